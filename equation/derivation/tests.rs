use super::*;
use crate::Equation;
use crate::dimension::Dimension;
use crate::expr::{Expr, abs, asin, conj, cos, exp, i, mean, pi, re, sin, sqrt, tan};
use crate::symbol::Symbol;
use yardstick::random;

const THETA_1: Symbol = Symbol::scalar("theta_1", Dimension::ONE).within(0.1, 1.4);
const THETA_2: Symbol = Symbol::scalar("theta_2", Dimension::ONE).within(0.1, 1.4);
const N_1: Symbol = Symbol::scalar("n_1", Dimension::ONE);
const N_2: Symbol = Symbol::scalar("n_2", Dimension::ONE);
const K: Symbol = Symbol::scalar("k", Dimension::ONE).within(0.5, 2.0);
const Z_0: Symbol = Symbol::scalar("Z_0", Dimension::OHM).within(100.0, 400.0);
const E_1: Symbol = Symbol::scalar("E_1", Dimension::VOLT_PER_METRE);
const E_R: Symbol = Symbol::scalar("E_1'", Dimension::VOLT_PER_METRE);
const E_2: Symbol = Symbol::scalar("E_2", Dimension::VOLT_PER_METRE);
const X: Symbol = Symbol::scalar("x", Dimension::ONE);
const P: Symbol = Symbol::scalar("p", Dimension::ONE).real(0.1, 4.0);
const Q: Symbol = Symbol::scalar("q", Dimension::ONE).real(0.1, 4.0);

fn judge(chain: &Chain) -> Vec<Verdict> {
    let mut stream = random::stream(7, "equation/derivation");
    chain.verify(6, 160, &mut stream).into_iter().map(|hop| hop.verdict).collect()
}

fn snell(chain: Chain) -> Chain {
    chain.given(N_1, K * sin(THETA_2), "Snell").given(N_2, K * sin(THETA_1), "Snell")
}

fn sine_of_difference() -> Expr {
    sin(THETA_1 - THETA_2)
}

fn sine_of_sum() -> Expr {
    sin(THETA_1 + THETA_2)
}

/// E35 to E36: the boundary conditions solved for the fields, and their ratio in the lecture's form.
fn r_s() -> Chain {
    let (c_1, c_2) = (|| cos(THETA_1), || cos(THETA_2));
    let current = Equation::new((N_1 * E_1 / Z_0 - N_1 * E_R / Z_0) * c_1(), N_2 * E_2 / Z_0 * c_2());
    let chain = Chain::assume(Equation::new(E_1 + E_R, E_2), "E is continuous").and(current, "H is continuous");
    snell(chain)
        .solve_for([E_R, E_2])
        .then(Equation::new(E_R / E_1, (N_1 * c_1() - N_2 * c_2()) / (N_1 * c_1() + N_2 * c_2())), ["linear solve"])
        .then(
            (sin(THETA_2) * c_1() - sin(THETA_1) * c_2()) / (sin(THETA_2) * c_1() + sin(THETA_1) * c_2()),
            ["Snell", "cancel k"],
        )
        .then(-sine_of_difference() / sine_of_sum(), ["sine of a sum"])
        .because("the sum and the difference of the same two products")
}

#[test]
fn follows_r_s_from_the_boundary_conditions() {
    assert_eq!(judge(&r_s()), [const { Verdict::Proved }; 3]);
    assert_eq!(r_s().units(), Ok(()));
    assert_eq!(r_s().lines.last().unwrap().says, "the sum and the difference of the same two products");
}

#[test]
fn compares_what_the_normal_form_leaves_open() {
    let nested = sqrt(3 + 2 * sqrt(Expr::from(2))) * X;
    let verdicts = judge(&Chain::new(nested).then((1 + sqrt(Expr::from(2))) * X, ["nested root"]));
    let [Verdict::Agrees { points: 6, skipped: 0, digits }] = verdicts.as_slice() else { panic!("{verdicts:?}") };
    assert!((46.0..48.2).contains(digits), "{digits}");
}

