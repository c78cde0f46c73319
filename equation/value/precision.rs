//! Arbitrary precision as a field. The library's functions that do not return, or that lose their precision, on some
//! arguments are gone around.

use super::field::Field;
use crate::expr::Function;
use crate::rational::Rational;
use yardstick::precise::{self, Complex, Real};

/// Beyond it exp leaves any range that an equation of physics needs, and the time it takes grows with it.
const LARGEST_EXPONENT: f64 = 1e5;
/// Beyond it a sine says nothing about an `f64` argument, and reducing the argument takes ever longer.
const LARGEST_ANGLE: f64 = 1e18;

impl Field for Complex {
    fn number(value: Rational, bits: usize) -> Self {
        let whole = |n: i64| Real::from(n).with_precision(bits).value();
        precise::from_real(whole(value.numerator()) / whole(value.denominator()))
    }

    fn pi(bits: usize) -> Self {
        precise::from_real(precise::pi(bits))
    }

    fn imaginary_unit(bits: usize) -> Option<Self> {
        Some(Self::from_parts(precise::real_at(0.0, bits), precise::real_at(1.0, bits)))
    }

    fn plus(&self, other: &Self) -> Self {
        self + other
    }

    fn times(&self, other: &Self) -> Self {
        self * other
    }

    fn over(&self, other: &Self) -> Option<Self> {
        if is_zero(other) { None } else { finite(self / other, self.precision()) }
    }

    fn negated(&self) -> Self {
        -self
    }

    fn power(&self, exponent: Rational) -> Option<Self> {
        let bits = self.precision();
        match (exponent.numerator(), exponent.denominator()) {
            (0, _) => Some(Self::number(Rational::ONE, bits)),
            (1, 2) => self.apply(Function::Sqrt),
            (n, _) if is_zero(self) => (n > 0).then(|| self.clone()),
            (n, d) => finite(root(self, usize::try_from(d).ok()?)?.powi(n.into()), bits),
        }
    }

    fn sine_cosine(&self) -> Option<(Self, Self)> {
        let (re, im) = self.clone().into_parts();
        if precise::to_f64(&re).abs() > LARGEST_ANGLE {
            return None;
        }
        let bits = self.precision();
        let (sin, cos) = re.sin_cos();
        if is_real_zero(&im) {
            return Some((finite(sin.into(), bits)?, finite(cos.into(), bits)?));
        }
        let (sinh, cosh) = sinh_cosh(&im)?;
        let sine = Self::from_parts(&sin * &cosh, &cos * &sinh);
        Some((finite(sine, bits)?, finite(Self::from_parts(cos * cosh, -(sin * sinh)), bits)?))
    }

    fn apply(&self, function: Function) -> Option<Self> {
        let (re, im) = self.clone().into_parts();
        let is_real = is_real_zero(&im);
        let value = match function {
            Function::Sqrt if is_real => real_root(re),
            Function::Sqrt => self.sqrt(),
            Function::Exp => exponential(&re, &im)?,
            Function::Sin => self.sine_cosine()?.0,
            Function::Cos => self.sine_cosine()?.1,
            Function::Tan => self.sine_cosine().and_then(|(sin, cos)| sin.over(&cos))?,
            Function::Asin if is_real && is_cosine(&re) => re.asin().into(),
            Function::Acos if is_real && is_cosine(&re) => re.acos().into(),
            Function::Atan if is_real => re.atan().into(),
            Function::Asin => arcsine(self),
            Function::Acos => arccosine(self),
            Function::Atan => arctangent(&re, &im)?,
            Function::Conj => self.conj(),
            Function::Abs => self.abs().into(),
            Function::Re => re.into(),
            Function::Im => im.into(),
        };
        finite(value, self.precision())
    }
}

fn is_real_zero(x: &Real) -> bool {
    x.repr().significand().is_zero()
}

/// Whether `z` is exactly 0.
pub(crate) fn is_zero(z: &Complex) -> bool {
    let (re, im) = z.clone().into_parts();
    is_real_zero(&re) && is_real_zero(&im)
}

/// `z` where it is finite, carried at `bits` again: the library gives values such as e⁰ and 0/x as exact, and an exact
/// operand stops the precision from spreading.
fn finite(z: Complex, bits: usize) -> Option<Complex> {
    if !z.is_finite() {
        return None;
    }
    let (re, im) = z.into_parts();
    Some(Complex::from_parts(re.with_precision(bits).value(), im.with_precision(bits).value()))
}

fn is_cosine(x: &Real) -> bool {
    let one = precise::real_at(1.0, x.precision());
    *x >= -one.clone() && *x <= one
}

fn real_root(x: Real) -> Complex {
    let bits = x.precision();
    let zero = precise::real_at(0.0, bits);
    if x >= zero { x.sqrt().into() } else { Complex::from_parts(zero, (-x).sqrt()) }
}

