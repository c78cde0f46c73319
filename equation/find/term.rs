//! Canonical forms: what a reader takes for the same line is the same [`Term`].
//!
//! Order and grouping of terms and factors, arithmetic of numbers, signs, nested fractions, collected powers and like
//! terms do not show in a term: a sum is a list of distinct monomials, a product a coefficient and powers of distinct
//! bases, and a quotient is a product with negative powers.

use super::number::{add, compare, gcd, integer_power, invert, is_unit, multiply, primes};
use crate::expr::Function;
use crate::rational::Rational;
use crate::value::Field;
use num_complex::Complex64;
use std::cmp::Ordering;
use std::hash::{Hash, Hasher};
use std::rc::Rc;

/// What a term is worth at the two points at which every rule is watched.
pub(super) type Values = [Complex64; 2];

/// A factor: base and exponent.
pub(super) type Power = (Term, Rational);

/// An expression in canonical form, with its hash, size and values. Cheap to clone.
#[derive(Clone, Debug)]
pub(super) struct Term(Rc<Node>);

#[derive(Debug)]
struct Node {
    form: Form,
    hash: u64,
    size: usize,
    values: Values,
}

/// What a term is made of.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Form {
    /// A division by zero, or a number beyond the range of [`Rational`]; whatever contains it is undefined too.
    Undefined,
    /// A coefficient and powers of distinct bases in order. A number is a product of no powers. Powers of products
    /// and of numbers are dissolved unless their exponent is a fraction; sums are primitive, with a positive first
    /// coefficient.
    Product(Rational, Vec<Power>),
    /// By its place in the scene.
    Symbol(usize),
    /// π
    Pi,
    /// i
    ImaginaryUnit,
    /// A function of unknown form at arguments.
    Apply(usize, Vec<Term>),
    /// The first coefficient in the argument of an odd or even function is positive.
    Function(Function, Term),
    /// At least two monomials, in order.
    Sum(Vec<Term>),
}

const HALF: Rational = Rational::new(1, 2).expect("2 is not 0");

impl Term {
    fn new(form: Form, values: Values) -> Self {
        let size = match &form {
            Form::Product(c, factors) => {
                let number = usize::from(factors.is_empty() || !is_unit(*c));
                number + factors.iter().map(|(base, e)| base.size() + usize::from(!is_unit(*e))).sum::<usize>()
            }
            Form::Apply(_, parts) | Form::Sum(parts) => parts.len() - 1 + parts.iter().map(Self::size).sum::<usize>(),
            Form::Function(_, of) => 1 + of.size(),
            _ => 1,
        };
        let mut hasher = Fold(size as u64);
        form.hash(&mut hasher);
        Self(Rc::new(Node { form, hash: hasher.finish(), size, values }))
    }

    pub fn form(&self) -> &Form {
        &self.0.form
    }

    /// How much there is to read: leaves, functions, exponents and signs of addition.
    pub fn size(&self) -> usize {
        self.0.size
    }

    pub fn values(&self) -> Values {
        self.0.values
    }

    pub fn fingerprint(&self) -> u64 {
        self.0.hash
    }

    pub fn undefined() -> Self {
        Self::new(Form::Undefined, [Complex64::new(f64::NAN, f64::NAN); 2])
    }

    pub fn number(value: Rational) -> Self {
        Self::new(Form::Product(value, vec![]), [Complex64::number(value, 53); 2])
    }

    pub fn integer(value: i32) -> Self {
        Self::number(value.into())
    }

    pub fn half() -> Self {
        Self::number(HALF)
    }

    pub fn symbol(index: usize, values: Values) -> Self {
        Self::new(Form::Symbol(index), values)
    }

    pub fn pi() -> Self {
        Self::new(Form::Pi, [Complex64::pi(53); 2])
    }

    pub fn imaginary_unit() -> Self {
        Self::new(Form::ImaginaryUnit, [Complex64::I; 2])
    }

    /// The unknown function `index` at `arguments`. Its stand-in for numbers is a sine of a mixture of them.
    pub fn apply(index: usize, values: Values, arguments: Vec<Self>) -> Self {
        if arguments.iter().any(Self::is_undefined) {
            return Self::undefined();
        }
        let mut at = 0;
        let mixed = values.map(|seed| {
            at += 1;
            arguments.iter().fold(seed, |sum, argument| sum * 1.25 + argument.values()[at - 1]).sin()
        });
        Self::new(Form::Apply(index, arguments), mixed)
    }

