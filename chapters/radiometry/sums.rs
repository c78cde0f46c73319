//! Sums over directions, as races: functions that are smooth, kinked, stepped and nearly singular, by rules and by chance.

use crate::plane_wave::fields::direction;
use crate::vocabulary::{Bench, Heat, Judge, Lane, lane};
use glam::DVec3;
use std::f64::consts::{PI, TAU};
use yardstick::directions::{Domain, Points, Rule, integral, lebedev, product, sampled};

/// A function of the cosine between a direction and an axis.
pub(super) type Pattern = fn(f64) -> f64;

/// A function to be summed over all directions, and its sum.
#[derive(Clone, Copy)]
pub(super) struct Subject {
    pub of: Pattern,
    pub exact: fn() -> f64,
}

/// e^(2c): a lamp with a soft beam.
pub(super) const SMOOTH: Subject = Subject { of: |c| (2.0 * c).exp(), exact: || TAU * 2.0_f64.sinh() };
/// max(0, c): a flat lamp.
pub(super) const KINK: Subject = Subject { of: |c| c.max(0.0), exact: || PI };
/// 1 where c > 0.3: a lamp with a shade.
pub(super) const STEP: Subject = Subject { of: |c| f64::from(u8::from(c > 0.3)), exact: || TAU * 0.7 };
/// 1/(1.01 − c): a lamp 0.13 of the radius inside the wall of its sphere.
pub(super) const NEAR: Subject = Subject { of: |c| 1.0 / (1.01 - c), exact: || TAU * 201.0_f64.ln() };

/// So many random axes make one error.
pub(super) const AXES: u32 = 24;

/// A heat: `rule` sums `subject` about an axis that chance turns.
fn heat(bench: &mut Bench, rule: Rule, subject: Subject) -> Heat {
    let axis = direction(&mut bench.stream);
    let cos = move |way: [f64; 3]| DVec3::from_array(way).dot(axis);
    let exact = (subject.exact)();
    let error: Judge = Box::new(move |found| (found[0] / exact - 1.0).abs());
    Heat { run: Box::new(move || vec![integral(&rule, |way| (subject.of)(cos(way)))]), error }
}

/// Directions drawn by chance.
pub(super) fn by_chance(bench: &mut Bench, work: u64, subject: Subject) -> Heat {
    let points = Points::Random.draw(work as usize, &mut bench.stream);
    heat(bench, sampled(Domain::Sphere, &points), subject)
}

/// Gauss's rule from pole to pole, even steps around: `work` = 2n² directions.
pub(super) fn by_product(bench: &mut Bench, work: u64, subject: Subject) -> Heat {
    heat(bench, product(Domain::Sphere, (work as f64 / 2.0).sqrt().round() as usize), subject)
}

/// Lebedev's rule of `work` = 12n² + 2 directions.
pub(super) fn by_lebedev(bench: &mut Bench, work: u64, subject: Subject) -> Heat {
    heat(bench, lebedev((work as f64 / 12.0).sqrt().floor() as usize), subject)
}

/// Numbers of directions by chance.
pub(super) const CHANCE: &[u64] = &[64, 256, 1024, 4096, 16384];
/// Numbers of directions of products.
pub(super) const PRODUCTS: &[u64] = &[18, 50, 128, 288, 578, 1152, 2048];
/// Numbers of directions of Lebedev's rules.
pub(super) const LEBEDEVS: &[u64] = &[14, 50, 110, 194, 434, 770, 1202];

/// The lane of chance, of which only the subject differs.
pub(super) const fn chance(prepare: fn(&mut Bench, u64) -> Heat) -> Lane {
    lane("monte_carlo", "Monte Carlo", CHANCE, prepare).repeated(AXES).order(0.5, 0.15)
}
