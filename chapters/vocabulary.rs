//! The words in which a chapter is written: all data, nothing about how it is shown.
//!
//! A claim is found by its address, `chapter/step/item` (`fresnel/energy/r_plus_t`): the same string is
//! command-line argument, JSON key, test name, book anchor and random stream.

use crate::figure::Plot;
use crate::function::Function;
use crate::setting::{Parameter, Setting};
use equation::Equation;
use equation::derivation::{Chain, Hop};
use yardstick::order;
use yardstick::precise::{self, Real};
use yardstick::random::{Stream, stream};
pub use yardstick::statistics::{rms, sidak};

/// One chapter of the lecture.
#[derive(Debug)]
pub struct Chapter {
    /// First part of every address in it; also the command-line word.
    pub id: &'static str,
    /// Heading.
    pub title: &'static str,
    /// One sentence: what the learner can do afterwards.
    pub says: &'static str,
    /// Ids of the chapters it needs.
    pub builds_on: &'static [&'static str],
    /// The course text, Markdown; `<!-- step: id -->` stands where that step's views go.
    pub prose: &'static str,
    /// In teaching order.
    pub steps: &'static [Step],
    /// What `lesson eval` offers from this chapter.
    pub functions: &'static [Function],
}

/// One step of a chapter: everything that any view of it needs.
#[derive(Debug)]
pub struct Step {
    /// Second part of the address; a module name (`total_reflection`).
    pub id: &'static str,
    /// Heading.
    pub title: &'static str,
    /// The claim in one sentence.
    pub says: &'static str,
    /// The lecture rows that this step teaches (`E36`, `C10`). Its items name the rows they are evidence for.
    pub rows: &'static [&'static str],
    /// What `--set` may change here.
    pub parameters: &'static [Parameter],
    /// The equations shown, as objects.
    pub statements: &'static [Statement],
    /// How the statements follow from earlier ones.
    pub derivations: &'static [Derivation],
    /// The step's quantities at the setting, computed by the program's own functions.
    pub readout: Option<fn(&Setting) -> Vec<Quantity>>,
    /// What could refute it.
    pub checks: &'static [Check],
    /// What could break it.
    pub stress: &'static [Stress],
    /// What it costs.
    pub races: &'static [Race],
    /// What it looks like.
    pub figures: &'static [Figure],
}

/// An equation on the page: the same object is typeset, unit-checked and evaluated.
#[derive(Debug)]
pub struct Statement {
    /// Last part of the address.
    pub id: &'static str,
    /// What it says in words.
    pub says: &'static str,
    /// Lecture rows it states.
    pub rows: &'static [&'static str],
    /// Builds the equation.
    pub equation: fn() -> Equation,
}

/// A chain of lines from earlier equations to a later one, each hop verified.
#[derive(Debug)]
pub struct Derivation {
    /// Last part of the address.
    pub id: &'static str,
    /// What is derived from what.
    pub says: &'static str,
    /// Lecture rows it derives.
    pub rows: &'static [&'static str],
    /// Hypotheses and lines.
    pub chain: fn() -> Chain,
    /// The planted mistake: the same chain with one wrong line, which must be refused.
    pub spoiled: fn() -> Chain,
    /// What the planted mistake is.
    pub slip: &'static str,
}

/// At how many points the hops of a derivation are compared.
pub const POINTS: usize = 16;

/// Every hop of `chain`, judged at points that its derivation's `address` names.
pub fn verify(chain: &Chain, address: &str) -> Vec<Hop> {
    chain.verify(POINTS, precise::BITS, &mut stream(SEED, address))
}

/// A named number shown for the current setting.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// Stable key in JSON (`r_s_re`).
    pub key: &'static str,
    /// Symbol, in the label markup of [`crate::figure`] (`R_s`, `θ_B`).
    pub symbol: &'static str,
    /// What it is.
    pub says: &'static str,
    /// Value in SI.
    pub value: f64,
    /// Unit shown; angles are stored in radians with unit `rad` and shown in degrees.
    pub unit: &'static str,
}

