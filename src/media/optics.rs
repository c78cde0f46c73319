//! What light knows of a medium: refractive indices from published measurements.
//!
//! An index is n + iκ for fields e^(−iωt): κ ≥ 0 absorbs, and κ = 0 exactly in the media listed as clear. Wavelengths
//! are those in vacuum.
//!
//! Every index is returned as its source printed it, and spectrometers stand in air: the glasses, fused silica, sapphire
//! and magnesium fluoride are relative to air, as [`Optics::conditions`] says. Against vacuum they are 2.7e-4 of
//! themselves higher. Their sources count wavelengths in air too, which are 0.11 nm to 0.21 nm shorter in the visible;
//! taking them for those in vacuum moves n by at most 2e-5 in BK7 and 1e-4 in SF11 (at 380 nm).

use super::dispersion::Dispersion;
use num_complex::Complex64;
use std::fmt;

/// A measured refractive index, with its source.
#[derive(Clone, Copy, Debug)]
pub struct Optics {
    /// What was measured, in a few words.
    pub says: &'static str,
    /// Where the numbers come from: author, year, journal, and which table or equation.
    pub source: &'static str,
    /// What they hold for: temperature, pressure, the medium they are relative to. Empty if nothing is to be said.
    pub conditions: &'static str,
    /// Shortest and longest vacuum wavelength of the data [m].
    pub range: (f64, f64),
    /// The law that carries the numbers.
    pub dispersion: Dispersion,
}

impl Optics {
    /// The index n + iκ [1] at a vacuum wavelength [m] in the range, whose ends belong to it.
    pub fn index(&self, wavelength: f64) -> Option<Complex64> {
        let (shortest, longest) = self.range;
        // 2500.0 * 1e-9 is not 2500e-9: an end reached by another rounding is still the end.
        const SLACK: f64 = 4.0 * f64::EPSILON;
        let inside = wavelength >= shortest * (1.0 - SLACK) && wavelength <= longest * (1.0 + SLACK);
        inside.then(|| self.dispersion.index(wavelength.clamp(shortest, longest)))
    }
}

/// A wavelength at which the index of a medium was not measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutOfRange {
    /// The medium.
    pub substance: &'static str,
    /// Vacuum wavelength asked for [m].
    pub wavelength: f64,
    /// Where its index comes from, and the shortest and longest wavelength of the data [m]; `None` if there are none.
    pub data: Option<(&'static str, (f64, f64))>,
    /// Where its ε, μ, σ hold [Hz].
    pub band: Option<(f64, f64)>,
}

impl fmt::Display for OutOfRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} at {}: ", self.substance, Nanometres(self.wavelength))?;
        match (self.data, self.band) {
            (Some((source, (shortest, longest))), _) => {
                write!(f, "its data ({source}) run from {} to {}", Nanometres(shortest), Nanometres(longest))
            }
            (None, Some((lowest, highest))) => {
                write!(
                    f,
                    "its refractive index is not known here, only its ε, μ, σ from {lowest:e} Hz to {highest:e} Hz"
                )
            }
            (None, None) => write!(f, "its refractive index is not known here"),
        }
    }
}

impl std::error::Error for OutOfRange {}

/// A length [m], written in nanometres to nine significant digits, so that no rounding of the unit shows.
pub(super) struct Nanometres(pub f64);

impl fmt::Display for Nanometres {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let nanometres = self.0 * 1e9;
        let short: f64 = format!("{nanometres:.8e}").parse().unwrap_or(nanometres);
        if short == 0.0 || (1e-3..1e9).contains(&short.abs()) {
            write!(f, "{short} nm")
        } else {
            write!(f, "{short:e} nm")
        }
    }
}
