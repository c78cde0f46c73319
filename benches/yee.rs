//! The Yee grid: cell-steps a second, one core unless it says otherwise.
//! `cargo bench -p light --bench yee`

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use light::em::line::{self, Ends, Line};
use light::em::{Medium, Stepping};

fn main() {
    divan::main();
}

fn line(bencher: Bencher, setup: line::Setup, steps: u64) {
    let cells = setup.cells as u64;
    let mut line = Line::new(setup).expect("a valid line");
    let length = cells as f64 * 1e-9;
    line.set(|z| (-(z / length - 0.5).powi(2) * 1e4).exp(), |_| 0.0);
    bencher.counter(ItemsCount::new(cells * steps)).bench_local(|| {
        line.run(black_box(steps)).expect("at least one step");
        black_box(line.e());
    });
}

#[divan::bench(args = [1_000, 10_000, 100_000, 1_000_000])]
fn line_vacuum(bencher: Bencher, cells: usize) {
    let setup = line::Setup::vacuum(cells, 1e-9, Ends::open(20), Stepping::at(0.99));
    line(bencher, setup, (20_000_000 / cells as u64).max(64));
}

#[divan::bench(args = [10_000, 1_000_000])]
fn line_periodic(bencher: Bencher, cells: usize) {
    let setup = line::Setup::vacuum(cells, 1e-9, Ends::Periodic, Stepping::at(0.99));
    line(bencher, setup, (20_000_000 / cells as u64).max(64));
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
    line(bencher, setup, (20_000_000 / cells as u64).max(64));
}
