//! Light that rough but polished surfaces cast: found by chance, by rays to lamps and by paths from lamps.

use super::*;
use crate::bsdf::microfacet::{Joint, Slopes};
use crate::scene::{Energy, Facets, Metal};

fn facets(alpha: f64) -> Facets {
    Facets { alpha: [alpha; 2], slopes: Slopes::Ggx }
}

fn silver(alpha: f64, energy: Energy) -> Material {
    Material::RoughConductor {
        metal: Metal::Named("silver".into()),
        facets: facets(alpha),
        masking: Joint::Correlated,
        energy,
        coating: None,
    }
}

fn frosted(alpha: f64) -> Material {
    Material::RoughDielectric {
        ior: 1.5,
        outside: 1.0,
        absorption: [0.0; 3],
        facets: facets(alpha),
        energy: Energy::Compensated,
    }
}

/// A room with a polished ball under its lamp, and a small lamp that is a ball.
fn gleam(material: Material, pixels: u32) -> Scene {
    let mut gleam = room(pixels);
    gleam.max_depth = Some(5);
    gleam.materials.push(("polished".into(), material));
    gleam.shapes.retain(|shape| !matches!(shape.geometry, Geometry::Box { .. }));
    gleam.shapes.push(shape(Geometry::Sphere { center: [0.4, 0.25, 0.5], radius: 0.25 }, "polished"));
    let bulb = Geometry::Sphere { center: [0.85, 0.6, 0.5], radius: 0.05 };
    gleam.shapes.push(shining(shape(bulb, "white"), [40.0, 30.0, 20.0], false));
    gleam
}

fn noise(picture: &[Halves]) -> f64 {
    picture.iter().map(|halves| f64::from(halves[0][1] - halves[1][1]).powi(2)).sum()
}

#[test]
fn light_cast_by_polished_balls_is_what_other_ways_find_and_quieter() {
    let kinds = [
        ("silver of 0.03", silver(0.03, Energy::Compensated)),
        ("silver of 0.2", silver(0.2, Energy::Single)),
        ("frosted glass", frosted(0.1)),
    ];
    let least = sidak(SIGNIFICANCE, 2 * kinds.len());
    for (name, material) in kinds {
        let gleam = gleam(material, 16);
        let cast = filmed(&gleam, &with(Tactics::default(), 1), &[0..256]).halves();
        let plain = Tactics { caustics: false, ..Tactics::default() };
        let without = filmed(&gleam, &with(plain, 2), &[0..256]).halves();
        let by_both = simple(&gleam, &INTEGRATORS[3], 1024, 3);
        for (other, picture) in [("without", &without), ("both", &by_both)] {
            let p = normal_two_sided(apart(&cast, picture));
            assert!(p > least, "{name} against {other}: p = {p:.1e}");
        }
        assert!(noise(&cast) < noise(&without), "{name}: {} against {}", noise(&cast), noise(&without));
    }
}

#[test]
fn lanes_cast_as_single_paths_do() {
    let gleam = gleam(silver(0.1, Energy::Compensated), 6);
    let [single, eight, most] =
        [1, 8, 16].map(|lanes| filmed(&gleam, &with(Tactics { lanes, ..Tactics::default() }, 1), &[0..8]));
    assert_eq!(eight, single);
    assert_eq!(most, single);
}

#[test]
fn what_is_too_rough_or_walks_casts_nothing() {
    let follows = |material| {
        let stage = Stage::<F32x8>::new(&gleam(material, 4), Structure::Best).expect("a scene without a flaw");
        stage.caustics().is_some()
    };
    assert!(follows(silver(0.1, Energy::Compensated)));
    assert!(!follows(silver(0.1, Energy::Walk)));
    assert!(!follows(silver(0.6, Energy::Compensated)));
}
