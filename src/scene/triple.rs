//! What is reckoned with points and directions here.

use super::Triple;

pub(crate) fn plus(a: Triple, b: Triple) -> Triple {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(crate) fn minus(a: Triple, b: Triple) -> Triple {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(crate) fn times(a: Triple, factor: f64) -> Triple {
    a.map(|x| x * factor)
}

pub(crate) fn dot(a: Triple, b: Triple) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: Triple, b: Triple) -> Triple {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(crate) fn length(a: Triple) -> f64 {
    dot(a, a).sqrt()
}

/// Of length 1; not a number if null.
pub(crate) fn normalised(a: Triple) -> Triple {
    times(a, 1.0 / length(a))
}

/// The largest component's size.
pub(crate) fn largest(a: Triple) -> f64 {
    a.into_iter().map(f64::abs).fold(0.0, f64::max)
}

/// In twice the precision.
pub(crate) fn widened(a: [f32; 3]) -> Triple {
    a.map(f64::from)
}
