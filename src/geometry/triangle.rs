//! Triangles that leave no slit between them.
//!
//! S. Woop, C. Benthin & I. Wald, "Watertight ray/triangle intersection", *JCGT* 2(1) (2013) 65: the corners are sheared
//! so that the ray runs along an axis, and three edge functions say on which side of each edge it passes. Corners that
//! triangles share are rounded alike, and fl(ab) − fl(cd) never has the sign opposite to ab − cd; it may only be 0 in its
//! stead. As 0 counts as inside, every ray through a closed mesh of these rounded corners meets some triangle. (The
//! original looks again in double precision where it finds a 0, to decide which.)
//!
//! t is a mean of the corners' with positive weights, whatever rounding does to a triangle seen from its edge. It is kept
//! within the triangle's own box besides: that makes a hierarchy of boxes lose nothing, by the monotony of rounding alone.

use super::{Meeting, Ray};
use crate::number::Width;
use crate::number::{Mask, Number};
use crate::scene::Triple;

/// A triangle.
#[derive(Clone, Copy, Debug)]
pub struct Triangle<N> {
    pub(super) corners: [[N; 3]; 3],
}

/// What the triangles of one ray share, in axes so turned that the ray runs mostly along the last.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shear<N> {
    origin: [N; 3],
    /// The direction's other components over the last.
    slant: [N; 2],
    /// 1 over each component.
    pace: [N; 3],
}

impl<N: Number> Shear<N> {
    #[inline(always)]
    fn new(origin: [N; 3], [x, y, z]: [N; 3]) -> Self {
        Self { origin, slant: [x / z, y / z], pace: [N::of(1.0) / x, N::of(1.0) / y, N::of(1.0) / z] }
    }

    /// From the ray's origin to a corner.
    #[inline(always)]
    fn relative(&self, [x, y, z]: [N; 3]) -> [N; 3] {
        [x - self.origin[0], y - self.origin[1], z - self.origin[2]]
    }

    /// How far beside the ray.
    #[inline(always)]
    fn apply(&self, [x, y, z]: [N; 3]) -> (N, N) {
        (x - self.slant[0] * z, y - self.slant[1] * z)
    }

    /// Between which t the ray is inside the box of corners relative to its origin, made larger by what the shear rounds
    /// off.
    #[inline(always)]
    fn crossing(&self, corners: [[N; 3]; 3]) -> (N, N) {
        let far = reach(range(corners, 2));
        let x = self.slab(0, range(corners, 0), far);
        let y = self.slab(1, range(corners, 1), far);
        let z = self.slab(2, range(corners, 2), far);
        (x.0.max(y.0).max(z.0), x.1.min(y.1).min(z.1))
    }

    #[inline(always)]
    fn slab(&self, axis: usize, (low, high): (N, N), far: N) -> (N, N) {
        let slack = (reach((low, high)) + far) * N::of(SLACK * N::EPSILON);
        let (one, other) = ((low - slack) * self.pace[axis], (high + slack) * self.pace[axis]);
        (one.min(other), one.max(other))
    }

    /// Of many rays.
    #[inline(always)]
    pub fn of(ray: &Ray<N>) -> (Self, Turn<N>) {
        let (o, d) = (ray.origin, ray.direction);
        let (x, y, z) = (d.x.abs(), d.y.abs(), d.z.abs());
        let is_x = x.gt(y) & x.gt(z);
        let turn = Turn { is_x, is_y: y.gt(z) & !is_x };
        (Self::new(turn.apply(&[o.x, o.y, o.z]), turn.apply(&[d.x, d.y, d.z])), turn)
    }
}

impl<N: Width> Shear<N> {
    /// Of one ray, for as many triangles as there are lanes; and the axes' order.
    #[inline(always)]
    pub fn of_one(ray: &Ray<N::Scalar>) -> (Self, [usize; 3]) {
        let (o, d) = (ray.origin, ray.direction);
        let (o, d) = ([o.x, o.y, o.z], [d.x, d.y, d.z]);
        let (x, y, z) = (d[0].abs(), d[1].abs(), d[2].abs());
        let order = if x > y && x > z {
            [1, 2, 0]
        } else if y > z {
            [2, 0, 1]
        } else {
            [0, 1, 2]
        };
        let Shear { origin, slant, pace } = Shear::<N::Scalar>::new(ordered(&o, order), ordered(&d, order));
        let [origin, pace] = [all(origin), all(pace)];
        (Self { origin, slant: [N::all(slant[0]), N::all(slant[1])], pace }, order)
    }
}

