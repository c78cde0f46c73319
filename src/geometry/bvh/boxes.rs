//! One ray against eight boxes.

use super::{Node, PAD};
use crate::geometry::Ray;
use crate::number::Width;
use crate::number::{F32x8, Number};

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
        let [o, d] = [ray.origin, ray.direction].map(|v| [v.x, v.y, v.z].map(|part| part.lane(0)));
        let origin = o.map(|part| part as f32);
        let pad = origin.map(f32::abs).into_iter().fold(0.0, f32::max) * (PAD * f64::from(f32::EPSILON)) as f32;
        // In the ray's own width, so that in `f32` it is what triangles divide by.
        let pace = d.map(|part| (S::of(1.0) / S::of(part)).lane(0) as f32);
        let first = pace.map(|pace| usize::from(pace < 0.0));
        // Towards higher numbers boxes come earlier the farther the origin is on.
        let moved = |axis: usize, by: f32| origin[axis] + if first[axis] == 0 { by } else { -by };
        Self {
            entry: [0, 1, 2].map(|axis| F32x8::all(moved(axis, pad))),
            exit: [0, 1, 2].map(|axis| F32x8::all(moved(axis, -pad))),
            pace: pace.map(F32x8::all),
            first,
        }
    }

    /// Boxes that the ray is in anywhere within 0 ≤ t ≤ `limit`. What is not a number, 0 · ∞ in the very plane of a side,
    /// does not count.
    #[inline(always)]
    pub fn pass(&self, node: &Node, limit: f32) -> Passed {
        let (mut enter, mut leave) = (F32x8::of(0.0), F32x8::all(limit));
        for axis in 0..3 {
            let first = self.first[axis];
            let near = (node.planes[axis][first & 1] - self.entry[axis]) * self.pace[axis];
            let far = (node.planes[axis][!first & 1] - self.exit[axis]) * self.pace[axis];
            enter = near.max(enter);
            leave = far.min(leave);
        }
        let mask = enter.le(leave);
        let mut bits = 0;
        for lane in 0..8 {
            bits |= mask.0[lane] & 1 << lane;
        }
        Passed { bits, enter: enter.0 }
    }
}
