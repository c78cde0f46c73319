//! C23: many paths a pixel, and how their mean's error falls.

use super::scenes::{colours, converged, greens, lit, rendered, view};
use super::ways::{ERROR, heat};
use crate::figure::{Axis, Chart, Dash, Hue, Mark, Plot, Shape};
use crate::parameter::{Kind, Parameter, Setting};
use crate::vocabulary::{
    Answer, Bench, Check, Entrant, Exhibit, Heat, Measured, Misled, Quantity, Race, Step, check, exhibit, figure, lane,
    question, race, step,
};
use light::sampling::Choice;
use light::transport::estimate::{Estimate, relative_mse};
use light::transport::simple::INTEGRATORS;
use light::transport::{Manner, Method, Renderer};
use yardstick::order;
use yardstick::random::uniform;
use yardstick::statistics::rms;

const PAIRS: Parameter =
    Parameter::new("pairs", "n", "pairs of paths a pixel", Kind::Count { min: 1, max: 256 }).default("16");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "rate",
    &[PAIRS],
    &[figure(
        "errors",
        "Error against paths a pixel: independent numbers fall as 1/√N; a net is below them, and steeper where light is smooth.",
        errors,
    )],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Many paths a pixel",
    "The mean of N independent paths is off by σ/√N, in any number of dimensions; numbers that avoid each other do better.",
)
.rows(&["C23"])
.questions(&[question(
    "sixteen",
    "A picture has too much noise. You give it sixteen times as many independent paths. By which factor does the error fall?",
    Answer::Number {
        unit: "1",
        tolerance: 0.05,
        right: |_| {
            let error = |pairs| smooth_error(Choice::Independent, pairs, 48);
            // The nearest half of an order.
            let order = (error(8) / error(128)).log(16.0);
            16f64.powf((2.0 * order).round() / 2.0)
        },
        slips: &[
            Misled { value: |_| 16.0, reply: "The variance of the mean falls by that; the error is its root." },
            Misled { value: |_| 2.0, reply: "That is the fourth root: so it would be if errors added up partly." },
        ],
    },
    "By four: σ/√N. A digit more costs a hundred times the work.",
)])
.readout(|setting| {
    let pairs = setting.number("pairs") as u32;
    let found = rendered(&view("cornell", SIDE), &Manner::default(), pairs);
    let guess = Estimate::of(&found, SIDE);
    let truth = relative_mse(&colours(&found), &converged("cornell", SIDE, 1024)).sqrt();
    let quantity = |key, symbol, says, value| Quantity { key, symbol, says, value, unit: "1" };
    vec![
        quantity("told", "ε_{AB}", "relative error of the box, told by its own two halves", guess.relative_error()),
        quantity("true", "ε", "and against one that is all but converged", truth),
    ]
})
.checks(&[&INDEPENDENT, &NET])
.races(&[BOX, METALS, SMOOTH]);

/// Pixels along a side.
const SIDE: u32 = 16;

const INDEPENDENT: Check<fn(u32) -> u32> =
    check("independent", "the box's error falls as the root of the number of independent paths")
        .against("a picture by 2048 paths a pixel, against those by 4 to 256")
        .order(
            0.5,
            0.08,
            "σ/√N; each of four errors is the root mean square of 768 numbers with long tails, known to 8 %",
        )
        .of(
            |_: &mut Bench, pairs: fn(u32) -> u32| {
                let exact = converged("cornell", SIDE, 1024);
                let points = [2, 8, 32, 128].map(|count: u32| {
                    let error = |seed| {
                        let manner = Manner { choice: Choice::Independent, seed, ..Manner::default() };
                        let found = colours(&rendered(&view("cornell", SIDE), &manner, pairs(count)));
                        relative_mse(&found, &exact).sqrt()
                    };
                    (f64::from(2 * count), rms(&[1, 2].map(error)))
                });
                Measured::new(order::slope(&points).map_or(f64::NAN, |slope| -slope), "4 to 256 paths", points.len())
            },
            |pairs| pairs,
        )
        .slip("the same four paths again and again", |_| 2);

const NET: Check<Choice> = check("net", "where the light is smooth, a scrambled net gains a whole order")
    .against("ρE/π by Lambert's closed form, rms over 32 seeds, of 8 to 512 rays to a square lamp that nothing hides")
    .order(1.4, 0.2, "N^−3/2 √ln N (A. B. Owen, Ann. Statist. 25 (1997) 1541), whose logarithm takes 0.13 off here; 32 seeds know each error to 12 %, the slope to 0.04")
    .of(
        |_: &mut Bench, choice: Choice| {
            let points = [4, 16, 64, 256].map(|pairs| (f64::from(pairs), smooth_error(choice, pairs, 32)));
            Measured::new(order::slope(&points).map_or(f64::NAN, |slope| -slope), "8 to 512 rays", points.len())
        },
        Choice::Net,
    )
    .slip("independent numbers", Choice::Independent);

/// Rays to a lamp over a floor that sees all of it.
fn smooth_manner(choice: Choice, seed: u64) -> Manner {
    Manner { method: Method::Simple(&INTEGRATORS[2]), choice, seed, ..Manner::default() }
}

