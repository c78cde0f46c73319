//! A step in the parts that a reader turns to one by one, and the short way through it.

use super::{Teller, prose};
use crate::block::{Block, Figure, Picture, Span, Tone};
use crate::report::{StatementReport, StepReport};
use chapters::text::Phrase;
use chapters::vocabulary::{self, Item, Reply};
use chapters::{Chapter, Step};

/// A kind of evidence, folded until it is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Evidence {
    /// How the equations follow.
    Derivations,
    /// What could refute the step.
    Checks,
    /// What could break it.
    Extremes,
    /// What it costs.
    Races,
}

impl Evidence {
    /// All of it, in the order in which it is shown.
    pub const ALL: [Self; 4] = [Self::Derivations, Self::Checks, Self::Extremes, Self::Races];

    /// That which an item is, if it is any.
    pub fn of(item: &Item) -> Option<Self> {
        match item {
            Item::Derivation(_) => Some(Self::Derivations),
            Item::Check(_) => Some(Self::Checks),
            Item::Stress(_) => Some(Self::Extremes),
            Item::Race(_) => Some(Self::Races),
            Item::Statement(_) | Item::Question(_) | Item::Figure(_) => None,
        }
    }

    /// What one of it is called, and several.
    pub fn nouns(self) -> (&'static str, &'static str) {
        match self {
            Self::Derivations => ("derivation", "derivations"),
            Self::Checks => ("check", "checks"),
            Self::Extremes => ("extreme case", "extreme cases"),
            Self::Races => ("race", "races"),
        }
    }
}

impl Teller<'_> {
    /// The heading of a step and its claim.
    pub fn head(&self, found: &StepReport) -> Vec<Block> {
        vec![self.heading(found), self.claim(found)]
    }

    /// What is said to an answer of the question at an `address`.
    pub fn reply(&self, address: &str, reply: Reply) -> Block {
        let (tone, verdict) = if reply.right { (Tone::Good, "Right.") } else { (Tone::Bad, "No.") };
        let verdict = Span::new(tone, self.say(verdict, &[]).then(Phrase::verbatim(" ")));
        Block::paragraph(2, 4, vec![verdict, Span::new(Tone::Plain, self.phrase(address, "reply", reply.says))])
    }

    /// The text of a step.
    pub fn text(&self, chapter: &Chapter, step: &Step, found: &StepReport) -> Vec<Block> {
        self.prose(&found.address, prose::section(chapter.prose, step.id), step.title)
    }

    /// Its equations.
    pub fn formulas(&self, found: &StepReport) -> Vec<Block> {
        found.statements.iter().map(|statement| self.formula(statement)).collect()
    }

    /// One of its figures.
    pub fn shown(&self, found: &StepReport, figure: &vocabulary::Figure, picture: Picture) -> Block {
        let address = format!("{}/{}", found.address, figure.id);
        Block::Figure(Figure { says: self.phrase(&address, "says", figure.says), picture, address })
    }

    /// What was found of one kind of evidence, whole.
    pub fn evidence(&self, found: &StepReport, kind: Evidence) -> Vec<Block> {
        match kind {
            Evidence::Derivations => self.derivations(&found.derivations, true),
            Evidence::Checks => found.checks.iter().map(|check| self.check(check)).collect(),
            Evidence::Extremes => found.stress.iter().map(|stress| self.stress(stress)).collect(),
            Evidence::Races => found.races.iter().map(|race| self.race(race)).collect(),
        }
    }

    /// The short way through a step: its claim, how its text begins, its key equation and its first figure.
    pub fn brief(&self, chapter: &Chapter, step: &Step, found: &StepReport) -> Vec<Block> {
        let mut blocks = self.head(found);
        blocks.extend(self.beginning(chapter, step, found));
        blocks.extend(self.key(step, found));
        let first = step.exhibit.figures.first();
        blocks.extend(first.map(|figure| self.shown(found, figure, Picture::Absent)));
        vec![super::section_at(&found.address, blocks)]
    }

    /// How the text of a step begins: its first paragraph.
    pub fn beginning(&self, chapter: &Chapter, step: &Step, found: &StepReport) -> Option<Block> {
        self.text(chapter, step, found).into_iter().find(|block| matches!(block, Block::Paragraph(_)))
    }

    /// The equation that a step is about: the first that it states, unless that only leads to it.
    pub fn key(&self, step: &Step, found: &StepReport) -> Option<Block> {
        let named = step.key.map(|key| format!("{}/{key}", found.address));
        let is_key = |statement: &&StatementReport| named.as_ref().is_none_or(|key| *key == statement.address);
        found.statements.iter().find(is_key).map(|key| self.formula(key))
    }

    /// What the short way leaves out.
    pub fn briefly(&self) -> Vec<Block> {
        let how = "The short way. Without --short: the whole text, derivations, checks and numbers.";
        vec![Block::section(vec![Block::text(0, Tone::Dim, self.say(how, &[]))])]
    }

    fn claim(&self, found: &StepReport) -> Block {
        Block::text(0, Tone::Emphasis, self.phrase(&found.address, "says", found.says))
    }
}
