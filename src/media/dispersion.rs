//! The laws by which an index depends on the wavelength.

use num_complex::Complex64;

/// Photon energy × vacuum wavelength, h c / e [eV µm], from the exact constants of the SI (2019).
pub(super) const EV_MICROMETRES: f64 = 6.626_070_15e-34 * 299_792_458.0 / 1.602_176_634e-19 * 1e6;

/// One row of a measured table: vacuum wavelength [µm], n [1], κ [1].
pub type Row = [f64; 3];

/// The lines of hydrogen and helium by which glass is told apart, F, d and C [µm] (Schott, *TIE-29: Refractive index and dispersion*).
const LINES: [f64; 3] = [0.486_132_7, 0.587_561_8, 0.656_272_5];

/// n [1] at a wavelength [m] of glass that is known by its index at the d line and by Abbe's number V = (n_d − 1)/(n_F − n_C)
/// [1] alone: Cauchy's n = A + B/λ² (A. L. Cauchy, *Mémoire sur la dispersion de la lumière* (1836), its first two terms; so
/// KHR_materials_dispersion has it).
pub fn cauchy(index: f64, abbe: f64, wavelength: f64) -> f64 {
    let inverse = |micrometres: f64| 1.0 / (micrometres * micrometres);
    let [f, d, c] = LINES.map(inverse);
    index + (index - 1.0) / abbe * (inverse(wavelength * 1e6) - d) / (f - c)
}

/// A law n(λ) + iκ(λ), in the form and the units in which its source prints it (µm and eV).
#[derive(Clone, Copy, Debug)]
pub enum Dispersion {
    /// n² = 1 + Σ B λ² / (λ² − C): resonances far from the range, each (B [1], C [µm²]), no absorption. W. Sellmeier,
    /// Ann. Phys. 219, 272 (1871). Without resonances it is the vacuum.
    Sellmeier(&'static [(f64, f64)]),
    /// n = 1 + Σ A / (B − λ⁻²), each (A, B) [µm⁻²]: the Sellmeier law of a gas, where n² − 1 = 2 (n − 1).
    Gas(&'static [(f64, f64)]),
    /// ε = 1 + Σ f ω_p² / (ω_0² − ω² − iΓω) and n + iκ = √ε; an oscillator without restoring force (ω_0 = 0) is Drude's
    /// free electrons. J. D. Jackson, Classical Electrodynamics (3rd ed.), eq. 7.51 and 7.56.
    LorentzDrude {
        /// Plasma energy ħω_p [eV].
        plasma: f64,
        /// The electrons, free and bound.
        oscillators: &'static [Oscillator],
    },
    /// Rows of rising wavelength, joined by the monotone cubic of M. Steffen, Astron. Astrophys. 239, 443 (1990): it goes
    /// through every row with a continuous slope and has no extremum that the rows have not, so κ stays ≥ 0. At the
    /// first and last row its slope is that of the chord.
    Table(&'static [Row]),
}

/// A damped oscillator of a [`Dispersion::LorentzDrude`] law.
#[derive(Clone, Copy, Debug)]
pub struct Oscillator {
    /// Oscillator strength f [1].
    pub strength: f64,
    /// Damping ħΓ [eV].
    pub damping: f64,
    /// Resonance ħω_0 [eV].
    pub resonance: f64,
}

impl Dispersion {
    /// The index n + iκ [1] at a vacuum wavelength [m] inside the range of the data.
    pub(super) fn index(&self, wavelength: f64) -> Complex64 {
        let micrometres = wavelength * 1e6;
        match self {
            Self::Sellmeier(resonances) => {
                let square = micrometres * micrometres;
                let susceptibility: f64 = resonances.iter().map(|(b, c)| b * square / (square - c)).sum();
                Complex64::from((1.0 + susceptibility).sqrt())
            }
            Self::Gas(resonances) => {
                let square = 1.0 / (micrometres * micrometres);
                Complex64::from(1.0 + resonances.iter().map(|(a, b)| a / (b - square)).sum::<f64>())
            }
            Self::LorentzDrude { plasma, oscillators } => {
                let energy = EV_MICROMETRES / micrometres;
                let permittivity = oscillators.iter().fold(Complex64::from(1.0), |sum, o| {
                    let response = Complex64::new(o.resonance * o.resonance - energy * energy, -o.damping * energy);
                    sum + o.strength * plasma * plasma / response
                });
                permittivity.sqrt()
            }
            Self::Table(rows) => interpolate(rows, micrometres),
        }
    }
}

/// Both columns of `rows` at `x` [µm], which lies between the first and the last row.
fn interpolate(rows: &[Row], x: f64) -> Complex64 {
    let right = rows.partition_point(|row| row[0] < x).clamp(1, rows.len() - 1);
    let left = right - 1;
    let step = rows[right][0] - rows[left][0];
    let t = (x - rows[left][0]) / step;
    let column = |c: usize| {
        let chord = |i: usize| (rows[i + 1][c] - rows[i][c]) / (rows[i + 1][0] - rows[i][0]);
        let slope = |i: usize| {
            if i == 0 || i == rows.len() - 1 {
                return chord(left);
            }
            let (before, after) = (rows[i][0] - rows[i - 1][0], rows[i + 1][0] - rows[i][0]);
            steffen_slope(chord(i - 1), chord(i), before, after)
        };
        let (y, rise) = (rows[left][c], rows[right][c] - rows[left][c]);
        let (a, b) = (slope(left) * step, slope(right) * step);
        y + t * (a + t * (3.0 * rise - 2.0 * a - b + t * (a + b - 2.0 * rise)))
    };
    // The cubic is bounded by its rows; only rounding could take κ below a row where it vanishes.
    Complex64::new(column(1), column(2).max(0.0))
}

/// Slope at a row from the chords to its neighbours: the parabola's through all three, but 0 at an extremum and at most
/// twice the flatter chord (Steffen 1990).
fn steffen_slope(chord_before: f64, chord_after: f64, before: f64, after: f64) -> f64 {
    if chord_before * chord_after <= 0.0 {
        return 0.0;
    }
    let parabola = (chord_before * after + chord_after * before) / (before + after);
    let bound = 2.0 * chord_before.abs().min(chord_after.abs());
    parabola.signum() * parabola.abs().min(bound)
}
