//! Polynomials with whole coefficients in atoms that are known by number alone.

use dashu_base::{Gcd, Signed};
use dashu_int::IBig;
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// A generator of the ring: an index into the table of [`super::atoms`].
pub(super) type Atom = u32;

/// A product of powers of atoms: atoms in ascending order, exponents ≥ 1.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub(super) struct Monomial(Vec<(Atom, u32)>);

impl Monomial {
    pub fn power(atom: Atom, exponent: u32) -> Self {
        if exponent == 0 { Self::default() } else { Self(vec![(atom, exponent)]) }
    }

    pub fn is_one(&self) -> bool {
        self.0.is_empty()
    }

    pub fn powers(&self) -> &[(Atom, u32)] {
        &self.0
    }

    pub fn exponent(&self, atom: Atom) -> u32 {
        self.0.binary_search_by_key(&atom, |power| power.0).map_or(0, |at| self.0[at].1)
    }

    /// The same with another exponent for `atom`.
    pub fn with(&self, atom: Atom, exponent: u32) -> Self {
        let mut powers: Vec<_> = self.0.iter().copied().filter(|power| power.0 != atom).collect();
        if exponent > 0 {
            let at = powers.partition_point(|power| power.0 < atom);
            powers.insert(at, (atom, exponent));
        }
        Self(powers)
    }

    /// The product; `None` where an exponent does not fit.
    pub fn times(&self, other: &Self) -> Option<Self> {
        let (mut a, mut b) = (self.0.iter().peekable(), other.0.iter().peekable());
        let mut powers = Vec::with_capacity(self.0.len() + other.0.len());
        loop {
            let order = match (a.peek(), b.peek()) {
                (None, None) => return Some(Self(powers)),
                (Some(_), None) => Ordering::Less,
                (None, Some(_)) => Ordering::Greater,
                (Some(x), Some(y)) => x.0.cmp(&y.0),
            };
            match order {
                Ordering::Less => powers.extend(a.next()),
                Ordering::Greater => powers.extend(b.next()),
                Ordering::Equal => {
                    if let (Some(x), Some(y)) = (a.next(), b.next()) {
                        powers.push((x.0, x.1.checked_add(y.1)?));
                    }
                }
            }
        }
    }

    pub fn to_the(&self, exponent: u32) -> Option<Self> {
        if exponent == 0 {
            return Some(Self::default());
        }
        let powers = self.0.iter().map(|&(atom, e)| Some((atom, e.checked_mul(exponent)?)));
        powers.collect::<Option<_>>().map(Self)
    }

    /// The greatest monomial that divides both.
    fn common(&self, other: &Self) -> Self {
        let shared = self.0.iter().map(|&(atom, e)| (atom, e.min(other.exponent(atom))));
        Self(shared.filter(|power| power.1 > 0).collect())
    }

    /// `self` / `divisor`, which divides it.
    pub fn over(&self, divisor: &Self) -> Self {
        let rest = self.0.iter().map(|&(atom, e)| (atom, e - divisor.exponent(atom)));
        Self(rest.filter(|power| power.1 > 0).collect())
    }
}

/// As on a page: the lowest atom first, its highest power first, a constant last.
impl Ord for Monomial {
    fn cmp(&self, other: &Self) -> Ordering {
        for (a, b) in self.0.iter().zip(&other.0) {
            let order = a.0.cmp(&b.0).then(b.1.cmp(&a.1));
            if order != Ordering::Equal {
                return order;
            }
        }
        other.0.len().cmp(&self.0.len())
    }
}

impl PartialOrd for Monomial {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// A sum of monomials with non-zero coefficients.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Polynomial(BTreeMap<Monomial, IBig>);

impl Polynomial {
    pub fn zero() -> Self {
        Self::default()
    }

    pub fn one() -> Self {
        Self::constant(IBig::ONE)
    }

    pub fn constant(value: IBig) -> Self {
        Self::term(Monomial::default(), value)
    }

    pub fn atom(atom: Atom) -> Self {
        Self::term(Monomial::power(atom, 1), IBig::ONE)
    }

    pub fn term(monomial: Monomial, coefficient: IBig) -> Self {
        let mut sum = Self::zero();
        sum.add(monomial, coefficient);
        sum
    }

    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    pub fn len(&self) -> usize {
        self.0.len()
    }

