//! Spheres of any size.

use super::planar::packed;
use super::primitive::{triple, vector};
use super::{Meeting, Ray};
use crate::number::Width;
use crate::number::{Number, Vector};
use crate::scene::Triple;

/// A sphere, hollow: it is met from inside too.
///
/// Two subtractions lose digits in the textbook's roots. That of −b ± √… is avoided by the stable product form. That of
/// the discriminant is r² − l², l being the way from the centre to the ray, which is good from afar (E. Haines,
/// J. Günther & T. Akenine-Möller, *Ray Tracing Gems* (2019), ch. 7), and b² − c beside or inside the sphere. And the power
/// c of a point, how far it is outside in squares, is counted from an anchor: the centre, or for a sphere much larger
/// than all else that point of the surface that is next to the world's origin.
#[derive(Clone, Copy, Debug)]
pub struct Sphere<N> {
    pub(super) anchor: Vector<N>,
    /// From the centre to the anchor.
    pub(super) arm: Vector<N>,
    /// The power of the anchor.
    pub(super) power: N,
    pub(super) radius: N,
}

/// A sphere whose surface passes the origin within its radius over this counts from there.
const HUGE: f64 = 8.0;

impl<N: Number> Sphere<N> {
    /// Of radius ≥ 0 [m] about `center` [m].
    pub fn new(center: Triple, radius: f64) -> Self {
        let center = vector(center);
        let distance = center.dot(center).sqrt();
        let is_huge = HUGE * (distance - radius).abs() <= radius;
        let from = if is_huge && distance > 0.0 { center.scaled(1.0 - radius / distance) } else { center };
        // As it is kept: what is left of rounding is in the arm, not lost.
        let anchor = Vector::<N>::of(triple(from));
        let arm = if is_huge { vector(anchor.lane(0)) - center } else { Vector::of([0.0; 3]) };
        let reach = arm.dot(arm).sqrt();
        let power = (reach - radius) * (reach + radius);
        Self { anchor, arm: Vector::of(triple(arm)), power: N::of(power), radius: N::of(radius) }
    }

    /// From the anchor and from the centre to a point, and the point's power: its distance² from the centre less r².
    #[inline(always)]
    pub(super) fn power_of(&self, point: Vector<N>) -> (Vector<N>, Vector<N>, N) {
        let near = point - self.anchor;
        let from_center = near + self.arm;
        (near, from_center, near.dot(from_center + self.arm) + self.power)
    }

    /// Where a ray meets it first; u = v = 0.
    #[inline(always)]
    pub fn meet(&self, ray: &Ray<N>) -> Meeting<N> {
        let zero = N::of(0.0);
        let d = ray.direction;
        let (_, from, c) = self.power_of(ray.origin);
        let (a, b) = (d.dot(d), from.dot(d));
        let foot = b / a;
        let aside = from - d.scaled(foot);
        let (square, near) = (self.radius.squared(), b * foot);
        let is_beside = (c.abs() + near).lt(square);
        let discriminant = N::select(is_beside, near - c, square - aside.dot(aside));
        let root = (discriminant.max(zero) * a).sqrt();
        // Of the two roots q/a and c/q, q is the sum of two numbers of one sign.
        let is_leaving = b.ge(zero);
        let q = N::select(is_leaving, -(b + root), root - b);
        let (one, other) = (c / q, q / a);
        let first = N::select(is_leaving, other, one);
        let last = N::select(is_leaving, one, other);
        let t = N::select(first.gt(zero), first, last);
        Meeting { is_met: discriminant.ge(zero) & t.gt(zero), t, u: zero, v: zero }
    }

    /// t of the first hit within `t_min` < t < `t_max`; infinite if there is none.
    #[inline(always)]
    pub fn closest(&self, ray: &Ray<N>, t_min: N, t_max: N) -> N {
        self.meet(ray).between(t_min, t_max)
    }
}

impl<N: Width> Sphere<N> {
    /// One a lane.
    pub(super) fn packed(of: impl Fn(usize) -> Sphere<N::Scalar>) -> Self {
        Self {
            anchor: packed(|lane| of(lane).anchor),
            arm: packed(|lane| of(lane).arm),
            power: N::each(|lane| of(lane).power),
            radius: N::each(|lane| of(lane).radius),
        }
    }
}
