//! E24: the mean from complex amplitudes.

use crate::parameter::{FREQUENCY, MEDIUM};
use crate::plane_wave::{quantity, wave};
use crate::symbols::{AMPLITUDE, OMEGA, PERIOD, S, T};
use crate::vocabulary::{Bench, Check, Exhibit, Measured, Step, check, derivation, exhibit, statement, step};
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

pub(super) const EXHIBIT: Exhibit = exhibit("phasor", &[MEDIUM, FREQUENCY], &[]);

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
