use super::precision::sinh_cosh;
use super::*;
use crate::dimension::Dimension;
use crate::expr::{acos, asin, atan, conj, cos, exp, i, im, partial, pi, re, sin, sqrt, tan};
use crate::rational::Rational;
use num_complex::Complex64;
use yardstick::precise::Complex;

const X: Symbol = Symbol::scalar("x", Dimension::ONE);
const Y: Symbol = Symbol::scalar("y", Dimension::ONE);

fn at<T>(x: T) -> Bindings<T> {
    Bindings::new().with(&X, x)
}

fn is_close(a: Complex64, b: Complex64) -> bool {
    (a - b).norm() <= 4.0 * f64::EPSILON * (1.0 + b.norm())
}

#[test]
fn evaluates_alike_in_every_field() {
    let forms = [
        sin(X) * 2 / (1 + X),
        cos(X).pow(2) - tan(X),
        sqrt(1 + X) + exp(X) * pi(),
        asin(X) + acos(X / 2) * atan(3 * X),
        X.pow(Rational::new(2, 3).unwrap()) + X.pow(-2),
    ];
    for form in forms {
        let real = form.evaluate(&at(0.625)).unwrap();
        let complex = form.evaluate(&at(Complex64::new(0.625, 0.0))).unwrap();
        let exact = form.evaluate(&at(precise::complex(Complex64::new(0.625, 0.0)))).unwrap();
        assert!(is_close(complex, real.into()), "{form}");
        assert!(is_close(precise::to_complex64(&exact), real.into()), "{form}");
        let z = Complex64::new(0.4, -0.3);
        let exact = form.evaluate(&at(precise::complex(z))).unwrap();
        assert!(is_close(form.evaluate(&at(z)).unwrap(), precise::to_complex64(&exact)), "{form}");
    }
}

#[test]
fn agrees_with_the_complex_functions_of_the_library() {
    let z = precise::complex(Complex64::new(0.7, 1.9));
    let (sin, cos) = Field::sine_cosine(&z).unwrap();
    let exponential = z.apply(Function::Exp).unwrap();
    for (ours, theirs) in [(sin, z.sin()), (cos, z.cos()), (exponential, z.exp())] {
        assert!(precise::to_f64(&(ours - theirs).abs()) < 1e-75);
    }
    let (sinh, _) = sinh_cosh(&precise::real(3e-16)).unwrap();
    assert!(precise::relative_error(precise::to_f64(&sinh), &precise::real(3e-16).sinh()) < f64::EPSILON);
}

#[test]
fn takes_the_real_path_and_the_upper_side_of_the_cut() {
    let minus_two = Complex64::new(-2.0, 0.0);
    let root = sqrt(X).evaluate(&at(precise::complex(minus_two))).unwrap();
    assert!(is_close(precise::to_complex64(&root), Complex64::new(0.0, 2_f64.sqrt())));
    // −(2 + 0i) has the imaginary part −0, which must not flip the root.
    let root = sqrt(-X).evaluate(&at(-minus_two)).unwrap();
    assert!(is_close(root, Complex64::new(0.0, 2_f64.sqrt())));
    let parts = re(X) + i() * im(X) - conj(conj(X));
    assert_eq!(parts.evaluate(&at(Complex64::new(0.3, 0.4))), Ok(Complex64::ZERO));
}

/// Small Gaussian numbers, on and beside every branch cut, where results are exact or purely imaginary.
#[test]
fn special_values_agree_with_double_precision() {
    let functions = [Function::Sqrt, Function::Exp, Function::Sin, Function::Cos, Function::Tan, Function::Abs];
    let inverses = [Function::Asin, Function::Acos, Function::Atan];
    let powers = [(0, 1), (1, 3), (2, 3), (-3, 2), (-5, 6), (4, 1), (1, 97), (3, 1_000_000_007)]
        .map(|(n, d)| Rational::new(n, d).unwrap());
    let parts = [-2.0, -1.0, -0.5, 0.0, 0.5, 1.0, 2.0, 3.0];
    for z in parts.iter().flat_map(|re| parts.map(|im| Complex64::new(*re, im))) {
        let exact = precise::complex(z);
        let pairs = functions.iter().chain(&inverses).map(|f| (exact.apply(*f), z.apply(*f)));
        let pairs = pairs.chain(powers.iter().map(|power| (exact.power(*power), z.power(*power))));
        for (precise, double) in pairs {
            let (Some(precise), Some(double)) = (precise, double) else { continue };
            assert_eq!(precise.precision(), precise::BITS);
            assert!((precise::to_complex64(&precise) - double).norm() < 1e-14 * (1.0 + double.norm()), "{z}");
        }
    }
}

/// The library's own inverse functions would not return here.
#[test]
fn inverse_functions_bear_a_vanishing_part() {
    let speck = precise::real(2.0).powi((-300_000).into());
    for (re, im) in [(precise::real(0.3), speck.clone()), (speck.clone(), precise::real(0.3))] {
        let z = Complex::from_parts(re, im);
        for (inverse, function) in [(Function::Asin, Function::Sin), (Function::Atan, Function::Tan)] {
            let back = z.apply(inverse).unwrap().apply(function).unwrap();
            assert!(precise::to_f64(&(back - &z).abs()) < 1e-75);
        }
        assert!(precise::to_f64(&(z.apply(Function::Acos).unwrap().cos() - &z).abs()) < 1e-75);
    }
}

#[test]
fn says_what_has_no_value() {
    let singular = (1 / (X - X)).evaluate(&at(precise::complex(Complex64::ONE)));
    assert_eq!(singular, Err(Unevaluable::Singular("1/(x − x)".into())));
    assert_eq!((1 / (X - X)).evaluate(&at(1.0)), Ok(f64::INFINITY));
    assert_eq!((X + Y).evaluate(&at(1.0)), Err(Unevaluable::Unbound("y".into())));
    assert_eq!(partial(Y, X).evaluate(&at(1.0)), Err(Unevaluable::NotAlgebraic("∂y/∂x".into())));
    assert_eq!((i() * X).evaluate(&at(1.0)), Err(Unevaluable::NotReal("i".into())));
    let huge = exp(exp(exp(exp(X)))).evaluate(&at(precise::complex(Complex64::new(9.0, 0.0))));
    assert!(matches!(huge, Err(Unevaluable::Singular(_))));
}

#[test]
fn resolves_definitions_in_any_order_and_refuses_circles() {
    let mut bindings = at(3.0);
    bindings.define(&Y, X + 1);
    assert_eq!((X * Y).evaluate(&bindings), Ok(12.0));
    bindings.define(&X, Y - 1);
    assert_eq!((X * Y).evaluate(&bindings), Err(Unevaluable::Circular("x".into())));
}
