//! Pictures in the cells of a terminal.

use std::sync::Arc;

/// Where one letter stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cell {
    /// The letter.
    pub symbol: char,
    /// sRGB of the letter; the terminal's own colour if `None`.
    pub ink: Option<[u8; 3]>,
    /// sRGB behind it; the terminal's own colour if `None`.
    pub paper: Option<[u8; 3]>,
}

impl Cell {
    /// A letter in the terminal's own colours.
    pub fn bare(symbol: char) -> Self {
        Self { symbol, ink: None, paper: None }
    }

    /// The same, further from what catches the eye.
    fn dimmed(self) -> Self {
        Self { ink: self.ink.map(|colour| colour.map(pale)), paper: self.paper.map(|colour| colour.map(pale)), ..self }
    }
}

/// A part of a colour, two thirds of the way to grey.
pub(crate) fn pale(part: u8) -> u8 {
    ((u16::from(part) + 2 * 0x80) / 3) as u8
}

/// A picture that a terminal draws by itself: what to send for each row, and the same put back.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Strips {
    /// As it is.
    pub rows: Vec<Arc<str>>,
    /// While something newer is on its way.
    pub pale: Vec<Arc<str>>,
}

impl Strips {
    /// The same, put back: something newer is on its way.
    pub fn dimmed(&self) -> Self {
        Self { rows: self.pale.clone(), pale: self.pale.clone() }
    }
}

/// A picture of cells.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Cells {
    columns: usize,
    cells: Vec<Cell>,
}

impl Cells {
    /// A picture of rows of `columns` cells from the top; what is no whole row is left out.
    pub fn new(columns: usize, mut cells: Vec<Cell>) -> Self {
        cells.truncate(cells.len().checked_div(columns).unwrap_or(0) * columns);
        Self { columns, cells }
    }

    /// An empty picture with a note in its middle.
    pub fn note(columns: usize, rows: usize, text: &str) -> Self {
        let mut cells = vec![Cell::bare(' '); columns * rows];
        let text: Vec<char> = text.chars().take(columns).collect();
        let start = rows / 2 * columns + (columns - text.len()) / 2;
        for (cell, symbol) in cells.iter_mut().skip(start).zip(text) {
            cell.symbol = symbol;
        }
        Self::new(columns, cells)
    }

    /// Its rows from the top.
    pub fn rows(&self) -> impl ExactSizeIterator<Item = &[Cell]> {
        self.cells.chunks_exact(self.columns.max(1))
    }

    /// The same, put back: something newer is on its way.
    pub fn dimmed(&self) -> Self {
        Self { columns: self.columns, cells: self.cells.iter().map(|cell| cell.dimmed()).collect() }
    }
}
