//! Reading expressions: what the one-line face prints, and what people type.
//!
//! ```
//! use equation::parse::parse;
//!
//! let t_s = parse("2 sin(theta2) cos(theta1)/sin(theta1 + theta2)", &[]).unwrap();
//! assert_eq!(t_s.to_string(), "2 sin θ₂ cos θ₁/sin(θ₁ + θ₂)");
//! assert_eq!(parse(&t_s.to_string(), &[]), Ok(t_s));
//! let fault = parse("1/2x", &[]).unwrap_err();
//! assert_eq!(fault.to_string(), "column 4: a/b c could be (a/b) c or a/(b c): write the brackets");
//! ```
//!
//! Names are a letter, a Greek letter or its English name, with an index and primes: `theta_1`, `theta1`, θ₁, `E_1'`.
//! Letters side by side are a product (kz), names before a bracket a value at arguments if they are known and a refusal
//! if not. Whatever could mean two things is refused with both.
//!
//! Every expression that the face prints is read back as it was, but for these: a number that has neither finite
//! decimals nor a character of its own reads as a quotient (3/2); a vector sign between numbers, or a product of two
//! vectors, does not read as one; and with a symbol named d, e or i the sign of that name is lost.

mod calculus;
mod cursor;
mod fault;
mod grammar;
mod lex;
mod part;
#[cfg(test)]
mod tests;

use super::expr::Expr;
use super::symbol::Symbol;
use super::{Equation, Relation};
use cursor::Parser;

pub use fault::{DEEPEST, Fault};

/// Reads an expression. The `known` symbols keep their unit, domain and rank and win over any other meaning of their
/// names; other names are positive numbers of dimension one.
///
/// # Errors
/// For whatever is not an expression, or could be two.
pub fn parse(text: &str, known: &[Symbol]) -> Result<Expr, Fault> {
    let mut parser = Parser::new(text, known)?;
    let expr = parser.expression()?;
    parser.end()?;
    Ok(expr)
}

/// Reads two expressions with =, ≈ or ∝ between them.
///
/// # Errors
/// As [`parse`].
pub fn parse_equation(text: &str, known: &[Symbol]) -> Result<Equation, Fault> {
    let mut parser = Parser::new(text, known)?;
    let lhs = parser.expression()?;
    let relation: Relation = parser.relation()?;
    let rhs = parser.expression()?;
    parser.end()?;
    Ok(Equation { lhs, rhs, relation })
}
