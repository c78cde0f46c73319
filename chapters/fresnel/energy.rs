//! E43: nothing is lost at a clear interface.

use super::amplitudes::{r_p, r_s, t_p, t_s};
use super::extremes::{self, cases_against, describe};
use super::geometry::depth;
use super::snell::with_snell;
use super::symbols::{N_1, N_2, R_N, R_P, R_S, T_P, T_S, THETA_1, THETA_2};
use super::{INTERFACE, incidence, interface};
use crate::diagram::{Behind, Diagram, Part};
use crate::figure::{Dash, Hue, Plot};
use crate::parameter::Setting;
use crate::vocabulary::{
    ALLOWED_ULPS, Answer, Bench, Check, Exhibit, Extreme, Measured, Quantity, Question, Step, check, choice,
    derivation, exhibit, figure, question, statement, step, stress,
};
use equation::derivation::Chain;
use equation::expr::{asin, cos, sin};
use equation::value::Bindings;
use equation::{Dimension, Equation, Expr, Symbol};
use light::Complex64;
use light::optics::Direction;
use light::optics::Incidence;
use light::optics::fresnel::{critical_angle, powers};
use light::references::fresnel::{Exact, Input, NAMES};
use std::f64::consts::FRAC_PI_2;
use yardstick::precise;

const T_N: Symbol = Symbol::scalar("T_n", Dimension::ONE);

pub(super) const EXHIBIT: Exhibit = exhibit(
    "energy",
    INTERFACE,
    &[figure(
        "box",
        "A flat box about the interface: it can keep nothing, so what enters it leaves it. Areas are shares of the power.",
        flat_box,
    )],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "What is not reflected is transmitted",
    "At a clear interface the two shares make one, for s, for p and for natural light.",
)
.rows(&["E43"])
.statements(&[statement("balance", "energy is conserved", || Equation::new(R_N + T_N, Expr::from(1)))])
.questions(&[INTO_GOLD])
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

const INTO_GOLD: Question = question(
    "into_gold",
    "Gold reflects a part of the light and swallows the rest. At its surface, what is R + T?",
    Answer::Choice {
        options: &[
            choice(
                "R alone, since nothing comes through gold",
                "T counts what crosses the *surface*. How far it gets behind it is not asked here.",
            ),
            choice(
                "less than 1, by what is swallowed",
                "It is swallowed in the depth of the gold. The surface has none, and swallows nothing.",
            ),
            choice("1", ""),
        ],
        right: |_| {
            let gold = powers(Incidence::from_angle(45f64.to_radians()), 1.0, Complex64::new(0.42, 2.47));
            match gold.r_n() + gold.t_n() {
                sum if (sum - 1.0).abs() < 1e-12 => 2,
                sum if (sum - gold.r_n()).abs() < 1e-12 => 0,
                _ => 1,
            }
        },
        slip: |_| 1,
    },
    "One, at every interface: it is too thin to keep anything. T is what goes in, whatever becomes of it.",
);

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

const R_PLUS_T: Check<fn() -> Expr> =
    check("r_plus_t", "R + T = 1 at every angle, into the glass and out of it, for s, p and natural light")
        .against("1 − T of E37, E40 and E41 as they stand on the page, with θ₂ by Snell's law, in 256-bit arithmetic")
        .within(
            ALLOWED_ULPS,
            "ulp · (1 + cond)",
            "of R: the project's promise, no more than a few roundings beyond what the inputs' own rounding does",
        )
        .of::<fn() -> Expr>(|bench, weight| what_is_missing(bench, &weight()), weight)
        .slip("T taken as |t|²", || Expr::from(1));