/// A premise fixes one of its symbols; what follows from it alone is proved, and nothing else is.
#[test]
fn takes_lines_from_premises() {
    let snell = || Chain::assume(Equation::new(N_1 * sin(THETA_1), N_2 * sin(THETA_2)), "Snell");
    let from = |chain: Chain, claim: Equation| judge(&chain.then(claim, []));
    assert_eq!(from(snell(), Equation::new(sin(THETA_1) / sin(THETA_2), N_2 / N_1)), [Verdict::Proved]);
    let slip = from(snell(), Equation::new(N_1 * cos(THETA_1), N_2 * cos(THETA_2)));
    assert!(matches!(slip[..], [Verdict::Refuted { .. }]), "{slip:?}");
    // No symbol can be taken from it, but what is left of a multiple of it is nothing.
    let cubic = || Chain::assume(Equation::new(X.pow(3) + X, K.pow(2) + K), "");
    let double = Equation::new(2 * X * (X.pow(2) + 1), 2 * K * (K + 1));
    assert_eq!(from(cubic(), double), [Verdict::Proved]);
    // A premise that all terms share a factor of says nothing about the factor.
    let scaled = |right: i32| Chain::assume(Equation::new(K * N_1, right * K * N_2), "");
    assert_eq!(from(scaled(1), Equation::new(N_1, N_2)), [Verdict::Proved]);
    assert!(matches!(from(scaled(3), Equation::new(N_1, N_2))[..], [Verdict::Refuted { .. }]));
    // Either factor may be zero: neither is shown to be, and where the other one is, it is seen not to be.
    let product = || Chain::assume(Equation::new((X - K) * (X - N_1), 0), "");
    for factor in [X - K, X - N_1] {
        assert!(matches!(from(product(), Equation::new(factor, 0))[..], [Verdict::Refuted { .. }]));
    }
    assert_eq!(from(product(), Equation::new(X.pow(2) + K * N_1, X * (K + N_1))), [Verdict::Proved]);
    // No point satisfies this one by itself: what does not follow from it is not refuted either.
    let open = || Chain::assume(Equation::new(sin(X), sin(K)), "");
    assert!(matches!(from(open(), Equation::new(sin(X).pow(2), sin(K).pow(2)))[..], [Verdict::Unknown { .. }]));
    let other = from(open(), Equation::new(X, K));
    assert!(matches!(other[..], [Verdict::Refuted { .. } | Verdict::Unknown { .. }]), "{other:?}");
    // A positive quantity is the positive root.
    let square = Chain::assume(Equation::new(N_1.pow(2), N_2.pow(2)), "");
    assert_eq!(from(square, Equation::new(N_1, N_2)), [Verdict::Proved]);
    // Nor need it be one, if the premise says otherwise.
    let negative = || Chain::assume(Equation::new(N_1 + 2, 1), "");
    assert_eq!(from(negative(), Equation::new(N_1 + 1, 0)), [Verdict::Proved]);
    assert!(matches!(from(negative(), Equation::new(sqrt(N_1.pow(2)), N_1))[..], [Verdict::Refuted { .. }]));
    // Zero, but no normal form says so; and zero by the premise that comes after. Neither may be divided by.
    let hidden = || sqrt(3 + 2 * sqrt(Expr::from(2))) - 1 - sqrt(Expr::from(2));
    for divisor in [hidden(), N_1 - N_2] {
        let equal = Equation::new(N_1, N_2);
        let linear = Chain::assume(Equation::new(&divisor * X, &divisor * K), "").and(equal.clone(), "");
        let verdict = from(linear, Equation::new(X, K));
        assert!(!verdict[0].agrees(), "{divisor}: {verdict:?}");
        let cubics = Equation::new(&divisor * (X.pow(3) + X), &divisor * (K.pow(3) + K));
        let open = Chain::assume(cubics, "").and(equal, "");
        let verdict = from(open, Equation::new(X.pow(3) + X, K.pow(3) + K));
        assert!(!verdict[0].agrees(), "{divisor}: {verdict:?}");
    }
    let over_zero = Equation::new((X.pow(3) + X - K.pow(2) - K) / hidden(), 0);
    assert!(matches!(from(cubic(), over_zero)[..], [Verdict::Unknown { .. }]));
    // No positive quantity has this square.
    let imaginary = |sign: i32| {
        let square = Chain::assume(Equation::new(P.pow(2) + Q.pow(2), 0), "");
        from(square, Equation::new(P, sign * i() * Q))
    };
    for sign in [1, -1] {
        assert!(matches!(imaginary(sign)[..], [Verdict::Unknown { .. }]), "{sign}");
    }
    let never = Chain::assume(Equation::new(X, X + 1), "");
    assert!(matches!(from(never, Equation::new(X, 0))[..], [Verdict::Unknown { .. }]));
}

