//! Models whose ρ differs from place to place.

use super::{Bsdf, Character, Rgb, Sample};
use crate::number::{Number, Vector};

/// A model with a ρ, asked as if it had another. Apart from [`Bsdf`], so that models without one are not compiled twice.
pub trait Painted<N: Number>: Send + Sync {
    /// [`Bsdf::eval_pdf`] of the model with that ρ [1].
    fn painted_eval_pdf(&self, rho: Rgb<N>, wi: Vector<N>, wo: Vector<N>) -> (Rgb<N>, N);

    /// [`Bsdf::sample`] of the model with that ρ [1].
    fn painted_sample(&self, rho: Rgb<N>, wo: Vector<N>, u: [N; 3]) -> Sample<N>;
}

/// A model with the ρ of a place.
pub(super) struct Repainted<'a, N, M> {
    pub model: &'a M,
    pub rho: Rgb<N>,
}

impl<N: Number, M: Bsdf<N> + Painted<N>> Bsdf<N> for Repainted<'_, N, M> {
    fn character(&self) -> Character {
        self.model.character()
    }

    #[inline(always)]
    fn eval_pdf(&self, wi: Vector<N>, wo: Vector<N>) -> (Rgb<N>, N) {
        self.model.painted_eval_pdf(self.rho, wi, wo)
    }

    #[inline(always)]
    fn sample(&self, wo: Vector<N>, u: [N; 3]) -> Sample<N> {
        self.model.painted_sample(self.rho, wo, u)
    }
}
