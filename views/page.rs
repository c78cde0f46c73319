//! Text set to a width: wrapped by display columns, coloured by meaning or not at all.

pub use crate::block::Tone;

use crate::block::{Cell, Cells, Strips};
use equation::face::Block;
use std::sync::Arc;
use unicode_width::UnicodeWidthStr;

/// Columns that the last cell of a row is worth being wrapped in; a line that goes on has as many on the narrowest page.
const LAST_CELL: usize = 16;

/// A piece of text, letter by letter, and what it means.
pub type Span<'a> = (Tone, &'a str);

/// A row of a page that has been set.
#[derive(Clone, Debug, PartialEq)]
pub enum Row {
    /// Pieces of text, each in another tone than the one before.
    Text(Vec<(Tone, String)>),
    /// A row of a picture.
    Picture(Vec<Cell>),
    /// A row of a picture, as the terminal is to be told of it.
    Strip(Arc<str>),
}

impl Row {
    /// Whether there is nothing to see.
    pub fn is_empty(&self) -> bool {
        match self {
            Self::Text(pieces) => pieces.is_empty(),
            Self::Picture(cells) => cells.is_empty(),
            Self::Strip(_) => false,
        }
    }

    /// Its letters alone.
    pub fn text(&self) -> String {
        match self {
            Self::Text(pieces) => pieces.iter().map(|(_, text)| text.as_str()).collect(),
            Self::Picture(cells) => cells.iter().map(|cell| cell.symbol).collect(),
            Self::Strip(_) => String::new(),
        }
    }
}

/// A page that is being set.
#[derive(Debug)]
pub struct Page {
    width: usize,
    colour: bool,
    rows: Vec<Row>,
}

impl Page {
    /// A page of `width` columns (40 to 100 are used).
    pub fn new(width: usize, colour: bool) -> Self {
        Self { width: width.clamp(40, 100), colour, rows: Vec::new() }
    }

    /// The page so far.
    pub fn into_text(self) -> String {
        let shown = |row: &Row| match row {
            Row::Text(pieces) if self.colour => pieces.iter().map(|(tone, text)| painted(*tone, text)).collect(),
            row => row.text(),
        };
        self.rows.iter().map(|row| shown(row) + "\n").collect()
    }

    /// The page so far, row by row.
    pub fn into_rows(self) -> Vec<Row> {
        self.rows
    }

    /// An empty line, unless there is one already.
    pub fn gap(&mut self) {
        if self.rows.last().is_some_and(|row| !row.is_empty()) {
            self.rows.push(Row::Text(Vec::new()));
        }
    }

    /// A picture at column `indent`.
    pub fn picture(&mut self, indent: usize, cells: &Cells) {
        let margin = Cell { symbol: ' ', ink: None, paper: None };
        for row in cells.rows() {
            self.rows.push(Row::Picture([&vec![margin; indent][..], row].concat()));
        }
    }

    /// A picture that the terminal draws.
    pub fn strips(&mut self, strips: &Strips) {
        self.rows.extend(strips.rows.iter().cloned().map(Row::Strip));
    }

    /// A paragraph: the first line starts at column `first`, the others at `rest`. Lines break at spaces; spans that
    /// touch stay together.
    pub fn wrap(&mut self, first: usize, rest: usize, spans: &[Span]) {
        let rest = rest.min(self.width - LAST_CELL);
        let mut line = Line::at(self, first);
        let mut empty = true;
        for word in words(spans) {
            let wide: usize = word.iter().map(|(_, text)| text.width()).sum();
            let blank = word.iter().all(|(_, text)| text.trim_start().is_empty());
            if !empty && !blank && line.column + wide > line.page.width {
                line.turn(rest);
                word.iter().for_each(|(tone, text)| line.put(*tone, text.trim_start()));
            } else {
                word.iter().for_each(|(tone, text)| line.put(*tone, text));
            }
            empty &= blank;
        }
        line.end();
    }

    /// One line at column `indent`: what does not fit is left out, and `…` says so.
    pub fn cut(&mut self, indent: usize, spans: &[Span]) {
        let wide: usize = indent + spans.iter().map(|(_, text)| text.width()).sum::<usize>();
        let room = if wide > self.width { self.width - 1 } else { self.width };
        let mut line = Line::at(self, indent);
        for &(tone, text) in spans {
            let fits = |end: &usize| line.column + text[..*end].width() <= room;
            let ends = text.char_indices().map(|(at, _)| at).chain([text.len()]);
            let end = ends.take_while(fits).last().unwrap_or(0);
            line.put(tone, &text[..end]);
            if end < text.len() {
                line.put(tone, "…");
                break;
            }
        }
        line.end();
    }

    /// A paragraph in one tone at column `indent`.
    pub fn line(&mut self, indent: usize, tone: Tone, text: &str) {
        self.wrap(indent, indent, &[(tone, text)]);
    }

