mod diffuse;
mod digits;
mod hostile;
mod rough;

use crate::number::Vector;

/// The direction at an angle's cosine and an azimuth [rad]; `cos` may be negative.
fn direction(cos: f64, phi: f64) -> Vector<f64> {
    let sin = ((1.0 - cos) * (1.0 + cos)).sqrt();
    Vector::of([sin * phi.cos(), sin * phi.sin(), cos])
}
