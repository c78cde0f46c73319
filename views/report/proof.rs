//! What `lesson prove` found, as plain data.

use super::LineReport;
use equation::Symbol;
use equation::derivation::Chain;
use serde::Serialize;

/// The answer to one question.
#[derive(Debug, Serialize)]
pub struct ProofReport {
    /// `proved`, `refuted` or `unknown`.
    pub verdict: &'static str,
    /// What was asked.
    pub claim: String,
    /// The argument, as far as there is one.
    pub lines: Vec<LineReport>,
    /// The equations given, solved for the symbols that they replace.
    pub hypotheses: Vec<LineReport>,
    /// What the names stand for.
    pub assumed: Assumed,
    /// What must not be zero.
    pub conditions: Vec<String>,
    /// Why it is unknown.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub why: Option<String>,
    /// Where it fails.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub witness: Option<Witness>,
}

/// What is assumed of the names; others are replaced by what was given.
#[derive(Debug, Serialize)]
pub struct Assumed {
    /// Positive numbers.
    pub positive: Vec<String>,
    /// Real numbers of either sign.
    pub real: Vec<String>,
}

/// What `chain` takes its names to stand for.
pub fn assumed(chain: &Chain) -> Assumed {
    let found = chain.assumed();
    let faces = |symbols: &[Symbol]| symbols.iter().map(Symbol::to_string).collect();
    Assumed { positive: faces(&found.positive), real: faces(&found.real) }
}

/// A point where the sides differ, and their values there.
#[derive(Debug, Serialize)]
pub struct Witness {
    /// The symbols and their values.
    pub at: Vec<(String, String)>,
    /// What the sides are there, where they have values by themselves.
    #[serde(skip_serializing_if = "Option::is_none", flatten)]
    pub values: Option<Sides>,
}

/// The values of both sides.
#[derive(Debug, Serialize)]
pub struct Sides {
    /// Of the left one.
    pub left: String,
    /// Of the right one.
    pub right: String,
}
