//! What a few places know of the light on all.

use super::*;
use crate::bsdf::rgb;
use crate::number::{Frame, Vector};
use crate::transport::film::added;
use crate::transport::irradiance_cache::Caches;
use crate::transport::irradiance_cache::hemisphere::{Cells, Fallen, Seen};
use crate::transport::irradiance_cache::record::{Cache, Record};
use std::f64::consts::{FRAC_PI_2, PI};

fn cached(seed: u64) -> Manner {
    Manner { method: Method::Cached, seed, ..Manner::default() }
}

fn lengthened(v: Vector<f64>, by: f64) -> [f64; 3] {
    v.scaled(by).lane(0)
}

/// A square lamp of radiance 1 in the plane z = 1, about the z axis.
const SQUARE: [[f64; 3]; 4] = [[-0.5, -0.5, 1.0], [-0.5, 0.5, 1.0], [0.5, 0.5, 1.0], [0.5, -0.5, 1.0]];

/// What the square sends to a place, by Lambert's closed form.
fn exact(place: [f64; 3], normal: [f64; 3]) -> f64 {
    let seen = SQUARE.map(|corner| std::array::from_fn(|k| corner[k] - place[k]));
    polygon::irradiance(&seen, normal).expect("a lamp above the place")
}

/// The same by a ray in the middle of each cell, before a black sky.
fn seen_from(place: [f64; 3], frame: &Frame<f64>, cells: &Cells) -> Vec<Seen> {
    let of = |cell| {
        let way = frame.outward(cells.direction(cell, [0.5; 2]));
        let t = (1.0 - place[2]) / way.z;
        let meets = t > 0.0 && [place[0] + t * way.x, place[1] + t * way.y].iter().all(|x| x.abs() <= 0.5);
        Seen { radiance: [f64::from(u8::from(meets)); 3], distance: if meets { t } else { f64::INFINITY } }
    };
    (0..cells.count()).map(of).collect()
}

/// ∂f of a function at 0, to the sixth power of a step of 1/50.
fn slope(f: impl Fn(f64) -> f64) -> f64 {
    let h = 0.02;
    let d = |k: f64| f(k * h) - f(-k * h);
    (45.0 * d(1.0) - 9.0 * d(2.0) + d(3.0)) / (60.0 * h)
}

#[test]
fn half_a_bright_sphere_changes_as_ward_has_it() {
    // Its cells are cut where the light is: exact, but for roundings.
    let (cells, radius) = (Cells { rings: 7, sectors: 24 }, 2.5);
    let bright = |sector: u32| !(6..18).contains(&sector);
    let seen: Vec<Seen> = (0..cells.count())
        .map(|cell| Seen { radiance: [f64::from(u8::from(bright(cell % 24))), 1.0, 0.0], distance: radius })
        .collect();
    let Fallen { irradiance, turned, shifted, distance } = cells.fallen(&seen);
    let close = |found: f64, exact: f64| assert!((found - exact).abs() < 1e-13, "{found}, {exact}");
    close(distance, radius);
    close(irradiance[0], FRAC_PI_2);
    // ΔE/E = 4Δx/πR, and as much as the angle by which it turns.
    close(shifted[0].x / irradiance[0], 4.0 / (PI * radius));
    close(turned[0].x / irradiance[0], 1.0);
    close(shifted[0].y, 0.0);
    close(turned[0].y, 0.0);
    // Light from everywhere is the same at every place and for every normal.
    close(irradiance[1], PI);
    for none in [turned[1], shifted[1], turned[2], shifted[2]] {
        close(none.dot(none), 0.0);
    }
}

#[test]
fn gradients_are_those_of_lamberts_closed_form() {
    let cells = Cells::about(40_000.0);
    for (place, normal) in
        [([0.3, 0.1, 0.0], [0.0, 0.0, 1.0]), ([0.9, -0.7, 0.0], [0.0, 0.0, 1.0]), ([0.2, 0.4, 0.5], [0.36, 0.48, 0.8])]
    {
        let frame = Frame::about(Vector::of(normal));
        let fallen = cells.fallen(&seen_from(place, &frame, &cells));
        // A cell at the rim of the square is bright or dark as its middle is: of 112 rings about 1 in 100, and signs differ.
        let scale = exact(place, normal);
        let close = |what: &str, found: f64, exact: f64| {
            assert!((found - exact).abs() < 0.02 * scale, "{place:?} {what}: {found}, {exact}");
        };
        close("irradiance", fallen.irradiance[1], scale);
        let (shifted, turned) = (frame.outward(fallen.shifted[1]), frame.outward(fallen.turned[1]));
        for axis in [frame.x, frame.y] {
            let moved = |x: f64| std::array::from_fn(|k| place[k] + lengthened(axis, x)[k]);
            close("shifted", shifted.dot(axis), slope(|x| exact(moved(x), normal)));
            let tilted = |angle: f64| (frame.z.scaled(angle.cos()) + axis.scaled(angle.sin())).lane(0);
            close("turned", turned.dot(axis), slope(|angle| exact(place, tilted(angle))));
        }
    }
}

