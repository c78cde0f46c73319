/// Relative standard deviation [1] of one path, where walls absorb that share and chance ends a path with that probability.
pub fn scatter(absorbed: f64, ended: f64) -> f64 {
    todo!()
}
