//! Quotients of polynomials, and the arithmetic that applies the atoms' relations.

use super::polynomial::{Atom, Monomial, Polynomial};
use dashu_base::{BitTest, Gcd, Signed, SquareRoot, UnsignedAbs};
use dashu_int::IBig;

/// A polynomial over a product of others. Nothing is cancelled but numbers, single atoms and equal factors: whether a
/// difference vanishes can be read off its numerator all the same.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Fraction {
    pub above: Polynomial,
    /// The whole number below the line, ≥ 1.
    pub number: IBig,
    /// The other factors below the line and their powers, ascending: single atoms, and sums without a common factor whose
    /// first term is positive.
    pub below: Vec<(Polynomial, u32)>,
}

/// Why no normal form was reached.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Undecided {
    /// It has more terms, longer numbers or deeper nesting than the decider takes on.
    TooLarge,
    /// A denominator that is zero whatever the symbols' values. Its face in Unicode.
    ZeroDenominator(String),
    /// Something that is not an algebraic form of numbers and symbols. Its face in Unicode.
    NotAlgebraic(String),
}

impl std::fmt::Display for Undecided {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            Self::TooLarge => write!(f, "the normal form is too large"),
            Self::ZeroDenominator(face) => write!(f, "{face} is zero wherever it is defined"),
            Self::NotAlgebraic(face) => write!(f, "{face} is not a number by itself"),
        }
    }
}

impl std::error::Error for Undecided {}

pub(super) type Result<T> = std::result::Result<T, Undecided>;

impl Fraction {
    pub fn of(above: Polynomial) -> Self {
        Self { above, number: IBig::ONE, below: Vec::new() }
    }

    pub fn zero() -> Self {
        Self::of(Polynomial::zero())
    }

    pub fn one() -> Self {
        Self::of(Polynomial::one())
    }

    pub fn atom(atom: Atom) -> Self {
        Self::of(Polynomial::atom(atom))
    }

    pub fn number(numerator: IBig, denominator: IBig) -> Self {
        Self { above: Polynomial::constant(numerator), number: denominator, below: Vec::new() }.lowest()
    }

    pub fn is_zero(&self) -> bool {
        self.above.is_zero()
    }

    pub fn is_one(&self) -> bool {
        self.is_whole() && self.above == Polynomial::one()
    }

    /// Whether nothing stands below the line.
    pub fn is_whole(&self) -> bool {
        self.below.is_empty() && self.number == IBig::ONE
    }

    /// Whether it is a product of numbers and atoms, all of which `are`.
    pub fn is_product(&self, are: impl Fn(Atom) -> bool) -> bool {
        let sums = std::iter::once(&self.above).chain(self.below.iter().map(|(factor, _)| factor));
        sums.into_iter().all(|sum| sum.len() == 1 && sum.atoms().into_iter().all(&are))
    }

    pub fn negated(&self) -> Self {
        Self { above: self.above.negated(), ..self.clone() }
    }

    /// Without the numbers, atoms and factors that stand on both sides of the line.
    fn lowest(mut self) -> Self {
        if self.above.is_zero() {
            return Self::zero();
        }
        // A sum below that is also above leaves a single term there, so this happens once at most.
        for (factor, power) in &mut self.below {
            if let Some(term) = multiple(&self.above, factor) {
                self.above = term;
                *power -= 1;
                break;
            }
        }
        let shared = IBig::from(self.above.content().gcd(&self.number));
        let common = self.above.common_monomial();
        let mut cancelled = Monomial::default();
        for (factor, power) in &mut self.below {
            if let Some(atom) = factor.as_atom() {
                let both = common.exponent(atom).min(*power);
                *power -= both;
                cancelled = cancelled.with(atom, both);
            }
        }
        if shared != IBig::ONE || !cancelled.is_one() {
            self.above = self.above.divided(&cancelled, &shared);
            self.number /= shared;
        }
        self.below.retain(|(_, power)| *power > 0);
        self
    }
}

