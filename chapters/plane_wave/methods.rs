//! E10: other ways to carry a wave along, and what each costs.

use super::rms_difference;
use crate::figure::{Axis, Chart, Hue, Plot};
use crate::setting::{Kind, Parameter, Setting};
use crate::symbols::{C, T, WAVE, Z};
use crate::vocabulary::{Expects, Figure, Heat, Lane, Quantity, Race, Statement, Step};
use light::em::wave::{Problem, Scheme};
use light::equation::Equation;
use light::equation::expr::partial;
use light::precise;
use std::f64::consts::TAU;

const CELLS: Parameter = Parameter {
    name: "cells",
    symbol: "N",
    says: "cells of the line",
    default: "128",
    kind: Kind::Count { min: 8, max: 1 << 14 },
};

pub(super) const STEP: Step = Step {
    id: "methods",
    title: "What accuracy costs",
    says: "For a smooth wave higher order and the spectrum buy digits cheaply; for a wave with edges nothing does but the exact solution.",
    rows: &["E10"],
    parameters: &[CELLS],
    statements: &[Statement {
        id: "wave_equation",
        says: "what all of them solve, with one number for the medium",
        rows: &["E10"],
        equation: || {
            let field = || WAVE.at([Z.into(), T.into()]);
            Equation::new(partial(partial(field(), T), T), C.pow(2) * partial(partial(field(), Z), Z))
        },
    }],
    derivations: &[],
    readout: Some(readout),
    checks: &[],
    stress: &[],
    races: &[
        Race {
            id: "smooth_pulse",
            claim: "a smooth pulse: fourth order overtakes second at once, and the whole spectrum needs a single step",
            lanes: &SMOOTH,
            ..RACE
        },
        Race {
            id: "square_pulse",
            claim: "a square pulse: every method that resolves edges by waves is slow, whatever its order",
            lanes: &SQUARE,
            ..RACE
        },
    ],
    figures: &[Figure {
        id: "after_a_while",
        says: "Both pulses after they have run round the line once and a bit.",
        rows: &["E10"],
        plot: after_a_while,
    }],
};

/// How far the pulses run round a line of 1 m: no whole number of anything.
const DISTANCE: f64 = 1.13;

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
    // z − ct − ½ in hundredths of a cell, so that nothing is rounded.
    let hundredths = |node: usize| 100.0 * node as f64 - 163.0 * cells as f64;
    let value = |node| {
        let away = precise::real(hundredths(node)) / precise::real(100.0 * cells as f64);
        precise::to_f64(&(&ten * ((&turn * away).cos() - &one)).exp())
    };
    (0..cells).map(value).collect()
}

/// The square pulse at the end in whole numbers, at every node.
fn square_at_the_end(cells: usize) -> Vec<f64> {
    let cells = cells as i64;
    let away = |node: i64| (100 * node - 113 * cells).rem_euclid(100 * cells) - 50 * cells;
    (0..cells).map(|node| if away(node).abs() < 20 * cells { 1.0 } else { 0.0 }).collect()
}

const RACE: Race = Race {
    id: "",
    claim: "",
    rows: &["E10"],
    work: "cells squared: cell-steps but for a factor",
    error: "RMS error of E over the peak",
    reference: "f(z − ct) at every node, the smooth pulse in 256 bits, the square one in whole numbers",
    lanes: &[],
};

/// 32 to 1024 cells; a step is a fixed share of a cell, so there are as many steps.
const COUNTS: &[u64] = &[1 << 10, 1 << 12, 1 << 14, 1 << 16, 1 << 18, 1 << 20];
/// The smooth pulse is resolved from 64 cells on.
const RESOLVED: &[u64] = &[1 << 12, 1 << 14, 1 << 16, 1 << 18, 1 << 20];

const fn order(order: f64, tolerance: f64) -> Expects {
    Expects::Order { order, tolerance }
}

const EXACT: Expects = Expects::Within { limit: 1e-13, why: "nothing but rounding, of the transform or of f itself" };

