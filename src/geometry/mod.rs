//! What a ray meets.
//!
//! A [`World`] is made once, from [`Primitive`]s in `f64`, and asked of any width: what is the closest hit of a ray, is
//! anything between two points, what does the surface look like there. Everything is written over
//! [`Number`], so that lanes answer as so many single rays do, bit for bit.
//!
//! Lengths are the caller's, who chooses where the origin lies and what is 1: digits are best for coordinates of order 1.
//! A ray's parameter t counts in lengths of its direction, which need not be 1.
//!
//! | idea | where |
//! |---|---|
//! | parallelograms and discs | [`Quad`], [`Disc`] |
//! | spheres from the size of an atom to that of the Earth | [`Sphere`] |
//! | triangles that leave no slit | [`Triangle`] |
//! | all of them at once | [`World`] |
//! | a scene's shapes as primitives | [`flatten`] |
//! | where on an image a place of a shape lies | [`charts()`] |
//! | normals, points on the surface, and how to leave it | [`Surface`] |

mod bounds;
mod brute;
mod bvh;
mod charts;
mod flatten;
mod planar;
mod primitive;
mod sphere;
mod surface;
#[cfg(test)]
mod tests;
mod triangle;
mod walls;
mod world;

pub use bounds::Bounds;
pub use charts::{Chart, charts};
pub use flatten::{Flat, Owners, flatten};
pub use planar::{Disc, Quad};
pub use primitive::Primitive;
pub use sphere::Sphere;
pub use surface::Surface;
pub use triangle::Triangle;
pub use world::{Ends, Hit, Settings, Structure, World};

use crate::number::{Number, Vector, Width};

/// From a point in a direction.
#[derive(Clone, Copy, Debug)]
pub struct Ray<N> {
    /// Where it starts [m].
    pub origin: Vector<N>,
    /// Where it goes; of any length but 0, in which t counts.
    pub direction: Vector<N>,
}

impl<N: Number> Ray<N> {
    /// `yes` where the mask is true, `no` elsewhere.
    #[inline(always)]
    pub fn select(mask: N::Mask, yes: Self, no: Self) -> Self {
        Self {
            origin: Vector::select(mask, yes.origin, no.origin),
            direction: Vector::select(mask, yes.direction, no.direction),
        }
    }

    /// o + t d.
    #[inline(always)]
    pub fn at(&self, t: N) -> Vector<N> {
        self.origin + self.direction.scaled(t)
    }
}

impl<N: Width> Ray<N> {
    /// That of one lane.
    #[inline(always)]
    pub(super) fn single(&self, lane: usize) -> Ray<N::Scalar> {
        let one = |v: Vector<N>| Vector::new(v.x.get(lane), v.y.get(lane), v.z.get(lane));
        Ray { origin: one(self.origin), direction: one(self.direction) }
    }
}

/// Where a ray meets a primitive.
#[derive(Clone, Copy, Debug)]
pub struct Meeting<N: Number> {
    /// Whether it does, at t > 0. Where not, the rest says nothing.
    pub is_met: N::Mask,
    /// How far along the ray, in lengths of its direction [1].
    pub t: N,
    /// Where on the primitive; see there [1].
    pub u: N,
    /// Where on the primitive [1].
    pub v: N,
}

impl<N: Number> Meeting<N> {
    /// t where it lies within `t_min` < t < `t_max`; infinite elsewhere.
    #[inline(always)]
    pub fn between(self, t_min: N, t_max: N) -> N {
        let is_met = self.is_met & self.t.gt(t_min) & self.t.lt(t_max);
        N::select(is_met, self.t, N::of(f64::INFINITY))
    }
}
