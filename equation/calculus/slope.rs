//! The derivative of a number: rules for each operation and function, and the atoms that are left.

use super::components::symbol_is_real;
use super::coordinates::is_coordinate;
use super::given::Rule;
use super::refusal::{Unresolved, face};
use super::resolver::Resolver;
use super::tidy::{negative, power, product, quotient, sum, zero};
use crate::expr::{Expr, Function, Node, abs, conj, cos, re, sin, sqrt};
use crate::rational::Rational;
use crate::symbol::Symbol;

impl Resolver<'_> {
    /// ∂`expr`/∂`by` of a number that is carried out.
    pub fn slope(&mut self, expr: &Expr, by: &Symbol) -> Result<Expr, Unresolved> {
        match expr.node() {
            Node::Number(_) | Node::Pi | Node::ImaginaryUnit => return Ok(zero()),
            Node::Symbol(symbol) if symbol.name() == by.name() => return Ok(Expr::from(1)),
            Node::Symbol(symbol) if !symbol.is_field() || !is_coordinate(by) => return Ok(zero()),
            _ => {}
        }
        if let Some(slope) = self.slopes.get(by.name()).and_then(|known| known.get(expr)) {
            return Ok(slope.clone());
        }
        let slope = self.deeper(|this| this.differentiate(expr, by))?;
        self.slopes.entry(by.name().to_owned()).or_default().insert(expr.clone(), slope.clone());
        Ok(slope)
    }

    fn differentiate(&mut self, expr: &Expr, by: &Symbol) -> Result<Expr, Unresolved> {
        match expr.node() {
            Node::Symbol(_) => self.field(expr, vec![by.into()]),
            Node::Apply(_, arguments) => self.chain_rule(expr, arguments, &[], by),
            Node::Partial(of, known) => match of.node() {
                Node::Apply(_, arguments) => self.chain_rule(of, arguments, known, by),
                Node::Symbol(_) if !is_coordinate(by) => Ok(zero()),
                Node::Symbol(_) => self.field(of, known.iter().cloned().chain([by.into()]).collect()),
                _ => Err(Unresolved::Opaque(face(expr))),
            },
            Node::Sum(terms) => {
                self.spend(terms.len())?;
                Ok(sum(terms.iter().map(|term| self.slope(term, by)).collect::<Result<Vec<_>, _>>()?))
            }
            Node::Product(factors) => self.product_rule(factors, by),
            Node::Quotient(above, below) => {
                let (d_above, d_below) = (self.slope(above, by)?, self.slope(below, by)?);
                if d_below.is_zero() {
                    return Ok(quotient(d_above, below.clone()));
                }
                let terms = [product([d_above, below.clone()]), negative(product([above.clone(), d_below]))];
                Ok(quotient(sum(terms), below.pow(2)))
            }
            Node::Negate(of) => Ok(negative(self.slope(of, by)?)),
            Node::Power(base, exponent) => {
                let inner = self.slope(base, by)?;
                let one_less = exponent.numerator().checked_sub(exponent.denominator());
                let one_less = one_less.and_then(|above| Rational::new(above, exponent.denominator()));
                let one_less = one_less.ok_or_else(|| Unresolved::Exponent(face(expr)))?;
                Ok(product([Expr::number(*exponent), power(base, one_less), inner]))
            }
            Node::Function(function, of) => {
                let inner = self.slope(of, by)?;
                if inner.is_zero() { Ok(inner) } else { of_function(expr, *function, of, inner, by) }
            }
            _ => Err(Unresolved::Opaque(face(expr))),
        }
    }

    fn product_rule(&mut self, factors: &[Expr], by: &Symbol) -> Result<Expr, Unresolved> {
        let mut terms = Vec::new();
        for (place, factor) in factors.iter().enumerate() {
            let slope = self.slope(factor, by)?;
            if !slope.is_zero() {
                self.spend(factors.len())?;
                let with_slope = factors.iter().enumerate();
                terms.push(product(with_slope.map(|(at, other)| if at == place { &slope } else { other }.clone())));
            }
        }
        Ok(sum(terms))
    }

    /// The derivative of a function that is derived by the arguments `known` already.
    fn chain_rule(
        &mut self,
        function: &Expr,
        arguments: &[Expr],
        known: &[Expr],
        by: &Symbol,
    ) -> Result<Expr, Unresolved> {
        let mut terms = Vec::new();
        for argument in arguments {
            let inner = self.slope(argument, by)?;
            if !inner.is_zero() {
                terms.push(product([by_argument(function, arguments, known, argument)?, inner]));
            }
        }
        Ok(sum(terms))
    }

    /// ∂`expr`/∂`argument` of a function at arguments; none if it is not one of them.
    pub fn slope_by_argument(&self, expr: &Expr, argument: &Expr) -> Option<Result<Expr, Unresolved>> {
        let (function, known) = match expr.node() {
            Node::Partial(of, known) => (of, known.as_slice()),
            _ => (expr, &[][..]),
        };
        match function.node() {
            Node::Apply(_, arguments) if arguments.contains(argument) => {
                Some(by_argument(function, arguments, known, argument))
            }
            _ => None,
        }
    }

    /// The derivative of a field by coordinates, with what is given of it put in.
    fn field(&mut self, field: &Expr, mut by: Vec<Expr>) -> Result<Expr, Unresolved> {
        by.sort_by(|a, b| name(a).cmp(name(b)));
        let atom = Expr::new(Node::Partial(field.clone(), by.clone()));
        if let Some(known) = self.reduced.get(&atom) {
            return Ok(known.clone());
        }
        let rules = self.calculus.rules.iter().filter(|rule| rule.field == name(field));
        let Some((rule, rest)) = rules.filter_map(|rule| Some((rule, without(&by, rule)?))).next() else {
            return Ok(atom);
        };
        let reduced = self.opened(&atom, |this| {
            let mut value = this.given_slope(rule)?;
            for variable in &rest {
                if let Node::Symbol(variable) = variable.node() {
                    value = this.slope(&value, variable)?;
                }
            }
            Ok(value)
        })?;
        self.reduced.insert(atom, reduced.clone());
        Ok(reduced)
    }
}

