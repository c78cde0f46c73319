//! Films on what is polished, and any film on anything.

use super::direction;
use crate::Polarisation;
use crate::bsdf::coated::{Film, band};
use crate::bsdf::{Bsdf, Setting, zoo};
use crate::media::{CHANNELS, named};
use crate::number::{F32x8, Number, Vector};
use crate::optics::Incidence;
use crate::optics::film::textbook::recursion;
use crate::optics::film::{Layer, Stack};
use crate::optics::fresnel::powers;
use num_complex::Complex64;

const SIDES: [Polarisation; 2] = [Polarisation::S, Polarisation::P];

pub(super) fn model<N: Number>(name: &str, film: Option<Film>, setting: Setting) -> Box<dyn Bsdf<N>> {
    let entry = zoo::<N>().into_iter().find(|entry| entry.name == name).expect("a model");
    entry.make(&Setting { film, ..setting })
}

fn glass(film: Film) -> Box<dyn Bsdf<f64>> {
    model("dielectric", Some(film), Setting::default())
}

fn of(index: [(f64, f64); 3], thickness: f64) -> Film {
    Film { index: index.map(|(n, k)| Complex64::new(n, k)), thickness }
}

/// A quarter of a green wave of magnesium fluoride, a few waves of something dense, and a veil of gold.
pub(super) fn films() -> [Film; 3] {
    let mgf2 = named("mgf2").expect("a medium").colour().expect("known for light");
    let quarter = CHANNELS[1] / (4.0 * mgf2[1].re);
    [
        Film { index: mgf2, thickness: quarter },
        of([(2.0, 0.0), (2.05, 0.0), (2.1, 0.0)], 900e-9),
        of([(0.19, 3.4), (0.55, 2.3), (1.3, 1.8)], 15e-9),
    ]
}

/// R and T of natural light over a band by the textbook's recursion, at wavelengths of another rule than the model's.
pub(super) fn expected(film: &Film, channel: usize, [n_i, n_t]: [Complex64; 2], cos: f64) -> [f64; 2] {
    let layers = [Layer { index: film.index[channel], thickness: film.thickness }];
    let stack = Stack { n_i: n_i.re, layers: &layers, substrate: n_t };
    let [short, long] = band(channel);
    let count = 601;
    let mut sums = [0.0; 2];
    // Simpson's rule.
    for k in 0..count {
        let wavelength = short + (long - short) * k as f64 / (count - 1) as f64;
        let weight = if k == 0 || k == count - 1 { 1.0 } else { [2.0, 4.0][k % 2] } / (3.0 * (count - 1) as f64);
        for side in SIDES {
            let powers = recursion(&stack, wavelength, Incidence::from_cos(cos), side);
            sums = [sums[0] + 0.5 * weight * powers.reflectance, sums[1] + 0.5 * weight * powers.transmittance];
        }
    }
    sums
}

#[test]
fn bands_adjoin_and_hold_what_is_nearest_to_their_channels() {
    let [red, green, blue] = [0, 1, 2].map(band);
    assert!(blue[1] == green[0] && green[1] == red[0]);
    for (channel, [short, long]) in [red, green, blue].into_iter().enumerate() {
        let own = |wavelength: f64| (wavelength - CHANNELS[channel]).abs();
        let nearest = |wavelength: f64| CHANNELS.iter().all(|other| own(wavelength) <= (wavelength - other).abs());
        assert!(nearest(short + 1e-12) && nearest(long - 1e-12), "{channel}: {short} to {long}");
    }
    // The outer ones are as wide on either side.
    assert!(
        (red[0] + red[1] - 2.0 * CHANNELS[0]).abs() < 1e-15 && (blue[0] + blue[1] - 2.0 * CHANNELS[2]).abs() < 1e-15
    );
}

