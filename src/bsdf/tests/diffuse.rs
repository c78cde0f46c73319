use super::direction;
use crate::bsdf::eon::Eon;
use crate::bsdf::{Bsdf, Setting, zoo};
use crate::optics::Incidence;
use crate::optics::fresnel::{diffuse_reflectance, powers};
use yardstick::quadrature::gauss_legendre;

/// ∫f cos θ_i dω_i by Gauss and the trapezoid, for lobes that are kinked along the plane of incidence at most.
fn furnace(model: &dyn Bsdf<f64>, wo: crate::number::Vector<f64>) -> f64 {
    // Kinked where the cosines are equal and where the azimuths are a quarter turn apart: no rule reaches across.
    let part = |low: f64, high: f64, from: f64| {
        let mut sum = 0.0;
        for (u, du) in gauss_legendre(32) {
            for (v, dv) in gauss_legendre(32) {
                // Bunched at both ends, where E has roots.
                let cos = low + (high - low) * u * u * (3.0 - 2.0 * u);
                let weight = (high - low) * 6.0 * u * (1.0 - u) * du * std::f64::consts::PI * dv;
                sum += weight * cos * model.eval(direction(cos, std::f64::consts::PI * (from + v)), wo)[0];
            }
        }
        sum
    };
    let cos_o = wo.z;
    [-0.5, 0.5].into_iter().map(|from| part(0.0, cos_o, from) + part(cos_o, 1.0, from)).sum()
}

#[test]
fn eons_white_furnace_is_white() {
    // Its own closed albedo, of any roughness and angle: 1 to 1e−12.
    for roughness in [0.0, 1e-6, 0.1, 0.5, 1.0] {
        let eon = Eon { albedo: [1.0; 3], roughness };
        for cos in [1e-6, 1e-3, 0.1, 0.5, 0.9, 1.0] {
            let closed = eon.albedo(direction(cos, 0.0)).unwrap()[0];
            assert!((closed - 1.0).abs() <= 1e-12, "r {roughness} μ {cos}: {closed}");
        }
    }
}

#[test]
fn albedos_are_the_integrals() {
    let setting = Setting { albedo: [0.7; 3], ..Setting::default() };
    for entry in zoo::<f64>() {
        let model = entry.make(&setting);
        if !["lambert", "eon"].contains(&entry.name) {
            continue;
        }
        for cos in [0.05, 0.3, 0.8] {
            let wo = direction(cos, 0.0);
            let (closed, integral) = (model.albedo(wo).unwrap()[0], furnace(model.as_ref(), wo));
            assert!((closed - integral).abs() < 1e-9, "{} μ {cos}: {closed} {integral}", entry.name);
        }
    }
}

#[test]
fn the_textbooks_oren_nayar_gains_energy_at_grazing() {
    // σ = 0.3 rad, ρ = 1.
    let roughness = 0.3 / std::f64::consts::FRAC_PI_2;
    let entry = zoo::<f64>().into_iter().find(|entry| entry.name == "oren-nayar").unwrap();
    let model = entry.make(&Setting { roughness, ..Setting::default() });
    let found = [1.0, 0.5, 0.1, 0.01].map(|cos| furnace(model.as_ref(), direction(cos, 0.0)));
    for (found, expected) in found.into_iter().zip([0.893, 0.960, 0.998, 1.005]) {
        assert!((found - expected).abs() < 1e-3, "{found} {expected}");
    }
}

/// The sum of what comes out after 0, 1 … further bounces, where `out` [1] of what bounces leaves and the rest meets a body of
/// an `albedo` [1] again.
fn series(albedo: f64, out: f64) -> f64 {
    let mut left = 1.0;
    let bounce = |_| {
        let here = left * albedo;
        left = here * (1.0 - out);
        here * out
    };
    (0..2000).map(bounce).sum()
}

#[test]
fn colour_deepens_with_every_bounce() {
    for albedo in [0.9, 0.5, 0.1] {
        // Between rough facets: of E(μ) nothing is lost; what is left met one facet and meets others, of which the mean of E
        // by Gauss's rule leaves each time.
        for roughness in [0.2, 1.0] {
            let [eon, dark] = [[albedo; 3], [0.0; 3]].map(|albedo| Eon { albedo, roughness });
            assert_eq!(dark.albedo(direction(0.5, 0.0)).unwrap(), [0.0; 3]);
            // f/ρ of a body so dark that nothing bounces twice.
            let faint = Eon { albedo: [1e-9; 3], roughness };
            let direct = |cos: f64| faint.albedo(direction(cos, 0.0)).unwrap()[0] / 1e-9;
            let node = |&(u, du): &(f64, f64)| 2.0 * u * du * direct(u);
            let mean: f64 = gauss_legendre(64).iter().map(node).sum();
            for cos in [0.05, 0.5, 1.0] {
                let (found, first) = (eon.albedo(direction(cos, 0.0)).unwrap()[0], direct(cos));
                let expected = albedo * (first + (1.0 - first) * series(albedo, mean));
                // Two bounces of the faint one, and the rule at the root of grazing.
                assert!((found - expected).abs() < 1e-6, "ρ {albedo} r {roughness} μ {cos}: {found} {expected}");
            }
        }
        // Under a coat: what it lets in is scattered, and of even light from below 1 − (1 − R̄)/n² is sent back.
        let index = 1.5;
        let entry = zoo::<f64>().into_iter().find(|entry| entry.name == "plastic").unwrap();
        let model = entry.make(&Setting { albedo: [albedo; 3], index, ..Setting::default() });
        for cos in [0.1, 0.5, 1.0] {
            let reflectance = powers(Incidence::from_cos(cos), 1.0, index.into()).r_n();
            let out = (1.0 - diffuse_reflectance(index)) / (index * index);
            let expected = (1.0 - reflectance) * series(albedo, out);
            let wo = direction(cos, 0.0);
            let (found, body) = (model.albedo(wo).unwrap()[0], furnace(model.as_ref(), wo));
            // The rules' own 1e−8.
            assert!((found - reflectance - expected).abs() < 1e-7, "ρ {albedo} μ {cos}: {found} {expected}");
            assert!((body - expected).abs() < 1e-7, "ρ {albedo} μ {cos}: {body} {expected}");
        }
    }
}
