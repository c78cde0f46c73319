//! E36, E37, E39, E40: the four amplitude ratios. One measurement serves all: the equation on the page, evaluated in
//! arbitrary precision, against the program's function.

use super::boundary::bounded;
use super::snell::with_snell;
use super::symbols::{E_1, E_1R, E_2, N_1, N_2, R_P, R_S, T_P, T_S, THETA_1, THETA_2};
use super::{INTERFACE, extremes, incidence, interface, media, over_angle, over_angle_near};
use crate::figure::{Axis, Chart, Hue, Plot};
use crate::parameter::Setting;
use crate::vocabulary::{
    ALLOWED_ULPS, Answer, Bench, Bound, Exhibit, Measured, Misled, Quantity, Question, Step, check, derivation,
    exhibit, figure, question, statement, step, stress,
};
use equation::derivation::Chain;
use equation::expr::{asin, cos, sin, tan};
use equation::value::Bindings;
use equation::{Equation, Expr};
use light::Complex64;
use light::Polarisation;
use light::optics::fresnel::{Amplitudes, amplitudes, brewster_angle, critical_angle, powers};
use light::optics::{Direction, Incidence};
use light::references::fresnel::{Exact, Input};
use std::f64::consts::FRAC_PI_2;
use yardstick::precise;
use yardstick::random::uniform;

/// How far the program may be from the equation, in units of ulp · (1 + cond).
const AS_PROMISED: Bound = Bound::AtMost {
    limit: ALLOWED_ULPS,
    unit: "ulp · (1 + cond)",
    why: "the project's promise: no more than a few roundings beyond what the inputs' own rounding does",
};

const ROUTE: &str = "the equation above, as the object on the page, in 256-bit arithmetic";

pub(super) const R_S_EXHIBIT: Exhibit = exhibit(
    "r_s",
    INTERFACE,
    &[figure("against_angle", "r_s with its sign against the angle.", |setting| {
        curves(setting, "Reflected amplitude, s", &[("r_s", Hue::S, |a| a.r_s)])
    })],
);

pub(super) const R_S_STEP: Step = step(
    R_S_EXHIBIT,
    "Reflected, s",
    "Across the plane of incidence the reflected field changes sign at a denser medium.",
)
.rows(&["E36"])
.statements(&[statement("ratio", "reflected over incident electric field, s", || Equation::new(R_S, r_s()))])
.questions(&[R_S_SIGN])
.derivations(&[derivation("from_boundary", "E35 solved for E₁′/E₁, with H = nE/Z₀", || s_chain(r_s()))
    .slip("the sign of r_s", || s_chain(-r_s()))])
.readout(|setting| readout(setting, ["r_s_re", "r_s_im"], ["Re r_s", "Im r_s"], |a| a.r_s))
.checks(&[&check("as_written", "the program's r_s is the lecture's")
    .against(ROUTE)
    .bound(AS_PROMISED)
    .of::<fn(f64, f64, f64) -> f64>(|bench, formula| held_against(bench, &r_s(), formula, 0), programs_r_s)
    .slip("the minus sign is dropped", |theta, n_i, n_t| -programs_r_s(theta, n_i, n_t))])
.stress(&[stress(
    "small_contrast",
    "r_s keeps its digits at normal incidence and between nearly equal media",
    |setting| extremes::cases(&["r_s_re"], &hard_inputs(setting)),
)
.textbook("−sin(θ₁−θ₂)/sin(θ₁+θ₂)")
.against("(q₁ − q₂)/(q₁ + q₂) in 256 bits")]);

const R_S_SIGN: Question = question(
    "which_sign",
    "Light in air meets glass along the normal. Which sign has the reflected electric field, beside the incident \
     one?",
    Answer::Sign {
        replies: [
            "In glass the same field drives more current, and the field at its face is pulled down: the reflected \
             wave takes away.",
            "It is zero only where the two indices are the same.",
            "That is from glass into air, as at the free end of a rope. Glass is the heavier rope.",
        ],
        right: |_| amplitudes(Incidence::NORMAL, 1.0, 1.5.into()).r_s.re,
        slip: |_| amplitudes(Incidence::NORMAL, 1.5, 1.0.into()).r_s.re,
    },
    "Negative, −0.2: at a denser medium the field is turned over, as a wave on a rope is at a heavier rope.",
);

pub(super) const T_S_EXHIBIT: Exhibit = exhibit(
    "t_s",
    INTERFACE,
    &[figure("against_angle", "t_s against the angle, into and out of the medium.", |setting| {
        curves(setting, "Transmitted amplitude, s", &[("t_s", Hue::Transmitted, |a| a.t_s)])
    })],
);

