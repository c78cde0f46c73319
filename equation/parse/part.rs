//! What a part of a text reads as, with what the reading of its surroundings needs.

use crate::expr::{Expr, Function, Node};
use crate::rational::Rational;
use crate::symbol::{Rank, Symbol};

/// An expression that was read, with what the reading of its surroundings needs.
pub(super) struct Part {
    pub expr: Expr,
    /// How deep its tree is.
    pub height: usize,
    pub is_vector: bool,
    /// What may not follow it without a bracket.
    pub end: End,
}

/// How the face of a factor ends.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum End {
    /// As a whole.
    Closed,
    /// With the bare argument of a function, sin x: what follows could belong to it.
    Bare,
    /// With a denominator.
    Slash,
    /// With a denominator whose function has a bare argument.
    SlashBare,
    /// With the variables of an integral.
    Integral,
}

impl Part {
    pub fn new(node: Node, parts: &[&Part], is_vector: bool) -> Self {
        let height = parts.iter().map(|part| part.height).max().unwrap_or(0) + 1;
        Self { expr: Expr::new(node), height, is_vector, end: End::Closed }
    }

    pub fn leaf(expr: impl Into<Expr>) -> Self {
        Self { expr: expr.into(), height: 1, is_vector: false, end: End::Closed }
    }

    pub fn ending(self, end: End) -> Self {
        Self { end, ..self }
    }

    pub fn negated(self, is_negative: bool) -> Self {
        match is_negative {
            true => Self { height: self.height + 1, expr: -self.expr, ..self },
            false => self,
        }
    }

    /// One expression of several parts, which lie below it.
    pub fn of(parts: Vec<Part>, build: fn(Vec<Expr>) -> Expr) -> Self {
        let is_vector = parts.iter().any(|part| part.is_vector);
        let height = parts.iter().map(|part| part.height).max().unwrap_or(0) + usize::from(parts.len() > 1);
        let end = parts.last().map_or(End::Closed, |part| part.end);
        Self { expr: build(parts.into_iter().map(|part| part.expr).collect()), height, is_vector, end }
    }
}

pub(super) fn value(function: Function, of: &Part) -> Part {
    let is_vector = of.is_vector && matches!(function, Function::Conj | Function::Re | Function::Im);
    Part::new(Node::Function(function, of.expr.clone()), &[of], is_vector)
}

pub(super) fn quotient(above: Part, below: Part) -> Part {
    let height = above.height.max(below.height) + 1;
    let end = if below.end == End::Bare { End::SlashBare } else { End::Slash };
    Part { expr: above.expr / below.expr, height, is_vector: above.is_vector, end }
}

pub(super) fn symbol_part(symbol: &Symbol) -> Part {
    Part { is_vector: symbol.rank() == Rank::Vector, ..Part::leaf(symbol) }
}

pub(super) fn power(base: Part, exponent: Option<Rational>) -> Part {
    match exponent {
        Some(exponent) => Part::new(Node::Power(base.expr.clone(), exponent), &[&base], base.is_vector),
        None => base,
    }
}

/// The rational number that an expression is, if it is written as one.
pub(super) fn rational(expr: &Expr) -> Option<Rational> {
    match expr.node() {
        Node::Number(value) => Some(*value),
        Node::Negate(of) => rational(of).map(Rational::negated),
        Node::Quotient(above, below) => {
            let (above, below) = (rational(above)?.as_integer()?, rational(below)?.as_integer()?);
            Rational::new(above, below)
        }
        Node::Power(base, exponent) => {
            let (base, exponent) = (rational(base)?.as_integer()?, exponent.as_integer()?);
            Rational::new(base.checked_pow(u32::try_from(exponent).ok()?)?, 1)
        }
        _ => None,
    }
}
