/// Mean flow [W/m²] of fields with the phasors E [V/m] and H [A/m] by their real and imaginary parts.
pub fn mean_flow(e_re: f64, e_im: f64, h_re: f64, h_im: f64) -> f64 {
    todo!()
}
