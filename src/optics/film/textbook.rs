//! The forms that textbooks and packages use, in plain `f64`, to contrast with [`Stack`]: each is right on
//! paper, and each has stacks on which it loses every digit. Not for use.

use super::{Powers, Stack};
use crate::Polarisation;
use crate::optics::incidence::{Incidence, normal_squared, outgoing_root};
use num_complex::Complex64;
use std::f64::consts::TAU;

const I: Complex64 = Complex64::I;

/// The absorptance as what is missing.
fn powers(reflectance: f64, transmittance: f64) -> Powers {
    Powers { reflectance, transmittance, absorptance: 1.0 - reflectance - transmittance }
}

/// The normal wave numbers q = n cos θ [1] and tilted admittances Y (q for s, q/n² for p) of every medium of the
/// stack, the incident one first.
fn media(stack: &Stack, incidence: Incidence, polarisation: Polarisation) -> Vec<(Complex64, Complex64)> {
    let indices = stack.layers.iter().map(|layer| layer.index).chain([stack.substrate]);
    let incident = (Complex64::from(stack.n_i), Complex64::from(stack.n_i * incidence.cos()));
    std::iter::once(incident)
        .chain(indices.map(|n| (n, outgoing_root(normal_squared(incidence, stack.n_i, n)))))
        .map(|(n, q)| match polarisation {
            Polarisation::S => (q, q),
            Polarisation::P => (q, q / (n * n)),
        })
        .collect()
}

/// Abelès' characteristic matrix, layer by layer (Born & Wolf, 7th ed., §1.6.2): cos δ and sin δ of a complex δ grow
/// as e^(Im δ) until they overflow, and 1/Y divides by zero at a layer's critical angle.
pub fn characteristic_matrix(
    stack: &Stack,
    wavelength: f64,
    incidence: Incidence,
    polarisation: Polarisation,
) -> Powers {
    let media = media(stack, incidence, polarisation);
    let (y_i, y_s) = (media[0].1, media[media.len() - 1].1);
    let (mut psi, mut phi) = (Complex64::ONE, y_s);
    for (layer, &(q, y)) in stack.layers.iter().zip(&media[1..]).rev() {
        let delta = TAU / wavelength * layer.thickness * q;
        let (sin, cos) = (delta.sin(), delta.cos());
        (psi, phi) = (cos * psi - I * sin / y * phi, cos * phi - I * y * sin * psi);
    }
    let r = (y_i * psi - phi) / (y_i * psi + phi);
    let t = 2.0 * y_i / (y_i * psi + phi);
    powers(r.norm_sqr(), y_s.re / y_i.re * t.norm_sqr())
}

/// The transfer matrix of interfaces and propagations, as in the Python package `tmm` (Byrnes, arXiv:1603.02720),
/// with that package's clamp Im δ ≤ 35: T stops near 10⁻³¹ however opaque the stack is.
pub fn transfer_matrix(stack: &Stack, wavelength: f64, incidence: Incidence, polarisation: Polarisation) -> Powers {
    let media = media(stack, incidence, polarisation);
    let (y_i, y_s) = (media[0].1, media[media.len() - 1].1);
    // The column (1/t, r/t), from the substrate up: an interface, then a propagation through the layer above it.
    let (mut forward, mut backward) = (Complex64::ONE, Complex64::ZERO);
    for j in (0..media.len() - 1).rev() {
        let (above, below) = (media[j].1, media[j + 1].1);
        let (r, t) = ((above - below) / (above + below), 2.0 * above / (above + below));
        (forward, backward) = ((forward + r * backward) / t, (r * forward + backward) / t);
        if j > 0 {
            let mut delta = TAU / wavelength * stack.layers[j - 1].thickness * media[j].0;
            delta.im = delta.im.min(35.0);
            forward *= (-I * delta).exp();
            backward *= (I * delta).exp();
        }
    }
    powers((backward / forward).norm_sqr(), y_s.re / y_i.re / forward.norm_sqr())
}

/// Rouard's (Parratt's) recursion r ← (ρ + r e^(2iδ))/(1 + ρ r e^(2iδ)) of Fresnel's coefficients (Born & Wolf, 7th
/// ed., §1.6.4): no exponential grows, but beside a layer at its critical angle ρ = ±1 and it becomes 0/0.
pub fn recursion(stack: &Stack, wavelength: f64, incidence: Incidence, polarisation: Polarisation) -> Powers {
    let media = media(stack, incidence, polarisation);
    let (y_i, y_s) = (media[0].1, media[media.len() - 1].1);
    let (mut r, mut t) = (Complex64::ZERO, Complex64::ONE);
    for j in (0..media.len() - 1).rev() {
        let (above, below) = (media[j].1, media[j + 1].1);
        let step = if j + 1 < media.len() - 1 {
            (I * (TAU / wavelength * stack.layers[j].thickness * media[j + 1].0)).exp()
        } else {
            Complex64::ONE
        };
        let rho = (above - below) / (above + below);
        let round = r * step * step;
        t = (1.0 + rho) * t * step / (1.0 + rho * round);
        r = (rho + round) / (1.0 + rho * round);
    }
    powers(r.norm_sqr(), y_s.re / y_i.re * t.norm_sqr())
}
