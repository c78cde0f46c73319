//! What is wrong with a text, and where.

use std::fmt;

/// What is wrong with a text, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// The character that it is about, counted from 1.
    pub column: usize,
    /// What was expected, or how it can be read.
    pub message: String,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "column {}: {}", self.column, self.message)
    }
}

impl std::error::Error for Fault {}

/// How deep brackets, functions and quotients may lie in one another.
pub const DEEPEST: usize = 256;

pub(super) fn fault(at: usize, message: impl Into<String>) -> Fault {
    Fault { column: at + 1, message: message.into() }
}
