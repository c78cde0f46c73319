//! What becomes of light among real heights, and where Smith says the same.

use super::super::{Fate, Path, Relief};
use super::smith::Smith;
use super::{dot, even, gaussian, towards};
use std::f64::consts::TAU;
use yardstick::statistics::{Moments, normal_two_sided};

const RAYS: usize = 20_000;

fn paths(relief: &Relief, wi: [f64; 3], rays: usize) -> Vec<Path> {
    let mut even = even(1, &format!("relief/rays/{wi:?}"));
    let points: Vec<[f64; 2]> = (0..rays).map(|_| [even(), even()]).collect();
    relief.trace_all(wi, &points, |_| 1.0, 1000)
}

fn single(paths: &[Path]) -> f64 {
    paths.iter().filter(|path| path.bounces == 1).count() as f64 / paths.len() as f64
}

#[test]
fn a_gaussian_relief_agrees_with_smith_where_correlation_lets_it() {
    for alpha in [0.1, 0.5, 0.8] {
        let relief = gaussian(alpha);
        for degrees in [0.0, 60.0, 85.0] {
            let theta = f64::to_radians(degrees);
            let wi = towards(theta, 0.7);
            let paths = paths(&relief, wi, RAYS);
            // Energy: a perfect mirror sends all away, upwards.
            assert!(paths.iter().all(|path| path.fate == Fate::Left && path.power == 1.0));
            assert!(paths.iter().all(|path| path.direction[2] > 0.0 && path.bounces > 0 && dot(path.first, wi) > 0.0));
            let (slope, share) = Smith::Beckmann.seen(alpha, theta);
            let sigma = (share * (1.0 - share).max(0.0) / RAYS as f64).sqrt();
            let found = single(&paths);
            // Neighbours rise together: what leaves one facet meets fewer others than independent heights would put in
            // its way.
            assert!(found - share < 0.025 && found - share > -3.0 * sigma - 1e-3, "{alpha} {degrees}: {found} {share}");
            let tilt: Moments = paths
                .iter()
                .map(|path| (path.first[0] * 0.7_f64.cos() + path.first[1] * 0.7_f64.sin()) / path.first[2])
                .collect();
            let noise = 4.0 * tilt.standard_error();
            assert!((tilt.mean() - slope).abs() < 0.05 * slope + noise, "{alpha} {degrees}: {} {slope}", tilt.mean());
        }
    }
}

#[test]
fn slopes_alone_do_not_make_a_brdf() {
    // The histogram is GGX's, the shadows are not: roughness and height go together.
    let relief = Relief::ggx(1024, [8.0, 128.0], 0.5, even(1, "relief/ggx")).expect("valid");
    let theta = f64::to_radians(60.0);
    let found = single(&paths(&relief, towards(theta, 0.7), RAYS));
    let (_, share) = Smith::Ggx.seen(0.5, theta);
    assert!(found - share > 0.03, "{found} {share}");
}

/// A ring of directions with cos θ in a range.
struct Ring(f64, f64);

impl Ring {
    /// Its measure cos θ dω [sr], over π.
    fn size(&self) -> f64 {
        self.1 * self.1 - self.0 * self.0
    }

    /// How much of the light that comes from this ring goes to `other`, and the variance of that.
    fn to(&self, other: &Self, relief: &Relief, seed: u64) -> (f64, f64) {
        let mut even = even(seed, "relief/reciprocity");
        let reached = (0..RAYS)
            .filter(|_| {
                let cos = (self.0 * self.0 + self.size() * even()).sqrt();
                let wi = towards(cos.acos(), TAU * even());
                let path = relief.trace(wi, [even(), even()], |_| 1.0, 1000);
                (other.0..other.1).contains(&path.direction[2])
            })
            .count();
        let share = reached as f64 / RAYS as f64;
        (share * self.size(), share * (1.0 - share) / RAYS as f64 * self.size().powi(2))
    }
}

#[test]
fn light_goes_back_as_it_came() {
    // The way of every ray can be gone backwards, so what ring A sends to ring B, weighed by cos θ dω, is what B sends
    // to A, on any relief, however few its cells.
    let relief = Relief::gaussian(256, 8.0, 0.6, even(2, "relief/gaussian")).expect("valid");
    for (one, other) in [(Ring(0.0, 0.3), Ring(0.5, 1.0)), (Ring(0.2, 0.6), Ring(0.8, 1.0))] {
        let ((there, noise), (back, more)) = (one.to(&other, &relief, 1), other.to(&one, &relief, 2));
        let p = normal_two_sided((there - back) / (noise + more).sqrt());
        assert!(p > 1e-3, "{there} {back}");
        // The slip: shares compared as they are.
        let (there, back) = (there / one.size(), back / other.size());
        assert!((there / back - 1.0).abs() > 0.1, "{there} {back}");
    }
}
