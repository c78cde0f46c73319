//! From expressions to their normal form.

use super::atoms::Atoms;
use super::fraction::{Fraction, Result, Undecided};
use crate::expr::{Expr, Function, Node};
use crate::rational::Rational;
use dashu_int::IBig;
use std::collections::HashMap;

/// How deeply expressions may be nested.
const DEEPEST: usize = 400;

/// The normal forms of however many expressions over common atoms.
#[derive(Debug, Default)]
pub(super) struct Normaliser {
    pub atoms: Atoms,
    known: HashMap<Expr, Fraction>,
    depth: usize,
}

impl Normaliser {
    /// What `work` finds once every angle has a base that all its occurrences are whole multiples of.
    pub fn settle<T>(&mut self, work: impl Fn(&mut Self) -> Result<T>) -> Result<T> {
        loop {
            // A common denominator at least doubles in each round and is bounded.
            self.known.clear();
            self.atoms.is_stale = false;
            let found = work(self)?;
            if !self.atoms.is_stale {
                return Ok(found);
            }
        }
    }

    /// The normal form of `expr`.
    pub fn fraction(&mut self, expr: &Expr) -> Result<Fraction> {
        if let Some(known) = self.known.get(expr) {
            return Ok(known.clone());
        }
        self.deeper(|this| this.compute(expr)).inspect(|found| {
            self.known.insert(expr.clone(), found.clone());
        })
    }

    fn deeper<T>(&mut self, work: impl FnOnce(&mut Self) -> Result<T>) -> Result<T> {
        if self.depth >= DEEPEST {
            return Err(Undecided::TooLarge);
        }
        self.depth += 1;
        let found = work(self);
        self.depth -= 1;
        found
    }

    fn compute(&mut self, expr: &Expr) -> Result<Fraction> {
        match expr.node() {
            Node::Number(value) => Ok(Fraction::number(IBig::from(value.numerator()), IBig::from(value.denominator()))),
            Node::Pi => Ok(self.atoms.pi()),
            Node::ImaginaryUnit => Ok(self.atoms.imaginary()),
            Node::Symbol(symbol) => Ok(self.atoms.symbol(symbol)),
            Node::Sum(terms) => self.fold(terms, |ring, total, term| ring.atoms.arithmetic.plus(total, term)),
            Node::Product(factors) => self.fold(factors, |ring, total, term| ring.atoms.arithmetic.times(total, term)),
            Node::Quotient(above, below) => {
                let (above, inverse) = (self.fraction(above)?, self.inverse(below)?);
                self.atoms.arithmetic.times(&above, &inverse)
            }
            Node::Power(base, exponent) => self.power(base, *exponent),
            Node::Negate(of) => Ok(self.fraction(of)?.negated()),
            Node::Function(Function::Conj, of) => self.conjugate(of),
            Node::Function(Function::Re, of) => self.half_sum(of, false),
            Node::Function(Function::Im, of) => self.half_sum(of, true),
            Node::Function(Function::Abs, of) => {
                let (value, conjugate) = (self.fraction(of)?, self.conjugate(of)?);
                let square = self.atoms.arithmetic.times(&value, &conjugate)?;
                self.atoms.root(&square, 2)
            }
            Node::Function(function, of) => {
                let of = self.fraction(of)?;
                self.apply(*function, &of, expr)
            }
            _ => Err(Undecided::NotAlgebraic(expr.to_string())),
        }
    }

    fn fold(
        &mut self,
        parts: &[Expr],
        join: fn(&mut Self, &Fraction, &Fraction) -> Result<Fraction>,
    ) -> Result<Fraction> {
        let mut total = self.fraction(&parts[0])?;
        for part in &parts[1..] {
            let part = self.fraction(part)?;
            total = join(self, &total, &part)?;
        }
        Ok(total)
    }

    fn inverse(&mut self, expr: &Expr) -> Result<Fraction> {
        let fraction = self.fraction(expr)?;
        self.inverse_of(&fraction, expr)
    }

    /// 1/`fraction`; `expr` is what it came from.
    fn inverse_of(&mut self, fraction: &Fraction, expr: &Expr) -> Result<Fraction> {
        let inverse = self.atoms.arithmetic.inverse(fraction)?;
        inverse.ok_or_else(|| Undecided::ZeroDenominator(expr.to_string()))
    }

    /// The principal power: that of the root of the exponent's denominator.
    fn power(&mut self, base: &Expr, exponent: Rational) -> Result<Fraction> {
        let degree = u32::try_from(exponent.denominator()).map_err(|_| Undecided::TooLarge)?;
        let times = u32::try_from(exponent.numerator().unsigned_abs()).map_err(|_| Undecided::TooLarge)?;
        let mut root = self.fraction(base)?;
        if degree > 1 {
            // The relation of a root of high degree would raise what stands below to that degree.
            if degree > 12 {
                return Err(Undecided::TooLarge);
            }
            root = self.atoms.root(&root, degree)?;
        }
        let power = self.atoms.arithmetic.raise(&root, times)?;
        if exponent.is_negative() { self.inverse_of(&power, base) } else { Ok(power) }
    }

    /// Any function of one argument but those that need the argument's conjugate; `expr` is what it came from.
    fn apply(&mut self, function: Function, of: &Fraction, expr: &Expr) -> Result<Fraction> {
        match function {
            Function::Sqrt => self.atoms.root(of, 2),
            Function::Sin => Ok(self.sine_cosine(of)?.0),
            Function::Cos => Ok(self.sine_cosine(of)?.1),
            Function::Tan => {
                let (sin, cos) = self.sine_cosine(of)?;
                let inverse = self.inverse_of(&cos, expr)?;
                self.atoms.arithmetic.times(&sin, &inverse)
            }
            Function::Exp => self.exponential(of),
            _ if of.is_zero() && matches!(function, Function::Asin | Function::Atan) => Ok(Fraction::zero()),
            _ => Ok(self.atoms.opaque(function, of)),
        }
    }

