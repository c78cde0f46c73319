//! E9, E10: one dimension, and d'Alembert's solution.

use super::grid::{Ring, Stencil};
use super::rms_difference;
use super::symbols::{E, EPSILON, F_1, F_2, MU, T, WAVE, Z};
use super::wave_equation::twice;
use crate::figure::{Axis, Chart, Hue, Map, Plot, Ramp};
use crate::setting::Setting;
use crate::vocabulary::{
    Bound, Check, Derivation, Expects, Figure, Heat, Lane, Measured, Race, Statement, Step, fitted_order,
};
use light::equation::derivation::Chain;
use light::equation::expr::{laplacian, sqrt, vector};
use light::equation::{Equation, Expr};
use light::waves::harmonics::Spectrum;

pub(super) const STEP: Step = Step {
    id: "dalembert",
    title: "Two shapes, running apart",
    says: "In one dimension every solution is one shape that runs to the right and one that runs to the left.",
    rows: &["E9", "E10"],
    parameters: &[],
    statements: &[
        Statement {
            id: "one_dimension",
            says: "the wave equation of a field that depends on z and t alone",
            rows: &["E9"],
            equation: || Equation::new(operator(&WAVE.at([Z.into(), T.into()]), EPSILON * MU), 0),
        },
        Statement {
            id: "solution",
            says: "d'Alembert's solution, for any two shapes that have two derivatives",
            rows: &["E10"],
            equation: || Equation::new(WAVE.at([Z.into(), T.into()]), running_apart()),
        },
    ],
    derivations: &[
        Derivation {
            id: "reduction",
            says: "the wave equation of a field along x that is the same for all x and y",
            rows: &["E9"],
            chain: || reduction(EPSILON * MU),
            spoiled: || reduction(-(EPSILON * MU)),
            slip: "the sign of Laplace's equation",
        },
        Derivation {
            id: "chain_rule",
            says: "each shape brings the same factor twice: (±1/√(εμ))²",
            rows: &["E10"],
            chain: || chain_rule(running_apart()),
            spoiled: || chain_rule(F_1.at([Z - T / sqrt(EPSILON * MU)]) + F_2.at([Z + 2 * T / sqrt(EPSILON * MU)])),
            slip: "the second shape runs at twice the speed",
        },
    ],
    readout: None,
    checks: &[DIFFERENCES, ONE_CELL_A_STEP],
    stress: &[],
    races: &[SMOOTH, SQUARE],
    figures: &[
        Figure {
            id: "space_time",
            says: "Two pulses in space and time: each keeps its shape and its slope, and where they meet they add.",
            rows: &["E10"],
            plot: space_time,
        },
        Figure { id: "strip", says: "The same two pulses at six instants.", rows: &["E10"], plot: strip },
    ],
};

/// (∂²/∂z² − `slowness` ∂²/∂t²) f
fn operator(f: &Expr, slowness: Expr) -> Expr {
    twice(f, Z) - slowness * twice(f, T)
}

fn running_apart() -> Expr {
    F_1.at([Z - T / sqrt(EPSILON * MU)]) + F_2.at([Z + T / sqrt(EPSILON * MU)])
}

fn reduction(slowness: Expr) -> Chain {
    let f = WAVE.at([Z.into(), T.into()]);
    Chain::new(laplacian(E) - EPSILON * MU * twice(E, T))
        .because("nought, by E7")
        .given(E, vector(&f, 0, 0), "along x, the same for all x and y")
        .then(vector(operator(&f, slowness), 0, 0), ["∂/∂x = ∂/∂y = 0"])
}

fn chain_rule(shapes: Expr) -> Chain {
    Chain::new(Equation::new(twice(WAVE, Z), EPSILON * MU * twice(WAVE, T)))
        .given(WAVE, &shapes, "d'Alembert")
        .then(Equation::new(operator(&shapes, EPSILON * MU), 0), ["d'Alembert", "chain rule"])
}

