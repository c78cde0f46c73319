//! E35, E38: what the boundary conditions say about the three amplitudes.

use super::fields::{tangential_step, waves};
use super::geometry::depth;
use super::symbols::{E_1, E_1R, E_2, ELECTRIC, H_1, H_1R, H_2, MAGNETIC, N_1, N_2, NORMAL, THETA_1, THETA_2, Z_0};
use super::{INTERFACE, extremes, incidence, sample_inputs};
use crate::diagram::{Behind, Diagram, Part};
use crate::figure::{Dash, Hue, Plot};
use crate::parameter::Setting;
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Quantity, Question, Step, check, derivation, exhibit, figure, question,
    statement, step,
};
use equation::derivation::Chain;
use equation::expr::{cos, cross, sin, vector};
use equation::{Equation, Symbol};
use light::Complex64;
use light::Polarisation;
use light::optics::Incidence;
use light::optics::fresnel::{Amplitudes, amplitudes, refract};

pub(super) const EXHIBIT: Exhibit = exhibit(
    "boundary",
    INTERFACE,
    &[figure(
        "fields",
        "Which way E, H and k of the three waves count as positive: s on the left, p on the right. Each three are \
         right-handed.",
        fields,
    )],
);

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
.questions(&[TURNED_ROUND])
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

const TURNED_ROUND: Question = question(
    "turned_round",
    "s light: the electric field of the reflected wave points, say, the same way as that of the incident one. \
     Beside the incident wave's, which sign has its H along the interface?",
    Answer::Sign {
        replies: [
            "E, H and k are right-handed, and k has turned round along the normal.",
            "H along the interface is H cos θ: nothing only at grazing incidence.",
            "Then E×H would point into the interface, for a wave that leaves it.",
        ],
        right: |_| reflected_h(1.0),
        slip: |_| reflected_h(-1.0),
    },
    "Negative: a wave that turns round turns one of its fields. Hence the minus in (H₁ − H₁′) cos θ₁ for s, and in \
     (E₁ − E₁′) cos θ₁ for p.",
);

/// Tangential H of a reflected s wave whose E is `electric` of the incident one's, over that of the incident wave.
fn reflected_h(electric: f64) -> f64 {
    let one = Complex64::ONE;
    let ratios = Amplitudes { r_s: electric * one, t_s: one, r_p: one, t_p: one };
    let [incident, reflected, _] =
        waves(Polarisation::S, Incidence::from_angle(40f64.to_radians()), 1.0, 1.5.into(), &ratios);
    reflected.h[0].re / incident.h[0].re
}

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

/// The steepest and the flattest angle of incidence [rad] that is drawn: beyond them the waves lie on each other.
const DRAWN: [f64; 2] = [0.35, 1.2];

fn fields(setting: &Setting) -> Plot {
    let panels = [("s: E across the plane of incidence", Polarisation::S), ("p: H across it", Polarisation::P)];
    let panels = panels.map(|(title, polarisation)| counted(setting, title, polarisation).into());
    Plot::grid("Which way the fields count", 2, panels.into())
}

/// The waves with their fields, by the vectors that the checks are made with; x to the right and z down, so that y points
/// at the reader.
fn counted(setting: &Setting, title: &str, polarisation: Polarisation) -> Diagram {
    let (n_i, n_t) = (setting.index("n_i").re, setting.index("n_t"));
    let incidence = Incidence::from_angle(setting.number("theta").clamp(DRAWN[0], DRAWN[1]));
    let one = Complex64::ONE;
    let unit = Amplitudes { r_s: one, t_s: one, r_p: one, t_p: one };
    let all = waves(polarisation, incidence, n_i, n_t, &unit);
    let (sin, cos) = (incidence.sin(), incidence.cos());
    let behind = if n_t.im == 0.0 { refract(incidence, n_i, n_t.re) } else { None };
    let mut diagram = Diagram::new(title, [-1.3, -1.15], [1.3, 1.15])
        .with(Part::surface([1.3, 0.0], [-1.3, 0.0], Behind::Tinted(depth(n_i))))
        .with(Part::surface([-1.3, 0.0], [1.3, 0.0], Behind::Tinted(depth(n_t.re))))
        .with(Part::line([0.0, -1.1], [0.0, 1.1]).dash(Dash::Dashed).hue(Hue::Reference))
        .with(Part::ray_with_heads([-sin, cos], [0.0; 2], &[0.75]).label("k_1"))
        .with(Part::ray_with_heads([0.0; 2], [sin, cos], &[0.35]).label("k_1′"));
    let mut places = vec![[-0.6 * sin, 0.6 * cos], [0.75 * sin, 0.75 * cos]];
    match behind {
        Some((sin, cos)) => {
            let ray = Part::ray_with_heads([0.0; 2], [sin, -cos], &[0.35]);
            diagram = diagram.with(ray.hue(Hue::Transmitted).label("k_2"));
            places.push([0.7 * sin, -0.7 * cos]);
        }
        None => diagram = diagram.with(Part::note([-1.2, -0.6], "no wave with a direction")),
    }
    let names = [["E_1", "H_1"], ["E_1′", "H_1′"], ["E_2", "H_2"]];
    for ((wave, at), [electric, magnetic]) in all.iter().zip(places).zip(names) {
        let field = |vector: [Complex64; 3], hue: Hue, name: &str| {
            let [x, y, z] = vector.map(|part| part.re);
            let length = x.hypot(z);
            let part = match length > 1e-9 {
                true => Part::vector(at, [at[0] + 0.34 * x / length, at[1] - 0.34 * z / length]),
                false => Part::across(at, y > 0.0),
            };
            part.hue(hue).label(name)
        };
        diagram = diagram.with(field(wave.e, Hue::S, electric)).with(field(wave.h, Hue::P, magnetic));
    }
    diagram
}
