//! From normal forms back to expressions.

use super::atoms::{Angle, Kind};
use super::fraction::Fraction;
use super::normal::Normaliser;
use super::polynomial::{Atom, Monomial, Polynomial};
use crate::expr::{Expr, Function, cos, exp, i, pi, sin};
use crate::rational::Rational;
use dashu_base::{Signed, UnsignedAbs};
use dashu_int::IBig;

impl Normaliser {
    /// `fraction` as it is written: what all terms share stands in front; `None` where a number does not fit.
    pub fn expr(&self, fraction: &Fraction) -> Option<Expr> {
        let content = fraction.above.content();
        let (mut above, takes_sign) = self.product(&fraction.above, &content)?;
        let mut below: Vec<Expr> = Vec::new();
        let size = IBig::from(content.clone().unsigned_abs());
        if size != IBig::ONE {
            above.insert(0, number(&size)?);
        }
        if fraction.number != IBig::ONE {
            below.push(number(&fraction.number)?);
        }
        for (factor, power) in &fraction.below {
            let factor = match factor.as_atom() {
                Some(atom) => self.atom(atom)?,
                None => self.sum(factor)?,
            };
            below.push(raised(factor, *power));
        }
        let above = above.into_iter().reduce(|a, b| a * b).unwrap_or_else(|| Expr::from(1));
        let value = match below.into_iter().reduce(|a, b| a * b) {
            Some(below) => above / below,
            None => above,
        };
        if fraction.is_zero() {
            return Some(Expr::from(0));
        }
        Some(if content.is_negative() && !takes_sign { -value } else { value })
    }

    /// The factors of a polynomial over the size of its content, and whether a minus sign went into a sum among them:
    /// b − a rather than −(a − b).
    fn product(&self, sum: &Polynomial, content: &IBig) -> Option<(Vec<Expr>, bool)> {
        let common = sum.common_monomial();
        let mut rest = sum.divided(&common, content);
        let mut factors = self.monomial(&common)?;
        let takes_sign = content.is_negative() && rest.terms().any(|(_, c)| c.is_negative());
        if takes_sign {
            rest = rest.negated();
        }
        if rest.len() > 1 {
            factors.push(self.sum(&rest)?);
        }
        Some((factors, takes_sign))
    }

    /// Its terms; a positive one comes first if there is one.
    fn sum(&self, sum: &Polynomial) -> Option<Expr> {
        let mut total: Option<Expr> = None;
        let first = sum.terms().find(|(_, c)| c.is_positive());
        let rest = sum.terms().filter(|term| Some(*term) != first);
        for (monomial, coefficient) in first.into_iter().chain(rest) {
            let mut factors = self.monomial(monomial)?;
            let size = IBig::from(coefficient.clone().unsigned_abs());
            if size != IBig::ONE || factors.is_empty() {
                factors.insert(0, number(&size)?);
            }
            let term = factors.into_iter().reduce(|a, b| a * b)?;
            total = Some(match total {
                None if coefficient.is_negative() => -term,
                None => term,
                Some(total) if coefficient.is_negative() => total - term,
                Some(total) => total + term,
            });
        }
        total
    }

    /// Its factors: numbers and letters first, functions last.
    fn monomial(&self, monomial: &Monomial) -> Option<Vec<Expr>> {
        let is_function = |atom: Atom| !matches!(self.atoms.kind(atom), Kind::Imaginary | Kind::Pi | Kind::Symbol(_));
        let mut powers = monomial.powers().to_vec();
        powers.sort_by_key(|&(atom, _)| is_function(atom));
        powers.into_iter().map(|(atom, power)| Some(raised(self.atom(atom)?, power))).collect()
    }

    fn atom(&self, atom: Atom) -> Option<Expr> {
        Some(match self.atoms.kind(atom) {
            Kind::Imaginary => i(),
            Kind::Pi => pi(),
            Kind::Symbol(symbol) => symbol.into(),
            Kind::Sin(angle) => sin(self.angle(angle)?),
            Kind::Cos(angle) => cos(self.angle(angle)?),
            Kind::Exp(angle) => exp(self.angle(angle)?),
            Kind::Root { of, degree } => {
                let root = match *degree {
                    2 => Expr::function(Function::Sqrt, self.expr(of)?),
                    degree => self.expr(of)?.pow(Rational::new(1, i64::from(degree))?),
                };
                // The atom is the root times what stands below in it.
                let below = Fraction { above: Polynomial::one(), ..of.clone() };
                if below.is_one() { root } else { root / self.expr(&below)? }
            }
            Kind::Leg(of) => {
                let below = Fraction { above: Polynomial::one(), ..of.clone() };
                let cos = cos(Expr::function(Function::Asin, self.expr(of)?));
                if below.is_one() { cos } else { cos / self.expr(&below)? }
            }
            Kind::Opaque(function, of) => Expr::function(*function, self.expr(of)?),
        })
    }

    fn angle(&self, angle: &Angle) -> Option<Expr> {
        let above = Polynomial::term(angle.of.above.clone(), IBig::ONE);
        self.expr(&Fraction { above, number: IBig::from(angle.over), below: angle.of.below.clone() })
    }
}

fn raised(base: Expr, power: u32) -> Expr {
    if power == 1 { base } else { base.pow(Rational::integer(i64::from(power))) }
}

fn number(value: &IBig) -> Option<Expr> {
    i64::try_from(value).ok().map(|value| Expr::number(Rational::integer(value)))
}
