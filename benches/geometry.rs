//! Rays against primitives, on one thread: a second and a core.
//! `cargo bench -p light --bench geometry`

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use light::geometry::{Ends, Primitive, Ray, Settings, Structure, World};
use light::number::{Dice, Eight, F32x8, Number, Vector, vectorised};

fn main() {
    divan::main();
}

const RAYS: usize = 4096;

type Triple = [f64; 3];

/// Six rectangles, their normals outward.
fn cube(low: Triple, high: Triple) -> impl Iterator<Item = Primitive> {
    (0..6).map(move |face| {
        let (axis, is_high) = (face / 2, face % 2 == 1);
        let corner = std::array::from_fn(|other| if other == axis && is_high { high[other] } else { low[other] });
        let edge = |by: usize| {
            let side = (axis + by) % 3;
            std::array::from_fn(|other| if other == side { high[side] - low[side] } else { 0.0 })
        };
        let edges = if is_high { [edge(1), edge(2)] } else { [edge(2), edge(1)] };
        Primitive::Quad { corner, edges }
    })
}

/// A room with cubes in it, cut off after `count` quads.
fn room(count: usize) -> Vec<Primitive> {
    let mut dice = Dice::new(1.0_f64, 2.0);
    let mut all: Vec<Primitive> = cube([-1.0; 3], [1.0; 3]).collect();
    while all.len() < count {
        let low = [0; 3].map(|_| 1.6 * dice.throw() - 0.9);
        all.extend(cube(low, low.map(|part| part + 0.05 + 0.3 * dice.throw())));
    }
    all.truncate(count);
    all
}

/// A ball of `count` triangles or a few more, with bumps.
fn ball(count: usize) -> Vec<Primitive> {
    let around = (count as f64).sqrt() as usize;
    let point = |i: usize, j: usize| {
        let (theta, phi) = (
            std::f64::consts::PI * i as f64 / (around / 2) as f64,
            std::f64::consts::TAU * (j % around) as f64 / around as f64,
        );
        let r = 0.8 + 0.05 * (9.0 * theta).sin() * (7.0 * phi).cos();
        [r * theta.sin() * phi.cos(), r * theta.cos(), r * theta.sin() * phi.sin()]
    };
    let cells = (0..around / 2).flat_map(|i| (0..around).map(move |j| (i, j)));
    let triangles = cells.flat_map(|(i, j)| {
        let [a, b, c, d] = [point(i, j), point(i, j + 1), point(i + 1, j + 1), point(i + 1, j)];
        [[a, b, c], [a, c, d]]
    });
    let floor = [[-4.0, -0.9, -4.0], [-4.0, -0.9, 4.0], [4.0, -0.9, 4.0], [4.0, -0.9, -4.0]];
    let all = triangles.chain([[floor[0], floor[1], floor[2]], [floor[0], floor[2], floor[3]]]);
    all.map(|corners| Primitive::Triangle { corners, normals: None }).collect()
}

/// Rays from anywhere in the room to anywhere: without any order.
fn anywhere(reach: f64) -> Vec<Ray<F32x8>> {
    let mut dice = Dice::new(3.0_f64, 4.0);
    let rays = (0..RAYS / 8).map(|_| {
        let mut vector = || {
            let [x, y, z] = [0; 3].map(|_| Eight(std::array::from_fn(|_| (reach * (2.0 * dice.throw() - 1.0)) as f32)));
            Vector::new(x, y, z)
        };
        let origin = vector();
        Ray { origin, direction: (vector() - origin).normalised() }
    });
    rays.collect()
}

/// Light that has bounced: from the hits of camera rays, to anywhere above the surface.
fn bounced(world: &World<F32x8>) -> Vec<Ray<F32x8>> {
    let mut dice = Dice::new(5.0_f64, 6.0);
    let mut draw = || Eight(std::array::from_fn(|_| (2.0 * dice.throw() - 1.0) as f32));
    let mut found = Vec::new();
    for ray in camera().iter().cycle() {
        let hit = world.closest(ray, hits(ray));
        let surface = world.surface(ray, &hit);
        let out = Vector::new(draw(), draw(), draw());
        let length = out.dot(out).sqrt();
        let out = surface.normal.scaled(Eight([1.05; 8])) + out.scaled(Eight([1.0; 8]) / length);
        let (origin, direction) = (surface.leave(out), out.normalised());
        let is_hit = |lane: &usize| hit.primitive.0[*lane] >= 0.0;
        found.extend((0..8).filter(is_hit).map(|lane| [origin.lane(lane), direction.lane(lane)]));
        if found.len() >= RAYS {
            break;
        }
    }
    let rays = (0..RAYS / 8).map(|at| {
        let [origin, direction] = [0, 1].map(|which| {
            let [x, y, z] = [0, 1, 2].map(|axis| F32x8::from_lanes(|lane| found[8 * at + lane][which][axis]));
            Vector::new(x, y, z)
        });
        Ray { origin, direction }
    });
    rays.collect()
}

/// From a camera, in squares of 8 neighbours.
fn camera() -> Vec<Ray<F32x8>> {
    let rays = (0..RAYS / 8).map(|at| {
        let (row, column) = (at / 8, at % 8);
        let x = Eight(std::array::from_fn(|lane| ((column * 8 + lane) as f32 / 64.0 - 0.5) * 0.8));
        let y = Eight([(row as f32 / 64.0 - 0.5) * 0.8; 8]);
        let direction = Vector::new(x, y, Eight([-1.0; 8])).normalised();
        Ray { origin: Vector::of([0.0, 0.0, 2.5]), direction }
    });
    rays.collect()
}

