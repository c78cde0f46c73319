//! From spectra to three numbers: how an eye and a screen see a wavelength, and what a channel of a picture means.
//!
//! | idea | where |
//! |---|---|
//! | the standard observer, and its X, Y, Z | [`matching`], [`tristimulus`] |
//! | X, Y, Z as a screen's red, green and blue | [`linear_srgb`] |
//! | which wavelengths a channel sees, and how they are drawn | [`response`] |
//! | light of what glows | [`blackbody`] |
//!
//! The tables are the CIE's, every 5 nm; between them values lie on straight lines.

pub mod response;
mod tables;
#[cfg(test)]
mod tests;

use crate::waves::constants::C;
use tables::{D65, MATCHING};

/// The first wavelength of the tables [m], and the step from one to the next [m].
const SHORTEST: f64 = 360e-9;
const STEP: f64 = 5e-9;

/// Chromaticities x, y [1] of the primaries of sRGB, red, green and blue (IEC 61966-2-1, ITU-R BT.709).
pub const PRIMARIES: [[f64; 2]; 3] = [[0.64, 0.33], [0.30, 0.60], [0.15, 0.06]];
/// Chromaticity x, y [1] of its white, D65.
pub const WHITE: [f64; 2] = [0.3127, 0.3290];

/// Luminous efficacy [lm W⁻¹] of 540 THz, exact since 1979.
pub const EFFICACY: f64 = 683.0;

/// h [J s] and k [J K⁻¹], exact since 2019.
const PLANCK: f64 = 6.626_070_15e-34;
const BOLTZMANN: f64 = 1.380_649e-23;

/// A table's value between its rows; None outside.
fn between<const K: usize>(rows: usize, wavelength: f64, row: impl Fn(usize) -> [f64; K]) -> Option<[f64; K]> {
    let at = (wavelength - SHORTEST) / STEP;
    if !(at >= 0.0 && at <= (rows - 1) as f64) {
        return None;
    }
    let first = (at as usize).min(rows - 2);
    let part = at - first as f64;
    let (a, b) = (row(first), row(first + 1));
    Some(std::array::from_fn(|k| a[k] + (b[k] - a[k]) * part))
}

/// The colour matching functions x̄, ȳ, z̄ [1] of the 2° observer of 1931 at a wavelength [m]; 0 outside 360 … 830 nm.
pub fn matching(wavelength: f64) -> [f64; 3] {
    between(MATCHING.len(), wavelength, |k| MATCHING[k]).unwrap_or_default()
}

/// Relative power of daylight D65 [1, 100 at 560 nm] at a wavelength [m] of 360 … 780 nm; 0 outside.
pub fn daylight(wavelength: f64) -> f64 {
    between(D65.len(), wavelength, |k| [D65[k]]).unwrap_or_default()[0]
}

/// X, Y, Z of a spectrum, each ∫x̄ L dλ [the spectrum's unit times m], as the CIE sums them, every 5 nm (CIE 15:2004, §7.1): of
/// spectra that are smooth over such a step. [`EFFICACY`] Y of a spectral radiance is the luminance [cd m⁻²].
pub fn tristimulus(spectrum: impl Fn(f64) -> f64) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for (k, row) in MATCHING.iter().enumerate() {
        let power = spectrum(SHORTEST + STEP * k as f64);
        sum = std::array::from_fn(|c| sum[c] + row[c] * power * STEP);
    }
    sum
}

/// Chromaticity x, y [1] of X, Y, Z.
pub fn chromaticity([x, y, z]: [f64; 3]) -> [f64; 2] {
    let sum = x + y + z;
    [x / sum, y / sum]
}

/// The rows of X, Y, Z → red, green, blue of sRGB without its curve, from the primaries and the white: white of Y = 1 is
/// (1, 1, 1). Rounded to four digits it is the matrix that IEC 61966-2-1 prints.
pub fn srgb() -> [[f64; 3]; 3] {
    let xyz = |[x, y]: [f64; 2]| [x / y, 1.0, (1.0 - x - y) / y];
    let [red, green, blue] = PRIMARIES.map(xyz);
    // Rows of the inverse of the matrix of columns: cross products over the determinant.
    let inverse = [(green, blue), (blue, red), (red, green)].map(|(a, b)| cross(a, b));
    let white = xyz(WHITE);
    inverse.map(|row| {
        let share = dot(row, white);
        row.map(|x| x / share)
    })
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    crate::scene::triple::cross(a, b)
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    crate::scene::triple::dot(a, b)
}

/// Red, green and blue of sRGB without its curve, of X, Y, Z; below 0 where a colour lies outside.
pub fn linear_srgb(xyz: [f64; 3]) -> [f64; 3] {
    srgb().map(|row| dot(row, xyz))
}

/// Spectral radiance [W m⁻³ sr⁻¹] of a black body of a temperature [K] > 0 at a wavelength [m] > 0: Planck's law.
pub fn blackbody(wavelength: f64, temperature: f64) -> f64 {
    let exponent = PLANCK * C / (wavelength * BOLTZMANN * temperature);
    2.0 * PLANCK * C * C / wavelength.powi(5) / exponent.exp_m1()
}
