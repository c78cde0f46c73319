//! What is found: a way, or why there is none.

use crate::expr::Expr;
use std::borrow::Cow;
use std::fmt;

/// A way from one expression to another.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// The lines after the start, of which the last is the goal; none where start and goal are written alike.
    pub steps: Vec<Step>,
}

/// A line.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// What it says.
    pub expr: Expr,
    /// The rules that lead to it from the line before, as displayed: "Snell ×4", "cancel k".
    pub by: Vec<Cow<'static, str>>,
    /// The single steps that it sums up, ending with itself; empty where it is one.
    pub unfolded: Vec<Step>,
}

/// Why there is no way.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NotFound {
    /// The two have different values at a point that satisfies the hypotheses.
    Differs,
    /// An expression has too many parts or too deep a nesting.
    TooLarge,
    /// None was found among so many states.
    Exhausted {
        /// How many.
        states: usize,
    },
    /// A vector, a derivative or the like (its face in Unicode), no finite value, or a hypothesis that cannot be
    /// satisfied.
    NotAlgebraic(String),
}

impl fmt::Display for NotFound {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Differs => f.write_str("the two sides differ"),
            Self::TooLarge => f.write_str("too large to search"),
            Self::Exhausted { states } => write!(f, "not found among {states} states"),
            Self::NotAlgebraic(what) => write!(f, "not a matter of algebra: {what}"),
        }
    }
}

impl std::error::Error for NotFound {}
