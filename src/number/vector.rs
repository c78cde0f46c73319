//! Three numbers that are a direction.

use super::Number;
use std::ops::{Add, Neg, Sub};

/// A vector over any width. z is along the local normal.
#[derive(Clone, Copy, Debug)]
pub struct Vector<N> {
    /// Along the surface.
    pub x: N,
    /// Along the surface, across x.
    pub y: N,
    /// Along the normal.
    pub z: N,
}

impl<N: Number> Vector<N> {
    /// From its components.
    #[inline(always)]
    pub fn new(x: N, y: N, z: N) -> Self {
        Self { x, y, z }
    }

    /// The same vector in every lane.
    #[inline(always)]
    pub fn of([x, y, z]: [f64; 3]) -> Self {
        Self { x: N::of(x), y: N::of(y), z: N::of(z) }
    }

    /// One lane of it.
    pub fn lane(self, at: usize) -> [f64; 3] {
        [self.x.lane(at), self.y.lane(at), self.z.lane(at)]
    }

    /// v·w.
    #[inline(always)]
    pub fn dot(self, other: Self) -> N {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// v × w.
    #[inline(always)]
    pub fn cross(self, other: Self) -> Self {
        Self {
            x: self.y * other.z - self.z * other.y,
            y: self.z * other.x - self.x * other.z,
            z: self.x * other.y - self.y * other.x,
        }
    }

    /// Times a number.
    #[inline(always)]
    pub fn scaled(self, factor: N) -> Self {
        Self { x: self.x * factor, y: self.y * factor, z: self.z * factor }
    }

    /// Of length 1; not a number if null.
    #[inline(always)]
    pub fn normalised(self) -> Self {
        self.scaled(N::of(1.0) / self.dot(self).sqrt())
    }

    /// `yes` where the mask is true, `no` elsewhere.
    #[inline(always)]
    pub fn select(mask: N::Mask, yes: Self, no: Self) -> Self {
        Self { x: N::select(mask, yes.x, no.x), y: N::select(mask, yes.y, no.y), z: N::select(mask, yes.z, no.z) }
    }

    /// Mirrored in the surface where the mask is true.
    #[inline(always)]
    pub fn flipped(self, mask: N::Mask) -> Self {
        Self { z: N::select(mask, -self.z, self.z), ..self }
    }

    /// sin² of the angle to the normal.
    #[inline(always)]
    pub fn sin2(self) -> N {
        self.x.squared() + self.y.squared()
    }
}

impl<N: Number> Neg for Vector<N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { x: -self.x, y: -self.y, z: -self.z }
    }
}

impl<N: Number> Add for Vector<N> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y, z: self.z + other.z }
    }
}

impl<N: Number> Sub for Vector<N> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}
