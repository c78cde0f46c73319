//! Axes about a normal.

use super::{Number, Vector};

/// Three axes at right angles; z is the normal.
#[derive(Clone, Copy, Debug)]
pub struct Frame<N> {
    /// Along the surface.
    pub x: Vector<N>,
    /// Along the surface, across x.
    pub y: Vector<N>,
    /// The normal.
    pub z: Vector<N>,
}

impl<N: Number> Frame<N> {
    /// About a unit vector, without a root and without a place where it fails (T. Duff et al., *Building an orthonormal basis,
    /// revisited*, JCGT 6(1) (2017) 1).
    #[inline(always)]
    pub fn about(z: Vector<N>) -> Self {
        let one = N::of(1.0);
        let sign = N::select(z.z.lt(N::of(0.0)), -one, one);
        let a = -one / (sign + z.z);
        let b = z.x * z.y * a;
        let x = Vector::new(one + sign * z.x * z.x * a, sign * b, -sign * z.x);
        let y = Vector::new(b, sign + z.y * z.y * a, -z.y);
        Self { x, y, z }
    }

    /// The same seen from the other side where the mask is true; it stays right-handed.
    #[inline(always)]
    pub fn turned(self, mask: N::Mask) -> Self {
        Self { x: self.x, y: Vector::select(mask, -self.y, self.y), z: Vector::select(mask, -self.z, self.z) }
    }

    /// A vector's components along the axes.
    #[inline(always)]
    pub fn inward(&self, v: Vector<N>) -> Vector<N> {
        Vector::new(self.x.dot(v), self.y.dot(v), self.z.dot(v))
    }

    /// The vector of such components.
    #[inline(always)]
    pub fn outward(&self, v: Vector<N>) -> Vector<N> {
        self.x.scaled(v.x) + self.y.scaled(v.y) + self.z.scaled(v.z)
    }
}

/// The length [m] of a vector, and the vector of length 1 along it; both 0 for a null one.
#[inline(always)]
pub fn length_and_way<N: Number>(v: Vector<N>) -> (N, Vector<N>) {
    let length = v.dot(v).sqrt();
    let is_some = length.gt(N::of(0.0));
    (length, v.scaled((N::of(1.0) / N::select(is_some, length, N::of(1.0))).only(is_some)))
}
