//! The value of an expression, in `f64`, [`Complex64`] or arbitrary precision: one evaluator over any [`Field`].
//!
//! `f64` and [`Complex64`] follow IEEE 754: a vanishing denominator gives ∞ or NaN, so that a textbook form can be
//! seen to break. Arbitrary precision has no such values and answers [`Unevaluable::Singular`].

use super::expr::{Expr, Function, Node};
use super::rational::Rational;
use super::symbol::Symbol;
use num_complex::Complex64;
use std::collections::HashMap;
use std::fmt;
use yardstick::precise::{self, Complex, Real};

/// Why an expression has no value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unevaluable {
    /// A symbol without a value.
    Unbound(String),
    /// Symbols that are defined by each other, or by themselves.
    Circular(String),
    /// A vector, a derivative, an integral or a field: not a number by itself. Its face in Unicode.
    NotAlgebraic(String),
    /// Not a number at this point (a vanishing denominator, say). Its face in Unicode.
    Singular(String),
    /// Not real, where real numbers were asked for. Its face in Unicode.
    NotReal(String),
}

impl fmt::Display for Unevaluable {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Unbound(name) => write!(f, "{name} has no value"),
            Self::Circular(name) => write!(f, "{name} is defined by itself"),
            Self::NotAlgebraic(face) => write!(f, "{face} is not a number by itself"),
            Self::Singular(face) => write!(f, "{face} has no finite value here"),
            Self::NotReal(face) => write!(f, "{face} is not real"),
        }
    }
}

impl std::error::Error for Unevaluable {}

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

/// Values of symbols by name, and the precision of a calculation.
#[derive(Clone, Debug)]
pub struct Bindings<T> {
    bits: usize,
    values: HashMap<String, T>,
    definitions: HashMap<String, Expr>,
}

impl<T> Default for Bindings<T> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T> Bindings<T> {
    /// None yet; numbers and π at [`precise::BITS`] in arbitrary precision.
    pub fn new() -> Self {
        Self::with_bits(precise::BITS)
    }

    /// None yet; numbers and π at `bits` of precision (at least 53) in arbitrary precision.
    pub fn with_bits(bits: usize) -> Self {
        Self { bits: bits.max(53), values: HashMap::new(), definitions: HashMap::new() }
    }

    /// With `symbol` = `value`.
    pub fn with(mut self, symbol: &Symbol, value: T) -> Self {
        self.bind(symbol.name(), value);
        self
    }

    /// Whether `name` has a value.
    pub fn has(&self, name: &str) -> bool {
        self.values.contains_key(name)
    }

    /// Sets `name` = `value`.
    pub fn bind(&mut self, name: &str, value: T) {
        self.values.insert(name.to_owned(), value);
    }

    /// Sets `symbol` := `value`, evaluated when it is needed. It comes before a number of the same name.
    pub fn define(&mut self, symbol: &Symbol, value: Expr) {
        self.definitions.insert(symbol.name().to_owned(), value);
    }
}

impl Expr {
    /// Its value under `bindings`.
    pub fn evaluate<T: Field>(&self, bindings: &Bindings<T>) -> Result<T, Unevaluable> {
        Evaluation::new(bindings).value(self)
    }
}

/// One set of bindings and what was computed under it: equal parts of however many expressions are computed once.
#[derive(Debug)]
pub struct Evaluation<'a, T> {
    bindings: &'a Bindings<T>,
    known: HashMap<Expr, T>,
    sines: HashMap<Expr, (T, T)>,
    /// Names whose definitions are being evaluated.
    open: Vec<String>,
}

impl<'a, T: Field> Evaluation<'a, T> {
    /// Nothing computed yet.
    pub fn new(bindings: &'a Bindings<T>) -> Self {
        Self { bindings, known: HashMap::new(), sines: HashMap::new(), open: Vec::new() }
    }

    /// The value of `expr`.
    pub fn value(&mut self, expr: &Expr) -> Result<T, Unevaluable> {
        if let Some(value) = self.known.get(expr) {
            return Ok(value.clone());
        }
        let value = self.compute(expr)?;
        self.known.insert(expr.clone(), value.clone());
        Ok(value)
    }

    fn compute(&mut self, expr: &Expr) -> Result<T, Unevaluable> {
        let singular = || Unevaluable::Singular(expr.to_string());
        match expr.node() {
            Node::Number(value) => Ok(T::number(*value, self.bindings.bits)),
            Node::Pi => Ok(T::pi(self.bindings.bits)),
            Node::ImaginaryUnit => {
                T::imaginary_unit(self.bindings.bits).ok_or_else(|| Unevaluable::NotReal(expr.to_string()))
            }
            Node::Symbol(symbol) => self.symbol(symbol),
            Node::Sum(terms) => self.fold(terms, T::plus),
            Node::Product(factors) => self.fold(factors, T::times),
            Node::Quotient(above, below) => {
                let (above, below) = (self.value(above)?, self.value(below)?);
                above.over(&below).ok_or_else(singular)
            }
            Node::Power(base, exponent) => self.value(base)?.power(*exponent).ok_or_else(singular),
            Node::Negate(of) => Ok(self.value(of)?.negated()),
            Node::Function(Function::Sin, of) => Ok(self.sin_cos(of)?.0),
            Node::Function(Function::Cos, of) => Ok(self.sin_cos(of)?.1),
            Node::Function(Function::Tan, of) => {
                let (sin, cos) = self.sin_cos(of)?;
                sin.over(&cos).ok_or_else(singular)
            }
            Node::Function(function, of) => self.value(of)?.apply(*function).ok_or_else(singular),
            _ => Err(Unevaluable::NotAlgebraic(expr.to_string())),
        }
    }

    fn symbol(&mut self, symbol: &Symbol) -> Result<T, Unevaluable> {
        let name = symbol.name();
        let Some(definition) = self.bindings.definitions.get(name) else {
            return self.bindings.values.get(name).cloned().ok_or_else(|| Unevaluable::Unbound(symbol.to_string()));
        };
        if self.open.iter().any(|open| open == name) {
            return Err(Unevaluable::Circular(symbol.to_string()));
        }
        self.open.push(name.to_owned());
        let value = self.value(definition);
        self.open.pop();
        value
    }

    fn fold(&mut self, parts: &[Expr], join: fn(&T, &T) -> T) -> Result<T, Unevaluable> {
        let mut total = self.value(&parts[0])?;
        for part in &parts[1..] {
            total = join(&total, &self.value(part)?);
        }
        Ok(total)
    }

    fn sin_cos(&mut self, of: &Expr) -> Result<(T, T), Unevaluable> {
        if let Some(pair) = self.sines.get(of) {
            return Ok(pair.clone());
        }
        let pair = self.value(of)?.sine_cosine().ok_or_else(|| Unevaluable::Singular(format!("sin({of})")))?;
        self.sines.insert(of.clone(), pair.clone());
        Ok(pair)
    }
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
pub(super) fn is_zero(z: &Complex) -> bool {
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
fn sinh_cosh(x: &Real) -> Option<(Real, Real)> {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dimension::Dimension;
    use crate::expr::{acos, asin, atan, conj, cos, exp, i, im, partial, pi, re, sin, sqrt, tan};

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
}
