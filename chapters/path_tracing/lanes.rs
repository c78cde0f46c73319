//! The fast integrator, and what each of its tricks is worth.

use super::scenes::{rendered, runs, small};
use super::ways::{ERROR, heat, smallest};
use crate::figure::{Axis, Chart, Dash, Hue, Mark, Panel, Plot};
use crate::parameter::{Kind, Parameter, Setting};
use crate::vocabulary::{
    Answer, Bench, Check, Entrant, Exhibit, Extreme, Heat, Measured, Misled, Quantity, Race, Step, check, exhibit,
    figure, lane, question, race, step, stress,
};
use light::sampling::Choice;
use light::transport::kernel::{Meeting, Tactics};
use light::transport::simple::INTEGRATORS;
use light::transport::waiting::busy as busy_lanes;
use light::transport::{Manner, Method};
use yardstick::precise;
use yardstick::random::{Stream, stream, uniform};
use yardstick::statistics::{Moments, t_test, welch};

const CHANCE: Parameter =
    Parameter::new("chance", "q", "with which a path goes on after an edge", Kind::number(0.0, 0.99, "1"))
        .default("0.75");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "lanes",
    &[CHANCE],
    &[
        figure("time", "Eight lanes, step by step: each line is a path. Whoever waits for the longest is idle.", time),
        figure("busy", "The share of lanes that work if each waits for the longest.", busy),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Many paths at once",
    "The fast integrator does the same sums in eight lanes or sixteen that never wait, and all that it does otherwise can be switched off.",
)
.rows(&["C23"])
.questions(&[question(
    "idle",
    "Eight lanes each follow a path, and every path goes on with a chance of one half at every edge. If the lanes wait until the last of the eight has ended, which share of them is at work on average?",
    Answer::Number {
        unit: "1",
        tolerance: 0.08,
        right: |_| busy_lanes(0.5, 8),
        slips: &[
            Misled { value: |_| 1.0, reply: "So it would be if all paths were of one length." },
            Misled { value: |_| 0.125, reply: "Then only the longest path would work, and the others not at all." },
            Misled { value: |_| 0.5, reply: "A path has two edges on average; how many has the longest of eight?" },
        ],
    },
    "Paths have two edges on average, the longest of eight has 4.4: more than half of the work is waiting.",
)])
.readout(|setting| {
    let chance = setting.number("chance");
    let quantity = |key, symbol, says, value| Quantity { key, symbol, says, value, unit: "1" };
    vec![
        quantity("edges", "⟨d⟩", "edges of a path", 1.0 / (1.0 - chance)),
        quantity("longest", "⟨d_{max}⟩", "of the longest of eight", 1.0 / (1.0 - chance) / busy_lanes(chance, 8)),
        quantity("busy", "b", "share of lanes that work if they wait", busy_lanes(chance, 8)),
    ]
})
.checks(&[&SAME, &WIDTHS, &WAITING])
.stress(&[stress("many", "more and more lanes that wait", crowds)
    .textbook("⟨d⟩/⟨d_{max}⟩ with ⟨d_{max}⟩ = Σ(−1)^{j+1} n!/(j!(n − j)!)/(1 − q^j) as textbooks have it, in f64")
    .against("the same sum in arbitrary precision")])
.races(&[ABLATIONS, PLATES, GLASS, METALS]);

/// What can be done otherwise.
fn otherwise() -> Vec<(&'static str, Tactics)> {
    let own = Tactics::default();
    vec![
        ("early roulette", Tactics { patience: 2, boost: 1.0, ..own }),
        ("rays to lamps alone", Tactics { meeting: Meeting::Lamps, ..own }),
        ("by the surface alone", Tactics { meeting: Meeting::Chance, ..own }),
        ("a lamp chosen blindly", Tactics { blind_choice: true, ..own }),
        ("one lane", Tactics { lanes: 1, ..own }),
    ]
}

/// A chance that nothing holds below one.
fn unheld() -> Vec<(&'static str, Tactics)> {
    vec![("more than certain", Tactics { patience: 1, boost: 3.0, most: 3.0, ..Tactics::default() })]
}

