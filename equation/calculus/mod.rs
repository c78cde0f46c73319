//! Derivatives, vector operators and integrals carried out: what is left of an equation are scalar equations in atoms
//! that algebra alone can decide.
//!
//! Vectors are taken in Cartesian components. Position is (x, y, z) and time t, symbols by these names; fields
//! ([`Symbol::field`]) depend on all four. The component of a vector symbol is a symbol with the axis in its index
//! (E₁ → E₁ₓ); those of the position vector r, in metres, are x, y and z.
//!
//! ```
//! use equation::calculus::derivative;
//! use equation::expr::sin;
//! use equation::{Dimension, Symbol};
//!
//! const K: Symbol = Symbol::scalar("k", Dimension::RADIAN_PER_METRE);
//! const Z: Symbol = Symbol::scalar("z", Dimension::METRE);
//! assert_eq!(derivative(&sin(K * Z), &Z).unwrap().to_string(), "cos(kz) k");
//! ```

mod components;
mod coordinates;
mod given;
mod integral;
mod refusal;
mod resolver;
mod slope;
mod tidy;

#[cfg(test)]
mod tests;

use super::expr::{Expr, Node};
use super::symbol::Symbol;
use components::Value;
use resolver::Resolver;

pub use given::Calculus;
pub use refusal::{DEEPEST, LARGEST, Unresolved};

/// The derivative of `expr` by the symbol `by`, with no more simplification than that terms 0 and factors 1 are left
/// out.
///
/// A field depends on x, y, z and t; its derivatives by them are the atoms ∂F/∂x…, variables in alphabetical order. A
/// function at arguments is derived by the chain rule, with the atoms ∂f(u, v)/∂u. Any symbol but `by` is a constant.
/// A vector is taken to components first. Conjugate, real and imaginary part and magnitude have a derivative by real
/// variables alone (|f|′ = Re(f* f′)/|f|).
pub fn derivative(expr: &Expr, by: &Symbol) -> Result<Expr, Unresolved> {
    let calculus = Calculus::new(&[], &[], &|_, _| false);
    let mut resolver = Resolver::new(&calculus, &[expr])?;
    let value = resolver.value(expr)?;
    let by = resolver.variable(&by.into())?;
    let slopes = resolver.slope_of(value, &by)?;
    resolver.check(&slopes)?;
    Ok(match slopes {
        Value::Scalar(slope) => slope,
        Value::Vector(parts) => Expr::new(Node::Vector(parts)),
    })
}

impl Calculus<'_> {
    /// The scalar equations that `left` = `right` stands for, one or three, with every hypothesis applied and every
    /// vector operation, derivative and integral carried out.
    ///
    /// What is left are algebra and functions of these atoms: symbols; functions at arguments; ∂F/∂x… of a field or
    /// a component of one, variables in alphabetical order; ∂f(u, v)/∂u… of a function by its own arguments, in their
    /// order; differentials of symbols, other than in the quotient dq/dt, which is the derivative. The magnitude
    /// |v| of a vector becomes √(v·v) where v is real for real symbols, and √(v·v*) elsewhere.
    ///
    /// An integral between bounds is taken with a primitive F whose derivative is equal to the integrand; F must be
    /// entire in the variable: made of sums, products, powers, sin, cos and exp, and divided by nothing that varies.
    pub fn resolve(&self, left: &Expr, right: &Expr) -> Result<Vec<(Expr, Expr)>, Unresolved> {
        let mut resolver = Resolver::new(self, &[left, right])?;
        let (a, b) = (resolver.value(left)?, resolver.value(right)?);
        resolver.check(&a)?;
        resolver.check(&b)?;
        match (a, b) {
            (Value::Scalar(a), Value::Scalar(b)) => Ok(vec![(a, b)]),
            (a, b) => Ok(a.into_vector(left)?.into_iter().zip(b.into_vector(right)?).collect()),
        }
    }
}
