//! C22: paths that end too early.

use super::scenes::{closed, greens, rendered};
use super::symbols::{L, L_D, L_E, L_SHORT, RHO};
use crate::figure::{Axis, Chart, Hue, Mark, Plot, Shape};
use crate::parameter::{Kind, Parameter, Setting};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Extreme, Measured, Misled, Quantity, Step, check, derivation, exhibit, figure,
    question, statement, step, stress,
};
use equation::derivation::Chain;
use equation::{Equation, Expr};
use light::transport::simple::INTEGRATORS;
use light::transport::{Manner, Method, enclosure};
use yardstick::precise::{self, Real};

const RHO_SET: Parameter =
    Parameter::new("rho", "ρ", "share of the light that the walls return", Kind::number(0.0, 1.0 - 1e-6, "1"))
        .default("0.8");
const DEPTH: Parameter =
    Parameter::new("depth", "d", "the most edges of a path", Kind::Count { min: 1, max: 10_000 }).default("5");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "depth",
    &[RHO_SET, DEPTH],
    &[figure("missing", "What paths of at most d edges miss of a closed room's light: ρ to the d-th.", missing)],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Paths that end too early",
    "A limit of d edges loses the light of all longer paths: in a closed room ρ^d of it, which no number of paths brings back.",
)
.rows(&["C22"])
.statements(&[
    statement("closed", "in a closed room that shines and reflects alike everywhere, what arrives is what leaves", || {
        Equation::new(L, L_E + RHO * L)
    }),
    statement("limited", "with one edge more, paths see what those with one less saw, reflected once", || {
        Equation::new(L_D, L_E + RHO * L_SHORT)
    }),
])
.derivations(&[
    derivation("brightness", "the brightness of the closed room", || brightness(L_E / (1 - RHO)))
        .slip("ρ with the wrong sign", || brightness(L_E / (1 + RHO))),
    derivation("factor", "each edge more leaves ρ of what was missing", || factor(RHO * (L - L_SHORT)))
        .slip("as if it left 1 − ρ of it", || factor((1 - RHO) * (L - L_SHORT))),
])
.questions(&[question(
    "edges",
    "White walls return 80 % of the light. How many edges must paths be allowed, in a room that glows all over, to lose less than one per cent of the light?",
    Answer::Number {
        unit: "1",
        tolerance: 0.1,
        right: |_| (1..).find(|edges| enclosure::missing(0.2, *edges) < 0.01).map_or(f64::NAN, f64::from),
        slips: &[
            Misled { value: |_| 5.0, reply: "1/(1 − ρ) = 5 is how many edges paths have on average; a third of the light is in longer ones." },
            Misled { value: |_| 100.0, reply: "The loss falls faster than 1/d: as ρ^d." },
        ],
    },
    "0.8²¹ is just below 0.01: ln 100 divided by ln 1.25.",
)])
.readout(|setting| {
    let (absorbed, edges) = (1.0 - setting.number("rho"), setting.number("depth") as u32);
    let quantity = |key, symbol, says, value| Quantity { key, symbol, says, value, unit: "1" };
    vec![
        quantity("all", "L/L_e", "brightness of the room", 1.0 / absorbed),
        quantity("limited", "L_d/L_e", "by paths of at most d edges", enclosure::radiance(absorbed, edges)),
        quantity("missing", "ρ^d", "share that is missing", enclosure::missing(absorbed, edges)),
    ]
})
.checks(&[&SERIES])
.stress(&[stress("white", "walls that absorb hardly anything, and paths of ten thousand edges", |_| whites(enclosure::radiance))
    .own(|subject| subject.downcast_ref::<fn(f64, u32) -> f64>().map(whites))
    .textbook("(1 − ρ^d)/(1 − ρ), with ρ = 1 − a in f64")
    .against("the same in arbitrary precision")]);

fn brightness(last: Expr) -> Chain {
    Chain::assume(Equation::new(L, L_E + RHO * L), "what arrives is what leaves")
        .solve_for([L])
        .then(Equation::new(L, last), ["linear solve"])
}

fn factor(last: Expr) -> Chain {
    Chain::assume(Equation::new(L, L_E + RHO * L), "what arrives is what leaves")
        .and(Equation::new(L_D, L_E + RHO * L_SHORT), "one edge more")
        .solve_for([L, L_D])
        .then(Equation::new(L - L_D, last), ["linear solve", "factor ρ"])
}

