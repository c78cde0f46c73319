//! Scenes at the ends of what scenes may be, where the answer is known.

use super::*;
use crate::bsdf::microfacet::{Joint, Slopes};
use crate::scene::{Energy, Facets, Mesh, Metal, Normals};
use std::sync::Arc;
use yardstick::statistics::t_test;

/// Before a sky of radiance 1, seen from a place.
fn world(origin: [f64; 3], target: [f64; 3], material: Material, shapes: Vec<Geometry>) -> Scene {
    let shapes = shapes.into_iter().map(|geometry| shape(geometry, "body")).collect();
    let made = scene(looking(origin, target, 50.0, 12), 1, vec![("body".into(), material)], shapes);
    Scene { environment: Some(Environment::Constant([1.0; 3])), max_depth: None, ..made }
}

fn white() -> Material {
    Material::Diffuse { reflectance: [1.0; 3] }
}

fn mirror_of(alpha: f64) -> Material {
    Material::RoughConductor {
        metal: Metal::Indices { eta: [0.0; 3], k: [1.0; 3] },
        facets: Facets { alpha: [alpha; 2], slopes: Slopes::Ggx },
        masking: Joint::Correlated,
        energy: Energy::Compensated,
        coating: None,
    }
}

/// A fan of triangles a millionth as wide as they are long, some without any width.
fn needles() -> Geometry {
    let count = 64;
    let mut positions = vec![[0.0_f32, 0.0, 1.0]];
    for k in 0..count {
        let angle = k as f32 / count as f32 * std::f32::consts::TAU;
        for wide in [0.0, if k % 4 == 0 { 0.0 } else { 1e-6 }] {
            positions.push([(angle + wide).cos(), (angle + wide).sin(), 0.0]);
        }
    }
    let triangles = (0..count).map(|k| [0, 2 * k + 1, 2 * k + 2]).collect();
    let mesh = Mesh { positions, triangles, ..Mesh::default() };
    Geometry::Mesh { file: None, normals: Normals::Flat, mesh: Arc::new(mesh) }
}

#[test]
fn a_white_world_is_white_at_every_extreme() {
    let ball = |center, radius| Geometry::Sphere { center, radius };
    let plane = |z: f64| quad([[-1.0, -1.0, z], [1.0, -1.0, z], [1.0, 1.0, z], [-1.0, 1.0, z]]);
    let near = ([0.0, -4.0, 1.5], [0.0, 0.0, 0.5]);
    let of = |material, shapes| world(near.0, near.1, material, shapes);
    let tried = [
        (
            "a ball upon one of a million times its size",
            of(white(), vec![ball([0.0, 0.0, 1.0], 1.0), ball([0.0, 0.0, -1e6], 1e6)]),
        ),
        ("needles", of(white(), vec![needles()])),
        ("surfaces in one place", of(white(), vec![plane(0.0), plane(0.0), plane(1e-9)])),
        ("a ball a millionth wide", world([0.0, -4e-6, 0.0], [0.0; 3], white(), vec![ball([0.0; 3], 1e-6)])),
        ("facets as good as flat", of(mirror_of(1e-4), vec![ball([0.0, 0.0, 1.0], 1.0)])),
        ("nothing", of(white(), vec![])),
    ];
    for (name, scene) in tried {
        let halves = filmed(&scene, &with(Tactics::default(), 1), &[0..32]).halves();
        let off = halves.iter().flatten().flatten().map(|x| (f64::from(*x) - 1.0).abs()).fold(0.0, f64::max);
        // Every path ends at the sky with all it had. Compensation keeps its promise to 10⁻³.
        assert!(off < 2e-3, "{name}: {off}");
    }
}

