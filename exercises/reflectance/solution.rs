/// Reflected share [1] of natural light at a clear interface, at that cosine, `eta` the index behind over that before it.
pub fn reflectance(cos_i: f64, eta: f64) -> f64 {
    // η² − 1, and the square of what the refracted ray has along the normal, without a difference of numbers near 1.
    let contrast = (eta - 1.0) * (eta + 1.0);
    let square = contrast + cos_i * cos_i;
    if square <= 0.0 {
        return 1.0;
    }
    let q = square.sqrt();
    let eta2 = eta * eta;
    // (c − q)/(c + q) and (η²c − q)/(η²c + q), their numerators multiplied out by their denominators.
    let s = contrast / (cos_i + q).powi(2);
    let p = contrast * ((eta2 + 1.0) * cos_i * cos_i - 1.0) / (eta2 * cos_i + q).powi(2);
    0.5 * (s * s + p * p)
}
