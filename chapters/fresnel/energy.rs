//! E43: nothing is lost at a clear interface.

use super::amplitudes::{r_p, r_s, t_p, t_s};
use super::extremes::{self, cases_against, describe};
use super::snell::with_snell;
use super::symbols::{N_1, N_2, R_N, R_P, R_S, T_P, T_S, THETA_1, THETA_2};
use super::{INTERFACE, incidence, interface};
use crate::parameter::Setting;
use crate::vocabulary::{
    Bench, Check, Exhibit, Extreme, Measured, Quantity, Step, check, derivation, exhibit, statement, step, stress,
};
use equation::derivation::Chain;
use equation::expr::{cos, sin};
use equation::{Dimension, Equation, Expr, Symbol};
use light::Complex64;
use light::optics::fresnel::{Powers, amplitudes, critical_angle, powers};
use light::optics::{Direction, Incidence};
use light::references::fresnel::{Input, NAMES};
use std::f64::consts::FRAC_PI_2;

const T_N: Symbol = Symbol::scalar("T_n", Dimension::ONE);

pub(super) const EXHIBIT: Exhibit = exhibit("energy", INTERFACE, &[]);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "What is not reflected is transmitted",
    "At a clear interface the two shares make one, for s, for p and for natural light.",
)
.rows(&["E43"])
.statements(&[statement("balance", "energy is conserved", || Equation::new(R_N + T_N, Expr::from(1)))])
.derivations(&[
    derivation("s", "R_s + T_s from E36, E37 and E41", || s_balance(weight()))
        .slip("T taken as t²", || s_balance(Expr::from(1))),
    derivation("p", "R_p + T_p from E39, E40 and E41", || p_balance(weight()))
        .slip("T taken as t²", || p_balance(Expr::from(1))),
    derivation("natural", "R_n + T_n, the means of s and p", || balance(Expr::from(1)))
        .slip("the two halves are each taken for a whole", || balance(Expr::from(2))),
])
.readout(readout)
.checks(&[&R_PLUS_T])
.stress(&[stress(
    "small_transmittance",
    "T keeps its digits where it is small, because it is computed by itself",
    small_transmittances,
)
.textbook("T = 1 − R, as most programs have it")
.against("E41 in 256 bits")]);

/// What T is more than t².
fn weight() -> Expr {
    N_2 * cos(THETA_2) / (N_1 * cos(THETA_1))
}

fn s_balance(weight: Expr) -> Chain {
    let (sum, difference) = (sin(THETA_1 + THETA_2).pow(2), sin(THETA_1 - THETA_2).pow(2));
    with_snell(Chain::new(R_S.pow(2) + weight * T_S.pow(2)))
        .because("R_s + T_s by E41")
        .given(R_S, r_s(), "E36")
        .given(T_S, t_s(), "E37")
        .then(
            (&difference + sin(2 * THETA_1) * sin(2 * THETA_2)) / &sum,
            ["E36", "E37", "Snell", "double angle", "common denominator"],
        )
        .then(&sum / sum.clone(), ["square of a sum"])
        .then(Expr::from(1), ["cancel"])
}

fn p_balance(weight: Expr) -> Chain {
    let (sum, difference) = (THETA_1 + THETA_2, THETA_1 - THETA_2);
    let whole = (sin(&sum) * cos(&difference)).pow(2);
    with_snell(Chain::new(R_P.pow(2) + weight * T_P.pow(2)))
        .because("R_p + T_p by E41")
        .given(R_P, r_p(), "E39")
        .given(T_P, t_p(), "E40")
        .then(
            ((sin(&difference) * cos(&sum)).pow(2) + sin(2 * THETA_1) * sin(2 * THETA_2)) / &whole,
            ["E39", "E40", "Snell", "tan = sin/cos", "common denominator"],
        )
        .then(
            ((sin(2 * THETA_1) - sin(2 * THETA_2)).pow(2) + 4 * sin(2 * THETA_1) * sin(2 * THETA_2))
                / (sin(2 * THETA_1) + sin(2 * THETA_2)).pow(2),
            ["product to sum"],
        )
        .then(Expr::from(1), ["square of a sum"])
}

