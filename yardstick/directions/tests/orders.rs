//! How fast errors fall, on integrands that are smooth, kinked, stepped and nearly singular.

use super::super::{Direction, Domain, Points, Rule, TOP_LEVEL, integral, lebedev, product, sampled};
use super::{axis, cosine};
use crate::order::slope;
use crate::random::stream;
use crate::statistics::{Moments, rms};
use std::f64::consts::{PI, TAU};

/// A function of the cosine to an axis, and its integral over the sphere.
type Integrand = (&'static str, fn(f64) -> f64, f64);

fn integrands() -> [Integrand; 4] {
    [
        ("smooth", |c| (2.0 * c).exp(), TAU * 2.0_f64.sinh()),
        ("kink", |c| c.max(0.0), PI),
        ("step", |c| f64::from(u8::from(c > 0.3)), TAU * 0.7),
        ("nearly singular", |c| 1.0 / (1.01 - c), TAU * 201.0_f64.ln()),
    ]
}

/// The relative error of `rule`, rms over 24 axes.
fn error(rule: &Rule, (_, f, exact): Integrand) -> f64 {
    let mut stream = stream(1, "directions/axes");
    let errors: Vec<f64> = (0..24)
        .map(|_| axis(&mut stream))
        .map(|axis| integral(rule, |direction| f(cosine(axis, direction))) / exact - 1.0)
        .collect();
    rms(&errors)
}

fn order(rules: &[Rule], integrand: Integrand) -> f64 {
    let points: Vec<_> = rules.iter().map(|rule| (rule.len() as f64, error(rule, integrand))).collect();
    slope(&points).expect("a slope")
}

#[test]
fn rules_gain_from_smoothness() {
    let lebedevs: Vec<Rule> = (1..=TOP_LEVEL).map(lebedev).collect();
    let products: Vec<Rule> = (3..=24).step_by(3).map(|polar| product(Domain::Sphere, polar)).collect();
    let [smooth, kink, step, nearly] = integrands();
    // Fifty points either way, of degree 11 with the cube's symmetry and 9 in a product; then rounding alone is left.
    assert!(error(&lebedevs[1], smooth) < 1e-9 && error(&product(Domain::Sphere, 5), smooth) > 1e-8);
    assert!(error(&lebedevs[2], smooth) < 1e-14 && error(&product(Domain::Sphere, 8), smooth) < 1e-13);
    for rules in [&lebedevs, &products] {
        // Beyond its degree t a rule knows nothing: what is left of a kink's harmonics falls as t^−5/2, of a step's as
        // t^−3/2, and N ~ t².
        assert!((order(&rules[2..], kink) + 1.25).abs() < 0.25, "{}", order(&rules[2..], kink));
        assert!((order(&rules[2..], step) + 0.75).abs() < 0.25, "{}", order(&rules[2..], step));
    }
    // The pole at 1.01 makes harmonics fall as ρ^−l, ρ = 1.01 + √(1.01² − 1) = 1.152: by a factor of 1.152^36 = 163 from
    // degree 35 to 71, and a little more for the many that a rule gets right beyond its degree.
    let gain = error(&lebedevs[5], nearly) / error(&lebedevs[11], nearly);
    assert!((100.0..400.0).contains(&gain), "{gain}");
}

/// How fast the scatter of 32 seeds falls with the number of points under the cosine, for each integrand.
fn orders(points: Points) -> [f64; 4] {
    let scatter = |k: u32| {
        let mut runs = [[Moments::default(); 4]; 4];
        for seed in 0..32 {
            let address = format!("directions/{points:?}/{k}");
            let rule = sampled(Domain::Cosine, &points.draw(1 << k, &mut stream(seed, &address)));
            let mut axes = stream(1, "directions/scatter");
            for run in &mut runs {
                let axis: Direction = axis(&mut axes);
                for (moments, (_, f, _)) in run.iter_mut().zip(integrands()) {
                    moments.add(integral(&rule, |direction| f(cosine(axis, direction))));
                }
            }
        }
        std::array::from_fn(|at| rms(&runs.map(|run| run[at].variance().sqrt())))
    };
    let levels: Vec<(f64, [f64; 4])> = (6..=12).map(|k| (f64::from(1 << k), scatter(k))).collect();
    std::array::from_fn(|at| {
        let points: Vec<_> = levels.iter().map(|(n, errors)| (*n, errors[at])).collect();
        slope(&points).expect("a slope")
    })
}

#[test]
fn chance_has_one_order_and_plans_gain_from_smoothness() {
    // A scatter known from 4 × 32 runs to 6 % moves a slope over six octaves by 0.02; four of these are 0.1.
    for order in orders(Points::Random) {
        assert!((order + 0.5).abs() < 0.1, "{order}");
    }
    let [smooth, kink, step, nearly] = orders(Points::Stratified);
    assert!(
        [(smooth, 1.0), (kink, 1.0), (step, 0.75)].iter().all(|(is, due)| (is + due).abs() < 0.1),
        "{smooth} {kink} {step}"
    );
    assert!(nearly < -0.6, "{nearly}");
    // Owen's −3/2 holds up to logarithms and for smooth functions of the square, which these are not at the rim.
    let [smooth, kink, step, nearly] = orders(Points::Sobol);
    assert!(smooth <= -1.2 && kink <= -1.1 && nearly <= -0.9, "{smooth} {kink} {nearly}");
    assert!((-0.9..=-0.65).contains(&step), "{step}");
}
