//! What its speed costs.

use super::GLASS_INDEX;
use super::checks::GLASS_ERROR;
use crate::parameter::DEFAULT_WAVELENGTH;
use crate::vocabulary::{Expects, Heat, Measured, Race, lane, race};
use light::Complex64;
use light::media;
use light::optics::fresnel::{natural_reflectance, natural_reflectance_absorbing, powers};
use light::optics::schlick::{Dipped, normal_reflectance, schlick, schlick_rarer_side};
use light::optics::{Direction, Incidence};
use light::references::fresnel::{Exact, Input, NAMES};
use std::hint::black_box;
use yardstick::precise;

/// The metal of the races, chosen for its deep dip.
fn metal() -> Complex64 {
    media::named("chromium").and_then(|metal| metal.index(DEFAULT_WAVELENGTH).ok()).expect("a listed metal")
}

/// How far the form with two reflectances is from R_n of the metal. Nobody owes it: it is what is seen, largest near 87°.
const DIPPED_ERROR: f64 = 0.05;

const EVALUATIONS: &[u64] = &[1 << 10, 1 << 12, 1 << 14];

const EXACT: Expects = Expects::Within { limit: 1e-15, why: "a few roundings of a number below 1" };

/// R_n of many cosines in one call.
type Batch = fn(&[f64], &mut [f64]);

pub(super) const SPEED: Race =
    race("speed", "Schlick's error buys a few nanoseconds; with the rarer side's cosine it buys none")
        .work("evaluations of R_n")
        .error("largest |ΔR|", "largest |ΔR|; R_n in 256 bits at 64 of the cosines")
        .lanes(&[
            lane("exact", "exact, into glass", EVALUATIONS, |_, work| {
                heat(work, GLASS_INDEX.into(), |cos_i, out| natural_reflectance(cos_i, 1.0, GLASS_INDEX, out))
            })
            .expects(EXACT),
            lane("schlick", "Schlick, into glass", EVALUATIONS, |_, work| {
                heat(work, GLASS_INDEX.into(), |cos_i, out| {
                    let r_0 = normal_reflectance(1.0, GLASS_INDEX.into());
                    each(cos_i, out, |cos_i| schlick(cos_i, r_0));
                })
            })
            .within(GLASS_ERROR, "23 % of R_n (check glass_in_air), which is 1 at most"),
            lane("exact_inside", "exact, from inside", EVALUATIONS, |_, work| {
                heat_inside(work, |cos_i, out| natural_reflectance(cos_i, GLASS_INDEX, 1.0, out))
            })
            .within(
                1e-12,
                "beside the critical angle the last bit of cos θ₁ moves R by its root; elsewhere a few roundings",
            ),
            lane("rarer_side", "Schlick, rarer side", EVALUATIONS, |_, work| {
                heat_inside(work, |cos_i, out| each(cos_i, out, |cos_i| schlick_rarer_side(cos_i, GLASS_INDEX, 1.0)))
            })
            .within(GLASS_ERROR, "as from outside (check from_inside)"),
            lane("schlick_inside", "Schlick with cos θ_1", EVALUATIONS, |_, work| {
                heat_inside(work, |cos_i, out| {
                    let r_0 = normal_reflectance(GLASS_INDEX, 1.0.into());
                    each(cos_i, out, |cos_i| schlick(cos_i, r_0));
                })
            })
            .breaks(0.5, "cos θ₁ never comes near 0 before everything is reflected"),
            lane("exact_metal", "exact, chromium", EVALUATIONS, |_, work| {
                heat(work, metal(), |cos_i, out| natural_reflectance_absorbing(cos_i, 1.0, metal(), out))
            })
            .expects(EXACT),
            lane("schlick_metal", "Schlick, chromium", EVALUATIONS, |_, work| {
                heat(work, metal(), |cos_i, out| {
                    let r_0 = normal_reflectance(1.0, metal());
                    each(cos_i, out, |cos_i| schlick(cos_i, r_0));
                })
            })
            .breaks(DIPPED_ERROR, "R dips before it rises: no fifth power does"),
            lane("dipped_metal", "Schlick with a dip at 82°, chromium", EVALUATIONS, |_, work| {
                heat(work, metal(), |cos_i, out| {
                    let r_82 = powers(Incidence::from_cos(Dipped::COS), 1.0, metal()).r_n();
                    let dipped = Dipped::new(normal_reflectance(1.0, metal()), r_82);
                    each(cos_i, out, |cos_i| dipped.reflectance(cos_i));
                })
            })
            .within(DIPPED_ERROR, "an observation: what one lobe through one point leaves beside it"),
        ]);