/// Length of the line, in metres of a string whose waves run at 1 m/s.
const LENGTH: f64 = 1.0;
/// How long pulses are followed [s]: not once round, where all harmonics are in step again and errors of speed hide.
const DURATION: f64 = 0.625;

/// A smooth pulse of width 1/20 about ¼, repeated with the ring.
fn smooth(z: f64) -> f64 {
    let away = (z - 0.25).rem_euclid(LENGTH);
    let away = away.min(LENGTH - away) * 20.0;
    (-away * away).exp()
}

/// A square pulse between 0.15 and 0.35, repeated with the ring.
fn square(z: f64) -> f64 {
    if (0.15..0.35).contains(&z.rem_euclid(LENGTH)) { 1.0 } else { 0.0 }
}

/// Half of the shape runs each way.
fn dalembert(shape: fn(f64) -> f64, z: f64, t: f64) -> f64 {
    0.5 * (shape(z - t) + shape(z + t))
}

/// d'Alembert's solution on a ring of `cells` places, half a cell off so that no place lies on an edge.
fn sampled(shape: fn(f64) -> f64, cells: usize, t: f64) -> Vec<f64> {
    (0..cells).map(|i| dalembert(shape, (i as f64 + 0.5) / cells as f64, t)).collect()
}

/// `shape`, let go, stepped for [`DURATION`].
fn stepped(shape: fn(f64) -> f64, cells: usize, courant: f64, stencil: Stencil) -> Vec<f64> {
    let mut ring = Ring::at_rest(sampled(shape, cells, 0.0), courant, stencil);
    let steps = (DURATION / LENGTH * cells as f64 / courant).round() as usize;
    (0..steps).for_each(|_| ring.step());
    ring.now
}

/// Root mean square difference from d'Alembert.
fn error(shape: fn(f64) -> f64, found: &[f64]) -> f64 {
    let exact = sampled(shape, found.len(), DURATION);
    rms_difference(found, &exact)
}

const DIFFERENCES: Check = Check {
    id: "differences",
    claim: "the one-dimensional equation, solved in small steps, gives d'Alembert's pulses",
    rows: &["E9"],
    route: "three-point differences in z and t at half a cell a step, on finer and finer grids",
    bound: Bound::Order {
        order: 2.0,
        tolerance: 0.1,
        why: "both differences err by the square of their step; the next order still shows on the coarsest of the grids",
    },
    measure: |_| convergence(1.0),
    spoiled: |_| convergence(-1.0),
    slip: "the pulses start the wrong way",
};

fn convergence(speed: f64) -> Measured {
    let cells = [320, 640, 1280];
    let points = cells.map(|cells| {
        let (courant, shape) = (0.5, smooth as fn(f64) -> f64);
        let dt = courant * LENGTH / cells as f64;
        let one_way = |t: f64| (0..cells).map(|i| shape((i as f64 + 0.5) / cells as f64 - t)).collect::<Vec<_>>();
        let mut ring = Ring::new(one_way(-speed * dt), one_way(0.0), courant, Stencil::Three);
        let count = 3 * cells / 4;
        (0..count).for_each(|_| ring.step());
        let exact = one_way(count as f64 * dt);
        (cells as f64, rms_difference(&ring.now, &exact))
    });
    let value = fitted_order(&points).unwrap_or(f64::NAN);
    Measured { value, at: format!("{} … {} cells", cells[0], cells[2]), cases: cells.len() }
}

const ONE_CELL_A_STEP: Check = Check {
    id: "one_cell_a_step",
    claim: "two different shapes run through each other and come out unchanged",
    rows: &["E10"],
    route: "three-point differences at one cell a step, where their errors in z and t cancel exactly",
    bound: Bound::AtMost {
        limit: 1e-11,
        unit: "1",
        why: "a thousand steps, each adding a few roundings that the recurrence carries on in proportion to the steps left",
    },
    measure: |_| one_cell_a_step(1.0),
    spoiled: |_| one_cell_a_step(-1.0),
    slip: "both shapes run to the right",
};

