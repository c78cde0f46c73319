//! The page that is open, set for the screen, and which of its rows stands at the top.

use super::Effect;
use super::Reader;
use crate::reader::leaf::{Name, Part};
use views::page::Row;

/// The page that is open, set for the screen.
pub(super) struct Sheet {
    pub parts: Vec<Part>,
    /// The first row of each part.
    pub starts: Vec<usize>,
    pub rows: Vec<Row>,
}

impl Reader {
    /// Sets the page that is open anew; what stands at the top of the screen stays there.
    pub(super) fn set(&mut self) {
        let anchor = self.anchor();
        let look = self.look();
        let jobs = self.leaves[self.at].wanted(self.at, &look);
        self.effects.extend(jobs.into_iter().map(Effect::Do));
        let parts = self.leaves[self.at].parts(&look);
        let mut sheet = Sheet { parts, starts: Vec::new(), rows: Vec::new() };
        for part in &sheet.parts {
            sheet.starts.push(sheet.rows.len());
            sheet.rows.extend(part.rows.iter().cloned());
        }
        // No empty rows at the end.
        while sheet.rows.last().is_some_and(Row::is_empty) {
            sheet.rows.pop();
        }
        self.sheet = sheet;
        if let Some((name, share, before)) = anchor
            && let Some(at) = self.sheet.parts.iter().position(|part| part.name == name)
        {
            let rows = self.sheet.parts[at].rows.len();
            // A part of the same size is the same: nothing moves. Of another, as far in.
            let inside = if before == rows { share.0 } else { share.0 * rows / share.1.max(1) };
            self.top = self.sheet.starts[at] + inside;
        }
        // What was at the top may have been folded away.
        if self.top >= self.sheet.rows.len() {
            self.top = self.last_top();
        }
    }

    /// The part at the top of the screen and how far into it that is.
    fn anchor(&self) -> Option<(Name, (usize, usize), usize)> {
        let at = self.sheet.starts.iter().rposition(|start| *start <= self.top)?;
        let (start, rows) = (self.sheet.starts[at], self.sheet.parts[at].rows.len());
        Some((self.sheet.parts[at].name, (self.top - start, rows), rows))
    }
}
