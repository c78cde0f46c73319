//! Media by name: one list, of which a refractive index and (ε, μ, σ) are views.
//!
//! | what is known | where | view |
//! |---|---|---|
//! | n + iκ, of light | [`Optics`] | [`Substance::index`] at a wavelength |
//! | ε, μ, σ, from circuits to microwaves | [`Electric`] | [`Substance::medium`] at a frequency |
//! | either | both | [`Substance::wave`] of a frequency |
//!
//! Of some media only one of the two is known here, and none is known everywhere: what is not is refused with its name
//! and what is, never extrapolated.

mod dispersion;
mod electric;
mod list;
mod optics;
mod tables;
#[cfg(test)]
mod tests;

pub use dispersion::{Dispersion, Oscillator, Row, cauchy};
pub use electric::{Electric, Loss, OutOfBand};
pub use list::SUBSTANCES;
pub use optics::{Optics, OutOfRange};

use crate::waves;
use crate::waves::Wave;
use crate::waves::constants::C;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Vacuum wavelengths [m] that stand for red, green and blue: the primaries of ITU-R BT.2020.
pub const CHANNELS: [f64; 3] = [630e-9, 532e-9, 467e-9];

/// A medium by name, and what is known of it: at least one of the two.
#[derive(Debug)]
pub struct Substance {
    /// Command-line word (`fused-silica`).
    pub name: &'static str,
    /// Other words for it (`SiO2`).
    pub aliases: &'static [&'static str],
    /// As light meets it.
    pub optics: Option<Optics>,
    /// As circuits and radio waves meet it.
    pub electric: Option<Electric>,
}

impl PartialEq for Substance {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl Substance {
    /// The indices n + iκ [1] at [`CHANNELS`].
    ///
    /// # Errors
    /// If it is not known there.
    pub fn colour(&self) -> Result<[Complex64; 3], OutOfRange> {
        let [red, green, blue] = CHANNELS.map(|wavelength| self.index(wavelength));
        Ok([red?, green?, blue?])
    }

    /// The index n + iκ [1] at a vacuum wavelength [m]; n > 0, κ ≥ 0. The ends of the range belong to it.
    ///
    /// # Errors
    /// Outside the range of the data, or if there are none.
    pub fn index(&self, wavelength: f64) -> Result<Complex64, OutOfRange> {
        self.optics.as_ref().and_then(|optics| optics.index(wavelength)).ok_or(OutOfRange {
            substance: self.name,
            wavelength,
            data: self.optics.as_ref().map(|optics| (optics.source, optics.range)),
            band: self.electric.as_ref().map(|electric| electric.band),
        })
    }

    /// ε, μ, σ at a `frequency` [Hz] within the band.
    ///
    /// # Errors
    /// Outside the band, or if there is none.
    pub fn medium(&self, frequency: f64) -> Result<waves::Medium, OutOfBand> {
        self.electric
            .as_ref()
            .and_then(|electric| electric.medium(frequency))
            .ok_or_else(|| self.out_of_band(frequency))
    }

    /// The wave of a `frequency` [Hz] in it: by ε, μ and σ within the band, by its refractive index where that was
    /// measured.
    ///
    /// # Errors
    /// Elsewhere.
    pub fn wave(&self, frequency: f64) -> Result<Wave, OutOfBand> {
        let wave = match self.medium(frequency) {
            Ok(medium) => Wave::new(&medium, TAU * frequency),
            Err(outside) => {
                let index = self.index(C / frequency).map_err(|_| outside)?;
                Wave::with_index(index, TAU * frequency)
            }
        };
        wave.map_err(|_| self.out_of_band(frequency))
    }

    fn out_of_band(&self, frequency: f64) -> OutOfBand {
        let known = self.electric.as_ref().map(|electric| (electric.source, electric.band));
        // Where ε, μ, σ hold at all frequencies, light has nothing to add.
        let everywhere = known.is_some_and(|(_, (_, highest))| highest == f64::INFINITY);
        let light = self.optics.as_ref().filter(|_| !everywhere).map(|optics| (C / optics.range.1, C / optics.range.0));
        OutOfBand { substance: self.name, frequency, known, light }
    }
}

/// The medium called `name`, by its name or an alias; case, `_`, `-` and spaces do not matter.
pub fn named(name: &str) -> Option<&'static Substance> {
    SUBSTANCES.iter().find(|known| std::iter::once(&known.name).chain(known.aliases).any(|own| same(own, name)))
}

/// The media of which a refractive index is known.
pub fn optical() -> impl Iterator<Item = &'static Substance> {
    SUBSTANCES.iter().filter(|known| known.optics.is_some())
}

/// The media of which ε, μ, σ are known.
pub fn electric() -> impl Iterator<Item = &'static Substance> {
    SUBSTANCES.iter().filter(|known| known.electric.is_some())
}

/// Whether two words are the same name; case, `_`, `-` and spaces do not matter.
fn same(a: &str, b: &str) -> bool {
    letters(a).eq(letters(b))
}

fn letters(name: &str) -> impl Iterator<Item = char> {
    name.chars().filter(|c| !matches!(c, '_' | '-' | ' ')).map(|c| c.to_ascii_lowercase())
}

/// What fills a half-space or a layer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Medium {
    /// The same index n + iκ at every wavelength.
    Constant(Complex64),
    /// One by name.
    Named(&'static Substance),
}

impl Medium {
    /// The index n + iκ [1] at a vacuum wavelength [m].
    ///
    /// # Errors
    /// Where that of a named medium is not known.
    pub fn index(&self, wavelength: f64) -> Result<Complex64, OutOfRange> {
        match self {
            Self::Constant(index) => Ok(*index),
            Self::Named(known) => known.index(wavelength),
        }
    }
}