/// The single term t with `of` = t · `factor` for a sum `factor`, if there is one.
fn multiple(of: &Polynomial, factor: &Polynomial) -> Option<Polynomial> {
    if factor.len() < 2 || of.len() != factor.len() {
        return None;
    }
    let (common, content) = (of.common_monomial(), of.content());
    let primitive = of.divided(&common, &content);
    (primitive == *factor).then(|| Polynomial::term(common, content))
}

/// What may be computed before giving up [products of terms], and how long a coefficient may become [bits].
const WORK: usize = 500_000;
const LONGEST: usize = 4096;

/// Arithmetic under relations: an atom whose power `degree` equals a polynomial in other atoms.
#[derive(Debug, Default)]
pub(super) struct Arithmetic {
    relations: Vec<Option<Relation>>,
    work: usize,
}

#[derive(Clone, Debug)]
struct Relation {
    degree: u32,
    /// Powers 1, 2, … of what stands for it.
    powers: Vec<Polynomial>,
}

impl Arithmetic {
    /// A new atom, perhaps with aᵈ = a polynomial in atoms that came before.
    pub fn new_atom(&mut self, relation: Option<(u32, Polynomial)>) -> Atom {
        self.relations.push(relation.map(|(degree, equals)| Relation { degree, powers: vec![equals] }));
        (self.relations.len() - 1) as Atom
    }

    pub fn spend(&mut self, work: usize) -> Result<()> {
        self.work += work;
        if self.work > WORK { Err(Undecided::TooLarge) } else { Ok(()) }
    }

    /// The part of `monomial` that a relation applies to.
    fn reducible(&self, monomial: &Monomial) -> Option<(Atom, u32, u32)> {
        monomial.powers().iter().rev().find_map(|&(atom, exponent)| {
            let degree = self.relations[atom as usize].as_ref()?.degree;
            (exponent >= degree).then_some((atom, exponent, degree))
        })
    }

    fn add(&mut self, sum: &mut Polynomial, monomial: Monomial, coefficient: IBig) -> Result<()> {
        self.spend(1)?;
        if coefficient.bit_len() > LONGEST {
            return Err(Undecided::TooLarge);
        }
        let Some((atom, exponent, degree)) = self.reducible(&monomial) else {
            sum.add(monomial, coefficient);
            return Ok(());
        };
        let power = self.relation_power(atom, exponent / degree)?;
        let rest = monomial.with(atom, exponent % degree);
        for (m, c) in power.terms() {
            self.add(sum, rest.times(m).ok_or(Undecided::TooLarge)?, &coefficient * c)?;
        }
        Ok(())
    }

    /// What stands for the `power` of the reducible power of `atom`.
    fn relation_power(&mut self, atom: Atom, power: u32) -> Result<Polynomial> {
        let powers = |this: &Self| this.relations[atom as usize].as_ref().map_or(0, |relation| relation.powers.len());
        while powers(self) < power as usize {
            let Some(relation) = &self.relations[atom as usize] else { break };
            let (first, last) = (relation.powers[0].clone(), relation.powers[relation.powers.len() - 1].clone());
            let next = self.product(&first, &last)?;
            if let Some(relation) = &mut self.relations[atom as usize] {
                relation.powers.push(next);
            }
        }
        let relation = self.relations[atom as usize].as_ref().ok_or(Undecided::TooLarge)?;
        Ok(relation.powers[power as usize - 1].clone())
    }

    pub fn product(&mut self, a: &Polynomial, b: &Polynomial) -> Result<Polynomial> {
        let mut product = Polynomial::zero();
        for (m, c) in a.terms() {
            for (n, d) in b.terms() {
                self.add(&mut product, m.times(n).ok_or(Undecided::TooLarge)?, c * d)?;
            }
        }
        Ok(product)
    }