    /// `block` at column `indent`, with `beside` after its middle line, if the page is wide enough; otherwise `flat` as
    /// a paragraph.
    pub fn formula(&mut self, indent: usize, block: &Block, flat: &str, beside: &str) {
        let gap = if beside.is_empty() { "" } else { "  " };
        if indent + block.width() + gap.len() + beside.width() > self.width {
            return self.wrap(indent, indent + 2, &[(Tone::Equation, flat), (Tone::Dim, gap), (Tone::Dim, beside)]);
        }
        for (at, row) in block.rows().iter().enumerate() {
            let mut line = Line::at(self, indent);
            line.put(Tone::Equation, row);
            if at == block.baseline() {
                line.put(Tone::Dim, gap);
                line.put(Tone::Dim, beside);
            }
            line.end();
        }
    }

    /// A line that is not wrapped, because a script may want it whole.
    pub fn verbatim(&mut self, text: &str) {
        let row = |line: &str| Row::Text(vec![(Tone::Plain, line.to_owned())]);
        self.rows.extend(text.lines().map(row));
    }

    /// Cells padded to `widths` (right-aligned where negative), at column `indent`; the last one is wrapped, or all as
    /// a paragraph if that leaves it too little.
    pub fn row(&mut self, indent: usize, widths: &[i32], cells: &[Span]) {
        let mut column = indent;
        let mut padded = Vec::new();
        for (&(tone, cell), &width) in cells.iter().zip(widths) {
            padded.push((tone, pad(cell, width)));
        }
        let mut spans: Vec<Span> = Vec::new();
        for (at, (tone, cell)) in padded.iter().enumerate() {
            if at > 0 {
                spans.push((Tone::Plain, "  "));
            }
            spans.push((*tone, cell));
            if at + 1 < padded.len() {
                column += cell.width() + 2;
            }
        }
        let last = padded.last().map_or(0, |(_, cell)| cell.width());
        if column + last.min(LAST_CELL) > self.width {
            let stacked: Vec<Span> = spans.iter().map(|(tone, text)| (*tone, text.trim())).collect();
            let stacked = stacked.into_iter().map(|(tone, text)| (tone, if text.is_empty() { "  " } else { text }));
            return self.wrap(indent, indent + 2, &stacked.collect::<Vec<_>>());
        }
        self.wrap(indent, column, &spans);
    }
}

/// A cell in as many columns as `width` says, right-aligned where that is negative.
pub fn pad(cell: &str, width: i32) -> String {
    let padding = " ".repeat((width.unsigned_abs() as usize).saturating_sub(cell.width()));
    if width < 0 { padding + cell } else { cell.to_owned() + &padding }
}

/// The words of `spans`, each with the space before it, in pieces of one tone.
fn words<'a>(spans: &[Span<'a>]) -> Vec<Vec<Span<'a>>> {
    let mut words: Vec<Vec<Span>> = Vec::new();
    for &(tone, text) in spans {
        let mut start = 0;
        while start < text.len() {
            let spaces = text[start..].char_indices().skip(1).filter(|(_, letter)| *letter == ' ');
            let mut breaks = spaces.map(|(at, _)| start + at).filter(|at| !is_within_number(text, *at));
            let end = breaks.next().unwrap_or(text.len());
            let piece = (tone, &text[start..end]);
            match words.last_mut() {
                Some(word) if !piece.1.starts_with(' ') => word.push(piece),
                _ => words.push(vec![piece]),
            }
            start = end;
        }
    }
    words
}

/// Whether the space at a place parts groups of digits: `100 000`.
fn is_within_number(text: &str, at: usize) -> bool {
    let after = text[at + 1..].bytes();
    text[..at].ends_with(|c: char| c.is_ascii_digit()) && after.take_while(u8::is_ascii_digit).count() == 3
}

/// The line being filled.
struct Line<'a> {
    page: &'a mut Page,
    column: usize,
    pieces: Vec<(Tone, String)>,
}

impl<'a> Line<'a> {
    /// An empty one that starts at a column.
    fn at(page: &'a mut Page, column: usize) -> Self {
        let mut line = Self { page, column: 0, pieces: Vec::new() };
        line.put(Tone::Plain, &" ".repeat(column));
        line
    }

    fn put(&mut self, tone: Tone, text: &str) {
        self.column += text.width();
        match self.pieces.last_mut() {
            Some((last, before)) if *last == tone => before.push_str(text),
            _ if text.is_empty() => {}
            _ => self.pieces.push((tone, text.to_owned())),
        }
    }

    /// Ends the line and begins the next at a column.
    fn turn(&mut self, column: usize) {
        self.shed();
        self.column = 0;
        self.put(Tone::Plain, &" ".repeat(column));
    }

    /// Ends the line.
    fn end(mut self) {
        self.shed();
    }

