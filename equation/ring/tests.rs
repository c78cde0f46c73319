use super::*;
use crate::Equation;
use crate::dimension::Dimension;
use crate::expr::*;
use crate::rational::Rational;
use crate::symbol::Symbol;

const A: Symbol = Symbol::scalar("a", Dimension::ONE);
const B: Symbol = Symbol::scalar("b", Dimension::ONE);
const C: Symbol = Symbol::scalar("c", Dimension::ONE);
const X: Symbol = Symbol::scalar("x", Dimension::ONE);
const P: Symbol = Symbol::scalar("p", Dimension::ONE).real(0.1, 4.0);
const Q: Symbol = Symbol::scalar("q", Dimension::ONE).real(0.1, 4.0);
/// Nowhere on a branch cut of arcsin.
const U: Symbol = Symbol::scalar("u", Dimension::ONE).within(-0.9, 0.9);
/// Real, of either sign.
const S: Symbol = Symbol::scalar("s", Dimension::ONE).real(-2.0, 2.0);

fn half() -> Expr {
    ratio(1, 2)
}

#[test]
fn identities_of_algebra_trigonometry_and_roots() {
    let identities = [
        ((A + B).pow(3), A.pow(3) + 3 * A.pow(2) * B + 3 * A * B.pow(2) + B.pow(3)),
        (1 / (X - 1) - 1 / (X + 1), 2 / (X.pow(2) - 1)),
        (sin(A).pow(2) - sin(B).pow(2), sin(A + B) * sin(A - B)),
        (sin(3 * A), 3 * sin(A) - 4 * sin(A).pow(3)),
        (tan(A + B), (tan(A) + tan(B)) / (1 - tan(A) * tan(B))),
        (sin(A), 2 * sin(A / 2) * cos(A / 2)),
        (sin(A / 2).pow(2), (1 - cos(A)) / 2),
        (sin(A / 3 + B / 2), sin(A / 3) * cos(B / 2) + cos(A / 3) * sin(B / 2)),
        (sin((A + B) / C), sin(A / C) * cos(B / C) + cos(A / C) * sin(B / C)),
        (sin((A * B + B) / B), sin(A + 1)),
        (cos(pi() / 2 - A), sin(A)),
        (sin(pi() / 3) * sin(pi() / 4), sqrt(Expr::from(6)) / 4),
        (cos(pi() / 12), (sqrt(Expr::from(6)) + sqrt(Expr::from(2))) / 4),
        (sin(7 * pi() / 6), -half()),
        (sin(-11 * pi() / 12), -sin(pi() / 12)),
        (exp(i() * A), cos(A) + i() * sin(A)),
        (exp(i() * pi()), Expr::from(-1)),
        (exp(A + B) / exp(B), exp(A)),
        (exp(-A / 2).pow(2), exp(-A)),
        (cos(i() * A), (exp(A) + exp(-A)) / 2),
        (sin(i() * A) / i(), (exp(A) - exp(-A)) / 2),
        (sqrt(A).pow(2), A.into()),
        (sqrt(1 / (A - B)).pow(2), 1 / (A - B)),
        (sqrt(P * Q.pow(2)), Q * sqrt(P)),
        (sqrt(12 * P.pow(3)), 2 * P * sqrt(3 * P)),
        (sqrt(P / Q), sqrt(P * Q) / Q),
        (sqrt(-P), i() * sqrt(P)),
        (P.pow(Rational::new(3, 2).unwrap()), P * sqrt(P)),
        (P.pow(Rational::new(-1, 3).unwrap()).pow(3), 1 / P),
        (sqrt(Expr::from(8)) * sqrt(Expr::from(2)), Expr::from(4)),
        (1 / (sqrt(P) - sqrt(Q)), (sqrt(P) + sqrt(Q)) / (P - Q)),
        (sin(asin(X)), X.into()),
        (sin(2 * atan(P)), 2 * P / (1 + P.pow(2))),
        (sin(asin(A * sin(X) / B)), A * sin(X) / B),
        (cos(2 * asin(A / B)), 1 - 2 * (A / B).pow(2)),
        (cos(asin(U)), sqrt(1 - U.pow(2))),
        (cos(acos(X) + asin(X)), Expr::from(0)),
        (1 / i(), -i()),
        (abs(P * i()), P.into()),
        (abs(S).pow(2), S.pow(2)),
        (abs(exp(i() * P)), Expr::from(1)),
        (abs(A).pow(2), A * conj(A)),
        (conj(exp(i() * A)), exp(-i() * conj(A))),
        (re(A * conj(B)), re(A) * re(B) + im(A) * im(B)),
        (((P - i() * Q) / (P + i() * Q)) * conj((P - i() * Q) / (P + i() * Q)), Expr::from(1)),
    ];
    for (left, right) in &identities {
        assert_eq!(equal(left, right), Ok(true), "{left} = {right}");
        assert_eq!(equal(left, &(right + half() * X / 1000)), Ok(false), "{left} is not {right} + x/2000");
        let form = normal_form(left).unwrap();
        assert_eq!(equal(&form, left), Ok(true), "{form} = {left}");
    }
}

