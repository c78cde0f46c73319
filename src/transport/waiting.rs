//! What it costs that paths are of many lengths, where several go side by side.

/// The share [1] of so many lanes that work, if their paths begin together and each waits for the longest, and every path goes
/// on after each edge with the probability 0 ≤ `chance` < 1: ⟨edges⟩ over ⟨the most edges of any lane⟩.
pub fn busy(chance: f64, lanes: u32) -> f64 {
    // A maximum of k edges or more: some lane has not ended before. By log₁ₚ, since the last terms are tiny.
    let reaches = |k: i32| -(f64::from(lanes) * (-chance.powi(k)).ln_1p()).exp_m1();
    let mut most = 1.0;
    for k in 1.. {
        let more = reaches(k);
        most += more;
        // What follows falls at least as fast as chanceᵏ.
        if more <= most * f64::EPSILON * (1.0 - chance) {
            break;
        }
    }
    1.0 / ((1.0 - chance) * most)
}

#[cfg(test)]
mod tests {
    use super::busy;

    #[test]
    fn lanes_that_wait_are_idle() {
        // One lane never waits; two geometric paths last 1/p each and 2/p − 1/(1 − q²) together.
        assert!((busy(0.7, 1) - 1.0).abs() < 1e-14);
        let exact = 2.0 / (2.0 * 2.0 - 1.0 / 0.75);
        assert!((busy(0.5, 2) - exact).abs() < 1e-14);
        assert_eq!(busy(0.0, 8), 1.0);
    }
}
