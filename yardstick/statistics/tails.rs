//! How rare a deviate is: tails of the normal, Student's and the χ² distribution, with relative accuracy down to the
//! smallest numbers there are.
//!
//! Own code but for erfc and ln Γ (`libm`), since none of the crates is right far out: at 10⁶ degrees of freedom `statrs`
//! 0.19.1 is off by 6·10⁻¹⁰ (Q) and 4·10⁻⁹ (Student), and its erfc by 10⁻¹⁰ anywhere; `puruspe` 0.4.4 gives 0 for Q
//! below 10⁻⁸⁸ and misses Student's p by a tenth; `special` 0.14.2 has no upper tail at all. They take the difference
//! of numbers like a ln a; the factors here are C. Loader's, "Fast and accurate computation of binomial probabilities"
//! (2000), in which the large parts have cancelled on paper.

use std::f64::consts::{PI, SQRT_2, TAU};

/// The probability [1] that a standard normal deviate is at least as far from zero as `z` [1]: erfc(|z|/√2).
pub fn normal_two_sided(z: f64) -> f64 {
    libm::erfc(z.abs() / SQRT_2)
}

/// The probability [1] that Student's t with `dof` > 0 degrees of freedom, whole or not, is at least as far from zero
/// as `t` [1]: I_x(ν/2, ½) with x = ν/(ν + t²) (*DLMF* §8.17). An infinite `dof` makes it the normal one.
pub fn student_two_sided(t: f64, dof: f64) -> f64 {
    if dof == f64::INFINITY {
        return normal_two_sided(t);
    }
    if t.is_nan() || dof.is_nan() || dof <= 0.0 {
        return f64::NAN;
    }
    let a = 0.5 * dof;
    let slope = t.abs() / dof.sqrt();
    if slope == f64::INFINITY {
        return 0.0;
    }
    // x and y = 1 − x, each from its own side.
    let secant = 1f64.hypot(slope);
    let (x, y) = ((1.0 / secant).powi(2), (slope / secant).powi(2));
    // x^a: a power where x is small and a logarithm where it is near 1, lest either side lose digits.
    let power = if slope > 1.0 { secant.powf(-dof) } else { (-a * (slope * slope).ln_1p()).exp() };
    // x^a √y / B(a, ½)
    let front = power * (slope / secant) * gamma_half_step(a) / PI.sqrt();
    if y * (a + 2.5) < 1.5 {
        // I_y(½, a) = 2 front Σ Π (a + ½ + k)/(3/2 + k) y (DLMF 8.17.8 with 15.8.1), all terms positive.
        let mut rest = 1.0;
        let mut term = 1.0;
        let mut k = 0.0;
        while term > f64::EPSILON / 8.0 * rest {
            term *= y * (a + 0.5 + k) / (1.5 + k);
            rest += term;
            k += 1.0;
        }
        return 1.0 - 2.0 * front * rest;
    }
    // The even part of the usual fraction, BFRAC of A. R. DiDonato & A. H. Morris, ACM Trans. Math. Softw. 18 (1992)
    // 360, with b = ½: in it 1 − x does not appear but as y, and many degrees of freedom make it Legendre's below.
    let lambda = a * y - 0.5 * x;
    let step = |k: u32| {
        let k = f64::from(k);
        let turn = k * (0.5 - k) * x;
        let (odd, even) = (a + 2.0 * k - 1.0, a + 2.0 * k + 1.0);
        let numerator = (a + k - 1.0) / odd * ((a + k - 0.5) / odd) * turn * x;
        (numerator, k + turn / odd + (a + k) / even * (lambda + 1.0 + k * (1.0 + y)))
    };
    front / continued_fraction(a / (a + 1.0) * (lambda + 1.0), step)
}