/// Error of the program's R against 1 − T, T with `weight` times t² of the page. (For R and T of the program alone their
/// sum would tell roundings only: it is 1 for any normal wave number behind the interface.)
fn what_is_missing(bench: &mut Bench, weight: &Expr) -> Measured {
    let shares = [t_s(), t_p()].map(|ratio| weight * ratio.pow(2));
    Measured::worst(clear_inputs(bench.setting()).iter().flat_map(|input| {
        let mut bindings = Bindings::new();
        let Direction::Angle(theta) = input.direction else { unreachable!("given by their angle") };
        for (symbol, value) in [(N_1, input.n_i), (N_2, input.n_t.re), (THETA_1, theta)] {
            bindings.bind(symbol.name(), precise::from_real(precise::real(value)));
        }
        bindings.define(&THETA_2, asin(N_1 * sin(THETA_1) / N_2));
        let one = || precise::real(1.0);
        let [s, p] =
            shares.each_ref().map(|share| share.evaluate(&bindings).ok().map(|share| one() - share.into_parts().0));
        let natural = s.as_ref().zip(p.as_ref()).map(|(s, p)| (s + p) * precise::real(0.5));
        let found = powers(input.direction.into(), input.n_i, input.n_t);
        let conditions = Exact::new(input).conditions();
        let all = [("R_s", found.r_s, s), ("R_p", found.r_p, p), ("R_n", found.r_n(), natural)];
        all.map(|(name, found, missing)| {
            let at = NAMES.iter().position(|known| *known == name).expect("an output");
            let error = missing.map_or(f64::NAN, |missing| precise::relative_error(found, &missing));
            (error / (f64::EPSILON * (1.0 + conditions[at])), format!("{name}, {}", describe(input)))
        })
    }))
}

/// Clear media at angles from beside the normal, where the page's formulas are 0/0, to grazing or the critical angle, and
/// the setting's own.
fn clear_inputs(setting: &Setting) -> Vec<Input> {
    let own = interface(setting);
    let indices = [0.01, 0.3, 0.75, 1.0 - 1e-12, 1.0 + 1e-12, 1.33, 1.5, 2.4, 4.0, 100.0];
    let mut pairs = indices.map(|n_t| (1.0, n_t)).to_vec();
    let is_interface = own.n_t.im == 0.0 && own.n_t.re != own.n_i;
    pairs.extend(is_interface.then_some((own.n_i, own.n_t.re)));
    let shares = [1e-9, 0.02, 0.3, 0.6, 0.9, 0.999, 1.0 - 1e-6, 1.0 - 1e-12];
    let fan = pairs.into_iter().flat_map(|(n_i, n_t)| {
        let most = critical_angle(n_i, n_t).unwrap_or(FRAC_PI_2);
        shares.map(move |share| Input { direction: Direction::Angle(share * most), n_i, n_t: n_t.into() })
    });
    let theta = setting.number("theta");
    let propagates = critical_angle(own.n_i, own.n_t.re).is_none_or(|critical| theta < critical);
    fan.chain((is_interface && propagates && theta > 0.0).then_some(own)).collect()
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

/// The flows through a flat box, each as wide as its share.
fn flat_box(setting: &Setting) -> Plot {
    let input = interface(setting);
    let shares = powers(incidence(setting), input.n_i, input.n_t);
    let (wide, high) = (1.5, 1.0);
    // A block of an arrow: as wide as its share, and at least a line.
    let block = |x: f64, share: f64, from: f64, to: f64, hue: Hue, label: String| -> Vec<Part> {
        let half = 0.4 * share;
        let edges = [-half, half].map(|side| Part::line([x + side, from], [x + side, to]).hue(hue));
        let arrow = Part::ray([x, from], [x, to]).hue(hue).label(label);
        edges.into_iter().chain([arrow]).collect()
    };
    let diagram = Diagram::new("", [-wide, -high], [wide, high])
        .with(Part::surface([wide, 0.0], [-wide, 0.0], Behind::Tinted(depth(input.n_i))))
        .with(Part::surface([-wide, 0.0], [wide, 0.0], Behind::Tinted(depth(input.n_t.re))))
        .with(
            Part::curve(vec![[-1.3, -0.12], [1.3, -0.12], [1.3, 0.12], [-1.3, 0.12], [-1.3, -0.12]])
                .hue(Hue::Reference)
                .dash(Dash::Dashed),
        )
        .with_all(block(-0.75, 1.0, 0.85, 0.15, Hue::Natural, "1".into()))
        .with_all(block(0.55, shares.r_n(), 0.15, 0.85, Hue::Ours, format!("R_n = {:.3}", shares.r_n())))
        .with_all(block(-0.1, shares.t_n(), -0.15, -0.85, Hue::Transmitted, format!("T_n = {:.3}", shares.t_n())));
    Plot::of("What enters a flat box leaves it", diagram)
}
