//! E14, E19: one frequency, its wavelength and its wave number.

use super::perspective::travelling;
use super::transverse::oblique;
use super::wave_equation::twice;
use super::{GREEN, VACUUM, described, quantity, wave};
use crate::figure::Plot;
use crate::parameter::Setting;
use crate::symbols::{AMPLITUDE, AMPLITUDE_B, E, EPSILON, K, K_VECTOR, LAMBDA, MU, OMEGA, T, V, WAVE, Z};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Misled, Quantity, Question, Step, check, derivation, exhibit, figure,
    question, statement, step,
};
use equation::derivation::Chain;
use equation::expr::{cos, dot, laplacian, pi, sqrt};
use equation::{Dimension, Equation, Expr, Symbol};
use light::Complex64;
use light::Polarisation;
use light::optics::Incidence;
use light::optics::film::{Layer, Stack};
use light::waves::constants::C;
use light::waves::{Medium, Wave};
use std::f64::consts::{PI, TAU};

const WAVE_B: Symbol = Symbol::scalar("B_y", Dimension::TESLA);

pub(super) const EXHIBIT: Exhibit = exhibit(
    "cosine",
    &[VACUUM, GREEN],
    &[figure(
        "perspective",
        "E and B of a travelling wave in perspective, at four instants a sixth of a period \
         apart.",
        perspective,
    )
    .rows(&["E14"])],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "One frequency",
    "The simplest shape is a cosine: it repeats after λ in space and after 1/f in \
     time, and k counts radians per metre.",
)
.rows(&["E14", "E19"])
.statements(&[
    statement("electric", "the electric field of a harmonic wave", || {
        Equation::new(WAVE.at([Z.into(), T.into()]), AMPLITUDE * cos(by_wavelength()))
    })
    .rows(&["E14"]),
    statement("magnetic", "and its magnetic field, with an amplitude of its own", || {
        Equation::new(WAVE_B.at([Z.into(), T.into()]), AMPLITUDE_B * cos(by_wavelength()))
    })
    .rows(&["E14"]),
    statement("wave_number", "the wave number", || Equation::new(K, OMEGA / V)).rows(&["E19"]),
    statement("phase", "the wave by its wave number and its frequency", || {
        Equation::new(WAVE.at([Z.into(), T.into()]), AMPLITUDE * cos(K * Z - OMEGA * T))
    })
    .rows(&["E19"]),
])
.questions(&[IN_GLASS])
.derivations(&[
    derivation("is_a_wave", "a cosine of z − vt is one of d'Alembert's shapes", || is_a_wave(1 / sqrt(EPSILON * MU)))
        .rows(&["E14"])
        .slip("a speed that is not the medium's", || is_a_wave(1 / (2 * sqrt(EPSILON * MU)))),
    derivation("radians", "a whole turn over a wavelength, and ω/v radians per metre", || {
        radians(2 * pi() * V / OMEGA)
    })
    .rows(&["E19"])
    .slip("ω taken for f: λ = v/ω", || radians(V / OMEGA)),
    derivation(
        "any_direction",
        "a wave e^{i(k·r − ωt)} in any direction obeys the wave equation if k² = εμω²",
        || any_direction(dot(K_VECTOR, K_VECTOR)),
    )
    .rows(&["E19"])
    .slip("∂²/∂z² taken for k², not −k²", || any_direction(-dot(K_VECTOR, K_VECTOR))),
])
.readout(readout)
.checks(&[&NUMEROV, &FRINGES]);

