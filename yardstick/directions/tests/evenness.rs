//! Whether points are even, and maps keep areas.

use super::super::{Direction, Domain, MOST_SOBOL, Points, integral, sampled};
use crate::random::stream;
use crate::statistics::{Moments, chi_square, kolmogorov, sidak, t_test};
use proptest::prelude::*;
use std::f64::consts::TAU;

/// All tests of chance here fail together with this probability.
const SIGNIFICANCE: f64 = 1e-3;
const TESTS: usize = 30;

/// The distribution function of z over `domain`.
fn below(domain: Domain, z: f64) -> f64 {
    match domain {
        Domain::Sphere => 0.5 * (1.0 + z),
        Domain::Hemisphere => z,
        Domain::Cosine => z * z,
    }
}

/// χ²'s p of `directions` in 16 × 16 cells of equal measure in `domain`.
fn even(domain: Domain, directions: &[Direction]) -> f64 {
    const SIDE: usize = 16;
    let mut counts = vec![0; SIDE * SIDE];
    for [x, y, z] in directions {
        let cell = |share: f64| ((share * SIDE as f64) as usize).min(SIDE - 1);
        counts[cell(below(domain, *z)) * SIDE + cell((y.atan2(*x) / TAU).rem_euclid(1.0))] += 1;
    }
    chi_square(&counts, &vec![directions.len() as f64 / (SIDE * SIDE) as f64; SIDE * SIDE]).p
}

#[test]
fn maps_keep_areas() {
    let squares = Points::Random.draw(1 << 18, &mut stream(1, "directions/maps"));
    for domain in Domain::ALL {
        let directions: Vec<Direction> = squares.iter().map(|&square| domain.at(square)).collect();
        for judged in Domain::ALL {
            let p = even(judged, &directions);
            // The slip: one domain's points taken for another's.
            assert_eq!(p >= sidak(SIGNIFICANCE, TESTS), judged == domain, "{domain:?} as {judged:?}: {p}");
        }
        let heights: Vec<f64> = directions.iter().map(|direction| direction[2]).collect();
        assert!(kolmogorov(&heights, |z| below(domain, z)) >= sidak(SIGNIFICANCE, TESTS), "{domain:?}");
        // ∫ z² is a third of the whole, or half of it under the cosine.
        let squares: Moments = heights.iter().map(|z| z * z).collect();
        let mean = if domain == Domain::Cosine { 0.5 } else { 1.0 / 3.0 };
        assert!(t_test(&squares, mean).p >= sidak(SIGNIFICANCE, TESTS), "{domain:?}");
    }
}

#[test]
fn every_single_point_is_even() {
    const COUNT: usize = 16;
    for points in Points::ALL {
        // One point of each of many sets: which one it is must not matter.
        let one = |seed: u64| points.draw(COUNT, &mut stream(seed, "directions/single"))[seed as usize % COUNT];
        let ones: Vec<Direction> = (0..40_000).map(|seed| Domain::Hemisphere.at(one(seed))).collect();
        let p = even(Domain::Hemisphere, &ones);
        assert!(p >= sidak(SIGNIFICANCE, TESTS), "{points:?}: {p}");
        // The slip: every set the same.
        let same: Vec<Direction> = (0..40_000)
            .map(|draw| Domain::Hemisphere.at(points.draw(COUNT, &mut stream(1, "directions/single"))[draw % COUNT]))
            .collect();
        assert!(even(Domain::Hemisphere, &same) < 1e-9);
    }
}

#[test]
fn plans_put_one_point_in_each_cell() {
    let once = |points: &[[f64; 2]], rows: usize, columns: usize| {
        let mut seen = vec![false; rows * columns];
        points.iter().for_each(|[u, v]| {
            seen[(u * rows as f64) as usize * columns + (v * columns as f64) as usize] = true;
        });
        seen.into_iter().all(|seen| seen)
    };
    for seed in 0..8 {
        let draw = |points: Points, n: usize| points.draw(n, &mut stream(seed, "directions/cells"));
        assert!(once(&draw(Points::Stratified, 12), 3, 4) && once(&draw(Points::Stratified, 64), 8, 8));
        assert!(once(&draw(Points::Stratified, 7), 1, 7));
        // A (0, k, 2)-net in base 2: every elementary interval of area 1/n holds one point.
        for k in 0..=10 {
            let net = draw(Points::Sobol, 1 << k);
            assert!((0..=k).all(|rows| once(&net, 1 << rows, 1 << (k - rows))), "seed {seed}, 2^{k}");
        }
        assert!(!once(&draw(Points::Random, 64), 8, 8));
    }
}

#[test]
fn a_stream_decides_and_nothing_else() {
    for points in Points::ALL {
        let draw = |seed, address| points.draw(64, &mut stream(seed, address));
        assert_eq!(draw(1, "one"), draw(1, "one"));
        assert_ne!(draw(1, "one"), draw(2, "one"));
        assert_ne!(draw(1, "one"), draw(1, "other"));
        assert!(points.draw(0, &mut stream(1, "none")).is_empty());
    }
    assert_eq!(Points::Sobol.draw(MOST_SOBOL, &mut stream(1, "most")).len(), MOST_SOBOL);
}

#[test]
fn samples_weigh_the_whole_domain() {
    for domain in Domain::ALL {
        let rule = sampled(domain, &Points::Sobol.draw(256, &mut stream(1, "directions/weights")));
        assert!((integral(&rule, |_| 1.0) - domain.size()).abs() < 1e-13);
    }
}

proptest! {
    #[test]
    fn maps_give_unit_vectors_of_their_domain(
        u in prop_oneof![0.0..=1.0_f64, Just(0.0), Just(0.5), Just(1.0), Just(1.0_f64.next_down())],
        v in prop_oneof![0.0..=1.0_f64, Just(0.0), Just(0.5), Just(1.0), Just(f64::MIN_POSITIVE)],
    ) {
        for domain in Domain::ALL {
            let [x, y, z] = domain.at([u, v]);
            prop_assert!((x * x + y * y + z * z - 1.0).abs() < 4.0 * f64::EPSILON, "{domain:?} {x} {y} {z}");
            prop_assert!(z >= 0.0 || domain == Domain::Sphere);
        }
    }

    #[test]
    fn points_stay_in_the_square(seed in any::<u64>(), n in 0_usize..300) {
        for points in Points::ALL {
            let drawn = points.draw(n, &mut stream(seed, "directions/square"));
            prop_assert_eq!(drawn.len(), n);
            prop_assert!(drawn.iter().flatten().all(|part| (0.0..1.0).contains(part)));
        }
    }
}
