//! Two sides compared at points of their symbols' domains.

use super::atoms::Atoms;
use super::model::Model;
use super::verdict::Verdict;
use crate::Equation;
use crate::expr::Expr;
use crate::symbol::{Domain, Symbol};
use crate::tracked::Tracked;
use crate::value::{Bindings, Evaluation, Unevaluable};
use num_complex::Complex64;
use rand::RngExt;
use yardstick::precise::{self, Complex};
use yardstick::random::Stream;

/// How many points are tried for each one that is wanted.
const ATTEMPTS: usize = 8;

/// How far apart, in units of the two error bounds, values may lie that are still called equal: room for the few
/// units in the last place that the functions themselves may be off.
const ALLOWANCE: f64 = 16.0;

/// How far apart, relative to the size of their terms, two sides lie at a point that an `f64` tells before they differ
/// beyond doubt.
const DISTINCT: f64 = 1e-4;

/// Why nothing is proved from premises that may contradict one another.
const NO_MODEL: &str = "no point was found that satisfies all premises: they may contradict one another";

/// A comparison of two sides: what their normal forms say, and what their values do.
#[derive(Clone)]
pub(super) struct Comparison {
    left: Expr,
    right: Expr,
    /// Whether the normal form decides that they are equal, or why not.
    normal: Result<(), String>,
    /// What must not vanish for the one to follow from the other: then only whether they have values is looked at.
    implied_by: Option<Expr>,
    /// At how many points they are compared.
    wanted: usize,
    compared: usize,
    skipped: usize,
    digits: Option<f64>,
    last_singularity: String,
    settled: Option<Verdict>,
}

/// What a point must satisfy to count.
#[derive(Default)]
pub(super) struct Admission {
    /// Roots that stand for positive quantities: positive.
    pub roots: Vec<Expr>,
    /// What else stands for positive quantities: positive, unless it is so nowhere, because a premise says otherwise.
    pub positive: Vec<Expr>,
    /// What was divided by: beyond doubt not zero.
    pub divisors: Vec<Expr>,
}

impl Admission {
    fn admits(&self, evaluation: &mut Evaluation<Tracked>, strictly: bool) -> bool {
        let mut all = |values: &[Expr], are: fn(&Tracked) -> bool| {
            values.iter().all(|value| evaluation.value(value).is_ok_and(|value| are(&value)))
        };
        all(&self.roots, Tracked::is_right_of_zero)
            && all(&self.divisors, |value| !value.may_vanish())
            && (!strictly || all(&self.positive, Tracked::is_right_of_zero))
    }
}

/// What sort of points a comparison found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Points {
    /// Such that what is called positive is.
    Positive,
    /// None such, but others.
    Other,
    /// None that satisfies the premises.
    None,
}

/// Compares everything at common points, so that common parts are computed once.
pub(super) fn run(
    comparisons: &mut [Comparison],
    admission: &Admission,
    atoms: &Atoms,
    bits: usize,
    stream: &mut Stream,
) -> Points {
    compare(comparisons, (admission, true), atoms, bits, stream);
    let is_untouched = |comparisons: &[Comparison]| comparisons.iter().all(Comparison::is_untouched);
    if !is_untouched(comparisons) {
        return Points::Positive;
    }
    if !admission.positive.is_empty() {
        compare(comparisons, (admission, false), atoms, bits, stream);
    }
    if is_untouched(comparisons) { Points::None } else { Points::Other }
}

fn compare(
    comparisons: &mut [Comparison],
    (admission, strictly): (&Admission, bool),
    atoms: &Atoms,
    bits: usize,
    stream: &mut Stream,
) {
    let symbols = free_symbols(comparisons, admission, &[]);
    let most = comparisons.iter().map(|pair| pair.wanted).max().unwrap_or(0);
    for attempt in 0..most * ATTEMPTS {
        if comparisons.iter().all(Comparison::is_done) {
            break;
        }
        let sample = draw(&symbols, attempt % 2 == 1, stream);
        let bindings = bind(&sample, bits);
        let mut evaluation = Evaluation::new(&bindings);
        if !admission.admits(&mut evaluation, strictly) {
            continue;
        }
        for pair in comparisons.iter_mut().filter(|pair| !pair.is_done()) {
            pair.look(&mut evaluation, &sample, atoms, bits);
        }
    }
}

