//! What must hold among the forms, and what others have published.

use super::precision::comb;
use crate::radiometry::disc::Disc;
use crate::radiometry::form_factor::{coaxial_discs, parallel_rectangles, perpendicular_rectangles};
use crate::radiometry::polygon::{self, vector::Vector, vector::dot};
use crate::radiometry::rectangle::corner;
use crate::radiometry::solid_angle;
use crate::radiometry::sphere::Sphere;
use proptest::prelude::*;
use std::f64::consts::PI;
use yardstick::quadrature::gauss_legendre;

const UP: Vector = [0.0, 0.0, 1.0];

fn size() -> impl Strategy<Value = f64> {
    (-3.0..3.0).prop_map(|power| 10f64.powf(power))
}

/// Rounding in both of two routes, each within 4 ulp · (1 + condition) of some ten.
const ROUNDING: f64 = 100.0 * f64::EPSILON;

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= ROUNDING * a.abs().max(b.abs())
}

/// ∫ (n·r)⁺ (m·r)/r⁴ dA over the parallelogram `at` + s·`u` + t·`v`, whose unit normal is m, by a product of Gauss's rules.
fn by_area(at: Vector, u: Vector, v: Vector, normal: Vector) -> f64 {
    let rule = gauss_legendre(40);
    let area = polygon::vector::cross(u, v);
    let mut sum = 0.0;
    for (s, p) in &rule {
        for (t, q) in &rule {
            let r: Vector = std::array::from_fn(|axis| at[axis] + s * u[axis] + t * v[axis]);
            sum += p * q * dot(normal, r).max(0.0) * dot(area, r).abs() / dot(r, r).powi(2);
        }
    }
    sum
}

