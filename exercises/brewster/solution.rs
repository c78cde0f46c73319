/// Angle of incidence [rad] at which no p light is reflected, by the indices on both sides [1].
pub fn brewster_angle(n_i: f64, n_t: f64) -> f64 {
    (n_t / n_i).atan()
}