pub(super) const T_S_STEP: Step =
    step(T_S_EXHIBIT, "Transmitted, s", "The transmitted field is the sum of the incident and the reflected one.")
        .rows(&["E37"])
        .statements(&[statement("ratio", "transmitted over incident electric field, s", || Equation::new(T_S, t_s()))])
        .questions(&[T_S_OUT])
        .derivations(&[derivation("from_boundary", "E35 solved for E₂/E₁, with H = nE/Z₀", || t_s_chain(t_s()))
            .slip("the angles are interchanged", || {
                t_s_chain(2 * sin(THETA_1) * cos(THETA_2) / sin(THETA_1 + THETA_2))
            })])
        .readout(|setting| readout(setting, ["t_s_re", "t_s_im"], ["Re t_s", "Im t_s"], |a| a.t_s))
        .checks(&[&check("as_written", "the program's t_s is the lecture's")
            .against(ROUTE)
            .bound(AS_PROMISED)
            .of::<fn() -> Expr>(|bench, equation| against_equation(bench, &equation(), |a| a.t_s, 2), t_s)
            .slip("the angles are interchanged", || 2 * sin(THETA_1) * cos(THETA_2) / sin(THETA_1 + THETA_2))])
        .stress(&[stress(
            "grazing",
            "t_s keeps its digits down to the last picoradian above the surface",
            |setting| extremes::cases(&["t_s_re"], &hard_inputs(setting)),
        )
        .textbook("2 sin θ₂ cos θ₁/sin(θ₁+θ₂)")
        .against("2 q₁/(q₁ + q₂) in 256 bits")]);

const T_S_OUT: Question = question(
    "out_of_glass",
    "Light leaves glass of n = 1.5 along the normal, and a part of it comes back. The field that goes on into the \
     air: how large is it, over the incident one?",
    Answer::Number {
        unit: "1",
        tolerance: 0.01,
        right: |_| amplitudes(Incidence::NORMAL, 1.5, 1.0.into()).t_s.re,
        slips: &[
            Misled {
                value: |_| amplitudes(Incidence::NORMAL, 1.0, 1.5.into()).t_s.re,
                reply: "That is the way into the glass. Here the reflected field has the sign of the incident one, \
                 and adds to it.",
            },
            Misled {
                value: |_| powers(Incidence::NORMAL, 1.5, 1.0.into()).t_s,
                reply: "That is the share of the *power*. A field may grow where the light gets faster.",
            },
            Misled { value: |_| 1.0, reply: "Then nothing could come back: at the interface 1 + r_s is t_s." },
        ],
    },
    "1.2: more than came. It is no gain of energy, since in air the same field carries less.",
);

pub(super) const R_P_EXHIBIT: Exhibit = exhibit(
    "r_p",
    INTERFACE,
    &[figure("against_angle", "r_p with its sign against the angle: the zero is Brewster's.", |setting| {
        curves(setting, "Reflected amplitudes", &[("r_s", Hue::S, |a| a.r_s), ("r_p", Hue::P, |a| a.r_p)])
    })],
);

pub(super) const R_P_STEP: Step =
    step(R_P_EXHIBIT, "Reflected, p", "In the plane of incidence the reflected field passes through zero.")
        .rows(&["E39"])
        .statements(&[statement("ratio", "reflected over incident electric field, p", || Equation::new(R_P, r_p()))])
        .questions(&[R_P_NORMAL])
        .derivations(&[derivation("from_boundary", "E38 solved for E₁′/E₁, with H = nE/Z₀", || p_chain(r_p()))
            .slip("sine for tangent", || p_chain(sin(THETA_1 - THETA_2) / sin(THETA_1 + THETA_2)))])
        .readout(|setting| readout(setting, ["r_p_re", "r_p_im"], ["Re r_p", "Im r_p"], |a| a.r_p))
        .checks(&[&check("as_written", "the program's r_p is the lecture's")
            .against(ROUTE)
            .bound(AS_PROMISED)
            .of::<fn() -> Expr>(|bench, equation| against_equation(bench, &equation(), |a| a.r_p, 4), r_p)
            .slip("the sign of the other convention, in which r_p = r_s along the normal", || -r_p())])
        .stress(&[stress(
            "brewster",
            "r_p keeps its digits where it vanishes: at Brewster's angle, and between nearly equal media",
            |setting| {
                let brewster = brewster_angle(1.0, 1.5);
                let near =
                    [-1e-6, -1e-9, 1e-9, 1e-6].map(|offset| clear(Direction::Angle(brewster + offset), 1.0, 1.5));
                extremes::cases(&["r_p_re"], &[hard_inputs(setting), near.to_vec()].concat())
            },
        )
        .textbook("tan(θ₁−θ₂)/tan(θ₁+θ₂)")
        .against("(n₂²q₁ − n₁²q₂)/(n₂²q₁ + n₁²q₂) in 256 bits")]);

