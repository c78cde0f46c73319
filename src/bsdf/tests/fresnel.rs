//! The reflectance of every width against arbitrary precision, and its mean against a rule.

use crate::bsdf::fresnel::{Conductor, Reflecting, dielectric};
use crate::bsdf::{Setting, zoo};
use crate::number::{F32x8, Number, Vector};
use crate::optics::fresnel::{diffuse_reflectance, powers};
use crate::optics::{Direction, Incidence};
use crate::references::fresnel::{Exact, Input, NAMES, refracted_cosine};
use num_complex::Complex64;
use yardstick::precise::relative_error;
use yardstick::quadrature::gauss_legendre;

/// To grazing; where cos² passes ½; and about Brewster's angle into η = 1.5, 2.4, 1/1.5 and 1/2.4.
const COSINES: [f64; 16] = [
    1e-6,
    1e-3,
    0.03,
    0.1,
    0.3,
    0.3846,
    0.5,
    0.5547,
    0.6,
    std::f64::consts::FRAC_1_SQRT_2,
    0.7072,
    0.8320503,
    0.9230769,
    0.95,
    0.998,
    1.0,
];

const ETAS: [f64; 7] = [1.5, 2.4, 1.001, 1.0 / 1.5, 1.0 / 2.4, 0.999, 0.1];

/// Gold, copper at one wavelength each, a metal that barely absorbs, one that is nearly all κ, and a clear coat.
const METALS: [(f64, f64); 6] = [(0.14, 4.1), (0.43, 2.46), (1.38, 1.92), (2.5, 0.3), (0.05, 9.0), (1.5, 0.0)];

fn input(cos: f64, n: f64, k: f64) -> Input {
    Input { direction: Direction::Cos(cos), n_i: 1.0, n_t: Complex64::new(n, k) }
}

/// |error|/(ε(1 + κ)) of R_n.
fn ratio(found: f64, input: &Input, epsilon: f64) -> f64 {
    let exact = Exact::new(input);
    let at = NAMES.iter().position(|name| *name == "R_n").expect("an output");
    relative_error(found, &exact.outputs[at]) / (epsilon * (1.0 + exact.conditions()[at]))
}

fn keeps_its_digits<N: Number>() {
    let rounded = |x: f64| N::of(x).lane(0);
    for cos in COSINES.map(rounded) {
        for eta in ETAS.map(rounded) {
            let found = dielectric(N::of(cos), N::of(eta));
            let input = input(cos, eta, 0.0);
            let reflectance = ratio(found.reflectance.lane(0), &input, N::EPSILON);
            // The promise of the crate.
            assert!(reflectance <= 16.0, "R of η {eta} at {cos}: {found:?}, {reflectance}");
            let is_total = (1.0 - cos) * (1.0 + cos) >= eta * eta;
            assert_eq!(found.cos_t.lane(0) == 0.0, is_total, "η {eta} at {cos}: {found:?}");
            if is_total {
                assert_eq!(found.reflectance.lane(0), 1.0, "η {eta} at {cos}");
            } else {
                let (exact, condition) = refracted_cosine(&input);
                let cosine = relative_error(found.cos_t.lane(0), &exact) / (N::EPSILON * (1.0 + condition));
                assert!(cosine <= 16.0, "cos θ_t of η {eta} at {cos}: {found:?}, {cosine}");
            }
        }
        // A different one in each channel.
        for metals in METALS.windows(3) {
            let metal =
                Conductor { n: [0, 1, 2].map(|c| N::of(metals[c].0)), k: [0, 1, 2].map(|c| N::of(metals[c].1)) };
            for (c, found) in metal.reflectance(N::of(cos)).into_iter().enumerate() {
                let input = input(cos, metal.n[c].lane(0), metal.k[c].lane(0));
                let off = ratio(found.lane(0), &input, N::EPSILON);
                assert!(off <= 16.0, "R of {:?} at {cos}: {found:?}, {off}", metals[c]);
            }
        }
    }
}

#[test]
fn reflectances_keep_their_digits() {
    keeps_its_digits::<f64>();
    keeps_its_digits::<f32>();
    keeps_its_digits::<F32x8>();
}

#[test]
fn means_are_those_of_gausss_rule() {
    let mean = |n: Complex64| {
        let node = |&(cos, weight): &(f64, f64)| weight * 2.0 * cos * powers(Incidence::from_cos(cos), 1.0, n).r_n();
        gauss_legendre(64).iter().map(node).sum::<f64>()
    };
    for metals in METALS.windows(3) {
        let metal = Conductor { n: [0, 1, 2].map(|c: usize| metals[c].0), k: [0, 1, 2].map(|c: usize| metals[c].1) };
        for (found, &(n, k)) in metal.mean_reflectance().into_iter().zip(metals) {
            // The midpoint rule's (1/256)²/24 times a slope of about 1 at grazing.
            let expected = mean(Complex64::new(n, k));
            assert!((found - expected).abs() < 1e-4, "{n} + {k}i: {found} {expected}");
        }
    }
    assert!((mean(1.5.into()) - diffuse_reflectance(1.5)).abs() < 1e-12);
}

#[test]
fn polished_metal_reflects_what_its_indices_say() {
    let metal = [(0.14, 4.1), (0.43, 2.46), (1.38, 1.92)].map(|(n, k)| Complex64::new(n, k));
    let entry = zoo::<f64>().into_iter().find(|entry| entry.name == "conductor").expect("a model");
    let model = entry.make(&Setting { metal, ..Setting::default() });
    for cos in [1.0, 0.5, 0.1] {
        let wo = super::direction(cos, 0.7);
        let (albedo, drawn) = (model.albedo(wo).expect("closed"), model.sample(wo, [0.5; 3]));
        for c in 0..3 {
            let expected = powers(Incidence::from_cos(wo.z), 1.0, metal[c]).r_n();
            for found in [albedo[c], drawn.weight[c]] {
                assert!((found - expected).abs() < 1e-13, "{} at {cos}: {found} {expected}", metal[c]);
            }
        }
        let Vector { x, y, z } = drawn.wi;
        assert_eq!([x, y, z], [-wo.x, -wo.y, wo.z]);
    }
}
