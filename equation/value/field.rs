//! The numbers that expressions are evaluated in; those of IEEE 754 among them.

use crate::expr::Function;
use crate::rational::Rational;
use num_complex::Complex64;

/// Numbers that an expression can be evaluated in. `None` is a value that does not exist (in the field, or at all).
pub trait Field: Clone {
    /// The number nearest to `value`.
    fn number(value: Rational, bits: usize) -> Self;
    /// π
    fn pi(bits: usize) -> Self;
    /// i
    fn imaginary_unit(bits: usize) -> Option<Self>;
    /// Sum.
    fn plus(&self, other: &Self) -> Self;
    /// Product.
    fn times(&self, other: &Self) -> Self;
    /// Quotient.
    fn over(&self, other: &Self) -> Option<Self>;
    /// −x
    fn negated(&self) -> Self;
    /// Power.
    fn power(&self, exponent: Rational) -> Option<Self>;
    /// Sine and cosine at once, which most number types compute together.
    fn sine_cosine(&self) -> Option<(Self, Self)>;
    /// Any function but sin, cos and tan.
    fn apply(&self, function: Function) -> Option<Self>;
}

impl Field for f64 {
    fn number(value: Rational, _bits: usize) -> Self {
        value.numerator() as f64 / value.denominator() as f64
    }

    fn pi(_bits: usize) -> Self {
        std::f64::consts::PI
    }

    fn imaginary_unit(_bits: usize) -> Option<Self> {
        None
    }

    fn plus(&self, other: &Self) -> Self {
        self + other
    }

    fn times(&self, other: &Self) -> Self {
        self * other
    }

    fn over(&self, other: &Self) -> Option<Self> {
        Some(self / other)
    }

    fn negated(&self) -> Self {
        -self
    }

    fn power(&self, exponent: Rational) -> Option<Self> {
        Some(match (exponent.numerator(), exponent.denominator()) {
            (1, 2) => self.sqrt(),
            (n, 1) if n.unsigned_abs() < 64 => self.powi(n as i32),
            (n, d) => self.powf(n as f64 / d as f64),
        })
    }

    fn sine_cosine(&self) -> Option<(Self, Self)> {
        Some(f64::sin_cos(*self))
    }

    fn apply(&self, function: Function) -> Option<Self> {
        Some(match function {
            Function::Sqrt => self.sqrt(),
            Function::Exp => self.exp(),
            Function::Sin => self.sin(),
            Function::Cos => self.cos(),
            Function::Tan => self.tan(),
            Function::Asin => self.asin(),
            Function::Acos => self.acos(),
            Function::Atan => self.atan(),
            Function::Abs => self.abs(),
            Function::Conj | Function::Re => *self,
            Function::Im => 0.0,
        })
    }
}

impl Field for Complex64 {
    fn number(value: Rational, bits: usize) -> Self {
        f64::number(value, bits).into()
    }

    fn pi(bits: usize) -> Self {
        f64::pi(bits).into()
    }

    fn imaginary_unit(_bits: usize) -> Option<Self> {
        Some(Self::I)
    }

    fn plus(&self, other: &Self) -> Self {
        self + other
    }

    fn times(&self, other: &Self) -> Self {
        self * other
    }

    fn over(&self, other: &Self) -> Option<Self> {
        Some(self / other)
    }

    fn negated(&self) -> Self {
        -self
    }

    fn power(&self, exponent: Rational) -> Option<Self> {
        Some(match (exponent.numerator(), exponent.denominator()) {
            (1, 2) => unsigned(self).sqrt(),
            (n, 1) if n.unsigned_abs() < 64 => self.powi(n as i32),
            (n, d) => unsigned(self).powf(n as f64 / d as f64),
        })
    }

    fn sine_cosine(&self) -> Option<(Self, Self)> {
        Some((self.sin(), self.cos()))
    }

    fn apply(&self, function: Function) -> Option<Self> {
        Some(match function {
            Function::Sqrt => unsigned(self).sqrt(),
            Function::Exp => self.exp(),
            Function::Sin => self.sin(),
            Function::Cos => self.cos(),
            Function::Tan => self.tan(),
            Function::Asin => unsigned(self).asin(),
            Function::Acos => unsigned(self).acos(),
            Function::Atan => self.atan(),
            Function::Conj => self.conj(),
            Function::Abs => self.norm().into(),
            Function::Re => self.re.into(),
            Function::Im => self.im.into(),
        })
    }
}

/// The same number with no sign on a zero imaginary part: −x of a real x must not change the side of a branch cut.
fn unsigned(z: &Complex64) -> Complex64 {
    Complex64::new(z.re, z.im + 0.0)
}
