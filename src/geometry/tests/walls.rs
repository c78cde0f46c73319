//! What is left out between two points cannot come between them.

use super::*;
use crate::geometry::walls::walls;
use crate::number::Mask;

/// A room, its lamp set into the ceiling, and what stands in it.
fn room(even: &mut Even) -> Vec<Primitive> {
    let mut all = cube([-1.0; 3], [1.0; 3]);
    all.push(quad([-0.25, 1.0, -0.25], [[0.5, 0.0, 0.0], [0.0, 0.0, 0.5]]));
    all.extend(cube([-0.6, -1.0, -0.5], [-0.1, 0.2, 0.1]));
    all.push(Primitive::Sphere { center: [0.5, -0.6, 0.3], radius: 0.4 });
    all.push(Primitive::Disc { center: [0.2, 0.3, -0.4], normal: even.direction(), radius: 0.3 });
    all.push(flat([[-0.9, -0.9, 0.9], [0.9, -0.5, 0.9], [0.1, 0.9, 0.8]]));
    all
}

/// A point of a surface, and the surface there.
fn on<N: Width>(world: &World<N>, even: &mut Even) -> Surface<N> {
    loop {
        let ray = ray::<N>(even.point(), even.direction());
        let hit = world.closest(&ray, active::<N>());
        if hit.primitive.lane(0) >= 0.0 {
            return world.surface(&ray, &hit);
        }
    }
}

#[test]
fn walls_are_what_has_all_on_one_side() {
    let all = room(&mut Even::new("walls/which"));
    // The six of the room, the lamp in the ceiling, and the box's underside on the floor.
    assert_eq!(walls(&all, &[], usize::MAX), [0, 1, 2, 3, 4, 5, 6, 9]);
    // A lamp or a lens outside makes the walls beside it what they are; the largest come first.
    assert_eq!(walls(&all, &[[0.0, 0.0, 2.0]], usize::MAX), [0, 1, 2, 3, 4, 6, 9]);
    assert_eq!(walls(&all, &[[0.0, 5.0, 0.0]], usize::MAX), [0, 1, 2, 4, 5, 9]);
    assert_eq!(walls(&all, &[], 3), [0, 1, 2]);
    // What pokes through by a thousandth.
    let through = |primitive: Primitive| {
        let mut all = all.clone();
        all.push(primitive);
        walls(&all, &[], usize::MAX).contains(&0)
    };
    assert!(through(Primitive::Sphere { center: [-0.5, 0.0, 0.0], radius: 0.5 }));
    assert!(!through(Primitive::Sphere { center: [-0.5, 0.0, 0.0], radius: 0.501 }));
    let disc = |radius: f64| Primitive::Disc { center: [-0.7, 0.0, 0.0], normal: [0.8, 0.6, 0.0], radius };
    assert!(through(disc(0.499)) && !through(disc(0.501)));
    let corner = |x: f64| flat([[0.0; 3], [x, 0.1, 0.0], [0.0, 0.1, 0.2]]);
    assert!(through(corner(-0.999)) && !through(corner(-1.001)));
    let edge = |x: f64| quad([0.0; 3], [[0.5 * x, 0.1, 0.0], [0.5 * x, 0.0, 0.2]]);
    assert!(through(edge(-0.999)) && !through(edge(-1.001)));
    // A sphere is never one; nor is what has no area.
    assert!(
        walls(&[Primitive::Sphere { center: [0.0; 3], radius: 1.0 }, quad([0.0; 3], [[0.0; 3]; 2])], &[], 9).is_empty()
    );
}

fn same_shadows<N: Width>(address: &str, pairs: usize) {
    let mut even = Even::new(address);
    let primitives = room(&mut even);
    let also = [0.0, 0.5, 0.7];
    let world = |structure: Structure, ends: Ends| World::<N>::with(&primitives, &Settings { structure, ends });
    let all = world(Structure::Brute, Ends::Anywhere);
    let some = [Structure::Brute, Structure::Bvh].map(|one| world(one, Ends::OnSurfaces(vec![also])));
    let mut shadows = 0;
    for at in 0..pairs {
        let (from, to) = (on(&all, &mut even), on(&all, &mut even));
        let is_lamp = at % 8 == 0;
        let way = if is_lamp { Vector::of(also) } else { to.point } - from.point;
        let (from, to) = (from.leave(way), if is_lamp { Vector::of(also) } else { to.leave(-way) });
        let ray = Ray { origin: from, direction: to - from };
        let expected = all.is_blocked(&ray, N::of(1.0), active::<N>()).any();
        shadows += usize::from(expected);
        for world in &some {
            assert_eq!(world.is_blocked(&ray, N::of(1.0), active::<N>()).any(), expected, "{ray:?}");
        }
    }
    // Both answers are common.
    assert!(shadows > pairs / 10 && shadows < pairs * 9 / 10, "{shadows} of {pairs}");
}

#[test]
fn shadows_are_the_same_without_walls() {
    same_shadows::<f64>("walls/f64", 60_000);
    same_shadows::<f32>("walls/f32", 60_000);
}

/// They are left out of shadows, not of what is seen.
#[test]
fn walls_are_met() {
    let mut even = Even::new("walls/met");
    let primitives = room(&mut even);
    let settings = |ends: Ends| Settings { structure: Structure::Brute, ends };
    let [all, some] =
        [Ends::Anywhere, Ends::OnSurfaces(vec![])].map(|ends| World::<f32>::with(&primitives, &settings(ends)));
    for _ in 0..20_000 {
        let ray = ray(even.point(), even.direction());
        let hits = [&all, &some].map(|world| world.closest(&ray, true));
        let bits = hits.map(|hit| [hit.t, hit.u, hit.v, hit.primitive].map(f32::to_bits));
        assert_eq!(bits[0], bits[1]);
        // And a ray that ends in the open may be stopped by a wall only where all are asked.
        assert!(all.is_blocked(&ray, f32::INFINITY, true));
    }
    assert!(!some.is_blocked(&ray([0.0, 0.9, 0.0], [1.0, 0.0, 0.0]), f32::INFINITY, true));
}
