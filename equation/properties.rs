//! Properties of every expression, tried on random trees.

use super::derivation::{Chain, Verdict};
use super::dimension::Dimension;
use super::expr::*;
use super::parse::parse;
use super::rational::Rational;
use super::sound;
use super::symbol::{Rank, Symbol};
use super::tracked::Tracked;
use super::value::{Bindings, Unevaluable};
use super::{Equation, Expr};
use num_complex::Complex64;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use std::collections::HashMap;
use yardstick::precise;
use yardstick::random::stream;

const X: Symbol = Symbol::scalar("x", Dimension::ONE);
const Y: Symbol = Symbol::scalar("theta_1'", Dimension::ONE);

const FIELD: Symbol = Symbol::vector("E", Dimension::VOLT_PER_METRE);

fn leaf() -> impl Strategy<Value = Expr> {
    prop_oneof![
        4 => Just(Expr::from(X)),
        4 => Just(Expr::from(Y)),
        2 => (0..4_i32).prop_map(Expr::from),
        1 => Just(ratio(1, 2)),
        1 => Just(ratio(12_345, 10_000)),
        1 => Just(pi()),
        1 => Just(i()),
    ]
}

/// Trees that have a value almost everywhere.
fn algebraic() -> impl Strategy<Value = Expr> {
    leaf().prop_recursive(4, 24, 3, |inner| {
        let pair = || (inner.clone(), inner.clone());
        prop_oneof![
            2 => pair().prop_map(|(a, b)| a + b),
            2 => pair().prop_map(|(a, b)| a - b),
            3 => pair().prop_map(|(a, b)| a * b),
            3 => pair().prop_map(|(a, b)| a / b),
            1 => inner.clone().prop_map(|a| -a),
            1 => (inner.clone(), -2..4_i32).prop_map(|(a, n)| a.pow(n)),
            1 => inner.clone().prop_map(|a| a.pow(Rational::new(3, 2).unwrap())),
            1 => inner.clone().prop_map(sqrt),
            2 => inner.clone().prop_map(sin),
            2 => inner.clone().prop_map(cos),
            1 => inner.clone().prop_map(tan),
            1 => inner.clone().prop_map(exp),
            1 => inner.clone().prop_map(atan),
            1 => inner.clone().prop_map(asin),
            1 => inner.clone().prop_map(conj),
            1 => inner.clone().prop_map(abs),
            1 => inner.clone().prop_map(re),
        ]
    })
}

/// Trees of every kind of node, sensible or not.
pub(super) fn anything() -> impl Strategy<Value = Expr> {
    let field = FIELD;
    let region = Symbol::scalar("Omega", Dimension::ONE);
    let leaves = prop_oneof![leaf(), Just(Expr::from(&field))];
    leaves.prop_recursive(4, 24, 3, move |inner| {
        let pair = || (inner.clone(), inner.clone());
        let (field, region) = (field.clone(), region.clone());
        prop_oneof![
            pair().prop_map(|(a, b)| a + b),
            pair().prop_map(|(a, b)| a - b),
            pair().prop_map(|(a, b)| a * b),
            pair().prop_map(|(a, b)| a / b),
            pair().prop_map(|(a, b)| dot(a, b)),
            pair().prop_map(|(a, b)| cross(a, b)),
            pair().prop_map(|(a, b)| partial(a, b)),
            pair().prop_map(move |(a, b)| field.at([a, b])),
            pair().prop_map(move |(a, b)| integral(a, [b], Range::Region(region.clone()))),
            pair().prop_map(|(a, b)| integral(a, [b], Range::Closed)),
            (inner.clone(), inner.clone(), inner.clone()).prop_map(|(a, b, c)| integral_between(a, X, b, c)),
            inner.clone().prop_map(curl),
            inner.clone().prop_map(divergence),
            inner.clone().prop_map(gradient),
            inner.clone().prop_map(laplacian),
            inner.clone().prop_map(d),
            inner.clone().prop_map(mean),
            inner.clone().prop_map(|a| a.pow(2)),
            inner.clone().prop_map(sin),
            inner.clone().prop_map(exp),
            inner.clone().prop_map(sqrt),
            inner.clone().prop_map(im),
            inner.clone().prop_map(acos),
            inner.clone().prop_map(|a| -a),
        ]
    })
}