/// Positive names as `lesson prove` has them.
const NAMES: [Symbol; 5] = [name("a"), name("b"), name("c"), name("x"), name("y")];

const fn name(name: &'static str) -> Symbol {
    Symbol::scalar(name, Dimension::ONE).real(0.1, 4.0)
}

/// What is said of a claim, in whatever order its premises stand.
fn under(premises: &[Equation], claim: &Equation) -> Verdict {
    let said = |premises: &mut dyn Iterator<Item = &Equation>| {
        let chain = premises.fold(Chain::default(), |chain, premise| chain.and(premise.clone(), ""));
        judge(&chain.then(claim.clone(), [])).remove(0)
    };
    let (verdict, reversed) = (said(&mut premises.iter()), said(&mut premises.iter().rev()));
    let kind = std::mem::discriminant::<Verdict>;
    assert_eq!(kind(&verdict), kind(&reversed), "{claim}: {verdict:?}, {reversed:?}");
    verdict
}

/// A factor that is divided out is positive by its domain alone; another premise may make it zero.
#[test]
fn what_was_divided_out_must_not_vanish() {
    let [a, b, c, x, y] = &NAMES;
    let equal = Equation::new(x, y);
    let (product, over) = (Equation::new(x * a, y * a), Equation::new(x / a, y / a));
    assert_eq!(under(std::slice::from_ref(&product), &equal), Verdict::Proved);
    let zeros = [Equation::new(a, 0), Equation::new(a.pow(2), 0), Equation::new(sqrt(a), 0), Equation::new(a + b, b)];
    for zero in zeros {
        let verdict = under(&[product.clone(), zero.clone()], &equal);
        assert!(matches!(verdict, Verdict::Refuted { .. }), "{zero}: {verdict:?}");
        let verdict = under(&[over.clone(), zero.clone()], &equal);
        assert!(matches!(verdict, Verdict::Unknown { .. }), "{zero}: {verdict:?}");
    }
    // Zero at two removes, and what must not be divided by on the way there.
    let chain = [product.clone(), Equation::new(a * b, b), Equation::new(a, c), Equation::new(c + b, b)];
    assert!(matches!(under(&chain, &equal), Verdict::Refuted { .. }));
    // Zero, but no normal form says so.
    let hidden = sqrt(3 + 2 * sqrt(Expr::from(2))) - 1 - sqrt(Expr::from(2));
    for premise in [&product, &over] {
        let verdict = under(&[premise.clone(), Equation::new(a, &hidden)], &equal);
        assert!(matches!(verdict, Verdict::Unknown { .. }), "{premise}: {verdict:?}");
    }
}

/// Premises that no symbol can be taken from are satisfied at a point before anything is proved from them.
#[test]
fn premises_that_may_contradict_one_another_prove_nothing() {
    let [a, b, c, x, y] = &NAMES;
    let product = Equation::new(x * a, y * a);
    let is_unknown = |premises: &[Equation], claim: Equation| {
        let verdict = under(premises, &claim);
        assert!(matches!(verdict, Verdict::Unknown { .. }), "{claim}: {verdict:?}");
    };
    // Zero or complex; negative; nothing at all.
    is_unknown(&[product.clone(), Equation::new(exp(a), 1)], Equation::new(x, y));
    is_unknown(&[product.clone(), Equation::new(exp(a), crate::expr::ratio(1, 2))], Equation::new(x, y));
    is_unknown(&[Equation::new(sqrt(a), -1)], Equation::new(x, x));
    assert_eq!(under(&[product, Equation::new(exp(a), 2)], &Equation::new(x, y)), Verdict::Proved);
    // At π the sine vanishes that was divided by.
    let over_sine = Equation::new(b * sin(a), c);
    is_unknown(&[over_sine.clone(), Equation::new(cos(a), -1)], Equation::new(b, c / sin(a)));
    assert_eq!(under(&[over_sine, Equation::new(cos(a), 0)], &Equation::new(b, c / sin(a))), Verdict::Proved);
}

