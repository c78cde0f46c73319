//! Every primitive after the other, for worlds of a few.

use super::planar::{Skew, is_skew};
use super::triangle::Shear;
use super::{Disc, Hit, Primitive, Quad, Ray, Sphere, Triangle};
use crate::number::{Mask, Width};

/// All primitives by kind, each with its place in the list.
#[derive(Clone, Debug)]
pub(super) struct Brute<N> {
    quads: Vec<(Quad<N>, N)>,
    skew: Vec<(Skew<N>, N)>,
    spheres: Vec<(Sphere<N>, N)>,
    discs: Vec<(Disc<N>, N)>,
    triangles: Vec<(Triangle<N>, N)>,
}

/// Searches list after list by a macro that is told a list and how a ray meets an item of it.
macro_rules! in_all_lists {
    ($brute:ident, $ray:ident, $search:ident) => {
        $search!(quads, quad => quad.meet($ray));
        $search!(skew, quad => quad.meet($ray));
        $search!(spheres, sphere => sphere.meet($ray));
        $search!(discs, disc => disc.meet($ray));
        if !$brute.triangles.is_empty() {
            let (shear, turn) = Shear::of($ray);
            $search!(triangles, triangle => triangle.meet_sheared(&shear, #[inline(always)] |corner| turn.apply(corner)));
        }
    };
}

impl<N: Width> Brute<N> {
    /// Of those primitives whose place `is_kept`.
    pub fn new(primitives: &[Primitive], is_kept: impl Fn(usize) -> bool) -> Self {
        let mut all =
            Self { quads: Vec::new(), skew: Vec::new(), spheres: Vec::new(), discs: Vec::new(), triangles: Vec::new() };
        for (at, primitive) in primitives.iter().enumerate().filter(|(at, _)| is_kept(*at)) {
            let at = N::of(at as f64);
            match *primitive {
                Primitive::Quad { corner, edges } if is_skew::<N>(edges) => {
                    all.skew.push((Skew::new(corner, edges), at));
                }
                Primitive::Quad { corner, edges } => all.quads.push((Quad::new(corner, edges), at)),
                Primitive::Sphere { center, radius } => all.spheres.push((Sphere::new(center, radius), at)),
                Primitive::Disc { center, normal, radius } => all.discs.push((Disc::new(center, normal, radius), at)),
                Primitive::Triangle { corners, .. } => all.triangles.push((Triangle::new(corners), at)),
            }
        }
        all
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.quads.len() + self.skew.len() + self.spheres.len() + self.discs.len() + self.triangles.len()
    }

    /// What it occupies in memory [B].
    pub fn bytes(&self) -> usize {
        size_of_val(&*self.quads)
            + size_of_val(&*self.skew)
            + size_of_val(&*self.spheres)
            + size_of_val(&*self.discs)
            + size_of_val(&*self.triangles)
    }

    /// Replaces `best` by what is closer, or as close and lower in the list; not in lanes where it is at 0.
    #[inline(always)]
    pub fn closest(&self, ray: &Ray<N>, best: &mut Hit<N>) {
        let infinite = N::of(f64::INFINITY);
        macro_rules! search {
            ($list:ident, $item:ident => $meet:expr) => {
                if !self.$list.is_empty() {
                    let mut own = Hit::nothing(infinite.only(best.t.gt(N::of(0.0))));
                    for ($item, at) in &self.$list {
                        let meeting = $meet;
                        own.take(meeting.is_met & meeting.t.lt(own.t), meeting.t, meeting.u, meeting.v, *at);
                    }
                    // In a list the first of equals stays, being lower; between lists it has to be asked.
                    let is_closer = own.t.lt(best.t) | (own.t.le(best.t) & own.primitive.lt(best.primitive));
                    best.take(is_closer, own.t, own.u, own.v, own.primitive);
                }
            };
        }
        in_all_lists!(self, ray, search);
    }

    /// Whether anything is met before `t_max`.
    #[inline(always)]
    pub fn is_blocked(&self, ray: &Ray<N>, t_max: N) -> N::Mask {
        let mut blocked = N::Mask::of(false);
        macro_rules! search {
            ($list:ident, $item:ident => $meet:expr) => {
                for ($item, _) in &self.$list {
                    let meeting = $meet;
                    blocked = blocked | (meeting.is_met & meeting.t.lt(t_max));
                }
            };
        }
        in_all_lists!(self, ray, search);
        blocked
    }
}
