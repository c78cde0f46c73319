//! Balls on a floor: three of metal, and one of many triangles.

use super::{BLACK, grey, lamp, pinhole, quad, scene, shape};
use crate::bsdf::microfacet::{Joint, Slopes};
use crate::scene::{Energy, Environment, Facets, Geometry, Material, Mesh, Metal, Normals, Scene, Shape};
use std::f64::consts::{PI, TAU};
use std::sync::{Arc, OnceLock};

fn metal(name: &str, alpha: f64) -> Material {
    Material::RoughConductor {
        metal: Metal::Named(name.into()),
        facets: Facets { alpha: [alpha; 2], slopes: Slopes::Ggx },
        masking: Joint::Correlated,
        energy: Energy::Compensated,
        coating: None,
    }
}

/// Three balls of rough metal.
pub(super) fn metals() -> Scene {
    let kinds = [("silver", 0.05), ("gold", 0.2), ("copper", 0.5)];
    let ball = |(at, (name, _)): (usize, &(&str, f64))| {
        let center = [2.3 * (1.0 - at as f64), 1.0, 0.0];
        shape(Geometry::Sphere { center, radius: 1.0 }, name)
    };
    let balls = kinds.iter().enumerate().map(ball).collect();
    shown("metals", 50.0, kinds.iter().map(|(name, alpha)| (*name, metal(name, *alpha))).collect(), balls)
}

/// A ball with bumps, of 200 000 triangles.
pub(super) fn mesh() -> Scene {
    // Made once: the table of scenes is walked by many.
    static BALL: OnceLock<Arc<Mesh>> = OnceLock::new();
    let mesh = Arc::clone(BALL.get_or_init(|| Arc::new(bumpy())));
    let ball = Geometry::Mesh { file: None, normals: Normals::Smooth, mesh };
    // What it is made of asks nothing: the scene is about its triangles.
    let clay = Material::Diffuse { reflectance: [0.6, 0.5, 0.4] };
    shown("mesh", 32.0, vec![("clay", clay)], vec![shape(ball, "clay")])
}

/// On a floor, under a lamp and a grey sky, within an angle [deg].
fn shown(name: &str, angle: f64, mut materials: Vec<(&str, Material)>, mut shapes: Vec<Shape>) -> Scene {
    materials.extend([("floor", grey(0.5)), BLACK]);
    shapes.extend([
        shape(quad([-10.0, 0.0, -10.0], [0.0, 0.0, 20.0], [20.0, 0.0, 0.0]), "floor"),
        lamp(quad([-1.5, 5.0, -2.5], [3.0, 0.0, 0.0], [0.0, 0.0, 3.0]), [12.0; 3]),
    ]);
    let camera = pinhole([0.0, 2.6, -8.5], [0.0, 0.9, 0.0], angle);
    Scene { environment: Some(Environment::Constant([0.4, 0.5, 0.6])), ..scene(name, camera, materials, shapes) }
}

/// Meridians and parallels of the ball: a fan about each pole, two triangles to every other field.
const MERIDIANS: u32 = 400;
const PARALLELS: u32 = 250;

/// The radius is R(1 + 0.4 sin⁵θ cos θ cos 5φ + 0.02 sin⁹θ cos 24θ cos 24φ): bumps of two sizes that fade towards the
/// poles, where meridians meet.
fn bumpy() -> Mesh {
    let point = |theta: f64, phi: f64| {
        let ((sin, cos), (sin_phi, cos_phi)) = (theta.sin_cos(), phi.sin_cos());
        let large = 0.4 * sin.powi(5) * cos * (5.0 * phi).cos();
        let small = 0.02 * sin.powi(9) * (24.0 * phi).cos() * (24.0 * theta).cos();
        let radius = 1.2 * (1.0 + large + small);
        [radius * sin * cos_phi, 1.2 + radius * cos, radius * sin * sin_phi].map(|x| x as f32)
    };
    let mut positions = vec![point(0.0, 0.0)];
    for parallel in 1..=PARALLELS {
        let theta = PI * f64::from(parallel) / f64::from(PARALLELS + 1);
        positions.extend((0..MERIDIANS).map(|at| point(theta, TAU * f64::from(at) / f64::from(MERIDIANS))));
    }
    positions.push(point(PI, 0.0));
    let last = 1 + PARALLELS * MERIDIANS;
    let at = |parallel: u32, meridian: u32| 1 + parallel * MERIDIANS + meridian % MERIDIANS;
    let mut triangles = Vec::new();
    for meridian in 0..MERIDIANS {
        triangles.push([0, at(0, meridian + 1), at(0, meridian)]);
        for parallel in 1..PARALLELS {
            let [a, b] = [0, 1].map(|next| at(parallel - 1, meridian + next));
            let [c, d] = [0, 1].map(|next| at(parallel, meridian + next));
            triangles.extend([[a, b, c], [b, d, c]]);
        }
        triangles.push([at(PARALLELS - 1, meridian), at(PARALLELS - 1, meridian + 1), last]);
    }
    Mesh { positions, triangles, ..Mesh::default() }.smoothed()
}
