//! C21: two ways of finding one lamp, and how much each counts.

use super::scenes::{greens, plate, rendered};
use super::symbols::{G, P_1, P_2, W_1, W_2};
use super::ways::shown;
use crate::figure::{Axis, Chart, Hue, Plot};
use crate::parameter::{Kind, Parameter, Setting};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Extreme, Measured, Quantity, Step, check, choice, derivation, exhibit, figure,
    question, statement, step, stress,
};
use equation::derivation::Chain;
use equation::expr::partial;
use equation::{Equation, Expr};
use light::bsdf::{Rgb, rgb};
use light::geometry::Ray;
use light::sampling::{Choice, balance};
use light::transport::kernel::{Meeting, Tactics};
use light::transport::simple::{INTEGRATORS, Integrator, Numbers, gathered};
use light::transport::{Manner, Method, Stage};
use yardstick::precise;
use yardstick::statistics::Moments;

const ALPHA: Parameter =
    Parameter::new("alpha", "α", "roughness of the plate", Kind::number(1e-3, 1.0, "1")).default("0.1");
const RADIUS: Parameter =
    Parameter::new("radius", "R", "radius of the lamp, 5 m away", Kind::number(1e-3, 3.0, "m")).default("0.3");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "weights",
    &[ALPHA, RADIUS],
    &[
        figure(
            "scatter",
            "How far one path is off, by the size of the lamp it looks for: the lamp's way is good for small ones, the \
             surface's for large ones, and the two weighed for all.",
            scatter,
        ),
        figure("plates", "Four plates, ever rougher, under four lamps, ever smaller, by 16 paths a pixel.", plates),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Two ways, one light",
    "What two ways can find counts by each one's share of the densities: the shares sum to one, and no others scatter less.",
)
.rows(&["C21"])
.statements(&[statement("share", "the share of a way: how densely it looks there, over how densely both do", || {
    Equation::new(W_1, P_1 / (P_1 + P_2))
})])
.derivations(&[
    derivation("one", "the shares of both ways sum to one", || one(P_2 / (P_1 + P_2)))
        .slip("the same density above both", || one(P_1 / (P_1 + P_2))),
    derivation("mean", "with shares that sum to one the two ways together find the light once", || mean(1 - W_1))
        .slip("the second in full beside the first", || mean(1.into())),
    derivation("least", "of all such shares these make the mean square of what is found least", || {
        least(P_1 / (P_1 + P_2))
    })
    .slip("the other's density above", || least(P_2 / (P_1 + P_2))),
])
.questions(&[question(
    "half",
    "A colleague counts each of the two ways by one half, always. What does the picture look like?",
    Answer::Choice {
        options: &[
            choice("wrong: the halves know nothing of the densities", "The halves sum to one, and each way alone is right on average."),
            choice("right on average, but with the noise of the worse way", ""),
            choice("the same as with the shares of the densities", "Right on average, yes; but where one way is bad, its noise is only halved."),
        ],
        right: |_| {
            let [halved, weighed] = [&HALVED, &WEIGHED].map(|way| single(&plate(0.02, 1.0, 64), Method::Simple(way)));
            let apart = (halved.mean() - weighed.mean()).abs() / halved.standard_error().hypot(weighed.standard_error());
            match (apart < 5.0, relative_variance(&halved) > 2.0 * relative_variance(&weighed)) {
                (false, _) => 0,
                (true, true) => 1,
                (true, false) => 2,
            }
        },
        slip: |_| 0,
    },
    "Any shares that sum to one are right. The noise of the worse way remains, a quarter of its variance.",
)])
.readout(|setting| {
    let scene = plate(setting.number("alpha"), setting.number("radius"), 48);
    let of = |key, symbol, says, meeting| {
        let value = relative_variance(&single(&scene, met(meeting))).sqrt();
        Quantity { key, symbol, says, value: if value.is_finite() { value } else { 0.0 }, unit: "1" }
    };
    vec![
        of("lamps", "σ_1", "scatter of one path over its mean, by rays to the lamp (0 if it finds nothing)", Meeting::Lamps),
        of("chance", "σ_2", "by the surface", Meeting::Chance),
        of("both", "σ", "by both, weighed", Meeting::Both),
    ]
})
.checks(&[&ONE, &NO_WORSE])
.stress(&[stress("no_choice", "a mirror's density is infinite, and densities may be as large as numbers are", extremes)
    .textbook("p_1/(p_1 + p_2) as it is printed")
    .against("the same in arbitrary precision, and 1 beside an infinite density")]);