/// Natural light, half of it s and half p.
fn balance(last: Expr) -> Chain {
    with_snell(Chain::new(R_N + T_N))
        .given(R_N, (R_S.pow(2) + R_P.pow(2)) / 2, "E42")
        .given(T_N, weight() * (T_S.pow(2) + T_P.pow(2)) / 2, "E42, for what goes through")
        .given(R_S, r_s(), "E36")
        .given(T_S, t_s(), "E37")
        .given(R_P, r_p(), "E39")
        .given(T_P, t_p(), "E40")
        .then(
            (R_S.pow(2) + weight() * T_S.pow(2)) / 2 + (R_P.pow(2) + weight() * T_P.pow(2)) / 2,
            ["E42", "collect s and p"],
        )
        .then(last, ["R_s + T_s = 1", "R_p + T_p = 1"])
}

fn readout(setting: &Setting) -> Vec<Quantity> {
    let input = interface(setting);
    let powers = powers(incidence(setting), input.n_i, input.n_t);
    let all = [
        ("R_n", "R_n", "reflected share of natural light", powers.r_n()),
        ("T_n", "T_n", "transmitted share of natural light", powers.t_n()),
        ("sum", "R_n + T_n", "their sum", powers.r_n() + powers.t_n()),
    ];
    all.map(|(key, symbol, says, value)| Quantity { key, symbol, says, value, unit: "1" }).into()
}

const R_PLUS_T: Check<fn(Incidence, f64, Complex64) -> Powers> =
    check("r_plus_t", "R + T = 1 at every angle, into the glass and out of it, for s, p and natural light")
        .against("R from the reflected, T from the transmitted wave alone; conservation joins them")
        .within(8.0, "ulp", "about ten roundings of numbers near 1")
        .of(imbalance, powers)
        .slip("T taken as |t|²", |incidence, n_i, n_t| {
            let a = amplitudes(incidence, n_i, n_t);
            Powers { t_s: a.t_s.norm_sqr(), t_p: a.t_p.norm_sqr(), ..powers(incidence, n_i, n_t) }
        });

fn imbalance(bench: &mut Bench, powers: fn(Incidence, f64, Complex64) -> Powers) -> Measured {
    let own = interface(bench.setting);
    let indices = [0.01, 0.3, 0.75, 1.0 - 1e-12, 1.0 + 1e-12, 1.33, 1.5, 2.4, 4.0, 100.0];
    let pairs = indices.map(|n_t| (1.0, Complex64::from(n_t))).into_iter().chain([(own.n_i, own.n_t)]);
    let critical =
        indices.into_iter().filter_map(|n_t| Some((n_t, critical_angle(1.0, n_t)?))).flat_map(|(n_t, angle)| {
            // Just below the critical angle everything that can cancel does.
            (4..64)
                .map(move |quarter| angle - 10f64.powf(-f64::from(quarter) / 4.0))
                .filter(|theta| *theta >= 0.0)
                .map(move |theta| Input { direction: Direction::Angle(theta), n_i: 1.0, n_t: n_t.into() })
        });
    let angles = (0..=200).map(|step| f64::from(step) / 200.0 * FRAC_PI_2).map(Direction::Angle);
    let grazing = (0..20).map(|power| Direction::Grazing(10f64.powi(-power)));
    let directions: Vec<_> = angles.chain(grazing).collect();
    let fan = pairs.flat_map(|(n_i, n_t)| directions.iter().map(move |&direction| Input { direction, n_i, n_t }));
    Measured::worst(fan.chain(critical).flat_map(|input| {
        let p = powers(input.direction.into(), input.n_i, input.n_t);
        let sums = [("s", p.r_s + p.t_s), ("p", p.r_p + p.t_p), ("natural", p.r_n() + p.t_n())];
        sums.map(|(name, sum)| ((sum - 1.0) / f64::EPSILON, format!("{name}, {}", describe(&input))))
    }))
}

fn small_transmittances(setting: &Setting) -> Vec<Extreme> {
    let clear = |direction, n_i: f64, n_t: f64| Input { direction, n_i, n_t: n_t.into() };
    let inputs = [
        interface(setting),
        clear(Direction::Grazing(1e-6), 1.0, 1.5),
        clear(Direction::Grazing(1e-18), 1.0, 1.5),
        clear(Direction::Angle(0.2), 1.0, 1e6),
        clear(Direction::Angle(0.0), 1.0, 1e-6),
        clear(Direction::Grazing(1e-40), 2.0, 3.0),
    ];
    let by_difference = |input: &Input| {
        let mut outputs = extremes::ours(input);
        for at in [9, 11, 13] {
            outputs[at] = 1.0 - outputs[at - 1];
        }
        outputs
    };
    debug_assert_eq!([NAMES[9], NAMES[11], NAMES[13]], ["T_s", "T_p", "T_n"]);
    cases_against(&["T_s", "T_p", "T_n"], &inputs, by_difference)
}