    pub fn is_undefined(&self) -> bool {
        *self.form() == Form::Undefined
    }

    pub fn as_number(&self) -> Option<Rational> {
        match self.form() {
            Form::Product(value, factors) if factors.is_empty() => Some(*value),
            _ => None,
        }
    }

    pub fn is_zero(&self) -> bool {
        self.as_number().is_some_and(Rational::is_zero)
    }

    /// The terms of a sum; itself otherwise.
    pub fn terms(&self) -> &[Self] {
        match self.form() {
            Form::Sum(terms) => terms,
            _ => std::slice::from_ref(self),
        }
    }

    /// Its coefficient and its powers.
    pub fn factors(&self) -> (Rational, Vec<Power>) {
        match self.form() {
            Form::Product(coefficient, factors) => (*coefficient, factors.clone()),
            _ => (Rational::ONE, vec![(self.clone(), Rational::ONE)]),
        }
    }

    /// The number in front: of the first term in a sum.
    pub fn coefficient(&self) -> Rational {
        match self.form() {
            Form::Product(coefficient, _) => *coefficient,
            Form::Sum(terms) => terms[0].coefficient(),
            _ => Rational::ONE,
        }
    }

    /// The sum of `parts`, with like terms collected.
    pub fn sum(parts: impl IntoIterator<Item = Self>) -> Self {
        let mut monomials: Vec<(Self, Rational)> = Vec::new();
        for part in parts {
            if part.is_undefined() {
                return part;
            }
            monomials.extend(part.terms().iter().map(|term| (term.monic(), term.coefficient())));
        }
        monomials.sort_by(|a, b| a.0.compare_monomials(&b.0));
        let mut terms: Vec<Self> = Vec::new();
        for like in monomials.chunk_by(|a, b| a.0 == b.0) {
            let Some(total) = like.iter().try_fold(Rational::ZERO, |sum, (_, c)| add(sum, *c)) else {
                return Self::undefined();
            };
            if !total.is_zero() {
                terms.push(like[0].0.with_coefficient(total));
            }
        }
        match terms.len() {
            0 => Self::integer(0),
            1 => terms.remove(0),
            _ => Self::from_terms(terms),
        }
    }

    fn from_terms(terms: Vec<Self>) -> Self {
        let values = [0, 1].map(|at| terms.iter().map(|term| term.values()[at]).sum());
        Self::new(Form::Sum(terms), values)
    }

    /// The product of powers.
    pub fn product(parts: impl IntoIterator<Item = Power>) -> Self {
        let mut gathered = Gathered { coefficient: Rational::ONE, factors: Vec::new() };
        if parts.into_iter().try_for_each(|(base, exponent)| gathered.push(&base, exponent)).is_none() {
            return Self::undefined();
        }
        gathered.finish().unwrap_or_else(Self::undefined)
    }

    /// `function` of `of`.
    pub fn function(function: Function, of: Self) -> Self {
        if of.is_undefined() {
            return of;
        }
        let is_odd = matches!(function, Function::Sin | Function::Tan);
        let is_even = function == Function::Cos;
        match function {
            Function::Sqrt => return of.power(HALF),
            Function::Cos | Function::Exp if of.is_zero() => return Self::integer(1),
            _ if is_odd && of.is_zero() => return of,
            _ if (is_odd || is_even) && of.coefficient().is_negative() => {
                let positive = Self::function(function, of.negated());
                return if is_odd { positive.negated() } else { positive };
            }
            _ => {}
        }
        let value = |z: &Complex64| match function {
            Function::Tan => Some(z.tan()),
            other => z.apply(other),
        };
        let values = of.values().map(|z| value(&z).unwrap_or(Complex64::new(f64::NAN, 0.0)));
        Self::new(Form::Function(function, of), values)
    }

    pub fn plus(&self, other: &Self) -> Self {
        Self::sum([self.clone(), other.clone()])
    }

    pub fn minus(&self, other: &Self) -> Self {
        self.plus(&other.negated())
    }

