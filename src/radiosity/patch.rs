//! A flat piece of a surface.

use crate::scene::Triple;
use crate::scene::triple::{cross, dot, length, minus, normalised, plus, times};

/// A parallelogram that reflects and shines on one side, that of its normal; its back is black.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Patch {
    /// One corner [m].
    pub corner: Triple,
    /// From there to its two neighbours [m]; the normal is along the first × the second.
    pub edges: [Triple; 2],
}

impl Patch {
    /// [m²].
    pub fn area(&self) -> f64 {
        length(cross(self.edges[0], self.edges[1]))
    }

    /// Of length 1.
    pub fn normal(&self) -> Triple {
        normalised(cross(self.edges[0], self.edges[1]))
    }

    /// The place [m] that is such shares of the edges away from the corner.
    pub fn at(&self, [u, v]: [f64; 2]) -> Triple {
        plus(self.corner, plus(times(self.edges[0], u), times(self.edges[1], v)))
    }

    /// Its corners [m] in order.
    pub fn corners(&self) -> [Triple; 4] {
        [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|at| self.at(at))
    }

    /// The longer of its edges [m].
    pub fn size(&self) -> f64 {
        length(self.edges[0]).max(length(self.edges[1]))
    }

    /// The piece of column `i` and row `j`, cut into so many of either.
    pub fn piece(&self, counts: [usize; 2], at: [usize; 2]) -> Self {
        let corner = self.at([0, 1].map(|axis| at[axis] as f64 / counts[axis] as f64));
        let edges = [0, 1].map(|axis| times(self.edges[axis], 1.0 / counts[axis] as f64));
        Self { corner, edges }
    }

    /// How far a place is before its plane [m].
    pub fn before(&self, place: Triple) -> f64 {
        dot(self.normal(), minus(place, self.corner))
    }
}
