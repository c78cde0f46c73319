//! Stacks of plane coherent films: what a multilayer reflects, transmits and absorbs.
//!
//! One pair of unknowns serves both polarisations: ψ = E, φ = qψ (s) or ψ = H, φ = (q/n²)ψ (p) for a wave that runs
//! into the stack, q = n cos θ being the normal wave number over that of vacuum. Both are continuous at every
//! interface, and a layer takes them from its back to its front by the characteristic matrix (Abelès 1950; Born &
//! Wolf, 7th ed., §1.6.2) M = [[cos δ, −i sin δ/Y], [−i Y sin δ, cos δ]], Y = q or q/n², δ = k₀ d q. What is done to
//! keep its digits:
//!
//! - e^(Im δ), which grows without bound, is factored out of each layer and only its exponent is summed.
//! - The rest is written as the identity and a change, which vanishes with the layer, and the change is added with
//!   the rounding carried along, as losses and phases are: a hundred thousand thin layers are as exact as one. In an absorbing layer the change is
//!   u (1, −Y)ᵀ (1, −1/Y), u = (e^(2iδ) − 1)/2, of M e^(iδ): it leaves the wave that runs forward untouched.
//! - Layers of the substrate's own clear medium in front of it only turn the wave, so that a stack that is matched
//!   throughout reflects nothing, not even its rounding.
//! - Nothing divides by q: at the critical angle sin δ/Y → k₀ d (s) or n² k₀ d (p).
//! - The sweep runs from the substrate to the light, the direction in which the wanted solution grows, and powers
//!   of two taken out on the way keep the fields within range.
//! - Absorption is the integral of Im(n²) |E|² in closed form, and of R and T the larger is what the others leave.

use crate::Polarisation;
use crate::optics::incidence::{Incidence, normal_squared, outgoing_root};
use num_complex::Complex64;

mod lanes;
mod sweep;
pub mod textbook;

use sweep::{Coat, Sweep};

/// A homogeneous film.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layer {
    /// n + iκ [1], n ≥ 0 and κ ≥ 0, not both zero; n = 0 is a metal without loss.
    pub index: Complex64,
    /// [m], ≥ 0.
    pub thickness: f64,
}

/// Films between two half-spaces, in the order in which the light meets them.
#[derive(Clone, Copy, Debug)]
pub struct Stack<'a> {
    /// Index [1] of the clear medium that the light comes from, > 0.
    pub n_i: f64,
    /// From the light to the substrate; may be empty.
    pub layers: &'a [Layer],
    /// Index n + iκ [1] of the half-space behind, as a layer's.
    pub substrate: Complex64,
}

/// What becomes of a wave of unit power.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Powers {
    /// R [1], reflected.
    pub reflectance: f64,
    /// T [1], flux into the substrate; 0 where it is below the range of `f64`.
    pub transmittance: f64,
    /// A [1], absorbed in the layers; exactly 0 if none of them absorbs.
    pub absorptance: f64,
}

/// Everything about one wave.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Response {
    /// Reflected field over incident field [1] at the first interface, electric for s and p alike, with the signs
    /// of the lecture's E36 and E39.
    pub r: Complex64,
    /// Electric field at the substrate's surface over the incident one [1] at the first interface (E37, E40).
    pub t: Complex64,
    /// R [1].
    pub reflectance: f64,
    /// T [1].
    pub transmittance: f64,
    /// A [1].
    pub absorptance: f64,
    /// ln T [1], where T itself would underflow too; −∞ if nothing propagates behind.
    pub ln_transmittance: f64,
}

/// Wavelengths that [`Waves::powers`] works on side by side.
const LANES: usize = 4;

impl Stack<'_> {
    /// What does not depend on the wavelength, worked out once: the same indices, angle and polarisation for many.
    pub fn waves(&self, incidence: Incidence, polarisation: Polarisation) -> Waves {
        debug_assert!(self.n_i > 0.0 && self.n_i.is_finite() && self.substrate.im >= 0.0);
        let admittance = |n: Complex64| {
            let square = normal_squared(incidence, self.n_i, n);
            Admittance::new(square, self.n_i * incidence.sin(), n, polarisation)
        };
        let y_i = match polarisation {
            Polarisation::S => self.n_i * incidence.cos(),
            Polarisation::P => incidence.cos() / self.n_i,
        };
        // The incident medium again: to the last bit, or a vacant interface would reflect its rounding.
        let y_s = if self.substrate == self.n_i.into() { y_i.into() } else { admittance(self.substrate).y };
        // Towards the light, and without what has no thickness.
        let mut is_unbroken = true;
        let solid = self.layers.iter().rev().filter(|layer| layer.thickness > 0.0);
        let coats = solid.map(|layer| {
            is_unbroken &= layer.index == self.substrate;
            Coat::new(layer, &admittance(layer.index), is_unbroken)
        });
        let t_unit = match polarisation {
            Polarisation::S => Complex64::ONE,
            Polarisation::P => self.n_i / self.substrate,
        };
        Waves { y_i, y_s, t_unit, coats: coats.collect() }
    }

    /// The response at one vacuum wavelength [m], > 0.
    pub fn response(&self, wavelength: f64, incidence: Incidence, polarisation: Polarisation) -> Response {
        self.waves(incidence, polarisation).response(wavelength)
    }
}