/// Γ(a + ½)/Γ(a) [1] for a > 0.
fn gamma_half_step(mut a: f64) -> f64 {
    // Γ(a + 1) = a Γ(a) leads to where the series holds.
    let mut steps = 1.0;
    while a < 16.0 {
        steps *= a / (a + 0.5);
        a += 1.0;
    }
    // The logarithm's series in 1/a (DLMF 5.11.8 at h = ½ and 0); the next term, 0.004/a¹¹, is below rounding.
    const SERIES: [f64; 5] = [-1.0 / 8.0, 1.0 / 192.0, -1.0 / 640.0, 17.0 / 14336.0, -31.0 / 18432.0];
    let square = 1.0 / (a * a);
    let log = SERIES.iter().rev().fold(0.0, |sum, term| sum * square + term) / a;
    steps * a.sqrt() * log.exp()
}

/// The probability [1] that χ² with `dof` > 0 degrees of freedom is at least `statistic` ≥ 0: Q(ν/2, χ²/2).
/// Sums over some √`dof` terms.
pub fn chi_square_tail(statistic: f64, dof: f64) -> f64 {
    upper_gamma(0.5 * dof, 0.5 * statistic)
}

/// The regularised upper incomplete gamma function Q(a, x) = Γ(a, x)/Γ(a) [1] for a > 0 finite and x ≥ 0 (*DLMF* §8.2);
/// NaN outside.
pub fn upper_gamma(a: f64, x: f64) -> f64 {
    if !(a > 0.0 && a.is_finite() && x >= 0.0) {
        return f64::NAN;
    }
    let mu = (x - a) / a;
    if x == 0.0 || mu == f64::INFINITY {
        return if x == 0.0 { 1.0 } else { 0.0 };
    }
    // x^a e^(−x) / Γ(a)
    let front = (-a * excess(mu, x / a) - stirling(a)).exp() * (a / TAU).sqrt();
    if x < a + 1.0 {
        // DLMF 8.11.4, all terms positive; Q is at least 0.08 here.
        let mut sum = 1.0;
        let mut term = 1.0;
        let mut k = 1.0;
        while term > f64::EPSILON / 8.0 * sum {
            term *= x / (a + k);
            sum += term;
            k += 1.0;
        }
        return 1.0 - front / a * sum;
    }
    // Legendre's fraction (DLMF 8.9.2, contracted).
    let first = x + 1.0 - a;
    let step = |k: u32| {
        let k = f64::from(k);
        (k * (a - k), first + 2.0 * k)
    };
    front / continued_fraction(first, step)
}

/// μ − ln(1 + μ) [1] for μ > −1, without the cancellation near 0; `ratio` is 1 + μ, which μ does not know well near −1.
fn excess(mu: f64, ratio: f64) -> f64 {
    let v = mu / (2.0 + mu);
    if v.abs() > 0.1 {
        return mu - ratio.ln();
    }
    // ln(1 + μ) = 2 artanh v, and μ − 2v = μ v.
    let square = v * v;
    let series = (0..8).rev().fold(0.0, |sum, k| sum * square + 1.0 / f64::from(2 * k + 3));
    mu * v - 2.0 * v * square * series
}

/// The remainder of Stirling's formula, ln Γ(a) − (a − ½) ln a + a − ½ ln 2π [1], for a > 0.
fn stirling(a: f64) -> f64 {
    if a < 8.0 {
        return libm::lgamma(a) - ((a - 0.5) * a.ln() - a + 0.5 * TAU.ln());
    }
    // DLMF 5.11.1; the next term, 0.18/a¹⁷, is below rounding.
    const SERIES: [f64; 8] = [
        1.0 / 12.0,
        -1.0 / 360.0,
        1.0 / 1260.0,
        -1.0 / 1680.0,
        1.0 / 1188.0,
        -691.0 / 360_360.0,
        1.0 / 156.0,
        -3617.0 / 122_400.0,
    ];
    let square = 1.0 / (a * a);
    SERIES.iter().rev().fold(0.0, |sum, term| sum * square + term) / a
}