/// Equations that hold on one side of a branch cut only, or nowhere.
#[test]
fn says_nothing_untrue_about_branches() {
    let differ = [
        (sqrt(S.pow(2)), S.into()),
        (sqrt(A * B * C * X), sqrt(A) * sqrt(B) * sqrt(C) * sqrt(X)),
        (sqrt((S - 1).pow(2)), S - 1),
        (sqrt(1 / (S - 1)), sqrt(S - 1) / (S - 1)),
        (sqrt(S * (S - 1)), sqrt(S) * sqrt(S - 1)),
        (conj(sqrt(S)), sqrt(S)),
        (abs(S), S.into()),
        (abs(A), A.into()),
        (conj(A), A.into()),
        (asin(sin(S)), S.into()),
        (cos(asin(2 * P)), sqrt(1 - 4 * P.pow(2))),
        (sin(atan(A)), A / sqrt(1 + A.pow(2))),
        (S.pow(3).pow(Rational::new(1, 3).unwrap()), S.into()),
        (exp(i() * A) * conj(exp(i() * A)), Expr::from(1)),
    ];
    for (left, right) in differ {
        assert_eq!(equal(&left, &right), Ok(false), "{left} = {right}");
    }
    // Two roots of bounded phase: here the product rule holds.
    assert_eq!(equal(&sqrt(A * B), &(sqrt(A) * sqrt(B))), Ok(true));
}

#[test]
fn refuses_what_is_too_large_or_undefined() {
    let grown = (0..200).fold(A + 1, |sum, n| sum * (X + n));
    assert!(matches!(equal(&grown.pow(300), &A.into()), Err(Undecided::TooLarge)));
    assert!(matches!(equal(&(X + 1).pow(1_000_000_000), &A.into()), Err(Undecided::TooLarge)));
    assert!(matches!(equal(&Expr::from(2).pow(1_000_000_000), &A.into()), Err(Undecided::TooLarge)));
    assert_eq!(equal(&X.pow(1_000_000_000), &(X.pow(999_999_999) * X)), Ok(true));
    let deep = (0..2000).fold(Expr::from(X), |of, _| sin(of));
    assert_eq!(equal(&deep, &sin(&deep)), Err(Undecided::TooLarge));
    let zero = sin(X).pow(2) + cos(X).pow(2) - 1;
    assert!(matches!(equal(&(X / zero), &X.into()), Err(Undecided::ZeroDenominator(_))));
    assert!(matches!(equal(&curl(Symbol::vector("E", Dimension::ONE)), &X.into()), Err(Undecided::NotAlgebraic(_))));
}

/// Too large a multiple to be expanded is still what it is.
#[test]
fn knows_sines_of_large_multiples_by_themselves() {
    let n = 1_000_000_007;
    let identities = [
        (sin(n * X), sin(X * n)),
        (sin(-n * X), -sin(n * X)),
        (cos(n * X + A), cos(n * X) * cos(A) - sin(n * X) * sin(A)),
        (sin(n * X).pow(2), 1 - cos(n * X).pow(2)),
        (conj(sin(n * P)), sin(n * P)),
        (exp(i() * n * X), cos(n * X) + i() * sin(n * X)),
    ];
    for (left, right) in identities {
        assert_eq!(equal(&left, &right), Ok(true), "{left} = {right}");
    }
    for other in [sin((n + 1) * X), cos(n * X), -sin(n * X), sin(n * A), sin(n * X / 2)] {
        assert_eq!(equal(&sin(n * X), &other), Ok(false), "{other}");
    }
}

