//! Points that satisfy premises which no symbol could be taken from: followed down their slopes, premise after premise
//! (Kaczmarz's method with each equation made linear where it stands).

use super::sample::{Admission, draw};
use crate::Equation;
use crate::expr::Expr;
use crate::symbol::Symbol;
use crate::value::Bindings;
use num_complex::Complex64;
use yardstick::random::Stream;

/// How many points are looked for, and from how many starts.
const WANTED: usize = 4;
const STARTS: usize = 32;
/// Rounds over all premises before a start is given up.
const ROUNDS: usize = 200;
/// The last step of a search that has arrived [relative]; of one that met its premises at an angle, so that the point is
/// known as well as an `f64` can tell.
const NEAR: f64 = 1e-6;
const SHARP: f64 = 1e-12;

/// A point that satisfies every premise, up to rounding.
pub(super) struct Model {
    pub at: Vec<(Symbol, Complex64)>,
    /// Whether it is known to the rounding of an `f64`: where a premise only touches zero it is not.
    pub is_sharp: bool,
}

impl Model {
    /// Whether nothing is left of `expr` here.
    pub fn is_zero_of(&self, expr: &Expr) -> bool {
        !value(expr, &self.at).is_some_and(|value| value.norm() > NEAR)
    }
}

/// Points that satisfy `premises` and `admission`, with values for all of `symbols`.
pub(super) fn find(
    premises: &[Equation],
    admission: &Admission,
    symbols: &[Symbol],
    stream: &mut Stream,
) -> Vec<Model> {
    let differences: Vec<Expr> = premises.iter().map(|premise| &premise.lhs - &premise.rhs).collect();
    let mut found = Vec::new();
    for _ in 0..STARTS {
        let start = draw(symbols, false, stream).into_iter().map(|(symbol, value)| (symbol.clone(), value)).collect();
        found.extend(descend(&differences, start).filter(|model| fits(model, admission)));
        if found.len() == WANTED {
            break;
        }
    }
    found
}

fn fits(model: &Model, admission: &Admission) -> bool {
    let is_positive = |expr: &Expr| value(expr, &model.at).is_some_and(|value| value.re > NEAR);
    let keeps_sign = |(symbol, value): &(Symbol, Complex64)| symbol.domain().re.0 <= 0.0 || value.re > NEAR;
    model.at.iter().all(keeps_sign)
        && admission.roots.iter().chain(&admission.positive).all(is_positive)
        && !admission.divisors.iter().any(|divisor| model.is_zero_of(divisor))
}

fn descend(differences: &[Expr], mut at: Vec<(Symbol, Complex64)>) -> Option<Model> {
    for _ in 0..ROUNDS {
        let mut longest: f64 = 0.0;
        for difference in differences {
            longest = longest.max(step(difference, &mut at)?);
        }
        if longest < SHARP {
            return Some(Model { at, is_sharp: true });
        }
    }
    let last =
        differences.iter().map(|difference| step(difference, &mut at)).try_fold(0.0, |a: f64, b| Some(a.max(b?)))?;
    (last < NEAR).then_some(Model { at, is_sharp: false })
}

/// Moves the point to where `difference`, made linear, vanishes; how far, relative to where it is. `None` where there is
/// no way.
fn step(difference: &Expr, at: &mut [(Symbol, Complex64)]) -> Option<f64> {
    let here = value(difference, at)?;
    if here.norm() == 0.0 {
        return Some(0.0);
    }
    let names = difference.symbols();
    let mut slopes = vec![0.0; at.len()];
    for place in 0..at.len() {
        if !names.contains(&&at[place].0) {
            continue;
        }
        let (middle, aside) = (at[place].1, 1e-6 * (1.0 + at[place].1.norm()));
        let mut beside = |offset: f64| {
            at[place].1 = middle + offset;
            value(difference, at)
        };
        let rise = beside(aside).zip(beside(-aside)).map(|(above, below)| (above - below) / (2.0 * aside));
        at[place].1 = middle;
        slopes[place] = (here.conj() * rise?).re;
    }
    let steepness: f64 = slopes.iter().map(|slope| slope * slope).sum();
    if steepness == 0.0 {
        return None;
    }
    let mut longest: f64 = 0.0;
    for ((_, value), slope) in at.iter_mut().zip(slopes) {
        let move_by = -here.norm_sqr() * slope / steepness;
        *value += move_by;
        longest = longest.max(move_by.abs() / (1.0 + value.norm()));
    }
    longest.is_finite().then_some(longest)
}

fn value(expr: &Expr, at: &[(Symbol, Complex64)]) -> Option<Complex64> {
    let mut bindings = Bindings::new();
    at.iter().for_each(|(symbol, value)| bindings.bind(symbol.name(), *value));
    expr.evaluate(&bindings).ok().filter(|value: &Complex64| value.is_finite())
}
