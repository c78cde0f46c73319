//! The forms that keep their digits against those of textbooks.

use super::direction;
use crate::bsdf::microfacet::{Beckmann, Distribution, Ggx, Joint, Slopes, lambda, masking};
use crate::bsdf::rules::tanh_sinh;
use crate::bsdf::{Bsdf, Setting, zoo};
use crate::number::Vector;
use crate::optics::Incidence;
use crate::optics::fresnel::powers;
use num_complex::Complex64;

/// B(1 + a, 1 + b) = ∫tᵃ(1 − t)ᵇ dt.
fn euler(a: f64, b: f64) -> f64 {
    tanh_sinh(400).iter().map(|node| node.weight * node.at.powf(a) * node.left.powf(b)).sum()
}

/// G₂ [1], by Λ on either side.
fn joint<D: Distribution<f64>>(facets: &D, joint: Joint, wi: Vector<f64>, wo: Vector<f64>) -> f64 {
    let up = |w: Vector<f64>| w.flipped(w.z < 0.0);
    let [i, o] = [wi, wo].map(|w| lambda(facets, up(w)));
    match joint {
        Joint::Separable => masking(facets, up(wi)) * masking(facets, up(wo)),
        Joint::Correlated if wi.z * wo.z > 0.0 => 1.0 / (1.0 + i + o),
        Joint::Correlated => euler(i, o),
    }
}

/// f [sr⁻¹] of metal, F D G₂/(4 cos cos), in three channels.
fn metal<D: Distribution<f64>>(of: &Setting, wi: Vector<f64>, wo: Vector<f64>) -> [f64; 3] {
    let facets = D::new(of.alpha);
    let half = (wi + wo).normalised();
    let shape = facets.density(half) * joint(&facets, of.joint, wi, wo) / (4.0 * wi.z * wo.z);
    of.metal.map(|n| powers(Incidence::from_cos(wo.dot(half).min(1.0)), 1.0, n).r_n() * shape)
}

/// f [sr⁻¹] of glass, of radiance: Walter et al., eqs. 20 and 21, with the index of `wo`'s side upstairs.
fn glass<D: Distribution<f64>>(of: &Setting, wi: Vector<f64>, wo: Vector<f64>) -> f64 {
    let facets = D::new(of.alpha);
    let index = |w: Vector<f64>| if w.z < 0.0 { of.index } else { 1.0 };
    let (n_i, n_o) = (index(wi), index(wo));
    let is_through = wi.z * wo.z < 0.0;
    let half = if is_through { wi.scaled(n_i) + wo.scaled(n_o) } else { wi + wo }.normalised();
    let half = half.scaled(half.z.signum());
    let (cos_i, cos_o) = (wi.dot(half), wo.dot(half));
    // A facet is seen from its own side of the surface and of itself.
    if cos_o * wo.z <= 0.0 || cos_i * wi.z <= 0.0 {
        return 0.0;
    }
    let far = if wo.z < 0.0 { 1.0 } else { of.index };
    let reflectance = powers(Incidence::from_cos(cos_o.abs().min(1.0)), n_o, far.into()).r_n();
    let shape = facets.density(half) * joint(&facets, of.joint, wi, wo) / (wi.z * wo.z).abs();
    if is_through {
        let spread = (cos_i * cos_o).abs() * n_o * n_o / (n_i * cos_i + n_o * cos_o).powi(2);
        (1.0 - reflectance) * shape * spread
    } else {
        reflectance * shape / 4.0
    }
}

