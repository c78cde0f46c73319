/// The phase [rad] by which a wave of `k` radians a cell turns in one step, at the Courant number `courant` [1].
pub fn phase_per_step(k: f64, courant: f64) -> f64 {
    2.0 * (courant * (0.5 * k).sin()).asin()
}
