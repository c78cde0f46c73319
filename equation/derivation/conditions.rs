//! What must not be zero for a chain to hold: everything that it divides by.

use super::atoms::Atoms;
use super::chain::{Chain, Claim, Line};
use super::hypotheses::Hypotheses;
use crate::expr::{Expr, Function, Node, cos};
use crate::ring;

/// So many divisors are compared with one another; of more, only equal ones are left out.
const MOST_COMPARED: usize = 24;

impl Chain {
    /// What the chain divides by and the symbols' domains do not keep from zero, each once.
    pub fn conditions(&self) -> Vec<Expr> {
        let mut found: Vec<Expr> = Vec::new();
        let lines = self.lines.iter().flat_map(|line| line.unfolded.iter().chain([line]));
        let given = self.given.iter().map(|given| &given.value);
        if let Ok(hypotheses) = Hypotheses::of(self, &Atoms::default()) {
            hypotheses.divisors.iter().for_each(|divisor| divide(divisor, &mut found));
        }
        for expr in lines.flat_map(sides).chain(given) {
            collect(expr, &mut found);
        }
        if found.len() > MOST_COMPARED {
            return found;
        }
        // Later lines are the more compact ones: what vanishes with two of theirs says nothing new.
        let mut kept: Vec<Expr> = Vec::new();
        for divisor in found.into_iter().rev() {
            let is_product = |a: &Expr| {
                let pairs = kept.iter().map(|b| a * b).chain([a.clone()]);
                pairs.into_iter().any(|product| ring::vanish_together(&divisor, &product) == Ok(true))
            };
            if !kept.iter().any(is_product) {
                kept.insert(0, divisor);
            }
        }
        kept
    }
}

pub(super) fn sides(line: &Line) -> Vec<&Expr> {
    match &line.claim {
        Claim::Expr(expr) => vec![expr],
        Claim::Equation(equation) => vec![&equation.lhs, &equation.rhs],
    }
}

fn collect(expr: &Expr, found: &mut Vec<Expr>) {
    divisors(expr).iter().for_each(|divisor| divide(divisor, found));
}

/// Everything that stands below a line in `expr`.
pub(super) fn divisors(expr: &Expr) -> Vec<Expr> {
    let own = match expr.node() {
        // The quotient of two differentials is a derivative.
        Node::Quotient(_, below) if !matches!(below.node(), Node::Differential(_)) => Some(below.clone()),
        Node::Power(base, exponent) if exponent.is_negative() => Some(base.clone()),
        Node::Function(Function::Tan, of) => Some(cos(of)),
        _ => None,
    };
    own.into_iter().chain(expr.children().into_iter().flat_map(divisors)).collect()
}

/// The factors of a divisor that may vanish.
fn divide(by: &Expr, found: &mut Vec<Expr>) {
    match by.node() {
        Node::Product(factors) => factors.iter().for_each(|factor| divide(factor, found)),
        Node::Quotient(above, _) => divide(above, found),
        Node::Power(base, _) | Node::Negate(base) | Node::Function(Function::Sqrt, base) => divide(base, found),
        Node::Number(_) | Node::Pi | Node::ImaginaryUnit | Node::Function(Function::Exp, _) => {}
        Node::Symbol(symbol) if symbol.domain().excludes_zero() => {}
        _ if found.contains(by) => {}
        _ => found.push(by.clone()),
    }
}