/// Every symbol that a point must have a value for.
pub(super) fn free_symbols(comparisons: &[Comparison], admission: &Admission, premises: &[Equation]) -> Vec<Symbol> {
    let mut found: Vec<Symbol> = Vec::new();
    let sides = comparisons.iter().flat_map(|pair| [&pair.left, &pair.right]);
    let sides = sides.chain(premises.iter().flat_map(|premise| [&premise.lhs, &premise.rhs]));
    let more = [&admission.roots, &admission.positive, &admission.divisors];
    for expr in sides.chain(more.into_iter().flatten()) {
        for symbol in expr.symbols() {
            if found.iter().all(|known| known.name() != symbol.name()) {
                found.push(symbol.clone());
            }
        }
    }
    found
}

fn bind(sample: &[(&Symbol, Complex64)], bits: usize) -> Bindings<Tracked> {
    let mut bindings = Bindings::with_bits(bits);
    for (symbol, value) in sample {
        let part = |x| precise::real_at(x, bits);
        bindings.bind(symbol.name(), Tracked::exact(Complex::from_parts(part(value.re), part(value.im)), bits));
    }
    bindings
}

/// A point of the symbols' domains.
pub(super) fn draw<'a>(symbols: &'a [Symbol], off_axis: bool, stream: &mut Stream) -> Vec<(&'a Symbol, Complex64)> {
    symbols.iter().map(|symbol| (symbol, draw_one(symbol.domain(), off_axis, stream))).collect()
}

/// A point of the domain. On the real axis where the domain touches it, unless `off_axis`.
fn draw_one(domain: Domain, off_axis: bool, stream: &mut Stream) -> Complex64 {
    let mut within = |(min, max): (f64, f64)| min + (max - min) * stream.random::<f64>();
    let (re, im) = (within(domain.re), within(domain.im));
    let touches_axis = domain.im.0 <= 0.0 && domain.im.1 >= 0.0;
    Complex64::new(re, if touches_axis && !off_axis { 0.0 } else { im })
}

impl Comparison {
    pub fn new(left: Expr, right: Expr, normal: Result<(), String>, wanted: usize) -> Self {
        let (compared, skipped, digits, last_singularity, settled) = (0, 0, None, String::new(), None);
        let implied_by = None;
        Self { left, right, normal, implied_by, wanted, compared, skipped, digits, last_singularity, settled }
    }

    /// Sides that are equal by a premise that no point is known to satisfy, where `divisor` does not vanish.
    pub fn implied(left: Expr, right: Expr, divisor: Expr, wanted: usize) -> Self {
        Self { implied_by: Some(divisor), ..Self::new(left, right, Ok(()), wanted) }
    }

    fn is_untouched(&self) -> bool {
        self.settled.is_none() && self.compared + self.skipped == 0
    }

    fn is_done(&self) -> bool {
        self.settled.is_some() || self.compared >= self.wanted
    }

    fn look(
        &mut self,
        evaluation: &mut Evaluation<Tracked>,
        sample: &[(&Symbol, Complex64)],
        atoms: &Atoms,
        bits: usize,
    ) {
        let values = evaluation.value(&self.left).and_then(|l| Ok((l, evaluation.value(&self.right)?)));
        let (left, right) = match values {
            Ok(values) => values,
            Err(Unevaluable::Singular(face)) => {
                self.skipped += 1;
                self.last_singularity = face;
                return;
            }
            Err(other) => {
                self.settled = Some(Verdict::Unknown { why: other.to_string() });
                return;
            }
        };
        if let Some(divisor) = &self.implied_by {
            match evaluation.value(divisor) {
                Ok(divisor) if !divisor.may_vanish() => (self.compared, self.digits) = (self.compared + 1, Some(0.0)),
                _ => self.skipped += 1,
            }
            return;
        }
        let Some(difference) = left.difference(&right) else {
            self.skipped += 1;
            return;
        };
        self.compared += 1;
        let all = bits as f64 * std::f64::consts::LOG10_2;
        let digits = (-difference.log10()).min(all);
        if difference <= ALLOWANCE * (-(bits as f64)).exp2() {
            self.digits = Some(self.digits.map_or(digits, |worst| worst.min(digits)));
        } else {
            let symbols = [self.left.symbols(), self.right.symbols()].concat();
            let own = |symbol: &Symbol| symbols.contains(&symbol);
            let at = sample.iter().filter(|(symbol, _)| own(symbol));
            let at = at.map(|(symbol, value)| (atoms.face(symbol), text(*value))).collect();
            self.settled = Some(Verdict::Refuted { at, digits });
        }
    }

