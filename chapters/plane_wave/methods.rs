//! E10: other ways to carry a wave along, and what each costs.

use super::rms_difference;
use crate::figure::{Axis, Chart, Hue, Plot};
use crate::parameter::{Kind, Parameter, Setting};
use crate::symbols::{C, T, WAVE, Z};
use crate::vocabulary::{
    Answer, Bench, Exhibit, Expects, Heat, Lane, Quantity, Question, Race, Step, choice, exhibit, figure, lane,
    question, race, statement, step,
};
use equation::Equation;
use equation::expr::partial;
use light::em::wave::{Problem, Scheme};
use std::f64::consts::TAU;
use yardstick::precise;
use yardstick::random::uniform;

const CELLS: Parameter =
    Parameter::new("cells", "N", "cells of the line", Kind::Count { min: 8, max: 1024 }).default("128");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "methods",
    &[CELLS],
    &[figure(
        "after_a_while",
        "Once round the line and a third: what four methods get wrong of the smooth pulse, \
         and what the second-order one and the spectrum make of the square one.",
        after_a_while,
    )],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "What accuracy costs",
    "For a smooth wave higher order and the spectrum buy digits cheaply; for a wave \
     with edges nothing does but the exact solution.",
)
.rows(&["E10"])
.statements(&[statement("wave_equation", "what all of them solve, with one number for the medium", || {
    let field = || WAVE.at([Z.into(), T.into()]);
    Equation::new(partial(partial(field(), T), T), C.pow(2) * partial(partial(field(), Z), Z))
})])
.questions(&[EDGES])
.readout(readout)
.races(&[
    RACE.named(
        "smooth_pulse",
        "a smooth pulse: fourth order overtakes second at once, and the whole spectrum \
         needs a single step",
    )
    .lanes(&SMOOTH),
    RACE.named(
        "square_pulse",
        "a square pulse: every method that resolves edges by waves is slow, whatever its \
         order",
    )
    .lanes(&SQUARE),
]);

const EDGES: Question = question(
    "edges",
    "A method of fourth order carries a square pulse along. With twice as many cells, by how much does its error \
     fall?",
    Answer::Choice {
        options: &[
            choice(
                "to about a sixteenth",
                "That is what fourth order promises to a smooth wave. It counts on derivatives, and an edge has \
                 none.",
            ),
            choice("to about a quarter", "Not even of the second order is anything left at an edge."),
            choice("to no less than a half", ""),
        ],
        right: |_| {
            let off = |cells| rms_difference(&carry(Scheme::FourthOrder, &square, cells), &exact(square, cells));
            match off(512) / off(128) {
                // Of four times as many cells: the square of what twice as many do.
                share if share < 0.12 * 0.12 => 0,
                share if share < 0.35 * 0.35 => 1,
                _ => 2,
            }
        },
        slip: |_| 0,
    },
    "By a quarter or so: an edge holds waves of every length, and the shortest are resolved on no grid.",
);

/// How far the pulses run round a line of 1 m. On a power of two of cells the last cell is left at a third or two
/// thirds, which are alike to a method that knows no left and right: no grid of a race is luckier than another.
const DISTANCE: f64 = 4.0 / 3.0;

/// Entire in z, so that its spectrum falls faster than any power.
fn smooth(z: f64) -> f64 {
    (10.0 * ((TAU * (z - 0.5)).cos() - 1.0)).exp()
}

fn square(z: f64) -> f64 {
    if (z - 0.5).abs() < 0.2 { 1.0 } else { 0.0 }
}

/// The smooth pulse at the end in 256 bits, at every node.
fn smooth_at_the_end(cells: usize) -> Vec<f64> {
    let (turn, ten, one) = (precise::pi(precise::BITS) * precise::real(2.0), precise::real(10.0), precise::real(1.0));
    // z − ct − ½ in sixths of a cell, so that nothing is rounded.
    let sixths = |node: usize| 6.0 * node as f64 - 11.0 * cells as f64;
    let value = |node| {
        let away = precise::real(sixths(node)) / precise::real(6.0 * cells as f64);
        precise::to_f64(&(&ten * ((&turn * away).cos() - &one)).exp())
    };
    (0..cells).map(value).collect()
}

