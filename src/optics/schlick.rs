//! Schlick's approximation of natural reflectance and two of its descendants (E44).

use super::incidence::{Incidence, normal_squared};
use num_complex::Complex64;

/// Reflectance at normal incidence [1], |(n_t − n_i)/(n_t + n_i)|².
pub fn normal_reflectance(n_i: f64, n_t: Complex64) -> f64 {
    (n_t - n_i).norm_sqr() / (n_t + n_i).norm_sqr()
}

/// R ≈ R₀ + (1 − R₀)(1 − cos θ)⁵ [1] (Schlick 1994, *Computer Graphics Forum* 13(3), eq. 15).
pub fn schlick(cos: f64, r_0: f64) -> f64 {
    schlick_by_versine(1.0 - cos, r_0)
}

/// The same from 1 − cos θ [1], which near the normal keeps digits that cos θ has lost ([`Incidence::versine`]).
pub fn schlick_by_versine(versine: f64, r_0: f64) -> f64 {
    r_0 + (1.0 - r_0) * fifth_power(versine)
}

/// Schlick with the cosine on the rarer side, and 1 beyond the critical angle: what keeps the formula
/// usable from inside glass, where cos θ_i itself never comes near zero before everything is reflected.
pub fn schlick_rarer_side(cos_i: f64, n_i: f64, n_t: f64) -> f64 {
    let r_0 = normal_reflectance(n_i, Complex64::from(n_t));
    if n_i <= n_t {
        return schlick(cos_i, r_0);
    }
    let q2_t = normal_squared(Incidence::from_cos(cos_i), n_i, Complex64::from(n_t)).re;
    if q2_t <= 0.0 { 1.0 } else { schlick(q2_t.sqrt() / n_t, r_0) }
}

/// Schlick less a lobe −b cos θ (1 − cos θ)⁶ that makes it exact at cos θ = 1/7, near where metals dip most
/// (Kutz, Hašan and Edmondson 2021, *Novel aspects of the Adobe Standard Material*, §2: "F82").
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dipped {
    r_0: f64,
    dip: f64,
}

impl Dipped {
    /// From the reflectances [1] at normal incidence and at cos θ = 1/7 (82°).
    pub fn new(r_0: f64, r_82: f64) -> Self {
        let cos = Self::COS;
        let lobe = cos * (1.0 - cos).powi(6);
        Self { r_0, dip: (schlick(cos, r_0) - r_82) / lobe }
    }

    /// The cosine at which the second reflectance is taken.
    pub const COS: f64 = 1.0 / 7.0;

    /// Reflectance [1] at cos θ.
    pub fn reflectance(self, cos: f64) -> f64 {
        let away = 1.0 - cos;
        schlick(cos, self.r_0) - self.dip * cos * away * fifth_power(away)
    }
}

fn fifth_power(x: f64) -> f64 {
    let x2 = x * x;
    x2 * x2 * x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_at_both_ends() {
        let r_0 = normal_reflectance(1.0, Complex64::from(1.5));
        assert!((r_0 - 0.04).abs() < 1e-17);
        assert_eq!((schlick(1.0, r_0), schlick(0.0, r_0)), (r_0, 1.0));
    }

    #[test]
    fn the_dipped_form_passes_through_both_its_reflectances() {
        let metal = Dipped::new(0.9, 0.85);
        assert!((metal.reflectance(1.0) - 0.9).abs() < 1e-15);
        assert!((metal.reflectance(Dipped::COS) - 0.85).abs() < 1e-15);
    }

    #[test]
    fn the_rarer_side_knows_total_reflection() {
        assert_eq!(schlick_rarer_side(0.1, 1.5, 1.0), 1.0);
        assert!((schlick_rarer_side(1.0, 1.5, 1.0) - 0.04).abs() < 1e-15);
    }
}
