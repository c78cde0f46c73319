//! Error against run time.

use super::{Bench, SEED};
use crate::parameter::Setting;
use yardstick::order;

/// Several methods for one number, each at growing work: error against run time.
#[derive(Clone, Copy, Debug)]
pub struct Race {
    /// Last part of the address.
    pub id: &'static str,
    /// What the race shows.
    pub claim: &'static str,
    /// Lecture rows it is evidence for (letter R); those of its step if empty.
    pub rows: &'static [&'static str],
    /// What one unit of work is (`evaluations of R_n`).
    pub work: &'static str,
    /// Name of the error: what of, and whether it is relative (`relative error of R_n`, `|ΔR|`).
    pub error: &'static str,
    /// How `error` is taken and where the reference comes from.
    pub reference: &'static str,
    /// The contestants.
    pub lanes: &'static [Lane],
}

/// One contestant of a race.
#[derive(Clone, Copy, Debug)]
pub struct Lane {
    /// Last part of the lane's address (`…/race/lane`).
    pub id: &'static str,
    /// Name in table and legend.
    pub label: &'static str,
    /// The amounts of work it is run at.
    pub works: &'static [u64],
    /// What is asserted of its errors (never of its seconds).
    pub expects: Expects,
    /// How many independent runs make one RMS error; 1 for a deterministic lane.
    pub repeats: u32,
    /// Sets up one run of `work` units (not timed).
    pub prepare: fn(&mut Bench, u64) -> Heat,
}

/// The race `id`, which shows what its `claim` says.
pub const fn race(id: &'static str, claim: &'static str) -> Race {
    Race { id, claim, rows: &[], work: "", error: "", reference: "", lanes: &[] }
}

impl Race {
    /// With lecture rows of its own.
    pub const fn rows(self, rows: &'static [&'static str]) -> Self {
        Self { rows, ..self }
    }

    /// The same race under another name, for other lanes.
    pub const fn named(self, id: &'static str, claim: &'static str) -> Self {
        Self { id, claim, ..self }
    }

    /// What one unit of work is.
    pub const fn work(self, work: &'static str) -> Self {
        Self { work, ..self }
    }

    /// The error's name, how it is taken and where its reference comes from.
    pub const fn error(self, error: &'static str, reference: &'static str) -> Self {
        Self { error, reference, ..self }
    }

    /// The contestants.
    pub const fn lanes(self, lanes: &'static [Lane]) -> Self {
        Self { lanes, ..self }
    }
}

/// A lane of which nothing is asserted yet.
#[derive(Clone, Copy, Debug)]
pub struct Entrant {
    id: &'static str,
    label: &'static str,
    works: &'static [u64],
    repeats: u32,
    prepare: fn(&mut Bench, u64) -> Heat,
}

/// The lane `id`, run once at each of the `works` as `prepare` sets it up.
pub const fn lane(
    id: &'static str,
    label: &'static str,
    works: &'static [u64],
    prepare: fn(&mut Bench, u64) -> Heat,
) -> Entrant {
    Entrant { id, label, works, repeats: 1, prepare }
}

impl Entrant {
    /// So many independent runs make one RMS error.
    pub const fn repeated(self, repeats: u32) -> Self {
        Self { repeats, ..self }
    }

    /// Error ∝ work^(−order), the fitted order within `tolerance`.
    pub const fn order(self, order: f64, tolerance: f64) -> Lane {
        self.expects(Expects::Order { order, tolerance })
    }

    /// Every error at most `limit`; `why` says where that comes from.
    pub const fn within(self, limit: f64, why: &'static str) -> Lane {
        self.expects(Expects::Within { limit, why })
    }

    /// Every error below the one before, and that of the most work at most `last`.
    pub const fn converges(self, last: f64, why: &'static str) -> Lane {
        self.expects(Expects::Converges { last, why })
    }

    /// At least one error above `limit`; `why` says what breaks it.
    pub const fn breaks(self, limit: f64, why: &'static str) -> Lane {
        self.expects(Expects::Breaks { limit, why })
    }

    /// With what is asserted of its errors.
    pub const fn expects(self, expects: Expects) -> Lane {
        let Self { id, label, works, repeats, prepare } = self;
        Lane { id, label, works, expects, repeats, prepare }
    }
}

