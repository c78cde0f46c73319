//! Where on an image a place of a shape lies: (s, t) [1] from the image's lower left corner, s to the right, t up.
//!
//! | shape | the image, seen from the normal's side, so that it is not mirrored |
//! |---|---|
//! | quad | its lower edge from the first corner to the second, its left one from the first to the fourth |
//! | disc | the square about it, upright: t rises as y does; from above or below, as −z or z does |
//! | box | once on each face, upright; on top t rises as −z does, below as z does |
//! | sphere | by longitude and latitude: its middle to +z, its right to +x, its upper edge at +y |
//! | mesh | as its corners say |

use super::planar::disc_axes;
use crate::number::{Vector, atan2};
use crate::scene::triple::{cross, dot, length, normalised};
use crate::scene::{Geometry, Shape, Triple};
use std::f64::consts::{PI, TAU};

/// The places of a primitive, by what is known where it is met.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Chart {
    /// By [`super::Hit::u`] and [`super::Hit::v`].
    Flat {
        /// Where both are 0.
        at: [f64; 2],
        /// What each of them adds.
        along: [[f64; 2]; 2],
    },
    /// By the outward normal: the sphere's own x, y and z.
    Round([Triple; 3]),
}

impl Chart {
    /// The place (s, t) [1] of u and v, and of a normal of length 1.
    pub fn place(&self, [u, v]: [f64; 2], normal: Triple) -> [f64; 2] {
        match self {
            Self::Flat { at, along: [first, second] } => [0, 1].map(|k| at[k] + u * first[k] + v * second[k]),
            Self::Round(axes) => {
                let [x, y, z] = axes.map(|axis| dot(axis, normal));
                let acute = |a: f64, b: f64| if a == 0.0 && b == 0.0 { 0.0 } else { atan2(a.abs(), b.abs()) };
                let from_z = if z < 0.0 { PI - acute(x, z) } else { acute(x, z) };
                let height = acute(y, (x * x + z * z).sqrt());
                [0.5 + from_z.copysign(x) / TAU, 0.5 + height.copysign(y) / PI]
            }
        }
    }

    /// Of a square about the origin of u and v, which go along `edges`, the image lying along `right` and `up`; all of length 1.
    fn square(edges: [Triple; 2], [right, up]: [Triple; 2]) -> Self {
        Self::Flat { at: [0.5; 2], along: edges.map(|edge| [0.5 * dot(edge, right), 0.5 * dot(edge, up)]) }
    }
}

/// The axes of an upright image on what looks along a normal of length 1.
fn upright(normal: Triple) -> [Triple; 2] {
    // What is this near to the vertical has no digits left to be turned by.
    const LEAST: f64 = 1e-6;
    let right = cross([0.0, 1.0, 0.0], normal);
    let right = if length(right) < LEAST { [1.0, 0.0, 0.0] } else { normalised(right) };
    [right, cross(normal, right)]
}

/// The charts of a shape's primitives, in the order of [`super::flatten`]; None of a mesh that says nothing of it.
pub fn charts(shape: &Shape) -> Option<Vec<Chart>> {
    let map = shape.transform.map();
    let mirrored = |pair: [[f64; 2]; 2]| if map.is_mirror() { [pair[1], pair[0]] } else { pair };
    Some(match &shape.geometry {
        Geometry::Quad { .. } => {
            vec![Chart::Flat { at: [0.5; 2], along: mirrored([[0.5, 0.0], [0.0, 0.5]]) }]
        }
        Geometry::Sphere { .. } => {
            let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
            vec![Chart::Round(axes.map(|axis| normalised(map.way(axis))))]
        }
        Geometry::Disc { normal, .. } => {
            // Upright where it was made, and then moved with it.
            let image = upright(normalised(*normal)).map(|axis| normalised(map.way(axis)));
            let axes = disc_axes(map.normal(*normal), 1.0).map(|axis: Vector<f64>| axis.lane(0));
            vec![Chart::square(axes, image)]
        }
        Geometry::Box { .. } => (0..6)
            .map(|face| {
                let (axis, is_high) = (face / 2, face % 2 == 1);
                let unit = |axis: usize, size: f64| -> Triple {
                    std::array::from_fn(|other| if other == axis % 3 { size } else { 0.0 })
                };
                let edges = if is_high != map.is_mirror() { [1, 2] } else { [2, 1] };
                let edges = edges.map(|by| unit(axis + by, 1.0));
                Chart::square(edges, upright(unit(axis, if is_high { 1.0 } else { -1.0 })))
            })
            .collect(),
        Geometry::Mesh { mesh, .. } if mesh.texture.is_empty() => return None,
        Geometry::Mesh { mesh, .. } => {
            let place = |corner: u32| mesh.texture[corner as usize].map(f64::from);
            let chart = |&[a, b, c]: &[u32; 3]| {
                let at = place(a);
                let along = [b, c].map(|corner| [0, 1].map(|k| place(corner)[k] - at[k]));
                Chart::Flat { at, along: mirrored(along) }
            };
            mesh.triangles.iter().map(chart).collect()
        }
    })
}
