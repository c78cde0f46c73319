//! The atoms that expressions are polynomials in, and what is known of each.

use super::fraction::{Arithmetic, Fraction, Result, Undecided};
use super::polynomial::{Atom, Monomial, Polynomial};
use crate::expr::Function;
use crate::symbol::Symbol;
use dashu_base::Signed;
use dashu_int::IBig;

/// What an atom stands for.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Kind {
    /// i, with i² = −1.
    Imaginary,
    Pi,
    Symbol(Symbol),
    /// d·(n/d)^(1/q) of a fraction n/d, whose power q is n·d^(q−1): the factor d keeps it a polynomial's root without
    /// leaving the principal branch.
    Root {
        of: Fraction,
        degree: u32,
    },
    /// sin of an angle, with sin² = 1 − cos².
    Sin(Angle),
    Cos(Angle),
    /// e to the power of a real or complex form without a factor i.
    Exp(Angle),
    /// d·cos(arcsin(n/d)) or d·sin(arccos(n/d)), whose square is d² − n²: as √(1 − (n/d)²) off the branch cuts, where
    /// |n/d| > 1 is real, and of either sign on them.
    Leg(Fraction),
    /// A function of which nothing is known but that equal arguments give equal values.
    Opaque(Function, Fraction),
}

/// A base angle: the form over a whole number, so that every angle in sight is a whole multiple.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Angle {
    pub of: Base,
    pub over: u32,
}

/// A monomial over others: what the terms of an argument are numbers times of.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Base {
    pub above: Monomial,
    pub below: Vec<(Polynomial, u32)>,
}

/// Every atom met so far.
#[derive(Debug, Default)]
pub(super) struct Atoms {
    pub arithmetic: Arithmetic,
    pub kinds: Vec<Kind>,
    /// Base forms and the common denominator of the numbers they were met with.
    pub bases: Vec<(Base, u32)>,
    /// Whether a common denominator grew after atoms were made with it.
    pub is_stale: bool,
}

impl Atoms {
    pub fn kind(&self, atom: Atom) -> &Kind {
        &self.kinds[atom as usize]
    }

    /// The atom for `kind`, made with its relation where it is met for the first time.
    pub fn atom(&mut self, kind: Kind, relation: Option<(u32, Polynomial)>) -> Atom {
        if let Some(at) = self.kinds.iter().position(|known| *known == kind) {
            return at as Atom;
        }
        self.kinds.push(kind);
        self.arithmetic.new_atom(relation)
    }

    pub fn imaginary(&mut self) -> Fraction {
        let relation = Some((2, Polynomial::constant(IBig::NEG_ONE)));
        Fraction::atom(self.atom(Kind::Imaginary, relation))
    }

    pub fn pi(&mut self) -> Fraction {
        Fraction::atom(self.atom(Kind::Pi, None))
    }

    pub fn symbol(&mut self, symbol: &Symbol) -> Fraction {
        Fraction::atom(self.symbol_atom(symbol))
    }

    /// A symbol is known by its name alone.
    pub fn symbol_atom(&mut self, symbol: &Symbol) -> Atom {
        let same = |kind: &Kind| matches!(kind, Kind::Symbol(known) if known.name() == symbol.name());
        match self.kinds.iter().position(same) {
            Some(at) => at as Atom,
            None => self.atom(Kind::Symbol(symbol.clone()), None),
        }
    }

    pub fn opaque(&mut self, function: Function, of: &Fraction) -> Fraction {
        Fraction::atom(self.atom(Kind::Opaque(function, of.clone()), None))
    }

    /// Whether it is a symbol that keeps between −1 and 1, or off the real axis beyond.
    pub fn is_below_one(&self, u: &Fraction) -> bool {
        let Some(Kind::Symbol(symbol)) = u.above.as_atom().filter(|_| u.is_whole()).map(|atom| self.kind(atom)) else {
            return false;
        };
        let (min, max) = symbol.domain().re;
        min >= -1.0 && max <= 1.0
    }

