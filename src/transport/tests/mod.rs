//! Light through scenes: against closed forms, and one integrator against another.
#![expect(clippy::single_range_in_vec_init, reason = "parts of a film are ranges, and one may be all")]

use super::film::{Clash, Film, Halves};
use super::kernel::{Meeting, Tactics};
use super::picture::{self, Several};
use super::simple::{INTEGRATORS, Integrator};
use super::{Manner, Method, Needless, Renderer, Stage};
use crate::geometry::Structure;
use crate::number::{F32x8, Width};
use crate::radiometry::{self, disc::Disc, polygon, sphere::Sphere};
use crate::sampling::{Choice, Points};
use crate::scene::{
    Camera, Coating, Emission, Environment, Filter, Geometry, Light, Material, Scene, Shape, Transform,
};
use yardstick::statistics::{Moments, normal_two_sided, sidak, t_test, z_test};

mod balance;
mod casters;
mod extremes;
mod features;
mod irradiance_cache;
mod looks;
mod panorama;
mod patterns;
mod photons;
mod pilot;
mod polarised;
mod prism;
mod radiosity;

/// The chance that any one of these tests fails though nothing is wrong.
const SIGNIFICANCE: f64 = 1e-4;

fn shape(geometry: Geometry, material: &str) -> Shape {
    Shape { geometry, material: material.into(), emission: None, transform: Transform::default() }
}

fn shining(shape: Shape, radiance: [f64; 3], two_sided: bool) -> Shape {
    Shape { emission: Some(Emission { radiance, two_sided }), ..shape }
}

fn quad(vertices: [[f64; 3]; 4]) -> Geometry {
    Geometry::Quad { vertices }
}

fn diffuse(name: &str, reflectance: [f64; 3]) -> (String, Material) {
    (name.into(), Material::Diffuse { reflectance })
}

fn looking(origin: [f64; 3], target: [f64; 3], fov_y_deg: f64, pixels: u32) -> Camera {
    Camera {
        origin,
        target,
        up: [0.0, 0.6, 0.8],
        fov_y_deg,
        width: pixels,
        height: pixels,
        aperture: 0.0,
        focus: None,
        polariser_deg: None,
    }
}

fn scene(camera: Camera, max_depth: u32, materials: Vec<(String, Material)>, shapes: Vec<Shape>) -> Scene {
    Scene {
        name: "test".into(),
        max_depth: Some(max_depth),
        filter: Filter::Box,
        camera,
        environment: None,
        materials,
        shapes,
        lights: Vec::new(),
    }
}