    /// Puts the line on the page, without spaces at its end.
    fn shed(&mut self) {
        let mut pieces = std::mem::take(&mut self.pieces);
        while let Some((_, last)) = pieces.last_mut() {
            last.truncate(last.trim_end_matches(' ').len());
            if !last.is_empty() {
                break;
            }
            pieces.pop();
        }
        self.page.rows.push(Row::Text(pieces));
    }
}

/// A piece of text in the colours of its tone.
fn painted(tone: Tone, text: &str) -> String {
    if tone == Tone::Plain { text.to_owned() } else { format!("\x1b[{}m{text}\x1b[0m", ansi(tone)) }
}

/// The "select graphic rendition" parameters of ECMA-48 for a tone.
pub fn ansi(tone: Tone) -> &'static str {
    match tone {
        Tone::Plain => "",
        Tone::Heading => "1;4",
        Tone::Emphasis => "3",
        Tone::Strong | Tone::Name => "1",
        Tone::Code => "33",
        Tone::Equation => "36",
        Tone::Dim | Tone::Address => "2",
        Tone::Good => "32",
        Tone::Bad => "1;31",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_cut_where_the_page_ends_and_nowhere_else() {
        let cut = |text: &str| {
            let mut page = Page::new(40, false);
            page.cut(4, &[(Tone::Good, "✓ "), (Tone::Plain, text)]);
            page.into_text()
        };
        let fits = "θ".repeat(34);
        assert_eq!(cut(&fits), format!("    ✓ {fits}\n"));
        assert_eq!(cut(&format!("{fits}x")), format!("    ✓ {}…\n", "θ".repeat(33)));
    }

    fn set(width: usize, spans: &[Span]) -> String {
        let mut page = Page::new(width, false);
        page.wrap(2, 4, spans);
        page.into_text()
    }

    #[test]
    fn lines_wrap_by_columns_not_bytes() {
        let text = set(40, &[(Tone::Plain, "θ₁ θ₁ θ₁ θ₁ θ₁ θ₁ θ₁ θ₁ θ₁ θ₁ θ₁ θ₁ θ₁ θ₁ θ₁ θ₁")]);
        assert!(text.lines().all(|line| line.width() <= 40), "{text}");
        assert_eq!(text.lines().count(), 2);
        assert!(text.lines().nth(1).unwrap().starts_with("    θ"));
    }

    #[test]
    fn spans_that_touch_stay_together() {
        assert_eq!(set(40, &[(Tone::Plain, "see "), (Tone::Code, "x"), (Tone::Plain, ", then")]), "  see x, then\n");
    }

    #[test]
    fn a_word_in_several_tones_wraps_as_one() {
        let text = set(
            40,
            &[(Tone::Plain, "thirty-two columns are taken by this ("), (Tone::Code, "r_s"), (Tone::Plain, ").")],
        );
        assert_eq!(text, "  thirty-two columns are taken by this\n    (r_s).\n");
        let text =
            set(40, &[(Tone::Plain, "thirty-six columns are taken by this "), (Tone::Code, "r_s"), (Tone::Plain, ".")]);
        assert_eq!(text, "  thirty-six columns are taken by this\n    r_s.\n");
    }

    #[test]
    fn rows_align_and_wrap_their_last_cell() {
        let mut page = Page::new(40, false);
        let cells =
            [(Tone::Plain, "θ_B"), (Tone::Plain, "1.5"), (Tone::Plain, "the angle that is called after Brewster")];
        page.row(2, &[4, -5, 0], &cells);
        page.row(0, &[-6, 0], &[(Tone::Plain, "16"), (Tone::Plain, "x")]);
        page.row(0, &[-6, 0], &[(Tone::Plain, "123456"), (Tone::Plain, "x")]);
        assert_eq!(
            page.into_text(),
            "  θ_B     1.5  the angle that is called\n               after Brewster\n    16  x\n123456  x\n"
        );
    }

    #[test]
    fn colour_ends_where_its_meaning_does() {
        let mut page = Page::new(60, true);
        page.wrap(2, 2, &[(Tone::Good, "it holds"), (Tone::Plain, " so")]);
        assert_eq!(page.into_text(), "  \x1b[32mit holds\x1b[0m so\n");
    }

    #[test]
    fn groups_of_digits_stay_together() {
        let text = set(40, &[(Tone::Plain, "thirty-five columns are taken by it 100 000 times 5 in")]);
        assert_eq!(text, "  thirty-five columns are taken by it\n    100 000 times 5 in\n");
    }

    #[test]
    fn rows_too_wide_become_paragraphs() {
        let mut page = Page::new(40, false);
        let cells = [(Tone::Plain, "textbook"), (Tone::Plain, "1.2345678901234567"), (Tone::Plain, "some 12 digits")];
        page.row(8, &[9, 25, 0], &cells);
        assert_eq!(page.into_text(), "        textbook  1.2345678901234567\n          some 12 digits\n");
    }
}
