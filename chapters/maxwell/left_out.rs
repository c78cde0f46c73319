//! C2: what a scene does not need is not there, and costs nothing.

use super::throughput::{ROUNDED, THROUGHPUT};
use crate::figure::{Axis, Chart, Hue, Mark, Plot, Shape};
use crate::parameter::{Kind, Parameter, Setting};
use crate::vocabulary::{
    Bench, Check, Exhibit, Heat, Lane, Measured, Quantity, Step, check, exhibit, figure, lane, race, statement, step,
};
use equation::{Dimension, Equation, Symbol};
use light::em::line::{Ends, Line, Setup};
use light::em::{C, Medium, Pulse, Stepping, Z_0};
use std::f64::consts::TAU;

const CELLS: Parameter =
    Parameter::new("cells", "N", "cells of the line", Kind::Count { min: 100, max: 1_000_000 }).default("10000");

pub(super) const EXHIBIT: Exhibit =
    exhibit("left_out", &[CELLS], &[figure("savings", "What four scenes left out, per cell and step.", savings)]);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "What is not needed",
    "A lossless cell carries no conduction, a closed end no absorber, a line no second \
     dimension: the fields are the same, bit by bit.",
)
.rows(&["C2"])
.statements(&[statement(
    "memory",
    "the time of a step of a grid that does not fit into the cache: what it moves over \
     how fast memory moves it",
    || Equation::new(STEP_TIME, BYTES / BANDWIDTH),
)])
.readout(readout)
.checks(&[&SAME])
.races(&[
    race(
        "vacuum",
        "the same wave on a line that has all machinery and on one that has what vacuum \
         needs",
    )
    .work("cell-steps")
    .error("|ΔE| of a plane wave", "the wave at the speed that the grid gives it, at one node")
    .lanes(&[
        entrant("full", "everything in every cell", |_, n| ring(false, n)),
        entrant("pruned", "what is needed", |_, n| ring(true, n)),
    ]),
    THROUGHPUT,
]);

const STEP_TIME: Symbol = Symbol::scalar("t", Dimension::SECOND);
const BYTES: Symbol = Symbol::scalar("M", Dimension::ONE);
const BANDWIDTH: Symbol = Symbol::scalar("beta", Dimension::HERTZ);

const fn entrant(id: &'static str, label: &'static str, prepare: fn(&mut Bench, u64) -> Heat) -> Lane {
    lane(id, label, &[1_000_000, 4_000_000, 16_000_000], prepare).expects(ROUNDED)
}

fn stepping(pruned: bool) -> Stepping {
    Stepping { pruned, ..Stepping::at(0.5) }
}

/// A wave of twenty cells on a ring of 10⁴, so many cell-steps further at each run.
fn ring(pruned: bool, cell_steps: u64) -> Heat {
    const CELLS: usize = 10_000;
    let k = TAU / 20.0;
    let phase = light::em::theory::phase_per_step(&[k], 0.5).re;
    let mut line = Line::new(Setup::vacuum(CELLS, 1.0, Ends::Periodic, stepping(pruned))).expect("within all limits");
    line.set(|z| (k * z).cos(), |z| (k * z - 0.5 * phase).cos() / Z_0);
    Heat {
        run: Box::new(move || {
            line.run(cell_steps / CELLS as u64).expect("some steps");
            vec![line.e()[0], line.steps() as f64]
        }),
        error: Box::new(move |found| (found[0] - (phase * found[1]).cos()).abs()),
    }
}

/// Scenes that need more and more.
const SCENES: [(&str, &str); 4] = [("vacuum", "vacuum"), ("glass", "glass"), ("sea", "salt water"), ("metal", "metal")];

/// A line whose second half is filled, between absorbers.
fn scene(key: &str, cells: usize, pruned: bool) -> Line {
    let medium = match key {
        "glass" => Medium::dielectric(2.25),
        "sea" => Medium::conductor(74.0, 4.0),
        "metal" => Medium::metal(100.0 * C, C),
        _ => Medium::VACUUM,
    };
    let setup = Setup {
        layers: vec![(cells / 2..cells - 20, medium)],
        ..Setup::vacuum(cells, 0.01, Ends::open(20), stepping(pruned))
    };
    Line::new(setup).expect("within all limits")
}

