//! Closed forms against sums, and networks against rooms whose light is known.

use super::exact::{Wall, sphere};
use super::exchange::{around, by_middles, by_rim, exchange, parallel, perpendicular};
use super::{Face, Light, Network, Patch, Room, limit, solve, spectrum};
use crate::radiometry::form_factor;
use crate::scene::builtin;

/// A frame that is along no axis.
fn turned(patch: Patch) -> Patch {
    let ([a, b], [c, d]) = ([0.6, 0.8], [5.0 / 13.0, 12.0 / 13.0]);
    let turn = |[x, y, z]: [f64; 3]| {
        let (x, y) = (a * x - b * y, b * x + a * y);
        [x, c * y - d * z, d * y + c * z]
    };
    Patch { corner: turn(patch.corner), edges: patch.edges.map(turn), ..patch }
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
    let floor = Patch::parallelogram([0.0, 0.0, 0.0], [[1.0, 0.0, 0.0], [0.0, 0.7, 0.0]]);
    let others = [
        Patch::parallelogram([0.4, -2.0, 1.5], [[0.0, 0.9, 0.0], [1.2, 0.0, 0.0]]),
        Patch::parallelogram([-0.5, 0.2, 0.6], [[0.0, 1.1, 0.0], [0.0, 0.0, 0.5]]),
        // Partly below the floor's horizon, and with some of the floor behind it.
        Patch::parallelogram([0.6, 0.9, 0.4], [[0.0, 0.0, 1.0], [0.0, 0.8, 0.0]]),
        Patch::parallelogram([5.0, 9.0, 17.0], [[0.0, 0.5, 0.0], [0.5, 0.0, 0.0]]),
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
        // Nobody sees more than the whole, but for what is hidden in part: of 9 × 9 rays between whole walls, which a block cuts,
        // a row of nine or so is uncertain, of a pair that is a fifth of all.
        assert!(sum > 0.0 && sum < 1.0 + 0.2 / 9.0, "{at}: {sum}");
    }
    for (name, place) in [("glass", "shapes[6].geometry"), ("veach", "shapes[0].geometry")] {
        assert_eq!(Room::of(&scene(name)).unwrap_err().place.to_string(), place);
    }
}

/// A face of a room that absorbs a half.
fn face(patch: Patch) -> Face {
    Face { patch, absorbed: [0.5; 3], emitted: [1.0; 3] }
}

/// A closed room without a right angle: a sheared box.
fn sheared() -> Room {
    let [a, b, c] = [[1.0, 0.2, -0.1], [0.3, 0.9, 0.25], [-0.2, 0.35, 1.2]];
    let plus = |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|axis| a[axis] + b[axis]);
    // Seen from inside: the three at the corner, and the three across.
    let faces = [[a, b], [b, c], [c, a]].map(|edges| face(Patch::parallelogram([0.1; 3], edges)));
    let across = [(c, [b, a]), (a, [c, b]), (b, [a, c])];
    let across = across.map(|(way, edges)| face(Patch::parallelogram(plus([0.1; 3], way), edges)));
    Room { faces: faces.into_iter().chain(across).collect(), is_closed: true }
}

/// A closed room of triangles, no two edges alike.
fn tetrahedron() -> Room {
    let [a, b, c, d] = [[0.0, 0.1, 0.0], [1.3, 0.0, 0.2], [0.2, 0.9, 0.1], [0.4, 0.3, 0.8]];
    let faces = [[a, b, c], [a, c, d], [a, d, b], [b, d, c]].map(|corners| face(Patch::triangle(corners)));
    Room { faces: faces.into(), is_closed: true }
}

#[test]
fn rooms_of_slanted_faces_are_closed() {
    for room in [sheared(), tetrahedron()] {
        for n in [1, 3] {
            let network = Network::of(&room.cut(n));
            for at in 0..network.len() {
                let sum: f64 = network.row(at).iter().sum();
                // A hundred pairs, each some 10⁻¹⁴ of the square of an edge; a patch is a few hundredths.
                assert!((sum - 1.0).abs() < 1e-11, "{n} {at}: {}", sum - 1.0);
            }
        }
    }
}

