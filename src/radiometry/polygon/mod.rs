//! Irradiance from any plane polygon: Lambert's sum over its edges (J. H. Lambert, *Photometria*, 1760, §§180–186; D. R.
//! Baum, H. E. Rushmeier, J. M. Winget, SIGGRAPH 1989), clipped at the receiver's horizon.

mod checked;
mod clipped;
pub mod vector;
mod wide;

pub use checked::FLATNESS;

use super::Refusal;
use checked::checked;
use clipped::Clipped;
use vector::Vector;

/// E/L [sr] on the receiver at the origin from what of a simple polygon, convex or not, is above its horizon. Corners may
/// run either way round, for both sides shine; the normal may have any length. From a place in the polygon's plane, be it
/// on an edge or within, it is seen edge-on and sends nothing.
///
/// # Errors
/// If there are fewer than three corners, they are off their plane by more than [`FLATNESS`] or all on one line, edges
/// cross, the normal is null, or any number is not finite.
pub fn irradiance(corners: &[Vector], normal: Vector) -> Result<f64, Refusal> {
    Ok(checked(corners, normal)?.map_or(0.0, |polygon| Clipped::new(&polygon).irradiance().abs()))
}

/// What one edge adds to Lambert's sum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge {
    /// Where it starts, in the corners' unit.
    pub from: Vector,
    /// Where it ends.
    pub to: Vector,
    /// γ: the angle between both as seen from the receiver [rad].
    pub angle: f64,
    /// ½γ along the normal of the plane through edge and receiver [sr]. The sum of these has E/L along the receiver's
    /// normal.
    pub contribution: Vector,
}

/// The edges of what is above the horizon, with those along the horizon that close it: bridges between the pieces into
/// which a polygon that is not convex is cut run there and back. None where nothing is seen.
///
/// # Errors
/// As [`irradiance`].
pub fn edges(corners: &[Vector], normal: Vector) -> Result<Vec<Edge>, Refusal> {
    Ok(checked(corners, normal)?.map_or(Vec::new(), |polygon| Clipped::new(&polygon).edges()))
}
