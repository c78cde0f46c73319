//! One triangle of a relief.

/// The plane of a triangle over its cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facet {
    /// Its height [cells] over the cell's near corner, where the plane of both triangles passes.
    pub height: f64,
    /// (∂z/∂x, ∂z/∂y) [1].
    pub slope: [f64; 2],
}

impl Facet {
    /// How high above the plane `point` is [cells], measured from the cell's near corner.
    #[inline]
    pub fn above(&self, [x, y, z]: [f64; 3]) -> f64 {
        z - (self.height + self.slope[0] * x + self.slope[1] * y)
    }

    /// How fast a ray along `direction` gains on the plane [1]: negative where it falls towards it.
    #[inline]
    pub fn gain(&self, [x, y, z]: [f64; 3]) -> f64 {
        z - (self.slope[0] * x + self.slope[1] * y)
    }

    /// The square of the length of (−s_x, −s_y, 1) [1].
    fn stretch(&self) -> f64 {
        1.0 + (self.slope[0] * self.slope[0] + self.slope[1] * self.slope[1])
    }

    /// `direction` mirrored, and the cosine at which it came [1], 0 to 1.
    #[inline]
    pub fn mirrored(&self, direction: [f64; 3]) -> ([f64; 3], f64) {
        let (gain, stretch) = (self.gain(direction), self.stretch());
        let push = 2.0 * gain / stretch;
        let [x, y, z] = direction;
        let out = [x + push * self.slope[0], y + push * self.slope[1], z - push];
        (out, (-gain / stretch.sqrt()).clamp(0.0, 1.0))
    }

    /// The unit normal, upwards.
    pub fn normal(&self) -> [f64; 3] {
        let length = self.stretch().sqrt();
        [-self.slope[0] / length, -self.slope[1] / length, 1.0 / length]
    }
}
