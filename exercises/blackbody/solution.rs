/// Spectral radiance [W m⁻³ sr⁻¹] of a black body at a wavelength [m] and a temperature [K].
pub fn radiance(wavelength: f64, temperature: f64) -> f64 {
    const H: f64 = 6.626_070_15e-34;
    const C: f64 = 299_792_458.0;
    const K: f64 = 1.380_649e-23;
    2.0 * H * C * C / wavelength.powi(5) / (H * C / (wavelength * K * temperature)).exp_m1()
}
