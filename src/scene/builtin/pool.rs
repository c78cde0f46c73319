//! A pool under a grey sky, seen from where the sky's glare on the water is all of one polarisation.
//!
//! At Brewster's angle, arctan 1.333 = 53.1° from the normal, water returns no light that swings in the plane of incidence (E39 has its
//! zero there): a filter whose axis is upright takes the glare off the water and leaves what lies below it.

use super::{grey, pinhole, quad, scene, shape};
use crate::media;
use crate::scene::{Camera, Environment, Geometry, Material, Scene};

/// How deep the pool is [m].
const DEEP: f64 = 0.6;

/// Balls under water, a buoy upon it, and a polariser before the camera.
pub(super) fn polariser() -> Scene {
    // At the d line: of one index, not to ask for wavelengths.
    let n = media::named("water").and_then(|water| water.index(587.56e-9).ok()).map_or(1.333, |index| index.re);
    let water = Material::Dielectric { ior: n, outside: 1.0, absorption: [0.0; 3], coating: None };
    let paint = |reflectance| Material::Diffuse { reflectance };
    let (low, wide) = (-DEEP, 1.6);
    let [x, y, z] = [[2.0 * wide, 0.0, 0.0], [0.0, DEEP, 0.0], [0.0, 0.0, 2.0 * wide]];
    let basin = [
        quad([-wide, low, -wide], z, x),
        quad([-wide, low, -wide], x, y),
        quad([-wide, low, wide], y, x),
        quad([-wide, low, -wide], y, z),
        quad([wide, low, -wide], z, y),
    ];
    let surface = quad([-wide, 0.0, -wide], z, x);
    let ball = |center, radius, material| shape(Geometry::Sphere { center, radius }, material);
    let shapes = [shape(surface, "water")]
        .into_iter()
        .chain(basin.map(|side| shape(side, "basin")))
        .chain([
            ball([-0.55, low + 0.22, 0.1], 0.22, "red"),
            ball([0.05, low + 0.22, -0.35], 0.22, "yellow"),
            ball([0.6, low + 0.22, 0.2], 0.22, "blue"),
            ball([0.15, 0.02, 0.75], 0.16, "white"),
        ])
        .collect();
    let materials = vec![
        ("water", water),
        ("basin", grey(0.35)),
        ("red", paint([0.7, 0.08, 0.05])),
        ("yellow", paint([0.75, 0.55, 0.05])),
        ("blue", paint([0.06, 0.15, 0.6])),
        ("white", grey(0.8)),
    ];
    // The middle of the picture meets the water at Brewster's angle.
    let away = 3.2;
    let origin = [0.0, away * (1.0 / n).atan().sin(), -away * (1.0 / n).atan().cos()];
    let camera = Camera { polariser_deg: Some(90.0), ..pinhole(origin, [0.0, 0.0, 0.1], 36.0) };
    Scene { environment: Some(Environment::Constant([1.8, 1.9, 2.0])), ..scene("polariser", camera, materials, shapes) }
}
