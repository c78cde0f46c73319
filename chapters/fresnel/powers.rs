//! E41: what share of the power goes each way.

use super::boundary::{with_fields, with_impedance};
use super::extremes::{cases, describe};
use super::fields::{flow, waves};
use super::geometry::depth;
use super::symbols::{E_1, E_1R, E_2, ELECTRIC, MAGNETIC, N_1, N_2, NORMAL, R_S, T_P, T_S, THETA_1, THETA_2, Z_0};
use super::{INTERFACE, incidence, interface, sample_inputs};
use crate::diagram::{Behind, Diagram, Part};
use crate::figure::{Dash, Hue, Plot};
use crate::parameter::Setting;
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Misled, Quantity, Question, Step, check, derivation, exhibit, figure,
    question, statement, step, stress,
};
use equation::derivation::Chain;
use equation::expr::{abs, cos, cross, dot};
use equation::{Dimension, Equation, Expr, Symbol};
use light::Polarisation;
use light::optics::fresnel::{Amplitudes, Powers, amplitudes, powers, refract};
use light::optics::{Direction, Incidence};
use light::references::fresnel::Input;

const REFLECTANCE: Symbol = Symbol::scalar("R", Dimension::ONE);
const TRANSMITTANCE: Symbol = Symbol::scalar("T", Dimension::ONE);
const S_I: Symbol = Symbol::vector("S_i", Dimension::WATT_PER_SQUARE_METRE);
const S_R: Symbol = Symbol::vector("S_r", Dimension::WATT_PER_SQUARE_METRE);
const S_T: Symbol = Symbol::vector("S_t", Dimension::WATT_PER_SQUARE_METRE);

pub(super) const EXHIBIT: Exhibit = exhibit(
    "powers",
    INTERFACE,
    &[figure(
        "beams",
        "One patch of the interface and the three beams on it: it is as wide as a cos θ that each flow counts.",
        beams,
    )],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Shares of the power",
    "Power through the interface counts the normal component of the energy flow: T is not |t|².",
)
.rows(&["E41"])
.statements(&[
    statement("reflectance", "reflected share, as magnitudes: the reflected flow runs backwards", || {
        Equation::new(REFLECTANCE, abs(dot(NORMAL, S_R)) / abs(dot(NORMAL, S_I)))
    }),
    statement("transmittance", "transmitted share", || {
        Equation::new(TRANSMITTANCE, abs(dot(NORMAL, S_T)) / abs(dot(NORMAL, S_I)))
    }),
    statement(
        "from_amplitudes",
        "between clear media: slower light carries more power per field, in a narrower or wider beam",
        || Equation::new(TRANSMITTANCE, N_2 * cos(THETA_2) / (N_1 * cos(THETA_1)) * T_S.pow(2)),
    ),
])
.questions(&[NOT_T_SQUARED])
.derivations(&[
    derivation(
        "reflected_from_poynting",
        "the flow of the reflected wave through the interface over the incident one's, with the sign turned",
        || reflected(R_S.pow(2)),
    )
    .slip("one normal for both flows, without the magnitude", || reflected(-R_S.pow(2))),
    derivation("from_poynting", "the flow of the transmitted wave over the incident one's, s", || {
        transmitted(Polarisation::S, T_S, N_2 * cos(THETA_2) / (N_1 * cos(THETA_1)) * T_S.pow(2))
    })
    .slip("T taken as t²", || transmitted(Polarisation::S, T_S, T_S.pow(2))),
    derivation("from_poynting_p", "the same for p, whose fields stand otherwise", || {
        transmitted(Polarisation::P, T_P, N_2 * cos(THETA_2) / (N_1 * cos(THETA_1)) * T_P.pow(2))
    })
    .slip("the index is forgotten", || transmitted(Polarisation::P, T_P, cos(THETA_2) / cos(THETA_1) * T_P.pow(2))),
])
.readout(readout)
.checks(&[&FLOW])
.stress(&[stress(
    "grazing",
    "R and T keep their digits at grazing incidence, normal incidence and near equal indices",
    |setting| cases(&["R_s", "T_s", "R_p", "T_p"], &hard_inputs(setting)),
)
.textbook("|r|² and (n₂cosθ₂/n₁cosθ₁)|t|² from the angles")
.against("the amplitudes in 256 bits")]);

