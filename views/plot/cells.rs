//! A figure in the cells of a terminal: two pixels to a cell, one over the other, and its text as the terminal's own.
//!
//! A sheet is laid out anew for every size, so that a column is as wide as a letter of the figure's text: what is
//! written in it stays as readable as what stands around it, which no reduced picture of it would.

use super::canvas::{Across, Usual};
use super::palette::Colour;
use super::png::{built, fill, paste, stroke};
use super::sheet::{Item, Sheet, Text};
use super::{MARGIN, TITLE, block_height, draw_as, text as type_};
use crate::block::{Cell, Cells};
use chapters::figure::{Panel, Plot};
use chapters::text::Phrase;
use tiny_skia::{Color, PathBuilder, Pixmap, Transform};
use unicode_width::UnicodeWidthChar;

/// Pixels of the sheet to a column: the width of a letter of its text.
pub(super) const COLUMN: f64 = 8.0;
/// Pixels of the sheet to a row: twice as high as a column is wide, as terminals have it.
const ROW: f64 = 16.0;
/// Columns that a panel with axes needs at least to stand beside another.
const BESIDE: usize = 36;
/// Width at least of a line that carries something [pixels of the terminal].
const VISIBLE: f64 = 1.0;
/// Width of the lines around it.
const THIN: f64 = 0.5;
/// Width of the lines behind it.
const FAINT: f64 = 0.3;
/// Radius at least of a mark.
const MARK: f32 = 0.7;

/// The figure in at most so many `columns`, and `rows` to a panel, but for figures that need more to be read. In
/// colours, each half of a cell is a pixel; without, a cell has eight dots.
pub fn cells(plot: &Plot, columns: usize, rows: usize, is_coloured: bool) -> Cells {
    let Layout { sheet, shrink, columns, rows } = laid_out(plot, columns, rows);
    let (pixels_across, pixels_down) = if is_coloured { (1, 2) } else { (2, 4) };
    let scale = shrink * pixels_across as f64 / COLUMN;
    let raster = raster(&sheet, scale, columns * pixels_across, rows * pixels_down);
    let cell = |at: usize| {
        let (row, column) = (at / columns, at % columns);
        let pixel =
            |x: usize, y: usize| raster[(row * pixels_down + y) * columns * pixels_across + column * pixels_across + x];
        if is_coloured {
            Cell { symbol: '▀', ink: Some(pixel(0, 0)), paper: Some(pixel(0, 1)) }
        } else {
            Cell::bare(braille(|x, y| is_dark(pixel(x, y), 2 * column + x, 4 * row + y)))
        }
    };
    let mut cells: Vec<Cell> = (0..columns * rows).map(cell).collect();
    let mut taken = vec![false; cells.len()];
    let texts = sheet.items.iter().filter_map(|item| if let Item::Text(text) = item { Some(text) } else { None });
    // What is large stands for more than what is small.
    let mut texts: Vec<_> = texts.collect();
    // Of a turned text in several lines the last one stands lowest, and the others over it.
    let turned = |text: &Text| if text.upwards { -text.start[0] } else { 0.0 };
    texts.sort_by(|a, b| b.size.total_cmp(&a.size).then(turned(a).total_cmp(&turned(b))));
    texts.iter().for_each(|text| write(&mut cells, &mut taken, columns, text, shrink));
    Cells::new(columns, cells)
}

/// A sheet for a terminal.
pub(super) struct Layout {
    pub sheet: Sheet,
    /// By what its lengths are to be multiplied to fit.
    pub shrink: f64,
    /// How many there are.
    pub columns: usize,
    /// How many there are, where they are twice as high as columns are wide.
    pub rows: usize,
}

/// The figure for at most so many `columns`, and `rows` to a panel.
pub(super) fn laid_out(plot: &Plot, columns: usize, rows: usize) -> Layout {
    let has_axes = plot.panels.iter().any(|panel| !matches!(panel, Panel::Picture(_)));
    // Panels that are read stand under each other unless there is room for two; pictures are looked at side by side.
    let beside = if has_axes { columns / BESIDE } else { usize::MAX };
    let across = plot.columns.min(beside).clamp(1, plot.panels.len().max(1));
    let across = if has_axes { across.min(2) } else { across };
    let down = if has_axes { plot.panels.len().div_ceil(across) } else { 1 };
    let width = columns as f64 * COLUMN - (across + 1) as f64 * MARGIN;
    let title = type_::wrap(&plot.title, TITLE, columns as f64 * COLUMN - 4.0 * MARGIN);
    let height = rows as f64 * ROW - 3.0 * MARGIN - block_height(title.len(), TITLE);
    let usual = ((width / across as f64).max(10.0 * COLUMN), height.max(5.0 * ROW));
    let sheet = draw_as::<Usual>(plot, across, usual);
    // A panel that needs more than it was offered gets it, within reason.
    let most = (rows * down) as f64 * 1.5 * ROW;
    let shrink = (columns as f64 * COLUMN / f64::from(sheet.width)).min(most / f64::from(sheet.height)).min(1.0);
    let columns = ((f64::from(sheet.width) * shrink / COLUMN).ceil() as usize).clamp(1, columns.max(1));
    let rows = ((f64::from(sheet.height) * shrink / ROW).ceil() as usize).max(1);
    Layout { sheet, shrink, columns, rows }
}