fn hits(ray: &Ray<F32x8>) -> Eight<u32> {
    ray.direction.x.le(Eight([f32::INFINITY; 8]))
}

fn world(primitives: &[Primitive], structure: Structure) -> World<F32x8> {
    World::with(primitives, &Settings { structure, ends: Ends::OnSurfaces(vec![]) })
}

fn closest(bencher: Bencher, world: &World<F32x8>, rays: &[Ray<F32x8>]) {
    bencher.counter(ItemsCount::new(RAYS)).bench_local(|| {
        vectorised(
            #[inline(always)]
            || {
                let mut sum = F32x8::of(0.0);
                for ray in rays {
                    let hit = world.closest(ray, hits(ray));
                    sum = sum + hit.primitive + hit.u + hit.v;
                }
                black_box(sum)
            },
        )
    });
}

fn blocked(bencher: Bencher, world: &World<F32x8>, rays: &[Ray<F32x8>]) {
    bencher.counter(ItemsCount::new(RAYS)).bench_local(|| {
        vectorised(
            #[inline(always)]
            || {
                let mut sum = F32x8::of(0.0);
                for ray in rays {
                    sum = sum + F32x8::of(1.0).only(world.is_blocked(ray, F32x8::of(1.0), hits(ray)));
                }
                black_box(sum)
            },
        )
    });
}

/// Quads in a room, one by one and through the hierarchy: where the second wins.
#[divan::bench(args = [8, 16, 24, 32, 40, 48, 64, 96], consts = [false, true])]
fn few_closest<const BVH: bool>(bencher: Bencher, count: usize) {
    closest(bencher, &world(&room(count), if BVH { Structure::Bvh } else { Structure::Brute }), &anywhere(0.95));
}

#[divan::bench(args = [8, 16, 24, 32, 40, 48, 64, 96], consts = [false, true])]
fn few_blocked<const BVH: bool>(bencher: Bencher, count: usize) {
    blocked(bencher, &world(&room(count), if BVH { Structure::Bvh } else { Structure::Brute }), &anywhere(0.95));
}

#[divan::bench(args = [8, 12, 16, 24], consts = [false, true])]
fn few_closest_single<const BVH: bool>(bencher: Bencher, count: usize) {
    let settings =
        Settings { structure: if BVH { Structure::Bvh } else { Structure::Brute }, ends: Ends::OnSurfaces(vec![]) };
    let world = World::<f64>::with(&room(count), &settings);
    let one = |v: Vector<F32x8>, lane: usize| Vector::of(v.lane(lane));
    let of = |ray: &Ray<F32x8>, lane| Ray { origin: one(ray.origin, lane), direction: one(ray.direction, lane) };
    let rays: Vec<Ray<f64>> = anywhere(0.95).iter().flat_map(|ray| (0..8).map(|lane| of(ray, lane))).collect();
    bencher.counter(ItemsCount::new(RAYS)).bench_local(|| {
        vectorised(
            #[inline(always)]
            || rays.iter().map(|ray| world.closest(ray, true).t).sum::<f64>(),
        )
    });
}

#[divan::bench]
fn room_surface(bencher: Bencher) {
    let world = world(&room(16), Structure::Brute);
    surface(bencher, &world, &anywhere(0.95));
}

fn surface(bencher: Bencher, world: &World<F32x8>, rays: &[Ray<F32x8>]) {
    let hits: Vec<_> = rays.iter().map(|ray| (*ray, world.closest(ray, hits(ray)))).collect();
    bencher.counter(ItemsCount::new(RAYS)).bench_local(|| {
        vectorised(
            #[inline(always)]
            || {
                let mut sum = F32x8::of(0.0);
                for (ray, hit) in &hits {
                    let surface = world.surface(ray, hit);
                    sum = sum + surface.shading.x + surface.leave(ray.direction).y;
                }
                black_box(sum)
            },
        )
    });
}

const MESH: usize = 200_000;

#[divan::bench(sample_count = 10)]
fn mesh_build(bencher: Bencher) {
    let primitives = ball(MESH);
    let world = world(&primitives, Structure::Bvh);
    println!("{} primitives, {:.1} B each", primitives.len(), world.bytes() as f64 / primitives.len() as f64);
    bencher.bench_local(|| World::<F32x8>::new(black_box(&primitives)));
}

#[divan::bench]
fn mesh_closest_camera(bencher: Bencher) {
    closest(bencher, &world(&ball(MESH), Structure::Bvh), &camera());
}

#[divan::bench]
fn mesh_closest_bounced(bencher: Bencher) {
    let world = world(&ball(MESH), Structure::Bvh);
    closest(bencher, &world, &bounced(&world));
}

#[divan::bench]
fn mesh_closest_anywhere(bencher: Bencher) {
    closest(bencher, &world(&ball(MESH), Structure::Bvh), &anywhere(1.0));
}

#[divan::bench]
fn mesh_blocked_bounced(bencher: Bencher) {
    let world = world(&ball(MESH), Structure::Bvh);
    blocked(bencher, &world, &bounced(&world));
}

#[divan::bench]
fn mesh_blocked_anywhere(bencher: Bencher) {
    blocked(bencher, &world(&ball(MESH), Structure::Bvh), &anywhere(1.0));
}

#[divan::bench]
fn mesh_surface(bencher: Bencher) {
    surface(bencher, &world(&ball(MESH), Structure::Bvh), &camera());
}
