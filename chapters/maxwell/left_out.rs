//! C2: what a scene does not need is not there, and costs nothing.

use super::throughput::{ROUNDED, THROUGHPUT};
use crate::figure::{Axis, Chart, Hue, Plot};
use crate::parameter::{Kind, Parameter, Setting};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Heat, Lane, Measured, Quantity, Question, Step, check, choice, exhibit, figure,
    lane, largest, question, race, statement, step,
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
.questions(&[UNLIKE])
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

const UNLIKE: Question = question(
    "unlike",
    "A scene of vacuum is stepped twice: with losses, currents and absorbers in every cell, all of them nought, and \
     without any of that. By how much may the fields differ?",
    Answer::Choice {
        options: &[
            choice(
                "by a few roundings",
                "What is left out are products with zero and factors of one, and these round nothing.",
            ),
            choice("by the error of the grid", "Both runs make that same error, since they are the same arithmetic."),
            choice("not at all", ""),
        ],
        right: |_| {
            let [pruned, full] = [true, false].map(|pruned| {
                let mut line = scene("vacuum", 100, pruned);
                line.inject(30, 1.0, Pulse::Gaussian { delay: 0.5e-9, width: 0.1e-9 }).expect("a node of the line");
                line.run(100).expect("some steps");
                line.e().to_vec()
            });
            match largest(pruned.iter().zip(&full).map(|(a, b)| a - b)) {
                0.0 => 2,
                some if some < 1e-12 => 0,
                _ => 1,
            }
        },
        slip: |_| 0,
    },
    "Not by one bit. A tolerance here would hide the one mistake that matters: a cell that lost what it needed.",
);

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
    let explanations = SCENES.map(|(key, name)| (name, scene(key, cells, true).explain()));
    let panel = |title: &str, unit: &str, named: bool, of: fn(&light::em::pruning::Explanation) -> f64| {
        let axes = Chart::new(title, Axis::linear("saved per cell", unit), Axis::bare(0.0, 4.0));
        let chart = explanations.iter().zip((0..4).rev()).fold(axes, |chart, ((name, explanation), row)| {
            let (low, label) = (f64::from(row) + 0.15, if named { *name } else { "" });
            chart.bar(Hue::Nth(3 - row as u8), label, of(explanation), [low, low + 0.7])
        });
        let most = explanations.iter().map(|(_, explanation)| of(explanation)).fold(0.0, f64::max);
        Chart { x: chart.x.clone().range(0.0, 1.05 * most.max(1.0)), ..chart }.into()
    };
    let panels = vec![
        panel("memory", "B", true, |explanation| explanation.bytes_saved_per_cell()),
        panel("operations of a step", "", false, |explanation| explanation.operations_saved_per_cell()),
    ];
    Plot::grid("What scenes left out", 2, panels)
}
