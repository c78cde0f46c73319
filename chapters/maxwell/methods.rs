//! C2: other ways to carry a wave along, and what each costs.

use crate::figure::{Axis, Chart, Hue, Plot};
use crate::setting::{Kind, Parameter, Setting};
use crate::vocabulary::{Bench, Expects, Figure, Heat, Lane, Quantity, Race, Statement, Step, rms};
use light::em::line::{Ends, Line, Setup as LineSetup};
use light::em::plane::Region;
use light::em::plane::{self, Plane};
use light::em::wave::{Problem, Scheme};
use light::em::{Medium, Pulse, Refusal, Stepping, Wall};
use light::equation::expr::partial;
use light::equation::{Dimension, Equation, Symbol};
use std::f64::consts::{PI, TAU};

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
    rows: &["C2"],
    parameters: &[CELLS],
    statements: &[Statement {
        id: "wave_equation",
        says: "what all of them solve, with one number for the medium",
        rows: &["C2"],
        equation: || {
            let field = || FIELD.at([Z.into(), T.into()]);
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
        THROUGHPUT,
    ],
    figures: &[Figure {
        id: "after_a_while",
        says: "Both pulses after they have run round the line once and a bit.",
        rows: &["C2"],
        plot: after_a_while,
    }],
};

const FIELD: Symbol = Symbol::scalar("E", Dimension::VOLT_PER_METRE);
const Z: Symbol = Symbol::scalar("z", Dimension::METRE);
const T: Symbol = Symbol::scalar("t", Dimension::SECOND);
const C: Symbol = Symbol::scalar("c", Dimension::METRE_PER_SECOND);

/// How far the pulses run round a line of 1 m: no whole number of anything.
const DISTANCE: f64 = 1.13;

/// Entire in z, so that its spectrum falls faster than any power.
fn smooth(z: f64) -> f64 {
    (10.0 * ((TAU * (z - 0.5)).cos() - 1.0)).exp()
}

fn square(z: f64) -> f64 {
    if (z - 0.5).abs() < 0.2 { 1.0 } else { 0.0 }
}

const RACE: Race = Race {
    id: "",
    claim: "",
    rows: &["C2"],
    work: "cells squared: cell-steps but for a factor",
    error: "RMS error of E over the peak",
    reference: "d'Alembert's f(z − ct) at every node",
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
    lane("yee", "Yee: second order", RESOLVED, order(1.0, 0.1), |_, n| carried(Scheme::Yee, smooth, n)),
    lane("fourth_order", "fourth order", RESOLVED, order(2.0, 0.2), |_, n| carried(Scheme::FourthOrder, smooth, n)),
    lane("pseudo_spectral", "pseudo-spectral", RESOLVED, order(2.0, 0.2), |_, n| {
        carried(Scheme::PseudoSpectral, smooth, n)
    }),
    lane("spectral", "every harmonic by itself", RESOLVED, EXACT, |_, n| carried(Scheme::Spectral, smooth, n)),
    lane("dalembert", "d'Alembert", RESOLVED, EXACT, |_, n| carried(Scheme::DAlembert, smooth, n)),
];

const SQUARE: [Lane; 5] = [
    lane("yee", "Yee: second order", COUNTS, order(1.0 / 6.0, 0.04), |_, n| carried(Scheme::Yee, square, n)),
    lane("fourth_order", "fourth order", COUNTS, order(0.2, 0.04), |_, n| carried(Scheme::FourthOrder, square, n)),
    lane("pseudo_spectral", "pseudo-spectral", COUNTS, order(0.2, 0.04), |_, n| {
        carried(Scheme::PseudoSpectral, square, n)
    }),
    lane("spectral", "every harmonic by itself", COUNTS, order(0.25, 0.08), |_, n| {
        carried(Scheme::Spectral, square, n)
    }),
    lane("dalembert", "d'Alembert", COUNTS, EXACT, |_, n| carried(Scheme::DAlembert, square, n)),
];

type Prepare = fn(&mut Bench, u64) -> Heat;

const fn lane(
    id: &'static str,
    label: &'static str,
    works: &'static [u64],
    expects: Expects,
    prepare: Prepare,
) -> Lane {
    Lane { id, label, works, expects, repeats: 1, prepare }
}

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

fn deviation(found: &[f64], exact: &[f64]) -> f64 {
    rms(&found.iter().zip(exact).map(|(found, exact)| found - exact).collect::<Vec<_>>())
}

fn carried(scheme: Scheme, profile: fn(f64) -> f64, work: u64) -> Heat {
    let cells = work.isqrt() as usize;
    let exact = exact(profile, cells);
    Heat {
        run: Box::new(move || carry(scheme, profile, cells)),
        error: Box::new(move |found| deviation(found, &exact)),
    }
}

const THROUGHPUT: Race = Race {
    id: "throughput",
    claim: "steps of the grid on one core, and on all: 1 ns is 1000 million cell-steps a second",
    rows: &["C2"],
    work: "cell-steps",
    error: "|ΔE| of a standing wave",
    reference: "the wave at the speed that the grid gives it, at one node; with glass and metal: everything in every cell, one step at a time",
    lanes: &[
        lane("line_small", "line of 10⁴ cells", &[10_000_000, 100_000_000], ROUNDED, |_, n| on_line(10_000, n)),
        lane("line_large", "line of 10⁶ cells", &[64_000_000, 128_000_000], ROUNDED, |_, n| on_line(1_000_000, n)),
        lane("plane_small", "plane of 300²", &[9_000_000, 90_000_000], ROUNDED, |_, n| {
            on_plane(300, Plane::run_serial, n)
        }),
        lane("plane_middle", "plane of 1000²", &[16_000_000, 64_000_000], ROUNDED, |_, n| {
            on_plane(1000, Plane::run_serial, n)
        }),
        lane("plane_large", "plane of 3000²", &[36_000_000, 144_000_000], ROUNDED, |_, n| {
            on_plane(3000, Plane::run_serial, n)
        }),
        lane("plane_unblocked", "the same, one step at a time", &[36_000_000, 144_000_000], ROUNDED, |_, n| {
            on_plane(3000, step_by_step, n)
        }),
        lane("plane_full", "1000² with glass, metal, absorbers", &[16_000_000, 64_000_000], SAME, |_, n| in_full(n)),
        lane("plane_parallel", "3000² on all cores", &[36_000_000, 144_000_000], ROUNDED, |_, n| {
            on_plane(3000, Plane::run, n)
        }),
    ],
};

const SAME: Expects = Expects::Within { limit: 0.0, why: "the same operations on the same numbers" };
const ROUNDED: Expects = Expects::Within { limit: 1e-11, why: "two roundings a step" };

/// A standing wave of twenty cells between conductors, so many cell-steps further at each run.
fn on_line(cells: usize, cell_steps: u64) -> Heat {
    let k = TAU / 20.0;
    let phase = light::em::theory::phase_per_step(&[k], 0.5).re;
    let walls = Ends::Walls([Wall::Conductor; 2]);
    let mut line = Line::new(LineSetup::vacuum(cells, 1.0, walls, Stepping::at(0.5))).expect("within all limits");
    // Twenty cells further the wave is the same, and there its argument would have lost digits. H, half a step later,
    // starts at zero: there the standing wave has its crest.
    line.set(|z| (k * (z % 20.0)).sin(), |_| 0.0);
    let (steps, crest) = (cell_steps / cells as u64, cells / 2 + 5);
    Heat {
        run: Box::new(move || {
            line.run(steps).expect("some steps");
            vec![line.e()[crest], line.steps() as f64]
        }),
        error: Box::new(move |found| (found[0] - (phase * (found[1] - 0.5)).cos() / (0.5 * phase).cos()).abs()),
    }
}

/// A way to take many steps.
type Run = fn(&mut Plane, u64) -> Result<(), Refusal>;

/// Without carrying rows through several steps while they are in the cache.
fn step_by_step(plane: &mut Plane, steps: u64) -> Result<(), Refusal> {
    (0..steps).try_for_each(|_| plane.run_serial(1))
}

/// The lowest mode of a square of vacuum between conductors, TM, so many cell-steps further at each run.
fn on_plane(side: usize, run: Run, cell_steps: u64) -> Heat {
    let stepping = Stepping::at(0.7);
    let k = PI / side as f64;
    let phase = light::em::theory::phase_per_step(&[k, k], 0.7).re;
    let setup = plane::Setup::vacuum([side, side], 1.0, plane::Polarisation::Tm, stepping);
    let mut plane = Plane::new(setup).expect("within all limits");
    // H, half a step later, starts at zero: there the standing wave has its crest.
    plane.set_z(|x, y| ((k * x).sin() * (k * y).sin()).into());
    let middle = plane.probe([side / 2; 2]).expect("on the grid");
    let steps = cell_steps / (side * side) as u64;
    Heat {
        run: Box::new(move || {
            run(&mut plane, steps).expect("some steps");
            vec![plane.record(middle).last().map_or(f64::NAN, |e| e.re), plane.steps() as f64]
        }),
        error: Box::new(move |found| {
            let height = (k * (side / 2) as f64).sin().powi(2) / (0.5 * phase).cos();
            (found[0] - height * (phase * (found[1] - 0.5)).cos()).abs()
        }),
    }
}

/// A plane of 1000² cells, open all round, with a lamp between a disc of glass and one of metal.
fn furnished(pruned: bool) -> (Plane, usize) {
    const SIDE: usize = 1000;
    let regions = vec![
        Region::disc([300.0, 300.0], 150.0, Medium::dielectric(2.25)),
        Region::disc([300.0, 610.0], 150.0, Medium::metal(0.5 * light::em::C, 0.01 * light::em::C)),
    ];
    let stepping = Stepping { pruned, ..Stepping::at(0.7) };
    let open = plane::Setup::vacuum([SIDE; 2], 1.0, plane::Polarisation::Tm, stepping).open(20);
    let mut plane = Plane::new(plane::Setup { regions, ..open }).expect("within all limits");
    let pulse = Pulse::Gaussian { delay: 14.0 / light::em::C, width: 5.0 / light::em::C };
    plane.inject([300, 455], 1.0, pulse).expect("a stepped place");
    let probe = plane.probe([305, 448]).expect("on the grid");
    (plane, probe)
}

/// So many cell-steps from the start.
fn in_full(cell_steps: u64) -> Heat {
    let steps = cell_steps / 1_000_000;
    let (start, probe) = furnished(true);
    let mut ready = Some(start.clone());
    let (mut whole, same) = furnished(false);
    step_by_step(&mut whole, steps).expect("some steps");
    let expected = whole.record(same);
    Heat {
        run: Box::new(move || {
            let mut plane = ready.take().unwrap_or_else(|| start.clone());
            plane.run_serial(steps).expect("some steps");
            plane.record(probe).iter().map(|e| e.re).collect()
        }),
        error: Box::new(move |found| {
            let largest = expected.iter().map(|e| e.re.abs()).fold(0.0, f64::max);
            rms(&found.iter().zip(&expected).map(|(found, e)| (found - e.re) / largest).collect::<Vec<_>>())
        }),
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
            value: deviation(&carry(scheme, profile, cells), &exact(profile, cells)),
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