fn one_cell_a_step(direction: f64) -> Measured {
    let cells = 1000;
    let level = |step: f64| {
        let place = |i: usize, way: f64| (i as f64 + 0.5 - way * step) / cells as f64;
        (0..cells).map(|i| smooth(place(i, 1.0)) + square(place(i, -direction) + 0.5)).collect::<Vec<f64>>()
    };
    let mut ring = Ring::new(level(-1.0), level(0.0), 1.0, Stencil::Three);
    let exact = |step: f64| {
        let place = move |i: usize, way: f64| (i as f64 + 0.5 - way * step) / cells as f64;
        (0..cells).map(move |i| smooth(place(i, 1.0)) + square(place(i, -1.0) + 0.5))
    };
    let mut cases = Vec::new();
    for step in 1..=cells {
        ring.step();
        if step % 50 == 25 {
            let differences =
                ring.now.iter().zip(exact(step as f64)).map(|(found, exact)| (found - exact, String::new()));
            cases.push((Measured::worst(differences).value, format!("after {step} steps")));
        }
    }
    Measured::worst(cases)
}

const SMOOTH: Race = Race {
    id: "smooth_pulse",
    claim: "a smooth pulse, let go: order pays, harmonics pay more, and what needs no steps pays most",
    rows: &["E10"],
    work: "places; a stepped lane's steps grow with them, and its time with their square",
    error: "rms error of E",
    reference: "root mean square over the places, against d'Alembert evaluated at each; d'Alembert itself against one cell a step",
    lanes: &[
        Lane::once(
            "second_order",
            "three points, ½ cell a step",
            &[256, 512, 1024, 2048],
            order(2.0, 0.15),
            |_, work| steps_of(smooth, work, 0.5, Stencil::Three),
        ),
        Lane::once(
            "fourth_order",
            "five points, ½ cell a step",
            &[128, 256, 512, 1024],
            order(4.0, 0.3),
            |_, work| steps_of(smooth, work, 0.5, Stencil::Five),
        ),
        Lane::once("one_cell_a_step", "three points, 1 cell a step", &[256, 512, 1024, 2048], EXACT, |_, work| {
            steps_of(smooth, work, 1.0, Stencil::Three)
        }),
        HARMONICS,
        Lane::once("dalembert", "d'Alembert", &[256, 512, 1024, 2048], EXACT, |_, work| evaluated(smooth, work)),
    ],
};

const fn order(order: f64, tolerance: f64) -> Expects {
    Expects::Order { order, tolerance }
}

/// What a pulse holds beyond the harmonics that its samples can carry is laid on the others and lost: for this one
/// √(2Σ|c_m|²) over 2m > N with c_m ∝ e^(−(πm/20)²). The order is the slope of that over these places, which are odd in
/// number, so that the pulses do not come to rest on samples.
const HARMONICS: Lane =
    Lane::once("harmonics", "by its harmonics", &[25, 33, 39, 49, 57], order(19.9, 0.6), |_, work| {
        by_harmonics(smooth, work)
    });

const EXACT: Expects = Expects::Within {
    limit: 1e-11,
    why: "nothing but rounding: a few units a step, carried on in proportion to the steps left",
};

/// At a jump a scheme of order p makes ripples over a length that goes with h^(p/(p+1)); the rms error is its root.
const SQUARE: Race = Race {
    id: "square_pulse",
    claim: "a square pulse, let go: order is worth little where there is no derivative",
    rows: &["E10"],
    lanes: &[
        Lane::once(
            "second_order",
            "three points, ½ cell a step",
            &[256, 512, 1024, 2048],
            order(0.333, 0.12),
            |_, work| steps_of(square, work, 0.5, Stencil::Three),
        ),
        Lane::once(
            "fourth_order",
            "five points, ½ cell a step",
            &[256, 512, 1024, 2048],
            order(0.4, 0.12),
            |_, work| steps_of(square, work, 0.5, Stencil::Five),
        ),
        Lane::once("one_cell_a_step", "three points, 1 cell a step", &[256, 512, 1024, 2048], EXACT, |_, work| {
            steps_of(square, work, 1.0, Stencil::Three)
        }),
        Lane {
            works: &[255, 513, 1025, 2049],
            // Each edge leaves an error of its own height over a few places: one over the root of their number.
            expects: order(0.5, 0.1),
            prepare: |_, work| by_harmonics(square, work),
            ..HARMONICS
        },
        Lane::once("dalembert", "d'Alembert", &[256, 512, 1024, 2048], EXACT, |_, work| evaluated(square, work)),
    ],
    ..SMOOTH
};

