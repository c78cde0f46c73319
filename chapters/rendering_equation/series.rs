//! C19: light by the number of its bounces.

use super::rooms::{cube, network};
use super::symbols::{K, L, L_E, L_K, L_NEXT, POWER, RHO};
use crate::figure::{Axis, Chart, Hue, Mark, Plot, Shape};
use crate::parameter::{Kind, Parameter, Setting};
use crate::path_tracing::scenes::{closed, greens, halves};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Extreme, Heat, Measured, Misled, Quantity, Race, Step, check, derivation, exhibit,
    figure, lane, question, race, statement, step, stress,
};
use equation::derivation::Chain;
use equation::{Equation, Expr};
use light::radiosity::exact::{Wall, sphere};
use light::radiosity::{limit, solve};
use light::sampling::Choice;
use light::transport::simple::INTEGRATORS;
use light::transport::{Manner, Method, Renderer, enclosure};
use yardstick::precise::{self, Real};
use yardstick::random::uniform;

const RHO_SET: Parameter =
    Parameter::new("rho", "ρ", "share of the light that the walls return", Kind::number(0.01, 1.0 - 1e-6, "1"))
        .default("0.8");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "series",
    &[RHO_SET],
    &[figure(
        "terms",
        "What the first k terms miss of all light: ρ^k in a closed room that shines all over, and as steep in a cube of which \
         one wall shines.",
        terms,
    )],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Bounce by bounce",
    "Put the equation into itself: light once reflected, twice, … a series that falls as the albedo's powers.",
)
.rows(&["C19"])
.about("neumann")
.statements(&[
    statement("operator", "one bounce of light everywhere as an operator K: the equation of the whole room", || {
        Equation::new(L, L_E + K * L)
    }),
    statement("neumann", "the equation put into itself three times: what was reflected 0, 1, 2 and more often", || {
        Equation::new(L, L_E + K * L_E + K.pow(2) * L_E + K.pow(3) * L)
    }),
    statement("closed", "a closed room that shines and reflects alike everywhere", || {
        Equation::new(L, L_E / (1 - RHO))
    }),
])
.derivations(&[
    derivation(
        "telescope",
        "the powers of one operator take each other away in pairs: what is left after four terms",
        || telescope(1 - K.pow(4)),
    )
    .slip("a power too few", || telescope(1 - K.pow(3))),
    derivation("start", "one term is the lamp alone: p = ρ", || start(L_E.into()))
        .slip("as if the first term had been reflected once", || start(RHO * L_E)),
    derivation(
        "induction",
        "if k terms are L_e(1 − p)/(1 − ρ) with p = ρ^k, so are k + 1, with one power more",
        || induction(L_E * (1 - RHO * POWER) / (1 - RHO)),
    )
    .slip("one power less", || induction(L_E * (1 - POWER / RHO) / (1 - RHO))),
    derivation("rest", "each term leaves ρ of what was missing", || rest(RHO * (L - L_K)))
        .slip("as if it left 1 − ρ of it", || rest((1 - RHO) * (L - L_K))),
    derivation("limit", "and nothing is missing in the end", || fixed(L_E / (1 - RHO)))
        .slip("ρ with the wrong sign", || fixed(L_E / (1 + RHO))),
])
.questions(&[question(
    "million",
    "Walls return 99.9999 % of the light. How many terms does the series need to be right to one per cent?",
    Answer::Number {
        unit: "1",
        tolerance: 0.05,
        right: |_| 0.01_f64.ln() / (-1e-6_f64).ln_1p(),
        slips: &[
            Misled { value: |_| 1e6, reply: "After 1/(1 − ρ) terms a share 1/e, 37 %, is still missing." },
            Misled { value: |_| 1e8, reply: "The rest falls as ρ^k, not as 1/k." },
        ],
    },
    "4.6 million: ln 100 times 1/(1 − ρ).",
)])
.readout(|setting| {
    let absorbed = 1.0 - setting.number("rho");
    let quantity = |key, symbol, says, value| Quantity { key, symbol, says, value, unit: "1" };
    vec![
        quantity("all", "L/L_e", "a closed room that shines all over", 1.0 / absorbed),
        quantity("ten", "L_{10}/L_e", "ten terms", enclosure::radiance(absorbed, 10)),
        quantity("needed", "k", "terms until a per cent is missing", 0.01_f64.ln() / (-absorbed).ln_1p()),
    ]
})
.checks(&[&SUM, &RATE])
.stress(&[stress("white", "a sphere of three kinds of wall that absorb next to nothing", whites)
    .textbook("ΣsL_e/(1 − Σsρ), with ρ = 1 − a in f64")
    .against("the same in arbitrary precision")])
.races(&[CLOSED]);

fn telescope(last: Expr) -> Chain {
    Chain::new((1 - K) * (1 + K + K.pow(2) + K.pow(3))).then(last, ["each power but the ends appears twice"])
}