fn one(second: Expr) -> Chain {
    Chain::new(P_1 / (P_1 + P_2) + second).then(Expr::from(1), ["common denominator"])
}

fn mean(second: Expr) -> Chain {
    Chain::new(P_1 * (W_1 * G / P_1) + P_2 * (W_2 * G / P_2))
        .given(W_2, second, "what is left for the second way")
        .then(Expr::from(G), ["p cancels", "the shares sum to one"])
}

fn least(last: Expr) -> Chain {
    let square = W_1.pow(2) / P_1 + (1 - W_1).pow(2) / P_2;
    Chain::assume(Equation::new(partial(square, W_1), 0), "the mean square over g² is least")
        .solve_for([W_1])
        .then(Equation::new(W_1, last), ["∂ w²/p = 2w/p", "linear solve"])
}

const ONE: Check<fn(f64, f64) -> f64> =
    check("sum", "the shares of two ways sum to one, whatever their densities, and each is p times as large as p says")
        .against("1, and the ratio of the densities, over forty decades of them")
        .within(4.0, "ulp", "two quotients and a sum: two roundings each at most")
        .of(
            |_: &mut Bench, share: fn(f64, f64) -> f64| {
                let decades = || (-20..=20).map(|k| 10f64.powi(k));
                let pairs = decades().flat_map(|p| decades().map(move |q| (p, q)));
                Measured::worst(pairs.flat_map(|(p, q)| {
                    let (one, other) = (share(p, q), share(q, p));
                    let place = format!("p = {p:e}, q = {q:e}");
                    let off = [one + other - 1.0, one / other / (p / q) - 1.0];
                    off.map(|off| (off / f64::EPSILON, place.clone()))
                }))
            },
            balance as fn(f64, f64) -> f64,
        )
        .slip("the second way's two samples forgotten in the first one's share", |p, q| p / (p + 2.0 * q));

const NO_WORSE: Check<&'static Integrator> = check(
    "no_worse",
    "weighed by their densities two ways scatter at most a little more than the better of them, whatever lamp and roughness",
)
.against("the variance of either way alone, over the squared mean, by 8192 independent paths each")
.within(0.5, "1", "theorem 1 of Veach and Guibas: at most (1/min n − 1/Σn)⟨X⟩² more than any way, here ⟨X⟩²/2")
.of(
    |_: &mut Bench, way: &'static Integrator| {
        let cases = [(0.1, 0.05), (0.1, 0.5), (0.3, 0.5), (0.02, 1.0)];
        Measured::worst(cases.map(|(alpha, radius)| {
            let scene = plate(alpha, radius, 64);
            let of = |way| relative_variance(&single(&scene, Method::Simple(way)));
            let (both, [chance, lamps]) = (of(way), [1, 2].map(|k| of(&INTEGRATORS[k])));
            let place = format!("α = {alpha}, R = {radius} m: {both:.3} weighed, {lamps:.3} and {chance:.3} alone");
            // What is below the better one is nothing to worry about.
            (crate::vocabulary::excess(both - lamps.min(chance)), place)
        }))
    },
    &WEIGHED,
)
.slip("each way by one half", &HALVED);

/// Paths of one spot, each a number.
fn single(scene: &light::scene::Scene, method: Method) -> Moments {
    greens(&rendered(scene, &Manner { method, choice: Choice::Independent, ..Manner::default() }, 1))
}

fn relative_variance(found: &Moments) -> f64 {
    found.variance() / found.mean().powi(2)
}

fn met(meeting: Meeting) -> Method {
    Method::Fast(Tactics { meeting, ..Tactics::default() })
}

const WEIGHED: Integrator = Integrator {
    name: "weighed",
    about: "direct light by two ways, each by its share of the densities",
    fits: |_| true,
    radiance: |stage, ray, numbers, _| two_ways(stage, ray, numbers, balance),
};

