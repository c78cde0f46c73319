//! Media and their refractive indices, from published measurements.
//!
//! An index is n + iκ for fields e^(−iωt): κ ≥ 0 absorbs, and κ = 0 exactly in the media listed as clear. Wavelengths
//! are those in vacuum.
//!
//! Every index is returned as its source printed it, and spectrometers stand in air: the glasses, fused silica, sapphire
//! and magnesium fluoride are relative to air, as [`Material::conditions`] says. Against vacuum they are 2.7e-4 of
//! themselves higher. Their sources count wavelengths in air too, which are 0.11 nm to 0.21 nm shorter in the visible;
//! taking them for those in vacuum moves n by at most 2e-5 in BK7 and 1e-4 in SF11 (at 380 nm).

mod data;
mod dispersion;
mod tables;
#[cfg(test)]
mod tests;

pub use data::MATERIALS;
pub use dispersion::{Dispersion, Oscillator, Row};

use num_complex::Complex64;
use std::fmt;

/// A medium whose index was measured, with its source.
#[derive(Debug)]
pub struct Material {
    /// Command-line word (`fused-silica`).
    pub name: &'static str,
    /// Other words for it (`SiO2`).
    pub aliases: &'static [&'static str],
    /// What it is, in a few words.
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

impl Material {
    /// The index n + iκ [1] at a vacuum wavelength [m]; n > 0, κ ≥ 0. The ends of the range belong to it.
    pub fn index(&self, wavelength: f64) -> Result<Complex64, OutOfRange> {
        let (shortest, longest) = self.range;
        // 2500.0 * 1e-9 is not 2500e-9: an end reached by another rounding is still the end.
        const SLACK: f64 = 4.0 * f64::EPSILON;
        if wavelength >= shortest * (1.0 - SLACK) && wavelength <= longest * (1.0 + SLACK) {
            Ok(self.dispersion.index(wavelength.clamp(shortest, longest)))
        } else {
            Err(OutOfRange { material: self.name, source: self.source, wavelength, range: self.range })
        }
    }
}

impl PartialEq for Material {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

/// The material called `name`, by its name or an alias; case, `_`, `-` and spaces do not matter.
pub fn named(name: &str) -> Option<&'static Material> {
    MATERIALS.iter().find(|material| std::iter::once(&material.name).chain(material.aliases).any(|own| same(own, name)))
}

/// Whether two words are the same name; case, `_`, `-` and spaces do not matter.
pub(crate) fn same(a: &str, b: &str) -> bool {
    letters(a).eq(letters(b))
}

fn letters(name: &str) -> impl Iterator<Item = char> {
    name.chars().filter(|c| !matches!(c, '_' | '-' | ' ')).map(|c| c.to_ascii_lowercase())
}

/// A wavelength outside the range in which a material was measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutOfRange {
    /// The material.
    pub material: &'static str,
    /// Where its data come from.
    pub source: &'static str,
    /// Vacuum wavelength asked for [m].
    pub wavelength: f64,
    /// Shortest and longest wavelength of its data [m].
    pub range: (f64, f64),
}

impl fmt::Display for OutOfRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [asked, shortest, longest] = [self.wavelength, self.range.0, self.range.1].map(Nanometres);
        write!(f, "{} at {asked}: its data ({}) run from {shortest} to {longest}", self.material, self.source)
    }
}

impl std::error::Error for OutOfRange {}

/// A length [m], written in nanometres to nine significant digits, so that no rounding of the unit shows.
struct Nanometres(f64);

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

/// What fills a half-space or a layer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Medium {
    /// The same index n + iκ at every wavelength.
    Constant(Complex64),
    /// A measured one.
    Material(&'static Material),
}

impl Medium {
    /// The index n + iκ [1] at a vacuum wavelength [m].
    pub fn index(&self, wavelength: f64) -> Result<Complex64, OutOfRange> {
        match self {
            Self::Constant(index) => Ok(*index),
            Self::Material(material) => material.index(wavelength),
        }
    }
}
