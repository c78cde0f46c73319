//! How a rule stretches the flat net over the sphere: learned from one rule, the start for the next.

use super::linear::{dot, least_squares};
use super::orbit::{Orbit, normalised};
use std::f64::consts::FRAC_PI_2;

/// Smooth functions of a point's place on the octahedron's face.
pub enum Shape {
    /// Coordinates as sines, equal weights: for the first rules.
    Sines,
    /// Fitted to a rule.
    Fitted {
        /// The symmetric polynomials used are of this degree at most.
        degree: usize,
        /// Their factors times p, p², p³ in a coordinate on the sphere that grows from the place p.
        coordinates: Vec<f64>,
        /// Their factors in a point's weight, as a multiple of the mean.
        weights: Vec<f64>,
    },
}

impl Shape {
    /// What comes closest to a rule, with half as many factors as the rule has orbits: it is to lead on, not to repeat.
    pub fn of(orbits: &[Orbit]) -> Self {
        let Some(degree) =
            (3..orbits.len()).rev().find(|degree| 2 * symmetric([0.0; 3], *degree).len() <= orbits.len())
        else {
            return Self::Sines;
        };
        let every = orbits.iter().flat_map(|orbit| (0..3).map(move |axis| (orbit, axis)));
        let (rows, right): (Vec<_>, Vec<_>) =
            every.map(|(orbit, axis)| (terms(orbit.place, axis, degree), orbit.at[axis])).unzip();
        let count: usize = orbits.iter().map(Orbit::size).sum();
        let weight = |orbit: &Orbit| orbit.share * count as f64 / orbit.size() as f64;
        let (polynomials, weights): (Vec<_>, Vec<_>) =
            orbits.iter().map(|orbit| (symmetric(orbit.place, degree), weight(orbit))).unzip();
        Self::Fitted {
            degree,
            coordinates: least_squares(&rows, &right),
            weights: least_squares(&polynomials, &weights),
        }
    }

    /// `net`, each orbit where it should be in a rule.
    pub fn stretched(&self, net: Vec<Orbit>) -> Vec<Orbit> {
        let count: usize = net.iter().map(Orbit::size).sum();
        let stretched = |orbit: Orbit| {
            let (at, weight) = match self {
                Self::Sines => (orbit.place.map(|part| (FRAC_PI_2 * part).sin()), 1.0),
                Self::Fitted { degree, coordinates, weights } => (
                    std::array::from_fn(|axis| dot(coordinates, &terms(orbit.place, axis, *degree))),
                    dot(weights, &symmetric(orbit.place, *degree)),
                ),
            };
            Orbit { at: normalised(at), share: weight * orbit.size() as f64 / count as f64, ..orbit }
        };
        net.into_iter().map(stretched).collect()
    }
}

/// The polynomials up to `degree` that no exchange of coordinates changes; the coordinates add up to 1.
fn symmetric([x, y, z]: [f64; 3], degree: usize) -> Vec<f64> {
    let (pairs, triple) = (3.0 * (x * y + y * z + z * x), 27.0 * x * y * z);
    let powers = (0..=degree / 2).flat_map(|i| (0..=(degree - 2 * i) / 3).map(move |j| (i as i32, j as i32)));
    powers.map(|(i, j)| pairs.powi(i) * triple.powi(j)).collect()
}

fn terms(place: [f64; 3], axis: usize, degree: usize) -> Vec<f64> {
    let powers = (1..=3).map(|power| place[axis].powi(power));
    powers.flat_map(|power| symmetric(place, degree).into_iter().map(move |factor| factor * power)).collect()
}