/// Squares come out of a square root where the sign is known, as moduli where only that they are real is.
#[test]
fn takes_squares_out_of_roots() {
    const R: Symbol = Symbol::scalar("r", Dimension::ONE).real(-2.0, 2.0);
    let identities = [
        (sqrt((P + Q).pow(2)), P + Q),
        (sqrt(2 * P.pow(2) + 4 * P * Q + 2 * Q.pow(2)), sqrt(2) * (P + Q)),
        (sqrt((P + Q).pow(2) * S), (P + Q) * sqrt(S)),
        (sqrt(S / (P + Q).pow(2)), sqrt(S) / (P + Q)),
        (sqrt(A / (P + Q) / (P + Q)), sqrt(A) / (P + Q)),
        (sqrt((3 * P.pow(2) + P * Q + Q / 5).pow(2)), 3 * P.pow(2) + P * Q + Q / 5),
        (sqrt(exp(2 * P)), exp(P)),
        (sqrt(exp(S)), exp(S / 2)),
        (sqrt(exp(-2 * S) * A), exp(-S) * sqrt(A)),
        (sqrt(S.pow(2)), abs(S)),
        (abs(S) * abs(R), abs(S * R)),
        (abs(S / R), abs(S) / abs(R)),
        (abs(S).pow(3), abs(S.pow(3))),
        (sqrt(S.pow(3)), abs(S) * sqrt(S)),
        (abs(-S), abs(S)),
        (abs(P * S), P * abs(S)),
        (sqrt(1 / S.pow(2)), 1 / abs(S)),
    ];
    for (left, right) in identities {
        assert_eq!(equal(&left, &right), Ok(true), "{left} = {right}");
    }
    let differ = [
        (sqrt((P - Q).pow(2)), P - Q),
        (sqrt((P - Q).pow(2)), Q - P),
        (sqrt((P + S).pow(2)), P + S),
        (sqrt((P + Q).pow(2) + Q.pow(2)), P + Q),
        (sqrt(P.pow(2) + P * Q + Q.pow(2)), P + Q),
        (sqrt(exp(2 * A)), exp(A)),
        (sqrt(A.pow(2) / S.pow(2)), A / S),
        (sqrt(S * R), sqrt(S) * sqrt(R)),
        (sqrt(cos(S).pow(2)), cos(S)),
    ];
    for (left, right) in differ {
        assert_eq!(equal(&left, &right), Ok(false), "{left} is not {right}");
    }
}

#[test]
fn tells_the_factors_of_a_product() {
    let faces = |equation: Equation| {
        let mut faces: Vec<_> = factors(&equation).unwrap().iter().map(Expr::to_string).collect();
        faces.sort();
        faces
    };
    assert_eq!(faces(Equation::new((A - 1) * (B - 2), 0)), ["a − 1", "b − 2"]);
    assert_eq!(faces(Equation::new((A - 1) * (A - 2) / C, 0)), ["a − 1", "a − 2"]);
    assert_eq!(faces(Equation::new(sin(A) * B, sin(A) * C)), ["b − c", "sin a"]);
    assert_eq!(faces(Equation::new(S * A, S * B)), ["a − b", "s"]);
    assert_eq!(faces(Equation::new(A * B + 2, 2 * A + B)), ["a − 1", "b − 2"]);
    // Neither a number, nor what is never zero.
    assert_eq!(faces(Equation::new(3 * P * (A - B) * exp(C), 0)), ["a − b"]);
    assert_eq!(faces(Equation::new(sin(1) * A, sin(1) * B)), ["a − b"]);
}

