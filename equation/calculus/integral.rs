//! Integrals between bounds, by primitives that are given.

use super::components::Value;
use super::coordinates::varies;
use super::refusal::{Unresolved, face};
use super::resolver::Resolver;
use super::tidy::{negative, product, sum};
use crate::expr::{Expr, Function, Node};
use crate::rational::Rational;
use crate::symbol::Symbol;

impl Resolver<'_> {
    pub fn integral(&mut self, expr: &Expr, of: &Expr, by: &Expr, from: &Expr, to: &Expr) -> Result<Value, Unresolved> {
        let variable = self.variable(by)?;
        let bounds = [self.scalar(from)?, self.scalar(to)?];
        let integrand = self.value(of)?;
        self.check(&integrand)?;
        integrand.map(|part| {
            if varies(&part, &variable) {
                return self.between(&part, &variable, &bounds).unwrap_or(Err(Unresolved::NoPrimitive(face(expr))));
            }
            let [from, to] = bounds.clone();
            Ok(product([part, sum([to, negative(from)])]))
        })
    }

    /// F(b) − F(a) with the primitive F of `integrand`, if there is one.
    fn between(&mut self, integrand: &Expr, variable: &Symbol, bounds: &[Expr; 2]) -> Option<Result<Expr, Unresolved>> {
        let primitives = self.calculus.primitives.iter();
        for primitive in primitives.filter(|primitive| primitive.variable.name() == variable.name()) {
            match self.fits(&primitive.of, integrand, variable) {
                Ok(Some(of)) if is_entire(&of, variable) => {
                    let [from, to] = bounds.each_ref().map(|bound| of.replace(&variable.into(), bound));
                    return Some(Ok(sum([to, negative(from)])));
                }
                Ok(Some(of)) => {
                    return Some(Err(Unresolved::NotEntire { face: face(&of), variable: variable.to_string() }));
                }
                Ok(None) => {}
                Err(refusal) => return Some(Err(refusal)),
            }
        }
        None
    }

    /// The component of the primitive `of` whose derivative the integrand is.
    fn fits(&mut self, of: &Expr, integrand: &Expr, variable: &Symbol) -> Result<Option<Expr>, Unresolved> {
        let value = self.value(of)?;
        self.check(&value)?;
        for of in value.parts() {
            let slope = Value::Scalar(self.slope(of, variable)?);
            self.check(&slope)?;
            if (self.calculus.equal)(integrand, &slope.into_scalar(of)?) {
                return Ok(Some(of.clone()));
            }
        }
        Ok(None)
    }
}

/// Whether it has no singularity at any finite `variable`, by its form.
fn is_entire(expr: &Expr, variable: &Symbol) -> bool {
    let parts = || expr.children().into_iter().all(|part| is_entire(part, variable));
    match expr.node() {
        Node::Symbol(symbol) if symbol.name() == variable.name() => true,
        _ if !varies(expr, variable) => true,
        Node::Sum(_) | Node::Product(_) | Node::Negate(_) => parts(),
        Node::Function(Function::Sin | Function::Cos | Function::Exp, _) => parts(),
        Node::Power(_, exponent) => exponent.as_integer().is_some() && *exponent >= Rational::ZERO && parts(),
        Node::Quotient(above, below) => is_entire(above, variable) && !varies(below, variable),
        _ => false,
    }
}
