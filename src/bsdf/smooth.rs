//! Surfaces without roughness, whose directions have no choice: f is a delta over the cosine (E49, E50).

use super::fresnel::{Reflecting, dielectric};
use super::{Bsdf, Character, Energy, Rgb, Sample, grey, rgb};
use crate::number::{Mask, Number, Vector};

pub(super) const CHARACTER: Character = Character {
    transmits: false,
    is_delta: true,
    has_delta: true,
    is_stochastic: false,
    largest_weight: 1.0,
    energy: Energy::Kept,
};

/// The direction that mirrors `w`.
#[inline(always)]
fn mirrored<N: Number>(w: Vector<N>) -> Vector<N> {
    Vector::new(-w.x, -w.y, w.z)
}

/// What deltas are known to have in any other direction.
#[inline(always)]
pub(super) fn nothing<N: Number>() -> (Rgb<N>, N) {
    (grey(N::of(0.0)), N::of(0.0))
}

/// The direction from which light comes through to `w`, of relative index `eta` behind, where it is at `cos_t` to the normal.
#[inline(always)]
fn refracted<N: Number>(w: Vector<N>, eta: N, cos_t: N) -> Vector<N> {
    Vector::new(-w.x / eta, -w.y / eta, N::select(w.z.lt(N::of(0.0)), cos_t, -cos_t))
}

/// Light that goes to `wo` and comes either by way of the mirror or through, as it was chosen, carrying the share that was
/// `reflected` or `passed`: past an interface of relative index `eta` behind, at `cos_t` to the normal there.
#[inline(always)]
pub(super) fn either<N: Number>(
    wo: Vector<N>,
    [eta, cos_t]: [N; 2],
    is_transmitted: N::Mask,
    [reflected, passed]: [Rgb<N>; 2],
) -> Sample<N> {
    let one = N::of(1.0);
    let compression = N::select(is_transmitted, one / eta.squared(), one);
    Sample {
        wi: Vector::select(is_transmitted, refracted(wo, eta, cos_t), mirrored(wo)),
        weight: rgb(|c| N::select(is_transmitted, passed[c] * compression, reflected[c])),
        pdf: N::of(0.0),
        is_delta: N::Mask::of(true),
        is_transmitted,
        compression,
    }
}

/// A mirror of the same reflectance at every angle.
#[derive(Clone, Copy, Debug)]
pub struct Mirror<N> {
    /// The share reflected [1], 0 … 1.
    pub reflectance: Rgb<N>,
}

impl<N: Number> Bsdf<N> for Mirror<N> {
    fn character(&self) -> Character {
        CHARACTER
    }

    #[inline(always)]
    fn eval_pdf(&self, _: Vector<N>, _: Vector<N>) -> (Rgb<N>, N) {
        nothing()
    }

    #[inline(always)]
    fn sample(&self, wo: Vector<N>, _: [N; 3]) -> Sample<N> {
        let drawn = Sample::reflected(mirrored(wo), self.reflectance, N::of(0.0));
        Sample { is_delta: N::Mask::of(true), ..drawn }.only(wo.z.gt(N::of(0.0)))
    }

    #[inline(always)]
    fn albedo(&self, wo: Vector<N>) -> Option<Rgb<N>> {
        Some(rgb(|c| self.reflectance[c].only(wo.z.gt(N::of(0.0)))))
    }
}

/// Polished metal.
#[derive(Clone, Copy, Debug)]
pub struct SmoothConductor<M> {
    /// Its indices, or what is known of it under a film.
    pub metal: M,
}

impl<N: Number, M: Reflecting<N> + Send + Sync> Bsdf<N> for SmoothConductor<M> {
    fn character(&self) -> Character {
        CHARACTER
    }

    #[inline(always)]
    fn eval_pdf(&self, _: Vector<N>, _: Vector<N>) -> (Rgb<N>, N) {
        nothing()
    }

    #[inline(always)]
    fn sample(&self, wo: Vector<N>, u: [N; 3]) -> Sample<N> {
        Mirror { reflectance: self.metal.reflectance(wo.z.abs()) }.sample(wo, u)
    }

    #[inline(always)]
    fn albedo(&self, wo: Vector<N>) -> Option<Rgb<N>> {
        Mirror { reflectance: self.metal.reflectance(wo.z.abs()) }.albedo(wo)
    }
}

/// Polished glass, seen from either side.
#[derive(Clone, Copy, Debug)]
pub struct SmoothDielectric<N> {
    /// n inside [1].
    pub index: N,
}

impl<N: Number> Bsdf<N> for SmoothDielectric<N> {
    fn character(&self) -> Character {
        Character { transmits: true, ..CHARACTER }
    }

    #[inline(always)]
    fn eval_pdf(&self, _: Vector<N>, _: Vector<N>) -> (Rgb<N>, N) {
        nothing()
    }

    #[inline(always)]
    fn sample(&self, wo: Vector<N>, u: [N; 3]) -> Sample<N> {
        let (one, zero) = (N::of(1.0), N::of(0.0));
        let eta = N::select(wo.z.lt(zero), one / self.index, self.index);
        let there = dielectric(wo.z.abs().min(one), eta);
        // One of the two, chosen with its own probability: the weight is 1.
        // Chosen with its own probability: the weight is 1.
        either(wo, [eta, there.cos_t], u[2].ge(there.reflectance), [grey(one); 2])
    }

    #[inline(always)]
    fn albedo(&self, _: Vector<N>) -> Option<Rgb<N>> {
        Some(grey(N::of(1.0)))
    }
}
