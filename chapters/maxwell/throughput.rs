//! C2: how many cells the grid steps in a second.

use crate::vocabulary::{Expects, Heat, Race, lane, race};
use light::Polarisation;
use light::em::line::{Ends, Line, Setup as LineSetup};
use light::em::plane::{self, Plane, Region};
use light::em::{Medium, Pulse, Refusal, Stepping, Wall};
use std::f64::consts::{PI, TAU};
use yardstick::statistics::rms;

pub(super) const THROUGHPUT: Race = race(
    "throughput",
    "steps of the grid on one core, and on all: 1 ns is 1000 million cell-steps a \
     second",
)
.rows(&["C2"])
.work("cell-steps")
.error(
    "|ΔE| of a standing wave",
    "the wave at the speed that the grid gives it, at one node; with glass and metal: \
     everything in every cell, one step at a time",
)
.lanes(&[
    lane("line_small", "line of 10⁴ cells", &[10_000_000, 100_000_000], |_, n| on_line(10_000, n)).expects(ROUNDED),
    lane("line_large", "line of 10⁶ cells", &[64_000_000, 128_000_000], |_, n| on_line(1_000_000, n)).expects(ROUNDED),
    lane("plane_small", "plane of 300²", &[9_000_000, 90_000_000], |_, n| on_plane(300, Plane::run_serial, n))
        .expects(ROUNDED),
    lane("plane_middle", "plane of 1000²", &[16_000_000, 64_000_000], |_, n| on_plane(1000, Plane::run_serial, n))
        .expects(ROUNDED),
    lane("plane_large", "plane of 3000²", &[36_000_000, 144_000_000], |_, n| on_plane(3000, Plane::run_serial, n))
        .expects(ROUNDED),
    lane("plane_unblocked", "the same, one step at a time", &[36_000_000, 144_000_000], |_, n| {
        on_plane(3000, step_by_step, n)
    })
    .expects(ROUNDED),
    lane("plane_full", "1000² with glass, metal, absorbers", &[16_000_000, 64_000_000], |_, n| in_full(n))
        .expects(SAME),
    lane("plane_parallel", "3000² on all cores", &[36_000_000, 144_000_000], |_, n| on_plane(3000, Plane::run, n))
        .expects(ROUNDED),
]);

const SAME: Expects = Expects::Within { limit: 0.0, why: "the same operations on the same numbers" };
pub(super) const ROUNDED: Expects = Expects::Within { limit: 1e-11, why: "two roundings a step" };

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

/// The lowest mode of a square of vacuum between conductors, E across it, so many cell-steps further at each run.
fn on_plane(side: usize, run: Run, cell_steps: u64) -> Heat {
    let stepping = Stepping::at(0.7);
    let k = PI / side as f64;
    let phase = light::em::theory::phase_per_step(&[k, k], 0.7).re;
    let setup = plane::Setup::vacuum([side, side], 1.0, Polarisation::S, stepping);
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
    let open = plane::Setup::vacuum([SIDE; 2], 1.0, Polarisation::S, stepping).open(20);
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
