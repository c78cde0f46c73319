//! C2: conduction makes Ampère's law stiff in every cell.

use crate::figure::{Axis, Chart, Dash, Hue, Mark, Plot, Shape};
use crate::parameter::{Alias, Kind, Parameter, Setting};
use crate::symbols::{E, EPSILON, H, SIGMA, T};
use crate::vocabulary::{
    Answer, Exhibit, Expects, Extreme, Heat, Lane, Misled, Quantity, Question, Race, Step, derivation, exhibit, figure,
    lane, question, race, statement, step, stress,
};
use equation::derivation::Chain;
use equation::expr::{curl, exp, partial};
use equation::{Dimension, Equation, Expr, Symbol};
use light::em::Conduction;
use light::references::waves as exact;
use light::waves::conduction::{Cell, Scheme, Update};
use yardstick::precise;

const TANGENT: Parameter =
    Parameter::new("loss_tangent", "σ/(ωε)", "conduction over displacement current", Kind::number(1e-6, 1e12, "1"))
        .default("100")
        .aliases(&[Alias::same("tau")]);
const STEPS: Parameter =
    Parameter::new("steps", "N", "steps from ωt = 0 to 5", Kind::Count { min: 1, max: 100_000 }).default("64");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "conduction",
    &[TANGENT, STEPS],
    &[
        figure(
            "stiffness",
            "The error of each way to step E over 18 decades of conduction, and what it does \
             to a transient.",
            stiffness,
        )
        .rows(&["C2"]),
        figure("ringing", "E of a cell, from a start that is not its own, at four steps a radian.", ringing)
            .rows(&["C2"]),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Stiff cells",
    "Charge relaxes within ε/σ while the wave takes its time: only some ways to step E \
     survive the ratio of the two.",
)
.rows(&["C2", "E18"])
.statements(&[
    statement("relaxation", "Ampère's law in a conductor: E relaxes towards the curl", || {
        Equation::new(EPSILON * partial(E, T), curl(H) - SIGMA * E)
    })
    .rows(&["C2"]),
    statement("exponential_step", "the exact step while the curl stays what it is", || {
        Equation::new(RELAXED, relaxed())
    })
    .rows(&["C2"]),
])
.questions(&[LONGEST])
.derivations(&[derivation("solves_ampere", "the exponential step, put into Ampère's law", || {
    step_obeys(DRIVE.into())
})
.rows(&["C2"])
.slip("the curl forgets what E was at the start", || step_obeys(DRIVE - SIGMA * START))])
.readout(readout)
.stress(&[stress(
    "coefficients",
    "what the grid multiplies E by in a step keeps its digits from the best insulator \
     to the perfect conductor, and so does what it loses",
    |_| coefficients(),
)
.rows(&["C2"])
.textbook("the coefficients as they are usually programmed, 1 − e^(−x) and all")
.against("the same in 256 bits")])
.races(&[
    RACE.named("insulator", "an insulator, σ/(ωε) = 10⁻⁶: nothing is stiff, and order wins").lanes(&INSULATOR),
    RACE.named(
        "conductor",
        "a conductor, σ/(ωε) = 10⁶: forward Euler explodes, the usual update rings, the \
         exponential one is late",
    )
    .lanes(&CONDUCTOR),
    RACE.named("metal", "a metal, σ/(ωε) = 10¹²: the same, only more so").lanes(&METAL),
]);

const LONGEST: Question = question(
    "longest",
    "In a conducting cell E relaxes within ε/σ. Forward Euler is used. How many such times may a step last at most \
     before the field explodes?",
    Answer::Number {
        unit: "1",
        tolerance: 0.01,
        right: |_| {
            let explodes = |x: &f64| Update::new(Scheme::ForwardEuler, 1.0, *x, 1.0).keep.abs() > 1.0;
            (1..).map(|thousandth| f64::from(thousandth) / 1000.0).find(explodes).unwrap_or(f64::NAN)
        },
        slips: &[
            Misled {
                value: |_| 1.0,
                reply: "A step of one such time lands on the goal. A longer one overshoots, but not yet by more \
                 than it was off before.",
            },
            Misled { value: |_| 0.5, reply: "There a step goes half the way to the goal: slow, but safe." },
        ],
    },
    "Two: from there on each step overshoots by more than it was off. In copper two relaxation times are far less \
     than a femtosecond.",
);

