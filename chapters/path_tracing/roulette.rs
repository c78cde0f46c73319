//! C22: paths that chance ends, and nothing is lost.

use super::one_ray::judged;
use super::scenes::{closed, greens, rendered, runs};
use super::symbols::{M, M_2, Q, RHO, X};
use super::ways::smallest;
use crate::figure::{Axis, Chart, Hue, Mark, Plot, Shape};
use crate::parameter::{Kind, Parameter, Setting};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Extreme, Heat, Measured, Misled, Quantity, Race, Step, check, derivation, exhibit,
    figure, lane, question, race, statement, step, stress,
};
use equation::derivation::Chain;
use equation::{Equation, Expr};
use light::bsdf::Rgb;
use light::geometry::Ray;
use light::sampling::Choice;
use light::scene::Scene;
use light::transport::simple::{INTEGRATORS, Integrator, Numbers, carried, gathered};
use light::transport::{Manner, Method, Renderer, Stage, enclosure};
use yardstick::precise;
use yardstick::random::uniform;
use yardstick::statistics::Moments;

const RHO_SET: Parameter =
    Parameter::new("rho", "ρ", "share of the light that the walls return", Kind::number(0.05, 0.99, "1"))
        .default("0.75");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "roulette",
    &[RHO_SET],
    &[figure(
        "cost",
        "The work for one digit, by the chance to go on: it falls to the right, and has no end to the left of ρ². Near there a \
         few paths carry nearly all, and a count of paths tells too little.",
        cost,
    )],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Paths that chance ends",
    "Whoever goes on with the chance q counts 1/q: no light is lost, and the price is noise, without bound if q ≤ ρ².",
)
.rows(&["C22"])
.statements(&[statement("second", "the mean square of what a path finds, and of what the rest of it finds", || {
    Equation::new(M_2, 1 + 2 * RHO * M + RHO.pow(2) / Q * M_2)
})])
.derivations(&[
    derivation("mean", "with the chance q it is X/q, else nothing: X on average", || mean(X / Q))
        .slip("whoever goes on keeps his weight", || mean(X.into())),
    derivation("variance", "how much a path scatters that goes on with the same chance everywhere", || {
        variance(RHO.pow(2) * (1 - Q) / (Q - RHO.pow(2)))
    })
    .slip("ρ where ρ² belongs: as if q > ρ were needed", || variance(RHO * (1 - Q) / (Q - RHO))),
])
.questions(&[question(
    "least",
    "Walls return 90 % of the light. Below which chance to go on does the error of a path no longer have a finite mean square?",
    Answer::Number {
        unit: "1",
        tolerance: 0.02,
        right: |_| {
            // Where the scatter ceases to be a number, by halving.
            let (mut low, mut high) = (0.0, 1.0);
            for _ in 0..50 {
                let q = 0.5 * (low + high);
                if enclosure::scatter(0.1, 1.0 - q).is_some() { high = q } else { low = q }
            }
            high
        },
        slips: &[
            Misled { value: |_| 0.9, reply: "At q = ρ what a path carries stays the same: that is comfortable, not the limit." },
            Misled { value: |_| 0.1, reply: "That is what the walls absorb." },
        ],
    },
    "ρ² = 0.81: with each edge the carried square grows by ρ²/q², and only the share q of paths sees it.",
)])
.readout(|setting| {
    let absorbed = 1.0 - setting.number("rho");
    let quantity = |key, symbol, says, value| Quantity { key, symbol, says, value, unit: "1" };
    vec![
        quantity("least", "ρ²", "the chance to go on must be larger", (1.0 - absorbed).powi(2)),
        quantity(
            "own",
            "σ/⟨X⟩",
            "scatter of one path at q = ρ",
            enclosure::scatter(absorbed, absorbed).unwrap_or(f64::MAX),
        ),
        quantity("edges", "⟨d⟩", "edges of a path at q = ρ", 1.0 / absorbed),
    ]
})
.checks(&[&UNBIASED, &SQUARES])
.stress(&[stress("gentle", "chances of almost 1, on walls that are almost white", gentle)
    .textbook("⟨X²⟩/⟨X⟩² − 1, in f64")
    .against("the same in arbitrary precision")])
.races(&[ENDS]);

fn mean(of_survivors: Expr) -> Chain {
    Chain::new(Q * of_survivors + (1 - Q) * Expr::from(0)).then(Expr::from(X), ["q cancels"])
}

fn variance(last: Expr) -> Chain {
    Chain::assume(Equation::new(M, 1 + RHO * M), "the mean: the room's brightness over L_e")
        .and(Equation::new(M_2, 1 + 2 * RHO * M + RHO.pow(2) / Q * M_2), "the mean square")
        .because("X = 1 + (ρ/q) X′ with the chance q, and 1 without; X′ is like X")
        .solve_for([M, M_2])
        .then(Equation::new(M_2 / M.pow(2) - 1, last), ["linear solve", "factor 1 − ρ"])
}

