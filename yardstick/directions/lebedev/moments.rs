//! What a rule makes of every harmonic, and how that changes with the rule's unknowns.

use super::harmonics::{Harmonic, values};
use super::linear::{dot, solve};
use super::orbit::Orbit;

/// As many equations as unknowns: first the shares of the orbits, then the ways in which they may move.
pub struct Moments {
    /// The mean of each harmonic less the true one: 1 for the constant, which comes first, and 0 for all others.
    errors: Vec<f64>,
    /// A row for each harmonic, a column for each unknown.
    slopes: Vec<Vec<f64>>,
}

impl Moments {
    /// Of `harmonics`, as many as `orbits` have unknowns.
    pub fn of(harmonics: &[Harmonic], orbits: &[Orbit]) -> Self {
        let mut errors = vec![0.0; harmonics.len()];
        errors[0] = -1.0;
        let (mut shares, mut places) = (vec![vec![]; harmonics.len()], vec![vec![]; harmonics.len()]);
        for orbit in orbits {
            let ways = orbit.ways();
            for (at, (value, gradient)) in values(harmonics, orbit.at).into_iter().enumerate() {
                errors[at] += orbit.share * value;
                shares[at].push(value);
                places[at].extend(ways.iter().map(|way| orbit.share * dot(&gradient, way)));
            }
        }
        let slopes = shares.into_iter().zip(places).map(|(shares, places)| [shares, places].concat()).collect();
        Self { errors, slopes }
    }

    /// The sum of the squares of the errors [1].
    pub fn error(&self) -> f64 {
        dot(&self.errors, &self.errors)
    }

    /// What to add to the unknowns, if all were linear.
    pub fn newton_step(&self) -> Vec<f64> {
        solve(self.slopes.clone(), self.errors.iter().map(|error| -error).collect())
    }
}
