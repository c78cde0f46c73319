//! Shares of several ways that find the same thing.

use crate::number::Number;

/// The share [1] with which a way counts that finds a direction with the density `own` > 0, beside one that finds it with the
/// density `other` ≥ 0 [both sr⁻¹]: p/(p + q), the balance heuristic (E. Veach and L. J. Guibas, *Optimally combining sampling
/// techniques for Monte Carlo rendering*, SIGGRAPH '95, 419, eq. 8). An infinite `own`, where there was no choice, counts in
/// full.
#[inline(always)]
pub fn balance<N: Number>(own: N, other: N) -> N {
    // No sum of densities, which would be ∞/∞ there.
    N::of(1.0) / (N::of(1.0) + other / own)
}

#[cfg(test)]
mod tests {
    use super::balance;

    #[test]
    fn shares_are_those_of_the_densities() {
        assert_eq!(balance(1.0, 3.0), 0.25);
        assert_eq!([balance(f64::INFINITY, 3.0), balance(2.0, 0.0), balance(2.0, f64::INFINITY)], [1.0, 1.0, 0.0]);
    }
}