/// What a measurement may use: the setting and random numbers of its own.
#[derive(Debug)]
pub struct Bench<'a> {
    /// The parameters in force.
    pub setting: &'a Setting,
    /// The stream named by the item's address.
    pub stream: Stream,
}

/// The seed of every random stream of the lecture.
pub const SEED: u64 = 0;

impl<'a> Bench<'a> {
    /// The bench of the item at `address`.
    pub fn new(setting: &'a Setting, seed: u64, address: &str) -> Self {
        Self { setting, stream: stream(seed, address) }
    }
}

/// A claim that a number could refute.
#[derive(Debug)]
pub struct Check {
    /// Last part of the address.
    pub id: &'static str,
    /// The claim.
    pub claim: &'static str,
    /// Lecture rows it is evidence for (letter N).
    pub rows: &'static [&'static str],
    /// The other route that the program's number is held against.
    pub route: &'static str,
    /// How far it may be off, and why.
    pub bound: Bound,
    /// The measurement.
    pub measure: fn(&mut Bench) -> Measured,
    /// The planted mistake: the same measurement with the classic slip put in. It must break the bound.
    pub spoiled: fn(&mut Bench) -> Measured,
    /// What the planted mistake is.
    pub slip: &'static str,
}

/// What a check allows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bound {
    /// The worst deviation may be at most `limit`. `unit` is `ε` for multiples of the rounding unit
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
}

impl Measured {
    /// The case of largest magnitude. NaN counts as the largest; no case at all is NaN, which breaks every bound.
    pub fn worst(cases: impl IntoIterator<Item = (f64, String)>) -> Self {
        let mut worst = Self { value: f64::NAN, at: "no case".into(), cases: 0 };
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

/// A family of inputs chosen to break formulas. Beside each stands what the textbook form makes of it:
/// a stress whose textbook form never breaks is refused by the tests.
#[derive(Debug)]
pub struct Stress {
    /// Last part of the address.
    pub id: &'static str,
    /// What is pushed, and what holds all the same.
    pub claim: &'static str,
    /// Lecture rows it is evidence for (letter X).
    pub rows: &'static [&'static str],
    /// What the textbook column computes.
    pub textbook: &'static str,
    /// Where the reference comes from.
    pub reference: &'static str,
    /// The cases.
    pub cases: fn(&Setting) -> Vec<Extreme>,
}

/// How many rounding units, per unit of 1 + κ, a result may be off: the project's promise of accuracy.
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
    /// Condition number κ of the quantity with respect to its inputs [1].
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

/// Several methods for one number, each at growing work: error against run time.
#[derive(Debug)]
pub struct Race {
    /// Last part of the address.
    pub id: &'static str,
    /// What the race shows.
    pub claim: &'static str,
    /// Lecture rows it is evidence for (letter R).
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
#[derive(Debug)]
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

impl Lane {
    /// A lane without chance in it: one run makes its error.
    pub const fn once(
        id: &'static str,
        label: &'static str,
        works: &'static [u64],
        expects: Expects,
        prepare: fn(&mut Bench, u64) -> Heat,
    ) -> Self {
        Self { id, label, works, expects, repeats: 1, prepare }
    }

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

/// A picture of the step at a setting.
#[derive(Debug)]
pub struct Figure {
    /// Last part of the address, and the file name.
    pub id: &'static str,
    /// What is to be seen.
    pub says: &'static str,
    /// Lecture rows it is evidence for (letter P).
    pub rows: &'static [&'static str],
    /// Makes the figure; data, drawn elsewhere.
    pub plot: fn(&Setting) -> Plot,
}

#[cfg(test)]
mod tests {
    use super::*;

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
    }

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

    #[test]
    fn no_digits_are_plain_zero() {
        for error in [1.0, 10.0, f64::INFINITY, f64::NAN] {
            assert_eq!(digits(error).to_bits(), 0, "{error}");
        }
    }
}