/// The name of a field or a coordinate.
fn name(symbol: &Expr) -> &str {
    match symbol.node() {
        Node::Symbol(symbol) => symbol.name(),
        _ => "",
    }
}

/// The variables that are left when those of the rule are taken away; none if they are not all there.
fn without(by: &[Expr], rule: &Rule) -> Option<Vec<Expr>> {
    let mut rest = by.to_vec();
    for taken in &rule.by {
        let at = rest.iter().position(|variable| name(variable) == taken)?;
        rest.remove(at);
    }
    Some(rest)
}

/// The atom ∂f/∂u…, variables in the order of the arguments.
fn by_argument(function: &Expr, arguments: &[Expr], known: &[Expr], argument: &Expr) -> Result<Expr, Unresolved> {
    // ∂f(x, x²)/∂x could be read as a derivative by both.
    if arguments.iter().filter(|other| contains(other, argument)).count() > 1 {
        return Err(Unresolved::Entangled(face(function)));
    }
    let mut by: Vec<_> = known.iter().chain([argument]).cloned().collect();
    by.sort_by_key(|variable| arguments.iter().position(|argument| argument == variable));
    Ok(Expr::new(Node::Partial(function.clone(), by)))
}

fn contains(expr: &Expr, part: &Expr) -> bool {
    expr == part || expr.children().into_iter().any(|child| contains(child, part))
}

fn of_function(expr: &Expr, function: Function, of: &Expr, inner: Expr, by: &Symbol) -> Result<Expr, Unresolved> {
    let one_minus_square = || Expr::from(1) - of.pow(2);
    Ok(match function {
        Function::Sqrt => quotient(inner, 2 * expr),
        Function::Exp => product([expr.clone(), inner]),
        Function::Sin => product([cos(of), inner]),
        Function::Cos => negative(product([sin(of), inner])),
        Function::Tan => quotient(inner, cos(of).pow(2)),
        Function::Asin => quotient(inner, sqrt(one_minus_square())),
        Function::Acos => negative(quotient(inner, sqrt(one_minus_square()))),
        Function::Atan => quotient(inner, Expr::from(1) + of.pow(2)),
        _ if !symbol_is_real(by) => {
            return Err(Unresolved::NotReal { face: face(expr), variable: by.to_string() });
        }
        Function::Conj | Function::Re | Function::Im => Expr::new(Node::Function(function, inner)),
        Function::Abs => quotient(re(product([conj(of), inner])), abs(of)),
    })
}