    pub fn terms(&self) -> impl DoubleEndedIterator<Item = (&Monomial, &IBig)> {
        self.0.iter()
    }

    /// The term that is written first.
    pub fn first(&self) -> Option<(Monomial, IBig)> {
        self.0.first_key_value().map(|(monomial, coefficient)| (monomial.clone(), coefficient.clone()))
    }

    /// Its only term, if it has one.
    pub fn as_term(&self) -> Option<(&Monomial, &IBig)> {
        self.0.first_key_value().filter(|_| self.len() == 1)
    }

    /// The number it is, if it is one.
    pub fn as_constant(&self) -> Option<IBig> {
        if self.is_zero() {
            return Some(IBig::ZERO);
        }
        self.as_term().filter(|(monomial, _)| monomial.is_one()).map(|(_, value)| value.clone())
    }

    /// The single atom it is, if it is one.
    pub fn as_atom(&self) -> Option<Atom> {
        match self.as_term()? {
            (Monomial(powers), coefficient) if *coefficient == IBig::ONE => match powers[..] {
                [(atom, 1)] => Some(atom),
                _ => None,
            },
            _ => None,
        }
    }

    pub fn add(&mut self, monomial: Monomial, coefficient: IBig) {
        use std::collections::btree_map::Entry;
        match self.0.entry(monomial) {
            Entry::Vacant(place) if !coefficient.is_zero() => {
                place.insert(coefficient);
            }
            Entry::Vacant(_) => {}
            Entry::Occupied(mut place) => {
                *place.get_mut() += coefficient;
                if place.get().is_zero() {
                    place.remove();
                }
            }
        }
    }

    pub fn plus(mut self, other: &Self) -> Self {
        for (monomial, coefficient) in other.terms() {
            self.add(monomial.clone(), coefficient.clone());
        }
        self
    }

    pub fn scaled(&self, factor: &IBig) -> Self {
        if factor.is_zero() {
            return Self::zero();
        }
        Self(self.0.iter().map(|(monomial, coefficient)| (monomial.clone(), coefficient * factor)).collect())
    }

    pub fn negated(&self) -> Self {
        self.scaled(&IBig::NEG_ONE)
    }

    /// The greatest whole number that divides every coefficient, with the sign of the first term; 1 of zero.
    pub fn content(&self) -> IBig {
        let Some((_, first)) = self.0.first_key_value() else { return IBig::ONE };
        let divisor = self.0.values().fold(IBig::ZERO, |divisor, value| {
            if divisor == IBig::ONE { divisor } else { IBig::from(divisor.gcd(value)) }
        });
        if first.is_negative() { -divisor } else { divisor }
    }

    /// The greatest monomial that divides every term; 1 of zero.
    pub fn common_monomial(&self) -> Monomial {
        let mut terms = self.0.keys();
        let Some(first) = terms.next() else { return Monomial::default() };
        terms.fold(first.clone(), |common, monomial| common.common(monomial))
    }

    /// Every term divided by the monomial and the number, which divide it.
    pub fn divided(&self, monomial: &Monomial, number: &IBig) -> Self {
        Self(self.0.iter().map(|(m, c)| (m.over(monomial), c / number)).collect())
    }

    /// The highest power of `atom` in it.
    pub fn degree(&self, atom: Atom) -> u32 {
        self.0.keys().map(|monomial| monomial.exponent(atom)).max().unwrap_or(0)
    }

    /// What stands with the power `exponent` of `atom`.
    pub fn coefficient(&self, atom: Atom, exponent: u32) -> Self {
        let terms = self.0.iter().filter(|(monomial, _)| monomial.exponent(atom) == exponent);
        Self(terms.map(|(monomial, c)| (monomial.with(atom, 0), c.clone())).collect())
    }

    /// Every atom in it, ascending.
    pub fn atoms(&self) -> Vec<Atom> {
        let mut atoms: Vec<Atom> =
            self.0.keys().flat_map(|monomial| monomial.powers().iter().map(|power| power.0)).collect();
        atoms.sort_unstable();
        atoms.dedup();
        atoms
    }
}