/// Records on the floor under the square, half as far from each other as is allowed, their light by the closed form. Along x
/// they are not even: what a record gets wrong on one side would be made up for by the next on the other.
fn floor(allowed: f64, is_graded: bool) -> Cache {
    let mut cache = Cache::new(allowed);
    let up = Frame::about(Vector::of([0.0, 0.0, 1.0]));
    let spacing = allowed / 2.0;
    let count = (1.5 / spacing).ceil() as i32;
    for k in 0..(2 * count + 1).pow(2) {
        let [x, y] = [k % (2 * count + 1), k / (2 * count + 1)].map(|k| f64::from(k - count) * spacing);
        let x = x + 0.8 * spacing * ((0.618_034 * f64::from(k)).fract() - 0.5);
        let at = |x: f64, y: f64| exact([x, y, 0.0], [0.0, 0.0, 1.0]);
        let shift = Vector::of([slope(|d| at(x + d, y)), slope(|d| at(x, y + d)), 0.0]);
        let shift = if is_graded { shift } else { Vector::of([0.0; 3]) };
        let fallen = Fallen {
            irradiance: [at(x, y); 3],
            turned: [Vector::of([0.0; 3]); 3],
            shifted: [up.inward(shift); 3],
            distance: 1.0,
        };
        cache.add(Record::new(Vector::of([x, y, 0.0]), &up, 1, &fallen, [1.0, 1.0]));
    }
    cache
}

#[test]
fn interpolation_is_off_by_the_square_of_what_is_allowed() {
    let error = |allowed: f64, is_graded: bool| {
        let cache = floor(allowed, is_graded);
        let places = (0..900).map(|k| [k % 30, k / 30].map(|k| f64::from(k) * 0.033 - 0.47));
        let errors = places.map(|[x, y]| {
            let told = cache.irradiance(Vector::of([x, y, 0.0]), Vector::of([0.0, 0.0, 1.0]), 1).expect("a record");
            (told[1] - exact([x, y, 0.0], [0.0, 0.0, 1.0])).powi(2) / 900.0
        });
        errors.sum::<f64>().sqrt()
    };
    // Without gradients of the first order along x, where records are not even; across it neighbours make up for each other.
    for (is_graded, least, most) in [(true, 1.75, 2.25), (false, 0.75, 1.6)] {
        let order = (error(0.4, is_graded) / error(0.1, is_graded)).log2() / 2.0;
        assert!((least..most).contains(&order), "gradients {is_graded}: {order}");
    }
}

#[test]
fn what_is_near_is_told_and_what_is_not_is_not() {
    let cache = floor(0.3, true);
    let up = Vector::of([0.0, 0.0, 1.0]);
    let at = |x, z, normal, edges| cache.irradiance(Vector::of([x, 0.0, z]), normal, edges).is_some();
    assert!(at(0.1, 0.0, up, 1));
    // Beyond the last record, of other paths, on a wall, on the shelf above.
    assert!(!at(2.5, 0.0, up, 1) && !at(0.1, 0.0, up, 2));
    assert!(!at(0.1, 0.0, Vector::of([1.0, 0.0, 0.0]), 1) && !at(0.1, 0.1, up, 1));
}

#[test]
fn radii_are_held_by_neighbours_gradients_and_bounds() {
    let up = Frame::about(Vector::of([0.0, 0.0, 1.0]));
    let of = |x: f64, distance: f64, slope: f64, bounds: [f64; 2]| {
        let shifted = [Vector::of([slope, 0.0, 0.0]); 3];
        let fallen = Fallen { irradiance: [2.0; 3], turned: [Vector::of([0.0; 3]); 3], shifted, distance };
        Record::new(Vector::of([x, 0.0, 0.0]), &up, 1, &fallen, bounds)
    };
    assert_eq!(of(0.0, 0.5, 1.0, [0.0, 9.0]).radius, 0.5);
    assert_eq!(of(0.0, f64::INFINITY, 0.0, [0.0, 9.0]).radius, 9.0);
    // The gradient doubles the light within 2/8.
    assert_eq!(of(0.0, 0.5, 8.0, [0.0, 9.0]).radius, 0.25);
    let held = of(0.0, 0.5, 8.0, [1.0, 9.0]);
    assert_eq!((held.radius, held.shifted[0].x), (1.0, 2.0));
    let mut cache = Cache::new(0.5);
    cache.add(of(0.0, 4.0, 0.0, [0.0, 9.0]));
    cache.adapt(0);
    cache.add(of(1.0, 0.5, 0.0, [0.0, 9.0]));
    cache.add(of(3.0, 9.0, 0.0, [0.0, 9.0]));
    cache.adapt(1);
    assert_eq!(cache.records().iter().map(|record| record.radius).collect::<Vec<_>>(), [1.5, 0.5, 2.5]);
}

