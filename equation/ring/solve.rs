//! Equations: linear systems solved, one equation from another, a hypothesis from an equation.

use super::atoms::Kind;
use super::equal;
use super::fraction::{Fraction, Undecided};
use super::normal::Normaliser;
use super::polynomial::{Atom, Monomial, Polynomial};
use crate::Equation;
use crate::expr::{Expr, Node, sqrt};
use crate::symbol::Symbol;
use dashu_int::IBig;
use std::fmt;

/// Why equations have no solution that can be written down.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unsolvable {
    /// No normal form.
    Undecided(Undecided),
    /// Not linear in this unknown, or an unknown inside a function.
    NotLinear(String),
    /// Not as many independent equations as unknowns.
    Dependent,
    /// An equation with no symbol that it can be solved for, or a product of which either factor may be zero. Its face
    /// in Unicode.
    NoSymbol(String),
    /// An equation that never holds. Its face in Unicode.
    Contradiction(String),
}

/// Symbols and what they are where none of the divisors vanishes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Solution {
    /// What each symbol is.
    pub values: Vec<(Symbol, Expr)>,
    /// What was divided by on the way.
    pub divisors: Vec<Expr>,
}

impl fmt::Display for Unsolvable {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Undecided(why) => why.fmt(f),
            Self::NotLinear(unknown) => write!(f, "the equations are not linear in {unknown}"),
            Self::Dependent => write!(f, "the equations do not determine the unknowns"),
            Self::NoSymbol(face) => write!(f, "{face} cannot be solved for any of its symbols"),
            Self::Contradiction(face) => write!(f, "{face} never holds"),
        }
    }
}

impl std::error::Error for Unsolvable {}

impl From<Undecided> for Unsolvable {
    fn from(why: Undecided) -> Self {
        Self::Undecided(why)
    }
}

/// What the `unknowns` are, by as many equations (left and right sides) that are linear in them, where their determinant
/// does not vanish: Gaussian elimination over the rational functions of everything else.
pub fn solve(equations: &[(Expr, Expr)], unknowns: &[Symbol]) -> Result<Solution, Unsolvable> {
    let mut ring = Normaliser::default();
    let mut rows = ring.settle(|ring| {
        let atoms: Vec<Atom> = unknowns.iter().map(|unknown| ring.atoms.symbol_atom(unknown)).collect();
        let differences = equations.iter().map(|(left, right)| ring.difference(left, right));
        Ok((atoms, differences.collect::<Result<Vec<_>, _>>()?))
    })?;
    let (atoms, differences) = (std::mem::take(&mut rows.0), rows.1);
    let mut rows = Vec::new();
    // A component that is 0 = 0 determines nothing.
    for difference in differences.iter().filter(|difference| !difference.is_zero()) {
        rows.push(linear(&ring, difference, &atoms).map_err(|at| Unsolvable::NotLinear(unknowns[at].to_string()))?);
    }
    if rows.len() != atoms.len() {
        return Err(Unsolvable::Dependent);
    }
    let (values, pivots) = eliminate(&mut ring, rows)?.ok_or(Unsolvable::Dependent)?;
    let face = |value: &Fraction| ring.expr(value).ok_or(Undecided::TooLarge);
    let values = unknowns.iter().zip(&values).map(|(unknown, value)| Ok((unknown.clone(), face(value)?)));
    let pivots = pivots.iter().map(|pivot| face(&Fraction::of(pivot.above.clone())));
    Ok(Solution { values: values.collect::<Result<_, Undecided>>()?, divisors: pivots.collect::<Result<_, _>>()? })
}

/// The coefficients of `atoms` in `sum`, and last what is left with the sign changed; or which of them it is not linear in.
fn linear(ring: &Normaliser, sum: &Polynomial, atoms: &[Atom]) -> Result<Vec<Fraction>, usize> {
    let mut rest = sum.clone();
    let mut row = Vec::new();
    for (at, &atom) in atoms.iter().enumerate() {
        let coefficient = sum.coefficient(atom, 1);
        let is_free = atoms.iter().all(|&other| coefficient.degree(other) == 0);
        if sum.degree(atom) > 1 || !is_free || ring.hides(sum, atom) {
            return Err(at);
        }
        rest = rest.coefficient(atom, 0);
        row.push(Fraction::of(coefficient));
    }
    row.push(Fraction::of(rest.negated()));
    Ok(row)
}

