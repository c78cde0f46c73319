/// Wavelength [m] of a wave of angular frequency `omega` [rad/s] in a clear medium of `epsilon_r` and `mu_r` [1].
pub fn wavelength(omega: f64, epsilon_r: f64, mu_r: f64) -> f64 {
    todo!()
}