const START: Symbol = Symbol::scalar("E_0", Dimension::VOLT_PER_METRE);
const RELAXED: Symbol = Symbol::scalar("E", Dimension::VOLT_PER_METRE);
/// ∇×H, held.
const DRIVE: Symbol = Symbol::scalar("q", Dimension::AMPERE_PER_SQUARE_METRE);

fn relaxed() -> Expr {
    let keep = || exp(-(SIGMA * T / EPSILON));
    keep() * START + (1 - keep()) / SIGMA * DRIVE
}

fn step_obeys(last: Expr) -> Chain {
    Chain::new(EPSILON * partial(RELAXED, T) + SIGMA * RELAXED)
        .given(RELAXED, relaxed(), "the step")
        .then(last, ["chain rule"])
        .because("∇×H = σE + ε∂E/∂t with the curl held at q")
}

/// Where the runs end, ωt.
const END: f64 = 5.0;

const NAMES: [(Scheme, &str); 4] = [
    (Scheme::ForwardEuler, "forward Euler"),
    (Scheme::SemiImplicit, "semi-implicit"),
    (Scheme::Exponential, "exponential"),
    (Scheme::BackwardEuler, "backward Euler"),
];

fn cell(tau: f64) -> Cell {
    Cell::new(tau).expect("a loss tangent within range")
}

fn error_after(scheme: Scheme, tau: f64, steps: u64) -> f64 {
    let cell = cell(tau);
    (cell.march(scheme, 0.0, END, steps) - cell.exact(0.0, END)).abs()
}

fn readout(setting: &Setting) -> Vec<Quantity> {
    let (tau, steps) = (setting.number("loss_tangent"), setting.number("steps"));
    let x = tau * END / steps;
    let value = |key, symbol, says, value| Quantity { key, symbol, says, value, unit: "1" };
    let keys = ["forward_euler", "semi_implicit", "exponential", "backward_euler"];
    let kept = NAMES
        .into_iter()
        .zip(keys)
        .map(|((scheme, name), key)| value(key, "E′/E", name, Update::new(scheme, 1.0, tau, END / steps).keep));
    [value("x", "σΔt/ε", "relaxation times in a step", x)].into_iter().chain(kept).collect()
}

fn coefficients() -> Vec<Extreme> {
    let ratios = [0.0, 1e-300, 1e-18, 1e-12, 1e-6, 1e-3, 1.0, 30.0, 1e6, 1e15];
    let schemes = [
        (Conduction::SemiImplicit, Scheme::SemiImplicit, "semi-implicit"),
        (Conduction::Exponential, Scheme::Exponential, "exponential"),
    ];
    let cases = schemes.into_iter().flat_map(|scheme| ratios.map(|x| (scheme, x)));
    cases
        .flat_map(|((conduction, scheme, name), x)| {
            // In units of ε and Δt.
            let (ours, book) = (conduction.update(x), Update::as_written(scheme, 1.0, x, 1.0));
            let [keep, loss, gain] = exact::update(scheme, 1.0, x, 1.0);
            let rows = [
                ("C_a", keep, book.keep, ours.keep),
                ("1 − C_a", loss, book.loss, ours.loss),
                ("C_b", gain, book.gain, ours.gain),
            ];
            // Of what lies below the range of f64 there are no digits to keep.
            let kept = rows
                .into_iter()
                .filter(|(_, (exact, _), ..)| exact.repr().significand().is_zero() || precise::to_f64(exact) != 0.0);
            kept.map(|(quantity, (reference, condition), textbook, ours)| Extreme {
                input: format!("{name}, σΔt/ε = {x:e}"),
                quantity,
                reference,
                textbook,
                ours,
                condition,
                worst_of: 1,
            })
            .collect::<Vec<_>>()
        })
        .collect()
}