const SMOOTH: [Lane; 5] = [
    Lane::once("yee", "Yee: second order", RESOLVED, order(1.0, 0.1), |_, n| of_smooth(Scheme::Yee, n)),
    Lane::once("fourth_order", "fourth order", RESOLVED, order(2.0, 0.2), |_, n| of_smooth(Scheme::FourthOrder, n)),
    Lane::once("pseudo_spectral", "pseudo-spectral", RESOLVED, order(2.0, 0.2), |_, n| {
        of_smooth(Scheme::PseudoSpectral, n)
    }),
    Lane::once("spectral", "every harmonic by itself", RESOLVED, EXACT, |_, n| of_smooth(Scheme::Spectral, n)),
    Lane::once("dalembert", "d'Alembert", RESOLVED, EXACT, |_, n| of_smooth(Scheme::DAlembert, n)),
];

const SQUARE: [Lane; 5] = [
    Lane::once("yee", "Yee: second order", COUNTS, order(1.0 / 6.0, 0.04), |_, n| of_square(Scheme::Yee, n)),
    Lane::once("fourth_order", "fourth order", COUNTS, order(0.2, 0.04), |_, n| of_square(Scheme::FourthOrder, n)),
    Lane::once("pseudo_spectral", "pseudo-spectral", COUNTS, order(0.2, 0.04), |_, n| {
        of_square(Scheme::PseudoSpectral, n)
    }),
    Lane::once("spectral", "every harmonic by itself", COUNTS, order(0.25, 0.08), |_, n| {
        of_square(Scheme::Spectral, n)
    }),
    Lane::once("dalembert", "d'Alembert", COUNTS, EXACT, |_, n| of_square(Scheme::DAlembert, n)),
];

/// 80 % of what is stable, 0.5 for Yee's, which is exact at its limit and would tell nothing.
fn courant(scheme: Scheme) -> f64 {
    if scheme == Scheme::Yee { 0.5 } else { (0.8 * scheme.courant_limit()).min(0.5) }
}

fn carry(scheme: Scheme, profile: fn(f64) -> f64, cells: usize) -> Vec<f64> {
    let problem = Problem { profile: &profile, length: 1.0, distance: DISTANCE };
    scheme.carry(&problem, cells, courant(scheme)).expect("a stable step").e
}

fn exact(profile: fn(f64) -> f64, cells: usize) -> Vec<f64> {
    Problem { profile: &profile, length: 1.0, distance: DISTANCE }.exact(cells)
}

fn of_smooth(scheme: Scheme, work: u64) -> Heat {
    carried(scheme, smooth, smooth_at_the_end, work)
}

fn of_square(scheme: Scheme, work: u64) -> Heat {
    carried(scheme, square, square_at_the_end, work)
}

fn carried(scheme: Scheme, profile: fn(f64) -> f64, exact: fn(usize) -> Vec<f64>, work: u64) -> Heat {
    let cells = work.isqrt() as usize;
    Heat {
        run: Box::new(move || carry(scheme, profile, cells)),
        error: Box::new(move |found| rms_difference(found, &exact(cells))),
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
            value: rms_difference(&carry(scheme, profile, cells), &exact(profile, cells)),
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
    let errors = Chart::new("smooth: what is wrong", z(), Axis::log("|ΔE| over the peak", "").range(1e-18, 1.0));
    let errors = SHOWN.into_iter().enumerate().fold(errors, |chart, (at, (scheme, name))| {
        let found = carry(scheme, smooth, cells);
        let missed = found.iter().zip(&truth).map(|(found, truth)| (found - truth).abs()).collect();
        chart.line(Hue::Nth(at as u8), name, curve(missed))
    });
    let fields = Chart::new("square: the field", z(), Axis::linear("E over the peak", "").range(-0.4, 1.4));
    let fields = [SHOWN[0], SHOWN[3]]
        .into_iter()
        .zip([0, 3])
        .fold(fields.dashed(Hue::Natural, "exact", curve(exact(square, cells))), |chart, ((scheme, name), hue)| {
            chart.line(Hue::Nth(hue), name, curve(carry(scheme, square, cells)))
        });
    Plot::grid(format!("Once and a bit round {cells} cells"), 2, vec![errors.into(), fields.into()])
}
