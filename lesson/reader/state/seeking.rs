//! Words that are searched for, in all of a chapter.

use super::Reader;
use crate::reader::find::{Hit, hits};
use chapters::text::Phrase;

/// What is searched for.
pub(super) struct Search {
    pub words: String,
    /// By step, and by which of its hits.
    pub found: Vec<(usize, usize)>,
    pub at: usize,
}

impl Reader {
    pub(super) fn find(&mut self, words: &str) {
        self.search = None;
        if words.trim().is_empty() {
            return;
        }
        // A symbol is searched for as it is set: r_s is shown as rₛ.
        let set = Phrase::parse(words).to_string();
        for words in [words, &set] {
            let (look, chapter) = (self.look(), self.leaves[self.at].chapter.id);
            let mut found = Vec::new();
            for (leaf, own) in self.leaves.iter_mut().enumerate().filter(|(_, leaf)| leaf.chapter.id == chapter) {
                let skipped = std::mem::replace(&mut own.skipped, true);
                let parts = own.parts(&look);
                own.skipped = skipped;
                let count = hits(parts.iter().flat_map(|part| &part.rows), words).len();
                found.extend((0..count).map(|hit| (leaf, hit)));
            }
            if let Some(first) =
                found.iter().position(|(leaf, _)| *leaf >= self.at).or((!found.is_empty()).then_some(0))
            {
                // From where one is; the first hit of this step that is not above the screen.
                if found[first].0 == self.at {
                    self.skip();
                }
                self.search = Some(Search { words: words.to_owned(), found, at: first });
                let here = self.own_hits();
                let below = here.iter().position(|hit| hit.first().is_some_and(|(row, _)| *row >= self.top));
                if let Some(search) = &mut self.search
                    && search.found[first].0 == self.at
                {
                    search.at = first + below.unwrap_or(here.len());
                    if search.at >= search.found.len() {
                        search.at = 0;
                    }
                }
                return self.show_hit();
            }
        }
        self.note = Some(format!("“{}” does not stand in this chapter", words.trim()));
    }

    pub(super) fn next_hit(&mut self, way: isize) {
        match &mut self.search {
            Some(search) => {
                search.at = (search.at as isize + way).rem_euclid(search.found.len() as isize) as usize;
                self.show_hit();
            }
            None => self.note = Some("/ searches the chapter".into()),
        }
    }

    pub(super) fn show_hit(&mut self) {
        let Some((leaf, hit)) = self.search.as_ref().map(|search| search.found[search.at]) else { return };
        self.leave_trace();
        if leaf != self.at {
            self.open(leaf, 0);
        }
        self.skip();
        let row = self.own_hits().get(hit).and_then(|hit| hit.first()).map(|(row, _)| *row);
        if let Some(row) = row.filter(|row| *row < self.top || *row + 2 > self.top + self.height()) {
            self.top = row.saturating_sub(self.height() / 3);
        }
    }

    /// The places on this page where the words stand that are searched for.
    pub(super) fn own_hits(&self) -> Vec<Hit> {
        self.search.as_ref().map_or(Vec::new(), |search| hits(self.sheet.rows.iter(), &search.words))
    }
}
