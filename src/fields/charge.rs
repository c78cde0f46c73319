//! The field of a charge in uniform motion: a solution of all four of Maxwell's equations, with charge and current.
//! Heaviside (1888); Jackson, *Classical Electrodynamics* (3rd ed.), §11.10.

use super::{Vector, cross};
use crate::waves::constants::{C, EPSILON_0, MU_0};

/// A point charge that runs along z through the vacuum and passes the origin at t = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MovingCharge {
    /// q [C].
    pub charge: f64,
    /// Speed over that of light [1], −1 < β < 1.
    pub beta: f64,
}

impl MovingCharge {
    /// v [m s⁻¹] along z.
    pub fn speed(&self) -> f64 {
        self.beta * C
    }

    /// D [C m⁻²] at a place [m] other than the charge's own and a time [s]: q γR/4π(γ²Z² + X² + Y²)^(3/2), with the
    /// vector R from where the charge is at that very moment.
    pub fn d(&self, [x, y, z]: Vector, t: f64) -> Vector {
        debug_assert!(self.beta.abs() < 1.0);
        let ahead = z - self.speed() * t;
        let gamma = ((1.0 - self.beta) * (1.0 + self.beta)).sqrt().recip();
        let stretched = (gamma * ahead).hypot(x.hypot(y));
        let per_distance = self.charge * gamma / (4.0 * std::f64::consts::PI * stretched.powi(3));
        [x, y, ahead].map(|component| per_distance * component)
    }

    /// E = D/ε₀ [V m⁻¹].
    pub fn e(&self, place: Vector, t: f64) -> Vector {
        self.d(place, t).map(|d| d / EPSILON_0)
    }

    /// H = v×D [A m⁻¹].
    pub fn h(&self, place: Vector, t: f64) -> Vector {
        cross([0.0, 0.0, self.speed()], self.d(place, t))
    }

    /// B = μ₀H [T].
    pub fn b(&self, place: Vector, t: f64) -> Vector {
        self.h(place, t).map(|h| MU_0 * h)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Coulomb's law at rest; in motion the field is γ times as strong abreast and γ² times as weak ahead.
    #[test]
    fn is_coulombs_law_flattened() {
        let [rest, moving] = [0.0, 0.6].map(|beta| MovingCharge { charge: 1e-9, beta });
        let coulomb = 8.987_551_786e9 * 1e-9 / 4.0;
        let gamma: f64 = 1.25;
        let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-9, "{a} {b}");
        near(rest.e([0.0, 2.0, 0.0], 5.0)[1], coulomb);
        near(moving.e([0.0, 2.0, 0.0], 0.0)[1], gamma * coulomb);
        near(moving.e([0.0, 0.0, 2.0], 0.0)[2], coulomb / gamma.powi(2));
        assert_eq!(rest.b([1.0, 2.0, 3.0], 0.0), [0.0; 3]);
    }
}
