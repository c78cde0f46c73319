//! Random identities, and random mistakes in them: no verdict may be wrong.

use crate::derivation::{Chain, Verdict};
use crate::dimension::Dimension;
use crate::expr::*;
use crate::symbol::Symbol;
use crate::value::{Bindings, Unevaluable};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use yardstick::precise::{self, Complex};
use yardstick::random;

const X: Symbol = Symbol::scalar("x", Dimension::ONE);
const Y: Symbol = Symbol::scalar("y", Dimension::ONE);
const P: Symbol = Symbol::scalar("p", Dimension::ONE).real(0.25, 1.25);

/// Small forms to put into identities.
fn form() -> impl Strategy<Value = Expr> {
    let leaf = prop_oneof![
        4 => Just(Expr::from(X)),
        4 => Just(Expr::from(Y)),
        2 => Just(Expr::from(P)),
        2 => (1..5_i32).prop_map(Expr::from),
        1 => (1..4_i64, 2..5_i64).prop_map(|(n, d)| ratio(n, d)),
        1 => Just(i()),
        1 => Just(pi()),
    ];
    leaf.prop_recursive(2, 6, 2, |inner| {
        let pair = || (inner.clone(), inner.clone());
        prop_oneof![
            3 => pair().prop_map(|(a, b)| a + b),
            2 => pair().prop_map(|(a, b)| a - b),
            3 => pair().prop_map(|(a, b)| a * b),
            1 => pair().prop_map(|(a, b)| a / b),
            1 => inner.clone().prop_map(|a| -a),
            1 => (inner.clone(), 2..4_i32).prop_map(|(a, n)| a.pow(n)),
            1 => inner.clone().prop_map(sin),
            1 => inner.prop_map(|a| exp(i() * a)),
        ]
    })
}

/// What may stand in a sine without making it too large.
fn angle() -> impl Strategy<Value = Expr> {
    let term = (-3..4_i64, 1..4_i64, prop_oneof![Just(Expr::from(X)), Just(Expr::from(Y)), Just(pi()), Just(X * Y)]);
    proptest::collection::vec(term, 1..3)
        .prop_map(|terms| terms.into_iter().map(|(n, d, of)| ratio(n, d) * of).reduce(|a, b| a + b).unwrap())
}

/// An identity in two forms, a, b, and two angles, u, v.
type Template = fn(&Expr, &Expr, &Expr, &Expr) -> (Expr, Expr);

const TEMPLATES: &[Template] = &[
    |a, b, _, _| ((a + b).pow(2), a.pow(2) + 2 * a * b + b.pow(2)),
    |a, b, _, _| (a.pow(2) - b.pow(2), (a - b) * (a + b)),
    |a, b, _, _| (a.pow(3) - b.pow(3), (a - b) * (a.pow(2) + a * b + b.pow(2))),
    |a, b, _, _| (a / (b * b + 7) + b / (a * a + 9), (a * (a * a + 9) + b * (b * b + 7)) / ((a * a + 9) * (b * b + 7))),
    |a, b, _, _| (1 / (a * a + 5) * (b * (a * a + 5)), b.clone()),
    |a, b, _, _| (a - (b - a), 2 * a - b),
    |a, _, u, _| (a * sin(u).pow(2) + a * cos(u).pow(2), a.clone()),
    |_, _, u, v| (sin(u + v), sin(u) * cos(v) + cos(u) * sin(v)),
    |_, _, u, v| (cos(u - v), cos(u) * cos(v) + sin(u) * sin(v)),
    |_, _, u, v| (2 * sin(u) * cos(v), sin(u + v) + sin(u - v)),
    |_, _, u, v| (cos(u) + cos(v), 2 * cos((u + v) / 2) * cos((u - v) / 2)),
    |_, _, u, v| (sin(u) * cos(u) - sin(v) * cos(v), sin(u - v) * cos(u + v)),
    |_, _, u, v| (sin(u).pow(2) - sin(v).pow(2), sin(u + v) * sin(u - v)),
    |_, _, u, _| (sin(3 * u), 3 * sin(u) - 4 * sin(u).pow(3)),
    |_, _, u, _| (cos(u).pow(4), (3 + 4 * cos(2 * u) + cos(4 * u)) / 8),
    |_, _, u, _| (2 * sin(u / 2).pow(2), 1 - cos(u)),
    |a, _, u, _| (a * (1 + tan(u).pow(2)) * cos(u).pow(2), a.clone()),
    |_, _, u, v| (tan(u + v) * (1 - tan(u) * tan(v)), tan(u) + tan(v)),
    |_, _, u, v| (exp(u) * exp(v), exp(u + v)),
    |_, _, u, v| (exp(i() * u) * exp(i() * v), cos(u + v) + i() * sin(u + v)),
    |a, _, u, _| (a * exp(-i() * u) / exp(i() * u), a * (cos(2 * u) - i() * sin(2 * u))),
    |a, _, _, _| (sqrt(a).pow(2), a.clone()),
    |a, b, _, _| ((sqrt(a) - b) * (sqrt(a) + b), a - b.pow(2)),
    |a, _, _, _| (sqrt(P * a).pow(2) / P, a.clone()),
    |a, _, _, _| (sqrt(P.pow(3)) * a, P * a * sqrt(P)),
    |a, b, _, _| (a * conj(b) + conj(a) * b, 2 * re(a * conj(b))),
    |a, _, _, _| (abs(a).pow(2), re(a).pow(2) + im(a).pow(2)),
];

