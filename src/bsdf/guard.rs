//! The gate in front of a model: whatever comes in, what goes out is finite.

use super::painted::{Painted, Repainted};
use super::{Bsdf, Character, Rgb, Sample, rgb};
use crate::number::{Number, Vector};

/// A model behind its gate. Directions whose length is off 1 by more than 1/2000, nearly in the surface (|z| < 1e−7) or not
/// numbers at all see nothing; numbers outside 0 ≤ u < 1 count as ½; a draw that fails the same test is rejected.
#[derive(Clone, Copy, Debug)]
pub struct Guarded<M>(pub M);

/// The least |cos θ| [1] that is let in.
pub const LEAST_COSINE: f64 = 1e-7;

/// Whether a direction can be let in.
#[inline(always)]
pub(super) fn is_fit<N: Number>(w: Vector<N>) -> N::Mask {
    (w.dot(w) - N::of(1.0)).abs().lt(N::of(1e-3)) & w.z.abs().ge(N::of(LEAST_COSINE))
}

/// The direction where it is fit, else the normal.
#[inline(always)]
fn or_normal<N: Number>(fit: N::Mask, w: Vector<N>) -> Vector<N> {
    Vector::select(fit, w, Vector::of([0.0, 0.0, 1.0]))
}

impl<N: Number, M: Bsdf<N>> Bsdf<N> for Guarded<M> {
    fn character(&self) -> Character {
        self.0.character()
    }

    #[inline(always)]
    fn eval_pdf(&self, wi: Vector<N>, wo: Vector<N>) -> (Rgb<N>, N) {
        let (fit_i, fit_o) = (is_fit(wi), is_fit(wo));
        let (f, pdf) = self.0.eval_pdf(or_normal(fit_i, wi), or_normal(fit_o, wo));
        let fit = fit_i & fit_o;
        (rgb(|c| f[c].only(fit)), pdf.only(fit))
    }

    #[inline(always)]
    fn sample(&self, wo: Vector<N>, u: [N; 3]) -> Sample<N> {
        let fit = is_fit(wo);
        let wo = or_normal(fit, wo);
        let u = rgb(|k| N::select(u[k].ge(N::of(0.0)) & u[k].lt(N::of(1.0)), u[k], N::of(0.5)));
        let drawn = self.0.sample(wo, u);
        let is_drawn = is_fit(drawn.wi);
        Sample { wi: or_normal(is_drawn, drawn.wi), ..drawn }.only(fit & is_drawn)
    }

    #[inline(always)]
    fn albedo(&self, wo: Vector<N>) -> Option<Rgb<N>> {
        let fit = is_fit(wo);
        let albedo = self.0.albedo(or_normal(fit, wo))?;
        Some(rgb(|c| albedo[c].only(fit)))
    }
}

impl<N: Number, M: Bsdf<N> + Painted<N>> Painted<N> for Guarded<M> {
    #[inline(always)]
    fn painted_eval_pdf(&self, rho: Rgb<N>, wi: Vector<N>, wo: Vector<N>) -> (Rgb<N>, N) {
        Guarded(Repainted { model: &self.0, rho }).eval_pdf(wi, wo)
    }

    #[inline(always)]
    fn painted_sample(&self, rho: Rgb<N>, wo: Vector<N>, u: [N; 3]) -> Sample<N> {
        Guarded(Repainted { model: &self.0, rho }).sample(wo, u)
    }
}
