//! Points and normals where surfaces are met, and rays that leave them.

use super::*;
use crate::number::Frame;
use yardstick::precise::{real, to_f64};

/// A primitive of any kind, about as large as `size`, and a ray towards it.
fn case<N: Width>(kind: usize, size: f64, place: f64, even: &mut Even) -> (Primitive, Ray<N>) {
    let corner = even.point().map(|part| place * part);
    let edge = |even: &mut Even| even.point().map(|part| size * part);
    let [u, v] = [edge(even), edge(even)];
    let (primitive, target) = match kind {
        0 => (quad(corner, [u, v]), plus(plus(corner, u, even.number()), v, even.number())),
        1 => (Primitive::Sphere { center: corner, radius: size }, plus(corner, even.point(), size)),
        2 => (Primitive::Disc { center: corner, normal: v, radius: size }, plus(corner, vector_across(v), 0.5 * size)),
        _ => (
            flat([corner, plus(corner, u, 1.0), plus(corner, v, 1.0)]),
            plus(plus(corner, u, 0.7 * even.number()), v, 0.3 * even.number()),
        ),
    };
    // Or from inside, where there is one.
    let away = even.power(-1.0, 1.0).abs() * (size + place);
    let origin = if kind == 1 && even.number() < 0.5 {
        plus(corner, even.point(), 0.4 * size)
    } else {
        plus(target, even.direction(), away)
    };
    (primitive, ray(origin, triple((vector(target) - vector(origin)).normalised())))
}

fn vector_across(v: Triple) -> Triple {
    triple(Frame::about(vector(v).normalised()).x)
}

/// How far `point` is from the exact surface, and its exact normal there.
fn exact(primitive: &Primitive, point: Triple) -> (f64, Triple) {
    let across = |u: Triple, v: Triple| triple(vector(u).cross(vector(v)).normalised());
    let height = |place: Triple, normal: Triple| {
        let terms = [0, 1, 2].map(|axis| (real(point[axis]) - real(place[axis])) * real(normal[axis]));
        to_f64(&terms.into_iter().fold(real(0.0), |sum, term| sum + term)).abs()
    };
    match *primitive {
        Primitive::Quad { corner, edges: [u, v] } => (height(corner, across(u, v)), across(u, v)),
        Primitive::Disc { center, normal, .. } => {
            let normal = triple(vector(normal).normalised());
            (height(center, normal), normal)
        }
        Primitive::Triangle { corners: [a, b, c], .. } => {
            let normal = across(triple(vector(b) - vector(a)), triple(vector(c) - vector(a)));
            (height(a, normal), normal)
        }
        Primitive::Sphere { center, radius } => {
            let from = [0, 1, 2].map(|axis| real(point[axis]) - real(center[axis]));
            let square = from.iter().fold(real(0.0), |sum, part| sum + part * part);
            let off = to_f64(&(square - real(radius) * real(radius))) / (2.0 * radius);
            (off.abs(), triple((vector(point) - vector(center)).normalised()))
        }
    }
}

