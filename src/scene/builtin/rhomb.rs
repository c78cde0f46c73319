//! Fresnel's rhomb: glass that turns linear light into circular, by two total reflections.
//!
//! A bright ceiling is mirrored by dark glass at Brewster's angle: what comes back swings along one diagonal of the picture. In
//! between stands a rhomb on a table, in which light is totally reflected twice in a level plane, p against s each time turned by
//! an eighth of a period. Behind it the light is circular, as bright through a filter at any angle; beside it a filter along the
//! other diagonal makes the mirror black.

use super::{BLACK, grey, lamp, pinhole, quad, scene, shape};
use crate::optics::fresnel::{brewster_angle, retarding_angles};
use crate::scene::triple::{cross, minus, normalised, plus, times};
use crate::scene::{Camera, Geometry, Material, Mesh, Metal, Normals, Scene, Triple};
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_4};
use std::sync::Arc;

/// Index [1] of the rhomb, as Born and Wolf have it, and of the dark glass.
pub const INDEX: f64 = 1.51;
const DARK: f64 = 1.5;
/// Width of the rhomb's faces and its height [m].
const WIDE: f64 = 0.04;
const HIGH: f64 = 0.05;
/// How far the camera is from the face that it sees [m], so far that all rays are nearly square to it, and how far the dark glass
/// is behind that [m].
const AWAY: f64 = 1.2;
const BEHIND: f64 = 0.5;

/// A rhomb of an index [1] on the table, its exit in the plane z = 0 about x = 0 and its entry behind that, cut so that light along
/// z is reflected twice at an angle [rad].
fn cut(theta: f64) -> Geometry {
    // Along z a wall runs to the side by cot θ; between the two reflections light goes to the side by as much as between the faces.
    let (sin, cos) = theta.sin_cos();
    let aside = 2.0 * WIDE * sin * sin;
    let (x, z) = (WIDE / 2.0, -aside * sin / cos);
    let level = 1e-4;
    let section = [[-x, level, 0.0], [x, level, 0.0], [x + aside, level, z], [aside - x, level, z]];
    let mesh = Arc::new(Mesh::prism(section, [0.0, HIGH, 0.0]));
    Geometry::Mesh { file: None, normals: Normals::Flat, mesh }
}

/// A large square about a place, its normal a unit vector that is not along x.
fn facing(center: Triple, normal: Triple, half: f64) -> Geometry {
    let x = times(normalised(cross([1.0, 0.0, 0.0], normal)), half);
    let y = cross(normal, x);
    quad(minus(minus(center, x), y), times(x, 2.0), times(y, 2.0))
}

/// The rhomb on its table, the dark glass behind it, and what that mirrors.
pub(super) fn rhomb() -> Scene {
    // It moves least with the angle at the larger one of both.
    let [_, theta] = retarding_angles(INDEX, FRAC_PI_4).unwrap_or([0.85, 0.95]);
    let level = HIGH / 2.0;
    let brewster = brewster_angle(1.0, DARK);
    let tilted = |angle: f64| {
        let (sin, cos) = angle.sin_cos();
        [sin * FRAC_1_SQRT_2, sin * FRAC_1_SQRT_2, cos]
    };
    let mirror = [0.0, level, -BEHIND];
    // A ray along −z is turned by twice the angle from which it came.
    let ceiling = plus(mirror, times(tilted(2.0 * brewster), 1.0));
    let shapes = vec![
        shape(cut(theta), "glass"),
        shape(facing(mirror, tilted(brewster), 0.6), "dark"),
        lamp(facing(ceiling, times(tilted(2.0 * brewster), -1.0), 0.6), [10.0; 3]),
        shape(quad([-0.15, 0.0, -0.15], [0.0, 0.0, 0.25], [0.3, 0.0, 0.0]), "table"),
    ];
    let materials = vec![
        ("glass", Material::Dielectric { ior: INDEX, outside: 1.0, absorption: [0.0; 3], coating: None }),
        ("dark", Material::Conductor { metal: Metal::Indices { eta: [DARK; 3], k: [0.0; 3] }, coating: None }),
        ("table", grey(0.5)),
        BLACK,
    ];
    let camera = pinhole([0.0, level, AWAY], [0.0, level, 0.0], 8.0);
    scene("rhomb", Camera { polariser_deg: Some(45.0), ..camera }, materials, shapes)
}
