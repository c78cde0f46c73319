//! The tests tested: what they say of true claims, and of claims that are wrong by one per cent.
//!
//! Seeds are fixed, so each verdict is, too; the significances say how likely a rightly made test is to have failed
//! here the first time it ran.

use super::{
    Moments, chi_square, chi_square_pooled, chi_square_tail, family, kolmogorov, sidak, t_test, welch, z_test,
};
use crate::random::{Stream, stream, uniform};
use std::f64::consts::TAU;

/// All tests of uniformity here fail together with this probability.
const SIGNIFICANCE: f64 = 1e-3;

fn normal(stream: &mut Stream) -> f64 {
    // Box & Muller (1958); 1 − u is never 0.
    (-2.0 * (1.0 - uniform(stream, 0.0, 1.0)).ln()).sqrt() * (TAU * uniform(stream, 0.0, 1.0)).cos()
}

fn normals(stream: &mut Stream, count: usize, deviation: f64) -> Moments {
    (0..count).map(|_| 3.0 + deviation * normal(stream)).collect()
}

/// Counts of `draws` numbers x in 0 … 1, made from even ones by `warp`, in as many even bins as there are in
/// `expected`.
fn counts(stream: &mut Stream, draws: usize, bins: usize, warp: impl Fn(f64) -> f64) -> Vec<u64> {
    let mut counts = vec![0; bins];
    for _ in 0..draws {
        let x = warp(uniform(stream, 0.0, 1.0));
        counts[((x * bins as f64) as usize).min(bins - 1)] += 1;
    }
    counts
}

/// What `draws` numbers with the distribution function `cdf` on 0 … 1 should leave in even bins.
fn expectations(draws: usize, bins: usize, cdf: impl Fn(f64) -> f64) -> Vec<f64> {
    let edge = |at: usize| cdf(at as f64 / bins as f64);
    (0..bins).map(|at| draws as f64 * (edge(at + 1) - edge(at))).collect()
}

