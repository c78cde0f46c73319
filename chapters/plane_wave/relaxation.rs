//! E18 in time: Ampère's law with a current is stiff.

use super::quantity;
use super::symbols::{E, EPSILON, H, SIGMA, T};
use crate::figure::{Axis, Chart, Dash, Hue, Mark, Plot, Shape};
use crate::setting::{Kind, Parameter, Setting};
use crate::vocabulary::{Bench, Expects, Extreme, Figure, Heat, Lane, Quantity, Race, Statement, Step, Stress, rms};
use light::equation::Equation;
use light::equation::expr::{curl, partial};
use light::evidence::waves::{cell, update};
use light::precise;
use light::waves::conduction::{Cell, Scheme, Update};
use std::f64::consts::{PI, TAU};

pub(super) const STEP: Step = Step {
    id: "relaxation",
    title: "Stiff in time",
    says: "A good conductor forgets its charges in 1e−19 s, and a method that has to follow that never gets anywhere.",
    rows: &["E18"],
    parameters: &[TANGENT],
    statements: &[Statement {
        id: "ampere",
        says: "what a cell of a grid has to solve, with J = σE",
        rows: &["E18"],
        equation: || Equation::new(EPSILON * partial(E, T), curl(H) - SIGMA * E),
    }],
    derivations: &[],
    readout: Some(readout),
    checks: &[],
    stress: &[Stress {
        id: "coefficients",
        claim: "the update coefficients of a conducting cell keep their digits from σΔt/ε = 1e−18 to 1e18",
        rows: &["E18"],
        textbook: "Ca and Cb as usually programmed, 1 − Ca formed from Ca",
        reference: "the same coefficients in 256 bits; κ from difference quotients",
        cases: |_| coefficients(),
    }],
    races: &[LOOSE, STIFF],
    figures: &[
        Figure {
            id: "ringing",
            says: "E of a cell, from a start that is not its own, by four methods at four steps a radian.",
            rows: &["E18"],
            plot: ringing,
        },
        Figure {
            id: "stiffness",
            says: "Error over the second period at sixty-four steps a period, against σ/(ωε) over eighteen decades.",
            rows: &["E18"],
            plot: stiffness,
        },
    ],
};

const TANGENT: Parameter = Parameter {
    name: "loss_tangent",
    symbol: "σ/(ωε)",
    says: "conduction over displacement current",
    default: "20",
    kind: Kind::Number { min: 1e-6, max: 1e12, unit: "1" },
};

fn readout(setting: &Setting) -> Vec<Quantity> {
    let tangent = setting.number("loss_tangent");
    let steps = (tangent * PI).ceil().max(1.0);
    vec![
        quantity("relaxation", "ωε/σ", "by how much the field turns until a charge is forgotten", 1.0 / tangent, "rad"),
        quantity("explicit_steps", "N", "steps a period that forward Euler needs so as not to blow up", steps, "1"),
    ]
}

fn coefficients() -> Vec<Extreme> {
    // ε of the vacuum, so that x = σΔt/ε comes from quantities of the sizes that a grid has.
    let (epsilon, dt) = (light::waves::constants::EPSILON_0, 1e-17);
    let stiffness = [1e-18, 1e-12, 1e-9, 1e-6, 1e-3, 1.0, 30.0, 1e6, 1e18];
    let each = Scheme::ALL.into_iter().flat_map(|scheme| stiffness.map(|x| (scheme, x)));
    each.flat_map(|(scheme, x)| {
        let sigma = x * epsilon / dt;
        let (ours, written) = (Update::new(scheme, epsilon, sigma, dt), Update::as_written(scheme, epsilon, sigma, dt));
        let of = |update: Update| [("Ca", update.keep), ("1 − Ca", update.loss), ("Cb", update.gain)];
        let exact = update(scheme, epsilon, sigma, dt);
        let cases = of(ours).into_iter().zip(of(written)).zip(exact);
        cases
            .map(|(((quantity, ours), (_, textbook)), (reference, condition))| Extreme {
                input: format!("{scheme:?}, σΔt/ε = {x:e}"),
                quantity,
                reference,
                textbook,
                ours,
                condition,
                worst_of: 1,
            })
            .collect::<Vec<_>>()
    })
    .filter(|case| precise::to_f64(&case.reference).abs() > f64::MIN_POSITIVE)
    .collect()
}

