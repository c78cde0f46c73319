//! What could refute the film formulas: bounces, admittances, reversal, energy, Parratt.

use super::{BOTH, Films, film, quarter_film};
use crate::parameter::DEFAULT_WAVELENGTH;
use crate::vocabulary::{ALLOWED_ULPS, Bench, Check, Measured, check};
use light::Complex64;
use light::Polarisation;
use light::optics::film::{Layer, Powers};
use light::optics::fresnel::amplitudes_between;
use light::optics::{Direction, Incidence};
use light::references::film::{condition, reference};
use std::f64::consts::TAU;
use yardstick::precise::{self, Real};
use yardstick::random::uniform;

pub(super) const BOUNCES: Check<fn(Complex64, Complex64) -> Complex64> =
    check("every_bounce", "the field that a film reflects is the sum of all bounces in it")
        .against("bounce after bounce in f64, with Fresnel's coefficients at each face, until they vanish")
        .within(128.0, "ulp", "a dozen roundings in each of up to a hundred bounces")
        .of(against_bounces, |t_12, t_21| t_12 * t_21)
        .slip("the light leaves the film with t₁₂, not t₂₁", |t_12, _| t_12 * t_12);

fn against_bounces(bench: &mut Bench, passage: fn(Complex64, Complex64) -> Complex64) -> Measured {
    let films = [(1.38, 0.0, 1.52, 0.0), (2.35, 0.0, 1.52, 0.0), (1.5, 0.05, 3.0, 1.0), (0.2, 3.4, 1.52, 0.0)];
    let cases = films.into_iter().flat_map(|(n, k, n_s, k_s)| {
        let theta = uniform(&mut bench.stream, 0.0, 1.5);
        let thickness = uniform(&mut bench.stream, 10e-9, 300e-9);
        let films = Films { n_i: 1.0, layers: vec![film(n, k, thickness)], substrate: Complex64::new(n_s, k_s) };
        BOTH.map(move |polarisation| (films.clone(), theta, polarisation))
    });
    Measured::worst(cases.map(|(films, theta, polarisation)| {
        let incidence = Incidence::from_angle(theta);
        let ours = films.stack().response(DEFAULT_WAVELENGTH, incidence, polarisation).r;
        let sum = sum_of_bounces(&films, incidence, polarisation, passage);
        let Layer { index, thickness } = films.layers[0];
        let place = format!("{polarisation:?}, n = {index}, {:.0} nm thick, θ = {theta:.3}", thickness * 1e9);
        ((ours - sum).norm() / f64::EPSILON, place)
    }))
}

/// r₁₂ + t₁₂t₂₁ Σ r₂₃ (r₂₁r₂₃)^m e^(2i(m+1)δ) of a single film.
fn sum_of_bounces(
    films: &Films,
    incidence: Incidence,
    polarisation: Polarisation,
    passage: fn(Complex64, Complex64) -> Complex64,
) -> Complex64 {
    let (n_1, n_2, n_3) = (Complex64::from(films.n_i), films.layers[0].index, films.substrate);
    let beta = n_1 * incidence.sin();
    let face = |near, far| {
        let a = amplitudes_between(beta, near, far);
        if polarisation == Polarisation::S { (a.r_s, a.t_s) } else { (a.r_p, a.t_p) }
    };
    let ((r_12, t_12), (r_21, t_21), (r_23, _)) = (face(n_1, n_2), face(n_2, n_1), face(n_2, n_3));
    let q = ((n_2 - beta) * (n_2 + beta)).sqrt();
    let there_and_back = (Complex64::I * 2.0 * TAU / DEFAULT_WAVELENGTH * films.layers[0].thickness * q).exp();
    let mut bounce = passage(t_12, t_21) * r_23 * there_and_back;
    let mut sum = r_12;
    for _ in 0..2000 {
        sum += bounce;
        bounce *= r_21 * r_23 * there_and_back;
    }
    sum
}

pub(super) const QUARTER_WAVES: Check<fn(f64, f64) -> f64> =
    check("quarter_waves", "mirrors of quarter waves transmit what the closed form says, from one film to 101")
        .against("each quarter wave turns an admittance Y into n²/Y (Born & Wolf, 7th ed., §1.6.5): T = 4n₁Y/(n₁ + Y)²")
        .within(
            512.0,
            "ulp",
            "a few roundings for each of 101 films; the rounded thickness does not count, since T is stationary there",
        )
        .of(against_admittance, |n, y| n * n / y)
        .slip("Y becomes nY", |n, y| n * y);

fn against_admittance(_: &mut Bench, turn: fn(f64, f64) -> f64) -> Measured {
    let designs = [(1, 1.38, 1.38), (1, 2.35, 1.0), (3, 2.35, 1.38), (21, 2.35, 1.38), (101, 2.0, 1.45)];
    Measured::worst(designs.map(|(count, high, low)| {
        let films = quarter_wave_mirror(count, high, low);
        let powers = films.stack().response(DEFAULT_WAVELENGTH, Incidence::NORMAL, Polarisation::S);
        let admittance = films.layers.iter().rev().fold(films.substrate.re, |y, layer| turn(layer.index.re, y));
        let sum = films.n_i + admittance;
        let closed = 4.0 * films.n_i * admittance / (sum * sum);
        ((powers.transmittance / closed - 1.0) / f64::EPSILON, format!("{count} films of {high} and {low}"))
    }))
}

/// `count` films of alternating index, the high one first, on glass.
pub(super) fn quarter_wave_mirror(count: usize, high: f64, low: f64) -> Films {
    let layers = (0..count).map(|at| quarter_film(if at % 2 == 0 { high } else { low }, DEFAULT_WAVELENGTH));
    Films { n_i: 1.0, layers: layers.collect(), substrate: Complex64::from(1.52) }
}