fn each(cosines: &[f64], out: &mut [f64], value: impl Fn(f64) -> f64) {
    for (out, &cos) in out.iter_mut().zip(cosines) {
        *out = value(cos);
    }
}

fn heat(work: u64, n_t: Complex64, batch: Batch) -> Heat {
    prepared(work, 1.0, n_t, batch)
}

fn heat_inside(work: u64, batch: Batch) -> Heat {
    prepared(work, GLASS_INDEX, 1.0.into(), batch)
}

/// How many results of a run are held against 256 bits.
const SAMPLE: usize = 64;

/// `work` evaluations at the midpoints of equal steps in cos θ; some of them are handed on.
fn prepared(work: u64, n_i: f64, n_t: Complex64, batch: Batch) -> Heat {
    let cosines = midpoints(work as usize);
    let places = (0..cosines.len()).step_by(cosines.len() / SAMPLE);
    let sample: Vec<f64> = places.clone().map(|place| cosines[place]).collect();
    let mut values = vec![0.0; cosines.len()];
    Heat {
        run: Box::new(move || {
            batch(&cosines, &mut values);
            places.clone().map(|place| values[place]).collect()
        }),
        error: Box::new(move |found| {
            let at = NAMES.iter().position(|name| *name == "R_n").expect("an output");
            let errors = found.iter().zip(&sample).map(|(found, &cos_i)| {
                let exact = Exact::new(&Input { direction: Direction::Cos(cos_i), n_i, n_t });
                (precise::to_f64(&(precise::real(*found) - &exact.outputs[at])), String::new())
            });
            Measured::worst(errors).value
        }),
    }
}

fn midpoints(count: usize) -> Vec<f64> {
    (0..count).map(|place| (place as f64 + 0.5) / count as f64).collect()
}

const ENTRIES: &[u64] = &[16, 32, 64, 128, 256, 512, 1024];
/// Look-ups that a table is judged by.
const JUDGED: usize = 1 << 13;

pub(super) const TABLE: Race = race(
    "table",
    "filling a table buys digits as the square of its size, but only as the root where R has a vertical tangent",
)
.work("entries of the table, filled once")
.error("largest |ΔR|", "largest |ΔR|; the exact R_n in f64, whose error is a trillionth of a table's")
.lanes(&[
    lane("glass", "table in cos θ_1, into glass", ENTRIES, |_, work| tabulated(work, 1.0, GLASS_INDEX.into()))
        .order(2.0, 0.2),
    lane("metal", "table in cos θ_1, chromium", ENTRIES, |_, work| tabulated(work, 1.0, metal())).order(2.0, 0.2),
    lane("inside", "table in cos θ_1, out of glass", ENTRIES, |_, work| tabulated(work, GLASS_INDEX, 1.0.into()))
        .order(0.5, 0.2),
    lane("schlick", "Schlick, into glass (no table)", &[1], |_, _| Heat {
        run: Box::new(|| vec![normal_reflectance(1.0, black_box(GLASS_INDEX).into())]),
        error: Box::new(|r_0| largest_error(1.0, GLASS_INDEX.into(), |cos_i| schlick(cos_i, r_0[0]))),
    })
    .within(GLASS_ERROR, "23 % of R_n (check glass_in_air), which is 1 at most"),
]);

/// Filling a table of `entries` steps in cos θ₁ with the exact R_n; the error is that of looking up between them.
fn tabulated(entries: u64, n_i: f64, n_t: Complex64) -> Heat {
    let steps = entries as f64;
    let cosines: Vec<f64> = (0..=entries).map(|place| place as f64 / steps).collect();
    let mut table = vec![0.0; cosines.len()];
    Heat {
        run: Box::new(move || {
            match n_t.im == 0.0 {
                true => natural_reflectance(&cosines, n_i, n_t.re, &mut table),
                false => natural_reflectance_absorbing(&cosines, n_i, n_t, &mut table),
            }
            table.clone()
        }),
        error: Box::new(move |table| {
            largest_error(n_i, n_t, |cos_i| {
                let place = cos_i * steps;
                let left = (place as usize).min(table.len() - 2);
                let weight = place - left as f64;
                table[left] + weight * (table[left + 1] - table[left])
            })
        }),
    }
}

/// Largest |ΔR| of `approximate` against the exact R_n over the cosines.
fn largest_error(n_i: f64, n_t: Complex64, approximate: impl Fn(f64) -> f64) -> f64 {
    let error = |cos_i: f64| approximate(cos_i) - powers(Incidence::from_cos(cos_i), n_i, n_t).r_n();
    Measured::worst(midpoints(JUDGED).into_iter().map(|cos_i| (error(cos_i), String::new()))).value
}