const R_P_NORMAL: Question = question(
    "along_the_normal",
    "Along the normal s and p are the same light. For air and glass r_s is −0.2 there. What is r_p in this lecture?",
    Answer::Number {
        unit: "1",
        tolerance: 0.01,
        right: |_| amplitudes(Incidence::NORMAL, 1.0, 1.5.into()).r_p.re,
        slips: &[
            Misled {
                value: |_| amplitudes(Incidence::NORMAL, 1.0, 1.5.into()).r_s.re,
                reply: "The *field* is the same, the number is not: E_p turns with its ray, so that along the \
                 normal E_p of the reflected wave counts the other way.",
            },
            Misled { value: |_| 0.0, reply: "r_p vanishes at Brewster's angle, not along the normal." },
            Misled {
                value: |_| powers(Incidence::NORMAL, 1.0, 1.5.into()).r_p,
                reply: "That is R, the share of the power.",
            },
        ],
    },
    "+0.2. The field does the same; which way it counts as positive is a convention, and the diagram of the \
     boundary conditions shows ours.",
);

pub(super) const T_P_EXHIBIT: Exhibit = exhibit(
    "t_p",
    INTERFACE,
    &[figure("amplitudes", "All four ratios with their signs, into the medium and out of it.", both_ways)
        .rows(&["E36", "E37", "E39", "E40"])],
);

pub(super) const T_P_STEP: Step =
    step(T_P_EXHIBIT, "Transmitted, p", "With r_s, t_s and r_p the fourth ratio completes the interface.")
        .rows(&["E40"])
        .statements(&[statement("ratio", "transmitted over incident electric field, p", || Equation::new(T_P, t_p()))])
        .questions(&[T_P_ALL])
        .derivations(&[derivation("from_boundary", "E38 solved for E₂/E₁, with H = nE/Z₀", || t_p_chain(t_p()))
            .slip("the factor 1/cos(θ₁−θ₂) is forgotten", || t_p_chain(t_s()))])
        .readout(|setting| readout(setting, ["t_p_re", "t_p_im"], ["Re t_p", "Im t_p"], |a| a.t_p))
        .checks(&[&check("as_written", "the program's t_p is the lecture's")
            .against(ROUTE)
            .bound(AS_PROMISED)
            .of::<fn() -> Expr>(|bench, equation| against_equation(bench, &equation(), |a| a.t_p, 6), t_p)
            .slip("the factor 1/cos(θ₁−θ₂) is forgotten", t_s)])
        .stress(&[stress(
            "grazing",
            "t_p keeps its digits at grazing incidence and out of a dense medium",
            |setting| extremes::cases(&["t_p_re"], &hard_inputs(setting)),
        )
        .textbook("2 sin θ₂ cos θ₁/(sin(θ₁+θ₂) cos(θ₁−θ₂))")
        .against("2 n₁n₂q₁/(n₂²q₁ + n₁²q₂) in 256 bits")]);

const T_P_ALL: Question = question(
    "all_goes_in",
    "At Brewster's angle all p light goes from air into glass of n = 1.5, and none comes back. What is t_p there?",
    Answer::Number {
        unit: "1",
        tolerance: 0.01,
        right: |_| amplitudes(Incidence::from_angle(brewster_angle(1.0, 1.5)), 1.0, 1.5.into()).t_p.re,
        slips: &[
            Misled {
                value: |_| 1.0,
                reply: "T is 1. But in glass a smaller field carries the same power, and the beam there is wider.",
            },
            Misled {
                value: |_| amplitudes(Incidence::NORMAL, 1.0, 1.5.into()).t_p.re,
                reply: "That is along the normal.",
            },
            Misled { value: |_| 1.5, reply: "In the denser medium the field is smaller, not larger." },
        ],
    },
    "1/n = 0.667: with T = 1, since the power counts n cos θ as well as t².",
);

/// E36
pub(super) fn r_s() -> Expr {
    -(sin(THETA_1 - THETA_2) / sin(THETA_1 + THETA_2))
}

/// E37
pub(super) fn t_s() -> Expr {
    2 * sin(THETA_2) * cos(THETA_1) / sin(THETA_1 + THETA_2)
}