    pub fn power(&mut self, base: &Polynomial, exponent: u32) -> Result<Polynomial> {
        if let Some((monomial, coefficient)) = base.as_term() {
            if coefficient.bit_len().saturating_sub(1).saturating_mul(exponent as usize) > LONGEST {
                return Err(Undecided::TooLarge);
            }
            let monomial = monomial.to_the(exponent).ok_or(Undecided::TooLarge)?;
            // ±1 to any power, or a number short enough.
            let coefficient = match coefficient.bit_len() {
                1 if coefficient.is_negative() && exponent % 2 == 1 => IBig::NEG_ONE,
                1 => IBig::ONE,
                _ => coefficient.pow(exponent as usize),
            };
            let mut power = Polynomial::zero();
            self.add(&mut power, monomial, coefficient)?;
            return Ok(power);
        }
        if base.is_zero() && exponent > 0 {
            return Ok(Polynomial::zero());
        }
        // A sum to a power that no lecture needs would cost all the work before it fails.
        if exponent > 1000 {
            return Err(Undecided::TooLarge);
        }
        let mut power = Polynomial::one();
        for _ in 0..exponent {
            power = self.product(&power, base)?;
        }
        Ok(power)
    }

    pub fn plus(&mut self, a: &Fraction, b: &Fraction) -> Result<Fraction> {
        if a.is_zero() {
            return Ok(b.clone());
        }
        if b.is_zero() {
            return Ok(a.clone());
        }
        if a.number == b.number && a.below == b.below {
            self.spend(b.above.len())?;
            return Ok(Fraction { above: a.above.clone().plus(&b.above), ..a.clone() }.lowest());
        }
        let shared = IBig::from((&a.number).gcd(&b.number));
        let below = union(&a.below, &b.below, u32::max);
        let left = self.raised(a, &(&b.number / &shared), &below)?;
        let right = self.raised(b, &(&a.number / &shared), &below)?;
        let number = &a.number / &shared * &b.number;
        Ok(Fraction { above: left.plus(&right), number, below }.lowest())
    }

    /// The numerator of `fraction` over a common denominator.
    fn raised(&mut self, fraction: &Fraction, number: &IBig, below: &[(Polynomial, u32)]) -> Result<Polynomial> {
        let mut above = fraction.above.scaled(number);
        for (factor, power) in below {
            let own = fraction.below.iter().find(|(own, _)| own == factor).map_or(0, |(_, power)| *power);
            if *power > own {
                let missing = self.power(factor, power - own)?;
                above = self.product(&above, &missing)?;
            }
        }
        Ok(above)
    }

    pub fn times(&mut self, a: &Fraction, b: &Fraction) -> Result<Fraction> {
        if a.is_one() {
            return Ok(b.clone());
        }
        if b.is_one() {
            return Ok(a.clone());
        }
        let number = &a.number * &b.number;
        if number.bit_len() > LONGEST {
            return Err(Undecided::TooLarge);
        }
        // What one of them has below and the other above need not be multiplied out.
        let (a, b) = (without_shared(a, b), without_shared(b, a));
        let below = union(&a.below, &b.below, u32::saturating_add);
        Ok(Fraction { above: self.product(&a.above, &b.above)?, number: a.number * b.number, below }.lowest())
    }

    /// `sum` over `divisor` where that is a polynomial, by long division.
    pub fn quotient(&mut self, sum: &Polynomial, divisor: &Polynomial) -> Result<Option<Polynomial>> {
        let Some((lead, number)) = divisor.first() else { return Ok(None) };
        let (mut rest, mut quotient) = (sum.clone(), Polynomial::zero());
        // A round removes the first term and makes none before it, unless a relation interferes.
        let mut last = None;
        while let Some((monomial, coefficient)) = rest.first() {
            let is_multiple = lead.powers().iter().all(|&(atom, power)| monomial.exponent(atom) >= power);
            let is_later = last.as_ref().is_none_or(|last| monomial > *last);
            if !is_multiple || !is_later || !(&coefficient % &number).is_zero() {
                return Ok(None);
            }
            let factor = Polynomial::term(monomial.over(&lead), coefficient / &number);
            last = Some(monomial);
            let removed = self.product(&factor, divisor)?;
            rest = rest.plus(&removed.negated());
            quotient = quotient.plus(&factor);
        }
        Ok(Some(quotient))
    }

