/// Sine [1] of the angle of refraction, of an angle of incidence [rad] and the indices on both sides [1].
pub fn refracted_sine(theta_i: f64, n_i: f64, n_t: f64) -> f64 {
    todo!()
}