/// E39
pub(super) fn r_p() -> Expr {
    tan(THETA_1 - THETA_2) / tan(THETA_1 + THETA_2)
}

/// E40
pub(super) fn t_p() -> Expr {
    2 * sin(THETA_2) * cos(THETA_1) / (sin(THETA_1 + THETA_2) * cos(THETA_1 - THETA_2))
}

/// (a − b)/(a + b), the form in which the boundary conditions give both reflected waves.
pub(super) fn contrast(near: Expr, far: Expr) -> Expr {
    (&near - &far) / (near + far)
}

/// The amplitudes under the boundary conditions and Snell's law.
fn solved(polarisation: Polarisation) -> Chain {
    with_snell(bounded(polarisation)).solve_for([E_1R, E_2])
}

fn s_chain(last: Expr) -> Chain {
    solved(Polarisation::S)
        .then(Equation::new(E_1R / E_1, contrast(N_1 * cos(THETA_1), N_2 * cos(THETA_2))), ["linear solve"])
        .find(last)
}

fn t_s_chain(last: Expr) -> Chain {
    let (near, far) = (N_1 * cos(THETA_1), N_2 * cos(THETA_2));
    solved(Polarisation::S).then(Equation::new(E_2 / E_1, 2 * &near / (&near + far)), ["linear solve"]).find(last)
}

fn p_chain(last: Expr) -> Chain {
    solved(Polarisation::P)
        .then(Equation::new(E_1R / E_1, contrast(N_2 * cos(THETA_1), N_1 * cos(THETA_2))), ["linear solve"])
        .find(last)
}

fn t_p_chain(last: Expr) -> Chain {
    let (near, far) = (N_2 * cos(THETA_1), N_1 * cos(THETA_2));
    solved(Polarisation::P)
        .then(Equation::new(E_2 / E_1, 2 * N_1 * cos(THETA_1) / (near + far)), ["linear solve"])
        .find(last)
}

/// r_s by the angle of incidence [rad] and both indices, below the critical angle.
fn programs_r_s(theta: f64, n_i: f64, n_t: f64) -> f64 {
    amplitudes(Incidence::from_angle(theta), n_i, n_t.into()).r_s.re
}

fn against_equation(bench: &mut Bench, equation: &Expr, ratio: fn(&Amplitudes) -> Complex64, at: usize) -> Measured {
    let program = |theta, n_i, n_t: f64| ratio(&amplitudes(Incidence::from_angle(theta), n_i, n_t.into())).re;
    held_against(bench, equation, program, at)
}

/// Error of a ratio against `equation`, in units of ulp · (1 + cond); `at` is the place of its real part among
/// the reference's outputs, for cond. Angles and indices at random, and the setting's own.
fn held_against(bench: &mut Bench, equation: &Expr, ratio: impl Fn(f64, f64, f64) -> f64, at: usize) -> Measured {
    let own = interface(bench.setting());
    let mut inputs: Vec<(f64, f64, f64)> = (0..16)
        .map(|_| {
            let (n_i, n_t) = (uniform(&mut bench.stream, 1.0, 2.0), uniform(&mut bench.stream, 1.0, 4.0));
            let most = critical_angle(n_i, n_t).unwrap_or(FRAC_PI_2);
            (uniform(&mut bench.stream, 0.02, 0.98) * most, n_i, n_t)
        })
        .collect();
    let theta = bench.setting().number("theta");
    let propagates = critical_angle(own.n_i, own.n_t.re).is_none_or(|critical| theta < critical);
    // At normal incidence the equation itself is 0/0, and a metal's θ₂ is beyond this route: `digits` covers both.
    if own.n_t.im == 0.0 && own.n_t.re != own.n_i && theta > 0.0 && propagates {
        inputs.push((theta, own.n_i, own.n_t.re));
    }
    Measured::worst(inputs.into_iter().map(|(theta, n_i, n_t)| {
        let input = clear(Direction::Angle(theta), n_i, n_t);
        let mut bindings = Bindings::new();
        for (symbol, value) in [(N_1, n_i), (N_2, n_t), (THETA_1, theta)] {
            bindings.bind(symbol.name(), precise::from_real(precise::real(value)));
        }
        bindings.define(&THETA_2, asin(N_1 * sin(THETA_1) / N_2));
        let program = ratio(theta, n_i, n_t);
        let exact = equation.evaluate(&bindings);
        let error = exact.map_or(f64::NAN, |exact| precise::relative_error(program, &exact.into_parts().0));
        let condition = Exact::new(&input).conditions()[at];
        (error / (f64::EPSILON * (1.0 + condition)), extremes::describe(&input))
    }))
}