const SERIES: Check<fn(f64, u32) -> f64> = check(
    "series",
    "pictures of a closed room by paths of at most d edges are as bright as d terms of the series, from d = 1 to 10 000",
)
.against("(1 − ρ^d)/(1 − ρ), against the renderer's pixels; paths drawn by the cosine do not scatter in this room")
.within(1e-6, "1", "pixels are sums in f32, of sixteen paths in five levels: five roundings of 6e-8, and the mean's")
.of(
    |bench: &mut Bench, radiance: fn(f64, u32) -> f64| {
        let given = (1.0 - bench.setting().number("rho"), bench.setting().number("depth") as u32);
        let cases = [(0.2, 1), (0.2, 2), (0.2, 5), (0.5, 20), (0.01, 300), (1e-6, 10_000), given];
        Measured::worst(cases.map(|(absorbed, edges)| {
            let manner = Manner { method: Method::Simple(&INTEGRATORS[1]), ..Manner::default() };
            let pixels = greens(&rendered(&closed(absorbed, Some(edges), 1), &manner, 8));
            (pixels.mean() / radiance(absorbed, edges) - 1.0, format!("1 − ρ = {absorbed:e}, d = {edges}"))
        }))
    },
    enclosure::radiance as fn(f64, u32) -> f64,
)
.slip("the edge from the camera not counted", |absorbed, edges| enclosure::radiance(absorbed, edges + 1));

fn whites(program: impl Fn(f64, u32) -> f64) -> Vec<Extreme> {
    let cases = [0.5, 1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 1e-18]
        .into_iter()
        .flat_map(|absorbed| [1, 16, 10_000].map(|d| (absorbed, d)));
    cases
        .map(|(absorbed, edges): (f64, u32)| {
            let (a, one) = (precise::real_at(absorbed, 1024), precise::real_at(1.0, 1024));
            let rho = 1.0 - absorbed;
            Extreme {
                input: format!("a = {absorbed:e}, d = {edges}"),
                quantity: "L_d/L_e",
                reference: (&one - power(&one - &a, edges)) / &a,
                textbook: (1.0 - rho.powi(edges as i32)) / (1.0 - rho),
                ours: program(absorbed, edges),
                // a·∂ ln L/∂a is between −1 and 0.
                condition: 1.0,
                worst_of: 1,
            }
        })
        .collect()
}

/// By squares.
fn power(base: Real, exponent: u32) -> Real {
    let (mut result, mut square, mut left) = (precise::real_at(1.0, 1024), base, exponent);
    while left > 0 {
        if left % 2 == 1 {
            result *= &square;
        }
        square = &square * &square;
        left /= 2;
    }
    result
}

fn missing(setting: &Setting) -> Plot {
    let (rho, depth) = (setting.number("rho"), setting.number("depth") as u32);
    let curve = |rho: f64| -> Vec<[f64; 2]> {
        (1..=64).map(|edges| [f64::from(edges), enclosure::missing(1.0 - rho, edges)]).collect()
    };
    let manner = Manner { method: Method::Simple(&INTEGRATORS[1]), ..Manner::default() };
    let found = [1, 2, 4, 8, 16, 24, 32, 48, 64].map(|edges| {
        let pixels = greens(&rendered(&closed(1.0 - rho, Some(edges), 1), &manner, 8));
        [f64::from(edges), 1.0 - (1.0 - rho) * pixels.mean()]
    });
    let mut chart = Chart::new(
        "",
        Axis::linear("most edges of a path d", "").range(1.0, 64.0),
        Axis::log("share of the light that is missing", "").range(1e-3, 1.0),
    );
    for (k, rho) in [0.5, 0.95].into_iter().enumerate() {
        chart = chart.line(Hue::Nth(k as u8), format!("ρ = {rho}"), curve(rho));
    }
    chart = chart.line(Hue::Ours, format!("ρ = {rho}"), curve(rho)).with(Mark::Points {
        label: format!("rendered, ρ = {rho}"),
        hue: Hue::Ours,
        shape: Shape::Disc,
        joined: false,
        points: found.into(),
    });
    let own = [f64::from(depth), enclosure::missing(1.0 - rho, depth)];
    let own = Mark::Points {
        label: format!("d = {depth}"),
        hue: Hue::Reference,
        shape: Shape::Diamond,
        joined: false,
        points: if depth <= 64 { vec![own] } else { Vec::new() },
    };
    Plot::of("What a limit of depth loses", chart.with(own))
}
