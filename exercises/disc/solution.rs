/// Irradiance over radiance [sr] below the middle of a level disc of `radius` [m] at `height` [m].
pub fn irradiance(radius: f64, height: f64) -> f64 {
    std::f64::consts::PI * radius * radius / (radius * radius + height * height)
}
