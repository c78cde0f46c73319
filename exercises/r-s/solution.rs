/// Reflected over incident electric field [1] of an s wave, at an angle of incidence [rad] and indices on both sides [1].
pub fn r_s(theta_i: f64, n_i: f64, n_t: f64) -> f64 {
    let sin_t = n_i * theta_i.sin() / n_t;
    let (cos_i, cos_t) = (theta_i.cos(), (1.0 - sin_t * sin_t).sqrt());
    (n_i * cos_i - n_t * cos_t) / (n_i * cos_i + n_t * cos_t)
}
