//! Media whose answer depends on the direction: 3×3 tensors for ε, μ and σ.

use super::{Vector, dot};

/// A linear relation between two vectors, row by row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tensor(pub [Vector; 3]);

impl Tensor {
    /// Different along each axis.
    pub const fn diagonal([x, y, z]: Vector) -> Self {
        Self([[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]])
    }

    /// What it makes of `v`.
    pub fn of(&self, v: Vector) -> Vector {
        self.0.map(|row| dot(row, v))
    }

    /// The same medium turned by the rotation matrix `turn`: turn · self · turnᵀ.
    pub fn turned(&self, turn: &Self) -> Self {
        let columns = turn.0.map(|row| self.of(row));
        // Entry (i, j) is the i-th row of the rotation on self times the j-th.
        Self(turn.0.map(|row| columns.map(|column| dot(row, column))))
    }

    /// The number that it is on average over all directions: a third of the trace, what a powder or a cubic crystal of
    /// it shows.
    pub fn isotropic_part(&self) -> f64 {
        (self.0[0][0] + self.0[1][1] + self.0[2][2]) / 3.0
    }
}

/// The conductivity [S m⁻¹] of one kind of carriers in a steady magnetic field: J = σ₀E + J×b solved for J, with the
/// Hall angle b = (qτ/m)B [1] as a vector (Ashcroft & Mermin, *Solid State Physics*, ch. 1, eq. 1.15).
pub fn hall_conductivity(sigma: f64, [x, y, z]: Vector) -> Tensor {
    let scale = sigma / (1.0 + x * x + y * y + z * z);
    let rows =
        [[1.0 + x * x, x * y + z, x * z - y], [x * y - z, 1.0 + y * y, y * z + x], [x * z + y, y * z - x, 1.0 + z * z]];
    Tensor(rows.map(|row| row.map(|entry| scale * entry)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fields::cross;

    #[test]
    fn the_hall_current_obeys_its_own_law() {
        let (e, b) = ([0.3, -1.2, 0.7], [0.5, 2.0, -0.4]);
        let j = hall_conductivity(3.0, b).of(e);
        for (axis, turned) in cross(j, b).into_iter().enumerate() {
            assert!((j[axis] - 3.0 * e[axis] - turned).abs() < 1e-14);
        }
        assert_eq!(hall_conductivity(3.0, [0.0; 3]), Tensor::diagonal([3.0; 3]));
    }

    #[test]
    fn a_quarter_turn_exchanges_the_axes() {
        let turn = Tensor([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]);
        assert_eq!(Tensor::diagonal([1.0, 2.0, 3.0]).turned(&turn), Tensor::diagonal([2.0, 1.0, 3.0]));
    }
}
