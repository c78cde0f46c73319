//! Rays among heights, on one thread: made and followed until they leave.
//! `cargo bench -p light --bench relief`

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use light::relief::Relief;
use yardstick::random::{stream, uniform};

const RAYS: usize = 4096;

fn main() {
    divan::main();
}

fn even() -> impl FnMut() -> f64 {
    let mut stream = stream(1, "bench");
    move || uniform(&mut stream, 0.0, 1.0)
}

#[divan::bench(args = [(0.1, 0.0), (0.1, 85.0), (0.5, 0.0), (0.5, 60.0), (0.5, 85.0), (0.8, 60.0)])]
fn gaussian(bencher: Bencher, (alpha, degrees): (f64, f64)) {
    let mut even = even();
    let relief = Relief::gaussian(1024, 8.0, alpha, &mut even).expect("a valid relief");
    let points: Vec<[f64; 2]> = (0..RAYS).map(|_| [even(), even()]).collect();
    let (sin, cos) = f64::to_radians(degrees).sin_cos();
    bencher.counter(ItemsCount::new(RAYS)).bench_local(|| {
        for &point in &points {
            black_box(relief.trace([0.6 * sin, 0.8 * sin, cos], point, |_| 1.0, 1000));
        }
    });
}

#[divan::bench(args = [256, 1024])]
fn field(bencher: Bencher, side: usize) {
    let mut even = even();
    bencher.bench_local(|| Relief::gaussian(black_box(side), 8.0, 0.5, &mut even));
}
