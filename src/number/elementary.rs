//! Elementary functions of any width, from arithmetic alone. Series are Taylor's, whose coefficients need no table; each
//! is carried as far as the width asks ([`super::Terms`]).

use super::Number;
use std::f64::consts::{LN_2, LOG2_E, PI};

/// The polynomial Σ cₖ xᵏ of `terms` terms, constant term first (Horner).
#[inline(always)]
pub fn polynomial<N: Number>(x: N, terms: usize, coefficient: impl Fn(usize) -> f64) -> N {
    let mut sum = N::of(coefficient(terms - 1));
    for k in (0..terms - 1).rev() {
        sum = sum * x + N::of(coefficient(k));
    }
    sum
}

/// How many coefficients a table holds.
const LONGEST: usize = 24;

/// 1/k!.
const INVERSE_FACTORIAL: [f64; LONGEST] = {
    let (mut table, mut k, mut factorial) = ([1.0; LONGEST], 1, 1.0);
    while k < LONGEST {
        factorial *= k as f64;
        table[k] = 1.0 / factorial;
        k += 1;
    }
    table
};

/// (−1)ᵏ/(2k + 1).
const ALTERNATING_ODD: [f64; LONGEST] = {
    let (mut table, mut k) = ([1.0; LONGEST], 1);
    while k < LONGEST {
        table[k] = if k % 2 == 0 { 1.0 } else { -1.0 } / (2 * k + 1) as f64;
        k += 1;
    }
    table
};

/// (−1)ᵏ.
#[inline(always)]
fn alternating(k: usize) -> f64 {
    if k.is_multiple_of(2) { 1.0 } else { -1.0 }
}

/// Sine and cosine of `turns` full turns, −1 ≤ turns ≤ 1, to 2 ε.
#[inline(always)]
pub fn sin_cos_turns<N: Number>(turns: N) -> (N, N) {
    // A quarter turn to either side of the nearest axis, which is exact.
    let quarters = (turns * N::of(4.0)).round();
    let x = (turns - quarters * N::of(0.25)) * N::of(2.0 * PI);
    let x2 = x.squared();
    let terms = N::TERMS.sine;
    let sin = x - x * x2 * polynomial(x2, terms - 1, |k| alternating(k) * INVERSE_FACTORIAL[2 * k + 3]);
    let cos = N::of(1.0) - x2 * polynomial(x2, terms - 1, |k| alternating(k) * INVERSE_FACTORIAL[2 * k + 2]);
    // Odd quarters exchange the two; half turns change both signs.
    let halves = (quarters * N::of(0.5)).round();
    let rest = quarters - halves * N::of(2.0);
    let exchanged = rest.abs().gt(N::of(0.5));
    // rest·(2|…|): cos(π/2 · rest) is 1 or 0 and sin is rest, so that the sum of angles is a choice.
    let sign = N::of(1.0) - N::of(2.0) * (halves - (halves * N::of(0.5)).round() * N::of(2.0)).abs();
    let (turned_sin, turned_cos) = (rest * cos, -(rest * sin));
    (sign * N::select(exchanged, turned_sin, sin), sign * N::select(exchanged, turned_cos, cos))
}

/// e^x, to 2 ε; 0 where it leaves the range of normal numbers. For x below 80.
#[inline(always)]
pub fn exp<N: Number>(x: N) -> N {
    let least = N::of(N::TERMS.least_exponent);
    let clamped = x.max(least);
    let k = (clamped * N::of(LOG2_E)).round();
    // ln 2 in two parts, the first of so few bits that k times it is exact in either width.
    let r = (clamped - k * N::of(LN_2_HIGH)) - k * N::of(LN_2_LOW);
    let series = polynomial(r, N::TERMS.exponential - 2, |k| INVERSE_FACTORIAL[k + 2]);
    let value = N::power_of_two(k) * (N::of(1.0) + (r + r.squared() * series));
    N::select(x.lt(least), N::of(0.0), value)
}

/// ln 2 cut to 12 bits, so that multiples up to 1024 are exact in `f32`, and what is left of it.
const LN_2_HIGH: f64 = 2839.0 / 4096.0;
const LN_2_LOW: f64 = (LN_2 - LN_2_HIGH) + 2.3190468138462996e-17;

/// ln x for normal x > 0, to 2 ε.
#[inline(always)]
pub fn ln<N: Number>(x: N) -> N {
    let (mantissa, exponent) = x.split();
    let s = (mantissa - N::of(1.0)) / (mantissa + N::of(1.0));
    let s2 = s.squared();
    let twice = s + s;
    let tail = s2 * polynomial(s2, N::TERMS.logarithm - 1, |k| ALTERNATING_ODD[k + 1].abs());
    exponent * N::of(LN_2_HIGH) + (twice + (twice * tail + exponent * N::of(LN_2_LOW)))
}

/// ln(1 + x) for x ≥ 0, to 4 ε (W. Kahan's quotient, in which the rounding of 1 + x cancels).
#[inline(always)]
pub fn ln_1p<N: Number>(x: N) -> N {
    let sum = N::of(1.0) + x;
    let step = sum - N::of(1.0);
    let is_lost = step.le(N::of(0.0));
    let step = N::select(is_lost, N::of(1.0), step);
    N::select(is_lost, x, ln(sum) * (x / step))
}

