//! E42 by dice: directions under an even sky, what glass reflects of them, and the ways to draw them wrong.

use crate::figure::{Axis, Plot};
use crate::histogram::histogram;
use crate::vocabulary::{Bench, Check, Measured, check};
use light::optics::fresnel::{diffuse_reflectance, natural_reflectance};
use std::f64::consts::{FRAC_PI_2, TAU};
use yardstick::random::{Stream, uniform};
use yardstick::statistics::{Moments, chi_square, t_test};

/// The relative index of the glass.
const GLASS: f64 = 1.5;

/// cos θ [1] of a direction of the hemisphere, made of two numbers even in 0 … 1.
type Sampler = fn(f64, f64) -> f64;

pub(super) const MEAN: Check<Sampler> =
    check("by_dice", "glass under an even sky reflects on average what the closed form says, direction by direction")
        .against("Walsh's closed form of 1926; Student's t over 2¹⁸ directions drawn by their cosine")
        .significant(1e-3)
        .of(mean_reflectance, cosine_weighted)
        .slip("all directions alike: the cosine of the even sky is forgotten", alike);

pub(super) const ANGLES: Check<Sampler> =
    check("drawn_angles", "the directions drawn have the density 2 cos θ sin θ of an even sky's light")
        .against("χ² of the angles' histogram against the integral of the density over each bin")
        .significant(1e-3)
        .of(polar_histogram, cosine_weighted)
        .slip("the radius on the disc is drawn evenly, and points crowd at its centre", crowded);

/// How many directions are drawn.
///
/// Both checks are [`crate::vocabulary::Bound::PValue`] with a significance of 10⁻³ for the whole curriculum, so that
/// one of about a thousand statistical checks may refuse at 10⁻⁶: 4.9 standard errors, or χ² = 126 for 63 degrees of
/// freedom. Under an even sky R_n of glass is 0.0918 ± 0.1033 (n = 1.5, by quadrature), hence N = 2¹⁸ leaves a standard
/// error of 2.0·10⁻⁴, and with 5 of them to spare (missed once in 3·10⁶) the mean test sees whatever moves R by 9.9 of
/// them, 2.2 %. The slips below move it by 118 (the crowded disc) and more. R_n is skewed by 3.5, but that is odd in
/// the deviation: in a two-sided p the tails make up for one another, each being off by 3.5 (4.9³ − 3·4.9)/(6 √N) = 12
/// % there. The histogram sees a density that is off by δ (rms, relative) once N δ² reaches 240: δ = 3 %.
const DRAWS: usize = 1 << 18;

/// Bins of the histogram, even in θ. The first and poorest expects N sin²(π/128) = 158, so that none is pooled.
const BINS: usize = 64;

/// cos θ [1] of a direction whose density is cos θ/π [sr⁻¹], from `u` and `v` even in 0 … 1: a point drawn evenly on
/// the unit disc is lifted to the hemisphere above it (Malley's method; Pharr, Jakob & Humphreys, *Physically Based
/// Rendering*, 4th ed., §A.5.3). A disc's area grows as r², hence the root.
fn cosine_weighted(u: f64, v: f64) -> f64 {
    lifted(u.sqrt(), v)
}

/// The slip: the radius is drawn evenly, and points crowd at the disc's centre.
fn crowded(u: f64, v: f64) -> f64 {
    lifted(u, v)
}

/// The slip: all directions alike, density 1/2π. Their heights are even (Archimedes), and the cosine of the even sky is
/// forgotten.
fn alike(u: f64, _: f64) -> f64 {
    u
}

/// The height [1] of the unit hemisphere over the point of the disc at `radius` and `turn` [1 of a whole one].
fn lifted(radius: f64, turn: f64) -> f64 {
    let (sin, cos) = (TAU * turn).sin_cos();
    let (x, y) = (radius * cos, radius * sin);
    // Rounding may put a point of the rim just outside.
    (1.0 - x * x - y * y).max(0.0).sqrt()
}

/// [`DRAWS`] cosines.
fn cosines(stream: &mut Stream, sample: Sampler) -> Vec<f64> {
    let mut even = || uniform(stream, 0.0, 1.0);
    (0..DRAWS).map(|_| sample(even(), even())).collect()
}

/// Whether `cos` belongs to a direction of the hemisphere; NaN does not.
fn is_cosine(cos: f64) -> bool {
    (0.0..=1.0).contains(&cos)
}

