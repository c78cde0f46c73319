//! Interfaces with charge or current on them: what E4 leaves out.

use crate::Polarisation;
use crate::optics::incidence::{Incidence, normal_squared, outgoing_root};
use crate::waves::constants::Z_0;
use num_complex::Complex64;

/// One side of an interface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Side {
    /// ε [F m⁻¹] of the bound charges, > 0.
    pub epsilon: f64,
    /// σ [S m⁻¹], ≥ 0 and finite.
    pub sigma: f64,
}

/// The free charge on the interface over the normal field on the near side, `ρ_s/E₁ₙ` [F m⁻¹], at the angular frequency
/// `omega` [rad s⁻¹], > 0.
///
/// From n·(D₁−D₂) = −ρ_s, n pointing to the far side, and the current that piles the charge up, n·(J₁−J₂) = −iωρ_s:
/// (ε₂σ₁ − ε₁σ₂)/(σ₂ − iωε₂). It vanishes where both media relax in the same time ε/σ. The difference ε₂E₂ − ε₁E₁
/// would leave nothing but rounding where a medium hardly conducts.
pub fn free_charge(near: Side, far: Side, omega: f64) -> Complex64 {
    let surplus = difference_of_products([far.epsilon, near.sigma], [near.epsilon, far.sigma]);
    let displaced = omega * far.epsilon;
    let scale = far.sigma.max(displaced);
    let (conducted, displaced) = (far.sigma / scale, displaced / scale);
    let per_norm = surplus / scale / (conducted * conducted + displaced * displaced);
    Complex64::new(per_norm * conducted, per_norm * displaced)
}

/// ab − cd, each product with the rounding that it leaves (Kahan; Jeannerod, Louvet & Muller, *Math. Comp.* 82, 2013).
fn difference_of_products([a, b]: [f64; 2], [c, d]: [f64; 2]) -> f64 {
    let rounded = c * d;
    let error = c.mul_add(-d, rounded);
    a.mul_add(b, -rounded) + error
}

/// A plane wave at an interface that carries the surface current K = GE.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sheet {
    /// Reflected over incident field [1], with the signs of the lecture's E36 and E39.
    pub r: Complex64,
    /// The tangential electric field in the interface over the incident wave's [1].
    pub tangential: Complex64,
    /// R [1].
    pub reflectance: f64,
    /// T [1].
    pub transmittance: f64,
    /// A [1], turned into heat by the current.
    pub absorptance: f64,
}

impl Sheet {
    /// The sheet of conductance G [S] (per square), ≥ 0, between a clear medium and one with k ≥ 0:
    /// n×(H₂−H₁) = K = GE and E4 otherwise. Y₁ and Y₂ being the admittances of the tangential fields over that of the
    /// vacuum, the field in the sheet is 2Y₁/(Y₁ + Y₂ + Z₀G). Grazing incidence itself (cos θ = 0) is left out.
    pub fn new(incidence: Incidence, polarisation: Polarisation, n_i: f64, n_t: Complex64, conductance: f64) -> Self {
        debug_assert!(conductance >= 0.0 && incidence.cos() > 0.0);
        let (q_i, q_t) = (n_i * incidence.cos(), outgoing_root(normal_squared(incidence, n_i, n_t)));
        let (near, far) = match polarisation {
            Polarisation::S => (q_i, q_t),
            Polarisation::P => (n_i * n_i / q_i, n_t * n_t / q_t),
        };
        let own = Z_0 * conductance;
        let all = near + far + own;
        let tangential = 2.0 * near / all;
        let r = (near - far - own) / all;
        let per_field = tangential.norm_sqr() / near;
        Self {
            r: match polarisation {
                Polarisation::S => r,
                Polarisation::P => -r,
            },
            tangential,
            reflectance: r.norm_sqr(),
            transmittance: far.re * per_field,
            absorptance: own * per_field,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::optics::fresnel::amplitudes;
    use crate::waves::constants::EPSILON_0;

    #[test]
    fn a_bare_interface_is_fresnels() {
        let (incidence, n_t) = (Incidence::from_angle(0.7), Complex64::new(1.4, 0.3));
        let fresnel = amplitudes(incidence, 1.2, n_t);
        let bare = |polarisation| Sheet::new(incidence, polarisation, 1.2, n_t, 0.0).r;
        assert!((bare(Polarisation::S) - fresnel.r_s).norm() < 1e-15);
        assert!((bare(Polarisation::P) - fresnel.r_p).norm() < 1e-15);
    }

    /// Graphene conducts e²/4ħ and lets 97.7 % of light through (Nair et al., *Science* 320, 1308, 2008).
    #[test]
    fn graphene_takes_two_per_cent() {
        let conductance = 1.602_176_634e-19f64.powi(2) / (4.0 * 1.054_571_817e-34);
        let sheet = Sheet::new(Incidence::NORMAL, Polarisation::S, 1.0, 1.0.into(), conductance);
        assert!((sheet.transmittance - 0.977).abs() < 1e-3, "{sheet:?}");
        let sum = sheet.reflectance + sheet.transmittance + sheet.absorptance;
        assert!((sum - 1.0).abs() < 1e-15);
    }

    #[test]
    fn no_charge_gathers_where_both_sides_relax_alike() {
        let near = Side { epsilon: EPSILON_0, sigma: 1e-3 };
        let far = Side { epsilon: 4.0 * EPSILON_0, sigma: 4e-3 };
        assert_eq!(free_charge(near, far, 1e9), Complex64::ZERO);
        // A perfect conductor takes all of D.
        let metal = Side { epsilon: EPSILON_0, sigma: 1e30 };
        let clear = Side { sigma: 0.0, ..near };
        assert!((free_charge(clear, metal, 1e9) / -EPSILON_0 - 1.0).norm() < 1e-15);
    }
}