/// Parts of a cell in which the square pulses of the race are shifted. Odd numbers of them leave no node on an edge.
const PARTS: i64 = 128;

/// The square pulse at the end, shifted by `parts` of a cell, at every node; in whole numbers.
fn square_at_the_end(cells: usize, parts: i64) -> Vec<f64> {
    // In units of 1/30 of a part.
    let (cell, line) = (30 * PARTS, 30 * PARTS * cells as i64);
    let away = |node: i64| (cell * node - 30 * parts - 4 * line / 3).rem_euclid(line) - line / 2;
    (0..cells as i64).map(|node| if away(node).abs() < line / 5 { 1.0 } else { 0.0 }).collect()
}

const RACE: Race = race("", "")
    .work("cells; the steps of those that step grow with them")
    .error(
        "RMS error of E over the peak",
        "f(z − ct) at every node, the smooth pulse in 256 bits, the square one in whole \
         numbers",
    )
    .lanes(&[]);

const COUNTS: &[u64] = &[32, 64, 128, 256, 512];
/// The smooth pulse is resolved from 64 cells on.
const RESOLVED: &[u64] = &[64, 128, 256, 512, 1024];

const fn order(order: f64, tolerance: f64) -> Expects {
    Expects::Order { order, tolerance }
}

const EXACT: Expects = Expects::Within { limit: 1e-13, why: "nothing but rounding, of the transform or of f itself" };

const SMOOTH: [Lane; 5] = [
    lane("yee", "Yee: second order", RESOLVED, |_, n| of_smooth(Scheme::Yee, n)).expects(order(2.0, 0.2)),
    lane("fourth_order", "fourth order", RESOLVED, |_, n| of_smooth(Scheme::FourthOrder, n)).expects(order(4.0, 0.4)),
    lane("pseudo_spectral", "pseudo-spectral", RESOLVED, |_, n| of_smooth(Scheme::PseudoSpectral, n))
        .expects(order(4.0, 0.4)),
    lane("spectral", "every harmonic by itself", RESOLVED, |_, n| of_smooth(Scheme::Spectral, n)).expects(EXACT),
    lane("dalembert", "d'Alembert", RESOLVED, |_, n| of_smooth(Scheme::DAlembert, n)).expects(EXACT),
];

/// A jump has half a derivative in the mean square, of which a method of order p makes the order p/(2(p + 1)) (Brenner,
/// Thomée & Wahlbin, *Besov Spaces and Applications to Difference Methods*, 1975); the bare transform keeps all of it.
const SQUARE: [Lane; 5] = [
    of_square("yee", "Yee: second order", order(0.333, 0.06), |bench, n| edges(Scheme::Yee, bench, n)),
    of_square("fourth_order", "fourth order", order(0.4, 0.06), |bench, n| edges(Scheme::FourthOrder, bench, n)),
    of_square("pseudo_spectral", "pseudo-spectral", order(0.4, 0.06), |bench, n| {
        edges(Scheme::PseudoSpectral, bench, n)
    }),
    of_square("spectral", "every harmonic by itself", order(0.5, 0.06), |bench, n| edges(Scheme::Spectral, bench, n)),
    of_square("dalembert", "d'Alembert", EXACT, |bench, n| edges(Scheme::DAlembert, bench, n)),
];

/// Where its edges fall within a cell decides about the error of a square pulse: a lane takes the mean over several
/// places.
const fn of_square(
    id: &'static str,
    label: &'static str,
    expects: Expects,
    prepare: fn(&mut Bench, u64) -> Heat,
) -> Lane {
    lane(id, label, COUNTS, prepare).repeated(16).expects(expects)
}

/// 80 % of what is stable, 0.5 for Yee's, which is exact at its limit and would tell nothing.
fn courant(scheme: Scheme) -> f64 {
    if scheme == Scheme::Yee { 0.5 } else { (0.8 * scheme.courant_limit()).min(0.5) }
}

fn carry(scheme: Scheme, profile: &dyn Fn(f64) -> f64, cells: usize) -> Vec<f64> {
    let problem = Problem { profile, length: 1.0, distance: DISTANCE };
    scheme.carry(&problem, cells, courant(scheme)).expect("a stable step").e
}

