//! Whether numbers follow a distribution, without bins.

/// An upper bound of the p-value [1] of the claim that the independent `numbers` have the continuous distribution
/// function `cdf` [1]: 2 e^(−2nD²), D the largest distance between it and the share of numbers below (P. Massart, *Ann.
/// Probab.* 18 (1990) 1269, which holds for every n). Where it is small it is also Kolmogorov's limit for many numbers,
/// so little power is lost. NaN if there are no numbers, or if one has no place.
pub fn kolmogorov(numbers: &[f64], cdf: impl Fn(f64) -> f64) -> f64 {
    let mut places: Vec<f64> = numbers.iter().map(|&x| cdf(x)).collect();
    if places.is_empty() || places.iter().any(|place| place.is_nan()) {
        return f64::NAN;
    }
    places.sort_by(f64::total_cmp);
    let count = places.len() as f64;
    // The stairs are farthest off just before or at a step.
    let distance = |(at, place): (usize, &f64)| (place - at as f64 / count).max((at + 1) as f64 / count - place);
    let largest = places.iter().enumerate().map(distance).fold(0.0, f64::max);
    (2.0 * (-2.0 * count * largest * largest).exp()).min(1.0)
}

#[cfg(test)]
mod tests {
    use super::kolmogorov;

    #[test]
    fn finds_the_largest_step() {
        // By hand: the stairs 0, ⅓, ⅔, 1 over 0.1, 0.2, 0.6 are farthest off at 0.2, by ⅔ − 0.2.
        let expected = 2.0 * (-2.0 * 3.0 * (2.0 / 3.0 - 0.2_f64).powi(2)).exp();
        assert!((kolmogorov(&[0.6, 0.1, 0.2], |x| x) - expected).abs() < 1e-15);
        // And below a step: 0 against 0.9.
        assert!((kolmogorov(&[0.9], |x| x) - 2.0 * (-2.0 * 0.81_f64).exp()).abs() < 1e-15);
    }

    #[test]
    fn refuses_what_has_no_place() {
        assert!(kolmogorov(&[], |x| x).is_nan());
        assert!(kolmogorov(&[0.5, f64::NAN], |x| x).is_nan());
    }
}