/// The p-value [1] of the claim that R_n of glass, averaged over the directions that `sample` makes of two even numbers
/// (their cos θ), is what Walsh's closed form says.
fn mean_reflectance(bench: &mut Bench, sample: Sampler) -> Measured {
    let cosines = cosines(&mut bench.stream, sample);
    let mut reflectances = vec![0.0; cosines.len()];
    natural_reflectance(&cosines, 1.0, GLASS, &mut reflectances);
    // What is no direction of the hemisphere has no reflectance either: a cosine of 1.1 would pass for one.
    let found: Moments =
        cosines.iter().zip(reflectances).map(|(&cos, r_n)| if is_cosine(cos) { r_n } else { f64::NAN }).collect();
    let exact = diffuse_reflectance(GLASS);
    let test = t_test(&found, exact);
    let at = format!(
        "mean {:.6} ± {:.6} against {exact:.6}: {:+.2} standard errors",
        found.mean(),
        found.standard_error(),
        test.statistic
    );
    Measured::new(test.p, at, DRAWS)
}

/// The p-value [1] of the claim that the angles of the directions that `sample` makes have the density 2 cos θ sin θ.
fn polar_histogram(bench: &mut Bench, sample: Sampler) -> Measured {
    let edge = |at: usize| at as f64 / BINS as f64 * FRAC_PI_2;
    // The integral of the density is sin² θ; its difference is a product.
    let share = |at: usize| (edge(at + 1) - edge(at)).sin() * (edge(at + 1) + edge(at)).sin();
    let mut expected: Vec<f64> = (0..BINS).map(|at| DRAWS as f64 * share(at)).collect();
    // What is no direction of the hemisphere, NaN too, falls where nothing may.
    expected.push(0.0);
    let mut observed = vec![0; BINS + 1];
    for cos in cosines(&mut bench.stream, sample) {
        let bin = (cos.acos() / FRAC_PI_2 * BINS as f64) as usize;
        observed[if is_cosine(cos) { bin.min(BINS - 1) } else { BINS }] += 1;
    }
    let test = chi_square(&observed, &expected);
    // The bin farthest off; χ² itself says only how far all are.
    let worst = test.deviates().enumerate().max_by(|one, other| one.1.abs().total_cmp(&other.1.abs()));
    let worst = worst.map_or(String::new(), |(bin, deviate)| match bin {
        BINS => "; some are no directions".into(),
        _ => {
            format!("; farthest off: {deviate:+.2} √E near θ = {:.1}°", (edge(bin) + edge(bin + 1)).to_degrees() / 2.0)
        }
    });
    let at = format!("χ² = {:.1}, {} degrees of freedom{worst}", test.statistic, test.dof);
    let edges: Vec<f64> = (0..=BINS).map(|at| edge(at).to_degrees()).collect();
    let axis = Axis::linear("angle to the normal θ", "°").range(0.0, 90.0).tick(15.0);
    Measured::new(test.p, at, DRAWS).picture(Plot::of("Angles drawn", histogram(axis, &edges, &test.bins)))
}

#[cfg(test)]
mod tests {
    use super::*;

    use crate::parameter::Setting;
    use yardstick::statistics::{kolmogorov, sidak};

    const TESTS: [fn(&mut Bench, Sampler) -> Measured; 2] = [mean_reflectance, polar_histogram];

    /// The slip: the angle is drawn evenly, as if every ring of the hemisphere had the same area.
    fn even_in_angle(u: f64, _: f64) -> f64 {
        (FRAC_PI_2 * u).cos()
    }

    fn p_value(test: usize, seed: u64, sample: Sampler) -> f64 {
        let setting = Setting::defaults(&[]);
        TESTS[test](&mut Bench::new(&setting, seed, &format!("hemisphere/{test}")), sample).value
    }

    #[test]
    fn truth_fails_as_often_as_stated() {
        for test in 0..TESTS.len() {
            let p_values: Vec<f64> = (0..50).map(|seed| p_value(test, seed, cosine_weighted)).collect();
            // Even, so that every significance is met; the two tests are refused together once in a thousand.
            let uniformity = kolmogorov(&p_values, |p| p);
            assert!(uniformity >= sidak(1e-3, 2), "{test}: {uniformity} {p_values:?}");
            // Of 50 seeds some 5 ± 2.1 have p ≤ 0.1; 15 or more happen once in 10⁴.
            let refused = p_values.iter().filter(|p| **p <= 0.1).count();
            assert!((1..15).contains(&refused), "{test}: {refused} of 50");
        }
    }

    #[test]
    fn every_slip_is_caught_by_both_on_every_seed() {
        for slip in [crowded, alike, even_in_angle] {
            for test in 0..TESTS.len() {
                for seed in 0..5 {
                    // Far below one share of any curriculum.
                    assert!(p_value(test, seed, slip) < 1e-30);
                }
            }
        }
    }

    #[test]
    fn what_is_no_direction_is_refused() {
        for test in 0..TESTS.len() {
            let p = p_value(test, 0, |u, v| if u < 1e-4 { f64::NAN } else { cosine_weighted(u, v) });
            assert!(p.is_nan() || p == 0.0, "{test}: {p}");
        }
        // One direction in 10⁴ is below the horizon.
        assert_eq!(p_value(1, 0, |u, v| cosine_weighted(u, v) - 1e-2), 0.0);
    }
}
