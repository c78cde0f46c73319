//! What there is to see.

use super::Triple;
use std::path::PathBuf;
use std::sync::Arc;

/// A shape, what it is made of, and what it sends out.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// Its form, before [`Shape::transform`].
    pub geometry: Geometry,
    /// The name of its material.
    pub material: String,
    /// What it sends out.
    pub emission: Option<Emission>,
    /// Where it is put.
    pub transform: Transform,
}

/// What a surface sends out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Emission {
    /// [W m⁻² sr⁻¹].
    pub radiance: Triple,
    /// From both sides, not from that of the normal alone.
    pub two_sided: bool,
}

/// A form.
#[derive(Clone, Debug, PartialEq)]
pub enum Geometry {
    /// A parallelogram; its normal is (v₁ − v₀) × (v₃ − v₀).
    Quad {
        /// Its corners [m] in order.
        vertices: [Triple; 4],
    },
    /// A ball, its normal outward.
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
    /// Six rectangles along the axes, their normals outward.
    Box {
        /// The least corner [m].
        min: Triple,
        /// The largest [m].
        max: Triple,
    },
    /// Triangles.
    Mesh {
        /// Where they were read from; None if they were made.
        file: Option<PathBuf>,
        /// Whether their normals are smoothed.
        normals: Normals,
        /// They.
        mesh: Arc<Mesh>,
    },
}

/// How the surface of a mesh looks between its corners.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Normals {
    /// As flat as it is.
    #[default]
    Flat,
    /// By normals between those of the corners.
    Smooth,
}

/// Triangles that share corners.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Corners [m].
    pub positions: Vec<[f32; 3]>,
    /// A direction a corner, or none at all.
    pub normals: Vec<[f32; 3]>,
    /// Three corners each; the normal's side sees them counterclockwise.
    pub triangles: Vec<[u32; 3]>,
}

/// Scaled first, then turned about x, y and z in that order, then moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform {
    /// By axis [1]; not 0.
    pub scale: Triple,
    /// [deg].
    pub rotate_deg: Triple,
    /// [m].
    pub translate: Triple,
}

impl Default for Transform {
    /// Leaves everything where it is.
    fn default() -> Self {
        Self { scale: [1.0; 3], rotate_deg: [0.0; 3], translate: [0.0; 3] }
    }
}