/// A room with a block in it, under a lamp.
fn room(pixels: u32) -> Scene {
    let [white, red] = [diffuse("white", [0.73; 3]), diffuse("red", [0.65, 0.05, 0.05])];
    let wall = |vertices, material| shape(quad(vertices), material);
    let shapes = vec![
        wall([[0.0, 0.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [1.0, 0.0, 0.0]], "white"),
        wall([[0.0, 1.0, 0.0], [1.0, 1.0, 0.0], [1.0, 1.0, 1.0], [0.0, 1.0, 1.0]], "white"),
        wall([[0.0, 0.0, 1.0], [0.0, 1.0, 1.0], [1.0, 1.0, 1.0], [1.0, 0.0, 1.0]], "white"),
        wall([[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 1.0, 1.0], [0.0, 0.0, 1.0]], "red"),
        wall([[1.0, 0.0, 0.0], [1.0, 0.0, 1.0], [1.0, 1.0, 1.0], [1.0, 1.0, 0.0]], "white"),
        shape(Geometry::Box { min: [0.5, 0.0, 0.4], max: [0.8, 0.4, 0.7] }, "white"),
        shining(
            shape(quad([[0.3, 0.99, 0.3], [0.7, 0.99, 0.3], [0.7, 0.99, 0.7], [0.3, 0.99, 0.7]]), "white"),
            [8.0, 6.0, 4.0],
            false,
        ),
    ];
    scene(looking([0.5, 0.5, -1.3], [0.5, 0.5, 0.0], 40.0, pixels), 6, vec![white, red], shapes)
}

/// The pixels' halves, as means.
fn fast<N: Width>(of: &Scene, tactics: &Tactics, pairs: u32, seed: u64) -> Vec<Halves> {
    let stage = Stage::<N>::new(of, Structure::Best).expect("a scene without a flaw");
    let points = Points::new(Choice::Net, pairs, 8, seed);
    let several = Several::new(&stage, tactics, (Choice::Net, 8, seed));
    let sums = picture::fast(&stage, tactics, &several, &points, 0..of.camera.height, 0..pairs);
    means(&sums, pairs)
}

fn simple(of: &Scene, integrator: &Integrator, pairs: u32, seed: u64) -> Vec<Halves> {
    let stage = Stage::<f64>::new(of, Structure::Best).expect("a scene without a flaw");
    let points = Points::new(Choice::Net, pairs, 8, seed);
    let depth = of.max_depth.expect("a depth");
    means(&picture::simple(&stage, integrator, depth, &points, 0..of.camera.height, 0..pairs), pairs)
}

fn means(sums: &[Halves], pairs: u32) -> Vec<Halves> {
    sums.iter().map(|halves| halves.map(|half| half.map(|sum| sum / pairs as f32))).collect()
}

/// The green of the whole picture, by halves of independent pixels.
fn green(picture: &[Halves]) -> Moments {
    let mut moments = Moments::default();
    picture.iter().flatten().for_each(|half| moments.add(f64::from(half[1])));
    moments
}

/// Runs of one pixel with different seeds: they are independent, whatever the points of each are.
fn runs(count: u64, of: impl Fn(u64) -> Vec<Halves>) -> Moments {
    let mut moments = Moments::default();
    for seed in 0..count {
        of(seed).iter().flatten().for_each(|half| moments.add(f64::from(half[1])));
    }
    moments
}

#[test]
fn all_integrators_make_the_same_picture() {
    let room = room(12);
    let mut pictures = vec![("fast", fast::<F32x8>(&room, &Tactics::default(), 128, 1))];
    for integrator in INTEGRATORS {
        // What meets lamps by chance alone needs more.
        let pairs = if matches!(integrator.name, "hemisphere" | "surface") { 2048 } else { 128 };
        pictures.push((integrator.name, simple(&room, integrator, pairs, 2)));
    }
    let tests = pictures.len() * (pictures.len() - 1) / 2;
    let least = sidak(SIGNIFICANCE, tests);
    for (k, (name, one)) in pictures.iter().enumerate() {
        for (other_name, other) in &pictures[..k] {
            // Both halves of a pixel are of the same mean, and their difference is error: of the pixels' mean difference.
            let (mut difference, mut variance) = (0.0, 0.0);
            for (a, b) in one.iter().zip(other) {
                let mean = |halves: &Halves| f64::from(halves[0][1] + halves[1][1]) / 2.0;
                let error = |halves: &Halves| f64::from(halves[0][1] - halves[1][1]).powi(2) / 4.0;
                difference += mean(a) - mean(b);
                variance += error(a) + error(b);
            }
            let p = normal_two_sided(difference / variance.sqrt());
            assert!(p > least, "{name} against {other_name}: p = {p:.1e}");
        }
    }
}

#[test]
fn a_lamp_counted_twice_is_found() {
    // The test above can fail: by the slip of adding both ways of meeting a lamp without weighing them.
    let room = room(12);
    let right = green(&fast::<F32x8>(&room, &Tactics::default(), 128, 1));
    let by_lamps = fast::<F32x8>(&room, &Tactics { meeting: Meeting::Lamps, ..Tactics::default() }, 128, 2);
    let by_chance = fast::<F32x8>(&room, &Tactics { meeting: Meeting::Chance, ..Tactics::default() }, 2048, 3);
    let share = |picture: &[Halves]| green(picture).mean() / right.mean();
    assert!((share(&by_lamps) - 1.0).abs() < 0.01, "{}", share(&by_lamps));
    assert!((share(&by_chance) - 1.0).abs() < 0.05, "{}", share(&by_chance));
    assert!(share(&by_lamps) + share(&by_chance) > 1.8);
}

#[test]
fn eight_lanes_are_eight_single_paths() {
    let room = room(8);
    let (lanes, single) =
        (fast::<F32x8>(&room, &Tactics::default(), 16, 5), fast::<f32>(&room, &Tactics::default(), 16, 5));
    assert_eq!(lanes, single);
}

#[test]
fn no_split_of_samples_can_be_told() {
    let room = room(6);
    let stage = Stage::<F32x8>::new(&room, Structure::Best).expect("a scene without a flaw");
    let points = Points::new(Choice::Net, 1024, 8, 0);
    let tactics = Tactics::default();
    let several = Several::new(&stage, &tactics, (Choice::Net, 8, 0));
    let part = |rows: std::ops::Range<u32>, pairs| picture::fast(&stage, &tactics, &several, &points, rows, pairs);
    let whole = part(0..6, 0..1024);
    let halves = part(0..6, 0..512).into_iter().zip(part(0..6, 512..1024));
    assert_eq!(whole, halves.map(|(a, b)| super::film::added(a, b)).collect::<Vec<_>>());
    let rows = [part(0..2, 0..1024), part(2..6, 0..1024)].concat();
    assert_eq!(whole, rows);
}

/// A room with a ball of glass and a mirror in it.
fn hall(pixels: u32) -> Scene {
    let glass = Material::Dielectric { ior: 1.5, outside: 1.0, absorption: [0.0, 0.5, 1.0], coating: None };
    let mut hall = room(pixels);
    hall.max_depth = Some(7);
    hall.materials.extend([("glass".into(), glass), ("mirror".into(), Material::Mirror { reflectance: [0.9; 3] })]);
    hall.shapes.retain(|shape| !matches!(shape.geometry, Geometry::Box { .. }));
    hall.shapes.push(shape(Geometry::Sphere { center: [0.3, 0.3, 0.4], radius: 0.2 }, "glass"));
    hall.shapes.push(shape(Geometry::Sphere { center: [0.7, 0.2, 0.6], radius: 0.2 }, "mirror"));
    hall
}

/// As a film has it, from one renderer or from several that share the pairs.
fn filmed(of: &Scene, manner: &Manner, parts: &[std::ops::Range<u32>]) -> Film {
    let all = parts.iter().map(|part| part.end).max().unwrap_or_default();
    let renderer = Renderer::new(of, manner, all).expect("a scene without a flaw");
    let [width, height] = [of.camera.width, of.camera.height];
    let mut film = Film::new(width, height);
    for part in parts {
        let sums = renderer.sums(0..height, part.clone());
        film.add_lit(part.clone(), sums, renderer.splats(part.clone())).expect("new pairs");
    }
    film
}

fn with(tactics: Tactics, seed: u64) -> Manner {
    Manner { method: Method::Fast(tactics), seed, ..Manner::default() }
}

/// The mean difference of two pictures over its standard error, by the halves of each.
fn apart(one: &[Halves], other: &[Halves]) -> f64 {
    let (mut difference, mut variance) = (0.0, 0.0);
    for (a, b) in one.iter().zip(other) {
        let mean = |halves: &Halves| f64::from(halves[0][1] + halves[1][1]) / 2.0;
        let error = |halves: &Halves| f64::from(halves[0][1] - halves[1][1]).powi(2) / 4.0;
        difference += mean(a) - mean(b);
        variance += error(a) + error(b);
    }
    difference / variance.sqrt()
}

#[test]
fn caustics_are_what_chance_finds_and_quieter() {
    let hall = hall(16);
    let lit = filmed(&hall, &with(Tactics::default(), 1), &[0..256]).halves();
    let plain = Tactics { caustics: false, extra: 1, ..Tactics::default() };
    let without = filmed(&hall, &with(plain, 2), &[0..1024]).halves();
    let by_surface = simple(&hall, &INTEGRATORS[1], 2048, 3);
    let by_both = simple(&hall, &INTEGRATORS[3], 2048, 4);
    let least = sidak(SIGNIFICANCE, 3);
    for (name, other) in [("without", &without), ("surface", &by_surface), ("both", &by_both)] {
        let p = normal_two_sided(apart(&lit, other));
        assert!(p > least, "{name}: p = {p:.1e}");
    }
    // As many samples have less noise: neither of two fair ways that are weighed by their shares is worse for the other.
    let as_many = filmed(&hall, &with(plain, 5), &[0..256]).halves();
    let noise = |picture: &[Halves]| -> f64 {
        picture.iter().map(|halves| f64::from(halves[0][1] - halves[1][1]).powi(2)).sum()
    };
    assert!(noise(&lit) < noise(&as_many), "{} against {}", noise(&lit), noise(&as_many));
    // The slip of adding what lamps bring to what chance finds, unweighed: too bright by far.
    let renderer = Renderer::new(&hall, &with(Tactics::default(), 1), 256).expect("a scene without a flaw");
    let splats = renderer.splats(0..256).expect("caustics");
    let slip: Vec<Halves> = without
        .iter()
        .enumerate()
        .map(|(pixel, halves)| {
            let light = splats.light(pixel);
            [0, 1].map(|half| [0, 1, 2].map(|c| halves[half][c] + (light[half][c] / 256.0) as f32))
        })
        .collect();
    assert!(normal_two_sided(apart(&slip, &by_both)) < SIGNIFICANCE);
}

#[test]
fn no_order_and_no_threads_can_be_told_from_caustics() {
    let hall = hall(6);
    let manner = with(Tactics::default(), 1);
    let whole = filmed(&hall, &manner, &[0..8]);
    assert_eq!(whole, filmed(&hall, &manner, &[4..8, 2..4, 0..2]));
    let mut parts = filmed(&hall, &manner, &[4..8]);
    // Made by who expects no more.
    parts.merge(filmed(&hall, &manner, &[2..4, 0..1, 1..2])).expect("no overlap");
    assert_eq!(whole, parts);
    for lanes in [1, 8] {
        let fewer = with(Tactics { lanes, ..Tactics::default() }, 1);
        assert_eq!(whole.halves(), filmed(&hall, &fewer, &[0..8]).halves(), "{lanes}");
    }
    let dark = filmed(&hall, &with(Tactics { caustics: false, ..Tactics::default() }, 1), &[8..16]);
    assert_eq!(parts.merge(dark), Err(Clash::Light));
}

#[test]
fn samples_do_not_depend_on_how_many_are_expected() {
    // On both sides of where the table of numbers ends, too: of eight rows and eight samples a pair, after 2¹³ pairs.
    let pairs = [0..1, 63..64, 64..128, 8191..8192, 8192..8193, 16_384..16_385];
    for scene in [room(3), hall(3)] {
        let all = Renderer::new(&scene, &Manner::default(), 1 << 15).expect("a scene without a flaw");
        let mut grown = Renderer::new(&scene, &Manner::default(), 1).expect("a scene without a flaw");
        let mut before = None;
        for range in pairs.clone() {
            let alone = Renderer::new(&scene, &Manner::default(), range.end).expect("a scene without a flaw");
            grown.expect(range.end);
            let of = |renderer: &Renderer| (renderer.sums(0..3, range.clone()), renderer.splats(range.clone()));
            let expected = of(&all);
            assert!(of(&alone) == expected && of(&grown) == expected, "{range:?}");
            assert_ne!(before.replace(expected.clone()), Some(expected), "{range:?}");
        }
    }
}

#[test]
fn what_is_left_out_is_not_missed() {
    let mut foggy = room(8);
    foggy.environment = Some(Environment::Constant([0.3, 0.2, 0.1]));
    for (name, scene) in [("room", room(8)), ("hall", hall(8)), ("under a sky", foggy)] {
        let least = filmed(&scene, &Manner::default(), &[0..16]);
        let with = |needless| filmed(&scene, &Manner { needless, ..Manner::default() }, &[0..16]);
        assert_eq!(least, with(Needless::EVERYTHING), "{name}");
        let renderer = Renderer::new(&scene, &Manner::default(), 1).expect("a scene without a flaw");
        let left_out = renderer.needs().left_out();
        for (what, needless) in left_out.iter().filter_map(|one| Some((one.what, one.needless?))) {
            assert_eq!(least, with(needless), "{name}: {what}");
        }
        assert!(left_out.iter().any(|one| one.what == "shadow tests of walls"), "{name}");
        assert_eq!(left_out.iter().any(|one| one.what == "paths from lamps"), name != "hall", "{name}");
    }
}

#[test]
fn samples_where_glass_is_seen_are_means_of_several() {
    // The pixels of the balls' middles are quieter, as of eight times the samples; those of walls are the same, bit for bit.
    let hall = hall(16);
    let of = |extra| filmed(&hall, &with(Tactics { extra, caustics: false, ..Tactics::default() }, 1), &[0..64]);
    let (many, one) = (of(8).halves(), of(1).halves());
    let same = many.iter().zip(&one).filter(|(a, b)| a == b).count();
    assert!(same > 128 && same < 240, "{same} of 256");
    let p = normal_two_sided(apart(&many, &one));
    assert!(p > SIGNIFICANCE, "p = {p:.1e}");
}

#[test]
fn hostile_scenes_are_finite() {
    let point = Light::Point { position: [0.5, 0.0, 0.5], intensity: [1.0; 3] };
    let sliver =
        shape(quad([[0.2, 0.5, 0.2], [0.8, 0.5, 0.2], [0.8, 0.5, 0.2 + 1e-7], [0.2, 0.5, 0.2 + 1e-7]]), "white");
    let speck = Geometry::Sphere { center: [0.5, 0.9, 0.5], radius: 1e-6 };
    let mut scenes = vec![("a lamp in its ball of glass", hall(8)), ("a lamp that is a speck", hall(8))];
    scenes[0].1.shapes.push(shining(
        shape(Geometry::Sphere { center: [0.3, 0.3, 0.4], radius: 0.1 }, "white"),
        [1e6; 3],
        true,
    ));
    scenes[1].1.shapes.push(shining(shape(speck, "white"), [1e12; 3], false));
    let mut touching = hall(8);
    touching.lights.push(point);
    touching.shapes.push(sliver);
    touching.shapes.extend(touching.shapes.clone());
    scenes.push(("everything twice, a light in a wall, and a sliver", touching));
    let mut inside = hall(8);
    inside.camera = looking([0.3, 0.3, 0.4], [0.7, 0.2, 0.6], 120.0, 8);
    scenes.push(("a camera inside glass", inside));
    let mut sheet = hall(8);
    sheet.shapes.push(shining(sliver_of_light(), [1.0; 3], true));
    scenes.push(("a lamp without width", sheet));
    for (name, scene) in scenes {
        for tactics in [Tactics::default(), Tactics { blind_choice: true, patience: 2, ..Tactics::default() }] {
            let picture = filmed(&scene, &with(tactics, 3), &[0..16]).halves();
            let odd = picture.iter().flatten().flatten().filter(|x| !(x.is_finite() && **x >= 0.0)).count();
            assert_eq!(odd, 0, "{name}");
        }
    }
}

fn sliver_of_light() -> Shape {
    shape(quad([[0.2, 0.5, 0.2], [0.8, 0.5, 0.2], [0.8, 0.5, 0.2], [0.2, 0.5, 0.2]]), "white")
}

/// Light straight from a lamp onto a diffuse floor, seen through a needle's eye at a place of it.
fn lit(lamp: Option<Shape>, light: Option<Light>, at: [f64; 2]) -> Scene {
    let floor = quad([[-4.0, -4.0, 0.0], [4.0, -4.0, 0.0], [4.0, 4.0, 0.0], [-4.0, 4.0, 0.0]]);
    // Close enough to see it below all of the lamps.
    let camera = looking([at[0], at[1] - 0.006, 0.004], [at[0], at[1], 0.0], 1e-4, 1);
    let materials = vec![diffuse("floor", [0.5; 3]), diffuse("black", [0.0; 3])];
    let shapes = std::iter::once(shape(floor, "floor")).chain(lamp).collect();
    Scene { lights: light.into_iter().collect(), ..scene(camera, 2, materials, shapes) }
}

#[test]
fn lamps_light_a_floor_as_radiometry_says() {
    // The lamp's radiance is 2; the floor sends on ρ E/π.
    let two = [2.0; 3];
    let places = [[0.0, 0.0], [0.9, 0.2], [3.0, -1.0]];
    let mut tried = Vec::new();
    for at @ [x, y] in places {
        let aside = f64::hypot(x, y);
        let seen = |p: [f64; 3]| [p[0] - x, p[1] - y, p[2]];
        let corners = [[-0.5, -0.4, 1.0], [-0.5, 0.6, 1.0], [0.5, 0.6, 1.0], [0.5, -0.4, 1.0]];
        let lamp = shining(shape(quad(corners), "black"), two, false);
        tried.push((
            at,
            "a parallelogram",
            lit(Some(lamp), None, at),
            polygon::irradiance(&corners.map(seen), [0.0, 0.0, 1.0]),
        ));
        // Close above the floor, beside which a lamp's light is hardest to draw.
        let low = corners.map(|[x, y, _]| [x, y, 0.05]);
        let lamp = shining(shape(quad(low), "black"), two, false);
        tried.push((at, "a low one", lit(Some(lamp), None, at), polygon::irradiance(&low.map(seen), [0.0, 0.0, 1.0])));
        let round = Geometry::Disc { center: [0.0, 0.0, 0.7], normal: [0.0, 0.0, -3.0], radius: 0.6 };
        let lamp = shining(shape(round, "black"), two, false);
        let exact = Disc { radius: 0.6, height: 0.7, offset: aside, tilt: 0.0 }.irradiance();
        tried.push((at, "a disc", lit(Some(lamp), None, at), exact));
        // A ball that the floor cuts: its light comes from above the horizon alone.
        for (name, height) in [("a ball", 0.8), ("a ball on the floor", 0.4), ("a sunk ball", 0.2)] {
            let ball = Geometry::Sphere { center: [0.0, 0.0, height], radius: 0.39 };
            let distance = f64::hypot(aside, height);
            if distance > 0.39 {
                let lamp = shining(shape(ball, "black"), two, false);
                let exact = Sphere { radius: 0.39, distance, omega: (height / distance).acos() }.irradiance();
                tried.push((at, name, lit(Some(lamp), None, at), exact));
            }
        }
        let bulb = Light::Point { position: [0.1, 0.0, 0.9], intensity: [3.0; 3] };
        let (dx, dy) = (0.1 - x, -y);
        let distance = (dx * dx + dy * dy + 0.81).sqrt();
        let exact = radiometry::point(3.0 * 4.0 * std::f64::consts::PI / 2.0, distance, (0.9 / distance).acos());
        tried.push((at, "a point", lit(None, Some(bulb), at), exact));
    }
    let least = sidak(SIGNIFICANCE, 2 * tried.len());
    for (at, name, scene, irradiance) in tried {
        let exact = 0.5 / std::f64::consts::PI * 2.0 * irradiance.expect("a lamp");
        // Seeds apart are independent; a seed's own points are not, and are the better for it.
        let lanes = runs(64, |seed| fast::<F32x8>(&scene, &Tactics::default(), 64, seed));
        let both = runs(32, |seed| simple(&scene, &INTEGRATORS[3], 64, seed));
        for (how, found) in [("lanes", lanes), ("both", both)] {
            let off = found.mean() / exact - 1.0;
            // Besides noise: in f32 rays begin off this floor by 4 ε · 12 m, which is 3e-5 of the way to the nearest lamp's middle.
            let test = z_test(found.mean(), found.standard_error().max(3e-5 * exact), exact);
            assert!(test.p > least, "{name} at {at:?} by {how}: {off:.1e} off, p = {:.1e}", test.p);
            assert!(
                off.abs() < 1e-3 || found.standard_error() > 3e-4 * exact,
                "{name} at {at:?} by {how}: {off:.1e} off"
            );
        }
    }
}

#[test]
fn a_closed_room_that_glows_is_as_bright_as_its_series() {
    // L = L_e (1 + ρ + … + ρ^(d − 1)) with paths of d edges, within a ball that shines inwards.
    for (depth, rho) in [(1, 0.8), (2, 0.8), (5, 0.8), (40, 0.8)] {
        let ball = shape(Geometry::Sphere { center: [0.0; 3], radius: 2.0 }, "wall");
        let mut room = scene(
            looking([0.3, 0.1, -0.4], [0.0, 0.0, 1.0], 60.0, 4),
            depth,
            vec![diffuse("wall", [rho; 3])],
            vec![shining(ball, [1.0; 3], true)],
        );
        let exact = (1.0 - rho.powi(depth as i32)) / (1.0 - rho);
        let found = runs(16, |seed| fast::<F32x8>(&room, &Tactics::default(), 32, seed));
        let test = z_test(found.mean(), found.standard_error().max(1e-6), exact);
        assert!(test.p > SIGNIFICANCE / 8.0, "{depth} edges: {} against {exact}", found.mean());
        if depth == 40 {
            // Without a limit chance alone ends paths, and takes nothing.
            room.max_depth = None;
            let found = runs(16, |seed| fast::<F32x8>(&room, &Tactics::default(), 32, seed));
            let test = z_test(found.mean(), found.standard_error(), 1.0 / (1.0 - rho));
            assert!(test.p > SIGNIFICANCE / 8.0, "without a limit: {} against {}", found.mean(), 1.0 / (1.0 - rho));
        }
    }
}

/// A film that reflects some colours more than others and absorbs none.
fn veil() -> Coating {
    Coating { medium: "diamond".into(), thickness_nm: 300.0 }
}

#[test]
fn white_bodies_in_a_white_world_cannot_be_seen() {
    use crate::bsdf::microfacet::{Joint, Slopes};
    use crate::scene::{Energy, Facets, Metal};
    let facets = Facets { alpha: [0.3; 2], slopes: Slopes::Ggx };
    let white = Metal::Indices { eta: [0.0; 3], k: [1.0; 3] };
    let rough = |coating| {
        let (metal, masking, energy) = (white.clone(), Joint::Correlated, Energy::Compensated);
        Material::RoughConductor { metal, facets, masking, energy, coating }
    };
    let bodies = [
        ("diffuse", Material::Diffuse { reflectance: [1.0; 3] }, 1e-5),
        ("rough diffuse", Material::RoughDiffuse { reflectance: [1.0; 3], roughness: 0.5 }, 1e-5),
        ("mirror", Material::Mirror { reflectance: [1.0; 3] }, 1e-5),
        ("conductor", Material::Conductor { metal: white.clone(), coating: None }, 1e-5),
        // The compensation's own promise.
        ("rough conductor", rough(None), 1e-3),
        ("coated rough conductor", rough(Some(veil())), 1e-3),
        ("glass", Material::Dielectric { ior: 1.5, outside: 1.0, absorption: [0.0; 3], coating: None }, 1e-5),
        (
            "coated glass",
            Material::Dielectric { ior: 1.5, outside: 1.0, absorption: [0.0; 3], coating: Some(veil()) },
            1e-5,
        ),
        ("plastic", Material::Plastic { ior: 1.5, reflectance: [1.0; 3], alpha: None }, 1e-4),
    ];
    for (name, body, limit) in bodies {
        let ball = shape(Geometry::Sphere { center: [0.0, 0.0, 3.0], radius: 1.0 }, "body");
        let camera = looking([0.0; 3], [0.0, 0.0, 1.0], 40.0, 8);
        let mut world = scene(camera, 64, vec![("body".into(), body)], vec![ball]);
        world.environment = Some(Environment::Constant([1.0; 3]));
        let found = green(&fast::<F32x8>(&world, &Tactics::default(), 64, 7));
        let off = (found.mean() - 1.0).abs();
        assert!(off < limit + 4.0 * found.standard_error(), "{name}: {} ± {}", found.mean(), found.standard_error());
    }
}

#[test]
fn absorption_is_that_of_the_way_through() {
    // Seen along the diameter, glass of index 1 is a filter of its length, and nothing else.
    let glass = Material::Dielectric { ior: 1.0, outside: 1.0, absorption: [0.2, 0.5, 1.0], coating: None };
    let ball = shape(Geometry::Sphere { center: [0.0, 0.0, 3.0], radius: 0.7 }, "glass");
    let camera = looking([0.0; 3], [0.0, 0.0, 1.0], 1e-3, 1);
    let mut world = scene(camera, 8, vec![("glass".into(), glass)], vec![ball]);
    world.environment = Some(Environment::Constant([1.0; 3]));
    let [[half, _]] = fast::<F32x8>(&world, &Tactics::default(), 8, 0)[..] else { panic!("one pixel") };
    for (seen, a) in half.into_iter().zip([0.2_f64, 0.5, 1.0]) {
        assert!((f64::from(seen) - (-1.4 * a).exp()).abs() < 1e-5, "{seen}");
    }
}