impl Lane {
    /// The independent runs whose errors make one RMS error at `work`, each on a stream of its own, set up one by one.
    /// `address` is the lane's.
    pub fn heats(&self, setting: &Setting, address: &str, work: u64) -> impl Iterator<Item = Heat> {
        (0..self.repeats.max(1)).map(move |repeat| {
            (self.prepare)(&mut Bench::new(setting, SEED, &format!("{address}/{work}/{repeat}")), work)
        })
    }
}

/// A prepared run: what is timed, and the error of what it leaves behind.
pub struct Heat {
    /// The timed part; it may be run many times and leaves the same result each time.
    pub run: Run,
    /// The error of what `run` returned [1], relative unless the race says otherwise; not timed.
    pub error: Judge,
}

/// What is timed.
pub type Run = Box<dyn FnMut() -> Vec<f64>>;
/// What is not.
pub type Judge = Box<dyn Fn(&[f64]) -> f64>;

/// What a lane's errors must do as work grows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Expects {
    /// Error ∝ work^(−order), the fitted order within `tolerance`.
    Order {
        /// Expected order.
        order: f64,
        /// Largest distance of the fitted one.
        tolerance: f64,
    },
    /// Every error at most `limit`.
    Within {
        /// Largest error allowed [1].
        limit: f64,
        /// Where the limit comes from.
        why: &'static str,
    },
    /// Every error below the one before, and that of the most work at most `last`: faster than any order.
    Converges {
        /// Largest error allowed in the end [1].
        last: f64,
        /// Where it comes from.
        why: &'static str,
    },
    /// At least one error above `limit`: a lane that is there because it breaks.
    Breaks {
        /// Error that must be exceeded (NaN exceeds every limit) [1].
        limit: f64,
        /// What breaks it.
        why: &'static str,
    },
}

impl Expects {
    /// Whether a lane's (work, error) points do what is expected of them. NaN is larger than every limit and
    /// has no order.
    pub fn admits(&self, points: &[(f64, f64)]) -> bool {
        let within = |limit: f64| points.iter().all(|(_, error)| *error <= limit);
        match *self {
            Self::Order { order, tolerance } => {
                within(f64::MAX) && fitted_order(points).is_some_and(|fitted| (fitted - order).abs() <= tolerance)
            }
            Self::Within { limit, .. } => within(limit),
            Self::Converges { last, .. } => {
                points.windows(2).all(|pair| pair[1].1 < pair[0].1)
                    && points.last().is_some_and(|(_, error)| *error <= last)
            }
            Self::Breaks { limit, .. } => !within(limit),
        }
    }
}

/// The order p of a method whose (work, error) points fall as work^(−p) [1]; `None` if fewer than two can be used.
pub fn fitted_order(points: &[(f64, f64)]) -> Option<f64> {
    order::slope(points).map(|slope| -slope)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lanes_are_judged_by_their_errors() {
        let falling: Vec<_> = (1..6).map(|k| (f64::from(1 << k), 0.25_f64.powi(k))).collect();
        assert!(Expects::Order { order: 2.0, tolerance: 0.01 }.admits(&falling));
        assert!(!Expects::Order { order: 1.0, tolerance: 0.5 }.admits(&falling));
        assert!(Expects::Within { limit: 0.25, why: "" }.admits(&falling));
        assert!(Expects::Converges { last: 0.25_f64.powi(5), why: "" }.admits(&falling));
        assert!(!Expects::Converges { last: 0.25_f64.powi(6), why: "" }.admits(&falling));
        assert!(!Expects::Converges { last: 1.0, why: "" }.admits(&[&falling[..], &[(64.0, 0.1)]].concat()));
        assert!(Expects::Breaks { limit: 0.2, why: "" }.admits(&falling));
        let broken = [&falling[..], &[(128.0, f64::NAN)]].concat();
        assert!(!Expects::Order { order: 2.0, tolerance: 0.01 }.admits(&broken));
        assert!(!Expects::Within { limit: f64::INFINITY, why: "" }.admits(&broken));
        assert!(!Expects::Converges { last: f64::INFINITY, why: "" }.admits(&broken));
        assert!(!Expects::Converges { last: f64::INFINITY, why: "" }.admits(&[]));
        assert!(Expects::Breaks { limit: f64::INFINITY, why: "" }.admits(&broken));
    }
}