const IN_GLASS: Question = question(
    "in_glass",
    "Light of one frequency goes from the vacuum into glass of n = 1.5. How many radians per metre does it turn \
     there, over in the vacuum?",
    Answer::Number {
        unit: "1",
        tolerance: 0.01,
        right: |_| {
            let [glass, vacuum] = [2.25, 1.0].map(|eps| {
                let medium = Medium::relative(eps, 1.0, 0.0).expect("a clear medium");
                Wave::new(&medium, TAU * 545e12).expect("a positive frequency").k.re
            });
            glass / vacuum
        },
        slips: &[
            Misled {
                value: |_| 1.0 / 1.5,
                reply: "So it is with the wavelength, which is a turn over k. The slower the wave, the closer its \
                 crests.",
            },
            Misled {
                value: |_| 1.0,
                reply: "What stays is the frequency, radians per *second*: as many crests arrive as go on. Per \
                 metre there are more.",
            },
        ],
    },
    "1.5 times as many: k = ω/v, with the same ω and a v of c/n.",
);

fn by_wavelength() -> Expr {
    2 * pi() / LAMBDA * (Z - V * T)
}

fn is_a_wave(speed: Expr) -> Chain {
    let field = AMPLITUDE * cos(by_wavelength());
    let slope = (2 * pi() / LAMBDA).pow(2);
    Chain::new(twice(&field, Z))
        .given(V, speed, "v = 1/√(εμ)")
        .then(-(&slope * &field), ["∂²cos = −cos"])
        .then(EPSILON * MU * twice(&field, T), ["∂²cos = −cos", "v = 1/√(εμ)"])
}

fn radians(wavelength: Expr) -> Chain {
    Chain::new(AMPLITUDE * cos(by_wavelength()))
        .given(LAMBDA, wavelength, "λ = 2πv/ω")
        .given(K, OMEGA / V, "k = ω/v")
        .then(AMPLITUDE * cos(OMEGA / V * (Z - V * T)), ["λ = 2πv/ω"])
        .then(AMPLITUDE * cos(K * Z - OMEGA * T), ["k = ω/v"])
}

fn any_direction(k_squared: Expr) -> Chain {
    oblique(laplacian(E) - EPSILON * MU * twice(E, T))
        .because("nought, by the wave equation")
        .then((EPSILON * MU * OMEGA.pow(2) - k_squared) * E, ["∇ = ik, ∂/∂t = −iω"])
        .because("so the factor in front of E vanishes")
}

fn readout(setting: &Setting) -> Vec<Quantity> {
    let wave = wave(setting);
    vec![
        quantity("wavelength", "λ", "wavelength in the medium", wave.wavelength, "m"),
        quantity("k_re", "k", "wave number (its real part)", wave.k.re, "rad/m"),
        quantity("period", "1/f", "period", 1.0 / wave.frequency(), "s"),
        quantity("v_phase", "v", "speed of the phase", wave.v_phase, "m/s"),
    ]
}

/// The distance of two zeros is half a wavelength, and zeros can be found without knowing what a cosine is.
const NUMEROV: Check<fn(f64, f64, f64) -> f64> = check("zeros", "the field passes through zero every half wavelength")
    .rows(&["E14"])
    .against("d²E/dz² = −ω²εμE integrated by Numerov's method; its zeros by interpolation")
    .within(
        1e-10,
        "1",
        "Numerov's phase error, (kh)⁴/480, at 1000 steps a wavelength is 3e−12; the zeros \
         are interpolated by cubics",
    )
    .of(zeros, |omega, epsilon_r, mu_r| {
        let medium = Medium::relative(epsilon_r, mu_r, 0.0);
        medium.ok().and_then(|medium| Wave::new(&medium, omega).ok()).map_or(f64::NAN, |wave| wave.wavelength)
    })
    .slip("the wavelength in the vacuum", |omega, _, _| TAU * C / omega);