/// The admittance of a wave that runs into the stack in one of its media.
struct Admittance {
    /// Normal wave number over that of vacuum [1].
    q: Complex64,
    /// φ/ψ [1].
    y: Complex64,
    /// ψ/φ [1]; infinite at the critical angle.
    inverse: Complex64,
    /// lim q/Y [1] as q → 0: 1 (s) or n² (p).
    q_over_y: f64,
    /// Weights of |ψ|² and |φ|² in Im(n²) |E|² [1].
    loss: (f64, f64),
}

impl Admittance {
    /// From q², the tangential index n_i sin θ, and the index of the medium.
    fn new(square: Complex64, tangential: f64, n: Complex64, polarisation: Polarisation) -> Self {
        debug_assert!(n != Complex64::ZERO && n.re >= 0.0 && n.im >= 0.0 && n.is_finite());
        let q = outgoing_root(square);
        let absorption = 2.0 * n.re * n.im;
        // Twice divided by |q|, because |q|² may underflow.
        let size = q.norm();
        let inverse_q = Complex64::new(q.re / size / size, -q.im / size / size);
        match polarisation {
            Polarisation::S => Self { q, y: q, inverse: inverse_q, q_over_y: 1.0, loss: (absorption, 0.0) },
            Polarisation::P if square.im == 0.0 => {
                let n_squared = n.re * n.re - n.im * n.im;
                Self { q, y: q / n_squared, inverse: inverse_q * n_squared, q_over_y: n_squared, loss: (0.0, 0.0) }
            }
            Polarisation::P => {
                // q/n² and n²/q with n² = q² + S², S the tangential index, so that terms of one sign stand where the
                // sign is fixed: Re = q_r (|q|² + S²), Im = ± q_i (Re n² − 2 q_r²), over |n|⁴ and over |q|².
                let (s2, n2) = (tangential * tangential, n.norm_sqr());
                let (re, im) = (q.norm_sqr() + s2, (n.re - n.im) * (n.re + n.im) - 2.0 * q.re * q.re);
                let y = Complex64::new(q.re * re, q.im * im) / (n2 * n2);
                let inverse = Complex64::new(inverse_q.re * re, inverse_q.im * im);
                Self { q, y, inverse, q_over_y: f64::NAN, loss: (absorption * s2 / (n2 * n2), absorption) }
            }
        }
    }
}

/// A [`Stack`] under a fixed angle and polarisation, ready for any wavelength. Its indices do not disperse: build
/// one per wavelength where they do.
#[derive(Clone, Debug)]
pub struct Waves {
    y_i: f64,
    y_s: Complex64,
    /// Electric over ψ-ratio of the substrate's wave.
    t_unit: Complex64,
    coats: Vec<Coat>,
}

impl Waves {
    /// R, T and A at each vacuum wavelength [m], > 0: the very bits of [`Self::response`], several at a time.
    ///
    /// # Panics
    /// If the slices differ in length.
    pub fn powers(&self, wavelengths: &[f64], powers: &mut [Powers]) {
        assert_eq!(wavelengths.len(), powers.len(), "one result for each wavelength");
        let mut results = powers.chunks_exact_mut(LANES);
        let mut chunks = wavelengths.chunks_exact(LANES);
        for (wavelengths, results) in (&mut chunks).zip(&mut results) {
            let wavelengths: &[f64; LANES] = wavelengths.try_into().expect("a whole chunk");
            Sweep::run(self, wavelengths).powers_into(self, results);
        }
        for (wavelength, result) in chunks.remainder().iter().zip(results.into_remainder()) {
            Sweep::run(self, &[*wavelength]).powers_into(self, std::slice::from_mut(result));
        }
    }

    /// The whole response at a vacuum wavelength [m], > 0.
    pub fn response(&self, wavelength: f64) -> Response {
        Sweep::run(self, &[wavelength]).response(self)
    }
}
