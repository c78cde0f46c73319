//! Light that is left where it falls.

use super::*;
use crate::number::Vector;
use crate::scene::triple::{minus, times};
use crate::transport::film::added;
use crate::transport::photons::{Map, Photons};

fn staged(of: &Scene) -> Stage<f64> {
    Stage::new(of, Structure::Best).expect("a scene without a flaw")
}

fn by_photons(seed: u64) -> Manner {
    Manner { method: Method::Photons, seed, ..Manner::default() }
}

#[test]
fn a_map_tells_the_mean_of_a_floors_light_over_its_disc() {
    // A floor that returns nothing, under a square lamp: irradiance by Lambert's closed form.
    let floor = shape(quad([[-4.0, -4.0, 0.0], [4.0, -4.0, 0.0], [4.0, 4.0, 0.0], [-4.0, 4.0, 0.0]]), "black");
    let corners = [[-0.5, -0.5, 1.0], [-0.5, 0.5, 1.0], [0.5, 0.5, 1.0], [0.5, -0.5, 1.0]];
    let lamp = shining(shape(quad(corners), "black"), [2.0; 3], false);
    let camera = looking([0.3, 0.2, 3.0], [0.0, 0.0, 0.0], 60.0, 64);
    let world = scene(camera, 4, vec![diffuse("black", [0.0; 3])], vec![floor, lamp]);
    let exact = |x: f64, y: f64| {
        let seen = corners.map(|[a, b, height]| [a - x, b - y, height]);
        2.0 * radiometry::polygon::irradiance(&seen, [0.0, 0.0, 1.0]).expect("a lamp above the floor")
    };
    let ([x, y], radius) = ([0.05, 0.0], 0.35);
    // Even in the weight's own measure, 2(1 − s) ds with s = d²/r², and all around.
    let blurred = (0..64 * 32)
        .map(|k| (f64::from(k / 32) + 0.5, f64::from(k % 32) / 32.0 * std::f64::consts::TAU))
        .map(|(u, turn)| (radius * (1.0 - (1.0 - u / 64.0).sqrt()).sqrt(), turn))
        .map(|(away, turn)| exact(x + away * turn.cos(), y + away * turn.sin()) / (64.0 * 32.0))
        .sum::<f64>();

    let stage = staged(&world);
    let photons = Photons::new(&stage, Choice::Independent, 3);
    let place = Vector::of(times(minus([x, y, 0.0], world.camera.origin), stage.scale()));
    let of = |sample| {
        let map = Map::new(photons.sent(&stage, sample), radius * stage.scale());
        map.irradiance(place, Vector::of([0.0, 0.0, 1.0]), 8)[1]
    };
    let found: Moments = (0..512).map(of).collect();
    assert!((exact(x, y) - blurred).abs() > 5.0 * found.standard_error(), "the blur is not seen");
    let p = t_test(&found, blurred).p;
    assert!(p > SIGNIFICANCE, "{} ± {} against {blurred}: p = {p:.1e}", found.mean(), found.standard_error());
}

#[test]
fn photons_share_out_the_lamps_flux() {
    // In a closed room that returns ρ everywhere what falls in all is Φ(1 + ρ + ρ² + …).
    let mut room = room(32);
    room.materials = vec![diffuse("white", [0.5; 3]), diffuse("red", [0.5; 3])];
    room.shapes.retain(|shape| !matches!(shape.geometry, Geometry::Box { .. }));
    // The side that the camera looks through is a wall too, but for who looks from outside.
    room.camera.origin = [0.5, 0.5, 0.1];
    room.shapes.push(shape(quad([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]), "white"));
    room.max_depth = None;
    let stage = staged(&room);
    let photons = Photons::new(&stage, Choice::Independent, 5);
    let flux = std::f64::consts::PI * 0.16 * 6.0 * stage.scale().powi(2);
    let fallen = |sample| photons.sent(&stage, sample).iter().map(|photon| photon.flux[1]).sum::<f64>();
    let found: Moments = (0..64).map(fallen).collect();
    let p = t_test(&found, flux / (1.0 - 0.5)).p;
    assert!(p > SIGNIFICANCE, "{} ± {}, p = {p:.1e}", found.mean() / flux, found.standard_error() / flux);
}

#[test]
fn pictures_by_photons_are_those_of_paths_but_for_their_blur() {
    for (name, scene) in [("room", room(12)), ("hall", hall(12))] {
        let of = |manner: &Manner, pairs| {
            let halves = filmed(&scene, manner, &[0..pairs]).halves();
            halves.iter().map(|halves| f64::from(halves[0][1] + halves[1][1]) / 2.0).sum::<f64>()
        };
        let found = of(&by_photons(1), 64) / of(&Manner { seed: 2, ..Manner::default() }, 1024);
        assert!((found - 1.0).abs() < 0.02, "{name}: {found}");
    }
}

#[test]
fn no_split_of_samples_by_photons_can_be_told() {
    let room = room(6);
    let renderer = Renderer::new(&room, &by_photons(4), 4).expect("a scene without a flaw");
    let whole = renderer.sums(0..6, 0..4);
    let halves = renderer.sums(0..6, 0..2).into_iter().zip(renderer.sums(0..6, 2..4));
    assert_eq!(whole, halves.map(|(a, b)| added(a, b)).collect::<Vec<_>>());
    assert_eq!(whole, [renderer.sums(0..1, 0..4), renderer.sums(1..6, 0..4)].concat());
}

#[test]
fn radii_shrink_as_is_said() {
    // Knaus and Zwicker's rule, r²ₙ₊₁/r²ₙ = (n + α)/(n + 1) with α = ⅔, has N^−⅓ as its limit.
    let photons = Photons::new(&staged(&hall(8)), Choice::Net, 1);
    let [first, late] = [0, 999].map(|sample| photons.radii(sample));
    let product: f64 = (1..1000).map(|n| (f64::from(n) + 2.0 / 3.0) / (f64::from(n) + 1.0)).product();
    for (first, late) in first.into_iter().zip(late) {
        let ratio = (late / first).powi(2);
        assert!(first > 0.0 && (0.5..2.0).contains(&(ratio / product)), "{first} {late}");
        assert!((ratio - 0.1).abs() < 1e-12, "{ratio}");
    }
}