/// The sheet in pixels, but for its text.
fn raster(sheet: &Sheet, scale: f64, width: usize, height: usize) -> Vec<[u8; 3]> {
    let mut pixmap = Pixmap::new(width as u32, height as u32).expect("a terminal's figure fits into memory");
    pixmap.fill(Color::WHITE);
    let transform = Transform::from_scale(scale as f32, scale as f32);
    for item in &sheet.items {
        match item {
            Item::Fill { path, paint } => fill(&mut pixmap, built(path), paint, transform),
            Item::Disc { centre: [x, y], radius, paint } => {
                let radius = radius.max(MARK / scale as f32);
                fill(&mut pixmap, PathBuilder::from_circle(*x, *y, radius), paint, transform);
            }
            Item::Stroke { path, paint, width, dashes } => {
                let least = match paint.colour {
                    Colour::Grid | Colour::Hatch => FAINT,
                    Colour::Ink | Colour::Edge => THIN,
                    _ => VISIBLE,
                };
                let width = width.max((least / scale) as f32);
                // A stroke shorter than a pixel would be a fainter line.
                let pixel = 1.0 / scale as f32;
                let shortest = dashes.iter().copied().fold(f32::INFINITY, f32::min);
                let longer = (1.5 * pixel / shortest).max(1.0);
                let dashes: Vec<f32> = dashes.iter().map(|dash| dash * longer).collect();
                stroke(&mut pixmap, path, paint, width, &dashes, transform);
            }
            Item::Image(image) => paste(&mut pixmap, image, scale),
            Item::Text(_) => {}
        }
    }
    pixmap.data().chunks_exact(4).map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect()
}

/// Sets a line of text where there is room for all of it: two that overlap could neither be read.
fn write(cells: &mut [Cell], taken: &mut [bool], columns: usize, text: &Text, shrink: f64) {
    // Scripts that have no letters of their own keep their sign, not their brackets.
    let label = Phrase::parse(&text.label).to_string().replace(['{', '}'], "");
    let letters: Vec<char> = label.chars().filter(|letter| letter.width() == Some(1)).collect();
    let (count, rows) = (letters.len(), cells.len() / columns);
    let long = type_::width(&text.label, f64::from(text.size)) * shrink;
    let half_height = 0.36 * f64::from(text.size);
    let [x, y] = text.start.map(|at| f64::from(at) * shrink);
    let (x, y) = if text.upwards { (x - half_height * shrink, y) } else { (x, y - half_height * shrink) };
    // Where the first letter stands, so that start, middle or end is where the sheet has it.
    let begin = |start: f64, unit: f64| {
        let count = count as f64;
        match text.along {
            Across::Left => start / unit,
            Across::Middle => (start + long / 2.0) / unit - count / 2.0,
            Across::Right => (start + long) / unit - count,
        }
    };
    let in_row = |row: usize, first: usize| -> Vec<usize> {
        (first..columns).take(count).map(|column| row * columns + column).collect()
    };
    let row = ((y / ROW).max(0.0) as usize).min(rows - 1);
    let is_free = |at: &usize| {
        let beside = [at.checked_sub(1), Some(at + 1)].into_iter().flatten();
        let beside = beside.filter(|other| other / columns == at / columns);
        !taken[*at] && beside.filter_map(|other| taken.get(other)).all(|taken| !taken)
    };
    let is_blank = |at: &usize| {
        let cell = &cells[*at];
        cell.symbol == ' ' || (cell.ink, cell.paper) == (Some([0xff; 3]), Some([0xff; 3]))
    };
    let places = if text.upwards {
        // Terminals cannot turn letters: what runs along an axis stands over its end, in the first row that is free.
        let over = ((y - long / 2.0) / ROW).max(0.0) as usize;
        let first = ((x / COLUMN).max(2.0) as usize - 1).min(columns.saturating_sub(count));
        let mut free = (0..=over.min(rows - 1)).rev().map(|row| in_row(row, first));
        free.find(|places| places.iter().all(|at| is_free(at) && is_blank(at))).unwrap_or_default()
    } else {
        let first = begin(x, COLUMN).round().min(columns.saturating_sub(count) as f64).max(0.0) as usize;
        in_row(row, first)
    };
    if places.len() < count || !places.iter().all(is_free) {
        return;
    }
    for (at, symbol) in places.into_iter().zip(letters) {
        taken[at] = true;
        let cell = &mut cells[at];
        let paper = cell
            .ink
            .zip(cell.paper)
            .map(|(above, below)| std::array::from_fn(|part| u8::midpoint(above[part], below[part])));
        let ink = paper.map(|_| text.paint.colour.rgb());
        *cell = Cell { symbol, ink, paper };
    }
}