/// Half a period and a little, so that neither sine nor cosine vanishes at the end.
const END: f64 = 3.5;

const LOOSE: Race = Race {
    id: "loose",
    claim: "where charges relax as fast as the field turns every method has its order, and the adaptive one its price",
    rows: &["E18"],
    work: "steps (for Radau: 1/tolerance)",
    error: "error of E over its amplitude",
    reference: "the closed form of the cell in 256 bits, σ/(ωε) = 1, from E = 0, after 3.5 radians",
    lanes: &[
        Lane::once("forward_euler", "forward Euler", STEPS, order(1.0), |_, work| {
            marched(1.0, Scheme::ForwardEuler, work)
        }),
        Lane::once("backward_euler", "backward Euler", STEPS, order(1.0), |_, work| {
            marched(1.0, Scheme::BackwardEuler, work)
        }),
        Lane::once("semi_implicit", "semi-implicit", STEPS, order(2.0), |_, work| {
            marched(1.0, Scheme::SemiImplicit, work)
        }),
        Lane::once("exponential", "exponential", STEPS, order(2.0), |_, work| marched(1.0, Scheme::Exponential, work)),
        radau(|_, work| adaptive(1.0, work)),
    ],
};

const STIFF: Race = Race {
    id: "stiff",
    claim: "where charges relax a million times faster only methods that may skip it are of use",
    reference: "the closed form of the cell in 256 bits, σ/(ωε) = 1e6, from E = 0, after 3.5 radians",
    lanes: &[
        // From 128 steps on it overflows, which spares the others a plot of three hundred decades.
        Lane::once("forward_euler", "forward Euler", &[128, 512, 2048], BLOWS_UP, |_, work| {
            marched(1e6, Scheme::ForwardEuler, work)
        }),
        Lane::once("semi_implicit", "semi-implicit", STEPS, RINGS, |_, work| marched(1e6, Scheme::SemiImplicit, work)),
        Lane::once("exponential", "exponential", STEPS, order(1.0), |_, work| marched(1e6, Scheme::Exponential, work)),
        Lane::once("backward_euler", "backward Euler", STEPS, BALANCED, |_, work| {
            marched(1e6, Scheme::BackwardEuler, work)
        }),
        radau(|_, work| adaptive(1e6, work)),
    ],
    ..LOOSE
};

const fn order(order: f64) -> Expects {
    Expects::Order { order, tolerance: 0.2 }
}

const BLOWS_UP: Expects = Expects::Breaks { limit: 1e3, why: "it needs two million steps to be stable" };
const RINGS: Expects = Expects::Breaks { limit: 0.5, why: "the start is never forgotten: it rings with (−1)ⁿ" };
const BALANCED: Expects =
    Expects::Within { limit: 1e-5, why: "with ∇×H at the new time the fast part is simply in balance" };

const STEPS: &[u64] = &[32, 128, 512, 2048];

const fn radau(prepare: fn(&mut Bench, u64) -> Heat) -> Lane {
    let expects = Expects::Within { limit: 0.05, why: "a few times the loosest tolerance asked for, 1e−2" };
    Lane::once("radau", "Radau IIA, own steps", &[100, 10_000, 1_000_000, 100_000_000], expects, prepare)
}

fn marched(tangent: f64, scheme: Scheme, work: u64) -> Heat {
    let of = Cell::new(tangent).expect("a loss tangent");
    judged(tangent, move || of.march(scheme, 0.0, END, work))
}

