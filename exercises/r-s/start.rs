/// Reflected over incident electric field [1] of an s wave, at an angle of incidence [rad] and indices on both sides [1].
pub fn r_s(theta_i: f64, n_i: f64, n_t: f64) -> f64 {
    todo!()
}
