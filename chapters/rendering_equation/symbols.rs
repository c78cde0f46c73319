//! The quantities of light that bounces as symbols.

use equation::{Dimension, Symbol};

/// Radiance that leaves [W/(sr m²)].
pub const L_O: Symbol = Symbol::scalar("L_o", Dimension::WATT_PER_SQUARE_METRE).real(0.5, 2.0);
/// What is sent out by itself.
pub const L_E: Symbol = Symbol::scalar("L_e", Dimension::WATT_PER_SQUARE_METRE).real(0.5, 2.0);
/// What arrives.
pub const L_IN: Symbol = Symbol::scalar("L_in", Dimension::WATT_PER_SQUARE_METRE).real(0.5, 2.0);
/// What is sent back.
pub const L_R: Symbol = Symbol::scalar("L_r", Dimension::WATT_PER_SQUARE_METRE).real(0.5, 2.0);
/// All of it, where it is the same all over.
pub const L: Symbol = Symbol::scalar("L", Dimension::WATT_PER_SQUARE_METRE).real(0.5, 2.0);
/// k terms of the series.
pub const L_K: Symbol = Symbol::scalar("L_k", Dimension::WATT_PER_SQUARE_METRE).real(0.5, 2.0);
/// One term more.
pub const L_NEXT: Symbol = Symbol::scalar("L_next", Dimension::WATT_PER_SQUARE_METRE).real(0.5, 2.0);
/// The BRDF [1/sr].
pub const F_R: Symbol = Symbol::scalar("f_r", Dimension::ONE).real(0.1, 1.0);
/// Angle of incidence.
pub const THETA: Symbol = Symbol::scalar("theta", Dimension::ONE).real(0.2, 1.2);
/// Angle of incidence at the other end.
pub const THETA_2: Symbol = Symbol::scalar("theta'", Dimension::ONE).real(0.2, 1.2);
/// Solid angle of where light comes from [sr].
pub const OMEGA: Symbol = Symbol::scalar("omega_i", Dimension::ONE).real(0.5, 2.0);
/// Share of the light that comes back [1].
pub const RHO: Symbol = Symbol::scalar("rho", Dimension::ONE).real(0.1, 0.9);
/// ρ to the k-th.
pub const POWER: Symbol = Symbol::scalar("p", Dimension::ONE).real(0.1, 0.9);
/// One bounce, as an operator.
pub const K: Symbol = Symbol::scalar("K", Dimension::ONE).real(0.1, 0.9);
/// Radiance of one of two surfaces that face each other.
pub const L_1: Symbol = Symbol::scalar("L_1", Dimension::WATT_PER_SQUARE_METRE).real(0.5, 2.0);
/// Of the other.
pub const L_2: Symbol = Symbol::scalar("L_2", Dimension::WATT_PER_SQUARE_METRE).real(0.5, 2.0);
/// What the first sends out by itself.
pub const E_1: Symbol = Symbol::scalar("L_e1", Dimension::WATT_PER_SQUARE_METRE).real(0.5, 2.0);
/// The other.
pub const E_2: Symbol = Symbol::scalar("L_e2", Dimension::WATT_PER_SQUARE_METRE).real(0.5, 2.0);
/// Radiance of a black body as hot as the first.
pub const B_1: Symbol = Symbol::scalar("B_1", Dimension::WATT_PER_SQUARE_METRE).real(1.5, 2.0);
/// As hot as the other.
pub const B_2: Symbol = Symbol::scalar("B_2", Dimension::WATT_PER_SQUARE_METRE).real(0.5, 1.0);
/// What the first absorbs, 1 − ρ₁ [1].
pub const A_1: Symbol = Symbol::scalar("a_1", Dimension::ONE).real(0.1, 0.9);
/// The other.
pub const A_2: Symbol = Symbol::scalar("a_2", Dimension::ONE).real(0.1, 0.9);
/// Area of the ball over that of the sphere about it [1].
pub const RATIO: Symbol = Symbol::scalar("k", Dimension::ONE).real(0.1, 0.9);
/// Form factor from one patch to another [1].
pub const F_12: Symbol = Symbol::scalar("F_12", Dimension::ONE).real(0.1, 0.9);
/// And back.
pub const F_21: Symbol = Symbol::scalar("F_21", Dimension::ONE).real(0.1, 0.9);
/// Area of one.
pub const S_1: Symbol = Symbol::scalar("S_1", Dimension::SQUARE_METRE).real(0.5, 2.0);
/// Of the other.
pub const S_2: Symbol = Symbol::scalar("S_2", Dimension::SQUARE_METRE).real(0.5, 2.0);
/// From a point of one to a point of the other.
pub const DISTANCE: Symbol = Symbol::scalar("r", Dimension::METRE).real(0.5, 2.0);
