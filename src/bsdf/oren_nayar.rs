//! The rough diffuse surface as textbooks have it: M. Oren and S. K. Nayar, *Generalization of Lambert's reflectance
//! model*, SIGGRAPH 1994, the "qualitative" model of its eq. 30. Near grazing it returns more than it is sent.

use super::lambert::Lambert;
use super::{Bsdf, Character, Energy, Rgb, Sample, both_above, rgb};
use crate::number::{Number, Vector};

/// Facets that are Lambert's, in V-grooves.
#[derive(Clone, Copy, Debug)]
pub struct OrenNayar<N> {
    /// ρ of the facets [1].
    pub albedo: Rgb<N>,
    /// σ, the standard deviation of the facets' angles [rad], 0 … π/2.
    pub sigma: N,
}

impl<N: Number> Bsdf<N> for OrenNayar<N> {
    fn character(&self) -> Character {
        Character { largest_weight: f64::INFINITY, energy: Energy::Gained, ..self.body().character() }
    }

    #[inline(always)]
    fn eval_pdf(&self, wi: Vector<N>, wo: Vector<N>) -> (Rgb<N>, N) {
        let (flat, pdf) = self.body().eval_pdf(wi, wo);
        let factor = self.factor(wi, wo);
        (rgb(|c| flat[c] * factor), pdf)
    }

    #[inline(always)]
    fn sample(&self, wo: Vector<N>, u: [N; 3]) -> Sample<N> {
        let flat = self.body().sample(wo, u);
        let factor = self.factor(flat.wi, wo).only(both_above(flat.wi, wo));
        Sample { weight: rgb(|c| flat.weight[c] * factor), ..flat }
    }
}

impl<N: Number> OrenNayar<N> {
    fn body(&self) -> Lambert<N> {
        Lambert { albedo: self.albedo }
    }

    /// A + B max(0, cos Δφ) sin α tan β: sin sin cos Δφ is wi·wo − cos cos, and tan divides by the larger cosine.
    #[inline(always)]
    fn factor(&self, wi: Vector<N>, wo: Vector<N>) -> N {
        let sigma2 = self.sigma.squared();
        let a = N::of(1.0) - N::of(0.5) * sigma2 / (sigma2 + N::of(0.33));
        let b = N::of(0.45) * sigma2 / (sigma2 + N::of(0.09));
        let across = wi.x * wo.x + wi.y * wo.y;
        a + b * across.max(N::of(0.0)) / wi.z.max(wo.z)
    }
}
