//! One ray against eight boxes.

use super::{Node, PAD};
use crate::geometry::Ray;
use crate::number::Width;
use crate::number::{F32x8, Number};
use fearless_simd::{Simd, SimdFrom, f32x8, prelude::*};

/// A ray as boxes see it: in `f32` whatever its width, its origin moved so that boxes are met early and left late.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slabs {
    entry: [F32x8; 3],
    exit: [F32x8; 3],
    pace: [F32x8; 3],
    /// Which plane of each axis comes first.
    first: [usize; 3],
}

/// Which of eight boxes a ray passes, as bits, and where it enters them.
pub(super) struct Passed {
    pub bits: u32,
    pub enter: [f32; 8],
}

impl Slabs {
    #[inline(always)]
    pub fn new<S: Width>(ray: &Ray<S>) -> Self {
        let Ray { origin: o, direction: d } = ray;
        let origin = [narrow(o.x), narrow(o.y), narrow(o.z)];
        let reach = origin[0].abs().max(origin[1].abs()).max(origin[2].abs());
        let pad = reach * (PAD * f64::from(f32::EPSILON)) as f32;
        // In the ray's own width, so that in `f32` it is what triangles divide by.
        let one = S::of(1.0);
        let pace = [narrow(one / d.x), narrow(one / d.y), narrow(one / d.z)];
        let (x, y, z) =
            (moved(origin[0], pace[0], pad), moved(origin[1], pace[1], pad), moved(origin[2], pace[2], pad));
        Self {
            entry: [F32x8::all(x.0), F32x8::all(y.0), F32x8::all(z.0)],
            exit: [F32x8::all(x.1), F32x8::all(y.1), F32x8::all(z.1)],
            pace: [F32x8::all(pace[0]), F32x8::all(pace[1]), F32x8::all(pace[2])],
            first: [usize::from(pace[0] < 0.0), usize::from(pace[1] < 0.0), usize::from(pace[2] < 0.0)],
        }
    }

    /// Boxes that the ray is in anywhere within 0 ≤ t ≤ `limit`. What is not a number, 0 · ∞ in the very plane of a side,
    /// does not count.
    #[inline(always)]
    pub fn pass<M: Simd>(&self, machine: M, node: &Node, limit: f32) -> Passed {
        let (mut enter, mut leave) = (F32x8::of(0.0), F32x8::all(limit));
        for axis in 0..3 {
            let first = self.first[axis];
            let near = (node.planes[axis][first & 1] - self.entry[axis]) * self.pace[axis];
            let far = (node.planes[axis][!first & 1] - self.exit[axis]) * self.pace[axis];
            enter = near.max(enter);
            leave = far.min(leave);
        }
        // By the machine's own instruction: bits taken out of lanes one by one break up all that made them.
        let [enters, leaves] = [f32x8::simd_from(machine, enter.0), f32x8::simd_from(machine, leave.0)];
        let bits = enters.simd_le(leaves).to_bitmask() as u32;
        Passed { bits, enter: enter.0 }
    }
}

#[inline(always)]
fn narrow<S: Width>(x: S) -> f32 {
    x.lane(0) as f32
}

/// Boxes ahead come earlier the farther the origin is on, and end later the farther it is back.
#[inline(always)]
fn moved(origin: f32, pace: f32, pad: f32) -> (f32, f32) {
    let ahead = if pace < 0.0 { -pad } else { pad };
    (origin + ahead, origin - ahead)
}
