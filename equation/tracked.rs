//! Values that know how far rounding may have moved them.

use super::expr::Function;
use super::rational::Rational;
use super::value::{Field, is_zero};
use num_complex::Complex64;
use yardstick::precise::{self, Complex};

/// A number of arbitrary precision with a first-order bound of its rounding error (Higham, *Accuracy and Stability of
/// Numerical Algorithms*, §3.3): `error` is in units of 2^−bits and never below the magnitude of the value.
#[derive(Clone, Debug)]
pub(super) struct Tracked {
    pub value: Complex,
    size: f64,
    pub error: f64,
    bits: usize,
}

impl Tracked {
    /// A leaf, off by one rounding.
    pub fn exact(value: Complex, bits: usize) -> Self {
        Self::inherit(value, 0.0, bits)
    }

    /// A result that took over `error` from its operands and rounds once itself.
    fn inherit(value: Complex, error: f64, bits: usize) -> Self {
        let size = precise::to_complex64(&value).norm();
        Self { value, size, error: error + size, bits }
    }

    /// Whether its real part is beyond doubt positive.
    pub fn is_right_of_zero(&self) -> bool {
        precise::to_complex64(&self.value).re > self.error * (-(self.bits as f64)).exp2()
    }

    /// Whether a part of it that is not zero may be nothing but rounding: the side of a branch cut that it tells is none.
    fn is_noise(&self, part: f64) -> bool {
        part != 0.0 && part.abs() <= self.error * (-(self.bits as f64) / 2.0).exp2()
    }

    /// Whether nothing but rounding may be left of it.
    pub fn may_vanish(&self) -> bool {
        self.size <= self.error * (-(self.bits as f64) / 2.0).exp2()
    }

    /// Whether most digits are beyond doubt.
    #[cfg(test)]
    pub fn is_certain(&self) -> bool {
        self.size.is_normal() && self.error < 1e9 * self.size
    }

    /// |`self` − `other`| over the size of the terms they were made of [1]; `None` where that leaves the range of `f64`.
    pub fn difference(&self, other: &Self) -> Option<f64> {
        let gap = &self.value - &other.value;
        let scale = self.error + other.error;
        let resolved = scale.is_finite() && scale * (-(self.bits as f64)).exp2() > f64::MIN_POSITIVE;
        match (is_zero(&gap), resolved) {
            (true, _) => Some(0.0),
            (false, true) => Some(precise::to_complex64(&gap).norm() / scale).filter(|ratio| ratio.is_finite()),
            (false, false) => None,
        }
    }
}

impl Field for Tracked {
    fn number(value: Rational, bits: usize) -> Self {
        Self::exact(Complex::number(value, bits), bits)
    }

    fn pi(bits: usize) -> Self {
        Self::exact(Complex::pi(bits), bits)
    }

    fn imaginary_unit(bits: usize) -> Option<Self> {
        Complex::imaginary_unit(bits).map(|i| Self::exact(i, bits))
    }

    fn plus(&self, other: &Self) -> Self {
        Self::inherit(&self.value + &other.value, self.error + other.error, self.bits)
    }

    fn times(&self, other: &Self) -> Self {
        let error = self.size * other.error + other.size * self.error;
        Self::inherit(&self.value * &other.value, error, self.bits)
    }

    fn over(&self, other: &Self) -> Option<Self> {
        if other.may_vanish() {
            return None;
        }
        let value = self.value.over(&other.value)?;
        let error = (self.error + self.size / other.size * other.error) / other.size;
        Some(Self::inherit(value, error, self.bits))
    }

    fn negated(&self) -> Self {
        Self { value: -&self.value, ..self.clone() }
    }

    fn power(&self, exponent: Rational) -> Option<Self> {
        let p = exponent.numerator() as f64 / exponent.denominator() as f64;
        if self.may_vanish() && (p < 0.0 || exponent.as_integer().is_none()) && self.size > 0.0 {
            return None;
        }
        let z = precise::to_complex64(&self.value);
        if exponent.as_integer().is_none() && z.re < 0.0 && self.is_noise(z.im) {
            return None;
        }
        let value = self.value.power(exponent)?;
        let slope = if self.size == 0.0 { 0.0 } else { p.abs() * self.size.powf(p - 1.0) };
        Some(Self::inherit(value, slope * self.error, self.bits))
    }

    fn sine_cosine(&self) -> Option<(Self, Self)> {
        let (sin, cos) = self.value.sine_cosine()?;
        let slopes = [&cos, &sin].map(|slope| precise::to_complex64(slope).norm());
        Some((
            Self::inherit(sin, slopes[0] * self.error, self.bits),
            Self::inherit(cos, slopes[1] * self.error, self.bits),
        ))
    }

    fn apply(&self, function: Function) -> Option<Self> {
        if function == Function::Sqrt {
            return self.power(Rational::new(1, 2)?);
        }
        let x = precise::to_complex64(&self.value);
        let is_on_a_cut = match function {
            Function::Asin | Function::Acos => x.re.abs() > 1.0 && self.is_noise(x.im),
            Function::Atan => x.im.abs() > 1.0 && self.is_noise(x.re),
            _ => false,
        };
        if is_on_a_cut {
            return None;
        }
        let slope = match function {
            Function::Asin | Function::Acos => from_branch_point(1.0 - x * x)?.sqrt().recip(),
            Function::Atan => from_branch_point(1.0 + x * x)?.recip(),
            Function::Exp => x.re.exp(),
            _ => 1.0,
        };
        let value = self.value.apply(function)?;
        Some(Self::inherit(value, slope * self.error, self.bits))
    }
}

/// The distance, if `f64` can tell it from zero: at a branch point itself the slope has no bound.
fn from_branch_point(distance: Complex64) -> Option<f64> {
    Some(distance.norm()).filter(|distance| *distance > 1e-12)
}
