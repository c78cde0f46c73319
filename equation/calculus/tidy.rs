//! Sums, products, quotients and powers without the terms 0 and the factors 1 that rules leave behind.

use crate::expr::{Expr, Node};
use crate::rational::Rational;

pub(super) fn zero() -> Expr {
    Expr::from(0)
}

fn is_one(expr: &Expr) -> bool {
    matches!(expr.node(), Node::Number(value) if *value == Rational::ONE)
}

pub(super) fn sum(terms: impl IntoIterator<Item = Expr>) -> Expr {
    let mut flat = Vec::new();
    for term in terms {
        match term.node() {
            Node::Sum(inner) => flat.extend(inner.iter().filter(|inner| !inner.is_zero()).cloned()),
            _ if term.is_zero() => {}
            _ => flat.push(term),
        }
    }
    match flat.len() {
        0 => zero(),
        1 => flat.remove(0),
        _ => Expr::new(Node::Sum(flat)),
    }
}

pub(super) fn product(factors: impl IntoIterator<Item = Expr>) -> Expr {
    let mut flat = Vec::new();
    let mut negative = false;
    for factor in factors {
        if factor.is_zero() {
            return zero();
        }
        let factor = match factor.node() {
            Node::Negate(inner) => {
                negative = !negative;
                inner.clone()
            }
            _ => factor,
        };
        match factor.node() {
            Node::Product(inner) => flat.extend(inner.iter().cloned()),
            _ if is_one(&factor) => {}
            _ => flat.push(factor),
        }
    }
    let product = match flat.len() {
        0 => Expr::from(1),
        1 => flat.remove(0),
        _ => Expr::new(Node::Product(flat)),
    };
    if negative { -product } else { product }
}

pub(super) fn quotient(above: Expr, below: Expr) -> Expr {
    if above.is_zero() || is_one(&below) { above } else { above / below }
}

pub(super) fn negative(of: Expr) -> Expr {
    if of.is_zero() { zero() } else { -of }
}

pub(super) fn power(base: &Expr, exponent: Rational) -> Expr {
    match exponent.as_integer() {
        Some(0) => Expr::from(1),
        Some(1) => base.clone(),
        _ => base.pow(exponent),
    }
}