/// Paths drawn by the cosine that go on with a chance of so many per cent after every edge, whatever they carry.
fn chanced<const PERCENT: u32, const COUNTS_FOR_OTHERS: bool>(
    stage: &Stage<f64>,
    mut ray: Ray<f64>,
    numbers: &mut Numbers<'_>,
    depth: u32,
) -> Rgb<f64> {
    let chance = f64::from(PERCENT) / 100.0;
    let (mut light, mut carries) = ([0.0; 3], [1.0; 3]);
    for _ in 0..depth {
        let Some(vertex) = stage.meet(&ray) else { return gathered(light, carries, stage.sky(&ray)) };
        light = gathered(light, carries, vertex.emitted());
        let row = numbers.of_next_vertex();
        if row.survival >= chance {
            break;
        }
        let drawn = vertex.scatter(row.surface);
        let others = if COUNTS_FOR_OTHERS { chance } else { 1.0 };
        carries = carried(carries, drawn.weight.map(|weight| weight / others));
        ray = stage.leave(&vertex, vertex.frame.outward(drawn.wi));
    }
    light
}

const fn by_chance(radiance: fn(&Stage<f64>, Ray<f64>, &mut Numbers<'_>, u32) -> Rgb<f64>) -> Integrator {
    Integrator { name: "chanced", about: "by the surface, ended by one chance everywhere", fits: |_| true, radiance }
}

/// Chances to go on [%] and paths that have them.
const CHANCES: [(u32, Integrator); 6] = [
    (50, by_chance(chanced::<50, true>)),
    (60, by_chance(chanced::<60, true>)),
    (70, by_chance(chanced::<70, true>)),
    (80, by_chance(chanced::<80, true>)),
    (90, by_chance(chanced::<90, true>)),
    (95, by_chance(chanced::<95, true>)),
];

/// Going on with 80 %.
const FAIR: Integrator = by_chance(chanced::<80, true>);
const UNFAIR: Integrator = by_chance(chanced::<80, false>);

/// What ends paths at the latest: q^d is below 10⁻²⁰⁰.
const DEEP: Option<u32> = Some(10_000);

const UNBIASED: Check<&'static Integrator> = check(
    "unbiased",
    "paths that chance ends find all the light of a closed room: at one chance, and by the integrators' own roulette",
)
.against("1/(1 − ρ), against 64 independent pictures by each (t-tests)")
.significant(1e-3)
.of(
    |_: &mut Bench, way: &'static Integrator| {
        let of = |name: &str, absorbed: f64, method: Method, edges: Option<u32>| {
            let found = runs(64, &closed(absorbed, edges, 2), Manner { method, ..Manner::default() }, 64);
            let of = judged(&found, 1.0 / absorbed);
            Measured { at: format!("{name}, ρ = {}: {}", 1.0 - absorbed, of.at), ..of }
        };
        smallest(vec![
            of("q = 0.8", 0.25, Method::Simple(way), DEEP),
            of("both", 0.25, Method::Simple(&INTEGRATORS[3]), DEEP),
            of("fast", 0.25, Method::default(), None),
            of("fast", 0.05, Method::default(), None),
        ])
    },
    &FAIR,
)
.slip("whoever goes on does not count for the others", &UNFAIR);

const SQUARES: Check<fn(f64, f64) -> f64> = check("squares", "they scatter as is derived")
    .against("⟨X²⟩ of 32 768 independent paths in a closed room, ρ = 0.5 and 0.7, q = 0.8 (t-tests)")
    .significant(1e-3)
    .of(
        |_: &mut Bench, scatter: fn(f64, f64) -> f64| {
            let of = |absorbed: f64| {
                let found = single(absorbed, &FAIR, 128);
                let squares: Moments = found.into_iter().map(|x| (absorbed * x).powi(2)).collect();
                judged(&squares, 1.0 + scatter(absorbed, 0.2).powi(2))
            };
            smallest([0.5, 0.3].map(of).into())
        },
        |absorbed, ended| enclosure::scatter(absorbed, ended).unwrap_or(f64::INFINITY),
    )
    .slip("ρ for ρ²: the chance over what is left of a mean", |absorbed, ended| {
        let (rho, q) = (1.0 - absorbed, 1.0 - ended);
        rho * (ended / (q - rho).abs()).sqrt()
    });

/// What single paths find.
fn single(absorbed: f64, way: &'static Integrator, pixels: u32) -> Vec<f64> {
    let manner = Manner { method: Method::Simple(way), choice: Choice::Independent, ..Manner::default() };
    rendered(&closed(absorbed, DEEP, pixels), &manner, 1).iter().flatten().map(|half| f64::from(half[1])).collect()
}

