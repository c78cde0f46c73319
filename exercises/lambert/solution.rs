/// BRDF [1/sr] of a diffuse surface that returns the share `rho` [1] of what it gets.
pub fn brdf(rho: f64) -> f64 {
    rho / std::f64::consts::PI
}
