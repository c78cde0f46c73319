//! The hierarchy against trying all, bit for bit, and lanes against single rays.

use super::*;
use crate::number::{Eight, Mask, Number, vectorised};
use proptest::prelude::*;

/// What is asked of a ray, in bits.
fn answer<N: Width>(world: &World<N>, ray: &Ray<N>) -> Vec<[u64; 4]> {
    let hit = vectorised(
        #[inline(always)]
        || world.closest(ray, active::<N>()),
    );
    (0..N::LANES).map(|lane| [hit.t, hit.u, hit.v, hit.primitive].map(|part| part.lane(lane).to_bits())).collect()
}

fn both<N: Width>(primitives: &[Primitive]) -> [World<N>; 2] {
    [Structure::Brute, Structure::Bvh]
        .map(|structure| World::with(primitives, &Settings { structure, ends: Ends::Anywhere }))
}

/// Both structures' answers, which have to be one; and what lies before them.
fn agree<N: Width>(worlds @ [brute, _]: &[World<N>; 2], ray: &Ray<N>) {
    agree_on_hits(worlds, ray);
    let hit = brute.closest(ray, active::<N>());
    let beyond = N::from_lanes(|lane| f64::from((hit.t.lane(lane) as f32).next_up()));
    let before = hit.t * N::of(0.5);
    for (t_max, expected) in [(hit.t, false), (before, false), (beyond, true), (N::of(-1.0), false)] {
        for world in worlds {
            let blocked = vectorised(
                #[inline(always)]
                || world.is_blocked(ray, t_max, active::<N>()),
            );
            for lane in 0..N::LANES {
                let expected = expected && hit.primitive.lane(lane) >= 0.0;
                assert_eq!(blocked.lane(lane), expected, "{ray:?} {hit:?} {t_max:?}");
            }
        }
    }
}

fn agree_on_hits<N: Width>([brute, bvh]: &[World<N>; 2], ray: &Ray<N>) {
    assert_eq!(answer(brute, ray), answer(bvh, ray), "{ray:?}");
}

/// A number of a coarse lattice, so that much coincides, or any.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![3 => (-4..=4_i32).prop_map(|i| f64::from(i) / 4.0), 2 => -1.0..1.0_f64]
}

fn point() -> impl Strategy<Value = Triple> {
    prop::array::uniform3(number())
}

fn primitive() -> impl Strategy<Value = Primitive> {
    prop_oneof![
        2 => (point(), point(), point()).prop_map(|(corner, u, v)| quad(corner, [u, v])),
        1 => (point(), number()).prop_map(|(center, radius)| Primitive::Sphere { center, radius: radius.abs() }),
        1 => (point(), point(), number())
            .prop_map(|(center, normal, radius)| Primitive::Disc { center, normal, radius: radius.abs() }),
        3 => prop::array::uniform3(point()).prop_map(flat),
    ]
}

/// A scale and a place of the world.
fn frame() -> impl Strategy<Value = (f64, Triple)> {
    (prop_oneof![Just(1.0), Just(1e-6), Just(1e6)], prop_oneof![Just([0.0; 3]), Just([3.0, -2.0, 10.0])])
}

fn moved(primitive: &Primitive, (scale, place): (f64, Triple)) -> Primitive {
    let way = |v: Triple| v.map(|part| scale * part);
    let point = |v: Triple| way(plus(v, place, 1.0));
    match *primitive {
        Primitive::Quad { corner, edges } => quad(point(corner), edges.map(way)),
        Primitive::Sphere { center, radius } => Primitive::Sphere { center: point(center), radius: scale * radius },
        Primitive::Disc { center, normal, radius } => {
            Primitive::Disc { center: point(center), normal, radius: scale * radius }
        }
        Primitive::Triangle { corners, .. } => flat(corners.map(point)),
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]
    #[test]
    fn the_hierarchy_meets_what_there_is(
        primitives in prop::collection::vec(primitive(), 0..40),
        frame in frame(),
        from in prop::array::uniform8(point()),
        to in prop::array::uniform8(point()),
    ) {
        let primitives: Vec<Primitive> = primitives.iter().map(|one| moved(one, frame)).collect();
        let (scale, place) = frame;
        let at = |lane: usize| {
            let origin = plus(from[lane], place, 1.0).map(|part| scale * part);
            // Of any length: t counts in it.
            let way = triple(vector(to[lane]) - vector(from[lane]));
            (origin, if lane.is_multiple_of(2) { way } else { plus([0.0; 3], way, 1.0 / length(vector(way)).max(1e-3)) })
        };
        let wide = rays(at);
        let lanes = both::<F32x8>(&primitives);
        agree(&lanes, &wide);
        let (singles, exact) = (both::<f32>(&primitives), both::<f64>(&primitives));
        let all = answer(&lanes[0], &wide);
        for (lane, together) in all.into_iter().enumerate() {
            let (origin, direction) = at(lane);
            let single = ray::<f32>(origin, direction);
            agree(&singles, &single);
            prop_assert_eq!(&answer(&singles[0], &single), &[together]);
            agree(&exact, &ray(origin, direction));
        }
    }
}

