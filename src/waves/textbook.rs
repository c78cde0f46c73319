//! The formulas as books print them, to be held against the forms of this module. They are right in exact arithmetic;
//! in `f64` they lose digits or overflow. Nothing else in the project calls them.

use super::plane::{Medium, Wave};
use num_complex::Complex64;
use std::f64::consts::TAU;

/// E18 as in Balanis, *Advanced Engineering Electromagnetics* (2nd ed.), §4.3, or Griffiths, *Introduction to
/// Electrodynamics* (4th ed.), eq. 9.126: Im k = ω√(με/2) (√(1 + τ²) − 1)^½, Re k with + in place of −,
/// Z = √(μ/ε) (1 + τ²)^(−¼) e^(−i arg k).
pub fn wave(medium: &Medium, omega: f64) -> Wave {
    let (epsilon, mu) = (medium.epsilon(), medium.mu());
    let tau = medium.sigma() / (omega * epsilon);
    let (free, root) = (omega * (mu * epsilon / 2.0).sqrt(), (1.0 + tau * tau).sqrt());
    let k = Complex64::new(free * (root + 1.0).sqrt(), free * (root - 1.0).sqrt());
    let phase_lag = 0.5 * tau.atan();
    let impedance = Complex64::from_polar((mu / epsilon).sqrt() / root.sqrt(), -phase_lag);
    Wave {
        omega,
        k,
        impedance,
        skin_depth: 1.0 / k.im,
        phase_lag,
        wavelength: TAU / k.re,
        v_phase: omega / k.re,
        mean_flux: 0.5 * (1.0 / impedance.conj()).re,
    }
}

/// cos(2πft) by the rounded product: wrong by 2πft rounding units.
pub fn cos_of_time(frequency: f64, time: f64) -> f64 {
    (TAU * frequency * time).cos()
}
