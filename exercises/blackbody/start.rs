/// Spectral radiance [W m⁻³ sr⁻¹] of a black body at a wavelength [m] and a temperature [K].
pub fn radiance(wavelength: f64, temperature: f64) -> f64 {
    todo!()
}
