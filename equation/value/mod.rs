//! The value of an expression, in `f64`, [`Complex64`] or arbitrary precision: one evaluator over any [`Field`].
//!
//! `f64` and [`Complex64`] follow IEEE 754: a vanishing denominator gives ∞ or NaN, so that a textbook form can be
//! seen to break. Arbitrary precision has no such values and answers [`Unevaluable::Singular`].
//!
//! [`Complex64`]: num_complex::Complex64

mod field;
mod precision;
#[cfg(test)]
mod tests;

use crate::expr::{Expr, Function, Node};
use crate::symbol::Symbol;
use std::collections::HashMap;
use std::fmt;
use yardstick::precise;

pub use field::Field;
pub(super) use precision::is_zero;

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
