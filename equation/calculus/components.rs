//! Numbers, and vectors by their components.

use super::refusal::{Unresolved, face};
use super::tidy::{negative, product, sum, zero};
use crate::expr::{Expr, Function, Node, conj, sqrt};
use crate::symbol::{Rank, Symbol};

/// A number, or a vector by its components.
#[derive(Clone)]
pub(super) enum Value {
    Scalar(Expr),
    Vector([Expr; 3]),
}

impl Value {
    /// The number that `expr` was found to be.
    pub fn into_scalar(self, expr: &Expr) -> Result<Expr, Unresolved> {
        match self {
            Self::Scalar(value) => Ok(value),
            Self::Vector(_) => Err(Unresolved::Rank { face: face(expr), wanted: Rank::Scalar }),
        }
    }

    /// The components of the vector that `expr` was found to be; a bare 0 may be one.
    pub fn into_vector(self, expr: &Expr) -> Result<[Expr; 3], Unresolved> {
        match self {
            Self::Vector(parts) => Ok(parts),
            Self::Scalar(value) if value.is_zero() => Ok([zero(), zero(), zero()]),
            Self::Scalar(_) => Err(Unresolved::Rank { face: face(expr), wanted: Rank::Vector }),
        }
    }

    pub fn parts(&self) -> &[Expr] {
        match self {
            Self::Scalar(value) => std::slice::from_ref(value),
            Self::Vector(parts) => parts,
        }
    }

    pub fn map(self, mut image: impl FnMut(Expr) -> Result<Expr, Unresolved>) -> Result<Self, Unresolved> {
        Ok(match self {
            Self::Scalar(value) => Self::Scalar(image(value)?),
            Self::Vector([x, y, z]) => Self::Vector([image(x)?, image(y)?, image(z)?]),
        })
    }
}

pub(super) fn dot(a: &[Expr; 3], b: &[Expr; 3]) -> Expr {
    sum(a.iter().zip(b).map(|(a, b)| product([a.clone(), b.clone()])))
}

/// The vector with the components t(y, z) − t(z, y) and so on round.
pub(super) fn antisymmetric(
    mut term: impl FnMut(usize, usize) -> Result<Expr, Unresolved>,
) -> Result<[Expr; 3], Unresolved> {
    let mut part = |i, j| Ok(sum([term(i, j)?, negative(term(j, i)?)]));
    Ok([part(1, 2)?, part(2, 0)?, part(0, 1)?])
}

/// |v|
pub(super) fn length(parts: &[Expr; 3]) -> Expr {
    let square = |part: &Expr| if is_real(part) { part.pow(2) } else { product([part.clone(), conj(part)]) };
    sqrt(sum(parts.iter().filter(|part| !part.is_zero()).map(square)))
}

/// Whether it is real for real symbols, by its form.
fn is_real(expr: &Expr) -> bool {
    let parts = || expr.children().into_iter().all(is_real);
    match expr.node() {
        Node::Number(_) | Node::Pi => true,
        Node::Symbol(symbol) => symbol_is_real(symbol),
        Node::Apply(symbol, _) => symbol_is_real(symbol) && parts(),
        Node::Power(_, exponent) => exponent.as_integer().is_some() && parts(),
        Node::Sum(_) | Node::Product(_) | Node::Quotient(..) | Node::Negate(_) | Node::Partial(..) => parts(),
        Node::Function(Function::Abs | Function::Re | Function::Im, _) => true,
        Node::Function(Function::Exp | Function::Sin | Function::Cos | Function::Tan | Function::Atan, _) => parts(),
        _ => false,
    }
}

pub(super) fn symbol_is_real(symbol: &Symbol) -> bool {
    symbol.domain().im == (0.0, 0.0)
}