proptest! {
    #[test]
    fn a_rectangle_is_a_polygon(a in size(), b in size()) {
        let corners = [[0.0, 0.0, 1.0], [a, 0.0, 1.0], [a, b, 1.0], [0.0, b, 1.0]];
        let found = corner(a, b, 1.0).unwrap();
        prop_assert!(close(found.parallel, polygon::irradiance(&corners, UP).unwrap()));
        prop_assert!(close(found.perpendicular, polygon::irradiance(&corners, [1.0, 0.0, 0.0]).unwrap()));
        let [p, q, r, s] = corners;
        let halves = solid_angle::triangle(p, q, r) + solid_angle::triangle(p, r, s);
        prop_assert!(close(found.solid_angle, halves.abs()), "{found:?} {halves}");
    }

    #[test]
    fn a_polygon_is_its_area_s_integral(
        x in -1.0..1.0, y in -1.0..1.0, z in 1.5..3.0, u in [-0.5..0.5, 0.4..1.0, -0.3..0.3], v in [0.4..1.0, -0.3..0.3, -0.3..0.3],
    ) {
        let at: Vector = [x, y, z];
        let corner = |s: f64, t: f64| std::array::from_fn(|axis| at[axis] + s * u[axis] + t * v[axis]);
        let corners = [corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0)];
        let expected = by_area(at, u, v, UP);
        let found = polygon::irradiance(&corners, UP).unwrap();
        // The integrand's singularity is at least 0.9 away from parameters of 0 … 1: 80 digits of ρ > 2 each.
        prop_assert!((found - expected).abs() <= 1e-10 * expected.max(1e-3), "{found} {expected}");
    }

    #[test]
    fn neither_sense_nor_first_corner_nor_length_of_the_normal_matters(
        seen in 0.01..1.0, first in 0..12_usize, power in -9..9_i32, lean in -1.0..1.0,
    ) {
        // A power of two, which rounds nothing: on the horizon the normal's last digit counts.
        let factor = 2_f64.powi(power);
        let corners = comb(seen);
        let here = polygon::irradiance(&corners, [lean, 0.2, 1.0]).unwrap();
        let mut turned = corners.clone();
        turned.rotate_left(first);
        prop_assert!(close(here, polygon::irradiance(&turned, [lean, 0.2, 1.0]).unwrap()));
        turned.reverse();
        prop_assert!(close(here, polygon::irradiance(&turned, [factor * lean, factor * 0.2, factor]).unwrap()));
    }

    #[test]
    fn pieces_add_up(seen in 0.01..1.0, lean in 0.0..1.0) {
        let normal = [lean, 0.1, 1.0];
        let piece = |y: (f64, f64), z: (f64, f64)| {
            let corners = [[1.0, y.0, z.0], [1.0, y.1, z.0], [1.0, y.1, z.1], [1.0, y.0, z.1]];
            polygon::irradiance(&corners, normal).unwrap()
        };
        let parts = piece((-1.0, 1.0), (-0.5, -0.25))
            + [(-1.0, -0.7), (-0.2, 0.2), (0.7, 1.0)].map(|y| piece(y, (-0.25, seen))).iter().sum::<f64>();
        prop_assert!(close(parts, polygon::irradiance(&comb(seen), normal).unwrap()));
    }

    #[test]
    fn what_one_gives_the_other_takes(a in size(), b in size(), c in size()) {
        // A₁ F₁₂ = A₂ F₂₁
        let (there, back) = (perpendicular_rectangles(a, b, c).unwrap(), perpendicular_rectangles(b, a, c).unwrap());
        prop_assert!(close(a * there, b * back));
        let (there, back) = (coaxial_discs(a, b, c).unwrap(), coaxial_discs(b, a, c).unwrap());
        prop_assert!(close(a * a * there, b * b * back));
    }

    #[test]
    fn from_within_a_box_all_is_seen(a in size(), b in size(), c in size()) {
        let sides = perpendicular_rectangles(a, c, b).unwrap() + perpendicular_rectangles(b, c, a).unwrap();
        let sum = parallel_rectangles(a, b, c).unwrap() + 2.0 * sides;
        prop_assert!((sum - 1.0).abs() <= ROUNDING, "{sum}");
    }

    #[test]
    fn a_sphere_is_the_disc_where_its_tangents_end(distance in 1.001..100.0, omega in 0.0..PI) {
        let (sin, cos) = (1.0 / distance, f64::sqrt((distance - 1.0) * (distance + 1.0)) / distance);
        let sphere = Sphere { radius: 1.0, distance, omega }.irradiance().unwrap();
        let disc = Disc { radius: sin, height: cos, offset: 0.0, tilt: omega }.irradiance().unwrap();
        // Near its setting both follow the angle's rounding.
        prop_assert!((sphere - disc).abs() <= 1e-11 * sphere.max(1e-6), "{sphere} {disc}");
    }
}

#[test]
fn a_disc_is_the_limit_of_polygons() {
    let disc = Disc { radius: 1.0, height: 0.7, offset: 0.6, tilt: 1.1 };
    let error = |count: usize| {
        let corner = |at: usize| {
            let (sin, cos) = ((at as f64 + 0.5) * 2.0 * PI / count as f64).sin_cos();
            [disc.offset + disc.radius * cos, disc.radius * sin, disc.height]
        };
        let corners: Vec<Vector> = (0..count).map(corner).collect();
        let (sin, cos) = disc.tilt.sin_cos();
        disc.irradiance().unwrap() - polygon::irradiance(&corners, [sin, 0.0, cos]).unwrap()
    };
    // A chord cuts off its angle's square.
    let (coarse, fine) = (error(200), error(400));
    assert!(fine > 0.0 && fine < 1e-3 && (coarse / fine - 4.0).abs() < 0.05, "{coarse:e} {fine:e}");
}

#[test]
fn the_horizon_takes_nothing_at_once() {
    let disc = |tilt: f64| Disc { radius: 1.0, height: 1.0, offset: 0.4, tilt }.irradiance().unwrap();
    let sphere = |omega: f64| Sphere { radius: 1.0, distance: 2.0, omega }.irradiance().unwrap();
    let rims = [(0.4_f64 - 1.0).atan() + 0.5 * PI, 1.4_f64.atan() + 0.5 * PI];
    let setting = [PI / 3.0, 2.0 * PI / 3.0, PI / 2.0];
    let step = 1e-9;
    for at in rims {
        assert!((disc(at + step) - disc(at - step)).abs() <= 2.0 * PI * step);
    }
    for at in setting {
        assert!((sphere(at + step) - sphere(at - step)).abs() <= 2.0 * PI * step);
    }
    assert_eq!((disc(rims[1] + step), sphere(setting[1] + step)), (0.0, 0.0));
}

