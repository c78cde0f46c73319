//! Reflectances that change from place to place.

use super::*;
use crate::bsdf::{Setting, zoo};
use crate::geometry::Ray;
use crate::number::{Vector, length_and_way};
use crate::scene::{Image, Mesh, Normals, Pattern};
use std::sync::Arc;

/// An image whose red is s and whose green is t, but for half a texel at its rim.
fn places() -> Pattern {
    let (side, blue) = (64, 0.25);
    let texel = |k: u32| [(k % side) as f32 + 0.5, (side - 1 - k / side) as f32 + 0.5].map(|x| x / side as f32);
    let texels = (0..side * side).map(texel).map(|[s, t]| [s, t, blue]).collect();
    Pattern::Image { file: None, image: Arc::new(Image::new([side; 2], texels).expect("as many")) }
}

fn patterned(name: &str, pattern: Pattern) -> (String, Material) {
    let plain = Material::Diffuse { reflectance: [0.0; 3] };
    (name.into(), plain.patterned(pattern).expect("what is diffuse has a reflectance"))
}

/// The place (s, t) of a shape where a ray meets it.
fn place(of: &Shape, [from, to]: [[f64; 3]; 2]) -> [f64; 2] {
    let all =
        scene(looking([0.0, 9.0, 9.0], [0.0; 3], 40.0, 1), 1, vec![patterned("drawn", places())], vec![of.clone()]);
    assert_eq!(all.flaw(), None);
    let stage = Stage::<f64>::new(&all, Structure::Best).expect("a scene without a flaw");
    // The stage's lengths and origin are its own.
    let seen = |point: [f64; 3]| {
        Vector::of(std::array::from_fn(|axis| (point[axis] - all.camera.origin[axis]) * stage.scale()))
    };
    let [from, to]: [Vector<f64>; 2] = [seen(from), seen(to)];
    let vertex = stage.meet(&Ray { origin: from, direction: length_and_way(to - from).1 }).expect("a hit");
    let [s, t, blue] = vertex.met.paint();
    assert!((blue - 0.25).abs() < 1e-7);
    [s, t]
}

#[test]
fn every_place_of_every_shape_lies_where_it_is_said() {
    let drawn = |geometry| shape(geometry, "drawn");
    let moved = |geometry, transform| Shape { transform, ..drawn(geometry) };
    let none = Transform::default();
    let turned = Transform { rotate_deg: [0.0, 90.0, 0.0], ..none };
    let mirrored = Transform { scale: [-1.0, 1.0, 1.0], translate: [2.0, 0.0, 0.0], ..none };
    let square = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    let ball = || Geometry::Sphere { center: [0.0; 3], radius: 1.0 };
    let disc = |normal| Geometry::Disc { center: [0.0; 3], normal, radius: 1.0 };
    let cube = || Geometry::Box { min: [-1.0; 3], max: [1.0; 3] };
    let triangle = Geometry::Mesh {
        file: None,
        normals: Normals::Flat,
        mesh: Arc::new(Mesh {
            positions: vec![[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]],
            texture: vec![[0.1, 0.2], [0.9, 0.2], [0.1, 0.6]],
            triangles: vec![[0, 1, 2]],
            ..Mesh::default()
        }),
    };
    // Where it is met from a place this far off.
    let head_on = |to: [f64; 3], off: [f64; 3]| [std::array::from_fn(|axis| to[axis] + off[axis]), to];
    let (x, y, z) = ([3.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 3.0]);
    let lat = std::f64::consts::FRAC_1_SQRT_2;
    let cases = [
        ("quad", drawn(quad(square)), head_on([0.8, 0.3, 0.0], z), [0.8, 0.3]),
        ("quad from behind", drawn(quad(square)), head_on([0.8, 0.3, 0.0], [0.0, 0.0, -3.0]), [0.8, 0.3]),
        // The second corner went from 1 to 2 − 1.
        ("mirrored quad", moved(quad(square), mirrored), head_on([1.2, 0.3, 0.0], z), [0.8, 0.3]),
        ("ball, ahead", drawn(ball()), head_on([0.0, 0.0, 1.0], z), [0.5, 0.5]),
        ("ball, right", drawn(ball()), head_on([1.0, 0.0, 0.0], x), [0.75, 0.5]),
        ("ball, above", drawn(ball()), head_on([0.0, lat, lat], [0.0, 2.0, 2.0]), [0.5, 0.75]),
        ("turned ball", moved(ball(), turned), head_on([1.0, 0.0, 0.0], x), [0.5, 0.5]),
        ("upright disc", drawn(disc([0.0, 0.0, 2.0])), head_on([0.5, -0.25, 0.0], z), [0.75, 0.375]),
        ("lying disc", drawn(disc([0.0, 1.0, 0.0])), head_on([0.5, 0.0, -0.25], y), [0.75, 0.625]),
        ("turned disc", moved(disc([0.0, 0.0, 1.0]), turned), head_on([0.0, -0.25, -0.5], x), [0.75, 0.375]),
        (
            "mirrored disc",
            moved(disc([0.0, 0.0, 1.0]), Transform { scale: [-1.0; 3], ..none }),
            head_on([0.5, 0.25, 0.0], z),
            [0.25, 0.375],
        ),
        ("box, right", drawn(cube()), head_on([1.0, 0.4, -0.6], x), [0.8, 0.7]),
        ("box, left", drawn(cube()), head_on([-1.0, 0.4, -0.6], [-3.0, 0.0, 0.0]), [0.2, 0.7]),
        ("box, front", drawn(cube()), head_on([0.6, 0.4, 1.0], z), [0.8, 0.7]),
        ("box, back", drawn(cube()), head_on([0.6, 0.4, -1.0], [0.0, 0.0, -3.0]), [0.2, 0.7]),
        ("box, top", drawn(cube()), head_on([0.6, 1.0, 0.4], y), [0.8, 0.3]),
        ("box, bottom", drawn(cube()), head_on([0.6, -1.0, 0.4], [0.0, -3.0, 0.0]), [0.8, 0.7]),
        (
            "mirrored box",
            moved(cube(), Transform { scale: [-1.0, 1.0, 1.0], ..none }),
            head_on([-0.6, 0.4, 1.0], z),
            [0.8, 0.7],
        ),
        ("triangle", drawn(triangle.clone()), head_on([0.5, 1.0, 0.0], z), [0.3, 0.4]),
        ("mirrored triangle", moved(triangle, mirrored), head_on([1.5, 1.0, 0.0], z), [0.3, 0.4]),
    ];
    for (name, shape, ray, expected) in cases {
        let found = place(&shape, ray);
        // Texels are single numbers.
        assert!((0..2).all(|k| (found[k] - expected[k]).abs() < 1e-6), "{name}: {found:?}, {expected:?}");
    }
}