#[test]
fn solves_the_boundary_conditions_in_textbook_form() {
    const N_1: Symbol = Symbol::scalar("n_1", Dimension::ONE);
    const N_2: Symbol = Symbol::scalar("n_2", Dimension::ONE);
    const T_1: Symbol = Symbol::scalar("theta_1", Dimension::ONE);
    const T_2: Symbol = Symbol::scalar("theta_2", Dimension::ONE);
    const Z: Symbol = Symbol::scalar("Z_0", Dimension::OHM);
    let [e_1, e_r, e_2] = ["E_1", "E_1'", "E_2"].map(|name| Symbol::scalar(name, Dimension::VOLT_PER_METRE));
    let first = (&e_1 + &e_r, Expr::from(&e_2));
    let second = ((N_1 * &e_1 / Z - N_1 * &e_r / Z) * cos(T_1), N_2 * &e_2 / Z * cos(T_2));
    let solution = solve(&[first.clone(), second], &[e_r.clone(), e_2.clone()]).unwrap();
    let found: Vec<_> = solution.values.iter().map(|(_, value)| value).collect();
    assert!(
        solution.divisors.iter().any(|divisor| divisor.to_string().contains("n₁ cos θ₁ + n₂ cos θ₂")),
        "{solution:?}"
    );
    assert_eq!(found[0].to_string(), "E₁ (n₁ cos θ₁ − n₂ cos θ₂)/(n₁ cos θ₁ + n₂ cos θ₂)");
    assert_eq!(found[1].to_string(), "2 E₁ n₁ cos θ₁/(n₁ cos θ₁ + n₂ cos θ₂)");
    assert_eq!(solve(&[first.clone(), first.clone()], &[e_r.clone(), e_2.clone()]), Err(Unsolvable::Dependent));
    let square = (e_r.pow(2), Expr::from(&e_2));
    assert!(matches!(solve(&[square, first], &[e_r, e_2]), Err(Unsolvable::NotLinear(_))));
}

#[test]
fn takes_one_equation_from_another() {
    let condition = |from: &Equation, to: Equation| follows(from, &to).unwrap().map(|divisor| divisor.to_string());
    let from = Equation::new(A * sin(X), B * cos(X));
    assert_eq!(condition(&from, Equation::new(tan(X), B / A)).as_deref(), Some("sin x"));
    assert_eq!(condition(&from, Equation::new(tan(X), A / B)), None);
    let circle = Equation::new(A.pow(2) + B.pow(2), C.pow(2));
    assert_eq!(condition(&circle, Equation::new((C - B) * (C + B), A.pow(2))).as_deref(), Some("1"));
    assert_eq!(condition(&circle, Equation::new(A, C - B)), None);
    assert_eq!(condition(&Equation::new(X, X), Equation::new(A, B)), None);
}

#[test]
fn turns_an_equation_into_a_hypothesis() {
    let oriented = |equation: Equation| {
        let solution = orient(&equation)?;
        let value = solution.values.iter().map(|(symbol, value)| Equation::new(symbol, value).to_string());
        let divisors = solution.divisors.iter().map(Expr::to_string).filter(|face| face != "1");
        Ok(value.chain(divisors).collect::<Vec<_>>().join("; "))
    };
    assert_eq!(oriented(Equation::new(A * sin(X), B * sin(C))).unwrap(), "a = b sin c/sin x; sin x");
    assert_eq!(oriented(Equation::new(sin(X) + P.pow(2), Q.pow(2))).unwrap(), "p = √(q² − sin x)");
    // A factor of all terms that is never zero is divided out, not set to zero; of others either may be zero.
    assert_eq!(oriented(Equation::new(A * B, A * C)).unwrap(), "b = c; a");
    let products = [
        Equation::new(sin(X) * B, 3 * C * sin(X)),
        Equation::new((A + B) * C, (A + B) * X),
        Equation::new((A - 1) * (B - 2), 0),
        Equation::new((sin(A) - sin(B)) * C, (sin(A) - sin(B)) * X),
    ];
    for product in products {
        assert!(matches!(oriented(product.clone()), Err(Unsolvable::NoSymbol(_))), "{product}");
    }
    let branch = Equation::new((A - 1) * (B - 2), 0);
    assert_eq!(follows(&branch, &Equation::new(A, 1)), Ok(None));
    assert_eq!(oriented(Equation::new(P * S, 0)).unwrap(), "s = 0; p");
    // A root is zero with what it is the root of.
    assert_eq!(oriented(Equation::new(P * sqrt(A - B), 0)).unwrap(), "a = b; p");
    assert_eq!(oriented(Equation::new(A + B, B + A)).unwrap(), "");
    // Either sign would do.
    assert!(matches!(oriented(Equation::new(S.pow(2), 1)), Err(Unsolvable::NoSymbol(_))));
    assert!(matches!(oriented(Equation::new(S * U, 0)), Err(Unsolvable::NoSymbol(_))));
    assert!(matches!(oriented(Equation::new(sin(X), cos(X))), Err(Unsolvable::NoSymbol(_))));
    assert!(matches!(oriented(Equation::new(A + 1, A)), Err(Unsolvable::Contradiction(_))));
    assert!(matches!(oriented(Equation::new(P * exp(X), 0)), Err(Unsolvable::Contradiction(_))));
}