fn adaptive(tangent: f64, work: u64) -> Heat {
    let of = Cell::new(tangent).expect("a loss tangent");
    judged(tangent, move || of.adaptive(0.0, END, 1.0 / work as f64).map_or(f64::NAN, |found| found.field))
}

fn judged(tangent: f64, mut run: impl FnMut() -> f64 + 'static) -> Heat {
    Heat {
        run: Box::new(move || vec![run()]),
        // Over the amplitude, which is 1.
        error: Box::new(move |found| {
            let exact = cell(tangent, 0.0, END);
            if found[0].is_finite() { precise::to_f64(&(precise::real(found[0]) - exact)).abs() } else { f64::INFINITY }
        }),
    }
}

fn ringing(setting: &Setting) -> Plot {
    let tangent = setting.number("loss_tangent");
    let of = Cell::new(tangent).expect("within the parameter's domain");
    let (start, step) = (1.5, 0.25);
    let fine = (0..=600).map(|at| f64::from(at) / 100.0).map(|theta| [theta, of.exact(start, theta)]);
    let mut chart = Chart::new(
        format!("σ/(ωε) = {}", crate::setting::number(tangent)),
        Axis::linear("ωt", "rad").range(0.0, 6.0),
        Axis::linear("E over its final amplitude", "").range(-2.0, 2.0),
    )
    .line(Hue::Natural, "exact", fine.collect());
    for (at, scheme) in Scheme::ALL.into_iter().enumerate() {
        let stepped = (0..=24u64).map(|steps| {
            let theta = step * steps as f64;
            [theta, if steps == 0 { start } else { of.march(scheme, start, theta, steps) }]
        });
        // What has left the chart only flashes across it from then on.
        let points = stepped.take_while(|point| point[1].abs() < 10.0);
        chart = chart.with(Mark::Points {
            label: name(scheme).into(),
            hue: Hue::Nth(at as u8),
            shape: SHAPES[at],
            joined: true,
            points: points.collect(),
        });
    }
    Plot::of("A conducting cell, stepped", chart)
}

const SHAPES: [Shape; 4] = [Shape::Triangle, Shape::Square, Shape::Disc, Shape::Diamond];

fn name(scheme: Scheme) -> &'static str {
    match scheme {
        Scheme::ForwardEuler => "forward Euler",
        Scheme::SemiImplicit => "semi-implicit",
        Scheme::Exponential => "exponential",
        Scheme::BackwardEuler => "backward Euler",
    }
}

fn stiffness(setting: &Setting) -> Plot {
    let tangents = || (0..=180).map(|at| 10f64.powf(f64::from(at) / 10.0 - 6.0));
    let chart = Chart::new(
        "64 steps a period, from the steady oscillation",
        Axis::log("σ/(ωε)", "").range(1e-6, 1e12),
        Axis::log("error of E over its amplitude", "").range(1e-16, 1e4),
    );
    // Over a whole period, so that no zero of the error passes for accuracy.
    let error = |scheme: Scheme, tangent: f64| {
        let of = Cell::new(tangent).expect("within the domain");
        let off = |steps: u64| {
            let theta = steps as f64 * TAU / 64.0;
            of.march(scheme, of.settled(0.0), theta, steps) - of.settled(theta)
        };
        let error = rms(&(65..=128).step_by(7).map(off).collect::<Vec<_>>());
        [tangent, if error.is_finite() { error.max(1e-16) } else { f64::NAN }]
    };
    // Forward Euler last and dashed: where it is stable it errs as much as backward Euler.
    let chart = Scheme::ALL.into_iter().enumerate().rev().fold(chart, |chart, (at, scheme)| {
        let points = tangents().map(|tangent| error(scheme, tangent)).collect();
        let dash = if scheme == Scheme::ForwardEuler { Dash::Dashed } else { Dash::Solid };
        chart.with(Mark::Line { label: name(scheme).into(), hue: Hue::Nth(at as u8), dash, points })
    });
    Plot::of("Where each method is of use", chart.at_x(setting.number("loss_tangent"), "the setting"))
}