const NOT_T_SQUARED: Question = question(
    "not_t_squared",
    "From glass of n = 1.5 into air, along the normal, t is 1.2. Which share of the power goes on?",
    Answer::Number {
        unit: "1",
        tolerance: 0.01,
        right: |_| powers(Incidence::NORMAL, 1.5, 1.0.into()).t_s,
        slips: &[
            Misled {
                value: |_| amplitudes(Incidence::NORMAL, 1.5, 1.0.into()).t_s.norm_sqr(),
                reply: "t² is the ratio of the fields' squares. More than came cannot go on: in air the same field \
                 carries less.",
            },
            Misled { value: |_| 1.2, reply: "That is the ratio of the fields." },
        ],
    },
    "0.96, which is t²/1.5: the flow of a wave is as n E².",
);

/// `chain` with the mean flows of real fields, S = ½ E×H.
fn with_flows(chain: Chain, polarisation: Polarisation) -> Chain {
    let fields = ELECTRIC.into_iter().zip(MAGNETIC);
    let chain = [S_I, S_R, S_T].into_iter().zip(fields).fold(chain, |chain, (flow, (electric, magnetic))| {
        chain.given(flow, cross(electric, magnetic) / 2, "⟨S⟩ = ½ E×H")
    });
    with_impedance(with_fields(chain, polarisation))
}

/// n·S of a wave in a medium of index `n` at `angle` to the normal.
fn normal_flow(n: Symbol, field: Symbol, angle: Symbol) -> Expr {
    n * field.pow(2) / (2 * Z_0) * cos(angle)
}

fn reflected(last: Expr) -> Chain {
    with_flows(Chain::new(-(dot(NORMAL, S_R) / dot(NORMAL, S_I))), Polarisation::S)
        .because("|n·S_r| over |n·S_i|: S_r runs against n")
        .given(E_1R, R_S * E_1, "definition of r")
        .then(normal_flow(N_1, E_1R, THETA_1) / normal_flow(N_1, E_1, THETA_1), ["⟨S⟩ = ½ E×H", "H = nE/Z₀"])
        .then(last, ["definition of r", "cancel the incident flow"])
}

fn transmitted(polarisation: Polarisation, ratio: Symbol, last: Expr) -> Chain {
    with_flows(Chain::new(dot(NORMAL, S_T) / dot(NORMAL, S_I)), polarisation)
        .because("n·S_t over n·S_i")
        .given(E_2, ratio * E_1, "definition of t")
        .then(normal_flow(N_2, E_2, THETA_2) / normal_flow(N_1, E_1, THETA_1), ["⟨S⟩ = ½ E×H", "H = nE/Z₀"])
        .then(last, ["definition of t", "cancel E₁² and 2 Z₀"])
}

fn readout(setting: &Setting) -> Vec<Quantity> {
    let input = interface(setting);
    let Powers { r_s, t_s, r_p, t_p } = powers(incidence(setting), input.n_i, input.n_t);
    let all = [
        ("R_s", "R_s", "reflected, s", r_s),
        ("T_s", "T_s", "transmitted, s", t_s),
        ("R_p", "R_p", "reflected, p", r_p),
        ("T_p", "T_p", "transmitted, p", t_p),
    ];
    all.map(|(key, symbol, says, value)| Quantity { key, symbol, says, value, unit: "1" }).into()
}

const FLOW: Check<fn(&Amplitudes, Powers) -> Powers> =
    check("flow", "R and T are the normal flows of energy, reflected and transmitted over incident")
        .against("Re(E×H*) of the three waves' field vectors, normal component")
        .within(32.0, "ulp", "two dozen roundings in the fields and their products")
        .of(against_flow, |_, powers| powers)
        .slip("T taken as |t|²", |a, powers| Powers { t_s: a.t_s.norm_sqr(), t_p: a.t_p.norm_sqr(), ..powers });