/// Many rays through a world of everything at once: into it, within it, and nearly in the planes of what is there.
#[test]
fn a_million_rays_meet_the_same() {
    let mut even = Even::new("structures/soup");
    let primitives = soup(160, &mut even);
    let worlds = both::<F32x8>(&primitives);
    for at in 0..125_000 {
        let packet: [(Triple, Triple); 8] = std::array::from_fn(|_| {
            let reach = if even.number() < 0.2 { 30.0 } else { 1.0 };
            (even.point().map(|part| reach * part), even.point())
        });
        let ray = rays(|lane| (packet[lane].0, triple(vector(packet[lane].1) - vector(packet[lane].0))));
        agree_on_hits(&worlds, &ray);
        if at % 8 == 0 {
            agree(&worlds, &ray);
        }
    }
}

/// Rays in the planes of triangles and of their edges, where t is worth nothing and boxes are flat.
#[test]
fn grazing_rays_meet_the_same() {
    let mut even = Even::new("structures/grazing");
    for round in 0..40 {
        // A fan of needles in one plane, long and askew, among others a little beside it.
        let [u, v] = [even.direction(), even.direction()];
        let at = |s: f64, r: f64| plus(plus([0.1, 0.2, -0.3], u, s), v, r);
        let thickness = 10_f64.powi(-(round % 8));
        let corner = |even: &mut Even| at(even.between(-1.0, 1.0), thickness * even.between(-1.0, 1.0));
        let primitives: Vec<Primitive> = (0..64)
            .map(|_| flat([0; 3].map(|_| plus(corner(&mut even), even.direction(), 1e-7 * even.number()))))
            .collect();
        let worlds = both::<F32x8>(&primitives);
        for _ in 0..1000 {
            let packet: [(Triple, Triple); 8] = std::array::from_fn(|_| {
                let from = at(even.between(-3.0, 3.0), thickness * even.between(-3.0, 3.0));
                let lift = even.power(-9.0, -2.0);
                let to = plus(corner(&mut even), even.direction(), lift);
                (from, triple(vector(to) - vector(from)))
            });
            agree_on_hits(&worlds, &rays(|lane| packet[lane]));
        }
    }
}

#[test]
fn of_equals_the_first_is_met() {
    let triangle = flat([[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [0.0, 1.0, 0.0]]);
    let plane = quad([-1.0, -1.0, 0.0], [[2.0, 0.0, 0.0], [0.0, 2.0, 0.0]]);
    let disc = Primitive::Disc { center: [0.0; 3], normal: [0.0, 0.0, 1.0], radius: 1.0 };
    let sphere = Primitive::Sphere { center: [0.0, 0.0, -1.0], radius: 1.0 };
    let far = quad([-1.0, -1.0, -5.0], [[2.0, 0.0, 0.0], [0.0, 2.0, 0.0]]);
    let kinds = [triangle, plane, disc, sphere];
    for first in 0..4 {
        for turn in 1..4 {
            // In every order of kinds, and often enough for more than a leaf.
            let order = (0..4).map(|at| kinds[(first + at * turn) % 4]);
            let list: Vec<Primitive> = std::iter::once(far).chain(order.cycle().take(40)).collect();
            for world in both::<F32x8>(&list) {
                let hit = world.closest(&ray([0.0, 0.0, 1.0], [0.0, 0.0, -1.0]), active::<F32x8>());
                assert_eq!((hit.t, hit.primitive), (F32x8::of(1.0), F32x8::of(1.0)));
            }
        }
    }
}

#[test]
fn lanes_that_are_not_active_meet_nothing() {
    for world in both::<F32x8>(&cube([-1.0; 3], [1.0; 3])) {
        let ray = rays(|lane| ([0.0; 3], [1.0 + lane as f64, 0.1, 0.2]));
        let mask = Eight(std::array::from_fn(|lane| if lane % 3 == 0 { u32::MAX } else { 0 }));
        let hit = world.closest(&ray, mask);
        let blocked = world.is_blocked(&ray, F32x8::of(f64::INFINITY), mask);
        for lane in 0..8 {
            let is_active = lane % 3 == 0;
            assert_eq!((hit.t.lane(lane) < 10.0, hit.primitive.lane(lane) >= 0.0), (is_active, is_active));
            assert!(is_active || hit.t.lane(lane) == f64::INFINITY && hit.primitive.lane(lane) == -1.0);
            assert_eq!(blocked.lane(lane), is_active);
        }
    }
}

#[test]
fn where_nothing_is_nothing_is_met() {
    for world in both::<F32x8>(&[]) {
        let ray = ray([0.0; 3], [0.0, 0.0, 1.0]);
        let hit = world.closest(&ray, active::<F32x8>());
        assert_eq!((hit.t, hit.primitive), (F32x8::of(f64::INFINITY), F32x8::of(-1.0)));
        assert!(!world.is_blocked(&ray, F32x8::of(f64::INFINITY), active::<F32x8>()).any());
        let surface = world.surface(&ray, &hit);
        assert_eq!(surface.uv, [F32x8::of(0.0); 2]);
    }
}
