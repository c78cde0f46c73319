//! How one moves: through a page, from step to step, and back.

use super::sheet::Sheet;
use super::{Effect, Mode, Reader};
use crate::reader::event::Key;
use crate::reader::leaf::{Name, Part};
use views::page::Row;

/// How many places are remembered to go back to.
const TRAIL: usize = 1000;

impl Reader {
    /// Opens a step at a row.
    pub(super) fn open(&mut self, leaf: usize, row: usize) {
        if leaf != self.at {
            self.leaves[self.at].forget();
            self.effects.push(Effect::TurnTo(leaf));
        }
        self.at = leaf;
        self.sheet = Sheet { parts: Vec::new(), starts: Vec::new(), rows: Vec::new() };
        self.top = row;
        self.set();
        let address = self.leaves[leaf].address();
        self.memory.visited.insert(address);
        self.effects.push(Effect::Keep);
    }

    /// The same, so that `b` leads back.
    pub(super) fn go(&mut self, leaf: usize, row: usize) {
        self.leave_trace();
        self.open(leaf, row);
    }

    pub(super) fn leave_trace(&mut self) {
        if self.trail.last() != Some(&(self.at, self.top)) {
            self.trail.push((self.at, self.top));
        }
        if self.trail.len() > TRAIL {
            self.trail.remove(0);
        }
    }

    pub(super) fn step(&mut self, leaf: usize) {
        match self.leaves.get(leaf) {
            Some(_) => self.go(leaf, 0),
            None if leaf == self.leaves.len() => self.note = Some("this is the last step of all; q leaves".into()),
            None => self.note = Some("this is the first step of all".into()),
        }
    }

    /// The last row that may stand at the top of the screen when one scrolls.
    pub(super) fn last_top(&self) -> usize {
        self.sheet.rows.len().saturating_sub(self.height())
    }

    pub(super) fn scroll(&mut self, rows: isize) {
        match &mut self.mode {
            Mode::Read | Mode::Set(_) => {
                let last = self.last_top().max(if rows < 0 { self.top } else { 0 });
                self.top = self.top.saturating_add_signed(rows).min(last.max(self.top));
            }
            Mode::GoTo(contents) => {
                let key = if rows < 0 { Key::Up } else { Key::Down };
                for _ in 0..rows.abs() {
                    contents.press(key, &self.leaves);
                }
            }
            _ => {}
        }
    }

    /// Whether everything down to the end is on the screen.
    pub(super) fn is_at_end(&self) -> bool {
        self.top + self.height() >= self.sheet.rows.len()
    }

    /// A screen further; past a question; or to the next step.
    pub(super) fn on(&mut self) {
        if self.is_at_end() {
            if self.leaves[self.at].asks().is_some() {
                self.leave_trace();
                let end = self.sheet.rows.len();
                self.skip();
                // What follows begins where the question stood, which has moved behind the text.
                let rest = self.sheet.parts.iter().position(|part| part.name == Name::Text);
                self.top = rest.map_or(end, |at| self.sheet.starts[at]).min(self.last_top().max(self.top));
                return;
            }
            return self.step(self.at + 1);
        }
        self.leave_trace();
        let mut next = self.top + self.height();
        // What would be torn begins the next screen, unless it began this one.
        let torn =
            self.sheet.starts.iter().zip(&self.sheet.parts).find(|(start, part)| {
                part.is_whole && **start > self.top && **start < next && **start + seen(part) > next
            });
        if let Some((start, _)) = torn {
            next = *start;
        } else if let Some(gap) = (next.saturating_sub(2)..next).rev().find(|row| self.sheet.rows[*row].is_empty()) {
            // A paragraph of which only the first lines were seen is read from its start.
            next = gap + 1;
        }
        while self.sheet.rows.get(next).is_some_and(Row::is_empty) {
            next += 1;
        }
        // A few rows more do not make another screen.
        if next + self.height() / 3 > self.sheet.rows.len() {
            next = self.last_top().max(self.top + 1);
        }
        self.top = next.min(self.sheet.rows.len() - 1);
    }

    /// To where one was; where that is not known, a screen back or to the step before.
    pub(super) fn back(&mut self) {
        if let Some((leaf, top)) = self.trail.pop() {
            if leaf == self.at {
                self.top = top.min(self.sheet.rows.len().saturating_sub(1))
            } else {
                self.open(leaf, top)
            }
        } else if self.top > 0 {
            self.top = self.top.saturating_sub(self.height() - 1);
        } else if self.at > 0 {
            self.open(self.at - 1, 0);
            self.top = self.last_top();
        } else {
            self.note = Some("this is where it all begins".into());
        }
    }

    pub(super) fn skip(&mut self) {
        if self.leaves[self.at].asks().is_some() {
            self.leaves[self.at].skipped = true;
            self.set();
        }
    }

    pub(super) fn reveal_question(&mut self) {
        let asks = self.leaves[self.at].asks().map(|(at, _)| at);
        self.reveal(|name| asks.is_some_and(|at| name == Name::Question(at)));
    }

    /// Scrolls as little as shows a part, its beginning first.
    pub(super) fn reveal(&mut self, is_it: impl Fn(Name) -> bool) {
        let Some(at) = self.sheet.parts.iter().position(|part| is_it(part.name)) else { return };
        let (start, rows) = (self.sheet.starts[at], seen(&self.sheet.parts[at]));
        if start + rows > self.top + self.height() {
            self.top = (start + rows).saturating_sub(self.height());
        }
        self.top = self.top.min(start);
    }

    /// Brings a part to the top.
    pub(super) fn show(&mut self, is_it: impl Fn(Name) -> bool) {
        if let Some(at) = self.sheet.parts.iter().position(|part| is_it(part.name)) {
            self.leave_trace();
            self.top = self.sheet.starts[at];
        }
    }

    pub(super) fn next_figure(&mut self) {
        self.skip();
        if self.leaves[self.at].unfold_figures() {
            self.set();
        }
        let figures =
            || self.sheet.parts.iter().zip(&self.sheet.starts).filter(|(part, _)| matches!(part.name, Name::Figure(_)));
        let next = figures().find(|(_, start)| **start > self.top).or_else(|| figures().next());
        match next.map(|(_, start)| *start) {
            Some(start) => {
                self.leave_trace();
                self.top = start;
            }
            None => self.note = Some("this step has no figures".into()),
        }
    }

    /// From the numbers to the first figure and back, while parameters are turned.
    pub(super) fn turn_over(&mut self) {
        let start = |name: Name| {
            let at = self.sheet.parts.iter().position(|part| part.name == name)?;
            Some(self.sheet.starts[at])
        };
        let (numbers, figure) = (start(Name::Numbers), start(Name::Figure(0)));
        let other = if Some(self.top) == figure { numbers } else { figure };
        self.top = other.unwrap_or(self.top);
    }
}

/// Rows of a part up to its last one that is not empty.
fn seen(part: &Part) -> usize {
    part.rows.iter().rposition(|row| !row.is_empty()).map_or(0, |last| last + 1)
}
