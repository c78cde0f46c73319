//! Energy that leaves, passes and arrives: what lamps of every shape send to a place.
//!
//! Lamps have the radiance 1 everywhere and in all directions, so that what arrives is the projected solid angle
//! E/L [sr]; an irradiance is that times the radiance. The receiver is at the origin, and a lamp shines to both sides.
//! Lengths are in one unit, whichever. Everything is refused that has no size, no place or no number.
//!
//! | idea | where |
//! |---|---|
//! | how a source shares its flux | [`pattern`] |
//! | cones, discs and triangles as seen | [`solid_angle`] |
//! | what arrives from a disc, rectangle, sphere, polygon | [`disc`], [`rectangle`], [`sphere`], [`polygon`] |
//! | the share that goes from surface to surface | [`form_factor`] |
//! | the same as textbooks print it | [`textbook`] |

pub mod disc;
pub mod form_factor;
pub mod pattern;
pub mod polygon;
pub mod rectangle;
mod refusal;
pub mod solid_angle;
pub mod sphere;
#[cfg(test)]
mod tests;
pub mod textbook;

pub use refusal::Refusal;

/// Irradiance [W m⁻²] from a point that sends `flux` [W] alike to all sides, `distance` [m] away, at the angle `theta`
/// [rad] to the receiver's normal; 0 behind it.
///
/// # Errors
/// If the distance is not positive, or any of them is no number.
pub fn point(flux: f64, distance: f64, theta: f64) -> Result<f64, Refusal> {
    let flux = Refusal::unless("Phi", flux, flux >= 0.0, "0 or more")?;
    let distance = Refusal::unless_positive("d", distance)?;
    let theta = Refusal::unless("theta", theta, true, "any")?;
    // A factor at a time: the square of a distance may leave the range.
    Ok(pattern::Pattern::Isotropic.intensity(flux, 1.0) / distance / distance * theta.cos().max(0.0))
}
