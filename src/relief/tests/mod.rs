//! Reliefs against their own definition, against tracing by all triangles, and against Smith where he is right.

mod every_triangle;
mod extremes;
mod scattering;
mod slopes;
mod smith;

use super::Relief;
use yardstick::random::{Stream, stream, uniform};

/// Numbers even in 0 … 1.
fn even(seed: u64, address: &str) -> impl FnMut() -> f64 + use<> {
    let mut stream: Stream = stream(seed, address);
    move || uniform(&mut stream, 0.0, 1.0)
}

/// 128 correlation lengths a side, the least for which the slopes' sample is even enough.
fn gaussian(alpha: f64) -> Relief {
    Relief::gaussian(1024, 8.0, alpha, even(1, "relief/gaussian")).expect("a valid relief")
}

/// The direction at `theta` [rad] from the normal and `phi` around it.
fn towards(theta: f64, phi: f64) -> [f64; 3] {
    let ((sin, cos), (y, x)) = (theta.sin_cos(), phi.sin_cos());
    [sin * x, sin * y, cos]
}

fn dot(one: [f64; 3], other: [f64; 3]) -> f64 {
    one.iter().zip(other).map(|(a, b)| a * b).sum()
}
