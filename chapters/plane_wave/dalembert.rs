//! E9, E10: one dimension, and d'Alembert's solution.

use super::rms_difference;
use super::wave_equation::twice;
use crate::figure::{Axis, Chart, Hue, Map, Plot, Ramp};
use crate::parameter::Setting;
use crate::symbols::{E, EPSILON, F_1, F_2, MU, T, WAVE, Z};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Question, Step, check, choice, derivation, exhibit, figure, fitted_order,
    question, statement, step,
};
use equation::derivation::Chain;
use equation::expr::{laplacian, sqrt, vector};
use equation::{Equation, Expr};
use light::em::line::{Ends, Line, Setup};
use light::em::wave::{Problem, Scheme};
use light::em::{Stepping, Z_0};

pub(super) const EXHIBIT: Exhibit = exhibit(
    "dalembert",
    &[],
    &[
        figure(
            "space_time",
            "Two pulses in space and time: each keeps its shape and its slope, and where they meet they add.",
            space_time,
        )
        .rows(&["E10"]),
        figure("strip", "The same two pulses at six instants.", strip).rows(&["E10"]),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Two shapes, running apart",
    "In one dimension every solution is one shape that runs to the right and one that runs to the left.",
)
.rows(&["E9", "E10"])
.about("solution")
.statements(&[
    statement("one_dimension", "the wave equation of a field that depends on z and t alone", || {
        Equation::new(operator(&WAVE.at([Z.into(), T.into()]), EPSILON * MU), 0)
    })
    .rows(&["E9"]),
    statement("solution", "d'Alembert's solution, for any two shapes that have two derivatives", || {
        Equation::new(WAVE.at([Z.into(), T.into()]), running_apart())
    })
    .rows(&["E10"]),
])
.questions(&[UPSIDE_DOWN])
.derivations(&[
    derivation("reduction", "the wave equation of a field along x that is the same for all x and y", || {
        reduction(EPSILON * MU)
    })
    .rows(&["E9"])
    .slip("the sign of Laplace's equation", || reduction(-(EPSILON * MU))),
    derivation("chain_rule", "each shape brings the same factor twice: (±1/√(εμ))²", || {
        chain_rule(running_apart())
    })
    .rows(&["E10"])
    .slip("the second shape runs at twice the speed", || {
        chain_rule(F_1.at([Z - T / sqrt(EPSILON * MU)]) + F_2.at([Z + 2 * T / sqrt(EPSILON * MU)]))
    }),
])
.checks(&[&DIFFERENCES, &ONE_CELL_A_STEP]);

const UPSIDE_DOWN: Question = question(
    "upside_down",
    "Two equal pulses, one of them upside down, run towards each other. When they lie on each other E is zero \
     everywhere. What comes next?",
    Answer::Choice {
        options: &[
            choice(
                "nothing: they have put each other out",
                "E is zero at that moment, but not its rate: the magnetic fields of the two add up, and hold all \
                 the energy.",
            ),
            choice("both run on as if the other had not been there", ""),
            choice(
                "each bounces back the way it came",
                "The equation is linear: what each pulse does, it does alone. Nothing in it could push.",
            ),
        ],
        right: |_| {
            // They meet at z = ½ at ct = ¼; from ct = 0.4 on the upright one should stand at 0.65.
            let field = |z: f64, t: f64| smooth(z - t) - smooth(z + t - 0.5);
            match field(0.65, 0.4) {
                ahead if ahead > 0.5 => 1,
                ahead if ahead < -0.5 => 2,
                _ => 0,
            }
        },
        slip: |_| 0,
    },
    "Two shapes, running apart: each by itself solves the equation, and so does their sum, at every moment.",
);

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

/// A smooth pulse of width 1/20 of the line about its quarter, repeated with the line.
fn smooth(z: f64) -> f64 {
    let away = (z - 0.25).rem_euclid(1.0);
    let away = away.min(1.0 - away) * 20.0;
    (-away * away).exp()
}

/// A square pulse between 0.65 and 0.85 of the line, repeated with the line.
fn square(z: f64) -> f64 {
    if (0.65..0.85).contains(&z.rem_euclid(1.0)) { 1.0 } else { 0.0 }
}

const DIFFERENCES: Check<f64> =
    check("differences", "the one-dimensional equation, solved in small steps, gives d'Alembert's pulse")
        .rows(&["E9"])
        .against("the solver of chapter maxwell at half a cell a step, on finer and finer grids")
        .order(
            2.0,
            0.1,
            "its differences err by the square of their step; the next order still shows on the coarsest of the grids",
        )
        .of(convergence, 1.0)
        .slip("a shape that runs one per cent too slowly", 0.99);

fn convergence(_: &mut Bench, speed: f64) -> Measured {
    let cells = [320, 640, 1280];
    let problem = |distance| Problem { profile: &smooth, length: 1.0, distance };
    let points = cells.map(|cells| {
        let found = Scheme::Yee.carry(&problem(0.375), cells, 0.5).expect("a stable step").e;
        (cells as f64, rms_difference(&found, &problem(0.375 * speed).exact(cells)))
    });
    let value = fitted_order(&points).unwrap_or(f64::NAN);
    Measured::new(value, format!("{} … {} cells", cells[0], cells[2]), cells.len())
}

const ONE_CELL_A_STEP: Check<f64> =
    check("one_cell_a_step", "two different shapes run through each other and come out unchanged")
        .rows(&["E10"])
        .against("the solver of chapter maxwell at one cell a step, where its errors in z and t cancel exactly")
        .within(1e-12, "1", "a thousand steps, each adding a few roundings")
        .of(one_cell_a_step, 1.0)
        .slip("both shapes run to the right", -1.0);

/// Largest difference of the solver from both shapes, the second of which is expected to run `backwards`.
fn one_cell_a_step(_: &mut Bench, backwards: f64) -> Measured {
    const CELLS: usize = 1000;
    let shapes = |z: f64, on: f64, back: f64| (smooth((z - on) / CELLS as f64), square((z + back) / CELLS as f64));
    let mut line = Line::new(Setup::vacuum(CELLS, 1.0, Ends::Periodic, Stepping::at(1.0))).expect("a stable step");
    // Half a cell off, so that no node lies on an edge. H is half a step later and that of a wave to the left negative.
    let electric = |z: f64| shapes(z + 0.5, 0.0, 0.0);
    let magnetic = |z: f64| shapes(z + 0.5, 0.5, 0.5);
    line.set(|z| electric(z).0 + electric(z).1, |z| (magnetic(z).0 - magnetic(z).1) / Z_0);
    let cases = (0..20).map(|_| {
        line.run(50).expect("some steps");
        let steps = line.steps() as f64;
        let off = line.e()[..CELLS].iter().enumerate().map(|(node, found)| {
            let (on, back) = shapes(node as f64 + 0.5, steps, backwards * steps);
            (found - on - back, String::new())
        });
        (Measured::worst(off).value, format!("after {steps} steps"))
    });
    Measured::worst(cases.collect::<Vec<_>>())
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

/// The moment at which the middles of both pulses lie on each other, as vt [m].
const TOGETHER: f64 = 3.0;

fn strip(_: &Setting) -> Plot {
    let panel = |t: f64| {
        let points = (0..=2000).map(|at| -5.0 + f64::from(at) / 200.0).map(|z| [z, meeting(z, t)]).collect();
        let axes = Chart::new(
            format!("vt = {t:.1} m{}", if t == TOGETHER { ": on each other" } else { "" }),
            Axis::linear("z", "m").range(-5.0, 5.0),
            Axis::linear("E_x / A", "").range(-0.8, 1.1),
        );
        axes.line(Hue::Nth(0), "", points).at_y(0.0, "").into()
    };
    Plot::grid(
        "Two pulses that meet, from instant to instant",
        2,
        [0.0, 1.5, 2.4, TOGETHER, 3.6, 6.0].map(panel).into(),
    )
}