/// A letter of eight dots, two across and four down.
fn braille(is_set: impl Fn(usize, usize) -> bool) -> char {
    // As Unicode numbers them: down the left, down the right, then the bottom row, which came later.
    const DOTS: [(usize, usize); 8] = [(0, 0), (0, 1), (0, 2), (1, 0), (1, 1), (1, 2), (0, 3), (1, 3)];
    let bits = DOTS.iter().enumerate().map(|(bit, (x, y))| u32::from(is_set(*x, *y)) << bit).sum::<u32>();
    if bits == 0 { ' ' } else { char::from_u32(0x2800 + bits).unwrap_or(' ') }
}

/// Whether a pixel is one of the dark ones: as large a share of a grey area's as it is grey.
fn is_dark(pixel: [u8; 3], x: usize, y: usize) -> bool {
    /// The order in which the pixels of a square darken (Bayer, 1973).
    const ORDER: [[u8; 4]; 4] = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]];
    /// Darkness [1] that is no more than a tint behind what is shown.
    const TINT: f64 = 0.2;
    let [red, green, blue] = pixel.map(|part| f64::from(part) / 255.0);
    let dark = 1.0 - (0.2126 * red + 0.7152 * green + 0.0722 * blue);
    // A coloured line is a line, however light its colour.
    let vivid = red.max(green).max(blue) - red.min(green).min(blue);
    let dark = dark.max(0.9 * vivid);
    dark > TINT.max((f64::from(ORDER[y % 4][x % 4]) + 0.5) / 16.0 * 0.9)
}

#[cfg(test)]
mod tests {
    use super::*;
    use chapters::figure::{Axis, Chart, Dash, Hue, Mark};

    fn falling() -> Plot {
        let points = (0..=50).map(|x| [f64::from(x), 50.0 - f64::from(x)]).collect();
        let line = Mark::Line { label: "falls".into(), hue: Hue::S, dash: Dash::Solid, points };
        Plot::of("Title", Chart::new("", Axis::linear("across", "m"), Axis::linear("up", "1")).with(line))
    }

    fn text(cells: &Cells) -> Vec<String> {
        cells.rows().map(|row| row.iter().map(|cell| cell.symbol).collect()).collect()
    }

    #[test]
    fn a_figure_keeps_its_size_and_its_words() {
        for (columns, rows) in [(40, 16), (76, 22), (96, 34)] {
            let cells = cells(&falling(), columns, rows, true);
            let text = text(&cells);
            assert!(text.iter().all(|row| row.chars().count() <= columns), "{text:?}");
            assert!(text.len() <= rows && 2 * text.len() > rows, "{} of {rows} rows", text.len());
            for word in ["Title", "across", "falls", "up"] {
                assert!(text.iter().any(|row| row.contains(word)), "{word}: {text:#?}");
            }
            assert!(cells.rows().flatten().all(|cell| cell.ink.is_some() && cell.paper.is_some()));
        }
    }

    #[test]
    fn a_line_is_seen_where_it_runs() {
        let cells = cells(&falling(), 76, 22, true);
        let hue = super::super::palette::colour(Hue::S).rgb();
        let near = |colour: Option<[u8; 3]>| {
            colour.is_some_and(|colour| colour.iter().zip(hue).all(|(a, b)| a.abs_diff(b) < 90))
        };
        // Of a line that falls, the columns that it passes grow from row to row.
        // Up to column 8 stand the frame and what is written beside it, some of it as grey as the line's rim.
        let first = |row: &[Cell]| (8..row.len()).find(|at| near(row[*at].ink) || near(row[*at].paper));
        let found: Vec<usize> = cells.rows().take(16).filter_map(first).collect();
        assert!(found.len() > 8 && found.is_sorted() && found[found.len() - 1] > found[0] + 20, "{found:?}");
    }

    #[test]
    fn without_colours_dots_stand_for_pixels() {
        let cells = cells(&falling(), 76, 22, false);
        assert!(cells.rows().flatten().all(|cell| cell.ink.is_none() && cell.paper.is_none()));
        let is_dots = |symbol: char| ('\u{2801}'..='\u{28ff}').contains(&symbol);
        let share = cells.rows().flatten().filter(|cell| is_dots(cell.symbol)).count() as f64 / (76.0 * 22.0);
        assert!((0.02..0.4).contains(&share), "{share}");
        assert_eq!(braille(|x, y| (x, y) == (1, 0)), '⠈');
        assert_eq!(braille(|x, y| (x, y) == (0, 3)), '⡀');
    }
}
