/// Depth [m] at which the field in a metal of conductivity `sigma` [S/m] has fallen to 1/e, at `frequency` [Hz].
pub fn skin_depth(frequency: f64, sigma: f64) -> f64 {
    todo!()
}
