//! Mirrors, grazing light, and rays that do not come back.

use super::super::{Fate, Relief};
use super::{dot, even, gaussian, towards};
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, TAU};

proptest! {
    #[test]
    fn a_flat_relief_is_a_mirror_to_the_bit(
        theta in 0.0..FRAC_PI_2, phi in 0.0..TAU, u in 0.0..1.0_f64, v in 0.0..1.0_f64, bits in 1_u32..6,
    ) {
        let wi = towards(theta, phi);
        let path = Relief::flat(1 << bits).expect("valid").trace(wi, [u, v], |cos| cos, 1);
        prop_assert_eq!((path.fate, path.bounces, path.first), (Fate::Left, 1, [0.0, 0.0, 1.0]));
        prop_assert_eq!(path.direction, [-wi[0], -wi[1], wi[2]]);
        prop_assert_eq!(path.power, wi[2]);
    }

    #[test]
    fn no_relief_is_too_much(
        heights in prop::collection::vec(prop_oneof![-1.0..1.0_f64, -1e12..=1e12_f64, Just(0.0), Just(1e-300)], 16),
        theta in 0.0..1.57_f64, phi in 0.0..TAU, u in 0.0..1.0_f64, v in 0.0..1.0_f64,
    ) {
        let path = Relief::new(4, heights).expect("valid").trace(towards(theta, phi), [u, v], |cos| cos, 1000);
        prop_assert!((dot(path.direction, path.direction) - 1.0).abs() < 1e-9, "{path:?}");
        prop_assert!((dot(path.first, path.first) - 1.0).abs() < 1e-12 && (0.0..=1.0).contains(&path.power), "{path:?}");
    }

    #[test]
    fn no_direction_is_too_much(
        height in prop_oneof![Just(0.0), Just(1e-300), Just(1e-12), 0.0..1.0_f64, Just(1.0)],
        phi in prop_oneof![0.0..TAU, (0..8_i32).prop_map(|eighth| f64::from(eighth) * FRAC_PI_4)],
        u in prop_oneof![0.0..1.0_f64, Just(0.0), Just(0.5), Just(1.0)],
        v in prop_oneof![0.0..1.0_f64, Just(0.0), Just(0.25)],
        alpha in prop_oneof![Just(1e-4), 0.01..1.0_f64, Just(10.0)],
    ) {
        let relief = Relief::gaussian(16, 2.0, alpha, even(1, "relief/hostile")).expect("valid");
        let level = (1.0 - height * height).sqrt();
        let path = relief.trace([level * phi.cos(), level * phi.sin(), height], [u, v], |_| 1.0, 100);
        prop_assert!(path.direction.iter().chain(&path.first).all(|part| part.is_finite()), "{path:?}");
        prop_assert!((dot(path.direction, path.direction) - 1.0).abs() < 1e-12, "{path:?}");
        prop_assert!(path.power == 1.0 && path.bounces <= 100);
        // All rays that came down leave upwards, or are said to be missing.
        prop_assert!(path.fate == Fate::Trapped || path.direction[2] >= 0.0, "{path:?}");
    }
}

#[test]
fn level_rays_and_those_from_below_pass_over() {
    let relief = gaussian(0.5);
    for wi in [[1.0, 0.0, 0.0], [-FRAC_PI_4.cos(), FRAC_PI_4.sin(), -0.0], [0.6, 0.0, -0.8]] {
        let path = relief.trace(wi, [0.3, 0.7], |_| 0.0, 10);
        assert_eq!((path.fate, path.bounces, path.power), (Fate::Left, 0, 1.0));
        assert_eq!(path.direction, wi.map(|part| 0.0 - part));
    }
}

