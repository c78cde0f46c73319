//! Many tests at once: Z. Šidák, "Rectangular confidence regions for the means of multivariate normal distributions",
//! JASA 62 (1967) 626.

/// The significance of one of `tests` independent tests that makes `significance` of them all together (Šidák 1967).
pub fn sidak(significance: f64, tests: usize) -> f64 {
    // 1 − (1 − α)^(1/n), without cancellation.
    -f64::exp_m1(f64::ln_1p(-significance) / tests.max(1) as f64)
}

/// The p-value [1] of the claim that all of `tests` independent claims hold, of which the worst has the p-value
/// `least`: 1 − (1 − p)ⁿ, [`sidak`] read backwards. Where the tests depend on one another it errs towards larger p for
/// two-sided normal ones (Šidák's theorem), and by no more than Bonferroni's n p for any.
pub fn family(least: f64, tests: usize) -> f64 {
    // A p of 1 would give ln 0 = −∞, which is right for all but no test: 0·∞.
    -f64::exp_m1(f64::ln_1p(-least) * tests.max(1) as f64)
}

#[cfg(test)]
mod tests {
    use super::{family, sidak};
    use proptest::prelude::*;

    #[test]
    fn sidak_splits_a_significance() {
        let one = sidak(1e-3, 40);
        assert!((1.0 - (1.0 - one).powi(40) - 1e-3).abs() < 1e-14);
    }

    #[test]
    fn certain_and_impossible_claims_stay_so() {
        assert_eq!((family(1.0, 7), family(0.0, 7)), (1.0, 0.0));
        assert!(family(f64::NAN, 7).is_nan());
        // Far below the rounding of 1 − p.
        assert!((family(1e-300, 100) / 1e-298 - 1.0).abs() < 1e-12);
    }

    proptest! {
        #[test]
        fn one_is_the_other_backwards(exponent in -300.0..-0.01_f64, tests in 1_usize..1_000_000) {
            let significance = 10f64.powf(exponent);
            let back = family(sidak(significance, tests), tests);
            // ln(1 − α) is large where α is near 1.
            prop_assert!((back / significance - 1.0).abs() < 1e-13);
        }
    }
}