fn steps_of(shape: fn(f64) -> f64, work: u64, courant: f64, stencil: Stencil) -> Heat {
    Heat {
        run: Box::new(move || stepped(shape, work as usize, courant, stencil)),
        error: Box::new(move |found| error(shape, found)),
    }
}

/// The samples as a sum of harmonics, each moved by itself both ways.
fn by_harmonics(shape: fn(f64) -> f64, work: u64) -> Heat {
    let samples = sampled(shape, work as usize, 0.0);
    let moved = move || {
        let spectrum = Spectrum::of_samples(&samples, LENGTH).expect("finite samples");
        let [on, back] = [DURATION, -DURATION].map(|way| spectrum.shifted(way).samples(samples.len()));
        let both = on.expect("a number of places").into_iter().zip(back.expect("a number of places"));
        both.map(|(on, back)| 0.5 * (on + back)).collect()
    };
    Heat { run: Box::new(moved), error: Box::new(move |found| error(shape, found)) }
}

fn evaluated(shape: fn(f64) -> f64, work: u64) -> Heat {
    Heat {
        run: Box::new(move || sampled(shape, work as usize, DURATION)),
        // Of the other lanes one is exact too.
        error: Box::new(move |found| rms_difference(found, &stepped(shape, found.len(), 1.0, Stencil::Three))),
    }
}

/// A tall smooth pulse from the left and a lower square one from the right, z and t in units of their own.
fn meeting(z: f64, t: f64) -> f64 {
    let gauss = |away: f64| (-away * away).exp();
    let block = |away: f64| if away.abs() < 0.8 { -0.6 } else { 0.0 };
    gauss((z + 3.0 - t) / 0.6) + block(z - 3.0 + t)
}

fn space_time(_: &Setting) -> Plot {
    let (columns, rows) = (900, 660);
    let cell = |at: usize, count: usize, from: f64, to: f64| from + (to - from) * (at as f64 + 0.5) / count as f64;
    let values = (0..rows).flat_map(|row| {
        let t = cell(row, rows, 0.0, 6.0);
        (0..columns).map(move |column| meeting(cell(column, columns, -5.0, 5.0), t))
    });
    let map = Map {
        title: String::new(),
        x: Axis::linear("z", "m").range(-5.0, 5.0).tick(1.0),
        y: Axis::linear("vt", "m").range(0.0, 6.0).tick(1.0),
        colour: Axis::linear("E_x / A", "").range(-1.0, 1.0),
        ramp: Ramp::Diverging,
        columns,
        values: values.collect(),
        marks: Vec::new(),
    };
    Plot::of("Two pulses that meet", map)
}

fn strip(_: &Setting) -> Plot {
    let panel = |step: u32| {
        let t = f64::from(step) * 1.2;
        let points = (0..=2000).map(|at| -5.0 + f64::from(at) / 200.0).map(|z| [z, meeting(z, t)]).collect();
        let axes = Chart::new(
            format!("vt = {t:.1} m"),
            Axis::linear("z", "m").range(-5.0, 5.0),
            Axis::linear("E_x / A", "").range(-0.8, 1.1),
        );
        axes.line(Hue::Nth(0), "", points).at_y(0.0, "").into()
    };
    Plot::grid("Two pulses that meet, from instant to instant", 2, (0..6).map(panel).collect())
}
