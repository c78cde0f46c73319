//! E24: the mean from complex amplitudes.

use crate::diagram::{Diagram, Part};
use crate::figure::{Dash, Hue, Plot};
use crate::parameter::Setting;
use crate::parameter::{FREQUENCY, MEDIUM};
use crate::plane_wave::{quantity, wave};
use crate::symbols::{AMPLITUDE, OMEGA, PERIOD, S, T};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Misled, Question, Step, check, derivation, exhibit, figure, question,
    statement, step,
};
use equation::derivation::Chain;
use equation::expr::{abs, conj, cos, exp, i, integral_between, mean, pi, ratio, re, sin};
use equation::{Dimension, Equation, Expr, Symbol};
use light::Complex64;
use light::waves::constants::{EPSILON_0, Z_0};
use light::waves::flux::mean_by_phasors;
use light::waves::{Medium, Wave};
use yardstick::quadrature::gauss_legendre;

/// Amplitude of the magnetic field.
const AMPLITUDE_H: Symbol = Symbol::scalar("A_H", Dimension::AMPERE_PER_METRE).real(0.5, 2.0);
/// The angle by which H lags E.
const PHI: Symbol = Symbol::scalar("phi", Dimension::ONE).real(0.1, 0.7);
/// The phase of E.
const ALPHA: Symbol = Symbol::scalar("alpha", Dimension::ONE).real(0.1, 1.5);
/// E as a complex amplitude.
const E_HAT: Symbol = Symbol::scalar("E_0", Dimension::VOLT_PER_METRE);
/// H as a complex amplitude.
const H_HAT: Symbol = Symbol::scalar("H_0", Dimension::AMPERE_PER_METRE);

pub(super) const EXHIBIT: Exhibit = exhibit(
    "phasor",
    &[MEDIUM, FREQUENCY],
    &[figure("plane", "E and H as complex amplitudes: of H only the part along E carries energy on average.", plane)],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "From complex amplitudes",
    "½ Re(E H*) is the mean flow at once, and knows about the lag that ½vεA² forgets.",
)
.rows(&["E24"])
.about("phasors")
.statements(&[
    statement("square", "the mean flow goes as the square of the amplitude", || {
        Equation::proportional(abs(mean(S)), AMPLITUDE.pow(2))
    }),
    statement(
        "phasors",
        "from the complex amplitudes of E and H; where S turns back for a part of the period, ⟨|S|⟩ is more",
        || Equation::new(abs(mean(S)), ratio(1, 2) * re(E_HAT * conj(H_HAT))),
    ),
])
.questions(&[LAGGING])
.derivations(&[derivation(
    "lagging",
    "the mean of two cosines out of step, and the same from their complex amplitudes",
    || lagging(conj(AMPLITUDE_H * exp(i() * (ALPHA + PHI)))),
)
.slip("the conjugate forgotten", || lagging(AMPLITUDE_H * exp(i() * (ALPHA + PHI))))])
.readout(|setting| {
    let wave = wave(setting);
    vec![
        quantity("S_avg", "½ Re(E H*)", "mean flow at an amplitude of 1 V/m", wave.mean_flux, "W/m²"),
        quantity("S_vacuum", "½cε₀A²", "what the same field carries in empty space", 0.5 / Z_0, "W/m²"),
        quantity("S_modulus", "½|E||H|", "without the lag", 0.5 / wave.impedance.norm(), "W/m²"),
        quantity("phase_lag", "φ", "by which H lags E", wave.phase_lag, "rad"),
    ]
})
.checks(&[&OUT_OF_STEP, &SQUARE]);

const LAGGING: Question = question(
    "share",
    "In copper H lags E by an eighth of a period. Which share of ½|E||H| flows on average?",
    Answer::Number {
        unit: "1",
        tolerance: 0.01,
        right: |_| {
            let copper =
                light::media::named("copper").and_then(|copper| copper.wave(1e9).ok()).expect("known at 1 GHz");
            copper.mean_flux / (0.5 / copper.impedance.norm())
        },
        slips: &[
            Misled {
                value: |_| 1.0,
                reply: "So it is in step. Out of step the product is negative for a part of \
             the period.",
            },
            Misled {
                value: |_| 0.5,
                reply: "cos² 45°, but only one cosine of the lag is left in the mean of the \
             product.",
            },
            Misled { value: |_| 0.0, reply: "So it is a quarter of a period out of step, as in a coil." },
        ],
    },
    "cos 45° = 0.707; the conjugate in ½ Re(E H*) makes the angle between the two of their phases.",
);

