//! A pulse as a sum of harmonics (E13), on a period long enough to hold it: through its spectrum it travels as
//! d'Alembert says (E10, E12), and through a lossy medium each harmonic by its own k (E18).

use super::phase::{cis, cycles};
use super::plane::Invalid;
use num_complex::Complex64;
use rustfft::FftPlanner;
use std::f64::consts::{PI, TAU};

/// The most samples or harmonics taken: 256 MiB of coefficients.
pub const MOST: usize = 1 << 24;

/// By how much the partial sums of a Fourier series overshoot, as a share of the jump, however many terms they have:
/// Si(π)/π − ½ (Wilbraham 1848; Gibbs 1899; DLMF §6.16(i)).
pub const GIBBS_OVERSHOOT: f64 = 0.089_489_872_236_083_64;

/// A real signal of one period: f(x) = c₀ + 2 Re Σ c_m e^(2πimx/period), m = 1 … M. Its argument may be a place [m] or
/// a time [s].
#[derive(Clone, Debug, PartialEq)]
pub struct Spectrum {
    period: f64,
    /// c₀ … c_M.
    coefficients: Vec<Complex64>,
}

impl Spectrum {
    /// Of `samples` at x = j · period/n, j = 0 … n − 1: the one trigonometric polynomial of least degree through them.
    /// Takes 1 to [`MOST`] finite samples.
    pub fn of_samples(samples: &[f64], period: f64) -> Result<Self, Invalid> {
        let period = Invalid::unless_positive("period", period)?;
        let n = count("samples", samples.len())?;
        if let Some(bad) = samples.iter().find(|sample| !sample.is_finite()) {
            return Err(Invalid { place: "samples", value: *bad, valid: "finite" });
        }
        let mut buffer: Vec<Complex64> = samples.iter().map(|sample| Complex64::from(*sample)).collect();
        FftPlanner::new().plan_fft_forward(n).process(&mut buffer);
        buffer.truncate(n / 2 + 1);
        for coefficient in &mut buffer {
            *coefficient /= n as f64;
        }
        if n.is_multiple_of(2) {
            // The harmonic of two samples a period is its own mirror image.
            buffer[n / 2] *= 0.5;
        }
        Ok(Self { period, coefficients: buffer })
    }

    /// Of `n` samples of `signal` over 0 ≤ x < period.
    pub fn of(signal: impl Fn(f64) -> f64, period: f64, n: usize) -> Result<Self, Invalid> {
        let samples: Vec<f64> = (0..count("samples", n)?).map(|j| signal(period * (j as f64 / n as f64))).collect();
        Self::of_samples(&samples, period)
    }

    /// The first `harmonics` terms of the Fourier series of a square pulse, 1 for |x| < width/2: the coefficients
    /// sin(πm·width/period)/(πm) fall as 1/m. 0 < width < period.
    pub fn of_square(width: f64, period: f64, harmonics: usize) -> Result<Self, Invalid> {
        let share = share("width", width, period)?;
        Self::of_series(period, harmonics, |m| if m == 0.0 { share } else { cis(cycles(0.5 * m, share)).im / (PI * m) })
    }

    /// The same of a Gaussian e^(−x²/2w²) and its periodic images: the coefficients fall as e^(−m²).
    /// 0 < w < period.
    pub fn of_gaussian(width: f64, period: f64, harmonics: usize) -> Result<Self, Invalid> {
        let share = share("width", width, period)?;
        Self::of_series(period, harmonics, |m| share * TAU.sqrt() * (-0.5 * (TAU * m * share).powi(2)).exp())
    }

    fn of_series(period: f64, harmonics: usize, real: impl Fn(f64) -> f64) -> Result<Self, Invalid> {
        if harmonics > MOST {
            count("harmonics", harmonics)?;
        }
        Ok(Self { period, coefficients: (0..=harmonics).map(|m| Complex64::from(real(m as f64))).collect() })
    }

    /// Its period.
    pub fn period(&self) -> f64 {
        self.period
    }

    /// c₀ … c_M.
    pub fn coefficients(&self) -> &[Complex64] {
        &self.coefficients
    }

    /// The signal `by` further on, f(x − by): d'Alembert's one-way solution at the time by/v.
    pub fn shifted(&self, by: f64) -> Self {
        let periods = by / self.period;
        self.turned(|m| cis(-cycles(m, periods)))
    }

    fn turned(&self, factor: impl Fn(f64) -> Complex64) -> Self {
        let turned = self.coefficients.iter().enumerate().map(|(m, c)| c * factor(m as f64));
        Self { period: self.period, coefficients: turned.collect() }
    }

    /// f(x), term by term.
    pub fn at(&self, x: f64) -> f64 {
        let periods = x / self.period;
        let term = |(m, c): (usize, &Complex64)| (c * cis(cycles(m as f64, periods))).re;
        let constant = self.coefficients[0].re;
        constant + 2.0 * self.coefficients.iter().enumerate().skip(1).map(term).sum::<f64>()
    }

    /// f at x = j · period/n, j = 0 … n − 1, for n from 1 to [`MOST`]. Harmonics above n/2 fold back, as they do on
    /// such a grid.
    pub fn samples(&self, n: usize) -> Result<Vec<f64>, Invalid> {
        let n = count("samples", n)?;
        let mut buffer = vec![Complex64::ZERO; n];
        buffer[0] = Complex64::from(self.coefficients[0].re);
        for (m, c) in self.coefficients.iter().enumerate().skip(1) {
            buffer[m % n] += c;
            buffer[(n - m % n) % n] += c.conj();
        }
        FftPlanner::new().plan_fft_inverse(n).process(&mut buffer);
        Ok(buffer.into_iter().map(|sample| sample.re).collect())
    }

