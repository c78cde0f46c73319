//! Equations on the page.

use equation::Equation;

/// An equation on the page: the same object is typeset, unit-checked and evaluated.
#[derive(Clone, Copy, Debug)]
pub struct Statement {
    /// Last part of the address.
    pub id: &'static str,
    /// What it says in words.
    pub says: &'static str,
    /// Lecture rows it states (letter U); those of its step if empty.
    pub rows: &'static [&'static str],
    /// Builds the equation.
    pub equation: fn() -> Equation,
    /// Whether it is shown as a mistake, which its units must refute.
    pub is_struck_out: bool,
}

/// The equation `id`, which `says` in words what it states.
pub const fn statement(id: &'static str, says: &'static str, equation: fn() -> Equation) -> Statement {
    Statement { id, says, rows: &[], equation, is_struck_out: false }
}

impl Statement {
    /// With lecture rows of its own.
    pub const fn rows(self, rows: &'static [&'static str]) -> Self {
        Self { rows, ..self }
    }

    /// As a mistake that its units give away.
    pub const fn struck_out(self) -> Self {
        Self { is_struck_out: true, ..self }
    }
}
