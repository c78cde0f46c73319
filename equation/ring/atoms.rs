//! The atoms that expressions are polynomials in, and the relations among them.

use super::fraction::{Arithmetic, Fraction, Result, Undecided};
use super::polynomial::{Atom, Monomial, Polynomial};
use crate::expr::Function;
use crate::symbol::Symbol;
use dashu_base::{Gcd, Signed, UnsignedAbs};
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
    kinds: Vec<Kind>,
    /// Base forms and the common denominator of the numbers they were met with.
    bases: Vec<(Base, u32)>,
    /// Whether a common denominator grew after atoms were made with it.
    pub is_stale: bool,
}

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
    pub fn kind(&self, atom: Atom) -> &Kind {
        &self.kinds[atom as usize]
    }

    /// The atom for `kind`, made with its relation where it is met for the first time.
    fn atom(&mut self, kind: Kind, relation: Option<(u32, Polynomial)>) -> Atom {
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
        let (sin, cos) = match self.of_inverse(&angle)? {
            Some(pair) => pair,
            None => {
                let cos = self.atom(Kind::Cos(angle.clone()), None);
                let square = Polynomial::term(Monomial::power(cos, 2), IBig::NEG_ONE).plus(&Polynomial::one());
                let sin = self.atom(Kind::Sin(angle), Some((2, square)));
                (Fraction::atom(sin), Fraction::atom(cos))
            }
        };
        let times = u32::try_from(multiple.clone().unsigned_abs()).map_err(|_| Undecided::TooLarge)?;
        if times > LARGEST_MULTIPLE {
            return Err(Undecided::TooLarge);
        }
        let (sin, cos) = self.of_multiple(&sin, &cos, times)?;
        Ok((if multiple.is_negative() { sin.negated() } else { sin }, cos))
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

    /// Whether it is a symbol that keeps between −1 and 1, or off the real axis beyond.
    fn is_below_one(&self, u: &Fraction) -> bool {
        let Some(Kind::Symbol(symbol)) = u.above.as_atom().filter(|_| u.is_whole()).map(|atom| self.kind(atom)) else {
            return false;
        };
        let (min, max) = symbol.domain().re;
        min >= -1.0 && max <= 1.0
    }

    /// Whether it is real by its form.
    fn is_real(&self, value: &Fraction) -> bool {
        let sums = std::iter::once(&value.above).chain(value.below.iter().map(|(factor, _)| factor));
        sums.into_iter().all(|sum| sum.atoms().into_iter().all(|atom| self.is_real_atom(atom)))
    }

    fn is_real_atom(&self, atom: Atom) -> bool {
        match self.kind(atom) {
            Kind::Pi => true,
            Kind::Symbol(symbol) => symbol.domain().im == (0.0, 0.0),
            Kind::Sin(angle) | Kind::Cos(angle) | Kind::Exp(angle) => {
                let base = &angle.of;
                self.is_real(&Fraction {
                    below: base.below.clone(),
                    ..Fraction::of(Polynomial::term(base.above.clone(), IBig::ONE))
                })
            }
            Kind::Root { of, .. } => self.is_positive(of),
            Kind::Imaginary | Kind::Leg(_) | Kind::Opaque(..) => false,
        }
    }

    /// Whether it is a product of positive numbers, symbols and roots of such.
    pub fn is_positive(&self, value: &Fraction) -> bool {
        value.above.content().is_positive()
            && value.is_product(|atom| match self.kind(atom) {
                Kind::Pi => true,
                Kind::Symbol(symbol) => symbol.domain().im == (0.0, 0.0) && symbol.domain().re.0 > 0.0,
                Kind::Root { of, .. } => self.is_positive(of),
                _ => false,
            })
    }

    /// What stands below the line, multiplied out.
    fn denominator(&mut self, of: &Fraction) -> Result<Polynomial> {
        let mut below = Polynomial::constant(of.number.clone());
        for (factor, power) in &of.below {
            let factor = self.arithmetic.power(factor, *power)?;
            below = self.arithmetic.product(&below, &factor)?;
        }
        Ok(below)
    }

    /// exp of a term without a factor i.
    pub fn exponential(&mut self, part: &Part) -> Result<Fraction> {
        let (angle, multiple) = self.multiple(part)?;
        let exp = Fraction::atom(self.atom(Kind::Exp(angle), None));
        let times = u32::try_from(multiple.clone().unsigned_abs()).map_err(|_| Undecided::TooLarge)?;
        let power = self.arithmetic.raise(&exp, times)?;
        if multiple.is_negative() { self.inverse(&power) } else { Ok(power) }
    }

    /// 1/`fraction` of something that is not zero.
    fn inverse(&mut self, fraction: &Fraction) -> Result<Fraction> {
        self.arithmetic.inverse(fraction)?.ok_or_else(|| Undecided::ZeroDenominator("0".to_owned()))
    }

    /// The principal root of `degree` ≥ 2. Factors come out of it where the branch allows: positive numbers and positive
    /// symbols always; symbols of bounded phase where nothing else is left in it and their phases stay below π together.
    pub fn root(&mut self, of: &Fraction, degree: u32) -> Result<Fraction> {
        if of.is_zero() {
            return Ok(Fraction::zero());
        }
        let content = of.above.content();
        let sum = of.above.divided(&of.above.common_monomial(), &content);
        let is_bare = sum.len() == 1 && of.below.iter().all(|(factor, _)| factor.as_atom().is_some());
        let powers = self.atom_powers(of);
        let phase: f64 = powers.iter().map(|&(atom, power)| power.unsigned_abs() as f64 * self.phase(atom)).sum();
        let all = is_bare && !content.is_negative() && phase < std::f64::consts::PI;
        let mut outside = Fraction::one();
        let mut inside = of.clone();
        for (atom, power) in powers {
            if all || self.phase(atom) == 0.0 {
                let taken = self.power(atom, -power)?;
                inside = self.arithmetic.times(&inside, &taken)?;
                let root = self.root_of_atom(atom, power, degree)?;
                outside = self.arithmetic.times(&outside, &root)?;
            }
        }
        let number = Fraction::number(IBig::from(content.clone().unsigned_abs()), of.number.clone());
        let inverse = self.inverse(&number)?;
        inside = self.arithmetic.times(&inside, &inverse)?;
        let root = self.root_of_number(&number, degree)?;
        outside = self.arithmetic.times(&outside, &root)?;
        let rest = self.plain_root(&inside, degree)?;
        self.arithmetic.times(&outside, &rest)
    }

    /// The powers of single atoms that all of `of` carries, negative below the line.
    fn atom_powers(&self, of: &Fraction) -> Vec<(Atom, i64)> {
        let common = of.above.common_monomial();
        let above = common.powers().iter().map(|&(atom, power)| (atom, i64::from(power)));
        let below = of.below.iter().filter_map(|(factor, power)| Some((factor.as_atom()?, -i64::from(*power))));
        above.chain(below).collect()
    }

    /// The largest |arg| of what an atom stands for [rad]; π if nothing is known.
    fn phase(&self, atom: Atom) -> f64 {
        match self.kind(atom) {
            Kind::Pi => 0.0,
            Kind::Symbol(symbol) if symbol.domain().re.0 > 0.0 => {
                let domain = symbol.domain();
                domain.im.0.abs().max(domain.im.1.abs()).atan2(domain.re.0)
            }
            Kind::Root { of, .. } if self.is_positive(of) => 0.0,
            _ => std::f64::consts::PI,
        }
    }

    /// Whether what an atom stands for is nowhere zero.
    pub fn never_vanishes(&self, atom: Atom) -> bool {
        match self.kind(atom) {
            Kind::Imaginary | Kind::Pi | Kind::Exp(_) => true,
            Kind::Symbol(symbol) => symbol.domain().excludes_zero(),
            Kind::Root { of, .. } => of.is_product(|atom| self.never_vanishes(atom)),
            Kind::Sin(_) | Kind::Cos(_) | Kind::Leg(_) | Kind::Opaque(..) => false,
        }
    }

    fn power(&mut self, atom: Atom, power: i64) -> Result<Fraction> {
        let exponent = u32::try_from(power.unsigned_abs()).map_err(|_| Undecided::TooLarge)?;
        let raised = self.arithmetic.raise(&Fraction::atom(atom), exponent)?;
        if power < 0 { self.inverse(&raised) } else { Ok(raised) }
    }

    /// The root of a power of an atom on which the root can be taken factor by factor.
    fn root_of_atom(&mut self, atom: Atom, power: i64, degree: u32) -> Result<Fraction> {
        let (whole, rest) = (power.div_euclid(i64::from(degree)), power.rem_euclid(i64::from(degree)));
        let whole = self.power(atom, whole)?;
        if rest == 0 {
            return Ok(whole);
        }
        let root = self.plain_root(&Fraction::atom(atom), degree)?;
        let root = self.arithmetic.raise(&root, rest as u32)?;
        self.arithmetic.times(&whole, &root)
    }

    /// The root of a positive number: squares come out, every prime keeps its own root.
    fn root_of_number(&mut self, number: &Fraction, degree: u32) -> Result<Fraction> {
        let (above, below) = (number.above.as_constant().unwrap_or(IBig::ONE), number.number.clone());
        let mut root = Fraction::one();
        for (value, is_below) in [(above, false), (below, true)] {
            for (prime, power) in factors(value) {
                let prime = Fraction::number(prime, IBig::ONE);
                let whole = self.arithmetic.raise(&prime, power / degree)?;
                let left = self.plain_root(&prime, degree)?;
                let left = self.arithmetic.raise(&left, power % degree)?;
                let mut factor = self.arithmetic.times(&whole, &left)?;
                if is_below {
                    factor = self.rationalised(&factor, &prime, power, degree)?;
                }
                root = self.arithmetic.times(&root, &factor)?;
            }
        }
        Ok(root)
    }

    /// 1/p^(n/q) as p^((q−n mod q)/q) over a whole number: roots below the line come above it.
    fn rationalised(&mut self, factor: &Fraction, prime: &Fraction, power: u32, degree: u32) -> Result<Fraction> {
        if power.is_multiple_of(degree) {
            return self.inverse(factor);
        }
        let left = self.plain_root(prime, degree)?;
        let above = self.arithmetic.raise(&left, degree - power % degree)?;
        let whole = self.arithmetic.raise(prime, power / degree + 1)?;
        let below = self.inverse(&whole)?;
        self.arithmetic.times(&above, &below)
    }

    /// The root as an atom, with its relation; of ±1 the number.
    fn plain_root(&mut self, of: &Fraction, degree: u32) -> Result<Fraction> {
        if of.is_one() {
            return Ok(Fraction::one());
        }
        if degree == 2 && *of == Fraction::one().negated() {
            return Ok(self.imaginary());
        }
        let below = self.denominator(of)?;
        let rest = self.arithmetic.power(&below, degree - 1)?;
        let equals = self.arithmetic.product(&of.above, &rest)?;
        let atom = self.atom(Kind::Root { of: of.clone(), degree }, Some((degree, equals)));
        let whole = self.inverse(&Fraction::of(below))?;
        self.arithmetic.times(&Fraction::atom(atom), &whole)
    }
}

/// The factors of a positive number: primes below 1000 and whatever is left, with their powers.
fn factors(mut value: IBig) -> Vec<(IBig, u32)> {
    let mut found = Vec::new();
    for candidate in 2..1000 {
        let candidate = IBig::from(candidate);
        let mut power = 0;
        while (&value % &candidate).is_zero() {
            value /= &candidate;
            power += 1;
        }
        if power > 0 {
            found.push((candidate, power));
        }
    }
    if value != IBig::ONE {
        found.push((value, 1));
    }
    found
}
