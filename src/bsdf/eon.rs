//! The rough diffuse surface that keeps its energy: J. Portsmouth, P. Kutz and S. Hill, *EON: A practical
//! energy-preserving rough diffuse BRDF*, JCGT 14(1) (2025): Fujii's Oren–Nayar, whose albedo has a closed form, and what
//! it loses given back by a reciprocal lobe.

use super::{Bsdf, Character, Energy, Painted, Rgb, Sample, both_above, rgb};
use crate::number::{Number, Vector, atan2, sin_cos_turns};
use crate::sampling::warp::cosine_hemisphere;
use std::f64::consts::{FRAC_1_PI, PI};

/// A rough diffuse surface.
#[derive(Clone, Copy, Debug)]
pub struct Eon<N> {
    /// ρ of the facets [1], 0 … 1.
    pub albedo: Rgb<N>,
    /// r, the roughness [1], 0 … 1.
    pub roughness: N,
}

/// (½ − 2/(3π)): by how much the flat part falls.
const FALL: f64 = 0.5 - 2.0 / (3.0 * PI);
/// (2/3 − 28/(15π)): what the mean albedo gains by the other part.
const MEAN_GAIN: f64 = 2.0 / 3.0 - 28.0 / (15.0 * PI);

impl<N: Number> Bsdf<N> for Eon<N> {
    fn character(&self) -> Character {
        Character {
            transmits: false,
            is_delta: false,
            has_delta: false,
            is_stochastic: false,
            largest_weight: f64::INFINITY,
            energy: Energy::Kept,
        }
    }

    #[inline(always)]
    fn eval_pdf(&self, wi: Vector<N>, wo: Vector<N>) -> (Rgb<N>, N) {
        let above = both_above(wi, wo);
        let f = self.value(wi, wo);
        (rgb(|c| f[c].only(above)), Self::density(wi).only(above))
    }

    /// Half by the cosine, half evenly: by the cosine alone weights have no bound at grazing.
    #[inline(always)]
    fn sample(&self, wo: Vector<N>, u: [N; 3]) -> Sample<N> {
        let (sin, cos) = sin_cos_turns(u[1]);
        let sine = (u[0] * (N::of(2.0) - u[0])).sqrt();
        let evenly = Vector::new(sine * cos, sine * sin, N::of(1.0) - u[0]);
        let wi = Vector::select(u[2].lt(N::of(0.5)), cosine_hemisphere([u[0], u[1]]).0, evenly);
        let pdf = Self::density(wi);
        let f = self.value(wi, wo);
        let weight = rgb(|c| f[c] * wi.z / pdf);
        Sample::reflected(wi, weight, pdf).only(both_above(wi, wo))
    }

    #[inline(always)]
    fn albedo(&self, wo: Vector<N>) -> Option<Rgb<N>> {
        let loss = self.loss(wo);
        let direct = N::of(1.0) - loss;
        let above = wo.z.gt(N::of(0.0));
        Some(rgb(|c| (self.albedo[c] * direct + self.rebound(self.albedo[c]) * loss).only(above)))
    }
}

impl<N: Number> Painted<N> for Eon<N> {
    #[inline(always)]
    fn painted_eval_pdf(&self, rho: Rgb<N>, wi: Vector<N>, wo: Vector<N>) -> (Rgb<N>, N) {
        Self { albedo: rho, ..*self }.eval_pdf(wi, wo)
    }

    #[inline(always)]
    fn painted_sample(&self, rho: Rgb<N>, wo: Vector<N>, u: [N; 3]) -> Sample<N> {
        Self { albedo: rho, ..*self }.sample(wo, u)
    }
}

impl<N: Number> Eon<N> {
    #[inline(always)]
    fn density(wi: Vector<N>) -> N {
        (wi.z + N::of(0.5)) * N::of(0.5 * FRAC_1_PI)
    }

    #[inline(always)]
    fn value(&self, wi: Vector<N>, wo: Vector<N>) -> Rgb<N> {
        let zero = N::of(0.0);
        let across = wi.x * wo.x + wi.y * wo.y;
        let ahead = N::select(across.gt(zero), across / wi.z.max(wo.z), across);
        let single = N::of(FRAC_1_PI) * self.scale() * (N::of(1.0) + self.roughness * ahead);
        // Of no loss nothing is left to give back, and its lobe would be 0/0.
        let mean_loss = self.mean_loss();
        let is_rough = mean_loss.gt(zero);
        let lobe = self.loss(wi) * self.loss(wo) / N::select(is_rough, mean_loss, N::of(1.0));
        let lobe = N::of(FRAC_1_PI) * lobe.only(is_rough);
        rgb(|c| self.albedo[c] * single + self.rebound(self.albedo[c]) * lobe)
    }

    /// A.
    #[inline(always)]
    fn scale(&self) -> N {
        N::of(1.0) / (N::of(1.0) + N::of(FALL) * self.roughness)
    }

    /// 1 − ⟨E⟩ = A r (½ − 2/3π − 2/3 + 28/15π).
    #[inline(always)]
    fn mean_loss(&self) -> N {
        self.scale() * self.roughness * N::of(FALL - MEAN_GAIN)
    }

    /// 1 − E(μ) = A r (½ − 2/3π − G/π) [1]: what of white facets' light does not leave at the first bounce.
    #[inline(always)]
    fn loss(&self, w: Vector<N>) -> N {
        let (cos, sin) = (w.z, w.sin2().sqrt());
        let one = N::of(1.0);
        // G = s (θ − s μ) + ⅔((s/μ)(1 − s³) − s), its quotient without the cancellation of 1 − s³.
        let quotient = sin * cos * (one + sin + sin.squared()) / (one + sin) - sin;
        let g = sin * (atan2(sin, cos) - sin * cos) + N::of(2.0 / 3.0) * quotient;
        self.scale() * self.roughness * (N::of(FALL) - g * N::of(FRAC_1_PI))
    }

    /// ρ_ms = ρ² ⟨E⟩/(1 − ρ(1 − ⟨E⟩)): what comes of the light that bounces again.
    #[inline(always)]
    fn rebound(&self, albedo: N) -> N {
        let loss = self.mean_loss();
        albedo.squared() * (N::of(1.0) - loss) / (N::of(1.0) - albedo * loss)
    }
}
