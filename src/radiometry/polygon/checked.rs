//! Which polygons have an answer.

use super::super::Refusal;
use super::vector::{Vector, cross, dot, in_unit, minus};
use super::wide::WideVector;
use crate::wide::Wide;

/// How far corners may be off their plane [1], in units of the largest distance from the first to another.
pub const FLATNESS: f64 = 1e-8;

/// A polygon that has an answer, and is not seen edge-on.
pub(super) struct Polygon {
    /// The corners in a unit in which the largest coordinate is about 1.
    pub(super) corners: Vec<Vector>,
    /// The receiver's normal, of length 1.
    pub(super) normal: WideVector,
}

/// None where the receiver is in the polygon's plane.
pub(super) fn checked(corners: &[Vector], normal: Vector) -> Result<Option<Polygon>, Refusal> {
    let count = corners.len();
    if count < 3 {
        return Err(Refusal::new("vertices", format!("{count} corners are no polygon; valid: 3 or more")));
    }
    for &coordinate in corners.as_flattened() {
        Refusal::unless("vertices", coordinate, true, "finite coordinates")?;
    }
    for component in normal {
        Refusal::unless("normal", component, true, "finite components")?;
    }
    if normal == [0.0; 3] {
        return Err(Refusal::new("normal", "[0, 0, 0] has no direction; valid: any other"));
    }
    let corners = in_unit(corners);
    let area = plane(&corners)?;
    simple(&corners, area.narrow())?;
    let normal = WideVector::from(in_unit(&[normal])[0]);
    let normal = normal.times(Wide::from(1.0) / normal.norm());
    let seen = !is_edge_on(&corners, area);
    Ok(seen.then_some(Polygon { corners, normal }))
}

/// Whether the receiver is in the polygon's plane, as far as 106 bits tell.
fn is_edge_on(corners: &[Vector], area: WideVector) -> bool {
    let distance: [Wide; 3] = std::array::from_fn(|axis| area.0[axis] * Wide::from(corners[0][axis]));
    let size: f64 = distance.iter().map(|&part| f64::from(part).abs()).sum();
    let [x, y, z] = distance;
    f64::from(x + y + z).abs() <= LOST * size || corners.contains(&[0.0; 3])
}

/// How many times the least length, a corner's distance or the polygon's extent, the largest may be [1]: twice the digits bear
/// no more.
pub const RATIO: f64 = 1e20;

/// What rounding leaves of a sum with twice the digits that is 0 [1].
const LOST: f64 = 1e-30;

/// Twice the polygon's area along the normal of its plane, if it has one.
fn plane(corners: &[Vector]) -> Result<WideVector, Refusal> {
    let first = WideVector::from(corners[0]);
    let from_first: Vec<WideVector> = corners.iter().map(|&corner| WideVector::from(corner).minus(first)).collect();
    let extent = from_first.iter().map(|&side| f64::from(side.norm())).fold(0.0, f64::max);
    let area =
        from_first.windows(2).map(|pair| pair[0].cross(pair[1])).reduce(WideVector::plus).expect("three corners");
    let size = f64::from(area.norm());
    let distances = corners.iter().map(|&corner| corner.into_iter().fold(0.0, |most: f64, x| most.max(x.abs())));
    if distances.filter(|&distance| distance > 0.0).fold(extent, f64::min) < 1.0 / RATIO {
        let why = format!("a length is more than {RATIO:e} times another; valid: up to that");
        return Err(Refusal::new("vertices", why));
    }
    if size <= LOST * extent * extent {
        return Err(Refusal::new(
            "vertices",
            "the corners enclose no area: they are on one line, or edges cross; valid: a polygon with an area",
        ));
    }
    for (at, side) in from_first.iter().enumerate() {
        let off = f64::from(side.dot(area)).abs() / size / extent;
        if off > FLATNESS {
            let why =
                format!("corner {at} is off the plane by {off:.3e} of the polygon's extent; valid: up to {FLATNESS:e}");
            return Err(Refusal::new("vertices", why));
        }
    }
    Ok(area)
}

/// Refuses edges that cross; those that merely touch may pass.
fn simple(corners: &[Vector], area: Vector) -> Result<(), Refusal> {
    let edge = |at: usize| (corners[at], corners[(at + 1) % corners.len()]);
    // On which side of the edge a → b the corner c is, 0 within rounding of its line.
    let side = |(a, b): (Vector, Vector), c: Vector| {
        let (along, aside) = (minus(b, a), minus(c, a));
        let turn = dot(area, cross(along, aside));
        let size = (dot(area, area) * dot(along, along) * dot(aside, aside)).sqrt();
        if turn.abs() <= 1e-14 * size { 0.0 } else { turn.signum() }
    };
    let apart = |one: (Vector, Vector), other: (Vector, Vector)| side(one, other.0) * side(one, other.1) >= 0.0;
    for first in 0..corners.len() {
        for second in first + 1..corners.len() {
            let (one, other) = (edge(first), edge(second));
            if !apart(one, other) && !apart(other, one) {
                let why = format!("the edges from corners {first} and {second} cross; valid: edges that do not");
                return Err(Refusal::new("vertices", why));
            }
        }
    }
    Ok(())
}