    pub fn times(&self, other: &Self) -> Self {
        Self::product([(self.clone(), Rational::ONE), (other.clone(), Rational::ONE)])
    }

    pub fn over(&self, other: &Self) -> Self {
        Self::product([(self.clone(), Rational::ONE), (other.clone(), Rational::integer(-1))])
    }

    pub fn power(&self, exponent: Rational) -> Self {
        Self::product([(self.clone(), exponent)])
    }

    pub fn squared(&self) -> Self {
        self.power(Rational::integer(2))
    }

    pub fn scaled(&self, by: Rational) -> Self {
        Self::product([(Self::number(by), Rational::ONE), (self.clone(), Rational::ONE)])
    }

    pub fn negated(&self) -> Self {
        self.scaled(Rational::integer(-1))
    }

    /// Without its coefficient; not for sums.
    fn monic(&self) -> Self {
        match self.form() {
            Form::Product(c, _) if is_unit(*c) => self.clone(),
            Form::Product(..) => self.with_coefficient(Rational::ONE),
            _ => self.clone(),
        }
    }

    /// The same monomial with another coefficient, not 0.
    fn with_coefficient(&self, coefficient: Rational) -> Self {
        let factors = match self.form() {
            Form::Product(c, _) if *c == coefficient => return self.clone(),
            Form::Product(_, factors) => factors.clone(),
            _ if is_unit(coefficient) => return self.clone(),
            _ => vec![(self.clone(), Rational::ONE)],
        };
        Self::from_factors(coefficient, factors)
    }

    /// From parts that are canonical already.
    fn from_factors(coefficient: Rational, factors: Vec<Power>) -> Self {
        if is_unit(coefficient) && factors.len() == 1 && is_unit(factors[0].1) {
            return factors[0].0.clone();
        }
        let number = Complex64::number(coefficient, 53);
        let worth = |at: usize| {
            factors.iter().fold(number, |product, (base, e)| {
                let base = base.values()[at];
                product * if is_unit(*e) { base } else { base.power(*e).unwrap_or(Complex64::new(f64::NAN, 0.0)) }
            })
        };
        let values = [worth(0), worth(1)];
        Self::new(Form::Product(coefficient, factors), values)
    }

    /// The number that all coefficients of a sum have in common, with the sign of the first.
    pub fn content(&self) -> Rational {
        let mut whole: Option<(i64, i64)> = None;
        for term in self.terms() {
            let (n, d) = (term.coefficient().numerator().abs(), term.coefficient().denominator());
            whole = Some(match whole {
                None => (n, d),
                Some((above, below)) => (gcd(above, n), below.saturating_mul(d / gcd(below, d))),
            });
        }
        let (above, below) = whole.unwrap_or((1, 1));
        let content = Rational::new(above, below).unwrap_or(Rational::ONE);
        if self.coefficient().is_negative() { content.negated() } else { content }
    }

    /// Every coefficient of a sum multiplied.
    fn distribute(&self, by: Rational) -> Option<Self> {
        if is_unit(by) {
            return Some(self.clone());
        }
        let scale = |term: &Self| Some(term.with_coefficient(multiply(term.coefficient(), by)?));
        Some(Self::from_terms(self.terms().iter().map(scale).collect::<Option<_>>()?))
    }

    /// The order of monomials in a sum: by their first bases, higher powers first, numbers last.
    fn compare_monomials(&self, other: &Self) -> Ordering {
        let mut at = 0;
        loop {
            match (self.power_at(at), other.power_at(at)) {
                (None, None) => return Ordering::Equal,
                (Some(_), None) => return Ordering::Less,
                (None, Some(_)) => return Ordering::Greater,
                (Some((a, e)), Some((b, f))) => match a.cmp(b).then_with(|| compare(f, e)) {
                    Ordering::Equal => at += 1,
                    unequal => return unequal,
                },
            }
        }
    }

    fn power_at(&self, at: usize) -> Option<(&Self, Rational)> {
        match self.form() {
            Form::Product(_, factors) => factors.get(at).map(|(base, e)| (base, *e)),
            _ => (at == 0).then_some((self, Rational::ONE)),
        }
    }

