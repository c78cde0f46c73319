//! What the program says of a hop.

use std::borrow::Cow;

/// A judged step of a chain.
#[derive(Clone, Debug, PartialEq)]
pub struct Hop {
    /// The line it leads to: an index into [`super::Chain::lines`].
    pub line: usize,
    /// The rules that justify it.
    pub by: Vec<Cow<'static, str>>,
    /// What the program found.
    pub verdict: Verdict,
}

/// What is known about a hop.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// Decided symbolically.
    Proved,
    /// Both sides agree wherever they were compared.
    Agrees {
        /// Points compared, half of them off the real axis wherever a symbol may leave it.
        points: usize,
        /// Points left out because a side has no finite value there.
        skipped: usize,
        /// Decimal digits that agree at the worst point, relative to the size of the terms.
        digits: f64,
    },
    /// The sides differ.
    Refuted {
        /// A point where they do: symbol (in Unicode) and value.
        at: Vec<(String, String)>,
        /// Decimal digits that agree there, relative to the size of the terms; negative where nothing does.
        digits: f64,
    },
    /// Nothing could be decided.
    Unknown {
        /// What stood in the way.
        why: String,
    },
}

impl Verdict {
    /// Whether the sides agree wherever they were compared, proved or not.
    pub fn agrees(&self) -> bool {
        matches!(self, Self::Proved | Self::Agrees { .. })
    }
}
