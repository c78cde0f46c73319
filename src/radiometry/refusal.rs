//! What has no answer, and why.

use std::fmt;

/// Why there is no answer: which input, what was given and what may be.
#[derive(Clone, Debug, PartialEq)]
pub struct Refusal {
    /// Which input (`R`).
    pub place: &'static str,
    /// What is wrong with it, and what is valid.
    pub why: String,
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}: {}", self.place, self.why)
    }
}

impl std::error::Error for Refusal {}

impl Refusal {
    pub(super) fn new(place: &'static str, why: impl Into<String>) -> Self {
        Self { place, why: why.into() }
    }

    /// `value` if it is finite and `holds`; `valid` says what it may be.
    pub(super) fn unless(place: &'static str, value: f64, holds: bool, valid: &str) -> Result<f64, Self> {
        if value.is_finite() && holds {
            Ok(value)
        } else {
            Err(Self::new(place, format!("{value:?} is not valid; valid: {valid}")))
        }
    }

    /// `value` if it is positive and finite.
    pub(super) fn unless_positive(place: &'static str, value: f64) -> Result<f64, Self> {
        Self::unless(place, value, value > 0.0, "positive, finite")
    }

    /// A positive length in a `unit`, the largest length about, if it is not so much smaller that its products leave the range
    /// of `f64`.
    pub(super) fn unless_tiny(place: &'static str, length: f64, unit: f64) -> Result<f64, Self> {
        Self::unless(place, length, length / unit >= 1e-150, "at least 1e-150 of the largest length")
            .map(|length| length / unit)
    }
}
