//! Any numbers at all: nothing panics, nothing hangs, and no hit is without a place.

use super::*;
use proptest::prelude::*;

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        2 => any::<u64>().prop_map(f64::from_bits),
        2 => any::<u32>().prop_map(|bits| f64::from(f32::from_bits(bits))),
        3 => -2.0..2.0_f64,
        2 => prop::sample::select(vec![
            0.0, -0.0, 1.0, f64::INFINITY, f64::NAN, f64::MIN_POSITIVE, 1e-45, 1e38, -1e38, 1e300, 5e-324,
        ]),
    ]
}

fn triple() -> impl Strategy<Value = Triple> {
    prop::array::uniform3(number())
}

fn primitive() -> impl Strategy<Value = Primitive> {
    prop_oneof![
        (triple(), triple(), triple()).prop_map(|(corner, u, v)| quad(corner, [u, v])),
        (triple(), number()).prop_map(|(center, radius)| Primitive::Sphere { center, radius }),
        (triple(), triple(), number()).prop_map(|(center, normal, radius)| Primitive::Disc { center, normal, radius }),
        (prop::array::uniform3(triple()), prop::option::of(prop::array::uniform3(triple()))).prop_map(
            |(corners, normals)| Primitive::Triangle {
                corners,
                normals: normals.map(|normals| normals.map(|normal| normal.map(|part| part as f32))),
            }
        ),
    ]
}

fn is_sound<N: Width>(primitives: &[Primitive], origin: Triple, direction: Triple, t_max: f64) {
    for structure in [Structure::Brute, Structure::Bvh] {
        for ends in [Ends::Anywhere, Ends::OnSurfaces(vec![origin])] {
            let world = World::<N>::with(primitives, &Settings { structure, ends });
            let ray = ray::<N>(origin, direction);
            let hit = world.closest(&ray, active::<N>());
            let (t, primitive) = (hit.t.lane(0), hit.primitive.lane(0));
            if primitive == -1.0 {
                assert_eq!(t, f64::INFINITY);
            } else {
                assert!(t > 0.0 && t < f64::INFINITY, "{t}");
                assert!(primitive.fract() == 0.0 && (0.0..primitives.len() as f64).contains(&primitive), "{primitive}");
            }
            let _ = world.is_blocked(&ray, N::of(t_max), active::<N>());
            let surface = world.surface(&ray, &hit);
            let _ = surface.leave(ray.direction);
            let _ = (world.bounds().reach(), world.bytes());
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]
    #[test]
    fn any_numbers_are_survived(
        primitives in prop::collection::vec(primitive(), 0..14),
        origin in triple(),
        direction in triple(),
        t_max in number(),
    ) {
        is_sound::<f32>(&primitives, origin, direction, t_max);
        is_sound::<f64>(&primitives, origin, direction, t_max);
        is_sound::<F32x8>(&primitives, origin, direction, t_max);
    }
}

/// Without area, at the edge of zero, and along axes: no hit has a place that is not a number.
#[test]
fn what_has_no_area_is_harmless() {
    let [a, b] = [[0.25, 0.5, 0.0], [1.0, 1.0, 0.0]];
    let between = plus(a, [0.25, 0.5 / 3.0, 0.0], 1.0);
    let primitives = [
        flat([a, a, a]),
        flat([a, b, b]),
        flat([a, between, b]),
        flat([a, b, plus(a, [1e-30, 0.0, 0.0], 1.0)]),
        quad(a, [[0.0; 3], [1.0, 0.0, 0.0]]),
        quad(a, [[1.0, 0.0, 0.0], [2.0, 0.0, 0.0]]),
        Primitive::Sphere { center: a, radius: 0.0 },
        Primitive::Disc { center: a, normal: [0.0, 0.0, 1.0], radius: 0.0 },
        Primitive::Disc { center: a, normal: [0.0; 3], radius: 1.0 },
    ];
    let ends: Vec<Triple> = vec![a, b, between, [0.0; 3], [0.25, 0.5, -1.0], [1.0, 0.5, 0.0], [0.25, 0.5, 3.0]];
    for from in &ends {
        for to in &ends {
            for (axis, sign) in [(0, 1.0), (1, -1.0), (2, 1.0), (3, 1.0)] {
                let way = if axis == 3 { super::triple(vector(*to) - vector(*from)) } else { [0.0; 3] };
                let way = std::array::from_fn(|at| if at == axis { sign } else { way[at] });
                is_sound::<f32>(&primitives, *from, way, 1.0);
                is_sound::<f64>(&primitives, *from, way, 1.0);
                let world = World::<f64>::new(&primitives);
                let ray = ray(*from, way);
                let hit = world.closest(&ray, true);
                let surface = world.surface(&ray, &hit);
                if hit.is_some() {
                    let numbers = [triple_of(surface.point), triple_of(surface.normal), triple_of(surface.shading)];
                    assert!(numbers.iter().flatten().all(|part| part.is_finite()), "{hit:?} {surface:?}");
                }
            }
        }
    }
}

fn triple_of(v: Vector<f64>) -> Triple {
    super::triple(v)
}
