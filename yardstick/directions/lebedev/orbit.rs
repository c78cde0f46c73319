//! The points that the 48 symmetries of the cube make of one.

use super::super::Direction;

/// An orbit, kept as one of its points.
#[derive(Clone, Copy, Debug)]
pub struct Orbit {
    /// Where it starts: on the face x + y + z = 1 of the octahedron, x ≥ y ≥ z ≥ 0.
    pub place: [f64; 3],
    /// Where it is on the sphere.
    pub at: Direction,
    /// The share of the sphere that all its points hold [1].
    pub share: f64,
    /// Which mirrors of the cube it lies on; it moves along them only.
    pub mirrors: Mirrors,
}

/// The mirrors of the cube through a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mirrors {
    /// So many that it cannot move; there are so many points of its kind: 6 on axes, 12 between two, 8 among three.
    Corner(usize),
    /// The plane of two axes.
    Side,
    /// The plane of this axis and the diagonal of the other two.
    Diagonal(usize),
    /// None.
    Inside,
}

impl Orbit {
    /// The orbit that starts at (p, q, r)/(p + q + r), p ≥ q ≥ r.
    pub fn new([p, q, r]: [usize; 3]) -> Self {
        let mirrors = match (p == q, q == r, r == 0) {
            (true, true, _) => Mirrors::Corner(8),
            (true, _, true) => Mirrors::Corner(12),
            (_, true, true) => Mirrors::Corner(6),
            (_, _, true) => Mirrors::Side,
            (true, _, _) => Mirrors::Diagonal(2),
            (_, true, _) => Mirrors::Diagonal(0),
            _ => Mirrors::Inside,
        };
        let place = [p, q, r].map(|part| part as f64 / (p + q + r) as f64);
        Self { place, at: normalised(place), share: 0.0, mirrors }
    }

    /// How many points it has.
    pub fn size(&self) -> usize {
        match self.mirrors {
            Mirrors::Corner(size) => size,
            Mirrors::Side | Mirrors::Diagonal(_) => 24,
            Mirrors::Inside => 48,
        }
    }

    /// All its points.
    pub fn points(&self) -> Vec<Direction> {
        let [x, y, z] = self.at;
        let mut points: Vec<Direction> = Vec::with_capacity(48);
        for exchanged in [[x, y, z], [y, z, x], [z, x, y], [y, x, z], [x, z, y], [z, y, x]] {
            for signs in 0..8 {
                let point = std::array::from_fn(|axis| [1.0, -1.0][signs >> axis & 1] * exchanged[axis]);
                // Mirrors leave the points on them where they are; −0 equals 0.
                if !points.contains(&point) {
                    points.push(point);
                }
            }
        }
        points
    }

    /// The directions in which it may move: unit vectors at right angles to it and to each other.
    pub fn ways(&self) -> Vec<[f64; 3]> {
        let [x, y, z] = self.at;
        match self.mirrors {
            Mirrors::Corner(_) => vec![],
            Mirrors::Side => vec![[-y, x, 0.0]],
            Mirrors::Diagonal(axis) => vec![towards(self.at, axis)],
            Mirrors::Inside => {
                let [a, b, c] = towards(self.at, 2);
                vec![[a, b, c], [y * c - z * b, z * a - x * c, x * b - y * a]]
            }
        }
    }

    /// Moved by `steps` [rad] along its [`Self::ways`].
    pub fn moved(&self, steps: &[f64]) -> Self {
        let mut at = self.at;
        for (way, step) in self.ways().into_iter().zip(steps) {
            at = std::array::from_fn(|axis| at[axis] + step * way[axis]);
        }
        Self { at: normalised(at), ..*self }
    }
}

/// The unit tangent at `at` that leads to `axis`.
fn towards(at: Direction, axis: usize) -> [f64; 3] {
    normalised(std::array::from_fn(|part| f64::from(u8::from(part == axis)) - at[axis] * at[part]))
}

pub fn normalised(vector: [f64; 3]) -> Direction {
    let length = vector.iter().map(|part| part * part).sum::<f64>().sqrt();
    vector.map(|part| part / length)
}
