//! Arithmetic on `L` wavelengths at once: plain arrays that the compiler turns into vector instructions, with
//! the two elementary functions a film needs. Lanes never mix, so a result does not depend on its neighbours.

use std::array::from_fn;
use std::f64::consts::PI;
use std::ops::{Add, Mul, Neg, Sub};

/// `L` real numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lanes<const L: usize>(pub [f64; L]);

impl<const L: usize> Lanes<L> {
    pub const ZERO: Self = Self([0.0; L]);

    pub fn splat(x: f64) -> Self {
        Self([x; L])
    }

    #[inline(always)]
    pub fn map(self, f: impl Fn(f64) -> f64) -> Self {
        Self(from_fn(|i| f(self.0[i])))
    }

    #[inline(always)]
    pub fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Self(from_fn(|i| f(self.0[i], other.0[i])))
    }

    /// These where `x` < 1, `others` elsewhere.
    #[inline(always)]
    pub fn where_below_one(self, x: Self, others: Self) -> Self {
        Self(from_fn(|i| if x.0[i] < 1.0 { self.0[i] } else { others.0[i] }))
    }

    #[inline(always)]
    pub fn squared(self) -> Self {
        self * self
    }

    /// The polynomial Σ cₖ xᵏ, constant term first (Horner).
    #[inline(always)]
    pub fn polynomial(self, coefficients: &[f64]) -> Self {
        let (last, rest) = coefficients.split_last().expect("a coefficient");
        rest.iter().rev().fold(Self::splat(*last), |sum, &c| sum * self + c)
    }
}

impl<const L: usize> Add for Lanes<L> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }
}

impl<const L: usize> Sub for Lanes<L> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.zip(other, |a, b| a - b)
    }
}

impl<const L: usize> Mul for Lanes<L> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.zip(other, |a, b| a * b)
    }
}

impl<const L: usize> Neg for Lanes<L> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(|a| -a)
    }
}

impl<const L: usize> Add<f64> for Lanes<L> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: f64) -> Self {
        self.map(|a| a + other)
    }
}

impl<const L: usize> Mul<f64> for Lanes<L> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: f64) -> Self {
        self.map(|a| a * other)
    }
}

/// `L` complex numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Complexes<const L: usize> {
    pub re: Lanes<L>,
    pub im: Lanes<L>,
}

impl<const L: usize> Complexes<L> {
    pub const ZERO: Self = Self { re: Lanes::ZERO, im: Lanes::ZERO };

    pub fn splat(z: num_complex::Complex64) -> Self {
        Self { re: Lanes::splat(z.re), im: Lanes::splat(z.im) }
    }

    #[inline(always)]
    pub fn norm_sqr(self) -> Lanes<L> {
        self.re.squared() + self.im.squared()
    }

    /// −i z.
    #[inline(always)]
    pub fn times_minus_i(self) -> Self {
        Self { re: self.im, im: -self.re }
    }

    #[inline(always)]
    pub fn scaled(self, factor: Lanes<L>) -> Self {
        Self { re: self.re * factor, im: self.im * factor }
    }
}

impl<const L: usize> Add for Complexes<L> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { re: self.re + other.re, im: self.im + other.im }
    }
}

impl<const L: usize> Sub for Complexes<L> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { re: self.re - other.re, im: self.im - other.im }
    }
}

impl<const L: usize> Mul for Complexes<L> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self { re: self.re * other.re - self.im * other.im, im: self.re * other.im + self.im * other.re }
    }
}

/// A phase α ≥ 0 brought into one half turn: α = remainder + π·turns.
#[derive(Clone, Copy)]
pub(super) struct HalfTurn<const L: usize> {
    /// In [−π/2, π/2] up to rounding.
    pub remainder: Lanes<L>,
    /// Whole number of half turns.
    pub turns: Lanes<L>,
    /// sin(remainder) = ± sin α.
    pub sin: Lanes<L>,
    /// cos(remainder) = ± cos α, with the same sign.
    pub cos: Lanes<L>,
    /// 1 − cos(remainder), with all its digits.
    pub versine: Lanes<L>,
}

// π in three parts (Cody & Waite 1980): the first two have 29 bits, so that a multiple of either below 2²⁴ is exact.
const PI_HIGH: f64 = 3.141592651605606;
const PI_MIDDLE: f64 = 1.9841871548575973e-9;
const PI_LOW: f64 = 4.503483548312435e-18;
/// Phases [rad] up to which `turns` stays below 2²⁴.
const PHASE_LIMIT: f64 = 5e7;
/// 1.5·2⁵²: adding and subtracting it rounds to a whole number, which then stands in the low bits of the sum.
const ROUNDER: f64 = 6755399441055744.0;

// Minimax polynomials of sin and cos on [−π/4, π/4], errors below 2⁻⁵⁸ (FreeBSD msun, k_sin.c and k_cos.c).
const SIN: [f64; 6] = [
    -0.16666666666666632,
    0.00833333333332249,
    -0.0001984126982985795,
    2.7557313707070068e-06,
    -2.5050760253406863e-08,
    1.58969099521155e-10,
];
const COS: [f64; 6] = [
    0.0416666666666666,
    -0.001388888888887411,
    2.480158728947673e-05,
    -2.7557314351390663e-07,
    2.087572321298175e-09,
    -1.1359647557788195e-11,
];