    /// What is known where there are premises that the points do not satisfy, but some of `models` may: a proof needs a point where they hold, and a
    /// refutation one where they hold beyond doubt.
    pub fn verdict_at(self, models: &[Model], atoms: &Atoms, bits: usize) -> Verdict {
        let divides = |model: &Model| self.implied_by.as_ref().is_none_or(|divisor| !model.is_zero_of(divisor));
        let is_possible = models.iter().any(divides);
        let sharp = models.iter().filter(|model| model.is_sharp && !atoms.is_doubtful());
        let refuted = sharp.into_iter().find_map(|model| self.refuted_at(model, atoms, bits));
        match (self.verdict(atoms), refuted) {
            (Verdict::Proved, _) if !is_possible => Verdict::Unknown { why: NO_MODEL.to_owned() },
            (Verdict::Refuted { .. } | Verdict::Agrees { .. }, Some(refuted)) => refuted,
            (Verdict::Refuted { .. }, None) => {
                Verdict::Unknown { why: "a premise cannot be solved for any of its symbols".to_owned() }
            }
            (verdict, _) => verdict,
        }
    }

    fn refuted_at(&self, model: &Model, atoms: &Atoms, bits: usize) -> Option<Verdict> {
        let sample: Vec<_> = model.at.iter().map(|(symbol, value)| (symbol, *value)).collect();
        let bindings = bind(&sample, bits);
        let mut evaluation = Evaluation::new(&bindings);
        let (left, right) = (evaluation.value(&self.left).ok()?, evaluation.value(&self.right).ok()?);
        let difference = left.difference(&right).filter(|difference| *difference > DISTINCT)?;
        let at = sample.iter().map(|(symbol, value)| (atoms.face(symbol), text(*value))).collect();
        Some(Verdict::Refuted { at, digits: -difference.log10() })
    }

    pub fn verdict(self, atoms: &Atoms) -> Verdict {
        let singular = || match self.last_singularity.as_str() {
            "" => {
                format!("the values are out of range, or vanish where they must not, at all of {} points", self.skipped)
            }
            face => format!("{face} has no finite value at any of {} points", self.skipped),
        };
        match (self.normal, self.settled, self.digits) {
            (Ok(()), None, Some(_)) => Verdict::Proved,
            (Ok(()), Some(Verdict::Refuted { .. }), _) => {
                Verdict::Unknown { why: "the normal forms agree, but not the values on every branch".to_owned() }
            }
            (Err(_), Some(Verdict::Refuted { .. }), _) if atoms.is_doubtful() => {
                Verdict::Unknown { why: "a function's arguments may be equal or not".to_owned() }
            }
            (_, Some(verdict), _) => verdict,
            (Err(_), None, Some(digits)) => Verdict::Agrees { points: self.compared, skipped: self.skipped, digits },
            (_, None, None) if self.skipped > 0 => Verdict::Unknown { why: singular() },
            (_, None, None) => Verdict::Unknown { why: NO_MODEL.to_owned() },
        }
    }
}

fn text(value: Complex64) -> String {
    match value.im {
        0.0 => value.re.to_string(),
        im if im < 0.0 => format!("{} − {}i", value.re, -im),
        im => format!("{} + {im}i", value.re),
    }
}
