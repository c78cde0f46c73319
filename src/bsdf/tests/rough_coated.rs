//! Films on rough metal: each facet reflects as the film does at the angle at which it is seen.

use super::audit::{hemisphere, walks_agree};
use super::coated::{expected, films, model};
use super::direction;
use crate::bsdf::albedo::{Rule, albedo};
use crate::bsdf::audit::{drawn, reciprocity};
use crate::bsdf::coated::{CoatedMetal, Film};
use crate::bsdf::fresnel::Reflecting;
use crate::bsdf::microfacet::{Beckmann, Distribution, Ggx, Slopes};
use crate::bsdf::rules::golden;
use crate::bsdf::{Bsdf, Setting};
use num_complex::Complex64;
use yardstick::quadrature::gauss_legendre;

const MODELS: [&str; 3] = ["rough-conductor", "conductor-compensated", "conductor-walk"];

/// Gold by channel.
fn metal() -> [Complex64; 3] {
    [(0.14, 4.1), (0.43, 2.46), (1.38, 1.92)].map(|(n, k)| Complex64::new(n, k))
}

fn rough(name: &str, film: Option<Film>, alpha: [f64; 2]) -> Box<dyn Bsdf<f64>> {
    model(name, film, Setting { metal: metal(), alpha, ..Setting::default() })
}

/// What [`super::coated`] lets tables of reflectance be off [1].
const TABLE: f64 = 1e-4;

#[test]
fn rough_metal_under_a_film_returns_what_its_facets_do() {
    // D G R over the slopes, R by the textbook's recursion: no table, and f is not asked.
    let rule = gauss_legendre(48);
    let mut least_slip = f64::INFINITY;
    for (channel, film) in films().into_iter().enumerate() {
        let facet = |cos: f64| expected(&film, channel, [Complex64::ONE, metal()[channel]], cos)[0];
        for slopes in Slopes::ALL {
            for (alpha, cos) in [(0.8, 0.9), (1.0, 0.4)] {
                let setting = Setting { alpha: [alpha; 2], metal: metal(), slopes, ..Setting::default() };
                let model = model::<f64>("rough-conductor", Some(film), setting);
                let truth = match slopes {
                    Slopes::Ggx => Rule::new(&Ggx::new([alpha; 2]), 16, 32).albedo(cos, facet),
                    Slopes::Beckmann => Rule::new(&Beckmann::new([alpha; 2]), 16, 32).albedo(cos, facet),
                };
                let wo = direction(cos, 0.0);
                let values = hemisphere(&rule, |wi| model.eval(wi, wo)[channel]);
                assert!((values - truth).abs() < TABLE, "{film:?} {slopes:?} {alpha} {cos}: {values} {truth}");
                let count = 20_000;
                let draw = |k: usize| {
                    let [u, v] = golden(k, count);
                    model.sample(wo, [u, v, 0.5]).weight[channel]
                };
                let draws = (0..count).map(draw).sum::<f64>() / count as f64;
                // The lattice's own error: a few per its points.
                assert!((draws - truth).abs() < 2.0 * TABLE, "{film:?} {slopes:?} {alpha} {cos}: {draws} {truth}");
                // Seen at the angle to the surface instead of that to the facet, as if it were polished.
                least_slip = least_slip.min((albedo(slopes, alpha, cos) * facet(cos) - truth).abs());
            }
        }
    }
    // In every case it would be found.
    assert!(least_slip > TABLE, "the mistake would pass: {least_slip}");
}

#[test]
fn a_film_of_no_thickness_leaves_bare_metal() {
    for name in MODELS {
        for alpha in [[0.05; 2], [0.6; 2], [1.0, 0.3]] {
            let none = rough(name, Some(Film { thickness: 0.0, ..films()[1] }), alpha);
            let bare = rough(name, None, alpha);
            for (k, cos) in [1.0, 0.7, 0.3, 0.05].into_iter().enumerate() {
                let wo = direction(cos, 0.4);
                for u in (0..20).map(|k| golden(k, 20)) {
                    let [there, here] = [&none, &bare].map(|model| model.sample(wo, [u[0], u[1], 0.2 * k as f64]));
                    assert_eq!(there.wi.z, here.wi.z, "{name} {alpha:?} {cos}: the way does not depend on colour");
                    assert_eq!(there.pdf, here.pdf);
                    for c in 0..3 {
                        let (there, here) = (there.weight[c], here.weight[c]);
                        // A dozen bounces at most, each as far off as the table.
                        assert!((there - here).abs() < 12.0 * TABLE, "{name} {alpha:?} {cos}: {there} {here}");
                    }
                    let [there, bare] = [&none, &bare].map(|model| model.eval(here.wi, wo));
                    for c in 0..3 {
                        assert!((there[c] - bare[c]).abs() <= 12.0 * TABLE * bare[c], "{name} {there:?} {bare:?}");
                    }
                }
            }
        }
    }
}