#[test]
fn p_values_of_true_claims_are_uniform() {
    type Case = (&'static str, fn(&mut Stream) -> f64);
    let cases: [Case; 6] = [
        // Exact: normal numbers, few of them.
        ("t, 2 numbers", |stream| t_test(&normals(stream, 2, 0.1), 3.0).p),
        ("t, 7 numbers", |stream| t_test(&normals(stream, 7, 0.1), 3.0).p),
        ("z", |stream| z_test(normals(stream, 4, 0.1).mean(), 0.05, 3.0).p),
        // Satterthwaite's dof are an approximation, good to 1/1000 from ten numbers on.
        ("Welch", |stream| welch(&normals(stream, 12, 0.1), &normals(stream, 25, 1.0)).p),
        // x = u³: bins from 1180 down to 26, none pooled.
        ("χ²", |stream| chi_square(&counts(stream, 4000, 50, |u| u * u * u), &expectations(4000, 50, f64::cbrt)).p),
        // The worst of three tests.
        ("family", |stream| family((0..3).map(|_| uniform(stream, 0.0, 1.0)).fold(1.0, f64::min), 3)),
    ];
    for (name, p) in cases {
        let mut stream = stream(1, name);
        let p_values: Vec<f64> = (0..4000).map(|_| p(&mut stream)).collect();
        let uniformity = kolmogorov(&p_values, |p| p);
        assert!(uniformity >= sidak(SIGNIFICANCE, cases.len()), "{name}: {uniformity}");
    }
}

#[test]
fn kolmogorov_bounds_how_often_it_cries_wolf() {
    // Massart: at most the share α of true claims has p ≤ α; and, 100 numbers being many, hardly less. Of 4000 runs
    // some 200 ± 14 have p ≤ 0.05; Kolmogorov's distribution for n = 100 makes it 4.4 %.
    let mut stream = stream(1, "kolmogorov");
    let refused = (0..4000)
        .filter(|_| {
            let numbers: Vec<f64> = (0..100).map(|_| uniform(&mut stream, 0.0, 1.0)).collect();
            kolmogorov(&numbers, |x| x) <= 0.05
        })
        .count();
    assert!((130..=240).contains(&refused), "{refused}");
}

#[test]
fn a_density_wrong_by_one_per_cent_is_caught() {
    // The density 1 + ε (2x − 1), ε = 0.01, judged as even in 50 bins: χ² has 49 degrees of freedom and is moved by λ =
    // N ε²/3. N = 3.6·10⁶ makes λ = 120: 169 ± √(2·49 + 4·120) = 24 against the 85.4 that has p = 10⁻³, so it is missed
    // with probability Φ(−3.5) = 2·10⁻⁴.
    const DRAWS: usize = 3_600_000;
    assert!((chi_square_tail(85.35, 49.0) / 1e-3 - 1.0).abs() < 0.01);
    let cdf = |x: f64| x * (0.99 + 0.01 * x);
    let inverse = |u: f64| 2.0 * u / (0.99 + (0.99_f64.powi(2) + 0.04 * u).sqrt());
    for seed in 0..5 {
        let counts = counts(&mut stream(seed, "one per cent"), DRAWS, 50, inverse);
        let even = chi_square(&counts, &expectations(DRAWS, 50, |x| x));
        assert!(even.p < 1e-3, "seed {seed}: {}", even.p);
        let own = chi_square(&counts, &expectations(DRAWS, 50, cdf));
        assert!(own.p >= sidak(SIGNIFICANCE, 5), "seed {seed}: {}", own.p);
    }
}

#[test]
fn a_mean_wrong_by_one_per_cent_is_caught() {
    // Even numbers have a deviation of 0.577 of their mean: N = 180 000 of them put 1 % at 7.3 standard errors, 4 more
    // than p = 10⁻³ needs, so it is missed with probability 3·10⁻⁵.
    for seed in 0..5 {
        let mut stream = stream(seed, "mean");
        let sample: Moments = (0..180_000).map(|_| uniform(&mut stream, 0.0, 1.0)).collect();
        let other: Moments = (0..180_000).map(|_| uniform(&mut stream, 0.0, 1.02)).collect();
        let wrong = [t_test(&sample, 0.505).p, z_test(sample.mean(), sample.standard_error(), 0.495).p];
        assert!(wrong.iter().all(|p| *p < 1e-3), "seed {seed}: {wrong:?}");
        // Two samples have √2 the error: hence 2 %.
        assert!(welch(&sample, &other).p < 1e-3);
        assert!(t_test(&sample, 0.5).p >= sidak(SIGNIFICANCE, 5), "seed {seed}");
    }
}

#[test]
fn pooling_does_not_change_verdicts() {
    // An exponential fall through ten e-folds in 400 bins: from 10⁵ counts a bin to 4.5, with N = 4·10⁶. A fall that is
    // wrong by 1 % moves χ² by λ ≈ N ε² = 400 whatever the bins: 800 ± 49 against the 525 that the split significance
    // allows 400 bins (5.6 of these), and fewer pools still less.
    const DRAWS: usize = 4_000_000;
    let cdf = |rate: f64| move |x: f64| (-rate * x).exp_m1() / (-rate).exp_m1();
    for seed in 0..5 {
        let warp = |u: f64| -(u * f64::exp_m1(-10.0)).ln_1p() / 10.0;
        let counts = counts(&mut stream(seed, "pools"), DRAWS, 400, warp);
        for (rate, holds) in [(10.0, true), (10.1, false)] {
            for least in [1.0, 5.0, 20.0, 500.0, 10_000.0] {
                let test = chi_square_pooled(&counts, &expectations(DRAWS, 400, cdf(rate)), least);
                assert_eq!(test.p >= sidak(SIGNIFICANCE, 50), holds, "seed {seed}, rate {rate}, {least}: {}", test.p);
                assert_eq!(least >= 5.0, test.bins.iter().any(|bin| test.is_pooled(bin)), "{least}");
            }
        }
    }
}

#[test]
fn many_pools_of_five_scatter_as_haldane_says() {
    // 100 bins that expect 5 beside one with nearly all of 10⁶ draws: counts are Poisson's (a product of even numbers,
    // Knuth), and χ² has the variance 2·100 + 100/5 = 220. 20 000 runs know it to √(2/20 000) = 1 %; 200 is 9 of these
    // off.
    let mut stream = stream(1, "haldane");
    let limit = (-5.0_f64).exp();
    let mut poisson = || {
        let mut product = 1.0;
        (0_u64..).find(|_| {
            product *= uniform(&mut stream, 0.0, 1.0);
            product < limit
        })
    };
    let mut expected = vec![5.0; 100];
    expected.push(1e6 - 500.0);
    let statistics: Moments = (0..20_000)
        .map(|_| {
            let mut counts: Vec<u64> = (0..100).filter_map(|_| poisson()).collect();
            counts.push(1_000_000 - counts.iter().sum::<u64>());
            chi_square(&counts, &expected).statistic
        })
        .collect();
    assert!((statistics.variance() - 220.0).abs() < 9.0, "{}", statistics.variance());
    assert!((statistics.mean() - 100.0).abs() < 0.5, "{}", statistics.mean());
}
