//! What lies in a plane and is described by two directions in it.

use super::primitive::{triple, vector};
use super::{Meeting, Ray};

use crate::number::{Frame, Number, Vector, Width};
use crate::scene::Triple;

/// A plane with two coordinates.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plane<N> {
    center: Vector<N>,
    normal: Vector<N>,
    /// What gives the coordinates u and v of a vector from the centre: across the other axis, not along its own.
    duals: [Vector<N>; 2],
}

impl<N: Number> Plane<N> {
    /// About `center`, with u = ±1 at ± the first of `halves` and v at the second. `slack` [m] moves the lines |u| = 1 and
    /// |v| = 1 outwards. Without area it is met nowhere.
    fn new(center: Vector<f64>, halves: [Vector<f64>; 2], slack: f64) -> Self {
        let [(along, length), (aside, width)] = halves.map(unit);
        let (normal, sine) = unit(along.cross(aside));
        let duals = if sine > 0.0 && length > 0.0 && width > 0.0 {
            [aside.cross(normal).scaled(1.0 / (sine * length)), normal.cross(along).scaled(1.0 / (sine * width))]
        } else {
            [Vector::of([f64::NAN; 3]); 2]
        };
        let eased = duals.map(|dual| {
            let share = (slack * dual.dot(dual).sqrt()).min(MOST_EASE);
            dual.scaled(1.0 / (1.0 + share))
        });
        Self {
            center: Vector::of(triple(center)),
            normal: Vector::of(triple(normal)),
            duals: eased.map(|v| Vector::of(triple(v))),
        }
    }

    /// t, u and v of a ray. In the plane or along it they are infinite or not numbers, or far away.
    #[inline(always)]
    fn place(&self, ray: &Ray<N>) -> (N, N, N) {
        let to = self.center - ray.origin;
        let t = self.normal.dot(to) / self.normal.dot(ray.direction);
        let from_center = ray.direction.scaled(t) - to;
        let [u, v] = self.duals;
        (t, u.dot(from_center), v.dot(from_center))
    }
}

impl<N: Width> Plane<N> {
    fn packed(of: impl Fn(usize) -> Plane<N::Scalar>) -> Self {
        Self {
            center: packed(|lane| of(lane).center),
            normal: packed(|lane| of(lane).normal),
            duals: std::array::from_fn(|axis| packed(|lane| of(lane).duals[axis])),
        }
    }
}

/// A vector a lane.
pub(super) fn packed<N: Width>(of: impl Fn(usize) -> Vector<N::Scalar>) -> Vector<N> {
    let [x, y, z] = N::columns(|lane| {
        let Vector { x, y, z } = of(lane);
        [x, y, z]
    });
    Vector::new(x, y, z)
}

/// The most that a parallelogram grows [1] so that its neighbours overlap: no measurable light.
const MOST_EASE: f64 = 1e-4;

/// A parallelogram: |u| ≤ 1 and |v| ≤ 1 of its plane.
///
/// It is met a few roundings beyond its edges too, so that walls that share one leave no slit between them.
#[derive(Clone, Copy, Debug)]
pub struct Quad<N>(Plane<N>);

impl<N: Number> Quad<N> {
    /// From one corner [m] and the way to its two neighbours [m]; met nowhere if it has no area.
    pub fn new(corner: Triple, edges: [Triple; 2]) -> Self {
        let halves = edges.map(|edge| vector(edge).scaled(0.5));
        let center = vector(corner) + halves[0] + halves[1];
        let reach = largest(center) + largest(halves[0]) + largest(halves[1]);
        Self(Plane::new(center, halves, 4.0 * N::EPSILON * reach))
    }

    /// Where a ray meets it; u runs from −1 to 1 along the first edge and v along the second.
    #[inline(always)]
    pub fn meet(&self, ray: &Ray<N>) -> Meeting<N> {
        let (t, u, v) = self.0.place(ray);
        let one = N::of(1.0);
        Meeting { is_met: u.abs().le(one) & v.abs().le(one) & t.gt(N::of(0.0)), t, u, v }
    }

    /// t of the hit within `t_min` < t < `t_max`; infinite if there is none.
    #[inline(always)]
    pub fn closest(&self, ray: &Ray<N>, t_min: N, t_max: N) -> N {
        self.meet(ray).between(t_min, t_max)
    }
}

impl<N: Width> Quad<N> {
    /// One a lane.
    pub(super) fn packed(of: impl Fn(usize) -> Quad<N::Scalar>) -> Self {
        Self(Plane::packed(|lane| of(lane).0))
    }
}

