//! E35, E38: what the boundary conditions say about the three amplitudes.

use super::fields::{tangential_step, waves};
use super::symbols::{E_1, E_1R, E_2, H_1, H_1R, H_2, THETA_1, THETA_2};
use super::{INTERFACE, extremes, incidence, sample_inputs};
use crate::setting::Setting;
use crate::vocabulary::{Bench, Bound, Check, Derivation, Measured, Quantity, Statement, Step};
use light::equation::derivation::Chain;
use light::equation::expr::cos;
use light::equation::{Equation, Expr, Symbol};
use light::optics::Incidence;
use light::optics::film::Polarisation;
use light::optics::fresnel::{Amplitudes, amplitudes};

pub(super) const STEP: Step = Step {
    id: "boundary",
    title: "What must be continuous",
    says: "The tangential fields on both sides are the same: two equations for each polarisation.",
    rows: &["E35", "E38"],
    parameters: INTERFACE,
    statements: &[
        Statement {
            id: "s_electric",
            says: "s: the electric field is all tangential",
            rows: &["E35"],
            equation: || Equation::new(E_1 + E_1R, E_2),
        },
        Statement {
            id: "s_magnetic",
            says: "s: of the magnetic field cos θ is",
            rows: &["E35"],
            equation: || Equation::new((H_1 - H_1R) * cos(THETA_1), H_2 * cos(THETA_2)),
        },
        Statement {
            id: "p_electric",
            says: "p: of the electric field cos θ is tangential",
            rows: &["E38"],
            equation: || Equation::new((E_1 - E_1R) * cos(THETA_1), E_2 * cos(THETA_2)),
        },
        Statement {
            id: "p_magnetic",
            says: "p: the magnetic field is all tangential",
            rows: &["E38"],
            equation: || Equation::new(H_1 + H_1R, H_2),
        },
    ],
    derivations: &[
        Derivation {
            id: "s",
            says: "n×(H₁−H₂) = 0 for s, where the reflected wave runs back: its cosine changes sign",
            rows: &["E35"],
            chain: || turned(H_1, H_1R, H_2, (H_1 - H_1R) * cos(THETA_1)),
            spoiled: || turned(H_1, H_1R, H_2, (H_1 + H_1R) * cos(THETA_1)),
            slip: "the reflected wave does not turn round",
        },
        Derivation {
            id: "p",
            says: "n×(E₁−E₂) = 0 for p, likewise",
            rows: &["E38"],
            chain: || turned(E_1, E_1R, E_2, (E_1 - E_1R) * cos(THETA_1)),
            spoiled: || turned(E_1, E_1R, E_2, (E_1 + E_1R) * cos(THETA_1)),
            slip: "the reflected wave does not turn round",
        },
    ],
    readout: Some(readout),
    checks: &[CONTINUITY],
    stress: &[],
    races: &[],
    figures: &[],
};

/// The tangential components of three waves, of which the second has the normal part of its wave vector reversed.
fn turned(first: Symbol, second: Symbol, third: Symbol, left: Expr) -> Chain {
    let (cos_1, cos_2) = (cos(THETA_1), cos(THETA_2));
    let across = &third * &cos_2;
    Chain::new(Equation::new(&first * &cos_1 + &second * -&cos_1, across.clone()))
        .given(third, (&first - &second) * cos_1 / cos_2, "E4: tangential parts meet")
        .then(Equation::new(left, across), ["collect cos θ₁"])
}

fn readout(setting: &Setting) -> Vec<Quantity> {
    let input = super::interface(setting);
    let a = amplitudes(incidence(setting), input.n_i, input.n_t);
    let step = |key, symbol, polarisation| Quantity {
        key,
        symbol,
        says: "largest step of a tangential field across the interface",
        value: tangential_step(&waves(polarisation, incidence(setting), input.n_i, input.n_t, &a)),
        unit: "1",
    };
    vec![step("step_s", "s", Polarisation::S), step("step_p", "p", Polarisation::P)]
}

const CONTINUITY: Check = Check {
    id: "continuity",
    claim: "the program's amplitudes make tangential E and H continuous, in clear and absorbing media",
    rows: &["E35", "E38"],
    route: "full field vectors of the three waves, H = n k×E, component by component",
    bound: Bound::AtMost {
        limit: 32.0,
        unit: "ε",
        why: "a dozen roundings in the amplitudes and in each of the vectors' products",
    },
    measure: |bench| largest_step(bench, |a| a),
    spoiled: |bench| largest_step(bench, |a| Amplitudes { r_p: -a.r_p, ..a }),
    slip: "r_p with the sign of the other convention",
};

fn largest_step(bench: &mut Bench, amend: fn(Amplitudes) -> Amplitudes) -> Measured {
    Measured::worst(sample_inputs(bench.setting).iter().flat_map(|input| {
        let incidence = Incidence::from(input.direction);
        let a = amend(amplitudes(incidence, input.n_i, input.n_t));
        [Polarisation::S, Polarisation::P].map(|polarisation| {
            let step = tangential_step(&waves(polarisation, incidence, input.n_i, input.n_t, &a));
            (step / f64::EPSILON, format!("{polarisation:?}, {}", extremes::describe(input)))
        })
    }))
}
