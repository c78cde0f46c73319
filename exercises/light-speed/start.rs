/// Speed [m/s] of a wave in a medium of permittivity `epsilon` [F/m] and permeability `mu` [H/m].
pub fn speed(epsilon: f64, mu: f64) -> f64 {
    todo!()
}