/// Values and pivots.
type Eliminated = (Vec<Fraction>, Vec<Fraction>);

/// Gauss and Jordan's elimination; `None` where the determinant vanishes.
fn eliminate(ring: &mut Normaliser, mut rows: Vec<Vec<Fraction>>) -> Result<Option<Eliminated>, Undecided> {
    let mut pivots = Vec::new();
    let arithmetic = &mut ring.atoms.arithmetic;
    for column in 0..rows.len() {
        let Some(pivot) = (column..rows.len()).find(|&row| !rows[row][column].is_zero()) else { return Ok(None) };
        rows.swap(column, pivot);
        pivots.push(rows[column][column].clone());
        let Some(inverse) = arithmetic.inverse(&rows[column][column])? else { return Ok(None) };
        for entry in &mut rows[column] {
            *entry = arithmetic.times(entry, &inverse)?;
        }
        let pivot = rows[column].clone();
        for (at, row) in rows.iter_mut().enumerate() {
            let factor = row[column].negated();
            if at == column || factor.is_zero() {
                continue;
            }
            for (entry, above) in row.iter_mut().zip(&pivot) {
                let moved = arithmetic.times(&factor, above)?;
                *entry = arithmetic.plus(entry, &moved)?;
            }
        }
    }
    Ok(Some((rows.into_iter().filter_map(|mut row| row.pop()).collect(), pivots)))
}

/// Whether `to` follows from `from`, and what must not vanish for it: an unknown of the one, in which both are
/// polynomials, is eliminated from the other, and nothing is left (pseudo-division by its leading coefficient; Ritt,
/// *Differential Algebra*, ch. V).
pub fn follows(from: &Equation, to: &Equation) -> Result<Option<Expr>, Undecided> {
    let mut ring = Normaliser::default();
    let found = ring.settle(|ring| {
        let (from, to) = (ring.difference(&from.lhs, &from.rhs)?, ring.difference(&to.lhs, &to.rhs)?);
        if to.is_zero() {
            return Ok(Some(Fraction::one()));
        }
        for atom in from.atoms() {
            let is_symbol = matches!(ring.atoms.kind(atom), Kind::Symbol(_));
            let is_open = is_symbol && !ring.hides(&from, atom) && !ring.hides(&to, atom);
            let leading = from.coefficient(atom, from.degree(atom));
            if is_open && !ring.is_branch(&leading, &from)? && ring.remainder(&to, &from, atom)?.is_zero() {
                return Ok(Some(Fraction::of(leading)));
            }
        }
        Ok(None)
    })?;
    found.map(|leading| ring.expr(&leading).ok_or(Undecided::TooLarge)).transpose()
}

/// The factors of `equation`, written as a difference, that may vanish, as far as they can be told apart: it holds where
/// one of them does.
pub fn factors(equation: &Equation) -> Result<Vec<Expr>, Undecided> {
    let mut ring = Normaliser::default();
    let mut parts = Vec::new();
    if equal(&equation.rhs, &Expr::from(0))? {
        written_factors(&equation.lhs, &mut parts);
    } else {
        parts.push(&equation.lhs - &equation.rhs);
    }
    let found = ring.settle(|ring| {
        let mut found: Vec<Polynomial> = Vec::new();
        for part in &parts {
            let sum = ring.fraction(part)?.above;
            let common = sum.common_monomial();
            let atoms = common.powers().iter().filter(|(atom, _)| !ring.atoms.never_vanishes(*atom));
            found.extend(atoms.map(|(atom, _)| Polynomial::atom(*atom)));
            found.extend(ring.split(sum.divided(&common, &IBig::ONE))?);
        }
        Ok(found)
    })?;
    found.into_iter().map(|sum| ring.expr(&Fraction::of(sum)).ok_or(Undecided::TooLarge)).collect()
}

/// What a product is written as a product of.
fn written_factors(expr: &Expr, found: &mut Vec<Expr>) {
    match expr.node() {
        Node::Product(factors) => factors.iter().for_each(|factor| written_factors(factor, found)),
        Node::Negate(of) | Node::Quotient(of, _) => written_factors(of, found),
        Node::Power(base, exponent) if !exponent.is_negative() => written_factors(base, found),
        _ => found.push(expr.clone()),
    }
}