/// Their relative error [1], rms over seeds.
fn smooth_error(choice: Choice, pairs: u32, seeds: u64) -> f64 {
    let (scene, exact) = lit([0.9, 0.2], 1.0, 0.005, 1);
    let error = |seed| greens(&rendered(&scene, &smooth_manner(choice, seed), pairs)).mean() / exact - 1.0;
    rms(&(0..seeds).map(error).collect::<Vec<_>>())
}

const fn numbers(id: &'static str, label: &'static str, prepare: fn(&mut Bench, u64) -> Heat) -> Entrant {
    lane(id, label, &[4, 16, 64, 256], prepare).repeated(2)
}

fn of(bench: &mut Bench, name: &'static str, choice: Choice, work: u64) -> Heat {
    heat(bench, name, Manner { choice, ..Manner::default() }, work)
}

const PICTURES: Race = race("", "").work("paths a pixel").error(ERROR.0, ERROR.1);

const BOX: Race =
    PICTURES.named("cornell", "the box: edges of blocks and lamp leave a net little more than half an order").lanes(&[
        numbers("independent", "independent", |bench, work| of(bench, "cornell", Choice::Independent, work))
            .order(0.5, 0.1),
        // Between that and the ¾ that an edge leaves in two dimensions.
        numbers("net", "scrambled net", |bench, work| of(bench, "cornell", Choice::Net, work)).order(0.6, 0.12),
    ]);

const METALS: Race = PICTURES.named("metals", "rough metals under a lamp and a sky").lanes(&[
    numbers("independent", "independent", |bench, work| of(bench, "metals", Choice::Independent, work))
        .order(0.5, 0.12),
    numbers("net", "scrambled net", |bench, work| of(bench, "metals", Choice::Net, work)).order(0.6, 0.15),
]);

const SMOOTH: Race = race("smooth", "a lamp that all of the floor sees: a net gains a whole order")
    .work("rays to the lamp")
    .error("relative error of L", "rms over 32 seeds of the relative error, against Lambert's closed form")
    .lanes(&[
        lane("independent", "independent", &[8, 32, 128, 512], |bench, work| smooth(bench, Choice::Independent, work))
            .repeated(32)
            .order(0.5, 0.12),
        lane("net", "scrambled net", &[8, 32, 128, 512], |bench, work| smooth(bench, Choice::Net, work))
            .repeated(32)
            .order(1.4, 0.2),
    ]);

fn smooth(bench: &mut Bench, choice: Choice, work: u64) -> Heat {
    let seed = uniform(&mut bench.stream, 0.0, 1.0).to_bits();
    let ((scene, exact), pairs) = (lit([0.9, 0.2], 1.0, 0.005, 1), (work / 2) as u32);
    let renderer = Renderer::new(&scene, &smooth_manner(choice, seed), pairs).expect("a floor and a lamp");
    Heat {
        run: Box::new(move || vec![greens(&super::scenes::halves(&renderer, &scene, pairs)).mean()]),
        error: Box::new(move |found| (found[0] / exact - 1.0).abs()),
    }
}

fn errors(setting: &Setting) -> Plot {
    let own = setting.number("pairs") as u32;
    let counts = [1, 2, 4, 8, 16, 32, 64, 128];
    let error = |name, choice, pairs| {
        let manner = Manner { choice, seed: 5, ..Manner::default() };
        relative_mse(&colours(&rendered(&view(name, SIDE), &manner, pairs)), &converged(name, SIDE, 1024)).sqrt()
    };
    let mut chart = Chart::new(
        "",
        Axis::log("paths a pixel N", "").range(1.5, 600.0),
        Axis::log("relative error of the picture", ""),
    );
    for (k, (name, says)) in [("cornell", "box"), ("metals", "metals")].into_iter().enumerate() {
        for (choice, shape, how) in
            [(Choice::Independent, Shape::Ring, "independent"), (Choice::Net, Shape::Disc, "scrambled net")]
        {
            let points = counts.iter().map(|pairs| [f64::from(2 * pairs), error(name, choice, *pairs)]).collect();
            chart = chart.with(Mark::Points {
                label: format!("{says}, {how}"),
                hue: Hue::Nth(k as u8),
                shape,
                joined: true,
                points,
            });
        }
    }
    let smooth = |choice| counts.iter().map(|pairs| [f64::from(2 * pairs), smooth_error(choice, *pairs, 16)]).collect();
    for (choice, shape, how) in
        [(Choice::Independent, Shape::Ring, "independent"), (Choice::Net, Shape::Disc, "scrambled net")]
    {
        chart = chart.with(Mark::Points {
            label: format!("lit floor, {how}"),
            hue: Hue::Nth(2),
            shape,
            joined: true,
            points: smooth(choice),
        });
    }
    let line = [2.0, 512.0].map(|n: f64| [n, 1.0 / n.sqrt()]).into();
    chart = chart.with(Mark::Line { label: "1/√N".into(), hue: Hue::Reference, dash: Dash::Dashed, points: line });
    let own = [[f64::from(2 * own), error("cornell", Choice::Net, own)]].into();
    chart = chart.with(Mark::Points {
        label: "box, as many as are set".into(),
        hue: Hue::Ours,
        shape: Shape::Diamond,
        joined: false,
        points: own,
    });
    Plot::of("How the error of a picture falls", chart)
}
