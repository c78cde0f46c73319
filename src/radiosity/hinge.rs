//! Two rectangles that share an edge, at any angle.

use std::f64::consts::{FRAC_1_PI, FRAC_PI_2, PI};
use yardstick::quadrature::gauss_legendre;

/// F [1] from a rectangle to another at its edge: their widths over the edge's length, and the angle [rad] between them, 0 < φ < π
/// (A. Feingold, *Radiant-interchange configuration factors between various selected plane surfaces*, Proc. R. Soc. A 292 (1966)
/// 51; J. R. Howell, *A Catalog of Radiation Heat Transfer Configuration Factors*, C-16). One integral of a smooth function is
/// left, here by 48 points of Gauss; terms cancel where the angle or a width is small.
pub fn factor(width: f64, other: f64, angle: f64) -> f64 {
    let (a, b) = (other, width);
    let (sin, cos) = angle.sin_cos();
    let (sin_twice, cos_twice) = (2.0 * angle).sin_cos();
    let (a2, b2) = (a * a, b * b);
    let c = a2 + b2 - 2.0 * a * b * cos;
    let d = (1.0 + a2 * sin * sin).sqrt();
    let angles = a * b * sin
        + (FRAC_PI_2 - angle) * (a2 + b2)
        + b2 * ((a - b * cos) / (b * sin)).atan()
        + a2 * ((b - a * cos) / (a * sin)).atan();
    let logarithms = (2.0 / (sin * sin) - 1.0) * ((1.0 + a2) * (1.0 + b2) / (1.0 + c)).ln()
        + b2 * (b2 * (1.0 + c) / (c * (1.0 + b2))).ln()
        + a2 * (a2 * (1.0 + a2).powf(cos_twice) / (c * (1.0 + c).powf(cos_twice))).ln();
    let inside = |z: f64| {
        let root = (1.0 + z * z * sin * sin).sqrt();
        root * ((z * cos / root).atan() + ((a - z * cos) / root).atan())
    };
    let integral: f64 = gauss_legendre(48).iter().map(|(at, weight)| weight * inside(b * at)).sum();
    let ends = (1.0 / b).atan() + a / b * (1.0 / a).atan() - c.sqrt() / b * (1.0 / c.sqrt()).atan();
    let middle = sin * sin_twice / (2.0 * PI * b) * a * d * ((a * cos / d).atan() + ((b - a * cos) / d).atan());
    -sin_twice / (4.0 * PI * b) * angles
        + sin * sin / (4.0 * PI * b) * logarithms
        + FRAC_1_PI * ends
        + middle
        + cos * FRAC_1_PI * integral
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::radiometry::form_factor;

    #[test]
    fn at_a_right_angle_it_is_the_closed_form_and_of_long_plates_hottels() {
        for (width, other) in [(1.0, 1.0), (0.5, 2.0), (3.0, 0.7)] {
            let exact = form_factor::perpendicular_rectangles(width, other, 1.0).expect("a case");
            assert!((factor(width, other, FRAC_PI_2) - exact).abs() < 1e-14);
        }
        // Of plates without end strings tell: 1 − sin φ/2 (H. C. Hottel); the ends are missed as the width, up to its logarithm.
        for angle in [0.5, 1.0, 2.0] {
            let long = factor(1e-4, 1e-4, angle);
            assert!((long - (1.0 - (0.5 * angle).sin())).abs() < 1e-3, "{angle}: {long}");
        }
        // The same both ways, but for areas.
        assert!((0.7 * factor(0.7, 1.3, 2.2) - 1.3 * factor(1.3, 0.7, 2.2)).abs() < 1e-14);
    }
}
