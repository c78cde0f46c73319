//! Whether a relief has the slopes and the correlation it was asked for.

use super::super::synthesis::normal_pair;
use super::smith::Smith;
use super::{Relief, even, gaussian};
use num_complex::Complex64;
use proptest::prelude::*;
use yardstick::statistics::{kolmogorov, normal_two_sided};

/// How far from its distribution a sample of (1024/8)² = 16 384 patches may be at the worst: 0.64/√N, where Kolmogorov's
/// test of so many independent slopes would have p = 0.8; a patch holds a few slopes, not one.
const NEAR: f64 = 5e-3;

#[test]
fn gaussian_slopes_are_beckmanns() {
    for alpha in [0.1, 0.5] {
        let relief = gaussian(alpha);
        let distance = relief.distance(|slope| Smith::Beckmann.below(slope / alpha));
        assert!(distance < NEAR, "{alpha}: {distance}");
        // The slip: α for the root mean square of one component.
        assert!(relief.distance(|slope| Smith::Beckmann.below(slope / alpha * 0.5_f64.sqrt())) > 0.1);
        assert!((relief.mean_square_slope() / (alpha * alpha) - 1.0).abs() < 1e-12);
    }
}

#[test]
fn a_mixture_of_gaussians_has_the_slopes_of_ggx() {
    let alpha = 0.5;
    let relief = Relief::ggx(1024, [8.0, 128.0], alpha, even(1, "relief/ggx")).expect("a valid relief");
    let distance = relief.distance(|slope| Smith::Ggx.below(slope / alpha));
    assert!(distance < NEAR, "{distance}");
    assert!(relief.distance(|slope| Smith::Beckmann.below(slope / alpha)) > 0.05);
}

#[test]
fn the_noise_is_normal() {
    let mut even = even(1, "relief/noise");
    let pairs: Vec<_> = (0..20_000).map(|_| normal_pair(&mut even)).collect();
    // The distribution function at z is half of what lies beyond |z| on both sides, from the end that z is nearer to.
    let below = |z: f64| if z < 0.0 { 0.5 * normal_two_sided(z) } else { 1.0 - 0.5 * normal_two_sided(z) };
    for turn in [Complex64::ONE, Complex64::I, Complex64::from_polar(1.0, 0.7)] {
        let parts: Vec<f64> = pairs.iter().map(|pair| (pair * turn).re).collect();
        let p = kolmogorov(&parts, below);
        assert!(p > 1e-3, "{p}");
    }
}

#[test]
fn the_distance_is_that_of_a_step() {
    // All facets are level: the stairs go from 0 to 1 at once, and c is off by c below them and 1 − c above.
    let flat = Relief::flat(2).expect("valid");
    assert_eq!((flat.distance(|_| 0.25), flat.distance(|_| 0.875)), (0.75, 0.875));
    assert!(flat.distance(|_| f64::NAN).is_nan());
}

#[test]
fn heights_are_correlated_as_asked() {
    let (side, length) = (1024, 8);
    let relief = gaussian(0.3);
    let product = |dx: usize, dy: usize| -> f64 {
        let height = |x: usize, y: usize| relief.heights()[(y % side) * side + x % side];
        (0..side * side).map(|at| height(at % side, at / side) * height(at % side + dx, at / side + dy)).sum()
    };
    let variance = product(0, 0);
    for (dx, dy) in [(4, 0), (length, 0), (0, length), (length, length), (2 * length, 0), (5 * length, 3 * length)] {
        let due = (-((dx * dx + dy * dy) as f64) / (length * length) as f64).exp();
        let found = product(dx, dy) / variance;
        // 16 384 patches know a correlation to 1/128; three of these.
        assert!((found - due).abs() < 3.0 / 128.0, "({dx}, {dy}): {found} for {due}");
    }
    // ⟨s²⟩ = 4σ²/ℓ², less what cells of an eighth of ℓ smooth away: 1/(2·64) of it, to first order. Two quantities, each known to
    // 1/128; three of these.
    let ratio = relief.mean_square_slope() * (length * length) as f64 / (4.0 * variance / (side * side) as f64);
    assert!((ratio - (1.0 - 1.0 / 128.0)).abs() < 3.0 / 128.0 * 2.0_f64.sqrt(), "{ratio}");
}

#[test]
fn what_cannot_be_is_refused_by_name() {
    let gaussian = |side, length, alpha| Relief::gaussian(side, length, alpha, even(1, "refused")).map(|_| ());
    let ggx = |slower| Relief::ggx(64, [4.0, slower], 0.5, even(1, "refused")).map(|_| ());
    for (refused, place) in [
        (gaussian(100, 4.0, 0.5), "side"),
        (gaussian(1, 0.25, 0.5), "side"),
        (gaussian(1 << 14, 4.0, 0.5), "side"),
        (gaussian(64, 0.5, 0.5), "correlation"),
        (gaussian(64, 17.0, 0.5), "correlation"),
        (gaussian(64, f64::NAN, 0.5), "correlation"),
        (gaussian(64, 4.0, 0.0), "alpha"),
        (gaussian(64, 4.0, f64::NAN), "alpha"),
        (gaussian(64, 4.0, f64::INFINITY), "alpha"),
        (ggx(3.0), "slower"),
        (ggx(20.0), "slower"),
        (ggx(f64::NAN), "slower"),
        (Relief::new(4, vec![0.0; 15]).map(|_| ()), "heights"),
        (Relief::new(2, vec![0.0, 1.0, f64::NAN, 0.0]).map(|_| ()), "heights"),
        (Relief::new(2, vec![0.0, 1.0, -1e13, 0.0]).map(|_| ()), "heights"),
        (Relief::flat(3).map(|_| ()), "side"),
    ] {
        assert_eq!(refused.expect_err(place).place, place);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]
    #[test]
    fn every_valid_relief_has_its_roughness(
        bits in 1_u32..8, share in 0.0..=1.0_f64, alpha in 1e-4..=10.0_f64, seed in any::<u64>(),
    ) {
        let side = 1_usize << bits;
        prop_assume!(side >= 4);
        let length = 1.0 + share * (side as f64 / 4.0 - 1.0);
        let relief = Relief::gaussian(side, length, alpha, even(seed, "relief/any")).expect("valid");
        prop_assert!((relief.mean_square_slope().sqrt() / alpha - 1.0).abs() < 1e-12);
        prop_assert_eq!(relief.heights().len(), side * side);
        prop_assert_eq!(relief.slopes().count(), 2 * side * side);
        let highest = relief.heights().iter().copied().fold(f64::NEG_INFINITY, f64::max);
        prop_assert_eq!(relief.top(), highest);
        let mixed = Relief::ggx(side, [length, side as f64 / 4.0], alpha, even(seed, "relief/any")).expect("valid");
        prop_assert!(mixed.heights().iter().all(|height| height.is_finite()));
    }
}
