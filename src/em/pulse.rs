//! What a source does in time.

use super::refusal::{Refusal, demand};
use std::f64::consts::TAU;
use std::fmt;
use std::sync::Arc;

/// A real signal of time [s], dimensionless; sources scale it.
#[derive(Clone)]
pub enum Pulse {
    /// exp(−(t − delay)²/(2 width²)).
    Gaussian {
        /// Time of the peak [s].
        delay: f64,
        /// Standard deviation [s].
        width: f64,
    },
    /// A Gaussian times sin(2π frequency (t − delay)): no mean, so it leaves no static field behind.
    Modulated {
        /// Carrier [Hz].
        frequency: f64,
        /// Time of the peak of the envelope [s].
        delay: f64,
        /// Standard deviation of the envelope [s].
        width: f64,
    },
    /// Anything else.
    Custom(Arc<dyn Fn(f64) -> f64 + Send + Sync>),
}

impl Pulse {
    /// Any function of time [s].
    pub fn custom(signal: impl Fn(f64) -> f64 + Send + Sync + 'static) -> Self {
        Self::Custom(Arc::new(signal))
    }

    /// Refuses a pulse that is not a number anywhere. What a custom one answers is its own affair.
    pub(super) fn check(&self) -> Result<(), Refusal> {
        let envelope = |delay: f64, width: f64| {
            demand(delay.is_finite(), "delay of a pulse", delay, "finite")?;
            demand(width > 0.0 && width.is_finite(), "width of a pulse", width, "finite and above 0 s")
        };
        match *self {
            Self::Gaussian { delay, width } => envelope(delay, width),
            Self::Modulated { frequency, delay, width } => {
                demand(frequency.is_finite(), "frequency of a pulse", frequency, "finite")?;
                envelope(delay, width)
            }
            Self::Custom(_) => Ok(()),
        }
    }

    /// Its value [1] at time `t` [s].
    pub fn at(&self, t: f64) -> f64 {
        let envelope = |delay: f64, width: f64| (-0.5 * ((t - delay) / width).powi(2)).exp();
        match *self {
            Self::Gaussian { delay, width } => envelope(delay, width),
            Self::Modulated { frequency, delay, width } => {
                envelope(delay, width) * (TAU * frequency * (t - delay)).sin()
            }
            Self::Custom(ref signal) => signal(t),
        }
    }
}

impl fmt::Debug for Pulse {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Gaussian { delay, width } => write!(f, "Gaussian(delay {delay} s, width {width} s)"),
            Self::Modulated { frequency, delay, width } => {
                write!(f, "Modulated({frequency} Hz, delay {delay} s, width {width} s)")
            }
            Self::Custom(_) => f.write_str("Custom"),
        }
    }
}

/// Σ f(t) e^(iωt) Δt of samples at `start` + nΔt [s]: with fields as e^(−iωt), the amplitude at ω [rad/s].
/// `samples` are pairs of real and imaginary part.
pub fn amplitude(samples: &[num_complex::Complex64], start: f64, dt: f64, omega: f64) -> num_complex::Complex64 {
    let turn = |n: usize| num_complex::Complex64::cis(omega * (start + n as f64 * dt));
    samples.iter().enumerate().map(|(n, sample)| sample * turn(n)).sum::<num_complex::Complex64>() * dt
}
