//! Sines, cosines and exponentials: angles taken apart into whole multiples of base angles.

use super::atoms::{Angle, Atoms, Base, Kind};
use super::fraction::{Fraction, Result, Undecided};
use super::polynomial::{Atom, Monomial, Polynomial};
use crate::expr::Function;
use dashu_base::{Gcd, Signed, UnsignedAbs};
use dashu_int::IBig;

/// A term of an angle: a number times a base form, perhaps times i.
pub(super) struct Part {
    pub numerator: IBig,
    pub denominator: IBig,
    pub is_imaginary: bool,
    pub base: Base,
}

/// The largest whole multiple of a base angle that is expanded.
const LARGEST_MULTIPLE: u32 = 128;

impl Atoms {
    /// The terms of `angle`.
    pub fn parts(&mut self, angle: &Fraction) -> Vec<Part> {
        let imaginary = self.kinds.iter().position(|kind| *kind == Kind::Imaginary).map(|at| at as Atom);
        let part = |(monomial, coefficient): (&Monomial, &IBig)| {
            let divisor = IBig::from(coefficient.gcd(&angle.number));
            let mut above = monomial.clone();
            let is_imaginary = imaginary.is_some_and(|i| above.exponent(i) == 1);
            if is_imaginary {
                above = above.with(imaginary.unwrap_or_default(), 0);
            }
            let mut below = Vec::new();
            for (factor, power) in &angle.below {
                let both = factor.as_atom().map_or(0, |atom| above.exponent(atom).min(*power));
                if let (Some(atom), true) = (factor.as_atom(), both > 0) {
                    above = above.with(atom, above.exponent(atom) - both);
                }
                if *power > both {
                    below.push((factor.clone(), power - both));
                }
            }
            let base = Base { above, below };
            Part { numerator: coefficient / &divisor, denominator: &angle.number / divisor, is_imaginary, base }
        };
        angle.above.terms().map(part).collect()
    }

    /// The base angle of `part` and the multiple of it that `part` is.
    fn multiple(&mut self, part: &Part) -> Result<(Angle, IBig)> {
        let denominator = u32::try_from(&part.denominator).map_err(|_| Undecided::TooLarge)?;
        let at = match self.bases.iter().position(|(base, _)| *base == part.base) {
            Some(at) => at,
            None => {
                self.bases.push((part.base.clone(), denominator));
                self.bases.len() - 1
            }
        };
        let known = self.bases[at].1;
        if !known.is_multiple_of(denominator) {
            let common = known / known.gcd(denominator);
            self.bases[at].1 = common.checked_mul(denominator).ok_or(Undecided::TooLarge)?;
            self.is_stale = true;
        }
        let over = self.bases[at].1;
        Ok((Angle { of: part.base.clone(), over }, &part.numerator * IBig::from(over / denominator)))
    }

    /// sin and cos of a term without a factor i.
    pub fn sine_cosine(&mut self, part: &Part) -> Result<(Fraction, Fraction)> {
        if let Some(pair) = self.of_pi(part)? {
            return Ok(pair);
        }
        let (angle, multiple) = self.multiple(part)?;
        if multiple.clone().unsigned_abs() > LARGEST_MULTIPLE.into() {
            return self.whole_sine_cosine(part);
        }
        let (sin, cos) = match self.of_inverse(&angle)? {
            Some(pair) => pair,
            None => self.pair(Kind::Sin(angle.clone()), Kind::Cos(angle)),
        };
        let times = u32::try_from(multiple.clone().unsigned_abs()).map_err(|_| Undecided::TooLarge)?;
        let (sin, cos) = self.of_multiple(&sin, &cos, times)?;
        Ok((if multiple.is_negative() { sin.negated() } else { sin }, cos))
    }

    /// sin and cos of a term with too large a number to be expanded: known by that term alone.
    fn whole_sine_cosine(&mut self, part: &Part) -> Result<(Fraction, Fraction)> {
        let number = IBig::from(part.numerator.clone().unsigned_abs());
        let of = Fraction {
            above: Polynomial::term(part.base.above.clone(), number),
            number: part.denominator.clone(),
            below: part.base.below.clone(),
        };
        let (sin, cos) = self.pair(Kind::Opaque(Function::Sin, of.clone()), Kind::Opaque(Function::Cos, of));
        Ok((if part.numerator.is_negative() { sin.negated() } else { sin }, cos))
    }

    /// Two atoms, the first with sin² = 1 − cos².
    fn pair(&mut self, sin: Kind, cos: Kind) -> (Fraction, Fraction) {
        let cos = self.atom(cos, None);
        let square = Polynomial::term(Monomial::power(cos, 2), IBig::NEG_ONE).plus(&Polynomial::one());
        (Fraction::atom(self.atom(sin, Some((2, square)))), Fraction::atom(cos))
    }

