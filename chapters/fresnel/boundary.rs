//! E35, E38: what the boundary conditions say about the three amplitudes.

use super::fields::{tangential_step, waves};
use super::symbols::{E_1, E_1R, E_2, ELECTRIC, H_1, H_1R, H_2, MAGNETIC, N_1, N_2, NORMAL, THETA_1, THETA_2, Z_0};
use super::{INTERFACE, extremes, incidence, sample_inputs};
use crate::parameter::Setting;
use crate::vocabulary::{Bench, Check, Exhibit, Measured, Quantity, Step, check, derivation, exhibit, statement, step};
use equation::derivation::Chain;
use equation::expr::{cos, cross, sin, vector};
use equation::{Equation, Symbol};
use light::Polarisation;
use light::optics::Incidence;
use light::optics::fresnel::{Amplitudes, amplitudes};

pub(super) const EXHIBIT: Exhibit = exhibit("boundary", INTERFACE, &[]);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "What must be continuous",
    "The tangential fields on both sides are the same: two equations for each \
     polarisation.",
)
.rows(&["E35", "E38"])
.statements(&[
    statement("s_electric", "s: the electric field is all tangential", || conditions(Polarisation::S)[0].clone())
        .rows(&["E35"]),
    statement("s_magnetic", "s: of the magnetic field cos θ is", || conditions(Polarisation::S)[1].clone())
        .rows(&["E35"]),
    statement("p_electric", "p: of the electric field cos θ is tangential", || conditions(Polarisation::P)[0].clone())
        .rows(&["E38"]),
    statement("p_magnetic", "p: the magnetic field is all tangential", || conditions(Polarisation::P)[1].clone())
        .rows(&["E38"]),
])
.derivations(&[
    derivation("s", "E4 for fields of which the electric one stands across the plane of incidence", || {
        let [electric, magnetic] = conditions(Polarisation::S);
        continuous(Polarisation::S).then(electric, ["components"]).then(magnetic, ["components"])
    })
    .rows(&["E35"])
    .slip("the reflected wave does not turn round", || {
        let all = Equation::new((H_1 + H_1R) * cos(THETA_1), H_2 * cos(THETA_2));
        continuous(Polarisation::S).then(all, ["components"])
    }),
    derivation("p", "E4 for fields of which the magnetic one stands across the plane of incidence", || {
        let [electric, magnetic] = conditions(Polarisation::P);
        continuous(Polarisation::P).then(electric, ["components"]).then(magnetic, ["components"])
    })
    .rows(&["E38"])
    .slip("the reflected wave does not turn round", || {
        let all = Equation::new((E_1 + E_1R) * cos(THETA_1), E_2 * cos(THETA_2));
        continuous(Polarisation::P).then(all, ["components"])
    }),
])
.readout(readout)
.checks(&[&CONTINUITY]);

/// E35 or E38: the electric and the magnetic condition.
pub(super) fn conditions(polarisation: Polarisation) -> [Equation; 2] {
    let (cos_1, cos_2) = (cos(THETA_1), cos(THETA_2));
    match polarisation {
        Polarisation::S => [Equation::new(E_1 + E_1R, E_2), Equation::new((H_1 - H_1R) * cos_1, H_2 * cos_2)],
        Polarisation::P => [Equation::new((E_1 - E_1R) * cos_1, E_2 * cos_2), Equation::new(H_1 + H_1R, H_2)],
    }
}

/// The amplitudes under E35 or E38, with H = nE/Z₀ of every wave.
pub(super) fn bounded(polarisation: Polarisation) -> Chain {
    let [electric, magnetic] = conditions(polarisation);
    let row = match polarisation {
        Polarisation::S => "E35",
        Polarisation::P => "E38",
    };
    with_impedance(Chain::assume(electric, row).and(magnetic, row))
}

/// `chain` with the ratio of the fields in each medium.
pub(super) fn with_impedance(chain: Chain) -> Chain {
    let waves = [(H_1, N_1, E_1), (H_1R, N_1, E_1R), (H_2, N_2, E_2)];
    waves.into_iter().fold(chain, |chain, (h, n, e)| chain.given(h, n * e / Z_0, "H = nE/Z₀"))
}

/// E4 without surface charge and current: the tangential parts of the sum of the fields on either side.
fn continuous(polarisation: Polarisation) -> Chain {
    let meet = |[incident, reflected, transmitted]: [Symbol; 3]| {
        Equation::new(cross(NORMAL, incident + reflected), cross(NORMAL, transmitted))
    };
    with_fields(Chain::assume(meet(ELECTRIC), "E4").and(meet(MAGNETIC), "E4"), polarisation)
}

/// `chain` with the fields as vectors: z along the normal, the plane of incidence y = 0. One of the fields stands across
/// it, and E×H runs along the wave vector.
pub(super) fn with_fields(chain: Chain, polarisation: Polarisation) -> Chain {
    let (sin_1, cos_1) = (sin(THETA_1), cos(THETA_1));
    let directions = [vector(&sin_1, 0, &cos_1), vector(&sin_1, 0, -&cos_1), vector(sin(THETA_2), 0, cos(THETA_2))];
    let amplitudes = [(E_1, H_1), (E_1R, H_1R), (E_2, H_2)];
    let mut chain = chain.given(NORMAL, vector(0, 0, 1), "z along the normal");
    for (at, (direction, (e, h))) in directions.into_iter().zip(amplitudes).enumerate() {
        let (electric, magnetic) = (&ELECTRIC[at], &MAGNETIC[at]);
        chain = match polarisation {
            Polarisation::S => chain.given(electric, vector(0, e, 0), "s: E across the plane of incidence").given(
                magnetic,
                cross(direction, vector(0, h, 0)),
                "E×H along k",
            ),
            Polarisation::P => chain.given(magnetic, vector(0, h, 0), "p: H across the plane of incidence").given(
                electric,
                cross(vector(0, e, 0), direction),
                "E×H along k",
            ),
        };
    }
    chain
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

const CONTINUITY: Check<fn(Amplitudes) -> Amplitudes> = check(
    "continuity",
    "the program's amplitudes make tangential E and H continuous, in clear and \
     absorbing media",
)
.against("full field vectors of the three waves, H = n k×E, component by component")
.within(32.0, "ulp", "a dozen roundings in the amplitudes and in each of the vectors' products")
.of(largest_step, |a| a)
.slip("r_p with the sign of the other convention", |a| Amplitudes { r_p: -a.r_p, ..a });

fn largest_step(bench: &mut Bench, amend: fn(Amplitudes) -> Amplitudes) -> Measured {
    Measured::worst(sample_inputs(bench.setting()).iter().flat_map(|input| {
        let incidence = Incidence::from(input.direction);
        let a = amend(amplitudes(incidence, input.n_i, input.n_t));
        [Polarisation::S, Polarisation::P].map(|polarisation| {
            let step = tangential_step(&waves(polarisation, incidence, input.n_i, input.n_t, &a));
            (step / f64::EPSILON, format!("{polarisation:?}, {}", extremes::describe(input)))
        })
    }))
}
