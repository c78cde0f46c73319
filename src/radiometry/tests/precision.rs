//! Within 4 ulp · (1 + condition) of arbitrary precision, a polygon within that for each of its edges.

use crate::radiometry::disc::Disc;
use crate::radiometry::sphere::Sphere;
use crate::radiometry::{form_factor, point, polygon, rectangle, solid_angle};
use crate::references::radiometry as exact;
use exact::Exact;
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI};

const LIMIT: f64 = 4.0;

/// A size from 10⁻⁶ to 10⁶.
fn size() -> impl Strategy<Value = f64> {
    (-6.0..6.0).prop_map(|power| 10f64.powf(power))
}

/// A share, most often a very small one.
fn share() -> impl Strategy<Value = f64> {
    (-12.0..0.0).prop_map(|power| 10f64.powf(power))
}

/// An angle from 0 to π, often next to a right angle or an end.
fn angle() -> impl Strategy<Value = f64> {
    let near = (prop_oneof![Just(0.0), Just(FRAC_PI_2), Just(PI)], share(), any::<bool>());
    let near = near.prop_map(|(at, off, more)| (if more { at + off } else { at - off }).clamp(0.0, PI));
    prop_oneof![0.0..PI, near, Just(0.0), Just(FRAC_PI_2), Just(PI)]
}

fn holds(exact: &Exact, ours: f64, edges: usize) -> Result<(), TestCaseError> {
    let error = exact.error_of(ours);
    prop_assert!(error <= LIMIT * edges as f64, "{ours:e} is off by {error:e} ulp · (1 + {:e})", exact.condition);
    Ok(())
}

/// Where along the x axis the disc's centre lies.
fn disc() -> impl Strategy<Value = Disc> {
    let offset = prop_oneof![Just(0.0), share().prop_map(|off| 1.0 - off), share().prop_map(|off| 1.0 + off), size()];
    let tilt = prop_oneof![
        angle().prop_map(Ok),
        // Off the angle at which the horizon touches a rim.
        (any::<bool>(), share(), any::<bool>()).prop_map(Err),
    ];
    (size(), offset, any::<bool>(), tilt, any::<bool>()).prop_map(|(radius, offset, is_left, tilt, is_back)| {
        let offset = if is_left { -offset } else { offset } * radius;
        let tilt: f64 = tilt.unwrap_or_else(|(is_high, off, is_more)| {
            let rim = if is_high { offset + radius } else { offset - radius };
            let touching = FRAC_PI_2 + rim.atan();
            (touching * if is_more { 1.0 + off } else { 1.0 - off }).clamp(0.0, PI)
        });
        Disc { radius, height: 1.0, offset, tilt: if is_back { -tilt } else { tilt } }
    })
}

