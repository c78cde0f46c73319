//! C2: the four laws on a grid: speed of waves, and the Courant limit.

use crate::figure::{Axis, Chart, Dash, Hue, Map, Mark, Panel, Plot, Ramp, Shape};
use crate::parameter::{Fault, Kind, Parameter, Setting};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Quantity, Question, Step, check, derivation, exhibit, figure, question,
    statement, step,
};
use equation::derivation::Chain;
use equation::expr::{exp, i, sin};
use equation::{Dimension, Equation, Expr, Symbol};
use light::Complex64;
use light::Polarisation;
use light::em::line::{Ends, Line, Setup};
use light::em::plane::{self, Plane};
use light::em::theory::{growth_per_step, phase_per_step, phase_velocity};
use light::em::{Stepping, Z_0};
use std::f64::consts::{PI, TAU};
use yardstick::random::uniform;

const COURANT: Parameter = Parameter::new("courant", "S", "Courant number cΔt/Δ", Kind::number(0.01, 1.5, "1"))
    .default("0.5")
    .validate(blow_up_on_demand);
const CELLS: Parameter =
    Parameter::new("per_wave", "λ/Δ", "cells to a wavelength", Kind::number(2.0, 1e6, "1")).default("20");

const UNSTABLE: Parameter =
    Parameter::new("unstable", "", "1 to take a Courant number beyond the limit", Kind::Count { min: 0, max: 1 })
        .default("0");

/// A time step that blows up must be asked for.
fn blow_up_on_demand(setting: &Setting) -> Result<(), Fault> {
    let courant = setting.number(COURANT.name);
    if courant <= 1.0 || setting.number(UNSTABLE.name) == 1.0 {
        return Ok(());
    }
    let message =
        format!("{courant} is beyond the Courant limit of 1 and would blow up; `--unstable` takes it all the same");
    Err(Fault::new(COURANT.name, message))
}

