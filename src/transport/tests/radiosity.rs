//! Pictures by patches.

use super::*;
use crate::bsdf::rgb;
use crate::geometry::Ray;
use crate::number::Vector;
use crate::radiosity::{Room, Routes, limit};
use crate::scene::triple::{minus, plus, times};
use crate::scene::{Mesh, Normals, builtin};
use crate::transport::film::added;
use crate::transport::radiosity::{Radiosity, Solution, Solver, refusal};
use std::sync::Arc;

fn patched(seed: u64) -> Manner {
    Manner { method: Method::Radiosity, seed, ..Manner::default() }
}

/// A closed box of 1 m × 1 m × 1 m whose walls all shine and reflect alike.
fn even(depth: Option<u32>, rho: f64) -> Scene {
    let box_inside = Room::cuboid([1.0; 3], [(1.0 - rho, 1.0); 6]);
    let wall = |face: &crate::radiosity::Face| shining(shape(quad(face.patch.corners()), "wall"), [1.0; 3], false);
    let camera = looking([0.3, 0.4, 0.6], [0.8, 0.9, 0.1], 70.0, 8);
    let shapes = box_inside.faces.iter().map(wall).collect();
    Scene { max_depth: depth, ..scene(camera, 1, vec![diffuse("wall", [rho; 3])], shapes) }
}

#[test]
fn a_closed_room_is_as_bright_as_its_series_at_every_depth() {
    for (depth, rho) in [(Some(1), 0.6), (Some(2), 0.6), (Some(3), 0.6), (Some(7), 0.8), (None, 0.6), (None, 0.999)] {
        let room = even(depth, rho);
        let exact = depth.map_or(1.0 / (1.0 - rho), |depth| (1.0 - rho.powi(depth as i32)) / (1.0 - rho));
        // All but one bounce off lamps is known by patches without noise; that one is found by both ways, 8192 times.
        let found = green(&filmed(&room, &patched(1), &[0..64]).halves());
        let noise = if depth == Some(1) { 1e-6 } else { 4.0 * found.standard_error() + 1e-5 };
        assert!((found.mean() - exact).abs() < noise * exact.max(1.0), "{depth:?}: {} {exact}", found.mean());
    }
}

#[test]
fn patches_agree_with_paths_within_what_they_say_and_come_nearer_as_they_are_cut() {
    let cornell = Scene { max_depth: None, ..(builtin::named("cornell").expect("there").make)() };
    // Constant patches' means are of order h² where nothing is hidden (Galerkin's: the square of what the light itself is off by).
    let walls = [(0.3, 0.0), (0.7, 1.0), (0.4, 0.2), (0.9, 0.0), (0.2, 0.5), (0.6, 0.0)];
    let empty = Room::cuboid([1.0, 1.5, 1.0], walls);
    let mean = |n: f64| Solution::new(&empty, 0, empty.area() * n * n, None).mean(3, 1);
    let found = [4.0, 8.0, 16.0].map(mean);
    let order = limit::observed_order(found);
    assert!((order - 2.0).abs() < 0.25, "{order}: {found:?}");
    // Pictures of 16 × 16 pixels: by patches and by paths.
    let mut small = cornell;
    (small.camera.width, small.camera.height) = (16, 16);
    let mean = |manner: &Manner, pairs| {
        let halves = filmed(&small, manner, &[0..pairs]).halves();
        rgb(|c| halves.iter().map(|halves| f64::from(halves[0][c] + halves[1][c]) / 2.0).sum::<f64>())
    };
    let (found, exact) = (mean(&patched(1), 32), mean(&Manner { seed: 2, ..Manner::default() }, 256));
    // Patches of a seventh of the room, in the half of the light that comes by way of them: (1/7)²/2 = 1 %; and as much noise at
    // most, 16 × 16 pixels of 64 samples, a few tenths each.
    assert!((0..3).all(|c| (found[c] / exact[c] - 1.0).abs() < 0.02), "{found:?}, {exact:?}");
}