    /// The sum whose square is `square`, if there is one; its first coefficient is positive. Term after term, as on paper.
    pub fn square_root(&mut self, square: &Polynomial) -> Result<Option<Polynomial>> {
        let Some((lead, number)) = square.first() else { return Ok(None) };
        if number.is_negative() || lead.powers().iter().any(|(_, power)| power % 2 == 1) {
            return Ok(None);
        }
        let half = IBig::from(number.unsigned_abs().sqrt());
        let halved = lead.powers().iter().fold(Monomial::default(), |half, &(atom, power)| half.with(atom, power / 2));
        let (first, twice) = (halved.clone(), &half * IBig::from(2));
        let mut root = Polynomial::term(halved, half);
        // Each round finds one more term; a square has at least as many terms as its root.
        for _ in 0..=square.len() {
            let rest = square.clone().plus(&self.product(&root, &root)?.negated());
            let Some((monomial, coefficient)) = rest.first() else { return Ok(Some(root)) };
            let is_multiple = first.powers().iter().all(|&(atom, power)| monomial.exponent(atom) >= power);
            if !is_multiple || !(&coefficient % &twice).is_zero() {
                return Ok(None);
            }
            root = root.plus(&Polynomial::term(monomial.over(&first), coefficient / &twice));
        }
        Ok(None)
    }

    /// 1/`fraction`; `None` of zero.
    pub fn inverse(&mut self, fraction: &Fraction) -> Result<Option<Fraction>> {
        let above = &fraction.above;
        if above.is_zero() {
            return Ok(None);
        }
        let (monomial, content) = (above.common_monomial(), above.content());
        let primitive = above.divided(&monomial, &content);
        let mut below: Vec<_> =
            monomial.powers().iter().map(|&(atom, power)| (Polynomial::atom(atom), power)).collect();
        if primitive.len() > 1 {
            below.push((primitive, 1));
        }
        below.sort();
        let sign = if content.is_negative() { IBig::NEG_ONE } else { IBig::ONE };
        let mut above = Polynomial::constant(&fraction.number * &sign);
        for (factor, power) in &fraction.below {
            let factor = self.power(factor, *power)?;
            above = self.product(&above, &factor)?;
        }
        Ok(Some(Fraction { above, number: content * sign, below }.lowest()))
    }

    pub fn raise(&mut self, base: &Fraction, exponent: u32) -> Result<Fraction> {
        let below = base.below.iter().map(|(factor, power)| Some((factor.clone(), power.checked_mul(exponent)?)));
        let number = Polynomial::constant(base.number.clone());
        let number = self.power(&number, exponent)?.as_constant().unwrap_or(IBig::ONE);
        let below = below.collect::<Option<_>>().ok_or(Undecided::TooLarge)?;
        Ok(Fraction { above: self.power(&base.above, exponent)?, number, below }.lowest())
    }
}

/// The factors of both, with the powers joined.
fn union(a: &[(Polynomial, u32)], b: &[(Polynomial, u32)], join: fn(u32, u32) -> u32) -> Vec<(Polynomial, u32)> {
    let mut all = a.to_vec();
    for (factor, power) in b {
        match all.iter_mut().find(|(known, _)| known == factor) {
            Some((_, own)) => *own = join(*own, *power),
            None => all.push((factor.clone(), *power)),
        }
    }
    all.sort();
    all
}

/// `a` without the factors below that `b` has above as a whole, and without the sum above that `b` has below.
fn without_shared(a: &Fraction, b: &Fraction) -> Fraction {
    let mut rest = a.clone();
    if let Some((_, power)) = rest.below.iter_mut().find(|(factor, _)| multiple(&b.above, factor).is_some()) {
        *power -= 1;
    }
    if let Some(term) = b.below.iter().find_map(|(factor, _)| multiple(&a.above, factor)) {
        rest.above = term;
    }
    rest.below.retain(|(_, power)| *power > 0);
    rest
}
