//! Stacks of films: stack·wavelength evaluations a second, through the batch, against the textbook's matrix.
//! `cargo bench -p light --bench film`

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use light::Complex64;
use light::Polarisation;
use light::optics::Incidence;
use light::optics::film::{Layer, Powers, Stack, textbook};

const LAYERS: [usize; 4] = [1, 5, 21, 101];
const WAVELENGTHS: usize = 1024;

fn main() {
    divan::main();
}

fn quarter_waves(count: usize, k: f64) -> Vec<Layer> {
    let indices = [2.35, 1.38].into_iter().cycle().take(count);
    indices.map(|n| Layer { index: Complex64::new(n, k), thickness: 550e-9 / (4.0 * n) }).collect()
}

fn wavelengths() -> Vec<f64> {
    (0..WAVELENGTHS).map(|i| 380e-9 + 400e-9 * i as f64 / WAVELENGTHS as f64).collect()
}

fn batch(bencher: Bencher, layers: &[Layer], incidence: Incidence, polarisation: Polarisation) {
    let stack = Stack { n_i: 1.0, layers, substrate: Complex64::from(1.52) };
    let wavelengths = wavelengths();
    let mut powers = vec![Powers { reflectance: 0.0, transmittance: 0.0, absorptance: 0.0 }; WAVELENGTHS];
    bencher.counter(ItemsCount::new(WAVELENGTHS)).bench_local(|| {
        black_box(stack).waves(incidence, polarisation).powers(&wavelengths, &mut powers);
        black_box(&powers);
    });
}

#[divan::bench(args = LAYERS)]
fn clear_normal(bencher: Bencher, count: usize) {
    batch(bencher, &quarter_waves(count, 0.0), Incidence::NORMAL, Polarisation::S);
}

#[divan::bench(args = LAYERS)]
fn clear_oblique(bencher: Bencher, count: usize) {
    batch(bencher, &quarter_waves(count, 0.0), Incidence::from_angle(0.8), Polarisation::P);
}

#[divan::bench(args = LAYERS)]
fn absorbing_oblique(bencher: Bencher, count: usize) {
    batch(bencher, &quarter_waves(count, 0.01), Incidence::from_angle(0.8), Polarisation::P);
}

#[divan::bench(args = LAYERS)]
fn evanescent(bencher: Bencher, count: usize) {
    let layers = vec![Layer { index: Complex64::from(1.0), thickness: 3e-8 }; count];
    let stack = Stack { n_i: 1.52, layers: &layers, substrate: Complex64::from(1.52) };
    let wavelengths = wavelengths();
    let mut powers = vec![Powers { reflectance: 0.0, transmittance: 0.0, absorptance: 0.0 }; WAVELENGTHS];
    bencher.counter(ItemsCount::new(WAVELENGTHS)).bench_local(|| {
        black_box(stack).waves(Incidence::from_angle(1.0), Polarisation::P).powers(&wavelengths, &mut powers);
        black_box(&powers);
    });
}

/// One wavelength at a time, indices looked up anew: what a dispersive stack costs.
#[divan::bench(args = LAYERS)]
fn dispersive_response(bencher: Bencher, count: usize) {
    let layers = quarter_waves(count, 0.01);
    let stack = Stack { n_i: 1.0, layers: &layers, substrate: Complex64::from(1.52) };
    let wavelengths = wavelengths();
    let incidence = Incidence::from_angle(0.8);
    bencher.counter(ItemsCount::new(WAVELENGTHS)).bench_local(|| {
        for &wavelength in &wavelengths {
            black_box(black_box(stack).response(wavelength, incidence, Polarisation::P));
        }
    });
}

#[divan::bench(args = LAYERS)]
fn textbook_matrix(bencher: Bencher, count: usize) {
    let layers = quarter_waves(count, 0.0);
    let stack = Stack { n_i: 1.0, layers: &layers, substrate: Complex64::from(1.52) };
    let wavelengths = wavelengths();
    bencher.counter(ItemsCount::new(WAVELENGTHS)).bench_local(|| {
        for &wavelength in &wavelengths {
            black_box(textbook::characteristic_matrix(
                black_box(&stack),
                wavelength,
                Incidence::NORMAL,
                Polarisation::S,
            ));
        }
    });
}
