//! The quantities of path tracing as symbols.

use equation::{Dimension, Symbol};

/// Radiance that comes from a point [W/(sr m²)].
pub const L: Symbol = Symbol::scalar("L", Dimension::WATT_PER_SQUARE_METRE).real(0.5, 2.0);
/// What it sends out by itself.
pub const L_E: Symbol = Symbol::scalar("L_e", Dimension::WATT_PER_SQUARE_METRE).real(0.5, 2.0);
/// Radiance that arrives there.
pub const L_IN: Symbol = Symbol::scalar("L_in", Dimension::WATT_PER_SQUARE_METRE).real(0.5, 2.0);
/// The estimate of one path.
pub const X: Symbol = Symbol::scalar("X", Dimension::WATT_PER_SQUARE_METRE).real(0.5, 2.0);
/// BRDF [1/sr].
pub const F_R: Symbol = Symbol::scalar("f_r", Dimension::ONE).real(0.1, 1.0);
/// Angle of incidence.
pub const THETA: Symbol = Symbol::scalar("theta", Dimension::ONE).real(0.2, 1.2);
/// Solid angle of where light comes from [sr].
pub const OMEGA: Symbol = Symbol::scalar("omega", Dimension::ONE).real(0.5, 2.0);
/// Density with which a direction is drawn [1/sr].
pub const P: Symbol = Symbol::scalar("p", Dimension::ONE).real(0.1, 2.0);
/// Share of the light that comes back [1].
pub const RHO: Symbol = Symbol::scalar("rho", Dimension::ONE).real(0.1, 0.9);
