//! Families of extreme inputs.

use crate::parameter::Setting;
use std::any::Any;
use yardstick::precise::{self, Real};

/// A family of inputs chosen to break formulas. Beside each stands what the textbook form makes of it:
/// a stress whose textbook form never breaks is refused by the tests.
#[derive(Clone, Copy, Debug)]
pub struct Stress {
    /// Last part of the address.
    pub id: &'static str,
    /// What is pushed, and what holds all the same.
    pub claim: &'static str,
    /// Lecture rows it is evidence for (letter X); those of its step if empty.
    pub rows: &'static [&'static str],
    /// What the textbook column computes.
    pub textbook: &'static str,
    /// Where the reference comes from.
    pub reference: &'static str,
    /// The cases.
    pub cases: fn(&Setting) -> Vec<Extreme>,
    /// The same cases with somebody else's formula in the place of the program's, where they can take one.
    pub own: Option<OwnCases>,
}

/// The cases of somebody's own formula; `None` if it is of a type that they cannot take.
pub type OwnCases = fn(&dyn Any) -> Option<Vec<Extreme>>;

/// The family `id` of extreme cases: what is pushed and holds all the same.
pub const fn stress(id: &'static str, claim: &'static str, cases: fn(&Setting) -> Vec<Extreme>) -> Stress {
    Stress { id, claim, rows: &[], textbook: "", reference: "", cases, own: None }
}

impl Stress {
    /// With lecture rows of its own.
    pub const fn rows(self, rows: &'static [&'static str]) -> Self {
        Self { rows, ..self }
    }

    /// What the textbook column computes.
    pub const fn textbook(self, textbook: &'static str) -> Self {
        Self { textbook, ..self }
    }

    /// Where the reference comes from.
    pub const fn against(self, reference: &'static str) -> Self {
        Self { reference, ..self }
    }

    /// Whose cases can take a formula of somebody else's.
    pub const fn own(self, own: OwnCases) -> Self {
        Self { own: Some(own), ..self }
    }
}

/// How many rounding units, per unit of 1 + cond, a result may be off: the project's promise of accuracy.
pub const ALLOWED_ULPS: f64 = 16.0;

/// One extreme input and what became of it.
#[derive(Clone, Debug)]
pub struct Extreme {
    /// The input.
    pub input: String,
    /// The quantity computed (`R_p`).
    pub quantity: &'static str,
    /// The reference, in arbitrary precision: it may lie outside the range of `f64`.
    pub reference: Real,
    /// What the textbook form gives: wrong digits, NaN and ∞ included.
    pub textbook: f64,
    /// What the program gives.
    pub ours: f64,
    /// Condition number of the quantity with respect to its inputs [1].
    pub condition: f64,
    /// How many inputs this one is the worst of; 1 if it stands for itself.
    pub worst_of: usize,
}

impl Extreme {
    /// Relative error of `value` (`self.ours` or `self.textbook`) against the reference [1].
    pub fn error(&self, value: f64) -> f64 {
        precise::relative_error(value, &self.reference)
    }

    /// Decimal digits that `value` keeps, 0 to 15.95 (all that `f64` has).
    pub fn digits(&self, value: f64) -> f64 {
        digits(self.error(value))
    }

    /// The error that [`ALLOWED_ULPS`] and the condition number allow [1].
    pub fn allowed(&self) -> f64 {
        ALLOWED_ULPS * f64::EPSILON * (1.0 + self.condition)
    }

    /// Whether the program's value keeps what the condition number allows.
    pub fn holds(&self) -> bool {
        self.error(self.ours) <= self.allowed()
    }

    /// Whether the textbook form keeps at least three digits fewer than the program.
    pub fn textbook_breaks(&self) -> bool {
        self.digits(self.textbook) + 3.0 <= self.digits(self.ours)
    }
}

/// Decimal digits kept at a relative error, 0 to 15.95.
pub fn digits(relative_error: f64) -> f64 {
    if relative_error.is_nan() {
        return 0.0;
    }
    // Adding zero takes the sign off a negative one.
    (-relative_error.max(f64::EPSILON / 2.0).log10()).clamp(0.0, 15.95) + 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_digits_are_plain_zero() {
        for error in [1.0, 10.0, f64::INFINITY, f64::NAN] {
            assert_eq!(digits(error).to_bits(), 0, "{error}");
        }
    }
}