#[test]
fn every_factor_of_a_product_is_a_case() {
    let [_, _, _, x, y] = &NAMES;
    let product = [Equation::new((x - 1) * (y - 2), 0)];
    assert_eq!(under(&product, &Equation::new(sin(x * y + 2), sin(2 * x + y))), Verdict::Proved);
    for (name, value) in [(x, 1), (y, 2)] {
        assert!(matches!(under(&product, &Equation::new(name, value)), Verdict::Refuted { .. }));
    }
    // What is called positive is so in a case that counts, if there is one.
    assert_eq!(under(&[Equation::new((x + 1) * (y - 2), 0)], &Equation::new(sin(y), sin(2))), Verdict::Proved);
    // Nor does a case count that another premise contradicts.
    let elsewhere = Equation::new(x, 3);
    assert_eq!(under(&[product[0].clone(), elsewhere], &Equation::new(sin(y), sin(2))), Verdict::Proved);
}

/// On a branch cut the side is told by a part that is zero; rounding noise in it must not decide.
#[test]
fn does_not_take_noise_for_the_side_of_a_cut() {
    let hidden = sqrt(3 + 2 * sqrt(Expr::from(2))) - 1 - sqrt(Expr::from(2));
    let pairs = [
        (sqrt(exp(3 * i() * pi() / 5).pow(5)), i()),
        (sqrt(i() * &hidden * P - P.pow(2)), i() * P),
        (asin(P + 2 - i() * &hidden), asin(P + 2)),
    ];
    for (left, right) in pairs {
        let verdict = judge(&Chain::new(left.clone()).then(right, [])).remove(0);
        assert!(!matches!(verdict, Verdict::Refuted { .. }), "{left}: {verdict:?}");
    }
}

#[test]
fn knows_the_principal_roots_of_negative_numbers() {
    let cube_root = Expr::from(-8).pow(crate::rational::Rational::new(1, 3).unwrap());
    let verdict = judge(&Chain::new(cube_root).then(1 + i() * sqrt(Expr::from(3)), [])).remove(0);
    assert!(matches!(verdict, Verdict::Agrees { digits, .. } if digits > 45.0), "{verdict:?}");
}

/// Values of a function at different arguments are independent, at equal ones the same.
#[test]
fn knows_functions_by_their_arguments() {
    const F: Symbol = Symbol::scalar("f", Dimension::ONE);
    let judged = |left: Expr, right: Expr| judge(&Chain::new(left).then(right, [])).remove(0);
    assert_eq!(judged(F.at([X * (X + 1)]), F.at([X.pow(2) + X])), Verdict::Proved);
    assert!(matches!(judged(F.at([X.into()]), F.at([2 * X])), Verdict::Refuted { .. }));
    // These arguments are equal, but no normal form says so: no verdict rather than a wrong one.
    let nested = sqrt(3 + 2 * sqrt(Expr::from(2)));
    assert!(matches!(judged(F.at([nested]), F.at([1 + sqrt(Expr::from(2))])), Verdict::Unknown { .. }));
}