    fn sine_cosine(&mut self, angle: &Fraction) -> Result<(Fraction, Fraction)> {
        let mut total = (Fraction::zero(), Fraction::one());
        for part in self.atoms.parts(angle) {
            let pair = if part.is_imaginary {
                // sin ix = i (eˣ − e⁻ˣ)/2 and cos ix = (eˣ + e⁻ˣ)/2.
                let exp = self.atoms.exponential(&part)?;
                let half = Fraction::number(IBig::ONE, IBig::from(2));
                let i = self.atoms.imaginary();
                let ring = &mut self.atoms.arithmetic;
                let inverse = ring.inverse(&exp)?.unwrap_or_else(Fraction::one);
                let (sum, difference) = (ring.plus(&exp, &inverse)?, ring.plus(&exp, &inverse.negated())?);
                let difference = ring.times(&i, &difference)?;
                (ring.times(&difference, &half)?, ring.times(&sum, &half)?)
            } else {
                self.atoms.sine_cosine(&part)?
            };
            total = self.atoms.of_sum(&total, &pair)?;
        }
        Ok(total)
    }

    fn exponential(&mut self, exponent: &Fraction) -> Result<Fraction> {
        let mut total = Fraction::one();
        for part in self.atoms.parts(exponent) {
            let factor = if part.is_imaginary {
                let (sin, cos) = self.atoms.sine_cosine(&part)?;
                let i = self.atoms.imaginary();
                let turned = self.atoms.arithmetic.times(&i, &sin)?;
                self.atoms.arithmetic.plus(&cos, &turned)?
            } else {
                self.atoms.exponential(&part)?
            };
            total = self.atoms.arithmetic.times(&total, &factor)?;
        }
        Ok(total)
    }

    /// (z + z*)/2, or (z − z*)/(2i).
    fn half_sum(&mut self, of: &Expr, imaginary: bool) -> Result<Fraction> {
        let (value, conjugate) = (self.fraction(of)?, self.conjugate(of)?);
        let half = Fraction::number(IBig::ONE, IBig::from(2));
        if !imaginary {
            let sum = self.atoms.arithmetic.plus(&value, &conjugate)?;
            return self.atoms.arithmetic.times(&sum, &half);
        }
        let difference = self.atoms.arithmetic.plus(&value, &conjugate.negated())?;
        let over_i = self.atoms.imaginary().negated();
        let over_i = self.atoms.arithmetic.times(&over_i, &half)?;
        self.atoms.arithmetic.times(&difference, &over_i)
    }

    fn conjugate(&mut self, expr: &Expr) -> Result<Fraction> {
        self.deeper(|this| this.compute_conjugate(expr))
    }

    /// What analytic functions with real values on the real axis do to a conjugate, part by part.
    fn compute_conjugate(&mut self, expr: &Expr) -> Result<Fraction> {
        match expr.node() {
            Node::Number(_) | Node::Pi => self.fraction(expr),
            Node::ImaginaryUnit => Ok(self.atoms.imaginary().negated()),
            Node::Symbol(symbol) if symbol.domain().im == (0.0, 0.0) => self.fraction(expr),
            Node::Sum(terms) => self.fold_conjugates(terms, |ring, a, b| ring.atoms.arithmetic.plus(a, b)),
            Node::Product(factors) => self.fold_conjugates(factors, |ring, a, b| ring.atoms.arithmetic.times(a, b)),
            Node::Quotient(above, below) => {
                let (above, of) = (self.conjugate(above)?, self.conjugate(below)?);
                let inverse = self.inverse_of(&of, below)?;
                self.atoms.arithmetic.times(&above, &inverse)
            }
            Node::Power(base, exponent) if exponent.as_integer().is_some() => {
                let times = u32::try_from(exponent.numerator().unsigned_abs()).map_err(|_| Undecided::TooLarge)?;
                let of = self.conjugate(base)?;
                let power = self.atoms.arithmetic.raise(&of, times)?;
                if exponent.is_negative() { self.inverse_of(&power, base) } else { Ok(power) }
            }
            Node::Negate(of) => Ok(self.conjugate(of)?.negated()),
            Node::Function(Function::Conj, of) => self.fraction(of),
            Node::Function(Function::Abs | Function::Re | Function::Im, _) => self.fraction(expr),
            Node::Function(function @ (Function::Sin | Function::Cos | Function::Tan | Function::Exp), of) => {
                let of = self.conjugate(of)?;
                self.apply(*function, &of, expr)
            }
            _ => {
                // A root, an inverse function: on its branch cut the rule above fails.
                let value = self.fraction(expr)?;
                if self.atoms.is_positive(&value) { Ok(value) } else { Ok(self.atoms.opaque(Function::Conj, &value)) }
            }
        }
    }

    fn fold_conjugates(
        &mut self,
        parts: &[Expr],
        join: fn(&mut Self, &Fraction, &Fraction) -> Result<Fraction>,
    ) -> Result<Fraction> {
        let mut total = self.conjugate(&parts[0])?;
        for part in &parts[1..] {
            let part = self.conjugate(part)?;
            total = join(self, &total, &part)?;
        }
        Ok(total)
    }
}