    /// sin nα and cos nα, angle after angle.
    fn of_multiple(&mut self, sin: &Fraction, cos: &Fraction, times: u32) -> Result<(Fraction, Fraction)> {
        let mut total = (Fraction::zero(), Fraction::one());
        for _ in 0..times {
            total = self.of_sum(&total, &(sin.clone(), cos.clone()))?;
        }
        Ok(total)
    }

    /// sin and cos of a sum from those of the terms.
    pub fn of_sum(&mut self, a: &(Fraction, Fraction), b: &(Fraction, Fraction)) -> Result<(Fraction, Fraction)> {
        let ring = &mut self.arithmetic;
        let (sc, cs) = (ring.times(&a.0, &b.1)?, ring.times(&a.1, &b.0)?);
        let (cc, ss) = (ring.times(&a.1, &b.1)?, ring.times(&a.0, &b.0)?.negated());
        Ok((ring.plus(&sc, &cs)?, ring.plus(&cc, &ss)?))
    }

    /// sin and cos of a multiple of π/12: multiples of π/4 and π/3 added.
    fn of_pi(&mut self, part: &Part) -> Result<Option<(Fraction, Fraction)>> {
        let is_pi = match part.base.above.powers() {
            [(atom, 1)] => part.base.below.is_empty() && *self.kind(*atom) == Kind::Pi,
            _ => false,
        };
        let Ok(denominator) = u32::try_from(&part.denominator) else { return Ok(None) };
        if !is_pi || 12 % denominator != 0 {
            return Ok(None);
        }
        let twelfths = &part.numerator * IBig::from(12 / denominator);
        let turn = IBig::from(24);
        let twelfths = ((twelfths % &turn) + &turn) % turn;
        let twelfths = i32::try_from(&twelfths).map_err(|_| Undecided::TooLarge)?;
        // 12ths = 4·(thirds) + 3·(quarters)
        let quarters = (0..4).find(|quarters| (twelfths - 3 * quarters) % 4 == 0).unwrap_or(0);
        let thirds = (twelfths - 3 * quarters).div_euclid(4).rem_euclid(6);
        let half = Fraction::number(IBig::ONE, IBig::from(2));
        let root = |this: &mut Self, of: i32| {
            let root = this.root(&Fraction::number(IBig::from(of), IBig::ONE), 2)?;
            this.arithmetic.times(&root, &half)
        };
        let third = (root(self, 3)?, half.clone());
        let quarter = root(self, 2)?;
        let a = self.of_multiple(&third.0, &third.1, thirds as u32)?;
        let b = self.of_multiple(&quarter, &quarter, quarters as u32)?;
        self.of_sum(&a, &b).map(Some)
    }

    /// sin and cos of arcsin u, arccos u and arctan u as they are.
    fn of_inverse(&mut self, angle: &Angle) -> Result<Option<(Fraction, Fraction)>> {
        let [(atom, 1)] = angle.of.above.powers() else { return Ok(None) };
        if !angle.of.below.is_empty() || angle.over != 1 {
            return Ok(None);
        }
        let Kind::Opaque(function, u) = self.kind(*atom).clone() else { return Ok(None) };
        match function {
            Function::Asin => Ok(Some((u.clone(), self.leg(&u)?))),
            Function::Acos => Ok(Some((self.leg(&u)?, u))),
            // On the cuts of arctan u is imaginary.
            Function::Atan if self.is_real(&u) => {
                let square = self.arithmetic.times(&u, &u)?;
                let sum = self.arithmetic.plus(&Fraction::one(), &square)?;
                let root = self.root(&sum, 2)?;
                let cos = self.inverse(&root)?;
                Ok(Some((self.arithmetic.times(&u, &cos)?, cos)))
            }
            _ => Ok(None),
        }
    }

    /// The cosine of arcsin u, which is the sine of arccos u.
    fn leg(&mut self, u: &Fraction) -> Result<Fraction> {
        if self.is_below_one(u) {
            let square = self.arithmetic.times(u, u)?;
            let rest = self.arithmetic.plus(&Fraction::one(), &square.negated())?;
            return self.root(&rest, 2);
        }
        let below = self.denominator(u)?;
        let (d, n) = (self.arithmetic.product(&below, &below)?, self.arithmetic.product(&u.above, &u.above)?);
        let atom = self.atom(Kind::Leg(u.clone()), Some((2, d.plus(&n.negated()))));
        let inverse = self.inverse(&Fraction::of(below))?;
        self.arithmetic.times(&Fraction::atom(atom), &inverse)
    }

    /// exp of a term without a factor i.
    pub fn exponential(&mut self, part: &Part) -> Result<Fraction> {
        let (angle, multiple) = self.multiple(part)?;
        let exp = Fraction::atom(self.atom(Kind::Exp(angle), None));
        let times = u32::try_from(multiple.clone().unsigned_abs()).map_err(|_| Undecided::TooLarge)?;
        let power = self.arithmetic.raise(&exp, times)?;
        if multiple.is_negative() { self.inverse(&power) } else { Ok(power) }
    }
}