#[test]
fn batches_allow_less_and_send_more() {
    let stage = Stage::new(&room(256), Structure::Best).expect("a scene without a flaw");
    let caches = Caches::new(&stage, Choice::Net, 1);
    assert_eq!([0, 1, 2, 3, 4, 7, 8, 15, 16].map(Caches::batch), [0, 0, 1, 1, 2, 2, 3, 3, 4]);
    // Of 64 times the work: records four times as many, 16 times the rays.
    assert!((caches.allowed(2) / caches.allowed(8) - 2.0).abs() < 1e-12);
    let ratio = f64::from(caches.cells(8).count()) / f64::from(caches.cells(2).count());
    assert!((ratio / 16.0 - 1.0).abs() < 0.1, "{ratio}");
    // The last sample there may be has a cache too.
    assert!(Caches::batch(u32::MAX) < 33 && caches.cells(32).count() < 1 << 21 && caches.allowed(32) > 0.0);
}

#[test]
fn a_closed_room_is_as_bright_as_it_must_be() {
    // Its light is the same at every place: nothing is lost between records, and what is left is to count every path once.
    let wall = shining(shape(Geometry::Sphere { center: [0.0; 3], radius: 1.0 }, "wall"), [1.0; 3], true);
    // Rays to a lamp all around find it as densely as those by the cosine do, so that there is no noise: single numbers' roundings.
    for depth in [2, 3, 6] {
        let camera = looking([0.1, 0.2, -0.7], [0.0; 3], 90.0, 8);
        let room = scene(camera, depth, vec![diffuse("wall", [0.6; 3])], vec![wall.clone()]);
        let exact = (1.0 - 0.6f64.powi(depth as i32)) / (1.0 - 0.6);
        let found = green(&filmed(&room, &cached(1), &[0..4]).halves()).mean();
        assert!((found / exact - 1.0).abs() < 1e-6, "{depth}: {found}, {exact}");
    }
}

#[test]
fn a_sky_is_gathered_by_records() {
    // A floor under a sky of radiance 1: ρ, from the first pair on.
    let floor = shape(quad([[-4.0, -4.0, 0.0], [4.0, -4.0, 0.0], [4.0, 4.0, 0.0], [-4.0, 4.0, 0.0]]), "grey");
    let mut world = scene(looking([0.0, 0.0, 1.0], [0.0; 3], 40.0, 6), 2, vec![diffuse("grey", [0.5; 3])], vec![floor]);
    world.environment = Some(Environment::Constant([1.0; 3]));
    for halves in filmed(&world, &cached(3), &[0..1]).halves() {
        assert!(halves.iter().flatten().all(|x| (x - 0.5).abs() < 1e-6), "{halves:?}");
    }
}

#[test]
fn pictures_by_records_are_those_of_paths_but_for_what_is_interpolated() {
    for (name, scene) in [("room", room(16)), ("hall", hall(16))] {
        let of = |manner: &Manner, pairs| {
            let halves = filmed(&scene, manner, &[0..pairs]).halves();
            rgb(|c| halves.iter().map(|halves| f64::from(halves[0][c] + halves[1][c]) / 2.0).sum::<f64>())
        };
        let (found, exact) = (of(&cached(1), 64), of(&Manner { seed: 2, ..Manner::default() }, 1024));
        assert!((0..3).all(|c| (found[c] / exact[c] - 1.0).abs() < 0.02), "{name}: {found:?}, {exact:?}");
    }
}

#[test]
fn no_split_of_samples_by_records_can_be_told() {
    let room = room(6);
    let of = || Renderer::new(&room, &cached(4), 4).expect("a scene without a flaw");
    let renderer = of();
    let whole = renderer.sums(0..6, 0..4);
    // By another, which makes its caches in another order.
    let other = of();
    let late = other.sums(0..6, 2..4);
    let halves = other.sums(0..6, 0..2).into_iter().zip(late);
    assert_eq!(whole, halves.map(|(a, b)| added(a, b)).collect::<Vec<_>>());
    assert_eq!(whole, [renderer.sums(0..1, 0..4), renderer.sums(1..6, 0..4)].concat());
}
