//! The march over squares against the plain search of all triangles.

use super::super::{Fate, Path, Relief};
use super::{dot, towards};
use proptest::prelude::*;

type Vector = [f64; 3];

fn minus(one: Vector, other: Vector) -> Vector {
    std::array::from_fn(|axis| one[axis] - other[axis])
}

fn cross([a, b, c]: Vector, [x, y, z]: Vector) -> Vector {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

fn along(origin: Vector, direction: Vector, t: f64) -> Vector {
    std::array::from_fn(|axis| origin[axis] + t * direction[axis])
}

/// How far a triangle is along a ray (T. Möller & B. Trumbore, *J. Graphics Tools* 2(1) (1997) 21).
fn distance([a, b, c]: [Vector; 3], origin: Vector, direction: Vector) -> Option<f64> {
    let (ab, ac, from) = (minus(b, a), minus(c, a), minus(origin, a));
    let across = cross(direction, ac);
    let volume = dot(ab, across);
    let u = dot(from, across) / volume;
    let side = cross(from, ab);
    let v = dot(direction, side) / volume;
    let t = dot(ac, side) / volume;
    (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 1e-9).then_some(t)
}

/// A ray's way by trying every triangle of cells `reach` around each place; None if it goes farther than that. Each
/// facet keeps the cosine of the power.
fn plain(relief: &Relief, wi: Vector, [u, v]: [f64; 2], reach: isize) -> Option<Path> {
    let side = relief.side() as isize;
    let corner = |x: isize, y: isize| {
        [x as f64, y as f64, relief.heights()[(y.rem_euclid(side) * side + x.rem_euclid(side)) as usize]]
    };
    let mut origin = [u * side as f64, v * side as f64, relief.top()];
    let mut direction = wi.map(|part| -part);
    // The same line, from a little higher.
    origin = along(origin, direction, 1e-3 / direction[2]);
    let (mut bounces, mut power, mut first) = (0, 1.0, [0.0, 0.0, 1.0]);
    loop {
        let [x, y] = [0, 1].map(|axis| origin[axis].floor() as isize);
        let cells = (-reach..=reach).flat_map(|i| (-reach..=reach).map(move |j| [x + i, y + j]));
        let triangles = cells.flat_map(|[x, y]| {
            let (near, far) = (corner(x, y), corner(x + 1, y + 1));
            [[near, corner(x + 1, y), far], [near, far, corner(x, y + 1)]]
        });
        let nearest = triangles
            .filter_map(|triangle| distance(triangle, origin, direction).map(|t| (t, triangle)))
            .min_by(|one, other| one.0.total_cmp(&other.0));
        let Some((t, [a, b, c])) = nearest else {
            let rise = (relief.top() - origin[2]) / direction[2];
            let far = rise * direction[0].abs().max(direction[1].abs()) > reach as f64 - 1.0;
            return (direction[2] > 0.0 && !far).then_some(Path { fate: Fate::Left, direction, bounces, power, first });
        };
        let normal = cross(minus(b, a), minus(c, a));
        let length = dot(normal, normal).sqrt();
        let normal = normal.map(|part| part / length);
        if bounces == 0 {
            first = normal;
        }
        bounces += 1;
        power *= -dot(direction, normal);
        origin = along(origin, direction, t);
        direction = along(direction, normal, -2.0 * dot(direction, normal));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1024))]
    #[test]
    fn the_march_meets_what_the_search_meets(
        bits in 1_u32..4,
        heights in prop::collection::vec(-1.0..1.0_f64, 64),
        height in 0.1..2.0_f64,
        theta in 0.0..1.3_f64,
        phi in prop_oneof![0.0..std::f64::consts::TAU, (0..8_i32).prop_map(|eighth| f64::from(eighth) * std::f64::consts::FRAC_PI_4)],
        // Away from edges, where the search's two triangles may both miss or both be met.
        u in 0.001..0.999_f64,
        v in 0.001..0.999_f64,
    ) {
        let side = 1_usize << bits;
        let heights: Vec<f64> = heights[..side * side].iter().map(|part| part * height).collect();
        let relief = Relief::new(side, heights).expect("valid");
        let wi = towards(theta, phi);
        let found = plain(&relief, wi, [u, v], 24);
        prop_assume!(found.is_some());
        let found = found.expect("just seen");
        let path = relief.trace(wi, [u, v], |cos| cos, 1000);
        prop_assert_eq!((path.fate, path.bounces), (found.fate, found.bounces));
        let near = |one: Vector, other: Vector| minus(one, other).iter().all(|gap| gap.abs() < 1e-9);
        prop_assert!(near(path.direction, found.direction) && near(path.first, found.first), "{path:?} {found:?}");
        prop_assert!((path.power - found.power).abs() < 1e-9, "{path:?} {found:?}");
    }
}
