//! What cannot come between two points.

use super::planar::unit;
use super::primitive::vector;
use super::{Bounds, Primitive};
use crate::scene::Triple;

/// As many of the largest are looked at: walls are large, and each look is at the whole world.
const MOST_LOOKED_AT: usize = 64;

/// The places of at most `most` primitives that have the whole world, and the points `also`, on one side of their plane
/// or in it. A segment between two such points does not cross the plane.
pub(super) fn walls(primitives: &[Primitive], also: &[Triple], most: usize) -> Vec<usize> {
    let mut candidates: Vec<(f64, usize)> = primitives
        .iter()
        .enumerate()
        .filter(|(_, primitive)| !matches!(primitive, Primitive::Sphere { .. }))
        .map(|(at, primitive)| (primitive.area(), at))
        .collect();
    let larger = |one: &(f64, usize), other: &(f64, usize)| other.0.total_cmp(&one.0).then(one.1.cmp(&other.1));
    if candidates.len() > MOST_LOOKED_AT {
        candidates.select_nth_unstable_by(MOST_LOOKED_AT, larger);
        candidates.truncate(MOST_LOOKED_AT);
    }
    candidates.sort_unstable_by(larger);
    let bounds = primitives.iter().fold(Bounds::of(also.iter().copied()), |all, one| all.union(&one.bounds()));
    let slack = SLACK * f64::EPSILON * bounds.reach();
    let is_wall = |&(area, at): &(f64, usize)| area > 0.0 && is_one_sided(primitives, also, &primitives[at], slack);
    let mut found: Vec<usize> = candidates.iter().filter(|one| is_wall(one)).take(most).map(|(_, at)| *at).collect();
    found.sort_unstable();
    found
}

/// Roundings of `f64` by which a corner that lies in a plane may seem to be off it.
const SLACK: f64 = 16.0;

fn is_one_sided(primitives: &[Primitive], also: &[Triple], wall: &Primitive, slack: f64) -> bool {
    let (place, normal) = match *wall {
        Primitive::Quad { corner, edges: [u, v] } => (corner, unit(vector(u)).0.cross(unit(vector(v)).0)),
        Primitive::Triangle { corners: [a, b, c], .. } => {
            (a, unit(vector(b) - vector(a)).0.cross(unit(vector(c) - vector(a)).0))
        }
        Primitive::Disc { center, normal, .. } => (center, vector(normal)),
        Primitive::Sphere { .. } => return false,
    };
    let normal = unit(normal).0;
    let height = |point: Triple| normal.dot(vector(point) - vector(place));
    // How far what there is reaches to either side.
    let range = |primitive: &Primitive| -> (f64, f64) {
        let about = |center: Triple, reach: f64| (height(center) - reach, height(center) + reach);
        match *primitive {
            Primitive::Sphere { center, radius } => about(center, radius),
            Primitive::Disc { center, normal: own, radius } => {
                let sine = unit(vector(own)).0.cross(normal);
                about(center, radius * sine.dot(sine).sqrt())
            }
            Primitive::Quad { corner, edges } => {
                let [u, v] = edges.map(|edge| normal.dot(vector(edge)));
                let from = height(corner);
                (from + u.min(0.0) + v.min(0.0), from + u.max(0.0) + v.max(0.0))
            }
            Primitive::Triangle { corners, .. } => {
                let [a, b, c] = corners.map(height);
                (a.min(b).min(c), a.max(b).max(c))
            }
        }
    };
    let points = also.iter().map(|&point| (height(point), height(point)));
    let (mut is_below, mut is_above) = (false, false);
    // A few from everywhere first: neighbours in the list are so in space, and most planes are soon found to cut through.
    let few = primitives.iter().step_by(primitives.len() / 64 + 1);
    for (low, high) in points.chain(few.chain(primitives).map(range)) {
        // What is not a number is on both sides.
        is_below |= low.is_nan() || low < -slack;
        is_above |= high.is_nan() || high > slack;
        if is_below && is_above {
            return false;
        }
    }
    true
}
