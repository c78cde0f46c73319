//! What is taken as given: what the calculus puts in, the finder steps by and a derivation starts from.

use super::expr::Expr;
use super::symbol::Symbol;

/// A hypothesis: what is replaced and what stands for it.
#[derive(Clone, Debug, PartialEq)]
pub struct Given {
    /// What is replaced: a symbol; a field's derivative ∂F/∂t or divergence ∇·F, with which all derivatives of it go;
    /// or any other form, where it stands as it is written.
    pub what: Expr,
    /// By what.
    pub value: Expr,
    /// The rule or law that says so.
    pub by: &'static str,
}

/// An antiderivative: whatever integrand ∂`of`/∂`variable` is equal to is integrated by it.
#[derive(Clone, Debug, PartialEq)]
pub struct Primitive {
    /// F, entire in the variable.
    pub of: Expr,
    /// The variable of integration.
    pub variable: Symbol,
}
