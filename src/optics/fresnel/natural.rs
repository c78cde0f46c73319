//! Natural light: its reflectance at many angles at once, and at all of them together.

use super::{powers, square};
use crate::number::Number;
use crate::optics::incidence::Incidence;
use num_complex::Complex64;

/// Reflectance [1] of a plane interface under diffuse light from a rarer clear medium, 2∫R_n cos θ d(cos θ), for the
/// relative index n > 1 in closed form (Walsh 1926, *The reflection factor of a polished glass surface for diffused
/// light*; Duntley 1942, J. Opt. Soc. Am. 32, 61). A reference: it cancels as n → 1.
pub fn diffuse_reflectance(n: f64) -> f64 {
    let n2 = n * n;
    let (sum, fourth) = (n2 + 1.0, n2 * n2 - 1.0);
    0.5 + (n - 1.0) * (3.0 * n + 1.0) / (6.0 * (n + 1.0) * (n + 1.0))
        + n2 * (n2 - 1.0) * (n2 - 1.0) / (sum * sum * sum) * ((n - 1.0) / (n + 1.0)).ln()
        - 2.0 * n2 * n * (n2 + 2.0 * n - 1.0) / (sum * fourth)
        + 8.0 * n2 * n2 * (n2 * n2 + 1.0) / (sum * fourth * fourth) * n.ln()
}

/// R_n [1] between clear media and q_t/n_i [1], 0 beyond the critical angle, by the products of [`powers`] over n_i²: at
/// one 0 ≤ `cos_i` ≤ 1, from (n_t/n_i)² [1] and that less 1, which the caller knows with more digits.
///
/// One division, of a quotient that `f32` can hold before it is squared, and no branch, so that the compiler can work on
/// several at a time.
#[inline(always)]
pub(crate) fn clear<N: Number>(cos_i: N, index2: N, contrast: N) -> (N, N) {
    let (one, zero) = (N::of(1.0), N::of(0.0));
    let (cos2, sin2) = (cos_i.squared(), (one - cos_i) * (one + cos_i));
    // As in `normal_squared`: near grazing from the cosine, near the normal from the sine.
    let q2 = N::select(cos2.lt(N::of(0.5)), contrast + cos2, index2 - sin2);
    let q = q2.max(zero).sqrt();
    // Where this cancels, at Brewster's angle, s alone counts.
    let balance = index2 * cos2 - sin2;
    let (s, p) = ((cos_i + q).squared(), (index2 * cos_i + q).squared());
    let share = N::of(0.5) * (contrast / (s * p)).squared() * (p.squared() + (balance * s).squared());
    // Asked so that a cosine that is no number gives none: a mean must not take it for total reflection.
    (N::select(q2.le(zero), one, share), q)
}

/// R_n [1] of natural light between clear media, for many cosines of incidence (0 … 1) at once.
///
/// # Panics
/// If the slices differ in length.
pub fn natural_reflectance(cos_i: &[f64], n_i: f64, n_t: f64, out: &mut [f64]) {
    assert_eq!(cos_i.len(), out.len());
    let contrast = ((n_t - n_i) / n_i) * ((n_t + n_i) / n_i);
    if contrast == 0.0 {
        return out.fill(0.0);
    }
    let index2 = (n_t / n_i).squared();
    for (out, &cos) in out.iter_mut().zip(cos_i) {
        (*out, _) = clear(cos, index2, contrast);
    }
}

