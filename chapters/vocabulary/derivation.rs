//! Chains of lines from earlier equations to a later one.

use equation::derivation::Chain;

/// A chain of lines from earlier equations to a later one, each hop verified.
#[derive(Clone, Copy, Debug)]
pub struct Derivation {
    /// Last part of the address.
    pub id: &'static str,
    /// What is derived from what.
    pub says: &'static str,
    /// Lecture rows it derives (letter D); those of its step if empty.
    pub rows: &'static [&'static str],
    /// Premises and lines.
    pub chain: fn() -> Chain,
    /// The planted mistake: the same chain with one wrong line, which must be refused.
    pub spoiled: fn() -> Chain,
    /// What the planted mistake is.
    pub slip: &'static str,
}

/// A derivation that still lacks its planted mistake.
#[derive(Clone, Copy, Debug)]
pub struct Unspoiled(Derivation);

/// The derivation `id` of what it `says`, line by line.
pub const fn derivation(id: &'static str, says: &'static str, chain: fn() -> Chain) -> Unspoiled {
    Unspoiled(Derivation { id, says, rows: &[], chain, spoiled: chain, slip: "" })
}

impl Unspoiled {
    /// With lecture rows of its own.
    pub const fn rows(self, rows: &'static [&'static str]) -> Self {
        Self(Derivation { rows, ..self.0 })
    }

    /// With its planted mistake.
    pub const fn slip(self, slip: &'static str, spoiled: fn() -> Chain) -> Derivation {
        Derivation { slip, spoiled, ..self.0 }
    }
}