/// tan of half the angle.
#[inline(always)]
fn halved<N: Number>(tan: N) -> N {
    tan / (N::of(1.0) + (N::of(1.0) + tan.squared()).sqrt())
}

/// The angle [rad] of the point (x, y) from the x axis, for x ≥ 0, y ≥ 0, not both 0; to 4 ε.
#[inline(always)]
pub fn atan2<N: Number>(y: N, x: N) -> N {
    // tan of the half angle is at most 1, of a quarter tan π/8, of an eighth tan π/16.
    let half = y / (x + (x.squared() + y.squared()).sqrt());
    let eighth = halved(halved(half));
    let square = eighth.squared();
    let tail = square * polynomial(square, N::TERMS.arctangent - 1, |k| ALTERNATING_ODD[k + 1]);
    N::of(8.0) * (eighth + eighth * tail)
}

/// What is left of a Gaussian.
#[derive(Clone, Copy, Debug)]
pub struct Erfcx<N> {
    /// e^(x²) erfc x.
    pub scaled: N,
    /// 1 − √π x e^(x²) erfc x, which is 1/(2x²) far out: by itself, so that it keeps its digits there.
    pub rest: N,
}

/// e^(x²) erfc x and its distance from its asymptote, for x ≥ 0, given as the quotient `above`/`below` of which either
/// may be 0. To 4 ε.
///
/// erfcx x = (x/π)∫e^(−t²)/(x² + t²)dt by the midpoint rule of step h, whose only error is the pole at t = ix: as long as
/// that is within reach, x < π/h, it is known and added (F. Matta and A. Reichel, *Math. Comp.* 25 (1971) 339); what then
/// is left, e^(−(π/h)²), is below rounding.
#[inline(always)]
pub fn erfcx<N: Number>(above: N, below: N) -> Erfcx<N> {
    let (count, step) = N::TERMS.gaussian;
    let (above2, below2) = (above.squared(), below.squared());
    let (mut sum, mut rest) = (N::of(0.0), N::of(0.0));
    for k in (0..count).rev() {
        let t2 = ((k as f64 + 0.5) * step).powi(2);
        let share = N::of((-t2).exp()) / (above2 + below2 * N::of(t2));
        sum = sum + share;
        rest = rest + share * N::of(t2);
    }
    let reach = PI / step;
    let is_near = above.lt(below * N::of(reach));
    let x = N::select(is_near, above, N::of(0.0)) / N::select(is_near, below, N::of(1.0));
    let pole = (N::of(2.0) * exp(x.squared()) / (N::of(1.0) + exp(x * N::of(2.0 * reach)))).only(is_near);
    Erfcx {
        scaled: N::of(2.0 * step / PI) * (above * below) * sum + pole,
        rest: N::of(2.0 * step / PI.sqrt()) * below2 * rest - N::of(PI.sqrt()) * x * pole,
    }
}

/// Euler's integral B(x, y) for x, y ≥ 1, to 1e−11 or 30 ε of the larger of x, y and 1/B's exponent; symmetric to the bit.
#[inline(always)]
pub fn beta<N: Number>(x: N, y: N) -> N {
    let (small, large) = (x.min(y), x.max(y));
    let lift = lift(small, large, 0) + lift(small, large, SHIFT / 2);
    let by = N::of(SHIFT as f64);
    let (small, large) = (small + by, large + by);
    let sum = small + large;
    let half = N::of(0.5);
    let exponent = -((large - half) * ln_1p(small / large)) - (small - half) * ln_1p(large / small)
        + stirling(small)
        + (stirling(large) - stirling(sum));
    exp(lift + exponent) * (N::of(2.0 * PI) / sum).sqrt()
}

/// By how much the arguments of [`beta`] are raised, until Stirling's series is good.
const SHIFT: usize = 6;

/// ln of half of the factors (x + y)(x + y + 1)/(x y) by which B(x, y) exceeds B(x + 1, y + 1): all of them together would
/// leave the range of `f32`.
#[inline(always)]
fn lift<N: Number>(small: N, large: N, from: usize) -> N {
    let sum = small + large;
    let mut product = N::of(1.0);
    for k in from..from + SHIFT / 2 {
        let k = k as f64;
        let even = (sum + N::of(2.0 * k)) / (large + N::of(k));
        product = product * even * ((sum + N::of(2.0 * k + 1.0)) / (small + N::of(k)));
    }
    ln(product)
}

/// ln Γ(x) less (x − ½) ln x − x + ½ ln 2π, for x ≥ 7 (DLMF 5.11.1), to 2e−12.
#[inline(always)]
fn stirling<N: Number>(x: N) -> N {
    let inverse = N::of(1.0) / x;
    let series = [1.0 / 12.0, -1.0 / 360.0, 1.0 / 1260.0, -1.0 / 1680.0, 1.0 / 1188.0];
    inverse * polynomial(inverse.squared(), series.len(), |k| series[k])
}
