//! What light owes to nature: energy through glass, the same both ways, and pictures that know how wrong they are.

use super::*;
use crate::optics::fresnel::natural_reflectance;
use crate::scene::{Energy, Facets, Metal};
use crate::transport::estimate::{DARK, Estimate, colour, relative_mse_less, variance};
use std::f64::consts::PI;
use yardstick::statistics::{t_test, welch};

/// A slab of glass above a floor, a lamp far smaller than anything above it, and a camera below it that looks down on a square
/// of the floor.
mod slab {
    pub const INDEX: f64 = 1.5;
    pub const THICKNESS: f64 = 0.3;
    pub const BELOW: f64 = 1.0;
    pub const LAMP: f64 = 4.0;
    pub const RADIUS: f64 = 0.01;
    pub const RADIANCE: f64 = 1e5;
    pub const CAMERA: f64 = 0.9;
    /// Half a side of the square that is seen.
    pub const SEEN: f64 = 0.5;
    pub const RHO: f64 = 0.5;
}

fn under_a_slab(pixels: u32) -> Scene {
    use slab::*;
    let angle = 2.0 * (SEEN / CAMERA).atan().to_degrees();
    let camera = looking([0.0, 0.0, CAMERA], [0.0, 0.0, 0.0], angle, pixels);
    let glass = Material::Dielectric { ior: INDEX, outside: 1.0, absorption: [0.0; 3], coating: None };
    let materials = vec![diffuse("floor", [RHO; 3]), diffuse("black", [0.0; 3]), ("glass".into(), glass)];
    let lamp = Geometry::Disc { center: [0.0, 0.0, LAMP], normal: [0.0, 0.0, -1.0], radius: RADIUS };
    let shapes = vec![
        shape(quad([[-4.0, -4.0, 0.0], [4.0, -4.0, 0.0], [4.0, 4.0, 0.0], [-4.0, 4.0, 0.0]]), "floor"),
        shape(Geometry::Box { min: [-0.8, -0.8, BELOW], max: [0.8, 0.8, BELOW + THICKNESS] }, "glass"),
        shining(shape(lamp, "black"), [RADIANCE; 3], false),
    ];
    // Camera, floor, two faces of the glass, lamp: what is reflected within the glass needs two edges more.
    scene(camera, 4, materials, shapes)
}

/// Irradiance [W m⁻²] at a distance from the axis: what leaves the lamp within a cone dθ, less what both faces reflect, comes
/// down on a ring.
fn below_a_slab(aside: f64) -> f64 {
    use slab::*;
    let inside = |theta: f64| (theta.sin() / INDEX).asin();
    let place = |theta: f64| (LAMP - THICKNESS) * theta.tan() + THICKNESS * inside(theta).tan();
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if place(middle) < aside { low = middle } else { high = middle }
    }
    let theta: f64 = 0.5 * (low + high);
    let (cos, cos_inside) = (theta.cos(), inside(theta).cos());
    let spread = (LAMP - THICKNESS) / (cos * cos) + THICKNESS / (cos_inside * cos_inside) * cos / (INDEX * cos_inside);
    let mut reflected = [0.0_f64];
    natural_reflectance(&[cos], 1.0, INDEX, &mut reflected);
    let kept = (1.0 - reflected[0]).powi(2);
    RADIANCE * PI * RADIUS * RADIUS * cos * kept * theta.sin() / (aside * spread)
}

#[test]
fn a_slab_lets_through_what_fresnel_leaves() {
    use slab::*;
    const STEPS: usize = 64;
    let scene = under_a_slab(12);
    let place = |k: usize| SEEN * (2.0 * (k as f64 + 0.5) / STEPS as f64 - 1.0);
    let all = (0..STEPS * STEPS).map(|k| below_a_slab(f64::hypot(place(k % STEPS), place(k / STEPS))));
    let exact = RHO / PI * all.sum::<f64>() / (STEPS * STEPS) as f64;
    let mean = |halves: Vec<Halves>| green(&halves).mean();
    let found: Moments =
        (0..24).map(|seed| mean(filmed(&scene, &with(Tactics::default(), seed), &[0..64]).halves())).collect();
    let test = t_test(&found, exact);
    assert!(test.p > SIGNIFICANCE, "{} ± {} against {exact}", found.mean(), found.standard_error());
    // So sharp that the slip of leaving out what the faces reflect, 8 %, is seen; and chance finds next to nothing.
    assert!(found.standard_error() < 0.01 * exact, "{}", found.standard_error());
    let chance = Tactics { caustics: false, ..Tactics::default() };
    assert!(mean(filmed(&scene, &with(chance, 1), &[0..16]).halves()) < 0.5 * exact);
}

