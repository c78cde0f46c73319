//! What comes between two faces.

use super::{Patch, Room};
use crate::geometry::{Quad, Ray};
use crate::number::Vector;
use crate::scene::Triple;
use crate::scene::triple::{largest, minus};

/// The faces that may come between each two.
pub(super) struct Sight {
    faces: Vec<Patch>,
    /// Row by row, the others that may hide something of one from the other.
    others: Vec<Vec<usize>>,
    slack: f64,
}

/// Roundings by which a corner in a plane may seem to be off it.
const SLACK: f64 = 32.0 * f64::EPSILON;

impl Sight {
    pub fn new(room: &Room) -> Self {
        let faces: Vec<Patch> = room.faces.iter().map(|face| face.patch).collect();
        let reach = faces.iter().flat_map(Patch::corners).map(largest).fold(0.0, f64::max);
        let mut sight = Self { faces, others: Vec::new(), slack: SLACK * reach };
        let n = sight.faces.len();
        let all: Vec<usize> = (0..n).collect();
        sight.others = (0..n * n)
            .map(|at| {
                let ends = [at / n, at % n];
                sight.among(&all, ends, ends.map(|end| &sight.faces[end]))
            })
            .collect();
        sight
    }

    /// Whether any face may hide something of one from the other.
    pub fn may_be_blocked(&self, from: usize, to: usize) -> bool {
        !self.others[from * self.faces.len() + to].is_empty()
    }

    /// The faces that may come between patches of two of them, ready for rays.
    pub fn between(&self, [from, to]: [usize; 2], patches: [&Patch; 2]) -> Vec<Quad<f64>> {
        let others = &self.others[from * self.faces.len() + to];
        let left = self.among(others, [from, to], patches);
        left.into_iter().map(|at| Quad::new(self.faces[at].corner, self.faces[at].edges)).collect()
    }

    /// Of some faces those with something of both patches on either side of their plane, and of themselves before both.
    fn among(&self, others: &[usize], ends: [usize; 2], patches: [&Patch; 2]) -> Vec<usize> {
        let between = |at: &usize| {
            let face = &self.faces[*at];
            let corners = || patches.iter().flat_map(|patch| patch.corners()).map(|corner| face.before(corner));
            let is_crossed = corners().any(|off| off > self.slack) && corners().any(|off| off < -self.slack);
            let is_before = |patch: &&Patch| face.corners().iter().any(|corner| patch.before(*corner) > self.slack);
            !ends.contains(at) && is_crossed && patches.iter().all(is_before)
        };
        others.iter().copied().filter(between).collect()
    }

    /// Whether none of them is met on the way.
    pub fn is_free(between: &[Quad<f64>], from: Triple, to: Triple) -> bool {
        let ray = Ray { origin: Vector::of(from), direction: Vector::of(minus(to, from)) };
        between.iter().all(|quad| quad.closest(&ray, 0.0, 1.0).is_infinite())
    }
}
