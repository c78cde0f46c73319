//! The grid against closed forms, against arbitrary precision, and against itself.

mod balances;
mod coefficients;
mod echoes;
mod identical;
mod interfaces;
mod open_space;
mod refusals;
mod stability;
mod waves;

use super::Pulse;
use num_complex::Complex64;

/// A pulse about `frequency` [Hz] whose spectrum spans about a third of it.
fn packet(frequency: f64, cycles: f64) -> Pulse {
    let width = cycles / frequency;
    Pulse::Modulated { frequency, delay: 6.0 * width, width }
}

fn complex(series: &[f64]) -> Vec<Complex64> {
    series.iter().map(|&e| Complex64::from(e)).collect()
}

fn worst(errors: impl IntoIterator<Item = f64>) -> f64 {
    errors.into_iter().map(f64::abs).max_by(f64::total_cmp).expect("some errors")
}