/// The least and the largest of three corners along an axis.
#[inline(always)]
fn range<N: Number>([a, b, c]: [[N; 3]; 3], axis: usize) -> (N, N) {
    (a[axis].min(b[axis]).min(c[axis]), a[axis].max(b[axis]).max(c[axis]))
}

/// How far a range is from 0 at most.
#[inline(always)]
fn reach<N: Number>((low, high): (N, N)) -> N {
    high.max(-low)
}

#[inline(always)]
fn all<N: Width>([x, y, z]: [N::Scalar; 3]) -> [N; 3] {
    [N::all(x), N::all(y), N::all(z)]
}

/// The same in another order of axes.
#[inline(always)]
pub(super) fn ordered<T: Copy>(v: &[T; 3], [x, y, z]: [usize; 3]) -> [T; 3] {
    [v[x], v[y], v[z]]
}

/// How the axes are turned in each lane.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turn<N: Number> {
    is_x: N::Mask,
    is_y: N::Mask,
}

impl<N: Number> Turn<N> {
    #[inline(always)]
    pub fn apply(&self, &[x, y, z]: &[N; 3]) -> [N; 3] {
        [self.choice(y, z, x), self.choice(z, x, y), self.choice(x, y, z)]
    }

    #[inline(always)]
    fn choice(&self, for_x: N, for_y: N, for_z: N) -> N {
        N::select(self.is_x, for_x, N::select(self.is_y, for_y, for_z))
    }
}

impl<N: Number> Triangle<N> {
    /// From its corners [m].
    pub fn new(corners: [Triple; 3]) -> Self {
        Self { corners: corners.map(|corner| corner.map(N::of)) }
    }

    /// Where a ray meets it; u and v are the shares of the second and the third corner in the point.
    #[inline(always)]
    pub fn meet(&self, ray: &Ray<N>) -> Meeting<N> {
        let (shear, turn) = Shear::of(ray);
        self.meet_sheared(
            &shear,
            #[inline(always)]
            |corner| turn.apply(corner),
        )
    }

    /// The same, with what does not depend on the triangle given.
    #[inline(always)]
    pub(super) fn meet_sheared(&self, shear: &Shear<N>, turn: impl Fn(&[N; 3]) -> [N; 3]) -> Meeting<N> {
        let a = shear.relative(turn(&self.corners[0]));
        let b = shear.relative(turn(&self.corners[1]));
        let c = shear.relative(turn(&self.corners[2]));
        let ((ax, ay), (bx, by), (cx, cy)) = (shear.apply(a), shear.apply(b), shear.apply(c));
        let (of_a, of_b, of_c) = (cx * by - cy * bx, ax * cy - ay * cx, bx * ay - by * ax);
        let zero = N::of(0.0);
        let is_right = of_a.lt(zero) | of_b.lt(zero) | of_c.lt(zero);
        let is_left = of_a.gt(zero) | of_b.gt(zero) | of_c.gt(zero);
        // Not where all three are 0.
        let is_met = (is_right | is_left) & !(is_right & is_left);
        let nowhere = Meeting { is_met: N::Mask::of(false), t: zero, u: zero, v: zero };
        if !is_met.any() {
            return nowhere;
        }
        let share = N::of(1.0) / (of_a + of_b + of_c);
        let t = (of_a * a[2] + of_b * b[2] + of_c * c[2]) * share * shear.pace[2];
        let (enter, leave) = shear.crossing([a, b, c]);
        let t = enter.max(leave.min(t));
        Meeting { is_met: is_met & t.gt(zero) & enter.le(leave), t, u: of_b * share, v: of_c * share }
    }

    /// t of the hit within `t_min` < t < `t_max`; infinite if there is none.
    #[inline(always)]
    pub fn closest(&self, ray: &Ray<N>, t_min: N, t_max: N) -> N {
        self.meet(ray).between(t_min, t_max)
    }
}

/// Roundings by which the shear may move a corner, in coordinates as seen from the ray's origin: half of one in each of a
/// difference, a quotient, a product and a difference again, and as much by each of the two edge functions' products.
const SLACK: f64 = 8.0;

impl<N: Width> Triangle<N> {
    /// One a lane.
    pub(super) fn packed(of: impl Fn(usize) -> Triangle<N::Scalar>) -> Self {
        Self {
            corners: std::array::from_fn(|corner| {
                std::array::from_fn(|axis| N::each(|lane| of(lane).corners[corner][axis]))
            }),
        }
    }
}
