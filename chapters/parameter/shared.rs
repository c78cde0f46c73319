//! The quantities that many steps and functions share: one name, one symbol and one domain each.

use super::{Alias, Kind, Parameter};
use light::waves::constants::C;
use std::f64::consts::FRAC_PI_2;

/// The vacuum wavelength [m] used where a step names none: the middle of the visible.
pub const DEFAULT_WAVELENGTH: f64 = 550e-9;

/// Who takes a wavelength takes a frequency.
pub const BY_FREQUENCY: Alias = Alias::over("freq", C, "Hz");

/// Who takes a frequency takes a vacuum wavelength.
pub const BY_WAVELENGTH: Alias = Alias::over("wavelength", C, "m");

/// The parameter every optics step shares: the vacuum wavelength.
pub const WAVELENGTH: Parameter = Parameter::new("wavelength", "λ", "vacuum wavelength", Kind::number(1e-9, 1e-3, "m"))
    .default("550nm")
    .aliases(&[BY_FREQUENCY]);

/// The medium of a wave of any frequency.
pub const MEDIUM: Parameter =
    Parameter::new("medium", "ε_r/μ_r/σ", "the medium, by name or as ε_r/μ_r/σ with σ in S/m", Kind::Conductor)
        .default("copper");

/// The frequency of a wave.
pub const FREQUENCY: Parameter =
    Parameter::new("freq", "f", "frequency", Kind::number(1e-3, 1e16, "Hz")).default("1GHz").aliases(&[BY_WAVELENGTH]);

/// The angle of incidence, measured from the normal.
pub const THETA: Parameter =
    Parameter::new("theta", "θ_1", "angle of incidence, from the normal", Kind::number(0.0, FRAC_PI_2, "rad"))
        .default("45deg");