/// `equation` as a hypothesis: factors that all its terms share and that are never zero are divided out, and the rest is
/// solved for the first of its symbols that it is linear in and that no function hides, else for a positive one whose square it is linear in.
/// Of an equation that always holds nothing follows: no symbol. A root is zero where what it is the root of is.
///
/// That a symbol is never zero is what its domain says; another premise may say otherwise. So whatever is divided out
/// is among the divisors.
pub fn orient(equation: &Equation) -> Result<Solution, Unsolvable> {
    let mut ring = Normaliser::default();
    let all = ring.settle(|ring| ring.difference(&equation.lhs, &equation.rhs))?;
    ring.orient(&all, equation)
}

impl Normaliser {
    /// [`orient`] of the equation that says that `all` is zero.
    fn orient(&mut self, all: &Polynomial, equation: &Equation) -> Result<Solution, Unsolvable> {
        if all.is_zero() {
            return Ok(Solution::default());
        }
        let (common, one) = (all.common_monomial(), IBig::ONE);
        let sum = all.divided(&common, &one);
        if sum.as_constant().is_some() {
            return self.one_factor(&common, equation);
        }
        if common.powers().iter().any(|(atom, _)| !self.atoms.never_vanishes(*atom)) {
            return Err(Unsolvable::NoSymbol(equation.to_string()));
        }
        let common = Polynomial::term(common, one);
        for degree in [1, 2] {
            for symbol in equation.lhs.symbols().into_iter().chain(equation.rhs.symbols()) {
                let atom = self.atoms.symbol_atom(symbol);
                let is_pure =
                    sum.degree(atom) == degree && (1..degree).all(|lower| sum.coefficient(atom, lower).is_zero());
                // Of the two roots a positive quantity is the positive one.
                let is_one_valued = degree == 1 || symbol.domain().re.0 > 0.0;
                if !is_pure || !is_one_valued || self.hides(&sum, atom) {
                    continue;
                }
                let (above, below) = (sum.coefficient(atom, 0), sum.coefficient(atom, degree));
                if self.is_branch(&below, &sum)? {
                    continue;
                }
                let arithmetic = &mut self.atoms.arithmetic;
                let Some(inverse) = arithmetic.inverse(&Fraction::of(below.clone()))? else { continue };
                let value = arithmetic.times(&Fraction::of(above.negated()), &inverse)?;
                let value = if degree == 2 { sqrt(self.face(value)?) } else { self.face(value)? };
                let divisors = [below, common].into_iter().filter(|divisor| divisor.as_constant().is_none());
                let divisors = divisors.map(|divisor| self.face(Fraction::of(divisor))).collect::<Result<_, _>>()?;
                return Ok(Solution { values: vec![(symbol.clone(), value)], divisors });
            }
        }
        Err(Unsolvable::NoSymbol(equation.to_string()))
    }

    fn face(&self, value: Fraction) -> Result<Expr, Undecided> {
        self.expr(&value).ok_or(Undecided::TooLarge)
    }

    /// `sum` without the coefficient of its highest power of some symbol, and that coefficient, where it is a factor; so on
    /// with both. Numbers and what is never zero are no factors.
    fn split(&mut self, sum: Polynomial) -> Result<Vec<Polynomial>, Undecided> {
        if Fraction::of(sum.clone()).is_product(|atom| self.atoms.never_vanishes(atom)) {
            return Ok(Vec::new());
        }
        for atom in sum.atoms() {
            let leading = sum.coefficient(atom, sum.degree(atom));
            if leading.len() > 1
                && sum.degree(atom) > 0
                && let Some(quotient) = self.atoms.arithmetic.quotient(&sum, &leading)?
            {
                return Ok([self.split(leading)?, self.split(quotient)?].concat());
            }
        }
        Ok(vec![sum])
    }

