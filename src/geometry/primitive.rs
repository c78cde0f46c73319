//! What a world is made of.

use super::Bounds;
use super::planar::unit;
use crate::number::Vector;
use crate::scene::Triple;
use std::f64::consts::PI;

/// A surface that cannot be divided further. Which it is in its world is its place in the list that made it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Primitive {
    /// A parallelogram; its normal is the first edge × the second.
    Quad {
        /// One corner [m].
        corner: Triple,
        /// From there to its two neighbours [m].
        edges: [Triple; 2],
    },
    /// A sphere, its normal outward.
    Sphere {
        /// [m].
        center: Triple,
        /// [m].
        radius: f64,
    },
    /// A flat disc.
    Disc {
        /// [m].
        center: Triple,
        /// Of any length but 0.
        normal: Triple,
        /// [m].
        radius: f64,
    },
    /// A triangle; its normal's side sees the corners counterclockwise.
    Triangle {
        /// [m].
        corners: [Triple; 3],
        /// Directions at the corners between which a smooth surface's normal turns; None is flat. Of any length but 0.
        normals: Option<[[f32; 3]; 3]>,
    },
}

impl Primitive {
    /// What it has of area [m²]; of a sphere, outside.
    pub fn area(&self) -> f64 {
        let length = |v: Vector<f64>| v.dot(v).sqrt();
        match *self {
            Self::Quad { edges: [u, v], .. } => length(vector(u).cross(vector(v))),
            Self::Sphere { radius, .. } => 4.0 * PI * radius * radius,
            Self::Disc { radius, .. } => PI * radius * radius,
            Self::Triangle { corners: [a, b, c], .. } => {
                0.5 * length((vector(b) - vector(a)).cross(vector(c) - vector(a)))
            }
        }
    }

    /// The box about it.
    pub fn bounds(&self) -> Bounds {
        let around = |center: Triple, reach: Triple| Bounds {
            low: std::array::from_fn(|axis| center[axis] - reach[axis]),
            high: std::array::from_fn(|axis| center[axis] + reach[axis]),
        };
        match *self {
            Self::Quad { .. } => Bounds::of(self.corners().into_iter().flatten()),
            Self::Sphere { center, radius } => around(center, [radius; 3]),
            Self::Disc { center, normal, radius } => {
                // A circle reaches r sin(its normal, axis) along an axis.
                let [x, y, z] = triple(unit(vector(normal)).0).map(|part| part * part);
                around(center, [y + z, x + z, x + y].map(|across| radius * across.sqrt()))
            }
            Self::Triangle { corners, .. } => Bounds::of(corners),
        }
    }

    /// The corners of what has some.
    pub(super) fn corners(&self) -> Option<[Triple; 4]> {
        let plus = |one: Triple, other: Triple| std::array::from_fn(|axis| one[axis] + other[axis]);
        match *self {
            Self::Quad { corner, edges: [u, v] } => {
                Some([corner, plus(corner, u), plus(plus(corner, u), v), plus(corner, v)])
            }
            Self::Triangle { corners: [a, b, c], .. } => Some([a, b, c, c]),
            Self::Sphere { .. } | Self::Disc { .. } => None,
        }
    }
}

/// As something to compute with.
pub(super) fn vector([x, y, z]: Triple) -> Vector<f64> {
    Vector::new(x, y, z)
}

/// And back.
pub(super) fn triple(v: Vector<f64>) -> Triple {
    [v.x, v.y, v.z]
}
