//! Solid angles, without the differences in which narrow ones lose their digits.

use super::polygon::vector::{Vector, cross, dot, in_unit, minus};
use std::f64::consts::TAU;

/// Of a cone of half-angle `alpha` [rad], 0 … π: 2π(1 − cos α) [sr].
pub fn cone(alpha: f64) -> f64 {
    2.0 * TAU * (0.5 * alpha).sin().powi(2)
}

/// Of a disc of `radius` from its axis, `distance` away [sr]: 2π(1 − cos ψ), tan ψ = radius/distance.
pub fn disc(radius: f64, distance: f64) -> f64 {
    let slant = radius.hypot(distance);
    TAU * (radius / slant) * (radius / (slant + distance))
}

/// Of a triangle of corners `a`, `b`, `c` seen from the origin [sr]: positive if they run counter-clockwise as seen from
/// there, negative otherwise (A. Van Oosterom and J. Strackee, *IEEE Trans. Biomed. Eng.* BME-30 (1983) 125). The triple
/// product is taken of edges, which keeps the digits of far and of small ones.
pub fn triangle(a: Vector, b: Vector, c: Vector) -> f64 {
    let corners = in_unit(&[a, b, c]);
    let (a, b, c) = (corners[0], corners[1], corners[2]);
    let volume = dot(a, cross(minus(b, a), minus(c, a)));
    let [la, lb, lc] = [a, b, c].map(|corner| dot(corner, corner).sqrt());
    let below = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
    -2.0 * volume.atan2(below)
}
