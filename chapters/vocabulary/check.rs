//! Claims that a number could refute.
//!
//! A check is a measurement over a subject: the formula, number or rule that is tried. The truth, the planted slip and a
//! learner's own formula are subjects of one type, judged by the same code.

use super::Bench;
use crate::figure::Plot;
use std::any::Any;
use std::fmt;
use yardstick::statistics::sidak;

/// A claim that a number could refute, tried on a subject of type `F`.
#[derive(Clone, Copy)]
pub struct Check<F: 'static> {
    head: Head,
    measure: fn(&mut Bench, F) -> Measured,
    truth: F,
    slip: F,
}

/// What a check says, whatever it is tried on.
#[derive(Clone, Copy, Debug)]
pub struct Head {
    /// Last part of the address.
    pub id: &'static str,
    /// The claim.
    pub claim: &'static str,
    /// Lecture rows it is evidence for (letter N); those of its step if empty.
    pub rows: &'static [&'static str],
    /// The other route that the program's number is held against.
    pub route: &'static str,
    /// How far it may be off, and why.
    pub bound: Bound,
    /// What the planted mistake is.
    pub slip: &'static str,
}

/// A check of any subject, as a step holds it.
pub trait Claim: Sync {
    /// What it says.
    fn head(&self) -> &Head;
    /// The measurement on the program's own formula.
    fn measure(&self, bench: &mut Bench) -> Measured;
    /// The same measurement with the classic slip put in. It must break the bound.
    fn spoiled(&self, bench: &mut Bench) -> Measured;
    /// The same measurement on somebody else's formula; `None` if it is of another type than the check's subject.
    fn own(&self, bench: &mut Bench, subject: &dyn Any) -> Option<Measured>;
    /// The program's own formula and the one with the slip, each of the subject's type.
    fn subjects(&self) -> [&dyn Any; 2];
}

impl<F: Copy + Sync + 'static> Claim for Check<F> {
    fn head(&self) -> &Head {
        &self.head
    }

    fn measure(&self, bench: &mut Bench) -> Measured {
        (self.measure)(bench, self.truth)
    }

    fn spoiled(&self, bench: &mut Bench) -> Measured {
        (self.measure)(bench, self.slip)
    }

    fn own(&self, bench: &mut Bench, subject: &dyn Any) -> Option<Measured> {
        subject.downcast_ref().map(|subject| (self.measure)(bench, *subject))
    }

    fn subjects(&self) -> [&dyn Any; 2] {
        [&self.truth, &self.slip]
    }
}

impl fmt::Debug for dyn Claim {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.head().fmt(f)
    }
}

/// A claim without a bound yet.
#[derive(Clone, Copy, Debug)]
pub struct Claimed {
    id: &'static str,
    claim: &'static str,
    rows: &'static [&'static str],
    route: &'static str,
}

/// A check that still lacks its planted mistake.
#[derive(Clone, Copy)]
pub struct Measurement<F: 'static> {
    head: Head,
    measure: fn(&mut Bench, F) -> Measured,
    truth: F,
}

/// The check `id` of a `claim`.
pub const fn check(id: &'static str, claim: &'static str) -> Claimed {
    Claimed { id, claim, rows: &[], route: "" }
}

impl Claimed {
    /// With lecture rows of its own.
    pub const fn rows(self, rows: &'static [&'static str]) -> Self {
        Self { rows, ..self }
    }

    /// The other route that the program's number is held against.
    pub const fn against(self, route: &'static str) -> Self {
        Self { route, ..self }
    }

    /// The worst deviation is at most `limit`, in `unit`: `ulp` for multiples of the rounding unit, `1` for plain numbers,
    /// or an SI unit. `why` says where the limit comes from.
    pub const fn within(self, limit: f64, unit: &'static str, why: &'static str) -> Head {
        self.bound(Bound::AtMost { limit, unit, why })
    }

    /// The observed order is `order`, give or take `tolerance`. `why` says where the two come from.
    pub const fn order(self, order: f64, tolerance: f64, why: &'static str) -> Head {
        self.bound(Bound::Order { order, tolerance, why })
    }

    /// The p-value is at least the check's share of a significance of the whole curriculum.
    pub const fn significant(self, significance: f64) -> Head {
        self.bound(Bound::PValue { significance })
    }

    /// Bounded so.
    pub const fn bound(self, bound: Bound) -> Head {
        let Self { id, claim, rows, route } = self;
        Head { id, claim, rows, route, bound, slip: "" }
    }
}

impl Head {
    /// Measured so, of the `truth`.
    pub const fn of<F: Copy>(self, measure: fn(&mut Bench, F) -> Measured, truth: F) -> Measurement<F> {
        Measurement { head: self, measure, truth }
    }
}