    /// Whether it is real by its form.
    pub fn is_real(&self, value: &Fraction) -> bool {
        let sums = std::iter::once(&value.above).chain(value.below.iter().map(|(factor, _)| factor));
        sums.into_iter().all(|sum| sum.atoms().into_iter().all(|atom| self.is_real_atom(atom)))
    }

    pub fn is_real_atom(&self, atom: Atom) -> bool {
        match self.kind(atom) {
            Kind::Pi => true,
            Kind::Symbol(symbol) => symbol.domain().im == (0.0, 0.0),
            Kind::Sin(angle) | Kind::Cos(angle) | Kind::Exp(angle) => self.is_real_angle(angle),
            Kind::Root { of, .. } => self.is_positive(of),
            Kind::Opaque(Function::Sin | Function::Cos, of) => self.is_real(of),
            Kind::Imaginary | Kind::Leg(_) | Kind::Opaque(..) => false,
        }
    }

    fn is_real_angle(&self, angle: &Angle) -> bool {
        let base = &angle.of;
        self.is_real(&Fraction {
            below: base.below.clone(),
            ..Fraction::of(Polynomial::term(base.above.clone(), IBig::ONE))
        })
    }

    /// Whether it is made of positive numbers, symbols and roots of such by +, × and ÷ alone.
    pub fn is_positive(&self, value: &Fraction) -> bool {
        let is_positive = |(monomial, number): (&Monomial, &IBig)| {
            number.is_positive() && monomial.powers().iter().all(|(atom, _)| self.is_positive_atom(*atom))
        };
        let mut sums = std::iter::once(&value.above).chain(value.below.iter().map(|(factor, _)| factor));
        !value.is_zero() && sums.all(|sum| sum.terms().all(is_positive))
    }

    fn is_positive_atom(&self, atom: Atom) -> bool {
        match self.kind(atom) {
            Kind::Pi => true,
            Kind::Symbol(symbol) => symbol.domain().im == (0.0, 0.0) && symbol.domain().re.0 > 0.0,
            Kind::Exp(angle) => self.is_real_angle(angle),
            Kind::Root { of, .. } => self.is_positive(of),
            _ => false,
        }
    }

    /// What stands below the line, multiplied out.
    pub fn denominator(&mut self, of: &Fraction) -> Result<Polynomial> {
        let mut below = Polynomial::constant(of.number.clone());
        for (factor, power) in &of.below {
            let factor = self.arithmetic.power(factor, *power)?;
            below = self.arithmetic.product(&below, &factor)?;
        }
        Ok(below)
    }

    /// The largest |arg| of what an atom stands for [rad]; π if nothing is known.
    pub fn phase(&self, atom: Atom) -> f64 {
        match self.kind(atom) {
            Kind::Symbol(symbol) if symbol.domain().re.0 > 0.0 => {
                let domain = symbol.domain();
                domain.im.0.abs().max(domain.im.1.abs()).atan2(domain.re.0)
            }
            _ if self.is_positive_atom(atom) => 0.0,
            _ => std::f64::consts::PI,
        }
    }

    /// Whether what an atom stands for is nowhere zero.
    pub fn never_vanishes(&self, atom: Atom) -> bool {
        match self.kind(atom) {
            Kind::Imaginary | Kind::Pi | Kind::Exp(_) => true,
            Kind::Symbol(symbol) => symbol.domain().excludes_zero(),
            Kind::Root { of, .. } => of.is_product(|atom| self.never_vanishes(atom)),
            // Of a rational number but zero they are transcendental (Lindemann); multiples of π are no atoms of this kind.
            Kind::Sin(angle) | Kind::Cos(angle) => angle.of.above.is_one() && angle.of.below.is_empty(),
            Kind::Leg(_) | Kind::Opaque(..) => false,
        }
    }

    /// 1/`fraction` of something that is not zero.
    pub fn inverse(&mut self, fraction: &Fraction) -> Result<Fraction> {
        self.arithmetic.inverse(fraction)?.ok_or_else(|| Undecided::ZeroDenominator("0".to_owned()))
    }
}