/// Sine and cosine of α ≥ 0 modulo half a turn, each to about 2 ulp.
#[inline(always)]
pub(super) fn half_turn<const L: usize>(alpha: Lanes<L>) -> HalfTurn<L> {
    let turns = (alpha * (1.0 / PI)).map(|x| (x + ROUNDER) - ROUNDER);
    let remainder = ((alpha - turns * PI_HIGH) - turns * PI_MIDDLE) - turns * PI_LOW;
    // Through the half angle, where the short polynomials hold: no quadrants to choose from.
    let h = remainder * 0.5;
    let z = h.squared();
    let sin_h = h + h * z * z.polynomial(&SIN);
    let cos_h = -(z * 0.5 - z.squared() * z.polynomial(&COS)) + 1.0;
    let versine = sin_h.squared() * 2.0;
    let mut half = HalfTurn { remainder, turns, sin: sin_h * cos_h * 2.0, cos: -versine + 1.0, versine };
    if alpha.0.iter().any(|&a| a > PHASE_LIMIT) {
        half.replace_far(alpha);
    }
    half
}

impl<const L: usize> HalfTurn<L> {
    /// Lanes whose phase is beyond the three-part π take the slower way of the standard library.
    #[cold]
    fn replace_far(&mut self, alpha: Lanes<L>) {
        for (i, &a) in alpha.0.iter().enumerate().filter(|(_, a)| **a > PHASE_LIMIT) {
            let (sin, cos) = a.sin_cos();
            let turned = cos < 0.0;
            let (sin, cos) = if turned { (-sin, -cos) } else { (sin, cos) };
            self.sin.0[i] = sin;
            self.cos.0[i] = cos;
            self.versine.0[i] = sin * sin / (1.0 + cos);
            self.remainder.0[i] = sin.atan2(cos);
            self.turns.0[i] = f64::from(turned);
        }
    }
}

// ln 2 in two parts, the first of 32 bits.
const LN2_HIGH: f64 = 0.6931471803691238;
const LN2_LOW: f64 = 1.9082149292705877e-10;
/// 1/k! from k = 2: Taylor's (eʳ − 1 − r)/r², whose remainder for |r| ≤ ln 2 / 2 is below 2⁻⁶².
const EXP: [f64; 13] = [
    1.0 / 2.0,
    1.0 / 6.0,
    1.0 / 24.0,
    1.0 / 120.0,
    1.0 / 720.0,
    1.0 / 5040.0,
    1.0 / 40320.0,
    1.0 / 362880.0,
    1.0 / 3628800.0,
    1.0 / 39916800.0,
    1.0 / 479001600.0,
    1.0 / 6227020800.0,
    1.0 / 87178291200.0,
];

/// e^(−x) for x ≥ 0, in the two forms that keep their digits: where it is small, and where it is near 1.
#[derive(Clone, Copy)]
pub(super) struct Decay<const L: usize> {
    /// e^(−x), to about 2 ulp.
    pub exp: Lanes<L>,
    /// e^(−x) − 1, to about 2 ulp.
    pub exp_m1: Lanes<L>,
}

/// Where e^(−x) leaves the range of normal numbers.
const DECAY_LIMIT: f64 = 708.0;

/// e^(−x) for x ≥ 0; 0 beyond [`DECAY_LIMIT`].
#[inline(always)]
pub(super) fn decay<const L: usize>(x: Lanes<L>) -> Decay<L> {
    let y = x.map(|x| if x < DECAY_LIMIT { -x } else { -DECAY_LIMIT });
    let shifted = y.map(|y| y * std::f64::consts::LOG2_E + ROUNDER);
    let k = shifted.map(|s| s - ROUNDER);
    let r = (y - k * LN2_HIGH) - k * LN2_LOW;
    let exp_m1 = r + r.squared() * r.polynomial(&EXP);
    let power = shifted.map(|s| f64::from_bits((s.to_bits() << 52).wrapping_add(1023 << 52)));
    let part = power * exp_m1;
    Decay {
        exp: (power + part).zip(x, |exp, x| if x < DECAY_LIMIT { exp } else { 0.0 }),
        exp_m1: part + (power + -1.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use yardstick::precise::{real, relative_error};

    fn phases() -> impl Iterator<Item = f64> {
        (0..4000).map(|i| 10f64.powf(f64::from(i) * 0.004 - 6.0)).chain([0.0, PI / 2.0, PI, 7.0 * PI, 1e-300])
    }

    #[test]
    fn sine_and_cosine_keep_their_digits() {
        for alpha in phases() {
            let half = half_turn(Lanes([alpha]));
            let (sin, cos) = real(alpha).sin_cos();
            let sign = if half.turns.0[0] % 2.0 == 0.0 { 1.0 } else { -1.0 };
            assert!(relative_error(sign * half.sin.0[0], &sin) <= 3.0 * f64::EPSILON, "sin {alpha:e}");
            let error = yardstick::precise::to_f64(&(real(sign * half.cos.0[0]) - cos)).abs();
            assert!(error <= 2.0 * f64::EPSILON, "cos {alpha:e}: {error:e}");
        }
    }

    #[test]
    fn decay_keeps_its_digits() {
        for x in phases() {
            let ours = decay(Lanes([x]));
            let exact = -real(x);
            assert!(relative_error(ours.exp_m1.0[0], &exact.exp_m1()) <= 3.0 * f64::EPSILON, "{x:e}");
            if x < DECAY_LIMIT {
                assert!(relative_error(ours.exp.0[0], &exact.exp()) <= 3.0 * f64::EPSILON, "{x:e}");
            } else {
                assert_eq!(ours.exp.0[0], 0.0);
            }
        }
    }
}