const RACE: Race = race("", "")
    .work("steps (Radau: its tolerance is (10/N)⁵)")
    .error("|ΔE| over the final amplitude", "the closed form of a cell driven from rest by a harmonic curl, at ωt = 5")
    .lanes(&[]);

/// Exponents of ten of σ/(ωε).
const SLOW: i32 = -6;
const FAST: i32 = 6;
const FASTEST: i32 = 12;

const fn order(order: f64) -> Expects {
    Expects::Order { order, tolerance: 0.15 }
}

const BLOWS_UP: Expects = Expects::Breaks { limit: 1e3, why: "σΔt/ε is beyond 2" };
const RINGS: Expects =
    Expects::Breaks { limit: 0.5, why: "the transient changes its sign at every step instead of dying" };
/// Its error goes as tolerance^(5/6), here (10/N)^(25/6), in stairs because steps are halved.
const RADAU_RESOLVES: Expects = Expects::Order { order: 4.0, tolerance: 0.6 };
const RADAU_FOLLOWS: Expects =
    Expects::Within { limit: 1e-11, why: "it is L-stable: the fast part is in balance, the slow one easy" };

const INSULATOR: [Lane; 5] = lanes::<SLOW>([order(1.0), order(2.0), order(2.0), order(1.0), RADAU_RESOLVES]);
const CONDUCTOR: [Lane; 5] = lanes::<FAST>([BLOWS_UP, RINGS, order(1.0), order(1.0), RADAU_FOLLOWS]);
const METAL: [Lane; 5] = lanes::<FASTEST>([
    BLOWS_UP,
    RINGS,
    order(1.0),
    Expects::Within { limit: 1e-11, why: "what the field lacks of the curl is ωε/σ of it" },
    RADAU_FOLLOWS,
]);

/// Every way to step a cell whose σ/(ωε) is 10^`EXPONENT`.
const fn lanes<const EXPONENT: i32>([euler, semi, exponential, backward, radau]: [Expects; 5]) -> [Lane; 5] {
    const fn entrant(id: &'static str, label: &'static str, expects: Expects, prepare: Prepare) -> Lane {
        lane(id, label, &[64, 128, 256, 512, 1024, 2048], prepare).expects(expects)
    }
    [
        entrant("forward_euler", "forward Euler", euler, |_, n| march::<EXPONENT>(Scheme::ForwardEuler, n)),
        entrant("semi_implicit", "semi-implicit", semi, |_, n| march::<EXPONENT>(Scheme::SemiImplicit, n)),
        entrant("exponential", "exponential", exponential, |_, n| march::<EXPONENT>(Scheme::Exponential, n)),
        entrant("backward_euler", "backward Euler", backward, |_, n| march::<EXPONENT>(Scheme::BackwardEuler, n)),
        entrant("radau", "Radau IIA, adaptive", radau, |_, n| adapt::<EXPONENT>(n)),
    ]
}

type Prepare = fn(&mut crate::vocabulary::Bench, u64) -> Heat;

fn judged<const EXPONENT: i32>(mut run: impl FnMut(&Cell) -> f64 + 'static) -> Heat {
    let cell = cell(10f64.powi(EXPONENT));
    let exact = cell.exact(0.0, END);
    Heat { run: Box::new(move || vec![run(&cell)]), error: Box::new(move |found| (found[0] - exact).abs()) }
}

fn march<const EXPONENT: i32>(scheme: Scheme, steps: u64) -> Heat {
    judged::<EXPONENT>(move |cell| cell.march(scheme, 0.0, END, steps))
}

fn adapt<const EXPONENT: i32>(steps: u64) -> Heat {
    let tolerance = (10.0 / steps as f64).powi(5);
    judged::<EXPONENT>(move |cell| cell.adaptive(0.0, END, tolerance).map_or(f64::NAN, |found| found.y))
}