fn exact(profile: fn(f64) -> f64, cells: usize) -> Vec<f64> {
    Problem { profile: &profile, length: 1.0, distance: DISTANCE }.exact(cells)
}

fn of_smooth(scheme: Scheme, cells: u64) -> Heat {
    let cells = cells as usize;
    carried(scheme, smooth, cells, move || smooth_at_the_end(cells))
}

/// A square pulse, shifted by a part of a cell.
fn edges(scheme: Scheme, bench: &mut Bench, cells: u64) -> Heat {
    let cells = cells as usize;
    let parts = 2 * uniform(&mut bench.stream, 0.0, PARTS as f64 / 2.0) as i64 + 1;
    let shift = parts as f64 / PARTS as f64 / cells as f64;
    carried(scheme, move |z| square(z - shift), cells, move || square_at_the_end(cells, parts))
}

fn carried(
    scheme: Scheme,
    profile: impl Fn(f64) -> f64 + 'static,
    cells: usize,
    exact: impl Fn() -> Vec<f64> + 'static,
) -> Heat {
    Heat {
        run: Box::new(move || carry(scheme, &profile, cells)),
        error: Box::new(move |found| rms_difference(found, &exact())),
    }
}

fn readout(setting: &Setting) -> Vec<Quantity> {
    let cells = setting.number("cells") as usize;
    let keys = [
        (Scheme::Yee, ["yee_smooth", "yee_square"], ["Yee, smooth", "Yee, square"]),
        (Scheme::FourthOrder, ["fourth_smooth", "fourth_square"], ["fourth order, smooth", "fourth order, square"]),
        (
            Scheme::PseudoSpectral,
            ["pseudo_smooth", "pseudo_square"],
            ["pseudo-spectral, smooth", "pseudo-spectral, square"],
        ),
        (Scheme::Spectral, ["spectral_smooth", "spectral_square"], ["spectral, smooth", "spectral, square"]),
    ];
    let profiles: [fn(f64) -> f64; 2] = [smooth, square];
    let each = keys.into_iter().flat_map(|(scheme, keys, names)| {
        profiles.into_iter().zip(keys.into_iter().zip(names)).map(move |(profile, (key, says))| Quantity {
            key,
            symbol: "ΔE",
            says,
            value: rms_difference(&carry(scheme, &profile, cells), &exact(profile, cells)),
            unit: "1",
        })
    });
    each.collect()
}

/// What the figure shows.
const SHOWN: [(Scheme, &str); 4] = [
    (Scheme::Yee, "Yee"),
    (Scheme::FourthOrder, "order 4"),
    (Scheme::PseudoSpectral, "pseudo-spectral"),
    (Scheme::Spectral, "spectral"),
];

fn after_a_while(setting: &Setting) -> Plot {
    let cells = setting.number("cells") as usize;
    let curve = |e: Vec<f64>| -> Vec<[f64; 2]> {
        e.into_iter().enumerate().map(|(at, e)| [at as f64 / cells as f64, e]).collect()
    };
    let z = || Axis::linear("z", "m").range(0.0, 1.0);
    let truth = exact(smooth, cells);
    let errors =
        Chart::new("smooth: what is wrong", z(), Axis::log("|ΔE| over the peak (0 as 10^{−18})", "").range(1e-18, 1.0));
    let errors = SHOWN.into_iter().enumerate().fold(errors, |chart, (at, (scheme, name))| {
        let found = carry(scheme, &smooth, cells);
        let missed = found.iter().zip(&truth).map(|(found, truth)| (found - truth).abs().max(1e-18)).collect();
        chart.line(Hue::Nth(at as u8), name, curve(missed))
    });
    let fields = Chart::new("square: the field", z(), Axis::linear("E over the peak", "").range(-0.4, 1.4));
    let fields = [SHOWN[0], SHOWN[3]]
        .into_iter()
        .zip([0, 3])
        .fold(fields.dashed(Hue::Natural, "exact", curve(exact(square, cells))), |chart, ((scheme, name), hue)| {
            chart.line(Hue::Nth(hue), name, curve(carry(scheme, &square, cells)))
        });
    Plot::grid(format!("Once and a third round {cells} cells"), 2, vec![errors.into(), fields.into()])
}
