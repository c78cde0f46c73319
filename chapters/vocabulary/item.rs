//! Everything in a step that has an address, whatever its kind: the only list of the kinds of items.

use super::{Claim, Derivation, Figure, Question, Race, Statement, Step, Stress};

/// An item of a step.
#[derive(Clone, Copy, Debug)]
pub enum Item {
    /// An equation on the page.
    Statement(&'static Statement),
    /// What is asked before the evidence is shown.
    Question(&'static Question),
    /// How a statement follows.
    Derivation(&'static Derivation),
    /// What could refute the step.
    Check(&'static dyn Claim),
    /// What could break it.
    Stress(&'static Stress),
    /// What it costs.
    Race(&'static Race),
    /// What it looks like.
    Figure(&'static Figure),
}

/// What a run may be asked for; each is an option of the command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Part {
    /// `--check`
    Checks,
    /// `--stress`
    Stress,
    /// `--race`
    Races,
    /// `--plot`
    Figures,
}

impl Part {
    /// All of them, in the order in which they are shown.
    pub const ALL: [Self; 4] = [Self::Checks, Self::Stress, Self::Races, Self::Figures];

    /// The option that asks for it.
    pub fn flag(self) -> &'static str {
        match self {
            Self::Checks => "--check",
            Self::Stress => "--stress",
            Self::Races => "--race",
            Self::Figures => "--plot",
        }
    }

    /// What there is none of, if there is none.
    pub fn noun(self) -> &'static str {
        match self {
            Self::Checks => "checks",
            Self::Stress => "extreme cases",
            Self::Races => "races",
            Self::Figures => "figures",
        }
    }
}

impl Item {
    /// Last part of the address; the lane of a race has one more.
    pub fn id(&self) -> &'static str {
        match self {
            Self::Statement(item) => item.id,
            Self::Question(item) => item.id,
            Self::Derivation(item) => item.id,
            Self::Check(item) => item.head().id,
            Self::Stress(item) => item.id,
            Self::Race(item) => item.id,
            Self::Figure(item) => item.id,
        }
    }

    /// What it says in one sentence.
    pub fn says(&self) -> &'static str {
        match self {
            Self::Statement(item) => item.says,
            Self::Question(item) => item.asks,
            Self::Derivation(item) => item.says,
            Self::Check(item) => item.head().claim,
            Self::Stress(item) => item.claim,
            Self::Race(item) => item.claim,
            Self::Figure(item) => item.says,
        }
    }

    /// What that sentence is called where texts are looked up for translation.
    pub fn field(&self) -> &'static str {
        match self {
            Self::Question(_) => "asks",
            Self::Check(_) | Self::Stress(_) | Self::Race(_) => "claim",
            Self::Statement(_) | Self::Derivation(_) | Self::Figure(_) => "says",
        }
    }

    /// Lecture rows that it names for itself; none if those of its step are meant.
    fn own_rows(&self) -> &'static [&'static str] {
        match self {
            Self::Statement(item) => item.rows,
            Self::Question(_) => &[],
            Self::Derivation(item) => item.rows,
            Self::Check(item) => item.head().rows,
            Self::Stress(item) => item.rows,
            Self::Race(item) => item.rows,
            Self::Figure(item) => item.rows,
        }
    }

    /// The part of a run that it belongs to; a question is asked, not run.
    pub fn part(&self) -> Option<Part> {
        match self {
            Self::Statement(_) | Self::Derivation(_) | Self::Check(_) => Some(Part::Checks),
            Self::Question(_) => None,
            Self::Stress(_) => Some(Part::Stress),
            Self::Race(_) => Some(Part::Races),
            Self::Figure(_) => Some(Part::Figures),
        }
    }

    /// The letter of the lecture's table for which it is evidence. Units count only where both sides agree, or where a
    /// mistake is told by them; a race only with a rival.
    pub fn letter(&self) -> Option<char> {
        match self {
            Self::Statement(item) => crate::judge::statement(item).holds().then_some('U'),
            Self::Question(_) => None,
            Self::Derivation(_) => Some('D'),
            Self::Check(_) => Some('N'),
            Self::Stress(_) => Some('X'),
            Self::Race(item) => (item.lanes.len() > 1).then_some('R'),
            Self::Figure(_) => Some('P'),
        }
    }

    /// What a count of its kind is called: one, several.
    pub fn kind(&self) -> (&'static str, &'static str) {
        match self {
            Self::Statement(_) => ("equation", "equations"),
            Self::Question(_) => ("question", "questions"),
            Self::Derivation(_) => ("derivation", "derivations"),
            Self::Check(_) => ("check", "checks"),
            Self::Stress(_) => ("family of extreme cases", "families of extreme cases"),
            Self::Race(_) => ("race", "races"),
            Self::Figure(_) => ("figure", "figures"),
        }
    }
}

impl Step {
    /// Everything in the step that has an address, in the order in which it is shown.
    pub fn items(&self) -> impl Iterator<Item = Item> + Clone + use<> {
        let statements = self.statements.iter().map(Item::Statement);
        let questions = self.questions.iter().map(Item::Question);
        let derivations = self.derivations.iter().map(Item::Derivation);
        let checks = self.checks.iter().map(|check| Item::Check(*check));
        let stress = self.stress.iter().map(Item::Stress);
        let races = self.races.iter().map(Item::Race);
        let figures = self.exhibit.figures.iter().map(Item::Figure);
        statements.chain(questions).chain(derivations).chain(checks).chain(stress).chain(races).chain(figures)
    }

    /// The item `id`.
    pub fn item(&self, id: &str) -> Option<Item> {
        self.items().find(|item| item.id() == id)
    }

    /// The lecture rows that an item of this step is evidence for: its own, or else the step's.
    pub fn rows_of(&self, item: &Item) -> &'static [&'static str] {
        if item.own_rows().is_empty() { self.rows } else { item.own_rows() }
    }
}