/// What each scene saved, of memory and of operations a step, and what it was that vacuum did without.
fn readout(setting: &Setting) -> Vec<Quantity> {
    let cells = setting.number("cells") as usize;
    let per_cell = |key, symbol, says, value, unit| Quantity { key, symbol, says, value, unit };
    let mut quantities = Vec::new();
    let work_keys = ["vacuum_work", "glass_work", "sea_work", "metal_work"];
    for ((key, says), work_key) in SCENES.into_iter().zip(work_keys) {
        let explanation = scene(key, cells, true).explain();
        quantities.push(per_cell(key, "memory saved", says, explanation.bytes_saved_per_cell(), "B/cell"));
        quantities.push(per_cell(work_key, "work saved", says, explanation.operations_saved_per_cell(), "1/cell"));
    }
    let vacuum = scene("vacuum", cells, true).explain();
    quantities.extend(vacuum.omissions.iter().map(|omission| {
        let (amount, unit) =
            if omission.bytes > 0 { (omission.bytes, "B/cell") } else { (omission.operations, "1/cell") };
        per_cell(omission.id, "of vacuum", omission.what, amount as f64 / vacuum.cells as f64, unit)
    }));
    quantities
}

const SAME: Check<f64> =
    check("same_fields", "what was left out is not missed: both kinds of line give the same fields")
        .against("the same scenes with every coefficient and current in every cell")
        .within(0.0, "ulp", "the same operations on the same numbers, and others that change nothing")
        .of(difference, 0.0)
        .slip("a faint conduction taken for none", 1e-6);

/// Largest difference of fields [ε V/m] between pruned and full lines, the full one with vacuum that conducts by `sigma`.
fn difference(_: &mut Bench, sigma: f64) -> Measured {
    Measured::worst(SCENES.into_iter().flat_map(|(key, name)| {
        let mut lines = [true, false].map(|pruned| {
            let line = scene(key, 400, pruned);
            let mut setup = line.setup().clone();
            if !pruned {
                setup.background = Medium { sigma, ..setup.background };
            }
            let mut line = Line::new(setup).expect("within all limits");
            let pulse = Pulse::Modulated { frequency: 1.5e9, delay: 1e-9, width: 0.3e-9 };
            line.inject(60, 1.0, pulse).expect("a node of the line");
            line
        });
        for line in &mut lines {
            line.run(600).expect("some steps");
        }
        let [pruned, full] = lines;
        let pairs: Vec<_> = pruned.e().iter().zip(full.e()).map(|(a, b)| (a - b) / f64::EPSILON).collect();
        pairs.into_iter().map(move |difference| (difference, name.to_owned()))
    }))
}

fn savings(setting: &Setting) -> Plot {
    let cells = setting.number("cells") as usize;
    let points = |of: fn(&light::em::pruning::Explanation) -> f64| -> Vec<[f64; 2]> {
        let each = SCENES.iter().enumerate();
        each.map(|(at, (key, _))| [at as f64 + 1.0, of(&scene(key, cells, true).explain())]).collect()
    };
    let names = SCENES.iter().enumerate().map(|(at, (_, name))| format!("{} {name}", at + 1));
    let mark =
        |label: &str, hue, shape, points| Mark::Points { label: label.into(), hue, shape, joined: false, points };
    let chart = Chart::new(
        "",
        Axis::linear(format!("scene: {}", names.collect::<Vec<_>>().join(", ")), "").range(0.5, 4.5).tick(1.0),
        Axis::linear("saved per cell", "").range(0.0, 100.0),
    )
    .with(mark("bytes", Hue::Ours, Shape::Disc, points(|explanation| explanation.bytes_saved_per_cell())))
    .with(mark("operations a step", Hue::Nth(1), Shape::Square, points(|e| e.operations_saved_per_cell())));
    Plot::of("What scenes left out", chart)
}
