//! Whether counts follow a density.

use super::tails::chi_square_tail;

/// The least count that a pool of bins must expect [1] for its scatter to be taken as normal: the customary 5
/// (W. G. Cochran, "Some methods for strengthening the common χ² tests", *Biometrics* 10 (1954) 417).
///
/// It serves bodies, not far tails. The variance of χ² is 2 dof + Σ 1/E − (dof + 1)²/N − …, not 2 dof (J. B. S.
/// Haldane, *Biometrika* 29 (1937) 133): if nearly all pools expect 5 and a few hold nearly all draws, it scatters 5 %
/// more than it should, and a p of 10⁻⁶ comes three times as often. Where the significance is split over many tests of
/// many nearly empty bins, ask more of [`chi_square_pooled`].
pub const LEAST_EXPECTED: f64 = 5.0;

/// One bin of a histogram, kept so that it can be drawn beside what was expected.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bin {
    /// What fell into it [1].
    pub observed: u64,
    /// What should have, on average [1].
    pub expected: f64,
    /// Which pool it was judged in: bins of the same number were added up. None for a bin that expects nothing.
    pub pool: Option<usize>,
}

/// What a χ² test found.
#[derive(Clone, Debug, PartialEq)]
pub struct ChiSquare {
    /// Σ (O − E)²/E over the pools [1]; infinite if the counts are impossible.
    pub statistic: f64,
    /// Pools less one [1]: the total is given.
    pub dof: usize,
    /// How often counts of the claimed density look at least as bad [1].
    pub p: f64,
    /// The bins, in the order given.
    pub bins: Vec<Bin>,
}

impl ChiSquare {
    /// Whether `bin` was added up with others.
    pub fn is_pooled(&self, bin: &Bin) -> bool {
        bin.pool.is_some() && self.bins.iter().filter(|other| other.pool == bin.pool).count() > 1
    }

    /// How far each bin is off, in units of its own expected scatter √E [1], and signed: what to colour a drawing by.
    pub fn deviates(&self) -> impl Iterator<Item = f64> {
        self.bins.iter().map(|bin| match bin.observed as f64 - bin.expected {
            0.0 => 0.0,
            gap => gap / bin.expected.sqrt(),
        })
    }
}

/// Pearson's χ² test of the claim that `observed` counts are draws from bins that expect `expected` counts each.
/// Whatever falls outside all bins needs a bin of its own, so that both add up to the number of draws.
///
/// Pooling: bins are taken from the least expectation to the largest (equal ones in the order given) and added up until
/// a pool expects at least [`LEAST_EXPECTED`]; the last pool takes what is left. It looks at expectations only, never
/// at counts, so the pools are fair. The counts are impossible, p = 0, if a bin that expects nothing has any, or if the
/// sums differ by more than a tenth of the scatter of a count, √N/10: a density that is off by more does not integrate
/// to 1, and one that is off by less moves χ² by at most 1/100. p is NaN if an expectation is negative or NaN, and if
/// fewer than two pools are left: nothing was tested.
///
/// # Panics
/// If the two differ in length.
pub fn chi_square(observed: &[u64], expected: &[f64]) -> ChiSquare {
    chi_square_pooled(observed, expected, LEAST_EXPECTED)
}