fn against_flow(bench: &mut Bench, amend: fn(&Amplitudes, Powers) -> Powers) -> Measured {
    Measured::worst(sample_inputs(bench.setting()).iter().flat_map(|input| {
        let incidence = Incidence::from(input.direction);
        let a = amplitudes(incidence, input.n_i, input.n_t);
        let powers = amend(&a, powers(incidence, input.n_i, input.n_t));
        let shares = [(Polarisation::S, powers.r_s, powers.t_s), (Polarisation::P, powers.r_p, powers.t_p)];
        shares.into_iter().flat_map(move |(polarisation, r, t)| {
            let [incident, reflected, transmitted] =
                waves(polarisation, incidence, input.n_i, input.n_t, &a).map(|wave| flow(&wave));
            [("R", r + reflected / incident), ("T", t - transmitted / incident)].map(|(name, difference)| {
                (difference / f64::EPSILON, format!("{name}, {polarisation:?}, {}", describe(input)))
            })
        })
    }))
}

fn hard_inputs(setting: &Setting) -> Vec<Input> {
    let clear = |direction, n_i: f64, n_t: f64| Input { direction, n_i, n_t: n_t.into() };
    vec![
        interface(setting),
        clear(Direction::Angle(0.0), 1.0, 1.5),
        clear(Direction::Angle(0.7), 1.0, 1.0 + 1e-12),
        clear(Direction::Grazing(1e-20), 1.0, 1.5),
        clear(Direction::Grazing(1e-9), 1.5, 1.5 + 1e-12),
        clear(Direction::Angle(0.3), 1.0, 1e6),
        Input { direction: Direction::Grazing(1e-12), n_i: 1.0, n_t: light::Complex64::new(0.2, 3.4) },
    ]
}

/// Half of the patch that is lit.
const PATCH: f64 = 0.32;

/// The beams on a patch of the interface.
fn beams(setting: &Setting) -> Plot {
    let (n_i, n_t) = (setting.index("n_i").re, setting.index("n_t"));
    let incidence = Incidence::from_angle(setting.number("theta").clamp(0.35, 1.1));
    let (sin, cos) = (incidence.sin(), incidence.cos());
    let behind = if n_t.im == 0.0 { refract(incidence, n_i, n_t.re) } else { None };
    let shares = powers(incidence, n_i, n_t);
    let (wide, high) = (1.7, 1.05);
    let mut diagram = Diagram::new("", [-wide, -high], [wide, high])
        .with(Part::surface([wide, 0.0], [-wide, 0.0], Behind::Tinted(depth(n_i))))
        .with(Part::surface([-wide, 0.0], [wide, 0.0], Behind::Tinted(depth(n_t.re))))
        .with_all(beam([-sin, cos], true, "S_i", Hue::Natural))
        .with_all(beam([sin, cos], false, "S_r", Hue::Natural));
    if let Some((sin, cos)) = behind {
        diagram = diagram.with_all(beam([sin, -cos], false, "S_t", Hue::Transmitted));
    }
    let through = format!("T_s = {:.3}, T_p = {:.3}", shares.t_s, shares.t_p);
    let diagram = diagram
        .with(Part::ray_with_heads([-PATCH, 0.0], [PATCH, 0.0], &[]).label("a"))
        .with(Part::note([-1.65, 0.92], format!("θ_1 = {:.1}°", sin.atan2(cos).to_degrees())))
        .with(Part::note([-1.65, -0.92], through));
    Plot::of("Beams on a patch of the interface", diagram)
}

/// Edges, width and flow of the beam that leaves the patch by `way`, or comes from there.
fn beam(way: [f64; 2], comes: bool, name: &str, hue: Hue) -> Vec<Part> {
    let along = |from: f64, share: f64| [from + share * way[0], share * way[1]];
    let edge = |from: f64| Part::line(along(from, 0.0), along(from, 0.95)).hue(hue).dash(Dash::Dashed);
    let (tip, end) = if comes { (along(0.0, 0.4), along(0.0, 0.85)) } else { (along(0.0, 0.85), along(0.0, 0.4)) };
    // Across the beam, from one of its edges to the other.
    let cosine = way[1].abs();
    let shift = 2.0 * PATCH * way[0];
    let nearer = 0.3 - shift.min(0.0);
    let (near, far) = (along(PATCH, nearer), along(-PATCH, nearer + shift));
    let width = Part::line(near, far).hue(Hue::Reference);
    let width = if cosine > 0.25 && !comes { width.label(format!("{name}: a · {cosine:.2}")) } else { width };
    vec![edge(-PATCH), edge(PATCH), width, Part::vector(end, tip).hue(hue).label(name)]
}