/// The room without its lamp, and with metal and plaster in it.
fn workshop() -> Scene {
    let facets = Facets { alpha: [0.3; 2], slopes: crate::bsdf::microfacet::Slopes::Ggx };
    let metal = Material::RoughConductor {
        metal: Metal::Named("copper".into()),
        facets,
        masking: crate::bsdf::microfacet::Joint::Correlated,
        energy: Energy::Compensated,
        coating: None,
    };
    let mut workshop = room(16);
    workshop.shapes.pop();
    let plaster = Material::RoughDiffuse { reflectance: [0.5, 0.6, 0.7], roughness: 0.8 };
    workshop.materials.extend([("metal".into(), metal), ("plaster".into(), plaster)]);
    workshop.shapes[5].material = "metal".into();
    workshop.shapes[2].material = "plaster".into();
    workshop
}

/// The fluence [W m⁻²], ∫L dω over all directions, at a place under a point of unit intensity at another.
fn fluence(lamp: [f64; 3], eye: [f64; 3], seed: u64) -> f64 {
    let mut scene = workshop();
    scene.lights.push(Light::Point { position: lamp, intensity: [1.0; 3] });
    let pixels = scene.camera.width;
    // ∫dω over a part of a face of the cube about the eye, from its middle.
    let corner = |x: f64, y: f64| (x * y / (x * x + y * y + 1.0).sqrt()).atan();
    let at = |k: u32| 2.0 * f64::from(k) / f64::from(pixels) - 1.0;
    let omega = |i: u32, j: u32| {
        corner(at(i + 1), at(j + 1)) - corner(at(i), at(j + 1)) - corner(at(i + 1), at(j)) + corner(at(i), at(j))
    };
    let mut sum = 0.0;
    for face in 0..6 {
        let mut way = [0.0; 3];
        way[face / 2] = if face % 2 == 0 { 1.0 } else { -1.0 };
        let target = [0, 1, 2].map(|axis| eye[axis] + way[axis]);
        let up = if face / 2 == 1 { [0.0, 0.0, 1.0] } else { [0.0, 1.0, 0.0] };
        scene.camera = Camera { up, ..looking(eye, target, 90.0, pixels) };
        let halves = filmed(&scene, &with(Tactics::default(), 6 * seed + face as u64), &[0..32]).halves();
        for (at, halves) in halves.iter().enumerate() {
            let place = at as u32;
            sum += omega(place % pixels, place / pixels) * f64::from(halves[0][1] + halves[1][1]) / 2.0;
        }
    }
    sum
}

#[test]
fn light_goes_both_ways() {
    // Helmholtz: lamp and eye may change places. One beside the metal, the other before the plaster.
    let (a, b) = ([0.35, 0.3, 0.3], [0.6, 0.75, 0.5]);
    let of = |lamp, eye, first: u64| -> Moments { (first..first + 12).map(|seed| fluence(lamp, eye, seed)).collect() };
    let (there, back) = (of(a, b, 0), of(b, a, 100));
    // Within a pixel an eighth wide both the radiance and what a direction counts change by some tenths: a third of their product
    // times a 64th is left besides noise.
    let allowed = 2e-3 * there.mean();
    let noise = there.standard_error().hypot(back.standard_error());
    let apart = (there.mean() - back.mean()).abs();
    assert!(apart < allowed + 4.0 * noise, "{} there, {} back, ± {noise}", there.mean(), back.mean());
    assert!(noise < 2e-3 * there.mean(), "{noise}");
    // The slip of a direction's cosine left out at one end would be seen: a place that faces away differs.
    let elsewhere = of(b, [0.3, 0.3, 0.3], 200);
    assert!(welch(&there, &elsewhere).p < SIGNIFICANCE);
}