fn start(last: Expr) -> Chain {
    Chain::new(L_E * (1 - POWER) / (1 - RHO)).given(POWER, RHO, "k = 1").then(last, ["k = 1"])
}

fn induction(last: Expr) -> Chain {
    Chain::new(L_E + RHO * L_K)
        .because("one term more: all of the sum is reflected once, and the lamp added")
        .given(L_K, L_E * (1 - POWER) / (1 - RHO), "k terms")
        .then(last, ["k terms", "common denominator"])
}

fn rest(last: Expr) -> Chain {
    Chain::assume(Equation::new(L, L_E + RHO * L), "all of it")
        .and(Equation::new(L_NEXT, L_E + RHO * L_K), "one term more")
        .solve_for([L, L_NEXT])
        .then(Equation::new(L - L_NEXT, last), ["linear solve", "factor ρ"])
}

fn fixed(last: Expr) -> Chain {
    Chain::assume(Equation::new(L, L_E + RHO * L), "what arrives is what leaves")
        .solve_for([L])
        .then(Equation::new(L, last), ["linear solve"])
}

const SUM: Check<fn(f64) -> f64> =
    check("sum", "added up term by term, up to 40 million of them, the series is the closed form")
        .against("the sum in f64, until e^−40 of it is missing, against 1/(1 − ρ) for ρ up to 0.999999")
        .within(
            1e6 * f64::EPSILON,
            "1",
            "each addition rounds by half an ulp, and what it adds is reflected on 1/(1 − ρ) = 10⁶ times",
        )
        .of(
            |_: &mut Bench, closed: fn(f64) -> f64| {
                Measured::worst([0.5, 0.1, 1e-3, 1e-6].map(|absorbed: f64| {
                    let rho = 1.0 - absorbed;
                    let terms = (40.0 / absorbed) as u64;
                    let sum = (1..terms).fold(1.0, |sum, _| 1.0 + rho * sum);
                    // Of the number that f64 has for ρ.
                    (sum / closed(1.0 - rho) - 1.0, format!("1 − ρ = {absorbed:e}, {terms} terms"))
                }))
            },
            |absorbed| 1.0 / absorbed,
        )
        .slip("the sum without the lamp itself", |absorbed| (1.0 - absorbed) / absorbed);

const RATE: Check<fn(f64) -> f64> =
    check("rate", "in a cube of which one wall shines each term leaves ρ of what was missing, too")
        .against("ρ, against two neighbouring partial sums' distances from the solution by elimination, over all patches")
        .within(
            1e-8,
            "1",
            "a bounce keeps ρ of all energy exactly, for rows of form factors sum to 1; at ρ = 0.2 a 10⁻⁷ of the light is left, in \
             which 24 patches' rounding is some 10⁻⁹",
        )
        .of(
            |_: &mut Bench, factor: fn(f64) -> f64| {
                Measured::worst([0.2, 0.5, 0.8, 0.99].map(|rho: f64| {
                    let (_, network, light) = network(&cube(1.0 - rho), 2);
                    let all = solve::direct(&network, &light);
                    // As late as the rest is well above rounding.
                    let k = if rho < 0.4 { 10 } else { 20 };
                    let off = |terms: u32| {
                        let found = solve::series(&network, &light, terms);
                        found.iter().zip(&all).map(|(some, all)| all - some).sum::<f64>()
                    };
                    (off(k + 1) / off(k) / factor(rho) - 1.0, format!("ρ = {rho}, {k} terms"))
                }))
            },
            |rho| rho,
        )
        .slip("each term taken to leave what is not absorbed twice, ρ²", |rho| rho * rho);

fn whites(_: &Setting) -> Vec<Extreme> {
    let shares = [0.25, 0.25, 0.5];
    [0.5, 1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 1e-18, 1e-300]
        .map(|white: f64| {
            let walls = [(1.0, 1.0), (0.25, 0.0), (0.5, 0.125)]
                .map(|(absorbed, emitted)| Wall { absorbed: white * absorbed, emitted });
            let pieces: Vec<(f64, Wall)> = shares.into_iter().zip(walls).collect();
            let sum = |of: &dyn Fn(&Wall) -> f64| pieces.iter().map(|(share, wall)| share * of(wall)).sum::<f64>();
            let exact = |of: fn(&Wall) -> f64| -> Real {
                let term =
                    |(share, wall): &(f64, Wall)| precise::real_at(*share, 2048) * precise::real_at(of(wall), 2048);
                pieces.iter().map(term).fold(precise::real_at(0.0, 2048), |sum, term| sum + term)
            };
            let arriving = exact(|wall| wall.emitted) / exact(|wall| wall.absorbed);
            let rho = precise::real_at(1.0, 2048) - precise::real_at(walls[1].absorbed, 2048);
            let reflected = 1.0 - sum(&|wall| 1.0 - wall.absorbed);
            Extreme {
                input: format!("a up to {white:e}"),
                quantity: "L_2",
                reference: rho * arriving,
                textbook: (1.0 - walls[1].absorbed) * sum(&|wall| wall.emitted) / reflected,
                ours: sphere(&pieces)[1],
                // A quotient of sums of positive terms.
                condition: 2.0,
                worst_of: 1,
            }
        })
        .into()
}