/// `conjugate` is what stands for H* at the phase α + φ.
fn lagging(conjugate: Expr) -> Chain {
    let product = AMPLITUDE * cos(OMEGA * T - ALPHA) * AMPLITUDE_H * cos(OMEGA * T - ALPHA - PHI);
    let over_a_period = 1 / PERIOD * integral_between(&product, T, 0, PERIOD);
    let primitive = AMPLITUDE * AMPLITUDE_H * (T * cos(PHI) / 2 + sin(2 * OMEGA * T - 2 * ALPHA - PHI) / (4 * OMEGA));
    Chain::new(mean(&product))
        .given(mean(product), &over_a_period, "mean over a period")
        .given(PERIOD, 2 * pi() / OMEGA, "T = 2π/ω")
        .primitive(primitive, T)
        .then(over_a_period, ["mean over a period"])
        .then(ratio(1, 2) * AMPLITUDE * AMPLITUDE_H * cos(PHI), ["product of cosines", "T = 2π/ω"])
        .then(ratio(1, 2) * re(AMPLITUDE * exp(i() * ALPHA) * conjugate), ["Re e^{−iφ} = cos φ"])
}

const OUT_OF_STEP: Check<fn(Complex64, Complex64) -> f64> =
    check("out_of_step", "½ Re(E H*) is the mean flow in any medium, however late H comes")
        .against("the product of the two real fields over a period, by Gauss's rule")
        .within(64.0, "ulp", "forty terms of which some cancel, and a dozen roundings in Z")
        .of(out_of_step, mean_by_phasors)
        .slip("½|E||H|, as if they were in step", |e, h| 0.5 * e.norm() * h.norm());

/// σ/(ωε) of the media looked at.
const TANGENTS: [f64; 6] = [0.0, 1e-3, 0.1, 1.0, 100.0, 1e12];

fn waves() -> impl Iterator<Item = (Wave, String)> {
    let omega = 1e9;
    TANGENTS.into_iter().map(move |tangent| {
        let medium = Medium::relative(4.0, 1.0, tangent * omega * 4.0 * EPSILON_0).expect("a medium");
        (Wave::new(&medium, omega).expect("a positive frequency"), format!("σ/(ωε) = {tangent}"))
    })
}

fn out_of_step(_: &mut Bench, form: fn(Complex64, Complex64) -> f64) -> Measured {
    let rule = gauss_legendre(40);
    Measured::worst(waves().map(|(wave, at)| {
        let e = Complex64::from_polar(1.7, 0.4);
        let h = e / wave.impedance;
        let product = |share: f64| {
            let turn = Complex64::cis(-std::f64::consts::TAU * share);
            (e * turn).re * (h * turn).re
        };
        let mean: f64 = rule.iter().map(|(share, weight)| weight * product(*share)).sum();
        ((form(e, h) / mean - 1.0) / f64::EPSILON, at)
    }))
}

const SQUARE: Check<i32> =
    check("square_law", "twice the field carries four times the power, and the program's ⟨S⟩ is that of 1 V/m")
        .against("phasors of growing amplitude against the program's mean flow")
        .within(16.0, "ulp", "a few roundings on either side")
        .of(square_law, 2)
        .slip("in proportion to the amplitude", 1);

fn square_law(_: &mut Bench, power: i32) -> Measured {
    Measured::worst(waves().flat_map(|(wave, at)| {
        [1e-6, 1.0, 3.0, 1e9].map(|amplitude: f64| {
            let e = Complex64::from(amplitude);
            let found = mean_by_phasors(e, e / wave.impedance);
            (
                (found / (amplitude.powi(power) * wave.mean_flux) - 1.0) / f64::EPSILON,
                format!("{at}, A = {amplitude} V/m"),
            )
        })
    }))
}

/// Both amplitudes, each over its own size, in the plane of complex numbers; by e^(−iωt) what lags has the larger angle.
fn plane(setting: &Setting) -> Plot {
    let lag = wave(setting).phase_lag;
    let lag = if lag.is_finite() { lag } else { 0.0 };
    let (sin, cos) = lag.sin_cos();
    let mut diagram = Diagram::new(crate::plane_wave::described(setting), [-0.35, -0.35], [1.5, 1.2])
        .with(Part::vector([-0.25, 0.0], [1.45, 0.0]).hue(Hue::Reference).label("Re"))
        .with(Part::vector([0.0, -0.25], [0.0, 1.15]).hue(Hue::Reference).label("Im"))
        .with(Part::line([cos, sin], [cos, 0.0]).dash(Dash::Dashed).hue(Hue::Reference))
        .with(Part::ray([0.0; 2], [1.2, 0.0]).hue(Hue::S).label("E_0"))
        .with(Part::ray([0.0; 2], [cos, sin]).hue(Hue::P))
        .with(Part::note([cos + 0.04, sin + 0.04], "H_0").hue(Hue::P))
        .with(Part::point([cos, 0.0]).hue(Hue::P).label(format!("cos φ = {cos:.3}")));
    if lag > 0.05 {
        diagram = diagram.with(Part::arc([0.0; 2], 0.35, 0.0, lag).label("φ"));
    }
    Plot::of("The part in step", diagram)
}
