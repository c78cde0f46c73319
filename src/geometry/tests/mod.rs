//! What rays meet, against exact arithmetic, counting, and each structure against the other.

use super::*;
use crate::number::F32x8;

fn ray<N: Width>(origin: [f64; 3], direction: [f64; 3]) -> Ray<N> {
    Ray { origin: Vector::of(origin), direction: Vector::of(direction) }
}

fn simple<N: Width>() {
    let world = World::<N>::new(&[
        Primitive::Quad { corner: [-1.0, -1.0, 0.0], edges: [[2.0, 0.0, 0.0], [0.0, 2.0, 0.0]] },
        Primitive::Sphere { center: [0.0, 0.0, 3.0], radius: 1.0 },
        Primitive::Disc { center: [5.0, 0.0, 0.0], normal: [0.0, 0.0, 2.0], radius: 1.0 },
        Primitive::Triangle { corners: [[-6.0, -1.0, 0.0], [-4.0, -1.0, 0.0], [-5.0, 1.0, 0.0]], normals: None },
    ]);
    let active = N::of(0.0).le(N::of(0.0));
    for (x, t, primitive) in [(0.0, 1.0, 0.0), (5.0, 1.0, 2.0), (-5.0, 1.0, 3.0), (2.0, f64::INFINITY, -1.0)] {
        let ray = ray::<N>([x, 0.1, 1.0], [0.0, 0.0, -1.0]);
        let hit = world.closest(&ray, active);
        assert_eq!((hit.t.lane(0), hit.primitive.lane(0)), (t, primitive));
        let surface = world.surface(&ray, &hit);
        if primitive >= 0.0 {
            let gap = surface.point - Vector::of([x, 0.1, 0.0]);
            assert!(gap.dot(gap).lane(0) < 1e-12, "{surface:?}");
            assert_eq!(surface.normal.lane(0), [0.0, 0.0, 1.0]);
        }
    }
    let up = ray::<N>([0.0, 0.0, 1.0], [0.0, 0.0, 1.0]);
    let hit = world.closest(&up, active);
    assert_eq!((hit.t.lane(0), hit.primitive.lane(0)), (1.0, 1.0));
    assert_eq!(world.surface(&up, &hit).normal.lane(0), [0.0, 0.0, -1.0]);
}

#[test]
fn simple_hits() {
    simple::<f32>();
    simple::<f64>();
    simple::<F32x8>();
}