#[test]
fn what_cannot_leave_is_counted() {
    let relief = gaussian(1.0);
    let mut even = even(1, "relief/trapped");
    let points: Vec<[f64; 2]> = (0..4000).map(|_| [even(), even()]).collect();
    let wi = towards(0.5, 0.3);
    let free = relief.trace_all(wi, &points, |_| 0.5, 1000);
    assert!(free.iter().all(|path| path.fate == Fate::Left && path.bounces >= 1));
    for most in 0..3 {
        let held = relief.trace_all(wi, &points, |_| 0.5, most);
        for (held, free) in held.iter().zip(&free) {
            assert_eq!(held.fate == Fate::Trapped, free.bounces > most);
            assert_eq!(held.bounces, free.bounces.min(most));
            assert_eq!(held.power, 0.5_f64.powi(held.bounces as i32));
        }
        assert!(held.iter().any(|path| path.fate == Fate::Trapped));
    }
}

#[test]
fn a_ray_that_runs_along_the_horizon_is_counted_too() {
    // One peak, and a ray that falls by 10⁻¹² a cell beside it: a march of 10¹² cells.
    let mut heights = vec![0.0; 16];
    heights[0] = 1.0;
    let relief = Relief::new(4, heights).expect("valid");
    let path = relief.trace([-1.0, 0.0, 1e-12], [0.1, 0.625], |_| 0.0, 10);
    assert_eq!((path.fate, path.bounces, path.power), (Fate::Trapped, 0, 1.0));
    // In the peak's own row it meets it on the way.
    let path = relief.trace([-1.0, 0.0, 1e-12], [0.1, 0.0], |_| 0.5, 10);
    assert_eq!((path.fate, path.bounces, path.power), (Fate::Left, 1, 0.5));
}

#[test]
fn neither_threads_nor_neighbours_move_a_ray() {
    let relief = gaussian(0.5);
    let mut even = even(1, "relief/threads");
    let points: Vec<[f64; 2]> = (0..2000).map(|_| [even(), even()]).collect();
    let wi = towards(1.2, 1.0);
    let all = relief.trace_all(wi, &points, |cos| cos, 100);
    for (point, path) in points.iter().zip(&all) {
        assert_eq!(*path, relief.trace(wi, *point, |cos| cos, 100));
        // A period farther it is the same ray, up to the rounding of its place.
        let farther = relief.trace(wi, [point[0] + 1.0, point[1] - 2.0], |cos| cos, 100);
        assert!(farther.bounces == path.bounces && dot(farther.direction, path.direction) > 1.0 - 1e-6);
    }
}

proptest! {
    #[test]
    fn edges_and_corners_send_light_away_once(
        heights in prop::collection::vec(-0.05..0.05_f64, 16),
        theta in 0.0..0.5_f64, phi in 0.0..TAU, x in 0_i32..4, y in 0_i32..4, along in 0.0..1.0_f64, way in 0_usize..4,
    ) {
        // Slopes up to 0.15 turn light by less than 0.43 from 0.5 at most: none can meet a second facet.
        let relief = Relief::new(4, heights).expect("valid");
        let [dx, dy] = [[0.0, 0.0], [along, 0.0], [0.0, along], [along, along]][way];
        let (x, y) = (f64::from(x), f64::from(y));
        // The height there is that of the edge between two corners.
        let height = |x: f64, y: f64| relief.heights()[y as usize % 4 * 4 + x as usize % 4];
        let end = height(x + dx.ceil(), y + dy.ceil());
        let place = [x + dx, y + dy, height(x, y) + along * if way == 0 { 0.0 } else { end - height(x, y) }];
        let wi = towards(theta, phi);
        let rise = (relief.top() - place[2]) / wi[2];
        let start = [0, 1].map(|axis| (place[axis] + rise * wi[axis]) / 4.0);
        let path = relief.trace(wi, start, |_| 0.5, 100);
        prop_assert!(path.fate == Fate::Left && path.bounces == 1, "{path:?}");
        // Back it goes as the facet it met says.
        let cos = dot(path.first, wi);
        let mirrored: [f64; 3] = std::array::from_fn(|axis| 2.0 * cos * path.first[axis] - wi[axis]);
        prop_assert!(dot(mirrored, path.direction) > 1.0 - 1e-12, "{path:?}");
    }
}
