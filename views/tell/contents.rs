//! The contents: a map of the chapters, and the steps of each.

use super::{Teller, section_at};
use crate::block::{Block, Heading, Rank, Span, Term, Terms, Tone};
use chapters::{CURRICULUM, Chapter, Step};

/// What to type next, and what that does.
const NEXT: [(&str, &str); 5] = [
    ("lesson fresnel", "read a chapter, where you left it"),
    ("lesson contents fresnel", "its steps, one line each"),
    ("lesson fresnel brewster", "one step; --plot its figures, --help the rest"),
    ("lesson exercise list", "formulas for you to write, judged by these checks"),
    ("lesson --help", "all the rest, and what the signs mean"),
];

impl Teller<'_> {
    /// Every chapter of the lecture, written or not, in a sentence, and what to type next.
    pub fn map(&self) -> Vec<Block> {
        let intro = self.say("A lecture on the physics of rendering that proves itself.", &[]);
        let chapter = |chapter: &&Chapter| Term {
            name: Span::verbatim(Tone::Name, chapter.id),
            says: vec![Span::new(Tone::Plain, self.phrase(chapter.id, "says", chapter.says))],
            note: None,
        };
        let next = |(command, says): &(&str, &str)| Term {
            name: Span::verbatim(Tone::Code, *command),
            says: vec![Span::new(Tone::Plain, self.say(says, &[]))],
            note: None,
        };
        let terms = |width, items| Block::section(vec![Block::Terms(Terms { width: Some(width), items })]);
        vec![
            Block::section(vec![Block::text(0, Tone::Plain, intro)]),
            terms(19, CURRICULUM.iter().map(chapter).collect()),
            terms(24, NEXT.iter().map(next).collect()),
        ]
    }

    /// The steps of a chapter, one line each.
    pub fn contents(&self, chapter: &Chapter) -> Vec<Block> {
        let title = self.phrase(chapter.id, "title", chapter.title);
        let heading = Heading {
            rank: Rank::Entry,
            text: vec![Span::verbatim(Tone::Heading, chapter.id), Span::plain("  "), Span::new(Tone::Strong, title)],
            address: None,
            rows: Vec::new(),
        };
        let step = |step: &Step| Term {
            name: Span::verbatim(Tone::Name, step.id),
            says: vec![Span::new(
                Tone::Plain,
                self.phrase(&format!("{}/{}", chapter.id, step.id), "title", step.title),
            )],
            note: None,
        };
        let items = chapter.steps.iter().map(step).collect();
        let terms = Block::Terms(Terms { width: Some(18), items });
        vec![section_at(chapter.id, vec![Block::Group(vec![Block::Heading(heading), terms])])]
    }
}
