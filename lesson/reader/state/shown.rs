//! What stands on the screen.

use super::{LEAST, Mode, Reader};
use crate::reader::leaf::{Leaf, Look};
use console::{measure_text_width, truncate_str};
use std::ops::Range;
use views::block::Tone;
use views::page::{Page, Row};

/// A line of the screen.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// What stands in it.
    pub row: Row,
    /// Columns left free before it.
    pub margin: usize,
    /// Letters that were searched for.
    pub marks: Vec<Range<usize>>,
    /// Whether it is a bar across the screen.
    pub is_bar: bool,
}

impl Reader {
    /// The screen, line by line.
    pub fn screen(&self) -> Vec<Line> {
        let (columns, rows) = self.size;
        if self.is_too_small() {
            return self.too_small();
        }
        let Look { width, height, .. } = self.look();
        let margin = (columns - width.min(columns)) / 2;
        let plain = |row: Row| Line { row, margin, marks: Vec::new(), is_bar: false };
        let mut lines: Vec<Line> = match &self.mode {
            Mode::Help(top) => help(width).into_iter().skip(*top).map(plain).collect(),
            Mode::GoTo(contents) => {
                let is_seen = |leaf: &Leaf| self.memory.visited.contains(&leaf.address());
                contents.rows(&self.leaves, is_seen, width, height).into_iter().map(plain).collect()
            }
            Mode::Set(panel) => {
                let mut lines = self.page(height, margin);
                let panel = self.panel(panel);
                lines.push(plain(Row::Text(vec![(Tone::Dim, "─".repeat(width))])));
                lines.extend(panel.into_iter().map(plain));
                lines
            }
            Mode::Read | Mode::Search(_) | Mode::Answer(_) => self.page(height, margin),
        };
        lines.truncate(rows - 1);
        lines.resize(rows - 1, plain(Row::Text(Vec::new())));
        lines.push(self.bar());
        lines
    }

    fn page(&self, height: usize, margin: usize) -> Vec<Line> {
        let hits = self.own_hits();
        let line = |(at, row): (usize, &Row)| {
            let marks = hits.iter().flatten().filter(|(row, _)| *row == at).map(|(_, range)| range.clone()).collect();
            Line { row: row.clone(), margin, marks, is_bar: false }
        };
        let mut lines: Vec<Line> = self.sheet.rows.iter().enumerate().skip(self.top).take(height).map(line).collect();
        lines.resize(height, Line { row: Row::Text(Vec::new()), margin, marks: Vec::new(), is_bar: false });
        lines
    }

    fn too_small(&self) -> Vec<Line> {
        let (columns, rows) = self.size;
        let (least_columns, least_rows) = LEAST;
        let text =
            format!("{columns} × {rows} is too small; {least_columns} × {least_rows} or more, please. q leaves.");
        let letters: Vec<char> = text.chars().collect();
        let line = |text: &[char]| Line {
            row: Row::Text(vec![(Tone::Plain, text.iter().collect())]),
            margin: 0,
            marks: Vec::new(),
            is_bar: false,
        };
        let mut lines: Vec<Line> = letters.chunks(columns.max(1)).take(rows).map(line).collect();
        lines.resize(rows, line(&[]));
        lines
    }

    /// The bar at the bottom: where one is, and what can be done.
    fn bar(&self) -> Line {
        let (columns, _) = self.size;
        let leaf = &self.leaves[self.at];
        let (number, of) = self.numbered();
        let place = if columns < 60 {
            format!(" {number}/{of} {} ", leaf.step.id)
        } else {
            format!(" {} {number}/{of} ", leaf.address())
        };
        let share = match self.sheet.rows.len().saturating_sub(self.height()) {
            0 => String::new(),
            _ if self.is_at_end() => " end ".into(),
            _ => format!(" {} % ", 100 * (self.top + self.height()) / self.sheet.rows.len()),
        };
        let keys: String = match (&self.mode, &self.note, &self.search) {
            (Mode::Search(words), ..) => format!("/{words}▏"),
            (Mode::Answer(text), ..) => format!("answer: {text}▏  Enter gives it, Esc not"),
            (Mode::GoTo(_), ..) => "type to filter  ↑↓ Enter goes  Esc closes".into(),
            (Mode::Help(top), ..) if top + self.height() < help(self.look().width).len() => "space: more".into(),
            (Mode::Help(_), ..) => "any key goes back".into(),
            (Mode::Set(_), ..) => "↑↓ ←→ (shift: far) or type  Tab figure  Esc".into(),
            (_, Some(note), _) => note.clone(),
            (_, _, Some(search)) => {
                format!("{} of {} “{}”  . next  , before  Esc ends", search.at + 1, search.found.len(), search.words)
            }
            _ if leaf.asks().is_some() => match leaf.asks().map_or(0, |(_, question)| question.options().len()) {
                0 => "type a number  space goes on  ? keys".into(),
                options => format!("1 to {options} answers  space goes on  ? keys"),
            },
            _ if columns < 60 => "space on  ? keys".into(),
            _ if columns < 100 => "space on  b back  g go to  ? keys  q quit".into(),
            _ => "space on  b back  n next step  g go to  / search  s settings  f figures  ? keys  q quit".into(),
        };
        let busy = if leaf.is_busy() { "⋯ " } else { "" };
        let left = format!("{place}{share}{busy}");
        let room = columns.saturating_sub(measure_text_width(&left) + 1);
        let keys = truncate_str(&keys, room, "…");
        let gap = room.saturating_sub(measure_text_width(&keys));
        let text = format!("{left}{}{keys} ", " ".repeat(gap));
        Line { row: Row::Text(vec![(Tone::Plain, text)]), margin: 0, marks: Vec::new(), is_bar: true }
    }

    /// Which step of its chapter is open, from 1, and how many that has.
    fn numbered(&self) -> (usize, usize) {
        let chapter = self.leaves[self.at].chapter;
        let first = self.leaves.iter().position(|leaf| leaf.chapter.id == chapter.id).unwrap_or(0);
        (self.at - first + 1, chapter.steps.len())
    }
}

/// The keys, as they are told.
pub const KEYS: [(&str, &str); 19] = [
    ("space, Enter", "on: the next screen, then the next step"),
    ("b", "back to where you were"),
    ("n  N", "the next step, the step before"),
    ("↑ ↓  PgUp PgDn", "scroll; so does the mouse's wheel"),
    ("Home End", "the step's beginning, its end"),
    ("g", "go to a chapter or a step: type a part of its name"),
    ("/", "search the chapter's text"),
    (".  ,", "the next place found, the one before"),
    ("f", "the next figure of the step; first, all of them"),
    ("s", "settings: turn a parameter and see what changes"),
    ("1 2 3 …", "answer a question; space goes on without"),
    ("a", "answer a question that you have passed"),
    ("d", "derivations, line by line"),
    ("u", "with the unit of every line, or without"),
    ("e", "checks: what could refute the step"),
    ("x", "extreme cases: what could break it"),
    ("r", "races: error against run time"),
    ("?", "this"),
    ("q, Ctrl-C", "leave; your place is remembered"),
];

pub(super) fn help(width: usize) -> Vec<Row> {
    let mut page = Page::new(width, true);
    for (keys, says) in KEYS {
        page.row(0, &[15, 0], &[(Tone::Name, keys), (Tone::Plain, says)]);
    }
    page.into_rows()
}
