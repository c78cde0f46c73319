//! The Yee grid: cell-steps a second, one core unless it says otherwise.
//! `cargo bench -p light --bench yee`

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use light::Complex64;
use light::Polarisation;
use light::em::line::{self, Ends, Line};
use light::em::plane::{self, Plane, Region};
use light::em::{Medium, Stepping};

fn main() {
    divan::main();
}

/// Steps that are run at once: many, which may be carried through one tile or row after the other, or one by one,
/// every step a sweep over the whole grid.
const ONE_BY_ONE: u64 = 1;
const AT_ONCE: u64 = u64::MAX;

fn in_portions(steps: u64, portion: u64, mut run: impl FnMut(u64)) {
    let portion = portion.min(steps);
    (0..steps / portion).for_each(|_| run(black_box(portion)));
}

fn line(bencher: Bencher, setup: line::Setup, portion: u64) {
    let cells = setup.cells as u64;
    let steps = (20_000_000 / cells).max(64);
    let mut line = Line::new(setup).expect("a valid line");
    let length = cells as f64 * 1e-9;
    line.set(|z| (-(z / length - 0.5).powi(2) * 1e4).exp(), |_| 0.0);
    bencher.counter(ItemsCount::new(cells * steps)).bench_local(|| {
        in_portions(steps, portion, |steps| line.run(steps).expect("at least one step"));
        black_box(line.e());
    });
}

#[divan::bench(args = [1_000, 10_000, 100_000, 1_000_000])]
fn line_vacuum(bencher: Bencher, cells: usize) {
    let setup = line::Setup::vacuum(cells, 1e-9, Ends::open(20), Stepping::at(0.99));
    line(bencher, setup, AT_ONCE);
}

#[divan::bench(args = [10_000, 1_000_000])]
fn line_vacuum_step_by_step(bencher: Bencher, cells: usize) {
    let setup = line::Setup::vacuum(cells, 1e-9, Ends::open(20), Stepping::at(0.99));
    line(bencher, setup, ONE_BY_ONE);
}

#[divan::bench(args = [10_000, 1_000_000])]
fn line_periodic(bencher: Bencher, cells: usize) {
    let setup = line::Setup::vacuum(cells, 1e-9, Ends::Periodic, Stepping::at(0.99));
    line(bencher, setup, AT_ONCE);
}

/// Glass, sea water, copper and a Drude metal, a quarter each.
#[divan::bench(args = [10_000, 1_000_000])]
fn line_of_everything(bencher: Bencher, cells: usize) {
    let mut setup = line::Setup::vacuum(cells, 1e-9, Ends::open(20), Stepping::at(0.99));
    let media = [
        Medium::dielectric(2.25),
        Medium::conductor(80.0, 5.0),
        Medium::conductor(1.0, 5.8e7),
        Medium::metal(1.37e16, 4e13),
    ];
    let quarter = (cells - 100) / 4;
    setup.layers = media.into_iter().enumerate().map(|(k, m)| (50 + k * quarter..50 + (k + 1) * quarter, m)).collect();
    line(bencher, setup, AT_ONCE);
}

fn plane(bencher: Bencher, setup: plane::Setup, portion: u64) {
    let [columns, rows] = setup.cells;
    let cells = (columns * rows) as u64;
    let steps = (10_000_000 / cells).max(16);
    let middle = 0.5 * setup.spacing * columns as f64;
    let mut plane = Plane::new(setup).expect("a valid plane");
    plane.set_z(|x, y| {
        Complex64::from((-((x - middle).powi(2) + (y - middle).powi(2)) / (0.01 * middle * middle)).exp())
    });
    bencher.counter(ItemsCount::new(cells * steps)).bench_local(|| {
        in_portions(steps, portion, |steps| plane.run_serial(steps).expect("at least one step"));
        black_box(&plane);
    });
}

#[divan::bench(args = [300, 1_000, 3_000], sample_count = 20)]
fn plane_tm_vacuum(bencher: Bencher, cells: usize) {
    plane(bencher, plane::Setup::vacuum([cells; 2], 1e-9, Polarisation::S, Stepping::at(0.7)), AT_ONCE);
}

#[divan::bench(args = [300, 1_000, 3_000], sample_count = 20)]
fn plane_tm_vacuum_step_by_step(bencher: Bencher, cells: usize) {
    plane(bencher, plane::Setup::vacuum([cells; 2], 1e-9, Polarisation::S, Stepping::at(0.7)), ONE_BY_ONE);
}

#[divan::bench(args = [300, 1_000, 3_000], sample_count = 20)]
fn plane_te_vacuum(bencher: Bencher, cells: usize) {
    plane(bencher, plane::Setup::vacuum([cells; 2], 1e-9, Polarisation::P, Stepping::at(0.7)), AT_ONCE);
}

/// Open on four sides, with a disc of glass and one of a conductor.
#[divan::bench(args = [300, 1_000], sample_count = 20)]
fn plane_tm_of_media(bencher: Bencher, cells: usize) {
    let mut setup = plane::Setup::vacuum([cells; 2], 1e-9, Polarisation::S, Stepping::at(0.7)).open(10);
    let length = cells as f64 * setup.spacing;
    setup.regions = vec![
        Region::disc([0.5 * length, 0.5 * length], 0.25 * length, Medium::dielectric(2.25)),
        Region::disc([0.7 * length, 0.7 * length], 0.1 * length, Medium::conductor(4.0, 1e3)),
    ];
    plane(bencher, setup, AT_ONCE);
}
