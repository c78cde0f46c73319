//! What a stack costs, in this form and in the textbooks'.

use super::checks::quarter_wave_mirror;
use super::{Films, film, quarter_film};
use crate::parameter::DEFAULT_WAVELENGTH;
use crate::vocabulary::{Expects, Heat, Lane, Measured, Race, lane, race};
use light::Polarisation;
use light::optics::film::textbook::{characteristic_matrix, recursion, transfer_matrix};
use light::optics::film::{Powers, Stack};
use light::optics::{Direction, Incidence};
use light::references::film::{Reference, reference};
use yardstick::precise::{self, Real};

pub(super) const ORDINARY: Race = race("", "")
    .work("evaluations of one stack at one wavelength")
    .error(
        "largest relative error of T",
        "largest relative error of T; Parratt's recursion in 256 bits at some of the \
         wavelengths",
    )
    .lanes(&[]);

pub(super) const ONE_FILM: [Lane; 4] = lanes::<1>();
pub(super) const FIVE_FILMS: [Lane; 4] = lanes::<5>();
pub(super) const TWENTY_ONE_FILMS: [Lane; 4] = lanes::<21>();

const EVALUATIONS: &[u64] = &[256, 1024, 4096];

/// Textbook and program on a mirror of `COUNT` quarter waves over the visible, where no form breaks.
pub(super) const fn lanes<const COUNT: usize>() -> [Lane; 4] {
    const ROUNDING: Expects = Expects::Within {
        limit: 1e-11,
        why: "roundings, magnified by T's condition at the edges of the mirror's band",
    };
    [
        lane("characteristic_matrix", "characteristic matrix", EVALUATIONS, |_, work| {
            singly(work, visible_mirror(COUNT), |s, w, i, p| characteristic_matrix(s, w, i, p).transmittance)
        })
        .expects(ROUNDING),
        lane("transfer_matrix", "transfer matrix", EVALUATIONS, |_, work| {
            singly(work, visible_mirror(COUNT), |s, w, i, p| transfer_matrix(s, w, i, p).transmittance)
        })
        .expects(ROUNDING),
        lane("single", "this program, one at a time", EVALUATIONS, |_, work| {
            singly(work, visible_mirror(COUNT), |s, w, i, p| s.response(w, i, p).transmittance)
        })
        .expects(ROUNDING),
        lane("batch", "this program, many wavelengths at once", EVALUATIONS, |_, work| {
            in_batch(work, visible_mirror(COUNT))
        })
        .expects(ROUNDING),
    ]
}

fn visible_mirror(count: usize) -> Films {
    quarter_wave_mirror(count, 2.35, 1.38)
}

/// A protected silver mirror 20 µm thick.
fn thick_mirror() -> Films {
    let protection = quarter_film(1.38, DEFAULT_WAVELENGTH);
    Films { n_i: 1.0, layers: vec![protection, film(0.055, 3.32, 20e-6)], substrate: 1.52.into() }
}

pub(super) const OPAQUE_FILM: Race = ORDINARY
    .named(
        "opaque_film",
        "behind opaque silver the textbook forms lose every digit, however long they \
         compute",
    )
    .error(
        "largest relative error of ln T",
        "largest relative error of ln T; Parratt's recursion in 256 bits at some of the \
         wavelengths",
    )
    .lanes(&[
        lane("characteristic_matrix", "characteristic matrix", EVALUATIONS, |_, work| {
            opaque_heat(work, |s, w, i, p| characteristic_matrix(s, w, i, p).transmittance.ln())
        })
        .breaks(1e-3, "cos δ and sin δ overflow"),
        lane("transfer_matrix", "transfer matrix, Im δ clamped", EVALUATIONS, |_, work| {
            opaque_heat(work, |s, w, i, p| transfer_matrix(s, w, i, p).transmittance.ln())
        })
        .breaks(1e-3, "the clamp holds T near 1e−31"),
        lane("recursion", "recursion of coefficients", EVALUATIONS, |_, work| {
            opaque_heat(work, |s, w, i, p| recursion(s, w, i, p).transmittance.ln())
        })
        .breaks(1e-3, "T itself underflows"),
        lane("single", "this program", EVALUATIONS, |_, work| {
            opaque_heat(work, |s, w, i, p| s.response(w, i, p).ln_transmittance)
        })
        .within(1e-14, "the decay is a sum of exponents, never multiplied out"),
    ]);

fn opaque_heat(work: u64, logarithm: SingleForm) -> Heat {
    let exact = |found: Reference| found.ln_transmittance.expect("something comes through");
    raced(work, thick_mirror(), exact, one_by_one(logarithm))
}

/// θ of the races [rad]: oblique, so that no short cut of normal incidence helps.
const RACE_ANGLE: f64 = 0.5;
/// How many results of a run are held against 256 bits.
const SAMPLE: usize = 8;

/// `count` wavelengths over the visible.
fn wavelengths(count: u64) -> Vec<f64> {
    (0..count).map(|at| 400e-9 + 300e-9 * (at as f64 + 0.5) / count as f64).collect()
}

/// One number of a stack at one wavelength.
type SingleForm = fn(&Stack, f64, Incidence, Polarisation) -> f64;

fn one_by_one(form: SingleForm) -> impl FnMut(&Films, &[f64], &mut [f64]) {
    let incidence = Incidence::from_angle(RACE_ANGLE);
    move |films, wavelengths, found| {
        for (found, &wavelength) in found.iter_mut().zip(wavelengths) {
            *found = form(&films.stack(), wavelength, incidence, Polarisation::S);
        }
    }
}

/// T of `films`, one wavelength after the other.
fn singly(work: u64, films: Films, transmittance: SingleForm) -> Heat {
    raced(work, films, |found| found.transmittance, one_by_one(transmittance))
}

/// T of `films`, all wavelengths in one call.
fn in_batch(work: u64, films: Films) -> Heat {
    let incidence = Incidence::from_angle(RACE_ANGLE);
    let mut powers = vec![Powers { reflectance: 0.0, transmittance: 0.0, absorptance: 0.0 }; work as usize];
    let method = move |films: &Films, wavelengths: &[f64], found: &mut [f64]| {
        films.stack().waves(incidence, Polarisation::S).powers(wavelengths, &mut powers);
        for (found, powers) in found.iter_mut().zip(&powers) {
            *found = powers.transmittance;
        }
    };
    raced(work, films, |found| found.transmittance, method)
}

/// A run of `work` wavelengths; a few of its results are handed on and held against 256 bits.
fn raced(
    work: u64,
    films: Films,
    exact: fn(Reference) -> Real,
    mut method: impl FnMut(&Films, &[f64], &mut [f64]) + 'static,
) -> Heat {
    let wavelengths = wavelengths(work);
    let places = (0..wavelengths.len()).step_by(wavelengths.len() / SAMPLE);
    let sample: Vec<f64> = places.clone().map(|place| wavelengths[place]).collect();
    let judged = films.clone();
    let mut found = vec![0.0; wavelengths.len()];
    Heat {
        run: Box::new(move || {
            method(&films, &wavelengths, &mut found);
            places.clone().map(|place| found[place]).collect()
        }),
        error: Box::new(move |found| {
            let errors = found.iter().zip(&sample).map(|(&found, &wavelength)| {
                let angle = Direction::Angle(RACE_ANGLE);
                let exact = exact(reference(&judged.stack(), wavelength, angle, Polarisation::S));
                (precise::relative_error(found, &exact), String::new())
            });
            Measured::worst(errors).value
        }),
    }
}
