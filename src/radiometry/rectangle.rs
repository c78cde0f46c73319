//! Rectangles with a corner over the receiver.

use super::Refusal;

/// What a rectangle sends to a receiver under one of its corners.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    /// E/L [sr] on a surface that faces the rectangle's plane.
    pub parallel: f64,
    /// E/L [sr] on a surface across that plane, whose normal runs along the side a.
    pub perpendicular: f64,
    /// Solid angle [sr].
    pub solid_angle: f64,
}

/// Of the rectangle 0 … `a` by 0 … `b` in the plane z = `h`.
///
/// # Errors
/// If any of the lengths is not positive and finite, or less than 10⁻¹⁵⁰ of the largest.
pub fn corner(a: f64, b: f64, h: f64) -> Result<Corner, Refusal> {
    let [a, b, h] = [("a", a), ("b", b), ("h", h)].map(|(place, length)| Refusal::unless_positive(place, length));
    let (a, b, h) = (a?, b?, h?);
    let unit = a.max(b).max(h);
    let [a, b, h] = [("a", a), ("b", b), ("h", h)].map(|(place, length)| Refusal::unless_tiny(place, length, unit));
    let (a, b, h) = (a?, b?, h?);
    let (along, across) = (a.hypot(h), b.hypot(h));
    // along − h, without the difference.
    let rise = a * a / (along + h);
    Ok(Corner {
        parallel: 0.5 * (a / along * (b / along).atan() + b / across * (a / across).atan()),
        perpendicular: 0.5 * ((b * rise).atan2(h * along + b * b) + rise / along * (b / along).atan()),
        solid_angle: (a * b).atan2(h * along.hypot(b)),
    })
}
