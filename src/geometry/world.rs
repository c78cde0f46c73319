//! All primitives at once.

use super::brute::Brute;
use super::bvh::Bvh;
use super::surface::Rows;
use super::walls::walls;
use super::{Bounds, Primitive, Ray, Surface};
use crate::number::{Number, Vector, Width};
use crate::scene::Triple;
#[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
use fearless_simd::{Level, dispatch};
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
use {
    crate::number::avx2,
    fearless_simd::{Level, Simd},
};

/// What a ray met.
#[derive(Clone, Copy, Debug)]
pub struct Hit<N> {
    /// How far, in lengths of the ray's direction [1]; infinite if it met nothing.
    pub t: N,
    /// Where on the primitive [1]: −1 … 1 along the first edge of a quad, the first axis of a disc in radii, the share of
    /// a triangle's second corner; 0 on a sphere.
    pub u: N,
    /// The same along the second, and of the third corner.
    pub v: N,
    /// Its place in the list, a whole number; −1 if it met nothing.
    pub primitive: N,
}

impl<N: Number> Hit<N> {
    /// None yet, before `t_max`.
    #[inline(always)]
    pub(super) fn nothing(t_max: N) -> Self {
        Self { t: t_max, u: N::of(0.0), v: N::of(0.0), primitive: N::of(-1.0) }
    }

    /// Replaced where the mask is true.
    #[inline(always)]
    pub(super) fn take(&mut self, mask: N::Mask, t: N, u: N, v: N, primitive: N) {
        self.t = N::select(mask, t, self.t);
        self.u = N::select(mask, u, self.u);
        self.v = N::select(mask, v, self.v);
        self.primitive = N::select(mask, primitive, self.primitive);
    }

    /// Whether there is one.
    #[inline(always)]
    pub fn is_some(&self) -> N::Mask {
        self.primitive.ge(N::of(0.0))
    }
}

impl<N: Width> Hit<N> {
    /// That of one lane.
    #[inline(always)]
    pub(super) fn single(&self, lane: usize) -> Hit<N::Scalar> {
        Hit { t: self.t.get(lane), u: self.u.get(lane), v: self.v.get(lane), primitive: self.primitive.get(lane) }
    }
}

/// How a world is searched.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Structure {
    /// Whichever is faster for as many primitives.
    #[default]
    Best,
    /// One after the other.
    Brute,
    /// Through a hierarchy of boxes.
    Bvh,
}

/// Between what points [`World::is_blocked`] will be asked. What has all of them on one side of its plane cannot come
/// between them and is left out: the walls of a room. A ray to infinity ends nowhere.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Ends {
    /// Any; nothing is left out.
    #[default]
    Anywhere,
    /// Points of the world's own surfaces, and these besides [m]: where lights without a surface stand, and the lens.
    OnSurfaces(Vec<Triple>),
}

/// How a world is made.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Settings {
    /// How it is searched.
    pub structure: Structure,
    /// Between what points segments run.
    pub ends: Ends,
}

/// Up to as many primitives trying all is faster, one ray at a time and eight: measured on cubes in a room by
/// `cargo bench -p light --bench geometry -- few`.
const MOST_BRUTE: [usize; 2] = [12, 40];

/// The most walls that are tried before the hierarchy.
const MOST_WALLS: usize = 8;

/// Surfaces, to be asked what a ray meets.
#[derive(Clone, Debug)]
pub struct World<N: Width> {
    /// What is tried one by one and may come between two points.
    few: Brute<N>,
    /// What is tried one by one and cannot.
    walls: Brute<N>,
    /// The rest.
    many: Option<Bvh<N::Pack>>,
    rows: Rows<N>,
    bounds: Bounds,
}

impl<N: Width> World<N> {
    /// The most primitives that a world can hold: their places are numbers of `f32`.
    pub const MOST: usize = 1 << 24;

    /// Of `primitives`, at most [`Self::MOST`].
    pub fn new(primitives: &[Primitive]) -> Self {
        Self::with(primitives, &Settings::default())
    }