/// The hall under a lamp so small that few paths meet what mirror and glass show of it.
fn hall_under_a_small_lamp(pixels: u32) -> Scene {
    let mut hall = hall(pixels);
    for shape in hall.shapes.iter_mut().filter(|shape| shape.emission.is_some()) {
        let corners = [[0.45, 0.99, 0.45], [0.55, 0.99, 0.45], [0.55, 0.99, 0.55], [0.45, 0.99, 0.55]];
        *shape = shining(self::shape(quad(corners), "white"), [128.0, 96.0, 64.0], false);
    }
    hall
}

/// What pictures of so many pairs tell of their errors, over the true ones.
#[derive(Debug)]
struct Told {
    /// On average, and how well that is known.
    ratio: f64,
    noise: f64,
    /// The same from every pixel's own mean alone.
    alone: f64,
    /// How far told errors spread, over what they say that they do.
    spread: f64,
}

fn told_over_true(scene: &Scene, truth: &[Halves], pairs: u32, seeds: u64) -> Told {
    let mut all: [Moments; 4] = Default::default();
    for seed in 0..seeds {
        let halves = filmed(scene, &with(Tactics::default(), seed), &[0..pairs]).halves();
        let estimate = Estimate::of(&halves, scene.camera.width);
        let picture: Vec<_> = halves.iter().map(colour).collect();
        let of = |pixel: &Halves| (0..3).map(|c| variance(pixel)[c] / (colour(pixel)[c].powi(2) + DARK)).sum::<f64>();
        let alone = halves.iter().map(of).sum::<f64>() / (3 * halves.len()) as f64;
        let errors = [estimate.relative_mse, estimate.deviation, alone, relative_mse_less(&picture, truth).0];
        all.iter_mut().zip(errors).for_each(|(moments, error)| moments.add(error));
    }
    let [told, deviation, alone, exact] = all;
    Told {
        ratio: told.mean() / exact.mean(),
        noise: (told.standard_error() / told.mean()).hypot(exact.standard_error() / exact.mean()),
        alone: alone.mean() / exact.mean(),
        spread: told.variance().sqrt() / deviation.mean(),
    }
}

#[test]
fn a_picture_knows_how_wrong_it_is() {
    // So few pixels that many are at edges, which few samples tell least of.
    let room = room(16);
    let truth = filmed(&room, &with(Tactics::default(), 1000), &[0..8192]).halves();
    for (pairs, most) in [(2, 1.4), (4, 1.2), (16, 1.1), (64, 1.1)] {
        let told = told_over_true(&room, &truth, pairs, 64);
        assert!((0.9 - 3.0 * told.noise..most + 3.0 * told.noise).contains(&told.ratio), "{pairs} pairs: {told:?}");
        assert!(told.noise < 0.05, "{pairs} pairs: {told:?}");
        // And how sure they are of it, by how pixels differ: pictures do differ so. 64 of them tell a spread to 1/√128.
        assert!((0.7..1.4).contains(&told.spread), "{pairs} pairs: {told:?}");
    }
}

#[test]
fn what_few_paths_meet_does_not_hide_its_own_error() {
    let hall = hall_under_a_small_lamp(16);
    let truth = filmed(&hall, &with(Tactics::default(), 1000), &[0..2048]).halves();
    for (pairs, seeds) in [(2, 256), (4, 128), (16, 64)] {
        let told = told_over_true(&hall, &truth, pairs, seeds);
        assert!((0.8 - 3.0 * told.noise..1.3 + 3.0 * told.noise).contains(&told.ratio), "{pairs} pairs: {told:?}");
        // Its own mean alone would say too little.
        assert!(told.noise < 0.1 && told.alone < 0.8, "{pairs} pairs: {told:?}");
    }
}
