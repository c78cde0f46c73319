//! Random premises with common factors, factors that another premise makes zero, and contradictions, in every order: what
//! is said of a claim is held against every point of a grid.

use super::{Chain, Verdict};
use crate::Equation;
use crate::dimension::Dimension;
use crate::expr::{Expr, sqrt};
use crate::symbol::Symbol;
use crate::value::Bindings;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use yardstick::random;

const NAMES: [&str; 4] = ["a", "x", "y", "z"];

fn symbol(at: usize) -> Expr {
    Symbol::scalar(NAMES[at], Dimension::ONE).real(0.1, 4.0).into()
}

/// A name, or a small number.
fn part() -> impl Strategy<Value = Expr> {
    prop_oneof![3 => (1..4_usize).prop_map(symbol), 1 => (1..3_i32).prop_map(Expr::from)]
}

/// Equations whose solutions, where they have any, lie on the grid too.
fn premise() -> impl Strategy<Value = Equation> {
    let factor =
        || prop_oneof![3 => Just(symbol(0)), 1 => (1..4_usize).prop_map(symbol), 1 => Just(symbol(0) * symbol(3))];
    let scaled = |(factor, a, b): (Expr, Expr, Expr)| Equation::new(&factor * a, factor * b);
    let ahead = |(factor, a, b): (Expr, Expr, Expr)| Equation::new(factor * (a - b), 0);
    let below = |(factor, a, b): (Expr, Expr, Expr)| Equation::new(a / &factor, b / factor);
    let zero = |of: Expr| {
        prop_oneof![
            Just(Equation::new(&of, 0)),
            Just(Equation::new(of.pow(2), 0)),
            Just(Equation::new(sqrt(&of), 0)),
            Just(Equation::new(&of + symbol(3), symbol(3))),
        ]
    };
    prop_oneof![
        2 => (factor(), part(), part()).prop_map(scaled),
        2 => (factor(), part(), part()).prop_map(ahead),
        1 => (factor(), part(), part()).prop_map(below),
        1 => (part(), part(), part(), part()).prop_map(|(a, b, c, d)| Equation::new((a - b) * (c - d), 0)),
        1 => (part(), part()).prop_map(|(a, b)| Equation::new(a, b)),
        2 => factor().prop_flat_map(zero),
    ]
}

/// Every order of `items`.
fn orders<T: Clone>(items: &[T]) -> Vec<Vec<T>> {
    if items.is_empty() {
        return vec![vec![]];
    }
    let with_first = |at: usize| {
        let mut rest = items.to_vec();
        let first = rest.remove(at);
        orders(&rest).into_iter().map(move |rest| [vec![first.clone()], rest].concat())
    };
    (0..items.len()).flat_map(with_first).collect()
}

fn value(expr: &Expr, at: [f64; 4]) -> Option<f64> {
    let mut bindings = Bindings::new();
    NAMES.iter().zip(at).for_each(|(name, value)| bindings.bind(name, value));
    expr.evaluate(&bindings).ok().filter(|value: &f64| value.is_finite())
}

fn holds(equation: &Equation, at: [f64; 4]) -> Option<bool> {
    Some((value(&equation.lhs, at)? - value(&equation.rhs, at)?).abs() < 1e-9)
}

/// The points where every premise holds, nothing that `chain` names vanishes, and what it calls positive is.
fn admitted(chain: &Chain, premises: &[Equation]) -> Vec<[f64; 4]> {
    let grid = (0..256_usize).map(|n| [n, n / 4, n / 16, n / 64].map(|digit| (digit % 4) as f64));
    let (conditions, assumed) = (chain.conditions(), chain.assumed());
    let is_named = |at: usize| assumed.positive.iter().any(|symbol| symbol.name() == NAMES[at]);
    grid.filter(|at| {
        premises.iter().all(|premise| holds(premise, *at) == Some(true))
            && conditions.iter().all(|divisor| value(divisor, *at).is_some_and(|value| value.abs() > 1e-9))
            && (0..4).all(|name| !is_named(name) || at[name] > 0.0)
    })
    .collect()
}

proptest! {
    #![proptest_config(ProptestConfig { rng_seed: RngSeed::Fixed(11), failure_persistence: None, ..ProptestConfig::with_cases(400) })]

    #[test]
    fn nothing_false_is_proved_and_nothing_true_refuted(
        premises in proptest::collection::vec(premise(), 1..4),
        (left, right) in (part(), part()),
    ) {
        let claim = Equation::new(left, right);
        for order in orders(&premises) {
            let chain = order.iter().fold(Chain::default(), |chain, premise| chain.and(premise.clone(), "given"));
            let chain = chain.then(claim.clone(), []);
            let verdict = chain.verify(3, 128, &mut random::stream(5, "premises")).remove(0).verdict;
            let points = admitted(&chain, &order);
            let shown: Vec<_> = order.iter().map(ToString::to_string).collect();
            match verdict {
                Verdict::Proved => {
                    prop_assert!(!points.is_empty(), "{claim} proved from contradictory {shown:?}");
                    let wrong = points.iter().find(|at| holds(&claim, **at) != Some(true));
                    prop_assert!(wrong.is_none(), "{claim} proved from {shown:?}, but not at {wrong:?}");
                }
                Verdict::Refuted { at, .. } => {
                    let is_true = points.iter().all(|at| holds(&claim, *at) == Some(true));
                    prop_assert!(!is_true || points.is_empty(), "{claim} refuted from {shown:?} at {at:?}");
                }
                Verdict::Agrees { .. } | Verdict::Unknown { .. } => {}
            }
        }
    }
}