fn points_and_normals<N: Width>() {
    let mut even = Even::new("surfaces/points");
    let mut count = 0;
    for at in 0..8000 {
        let (size, place) = (even.power(-3.0, 3.0).abs(), even.power(-1.0, 1.0).abs());
        let (primitive, ray) = case::<N>(at % 4, size, place, &mut even);
        for structure in [Structure::Brute, Structure::Bvh] {
            let world = World::with(&[primitive], &Settings { structure, ends: Ends::Anywhere });
            let hit = world.closest(&ray, active::<N>());
            if hit.primitive.lane(0) < 0.0 {
                continue;
            }
            count += 1;
            let surface = world.surface(&ray, &hit);
            let (off, normal) = exact(&primitive, surface.point.lane(0));
            let slack = surface.slack.lane(0);
            assert!(off <= 0.5 * slack, "{primitive:?}: {off:e} off, of {slack:e}");
            assert!(slack <= 32.0 * N::EPSILON * (size + place), "{primitive:?}: {slack:e}");
            // A normal of short edges of rounded corners turns by their roundings.
            let turn = length(vector(surface.normal.lane(0)) - vector(normal));
            let edges = match primitive {
                Primitive::Triangle { corners: [a, b, c], .. } => {
                    let (u, v) = (vector(b) - vector(a), vector(c) - vector(a));
                    let longest = length(u).max(length(v));
                    8.0 * (place + size) * longest / length(u.cross(v))
                }
                Primitive::Quad { edges: [u, v], .. } => {
                    4.0 / length(vector(u).normalised().cross(vector(v).normalised()))
                }
                Primitive::Sphere { .. } => 4.0 * (place + size) / size,
                Primitive::Disc { .. } => 4.0,
            };
            assert!(turn <= edges * N::EPSILON, "{primitive:?}: normal {turn:e} off, {:e} allowed", edges * N::EPSILON);
            // The point is where the ray meets it.
            let gap = length(vector(surface.point.lane(0)) - vector(ray.at(hit.t).lane(0)));
            let cos = surface.normal.dot(ray.direction).lane(0).abs();
            assert!(gap <= 4.0 * (slack + N::EPSILON * hit.t.lane(0)) / cos + 3e-4 * size, "{primitive:?}: {gap:e}");
        }
    }
    assert!(count > 4000, "{count}");
}

#[test]
fn points_lie_on_surfaces_and_normals_stand_on_them() {
    points_and_normals::<f64>();
    points_and_normals::<f32>();
    points_and_normals::<F32x8>();
}

/// A direction at a grazing angle or not, on the side of `sign`.
fn leaving(normal: Triple, sign: f64, even: &mut Even) -> Triple {
    let cos = sign * even.power(-7.0, 0.0).abs();
    let Frame { x: u, y: v, .. } = Frame::about(vector(normal).normalised());
    let (phi, sin) = (even.between(0.0, std::f64::consts::TAU), (1.0 - cos * cos).max(0.0).sqrt());
    triple(u.scaled(sin * phi.cos()) + v.scaled(sin * phi.sin()) + vector(normal).scaled(cos))
}

fn no_surface_shadows_itself<N: Width>(address: &str) {
    let mut even = Even::new(address);
    let mut count = 0;
    for at in 0..60_000 {
        let kind = at % 4;
        let (size, place) = (even.power(-3.0, 3.0).abs(), even.power(-1.0, 1.0).abs());
        let (primitive, ray) = case::<N>(kind, size, place, &mut even);
        let world = World::<N>::new(&[primitive]);
        let hit = world.closest(&ray, active::<N>());
        if hit.primitive.lane(0) < 0.0 {
            continue;
        }
        let surface = world.surface(&ray, &hit);
        let normal = surface.normal.lane(0);
        for sign in [1.0, -1.0] {
            let direction = Vector::<N>::of(leaving(normal, sign, &mut even));
            let side = surface.normal.dot(direction).lane(0);
            let next = Ray { origin: surface.leave(direction), direction };
            let found = world.closest(&next, active::<N>());
            let (t, is_met) = (found.t.lane(0), found.primitive.lane(0) >= 0.0);
            count += 1;
            if kind == 1 && side < 0.0 {
                // Into a sphere it comes out again at the end of the chord, which is never missed; as far as a
                // grazing one can be told from none.
                let chord = -2.0 * size * side;
                let blur = 8.0 * surface.slack.lane(0) / side.abs() + 16.0 * N::EPSILON * chord;
                assert!(is_met, "{primitive:?} {next:?}");
                assert!((t - chord).abs() <= blur, "{primitive:?} {next:?}: {t} of {chord}, {blur:e} allowed");
            } else {
                assert!(!is_met, "{primitive:?} {next:?} {found:?}");
            }
        }
    }
    assert!(count > 40_000, "{count}");
}

#[test]
fn what_leaves_does_not_come_back_at_once() {
    no_surface_shadows_itself::<f32>("surfaces/leave f32");
    no_surface_shadows_itself::<f64>("surfaces/leave f64");
}