/// ω [rad/s], ε_r and μ_r [1] to the wavelength [m].
fn zeros(_: &mut Bench, wavelength: fn(f64, f64, f64) -> f64) -> Measured {
    let cases = [(1.0, 1.0, 1e9), (2.25, 1.0, TAU * 545e12), (80.0, 1.0, TAU * 50.0), (1.0, 100.0, 1e-3)];
    Measured::worst(cases.map(|(epsilon_r, mu_r, omega)| {
        let medium = Medium::relative(epsilon_r, mu_r, 0.0).expect("a clear medium");
        // Steps of a thousandth of the wavelength in the medium, near enough: C/√(ε_r μ_r) is no part of the answer.
        let h = C / (epsilon_r * mu_r).sqrt() * TAU / omega / 1000.0;
        let found = numerov_zeros(omega * omega * medium.epsilon() * medium.mu() * h * h, 21);
        let half = (found[20] - found[0]) * h / 20.0;
        (
            2.0 * half / wavelength(omega, epsilon_r, mu_r) - 1.0,
            format!("ε_r = {epsilon_r}, μ_r = {mu_r}, ω = {omega:e}"),
        )
    }))
}

/// The first `count` zeros, in steps, of u″ = −q u with u = 1 and u′ about 0 at the start; q per step squared.
fn numerov_zeros(q: f64, count: usize) -> Vec<f64> {
    let (weight, turn) = (1.0 + q / 12.0, 2.0 - 5.0 * q / 6.0);
    let mut last = [1.0, 1.0, 1.0 - q / 2.0, 0.0];
    last[3] = (turn * last[2] - weight * last[1]) / weight;
    let (mut step, mut zeros) = (2.0, Vec::new());
    while zeros.len() < count {
        if (last[1] < 0.0) != (last[2] < 0.0) && step > 3.0 {
            let cubic = |x: f64| {
                let [a, b, c, d] = last;
                -a * x * (x - 1.0) * (x - 2.0) / 6.0 + b * (x + 1.0) * (x - 1.0) * (x - 2.0) / 2.0
                    - c * (x + 1.0) * x * (x - 2.0) / 2.0
                    + d * (x + 1.0) * x * (x - 1.0) / 6.0
            };
            zeros.push(step + super::transverse::zero_of(cubic, 0.0, 1.0));
        }
        let next = (turn * last[3] - weight * last[2]) / weight;
        last = [last[1], last[2], last[3], next];
        step += 1.0;
    }
    zeros
}

const FRINGES: Check<fn(&Wave) -> f64> =
    check("half_wave", "a film grown by π/k reflects as if nothing had been added")
        .rows(&["E19"])
        .against("the film formulas of the chapter `fresnel`, which count in vacuum wavelengths")
        .within(1e-13, "1", "a phase of up to 10π, rounded, and a reflectance below ½")
        .of(fringes, |wave| wave.k.re)
        .slip("the wave number of the vacuum", |wave| wave.omega / C);

fn fringes(_: &mut Bench, wave_number: fn(&Wave) -> f64) -> Measured {
    let indices = [1.2, 1.38, 2.4, 4.0];
    Measured::worst(indices.into_iter().flat_map(|n: f64| {
        let lambda = 550e-9;
        let medium = Medium::relative(n * n, 1.0, 0.0).expect("a clear medium");
        let wave = Wave::new(&medium, TAU * C / lambda).expect("a positive frequency");
        let reflectance = move |thickness: f64| {
            let layers = [Layer { index: Complex64::from(n), thickness }];
            let stack = Stack { n_i: 1.0, layers: &layers, substrate: 1.52.into() };
            stack.response(lambda, Incidence::NORMAL, Polarisation::S).reflectance
        };
        let bare = reflectance(30e-9);
        (1..=5).map(move |order| {
            let grown = reflectance(30e-9 + f64::from(order) * PI / wave_number(&wave));
            (grown - bare, format!("n = {n}, {order} half waves"))
        })
    }))
}

fn perspective(setting: &Setting) -> Plot {
    let wave = wave(setting);
    let panel = |step: u32| {
        let turn = TAU * f64::from(step) / 6.0;
        travelling(format!("ωt = {}°", 60 * step), &wave, turn).into()
    };
    let title = format!("E (blue, upright) and B (red, across) along z, in {}", described(setting));
    Plot::grid(title, 2, (0..4).map(panel).collect())
}