/// b₀ + a₁/(b₁ + a₂/(b₂ + …)) with `step(k)` = (a_k, b_k), by Lentz's method (Thompson & Barnett 1986) until a step
/// changes nothing.
fn continued_fraction(b_0: f64, step: impl Fn(u32) -> (f64, f64)) -> f64 {
    // Stands for a denominator that vanishes.
    let nonzero = |x: f64| if x == 0.0 { f64::MIN_POSITIVE } else { x };
    let mut value = nonzero(b_0);
    let (mut c, mut d) = (value, 0.0);
    // √(10¹²) steps would be an `a` of 10¹²; nothing in the domain that is tested needs more than some thousands.
    for k in 1..10_000_000 {
        let (a, b) = step(k);
        d = 1.0 / nonzero(b + a * d);
        c = nonzero(b + a / c);
        value *= c * d;
        if (c * d - 1.0).abs() <= f64::EPSILON {
            break;
        }
    }
    value
}

#[cfg(test)]
mod tests {
    use super::{chi_square_tail, gamma_half_step, normal_two_sided, stirling, student_two_sided, upper_gamma};
    use crate::statistics::references::{CHI_SQUARE, NORMAL, STUDENT};
    use proptest::prelude::*;

    /// |relative error| in ulp · (1 + cond), cond the condition number |x p′/p| [1].
    fn ratio(value: f64, reference: f64, condition: f64) -> f64 {
        (value / reference - 1.0).abs() / (f64::EPSILON * (1.0 + condition))
    }

    #[test]
    fn chi_square_keeps_its_digits() {
        for &(dof, statistic, p) in CHI_SQUARE {
            let (a, x) = (0.5 * dof, 0.5 * statistic);
            // κ = x^a e^(−x) / (Γ(a) Q); from the difference of neighbours, which need not be good.
            let h = 1e-5 * x / a.sqrt();
            let condition = (x * (upper_gamma(a, x + h) - upper_gamma(a, x - h)) / (2.0 * h * p)).abs();
            let found = ratio(chi_square_tail(statistic, dof), p, condition);
            assert!(found <= 4.0, "dof {dof}, χ² {statistic}: {found} ε(1 + {condition})");
        }
    }

    #[test]
    fn student_keeps_its_digits() {
        for &(dof, t, p) in STUDENT {
            // t p′/p tends to t² (normal) or dof (a power law), whichever is less.
            let condition = (t * t).min(dof);
            let found = ratio(student_two_sided(t, dof), p, condition);
            assert!(found <= 4.0, "dof {dof}, t {t}: {found} ε(1 + {condition})");
            assert_eq!(student_two_sided(-t, dof), student_two_sided(t, dof));
        }
    }

    #[test]
    fn normal_keeps_its_digits() {
        for &(z, p) in NORMAL {
            // Below 2⁻¹⁰²² numbers have fewer digits.
            let found = ratio(normal_two_sided(z), p, if p < f64::MIN_POSITIVE { 1e16 } else { z * z });
            assert!(found <= 16.0, "z {z}: {found}");
            assert_eq!(normal_two_sided(-z), normal_two_sided(z));
        }
    }

    #[test]
    fn closed_forms() {
        for x in [1e-300, 1e-3, 0.3, 1.0, 2.0, 5.0, 30.0, 700.0] {
            // dof = 1: a squared normal deviate; 2: exponential; 4: by parts.
            assert!(ratio(chi_square_tail(x, 1.0), normal_two_sided(x.sqrt()), x) <= 16.0, "{x}");
            assert!(ratio(chi_square_tail(x, 2.0), (-0.5 * x).exp(), x) <= 16.0, "{x}");
            assert!(ratio(chi_square_tail(x, 4.0), (-0.5 * x).exp() * (1.0 + 0.5 * x), x) <= 16.0, "{x}");
            // dof = 1: Cauchy's; 2: 1 − t/√(2 + t²).
            assert!(ratio(student_two_sided(x, 1.0), (1.0_f64).atan2(x) / std::f64::consts::FRAC_PI_2, 1.0) <= 16.0);
            let root = (2.0 + x * x).sqrt();
            assert!(ratio(student_two_sided(x, 2.0), 2.0 / (root * (root + x)), 2.0) <= 16.0, "{x}");
        }
    }