/// `count` films at random between clear media, some of them absorbing as much as `most`.
fn random_films(bench: &mut Bench, count: usize, most: f64) -> (Films, f64) {
    let mut draw = |low, high| uniform(&mut bench.stream, low, high);
    let layers = (0..count)
        .map(|at| film(draw(1.2, 2.6), if at % 2 == 0 { draw(0.0, most) } else { 0.0 }, draw(20e-9, 300e-9)))
        .collect();
    (Films { n_i: draw(1.0, 1.2), layers, substrate: Complex64::from(draw(1.3, 1.9)) }, draw(0.0, 1.4))
}

pub(super) const REVERSAL: Check<fn(&Powers, &Powers) -> f64> =
    check("reversal", "a stack transmits as much from behind as from the front, even one that absorbs")
        .against("the same films in reverse order, lit along the refracted ray")
        .within(
            256.0,
            "ulp",
            "some ten roundings a film, magnified by the phases (up to 20 rad) and by the rounded angle of return",
        )
        .of(from_behind, |there, back| back.transmittance / there.transmittance - 1.0)
        .slip("the same is claimed of reflection", |there, back| back.reflectance / there.reflectance - 1.0);

fn from_behind(bench: &mut Bench, change: fn(&Powers, &Powers) -> f64) -> Measured {
    Measured::worst((0..12).flat_map(|_| {
        let (films, theta) = random_films(bench, 6, 0.1);
        let there = Incidence::from_angle(theta);
        let sin = films.n_i * there.sin() / films.substrate.re;
        let back = Incidence::from_angle(sin.asin());
        let layers = films.layers.iter().rev().copied().collect();
        let reversed = Films { n_i: films.substrate.re, layers, substrate: films.n_i.into() };
        BOTH.map(|polarisation| {
            let [there, back] = [(&films, there), (&reversed, back)].map(|(films, incidence)| {
                let mut powers = [Powers { reflectance: 0.0, transmittance: 0.0, absorptance: 0.0 }];
                films.stack().waves(incidence, polarisation).powers(&[DEFAULT_WAVELENGTH], &mut powers);
                powers[0]
            });
            (change(&there, &back) / f64::EPSILON, format!("{polarisation:?}, θ = {theta:.3}, six films"))
        })
    }))
}

pub(super) const ENERGY: Check<fn(f64, Complex64) -> f64> =
    check("energy", "|r|², the flow that t carries and what the films absorb make up the incident power")
        .against("r and t as fields, A from the losses film by film: three numbers that share no sum")
        .within(64.0, "ulp", "some ten roundings for each of six films")
        .of(balance, |flux, t| flux * t.norm_sqr())
        .slip("T taken as |t|²", |_, t| t.norm_sqr());

fn balance(bench: &mut Bench, through: fn(f64, Complex64) -> f64) -> Measured {
    Measured::worst((0..24).flat_map(|_| {
        let (films, theta) = random_films(bench, 6, 0.5);
        let incidence = Incidence::from_angle(theta);
        let sin_s = films.n_i * incidence.sin() / films.substrate.re;
        let cos_s = ((1.0 - sin_s) * (1.0 + sin_s)).sqrt();
        let flux = films.substrate.re * cos_s / (films.n_i * incidence.cos());
        BOTH.map(|polarisation| {
            let found = films.stack().response(DEFAULT_WAVELENGTH, incidence, polarisation);
            let sum = found.r.norm_sqr() + through(flux, found.t) + found.absorptance;
            ((sum - 1.0) / f64::EPSILON, format!("{polarisation:?}, θ = {theta:.3}, six films"))
        })
    }))
}

pub(super) const PARRATT: Check<f64> =
    check("parratt", "R, T and A of stacks at random are right to the last digits that the inputs fix")
        .against("Parratt's recursion of interface coefficients (1954) in 256 bits: another form, another precision")
        .within(
            ALLOWED_ULPS,
            "ulp · (1 + cond)",
            "the project's promise: no more than a few roundings beyond what the inputs' own rounding does",
        )
        .of(against_parratt, 1.0)
        .slip("the wave crosses each film once where it should there and back", 0.5);

/// Error in ulp · (1 + cond) of films whose thickness is `scale` times what it should be.
fn against_parratt(bench: &mut Bench, scale: f64) -> Measured {
    let cases = [(1, 0.0), (3, 0.2), (4, 0.01), (5, 0.0)];
    Measured::worst(cases.into_iter().zip(BOTH.into_iter().cycle()).flat_map(|((count, most), polarisation)| {
        let (films, theta) = random_films(bench, count, most);
        let angle = Direction::Angle(theta);
        let exact = reference(&films.stack(), DEFAULT_WAVELENGTH, angle, polarisation);
        let kappa = condition(&films.stack(), DEFAULT_WAVELENGTH, angle, polarisation);
        let scaled = films.layers.iter().map(|layer| Layer { thickness: layer.thickness * scale, ..*layer }).collect();
        let ours = Films { layers: scaled, ..films.clone() };
        let ours = ours.stack().response(DEFAULT_WAVELENGTH, Incidence::from(angle), polarisation);
        let error = move |name: &str, ours: f64, exact: &Real, kappa: f64| {
            let error = precise::relative_error(ours, exact) / (f64::EPSILON * (1.0 + kappa));
            (error, format!("{name} of {count} films, {polarisation:?}, θ = {theta:.3}"))
        };
        [
            error("R", ours.reflectance, &exact.reflectance, kappa.reflectance),
            error("T", ours.transmittance, &exact.transmittance, kappa.transmittance),
            error("A", ours.absorptance, &exact.absorptance, kappa.absorptance),
        ]
    }))
}
