//! What has no answer is refused by name, with what is valid.

use crate::radiometry::disc::Disc;
use crate::radiometry::sphere::Sphere;
use crate::radiometry::{Refusal, form_factor, point, polygon, rectangle};
use proptest::prelude::*;

const SQUARE: [[f64; 3]; 4] = [[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [1.0, 1.0, 1.0], [0.0, 1.0, 1.0]];
const UP: [f64; 3] = [0.0, 0.0, 1.0];

fn refused<T: std::fmt::Debug>(place: &str, found: Result<T, Refusal>) {
    let refusal = found.expect_err(place);
    assert!(refusal.place == place && refusal.to_string().contains("valid"), "{place}: {refusal}");
}

#[test]
fn sizes_and_places() {
    let disc = Disc { radius: 1.0, height: 1.0, offset: 0.0, tilt: 0.0 };
    let sphere = Sphere { radius: 1.0, distance: 2.0, omega: 0.0 };
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        refused("R", Disc { radius: bad, ..disc }.irradiance());
        refused("h", Disc { height: bad, ..disc }.irradiance());
        refused("R", Sphere { radius: bad, ..sphere }.irradiance());
        refused("a", rectangle::corner(bad, 1.0, 1.0));
        refused("b", rectangle::corner(1.0, bad, 1.0));
        refused("h", rectangle::corner(1.0, 1.0, bad));
        refused("d", point(1.0, bad, 0.0));
        refused("c", form_factor::parallel_rectangles(1.0, 1.0, bad));
        refused("w", form_factor::perpendicular_rectangles(bad, 1.0, 1.0));
        refused("r2", form_factor::coaxial_discs(1.0, bad, 1.0));
    }
    for tiny in [1e-151, 5e-324] {
        refused("R", Disc { radius: tiny, ..disc }.irradiance());
        refused("h", Disc { height: tiny, ..disc }.irradiance());
        refused("b", rectangle::corner(1.0, tiny, 1.0));
    }
    for bad in [f64::NAN, f64::INFINITY] {
        refused("a", Disc { offset: bad, ..disc }.irradiance());
        refused("theta", point(1.0, 1.0, bad));
    }
    for bad in [f64::NAN, 3.2, -3.2] {
        refused("tau", Disc { tilt: bad, ..disc }.irradiance());
        refused("omega", Sphere { omega: bad, ..sphere }.irradiance());
    }
    refused("Phi", point(-1.0, 1.0, 0.0));
    // Inside a sphere, and on it.
    for distance in [0.0, 0.5, 1.0, f64::NAN, f64::INFINITY] {
        refused("d", Sphere { distance, ..sphere }.irradiance());
    }
}

#[test]
fn polygons() {
    refused("vertices", polygon::irradiance(&[], UP));
    refused("vertices", polygon::irradiance(&SQUARE[..2], UP));
    refused("normal", polygon::irradiance(&SQUARE, [0.0; 3]));
    refused("normal", polygon::irradiance(&SQUARE, [0.0, f64::NAN, 1.0]));
    let changed = |at: usize, corner: [f64; 3]| {
        let mut corners = SQUARE;
        corners[at] = corner;
        polygon::irradiance(&corners, UP)
    };
    refused("vertices", changed(1, [f64::INFINITY, 0.0, 1.0]));
    refused("vertices", changed(2, [1.0, 1.0, 1.0 + 1e-7]));
    assert!(changed(2, [1.0, 1.0, 1.0 + 1e-9]).is_ok());
    // A length of another world; a line, and a point.
    refused("vertices", changed(1, [1e150, 0.0, 1.0]));
    refused("vertices", polygon::irradiance(&[[3e144, 0.0, -1e84], [0.0, 0.0, 8e108], [0.0, -9e167, 0.0]], UP));
    refused("vertices", polygon::irradiance(&[[0.1, 0.2, 1.0], [0.2, 0.4, 1.0], [0.4, 0.8, 1.0]], UP));
    refused("vertices", polygon::irradiance(&[[1.0, 0.5, 1.0]; 3], UP));
    // An hourglass whose halves do not undo each other.
    refused("vertices", polygon::irradiance(&[SQUARE[0], SQUARE[1], SQUARE[3], [1.0, 1.5, 1.0]], UP));
    // Corners that are there twice, or on an edge, are no harm.
    let [a, b, c, d] = SQUARE;
    let more = polygon::irradiance(&[a, a, [0.5, 0.0, 1.0], b, c, d], UP).unwrap();
    assert!((more - polygon::irradiance(&SQUARE, UP).unwrap()).abs() <= 4.0 * f64::EPSILON);
}

proptest! {
    #[test]
    fn any_numbers_give_an_answer_in_range_or_a_refusal(bits in prop::array::uniform12(any::<f64>()), normal in prop::array::uniform3(any::<f64>())) {
        let sky = 0.0..=std::f64::consts::PI * (1.0 + 1e-15);
        let [a, b, c, d, ..] = bits;
        if let Ok(found) = (Disc { radius: a, height: b, offset: c, tilt: d }).irradiance() {
            prop_assert!(sky.contains(&found), "disc {found}");
        }
        if let Ok(found) = (Sphere { radius: a, distance: b, omega: c }).irradiance() {
            prop_assert!(sky.contains(&found), "sphere {found}");
        }
        if let Ok(found) = rectangle::corner(a, b, c) {
            prop_assert!(sky.contains(&found.parallel) && sky.contains(&found.perpendicular), "{found:?}");
        }
        let corners: Vec<[f64; 3]> = bits.chunks(3).map(|corner| [corner[0], corner[1], corner[2]]).collect();
        if let Ok(found) = polygon::irradiance(&corners[..3], normal) {
            prop_assert!(sky.contains(&found), "polygon {found}");
        }
    }
}