/// A parallelogram so skew that rounding smears its corners: met only within its box.
#[derive(Clone, Copy, Debug)]
pub(super) struct Skew<N> {
    quad: Quad<N>,
    center: Vector<N>,
    half: Vector<N>,
}

/// Whether a parallelogram is smeared at its corners by more than two roundings of `f32`.
pub(super) fn is_skew<N: Number>([u, v]: [Triple; 2]) -> bool {
    let (_, sine) = unit(unit(vector(u)).0.cross(unit(vector(v)).0));
    N::EPSILON > 2.0 * sine * f64::from(f32::EPSILON)
}

/// Roundings by which the box of a skew parallelogram is larger than itself.
const SKEW_SLACK: f64 = 16.0;

impl<N: Number> Skew<N> {
    pub fn new(corner: Triple, edges: [Triple; 2]) -> Self {
        let [u, v] = edges.map(vector);
        let center = vector(corner) + (u + v).scaled(0.5);
        let slack = SKEW_SLACK * N::EPSILON * (largest(center) + largest(u) + largest(v));
        let half = |u: f64, v: f64| 0.5 * (u.abs() + v.abs()) + slack;
        let half = Vector::new(half(u.x, v.x), half(u.y, v.y), half(u.z, v.z));
        Self { quad: Quad::new(corner, edges), center: Vector::of(triple(center)), half: Vector::of(triple(half)) }
    }

    #[inline(always)]
    pub fn meet(&self, ray: &Ray<N>) -> Meeting<N> {
        let meeting = self.quad.meet(ray);
        let from_center = ray.at(meeting.t) - self.center;
        let slack = largest(ray.origin) * N::of(SKEW_SLACK * N::EPSILON);
        let within = |part: N, half: N| part.abs().le(half + slack);
        let is_met = within(from_center.x, self.half.x)
            & within(from_center.y, self.half.y)
            & within(from_center.z, self.half.z);
        Meeting { is_met: meeting.is_met & is_met, ..meeting }
    }
}

impl<N: Width> Skew<N> {
    /// One a lane.
    pub(super) fn packed(of: impl Fn(usize) -> Skew<N::Scalar>) -> Self {
        Self {
            quad: Quad::packed(|lane| of(lane).quad),
            center: packed(|lane| of(lane).center),
            half: packed(|lane| of(lane).half),
        }
    }
}

/// The largest |component|.
#[inline(always)]
pub(super) fn largest<N: Number>(v: Vector<N>) -> N {
    v.x.abs().max(v.y.abs()).max(v.z.abs())
}

/// A disc: u² + v² ≤ 1 of its plane.
#[derive(Clone, Copy, Debug)]
pub struct Disc<N>(Plane<N>);

impl<N: Number> Disc<N> {
    /// From its centre [m], its normal of any length but 0, and its radius [m]; met nowhere if that is 0.
    pub fn new(center: Triple, normal: Triple, radius: f64) -> Self {
        let halves = disc_axes(normal, radius);
        Self(Plane::new(vector(center), halves, 0.0))
    }

    /// Where a ray meets it; u and v are Cartesian, in radii.
    #[inline(always)]
    pub fn meet(&self, ray: &Ray<N>) -> Meeting<N> {
        let (t, u, v) = self.0.place(ray);
        Meeting { is_met: (u.squared() + v.squared()).le(N::of(1.0)) & t.gt(N::of(0.0)), t, u, v }
    }

    /// t of the hit within `t_min` < t < `t_max`; infinite if there is none.
    #[inline(always)]
    pub fn closest(&self, ray: &Ray<N>, t_min: N, t_max: N) -> N {
        self.meet(ray).between(t_min, t_max)
    }
}

impl<N: Width> Disc<N> {
    /// One a lane.
    pub(super) fn packed(of: impl Fn(usize) -> Disc<N::Scalar>) -> Self {
        Self(Plane::packed(|lane| of(lane).0))
    }
}

/// The radii [m] of a disc along its u and v.
pub(super) fn disc_axes(normal: Triple, radius: f64) -> [Vector<f64>; 2] {
    let Frame { x, y, .. } = Frame::about(unit(vector(normal)).0);
    [x, y].map(|axis| axis.scaled(radius))
}

/// Its direction and its length, whatever its size; a null vector's direction is not a number.
pub(super) fn unit(v: Vector<f64>) -> (Vector<f64>, f64) {
    let scale = largest(v);
    let small = Vector::new(v.x / scale, v.y / scale, v.z / scale);
    let length = small.dot(small).sqrt();
    (small.scaled(1.0 / length), scale * length)
}