/// Beyond this degree a root goes through the logarithm.
const LARGEST_ROOT: usize = 64;

/// The principal `degree`-th root of a `z` that is not 0. Through modulus and angle, because the library's complex power
/// does not return where a part of the result is exact (as of (−1)^(1/3)).
fn root(z: &Complex, degree: usize) -> Option<Complex> {
    match degree {
        1 => Some(z.clone()),
        2 => z.apply(Function::Sqrt),
        _ => {
            let bits = z.precision();
            let size = z.abs().with_precision(bits).value();
            let whole = Real::from(degree).with_precision(bits).value();
            // The library's own root takes memory with the degree.
            let size = if degree > LARGEST_ROOT { (size.ln() / &whole).exp() } else { size.nth_root(degree) };
            let (sin, cos) = (argument(z, bits) / whole).sin_cos();
            Some(Complex::from_parts(&size * cos, size * sin))
        }
    }
}

/// arg z at `bits` of precision, which the library's own has not on the real axis.
fn argument(z: &Complex, bits: usize) -> Real {
    let (re, im) = z.clone().into_parts();
    match is_real_zero(&im) {
        true if re < Real::ZERO => precise::pi(bits),
        true => precise::real_at(0.0, bits),
        false => z.arg().with_precision(bits).value(),
    }
}

// The inverse functions go through real ones, after Kahan, "Branch cuts for complex elementary functions" (1987): the
// library's complex ones do not return in any reasonable time where one part is far smaller than the other.

/// √(1 − z) and √(1 + z).
fn edge_roots(z: &Complex) -> (Complex, Complex) {
    let one = Complex::number(Rational::ONE, z.precision());
    ((&one - z).sqrt(), (one + z).sqrt())
}

fn arcsine(z: &Complex) -> Complex {
    let (minus, plus) = edge_roots(z);
    let (re, _) = z.clone().into_parts();
    let (across, _) = (&minus * &plus).into_parts();
    let (_, along) = (minus.conj() * plus).into_parts();
    Complex::from_parts(re.atan2(&across), along.asinh())
}

fn arccosine(z: &Complex) -> Complex {
    let (minus, plus) = edge_roots(z);
    let (_, along) = (plus.conj() * &minus).into_parts();
    let ((below, _), (above, _)) = (plus.into_parts(), minus.into_parts());
    let half = above.atan2(&below);
    Complex::from_parts(&half + &half, along.asinh())
}

/// ½ atan2(2x, 1 − x² − y²) + ¼ i ln(1 + 4y/(x² + (1 − y)²)); none at ±i.
fn arctangent(x: &Real, y: &Real) -> Option<Complex> {
    let bits = x.precision();
    let number = |value| precise::real_at(value, bits);
    let from_i = x * x + (number(1.0) - y) * (number(1.0) - y);
    let from_minus_i = x * x + (number(1.0) + y) * (number(1.0) + y);
    if is_real_zero(&from_i) || is_real_zero(&from_minus_i) {
        return None;
    }
    // Each half-plane reckons from its own end of the cut, and of the cut itself the two ends face opposite ways.
    let sign = if *y < number(0.0) { number(-1.0) } else { number(1.0) };
    let near = if *y < number(0.0) { from_minus_i } else { from_i };
    let im = (number(4.0) * y * &sign / near).ln_1p() * sign.clone() / number(4.0);
    let across = (number(1.0) - x) * (number(1.0) + x) - y * y;
    let re = if is_real_zero(x) {
        if across < number(0.0) { sign * precise::pi(bits) } else { number(0.0) }
    } else {
        (number(2.0) * x).atan2(&across)
    };
    Some(Complex::from_parts(re / number(2.0), im))
}

/// sinh and cosh from one exponential, a third of the time of asking for them; 64 more bits make up for what
/// e^x − e^−x loses near zero.
pub(super) fn sinh_cosh(x: &Real) -> Option<(Real, Real)> {
    let size = precise::to_f64(x).abs();
    if size > LARGEST_EXPONENT {
        return None;
    }
    if size < 1e-16 {
        return Some(x.sinh_cosh());
    }
    let bits = x.precision();
    let grown = x.clone().with_precision(bits + 64).value().exp();
    let shrunk = precise::real_at(1.0, bits + 64) / &grown;
    let half = |sum: Real| (sum * precise::real_at(0.5, bits)).with_precision(bits).value();
    Some((half(&grown - &shrunk), half(grown + shrunk)))
}

fn exponential(re: &Real, im: &Real) -> Option<Complex> {
    if precise::to_f64(re).abs() > LARGEST_EXPONENT {
        return None;
    }
    let size = re.exp();
    if is_real_zero(im) {
        return Some(size.into());
    }
    let (sin, cos) = im.sin_cos();
    Some(Complex::from_parts(&size * cos, size * sin))
}
