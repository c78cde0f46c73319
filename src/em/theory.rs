//! What the grid does to waves, in closed form.
//!
//! T&H §4.5 (dispersion) and §4.7 (stability). A plane wave on a cubic grid obeys
//! sin²(ωΔt/2)/S² = Σ sin²(k_iΔ/2), with S = cΔt/Δ and c that of the medium.

use num_complex::Complex64;

/// Largest stable Courant number S = cΔt/Δ [1] in `dimensions` (1 to 3): 1/√dimensions.
pub fn courant_limit(dimensions: u32) -> f64 {
    (1.0 / f64::from(dimensions)).sqrt()
}

/// ωΔt [rad] of the plane wave whose components kΔ [rad] are given, at Courant number S: real below the limit;
/// above it the real part is π and the imaginary part, in e^(−iωt), how fast it grows.
pub fn phase_per_step(k: &[f64], courant: f64) -> Complex64 {
    let sine = courant * k.iter().map(|k| (0.5 * k).sin().powi(2)).sum::<f64>().sqrt();
    if sine <= 1.0 {
        return Complex64::new(2.0 * sine.asin(), 0.0);
    }
    Complex64::new(std::f64::consts::PI, growth_per_step(sine))
}

/// ln of what the fastest-growing wave is multiplied by at each step [1], when S is `excess` times the limit:
/// sin(ωΔt/2) = S√d > 1 gives 2 arcosh(S√d); 0 up to the limit.
pub fn growth_per_step(excess: f64) -> f64 {
    let beyond = excess - 1.0;
    if beyond > 0.0 { 2.0 * (beyond + (beyond * (excess + 1.0)).sqrt()).ln_1p() } else { 0.0 }
}

/// Phase velocity on the grid over that of the medium [1], for a wave vector kΔ [rad] at Courant number S below
/// the limit.
pub fn phase_velocity(k: &[f64], courant: f64) -> f64 {
    let norm = k.iter().map(|k| k * k).sum::<f64>().sqrt();
    phase_per_step(k, courant).re / (courant * norm)
}

#[cfg(test)]
mod tests {
    use super::*;
    use yardstick::order;

    #[test]
    fn speed_error_is_of_second_order_and_vanishes_at_the_magic_step() {
        let points: Vec<_> =
            (3..9).map(|p| f64::from(1 << p)).map(|n| (n, 1.0 - phase_velocity(&[6.0 / n], 0.5))).collect();
        assert!((order::slope(&points).unwrap() + 2.0).abs() < 0.05);
        assert!((phase_velocity(&[0.7], 1.0) - 1.0).abs() < 1e-15);
        assert!((phase_velocity(&[0.7, 0.7], courant_limit(2)) - 1.0).abs() < 1e-15);
    }

    #[test]
    fn growth_sets_in_at_the_limit() {
        assert_eq!(growth_per_step(1.0), 0.0);
        // T&H (4.83): the ratio of successive steps is S√d + √(S²d − 1), squared here as it is per half step there.
        let excess = 1.075;
        let factor: f64 = excess + (excess * excess - 1.0_f64).sqrt();
        assert!((growth_per_step(excess) - 2.0 * factor.ln()).abs() < 1e-14);
    }
}
