//! Heights by chance, with a wanted distribution of slopes.

use super::{Relief, only_if, refusal};
use crate::waves::plane::Invalid;
use num_complex::Complex64;
use rustfft::FftPlanner;
use std::f64::consts::TAU;

impl Relief {
    /// A Gaussian field: heights whose correlation over a distance r is e^(−r²/ℓ²), ℓ = `correlation` [cells], scaled so
    /// that the facets' ⟨s_x² + s_y²⟩ is α² to rounding. Its slopes are normal, and Beckmann's distribution is exactly
    /// that of their directions (P. Beckmann & A. Spizzichino, *The Scattering of Electromagnetic Waves from Rough
    /// Surfaces* (1963), §5.3); (side/ℓ)² patches make up the sample.
    ///
    /// `even` gives numbers even in 0 … 1; 2 side² of them are drawn. α in 10⁻⁴ … 10; ℓ from 1 to side/4.
    pub fn gaussian(side: usize, correlation: f64, alpha: f64, even: impl FnMut() -> f64) -> Result<Self, Invalid> {
        let (side, alpha) = (refusal::side(side)?, steepness(alpha)?);
        let heights = field(side, length(side, "correlation", correlation)?, even).iter().map(|pair| pair.re).collect();
        scaled(side, heights, alpha)
    }

    /// A field g/√E with the slopes of GGX: Student's t of two degrees of freedom, which is a normal one whose variance
    /// is divided by an exponential E (W. S. Gosset, *Biometrika* 6 (1908) 1). E is made of a Gaussian field of
    /// correlation `slower` [cells], by rank, so that its own distribution is exact; g as in [`Self::gaussian`], with the
    /// slopes' α before the division.
    ///
    /// Its histogram of slopes is GGX's, but not its shadows: where E is small the relief is rough and high at once, and
    /// Smith's masking takes slopes and heights to be independent. `even` is drawn from 4 side² times; `correlation` ≤
    /// `slower` ≤ side/4.
    pub fn ggx(
        side: usize,
        [correlation, slower]: [f64; 2],
        alpha: f64,
        mut even: impl FnMut() -> f64,
    ) -> Result<Self, Invalid> {
        let smooth = Self::gaussian(side, correlation, alpha, &mut even)?;
        only_if(slower >= correlation, "slower", slower, "at least the correlation")?;
        let mixture = field(side, length(side, "slower", slower)?, even);
        let exponential = exponential(mixture.iter().map(|pair| pair.norm_sqr()).collect());
        Self::new(side, smooth.heights.iter().zip(exponential).map(|(height, e)| height / e.sqrt()).collect())
    }
}

fn steepness(alpha: f64) -> Result<f64, Invalid> {
    only_if((1e-4..=10.0).contains(&alpha), "alpha", alpha, "1e-4 to 10")
}

fn length(side: usize, place: &'static str, length: f64) -> Result<f64, Invalid> {
    let holds = (1.0..=side as f64 / 4.0).contains(&length);
    only_if(holds, place, length, "from 1 cell to a quarter of the side")
}

/// `heights`, by a factor, with the mean square slope α².
fn scaled(side: usize, heights: Vec<f64>, alpha: f64) -> Result<Relief, Invalid> {
    let rough = Relief::new(side, heights)?;
    let factor = alpha / rough.mean_square_slope().sqrt();
    Relief::new(side, rough.heights.iter().map(|height| height * factor).collect())
}

/// Two independent Gaussian fields of the correlation e^(−r²/ℓ²), as real and imaginary parts: white noise of the
/// harmonics times the root of the spectrum e^(−k²ℓ²/4) (Wiener 1930, Khinchin 1934).
fn field(side: usize, correlation: f64, mut even: impl FnMut() -> f64) -> Vec<Complex64> {
    // The square of half a harmonic's phase over the length ℓ; harmonics beyond the middle count downwards.
    let squared = |at: usize| (0.5 * TAU * at.min(side - at) as f64 * correlation / side as f64).powi(2);
    let harmonic = |at: usize| {
        let [column, row] = [at % side, at / side];
        let noise = normal_pair(&mut even);
        // A mean height would change nothing.
        if at == 0 { Complex64::ZERO } else { noise * (-0.5 * (squared(column) + squared(row))).exp() }
    };
    let mut field: Vec<Complex64> = (0..side * side).map(harmonic).collect();
    let transform = FftPlanner::new().plan_fft_inverse(side);
    for _ in 0..2 {
        transform.process(&mut field);
        transpose(side, &mut field);
    }
    field
}

/// Two independent normal numbers (G. E. P. Box & M. E. Muller, *Ann. Math. Statist.* 29 (1958) 610).
pub fn normal_pair(even: &mut impl FnMut() -> f64) -> Complex64 {
    // 1 − u is never 0.
    let radius = (-2.0 * (1.0 - even()).ln()).sqrt();
    Complex64::from_polar(radius, TAU * even())
}

fn transpose(side: usize, square: &mut [Complex64]) {
    for row in 0..side {
        for column in 0..row {
            square.swap(row * side + column, column * side + row);
        }
    }
}

/// As many numbers in the same order, with the exponential distribution of mean 1 to one part in their count.
fn exponential(values: Vec<f64>) -> Vec<f64> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|&one, &other| values[one].total_cmp(&values[other]));
    let mut numbers = vec![0.0; values.len()];
    for (rank, at) in order.into_iter().enumerate() {
        numbers[at] = -(-(rank as f64 + 0.5) / values.len() as f64).ln_1p();
    }
    numbers
}
