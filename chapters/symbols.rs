//! The quantities of fields, waves and their energy as symbols, for all chapters that speak of them. What holds on the
//! real axis alone, because it is a statement about cosines and their amplitudes, is sampled there; the rest off it too.

use equation::{Dimension, Symbol};

/// Place along the propagation.
pub const Z: Symbol = Symbol::scalar("z", Dimension::METRE).real(0.25, 1.25);
/// Place, in any direction.
pub const R: Symbol = Symbol::vector("r", Dimension::METRE);
/// Time.
pub const T: Symbol = Symbol::scalar("t", Dimension::SECOND).real(0.25, 1.25);

/// Permittivity.
pub const EPSILON: Symbol = Symbol::scalar("epsilon", Dimension::FARAD_PER_METRE).real(0.5, 2.0);
/// Permeability.
pub const MU: Symbol = Symbol::scalar("mu", Dimension::HENRY_PER_METRE).real(0.5, 2.0);
/// Conductivity.
pub const SIGMA: Symbol = Symbol::scalar("sigma", Dimension::SIEMENS_PER_METRE).real(0.5, 2.0);
/// Permittivity of the vacuum.
pub const EPSILON_0: Symbol = Symbol::scalar("epsilon_0", Dimension::FARAD_PER_METRE).real(0.5, 2.0);
/// Permeability of the vacuum.
pub const MU_0: Symbol = Symbol::scalar("mu_0", Dimension::HENRY_PER_METRE).real(0.5, 2.0);

/// Electric field.
pub const E: Symbol = Symbol::vector("E", Dimension::VOLT_PER_METRE).field();
/// Magnetic flux density.
pub const B: Symbol = Symbol::vector("B", Dimension::TESLA).field();
/// Electric displacement.
pub const D: Symbol = Symbol::vector("D", Dimension::COULOMB_PER_SQUARE_METRE).field();
/// Magnetic field.
pub const H: Symbol = Symbol::vector("H", Dimension::AMPERE_PER_METRE).field();
/// Density of current.
pub const J: Symbol = Symbol::vector("J", Dimension::AMPERE_PER_SQUARE_METRE).field();
/// Density of charge.
pub const RHO: Symbol = Symbol::scalar("rho", Dimension::COULOMB_PER_CUBIC_METRE).field();

/// The electric field of a plane wave: a function of z and t.
pub const WAVE: Symbol = Symbol::scalar("E_x", Dimension::VOLT_PER_METRE);
/// The part of a wave that runs towards larger z.
pub const F_1: Symbol = Symbol::scalar("f_1", Dimension::VOLT_PER_METRE);
/// The part of a wave that runs towards smaller z.
pub const F_2: Symbol = Symbol::scalar("f_2", Dimension::VOLT_PER_METRE);
/// The shape of a one-way wave's electric field.
pub const F_E: Symbol = Symbol::scalar("f_E", Dimension::VOLT_PER_METRE);
/// The shape of its magnetic field.
pub const F_B: Symbol = Symbol::scalar("f_B", Dimension::TESLA);

/// Speed of the wave.
pub const V: Symbol = Symbol::scalar("v", Dimension::METRE_PER_SECOND).real(0.5, 2.0);
/// Speed of light in the vacuum.
pub const C: Symbol = Symbol::scalar("c", Dimension::METRE_PER_SECOND).real(0.5, 2.0);
/// Angular frequency.
pub const OMEGA: Symbol = Symbol::scalar("omega", Dimension::HERTZ).real(0.5, 2.0);
/// Wave number.
pub const K: Symbol = Symbol::scalar("k", Dimension::RADIAN_PER_METRE).real(0.5, 2.0);
/// Wavelength in the medium.
pub const LAMBDA: Symbol = Symbol::scalar("lambda", Dimension::METRE).real(0.5, 2.0);
/// Period.
pub const PERIOD: Symbol = Symbol::scalar("T", Dimension::SECOND).real(0.5, 2.0);
/// Wave vector, in any direction; complex where the wave is damped.
pub const K_VECTOR: Symbol = Symbol::vector("k", Dimension::RADIAN_PER_METRE);
/// Amplitude of the electric field.
pub const AMPLITUDE: Symbol = Symbol::scalar("A", Dimension::VOLT_PER_METRE).real(0.5, 2.0);
/// Amplitude of the magnetic flux density.
pub const AMPLITUDE_B: Symbol = Symbol::scalar("A'", Dimension::TESLA).real(0.5, 2.0);
/// Amplitude and phase of the electric field along each axis.
pub const A_VECTOR: Symbol = Symbol::vector("A", Dimension::VOLT_PER_METRE);
/// Characteristic impedance.
pub const Z_C: Symbol = Symbol::scalar("Z_c", Dimension::OHM);
/// Skin depth.
pub const DELTA: Symbol = Symbol::scalar("delta", Dimension::METRE).real(0.5, 2.0);

/// Flow of energy.
pub const S: Symbol = Symbol::vector("S", Dimension::WATT_PER_SQUARE_METRE);
/// Density of energy.
pub const U_DENSITY: Symbol = Symbol::scalar("u", Dimension::JOULE_PER_CUBIC_METRE);
