//! The quantities of radiometry as symbols. A steradian is a pure number, as a radian is.

use equation::{Dimension, Symbol};

/// Radiant flux [W].
pub const FLUX: Symbol = Symbol::scalar("Phi", Dimension::WATT).real(0.5, 2.0);
/// Radiant intensity [W/sr].
pub const INTENSITY: Symbol = Symbol::scalar("I", Dimension::WATT).real(0.5, 2.0);
/// Radiance [W/(sr m²)].
pub const RADIANCE: Symbol = Symbol::scalar("L", Dimension::WATT_PER_SQUARE_METRE).real(0.5, 2.0);
/// Radiance on the side of the light.
pub const RADIANCE_1: Symbol = Symbol::scalar("L_1", Dimension::WATT_PER_SQUARE_METRE).real(0.5, 2.0);
/// Radiance behind the interface.
pub const RADIANCE_2: Symbol = Symbol::scalar("L_2", Dimension::WATT_PER_SQUARE_METRE).real(0.5, 2.0);
/// Irradiance [W/m²].
pub const IRRADIANCE: Symbol = Symbol::scalar("E", Dimension::WATT_PER_SQUARE_METRE).real(0.5, 2.0);
/// Mean flow of energy along the radius [W/m²].
pub const S_R: Symbol = Symbol::scalar("S_r", Dimension::WATT_PER_SQUARE_METRE).real(0.5, 2.0);
/// Area.
pub const AREA: Symbol = Symbol::scalar("A", Dimension::SQUARE_METRE).real(0.5, 2.0);
/// Area of another surface.
pub const AREA_2: Symbol = Symbol::scalar("A'", Dimension::SQUARE_METRE).real(0.5, 2.0);
/// A unit vector across a surface.
pub const NORMAL: Symbol = Symbol::vector("n", Dimension::ONE);
/// Angle between the flow and a surface's normal.
pub const ALPHA: Symbol = Symbol::scalar("alpha", Dimension::ONE).real(0.2, 1.2);
/// Polar angle.
pub const THETA: Symbol = Symbol::scalar("theta", Dimension::ONE).real(0.2, 1.2);
/// Polar angle at the other surface.
pub const THETA_2: Symbol = Symbol::scalar("theta'", Dimension::ONE).real(0.2, 1.2);
/// Azimuth.
pub const AZIMUTH: Symbol = Symbol::scalar("phi", Dimension::ONE).real(0.2, 1.2);
/// Solid angle [sr].
pub const SOLID_ANGLE: Symbol = Symbol::scalar("Omega", Dimension::ONE).real(0.5, 2.0);
/// Distance from the source.
pub const RADIUS: Symbol = Symbol::scalar("r", Dimension::METRE).real(0.5, 2.0);
/// Height above a surface.
pub const HEIGHT: Symbol = Symbol::scalar("h", Dimension::METRE).real(0.5, 2.0);
/// A place, from the source.
pub const PLACE: Symbol = Symbol::vector("P", Dimension::METRE);
/// Refractive index on the side of the light.
pub const N_1: Symbol = Symbol::scalar("n_1", Dimension::ONE).real(1.5, 2.0);
/// Refractive index behind the interface.
pub const N_2: Symbol = Symbol::scalar("n_2", Dimension::ONE).real(1.0, 1.4);
/// The surface that is meant.
pub const SURFACE: Symbol = Symbol::scalar("Sigma", Dimension::SQUARE_METRE);
/// Radius of a disc or sphere.
pub const RADIUS_OF: Symbol = Symbol::scalar("R", Dimension::METRE).real(0.5, 1.0);
/// Distance of its centre.
pub const DISTANCE: Symbol = Symbol::scalar("d", Dimension::METRE).real(1.5, 3.0);
/// Angle between the receiver's normal and the way to a sphere.
pub const OMEGA: Symbol = Symbol::scalar("omega", Dimension::ONE).real(0.2, 1.2);