fn readout(
    setting: &Setting,
    keys: [&'static str; 2],
    symbols: [&'static str; 2],
    ratio: fn(&Amplitudes) -> Complex64,
) -> Vec<Quantity> {
    let input = interface(setting);
    let value = ratio(&amplitudes(incidence(setting), input.n_i, input.n_t));
    let parts = [
        (keys[0], symbols[0], "in phase with the incident field", value.re),
        (keys[1], symbols[1], "a quarter period off", value.im),
    ];
    parts.into_iter().map(|(key, symbol, says, value)| Quantity { key, symbol, says, value, unit: "1" }).collect()
}

fn clear(direction: Direction, n_i: f64, n_t: f64) -> Input {
    Input { direction, n_i, n_t: n_t.into() }
}

/// The inputs at which the formulas as written fail, after the setting's own.
fn hard_inputs(setting: &Setting) -> Vec<Input> {
    let mut inputs = vec![interface(setting)];
    inputs.extend([
        clear(Direction::Angle(0.0), 1.0, 1.5),
        clear(Direction::Angle(1e-12), 1.0, 1.5),
        clear(Direction::Angle(1e-160), 1.5, 1.0),
        clear(Direction::Angle(0.7), 1.0, 1.0 + 1e-15),
        clear(Direction::Angle(0.7), 1.0, 1.0 + 1e-9),
        clear(Direction::Angle(FRAC_PI_2 - 1e-12), 1.0, 1.5),
        clear(Direction::Grazing(1e-30), 1.0, 1.5),
        clear(Direction::Grazing(1e-9), 1.0, 1.0 + 1e-12),
        clear(Direction::Angle(0.5), 1.0, 1e6),
        clear(Direction::Angle(1e-7), 1.0, 1e-6),
    ]);
    inputs
}

type Curve = (&'static str, Hue, fn(&Amplitudes) -> Complex64);

fn curves(setting: &Setting, title: &str, ratios: &[Curve]) -> Plot {
    let input = interface(setting);
    Plot::of(title, chart(input.n_i, input.n_t, ratios))
}

/// The ratios as they are where they are real; real part and modulus where they are not.
fn chart(n_i: f64, n_t: Complex64, ratios: &[Curve]) -> Chart {
    let title = media(n_i, n_t);
    let critical = if n_t.im == 0.0 { critical_angle(n_i, n_t.re) } else { None };
    let everywhere_real = n_t.im == 0.0 && critical.is_none();
    let mut chart = Chart::new(
        title,
        Axis::linear("angle of incidence θ_1", "°").range(0.0, 90.0).tick(15.0),
        Axis::linear("field over incident field", ""),
    );
    for &(name, hue, ratio) in ratios {
        let curve = |part: fn(Complex64) -> f64| match critical {
            Some(critical) => {
                over_angle_near(critical.to_degrees(), |incidence| part(ratio(&amplitudes(incidence, n_i, n_t))))
            }
            None => over_angle(|incidence| part(ratio(&amplitudes(incidence, n_i, n_t)))),
        };
        if everywhere_real {
            chart = chart.line(hue, name, curve(|z| z.re));
        } else {
            chart = chart.line(hue, format!("Re {name}"), curve(|z| z.re)).dashed(
                hue,
                format!("|{name}|"),
                curve(|z| z.norm()),
            );
        }
    }
    if n_t.im == 0.0 && ratios.iter().any(|(name, ..)| *name == "r_p") && n_t.re != n_i {
        chart = chart.at_x(brewster_angle(n_i, n_t.re).to_degrees(), "θ_B");
    }
    if let Some(critical) = critical {
        chart = chart.at_x(critical.to_degrees(), "θ_c");
    }
    chart.at_y(0.0, "")
}

fn both_ways(setting: &Setting) -> Plot {
    let all: [Curve; 4] = [
        ("r_s", Hue::S, |a| a.r_s),
        ("r_p", Hue::P, |a| a.r_p),
        ("t_s", Hue::Transmitted, |a| a.t_s),
        ("t_p", Hue::Natural, |a| a.t_p),
    ];
    let input = interface(setting);
    let mut panels = vec![chart(input.n_i, input.n_t, &all).into()];
    if input.n_t.im == 0.0 {
        panels.push(chart(input.n_t.re, Complex64::from(input.n_i), &all).into());
    }
    let columns = panels.len();
    Plot::grid("Amplitude ratios with their signs", columns, panels)
}
