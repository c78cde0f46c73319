//! ∇, ∂, d and ∫, which have a grammar of their own.

use super::cursor::{Parser, Read};
use super::fault::{DEEPEST, Fault, fault};
use super::lex::Kind;
use super::part::{End, Part};
use crate::expr::{self, Expr, Nabla, Node, Range};

impl Parser<'_> {
    pub fn nabla(&mut self) -> Read {
        self.at += 1;
        let nabla = match self.kind() {
            Kind::Sign('·') => Nabla::Divergence,
            Kind::Sign('×') => Nabla::Curl,
            Kind::Raised(order) if order == "2" => Nabla::Laplacian,
            _ => Nabla::Gradient,
        };
        self.at += usize::from(nabla != Nabla::Gradient);
        let of = match self.kind() {
            Kind::Sign('∇') => self.deeper(Self::nabla)?,
            _ => self.raised()?,
        };
        let is_vector = match nabla {
            Nabla::Gradient | Nabla::Curl => true,
            Nabla::Divergence => false,
            Nabla::Laplacian => of.is_vector,
        };
        Ok(Part::new(Node::Nabla(nabla, of.expr.clone()), &[&of], is_vector))
    }

    /// ∂f/∂x, ∂²f/∂x², ∂²f/(∂x ∂y)
    pub fn derivative(&mut self) -> Read {
        let at = self.token(0).at;
        self.at += 1;
        let order = self.order()?;
        let of = self.raised()?;
        if !self.takes('/') {
            return Err(self.expected("a / and the variable of the derivative, as in ∂f/∂x,"));
        }
        let mut by = Vec::new();
        if let Kind::Open(closer) = *self.kind() {
            self.at += 1;
            while self.is_sign('∂') {
                self.variable(&mut by)?;
            }
            self.close(closer)?;
        } else {
            self.variable(&mut by)?;
        }
        if by.len() != order {
            let message = format!("expected the order {} above the line, as below, found {order}", by.len());
            return Err(fault(at, message));
        }
        let height = by.iter().chain([&of]).map(|part| part.height).max().unwrap_or(0) + 1;
        let is_vector = of.is_vector;
        let expr = by.into_iter().rev().fold(of.expr, |of, by| expr::partial(of, by.expr));
        Ok(Part { expr, height, is_vector, end: End::Slash })
    }

    /// ∂x or ∂x², which counts twice.
    fn variable(&mut self, by: &mut Vec<Part>) -> Result<(), Fault> {
        if !self.takes('∂') {
            return Err(self.expected("∂ and a variable"));
        }
        let variable = self.atom()?;
        let order = self.order()?;
        for _ in 0..order {
            by.push(Part { expr: variable.expr.clone(), ..variable });
        }
        Ok(())
    }

    /// The order of a derivative: 1 unless an exponent says otherwise.
    fn order(&mut self) -> Result<usize, Fault> {
        let at = self.token(0).at;
        let Some(exponent) = self.exponent()? else { return Ok(1) };
        let order = exponent.as_integer().and_then(|n| usize::try_from(n).ok());
        order.filter(|n| (1..=DEEPEST).contains(n)).ok_or_else(|| fault(at, "expected a whole number as the order"))
    }

    pub fn differential(&mut self) -> Read {
        self.at += 1;
        let of = self.raised()?;
        Ok(Part::new(Node::Differential(of.expr.clone()), &[&of], of.is_vector))
    }

    /// ∫ f dx dy, with bounds or a region.
    pub fn integral(&mut self, sign: char) -> Read {
        self.at += 1;
        let at = self.at;
        let lower = self.bound('_')?;
        let upper = self.bound('^')?;
        let bounds: Vec<_> = lower.iter().chain(&upper).map(|part| part.height).collect();
        let range = match (lower, upper) {
            (None, None) if sign == '∮' => Range::Closed,
            (None, None) => Range::Whole,
            (Some(_), _) if sign == '∮' => {
                return Err(fault(self.tokens[at].at, "expected no bounds on a closed integral"));
            }
            (Some(lower), None) => match lower.expr.node() {
                Node::Symbol(region) => Range::Region(region.clone()),
                _ => return Err(self.expected("an upper bound after ^, or a name as the region,")),
            },
            (Some(lower), Some(upper)) => Range::Between(lower.expr, upper.expr),
            (None, Some(_)) => return Err(fault(self.tokens[at].at, "expected a lower bound after _ as well")),
        };
        let outer = std::mem::replace(&mut self.in_integrand, true);
        if matches!(self.kind(), Kind::Sign('∫' | '∮')) {
            return Err(self.expected("the integral inside in brackets, or one ∫ with all its variables,"));
        }
        let of = self.product();
        self.in_integrand = outer;
        let of = of?;
        if of.end == End::Integral {
            return Err(self.fault("expected the integral inside in brackets"));
        }
        let mut by = Vec::new();
        while *self.kind() == Kind::Differential {
            self.at += 1;
            by.push(self.raised()?);
        }
        if matches!(range, Range::Between(..)) && by.len() != 1 {
            return Err(self.expected("one variable for the bounds, as in dx,"));
        }
        let height = by.iter().chain([&of]).map(|part| part.height).chain(bounds).max().unwrap_or(0) + 1;
        let by = by.into_iter().map(|part| part.expr).collect();
        let node = Node::Integral(of.expr, by, range);
        Ok(Part { expr: Expr::new(node), height, is_vector: of.is_vector, end: End::Integral })
    }

    /// A bound of an integral: small characters, or what stands after `mark`.
    fn bound(&mut self, mark: char) -> Result<Option<Part>, Fault> {
        let small = match self.kind() {
            Kind::Lowered(text) if mark == '_' => Some(text.clone()),
            Kind::Raised(text) if mark == '^' => Some(text.clone()),
            _ => None,
        };
        if let Some(text) = small {
            let within = |inner: Fault| fault(self.token(0).at + inner.column - 1, inner.message);
            let mut inner = Parser::new(&text, self.known).map_err(within)?;
            inner.depth = self.depth;
            let part = inner.sum().map_err(within)?;
            inner.end().map_err(within)?;
            self.at += 1;
            return Ok(Some(part));
        }
        if !self.takes(mark) {
            return Ok(None);
        }
        let is_negative = self.minus();
        let part = self.atom()?.negated(is_negative);
        let next = self.token(0);
        if !next.spaced && matches!(next.kind, Kind::Name(..) | Kind::Pi | Kind::Number(_) | Kind::Open(_)) {
            return Err(self.fault("expected a space, or the bound in brackets"));
        }
        Ok(Some(part))
    }
}