#[test]
fn films_reflect_and_let_through_what_the_stack_does() {
    let (air, index) = (Complex64::ONE, Complex64::new(1.5, 0.0));
    for film in films() {
        let model = glass(film);
        for cos in [0.999, 0.83, 0.57, 0.31, 0.11, 0.03, -0.03, -0.31, -0.72, -0.744, -0.747, -0.8, -0.97] {
            let wo = direction(f64::abs(cos), 0.7).flipped(cos < 0.0);
            let media = if cos < 0.0 { [index, air] } else { [air, index] };
            // One number below all odds of coming through, one above.
            let [back, through] = [0.0, 1.0 - 1e-9].map(|u| model.sample(wo, [0.5, 0.5, u]));
            let total: f64 = (0..3).map(|c| expected(&film, c, media, wo.z.abs())[1]).sum::<f64>() / 3.0;
            for c in 0..3 {
                let [r, t] = expected(&film, c, media, wo.z.abs());
                // Wavelengths of a band to (π/24)²/24 of what its ends differ by, and nodes.
                let close = |found: f64, expected: f64| (found - expected).abs() < 1e-4;
                let albedo = model.albedo(wo).expect("closed")[c];
                assert!(close(albedo, r + t), "{film:?} at {cos}, {c}: R + T {albedo} {}", r + t);
                let found = back.weight[c] * (1.0 - total);
                assert!(close(found, r), "{film:?} at {cos}, {c}: R {found} {r}");
                if total > 1e-6 {
                    assert!(through.is_transmitted);
                    let [from, to] = media.map(|index| index.re);
                    assert!((through.compression - (from / to).powi(2)).abs() < 1e-14, "radiance goes as n²");
                    let found = through.weight[c] / through.compression * total;
                    assert!(close(found, t), "{film:?} at {cos}, {c}: T {found} {t}");
                } else {
                    assert!(!through.is_transmitted, "{film:?} at {cos}");
                }
            }
        }
    }
}

#[test]
fn metal_under_a_film_reflects_what_the_stack_does() {
    let metal = [(0.14, 4.1), (0.43, 2.46), (1.38, 1.92)].map(|(n, k)| Complex64::new(n, k));
    for film in films() {
        let model = model::<f64>("conductor", Some(film), Setting { metal, ..Setting::default() });
        for cos in [0.999, 0.57, 0.11, 0.03] {
            let drawn = model.sample(direction(cos, 0.7), [0.5; 3]);
            for (c, index) in metal.into_iter().enumerate() {
                let [r, _] = expected(&film, c, [Complex64::ONE, index], cos);
                // Grazing, both faces are mirrors, and between them resonances are sharper than a band's wavelengths are close.
                let limit = if cos < 0.1 { 1e-3 } else { 1e-4 };
                assert!((drawn.weight[c] - r).abs() < limit, "{film:?} at {cos}, {c}: {} {r}", drawn.weight[c]);
            }
        }
    }
}

#[test]
fn a_quarter_wave_takes_most_of_the_glare_away() {
    let [coat, ..] = films();
    let up = direction(1.0, 0.0);
    let bare = powers(Incidence::NORMAL, 1.0, Complex64::new(1.5, 0.0)).r_n();
    let model = glass(coat);
    // The odds of glare: where a number begins to mean passage.
    let glare = (0..10_000).map(|k| f64::from(k) / 10_000.0);
    let glare = glare.take_while(|u| !model.sample(up, [0.5, 0.5, *u]).is_transmitted).count() as f64 / 10_000.0;
    // ((n² − n_t)/(n² + n_t))² in the middle of the green, and a little more about it: a third of what bare glass has.
    let n2 = coat.index[1].re.powi(2);
    let best = ((n2 - 1.5) / (n2 + 1.5)).powi(2);
    assert!(glare > best && glare < best + 4e-3 && glare < 0.45 * bare, "{glare} {best} {bare}");
    assert!(model.albedo(up).expect("closed").iter().all(|albedo| (albedo - 1.0).abs() < 1e-12));
}