    /// The same, made in a certain way.
    pub fn with(primitives: &[Primitive], settings: &Settings) -> Self {
        debug_assert!(primitives.len() <= Self::MOST);
        let is_brute = match settings.structure {
            Structure::Best => primitives.len() <= MOST_BRUTE[usize::from(N::LANES > 1)],
            Structure::Brute => true,
            Structure::Bvh => false,
        };
        let walls = match &settings.ends {
            Ends::Anywhere => Vec::new(),
            Ends::OnSurfaces(also) => walls(primitives, also, if is_brute { usize::MAX } else { MOST_WALLS }),
        };
        let is_wall = |at: usize| walls.binary_search(&at).is_ok();
        let many = (!is_brute).then(|| Bvh::new(primitives, |at| !is_wall(at)));
        Self {
            few: Brute::new(primitives, |at| is_brute && !is_wall(at)),
            walls: Brute::new(primitives, is_wall),
            rows: Rows::new(primitives, many.as_ref()),
            many,
            bounds: primitives.iter().fold(Bounds::NOTHING, |all, one| all.union(&one.bounds())),
        }
    }

    /// Whether everything is tried one after the other.
    pub fn is_brute(&self) -> bool {
        self.many.is_none()
    }

    /// Primitives that cannot come between two points.
    pub fn walls(&self) -> usize {
        self.walls.count()
    }

    /// The box about everything.
    pub fn bounds(&self) -> Bounds {
        self.bounds
    }

    /// What it occupies in memory [B].
    pub fn bytes(&self) -> usize {
        self.few.bytes() + self.walls.bytes() + self.many.as_ref().map_or(0, Bvh::bytes) + self.rows.bytes()
    }

    /// The closest hit at t > 0 of every active lane; of primitives equally far the first in the list.
    #[inline(always)]
    pub fn closest(&self, ray: &Ray<N>, active: N::Mask) -> Hit<N> {
        let infinite = N::of(f64::INFINITY);
        let mut hit = Hit::nothing(infinite.only(active));
        self.few.closest(ray, &mut hit);
        self.walls.closest(ray, &mut hit);
        if let Some(many) = &self.many {
            hit = closest_of(many, ray, hit, active);
        }
        Hit { t: N::select(active, hit.t, infinite), ..hit }
    }

    /// Whether anything is met within 0 < t < `t_max`; false in lanes that are not active.
    #[inline(always)]
    pub fn is_blocked(&self, ray: &Ray<N>, t_max: N, active: N::Mask) -> N::Mask {
        let t_max = t_max.only(active);
        let mut blocked = self.few.is_blocked(ray, t_max);
        if let Some(many) = &self.many {
            blocked = blocked | is_blocked_of(many, ray, t_max, active);
        }
        blocked
    }

    /// What the surface is like at a place of a flat primitive, as [`Hit`] has it.
    #[inline(always)]
    pub fn at(&self, primitive: N, [u, v]: [N; 2]) -> Surface<N> {
        let null = Vector::of([0.0; 3]);
        self.surface(&Ray { origin: null, direction: null }, &Hit { t: N::of(0.0), u, v, primitive })
    }

    /// What the surface is like where `ray` has met it; of lanes without a hit, some numbers.
    #[inline(always)]
    pub fn surface(&self, ray: &Ray<N>, hit: &Hit<N>) -> Surface<N> {
        self.rows.surface(self.many.as_ref(), ray, hit)
    }
}

/// A search, for the machine it is on. By a call of its own, which is little beside it and keeps it out of whoever asks.
macro_rules! searched {
    ($machine:ident => $search:expr) => {{
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        match avx2() {
            Some($machine) => $machine.vectorize(
                #[inline(always)]
                || $search,
            ),
            None => {
                let $machine = Level::new().as_sse2().expect("every x86 that Rust compiles for has SSE2");
                $search
            }
        }
        #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
        dispatch!(Level::new(), $machine => $search)
    }};
}

#[inline(never)]
fn closest_of<N: Width>(many: &Bvh<N::Pack>, ray: &Ray<N>, hit: Hit<N>, active: N::Mask) -> Hit<N> {
    searched!(machine => many.closest_of(machine, ray, hit, active))
}

#[inline(never)]
fn is_blocked_of<N: Width>(many: &Bvh<N::Pack>, ray: &Ray<N>, t_max: N, active: N::Mask) -> N::Mask {
    searched!(machine => many.is_blocked_of(machine, ray, t_max, active))
}