#[test]
fn backs_are_patches_where_light_gets_to_them() {
    let cornell = (builtin::named("cornell").expect("there").make)();
    // The blocks' insides stay dark, and so do the walls' outsides.
    let (room, backs) = Room::of(&cornell).expect("flat and diffuse").with_backs();
    // The lamp hangs a little under the ceiling.
    assert_eq!((room.faces.len(), backs.iter().flatten().count()), (17, 1));
    assert!(backs[5].is_some());
    // A screen that hangs in a room under its lamp: seen from the one side and the other.
    let mut screened = super::room(12);
    let screen = shape(quad([[0.45, 0.1, 0.2], [0.45, 0.5, 0.2], [0.45, 0.5, 0.8], [0.45, 0.1, 0.8]]), "red");
    screened.shapes.push(screen);
    let (room, backs) = Room::of(&screened).expect("flat and diffuse").with_backs();
    assert_eq!(backs.iter().flatten().count(), 2, "the screen's, and the lamp's, which hangs free");
    assert_eq!((room.faces.len(), backs[12]), (15, Some(14)));
    for (origin, target) in [([0.9, 0.7, 0.3], [0.45, 0.4, 0.4]), ([0.02, 0.6, 0.4], [0.45, 0.3, 0.5])] {
        screened.camera = looking(origin, target, 50.0, 8);
        let mean = |manner: &Manner, pairs| {
            let halves = filmed(&screened, manner, &[0..pairs]).halves();
            rgb(|c| halves.iter().map(|halves| f64::from(halves[0][c] + halves[1][c]) / 2.0).sum::<f64>())
        };
        let (found, exact) = (mean(&patched(1), 64), mean(&Manner { seed: 2, ..Manner::default() }, 512));
        // Patches of 0.23 m, 0.45 m from what they light: a quarter of what comes by way of them twice, about a sixth of all that
        // the lamp above sends to either side.
        assert!((0..3).all(|c| (found[c] / exact[c] - 1.0).abs() < 0.04), "{origin:?}: {found:?}, {exact:?}");
    }
}

#[test]
fn what_has_no_patches_is_refused_by_its_place() {
    for (name, place) in [("glass", "shapes[6].geometry"), ("veach", "shapes[0].geometry")] {
        let scene = (builtin::named(name).expect("there").make)();
        assert_eq!(refusal(&scene).map(|flaw| flaw.place.to_string()), Some(place.to_owned()));
        assert!(Renderer::new(&scene, &patched(1), 1).is_err());
    }
    let mut bare = room(4);
    assert_eq!(refusal(&bare), None);
    bare.lights.push(Light::Point { position: [0.5; 3], intensity: [1.0; 3] });
    assert_eq!(refusal(&bare).map(|flaw| flaw.place.to_string()).as_deref(), Some("lights"));
    bare.lights.clear();
    bare.shapes.clear();
    assert_eq!(refusal(&bare).map(|flaw| flaw.place.to_string()).as_deref(), Some("shapes"));
}

#[test]
fn patches_are_as_many_as_the_root_of_the_samples_and_told_of() {
    let mut small = room(64);
    let radiosity = Radiosity::new(&small).expect("flat and diffuse");
    let facts = radiosity.of_sample(0).facts;
    assert_eq!(radiosity.of_sample(1).facts, facts);
    // The lamp hangs free: its back is a face too.
    assert_eq!((facts.faces, facts.backs, facts.solver), (13, 1, Solver::Bounces(4)));
    let Routes { behind, closed, points, contour, hidden } = facts.routes;
    // Of patches of two faces; those of one are not asked for.
    assert!(behind + closed + points + contour < facts.patches * (facts.patches - 1) / 2);
    assert!(closed > 0 && hidden > 0 && contour == 0, "{:?}", facts.routes);
    // Nobody sees more than there is; the room is open to the camera.
    assert!(facts.sums[0] >= 0.0 && facts.sums[1] < 1.0 + 1e-9, "{:?}", facts.sums);
    // Of 256 × 256 pixels; 64 times the samples, 8 times the patches.
    (small.camera.width, small.camera.height) = (256, 256);
    let radiosity = Radiosity::new(&small).expect("flat and diffuse");
    assert!((radiosity.count(256) / radiosity.count(4) - 8.0).abs() < 1e-9);
    assert!(radiosity.count(u32::MAX) <= 4096.0);
}

#[test]
fn no_split_of_samples_by_patches_can_be_told() {
    let room = room(6);
    let of = || Renderer::new(&room, &patched(4), 4).expect("a scene without a flaw");
    let renderer = of();
    let whole = renderer.sums(0..6, 0..4);
    let other = of();
    let late = other.sums(0..6, 2..4);
    let halves = other.sums(0..6, 0..2).into_iter().zip(late);
    assert_eq!(whole, halves.map(|(a, b)| added(a, b)).collect::<Vec<_>>());
    assert_eq!(whole, [renderer.sums(0..1, 0..4), renderer.sums(1..6, 0..4)].concat());
}