pub(super) const EXHIBIT: Exhibit = exhibit(
    "grid",
    &[COURANT, CELLS, UNSTABLE],
    &[
        figure(
            "late_waves",
            "Short waves run late, less so near the Courant limit; at the limit, in one \
             dimension, not at all.",
            late,
        ),
        figure(
            "courant_map",
            "How fast the grid's waves grow: not at all below the limit, the shortest first \
             above it.",
            courant_map,
        ),
        figure(
            "explosion",
            "The setting's grid, started from rounding errors: beyond the limit they grow as fast as theory says.",
            explosion,
        ),
        figure("blow_up", "The largest field on the grid, step by step: a hair beyond the limit decides.", blow_up),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "The laws on a grid",
    "Fields half a cell and half a step apart make every derivative a centred \
     difference; waves then run a little late, and too long a step blows up.",
)
.rows(&["C2"])
.statements(&[
    statement("leapfrog", "the step of Faraday's and Ampère's laws along z, H taken out", || {
        second_differences(|z, t| FIELD.at([z, t]))
    }),
    statement("dispersion", "what it makes of frequency and wave number", || {
        Equation::new(sin(OMEGA * DT / 2).pow(2), S.pow(2) * sin(K * DZ / 2).pow(2))
    }),
    statement("courant", "the Courant number; beyond 1 the shortest wave has no real frequency", || {
        Equation::new(S, C * DT / DZ)
    }),
])
.questions(&[SHORTER])
.derivations(&[derivation("from_the_step", "a harmonic wave put into the step", || {
    dispersion(S.pow(2) * sin(K * DZ / 2).pow(2))
})
.slip("the fields a whole cell apart", || dispersion(S.pow(2) * sin(K * DZ).pow(2)))])
.readout(readout)
.checks(&[&SPEED, &STABLE, &GROWTH, &GROWTH_IN_THE_PLANE]);

const SHORTER: Question = question(
    "shorter",
    "A wave of ten cells runs along a line, a little slower than light. The time step is made shorter, from the \
     Courant limit down to nearly nothing, the cells stay. What does the wave's speed do?",
    Answer::Trend {
        replies: [
            "The errors of space and time have opposite signs. At the limit they cancel; the shorter the step, the \
             less of the one is left to cancel the other.",
            "The step enters the grid's waves as well as the cells do: sin²(ωΔt/2) = S² sin²(kΔz/2).",
            "A finer step makes time exact, but it is the cells that make the wave late, and a coarse step that \
             makes up for it.",
            "There is no best step in between: the best is the longest.",
            "There is no best step in between: the best is the longest.",
        ],
        right: |_, at| phase_velocity(&[TAU / 10.0], 1.0 - 0.99 * at),
        slip: |_, at| phase_velocity(&[TAU / 10.0], 0.01 + 0.99 * at),
    },
    "It falls: along a line the wave is exact at the Courant limit and latest at the shortest step. What helps is \
     smaller cells.",
);

const Z: Symbol = Symbol::scalar("z", Dimension::METRE).real(0.25, 1.25);
const T: Symbol = Symbol::scalar("t", Dimension::SECOND).real(0.25, 1.25);
const DZ: Symbol = Symbol::scalar("Delta", Dimension::METRE).real(0.25, 1.25);
const DT: Symbol = Symbol::scalar("tau", Dimension::SECOND).real(0.25, 1.25);
const S: Symbol = Symbol::scalar("S", Dimension::ONE).real(0.25, 1.0);
const C: Symbol = Symbol::scalar("c", Dimension::METRE_PER_SECOND).real(0.5, 2.0);
const K: Symbol = Symbol::scalar("k", Dimension::RADIAN_PER_METRE).real(0.5, 2.0);
const OMEGA: Symbol = Symbol::scalar("omega", Dimension::HERTZ).real(0.5, 2.0);
const FIELD: Symbol = Symbol::scalar("E", Dimension::VOLT_PER_METRE);

/// E(t + τ) − 2E(t) + E(t − τ) = S²(E(z + Δ) − 2E(z) + E(z − Δ)), with `at` telling what E(z, t) is.
fn second_differences(at: impl Fn(Expr, Expr) -> Expr) -> Equation {
    let here = || at(Z.into(), T.into());
    let in_time = at(Z.into(), T + DT) - 2 * here() + at(Z.into(), T - DT);
    let in_space = at(Z + DZ, T.into()) - 2 * here() + at(Z - DZ, T.into());
    Equation::new(in_time, S.pow(2) * in_space)
}

fn dispersion(last: Expr) -> Chain {
    let wave = |z: Expr, t: Expr| exp(i() * (K * z - OMEGA * t));
    let step = second_differences(wave);
    let per_wave = |phase: Expr| exp(i() * &phase) - 2 + exp(-(i() * phase));
    Chain::assume(step, "the step, E = e^(i(kz − ωt))")
        .given(Z, 0, "any other place only multiplies both sides")
        .given(T, 0, "and so does any other time")
        .then(Equation::new(per_wave(OMEGA * DT), S.pow(2) * per_wave(K * DZ)), ["E at the neighbours"])
        .then(Equation::new(sin(OMEGA * DT / 2).pow(2), last), ["e^(iα) − 2 + e^(−iα) = −4 sin²(α/2)"])
}

/// The least excess S − 1 of which the growth is measured: thousands of steps to grow e-fold would be too many.
const SLOWEST: f64 = 1e-6;

/// A periodic line of vacuum, cells of 1 m, at this Courant number, above the limit too.
fn ring(cells: usize, courant: f64) -> Line {
    let stepping = Stepping { unstable: true, ..Stepping::at(courant) };
    Line::new(Setup::vacuum(cells, 1.0, Ends::Periodic, stepping)).expect("a line within all limits")
}

/// The wave cos(kz − ωt) that runs on the ring, ωΔt as given.
fn start(line: &mut Line, k: f64, phase: f64) {
    line.set(|z| (k * z).cos(), |z| (k * z - 0.5 * phase).cos() / Z_0);
}

fn run(line: &mut Line, steps: u64) {
    line.run(steps).expect("at least one step");
}

const SPEED: Check<fn(f64, f64) -> f64> = check(
    "speed",
    "a wave on the grid keeps its shape and runs at the speed that the dispersion \
     relation says",
)
.against(
    "the solver, a thousand steps on a ring, against the wave in closed form at every \
     node",
)
.within(1e-11, "1", "two roundings a step of fields that are at most 1, over a thousand steps")
.of(speed, |k, courant| phase_per_step(&[k], courant).re)
.slip("ω = ck, as if there were no grid", |k, courant| k * courant);

fn speed(_: &mut Bench, phase: fn(f64, f64) -> f64) -> Measured {
    const CELLS: usize = 60;
    const STEPS: u64 = 1000;
    let cases = [0.1, 0.5, 0.9, 0.999].into_iter().flat_map(|s| [1, 3, 10, 20].map(|waves| (s, waves)));
    Measured::worst(cases.map(|(courant, waves)| {
        let k = TAU * f64::from(waves) / CELLS as f64;
        let phase = phase(k, courant);
        let mut line = ring(CELLS, courant);
        start(&mut line, k, phase);
        run(&mut line, STEPS);
        let missed = line.e()[..CELLS]
            .iter()
            .enumerate()
            .map(|(at, e)| (e - (k * at as f64 - phase * STEPS as f64).cos(), String::new()));
        (Measured::worst(missed).value, format!("S = {courant}, {} cells to a wave", CELLS as f64 / f64::from(waves)))
    }))
}

const STABLE: Check<f64> = check(
    "stable",
    "a hair below the Courant limit the energy on the grid is the same after 100 000 \
     steps",
)
.against("Σ E² + Σ H₋H₊ over all cells, from random fields, every wave length among them")
.within(1e-10, "1", "100 000 steps of one rounding each, of either sign")
.of(drift, 1.0 - 1e-6)
.slip("a hair above", 1.0 + 1e-6);

/// Relative change of the energy on a ring.
fn drift(bench: &mut Bench, courant: f64) -> Measured {
    let mut line = ring(64, courant);
    let noise: Vec<f64> = (0..128).map(|_| uniform(&mut bench.stream, -1.0, 1.0)).collect();
    line.set(|z| noise[z as usize], |z| noise[64 + z as usize] / Z_0);
    let before = energy(&mut line);
    run(&mut line, 100_000);
    let after = energy(&mut line);
    Measured::worst([((after - before) / before, format!("S = 1 {:+.0e}", courant - 1.0))])
}

/// The energy that leapfrog keeps [V² m⁻²], one step on.
fn energy(line: &mut Line) -> f64 {
    let before = line.h();
    run(line, 1);
    let magnetic: f64 = before.iter().zip(line.h()).map(|(a, b)| a * b).sum();
    let cells = line.setup().cells;
    let electric: f64 = line.e()[..cells].iter().map(|e| e * e).sum();
    electric + Z_0 * Z_0 * magnetic
}

const GROWTH: Check<fn(f64) -> f64> = check("growth", "beyond the limit the shortest wave grows by 2 arcosh S a step")
    .against("the solver, at the setting's S too: how the logarithm of the field rises from step to step")
    .within(
        1e-11,
        "1",
        "rounding of up to 40 000 steps, against a rate that is three thousandths where it \
         is least",
    )
    .of(growth, growth_per_step)
    .slip(
        "growth in proportion to the excess, as for the amplitude of one equation of first \
         order",
        |excess| 2.0 * (excess - 1.0),
    );

fn growth(bench: &mut Bench, theory: fn(f64) -> f64) -> Measured {
    let numbers = [SLOWEST, 1e-4, 1e-2, 0.1, 0.5].map(|excess| 1.0 + excess);
    let own = Some(bench.setting().number(COURANT.name)).filter(|courant| *courant >= numbers[0]);
    Measured::worst(numbers.into_iter().chain(own).map(|courant| {
        let found = grown(courant);
        let theory = theory(courant);
        (found / theory - 1.0, format!("S = {courant}: {found:.6} a step"))
    }))
}

const GROWTH_IN_THE_PLANE: Check<fn(f64) -> f64> = check(
    "growth_in_the_plane",
    "in two dimensions the limit is 1/√2 over sin(kΔ/2), and beyond it the shortest \
     wave of a box grows by 2 arcosh(√2 S sin(kΔ/2)) a step",
)
.against(
    "the two-dimensional solver, E along z and H along z: how the logarithm of the \
     field rises",
)
.within(1e-9, "1", "rounding of up to 4000 steps, against a rate of 0.03 at least")
.of(growth_in_the_plane, |courant| growth_per_step(courant * 2f64.sqrt()))
.slip("the limit of one dimension", growth_per_step);

fn growth_in_the_plane(_: &mut Bench, theory: fn(f64) -> f64) -> Measured {
    let excesses = [(1e-4, 2000), (1e-2, 400), (0.1, 100)];
    let cases =
        [Polarisation::S, Polarisation::P].into_iter().flat_map(|polarisation| excesses.map(|e| (polarisation, e)));
    Measured::worst(cases.map(|(polarisation, (excess, steps))| {
        // The mode of a box of conductors that is nearest to two cells a wave both ways; it grows from here on.
        let k = 15.0 * PI / 16.0;
        let courant = (1.0 + excess) / (2f64.sqrt() * (0.5 * k).sin());
        let stepping = Stepping { unstable: true, ..Stepping::at(courant) };
        let mut plane = Plane::new(plane::Setup::vacuum([16, 16], 1.0, polarisation, stepping)).expect("asked for");
        plane.set_z(|x, y| match polarisation {
            Polarisation::S => ((k * x).sin() * (k * y).sin()).into(),
            Polarisation::P => ((k * x).cos() * (k * y).cos()).into(),
        });
        let largest = |plane: &Plane| plane.z().iter().flatten().fold(0.0_f64, |most, z| most.max(z.abs())).ln();
        plane.run(steps).expect("some steps");
        let before = largest(&plane);
        plane.run(steps).expect("some steps");
        let found = (largest(&plane) - before) / steps as f64;
        let of_mode = theory(courant * (0.5 * k).sin());
        (found / of_mode - 1.0, format!("{polarisation:?}, S = {courant:.6}"))
    }))
}

/// ln of the growth per step of the shortest wave, once the wave that dies away as fast has gone: where it is that slow
/// that this takes too long, at S below 1 + 10⁻⁶, what is found is too small.
fn grown(courant: f64) -> f64 {
    // The field stays within the range of a double: e^(2 × 56), or less at the slowest.
    let steps = (56.0 / growth_per_step(courant)).clamp(32.0, 20_000.0) as u64;
    let mut line = ring(16, courant);
    line.set(|z| (PI * z).cos(), |_| 0.0);
    run(&mut line, steps);
    let before = line.e()[0].abs().ln();
    run(&mut line, steps);
    (line.e()[0].abs().ln() - before) / steps as f64
}

fn readout(setting: &Setting) -> Vec<Quantity> {
    let (courant, cells) = (setting.number("courant"), setting.number("per_wave"));
    let k = TAU / cells;
    let value = |key, symbol, says, value| Quantity { key, symbol, says, value, unit: "1" };
    let growth = value("growth", "ln g", "growth of the shortest wave per step", growth_per_step(courant));
    let speed = || value("speed", "v/c", "speed of the wave on the grid", phase_velocity(&[k], courant));
    let found = || value("growth_found", "ln g", "the same, measured on the grid", grown(courant));
    let runs = (courant * (0.5 * k).sin() <= 1.0).then(speed);
    runs.into_iter().chain([growth]).chain((courant >= 1.0 + SLOWEST).then(found)).collect()
}

/// Phase that the wave gains per step on a ring [rad], followed step by step.
fn measured_phase(cells: usize, courant: f64) -> f64 {
    const STEPS: u32 = 50;
    let k = TAU / cells as f64;
    let mut line = ring(cells, courant);
    start(&mut line, k, phase_per_step(&[k], courant).re);
    let component = |line: &Line| -> Complex64 {
        line.e()[..cells].iter().enumerate().map(|(at, e)| e * Complex64::cis(-k * at as f64)).sum()
    };
    let mut before = component(&line);
    let mut gained = 0.0;
    for _ in 0..STEPS {
        run(&mut line, 1);
        let now = component(&line);
        gained -= (now / before).arg();
        before = now;
    }
    gained / f64::from(STEPS)
}

fn late(setting: &Setting) -> Plot {
    let own = setting.number("courant").min(0.999);
    let chart = Chart::new(
        "",
        Axis::log("cells to a wavelength λ/Δ", "").range(3.0, 100.0),
        Axis::log("lag of the wave 1 − v/c", "").range(1e-6, 1.0),
    );
    let numbers = [own, 0.9, 0.99];
    let chart = numbers.iter().enumerate().fold(chart, |chart, (at, &courant)| {
        let line = (0..=160).map(|step| 3.0 * (100.0f64 / 3.0).powf(f64::from(step) / 160.0));
        let curve = line.map(|cells| [cells, 1.0 - phase_velocity(&[TAU / cells], courant)]).collect();
        let points = [3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96].map(|cells| {
            let k = TAU / cells as f64;
            [cells as f64, 1.0 - measured_phase(cells, courant) / (courant * k)]
        });
        let hue = Hue::Nth(at as u8);
        chart.line(hue, format!("S = {courant}"), curve).with(Mark::Points {
            label: String::new(),
            hue,
            shape: Shape::Disc,
            joined: false,
            points: points.into(),
        })
    });
    Plot::of("Waves on the grid: theory (lines) and solver (points)", chart)
}

fn courant_map(_: &Setting) -> Plot {
    const COLUMNS: usize = 120;
    const ROWS: usize = 120;
    let values = (0..COLUMNS * ROWS).map(|cell| {
        let k = PI * ((cell % COLUMNS) as f64 + 0.5) / COLUMNS as f64;
        let courant = 0.5 + ((cell / COLUMNS) as f64 + 0.5) / ROWS as f64;
        phase_per_step(&[k], courant).im
    });
    let limit = (0..=100).map(|at| 0.46 + 0.54 * f64::from(at) / 100.0).map(|k| [k, (0.5 * PI * k).sin().recip()]);
    let map = Panel::Map(Map {
        title: "one dimension: which waves grow".into(),
        x: Axis::linear("wave number kΔ/π", "").range(0.0, 1.0),
        y: Axis::linear("Courant number S", "").range(0.5, 1.5),
        colour: Axis::linear("growth per step, ln g", "").range(0.0, 2.0),
        ramp: Ramp::Sequential,
        columns: COLUMNS,
        values: values.collect(),
        marks: vec![Mark::Line {
            label: String::new(),
            hue: Hue::Reference,
            dash: crate::figure::Dash::Dashed,
            points: limit.collect(),
        }],
    });
    let excess = |at: i32| 10f64.powf(f64::from(at) / 20.0);
    let theory = (-120..=0).map(|at| [excess(at), growth_per_step(1.0 + excess(at))]).collect();
    let measured = [-120, -100, -80, -60, -40, -20, 0].map(|at| [excess(at), grown(1.0 + excess(at))]);
    let chart = Chart::new("beyond the limit", Axis::log("excess S − 1", ""), Axis::log("growth per step, ln g", ""))
        .line(Hue::Natural, "2 arcosh S", theory)
        .with(Mark::Points {
            label: "solver".into(),
            hue: Hue::Ours,
            shape: Shape::Disc,
            joined: false,
            points: measured.into(),
        });
    Plot::grid("The Courant limit", 2, vec![map, chart.into()])
}

/// The setting's grid at rest but for one rounding error, and what theory makes of it.
fn explosion(setting: &Setting) -> Plot {
    const STEPS: usize = 400;
    let courant = setting.number(COURANT.name);
    let mut line = ring(200, courant);
    line.set(|z| if z == 100.0 { f64::EPSILON } else { 0.0 }, |_| 0.0);
    let found = (1..=STEPS).map(|step| {
        run(&mut line, 1);
        [step as f64, line.e().iter().fold(0.0f64, |most, e| most.max(e.abs()))]
    });
    let found: Vec<_> = found.filter(|[_, largest]| (1e-20..1e300).contains(largest)).collect();
    let growth = growth_per_step(courant);
    // Through the last point: at first other waves than the shortest are there too.
    let theory = found.last().map_or(vec![], |&[end, height]| {
        found.iter().map(|&[step, _]| [step, height * (growth * (step - end)).exp()]).collect()
    });
    let chart = Chart::new(
        format!("S = {}", crate::parameter::number(courant)),
        Axis::linear("step", "").range(0.0, STEPS as f64),
        Axis::log("largest |E| on the grid", "V/m"),
    )
    .line(Hue::Ours, "solver", found)
    .dashed(Hue::Reference, "growth by 2 arcosh S a step", theory);
    Plot::of("What becomes of one rounding error", chart)
}

fn blow_up(setting: &Setting) -> Plot {
    const STEPS: usize = 400;
    let chart = Chart::new(
        "",
        Axis::linear("step", "").range(0.0, STEPS as f64),
        Axis::log("largest |E| on the grid", "V/m").range(1e-1, 1e12),
    );
    let own = setting.number("courant");
    let chart =
        [(4, 1.1), (3, 1.01), (2, 1.003), (1, 0.999), (0, own)].into_iter().fold(chart, |chart, (at, courant)| {
            let mut line = ring(200, courant);
            let pulse = |z: f64| (-((z - 100.0) / 8.0).powi(2)).exp();
            line.set(pulse, |z| pulse(z - 0.5 * courant) / Z_0);
            let heights = (1..=STEPS).map(|step| {
                run(&mut line, 1);
                [step as f64, line.e().iter().fold(0.0f64, |most, e| most.max(e.abs()))]
            });
            // All lie on 1 until they rise: dashes let the others through.
            let dash = if at == 0 { Dash::Dashed } else { Dash::Solid };
            chart.with(Mark::Line {
                label: format!("S = {courant}"),
                hue: Hue::Nth(at as u8),
                dash,
                points: heights.collect(),
            })
        });
    Plot::of("A pulse, below and beyond the Courant limit", chart)
}