/// R_n [1] of natural light into an absorbing medium, for many cosines of incidence (0 … 1) at once.
///
/// # Panics
/// If the slices differ in length.
pub fn natural_reflectance_absorbing(cos_i: &[f64], n_i: f64, n_t: Complex64, out: &mut [f64]) {
    assert_eq!(cos_i.len(), out.len());
    let index2 = square(n_t / n_i);
    let kappa = n_t.im / n_i;
    let contrast = Complex64::new(((n_t.re - n_i) / n_i) * ((n_t.re + n_i) / n_i) - kappa * kappa, index2.im);
    let contrast2 = contrast.norm_sqr();
    // As in `normal_squared`.
    let normal_squared = |cos2: f64, sin2: f64| if cos2 < 0.5 { contrast.re + cos2 } else { index2.re - sin2 };
    let outwards = 0.0 < index2.re && index2.re < 1.0;
    for (out, &cos) in out.iter_mut().zip(cos_i) {
        let (cos2, sin2) = (cos * cos, (1.0 - cos) * (1.0 + cos));
        let q2 = normal_squared(cos2, sin2);
        // As in `brewster_balance`.
        let balance = if outwards { q2 - index2.re * sin2 } else { index2.re * cos2 - sin2 };
        let modulus = (q2 * q2 + index2.im * index2.im).sqrt();
        let larger = ((q2.abs() + modulus) * 0.5).sqrt();
        let smaller = 0.5 * index2.im / larger.max(f64::MIN_POSITIVE);
        let q = if q2 >= 0.0 { (larger, smaller) } else { (smaller, larger) };
        let (s_re, p_re, p_im) = (cos + q.0, index2.re * cos + q.0, index2.im * cos + q.1);
        let (s, p) = (s_re * s_re + q.1 * q.1, p_re * p_re + p_im * p_im);
        let turned = index2.im * cos2;
        let balance2 = balance * balance + turned * turned;
        let both = s * p;
        *out = 0.5 * contrast2 * (p * p + balance2 * (s * s)) / (both * both);
    }
    // A trace of absorption near the critical angle, or at the faintest grazing contrast, needs the care that a batch has
    // no room for.
    for (out, &cos) in out.iter_mut().zip(cos_i) {
        let (cos2, sin2) = (cos * cos, (1.0 - cos) * (1.0 + cos));
        let q2 = normal_squared(cos2, sin2).abs();
        let size = if cos2 < 0.5 { contrast.re.abs() } else { index2.re.abs() };
        if q2 < size / 64.0 || q2 + cos2 < 1e-60 {
            *out = powers(Incidence::from_cos(cos), n_i, n_t).r_n();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{angle, extinction, index};
    use super::*;
    use crate::optics::incidence::{Direction, normal_squared};
    use crate::references::fresnel::{Exact, Input, NAMES};
    use proptest::prelude::*;
    use yardstick::precise::relative_error;

    #[test]
    fn a_cosine_that_is_no_number_reflects_no_number() {
        // Into the denser and the rarer medium, and among others that are numbers.
        for n_t in [1.5, 1.0 / 1.5] {
            let mut out = [0.0; 3];
            natural_reflectance(&[0.5, f64::NAN, 1.0], 1.0, n_t, &mut out);
            assert!(out[1].is_nan() && out[0].is_finite() && out[2].is_finite(), "{out:?}");
        }
        let mut out = [0.0];
        natural_reflectance_absorbing(&[f64::NAN], 1.0, Complex64::new(0.2, 3.4), &mut out);
        assert!(out[0].is_nan(), "{out:?}");
    }

    /// Error of one R_n of a batch into an absorbing medium, in ulp · (1 + cond).
    fn error_absorbing(cos: f64, n_i: f64, n_t: Complex64) -> f64 {
        let mut out = [f64::NAN];
        natural_reflectance_absorbing(&[cos], n_i, n_t, &mut out);
        let exact = Exact::new(&Input { direction: Direction::Cos(cos), n_i, n_t });
        let at = NAMES.iter().position(|name| *name == "R_n").expect("an output");
        relative_error(out[0], &exact.outputs[at]) / (f64::EPSILON * (1.0 + exact.conditions()[at]))
    }

    #[test]
    fn a_batch_keeps_the_promise_where_a_trace_of_absorption_meets_the_critical_angle() {
        for (n_i, n) in [(1.5_f64, 1.0), (2.4, 1.0), (1.0, 0.13), (1.7, 1.69)] {
            let critical = ((n_i - n) * (n_i + n)).sqrt() / n_i;
            for k in [1e-300, 1e-30, 1e-16, 1e-12, 1e-8, 1e-5] {
                for offset in [0.0, 1e-16, 3e-16, 1e-14, 1e-12, 1e-9, 1e-6, 1e-3] {
                    for cos in [critical * (1.0 - offset), critical * (1.0 + offset)] {
                        let error = error_absorbing(cos, n_i, Complex64::new(n, k));
                        assert!(error <= 16.0, "{error} at n {n_i} → {n} + {k:e}i, cos θ = {cos}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_batch_keeps_the_promise_at_the_faintest_contrast() {
        for k in [1e-290, 1e-160, 1e-100] {
            for cos in [1e-300, 1e-200, 1e-120, 1e-60] {
                let error = error_absorbing(cos, 1.0, Complex64::new(1.0, k));
                assert!(error <= 16.0, "{error} at κ = {k:e}, cos θ = {cos:e}");
            }
        }
    }

    proptest! {
        #[test]
        fn batches_agree_with_single_evaluations(theta in angle(), n_i in index(), n in index(), k in extinction()) {
            let incidence = Incidence::from_cos(theta.cos());
            let (mut clear, mut absorbing) = ([0.0], [0.0]);
            natural_reflectance(&[incidence.cos()], n_i, n, &mut clear);
            natural_reflectance_absorbing(&[incidence.cos()], n_i, Complex64::new(n, k), &mut absorbing);
            let one_by_one = powers(incidence, n_i, Complex64::new(n, k)).r_n();
            if k > 1e-3 {
                prop_assert!((absorbing[0] / one_by_one - 1.0).abs() < 1e-12, "{} {one_by_one}", absorbing[0]);
            }
            let exact = powers(incidence, n_i, Complex64::from(n)).r_n();
            // Both are within a few ulp · (1 + cond); cond of R near the critical angle goes as 1/|q_t|².
            let q2 = normal_squared(incidence, n_i, Complex64::from(n)).re.abs() / (n_i * n_i);
            let contrast = (n / n_i - 1.0).abs();
            let tolerance = 16.0 * f64::EPSILON * (1.0 + 10.0 / q2 + 10.0 / contrast.max(1e-300));
            prop_assert!((clear[0] - exact).abs() <= tolerance * exact.max(f64::MIN_POSITIVE), "{} {exact}", clear[0]);
        }
    }

    #[test]
    fn diffuse_reflectance_has_the_published_values() {
        // Walsh's factor for n = 1.5 as tabulated by Duntley (1942): 0.092.
        assert!((diffuse_reflectance(1.5) - 0.0918).abs() < 5e-5);
        for n in [1.1, 1.33, 1.5, 2.4] {
            let rule = yardstick::quadrature::gauss_legendre(64);
            let integral: f64 = rule
                .iter()
                .map(|&(cos, weight)| {
                    weight * 2.0 * cos * powers(Incidence::from_cos(cos), 1.0, Complex64::from(n)).r_n()
                })
                .sum();
            assert!((integral - diffuse_reflectance(n)).abs() < 1e-12, "{n}");
        }
    }
}
