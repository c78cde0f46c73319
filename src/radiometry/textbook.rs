//! The closed forms as textbooks print them, digits lost and all.

use std::f64::consts::{PI, TAU};

/// Solid angle [sr] of a disc of `radius` on the axis, `distance` away: 2π(1 − cos ψ).
pub fn solid_angle_of_disc(radius: f64, distance: f64) -> f64 {
    TAU * (1.0 - distance / (distance * distance + radius * radius).sqrt())
}

/// E/L [sr] of a disc parallel to the receiver, `offset` from its axis (P. Foote, *Bull. Bureau of Standards* 12 (1915)
/// 583; Howell B-12).
pub fn disc(radius: f64, height: f64, offset: f64) -> f64 {
    let (h, r, a) = (height * height, radius * radius, offset * offset);
    let sum = h + a + r;
    0.5 * PI * (1.0 - (h + a - r) / (sum * sum - 4.0 * a * r).sqrt())
}

/// E/L [sr] of the rectangle 0 … a by 0 … b at height h, on a receiver across its plane: Howell B-4.
pub fn perpendicular_corner(a: f64, b: f64, h: f64) -> f64 {
    let along = (a * a + h * h).sqrt();
    0.5 * ((b / h).atan() - h / along * (b / along).atan())
}

/// E/L [sr] of a sphere that the horizon cuts (S. Lagarde and C. de Rousiers, *Moving Frostbite to PBR*, 2014, listing 7).
pub fn sphere(radius: f64, distance: f64, omega: f64) -> f64 {
    let (cos, sin) = (omega.cos(), omega.sin());
    let h = distance / radius;
    let square = h * h;
    if cos * cos > 1.0 / square {
        return PI / square * cos.clamp(0.0, 1.0);
    }
    let x = (square - 1.0).sqrt();
    let y = -x * (cos / sin);
    let root = sin * (1.0 - y * y).sqrt();
    (cos * y.acos() - x * root) / square + (root / x).atan()
}

/// E/L [sr] of a polygon wholly above the horizon, by Lambert's sum (*Photometria*, 1760, §§180–186) with the edges'
/// angles from arc cosines.
pub fn polygon(corners: &[[f64; 3]], normal: [f64; 3]) -> f64 {
    use super::polygon::vector::{cross, dot};
    let edge = |at: usize| {
        let (a, b) = (corners[at], corners[(at + 1) % corners.len()]);
        let across = cross(a, b);
        let angle = (dot(a, b) / (dot(a, a) * dot(b, b)).sqrt()).acos();
        angle * dot(across, normal) / dot(across, across).sqrt()
    };
    (0.5 * (0..corners.len()).map(edge).sum::<f64>()).abs()
}

/// Form factor [1] of two rectangles a × b that face each other at a distance c: Howell C-11.
pub fn parallel_rectangles(a: f64, b: f64, c: f64) -> f64 {
    let (x, y) = (a / c, b / c);
    let (u, v) = ((1.0 + x * x).sqrt(), (1.0 + y * y).sqrt());
    let log = ((1.0 + x * x) * (1.0 + y * y) / (1.0 + x * x + y * y)).sqrt().ln();
    2.0 / (PI * x * y) * (log + x * v * (x / v).atan() + y * u * (y / u).atan() - x * x.atan() - y * y.atan())
}

/// Form factor [1] from a rectangle w × l to one of h × l at a right angle: Howell C-14.
pub fn perpendicular_rectangles(w: f64, h: f64, l: f64) -> f64 {
    let (w, h) = (w / l, h / l);
    let (w2, h2) = (w * w, h * h);
    let slant = (w2 + h2).sqrt();
    let product = (1.0 + w2) * (1.0 + h2) / (1.0 + w2 + h2)
        * (w2 * (1.0 + w2 + h2) / ((1.0 + w2) * (w2 + h2))).powf(w2)
        * (h2 * (1.0 + h2 + w2) / ((1.0 + h2) * (h2 + w2))).powf(h2);
    (w * (1.0 / w).atan() + h * (1.0 / h).atan() - slant * (1.0 / slant).atan() + 0.25 * product.ln()) / (PI * w)
}

/// Form factor [1] from a disc of radius r₁ to one of r₂ on the same axis: Howell C-41.
pub fn coaxial_discs(r1: f64, r2: f64, h: f64) -> f64 {
    let (x, y) = (r1 / h, r2 / h);
    let z = 1.0 + (1.0 + y * y) / (x * x);
    0.5 * (z - (z * z - 4.0 * (y / x).powi(2)).sqrt())
}