/// Light in a closed room is met by a wall, however often it has bounced and however flat.
fn no_light_leaks(address: &str, primitives: &[Primitive], start: Triple) {
    let mut even = Even::new(address);
    let world = World::<F32x8>::new(primitives);
    let mut ray = rays(|_| (start, even_direction()));
    for _ in 0..6000 {
        let hit = world.closest(&ray, active::<F32x8>());
        for lane in 0..8 {
            assert!(hit.primitive.lane(lane) >= 0.0, "{address}: {ray:?}");
        }
        let surface = world.surface(&ray, &hit);
        let directions: [Triple; 8] = std::array::from_fn(|lane| {
            let normal = surface.normal.lane(lane);
            // Back to the side that it came from.
            let sign = -vector(normal).dot(vector(ray.direction.lane(lane))).signum();
            if even.number() < 0.5 {
                leaving(normal, sign, &mut even)
            } else {
                triple((vector(even.direction()).scaled(0.999) + vector(normal).scaled(sign)).normalised())
            }
        });
        let [x, y, z] = [0, 1, 2].map(|axis| F32x8::from_lanes(|lane| directions[lane][axis]));
        let direction = Vector::new(x, y, z);
        ray = Ray { origin: surface.leave(direction), direction };
    }
}

fn even_direction() -> Triple {
    [0.48, 0.6, 0.64]
}

#[test]
fn closed_rooms_hold_light() {
    no_light_leaks("surfaces/room", &cube([-1.0; 3], [1.0, 0.5, 1.5]), [0.1, 0.2, 0.3]);
    for radius in [1e-3, 1.0, 1e3] {
        let sphere = Primitive::Sphere { center: [0.5, -0.3, 1.0].map(|part: f64| part * radius.min(1.0)), radius };
        no_light_leaks("surfaces/sphere", &[sphere], [0.5, -0.3, 1.0].map(|part: f64| part * radius.min(1.0)));
    }
    let mesh: Vec<Primitive> = ball(3, |v| plus([0.3, 0.1, -0.2], v, 1.0)).into_iter().map(flat).collect();
    no_light_leaks("surfaces/ball", &mesh, [0.3, 0.1, -0.2]);
}

#[test]
fn smooth_normals_run_between_the_corners() {
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let mut even = Even::new("surfaces/smooth");
    for _ in 0..500 {
        let normals = [0; 3].map(|_| {
            let size = even.power(-2.0, 2.0).abs();
            let [x, y, z] = even.direction();
            // Of all sides, of any length, and along axes.
            if even.number() < 0.1 { [0.0, 0.0, z.signum() as f32] } else { [x, y, z].map(|part| (size * part) as f32) }
        });
        let primitives = [
            Primitive::Triangle { corners, normals: Some(normals) },
            flat(corners.map(|v| plus(v, [0.0, 0.0, -1.0], 1.0))),
        ];
        for structure in [Structure::Brute, Structure::Bvh] {
            let world = World::<F32x8>::with(&primitives, &Settings { structure, ends: Ends::Anywhere });
            let places: [(f64, f64); 8] = std::array::from_fn(|_| (0.5 * even.number(), 0.5 * even.number()));
            let ray = rays(|lane| ([places[lane].0, places[lane].1, 1.0], [0.0, 0.0, -1.0]));
            let surface = world.surface(&ray, &world.closest(&ray, active::<F32x8>()));
            for (lane, &(u, v)) in places.iter().enumerate() {
                let [a, b, c] = normals.map(|normal| vector(normal.map(f64::from)).normalised());
                let sum = a.scaled(1.0 - u - v) + b.scaled(u) + c.scaled(v);
                let gap = length(vector(surface.shading.lane(lane)) - sum.normalised());
                assert!(gap <= 4e-6 / length(sum), "{normals:?} {u} {v}: {gap:e}");
                assert_eq!(surface.normal.lane(lane), [0.0, 0.0, 1.0]);
            }
            // The flat one below keeps its own.
            let from_below = rays(|lane| ([places[lane].0, places[lane].1, -2.0], [0.0, 0.0, 1.0]));
            let surface = world.surface(&from_below, &world.closest(&from_below, active::<F32x8>()));
            assert_eq!(surface.shading.lane(0), [0.0, 0.0, 1.0]);
        }
    }
}
