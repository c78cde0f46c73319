/// Share [1] of all directions with a polar angle between `from` and `to` [rad].
pub fn share(from: f64, to: f64) -> f64 {
    0.5 * (from.cos() - to.cos())
}