/// What an identity stands in.
fn embed(context: usize, one: Expr, other: Expr, more: &Expr) -> Expr {
    match context {
        0 => one,
        1 => one + other,
        2 => one * other,
        3 => more - one,
        4 => one / (3 + more * more) + other,
        5 => (one + more).pow(2),
        _ => more * one - other,
    }
}

/// One slip of the pen: the first place from `at` on where it can be made.
fn slip(expr: &Expr, kind: usize, at: &mut usize) -> Expr {
    let here = match (expr.node(), kind) {
        (Node::Function(Function::Sin, of), 0) => Some(cos(of)),
        (Node::Function(Function::Cos, of), 0) => Some(sin(of)),
        (Node::Negate(of), 1) => Some(of.clone()),
        (Node::Power(base, exponent), 2) if exponent.as_integer() == Some(2) => Some(base.pow(3)),
        (Node::Number(value), 3) => Some(Expr::number(*value) + 1),
        (Node::Symbol(symbol), 4) if symbol.name() == "x" => Some(Y.into()),
        (Node::Sum(terms), 5) => Some(terms[1..].iter().cloned().reduce(|a, b| a + b).unwrap()),
        (Node::Quotient(above, _), 6) => Some(above.clone()),
        (Node::Function(Function::Conj, of), 7) => Some(of.clone()),
        _ => None,
    };
    match here {
        Some(wrong) if *at == 0 => {
            *at = usize::MAX;
            wrong
        }
        here => {
            if here.is_some() {
                *at -= 1;
            }
            expr.map(&mut |child| slip(child, kind, at))
        }
    }
}

/// What two forms differ by, relative to their size, at a point of its own: in other arithmetic and at another
/// precision than the decider's guard. `None` where a value does not exist.
fn gap(left: &Expr, right: &Expr) -> Option<f64> {
    let value = |re: f64, im: f64| Complex::from_parts(precise::real_at(re, 400), precise::real_at(im, 400));
    let bindings = Bindings::with_bits(400)
        .with(&X, value(0.731_058_578_630, 0.061_8))
        .with(&Y, value(0.414_213_562_373, -0.173_2))
        .with(&P, value(0.577_215_664_901, 0.0));
    let at = |expr: &Expr| -> Result<Complex, Unevaluable> { expr.evaluate(&bindings) };
    let (left, right) = (at(left).ok()?, at(right).ok()?);
    let size = |z: &Complex| precise::to_complex64(z).norm();
    // A zero that is left of larger terms is not relatively exact.
    Some(size(&(&left - &right)) / (size(&left) + size(&right)).max(1e-30))
}

fn judge(left: &Expr, right: &Expr, seed: u64) -> Verdict {
    let chain = Chain::new(left.clone()).then(right.clone(), ["claimed"]);
    chain.verify(3, 128, &mut random::stream(seed, "ring")).remove(0).verdict
}

proptest! {
    #![proptest_config(ProptestConfig { rng_seed: RngSeed::Fixed(53), failure_persistence: None, ..ProptestConfig::with_cases(1500) })]

    /// Every template is within what the decider is complete for, as long as the forms put in are.
    #[test]
    fn no_identity_is_refuted_and_no_slip_is_proved(
        (one, other) in (0..TEMPLATES.len(), 0..TEMPLATES.len()),
        (a, b) in (form(), form()),
        (u, v) in (angle(), angle()),
        context in 0..7_usize,
        (kind, place) in (0..8_usize, 0..4_usize),
        seed in 0..1000_u64,
    ) {
        let (first, second) = (TEMPLATES[one](&a, &b, &u, &v), TEMPLATES[other](&b, &a, &v, &u));
        let left = embed(context, first.0, second.0, &b);
        let right = embed(context, first.1, second.1, &b);
        match judge(&left, &right, seed) {
            Verdict::Refuted { at, .. } => prop_assert!(false, "{left} = {right} refuted at {at:?}"),
            Verdict::Agrees { .. } => prop_assert!(false, "{left} = {right} is left open"),
            Verdict::Proved => {}
            // A denominator that vanishes, or a form that grew too large.
            Verdict::Unknown { .. } => prop_assume!(false),
        }
        let mut at = place;
        let wrong = slip(&right, kind, &mut at);
        let Some(gap) = gap(&left, &wrong) else { return Ok(()) };
        let verdict = judge(&left, &wrong, seed);
        let fits = match &verdict {
            Verdict::Proved | Verdict::Agrees { .. } => gap < 1e-60,
            Verdict::Refuted { .. } => gap > 1e-60,
            Verdict::Unknown { .. } => true,
        };
        prop_assert!(fits, "{left} = {wrong}: {verdict:?}, but they are {gap:e} apart");
    }
}