    #[test]
    fn ends_of_the_domain() {
        for dof in [1e-300, 0.5, 1.0, 7.0, 1e6, 1e9] {
            assert_eq!((chi_square_tail(0.0, dof), chi_square_tail(f64::INFINITY, dof)), (1.0, 0.0), "{dof}");
            assert_eq!((student_two_sided(0.0, dof), student_two_sided(f64::INFINITY, dof)), (1.0, 0.0), "{dof}");
            for x in [f64::MIN_POSITIVE, 1e-320, 1e-100, 1e100, f64::MAX] {
                assert!((0.0..=1.0).contains(&chi_square_tail(x, dof)), "dof {dof}, χ² {x}");
                assert!((0.0..=1.0).contains(&student_two_sided(x, dof)), "dof {dof}, t {x}");
            }
        }
        assert_eq!(student_two_sided(2.0, f64::INFINITY), normal_two_sided(2.0));
        assert_eq!((normal_two_sided(0.0), normal_two_sided(f64::INFINITY)), (1.0, 0.0));
        // A power law far out: p → 2/(π t).
        assert!(ratio(student_two_sided(1e200, 1.0), 2e-200 / std::f64::consts::PI, 1.0) <= 16.0);
        for refused in [
            chi_square_tail(-1.0, 3.0),
            chi_square_tail(1.0, 0.0),
            chi_square_tail(f64::NAN, 3.0),
            chi_square_tail(1.0, f64::INFINITY),
            student_two_sided(f64::NAN, 3.0),
            student_two_sided(1.0, 0.0),
            student_two_sided(1.0, f64::NAN),
            normal_two_sided(f64::NAN),
        ] {
            assert!(refused.is_nan());
        }
    }

    #[test]
    fn both_branches_meet() {
        let jump = |below: f64, above: f64| (below / above - 1.0).abs() / f64::EPSILON;
        for a in [0.5, 3.0, 15.9, 16.1, 1e3, 5e5_f64] {
            // The series below x = a + 1, the fraction from there on; κ is about √a.
            let (below, above) = (upper_gamma(a, (a + 1.0).next_down()), upper_gamma(a, a + 1.0));
            assert!(jump(below, above) <= 16.0 * (1.0 + a.sqrt()), "{a}: {below} {above}");
        }
        let (below, above) = (gamma_half_step(16f64.next_down()), gamma_half_step(16.0));
        assert!(jump(below, above) <= 16.0, "{below} {above}");
    }

    #[test]
    fn stirlings_remainder_climbs_by_one() {
        // From Γ(a + 1) = a Γ(a): μ(a) − μ(a + 1) = (a + ½) ln(1 + 1/a) − 1 (Binet). Below 8 numbers up to 20 cancel.
        for at in 1..400 {
            let a = f64::from(at) / 16.0;
            let step = (a + 0.5) * (1.0 / a).ln_1p() - 1.0;
            let allowed = if a < 8.0 { 1e-14 } else { 5e-16 };
            assert!((stirling(a) - stirling(a + 1.0) - step).abs() <= allowed, "{a}");
        }
    }

    proptest! {
        #[test]
        fn tails_fall_and_stay_within_0_and_1(log_dof in 0.0..6.0_f64, log in -8.0..8.0_f64, step in 1e-6..1.0_f64) {
            let dof = 10f64.powf(log_dof);
            let x = 10f64.powf(log);
            let further = x * (1.0 + step);
            for tail in [chi_square_tail as fn(f64, f64) -> f64, student_two_sided] {
                let (near, far) = (tail(x, dof), tail(further, dof));
                prop_assert!((0.0..=1.0).contains(&near) && (0.0..=1.0).contains(&far), "{near} {far}");
                prop_assert!(far <= near * (1.0 + 1e-12), "{near} {far}");
            }
        }

        #[test]
        fn two_more_degrees_of_freedom(log_dof in 0.0..4.0_f64, factor in 0.2..3.0_f64) {
            // Q(a + 1, x) = Q(a, x) + x^a e^(−x)/Γ(a + 1) (DLMF 8.8.6).
            let a = 0.5 * 10f64.powf(log_dof);
            let x = a * factor;
            let term = (a * x.ln() - x - libm::lgamma(a + 1.0)).exp();
            let expected = upper_gamma(a, x) + term;
            prop_assert!((upper_gamma(a + 1.0, x) - expected).abs() <= 1e-10 * expected + 1e-300);
        }
    }
}