    /// A product that is zero: so is the only one of its factors that may be.
    fn one_factor(&mut self, product: &Monomial, equation: &Equation) -> Result<Solution, Unsolvable> {
        let may_vanish = |(atom, _): &&(Atom, u32)| !self.atoms.never_vanishes(*atom);
        let single = match product.powers() {
            // What is said to be zero by itself is, whatever its domain.
            [(atom, _)] => vec![*atom],
            all => all.iter().filter(may_vanish).map(|(atom, _)| *atom).collect(),
        };
        let [atom] = single[..] else {
            return Err(match single[..] {
                [] => Unsolvable::Contradiction(equation.to_string()),
                _ => Unsolvable::NoSymbol(equation.to_string()),
            });
        };
        let found = match self.atoms.kind(atom).clone() {
            Kind::Imaginary | Kind::Pi | Kind::Exp(_) => Err(Unsolvable::Contradiction(equation.to_string())),
            Kind::Symbol(symbol) => Ok(Solution { values: vec![(symbol, Expr::from(0))], divisors: vec![] }),
            Kind::Root { of, .. } => self.orient(&of.above, equation),
            _ => Err(Unsolvable::NoSymbol(equation.to_string())),
        };
        let rest = Polynomial::term(product.with(atom, 0), IBig::ONE);
        found.and_then(|mut solution| {
            if rest.as_constant().is_none() {
                solution.divisors.push(self.face(Fraction::of(rest))?);
            }
            Ok(solution)
        })
    }

    /// The numerator of `left` − `right`.
    fn difference(&mut self, left: &Expr, right: &Expr) -> Result<Polynomial, Undecided> {
        let (left, right) = (self.fraction(left)?, self.fraction(right)?);
        Ok(self.atoms.arithmetic.plus(&left, &right.negated())?.above)
    }

    /// Whether `sum` vanishes wherever `divisor` does, which may happen: dividing by it would leave out a branch.
    fn is_branch(&mut self, divisor: &Polynomial, sum: &Polynomial) -> Result<bool, Undecided> {
        if Fraction::of(divisor.clone()).is_product(|atom| self.atoms.never_vanishes(atom)) {
            return Ok(false);
        }
        if self.atoms.arithmetic.quotient(sum, divisor)?.is_some() {
            return Ok(true);
        }
        for atom in divisor.atoms() {
            let is_symbol = matches!(self.atoms.kind(atom), Kind::Symbol(_));
            let is_open = is_symbol && !self.hides(divisor, atom) && !self.hides(sum, atom);
            if is_open && self.remainder(sum, divisor, atom)?.is_zero() {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Whether `atom` stands inside another atom of `sum`.
    fn hides(&self, sum: &Polynomial, atom: Atom) -> bool {
        sum.atoms().into_iter().any(|other| other != atom && self.mentions(other, atom))
    }

    fn mentions(&self, outer: Atom, atom: Atom) -> bool {
        let within = |sum: &Polynomial| sum.atoms().into_iter().any(|inner| self.mentions(inner, atom));
        let below = |factors: &[(Polynomial, u32)]| factors.iter().any(|(factor, _)| within(factor));
        match self.atoms.kind(outer) {
            _ if outer == atom => true,
            Kind::Imaginary | Kind::Pi | Kind::Symbol(_) => false,
            Kind::Sin(angle) | Kind::Cos(angle) | Kind::Exp(angle) => {
                let above = Polynomial::term(angle.of.above.clone(), IBig::ONE);
                within(&above) || below(&angle.of.below)
            }
            Kind::Root { of, .. } | Kind::Leg(of) | Kind::Opaque(_, of) => within(&of.above) || below(&of.below),
        }
    }

    /// The pseudo-remainder of `of` by `by` as polynomials in `atom`.
    fn remainder(&mut self, of: &Polynomial, by: &Polynomial, atom: Atom) -> Result<Polynomial, Undecided> {
        let degree = by.degree(atom);
        let leading = by.coefficient(atom, degree);
        let mut rest = of.clone();
        while rest.degree(atom) >= degree && !rest.is_zero() {
            let power = rest.degree(atom);
            let shift = Polynomial::term(Monomial::power(atom, power - degree), IBig::ONE);
            let top = self.atoms.arithmetic.product(&rest.coefficient(atom, power), &shift)?;
            let removed = self.atoms.arithmetic.product(&top, by)?;
            rest = self.atoms.arithmetic.product(&rest, &leading)?.plus(&removed.negated());
        }
        Ok(rest)
    }
}