#[test]
fn around_both_is_what_closed_forms_are_and_the_same_from_either_side() {
    let floor = Patch::parallelogram([0.0; 3], [[1.0, 0.0, 0.0], [0.0, 0.7, 0.0]]);
    let closed = [
        // Hinged, folded over it, across a gap of a millionth, partly behind.
        Patch::parallelogram([0.0; 3], [[0.0, 0.7, 0.0], [0.0, 0.0, 0.4]]),
        Patch::parallelogram([0.0, 0.0, 0.3], [[0.0, 0.7, 0.0], [1.0, 0.0, 0.0]]),
        Patch::parallelogram([0.0, 0.0, 1e-6], [[0.0, 0.7, 0.0], [1.0, 0.0, 0.0]]),
        Patch::parallelogram([0.6, 0.9, -0.4], [[0.0, 0.0, 1.0], [0.0, 0.8, 0.0]]),
    ];
    for other in closed {
        let (found, exact) = (around(&floor, &other), exchange(&floor, &other));
        assert!((found - exact).abs() < 1e-14, "{other:?}: {found} {exact}");
    }
    // Slanted, touching at an edge, at a corner, in the middle of either, or nearly parallel.
    let slanted = [
        Patch::parallelogram([0.0; 3], [[0.0, 0.7, 0.0], [0.4, 0.1, 0.3]]),
        Patch::parallelogram([1.0, 0.7, 0.0], [[-0.2, 0.1, 0.6], [-0.3, 0.5, 0.1]]),
        Patch::parallelogram([0.3, 0.2, 0.0], [[0.2, 0.3, 0.0], [0.1, 0.0, 0.5]]),
        Patch::parallelogram([0.1, 0.1, 0.2], [[0.0, 0.7, 1e-3], [1.0, 0.0, 1e-5]]),
        Patch::triangle([[0.0, 0.0, 0.0], [-0.3, 0.7, 0.2], [0.2, 0.1, 0.9]]),
    ];
    for (at, other) in slanted.into_iter().enumerate() {
        let (found, back) = (exchange(&floor, &other), exchange(&other, &floor));
        assert!((found - back).abs() < 1e-14 && found > 0.0, "{at}: {found} {back}");
        assert!((exchange(&turned(floor), &turned(other)) - found).abs() < 1e-13, "{at}");
        // Lambert's formula for a point, summed over one of them: 1/64² of a piece, or where the other's plane cuts it 1/64 of a
        // row's light.
        let fine = by_rim(&floor, &other, 64);
        assert!((found / fine - 1.0).abs() < 2e-3, "{at}: {found} {fine}");
        assert!(found <= floor.area().min(other.area()));
    }
}

#[test]
fn far_triangles_are_summed_as_they_are_seen_from_around() {
    let floor = Patch::parallelogram([0.0; 3], [[1.0, 0.0, 0.0], [0.0, 0.7, 0.0]]);
    let triangle = Patch::triangle([[5.0, 9.0, 17.0], [4.8, 9.9, 17.1], [5.7, 9.2, 16.8]]);
    let found = exchange(&floor, &triangle);
    // Around both, (r/L)² ulp of a few terms over F ~ 10⁻⁴ are left.
    assert!((found / around(&floor, &triangle) - 1.0).abs() < 1e-10 && found > 0.0, "{found}");
    assert!((exchange(&triangle, &floor) / found - 1.0).abs() < 1e-12);
}

#[test]
fn graded_patches_are_found_again_and_their_limit_is_that_of_even_ones() {
    let room = Room::cuboid([1.0, 0.8, 0.6], [(0.3, 0.0), (0.7, 0.0), (0.2, 0.0), (0.5, 1.0), (0.25, 0.4), (0.6, 0.0)]);
    let patches = room.cut_graded(5);
    let middle = |at: usize| patches.list[at].middle();
    for face in 0..6 {
        let whole = &room.faces[face].patch;
        for at in patches.of_face(face) {
            let place = whole.edges.map(|edge| {
                let way: f64 = (0..3).map(|axis| (middle(at)[axis] - whole.corner[axis]) * edge[axis]).sum();
                way / edge.iter().map(|x| x * x).sum::<f64>()
            });
            assert_eq!(patches.at(face, place), at);
        }
    }
    let floor = |patches: super::Patches| {
        let found = solve::direct(&Network::of(&patches), &Light::of(&patches, 1));
        patches.mean(2, &found)
    };
    // Even ones: h² and the next order taken off, 10⁻⁵; graded ones better still.
    let even = [4, 8].map(|n| floor(room.cut(n)));
    let graded = [4, 6, 8].map(|n| (1.0 / n as f64, floor(room.cut_graded(n))));
    let [even, graded] = [limit::richardson(even, 2.0), limit::without(&graded, &[2.0, 4.0])];
    assert!((even / graded - 1.0).abs() < 1e-4, "{even} {graded}");
}
