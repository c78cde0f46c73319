/// Approximate reflectance [1] of natural light at that cosine, with that reflectance along the normal.
pub fn schlick(cos_i: f64, r_0: f64) -> f64 {
    r_0 + (1.0 - r_0) * (1.0 - cos_i).powi(5)
}
