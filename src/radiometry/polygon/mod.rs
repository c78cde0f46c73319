//! Irradiance from any plane polygon: Lambert's sum over its edges (J. H. Lambert, *Photometria*, 1760, §§180–186; D. R.
//! Baum, H. E. Rushmeier, J. M. Winget, SIGGRAPH 1989), clipped at the receiver's horizon.

mod checked;
mod clipped;
pub mod vector;
mod wide;

pub use checked::{FLATNESS, RATIO};

use super::Refusal;
use checked::checked;
use clipped::Clipped;
use vector::{Vector, cross, dot, in_unit};

/// E/L [sr] on the receiver at the origin from what of a simple polygon, convex or not, is above its horizon. Corners may
/// run either way round, for both sides shine; the normal may have any length. From a place in the polygon's plane, be it
/// on an edge or within, it is seen edge-on and sends nothing.
///
/// # Errors
/// If there are fewer than three corners, they are off their plane by more than [`FLATNESS`] or all on one line, edges
/// cross, lengths differ by more than [`RATIO`], the normal is null, or any number is not finite.
pub fn irradiance(corners: &[Vector], normal: Vector) -> Result<f64, Refusal> {
    Ok(checked(corners, normal)?.map_or(0.0, |polygon| Clipped::new(&polygon).irradiance().abs()))
}

/// What each edge of a polygon adds to Lambert's sum [sr]: half the angle at which it is seen, along the normal of the plane
/// through it and the receiver; none where it is seen end-on. E/L of a polygon wholly above the horizon is what the sum of
/// these has along the receiver's normal, negative if the corners run clockwise as seen from the receiver.
pub fn edges(corners: &[Vector]) -> Vec<Vector> {
    let edge = |(&from, &to): (&Vector, &Vector)| {
        let across = cross(from, to);
        let size = dot(across, across).sqrt();
        let half = 0.5 * size.atan2(dot(from, to));
        if size == 0.0 { [0.0; 3] } else { across.map(|component| half * component / size) }
    };
    let corners = in_unit(corners);
    corners.iter().zip(corners.iter().cycle().skip(1)).map(edge).collect()
}
