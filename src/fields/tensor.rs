//! Media whose answer depends on the direction: 3×3 tensors for ε, μ and σ.

use super::{Vector, cross, dot};

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

    /// The number that it is on average over all directions: a third of the trace. Of a block of grains that point
    /// everywhere it is an upper bound, reached if the field were the same in all of them.
    pub fn isotropic_part(&self) -> f64 {
        (self.0[0][0] + self.0[1][1] + self.0[2][2]) / 3.0
    }

    /// The number that a block of grains shows which point everywhere, for a symmetric tensor of three positive axes:
    /// Bruggeman's self-consistent estimate, in which grains are balls in the block itself,
    /// Σ (ε_i − ε)/(ε_i + 2ε) = 0 (D. Stroud, *Phys. Rev. B* **12**, 3368, 1975). Multiplied out it is
    /// 4ε³ = I₂ε + I₃, with the sum I₂ of the principal minors and the determinant I₃.
    pub fn of_grains(&self) -> f64 {
        let mean = self.isotropic_part();
        let [x, y, z] = self.0.map(|row| row.map(|entry| entry / mean));
        let minors = cross(x, y)[2] + cross(y, z)[0] + cross(z, x)[1];
        let determinant = dot(x, cross(y, z));
        // The cubic is convex, so that Newton's steps from above the root come down to it.
        let mut root = 1.0_f64;
        loop {
            let next = (8.0 * root.powi(3) + determinant) / (12.0 * root * root - minors);
            if next.partial_cmp(&root) != Some(std::cmp::Ordering::Less) {
                return mean * root;
            }
            root = next;
        }
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
    use proptest::prelude::*;

    #[test]
    fn the_hall_current_obeys_its_own_law() {
        let (e, b) = ([0.3, -1.2, 0.7], [0.5, 2.0, -0.4]);
        let j = hall_conductivity(3.0, b).of(e);
        for (axis, turned) in cross(j, b).into_iter().enumerate() {
            assert!((j[axis] - 3.0 * e[axis] - turned).abs() < 1e-14);
        }
        assert_eq!(hall_conductivity(3.0, [0.0; 3]), Tensor::diagonal([3.0; 3]));
    }

    /// Of two equal axes a and one b: 2ε² = aε + ab.
    #[test]
    fn marble_is_less_than_the_mean_of_calcite() {
        let [a, b] = [1.6584f64, 1.4864].map(|n| n * n);
        let calcite = Tensor::diagonal([a, a, b]);
        assert!((calcite.of_grains() - 0.25 * (a + (a * a + 8.0 * a * b).sqrt())).abs() < 4.0 * f64::EPSILON);
        assert!((calcite.of_grains() - 2.5613).abs() < 5e-5);
        assert!((calcite.isotropic_part() - 2.56999).abs() < 5e-6);
    }

    proptest! {
        /// Wiener's bounds; and the grains may point anywhere, so that the first may be turned.
        #[test]
        fn grains_lie_between_the_means(axes in prop::array::uniform3(1e-3..1e3f64), angle in 0.0..6.3f64) {
            let crystal = Tensor::diagonal(axes);
            let block = crystal.of_grains();
            let harmonic = 3.0 / axes.iter().map(|axis| axis.recip()).sum::<f64>();
            let slack = 16.0 * f64::EPSILON;
            prop_assert!(block <= crystal.isotropic_part() * (1.0 + slack), "{block}");
            prop_assert!(block >= harmonic * (1.0 - slack), "{block}");
            let (sin, cos) = angle.sin_cos();
            let about_x = Tensor([[1.0, 0.0, 0.0], [0.0, cos, -sin], [0.0, sin, cos]]);
            let about_z = Tensor([[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]]);
            let turned = crystal.turned(&about_x).turned(&about_z).of_grains();
            // Entries of the turned tensor are known to ε of the largest axis, its determinant to that over the least.
            prop_assert!((turned / block - 1.0).abs() < 1e-9, "{turned} {block}");
        }
    }

    #[test]
    fn a_quarter_turn_exchanges_the_axes() {
        let turn = Tensor([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]);
        assert_eq!(Tensor::diagonal([1.0, 2.0, 3.0]).turned(&turn), Tensor::diagonal([2.0, 1.0, 3.0]));
    }
}