fn stiffness(setting: &Setting) -> Plot {
    let steps = setting.number("steps") as u64;
    // Where two do alike, the dashes of the one let the other through.
    let styles = [Dash::Solid, Dash::Solid, Dash::Dashed, Dash::Dashed];
    let errors = Chart::new(
        format!("error after {steps} steps"),
        Axis::log("conduction σ/(ωε)", "").range(1e-6, 1e12),
        Axis::log("|ΔE| over the final amplitude", "").range(1e-16, 1e4),
    );
    let errors = NAMES.iter().zip(styles).enumerate().fold(errors, |chart, (at, ((scheme, name), dash))| {
        let points = (-48..=96).map(|eighth| {
            let tau = 10f64.powf(f64::from(eighth) / 8.0);
            [tau, error_after(*scheme, tau, steps)]
        });
        let (finite, lost): (Vec<_>, Vec<_>) = points.partition(|point: &[f64; 2]| point[1].is_finite());
        let hue = Hue::Nth(at as u8);
        let chart = chart.with(Mark::Line { label: (*name).into(), hue, dash, points: finite });
        let at = lost.iter().step_by(4).map(|point| point[0]).collect();
        chart.with(Mark::Broken { hue, shape: Shape::Triangle, at })
    });
    let adaptive = (-12..=24).map(|half| {
        let tau = 10f64.powf(f64::from(half) / 2.0);
        let found = cell(tau).adaptive(0.0, END, 1e-9).map_or(f64::NAN, |found| found.y);
        [tau, (found - cell(tau).exact(0.0, END)).abs().max(1e-16)]
    });
    let errors = errors.line(Hue::Nth(4), "Radau IIA, tolerance 10⁻⁹", adaptive.collect());
    let transient = Chart::new(
        "what a step keeps of E",
        Axis::log("relaxation times in a step σΔt/ε", "").range(1e-3, 1e3),
        Axis::linear("E′/E", "").range(-2.0, 1.0),
    )
    .at_y(-1.0, "unstable below");
    let transient = NAMES.iter().enumerate().fold(transient, |chart, (at, (scheme, _))| {
        let ratios = (-120..=120).map(|at| 10f64.powf(f64::from(at) / 40.0));
        let curve = ratios.map(|x| [x, Update::new(*scheme, 1.0, x, 1.0).keep]).collect();
        let dash = styles[at];
        chart.with(Mark::Line { label: String::new(), hue: Hue::Nth(at as u8), dash, points: curve })
    });
    Plot::grid("A conducting cell, driven from rest", 2, vec![errors.into(), transient.into()])
}

fn ringing(setting: &Setting) -> Plot {
    let tangent = setting.number("loss_tangent");
    let of = cell(tangent);
    let (start, step) = (1.5, 0.25);
    let fine = (0..=600).map(|at| f64::from(at) / 100.0).map(|theta| [theta, of.exact(start, theta)]);
    let mut chart = Chart::new(
        format!("σ/(ωε) = {}", crate::parameter::number(tangent)),
        Axis::linear("ωt", "rad").range(0.0, 6.0),
        Axis::linear("E over its final amplitude", "").range(-2.0, 2.0),
    )
    .line(Hue::Natural, "exact", fine.collect());
    for (at, (scheme, name)) in NAMES.into_iter().enumerate() {
        let stepped = (0..=24u64).map(|steps| {
            let theta = step * steps as f64;
            [theta, if steps == 0 { start } else { of.march(scheme, start, theta, steps) }]
        });
        // What has left the chart only flashes across it from then on: the step that takes it away is the last.
        let stepped: Vec<_> = stepped.collect();
        let inside = stepped.iter().take_while(|point| point[1].abs() < 2.0).count();
        let points = stepped.into_iter().take(inside + 1);
        chart = chart.with(Mark::Points {
            label: name.into(),
            hue: Hue::Nth(at as u8),
            shape: SHAPES[at],
            joined: true,
            points: points.collect(),
        });
    }
    Plot::of("A conducting cell, stepped", chart)
}

const SHAPES: [Shape; 4] = [Shape::Triangle, Shape::Square, Shape::Disc, Shape::Diamond];
