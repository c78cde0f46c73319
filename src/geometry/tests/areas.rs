//! Solid angles and areas by counting rays.

use super::*;
use crate::number::Frame;
use crate::radiometry::solid_angle;
use std::f64::consts::PI;
use yardstick::statistics::{Moments, z_test};

/// Rays in units of 8.
const PACKETS: usize = 60_000;

/// The share of all directions in which rays from `origin` meet something, and its standard error.
fn share(address: &str, origin: Triple, primitives: &[Primitive]) -> Moments {
    let mut even = Even::new(address);
    let world = World::<F32x8>::new(primitives);
    let mut moments = Moments::default();
    for _ in 0..PACKETS {
        let directions: [Triple; 8] = std::array::from_fn(|_| even.direction());
        let ray = rays(|lane| (origin, directions[lane]));
        let hit = world.closest(&ray, active::<F32x8>());
        (0..8).for_each(|lane| moments.add(f64::from(u8::from(hit.primitive.lane(lane) >= 0.0))));
    }
    moments
}

fn is_expected(name: &str, moments: &Moments, expected: f64) {
    let test = z_test(moments.mean(), moments.standard_error(), expected);
    // A fixed seed: one of ten thousand such tests would fail by chance.
    assert!(test.p > 1e-4, "{name}: {} ± {} against {expected}", moments.mean(), moments.standard_error());
}

#[test]
fn solid_angles_are_those_of_radiometry() {
    let origin = [0.3, -0.2, 0.1];
    let seen = |point: Triple| triple(vector(point) - vector(origin));
    let corners = [[1.0, -0.5, 0.2], [0.4, 1.0, -0.3], [0.2, 0.1, 1.4]];
    let of_triangle = |corners: [Triple; 3]| {
        let [a, b, c] = corners.map(seen);
        solid_angle::triangle(a, b, c).abs()
    };
    is_expected("triangle", &share("areas/triangle", origin, &[flat(corners)]), of_triangle(corners) / (4.0 * PI));

    let (corner, edges) = ([-1.0, 0.5, -0.7], [[1.5, 0.2, 0.1], [0.3, 0.1, 1.2]]);
    let [b, d] = edges.map(|edge| plus(corner, edge, 1.0));
    let c = plus(b, edges[1], 1.0);
    let both = of_triangle([corner, b, c]) + of_triangle([corner, c, d]);
    is_expected("quad", &share("areas/quad", origin, &[quad(corner, edges)]), both / (4.0 * PI));

    let normal = [0.48, 0.6, 0.64];
    let disc =
        Primitive::Disc { center: plus(origin, normal, 0.9), normal: normal.map(|part| 3.0 * part), radius: 0.7 };
    let expected = solid_angle::disc(0.7, 0.9) / (4.0 * PI);
    is_expected("disc", &share("areas/disc", origin, &[disc]), expected);

    let sphere = Primitive::Sphere { center: plus(origin, normal, 1.1), radius: 0.8 };
    let expected = solid_angle::cone((0.8_f64 / 1.1).asin()) / (4.0 * PI);
    is_expected("sphere", &share("areas/sphere", origin, &[sphere]), expected);
}

/// Lines even in place and direction that pass a ball of radius R cross a surface of area A within it A/(2πR²) times
/// (Crofton).
#[test]
fn areas_are_what_lines_count() {
    let (radius, mut even) = (2.0, Even::new("areas/crofton"));
    let primitives = [
        quad([-0.3, 0.2, -0.4], [[1.1, 0.2, 0.1], [0.3, 0.9, -0.4]]),
        Primitive::Sphere { center: [0.2, -0.5, 0.3], radius: 0.8 },
        Primitive::Disc { center: [0.3, 0.1, -0.2], normal: [1.0, 2.0, -0.5], radius: 0.7 },
        flat([[1.0, -0.5, 0.2], [0.4, 1.0, -0.3], [0.2, 0.1, 1.4]]),
    ];
    let worlds = primitives.map(|primitive| World::<F32x8>::new(&[primitive]));
    let mut counts = [Moments::default(); 4];
    for _ in 0..PACKETS / 2 {
        let lines: [(Triple, Triple); 8] = std::array::from_fn(|_| {
            // From a disc through the ball's centre, square to the line, and as far before it as the ball reaches.
            let direction = even.direction();
            let Frame { x: u, y: v, .. } = Frame::about(vector(direction));
            let (r, phi) = (radius * even.number().sqrt(), even.between(0.0, 2.0 * PI));
            let aside = u.scaled(r * phi.cos()) + v.scaled(r * phi.sin());
            (triple(aside - vector(direction).scaled(radius)), direction)
        });
        let ray = rays(|lane| lines[lane]);
        for ((world, primitive), moments) in worlds.iter().zip(&primitives).zip(&mut counts) {
            let hit = world.closest(&ray, active::<F32x8>());
            let times = if matches!(primitive, Primitive::Sphere { .. }) { 2.0 } else { 1.0 };
            (0..8).for_each(|lane| moments.add(if hit.primitive.lane(lane) >= 0.0 { times } else { 0.0 }));
        }
    }
    for (primitive, moments) in primitives.iter().zip(&counts) {
        is_expected("lines", moments, primitive.area() / (2.0 * PI * radius * radius));
    }
}

/// Euler: on a closed mesh of genus 0 all solid angles seen from inside sum to 4π, and no ray misses.
#[test]
fn a_closed_mesh_is_all_there_is_to_see() {
    let faces = ball(2, |[x, y, z]| [1.3 * x, 0.7 * y + 0.2 * x * x, z - 0.1 * y]);
    let origin = [0.2, 0.1, -0.3];
    let sum: f64 = faces
        .iter()
        .map(|face| {
            let [a, b, c] = face.map(|corner| triple(vector(corner) - vector(origin)));
            solid_angle::triangle(a, b, c)
        })
        .sum();
    // Seen from inside they run clockwise.
    assert!((sum + 4.0 * PI).abs() < 1e-12, "{sum}");
    let primitives: Vec<Primitive> = faces.into_iter().map(flat).collect();
    assert_eq!(share("areas/euler", origin, &primitives).mean(), 1.0);
}
