//! Where to go: chapters and steps, filtered as one types.

use super::event::Key;
use super::leaf::Leaf;
use views::block::Tone;
use views::page::{Page, Row};

/// The list of chapters and steps.
#[derive(Debug, Default)]
pub struct Contents {
    filter: String,
    /// The chosen line of those shown.
    at: usize,
}

/// What a key in the list led to.
#[derive(Debug, PartialEq, Eq)]
pub enum Choice {
    /// Nothing yet.
    Open,
    /// This step.
    Go(usize),
    /// Back to where one was.
    Close,
}

/// A line of the list: a chapter leads to its first step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Line {
    leaf: usize,
    is_chapter: bool,
}

impl Contents {
    /// The list with the step that is open chosen.
    pub fn at(leaves: &[Leaf], leaf: usize) -> Self {
        let contents = Self::default();
        let at = contents.lines(leaves).iter().position(|line| line.leaf == leaf && !line.is_chapter);
        Self { at: at.unwrap_or(0), ..contents }
    }

    pub fn press(&mut self, key: Key, leaves: &[Leaf]) -> Choice {
        let count = self.lines(leaves).len();
        let last = count.saturating_sub(1);
        match key {
            Key::Escape => return Choice::Close,
            Key::Enter => {
                return self.lines(leaves).get(self.at).map_or(Choice::Open, |line| Choice::Go(line.leaf));
            }
            Key::Up => self.at = self.at.saturating_sub(1),
            Key::Down => self.at = (self.at + 1).min(last),
            Key::PageUp => self.at = self.at.saturating_sub(10),
            Key::PageDown => self.at = (self.at + 10).min(last),
            Key::Home => self.at = 0,
            Key::End => self.at = last,
            Key::Backspace => {
                self.filter.pop();
                self.at = 0;
            }
            Key::Char(letter) => {
                self.filter.push(letter);
                // What is asked for is a step, unless a chapter is called so.
                self.at = 0;
                let lines = self.lines(leaves);
                let words = self.words();
                let is_named = |line: &Line| {
                    line.is_chapter && words.iter().all(|word| leaves[line.leaf].chapter.id.contains(word))
                };
                self.at = lines.iter().position(|line| !line.is_chapter || is_named(line)).unwrap_or(0);
            }
            Key::Left { .. } | Key::Right { .. } | Key::Tab | Key::Interrupt => {}
        }
        Choice::Open
    }

    fn words(&self) -> Vec<String> {
        self.filter.to_lowercase().split_whitespace().map(str::to_owned).collect()
    }

    /// The steps that have all the words, each under its chapter.
    fn lines(&self, leaves: &[Leaf]) -> Vec<Line> {
        let words = self.words();
        let has = |leaf: &Leaf| {
            let Leaf { chapter, step, .. } = leaf;
            let text =
                format!("{} {} {} {}", chapter.id, chapter.title, step.id.replace('_', "-"), step.title).to_lowercase();
            words.iter().all(|word| text.contains(&word.replace('_', "-")))
        };
        let mut lines = Vec::new();
        let mut under = "";
        for (at, leaf) in leaves.iter().enumerate().filter(|(_, leaf)| has(leaf)) {
            if leaf.chapter.id != under {
                under = leaf.chapter.id;
                let first = leaves.iter().position(|other| other.chapter.id == under).unwrap_or(at);
                lines.push(Line { leaf: first, is_chapter: true });
            }
            lines.push(Line { leaf: at, is_chapter: false });
        }
        lines
    }

    /// The list in so many rows, around the chosen line.
    pub fn rows(&self, leaves: &[Leaf], is_seen: impl Fn(&Leaf) -> bool, width: usize, height: usize) -> Vec<Row> {
        let lines = self.lines(leaves);
        let mut page = Page::new(width, true);
        page.cut(0, &[(Tone::Strong, "Go to: "), (Tone::Code, &self.filter), (Tone::Plain, "▏")]);
        let room = height.saturating_sub(1).max(1);
        let at = self.at.min(lines.len().saturating_sub(1));
        let first = at.saturating_sub(room / 2).min(lines.len().saturating_sub(room));
        for (place, line) in lines.iter().enumerate().skip(first).take(room) {
            let Leaf { chapter, step, .. } = &leaves[line.leaf];
            let (sign, tone) = if place == at { ("› ", Tone::Strong) } else { ("  ", Tone::Plain) };
            if line.is_chapter {
                let tone = if place == at { Tone::Strong } else { Tone::Heading };
                page.cut(
                    0,
                    &[(Tone::Strong, sign), (tone, chapter.id), (Tone::Plain, "  "), (Tone::Dim, chapter.title)],
                );
            } else {
                let seen = if is_seen(&leaves[line.leaf]) { "✓ " } else { "  " };
                let id = format!("{:<18}", step.id);
                let title = if width < 60 { "" } else { step.title };
                page.cut(
                    2,
                    &[(Tone::Strong, sign), (Tone::Good, seen), (tone, &id), (Tone::Plain, " "), (tone, title)],
                );
            }
        }
        if lines.is_empty() {
            page.line(2, Tone::Dim, "no step has these words; Backspace takes letters back, Esc closes");
        }
        page.into_rows()
    }
}
