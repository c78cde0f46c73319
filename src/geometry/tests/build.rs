//! How much a hierarchy takes, and that it is always the same.

use super::*;
use crate::geometry::bvh::Bvh;

fn mesh(times: u32) -> Vec<Primitive> {
    let bumpy = |[x, y, z]: Triple| {
        let r = 1.0 + 0.1 * (9.0 * x).sin() * (7.0 * y).cos();
        [r * x, r * y, r * z]
    };
    ball(times, bumpy).into_iter().map(flat).collect()
}

#[test]
fn a_triangle_takes_80_bytes_at_most() {
    let mut primitives = mesh(5);
    let flat = World::<F32x8>::new(&primitives).bytes() / primitives.len();
    for primitive in &mut primitives {
        if let Primitive::Triangle { corners, normals } = primitive {
            *normals = Some(corners.map(|corner| corner.map(|part| part as f32)));
        }
    }
    let smooth = World::<F32x8>::new(&primitives).bytes() / primitives.len();
    assert!(flat <= 64 && smooth <= 80, "{flat} {smooth}");
}

#[test]
fn the_same_list_makes_the_same_hierarchy() {
    let mut primitives = mesh(3);
    primitives.extend(soup(500, &mut Even::new("build/same")));
    let text = |bvh: Bvh<F32x8>| format!("{bvh:?}");
    let once = text(Bvh::new(&primitives, |_| true));
    assert_eq!(once, text(Bvh::new(&primitives, |_| true)));
    // And every thread's.
    let other = std::thread::scope(|scope| scope.spawn(|| text(Bvh::new(&primitives, |_| true))).join());
    assert_eq!(once, other.expect("it ends"));
}

/// Sizes that shrink for ever take one at a time off a list, and what lies in one place cannot be told apart: neither
/// grows deep.
#[test]
fn pathological_lists_stay_shallow() {
    let of_size = |x: f64| flat([[x, x, 0.0], [1.5 * x, x, 0.0], [x, 1.5 * x, 0.1 * x]]);
    let shrinking: Vec<Primitive> = (0..3000).map(|at| of_size(0.97_f64.powi(at))).collect();
    let equal = vec![of_size(1.0); 5000];
    let mixed: Vec<Primitive> = equal
        .iter()
        .enumerate()
        .map(|(at, one)| if at % 3 == 0 { Primitive::Sphere { center: [1.2, 1.2, 0.0], radius: 0.3 } } else { *one })
        .collect();
    for list in [&shrinking, &equal, &mixed] {
        let settings = |structure| Settings { structure, ends: Ends::Anywhere };
        let [brute, bvh] = [Structure::Brute, Structure::Bvh].map(|one| World::<f32>::with(list, &settings(one)));
        let mut even = Even::new("build/pathological");
        for _ in 0..50 {
            let to = if even.number() < 0.5 { [1.2, 1.2, 0.02] } else { even.point().map(f64::abs) };
            let origin = plus(to, even.direction(), 2.0);
            let ray = ray(origin, triple(vector(to) - vector(origin)));
            let hits = [&brute, &bvh].map(|world| world.closest(&ray, true));
            assert_eq!(hits[0].primitive, hits[1].primitive);
            assert_eq!(hits[0].t.to_bits(), hits[1].t.to_bits());
        }
        assert!(Bvh::<F32x8>::new(list, |_| true).depth() <= bvh::DEEPEST, "too deep");
    }
}