/// A star of corners about a centre: simple, hardly ever convex. In a plane across an axis, so that it is plane exactly.
fn star() -> impl Strategy<Value = Vec<[f64; 3]>> {
    let radii = prop::collection::vec((0.05..1.0, 0.1..0.9), 3..8);
    let centre = prop_oneof![Just([0.0; 2]), [-1.0..1.0, -1.0..1.0]];
    (radii, size(), centre, prop_oneof![Just(1.0), share()], any::<bool>(), 0..3_usize).prop_map(
        |(radii, size, [x, y], height, is_far, axis)| {
            let count = radii.len() as f64;
            let unit = if is_far { 1.0 } else { size };
            let corner = |(at, (radius, turn)): (usize, &(f64, f64))| {
                let (sin, cos) = ((at as f64 + turn) * 2.0 * PI / count).sin_cos();
                let place = [unit * x + size * radius * cos, unit * y + size * radius * sin, height * unit];
                std::array::from_fn(|component| place[(component + axis) % 3])
            };
            radii.iter().enumerate().map(corner).collect()
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    #[test]
    fn discs(disc in disc()) {
        let Disc { radius, height, offset, tilt } = disc;
        holds(&exact::disc(radius, height, offset, tilt), disc.irradiance().unwrap(), 1)?;
    }

    #[test]
    fn spheres(far in prop_oneof![size(), share()], omega in angle(), cut in prop_oneof![Just(None), share().prop_map(Some)]) {
        let distance = 1.0 + far;
        // Near where it sets.
        let omega = cut.map_or(omega, |cut| (FRAC_PI_2 + (1.0 / distance).asin()) * (1.0 - cut));
        let sphere = Sphere { radius: 1.0, distance, omega };
        holds(&exact::sphere(1.0, distance, omega), sphere.irradiance().unwrap(), 1)?;
    }

    #[test]
    fn rectangles(a in size(), b in size(), h in size()) {
        let found = rectangle::corner(a, b, h).unwrap();
        for (exact, ours) in exact::corner(a, b, h).iter().zip([found.parallel, found.perpendicular, found.solid_angle]) {
            holds(exact, ours, 1)?;
        }
    }

    #[test]
    fn form_factors(a in size(), b in size(), c in size()) {
        holds(&exact::parallel_rectangles(a, b, c), form_factor::parallel_rectangles(a, b, c).unwrap(), 1)?;
        holds(&exact::perpendicular_rectangles(a, b, c), form_factor::perpendicular_rectangles(a, b, c).unwrap(), 1)?;
        holds(&exact::coaxial_discs(a, b, c), form_factor::coaxial_discs(a, b, c).unwrap(), 1)?;
    }

    #[test]
    fn solid_angles_and_points(a in size(), b in size(), angle in angle()) {
        holds(&exact::cone(angle), solid_angle::cone(angle), 1)?;
        holds(&exact::solid_angle_of_disc(a, b), solid_angle::disc(a, b), 1)?;
        holds(&exact::point(a, b, angle), point(a, b, angle).unwrap(), 1)?;
    }

    #[test]
    fn triangles(centre in [-1.0..1.0, -1.0..1.0, -1.0..1.0], sides in prop::array::uniform9(-1.0..1.0), size in size()) {
        let corner = |at: usize| std::array::from_fn(|axis| centre[axis] + size * sides[3 * at + axis]);
        let corners: [[f64; 3]; 3] = std::array::from_fn(corner);
        let [a, b, c] = corners;
        holds(&exact::triangle(corners), solid_angle::triangle(a, b, c).abs(), 1)?;
    }

    #[test]
    fn polygons(corners in star(), normal in [-1.0..1.0, -1.0..1.0, -1.0..1.0], level in prop_oneof![Just(None), share().prop_map(Some)]) {
        // Sometimes nearly across the way to the first corner, which then is nearly on the horizon.
        let normal = level.map_or(normal, |level| {
            let first = corners[0];
            let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
            let along = dot(normal, first) / dot(first, first) * (1.0 - level);
            std::array::from_fn(|axis| normal[axis] - along * first[axis])
        });
        holds(&exact::polygon(&corners, normal), polygon::irradiance(&corners, normal).unwrap(), corners.len())?;
    }
}

#[test]
fn hard_discs() {
    for (radius, offset, tilt) in [
        (1e6, 0.0, 3.0),
        (1e6, 0.0, PI - 1e-5),
        (384_403.0, -2.137, 2.6e-6),
        (4095.3, 3670.0, 0.00235),
        (1e-6, 1.0, FRAC_PI_2 + std::f64::consts::FRAC_PI_4),
        (1.0, 1.0, FRAC_PI_2),
        (1.0, 0.0, 0.75 * PI - 1e-9),
        (1e-12, 0.0, FRAC_PI_2),
    ] {
        let disc = Disc { radius, height: 1.0, offset, tilt };
        let error = exact::disc(radius, 1.0, offset, tilt).error_of(disc.irradiance().unwrap());
        assert!(error <= LIMIT, "{disc:?}: {error:e}");
    }
}

#[test]
fn spheres_that_all_but_touch_and_set() {
    for near in [1e-3, 1e-6, 1e-9, 1e-12, f64::EPSILON] {
        for low in [0.1, 1e-2, 1e-4, 1e-6, 0.0] {
            let (distance, omega) = (1.0 + near, PI - low);
            let sphere = Sphere { radius: 1.0, distance, omega };
            let error = exact::sphere(1.0, distance, omega).error_of(sphere.irradiance().unwrap());
            assert!(error <= LIMIT, "{sphere:?}: {error:e}");
        }
    }
}

#[test]
fn form_factors_of_slivers() {
    for [a, b, c] in
        [[1e-6, 1e6, 1.0], [1e6, 1e-6, 1.0], [1e-6, 1e-6, 1e6], [1e6, 1e6, 1e-6], [1e-6, 1.0, 1e6], [1.0, 1e6, 1e-6]]
    {
        let parallel = form_factor::parallel_rectangles(a, b, c).unwrap();
        let upright = form_factor::perpendicular_rectangles(a, b, c).unwrap();
        let discs = form_factor::coaxial_discs(a, b, c).unwrap();
        let errors = [
            exact::parallel_rectangles(a, b, c).error_of(parallel),
            exact::perpendicular_rectangles(a, b, c).error_of(upright),
            exact::coaxial_discs(a, b, c).error_of(discs),
        ];
        assert!(errors.iter().all(|&error| error <= LIMIT), "{a} {b} {c}: {errors:?}");
    }
}

/// Teeth of a comb that hang into view: a polygon that the horizon cuts into three, each as high as `seen`.
pub(super) fn comb(seen: f64) -> Vec<[f64; 3]> {
    let outline = [
        (-1.0, -0.5),
        (1.0, -0.5),
        (1.0, seen),
        (0.7, seen),
        (0.7, -0.25),
        (0.2, -0.25),
        (0.2, seen),
        (-0.2, seen),
        (-0.2, -0.25),
        (-0.7, -0.25),
        (-0.7, seen),
        (-1.0, seen),
    ];
    outline.map(|(y, z)| [1.0, y, z]).to_vec()
}

#[test]
fn combs_that_barely_rise_over_the_horizon() {
    for power in [0, 1, 2, 4, 6, 7, 8, 10, 12, 15, 50] {
        let corners = comb(10f64.powi(-power));
        let normal = [0.0, 0.0, 1.0];
        let error = exact::polygon(&corners, normal).error_of(polygon::irradiance(&corners, normal).unwrap());
        assert!(error <= LIMIT * corners.len() as f64, "1e-{power}: {error:e}");
    }
}

#[test]
fn no_unit_of_length_leaves_the_range() {
    for unit in [1e-150, 1e-60, 1.0, 1e60, 1e150] {
        let disc = |unit: f64| Disc { radius: 0.5 * unit, height: unit, offset: 0.3 * unit, tilt: 1.2 };
        let sphere = |unit: f64| Sphere { radius: 0.5 * unit, distance: unit, omega: 1.4 };
        let square = |unit: f64| [[-unit, -unit, unit], [unit, -unit, unit], [unit, unit, unit], [-unit, unit, unit]];
        let close = |ours: f64, at_one: f64| assert!((ours / at_one - 1.0).abs() <= 1e-14, "{unit:e}: {ours} {at_one}");
        close(disc(unit).irradiance().unwrap(), disc(1.0).irradiance().unwrap());
        close(sphere(unit).irradiance().unwrap(), sphere(1.0).irradiance().unwrap());
        let seen = |unit: f64| polygon::irradiance(&square(unit), [0.4 * unit, 0.0, unit]).unwrap();
        close(seen(unit), seen(1.0));
        let [a, b, c, _] = square(unit);
        close(solid_angle::triangle(a, b, c).abs(), std::f64::consts::PI / 3.0);
        close(polygon::edges(&square(unit))[0][2].abs(), polygon::edges(&square(1.0))[0][2].abs());
        let corner = |unit: f64| rectangle::corner(unit, 2.0 * unit, 0.7 * unit).unwrap();
        close(corner(unit).parallel, corner(1.0).parallel);
        close(corner(unit).perpendicular, corner(1.0).perpendicular);
    }
}
