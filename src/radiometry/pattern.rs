//! How sources share their flux among the directions.

use std::f64::consts::PI;

/// How a source sends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pattern {
    /// Alike in all directions.
    Isotropic,
    /// As cos θ on one side of a surface, nothing on the other (J. H. Lambert, *Photometria*, 1760, §81).
    Lambertian,
    /// As sin² θ about an axis: a short antenna (Jackson, *Classical Electrodynamics* (3rd ed.), eq. 9.23).
    Antenna,
}

impl Pattern {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Isotropic, Self::Lambertian, Self::Antenna];

    /// Command-line word.
    pub fn name(self) -> &'static str {
        match self {
            Self::Isotropic => "isotropic",
            Self::Lambertian => "lambertian",
            Self::Antenna => "antenna",
        }
    }

    /// Intensity [W sr⁻¹] at cos θ [1], −1 … 1, from normal or axis, of a source that sends `flux` [W] in all.
    pub fn intensity(self, flux: f64, cos: f64) -> f64 {
        match self {
            Self::Isotropic => flux / (4.0 * PI),
            Self::Lambertian => flux * cos.max(0.0) / PI,
            Self::Antenna => flux * (1.0 - cos) * (1.0 + cos) * (3.0 / (8.0 * PI)),
        }
    }
}
