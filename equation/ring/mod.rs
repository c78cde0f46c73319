//! The decider: whether two expressions are the same function.
//!
//! Every expression becomes a quotient of polynomials with whole coefficients in *atoms*: symbols, i, π, the sine and
//! cosine of base angles, exponentials, roots. Where atoms are multiplied, their relations are applied: i² = −1,
//! sin² = 1 − cos², the root's power is what it is the root of. Angles are split into terms; every term is a whole
//! multiple of a base angle, and sums and multiples are expanded. Two expressions are equal if the numerator of
//! their difference has no term left. Where nothing is divided by zero that direction is sound; the other one holds where the atoms are
//! independent, so a difference that is left over proves nothing, and [`super::derivation`] looks for a point instead.
//!
//! Not decided are nested roots that simplify, roots of squares of sums that may be of either sign, relations between values of sin and cos
//! at different numbers, and inverse functions beyond sin(arcsin u) and its like.

mod angles;
mod atoms;
mod fraction;
mod normal;
mod polynomial;
#[cfg(test)]
mod properties;
mod roots;
mod show;
mod solve;
#[cfg(test)]
mod tests;

pub use fraction::Undecided;
pub use solve::{Solution, Unsolvable, factors, follows, orient, solve};

use super::expr::Expr;
use normal::Normaliser;

/// Whether `left` − `right` vanishes in normal form, wherever both are defined.
///
/// `false` says that the normal forms differ: as a rule the expressions do then, but that is no proof.
pub fn equal(left: &Expr, right: &Expr) -> Result<bool, Undecided> {
    if left == right {
        return Ok(true);
    }
    Normaliser::default().settle(|ring| {
        let (left, right) = (ring.fraction(left)?, ring.fraction(right)?);
        if left == right {
            return Ok(true);
        }
        Ok(ring.atoms.arithmetic.plus(&left, &right.negated())?.is_zero())
    })
}

/// Whether `a` is `b` times numbers and symbols that are never zero: where one vanishes, the other does.
pub fn vanish_together(a: &Expr, b: &Expr) -> Result<bool, Undecided> {
    Normaliser::default().settle(|ring| {
        let quotient = ring.fraction(&(a / b))?;
        Ok(quotient.is_product(|atom| ring.atoms.never_vanishes(atom)))
    })
}

/// The normal form of `expr` as an expression: one fraction, expanded.
pub fn normal_form(expr: &Expr) -> Result<Expr, Undecided> {
    let mut ring = Normaliser::default();
    let found = ring.settle(|ring| ring.fraction(expr))?;
    ring.expr(&found).ok_or(Undecided::TooLarge)
}
