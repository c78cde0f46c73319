/// Reflected share [1] of natural light at a clear interface, at that cosine, `eta` the index behind over that before it.
pub fn reflectance(cos_i: f64, eta: f64) -> f64 {
    todo!()
}
