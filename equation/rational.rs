//! Exact fractions, small enough for coefficients and exponents.

use std::fmt;

/// A fraction in lowest terms. Numerator and denominator are `i64`: textbook coefficients, powers of ten up
/// to 18 and the exponents of units fit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Rational {
    numerator: i64,
    denominator: i64,
}

impl Rational {
    /// 0
    pub const ZERO: Self = Self::integer(0);
    /// 1
    pub const ONE: Self = Self::integer(1);

    /// The whole number `n`.
    pub const fn integer(n: i64) -> Self {
        Self { numerator: n, denominator: 1 }
    }

    /// `numerator / denominator`; `None` for a zero denominator or where the lowest terms do not fit.
    pub const fn new(numerator: i64, denominator: i64) -> Option<Self> {
        Self::reduce(numerator as i128, denominator as i128)
    }

    const fn reduce(numerator: i128, denominator: i128) -> Option<Self> {
        if denominator == 0 {
            return None;
        }
        let divisor = greatest_common_divisor(numerator.unsigned_abs(), denominator.unsigned_abs()) as i128;
        let sign = if denominator < 0 { -1 } else { 1 };
        let (numerator, denominator) = (sign * numerator / divisor, sign * denominator / divisor);
        // The least i64 is left out so that every value has a negative.
        if numerator > i64::MAX as i128 || numerator < -(i64::MAX as i128) || denominator > i64::MAX as i128 {
            return None;
        }
        Some(Self { numerator: numerator as i64, denominator: denominator as i64 })
    }

    /// Above the line; carries the sign.
    pub const fn numerator(self) -> i64 {
        self.numerator
    }

    /// Below the line; at least 1.
    pub const fn denominator(self) -> i64 {
        self.denominator
    }

    /// Whether it is 0.
    pub const fn is_zero(self) -> bool {
        self.numerator == 0
    }

    /// Whether it is below 0.
    pub const fn is_negative(self) -> bool {
        self.numerator < 0
    }

    /// The whole number that it is, if it is one.
    pub const fn as_integer(self) -> Option<i64> {
        if self.denominator == 1 { Some(self.numerator) } else { None }
    }

    /// −`self`
    pub const fn negated(self) -> Self {
        Self { numerator: -self.numerator, denominator: self.denominator }
    }
}

/// The greatest common divisor, 1 of two zeros.
pub(super) const fn greatest_common_divisor(mut a: u128, mut b: u128) -> u128 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    if a == 0 { 1 } else { a }
}

impl From<i32> for Rational {
    fn from(n: i32) -> Self {
        Self::integer(n.into())
    }
}

impl fmt::Display for Rational {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self.as_integer() {
            Some(n) => write!(f, "{n}"),
            None => write!(f, "{}/{}", self.numerator, self.denominator),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Rational;

    #[test]
    fn keeps_lowest_terms_with_the_sign_above() {
        let half = Rational::new(-3, -6).unwrap();
        assert_eq!((half.numerator(), half.denominator()), (1, 2));
        assert_eq!(Rational::new(2, -4).unwrap().to_string(), "-1/2");
        assert_eq!(Rational::new(0, -7), Some(Rational::ZERO));
        assert_eq!(Rational::new(1, 0), None);
    }

    #[test]
    fn refuses_what_does_not_fit() {
        assert_eq!(Rational::new(i64::MIN, -2), Some(Rational::integer(1 << 62)));
        assert_eq!(Rational::new(i64::MIN, 1), None);
    }
}
