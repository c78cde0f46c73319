//! What circuits and radio waves know of a medium: constant ε_r, μ_r and loss with their source and the band in which
//! they may be taken as constant.

use crate::waves;
use crate::waves::constants::EPSILON_0;
use std::f64::consts::TAU;
use std::fmt;

/// How a medium turns energy to heat.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Loss {
    /// σ [S m⁻¹], the same at every frequency of the band.
    Conductivity(f64),
    /// tan δ = σ/(ωε) [1], the same at every frequency of the band: dielectric loss, spread over many relaxations.
    Tangent(f64),
}

/// ε, μ and σ, with their source.
#[derive(Clone, Copy, Debug)]
pub struct Electric {
    /// What was measured, with what was left out.
    pub says: &'static str,
    /// Where the numbers come from.
    pub source: &'static str,
    /// ε_r [1].
    pub epsilon_r: f64,
    /// μ_r [1].
    pub mu_r: f64,
    /// What it loses.
    pub loss: Loss,
    /// Lowest and highest frequency [Hz] at which these parameters hold.
    pub band: (f64, f64),
}

impl Electric {
    /// ε, μ, σ at a `frequency` [Hz] within the band.
    pub fn medium(&self, frequency: f64) -> Option<waves::Medium> {
        let (lowest, highest) = self.band;
        if !(frequency > 0.0 && frequency.is_finite() && (lowest..=highest).contains(&frequency)) {
            return None;
        }
        let sigma = match self.loss {
            Loss::Conductivity(sigma) => sigma,
            Loss::Tangent(tangent) => tangent * TAU * frequency * self.epsilon_r * EPSILON_0,
        };
        waves::Medium::relative(self.epsilon_r, self.mu_r, sigma).ok()
    }
}

/// A frequency at which a medium's parameters are not known to hold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutOfBand {
    /// The medium.
    pub substance: &'static str,
    /// Frequency asked for [Hz].
    pub frequency: f64,
    /// Where its ε, μ, σ come from and where they hold [Hz]; `None` if there are none.
    pub known: Option<(&'static str, (f64, f64))>,
    /// Where its refractive index is known [Hz].
    pub light: Option<(f64, f64)>,
}

impl fmt::Display for OutOfBand {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} at {:e} Hz: its ε, μ, σ ", self.substance, self.frequency)?;
        match self.known {
            Some((source, (lowest, highest))) => write!(f, "({source}) hold from {lowest:e} Hz to {highest:e} Hz")?,
            None => write!(f, "are not known here")?,
        }
        self.light.map_or(Ok(()), |(lowest, highest)| {
            write!(f, ", its refractive index from {lowest:.3e} Hz to {highest:.3e} Hz")
        })
    }
}

impl std::error::Error for OutOfBand {}
