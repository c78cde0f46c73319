//! Lebedev's rules, computed: points with the symmetry of the cube whose places and weights solve the moment equations.
//!
//! V. I. Lebedev, *USSR Comput. Math. Math. Phys.* 16 (1976) 10; V. I. Lebedev & D. N. Laikov, *Doklady Math.* 59 (1999)
//! 477. His rules of degree 6m − 1 have 12 m² + 2 points: as many as the net of triangles over an octahedron whose edge
//! is cut into m parts across the triangles' corners (Goldberg's class II). Newton's iteration starts from that net,
//! stretched over the sphere as it was for the rule before.

mod harmonics;
mod linear;
mod moments;
mod orbit;
mod shape;

use super::{Domain, Rule};
use harmonics::invariants;
use moments::Moments;
use orbit::Orbit;
use shape::Shape;

/// The highest level that [`lebedev`] computes: 1730 points, degree 71. Newton's iteration went astray from some starts
/// beyond it.
pub const TOP_LEVEL: usize = 12;

/// Lebedev's rule of `level` 1 to [`TOP_LEVEL`]: 12 level² + 2 points with positive weights, exact for spherical
/// harmonics up to degree 6 level − 1.
///
/// # Panics
/// If there is no such level.
pub fn lebedev(level: usize) -> Rule {
    assert!((1..=TOP_LEVEL).contains(&level), "Lebedev's rules are computed for levels 1 to {TOP_LEVEL}, not {level}");
    let orbits = (2..=level).fold(solved(1, &Shape::Sines), |before, next| solved(next, &Shape::of(&before)));
    let weighted = |orbit: &Orbit| {
        let weight = Domain::Sphere.size() * orbit.share / orbit.size() as f64;
        orbit.points().into_iter().map(move |point| (point, weight))
    };
    orbits.iter().flat_map(weighted).collect()
}

/// The net of `level`: (p, q, r) with p + q + r = 3 level that agree modulo 3; if two do, so does the third.
fn net(level: usize) -> Vec<Orbit> {
    let sum = 3 * level;
    let places = (0..=sum / 2).flat_map(|q| (0..=q).map(move |r| (q, r))).filter(|(q, r)| 2 * q + r <= sum);
    places.map(|(q, r)| [sum - q - r, q, r]).filter(|[p, q, _]| p % 3 == q % 3).map(Orbit::new).collect()
}

/// The rule of `level`, by Newton's iteration from its net, stretched to `shape`, until rounding stops it.
fn solved(level: usize, shape: &Shape) -> Vec<Orbit> {
    const STEPS: usize = 60;
    let harmonics = invariants(6 * level - 1);
    let mut orbits = shape.stretched(net(level));
    let mut moments = Moments::of(&harmonics, &orbits);
    for _ in 0..STEPS {
        let step = moments.newton_step();
        // A step that leads away is halved.
        let shorter = (0..8).map(|halvings| advanced(&orbits, &step, 0.5_f64.powi(halvings)));
        let better = shorter
            .map(|moved| (Moments::of(&harmonics, &moved), moved))
            .find(|(next, _)| next.error() < moments.error());
        let Some(better) = better else { break };
        (moments, orbits) = better;
    }
    orbits
}

/// `orbits` after `length` times `step` in their unknowns, in the order of [`Moments`].
fn advanced(orbits: &[Orbit], step: &[f64], length: f64) -> Vec<Orbit> {
    let step: Vec<f64> = step.iter().map(|part| part * length).collect();
    let (shares, mut ways) = step.split_at(orbits.len());
    let moved = orbits.iter().zip(shares).map(|(orbit, share)| {
        let (own, others) = ways.split_at(orbit.ways().len());
        ways = others;
        Orbit { share: orbit.share + share, ..orbit.moved(own) }
    });
    moved.collect()
}
