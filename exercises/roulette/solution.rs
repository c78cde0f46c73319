/// Relative standard deviation [1] of one path, where walls absorb that share and chance ends a path with that probability.
pub fn scatter(absorbed: f64, ended: f64) -> f64 {
    let (rho, q) = (1.0 - absorbed, 1.0 - ended);
    rho * (ended / (q - rho * rho)).sqrt()
}