fn gentle(_: &Setting) -> Vec<Extreme> {
    let pairs = [(0.5, 0.25), (0.1, 1e-9), (1e-3, 1e-15), (1e-6, 1e-6), (1e-9, 1e-12), (1e-12, 1e-13)];
    pairs
        .map(|(absorbed, ended): (f64, f64)| {
            let (rho, q) = (1.0 - absorbed, 1.0 - ended);
            let square = (1.0 + rho) * (1.0 - rho) / (1.0 - rho * rho / q);
            let [a, e, one, two] = [absorbed, ended, 1.0, 2.0].map(precise::real);
            let (r, room) = (&one - &a, &a * (&two - &a) - &e);
            let half = precise::real(0.5);
            Extreme {
                input: format!("1 − ρ = {absorbed:e}, 1 − q = {ended:e}"),
                quantity: "σ/⟨X⟩",
                reference: &r * ((&e / &room).ln() * half).exp(),
                textbook: (square - 1.0).sqrt(),
                ours: enclosure::scatter(absorbed, ended).unwrap_or(f64::INFINITY),
                // Of a difference of 2a and e, either of which is at most twice the other's rest here.
                condition: 4.0,
                worst_of: 1,
            }
        })
        .into()
}

/// The room of the race.
const RACED: f64 = 0.25;

fn heat(bench: &mut Bench, method: Method, edges: Option<u32>, work: u64) -> Heat {
    let seed = uniform(&mut bench.stream, 0.0, 1.0).to_bits();
    let (scene, pairs): (Scene, u32) = (closed(RACED, edges, 4), (work / 2) as u32);
    let manner = Manner { method, choice: Choice::Independent, seed, ..Manner::default() };
    let renderer = Renderer::new(&scene, &manner, pairs).expect("a closed room");
    Heat {
        run: Box::new(move || vec![greens(&super::scenes::halves(&renderer, &scene, pairs)).mean()]),
        error: Box::new(|found| (found[0] * RACED - 1.0).abs()),
    }
}

const WORKS: &[u64] = &[16, 64, 256, 1024];

const ENDS: Race =
    race("ends", "a limit of depth has an error that no work takes away; chance has none that work does not")
        .work("paths a pixel, of 16 pixels")
        .error(
            "relative error of L",
            "rms over seeds of the relative error, against 1/(1 − ρ) of the closed room, ρ = 0.75",
        )
        .lanes(&[
            lane("four", "at most 4 edges", WORKS, |bench, work| {
                heat(bench, Method::Simple(&INTEGRATORS[1]), Some(4), work)
            })
            .order(0.0, 0.01),
            lane("deep", "at most 32 edges", WORKS, |bench, work| {
                heat(bench, Method::Simple(&INTEGRATORS[1]), Some(32), work)
            })
            .order(0.0, 0.05),
            lane("chance", "going on with 80 %", WORKS, |bench, work| heat(bench, Method::Simple(&FAIR), DEEP, work))
                .repeated(24)
                .order(0.5, 0.15),
            lane("late", "late and gently, both ways of meeting lamps, many lanes", WORKS, |bench, work| {
                heat(bench, Method::default(), None, work)
            })
            .repeated(24)
            .order(0.5, 0.15),
        ]);

fn cost(setting: &Setting) -> Plot {
    let rho = setting.number("rho");
    // Variance times edges, 1/(1 − q) of them.
    let curve = |rho: f64| -> Vec<[f64; 2]> {
        let qs = (1..400).map(|k| f64::from(k) / 400.0);
        qs.map(|q| [q, enclosure::scatter(1.0 - rho, 1.0 - q).map_or(f64::NAN, |s| s * s / (1.0 - q))]).collect()
    };
    let found = CHANCES.iter().filter_map(|(percent, way)| {
        let q = f64::from(*percent) / 100.0;
        enclosure::scatter(1.0 - rho, 1.0 - q)?;
        let found: Moments = single(1.0 - rho, way, 48).into_iter().collect();
        Some([q, found.variance() / found.mean().powi(2) / (1.0 - q)])
    });
    let chart = Chart::new(
        "",
        Axis::linear("chance to go on q", "").range(0.0, 1.0).tick(0.1),
        Axis::log("variance/⟨X⟩² times edges", "").range(1e-2, 1e3),
    )
    .line(Hue::Nth(0), "ρ = 0.3", curve(0.3))
    .line(Hue::Nth(1), "ρ = 0.9", curve(0.9))
    .line(Hue::Ours, format!("ρ = {rho}"), curve(rho))
    .with(Mark::Points {
        label: format!("4608 paths, ρ = {rho}"),
        hue: Hue::Ours,
        shape: Shape::Disc,
        joined: false,
        points: found.collect(),
    })
    .at_x(rho, "q = ρ");
    Plot::of("The price of ending paths by chance", chart)
}