#[test]
fn values_are_those_of_textbooks() {
    let gold = [(0.14, 4.1), (0.43, 2.46), (1.38, 1.92)].map(|(n, k)| Complex64::new(n, k));
    let make = |name: &str, of: &Setting| -> Box<dyn Bsdf<f64>> {
        zoo().into_iter().find(|entry| entry.name == name).expect("a model").make(of)
    };
    let cosines = [0.97, 0.6, 0.2, -0.3, -0.8];
    for (slopes, kind) in Slopes::ALL.into_iter().flat_map(|slopes| Joint::ALL.map(|kind| (slopes, kind))) {
        for (alpha, index) in [([0.4; 2], 1.5), ([0.9, 0.3], 1.5), ([0.5, 0.8], 1.0 / 1.8)] {
            let of = Setting { alpha, slopes, joint: kind, index, metal: gold, ..Setting::default() };
            let (shiny, clear) = (make("rough-conductor", &of), make("rough-dielectric", &of));
            let pairs = cosines.into_iter().flat_map(|i| cosines.map(|o| (i, o)));
            for ((cos_i, cos_o), phi) in pairs.flat_map(|pair| [0.5, 2.5, 3.2].map(|phi| (pair, phi))) {
                // Opposite azimuths, near which refraction goes.
                let up = |cos: f64, phi: f64| direction(cos.abs(), phi).flipped(cos < 0.0);
                let (wi, wo) = (up(cos_i, phi), up(cos_o, 0.3));
                let place = format!("{slopes:?} {kind:?} α {alpha:?} n {index} wi {wi:?} wo {wo:?}");
                // The textbook's own cancellation, of Λ and of the half vector: some 1e3 roundings.
                let near = |found: f64, expected: f64| (found - expected).abs() <= 1e-11 * expected.abs();
                let expected = match slopes {
                    Slopes::Ggx => glass::<Ggx<f64>>(&of, wi, wo),
                    Slopes::Beckmann => glass::<Beckmann<f64>>(&of, wi, wo),
                };
                let found = clear.eval(wi, wo);
                assert!(found.iter().all(|f| near(*f, expected)), "{place}: {found:?} {expected}");
                if cos_i.min(cos_o) > 0.0 {
                    let expected = match slopes {
                        Slopes::Ggx => metal::<Ggx<f64>>(&of, wi, wo),
                        Slopes::Beckmann => metal::<Beckmann<f64>>(&of, wi, wo),
                    };
                    let found = shiny.eval(wi, wo);
                    assert!((0..3).all(|c| near(found[c], expected[c])), "{place}: {found:?} {expected:?}");
                }
            }
        }
    }
}

#[test]
fn a_stretched_surface_is_an_even_one_seen_stretched() {
    // Slopes along x grow by the stretch: P(p, q) of α_x, α_y is that of α₀ at (p α₀/α_x, q α₀/α_y), times α₀²/(α_x α_y).
    fn holds<D: Distribution<f64>>() {
        let (even, [along, across]) = (0.5, [0.9, 0.2]);
        let (round, stretched) = (D::new([even; 2]), D::new([along, across]));
        for (cos, phi) in [0.95, 0.6, 0.2].into_iter().flat_map(|cos| [0.1, 0.8, 2.0].map(|phi| (cos, phi))) {
            let w = direction(cos, phi);
            let slopes = Vector::new(w.x * even / along, w.y * even / across, w.z);
            let facet = slopes.normalised();
            let slope_share = |d: f64, z: f64| d * z.powi(4);
            let expected = slope_share(round.density(facet), facet.z) * even * even / (along * across) / w.z.powi(4);
            let found = stretched.density(w);
            assert!((found / expected - 1.0).abs() < 1e-13, "D of {w:?}: {found} {expected}");
            // What is hidden of a view depends on the stretched slope of the view alone.
            let view = Vector::new(w.x * along / even, w.y * across / even, w.z).normalised();
            let (found, expected) = (lambda(&stretched, w), lambda(&round, view));
            assert!((found / expected - 1.0).abs() < 1e-13, "Λ of {w:?}: {found} {expected}");
        }
        // Held within what the forms bear, each by itself.
        assert_eq!(D::new([0.0, 0.3]).alpha(), [1e-4, 0.3]);
        assert_eq!(D::new([f64::NAN, 2.0]).alpha(), [1e-4, 1.0]);
    }
    holds::<Ggx<f64>>();
    holds::<Beckmann<f64>>();
}

#[test]
fn glass_is_held_off_the_index_around_it() {
    for (index, held) in [(1.0, 1.001), (1.0004, 1.001), (0.9996, 0.999), (1.0 - 1e-12, 0.999)] {
        for name in ["rough-dielectric", "dielectric-walk", "dielectric-compensated"] {
            let make = |index: f64| {
                let entry = zoo::<f64>().into_iter().find(|entry| entry.name == name).expect("a model");
                entry.make(&Setting { index, ..Setting::default() })
            };
            let (near, held) = (make(index), make(held));
            for (wi, wo) in [(0.5, 0.8), (-0.5, 0.8), (0.5, -0.8)] {
                let up = |cos: f64| direction(cos.abs(), 0.7).flipped(cos < 0.0);
                let [found, expected] = [&near, &held].map(|model| {
                    (model.eval_pdf(up(wi), up(wo)), format!("{:?}", model.sample(up(wo), [0.2, 0.6, 0.999])))
                });
                assert_eq!(found, expected, "{name} of index {index}, {wi} → {wo}");
            }
        }
    }
}
