//! The contents: every chapter, its steps, and what each checks.

use super::{Teller, section_at};
use crate::block::{Block, Heading, Rank, Span, Term, Terms, Tone};
use chapters::lecture::{LECTURE, chapter_names};
use chapters::text::Phrase;
use chapters::vocabulary::Item;
use chapters::{CURRICULUM, Chapter, Step};

impl Teller<'_> {
    /// Every chapter of the lecture, written or not.
    pub fn contents(&self) -> Vec<Block> {
        let intro = self.say("A lecture on the physics of rendering that proves itself.", &[]);
        let outro = "`lesson CHAPTER` walks through a chapter, `lesson CHAPTER STEP` shows one step; `lesson --help` \
                     tells the rest.";
        let outro = self.say(outro, &[]);
        let chapter = |name: &'static str| match CURRICULUM.iter().find(|chapter| chapter.id == name) {
            Some(chapter) => self.written(chapter),
            None => self.coming(name),
        };
        let mut blocks = vec![Block::section(vec![Block::text(0, Tone::Plain, intro)])];
        blocks.extend(chapter_names().into_iter().map(chapter));
        blocks.push(Block::text(0, Tone::Dim, outro));
        blocks
    }

    fn written(&self, chapter: &Chapter) -> Block {
        let title = self.phrase(chapter.id, "title", chapter.title);
        let heading = Heading {
            rank: Rank::Entry,
            text: vec![Span::verbatim(Tone::Heading, chapter.id), Span::plain("  "), Span::new(Tone::Strong, title)],
            address: None,
            rows: Vec::new(),
        };
        let step = |step: &Step| Term {
            name: Span::verbatim(Tone::Name, step.id),
            says: vec![Span::new(Tone::Plain, self.phrase(&format!("{}/{}", chapter.id, step.id), "says", step.says))],
            note: Some(Span::new(Tone::Address, self.inventory(step))),
        };
        let terms = Terms { width: None, items: chapter.steps.iter().map(step).collect() };
        let says = Block::text(2, Tone::Plain, self.phrase(chapter.id, "says", chapter.says));
        section_at(chapter.id, vec![Block::Group(vec![Block::Heading(heading), says, Block::Terms(terms)])])
    }

    /// What a step has, in one line: the checks by name, the rest by number.
    fn inventory(&self, step: &Step) -> Phrase {
        let ids: Vec<_> = step.checks.iter().map(|check| check.head().id).collect();
        let mut parts = vec![Phrase::verbatim(step.rows.join(" "))];
        if !ids.is_empty() {
            parts.push(self.say("checks {ids}", &[("ids", Phrase::verbatim(ids.join(", ")))]));
        }
        let mut counts: Vec<((&str, &str), usize)> = Vec::new();
        for item in step.items().filter(|item| !matches!(item, Item::Statement(_) | Item::Check(_))) {
            match counts.iter_mut().find(|(kind, _)| *kind == item.kind()) {
                Some((_, count)) => *count += 1,
                None => counts.push((item.kind(), 1)),
            }
        }
        parts.extend(counts.into_iter().map(|((one, many), count)| match count {
            1 => self.say(&format!("1 {one}"), &[]),
            _ => self.say(&format!("{{count}} {many}"), &[("count", Phrase::verbatim(count.to_string()))]),
        }));
        parts.retain(|part| !part.is_empty());
        let join = |whole: Phrase, part| whole.then(Phrase::verbatim(" · ")).then(part);
        parts.into_iter().reduce(join).unwrap_or_default()
    }

    fn coming(&self, name: &str) -> Block {
        let rows: Vec<_> = LECTURE.iter().filter(|row| row.chapter == name).map(|row| row.id).collect();
        let heading = Heading {
            rank: Rank::Entry,
            text: vec![
                Span::verbatim(Tone::Strong, name),
                Span::new(Tone::Dim, Phrase::verbatim("  ").then(self.say("to be written", &[]))),
                Span::verbatim(Tone::Dim, format!(": {}", rows.join(" "))),
            ],
            address: None,
            rows: Vec::new(),
        };
        section_at(name, vec![Block::Heading(heading)])
    }
}
