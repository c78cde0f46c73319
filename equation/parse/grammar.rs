//! From tokens to an expression: sums of products of factors, by recursive descent.

use super::cursor::{Parser, Read};
use super::fault::{Fault, fault};
use super::lex::Kind;
use super::part::{End, Part, power, quotient, rational, symbol_part, value};
use crate::Relation;
use crate::expr::{self, Expr, Function, Node};
use crate::rational::Rational;
use crate::symbol::{Rank, Symbol};

impl Parser<'_> {
    /// A whole expression.
    pub fn expression(&mut self) -> Result<Expr, Fault> {
        self.sum().map(|part| part.expr)
    }

    /// The sign between two sides.
    pub fn relation(&mut self) -> Result<Relation, Fault> {
        let relation = match self.kind() {
            Kind::Sign('=') => Relation::Equal,
            Kind::Sign('≈') => Relation::Approximate,
            Kind::Sign('∝') => Relation::Proportional,
            _ => return Err(self.expected("= and the right side")),
        };
        self.at += 1;
        Ok(relation)
    }

    /// The end of the text.
    pub fn end(&mut self) -> Result<(), Fault> {
        match self.kind() {
            Kind::End => Ok(()),
            Kind::Sign('=' | '≈' | '∝') => Err(self.expected("one expression, or one = at most in an equation,")),
            _ => Err(self.expected("an operator or the end")),
        }
    }

    pub fn sum(&mut self) -> Read {
        let at = self.token(0).at;
        let is_negative = self.minus();
        let mut terms = vec![self.product()?.negated(is_negative)];
        while matches!(self.kind(), Kind::Sign('+' | '−')) {
            let is_negative = self.minus();
            terms.push(self.product()?.negated(is_negative));
        }
        self.checked(Part::of(terms, Expr::sum_of), at)
    }

    pub fn product(&mut self) -> Read {
        let at = self.token(0).at;
        let mut factors = self.factors()?;
        let mut is_vector = factors.iter().any(|factor| factor.is_vector);
        loop {
            let end = factors.last().expect("a factor").end;
            let sign = match self.kind() {
                Kind::Sign(sign @ ('/' | '*' | '·' | '×')) => Some(*sign),
                Kind::Differential if self.in_integrand => None,
                _ if self.starts_factor() => Some(' '),
                _ => None,
            };
            let Some(sign) = sign else { return self.checked(Part::of(factors, Expr::product_of), at) };
            let sign_at = self.token(0).at;
            self.may_follow(end, sign)?;
            self.at += usize::from(sign != ' ');
            let is_negative = sign != ' ' && self.minus();
            if sign == '/' {
                let (above, below) = (Part::of(factors, Expr::product_of), self.factor()?.negated(is_negative));
                factors = vec![self.checked(quotient(above, below), at)?];
                continue;
            }
            let mut more = self.factors()?;
            let first = more.remove(0).negated(is_negative);
            let is_more_vector = first.is_vector || more.iter().any(|factor| factor.is_vector);
            factors.extend(std::iter::once(first).chain(more));
            if is_vector && is_more_vector {
                return Err(fault(sign_at, "two vectors in a product: expected · or × between them, or brackets"));
            }
            is_vector |= is_more_vector;
        }
    }

    /// A factor; two vectors with · or × between them are one.
    fn factors(&mut self) -> Result<Vec<Part>, Fault> {
        let mut factors = vec![self.factor()?];
        let Kind::Sign(sign @ ('·' | '×')) = *self.kind() else { return Ok(factors) };
        let Some(a) = factors.pop_if(|factor| factor.is_vector) else { return Ok(factors) };
        self.at += 1;
        let is_negative = self.minus();
        let b = self.factor()?.negated(is_negative);
        if !b.is_vector {
            return Ok(vec![a, b]);
        }
        if matches!(self.kind(), Kind::Sign('·' | '×')) {
            return Err(self.fault("expected brackets in a product of three vectors"));
        }
        let (first, second) = (a.expr.clone(), b.expr.clone());
        let node = if sign == '·' { Node::Dot(first, second) } else { Node::Cross(first, second) };
        Ok(vec![Part::new(node, &[&a, &b], sign == '×').ending(b.end)])
    }

    /// Whether the next token begins a factor that is multiplied without a sign.
    fn starts_factor(&self) -> bool {
        match self.kind() {
            Kind::Number(_) | Kind::Name(..) | Kind::Function(_) | Kind::Pi | Kind::ImaginaryUnit | Kind::Euler => true,
            Kind::Differential | Kind::Open(_) | Kind::Sign('√' | '∇' | '∂' | '∫' | '∮') => true,
            // A bar closes the one before it, unless space tells otherwise: |x |y||.
            Kind::Sign('|') => self.closer != '|' || (self.token(0).spaced && self.opens_at(1)),
            _ => false,
        }
    }

    /// Whether the token `ahead` begins a factor and stands close to what is before it.
    fn opens_at(&self, ahead: usize) -> bool {
        let token = self.token(ahead);
        let is_end = matches!(token.kind, Kind::End | Kind::Close(_));
        let is_operator = matches!(token.kind, Kind::Sign('+' | '*' | '·' | '×' | '/' | '^' | ',' | '=' | '≈' | '∝'));
        !token.spaced && !is_end && !is_operator
    }

    /// Refuses a product or quotient whose left part could end in two places.
    fn may_follow(&self, end: End, sign: char) -> Result<(), Fault> {
        let next = if sign == ' ' { self.kind() } else { &self.token(1).kind };
        let is_trigonometric = matches!(next, Kind::Function(Function::Sin | Function::Cos | Function::Tan));
        let is_differential = *next == Kind::Differential;
        match end {
            _ if sign == ' ' && matches!(next, Kind::Number(_)) => {
                Err(self.expected("an operator: a number after a factor needs one,"))
            }
            End::Bare if is_trigonometric || is_differential || (sign == '/' && matches!(next, Kind::Open(_))) => {
                Ok(())
            }
            End::Bare | End::SlashBare => {
                Err(self.fault("what follows could belong to the function's argument: put that in brackets"))
            }
            End::Slash if sign == ' ' => Err(self.fault("a/b c could be (a/b) c or a/(b c): write the brackets")),
            End::Integral => Err(self.fault("expected +, − or the end after an integral: put it in brackets")),
            End::Closed | End::Slash => Ok(()),
        }
    }

    /// What is multiplied: a function's value, a root, a derivative, an integral, or something with an exponent.
    fn factor(&mut self) -> Read {
        let at = self.token(0).at;
        let part = match self.kind().clone() {
            Kind::Function(function) => self.call(function),
            Kind::Sign('√') => self.root(),
            Kind::Sign('∇') => self.deeper(Self::nabla),
            Kind::Sign('∂') => self.derivative(),
            Kind::Differential => self.differential(),
            Kind::Sign(sign @ ('∫' | '∮')) => self.deeper(|parser| parser.integral(sign)),
            _ => self.raised(),
        };
        self.checked(part?, at)
    }

    /// A function with its argument, in brackets or bare.
    fn call(&mut self, function: Function) -> Read {
        let word_at = self.token(0).at;
        self.at += 1;
        let exponent = self.exponent()?;
        if let Some(exponent) = exponent {
            let is_trigonometric = matches!(function, Function::Sin | Function::Cos | Function::Tan);
            let name = function.name();
            if !is_trigonometric {
                return Err(fault(word_at, format!("expected the exponent after the argument: {name}(x)^n")));
            }
            if exponent.is_negative() {
                let inverse = format!("{name}^{exponent} could be arc{name} or a reciprocal");
                return Err(fault(word_at, format!("{inverse}: write arc{name}(x) or {name}(x)^({exponent})")));
            }
        }
        let is_bracketed = matches!(self.kind(), Kind::Open(')' | ']' | '}') | Kind::Sign('|'));
        let of = if is_bracketed { self.atom()? } else { self.bare(function)? };
        let value = value(function, &of);
        if !is_bracketed {
            return Ok(power(value, exponent).ending(End::Bare));
        }
        match exponent {
            Some(_) if matches!(self.kind(), Kind::Raised(_) | Kind::Sign('^')) => {
                Err(self.fault("a second exponent: expected brackets around the power before it"))
            }
            Some(_) => Ok(power(value, exponent)),
            None => self.with_exponent(value),
        }
    }

    /// The bare argument of a function: a number, a name, or some that touch (2kz).
    fn bare(&mut self, function: Function) -> Read {
        let start = self.token(0).at;
        let mut factors = Vec::new();
        while factors.is_empty() || !self.token(0).spaced {
            let part = match self.kind().clone() {
                Kind::Number(value) => Part::leaf(value),
                Kind::Name(symbol, _) => symbol_part(&symbol),
                Kind::Pi => Part::leaf(expr::pi()),
                Kind::ImaginaryUnit => Part::leaf(expr::i()),
                _ => break,
            };
            self.at += 1;
            let exponent = self.exponent()?;
            factors.push(power(part, exponent));
        }
        let name = function.name();
        if factors.is_empty() {
            return Err(self.expected(&format!("an argument, as in {name}(x),")));
        }
        let touches = !self.token(0).spaced && matches!(self.kind(), Kind::Open(_) | Kind::Sign('^'));
        if touches || (function == Function::Sqrt && factors.len() > 1) {
            return Err(fault(start, format!("expected the argument of {name} in brackets")));
        }
        self.checked(Part::of(factors, Expr::product_of), start)
    }

    /// √ of a number, a name or a bracket.
    fn root(&mut self) -> Read {
        self.at += 1;
        let is_simple = match self.kind() {
            Kind::Number(_) | Kind::Name(..) | Kind::Pi | Kind::ImaginaryUnit => true,
            Kind::Open(_) | Kind::Sign('|') => false,
            _ => return Err(self.expected("a number, a name or a bracket after √")),
        };
        let at = self.at;
        let of = self.atom()?;
        let next = self.token(0);
        let touches = match next.kind {
            Kind::Raised(_) | Kind::Sign('^') => true,
            Kind::Number(_) | Kind::Name(..) | Kind::Pi | Kind::ImaginaryUnit | Kind::Open(_) => {
                !next.spaced && is_simple
            }
            _ => self.is_conjugate()?,
        };
        if touches || (is_simple && self.at > at + 1) {
            return Err(self.fault("expected brackets that show where the root ends, as in √(x²)"));
        }
        Ok(value(Function::Sqrt, &of))
    }

    /// An atom with its exponent, or the star of its conjugate.
    pub fn raised(&mut self) -> Read {
        if *self.kind() == Kind::Euler {
            return self.power_of_e();
        }
        let atom = self.atom()?;
        self.with_exponent(atom)
    }

    fn with_exponent(&mut self, of: Part) -> Read {
        if self.is_conjugate()? {
            self.at += 1;
            return Ok(value(Function::Conj, &of));
        }
        let exponent = self.exponent()?;
        if exponent.is_some() && matches!(self.kind(), Kind::Raised(_) | Kind::Sign('^')) {
            return Err(self.fault("a second exponent: expected brackets, (a^b)^c or a^(b^c)"));
        }
        let of = power(of, exponent);
        if exponent.is_some() && self.is_conjugate()? {
            return Err(self.fault("expected a factor after *, or brackets around what the star conjugates"));
        }
        Ok(of)
    }

    /// Whether the next token is the star of a conjugate: close to what is before it, and with no factor after it.
    fn is_conjugate(&self) -> Result<bool, Fault> {
        if !self.is_sign('*') || self.token(0).spaced {
            return Ok(false);
        }
        let [next, after] = [self.token(1), self.token(2)];
        let ambiguous = || self.fault("a* b could be a times b or the conjugate of a: write a*b or conj(a)");
        match next.kind {
            Kind::End | Kind::Close(_) | Kind::Sign('/' | '·' | '×' | ',' | '=' | '≈' | '∝' | '*' | '^') => {
                Ok(true)
            }
            Kind::Raised(_) | Kind::Lowered(_) => Ok(true),
            Kind::Sign('|') if self.closer == '|' && !next.spaced => Ok(!self.opens_at(2)),
            Kind::Sign('+' | '−') if next.spaced && after.spaced => Ok(true),
            Kind::Differential if self.in_integrand && next.spaced => Ok(true),
            _ if next.spaced => Err(ambiguous()),
            _ => Ok(false),
        }
    }

    /// An exponent, if there is one.
    pub fn exponent(&mut self) -> Result<Option<Rational>, Fault> {
        let at = self.token(0).at;
        if let Kind::Raised(text) = self.kind() {
            let value = text.parse().ok().and_then(|n| Rational::new(n, 1));
            self.at += 1;
            return value.map(Some).ok_or_else(|| fault(at, "expected an exponent of up to 18 digits"));
        }
        if !self.takes('^') {
            return Ok(None);
        }
        let at = self.token(0).at;
        let is_negative = self.minus();
        let value = match self.kind() {
            Kind::Number(_) | Kind::Open(_) => self.atom()?.negated(is_negative),
            _ => return Err(self.expected("a rational number as the exponent; only e^x takes others;")),
        };
        let value = rational(&value.expr);
        value.map(Some).ok_or_else(|| fault(at, "expected a rational number as the exponent, such as 2, −1 or (3/2)"))
    }

    /// e, eˣ
    fn power_of_e(&mut self) -> Read {
        self.at += 1;
        let of = if self.takes('^') {
            let is_negative = self.minus();
            let of = match self.kind() {
                Kind::Number(_) | Kind::Name(..) | Kind::Pi | Kind::ImaginaryUnit | Kind::Open(_) => {
                    self.deeper(Self::atom)?
                }
                _ => return Err(self.expected("an exponent, as in e^x or e^(2x),")),
            };
            let next = self.token(0);
            let touches = !next.spaced
                && matches!(
                    next.kind,
                    Kind::Name(..) | Kind::Number(_) | Kind::Pi | Kind::ImaginaryUnit | Kind::Open(_)
                );
            if touches || matches!(next.kind, Kind::Raised(_) | Kind::Sign('^')) {
                return Err(self.fault("expected brackets around the exponent of e, as in e^(2x)"));
            }
            of.negated(is_negative)
        } else {
            Part::leaf(self.exponent()?.unwrap_or(Rational::ONE))
        };
        Ok(value(Function::Exp, &of))
    }

    pub fn atom(&mut self) -> Read {
        let at = self.token(0).at;
        let part = match self.kind().clone() {
            Kind::Number(value) => Part::leaf(value),
            Kind::Pi => Part::leaf(expr::pi()),
            Kind::ImaginaryUnit => Part::leaf(expr::i()),
            Kind::Name(symbol, is_known) => {
                self.at += 1;
                let touches = matches!(self.kind(), Kind::Open(')' | ']' | '}')) && !self.token(0).spaced;
                return match (touches, is_known) {
                    (false, _) => Ok(symbol_part(&symbol)),
                    (true, true) => self.deeper(|parser| parser.value_at(&symbol)),
                    (true, false) => {
                        let message = format!("{symbol}(…) could be a value of the function {symbol}");
                        Err(self.fault(format!("{message}, which is not known: for a product write {symbol}*(…)")))
                    }
                };
            }
            // What ∇, ∂ and d act on: ∇exp(x).
            Kind::Function(function) if matches!(self.token(1).kind, Kind::Open(_)) => {
                self.at += 1;
                let of = self.deeper(Self::atom)?;
                return self.checked(value(function, &of), at);
            }
            Kind::Open(closer) => return self.deeper(|parser| parser.bracket(closer)),
            Kind::Sign('|') => return self.deeper(Self::magnitude),
            Kind::Euler => {
                let of = Part::leaf(1);
                value(Function::Exp, &of)
            }
            _ => return Err(self.expected("an expression")),
        };
        self.at += 1;
        self.checked(part, at)
    }

    /// (a), ⟨a⟩, or the vector (a, b, c).
    fn bracket(&mut self, closer: char) -> Read {
        let at = self.token(0).at;
        let mut items = self.list(closer)?;
        match (items.len(), closer) {
            (1, '⟩') => {
                let of = items.remove(0);
                Ok(Part::new(Node::Mean(of.expr.clone()), &[&of], of.is_vector))
            }
            (1, _) => Ok(items.remove(0).ending(End::Closed)),
            (3, ')' | ']' | '}') => {
                let [x, y, z] = <[Part; 3]>::try_from(items).unwrap_or_else(|_| unreachable!("three items"));
                let node = Node::Vector([x.expr.clone(), y.expr.clone(), z.expr.clone()]);
                self.checked(Part::new(node, &[&x, &y, &z], true), at)
            }
            (count, _) => Err(fault(at, format!("expected one expression or three components, found {count}"))),
        }
    }

    fn value_at(&mut self, symbol: &Symbol) -> Read {
        let Kind::Open(closer) = *self.kind() else { return Err(self.expected("a bracket")) };
        let at = self.token(0).at;
        let arguments = self.list(closer)?;
        let height = arguments.iter().map(|part| part.height).max().unwrap_or(0) + 1;
        let node = Node::Apply(symbol.clone(), arguments.into_iter().map(|part| part.expr).collect());
        let part = Part { expr: Expr::new(node), height, is_vector: symbol.rank() == Rank::Vector, end: End::Closed };
        self.checked(part, at)
    }

    /// |a|
    fn magnitude(&mut self) -> Read {
        self.at += 1;
        let of = self.within('|', Self::sum)?;
        if !self.takes('|') {
            return Err(self.expected("an operator or a closing |"));
        }
        Ok(value(Function::Abs, &of))
    }

    /// What stands in a bracket, between commas.
    fn list(&mut self, closer: char) -> Result<Vec<Part>, Fault> {
        self.at += 1;
        let mut items = Vec::new();
        loop {
            items.push(self.within(closer, Self::sum)?);
            if !self.takes(',') {
                self.close(closer)?;
                return Ok(items);
            }
        }
    }
}
