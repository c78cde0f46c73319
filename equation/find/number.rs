//! Arithmetic of exact numbers that says where it leaves their range.

use crate::rational::Rational;
use std::cmp::Ordering;

pub(super) fn is_unit(value: Rational) -> bool {
    value == Rational::ONE
}

/// a + b; `None` out of range, as in the functions below.
pub(super) fn add(a: Rational, b: Rational) -> Option<Rational> {
    if a.denominator() == 1 && b.denominator() == 1 {
        return Rational::new(a.numerator().checked_add(b.numerator())?, 1);
    }
    let (left, right) = (a.numerator().checked_mul(b.denominator())?, b.numerator().checked_mul(a.denominator())?);
    Rational::new(left.checked_add(right)?, a.denominator().checked_mul(b.denominator())?)
}

pub(super) fn multiply(a: Rational, b: Rational) -> Option<Rational> {
    Rational::new(a.numerator().checked_mul(b.numerator())?, a.denominator().checked_mul(b.denominator())?)
}

pub(super) fn invert(a: Rational) -> Option<Rational> {
    Rational::new(a.denominator(), a.numerator())
}

pub(super) fn compare(a: Rational, b: Rational) -> Ordering {
    let cross = |a: Rational, b: Rational| i128::from(a.numerator()) * i128::from(b.denominator());
    cross(a, b).cmp(&cross(b, a))
}

pub(super) fn integer_power(base: Rational, exponent: i64) -> Option<Rational> {
    let base = if exponent < 0 { invert(base)? } else { base };
    let odd = exponent % 2 != 0;
    match (base.numerator(), base.denominator()) {
        (0 | 1, 1) => return Some(if exponent == 0 { Rational::ONE } else { base }),
        (-1, 1) => return Some(if odd { base } else { Rational::ONE }),
        _ => {}
    }
    let exponent = u32::try_from(exponent.unsigned_abs()).ok()?;
    Rational::new(base.numerator().checked_pow(exponent)?, base.denominator().checked_pow(exponent)?)
}

pub(super) fn gcd(a: i64, b: i64) -> i64 {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// The prime factors of a positive number with their multiplicities; what has no small factor counts as a prime.
pub(super) fn primes(mut n: i64) -> Vec<(i64, i64)> {
    let mut found = Vec::new();
    let mut divisor = 2;
    while divisor * divisor <= n && divisor < 1000 {
        let mut multiplicity = 0;
        while n % divisor == 0 {
            n /= divisor;
            multiplicity += 1;
        }
        if multiplicity > 0 {
            found.push((divisor, multiplicity));
        }
        divisor += 1;
    }
    if n > 1 {
        found.push((n, 1));
    }
    found
}