/// What the raced sphere absorbs.
const RACED: f64 = 0.01;

fn wrong(found: &[f64]) -> f64 {
    (found[0] * RACED - 1.0).abs()
}

/// `terms` terms in f64.
fn summed(terms: u64) -> f64 {
    (1..terms).fold(1.0, |sum, _| 1.0 + (1.0 - RACED) * sum)
}

fn traced(bench: &mut Bench, method: Method, edges: Option<u32>, work: u64) -> Heat {
    let seed = uniform(&mut bench.stream, 0.0, 1.0).to_bits();
    let (scene, pairs) = (closed(RACED, edges, 4), (work / 2) as u32);
    let manner = Manner { method, choice: Choice::Independent, seed, ..Manner::default() };
    let renderer = Renderer::new(&scene, &manner, pairs).expect("a closed room");
    Heat { run: Box::new(move || vec![greens(&halves(&renderer, &scene, pairs)).mean()]), error: Box::new(wrong) }
}

const CLOSED: Race = race(
    "sphere",
    "a sphere that returns 99 %: the series needs a thousand terms, Aitken three of them; paths that chance ends are right on average",
)
.work("terms, paths a pixel of 16 pixels, or evaluations")
.error("relative error of L", "relative error (rms over seeds where there is chance), against 1/(1 − ρ)")
.lanes(&[
    lane("series", "the series, term by term", &[64, 256, 1024, 3072], |_, work| Heat {
        run: Box::new(move || vec![summed(std::hint::black_box(work))]),
        error: Box::new(wrong),
    })
    .converges(1e-12, "0.99^3072 is 4·10⁻¹⁴, and a rounding a term, reflected on a hundred times"),
    lane("aitken", "Aitken's limit of its first terms", &[3], |_, _| Heat {
        run: Box::new(|| vec![limit::aitken([1, 2, 3].map(|terms| summed(std::hint::black_box(terms))))]),
        error: Box::new(wrong),
    })
    .within(1e-11, "one power alone, which three terms take off; their second difference loses 1/(1 − ρ)² ulp"),
    lane("limited", "paths of at most 64 edges", &[16, 64, 256], |bench, work| {
        traced(bench, Method::Simple(&INTEGRATORS[1]), Some(64), work)
    })
    .order(0.0, 0.01),
    lane("roulette", "paths that chance ends", &[16, 64, 256], |bench, work| traced(bench, Method::default(), None, work))
        .repeated(24)
        .order(0.5, 0.2),
    lane("exact", "the closed form", &[1], |_, _| Heat {
        run: Box::new(|| vec![1.0 / std::hint::black_box(RACED)]),
        error: Box::new(wrong),
    })
    .within(1e-15, "two roundings"),
]);

fn terms(setting: &Setting) -> Plot {
    let rho = setting.number("rho");
    let curve = |rho: f64| -> Vec<[f64; 2]> {
        (0..=80).map(|at| 10f64.powf(f64::from(at) / 20.0)).map(|k| [k, (k * rho.ln()).exp()]).collect()
    };
    let (_, network, light) = network(&cube(1.0 - rho), 2);
    let all = solve::direct(&network, &light);
    let whole: f64 = all.iter().sum();
    let found = [1, 2, 3, 5, 8, 12, 20, 32, 50, 80, 125, 200].map(|k| {
        let some: f64 = solve::series(&network, &light, k).iter().sum();
        [f64::from(k), 1.0 - some / whole]
    });
    let chart = Chart::new(
        "",
        Axis::log("terms k", "").range(1.0, 1e4),
        Axis::log("share of the light that is missing", "").range(1e-6, 1.5),
    );
    let chart = [0.5, 0.95, 0.999]
        .into_iter()
        .zip(0..)
        .fold(chart, |chart, (rho, at)| chart.line(Hue::Nth(at), format!("ρ = {rho}"), curve(rho)));
    let chart = chart.line(Hue::Ours, format!("ρ = {rho}"), curve(rho)).with(Mark::Points {
        label: format!("a cube, one wall shines, ρ = {rho}"),
        hue: Hue::Ours,
        shape: Shape::Disc,
        joined: false,
        points: found.into_iter().filter(|point| point[1] > 1e-12).collect(),
    });
    Plot::of("What a sum of bounces misses", chart)
}
