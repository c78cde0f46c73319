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
/// Light times cosine and BRDF, from one direction: what is to be summed.
pub const G: Symbol = Symbol::scalar("g", Dimension::WATT_PER_SQUARE_METRE).real(0.5, 2.0);
/// Densities of two ways to draw a direction [1/sr].
pub const P_1: Symbol = Symbol::scalar("p_1", Dimension::ONE).real(0.1, 2.0);
/// The other's.
pub const P_2: Symbol = Symbol::scalar("p_2", Dimension::ONE).real(0.1, 2.0);
/// Shares with which they count [1].
pub const W_1: Symbol = Symbol::scalar("w_1", Dimension::ONE).real(0.1, 0.9);
/// The other's.
pub const W_2: Symbol = Symbol::scalar("w_2", Dimension::ONE).real(0.1, 0.9);
/// Radiance by paths of at most d edges.
pub const L_D: Symbol = Symbol::scalar("L_d", Dimension::WATT_PER_SQUARE_METRE).real(0.5, 2.0);
/// Radiance by paths of one edge less.
pub const L_SHORT: Symbol = Symbol::scalar("L_short", Dimension::WATT_PER_SQUARE_METRE).real(0.5, 2.0);
/// Chance to go on [1].
pub const Q: Symbol = Symbol::scalar("q", Dimension::ONE).real(0.5, 0.9);
/// Mean of what a path finds, over L_e [1].
pub const M: Symbol = Symbol::scalar("m", Dimension::ONE).real(1.0, 4.0);
/// Mean of its square.
pub const M_2: Symbol = Symbol::scalar("m_2", Dimension::ONE).real(1.0, 9.0);
/// Radius of a disc about a place [m].
pub const R: Symbol = Symbol::scalar("r", Dimension::METRE).real(0.5, 2.0);
/// Distance from its middle.
pub const S: Symbol = Symbol::scalar("s", Dimension::METRE).real(0.1, 0.4);
/// Index of a prism over that outside [1].
pub const N: Symbol = Symbol::scalar("n", Dimension::ONE).real(1.1, 1.7);
/// Sine of half the angle of its edge [1], or of an angle within it.
pub const S_HALF: Symbol = Symbol::scalar("s", Dimension::ONE).real(0.1, 0.5);
/// Angles of two polarisers' axes.
pub const ALPHA: Symbol = Symbol::scalar("alpha", Dimension::ONE).real(0.1, 1.5);
/// The other's.
pub const BETA: Symbol = Symbol::scalar("beta", Dimension::ONE).real(0.1, 1.5);
/// Cosine of the angle before an interface [1].
pub const COS_1: Symbol = Symbol::scalar("c_1", Dimension::ONE).real(0.2, 0.9);
/// Behind it.
pub const COS_2: Symbol = Symbol::scalar("c_2", Dimension::ONE).real(0.2, 0.9);