    fn rank(&self) -> usize {
        match self.form() {
            Form::Symbol(_) => 0,
            Form::Pi => 1,
            Form::ImaginaryUnit => 2,
            Form::Apply(..) => 3,
            Form::Function(function, _) => 4 + *function as usize,
            Form::Sum(_) => 30,
            Form::Product(..) => 31,
            Form::Undefined => 32,
        }
    }
}

impl PartialEq for Term {
    fn eq(&self, other: &Self) -> bool {
        Rc::ptr_eq(&self.0, &other.0) || (self.0.hash == other.0.hash && self.0.form == other.0.form)
    }
}

impl Eq for Term {}

impl Hash for Term {
    fn hash<H: Hasher>(&self, state: &mut H) {
        state.write_u64(self.0.hash);
    }
}

impl Ord for Term {
    fn cmp(&self, other: &Self) -> Ordering {
        if self == other {
            return Ordering::Equal;
        }
        match (self.form(), other.form()) {
            (Form::Symbol(a), Form::Symbol(b)) => a.cmp(b),
            (Form::Apply(f, a), Form::Apply(g, b)) => f.cmp(g).then_with(|| a.cmp(b)),
            (Form::Function(f, a), Form::Function(g, b)) if f == g => a.cmp(b),
            (Form::Sum(a), Form::Sum(b)) => a.cmp(b),
            (Form::Product(c, _), Form::Product(d, _)) => self.compare_monomials(other).then_with(|| compare(*c, *d)),
            (Form::Product(..), _) | (_, Form::Product(..)) => {
                self.compare_monomials(other).then_with(|| compare(self.coefficient(), other.coefficient()))
            }
            _ => self.rank().cmp(&other.rank()),
        }
    }
}

impl PartialOrd for Term {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Hash for Form {
    fn hash<H: Hasher>(&self, state: &mut H) {
        state.write_usize(match self {
            Self::Undefined => 0,
            Self::Product(..) => 1,
            Self::Symbol(_) => 2,
            Self::Pi => 3,
            Self::ImaginaryUnit => 4,
            Self::Apply(..) => 5,
            Self::Function(function, _) => 10 + *function as usize,
            Self::Sum(_) => 6,
        });
        match self {
            Self::Product(coefficient, factors) => {
                number_hash(*coefficient, state);
                for (base, exponent) in factors {
                    base.hash(state);
                    number_hash(*exponent, state);
                }
            }
            Self::Symbol(index) => state.write_usize(*index),
            Self::Apply(index, parts) => {
                state.write_usize(*index);
                parts.iter().for_each(|part| part.hash(state));
            }
            Self::Function(_, of) => of.hash(state),
            Self::Sum(parts) => parts.iter().for_each(|part| part.hash(state)),
            Self::Undefined | Self::Pi | Self::ImaginaryUnit => {}
        }
    }
}

fn number_hash(value: Rational, state: &mut impl Hasher) {
    state.write_u64(value.numerator() as u64);
    state.write_u64(value.denominator() as u64);
}

/// A hash for trees whose parts carry theirs: one multiplication a word (the finaliser of splitmix64).
#[derive(Default)]
pub(super) struct Fold(pub u64);

impl Hasher for Fold {
    fn finish(&self) -> u64 {
        self.0
    }

    fn write(&mut self, bytes: &[u8]) {
        bytes.iter().for_each(|byte| self.write_u64((*byte).into()));
    }

    fn write_u64(&mut self, word: u64) {
        let mixed =
            (self.0.rotate_left(23) ^ word).wrapping_add(0x9e37_79b9_7f4a_7c15).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        self.0 = mixed ^ (mixed >> 31);
    }

