//! Equations: linear systems solved, one equation from another, a hypothesis from an equation.

use super::atoms::Kind;
use super::fraction::{Fraction, Undecided};
use super::normal::Normaliser;
use super::polynomial::{Atom, Polynomial};
use crate::equation::Equation;
use crate::equation::derivation::Given;
use crate::equation::expr::{Expr, sqrt};
use crate::equation::symbol::Symbol;
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
    /// An equation with no symbol that it can be solved for. Its face in Unicode.
    NoSymbol(String),
    /// An equation that never holds. Its face in Unicode.
    Contradiction(String),
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
pub fn solve(equations: &[(Expr, Expr)], unknowns: &[Symbol]) -> Result<Vec<Expr>, Unsolvable> {
    let mut ring = Normaliser::default();
    let mut rows = ring.settle(|ring| {
        let atoms: Vec<Atom> = unknowns.iter().map(|unknown| ring.atoms.symbol_atom(unknown)).collect();
        let differences = equations.iter().map(|(left, right)| ring.difference(left, right));
        Ok((atoms, differences.collect::<Result<Vec<_>, _>>()?))
    })?;
    let (atoms, differences) = (std::mem::take(&mut rows.0), rows.1);
    let mut rows = Vec::new();
    for difference in &differences {
        rows.push(linear(&ring, difference, &atoms).map_err(|at| Unsolvable::NotLinear(unknowns[at].to_string()))?);
    }
    if rows.len() != atoms.len() {
        return Err(Unsolvable::Dependent);
    }
    let solution = eliminate(&mut ring, rows)?.ok_or(Unsolvable::Dependent)?;
    let faces = solution.iter().map(|value| ring.expr(value).ok_or(Undecided::TooLarge.into()));
    faces.collect()
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

/// Gauss and Jordan's elimination; `None` where the determinant vanishes.
fn eliminate(ring: &mut Normaliser, mut rows: Vec<Vec<Fraction>>) -> Result<Option<Vec<Fraction>>, Undecided> {
    let arithmetic = &mut ring.atoms.arithmetic;
    for column in 0..rows.len() {
        let Some(pivot) = (column..rows.len()).find(|&row| !rows[row][column].is_zero()) else { return Ok(None) };
        rows.swap(column, pivot);
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
    Ok(Some(rows.into_iter().filter_map(|mut row| row.pop()).collect()))
}

/// Whether `to` follows from `from`: an unknown of the one, in which both are polynomials, is eliminated from the
/// other, and nothing is left (pseudo-division; Ritt, *Differential Algebra*, ch. V). Where the leading coefficient
/// that is multiplied with vanishes, nothing is said.
pub fn follows(from: &Equation, to: &Equation) -> Result<bool, Undecided> {
    Normaliser::default().settle(|ring| {
        let (from, to) = (ring.difference(&from.lhs, &from.rhs)?, ring.difference(&to.lhs, &to.rhs)?);
        for atom in from.atoms() {
            let is_symbol = matches!(ring.atoms.kind(atom), Kind::Symbol(_));
            if is_symbol
                && !ring.hides(&from, atom)
                && !ring.hides(&to, atom)
                && ring.remainder(&to, &from, atom)?.is_zero()
            {
                return Ok(true);
            }
        }
        Ok(to.is_zero())
    })
}

/// `equation` as a hypothesis: solved for the first of its symbols that it is linear in and that no function hides, else for
/// one whose square it is linear in (the positive root), known as `by`.
pub fn orient(equation: &Equation, by: &'static str) -> Result<Given, Unsolvable> {
    let mut ring = Normaliser::default();
    let sum = ring.settle(|ring| ring.difference(&equation.lhs, &equation.rhs))?;
    if sum.as_constant().is_some_and(|value| value != IBig::ZERO) {
        return Err(Unsolvable::Contradiction(equation.to_string()));
    }
    for degree in [1, 2] {
        for symbol in equation.lhs.symbols().into_iter().chain(equation.rhs.symbols()) {
            let atom = ring.atoms.symbol_atom(symbol);
            let is_pure = sum.degree(atom) == degree && (1..degree).all(|lower| sum.coefficient(atom, lower).is_zero());
            if !is_pure || ring.hides(&sum, atom) {
                continue;
            }
            let (above, below) = (sum.coefficient(atom, 0), sum.coefficient(atom, degree));
            let arithmetic = &mut ring.atoms.arithmetic;
            let Some(inverse) = arithmetic.inverse(&Fraction::of(below))? else { continue };
            let value = arithmetic.times(&Fraction::of(above.negated()), &inverse)?;
            let value = ring.expr(&value).ok_or(Undecided::TooLarge)?;
            let value = if degree == 2 { sqrt(value) } else { value };
            return Ok(Given { what: symbol.into(), value, by });
        }
    }
    Err(Unsolvable::NoSymbol(equation.to_string()))
}

impl Normaliser {
    /// The numerator of `left` − `right`.
    fn difference(&mut self, left: &Expr, right: &Expr) -> Result<Polynomial, Undecided> {
        let (left, right) = (self.fraction(left)?, self.fraction(right)?);
        Ok(self.atoms.arithmetic.plus(&left, &right.negated())?.above)
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
            let shift = Polynomial::term(super::polynomial::Monomial::power(atom, power - degree), IBig::ONE);
            let top = self.atoms.arithmetic.product(&rest.coefficient(atom, power), &shift)?;
            let removed = self.atoms.arithmetic.product(&top, by)?;
            rest = self.atoms.arithmetic.product(&rest, &leading)?.plus(&removed.negated());
        }
        Ok(rest)
    }
}
