//! What is integrated over, and how the unit square covers it evenly.

use super::Direction;
use std::f64::consts::{PI, TAU};

/// A set of directions and its measure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Domain {
    /// All directions, dω.
    Sphere,
    /// Those with z ≥ 0, dω.
    Hemisphere,
    /// Those with z ≥ 0, cos θ dω: what irradiance and reflection weigh by.
    Cosine,
}

impl Domain {
    /// All domains.
    pub const ALL: [Self; 3] = [Self::Sphere, Self::Hemisphere, Self::Cosine];

    /// Its whole measure [sr]: 4π, 2π, or π.
    pub fn size(self) -> f64 {
        match self {
            Self::Sphere => 2.0 * TAU,
            Self::Hemisphere => TAU,
            Self::Cosine => PI,
        }
    }

    /// The direction at (u, v) of the unit square: equal areas there have equal measure here, so even points make a
    /// density of 1/[`Self::size`] in the domain's own measure.
    ///
    /// v goes around. u is the way down from the top of the cylinder about the sphere (Archimedes), or the area of the
    /// disc under the hemisphere (Malley).
    pub fn at(self, [u, v]: [f64; 2]) -> Direction {
        // sin² θ in factors, which cancel at neither end.
        let (radius, z) = match self {
            Self::Sphere => (2.0 * (u * (1.0 - u)).sqrt(), 1.0 - 2.0 * u),
            Self::Hemisphere => ((u * (2.0 - u)).sqrt(), 1.0 - u),
            Self::Cosine => (u.sqrt(), (1.0 - u).sqrt()),
        };
        let (sin, cos) = (TAU * v).sin_cos();
        [radius * cos, radius * sin, z]
    }
}