#[test]
fn refuses_a_slipped_sign_and_says_where() {
    let r_p = |sign: i32| {
        let start = (N_2 * cos(THETA_1) - N_1 * cos(THETA_2)) / (N_2 * cos(THETA_1) + N_1 * cos(THETA_2));
        snell(Chain::new(start))
            .then(sign * tan(THETA_1 - THETA_2) / tan(THETA_1 + THETA_2), ["sines of double angles"])
    };
    assert!(judge(&r_p(1))[0].agrees());
    let verdicts = judge(&r_p(-1));
    let [Verdict::Refuted { at, digits }] = verdicts.as_slice() else { panic!("{verdicts:?}") };
    assert!(digits.abs() < 2.0, "{digits}");
    let names: Vec<_> = at.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["k", "θ₁", "θ₂"]);
    let angle: f64 = at[1].1.parse().expect("the first point is real");
    assert!((0.1..=1.4).contains(&angle));
}

#[test]
fn the_witness_refutes_in_plain_f64_too() {
    let chain = Chain::new(sin(X).pow(2)).then(1 - cos(X), ["a slip"]);
    let verdicts = judge(&chain);
    let [Verdict::Refuted { at, .. }] = verdicts.as_slice() else { panic!("{verdicts:?}") };
    let x: f64 = at[0].1.parse().unwrap();
    assert!((x.sin().powi(2) - (1.0 - x.cos())).abs() > 1e-3);
}

#[test]
fn sees_differences_far_below_f64() {
    let tiny = Expr::number(crate::rational::Rational::new(1, 1_000_000_000_000_000_000).unwrap());
    let verdicts = judge(&Chain::new(sin(X)).then(sin(X) + tiny.pow(2), ["a slip"]));
    let [Verdict::Refuted { digits, .. }] = verdicts.as_slice() else { panic!("{verdicts:?}") };
    assert!((35.0..38.0).contains(digits), "{digits}");
}

#[test]
fn judges_an_exact_zero_by_the_size_of_its_terms() {
    let zero = sin(X).pow(2) + cos(X).pow(2) - 1;
    assert!(judge(&Chain::new(Equation::new(&zero, 0)))[0].agrees());
    assert!(judge(&Chain::new(Equation::new(X * &zero / 7 + X, X)))[0].agrees());
    let verdicts = judge(&Chain::new(Equation::new(X / zero, X)));
    let [Verdict::Unknown { why }] = verdicts.as_slice() else { panic!("{verdicts:?}") };
    assert_eq!(why, "x/(sin² x + cos² x − 1) has no finite value at any of 48 points");
}

#[test]
fn looks_off_the_real_axis_unless_told_not_to() {
    let real = X.real(0.2, 1.3);
    let squared = |x: Symbol| Chain::new(abs(&x).pow(2)).then(x.pow(2), ["real"]);
    assert!(judge(&squared(real.clone()))[0].agrees());
    assert!(matches!(judge(&squared(X))[0], Verdict::Refuted { .. }));
    assert!(judge(&Chain::new(abs(X).pow(2)).then(X * conj(X), []))[0].agrees());
    // A metal: Im n > 0 throughout.
    let n = Symbol::scalar("n", Dimension::ONE).complex((0.1, 3.0), (0.5, 8.0));
    assert!(judge(&Chain::new(re(&n * i())).then(-crate::expr::im(n), []))[0].agrees());
}

#[test]
fn says_what_must_not_vanish() {
    let chain = r_s();
    let faces: Vec<_> = chain.conditions().iter().map(Expr::to_string).collect();
    assert_eq!(faces, ["n₁ cos θ₁ + n₂ cos θ₂", "sin(θ₁ + θ₂)"]);
    assert_eq!(Chain::new(1 / (X * K * 2)).then(X.pow(-1) / exp(X), []).conditions(), []);
}

#[test]
fn admits_what_it_cannot_judge() {
    let verdicts = judge(&Chain::new(mean(X)).then(X + 0, ["no average is known"]));
    assert!(matches!(verdicts[..], [Verdict::Unknown { .. }]), "{verdicts:?}");
    let circle = Chain::new(Expr::from(X)).given(X, X + 1, "nonsense").then(X + 0, []);
    assert_eq!(judge(&circle), [Verdict::Unknown { why: "x is given by itself".into() }]);
}

#[test]
fn the_same_stream_gives_the_same_hops() {
    assert_eq!(judge(&r_s()), judge(&r_s()));
}
