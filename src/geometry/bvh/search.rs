//! The way of a ray through the hierarchy: into the nearest box first, and never into one beyond what is met.

use super::boxes::Slabs;
use super::build::MOST_WAITING;
use super::{Bvh, Kind, Link};
use crate::geometry::triangle::{Shear, ordered};
use crate::geometry::{Hit, Meeting, Ray};
use crate::number::{MOST_LANES, Mask, Number, Vector, Width};
use fearless_simd::Simd;

/// Where the ray enters what it has yet to look into, as bits, which sort as the numbers do; and what that is.
type Waiting = [u64; MOST_WAITING];

impl<P: Width> Bvh<P> {
    /// Of every active lane the closest hit, or `best` if nothing is closer, or as close and lower in the list.
    #[inline(always)]
    pub fn closest_of<N, M>(&self, machine: M, ray: &Ray<N>, best: Hit<N>, active: N::Mask) -> Hit<N>
    where
        N: Width<Scalar = P::Scalar, Pack = P>,
        M: Simd,
    {
        let mut waiting = [0; MOST_WAITING];
        let mut all = [[P::Scalar::of(0.0); 8]; MOST_LANES];
        for (lane, found) in all.iter_mut().enumerate().take(N::LANES) {
            let mut hit = best.single(lane);
            if active.lane(lane) {
                self.search::<M, false>(machine, &mut waiting, &ray.single(lane), &mut hit);
            }
            found[..4].copy_from_slice(&[hit.t, hit.u, hit.v, hit.primitive]);
        }
        let [t, u, v, primitive, ..] = N::columns(
            #[inline(always)]
            |lane| all[lane],
        );
        Hit { t, u, v, primitive }
    }

    /// Of every active lane whether anything is met before `t_max`.
    #[inline(always)]
    pub fn is_blocked_of<N, M>(&self, machine: M, ray: &Ray<N>, t_max: N, active: N::Mask) -> N::Mask
    where
        N: Width<Scalar = P::Scalar, Pack = P>,
        M: Simd,
    {
        let mut waiting = [0; MOST_WAITING];
        let mut all = [P::Scalar::of(0.0); MOST_LANES];
        for (lane, found) in all.iter_mut().enumerate().take(N::LANES) {
            let mut hit = Hit::nothing(t_max.get(lane));
            if active.lane(lane) && self.search::<M, true>(machine, &mut waiting, &ray.single(lane), &mut hit) {
                *found = P::Scalar::of(1.0);
            }
        }
        let found = N::each(
            #[inline(always)]
            |lane| all[lane],
        );
        found.gt(N::of(0.0))
    }

    /// Whether anything is met before `best`, which is then replaced by the closest; if `ANY`, by nothing.
    #[inline(always)]
    fn search<M: Simd, const ANY: bool>(
        &self,
        machine: M,
        waiting: &mut Waiting,
        ray: &Ray<P::Scalar>,
        best: &mut Hit<P::Scalar>,
    ) -> bool {
        let slabs = Slabs::new(ray);
        let (shear, order) = Shear::<P>::of_one(ray);
        let wide = spread::<P>(ray);
        let mut limit = above(best.t.lane(0));
        let (mut count, mut is_met) = (0, false);
        let mut link = Link::node(0);
        loop {
            if link.is_leaf() {
                let packs = link.packs();
                macro_rules! search {
                    ($list:ident, $item:ident => $meet:expr) => {
                        for ($item, places) in &self.$list[packs] {
                            if take::<P, ANY>($meet, *places, best) {
                                if ANY {
                                    return true;
                                }
                                limit = above(best.t.lane(0));
                                is_met = true;
                            }
                        }
                    };
                }
                match link.kind() {
                    Kind::Triangle => search!(triangles, triangle => {
                        triangle.meet_sheared(&shear, #[inline(always)] |corner| ordered(corner, order))
                    }),
                    Kind::Quad => search!(quads, quad => quad.meet(&wide)),
                    Kind::Skew => search!(skew, quad => quad.meet(&wide)),
                    Kind::Sphere => search!(spheres, sphere => sphere.meet(&wide)),
                    Kind::Disc => search!(discs, disc => disc.meet(&wide)),
                }
            } else {
                let node = &self.nodes[link.0 as usize];
                let passed = slabs.pass(machine, node, limit);
                let (mut bits, from) = (passed.bits, count);
                // A single box is entered at once.
                if bits.is_power_of_two() {
                    link = node.children[bits.trailing_zeros() as usize & 7];
                    continue;
                }
                while bits != 0 {
                    let child = bits.trailing_zeros() as usize & 7;
                    bits &= bits - 1;
                    let entry = u64::from(passed.enter[child].to_bits()) << 32 | u64::from(node.children[child].0);
                    // The nearest comes to stand last.
                    let mut at = count;
                    while at > from && waiting[at - 1] < entry {
                        waiting[at] = waiting[at - 1];
                        at -= 1;
                    }
                    waiting[at] = entry;
                    count += 1;
                }
            }
            loop {
                if count == 0 {
                    return is_met;
                }
                count -= 1;
                let entry = waiting[count];
                if f32::from_bits((entry >> 32) as u32) <= limit {
                    link = Link(entry as u32);
                    break;
                }
            }
        }
    }
}

/// Takes the closest of a pack that is closer than `best`, or as close and lower in the list. Whether there is one.
#[inline(always)]
fn take<P: Width, const ANY: bool>(meeting: Meeting<P>, places: P, best: &mut Hit<P::Scalar>) -> bool {
    let limit = P::all(best.t);
    let is_closer = meeting.is_met & if ANY { meeting.t.lt(limit) } else { meeting.t.le(limit) };
    if !is_closer.any() {
        return false;
    }
    if ANY {
        return true;
    }
    let mut is_taken = false;
    for lane in 0..P::LANES {
        let (t, place) = (meeting.t.get(lane), places.get(lane));
        if is_closer.lane(lane) && (t < best.t || t == best.t && place < best.primitive) {
            *best = Hit { t, u: meeting.u.get(lane), v: meeting.v.get(lane), primitive: place };
            is_taken = true;
        }
    }
    is_taken
}

/// The same ray in every lane.
#[inline(always)]
fn spread<P: Width>(ray: &Ray<P::Scalar>) -> Ray<P> {
    let Ray { origin: o, direction: d } = ray;
    Ray {
        origin: Vector::new(P::all(o.x), P::all(o.y), P::all(o.z)),
        direction: Vector::new(P::all(d.x), P::all(d.y), P::all(d.z)),
    }
}

/// The least `f32` that is no less.
#[inline(always)]
fn above(x: f64) -> f32 {
    let near = x as f32;
    if f64::from(near) < x { near.next_up() } else { near }
}