impl<F: Copy> Measurement<F> {
    /// With its planted mistake: what it `says`, and the subject with it put in, no larger than people make it.
    pub const fn slip(self, says: &'static str, slip: F) -> Check<F> {
        Check { head: Head { slip: says, ..self.head }, measure: self.measure, truth: self.truth, slip }
    }
}

/// What a check allows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bound {
    /// The worst deviation may be at most `limit`. `unit` is `ulp` for multiples of the rounding unit
    /// (`f64::EPSILON`), `1` for plain numbers, or an SI unit.
    AtMost {
        /// Largest deviation allowed, in `unit`.
        limit: f64,
        /// Unit of value and limit.
        unit: &'static str,
        /// Where the limit comes from.
        why: &'static str,
    },
    /// The observed order must lie within `tolerance` of `order`.
    Order {
        /// Expected slope.
        order: f64,
        /// Largest distance from it.
        tolerance: f64,
        /// Where the two come from.
        why: &'static str,
    },
    /// The p-value of a statistical test must be at least the significance, corrected (Šidák) for how
    /// many statistical checks the curriculum holds.
    PValue {
        /// Significance of the whole curriculum [1].
        significance: f64,
    },
}

impl Bound {
    /// Whether `value` keeps the bound. NaN breaks every bound.
    pub fn admits(&self, value: f64, statistical_checks: usize) -> bool {
        match *self {
            Self::AtMost { limit, .. } => value <= limit,
            Self::Order { order, tolerance, .. } => (value - order).abs() <= tolerance,
            Self::PValue { significance } => value >= sidak(significance, statistical_checks),
        }
    }

    /// Whether its verdict depends on random numbers.
    pub fn is_statistical(&self) -> bool {
        matches!(self, Self::PValue { .. })
    }
}

/// What a check found: its worst case and where that was.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// In the bound's unit.
    pub value: f64,
    /// The input of the worst case.
    pub at: String,
    /// How many cases were looked at.
    pub cases: usize,
    /// What to look at if the bound breaks: a histogram beside its density.
    pub picture: Option<Plot>,
}

impl fmt::Display for Measured {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:e} at {} ({} cases)", self.value, self.at, self.cases)
    }
}

impl Measured {
    /// A value found over so many `cases`, with the place that it speaks of.
    pub fn new(value: f64, at: impl Into<String>, cases: usize) -> Self {
        Self { value, at: at.into(), cases, picture: None }
    }

    /// With what to look at if the bound breaks.
    pub fn picture(self, picture: Plot) -> Self {
        Self { picture: Some(picture), ..self }
    }

    /// The case of largest magnitude. NaN counts as the largest; no case at all is NaN, which breaks every bound.
    pub fn worst(cases: impl IntoIterator<Item = (f64, String)>) -> Self {
        let mut worst = Self::new(f64::NAN, "no case", 0);
        for (value, at) in cases {
            let magnitude = value.abs();
            worst.cases += 1;
            if worst.cases == 1 || magnitude.total_cmp(&worst.value).is_gt() {
                (worst.value, worst.at) = (magnitude, at);
            }
        }
        worst
    }
}

/// By how much `x` exceeds zero. NaN stays NaN: `max` would let it pass for nothing.
pub fn excess(x: f64) -> f64 {
    if x <= 0.0 { 0.0 } else { x }
}

/// The largest |x| of some. NaN stays NaN, as with [`excess`].
pub fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().map(f64::abs).max_by(f64::total_cmp).unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_excess_of_nan_is_nan() {
        assert!(excess(f64::NAN).is_nan());
        assert_eq!([-1.0, 0.0, 2.0].map(excess), [0.0, 0.0, 2.0]);
    }

    #[test]
    fn nan_breaks_every_bound() {
        let bounds = [
            Bound::AtMost { limit: f64::INFINITY, unit: "1", why: "" },
            Bound::Order { order: 2.0, tolerance: f64::INFINITY, why: "" },
            Bound::PValue { significance: 1e-3 },
        ];
        assert!(bounds.iter().all(|bound| !bound.admits(f64::NAN, 1)));
    }

    #[test]
    fn worst_case_is_nan_if_any_is_or_if_there_is_none() {
        assert!(Measured::worst([]).value.is_nan());
        let worst = Measured::worst([(1.0, "a".into()), (f64::NAN, "b".into()), (-3.0, "c".into())]);
        assert!(worst.value.is_nan());
        assert_eq!((worst.at.as_str(), worst.cases), ("b", 3));
        assert_eq!(Measured::worst([(1.0, "a".into()), (-3.0, "c".into())]).value, 3.0);
        assert!(largest([1.0, f64::NAN, 2.0]).is_nan() && largest([1.0, -f64::NAN, -3.0]).is_nan());
        assert_eq!((largest([1.0, -3.0]), largest([])), (3.0, 0.0));
    }
}