#[test]
fn a_place_has_the_patch_that_covers_it_on_either_side() {
    let triangle = [[0.2, 0.3, 0.1], [1.4, 0.1, 0.3], [0.5, 1.1, 0.4]];
    let mesh = Mesh {
        positions: triangle.map(|corner| corner.map(|part| part as f32)).to_vec(),
        triangles: vec![[0, 1, 2]],
        ..Mesh::default()
    };
    let flat = Geometry::Mesh { file: None, normals: Normals::Flat, mesh: Arc::new(mesh) };
    let leaning = quad([[2.0, 0.0, 0.0], [3.0, 0.2, 0.1], [3.1, 1.2, 0.5], [2.1, 1.0, 0.4]]);
    let mirrored = Transform { scale: [-1.0, 1.0, 1.0], ..Transform::default() };
    let plain = Transform::default();
    let shapes = [flat, leaning]
        .into_iter()
        .flat_map(|geometry| [plain, mirrored].map(|transform| Shape { transform, ..shape(geometry.clone(), "wall") }));
    let camera = looking([0.0, 0.0, 5.0], [0.0; 3], 70.0, 2);
    let scene = scene(camera, 4, vec![diffuse("wall", [0.5; 3])], shapes.collect());
    let stage = Stage::<f64>::new(&scene, Structure::Best).expect("a scene without a flaw");
    let room = Room::of(&scene).expect("flat and diffuse");
    let fronts = room.faces.len();
    let both = room
        .faces
        .iter()
        .copied()
        .chain(room.faces.iter().map(|face| crate::radiosity::Face { patch: face.patch.back(), ..*face }));
    let sides = Room { faces: both.collect(), ..room };
    let patches = sides.cut(5);
    for (number, patch) in patches.list.iter().enumerate() {
        let (face, normal) = (patches.owners[number], patch.normal());
        let (origin, direction) = (plus(patch.middle(), times(normal, 0.3)), times(normal, -1.0));
        let ray = Ray {
            origin: Vector::of(times(minus(origin, scene.camera.origin), stage.scale())),
            direction: Vector::of(direction),
        };
        let hit = stage.closest(&ray, true);
        let place = crate::transport::radiosity::place(sides.faces[face % fronts].patch.outline, &hit, face >= fronts);
        assert_eq!(hit.primitive as usize, face % fronts, "patch {number}");
        assert_eq!(patches.at(face, place), number, "of face {face}");
    }
}

#[test]
fn patches_are_no_more_than_there_is_room_for_and_end_what_grows() {
    // A drum of many thin triangles.
    let corner = |k: u32, y: f32| {
        let angle = std::f32::consts::TAU * k as f32 / 30.0;
        [angle.cos(), y, angle.sin()]
    };
    let positions = (0..60).map(|k| corner(k / 2, (k % 2) as f32 * 20.0)).collect();
    let triangles =
        (0..30u32).flat_map(|k| [0, 1].map(|up| [2 * k + up, (2 * k + 1 + up) % 60, (2 * k + 2 + up) % 60]));
    let mesh = Mesh { positions, triangles: triangles.collect(), ..Mesh::default() };
    let drum = Geometry::Mesh { file: None, normals: Normals::Flat, mesh: Arc::new(mesh) };
    let camera = looking([0.0, 0.0, 5.0], [0.0; 3], 70.0, 2);
    let drum = scene(camera, 4, vec![diffuse("wall", [0.5; 3])], vec![shape(drum, "wall")]);
    let room = Room::of(&drum).expect("flat and diffuse");
    assert_eq!(room.faces.len(), 60);
    assert!(room.cut_to((room.area() / 4096.0).sqrt()).list.len() > 20_000, "thin pieces are many");
    assert!(room.cut_within((room.area() / 4096.0).sqrt(), 4096).list.len() <= 4096);
    // A white room with a block in it, all shining 1: radiance 1/(1 − ρ) everywhere, whatever hides what. What rays say of
    // hidden pairs may make it darker; brighter it cannot be.
    let rho = 0.999;
    let mut white = even(None, rho);
    white.camera = looking([0.1, 0.1, 0.1], [0.9, 0.2, 0.9], 70.0, 2);
    let block = Geometry::Box { min: [0.35, 0.3, 0.4], max: [0.7, 0.6, 0.65] };
    white.shapes.push(shining(shape(block, "wall"), [1.0; 3], false));
    let solution = Solution::new(&Room::of(&white).expect("flat and diffuse"), 0, 200.0, None);
    let most = 1.0 / (1.0 - rho);
    assert!(solution.facts.sums[1] < 1.0 + 1e-12, "{:?}", solution.facts);
    assert!(
        solution.facts.mean > 0.0 && solution.facts.mean < most && solution.facts.residual < 1e-9,
        "{:?}",
        solution.facts
    );
}
