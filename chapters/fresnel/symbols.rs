//! The quantities of the chapter as symbols. Side 1 is where the light comes from, side 2 the other.
//! Indices and angles are sampled off the real axis too: what is derived here holds for metals as well.

use equation::{Dimension, Symbol};

/// Refractive index of the incident side.
pub const N_1: Symbol = Symbol::scalar("n_1", Dimension::ONE).within(1.0, 2.0);
/// Refractive index of the other side.
pub const N_2: Symbol = Symbol::scalar("n_2", Dimension::ONE).within(1.0, 2.5);
/// Angle of incidence.
pub const THETA_1: Symbol = Symbol::scalar("theta_1", Dimension::ONE).within(0.2, 1.2);
/// Angle of reflection.
pub const THETA_1R: Symbol = Symbol::scalar("theta_1'", Dimension::ONE).within(0.2, 1.2);
/// Angle of refraction.
pub const THETA_2: Symbol = Symbol::scalar("theta_2", Dimension::ONE).within(0.2, 1.2);
/// n₁/sin θ₂ = n₂/sin θ₁: the symmetric parameter of Snell's law.
pub const K: Symbol = Symbol::scalar("k", Dimension::ONE).within(1.0, 2.0);
/// Relative index n₂/n₁.
pub const N_REL: Symbol = Symbol::scalar("n", Dimension::ONE).real(4.0, 9.0);
/// Vacuum wave number.
pub const K_0: Symbol = Symbol::scalar("k_0", Dimension::RADIAN_PER_METRE).within(1.0, 2.0);
/// Wave number on the incident side.
pub const K_1: Symbol = Symbol::scalar("k_1", Dimension::RADIAN_PER_METRE).within(1.0, 2.0);
/// Wave number on the other side.
pub const K_2: Symbol = Symbol::scalar("k_2", Dimension::RADIAN_PER_METRE).within(1.0, 2.0);
/// Along the interface, in the plane of incidence.
pub const X: Symbol = Symbol::scalar("x", Dimension::METRE).real(0.25, 1.25);
/// Across the interface, into the other side.
pub const Z: Symbol = Symbol::scalar("z", Dimension::METRE).real(0.25, 1.25);
/// Time.
pub const T: Symbol = Symbol::scalar("t", Dimension::SECOND).real(0.25, 1.25);
/// Angular frequency.
pub const OMEGA: Symbol = Symbol::scalar("omega", Dimension::HERTZ).real(1.0, 2.0);
/// Speed of light.
pub const C: Symbol = Symbol::scalar("c", Dimension::METRE_PER_SECOND).real(1.0, 2.0);
/// Phase velocity on the incident side.
pub const V_1: Symbol = Symbol::scalar("v_1", Dimension::METRE_PER_SECOND).within(0.5, 1.0);
/// Phase velocity on the other side.
pub const V_2: Symbol = Symbol::scalar("v_2", Dimension::METRE_PER_SECOND).within(0.5, 1.0);

/// Incident electric field.
pub const E_1: Symbol = Symbol::scalar("E_1", Dimension::VOLT_PER_METRE).within(1.0, 2.0);
/// Reflected electric field.
pub const E_1R: Symbol = Symbol::scalar("E_1'", Dimension::VOLT_PER_METRE).within(1.0, 2.0);
/// Transmitted electric field.
pub const E_2: Symbol = Symbol::scalar("E_2", Dimension::VOLT_PER_METRE).within(1.0, 2.0);
/// Incident magnetic field.
pub const H_1: Symbol = Symbol::scalar("H_1", Dimension::AMPERE_PER_METRE).within(1.0, 2.0);
/// Reflected magnetic field.
pub const H_1R: Symbol = Symbol::scalar("H_1'", Dimension::AMPERE_PER_METRE).within(1.0, 2.0);
/// Transmitted magnetic field.
pub const H_2: Symbol = Symbol::scalar("H_2", Dimension::AMPERE_PER_METRE).within(1.0, 2.0);
/// Normal of the interface, into the other side.
pub const NORMAL: Symbol = Symbol::vector("n", Dimension::ONE);
/// Electric fields at the interface: incident, reflected, transmitted.
pub const ELECTRIC: [Symbol; 3] = [
    Symbol::vector("E_i", Dimension::VOLT_PER_METRE),
    Symbol::vector("E_r", Dimension::VOLT_PER_METRE),
    Symbol::vector("E_t", Dimension::VOLT_PER_METRE),
];
/// Magnetic fields at the interface: incident, reflected, transmitted.
pub const MAGNETIC: [Symbol; 3] = [
    Symbol::vector("H_i", Dimension::AMPERE_PER_METRE),
    Symbol::vector("H_r", Dimension::AMPERE_PER_METRE),
    Symbol::vector("H_t", Dimension::AMPERE_PER_METRE),
];
/// Impedance of the vacuum.
pub const Z_0: Symbol = Symbol::scalar("Z_0", Dimension::OHM).real(1.0, 2.0);

/// Reflected over incident electric field, s.
pub const R_S: Symbol = Symbol::scalar("r_s", Dimension::ONE);
/// Transmitted over incident electric field, s.
pub const T_S: Symbol = Symbol::scalar("t_s", Dimension::ONE);
/// Reflected over incident electric field, p.
pub const R_P: Symbol = Symbol::scalar("r_p", Dimension::ONE);
/// Transmitted over incident electric field, p.
pub const T_P: Symbol = Symbol::scalar("t_p", Dimension::ONE);

/// Normal wave number behind the interface over that of the vacuum.
pub const Q_2: Symbol = Symbol::scalar("q_2", Dimension::ONE);
/// Reflectance at normal incidence.
pub const R_0: Symbol = Symbol::scalar("R_0", Dimension::ONE);
/// Reflectance of natural light.
pub const R_N: Symbol = Symbol::scalar("R_n", Dimension::ONE);