fn number() -> impl Strategy<Value = Complex64> {
    (0.3..1.3, -0.4..0.4).prop_map(|(re, im)| Complex64::new(re, im))
}

fn bindings<T>(x: T, y: T) -> Bindings<T> {
    Bindings::with_bits(160).with(&X, x).with(&Y, y)
}

fn tracked(expr: &Expr, x: Complex64, y: Complex64) -> Result<Tracked, Unevaluable> {
    let exact = |z: Complex64| {
        let part = |x| precise::real_at(x, 160);
        Tracked::exact(precise::Complex::from_parts(part(z.re), part(z.im)), 160)
    };
    expr.evaluate(&bindings(exact(x), exact(y)))
}

fn unit() -> impl Strategy<Value = Dimension> {
    let base = [Dimension::METRE, Dimension::SECOND, Dimension::KILOGRAM, Dimension::AMPERE, Dimension::KELVIN];
    proptest::collection::vec((0..base.len(), -3..4_i64, 1..4_i64), 0..4).prop_map(move |powers| {
        powers.iter().fold(Dimension::ONE, |unit, (at, n, d)| {
            unit.times(base[*at].checked_power(Rational::new(*n, *d).unwrap()).unwrap())
        })
    })
}

proptest! {
    #![proptest_config(ProptestConfig { rng_seed: RngSeed::Fixed(36), failure_persistence: None, ..ProptestConfig::with_cases(300) })]

    #[test]
    fn double_precision_stays_within_its_error_bound(expr in algebraic(), x in number(), y in number()) {
        let Ok(exact) = tracked(&expr, x, y) else { return Ok(()) };
        let bound = 32.0 * f64::EPSILON * exact.error;
        // The bound is of first order: it says nothing where rounding moves a value by much.
        prop_assume!(bound < 1e-8);
        let exact = precise::to_complex64(&exact.value);
        let ours = expr.evaluate(&bindings(x, y)).unwrap();
        prop_assert!((ours - exact).norm() <= bound, "{expr}: {ours} against {exact}, bound {bound:e}");
    }

    #[test]
    fn faces_are_well_formed(expr in anything()) {
        let equation = Equation::new(&expr, 0);
        prop_assert_eq!(sound::well_formed(&equation), Ok(()));
        // Units are inferred or refused, never a panic.
        let _ = equation.dimension();
    }

    #[test]
    fn the_one_line_face_is_read_back(expr in algebraic()) {
        prop_assert_eq!(parse(&expr.to_string(), &[X, Y]), Ok(expr.clone()), "{}", expr);
    }

    #[test]
    fn the_one_line_face_is_read_back_with_vectors_and_calculus(tree in anything()) {
        let known = [X, Y, FIELD, Symbol::scalar("Omega", Dimension::ONE)];
        for part in with_parts(&tree).into_iter().filter(|part| is_vector(part).is_some()) {
            prop_assert_eq!(parse(&part.to_string(), &known), Ok(part.clone()), "{}", part);
        }
    }

    #[test]
    fn layouts_are_rectangles(expr in anything()) {
        let block = expr.layout();
        prop_assert!(block.rows().iter().all(|row| row.chars().count() == block.width()), "{block}");
        prop_assert!(block.baseline() < block.rows().len());
        // Without a fraction nothing tells the two faces apart.
        if block.rows().len() == 1 {
            prop_assert_eq!(&block.rows()[0], &expr.to_string());
        }
        let is_flat = |part: &Expr| !matches!(part.node(), Node::Quotient(..) | Node::Partial(..) | Node::Integral(..));
        prop_assert!(block.rows().len() == 1 || !with_parts(&expr).iter().all(is_flat), "{block}");
    }

    #[test]
    fn one_face_means_one_value(trees in proptest::collection::vec(algebraic(), 40), x in number(), y in number()) {
        let mut seen: HashMap<String, Complex64> = HashMap::new();
        for tree in trees.iter().flat_map(with_parts) {
            let Ok(value) = tree.evaluate(&bindings(x, y)) else { continue };
            for face in [tree.to_string(), tree.latex(), tree.mathml()] {
                let known = *seen.entry(face.clone()).or_insert(value);
                let same = (known - value).norm() <= 1e-9 * (1.0 + value.norm()) || !value.is_finite();
                prop_assert!(same, "{face} stands for {known} and {value}");
            }
        }
    }

    #[test]
    fn rearranging_agrees_and_spoiling_is_refuted(a in algebraic(), b in algebraic(), c in algebraic(), x in number(), seed in 0..1000_u64) {
        let products = &a * &c + &b * &c;
        // One millionth of the terms, so that no cancellation between them can hide it.
        let slip = (abs(&a * &c) + abs(&b * &c)) / 1_000_000;
        prop_assume!(tracked(&slip, x, x.conj()).is_ok_and(|slip| slip.is_certain()));
        let chain = Chain::new((&a + &b) * &c).then(&products * 1, ["distribute"]).then(products + slip, ["a slip"]);
        let hops = chain.verify(3, 128, &mut stream(seed, "properties"));
        prop_assert!(!matches!(hops[0].verdict, Verdict::Refuted { .. }), "{a} | {b} | {c}: {:?}", hops[0]);
        prop_assert!(!hops[1].verdict.agrees(), "{a} | {b} | {c}: {:?}", hops[1]);
    }

    #[test]
    fn units_multiply_divide_and_take_powers(a in unit(), b in unit(), n in -3..4_i32) {
        let (p, q) = (Symbol::scalar("p", a), Symbol::scalar("q", b));
        prop_assert_eq!((&p * &q).dimension(), Ok(a.times(b)));
        prop_assert_eq!((&p / &q).dimension(), Ok(a.per(b)));
        prop_assert_eq!(p.pow(n).dimension(), Ok(a.checked_power(n.into()).unwrap()));
        prop_assert_eq!((&p + &q).dimension().is_ok(), a == b);
        prop_assert_eq!(Equation::new(&p, &q).dimension().is_ok(), a == b);
        prop_assert_eq!(a.to_string() == b.to_string(), a == b);
        prop_assert_eq!(q.rank(), Rank::Scalar);
    }
}

