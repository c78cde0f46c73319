//! Where a prism sends light: by Snell's law at two faces with the angle A between them.
//!
//! Born & Wolf, *Principles of Optics* (7th ed.), §4.7.2. Light that comes in at θ₁ leaves bent by δ = θ₁ + θ₂ − A in all, and δ is
//! least where it goes through alike on both sides: sin ½(δ + A) = n sin ½A.

/// The sine of half the least deviation [1], of light that goes through a prism of index `n` ≥ 1 over that outside, and of `s` = sin ½A,
/// 0 ≤ `s` ≤ 1. None where no light gets through: n s > 1.
///
/// sin(α − β) = sin α cos β − cos α sin β of α = ½(δ + A) and β = ½A loses its digits where the index is nearly 1; as a product with
/// n² − 1 in factors it keeps them.
// ANCHOR: deviation
pub fn half_sine(s: f64, n: f64) -> Option<f64> {
    let sin = n * s;
    let left = (1.0 - sin) * (1.0 + sin);
    (left >= 0.0).then(|| s * (n - 1.0) * (n + 1.0) / (n * ((1.0 - s) * (1.0 + s)).sqrt() + left.sqrt()))
}
// ANCHOR_END: deviation

/// The least deviation [rad] of a prism of index `n` ≥ 1 whose faces are at an angle `apex` [rad], 0 … π. None where no light gets
/// through.
pub fn least_deviation(apex: f64, n: f64) -> Option<f64> {
    half_sine((0.5 * apex).sin(), n).map(|sine| 2.0 * sine.min(1.0).asin())
}

/// The deviation [rad] of light that comes in at an angle `theta` [rad] from the normal, counted away from the edge, −½π … ½π. None
/// where it is reflected in total at the second face.
pub fn deviation(theta: f64, apex: f64, n: f64) -> Option<f64> {
    let second = apex - (theta.sin() / n).asin();
    let sin = n * second.sin();
    (sin.abs() <= 1.0).then(|| theta + sin.asin() - apex)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_prism_of_flint_bends_the_d_line_by_48_degrees() {
        // F2, n_d = 1.6200 (Schott), in a prism of 60°: ½(δ + 60°) = arcsin 0.81.
        let found = least_deviation(60f64.to_radians(), 1.62).expect("light gets through").to_degrees();
        assert!((found - 48.192).abs() < 1e-3, "{found}");
        assert_eq!(least_deviation(60f64.to_radians(), 2.1), None);
        assert!(half_sine(0.5, 2.0).is_some_and(|sine| (sine - 0.75f64.sqrt()).abs() < 1e-15));
    }

    proptest! {
        #[test]
        fn it_is_the_least(apex in 0.05f64..1.2, n in 1.0001..2.0, off in -0.5f64..0.5) {
            if let Some(least) = least_deviation(apex, n) {
                let theta = 0.5 * (least + apex);
                let own = deviation(theta, apex, n).expect("the same light");
                prop_assert!((own - least).abs() < 1e-9 / (1.0 - (n * (0.5 * apex).sin()).powi(2)).sqrt().max(1e-6), "{own} {least}");
                if let Some(other) = deviation((theta + off).clamp(-1.57, 1.57), apex, n) {
                    prop_assert!(other > least - 1e-9, "{other} below {least}");
                }
            }
        }

        #[test]
        fn it_goes_both_ways(apex in 0.05..1.2, n in 1.0001..2.0, theta in 0.0..1.5) {
            if let Some(bent) = deviation(theta, apex, n) {
                let back = bent + apex - theta;
                // Near grazing an angle has fewer digits than its sine.
                prop_assume!(back.abs() < 1.5);
                let again = deviation(back, apex, n).expect("the way back");
                prop_assert!((again - bent).abs() < 1e-9, "{again} {bent}");
            }
        }
    }
}
