//! Numbers whose exponent cannot overflow: a product of inputs from the whole range of `f64` may leave that range on
//! the way to an answer within it.

use std::ops::{Div, Mul};

/// mantissa · 2^exponent with 1 ≤ mantissa < 2, or mantissa 0; never negative, never NaN.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scaled {
    mantissa: f64,
    exponent: i32,
}

/// 2^n for an exponent of a normal number.
const fn power_of_two(n: i32) -> f64 {
    f64::from_bits(((1023 + n) as u64) << 52)
}

impl From<f64> for Scaled {
    /// For finite x ≥ 0.
    fn from(x: f64) -> Self {
        debug_assert!(x >= 0.0 && x.is_finite());
        if x == 0.0 {
            return Self { mantissa: 0.0, exponent: 0 };
        }
        let (normal, lifted) = if x < f64::MIN_POSITIVE { (x * power_of_two(54), 54) } else { (x, 0) };
        let exponent = (normal.to_bits() >> 52) as i32 - 1023;
        Self {
            mantissa: normal * power_of_two(-(exponent / 2)) * power_of_two(exponent / 2 - exponent),
            exponent: exponent - lifted,
        }
    }
}

impl Scaled {
    fn normalised(mantissa: f64, exponent: i32) -> Self {
        let own = Self::from(mantissa);
        // Zero keeps its one form.
        Self { exponent: if mantissa == 0.0 { 0 } else { own.exponent + exponent }, ..own }
    }

    /// √x.
    pub fn sqrt(self) -> Self {
        let odd = self.exponent.rem_euclid(2);
        Self::normalised((self.mantissa * power_of_two(odd)).sqrt(), (self.exponent - odd) / 2)
    }

    /// The nearest `f64`: one rounding, ∞ above the range and 0 below it.
    pub fn to_f64(self) -> f64 {
        match self.exponent {
            1024.. => self.mantissa * f64::INFINITY,
            -1022.. => self.mantissa * power_of_two(self.exponent),
            -1100.. => self.mantissa * power_of_two(-600) * power_of_two(self.exponent + 600),
            _ => 0.0,
        }
    }
}

impl Mul for Scaled {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self::normalised(self.mantissa * other.mantissa, self.exponent + other.exponent)
    }
}

impl Div for Scaled {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        debug_assert!(other.mantissa > 0.0);
        Self::normalised(self.mantissa / other.mantissa, self.exponent - other.exponent)
    }
}

#[cfg(test)]
mod tests {
    use super::Scaled;

    #[test]
    fn the_whole_range_goes_in_and_comes_out() {
        for x in [0.0, 5e-324, 1e-310, f64::MIN_POSITIVE, 1e-200, 0.3, 1.0, 2.0, 1e200, f64::MAX] {
            assert_eq!(Scaled::from(x).to_f64(), x);
            if x > 1e-300 {
                let back = (Scaled::from(x) * Scaled::from(x)).sqrt().to_f64();
                assert!((back / x - 1.0).abs() < 1e-15, "{x} {back}");
                assert_eq!((Scaled::from(x) / Scaled::from(x)).to_f64(), 1.0);
            }
        }
    }

    #[test]
    fn answers_beyond_the_range_are_its_ends() {
        let (large, small) = (Scaled::from(1e200), Scaled::from(1e-200));
        assert_eq!((large * large).to_f64(), f64::INFINITY);
        assert_eq!((small * small).to_f64(), 0.0);
        assert!(((small / large * Scaled::from(1e100)).to_f64() / 1e-300 - 1.0).abs() < 1e-15);
        assert_eq!((Scaled::from(0.0) * large * large * large).to_f64(), 0.0);
    }
}
