//! Principal roots: what comes out of one, and the atom for what stays in.

use super::atoms::{Atoms, Kind};
use super::fraction::{Fraction, Result, Undecided};
use super::polynomial::{Atom, Polynomial};
use dashu_base::{Signed, UnsignedAbs};
use dashu_int::IBig;

impl Atoms {
    /// The principal root of `degree` ≥ 2. Factors come out of it where the branch allows: positive numbers and positive
    /// symbols always; squares of what is real as moduli; symbols of bounded phase where nothing else is left in it and
    /// their phases stay below π together.
    pub fn root(&mut self, of: &Fraction, degree: u32) -> Result<Fraction> {
        if of.is_zero() {
            return Ok(Fraction::zero());
        }
        let (moduli, rest) = if degree == 2 { self.squares(of)? } else { (Fraction::one(), of.clone()) };
        let root = self.root_of_factors(&rest, degree)?;
        self.arithmetic.times(&moduli, &root)
    }

    /// What comes out of the square root of `of` because its square is a factor of it, and what is left in: sums that are
    /// positive by their form, and the moduli of what is real.
    fn squares(&mut self, of: &Fraction) -> Result<(Fraction, Fraction)> {
        let (mut outside, mut inside) = (Fraction::one(), of.clone());
        let common = of.above.common_monomial();
        let sum = of.above.divided(&common, &of.above.content());
        if sum.len() > 1
            && let Some(root) = self.arithmetic.square_root(&sum)?.map(Fraction::of)
            && self.is_positive(&root)
        {
            inside.above = Polynomial::term(common, of.above.content());
            outside = root;
        }
        let mut below = Vec::new();
        for (factor, power) in of.below.clone() {
            let (root, times, left) = match self.arithmetic.square_root(&factor)? {
                Some(root) => (Fraction::of(root), power, 0),
                None => (Fraction::of(factor.clone()), power / 2, power % 2),
            };
            let comes_out = factor.len() > 1 && times > 0 && self.is_positive(&root);
            let left = if comes_out { left } else { power };
            if left > 0 {
                below.push((factor, left));
            }
            if comes_out {
                let inverse = self.inverse(&root)?;
                let taken = self.arithmetic.raise(&inverse, times)?;
                outside = self.arithmetic.times(&outside, &taken)?;
            }
        }
        inside.below = below;
        for (atom, power) in self.atom_powers(&inside) {
            if power.unsigned_abs() > 1 && self.phase(atom) != 0.0 && self.is_real_atom(atom) {
                let square = self.power(atom, 2)?;
                let modulus = self.plain_root(&square, 2)?;
                let taken = self.arithmetic.raise(&modulus, (power.unsigned_abs() / 2) as u32)?;
                let taken = if power < 0 { self.inverse(&taken)? } else { taken };
                outside = self.arithmetic.times(&outside, &taken)?;
                let left = self.power(atom, -(power / 2 * 2))?;
                inside = self.arithmetic.times(&inside, &left)?;
            }
        }
        Ok((outside, inside))
    }

    fn root_of_factors(&mut self, of: &Fraction, degree: u32) -> Result<Fraction> {
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
