//! The same with twice the digits.

use super::vector::Vector;
use crate::wide::Wide;

#[derive(Clone, Copy, Debug)]
pub(super) struct WideVector(pub(super) [Wide; 3]);

impl From<Vector> for WideVector {
    fn from(vector: Vector) -> Self {
        Self(vector.map(Wide::from))
    }
}

impl WideVector {
    pub(super) fn plus(self, other: Self) -> Self {
        Self(std::array::from_fn(|axis| self.0[axis] + other.0[axis]))
    }

    pub(super) fn minus(self, other: Self) -> Self {
        Self(std::array::from_fn(|axis| self.0[axis] - other.0[axis]))
    }

    pub(super) fn times(self, factor: Wide) -> Self {
        Self(self.0.map(|component| component * factor))
    }

    pub(super) fn dot(self, other: Self) -> Wide {
        let [x, y, z] = std::array::from_fn(|axis| self.0[axis] * other.0[axis]);
        x + y + z
    }

    pub(super) fn cross(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([b * z - c * y, c * x - a * z, a * y - b * x])
    }

    pub(super) fn norm(self) -> Wide {
        self.dot(self).sqrt()
    }

    pub(super) fn narrow(self) -> Vector {
        self.0.map(f64::from)
    }
}
