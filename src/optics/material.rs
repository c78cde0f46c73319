//! Media and their refractive indices.

use num_complex::Complex64;
use std::fmt;

/// A medium whose index was measured, with its source.
#[derive(Debug)]
pub struct Material {
    /// Command-line word (`fused-silica`).
    pub name: &'static str,
}

/// Every material, by name.
pub const MATERIALS: &[Material] = &[];

/// The material called `name` (case, `_` and `-` do not matter).
pub fn named(name: &str) -> Option<&'static Material> {
    MATERIALS.iter().find(|material| material.name == name)
}

/// A wavelength outside the range in which a material was measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutOfRange {
    /// The material.
    pub material: &'static str,
    /// Vacuum wavelength asked for [m].
    pub wavelength: f64,
    /// Shortest and longest wavelength of its data [m].
    pub range: (f64, f64),
}

impl fmt::Display for OutOfRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} at {} nm", self.material, self.wavelength * 1e9)
    }
}

/// What fills a half-space or a layer.
#[derive(Clone, Copy, Debug)]
pub enum Medium {
    /// The same index n + iκ at every wavelength.
    Constant(Complex64),
    /// A measured one.
    Material(&'static Material),
}

impl PartialEq for Medium {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Constant(a), Self::Constant(b)) => a == b,
            (Self::Material(a), Self::Material(b)) => a.name == b.name,
            _ => false,
        }
    }
}

impl Medium {
    /// The index n + iκ [1] at a vacuum wavelength [m].
    pub fn index(&self, _wavelength: f64) -> Result<Complex64, OutOfRange> {
        match self {
            Self::Constant(index) => Ok(*index),
            Self::Material(_) => unreachable!(),
        }
    }
}
