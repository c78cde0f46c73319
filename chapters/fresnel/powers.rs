//! E41: what share of the power goes each way.

use super::boundary::{with_fields, with_impedance};
use super::extremes::{cases, describe};
use super::fields::{flow, waves};
use super::symbols::{E_1, E_1R, E_2, ELECTRIC, MAGNETIC, N_1, N_2, NORMAL, R_S, T_P, T_S, THETA_1, THETA_2, Z_0};
use super::{INTERFACE, incidence, interface, sample_inputs};
use crate::parameter::Setting;
use crate::vocabulary::{
    Bench, Check, Exhibit, Measured, Quantity, Step, check, derivation, exhibit, statement, step, stress,
};
use equation::derivation::Chain;
use equation::expr::{abs, cos, cross, dot};
use equation::{Dimension, Equation, Expr, Symbol};
use light::Polarisation;
use light::optics::fresnel::{Amplitudes, Powers, amplitudes, powers};
use light::optics::{Direction, Incidence};
use light::references::fresnel::Input;

const REFLECTANCE: Symbol = Symbol::scalar("R", Dimension::ONE);
const TRANSMITTANCE: Symbol = Symbol::scalar("T", Dimension::ONE);
const S_I: Symbol = Symbol::vector("S_i", Dimension::WATT_PER_SQUARE_METRE);
const S_R: Symbol = Symbol::vector("S_r", Dimension::WATT_PER_SQUARE_METRE);
const S_T: Symbol = Symbol::vector("S_t", Dimension::WATT_PER_SQUARE_METRE);

pub(super) const EXHIBIT: Exhibit = exhibit("powers", INTERFACE, &[]);

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
