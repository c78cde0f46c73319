//! A flat piece of a surface.

use crate::scene::Triple;
use crate::scene::triple::{cross, dot, length, minus, normalised, plus, times};

/// What two edges from a corner span.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outline {
    /// All of the parallelogram.
    Parallelogram,
    /// The half of it beside the corner.
    Triangle,
}

/// A flat piece that reflects and shines on one side, that of its normal; its back is black.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Patch {
    /// One corner [m].
    pub corner: Triple,
    /// From there to its two neighbours [m]; the normal is along the first × the second.
    pub edges: [Triple; 2],
    /// What they span.
    pub outline: Outline,
}

impl Patch {
    /// That which two edges [m] span from a corner [m].
    pub const fn parallelogram(corner: Triple, edges: [Triple; 2]) -> Self {
        Self { corner, edges, outline: Outline::Parallelogram }
    }

    /// That of three corners [m], counterclockwise about the normal.
    pub fn triangle([a, b, c]: [Triple; 3]) -> Self {
        Self { corner: a, edges: [minus(b, a), minus(c, a)], outline: Outline::Triangle }
    }

    /// The same place, seen from behind.
    pub const fn back(&self) -> Self {
        let [first, second] = self.edges;
        Self { edges: [second, first], ..*self }
    }

    fn is_triangle(&self) -> bool {
        self.outline == Outline::Triangle
    }

    /// [m²].
    pub fn area(&self) -> f64 {
        let share = if self.is_triangle() { 0.5 } else { 1.0 };
        share * length(cross(self.edges[0], self.edges[1]))
    }

    /// The middle, that is the mean of all its places [m].
    pub fn middle(&self) -> Triple {
        self.at(if self.is_triangle() { [1.0 / 3.0; 2] } else { [0.5; 2] })
    }

    /// Of length 1.
    pub fn normal(&self) -> Triple {
        normalised(cross(self.edges[0], self.edges[1]))
    }

    /// The place [m] that is such shares of the edges away from the corner.
    pub fn at(&self, [u, v]: [f64; 2]) -> Triple {
        plus(self.corner, plus(times(self.edges[0], u), times(self.edges[1], v)))
    }

    /// Its corners [m] in order; of a triangle the last one twice.
    pub fn corners(&self) -> [Triple; 4] {
        let far = if self.is_triangle() { [0.0, 1.0] } else { [1.0, 1.0] };
        [[0.0, 0.0], [1.0, 0.0], far, [0.0, 1.0]].map(|at| self.at(at))
    }

    /// The longer of its edges [m].
    pub fn size(&self) -> f64 {
        length(self.edges[0]).max(length(self.edges[1]))
    }

    /// How many pieces there are if its edges are cut into so many; a triangle's are cut alike.
    pub fn count(&self, [columns, rows]: [usize; 2]) -> usize {
        columns * rows
    }

    /// The piece of that number, row by row along the first edge, its edges cut into so many. Of a triangle's, which are
    /// triangles, every other in a row is turned round.
    pub fn piece(&self, counts: [usize; 2], number: usize) -> Self {
        let edges = [0, 1].map(|axis| times(self.edges[axis], 1.0 / counts[axis] as f64));
        let share = |at: [usize; 2]| self.at([0, 1].map(|axis| at[axis] as f64 / counts[axis] as f64));
        if !self.is_triangle() {
            let at = [number % counts[0], number / counts[0]];
            return Self { corner: share(at), edges, ..*self };
        }
        // Before row j there are n² − (n − j)² pieces.
        let n = counts[0];
        let row = (0..n).rev().find(|row| n * n - (n - row) * (n - row) <= number).unwrap_or(0);
        let along = number - (n * n - (n - row) * (n - row));
        if along.is_multiple_of(2) {
            Self { corner: share([along / 2, row]), edges, ..*self }
        } else {
            Self { corner: share([along / 2 + 1, row + 1]), edges: edges.map(|edge| times(edge, -1.0)), ..*self }
        }
    }

    /// The number of the piece that has the place (u, v), 0 … 1; of a triangle u + v ≤ 1.
    pub fn number(&self, counts: [usize; 2], place: [f64; 2]) -> usize {
        let scaled = [0, 1].map(|axis| (place[axis] * counts[axis] as f64).max(0.0));
        let [i, j] = [0, 1].map(|axis| (scaled[axis] as usize).min(counts[axis] - 1));
        if !self.is_triangle() {
            return j * counts[0] + i;
        }
        let n = counts[0];
        let i = i.min(n - 1 - j);
        let is_turned = (scaled[0] - i as f64) + (scaled[1] - j as f64) > 1.0 && i + j + 1 < n;
        n * n - (n - j) * (n - j) + 2 * i + usize::from(is_turned)
    }

    /// How far a place is before its plane [m].
    pub fn before(&self, place: Triple) -> f64 {
        dot(self.normal(), minus(place, self.corner))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_cover_all_and_are_found_again() {
        let corners = [[0.0, 1.0, 2.0], [2.0, 1.0, 2.5], [0.5, 3.0, 1.0]];
        let triangle = Patch::triangle(corners);
        let whole = Patch { outline: Outline::Parallelogram, ..triangle };
        for (patch, counts) in [(triangle, [5, 5]), (whole, [3, 4]), (triangle, [1, 1])] {
            let pieces: Vec<Patch> = (0..patch.count(counts)).map(|number| patch.piece(counts, number)).collect();
            let area: f64 = pieces.iter().map(Patch::area).sum();
            assert!((area / patch.area() - 1.0).abs() < 1e-14);
            for (number, piece) in pieces.iter().enumerate() {
                assert!(dot(piece.normal(), patch.normal()) > 0.999);
                let [a, b] = patch.edges;
                let normal = cross(a, b);
                // The middle and places near the corners, by their shares of the edges: of the dual basis.
                for corner in [piece.middle()].into_iter().chain(piece.corners()) {
                    let inside = plus(times(piece.middle(), 0.05), times(corner, 0.95));
                    let way = minus(inside, patch.corner);
                    let place =
                        [dot(cross(way, b), normal), dot(cross(a, way), normal)].map(|x| x / dot(normal, normal));
                    assert_eq!(patch.number(counts, place), number, "{place:?}");
                }
            }
        }
    }
}