    fn write_usize(&mut self, word: usize) {
        self.write_u64(word as u64);
    }
}

/// Factors on the way to a product.
struct Gathered {
    coefficient: Rational,
    factors: Vec<Power>,
}

impl Gathered {
    /// Takes in `base` to the `exponent`; `None` where that has no value within range.
    fn push(&mut self, base: &Term, exponent: Rational) -> Option<()> {
        if exponent.is_zero() {
            return (!base.is_undefined()).then_some(());
        }
        match (base.form(), exponent.as_integer()) {
            (Form::Undefined, _) => None,
            (Form::Product(c, factors), Some(n)) => {
                self.scale(integer_power(*c, n)?)?;
                for (inner, e) in factors {
                    self.push(inner, multiply(*e, exponent)?)?;
                }
                Some(())
            }
            (Form::Product(c, factors), None) if factors.is_empty() => self.push_root(*c, exponent),
            (Form::Product(c, _), None) => {
                let size = if c.is_negative() { c.negated() } else { *c };
                self.push_root(size, exponent)?;
                let rest = if c.is_negative() { Rational::integer(-1) } else { Rational::ONE };
                self.keep(base.with_coefficient(rest), exponent)
            }
            (Form::Sum(_), Some(n)) => {
                let content = base.content();
                self.scale(integer_power(content, n)?)?;
                self.keep(base.distribute(invert(content)?)?, exponent)
            }
            (Form::Sum(_), None) => {
                let content = base.content();
                let size = if content.is_negative() { content.negated() } else { content };
                self.push_root(size, exponent)?;
                self.keep(base.distribute(invert(size)?)?, exponent)
            }
            (Form::ImaginaryUnit, Some(n)) => {
                if n.rem_euclid(4) >= 2 {
                    self.scale(Rational::integer(-1))?;
                }
                if n.rem_euclid(2) == 1 { self.keep(base.clone(), Rational::ONE) } else { Some(()) }
            }
            _ => self.keep(base.clone(), exponent),
        }
    }

    /// A power that stands as it is, unless it completes one that does not.
    fn keep(&mut self, base: Term, exponent: Rational) -> Option<()> {
        let Some(at) = self.factors.iter().position(|(known, _)| *known == base) else {
            self.factors.push((base, exponent));
            return Some(());
        };
        let total = add(self.factors[at].1, exponent)?;
        self.factors.swap_remove(at);
        let is_settled = !matches!(base.form(), Form::Product(..) | Form::Sum(_) | Form::ImaginaryUnit);
        if is_settled && !total.is_zero() {
            self.factors.push((base, total));
            return Some(());
        }
        self.push(&base, total)
    }

    fn scale(&mut self, by: Rational) -> Option<()> {
        self.coefficient = multiply(self.coefficient, by)?;
        Some(())
    }

    /// A number to a fractional exponent: roots of primes for what divides out, the number itself otherwise.
    fn push_root(&mut self, value: Rational, exponent: Rational) -> Option<()> {
        if is_unit(value) || value.is_zero() {
            let vanishes = value.is_zero();
            if vanishes {
                self.coefficient = Rational::ZERO;
            }
            return (!vanishes || !exponent.is_negative()).then_some(());
        }
        if value.is_negative() {
            if exponent.denominator() != 2 {
                return self.keep(Term::number(value), exponent);
            }
            self.push(&Term::imaginary_unit(), Rational::integer(exponent.numerator()))?;
            return self.push_root(value.negated(), exponent);
        }
        for (part, exponent) in [(value.numerator(), exponent), (value.denominator(), exponent.negated())] {
            for (prime, multiplicity) in primes(part) {
                self.push_prime(prime, multiply(exponent, Rational::integer(multiplicity))?)?;
            }
        }
        Some(())
    }

    /// `prime` to a power between 0 and 1; the rest of the exponent goes to the coefficient.
    fn push_prime(&mut self, prime: i64, exponent: Rational) -> Option<()> {
        let base = Term::number(Rational::integer(prime));
        let mut exponent = exponent;
        if let Some(at) = self.factors.iter().position(|(known, _)| *known == base) {
            exponent = add(exponent, self.factors.swap_remove(at).1)?;
        }
        let whole = exponent.numerator().div_euclid(exponent.denominator());
        self.scale(integer_power(Rational::integer(prime), whole)?)?;
        let rest = add(exponent, Rational::integer(whole).negated())?;
        if !rest.is_zero() {
            self.factors.push((base, rest));
        }
        Some(())
    }

    fn finish(mut self) -> Option<Term> {
        if self.coefficient.is_zero() {
            return Some(Term::integer(0));
        }
        self.factors.sort_by(|a, b| a.0.cmp(&b.0));
        match self.factors.as_slice() {
            [(base, exponent)] if is_unit(*exponent) && matches!(base.form(), Form::Sum(_)) => {
                base.distribute(self.coefficient)
            }
            [] => Some(Term::number(self.coefficient)),
            _ => Some(Term::from_factors(self.coefficient, self.factors)),
        }
    }
}