/// Off rough facets many a direction is drawn that leads into the body: there the path ends.
#[test]
fn draws_that_fail_end_paths() {
    let ball = Geometry::Sphere { center: [0.0; 3], radius: 1.0 };
    let of = world([0.0, -4.0, 1.5], [0.0; 3], mirror_of(0.2), vec![ball]);
    for integrator in INTEGRATORS.iter().filter(|one| one.name != "hemisphere") {
        let manner = Manner { method: Method::Simple(integrator), ..with(Tactics::default(), 1) };
        let halves = filmed(&of, &manner, &[0..128]).halves();
        let odd = halves.iter().flatten().flatten().filter(|x| !x.is_finite()).count();
        assert_eq!(odd, 0, "{}", integrator.name);
    }
}

#[test]
fn who_stands_in_glass_sees_a_brighter_sky() {
    // L/n² is what stays the same (Planck): all around it is n² times as bright.
    let glass = Material::Dielectric { ior: 1.5, outside: 1.0, absorption: [0.0; 3], coating: None };
    let ball = Geometry::Sphere { center: [0.0; 3], radius: 1.0 };
    let scene = world([0.1, 0.2, 0.1], [0.0, 1.0, 0.0], glass, vec![ball]);
    let found = runs(24, |seed| filmed(&scene, &with(Tactics::default(), seed), &[0..32]).halves());
    assert!((found.mean() / 2.25 - 1.0).abs() < 1e-4 + 4.0 * found.standard_error(), "{found:?}");
}

#[test]
fn without_a_lamp_all_is_black() {
    let mut dark = hall(8);
    dark.shapes.retain(|shape| shape.emission.is_none());
    for integrator in INTEGRATORS {
        assert_eq!(green(&simple(&dark, integrator, 8, 1)).mean(), 0.0, "{}", integrator.name);
    }
    assert!(
        filmed(&dark, &with(Tactics::default(), 1), &[0..8]).halves().iter().all(|halves| *halves == [[0.0; 3]; 2])
    );
}

#[test]
fn a_room_that_hardly_absorbs_is_as_bright_as_its_series() {
    // Of paths of at most 10⁴ edges, and of paths without an end. Without a pilot, so that each pixel has the samples that
    // are asked for.
    fn of<N: Width>(rho: f64, max_depth: Option<u32>, pairs: u32, seeds: u64) -> Moments {
        let ball = shape(Geometry::Sphere { center: [0.0; 3], radius: 2.0 }, "wall");
        let camera = looking([0.3, 0.1, -0.4], [0.0, 0.0, 1.0], 60.0, 1);
        let room = scene(camera, 1, vec![diffuse("wall", [rho; 3])], vec![shining(ball, [1.0; 3], true)]);
        let room = Scene { max_depth, ..room };
        let tactics = Tactics { pilot: false, ..Tactics::default() };
        (0..seeds).map(|seed| green(&fast::<N>(&room, &tactics, pairs, seed)).mean()).collect()
    }
    // One that f32 has: about a millionth. So few paths would leave most lanes idle.
    let loss = 17.0 / f64::from(1 << 24);
    let series = |rho: f64, depth: i32| (1.0 - rho.powi(depth)) / (1.0 - rho);
    let tried = [
        ("a thousandth, 10⁴ edges", series(0.999, 10_000), of::<F32x8>(0.999, Some(10_000), 128, 12)),
        ("a thousandth", 1e3, of::<F32x8>(0.999, None, 128, 12)),
        ("a millionth", 1.0 / loss, of::<f32>(1.0 - loss, None, 1, 8)),
    ];
    for (name, exact, found) in &tried {
        let test = t_test(found, *exact);
        assert!(test.p > SIGNIFICANCE / 3.0, "{name}: {} ± {} against {exact}", found.mean(), found.standard_error());
    }
    // A chance of 0.98 to go on, whatever a surface keeps, is the slip: its mean is right, and its variance without end, so that
    // few find it. Ours is that of a geometric sum: as large as its mean.
    let [(_, exact, found), ..] = &tried;
    let of_one = found.variance().sqrt() * 256.0_f64.sqrt() / exact;
    assert!(of_one < 2.0, "{of_one}");
}
