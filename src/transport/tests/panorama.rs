//! Light from an image all around.

use super::*;
use crate::bsdf::microfacet::{Joint, Slopes};
use crate::scene::image::edge;
use crate::scene::{Energy, Facets, Image, Metal, Sky};
use crate::transport::simple::RARE;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;
use yardstick::statistics::welch;

fn sky([width, height]: [u32; 2], rotate_deg: f64, texel: impl Fn([u32; 2]) -> [f32; 3]) -> Environment {
    let texels = (0..height).flat_map(|row| (0..width).map(move |column| [column, row])).map(texel).collect();
    let image = Arc::new(Image::new([width, height], texels).expect("as many"));
    Environment::Image(Sky { file: None, image, scale: 1.0, rotate_deg })
}

/// A floor of albedo ½ whose normal is y, under a sky, seen from above.
fn floor(sky: Environment, pixels: u32) -> Scene {
    let floor = shape(quad([[-9.0, 0.0, -9.0], [-9.0, 0.0, 9.0], [9.0, 0.0, 9.0], [9.0, 0.0, -9.0]]), "grey");
    let camera = Camera { up: [0.0, 0.0, 1.0], ..looking([0.0, 2.0, 0.0], [0.0; 3], 30.0, pixels) };
    Scene { environment: Some(sky), ..scene(camera, 2, vec![diffuse("grey", [0.5; 3])], vec![floor]) }
}

#[test]
fn one_bright_texel_lights_a_floor_as_it_must_and_at_once() {
    // E = L ∫cos θ dω = L Δφ (sin²θ₁ − sin²θ₀)/2, and the floor shows ρE/π.
    let ([width, height], [column, row], light) = ([64, 32], [40, 10], 1000.0);
    let [above, below] = [row, row + 1].map(|row| edge(row, height));
    let irradiance = light * TAU / f64::from(width) * (above * above - below * below) / 2.0;
    let exact = 0.5 * irradiance / PI;
    let bright = |at: [u32; 2]| if at == [column, row] { [light as f32; 3] } else { [0.0; 3] };
    let floor = floor(sky([width, height], 30.0, bright), 1);
    // A ray to the texel sees it at cosines that differ by no more than its edges do; a direction by the surface finds it with
    // the chance P = E/(πL) and counts then by about P, which adds P to the relative variance. Alone it would have 1/P.
    let chance = irradiance / (PI * light);
    let most = chance.sqrt() + (above - below) / (above + below);
    let scatter = |tactics: &Tactics, runs: u64| {
        let found = super::runs(runs, |seed| fast::<F32x8>(&floor, tactics, 1, seed));
        (found.variance().sqrt() / found.mean(), found)
    };
    let (relative, found) = scatter(&Tactics { pilot: false, ..Tactics::default() }, 2048);
    let p = t_test(&found, exact).p;
    assert!(p > SIGNIFICANCE && relative < most, "p = {p:.1e}, {relative} of at most {most}");
    let alone = Tactics { meeting: Meeting::Chance, pilot: false, ..Tactics::default() };
    let (relative, _) = scatter(&alone, 4096);
    assert!(relative > 5.0 * most, "by chance alone: {relative}");
    // The integrators to read, too; the slip of counting both ways of meeting it fails by far.
    for integrator in INTEGRATORS.iter().filter(|one| ["lamps", "both"].contains(&one.name)) {
        let found = super::runs(512, |seed| simple(&floor, integrator, 1, seed));
        let p = t_test(&found, exact).p;
        assert!(p > SIGNIFICANCE, "{}: p = {p:.1e}", integrator.name);
        assert!(t_test(&found, 1.1 * exact).p < 1e-9);
    }
}

/// Something of each kind under a sky of all colours.
fn yard(sky: Environment, pixels: u32) -> Scene {
    let gold = Material::RoughConductor {
        metal: Metal::Named("gold".into()),
        facets: Facets { alpha: [0.2; 2], slopes: Slopes::Ggx },
        masking: Joint::Correlated,
        energy: Energy::Compensated,
        coating: None,
    };
    let ball = |x: f64, material: &str| shape(Geometry::Sphere { center: [x, 0.5, 0.0], radius: 0.5 }, material);
    let mut yard = floor(sky, pixels);
    yard.max_depth = Some(4);
    yard.camera = Camera { up: Camera::UP, ..looking([0.0, 1.5, -4.0], [0.0, 0.6, 0.0], 40.0, pixels) };
    yard.materials.extend([("gold".into(), gold), ("mirror".into(), Material::Mirror { reflectance: [0.9; 3] })]);
    yard.shapes.extend([ball(-1.1, "gold"), ball(0.0, "grey"), ball(1.1, "mirror")]);
    yard
}

fn colourful([column, row]: [u32; 2]) -> [f32; 3] {
    match (column, row) {
        (5, 2) => [40.0, 30.0, 20.0],
        (_, 4..) => [0.0, 0.05, 0.0],
        _ => [0.2 + 0.1 * column as f32, 0.3, 0.1 * row as f32],
    }
}