const HALVED: Integrator = Integrator {
    name: "halved",
    about: "direct light by two ways, each by one half",
    fits: |_| true,
    radiance: |stage, ray, numbers, _| two_ways(stage, ray, numbers, |_, _| 0.5),
};

/// Light straight from lamps, by a ray to each and one that the surface draws, each counted by its share.
fn two_ways(stage: &Stage<f64>, ray: Ray<f64>, numbers: &mut Numbers<'_>, share: fn(f64, f64) -> f64) -> Rgb<f64> {
    let Some(vertex) = stage.meet(&ray) else { return [0.0; 3] };
    let (mut light, row) = (vertex.emitted(), numbers.of_next_vertex());
    for lamp in stage.lamps() {
        let arrival = lamp.sample(vertex.start, row.lamp);
        let wi = vertex.frame.inward(arrival.wi);
        let (f, by_chance) = vertex.f_pdf(wi);
        if f != [0.0; 3] && stage.sees(&vertex, &arrival) {
            let share = share(arrival.pdf, by_chance);
            light = gathered(light, [share; 3], rgb(|c| f[c] * wi.z.abs() * arrival.share[c]));
        }
    }
    let drawn = vertex.scatter(row.surface);
    let ray = stage.leave(&vertex, vertex.frame.outward(drawn.wi));
    stage.meet(&ray).map_or(light, |met| {
        let share = share(drawn.pdf, stage.density_to(&ray, &met, true));
        gathered(light, drawn.weight.map(|weight| weight * share), met.emitted())
    })
}

fn extremes(_: &Setting) -> Vec<Extreme> {
    let pairs = [
        (f64::INFINITY, 3.0),
        (f64::INFINITY, 1e300),
        (1e308, 1e308),
        (1.5e308, 1e300),
        (1e-300, 3e-300),
        (1e16, 1.0),
        (1.0, 1e16),
    ];
    pairs
        .map(|(p, q)| {
            let reference = if p.is_finite() {
                let (p, q) = (precise::real(p), precise::real(q));
                &p / (&p + &q)
            } else {
                precise::real(1.0)
            };
            Extreme {
                input: format!("p_1 = {p:e}, p_2 = {q:e}"),
                quantity: "w_1",
                reference,
                textbook: p / (p + q),
                ours: balance(p, q),
                // w moves by w₂ times as much, relatively, as either density.
                condition: 2.0,
                worst_of: 1,
            }
        })
        .into()
}

fn scatter(setting: &Setting) -> Plot {
    let alpha = setting.number("alpha");
    let curve = |meeting: Meeting| -> Vec<[f64; 2]> {
        let radii = (0..=12).map(|k| 0.01 * 200f64.powf(f64::from(k) / 12.0));
        let of = |radius: f64| [radius, relative_variance(&single(&plate(alpha, radius, 48), met(meeting))).sqrt()];
        radii.map(of).collect()
    };
    let chart = Chart::new(
        "",
        Axis::log("radius of the lamp R", "m").range(0.01, 2.0),
        Axis::log("scatter of one path σ/⟨X⟩", ""),
    )
    .line(Hue::Nth(0), "rays to the lamp", curve(Meeting::Lamps))
    .line(Hue::Nth(1), "by the surface", curve(Meeting::Chance))
    .line(Hue::Ours, "both, weighed", curve(Meeting::Both));
    Plot::of(format!("A lamp 5 m away in a plate of α = {alpha}, by 4608 paths each"), chart)
}

fn plates(_: &Setting) -> Plot {
    let scene = super::scenes::small("veach", 72);
    let panel = |(meeting, title): (Meeting, &str)| {
        let manner = Manner { method: met(meeting), ..Manner::default() };
        shown(title, &rendered(&scene, &manner, 8), 72).into()
    };
    let ways =
        [(Meeting::Lamps, "rays to the lamps"), (Meeting::Chance, "by the surface"), (Meeting::Both, "both, weighed")];
    Plot::grid("Plates and lamps by 16 paths a pixel", 3, ways.map(panel).into())
}