/// [`chi_square`] with pools that expect at least `least` > 0 counts each.
///
/// # Panics
/// If `observed` and `expected` differ in length.
pub fn chi_square_pooled(observed: &[u64], expected: &[f64], least: f64) -> ChiSquare {
    assert_eq!(observed.len(), expected.len(), "every bin needs a count and an expectation");
    let bin = |(&observed, &expected)| Bin { observed, expected, pool: None };
    let mut bins: Vec<Bin> = observed.iter().zip(expected).map(bin).collect();
    let pools = pool(&mut bins, least);

    let mut sums = vec![(0, 0.0); pools];
    for bin in &bins {
        if let Some(pool) = bin.pool {
            sums[pool].0 += bin.observed;
            sums[pool].1 += bin.expected;
        }
    }
    let statistic: f64 = sums.iter().map(|&(count, mean)| (count as f64 - mean).powi(2) / mean).sum();
    let dof = pools.saturating_sub(1);
    let (draws, total) = (observed.iter().sum::<u64>() as f64, expected.iter().sum::<f64>());
    let impossible = bins.iter().any(|bin| bin.expected == 0.0 && bin.observed > 0);

    let (statistic, p) = if !expected.iter().all(|mean| *mean >= 0.0) {
        (f64::NAN, f64::NAN)
    } else if impossible || (draws - total).abs() > 0.1 * draws.sqrt() {
        (f64::INFINITY, 0.0)
    } else if dof == 0 {
        (statistic, f64::NAN)
    } else {
        (statistic, chi_square_tail(statistic, dof as f64))
    };
    ChiSquare { statistic, dof, p, bins }
}