#[test]
fn a_film_of_no_thickness_is_none_and_a_thick_one_has_no_colour() {
    for cos in [0.95, 0.4, -0.9, -0.5] {
        let wo = direction(f64::abs(cos), 0.3).flipped(cos < 0.0);
        let none = glass(Film { thickness: 0.0, ..films()[1] });
        let [n_i, n_t] = if cos < 0.0 { [1.5, 1.0] } else { [1.0, 1.5] };
        let bare = powers(Incidence::from_cos(wo.z.abs()), n_i, n_t.into()).r_n();
        let odds = |model: &dyn Bsdf<f64>, u: f64| model.sample(wo, [0.5, 0.5, u]).is_transmitted;
        assert!(!odds(none.as_ref(), 1.0 - (1.0 - bare) - 1e-4) && (bare > 0.999 || odds(none.as_ref(), bare + 1e-4)));
        if bare > 0.999 {
            continue;
        }
        // Powers of the two faces added without a phase: R = (a + b − 2ab)/(1 − ab), the mean over all phases.
        let index = 2.0;
        let thick = glass(of([(index, 0.0); 3], 1e-4));
        let sin2 = (n_i * wo.sin2().sqrt() / index).powi(2);
        let inside = Incidence::from_cos((1.0 - sin2).sqrt());
        let of_side = |side: usize| {
            let (first, second) =
                (powers(Incidence::from_cos(wo.z.abs()), n_i, index.into()), powers(inside, index, n_t.into()));
            let (a, b) = if side == 0 { (first.r_s, second.r_s) } else { (first.r_p, second.r_p) };
            (a + b - 2.0 * a * b) / (1.0 - a * b)
        };
        let mean = 0.5 * (of_side(0) + of_side(1));
        let found = [0, 1, 2].map(|c| {
            let drawn = thick.sample(wo, [0.5, 0.5, 0.0]);
            (drawn.weight[c], mean)
        });
        // Grey: each channel has the weight of all. What is left of a hundred fringes is below a hundredth.
        assert!(found.iter().all(|(weight, _)| (weight - 1.0).abs() < 0.02), "{found:?}");
        let threshold = |u: f64| odds(thick.as_ref(), u);
        assert!(!threshold(mean - 3e-3) && threshold(mean + 3e-3), "{cos}: {mean}");
    }
}

#[test]
fn light_that_runs_back_has_the_same_choice() {
    // T is the same both ways, of gold too; R is not.
    let gold = films()[2];
    let model = glass(gold);
    for cos in [0.95, 0.5, 0.2] {
        let wo = direction(cos, 0.3);
        let there = model.sample(wo, [0.5, 0.5, 1.0 - 1e-9]);
        let back = model.sample(there.wi, [0.5, 0.5, 1.0 - 1e-9]);
        assert!(there.is_transmitted && back.is_transmitted);
        for c in 0..3 {
            let [one, other] = [there, back].map(|drawn| drawn.weight[c] / drawn.compression);
            assert!((one - other).abs() < 1e-4 * one, "{cos} {c}: {one} {other}");
        }
        let Vector { x, y, z } = back.wi;
        assert!((x - wo.x).abs() + (y - wo.y).abs() + (z - wo.z).abs() < 1e-12);
        let [front, rear] = [wo, there.wi].map(|w| model.albedo(w).expect("closed")[1]);
        assert!((front - rear).abs() > 0.01, "{front} {rear}");
    }
}

#[test]
fn any_film_and_any_direction_give_finite_shares_alike_in_all_widths() {
    let hostile = [
        of([(f64::NAN, -1.0), (0.0, f64::INFINITY), (1e9, 0.0)], 1e-7),
        of([(1.5, 0.0); 3], f64::NAN),
        of([(1.0, 0.0); 3], 1.0),
        of([(1.5, 1e3); 3], 1e-6),
    ];
    for film in hostile.into_iter().chain(films()) {
        for name in ["conductor", "dielectric", "rough-conductor", "conductor-compensated", "conductor-walk"] {
            let index = if film.thickness == 1e-6 { 1.0 / 1.5 } else { 1.5 };
            // Metals that are none: without index, and with the air's.
            let metal = [0.0, 1.0, 0.5].map(|n| Complex64::new(n, 0.0));
            let setting = Setting { index, metal, ..Setting::default() };
            let (one, eight) = (model::<f32>(name, Some(film), setting), model::<F32x8>(name, Some(film), setting));
            for cos in [1.0_f32, 0.7454, 0.5, 1e-3, 1e-6, -1e-6, -0.2, -0.7453, -0.7454, -1.0] {
                let wo = Vector::new((1.0 - cos * cos).max(0.0).sqrt(), 0.0, cos);
                for u in [0.0, 0.04, 0.5, 0.999] {
                    let drawn = one.sample(wo, [0.5, 0.5, u]);
                    let finite = drawn.weight.iter().all(|w| (0.0..=3.001).contains(&(w / drawn.compression)));
                    assert!(finite, "{name} {film:?} {cos} {u}: {drawn:?}");
                    let all = |x: f32| F32x8::of(f64::from(x));
                    let lanes =
                        eight.sample(Vector::new(all(wo.x), all(wo.y), all(wo.z)), [all(0.5), all(0.5), all(u)]);
                    for c in 0..3 {
                        assert_eq!(lanes.weight[c].lane(3), f64::from(drawn.weight[c]), "{name} {film:?} {cos} {u}");
                    }
                }
            }
        }
    }
}