#[test]
fn smooth_facets_are_polished_metal_under_the_film() {
    let alpha = 1e-4;
    for film in films() {
        let polished = rough("conductor", Some(film), [alpha; 2]);
        for name in MODELS {
            let rough = rough(name, Some(film), [alpha; 2]);
            for cos in [1.0, 0.6, 0.2] {
                let wo = direction(cos, 0.4);
                let [there, here] = [&rough, &polished].map(|model| model.sample(wo, [0.5, 0.3, 0.2]).weight);
                for c in 0..3 {
                    // A facet leans by α, and no film's reflectance grows by more than ten per radian.
                    assert!((there[c] - here[c]).abs() < 10.0 * alpha, "{film:?} {name} {cos}: {there:?} {here:?}");
                }
            }
        }
    }
}

#[test]
fn films_on_rough_metal_keep_what_surfaces_have_to() {
    let white = [Complex64::I; 3];
    for (film, absorbs) in films().into_iter().zip([false, false, true]) {
        for (name, metal) in MODELS.into_iter().flat_map(|name| [metal(), white].map(|metal| (name, metal))) {
            for (alpha, cos) in [([0.1; 2], 0.9), ([0.6; 2], 0.1), ([1.0, 0.3], 0.5)] {
                let model = model::<f64>(name, Some(film), Setting { alpha, metal, ..Setting::default() });
                let (place, wo) = (format!("{film:?} {name} {metal:?} {alpha:?} {cos}"), direction(cos, 0.4));
                let found = drawn(model.as_ref(), wo, 5_000, &place);
                assert!(found.largest <= model.character().largest_weight * (1.0 + 1e-10), "{place}: {found:?}");
                // As for bare metal: five standard errors, and what the tables of losses leave.
                let table = if alpha[0] == alpha[1] { 1e-3 } else { 1e-2 };
                let (mean, error) = (found.energy.mean(), 5.0 * found.energy.standard_error() + table);
                assert!(mean <= 1.0 + error, "{place}: {found:?}");
                // Clear films on a metal that absorbs nothing take nothing.
                if metal == white && !absorbs && name != "rough-conductor" {
                    assert!((mean - 1.0).abs() <= error, "{place}: {found:?}");
                }
                if metal == white && absorbs {
                    assert!(mean < 1.0 - error, "{place}: a veil of gold absorbs: {found:?}");
                }
                if !model.character().is_stochastic {
                    let (off, wi) = reciprocity(model.as_ref(), wo, 300, &place);
                    assert!(off <= 1e-6, "{place}: {off} at {wi:?}");
                }
            }
        }
    }
}

#[test]
fn walks_over_coated_facets_value_what_they_sample() {
    for film in films() {
        walks_agree(Ggx::new([1.0; 2]), CoatedMetal::new(&film, metal()), 0.9, false);
        walks_agree(Beckmann::new([0.7; 2]), CoatedMetal::new(&film, [Complex64::I; 3]), 0.4, film != films()[2]);
    }
}

#[test]
fn the_second_lobe_has_the_films_mean_colour() {
    let rule = gauss_legendre(48);
    for (channel, film) in films().into_iter().enumerate() {
        let facet = |cos: f64| expected(&film, channel, [Complex64::ONE, metal()[channel]], cos)[0];
        let mean: f64 = rule.iter().map(|&(u, du)| 2.0 * u * du * facet(u)).sum();
        let found = Reflecting::<f64>::mean_reflectance(&CoatedMetal::new(&film, metal()))[channel];
        assert!((found - mean).abs() < TABLE, "{film:?}: {found} {mean}");
        // What leaves after two bounces and more, by the series of those who leave with the odds ⟨E⟩.
        let alpha = 1.0;
        let leaves: f64 = rule.iter().map(|&(u, du)| 2.0 * u * du * albedo(Slopes::Ggx, alpha, u)).sum();
        let again: f64 = (0..200).map(|k| mean.powi(k + 2) * (1.0 - leaves).powi(k) * leaves).sum();
        let model = rough("conductor-compensated", Some(film), [alpha; 2]);
        let cos = 0.4;
        let once = Rule::new(&Ggx::new([alpha; 2]), 16, 32).albedo(cos, facet);
        let expected = once + again * (1.0 - albedo(Slopes::Ggx, alpha, cos));
        let found = hemisphere(&rule, |wi| model.eval(wi, direction(cos, 0.0))[channel]);
        // What tables of losses leave, 5e−4.
        assert!((found - expected).abs() < 5e-4 + TABLE, "{film:?}: {found} {expected}");
    }
}
