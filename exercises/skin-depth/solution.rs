/// Depth [m] at which the field in a metal of conductivity `sigma` [S/m] has fallen to 1/e, at `frequency` [Hz].
pub fn skin_depth(frequency: f64, sigma: f64) -> f64 {
    const MU_0: f64 = 1.256_637_061_27e-6;
    let omega = std::f64::consts::TAU * frequency;
    (2.0 / (omega * MU_0 * sigma)).sqrt()
}
