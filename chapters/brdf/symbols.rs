//! The quantities of surfaces that scatter as symbols.

use equation::{Dimension, Symbol};

/// The bidirectional reflectance distribution function [1/sr].
pub const F_R: Symbol = Symbol::scalar("f_r", Dimension::ONE).real(0.1, 1.0);
/// Radiance that arrives [W/(sr m²)].
pub const L_IN: Symbol = Symbol::scalar("L_in", Dimension::WATT_PER_SQUARE_METRE).real(0.5, 2.0);
/// Radiance that is sent back.
pub const L_R: Symbol = Symbol::scalar("L_r", Dimension::WATT_PER_SQUARE_METRE).real(0.5, 2.0);
/// Irradiance [W/m²].
pub const E: Symbol = Symbol::scalar("E", Dimension::WATT_PER_SQUARE_METRE).real(0.5, 2.0);
/// Where the light comes from.
pub const W_I: Symbol = Symbol::vector("omega_i", Dimension::ONE);
/// Where it goes.
pub const W_O: Symbol = Symbol::vector("omega_o", Dimension::ONE);
/// Solid angle of where it comes from [sr].
pub const OMEGA_I: Symbol = Symbol::scalar("omega_i", Dimension::ONE).real(0.5, 2.0);
/// Solid angle of where it goes [sr].
pub const OMEGA_O: Symbol = Symbol::scalar("omega_o", Dimension::ONE).real(0.5, 2.0);
/// Angle of incidence.
pub const THETA_I: Symbol = Symbol::scalar("theta_i", Dimension::ONE).real(0.2, 1.2);
/// Angle of what leaves.
pub const THETA_O: Symbol = Symbol::scalar("theta_o", Dimension::ONE).real(0.2, 1.2);
/// Share of the light that comes back [1].
pub const RHO: Symbol = Symbol::scalar("rho", Dimension::ONE).real(0.1, 0.9);
/// A constant BRDF [1/sr].
pub const K: Symbol = Symbol::scalar("k", Dimension::ONE).real(0.1, 1.0);
/// The solid angle of a patch of directions about the mirror's.
pub const PATCH: Symbol = Symbol::scalar("Omega", Dimension::ONE).real(0.01, 0.1);
/// A delta: 1/Ω inside the patch, 0 outside.
pub const DELTA: Symbol = Symbol::scalar("delta", Dimension::ONE).real(1.0, 10.0);
/// Angle between the half vector and either direction.
pub const THETA_H: Symbol = Symbol::scalar("theta_h", Dimension::ONE).real(0.2, 0.7);
/// Roughness.
pub const ALPHA: Symbol = Symbol::scalar("alpha", Dimension::ONE).real(0.2, 1.0);
/// cot θ of a direction: the slope of the facets that it grazes.
pub const MU: Symbol = Symbol::scalar("mu", Dimension::ONE).real(0.2, 2.0);
/// arctan of a slope over α.
pub const PSI: Symbol = Symbol::scalar("psi", Dimension::ONE).real(0.3, 1.2);
/// The same of the slope that is grazed.
pub const PSI_0: Symbol = Symbol::scalar("psi_0", Dimension::ONE).real(0.3, 1.2);
/// Smith's Λ.
pub const LAMBDA: Symbol = Symbol::scalar("Lambda", Dimension::ONE).real(0.1, 1.0);
/// Distribution of facets [1/sr].
pub const D_M: Symbol = Symbol::scalar("D", Dimension::ONE).real(0.5, 2.0);
/// Fresnel's reflectance.
pub const F: Symbol = Symbol::scalar("F", Dimension::ONE).real(0.1, 0.9);
/// Masking from one side.
pub const G_1: Symbol = Symbol::scalar("G_1", Dimension::ONE).real(0.3, 0.9);
/// Masking from both.
pub const G_2: Symbol = Symbol::scalar("G_2", Dimension::ONE).real(0.2, 0.8);
/// cos θ of where light comes from.
pub const C_I: Symbol = Symbol::scalar("c_i", Dimension::ONE).real(0.2, 0.9);
/// cos θ of where it goes.
pub const C_O: Symbol = Symbol::scalar("c_o", Dimension::ONE).real(0.2, 0.9);
/// cos of the angle between the facet's normal and where the light goes.
pub const C_M: Symbol = Symbol::scalar("c_m", Dimension::ONE).real(0.2, 0.9);
/// Density with which a direction is drawn [1/sr].
pub const PDF: Symbol = Symbol::scalar("p", Dimension::ONE).real(0.1, 2.0);
/// Index on the side where the light comes from.
pub const N_I: Symbol = Symbol::scalar("n_i", Dimension::ONE).real(1.4, 1.8);
/// Index on the side where it goes.
pub const N_O: Symbol = Symbol::scalar("n_o", Dimension::ONE).real(1.0, 1.3);