/// A tree and everything in it.
fn with_parts(tree: &Expr) -> Vec<Expr> {
    let mut parts = vec![tree.clone()];
    parts.extend(tree.children().into_iter().flat_map(with_parts));
    parts
}

/// Whether an expression is a vector; none where vectors are multiplied like numbers, or numbers like vectors.
fn is_vector(expr: &Expr) -> Option<bool> {
    let below: Option<Vec<bool>> = expr.children().into_iter().map(is_vector).collect();
    let below = below?;
    let vectors = below.iter().filter(|is_vector| **is_vector).count();
    match expr.node() {
        Node::Symbol(symbol) | Node::Apply(symbol, _) => Some(symbol.rank() == Rank::Vector),
        Node::Dot(..) => (vectors == 2).then_some(false),
        Node::Cross(..) => (vectors == 2).then_some(true),
        Node::Product(_) => (vectors < 2).then_some(vectors == 1),
        Node::Nabla(nabla, _) => Some(match nabla {
            Nabla::Gradient | Nabla::Curl => true,
            Nabla::Divergence => false,
            Nabla::Laplacian => below[0],
        }),
        Node::Function(function, _) => {
            Some(matches!(function, Function::Conj | Function::Re | Function::Im) && below[0])
        }
        Node::Vector(_) => Some(true),
        Node::Sum(_) => Some(vectors > 0),
        Node::Number(_) | Node::Pi | Node::ImaginaryUnit => Some(false),
        Node::Quotient(..) | Node::Power(..) | Node::Negate(_) | Node::Partial(..) => Some(below[0]),
        Node::Differential(_) | Node::Mean(_) | Node::Integral(..) => Some(below[0]),
    }
}
