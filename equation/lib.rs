//! Equations as objects: what stands on the page is what is checked.
//!
//! An [`Equation`] relates two expressions ([`expr`]). From it come its face in LaTeX, MathML and Unicode
//! ([`face`]), the units of both sides ([`units`]), its value in any number type ([`value`]), and the
//! verification of the lines that lead to it ([`derivation`]).

pub mod calculus;
pub mod derivation;
pub mod dimension;
pub mod expr;
pub mod face;
pub mod find;
mod glyph;
pub mod hypothesis;
pub mod parse;
pub mod rational;
pub mod ring;
pub mod sound;
pub mod symbol;
mod tracked;
pub mod units;
pub mod value;

#[cfg(test)]
mod constructs;
#[cfg(test)]
mod properties;

pub use dimension::Dimension;
pub use expr::Expr;
pub use symbol::Symbol;

/// Two expressions and how they are related.
#[derive(Clone, Debug, PartialEq)]
pub struct Equation {
    /// Left side.
    pub lhs: Expr,
    /// Right side.
    pub rhs: Expr,
    /// What holds between them.
    pub relation: Relation,
}

/// What holds between the two sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Relation {
    /// =
    Equal,
    /// ≈, of the same dimension.
    Approximate,
    /// ∝, of any dimension.
    Proportional,
}

impl Equation {
    /// `lhs` = `rhs`
    pub fn new(lhs: impl Into<Expr>, rhs: impl Into<Expr>) -> Self {
        Self { lhs: lhs.into(), rhs: rhs.into(), relation: Relation::Equal }
    }

    /// `lhs` ≈ `rhs`
    pub fn approximate(lhs: impl Into<Expr>, rhs: impl Into<Expr>) -> Self {
        Self { relation: Relation::Approximate, ..Self::new(lhs, rhs) }
    }

    /// `lhs` ∝ `rhs`
    pub fn proportional(lhs: impl Into<Expr>, rhs: impl Into<Expr>) -> Self {
        Self { relation: Relation::Proportional, ..Self::new(lhs, rhs) }
    }
}
