//! What a draw says of itself, for every model.

use super::direction;
use crate::bsdf::audit::throw;
use crate::bsdf::{Setting, zoo};
use crate::number::Vector;
use crate::optics::Incidence;
use crate::optics::fresnel::powers;
use crate::optics::incidence::{mirrored, refracted};
use num_complex::Complex64;
use yardstick::quadrature::gauss_legendre;
use yardstick::random::stream;

/// Colours of bodies and metals, all different.
fn coloured() -> Setting {
    let metal = [(0.14, 4.1), (0.43, 2.46), (1.38, 1.92)].map(|(n, k)| Complex64::new(n, k));
    Setting { albedo: [0.9, 0.5, 0.2], metal, ..Setting::default() }
}

fn settings() -> [Setting; 3] {
    let plain = coloured();
    [plain, Setting { alpha: [0.9, 0.4], ..plain }, Setting { index: 1.0 / 1.5, alpha: [0.6; 2], ..plain }]
}

#[test]
fn draws_are_what_they_say() {
    for (setting, entry) in settings().iter().flat_map(|setting| zoo::<f64>().into_iter().map(move |e| (setting, e))) {
        let model = entry.make(setting);
        let character = model.character();
        for cos in [0.9, 0.3, -0.3, -0.9] {
            let wo = direction(f64::abs(cos), 0.7).flipped(cos < 0.0);
            let place = format!("{} {setting:?} {cos}", entry.name);
            let mut random = stream(13, &place);
            let index = |w: Vector<f64>| if w.z < 0.0 { setting.index } else { 1.0 };
            for _ in 0..200 {
                let drawn = model.sample(wo, [(); 3].map(|()| throw(&mut random)));
                let (f, pdf) = model.eval_pdf(drawn.wi, wo);
                let place = format!("{place}: {drawn:?}, {f:?}, {pdf}");
                if drawn.pdf == 0.0 && (!drawn.is_delta || drawn.weight[0] == 0.0) {
                    assert_eq!(drawn.weight, [0.0; 3], "{place}");
                    continue;
                }
                assert!((drawn.wi.dot(drawn.wi) - 1.0).abs() < 1e-13, "{place}");
                assert_eq!(drawn.is_transmitted, drawn.wi.z * wo.z < 0.0, "{place}");
                assert!(character.transmits || cos > 0.0 && drawn.wi.z > 0.0, "{place}");
                let compression = (index(wo) / index(drawn.wi)).powi(2);
                let compression = if drawn.is_transmitted { compression } else { 1.0 };
                assert!((drawn.compression - compression).abs() < 1e-14, "{place}");
                if drawn.is_delta {
                    assert!(character.has_delta && drawn.pdf == 0.0, "{place}");
                    // By the vectors' law, of rays that run the other way.
                    let (along, up) = ([-wo.x, -wo.y, -wo.z], [0.0, 0.0, 1.0]);
                    let expected = if drawn.is_transmitted {
                        refracted(along, up, index(wo), setting.index / index(wo))
                            .expect("not beyond the critical angle")
                    } else {
                        mirrored(along, up)
                    };
                    let found = [drawn.wi.x, drawn.wi.y, drawn.wi.z];
                    assert!((0..3).all(|k| (found[k] - expected[k]).abs() < 1e-14), "{place} {expected:?}");
                } else {
                    // The half vector keeps fewer digits than the facet: of lobes α ≥ 0.3 and cosines ≥ 0.3 some 1e−14.
                    assert!(!character.is_delta && (drawn.pdf / pdf - 1.0).abs() < 1e-10, "{place}");
                    let close =
                        |c: usize| (f[c] * drawn.wi.z.abs() / pdf - drawn.weight[c]).abs() <= 1e-10 * drawn.weight[c];
                    assert!(character.is_stochastic || (0..3).all(close), "{place}");
                }
            }
        }
    }
}

#[test]
fn channels_are_three_surfaces() {
    let setting = coloured();
    for entry in zoo::<f64>() {
        let all = entry.make(&setting);
        for c in 0..3 {
            let one = entry.make(&Setting { albedo: [setting.albedo[c]; 3], metal: [setting.metal[c]; 3], ..setting });
            let mut random = stream(14, entry.name);
            for _ in 0..20 {
                let mut way = |z: f64| direction(z, 6.0 * throw(&mut random)).flipped(throw(&mut random) < 0.3);
                let (wi, wo) = (way(0.7), way(0.4));
                let u = [(); 3].map(|()| throw(&mut random));
                let (all_f, one_f) = (all.eval(wi, wo), one.eval(wi, wo));
                let (all_drawn, one_drawn) = (all.sample(wo, u), one.sample(wo, u));
                let (all_albedo, one_albedo) = (all.albedo(wo), one.albedo(wo));
                let place = format!("{} channel {c} {wi:?} {wo:?} {u:?}", entry.name);
                assert_eq!(all_f[c], one_f[c], "f of {place}");
                assert_eq!(all_drawn.weight[c], one_drawn.weight[c], "weight of {place}");
                assert_eq!(all_albedo.map(|a| a[c]), one_albedo.map(|a| a[c]), "albedo of {place}");
            }
        }
    }
}

#[test]
fn polished_glass_chooses_by_fresnel() {
    let model = zoo::<f64>().into_iter().find(|entry| entry.name == "dielectric").expect("a model").make(&coloured());
    let count = 10_000;
    for cos in [1.0, 0.4, 0.1, -0.1, -0.5, -0.9] {
        let wo = direction(f64::abs(cos), 0.7).flipped(cos < 0.0);
        let (n_o, n) = if cos > 0.0 { (1.0, 1.5) } else { (1.5, 1.0) };
        let mirrored = |k: &usize| !model.sample(wo, [0.5, 0.5, (*k as f64 + 0.5) / count as f64]).is_transmitted;
        let share = (0..count).filter(mirrored).count() as f64 / count as f64;
        let expected = powers(Incidence::from_cos(wo.z.abs()), n_o, Complex64::from(n)).r_n();
        // Of even numbers one at most falls on the wrong side.
        assert!((share - expected).abs() <= 1.0 / count as f64, "μ {cos}: {share} {expected}");
    }
}

#[test]
fn densities_of_walks_are_no_more_than_one() {
    // ∫pdf dω over both sides: what is missing is drawn, and rejected, by the first bounce alone.
    for name in ["conductor-walk", "dielectric-walk"] {
        let entry = zoo::<f64>().into_iter().find(|entry| entry.name == name).expect("a model");
        let model = entry.make(&Setting { alpha: [1.0; 2], ..Setting::default() });
        for cos in [0.9, 0.4] {
            let wo = direction(cos, 0.0);
            let mut sum = 0.0;
            for (u, du) in gauss_legendre(48) {
                for k in 0..96 {
                    let wi = direction(u, std::f64::consts::TAU * (f64::from(k) + 0.5) / 96.0);
                    let both = model.pdf(wi, wo) + model.pdf(wi.flipped(true), wo);
                    sum += du * std::f64::consts::TAU / 96.0 * both;
                }
            }
            assert!(sum <= 1.0 + 1e-3 && sum > 0.8, "{name} {cos}: {sum}");
        }
    }
}