    /// The mean of f² over a period, c₀² + 2Σ|c_m|² (Parseval). It is the mean square of n samples too, if n is odd or
    /// they hold nothing at two samples a period.
    pub fn mean_square(&self) -> f64 {
        let rest: f64 = self.coefficients.iter().skip(1).rev().map(Complex64::norm_sqr).sum();
        self.coefficients[0].re.powi(2) + 2.0 * rest
    }

    /// Root of the mean square of the harmonics above `harmonics`: by Parseval the error of the truncated spectrum.
    pub fn tail(&self, harmonics: usize) -> f64 {
        let rest: f64 = self.coefficients.iter().skip(harmonics.saturating_add(1)).rev().map(Complex64::norm_sqr).sum();
        (2.0 * rest).sqrt()
    }
}

fn count(place: &'static str, n: usize) -> Result<usize, Invalid> {
    if (1..=MOST).contains(&n) { Ok(n) } else { Err(Invalid { place, value: n as f64, valid: "1 to 16777216" }) }
}

fn share(place: &'static str, width: f64, period: f64) -> Result<f64, Invalid> {
    let share = width / Invalid::unless_positive("period", period)?;
    if share > 0.0 && share < 1.0 {
        Ok(share)
    } else {
        Err(Invalid { place, value: width, valid: "between 0 and the period" })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use yardstick::quadrature::gauss_legendre;

    fn gaussian(x: f64) -> f64 {
        // Three images: the next one is below rounding.
        (-1..=1).map(|image| (-0.5 * ((x - 0.5 - f64::from(image)) / 0.05).powi(2)).exp()).sum()
    }

    proptest! {
        #[test]
        fn a_smooth_pulse_travels_as_dalembert_says(by in -9.0..9.0_f64, x in 0.0..1.0) {
            let moved = Spectrum::of(gaussian, 1.0, 64).unwrap().shifted(by);
            prop_assert!((moved.at(x) - gaussian((x - by).rem_euclid(1.0))).abs() < 1e-13);
        }

        #[test]
        fn any_samples_come_back_and_keep_their_energy(samples in proptest::collection::vec(-1.0..1.0, 1..200)) {
            let spectrum = Spectrum::of_samples(&samples, 2.0).unwrap();
            for (sample, back) in samples.iter().zip(spectrum.samples(samples.len()).unwrap()) {
                prop_assert!((sample - back).abs() < 1e-14);
            }
            if samples.len() % 2 == 1 {
                let mean_square = samples.iter().map(|x| x * x).sum::<f64>() / samples.len() as f64;
                prop_assert!((spectrum.mean_square() / mean_square - 1.0).abs() < 16.0 * f64::EPSILON);
            }
        }

        #[test]
        fn both_evaluations_agree(samples in proptest::collection::vec(-1.0..1.0, 1..40), n in 1..60_usize) {
            let spectrum = Spectrum::of_samples(&samples, 3.0).unwrap();
            for (j, sample) in spectrum.samples(n).unwrap().into_iter().enumerate() {
                prop_assert!((sample - spectrum.at(3.0 * j as f64 / n as f64)).abs() < 1e-13);
            }
        }
    }

    #[test]
    fn partial_sums_overshoot_by_gibbs_share() {
        let integral: f64 = gauss_legendre(24).iter().map(|(u, weight)| weight * PI * (PI * u).sin() / (PI * u)).sum();
        assert!((integral / PI - 0.5 - GIBBS_OVERSHOOT).abs() < 1e-15);
        for harmonics in [63, 255, 1023] {
            let series = Spectrum::of_square(0.5, 1.0, harmonics).unwrap();
            // The peak stands half a period of the last harmonic plus one inside the edge.
            let peak = series.at(0.25 - 0.5 / (harmonics as f64 + 1.0)) - 1.0;
            assert!((peak - GIBBS_OVERSHOOT).abs() < 1.0 / (harmonics * harmonics) as f64, "{harmonics} {peak}");
        }
    }

    #[test]
    fn truncation_errs_algebraically_on_a_square_and_spectrally_on_a_gaussian() {
        let square = Spectrum::of_square(0.3, 1.0, 1 << 18).unwrap();
        let points: Vec<_> = (4..12).map(|k| (f64::from(1 << k), square.tail(1 << k))).collect();
        assert!((yardstick::order::slope(&points).unwrap() + 0.5).abs() < 0.02);
        let smooth = Spectrum::of_gaussian(0.05, 1.0, 64).unwrap();
        assert!(smooth.tail(4) > 1e-2 && smooth.tail(12) < 1e-3 && smooth.tail(24) < 1e-12);
        let sampled = Spectrum::of(|x| gaussian(x + 0.5), 1.0, 128).unwrap();
        assert!((0..64).all(|m| (sampled.coefficients()[m] - smooth.coefficients()[m]).norm() < 1e-15));
    }

    #[test]
    fn bad_input_is_named() {
        assert_eq!(Spectrum::of_samples(&[], 1.0).unwrap_err().place, "samples");
        assert_eq!(Spectrum::of_samples(&[1.0, f64::NAN], 1.0).unwrap_err().place, "samples");
        assert_eq!(Spectrum::of_samples(&[1.0], f64::NAN).unwrap_err().place, "period");
        assert_eq!(Spectrum::of_square(2.0, 1.0, 4).unwrap_err().place, "width");
        assert_eq!(Spectrum::of_gaussian(0.1, 1.0, usize::MAX).unwrap_err().place, "harmonics");
    }
}
