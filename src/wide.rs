//! Twice the digits of `f64` where a difference of nearly equal inputs would leave too few: an unevaluated sum of
//! two `f64` (Dekker, *Numer. Math.* 18 (1971) 224; Knuth, TAOCP vol. 2, §4.2.2), about 31 decimal digits.
//! Only what `optics` needs near critical angles, `waves` after many periods and `radiometry` where a polygon's edges cancel;
//! everything wider is [`yardstick::precise`].

use std::ops::{Add, Div, Mul, Neg, Sub};

/// hi + lo with |lo| ≤ ½ ulp(hi).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wide {
    hi: f64,
    lo: f64,
}

impl From<f64> for Wide {
    fn from(hi: f64) -> Self {
        Self { hi, lo: 0.0 }
    }
}

impl From<Wide> for f64 {
    fn from(wide: Wide) -> Self {
        wide.hi + wide.lo
    }
}

/// a + b and its rounding error, for |a| ≥ |b| (Dekker).
fn ordered_sum(a: f64, b: f64) -> Wide {
    let hi = a + b;
    Wide { hi, lo: b - (hi - a) }
}

/// a + b and its rounding error (Knuth).
fn sum(a: f64, b: f64) -> Wide {
    let hi = a + b;
    let b_seen = hi - a;
    Wide { hi, lo: (a - (hi - b_seen)) + (b - b_seen) }
}

/// a · b and its rounding error, by Veltkamp's splitting (a fused multiply-add is slow where the machine lacks it).
fn product(a: f64, b: f64) -> Wide {
    let split = |x: f64| {
        let shifted = 134_217_729.0 * x; // 2²⁷ + 1
        let high = shifted - (shifted - x);
        (high, x - high)
    };
    let hi = a * b;
    let ((a_high, a_low), (b_high, b_low)) = (split(a), split(b));
    Wide { hi, lo: ((a_high * b_high - hi) + a_high * b_low + a_low * b_high) + a_low * b_low }
}

impl Add for Wide {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (high, low) = (sum(self.hi, other.hi), sum(self.lo, other.lo));
        let partial = ordered_sum(high.hi, high.lo + low.hi);
        ordered_sum(partial.hi, partial.lo + low.lo)
    }
}

impl Neg for Wide {
    type Output = Self;

    fn neg(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
}

impl Sub for Wide {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Wide {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let high = product(self.hi, other.hi);
        ordered_sum(high.hi, high.lo + (self.hi * other.lo + self.lo * other.hi))
    }
}

impl Div for Wide {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let first = self.hi / other.hi;
        let rest = self - other * Self::from(first);
        let second = rest.hi / other.hi;
        let rest = rest - other * Self::from(second);
        ordered_sum(first, second) + Self::from(rest.hi / other.hi)
    }
}

impl Wide {
    /// √x of x ≥ 0.
    pub fn sqrt(self) -> Self {
        let root = self.hi.sqrt();
        if root == 0.0 {
            return Self::from(0.0);
        }
        let rest = self - product(root, root);
        ordered_sum(root, 0.5 * (rest.hi + rest.lo) / root)
    }

    /// The angle 0 … π of the direction (x, y), y ≥ 0, from that of `f64` by one step of Newton's.
    pub fn atan2(y: Self, x: Self) -> Self {
        if x.hi < 0.0 {
            const PI: Wide = Wide { hi: std::f64::consts::PI, lo: 1.224_646_799_147_353_2e-16 };
            return PI - Self::atan2(y, -x);
        }
        let near = Self::from(y.hi.atan2(x.hi));
        let (sin, cos) = Self::sin_cos(near.hi);
        near + (y * cos - x * sin) / (x * cos + y * sin)
    }

    /// The nearest `f64` and what is left.
    pub fn parts(self) -> (f64, f64) {
        (self.hi, self.lo)
    }

    /// sin x and cos x for |x| ≤ π/2, absolute error below 1e−30.
    pub fn sin_cos(x: f64) -> (Self, Self) {
        // Taylor's series at x/8, then three times the double angle, kept as 1 − cos so that nothing cancels.
        let (eighth, one) = (Self::from(x / 8.0), Self::from(1.0));
        let square = eighth * eighth;
        let series = |first: Self, from: u32| {
            let (mut term, mut total) = (first, first);
            for n in (from..24).step_by(2) {
                term = -(term * square).over(f64::from(n * (n + 1)));
                total = total + term;
            }
            total
        };
        let (mut sin, mut versine) = (series(eighth, 2), series(square.over(2.0), 3));
        for _ in 0..3 {
            let cos = one - versine;
            (sin, versine) = (Self::from(2.0) * sin * cos, Self::from(2.0) * sin * sin);
        }
        (sin, one - versine)
    }

    /// Divided by a small integer.
    fn over(self, divisor: f64) -> Self {
        let first = self.hi / divisor;
        let rest = self - product(first, divisor);
        ordered_sum(first, (rest.hi + rest.lo) / divisor)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use yardstick::precise::{self, Real};

    fn distance(wide: Wide, exact: &Real) -> f64 {
        precise::to_f64(&(precise::real(wide.hi) + precise::real(wide.lo) - exact)).abs()
    }

    #[test]
    fn sine_and_cosine_agree_with_arbitrary_precision() {
        for step in 0..=200 {
            let x = f64::from(step) / 200.0 * std::f64::consts::FRAC_PI_2;
            let (sin, cos) = Wide::sin_cos(x);
            let (exact_sin, exact_cos) = precise::real(x).sin_cos();
            assert!(distance(sin, &exact_sin) < 1e-30, "sin {x}: {}", distance(sin, &exact_sin));
            assert!(distance(cos, &exact_cos) < 1e-30, "cos {x}: {}", distance(cos, &exact_cos));
        }
    }

    #[test]
    fn quotients_roots_and_arc_tangents_are_wide() {
        for (a, b) in [(1.0, 3.0), (0.1, 7e-9), (2e-5, 0.7), (1e-30, 3e-3), (5.0, 5.0)] {
            let quotient = Wide::from(a) / Wide::from(b);
            let exact = precise::real(a) / precise::real(b);
            assert!(distance(quotient, &exact) <= 4e-32 * (a / b), "{a}/{b}");
            // Of a number that itself has all digits.
            let root = quotient.sqrt();
            assert!(distance(root, &exact.sqrt()) <= 4e-32 * (a / b).sqrt(), "√({a}/{b})");
            for sign in [1.0, -1.0] {
                let angle = Wide::atan2(Wide::from(a), Wide::from(sign * b));
                let exact = precise::real(a).atan2(&precise::real(sign * b));
                assert!(distance(angle, &exact) <= 1e-30 * (a / b).min(1.0).max(if sign < 0.0 { 1.0 } else { 0.0 }));
            }
        }
        assert_eq!(f64::from(Wide::from(0.0).sqrt()), 0.0);
    }

    #[test]
    fn products_and_differences_are_wide() {
        let (a, b) = (1.0 / 3.0, 0.1);
        let exact = precise::real(a) * precise::real(b) - precise::real(1.0 / 30.0);
        let wide = Wide::from(a) * Wide::from(b) - Wide::from(1.0 / 30.0);
        assert!(distance(wide, &exact) <= 1e-33);
        assert!(f64::from(wide) != 0.0);
    }
}