/// A floor under a sky of radiance 1 that fills the picture: each pixel shows ρ, whatever the direction.
fn shown(material: Material, pixels: u32) -> Scene {
    // Right in the picture is −x, and up is z.
    let floor = shape(quad([[1.0, 0.0, -1.0], [-1.0, 0.0, -1.0], [-1.0, 0.0, 1.0], [1.0, 0.0, 1.0]]), "drawn");
    let camera = Camera { up: [0.0, 0.0, 1.0], ..looking([0.0, 1.0, 0.0], [0.0; 3], 90.0, pixels) };
    let all = scene(camera, 2, vec![("drawn".into(), material)], vec![floor]);
    Scene { environment: Some(Environment::Constant([1.0; 3])), ..all }
}

#[test]
fn a_checkerboard_returns_what_each_square_must() {
    let colours = [[1.0, 0.5, 0.25], [0.125, 0.0, 1.0]];
    let checker = |scale| patterned("", Pattern::Checker { colours, scale }).1;
    // As many squares as pixels: no noise, for Lambert's directions are drawn by the cosine.
    let board = shown(checker(8.0), 8);
    let picture = fast::<F32x8>(&board, &Tactics::default(), 4, 0);
    assert_eq!(picture, fast::<F32x8>(&Scene { name: "again".into(), ..board.clone() }, &Tactics::default(), 4, 0));
    for (at, halves) in picture.iter().enumerate() {
        // Rows from the top; the lower left square is of the first colour.
        let (column, row) = (at % 8, 7 - at / 8);
        let expected = colours[(column + row) % 2];
        for half in halves {
            assert!((0..3).all(|c| (f64::from(half[c]) - expected[c]).abs() < 2e-6), "{column}, {row}: {half:?}");
        }
    }
    for integrator in INTEGRATORS.iter().filter(|one| one.name != "hemisphere") {
        let found = simple(&board, integrator, 4, 0);
        let near =
            |(a, b): (&Halves, &Halves)| a.iter().flatten().zip(b.iter().flatten()).all(|(a, b)| (a - b).abs() < 2e-6);
        assert!(found.iter().zip(&picture).all(near), "{}", integrator.name);
    }
    // Energy: of an even number of squares, the mean.
    let many = fast::<F32x8>(&shown(checker(64.0), 4), &Tactics::default(), 512, 1);
    for c in 0..3 {
        let mut moments = Moments::default();
        many.iter().flatten().for_each(|half| moments.add(f64::from(half[c])));
        let p = t_test(&moments, 0.5 * (colours[0][c] + colours[1][c])).p;
        assert!(p > SIGNIFICANCE / 3.0, "channel {c}: p = {p:.1e}");
    }
}