#[test]
fn edge_on_there_is_nothing() {
    let square = [[1.0, -1.0, 0.0], [3.0, -1.0, 0.0], [3.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
    let shifted = |x: f64| square.map(|[a, b, c]| [a - x, b, c]);
    // Beside it, on an edge, within; seen from a surface in its plane and from one across.
    for x in [0.0, 1.0, 2.0] {
        for normal in [UP, [1.0, 0.0, 0.0], [0.3, -0.2, 1.0]] {
            assert_eq!(polygon::irradiance(&shifted(x), normal), Ok(0.0));
        }
    }
    // In a plane across no axis, where rounding does not leave 0 by itself.
    let (u, v): (Vector, Vector) = ([0.1, 0.7, 0.3], [0.5, -0.2, 0.9]);
    let twice = |u: Vector| u.map(|x| 2.0 * x);
    for corners in [vec![u, twice(u), v], vec![u, twice(u), twice(v), v], vec![u, v, twice(v).map(|x| -x)]] {
        assert_eq!(polygon::irradiance(&corners, UP), Ok(0.0));
    }
    assert_eq!(polygon::irradiance(&[[0.0; 3], [0.1, 0.7, 0.3], [0.2, -0.4, 0.9]], UP), Ok(0.0));
    // Yet from as close as one likes it fills the sky.
    let over = square.map(|[a, b, _]| [a - 2.0, b, 1e-300]);
    assert!((polygon::irradiance(&over, UP).unwrap() - PI).abs() <= 4.0 * f64::EPSILON);
    // Under its edge, half of it.
    let edge = square.map(|[a, b, _]| [a - 1.0, b, 1e-300]);
    assert!((polygon::irradiance(&edge, UP).unwrap() - 0.5 * PI).abs() <= 4.0 * f64::EPSILON);
}

#[test]
fn edges_add_up_to_the_irradiance() {
    let corners = [[-0.5, 0.3, 0.9], [0.7, -0.2, 0.9], [0.9, 0.8, 0.9], [-0.1, 1.1, 0.9]];
    let normal = [0.0, 0.6, 0.8];
    let sum: f64 = polygon::edges(&corners).iter().map(|edge| dot(*edge, normal)).sum();
    assert!(close(sum.abs(), polygon::irradiance(&corners, normal).unwrap()));
    assert_eq!(polygon::edges(&[[0.0, 0.0, 1.0], [0.0, 0.0, 2.0], [1.0, 0.0, 1.0]])[0], [0.0; 3]);
}

#[test]
fn published_values() {
    // J. R. Howell, A Catalog of Radiation Heat Transfer Configuration Factors, tables of C-11 and C-14: the cube's faces; C-41
    // and B-12 by their formulas for r₁ = r₂ = h.
    let cases = [
        (parallel_rectangles(1.0, 1.0, 1.0).unwrap(), 0.199_825, 5e-7),
        (perpendicular_rectangles(1.0, 1.0, 1.0).unwrap(), 0.200_044, 5e-7),
        (coaxial_discs(1.0, 1.0, 1.0).unwrap(), 0.5 * (3.0 - 5_f64.sqrt()), 1e-15),
        (Disc { radius: 1.0, height: 1.0, offset: 0.0, tilt: 0.0 }.irradiance().unwrap(), 0.5 * PI, 1e-15),
        (
            Disc { radius: 1.0, height: 1.0, offset: 1.0, tilt: 0.0 }.irradiance().unwrap(),
            0.5 * PI * (1.0 - 0.2_f64.sqrt()),
            1e-15,
        ),
    ];
    for (at, (found, published, digits)) in cases.into_iter().enumerate() {
        assert!((found - published).abs() <= digits, "{at}: {found} {published}");
    }
}
