/// Relative permittivity [1] of a block of grains that point everywhere, from that along a grain's axes [1].
pub fn permittivity(eps_x: f64, eps_y: f64, eps_z: f64) -> f64 {
    todo!()
}