type Others = fn() -> Vec<(&'static str, Tactics)>;

const SAME: Check<Others> = check("same", "whatever is switched off, the picture is the same on average")
    .against(
        "the mean of the box by 32 independent pictures of either, and of one path at a time in f64 (Welch's tests)",
    )
    .significant(1e-3)
    .of(
        |_: &mut Bench, others: Others| {
            let scene = small("cornell", 8);
            let of = |method| runs(32, &scene, Manner { method, ..Manner::default() }, 16);
            let own = of(Method::default());
            let methods = others().into_iter().map(|(name, tactics)| (name, Method::Fast(tactics)));
            let methods = methods.chain([("one at a time", Method::Simple(&INTEGRATORS[3]))]);
            let tests = methods.map(|(name, method)| {
                let found = of(method);
                let at =
                    format!("{name}: {:.4} ± {:.4} against {:.4}", found.mean(), found.standard_error(), own.mean());
                Measured::new(welch(&found, &own).p, at, 1)
            });
            smallest(tests.collect())
        },
        otherwise as Others,
    )
    .slip("a chance to go on that nothing holds below one", unheld);

/// Two scenes by so many lanes.
type InLanes = fn(usize) -> Vec<light::transport::film::Halves>;

fn in_lanes(lanes: usize, seed: u64) -> Vec<light::transport::film::Halves> {
    let method = Method::Fast(Tactics { lanes, ..Tactics::default() });
    let of = |name| rendered(&small(name, 16), &Manner { method, seed, ..Manner::default() }, 4);
    ["glass", "metals"].map(of).concat()
}

const WIDTHS: Check<InLanes> = check("widths", "the picture does not know how many lanes made it")
    .against(
        "the same by one lane, number by number: by eight, and by sixteen where the machine and the build have them",
    )
    .within(0.0, "1", "every path's sums are its own, and they are added in the order of samples: no bit may differ")
    .of(
        |_: &mut Bench, by: InLanes| {
            let one = by(1);
            let differ = |lanes: usize| by(lanes).iter().zip(&one).filter(|(many, one)| many != one).count();
            let [eight, sixteen] = [8, 16].map(differ);
            Measured::new(
                eight.max(sixteen) as f64,
                format!("pixels that differ: {eight} and {sixteen}"),
                2 * one.len(),
            )
        },
        |lanes| in_lanes(lanes, 1),
    )
    .slip("every lane draws from a stream of its own", |lanes| in_lanes(lanes, lanes as u64));

const WAITING: Check<fn(f64, u32) -> f64> =
    check("waiting", "lanes that wait for the longest path are idle as often as is said")
        .against("the edges of the longest of eight paths, 20 000 times by chance, at q = 0.3, 0.75 and 0.95 (t-tests)")
        .significant(1e-3)
        .of(
            |bench: &mut Bench, busy: fn(f64, u32) -> f64| {
                let tests = [0.3, 0.75, 0.95].map(|chance| {
                    let longest: Moments = (0..20_000)
                        .map(|_| f64::from((0..8).map(|_| edges(&mut bench.stream, chance)).max().unwrap_or(0)))
                        .collect();
                    let expected = 1.0 / (1.0 - chance) / busy(chance, 8);
                    let at = format!("q = {chance}: {:.3} against {expected:.3}", longest.mean());
                    Measured::new(t_test(&longest, expected).p, at, 1)
                });
                smallest(tests.into())
            },
            busy_lanes as fn(f64, u32) -> f64,
        )
        .slip("as if the longest were as long as the others", |_, _| 1.0);

/// The edges of a path that goes on with a chance.
fn edges(dice: &mut Stream, chance: f64) -> u32 {
    let mut edges = 1;
    while uniform(dice, 0.0, 1.0) < chance {
        edges += 1;
    }
    edges
}

fn crowds(_: &Setting) -> Vec<Extreme> {
    let cases = [0.3, 0.75, 0.9].into_iter().flat_map(|chance| [2, 8, 32, 64, 128].map(|lanes| (chance, lanes)));
    cases
        .map(|(chance, lanes): (f64, u32)| {
            let exact = |x: f64| precise::real_at(x, 1024);
            let (one, q) = (exact(1.0), exact(chance));
            let (mut sum, mut plain) = (exact(0.0), 0.0);
            // The j-th binomial and the j-th power, one from another.
            let (mut ways, mut power) = (exact(1.0), exact(1.0));
            for j in 1..=lanes {
                ways = &ways * &exact(f64::from(lanes - j + 1)) / &exact(f64::from(j));
                power = &power * &q;
                let sign = if j % 2 == 1 { 1.0 } else { -1.0 };
                sum += &exact(sign) * &ways / (&one - &power);
                plain += sign * precise::to_f64(&ways) / (1.0 - chance.powi(j as i32));
            }
            let step = 1e-6;
            let slope =
                (busy_lanes(chance * (1.0 + step), lanes) - busy_lanes(chance * (1.0 - step), lanes)) / (2.0 * step);
            let ours = busy_lanes(chance, lanes);
            Extreme {
                input: format!("q = {chance}, {lanes} lanes"),
                quantity: "b",
                reference: &one / ((&one - &q) * sum),
                textbook: 1.0 / ((1.0 - chance) * plain),
                ours,
                condition: (slope / ours).abs(),
                worst_of: 1,
            }
        })
        .collect()
}

const fn tried(id: &'static str, label: &'static str, prepare: fn(&mut Bench, u64) -> Heat) -> Entrant {
    lane(id, label, &[16, 64, 256], prepare).repeated(2)
}

fn with(bench: &mut Bench, name: &'static str, tactics: Tactics, work: u64) -> Heat {
    heat(bench, name, Manner { method: Method::Fast(tactics), ..Manner::default() }, work)
}

const TRIED: Race = race("", "").work("paths a pixel").error(ERROR.0, ERROR.1);

// Nets fall a little faster than 1/√N, and the fewer the edges of what is seen the more so.
const ABLATIONS: Race = TRIED.named("ablations", "the box, with one thing done otherwise in each lane").lanes(&[
    tried("own", "as it is", |bench, work| with(bench, "cornell", Tactics::default(), work)).order(0.6, 0.12),
    tried("independent", "independent numbers", |bench, work| {
        heat(bench, "cornell", Manner { choice: Choice::Independent, ..Manner::default() }, work)
    })
    .order(0.5, 0.1),
    tried("early", "early roulette", |bench, work| {
        with(bench, "cornell", Tactics { patience: 2, boost: 1.0, ..Tactics::default() }, work)
    })
    .order(0.55, 0.12),
    tried("lamps", "rays to lamps alone", |bench, work| {
        with(bench, "cornell", Tactics { meeting: Meeting::Lamps, ..Tactics::default() }, work)
    })
    .order(0.6, 0.15),
    tried("chance", "by the surface alone", |bench, work| {
        with(bench, "cornell", Tactics { meeting: Meeting::Chance, ..Tactics::default() }, work)
    })
    .order(0.5, 0.15),
    tried("single", "one lane", |bench, work| with(bench, "cornell", Tactics { lanes: 1, ..Tactics::default() }, work))
        .order(0.6, 0.12),
    tried("simple", "one path at a time in f64, to read", |bench, work| {
        heat(bench, "cornell", Manner { method: Method::Simple(&INTEGRATORS[3]), ..Manner::default() }, work)
    })
    .order(0.6, 0.12),
]);

const PLATES: Race = TRIED.named("plates", "plates of metal under lamps of all sizes: here it is the weights that pay").lanes(&[
    tried("own", "as it is", |bench, work| with(bench, "veach", Tactics::default(), work)).order(0.6, 0.2),
    tried("alike", "nobody asked where noise is", |bench, work| {
        with(bench, "veach", Tactics { pilot: false, ..Tactics::default() }, work)
    })
    .order(0.6, 0.2),
    tried("blind", "a lamp chosen blindly", |bench, work| {
        with(bench, "veach", Tactics { blind_choice: true, ..Tactics::default() }, work)
    })
    .order(0.55, 0.2),
    tried("lamps", "rays to lamps alone", |bench, work| {
        with(bench, "veach", Tactics { meeting: Meeting::Lamps, ..Tactics::default() }, work)
    })
    .breaks(0.25, "a ray to the large lamp seldom meets the narrow lobe of a smooth plate, and then brings very much"),
    tried("chance", "by the surface alone", |bench, work| {
        with(bench, "veach", Tactics { meeting: Meeting::Chance, ..Tactics::default() }, work)
    })
    .breaks(1.0, "the wall sees the smallest lamp under some hundred-thousandths of its hemisphere: hardly any path meets it"),
]);

const GLASS: Race = TRIED
    .named("glass", "a ball of glass: light that it gathers is found from the lamp, and what it shows by more samples")
    .lanes(&[
        tried("own", "as it is", |bench, work| with(bench, "glass", Tactics::default(), work)).order(0.5, 0.2),
        tried("extra", "no more samples behind glass than elsewhere", |bench, work| {
            with(bench, "glass", Tactics { extra: 1, ..Tactics::default() }, work)
        })
        .order(0.5, 0.25),
        tried("caustics", "nothing followed from the lamp", |bench, work| {
            with(bench, "glass", Tactics { caustics: false, ..Tactics::default() }, work)
        })
        .breaks(0.2, "paths from the eye meet the lamp through the glass by chance alone: sparks"),
    ]);

const METALS: Race = TRIED
    .named("metals", "balls of rough metal: what a polished one gathers on the floor is found from the lamp as well")
    .lanes(&[
        tried("own", "as it is", |bench, work| with(bench, "metals", Tactics::default(), work)).order(0.55, 0.2),
        tried("caustics", "nothing followed from the lamp", |bench, work| {
            with(bench, "metals", Tactics { caustics: false, ..Tactics::default() }, work)
        })
        .order(0.5, 0.2),
        tried("alike", "nobody asked where noise is", |bench, work| {
            with(bench, "metals", Tactics { pilot: false, ..Tactics::default() }, work)
        })
        .order(0.55, 0.2),
    ]);

fn time(setting: &Setting) -> Plot {
    const STEPS: u32 = 24;
    let chance = setting.number("chance");
    let panel = |title: &str, waits: bool| {
        let mut dice = stream(0, "path-tracing/lanes/time");
        let mut free = [0_u32; 8];
        let mut chart = Chart::new(
            title,
            Axis::linear("steps", "").range(0.0, f64::from(STEPS)).tick(4.0),
            Axis::linear("lane", "").range(0.5, 8.5).tick(1.0),
        );
        let mut count = 0_u8;
        while free.iter().any(|at| *at < STEPS) {
            // All begin together, or whoever is free begins.
            for (lane, at) in free.iter_mut().enumerate() {
                let end = *at + edges(&mut dice, chance);
                let y = lane as f64 + 1.0;
                let points = [f64::from(*at) + 0.1, f64::from(end.min(STEPS)) - 0.1].map(|x| [x, y]).into();
                if *at < STEPS {
                    chart = chart.with(Mark::Line {
                        label: String::new(),
                        hue: Hue::Nth(count % 4),
                        dash: Dash::Solid,
                        points,
                    });
                }
                count = count.wrapping_add(1);
                *at = end;
            }
            if waits {
                free = [free.into_iter().max().unwrap_or(STEPS); 8];
            }
        }
        Panel::from(chart)
    };
    let panels = vec![panel("each waits for the longest", true), panel("each takes the next path at once", false)];
    Plot::grid(format!("Eight lanes, paths that go on with a chance of {chance}"), 2, panels)
}

fn busy(setting: &Setting) -> Plot {
    let chance = setting.number("chance");
    let curve = |lanes: u32| (0..=98).map(|k| f64::from(k) / 100.0).map(|q| [q, busy_lanes(q, lanes)]).collect();
    let mut chart = Chart::new(
        "",
        Axis::linear("chance to go on q", "").range(0.0, 1.0).tick(0.1),
        Axis::share("share of lanes at work"),
    );
    for (k, lanes) in [2, 4, 8, 16].into_iter().enumerate() {
        chart = chart.line(Hue::Nth(k as u8), format!("{lanes} lanes"), curve(lanes));
    }
    Plot::of("Lanes that wait", chart.at_x(chance, "q"))
}