#[test]
fn all_integrators_make_the_same_picture_of_a_sky() {
    let yard = yard(sky([16, 8], 75.0, colourful), 12);
    let quick = |tactics: Tactics, seed| fast::<F32x8>(&yard, &tactics, 128, seed);
    let mut pictures = vec![
        ("fast", quick(Tactics::default(), 1)),
        ("fast, blind", quick(Tactics { blind_choice: true, pilot: false, ..Tactics::default() }, 3)),
        ("fast, by lamps", quick(Tactics { meeting: Meeting::Lamps, ..Tactics::default() }, 4)),
    ];
    for integrator in INTEGRATORS.iter().filter(|integrator| integrator.name != "hemisphere") {
        let pairs = if integrator.name == "surface" { 256 } else { 64 };
        pictures.push((integrator.name, simple(&yard, integrator, pairs, 2)));
    }
    let cached = filmed(&yard, &Manner { method: Method::Cached, ..Manner::default() }, &[0..64]).halves();
    let least = sidak(SIGNIFICANCE, pictures.len() * (pictures.len() - 1) / 2);
    for (k, (name, one)) in pictures.iter().enumerate() {
        for (other_name, other) in &pictures[..k] {
            let p = normal_two_sided(apart(one, other));
            assert!(p > least, "{name} against {other_name}: p = {p:.1e}");
        }
    }
    // By records it is interpolated: as near as elsewhere.
    let of = |picture: &[Halves]| green(picture).mean();
    assert!((of(&cached) / of(&pictures[0].1) - 1.0).abs() < 0.04, "{} {}", of(&cached), of(&pictures[0].1));
}

#[test]
fn what_is_known_of_polarisation_changes_no_light_of_a_sky() {
    let mut yard = yard(sky([16, 8], 75.0, colourful), 8);
    yard.shapes.retain(|shape| shape.material != "gold");
    yard.materials.retain(|(name, _)| name != "gold");
    let polarised = RARE.iter().find(|one| one.name == "polarised").expect("one of them");
    let p =
        normal_two_sided(apart(&simple(&yard, polarised, 64, 1), &fast::<F32x8>(&yard, &Tactics::default(), 64, 2)));
    assert!(p > SIGNIFICANCE, "p = {p:.1e}");
}

#[test]
fn an_image_of_one_texel_is_a_constant_sky() {
    let [image, constant] = [sky([1, 1], 0.0, |_| [0.4, 0.5, 0.6]), Environment::Constant([0.4, 0.5, 0.6])]
        .map(|sky| runs(64, |seed| fast::<F32x8>(&yard(sky.clone(), 4), &Tactics::default(), 8, seed)));
    let p = welch(&image, &constant).p;
    assert!(p > SIGNIFICANCE, "p = {p:.1e}");
}

#[test]
fn a_sky_is_seen_where_its_texels_lie() {
    // Nothing but sky. The camera looks to +z, where the image's middle is: what is right in the picture is right in the image.
    let each = |[column, row]: [u32; 2]| [column as f32, row as f32, 1.0];
    let seen = |target: [f64; 3], rotate_deg: f64| {
        let camera = Camera { up: Camera::UP, ..looking([0.0; 3], target, 40.0, 2) };
        let all = Scene { environment: Some(sky([8, 4], rotate_deg, each)), ..scene(camera, 1, vec![], vec![]) };
        let by_fast: Vec<_> = fast::<F32x8>(&all, &Tactics::default(), 4, 0).iter().map(|halves| halves[0]).collect();
        let by_reading: Vec<_> = simple(&all, &INTEGRATORS[3], 4, 0).iter().map(|halves| halves[1]).collect();
        assert_eq!(by_fast, by_reading);
        by_fast.into_iter().map(|[column, row, _]| [column, row]).collect::<Vec<_>>()
    };
    // Pixels row by row from the top left.
    assert_eq!(seen([0.0, 0.0, 1.0], 0.0), [[3.0, 1.0], [4.0, 1.0], [3.0, 2.0], [4.0, 2.0]]);
    // To the left of that is +x.
    assert_eq!(seen([1.0, 0.0, 0.0], 0.0), [[1.0, 1.0], [2.0, 1.0], [1.0, 2.0], [2.0, 2.0]]);
    // A quarter turn takes z to x.
    assert_eq!(seen([1.0, 0.0, 0.0], 90.0), seen([0.0, 0.0, 1.0], 0.0));
    assert_eq!(seen([0.0, 0.0, -1.0], 0.0), [[7.0, 1.0], [0.0, 1.0], [7.0, 2.0], [0.0, 2.0]]);
}

#[test]
fn a_sky_asks_for_what_it_needs_and_no_more() {
    let needs = |sky: Environment| {
        let all = floor(sky, 1);
        *Renderer::new(&all, &Manner::default(), 1).expect("a scene without a flaw").needs()
    };
    let left_out = |sky: Environment| -> Vec<_> { needs(sky).left_out().iter().map(|one| one.what).collect() };
    let image = needs(sky([2, 2], 0.0, |_| [1.0; 3]));
    assert!(image.environment && image.panorama && image.lamps == 1 && !image.rims && !image.bare_lights);
    assert!(!left_out(sky([2, 2], 0.0, |_| [1.0; 3])).contains(&"rays to the sky"));
    let constant = needs(Environment::Constant([1.0; 3]));
    assert!(constant.environment && !constant.panorama && constant.lamps == 0);
    assert!(left_out(Environment::Constant([1.0; 3])).contains(&"rays to the sky"));
    let black = needs(sky([2, 2], 0.0, |_| [0.0; 3]));
    assert!(!black.environment && !black.panorama && black.lamps == 0);
    let picture = fast::<F32x8>(&floor(sky([2, 2], 0.0, |_| [0.0; 3]), 2), &Tactics::default(), 2, 0);
    assert!(picture.iter().flatten().all(|half| *half == [0.0; 3]));
}

#[test]
fn eight_lanes_see_a_sky_as_single_paths_do() {
    let yard = yard(sky([16, 8], 10.0, colourful), 6);
    let of = |tactics: &Tactics| {
        assert_eq!(fast::<F32x8>(&yard, tactics, 8, 5), fast::<f32>(&yard, tactics, 8, 5));
    };
    of(&Tactics::default());
    of(&Tactics { blind_choice: true, ..Tactics::default() });
}
