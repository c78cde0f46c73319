//! The diffuse surface (J. H. Lambert, *Photometria* (1760)): f = ρ/π whatever the directions (E48).

use super::{Bsdf, Character, Energy, Painted, Rgb, Sample, both_above, rgb};
use crate::number::{Number, Vector};
use crate::sampling::warp::cosine_hemisphere;
use std::f64::consts::FRAC_1_PI;

/// A surface of one radiance in all directions.
#[derive(Clone, Copy, Debug)]
pub struct Lambert<N> {
    /// ρ, the share that returns [1], 0 … 1.
    pub albedo: Rgb<N>,
}

impl<N: Number> Bsdf<N> for Lambert<N> {
    fn character(&self) -> Character {
        Character {
            transmits: false,
            is_delta: false,
            has_delta: false,
            is_stochastic: false,
            largest_weight: 1.0,
            energy: Energy::Kept,
        }
    }

    #[inline(always)]
    fn eval_pdf(&self, wi: Vector<N>, wo: Vector<N>) -> (Rgb<N>, N) {
        let inverse_pi = N::of(FRAC_1_PI).only(both_above(wi, wo));
        (rgb(|c| self.albedo[c] * inverse_pi), wi.z * inverse_pi)
    }

    #[inline(always)]
    fn sample(&self, wo: Vector<N>, u: [N; 3]) -> Sample<N> {
        let (wi, pdf) = cosine_hemisphere([u[0], u[1]]);
        Sample::reflected(wi, self.albedo, pdf).only(both_above(wi, wo))
    }

    #[inline(always)]
    fn albedo(&self, wo: Vector<N>) -> Option<Rgb<N>> {
        Some(rgb(|c| self.albedo[c].only(wo.z.gt(N::of(0.0)))))
    }
}

impl<N: Number> Painted<N> for Lambert<N> {
    #[inline(always)]
    fn painted_eval_pdf(&self, rho: Rgb<N>, wi: Vector<N>, wo: Vector<N>) -> (Rgb<N>, N) {
        Self { albedo: rho }.eval_pdf(wi, wo)
    }

    #[inline(always)]
    fn painted_sample(&self, rho: Rgb<N>, wo: Vector<N>, u: [N; 3]) -> Sample<N> {
        Self { albedo: rho }.sample(wo, u)
    }
}