#[test]
fn a_white_pattern_is_not_seen_in_a_furnace() {
    let white = || Pattern::Checker { colours: [[1.0; 3]; 2], scale: 3.0 };
    let bases = [
        Material::Diffuse { reflectance: [0.0; 3] },
        Material::RoughDiffuse { reflectance: [0.0; 3], roughness: 0.7 },
        Material::Plastic { ior: 1.5, reflectance: [0.0; 3], alpha: None },
        Material::Plastic { ior: 1.5, reflectance: [0.0; 3], alpha: Some(0.3) },
    ];
    for base in bases {
        let name = format!("{base:?}");
        let found = green(&fast::<F32x8>(
            &shown(base.patterned(white()).expect("a reflectance"), 4),
            &Tactics::default(),
            64,
            1,
        ));
        let p = t_test(&found, 1.0).p;
        // Lambert's has no noise at all.
        assert!((found.mean() - 1.0).abs() < 2e-6 || p > SIGNIFICANCE / 4.0, "{name}: {}, p = {p:.1e}", found.mean());
    }
}

#[test]
fn another_reflectance_is_that_of_a_model_made_with_it() {
    let rho = [0.9, 0.4, 0.05];
    let directions = [[0.3, -0.4, 0.7], [-0.8, 0.1, 0.2], [0.0, 0.0, 1.0], [0.2, 0.9, 0.1]];
    for name in ["lambert", "eon", "plastic", "rough-plastic"] {
        let zoo = zoo::<f64>();
        let entry = zoo.iter().find(|entry| entry.name == name).expect("a model of the zoo");
        let of = |albedo| Setting { albedo, roughness: 0.6, index: 1.5, alpha: [0.3; 2], ..Setting::default() };
        let other = entry.make_painted(&of([0.2, 0.5, 0.7])).expect("a model with a reflectance");
        let own = entry.make(&of(rho));
        for wi in directions {
            for wo in directions {
                let [wi, wo] = [wi, wo].map(|w| length_and_way(Vector::<f64>::of(w)).1);
                let near =
                    |a: [f64; 3], b: [f64; 3]| (0..3).all(|c| (a[c] - b[c]).abs() <= 16.0 * f64::EPSILON * b[c].abs());
                let (painted, made) = (other.painted_eval_pdf(rho, wi, wo), own.eval_pdf(wi, wo));
                assert!(near(painted.0, made.0) && painted.1 == made.1, "{name}: {painted:?}, {made:?}");
                let (painted, made) = (other.painted_sample(rho, wo, [0.3, 0.6, 0.8]), own.sample(wo, [0.3, 0.6, 0.8]));
                assert!(near(painted.weight, made.weight) && painted.pdf == made.pdf, "{name}: {painted:?}, {made:?}");
            }
        }
    }
}

#[test]
fn eight_lanes_see_a_pattern_as_single_paths_do() {
    let mut room = room(8);
    let plastic = Material::Plastic { ior: 1.5, reflectance: [0.0; 3], alpha: Some(0.2) };
    room.materials[0].1 = plastic.patterned(places()).expect("a reflectance");
    room.materials[1] = patterned("red", Pattern::Checker { colours: [[0.7, 0.1, 0.1], [0.2; 3]], scale: 5.0 });
    let of = |tactics: &Tactics| fast::<F32x8>(&room, tactics, 8, 5);
    assert_eq!(of(&Tactics::default()), fast::<f32>(&room, &Tactics::default(), 8, 5));
    // And with all that a picture may do without: to the roundings of models that are asked in another place.
    let with = |needless| filmed(&room, &Manner { needless, ..Manner::default() }, &[0..8]);
    assert_eq!(with(Needless::NOTHING), with(Needless::EVERYTHING));
    let p = normal_two_sided(apart(
        &fast::<F32x8>(&room, &Tactics::default(), 128, 1),
        &simple(&room, &INTEGRATORS[3], 128, 2),
    ));
    assert!(p > SIGNIFICANCE, "p = {p:.1e}");
}
