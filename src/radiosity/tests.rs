//! Closed forms against sums, and networks against rooms whose light is known.

use super::exact::{Wall, sphere};
use super::exchange::{by_middles, by_rim, exchange, parallel, perpendicular};
use super::{Light, Network, Patch, Room, solve, spectrum};
use crate::radiometry::form_factor;
use crate::scene::builtin;

/// A frame that is along no axis.
fn turned(patch: Patch) -> Patch {
    let ([a, b], [c, d]) = ([0.6, 0.8], [5.0 / 13.0, 12.0 / 13.0]);
    let turn = |[x, y, z]: [f64; 3]| {
        let (x, y) = (a * x - b * y, b * x + a * y);
        [x, c * y - d * z, d * y + c * z]
    };
    Patch { corner: turn(patch.corner), edges: patch.edges.map(turn) }
}

#[test]
fn closed_forms_are_those_of_the_catalogue() {
    for (a, b, c) in [(1.0, 1.0, 1.0), (2.0, 0.5, 0.3), (0.1, 3.0, 1.0)] {
        let found = parallel([[0.0, a], [0.0, b]], [[0.0, a], [0.0, b]], c) / (a * b);
        let exact = form_factor::parallel_rectangles(a, b, c).unwrap();
        assert!((found / exact - 1.0).abs() < 1e-12, "{a} {b} {c}: {found} {exact}");
        let found = perpendicular([0.0, a], [0.0, c], [0.0, b], [0.0, b]) / (a * b);
        let exact = form_factor::perpendicular_rectangles(a, c, b).unwrap();
        assert!((found / exact - 1.0).abs() < 1e-12, "{a} {b} {c}: {found} {exact}");
    }
}

#[test]
fn closed_forms_are_sums_over_pairs_of_points_wherever_the_patches_are() {
    let floor = Patch { corner: [0.0, 0.0, 0.0], edges: [[1.0, 0.0, 0.0], [0.0, 0.7, 0.0]] };
    let others = [
        Patch { corner: [0.4, -2.0, 1.5], edges: [[0.0, 0.9, 0.0], [1.2, 0.0, 0.0]] },
        Patch { corner: [-0.5, 0.2, 0.6], edges: [[0.0, 1.1, 0.0], [0.0, 0.0, 0.5]] },
        // Partly below the floor's horizon, and with some of the floor behind it.
        Patch { corner: [0.6, 0.9, 0.4], edges: [[0.0, 0.0, 1.0], [0.0, 0.8, 0.0]] },
        Patch { corner: [5.0, 9.0, 17.0], edges: [[0.0, 0.5, 0.0], [0.5, 0.0, 0.0]] },
    ];
    for other in others {
        let found = exchange(&floor, &other);
        let [points, _] = by_middles(&floor, &other, 40, |_, _| true);
        assert!((found / points - 1.0).abs() < 2e-3 && found > 0.0, "{other:?}: {found} against {points}");
        for (one, other) in [(other, floor), (turned(floor), turned(other)), (turned(other), turned(floor))] {
            assert!((exchange(&one, &other) / found - 1.0).abs() < 1e-10, "{other:?}");
        }
        assert!((by_rim(&floor, &other, 32) / found - 1.0).abs() < 2e-3, "{other:?}");
    }
    // Behind.
    assert_eq!(exchange(&floor, &Patch { corner: [0.0, 0.0, -1.0], ..others[0] }), 0.0);
}

#[test]
fn every_patch_of_a_box_sees_all_of_it() {
    let patches = Room::cuboid([1.0, 2.0, 0.5], [(0.5, 1.0); 6]).cut(4);
    let network = Network::of(&patches);
    for at in 0..network.len() {
        let sum: f64 = network.row(at).iter().sum();
        // Sixteen terms of up to the box's square over a patch's area, 2⁴ … 2⁷ of them in a row.
        assert!((sum - 1.0).abs() < 1e-12, "{at}: {}", sum - 1.0);
    }
}

#[test]
fn all_solvers_agree() {
    let faces = [(0.5, 1.0), (0.2, 0.0), (0.9, 0.3), (0.4, 0.0), (0.1, 0.0), (0.7, 0.2)];
    let patches = Room::cuboid([1.0, 0.8, 0.5], faces).cut(3);
    let (network, light) = (Network::of(&patches), Light::of(&patches, 1));
    let exact = solve::direct(&network, &light);
    let found = [
        solve::series(&network, &light, 200),
        solve::seidel(&network, &light, 100),
        solve::shooting(&network, &light, 10_000).0,
        solve::conjugate(&network, &light, 60),
        solve::plain(&network, &light),
    ];
    for (way, found) in found.iter().enumerate() {
        for (one, other) in found.iter().zip(&exact) {
            assert!((one / other - 1.0).abs() < 1e-12, "{way}: {one} {other}");
        }
    }
}

#[test]
fn a_sphere_of_pieces_is_as_bright_as_is_known_however_white() {
    let shares = [0.1, 0.3, 0.15, 0.45];
    for white in [0.5, 1e-9, 1e-15, 1e-30] {
        let walls = [1.0, 2.0, 0.5, 3.0].map(|a| Wall { absorbed: white * a / 3.0, emitted: a });
        let pieces: Vec<_> = shares.into_iter().zip(walls).collect();
        let light = Light { absorbed: walls.map(|w| w.absorbed).into(), emitted: walls.map(|w| w.emitted).into() };
        let found = solve::direct(&Network::sphere(&shares), &light);
        for (one, other) in found.iter().zip(sphere(&pieces)) {
            assert!((one / other - 1.0).abs() < 32.0 * f64::EPSILON, "{white}: {one} {other}");
        }
    }
}

#[test]
fn modes_are_bounced_into_themselves() {
    let faces = [(0.5, 1.0), (0.2, 0.0), (0.9, 0.3), (0.4, 0.0), (0.1, 0.0), (0.7, 0.2)];
    let patches = Room::cuboid([1.0, 0.8, 0.5], faces).cut(2);
    let (network, light) = (Network::of(&patches), Light::of(&patches, 0));
    let modes = spectrum::modes(&network, &light);
    for mode in &modes {
        for at in 0..network.len() {
            let bounced = light.reflected(at) * network.arriving(at, &mode.radiances);
            assert!((bounced - mode.value * mode.radiances[at]).abs() < 1e-13, "{}", mode.value);
        }
    }
    // No patch sees itself.
    assert!(modes.iter().map(|mode| mode.value).sum::<f64>().abs() < 1e-13);
    assert!(spectrum::radius(&modes) < 0.9 && spectrum::condition(&modes) > 1.0);
}

#[test]
fn rooms_are_made_of_scenes_that_are_flat_and_diffuse() {
    let scene = |name: &str| (builtin::named(name).unwrap().make)();
    let room = Room::of(&scene("cornell")).unwrap();
    assert_eq!(room.faces.len(), 16);
    let network = Network::of(&room.cut(1));
    for at in 0..network.len() {
        let sum: f64 = network.row(at).iter().sum();
        // Nobody sees more than the whole, but for what points on slanted faces that touch leave uncertain (`Network::of`).
        assert!(sum > 0.3 && sum < 1.1, "{at}: {sum}");
    }
    for (name, place) in [("glass", "shapes[6].geometry"), ("veach", "shapes[0].geometry")] {
        assert_eq!(Room::of(&scene(name)).unwrap_err().place.to_string(), place);
    }
}
