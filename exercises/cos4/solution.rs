/// Irradiance [1] of a floor by a small lamp in the ceiling, over that straight below it, at an angle of that cosine.
pub fn law(cos: f64) -> f64 {
    cos.powi(4)
}