/// Gives every bin that expects anything its pool, and tells how many pools there are.
fn pool(bins: &mut [Bin], least: f64) -> usize {
    let mut order: Vec<usize> = (0..bins.len()).filter(|&at| bins[at].expected > 0.0).collect();
    // A stable sort: equal bins stay in the order given, on every machine.
    order.sort_by(|&one, &other| bins[one].expected.total_cmp(&bins[other].expected));
    let mut pools = 0;
    let mut sum = 0.0;
    for &at in &order {
        bins[at].pool = Some(pools);
        sum += bins[at].expected;
        if sum >= least {
            (pools, sum) = (pools + 1, 0.0);
        }
    }
    if sum > 0.0 && pools > 0 {
        // What is left expects too little to stand alone.
        bins.iter_mut().filter(|bin| bin.pool == Some(pools)).for_each(|bin| bin.pool = Some(pools - 1));
        pools
    } else {
        pools + usize::from(sum > 0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::{chi_square, chi_square_pooled};
    use proptest::prelude::*;

    #[test]
    fn mendels_peas() {
        // G. Mendel, *Versuche über Pflanzenhybriden* (1866): 556 peas, 9:3:3:1. Textbooks give χ² = 0.470, p = 0.925.
        let test = chi_square(&[315, 101, 108, 32], &[9.0, 3.0, 3.0, 1.0].map(|share| share * 556.0 / 16.0));
        assert_eq!(test.dof, 3);
        assert!((test.statistic - 0.470).abs() < 5e-4 && (test.p - 0.925).abs() < 5e-4, "{test:?}");
        assert!(test.bins.iter().all(|bin| !test.is_pooled(bin)));
    }

    #[test]
    fn pools_the_least_first_and_keeps_the_bins() {
        let expected = [40.0, 3.0, 0.0, 1.0, 2.5, 5.0];
        let observed = [41, 4, 0, 0, 2, 5];
        let test = chi_square(&observed, &expected);
        // 1 + 2.5 + 3 make one pool; 5 and 40 stand alone.
        let pools: Vec<_> = test.bins.iter().map(|bin| bin.pool).collect();
        assert_eq!(pools, [Some(2), Some(0), None, Some(0), Some(0), Some(1)]);
        assert_eq!(test.bins.iter().map(|bin| test.is_pooled(bin)).filter(|pooled| *pooled).count(), 3);
        assert_eq!(test.dof, 2);
        assert!((test.statistic - (0.25 / 6.5 + 1.0 / 40.0)).abs() < 1e-15);
        for (bin, (observed, expected)) in test.bins.iter().zip(observed.iter().zip(expected)) {
            assert_eq!((bin.observed, bin.expected), (*observed, expected));
        }
        let deviates: Vec<f64> = test.deviates().collect();
        assert_eq!((deviates[0], deviates[2], deviates[3]), (1.0 / 40f64.sqrt(), 0.0, -1.0));
    }

    #[test]
    fn the_last_pool_takes_what_is_left() {
        // 2 + 2 + 2 are a pool, the fourth and fifth 2 are not enough for one.
        let test = chi_square(&[2; 5], &[2.0; 5]);
        assert!(test.bins.iter().all(|bin| bin.pool == Some(0)) && test.dof == 0);
        let test = chi_square(&[2; 8], &[2.0; 8]);
        assert_eq!(test.bins.iter().map(|bin| bin.pool.unwrap()).collect::<Vec<_>>(), [0, 0, 0, 1, 1, 1, 1, 1]);
        assert_eq!((test.dof, test.statistic, test.p), (1, 0.0, 1.0));
    }

    #[test]
    fn impossible_counts_are_refused() {
        assert_eq!(chi_square(&[50, 49, 1], &[50.0, 50.0, 0.0]).p, 0.0);
        assert_eq!(chi_square(&[50, 50, 0], &[50.0, 50.0, 0.0]).p, 1.0);
        // A density whose integral is 1 % too large, and one that is 0.1 % too large, within what a quadrature may do.
        assert_eq!(chi_square(&[1000, 1000], &[1010.0, 1010.0]).p, 0.0);
        assert!(chi_square(&[1000, 1000], &[1001.0, 1001.0]).p > 0.9);
        assert_eq!(chi_square(&[0, 0], &[10.0, 10.0]).p, 0.0);
    }

    #[test]
    fn what_tests_nothing_is_nan() {
        for (observed, expected) in [
            (&[][..], &[][..]),
            (&[7], &[7.0]),
            (&[1, 1], &[1.0, 1.0]),
            (&[0], &[0.0]),
            (&[9, 9, 9], &[f64::NAN, 9.0, 9.0]),
        ] {
            assert!(chi_square(observed, expected).p.is_nan(), "{observed:?} {expected:?}");
        }
        assert!(chi_square(&[10, 10], &[25.0, -5.0]).p.is_nan());
    }

    proptest! {
        #[test]
        fn pools_are_a_partition_that_expects_enough(
            expected in prop::collection::vec(prop_oneof![Just(0.0), 0.0..20.0_f64], 1..200), least in 0.5..50.0_f64,
        ) {
            let observed: Vec<u64> = expected.iter().map(|mean| mean.round() as u64).collect();
            let test = chi_square_pooled(&observed, &expected, least);
            let pools = test.bins.iter().filter_map(|bin| bin.pool).max().map_or(0, |last| last + 1);
            prop_assert_eq!(test.dof, pools.saturating_sub(1));
            for pool in 0..pools {
                let of = || test.bins.iter().filter(|bin| bin.pool == Some(pool));
                let sum: f64 = of().map(|bin| bin.expected).sum();
                // One pool alone may expect less: there was no more.
                prop_assert!(sum >= least * (1.0 - 1e-12) || pools == 1);
                // Nothing was pooled that need not be.
                let largest = of().map(|bin| bin.expected).fold(0.0, f64::max);
                prop_assert!(of().count() == 1 || sum - largest < least || pool == pools - 1);
            }
            for bin in &test.bins {
                prop_assert_eq!(bin.pool.is_none(), bin.expected == 0.0);
            }
        }

        #[test]
        fn the_order_of_bins_does_not_matter(
            bins in prop::collection::vec((0.1..20.0_f64, 0.5..1.5_f64), 2..100),
        ) {
            // All expectations differ, with probability 1; equal ones may change pools.
            let mut observed: Vec<u64> = bins.iter().map(|(mean, factor)| (mean * factor).round() as u64).collect();
            let mut expected: Vec<f64> = bins.iter().map(|(mean, _)| *mean).collect();
            let scale = observed.iter().sum::<u64>() as f64 / expected.iter().sum::<f64>();
            expected.iter_mut().for_each(|mean| *mean *= scale);
            let there = chi_square(&observed, &expected);
            observed.reverse();
            expected.reverse();
            let back = chi_square(&observed, &expected);
            prop_assert_eq!(there.dof, back.dof);
            prop_assert!(there.p.is_nan() && back.p.is_nan() || (there.p - back.p).abs() < 1e-10);
        }
    }
}
