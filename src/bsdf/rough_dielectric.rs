//! Rough glass, one event: reflection and refraction by the facets that are seen (B. Walter et al., *Microfacet models
//! for refraction through rough surfaces*, EGSR 2007, eqs. 17 and 21), each facet with Fresnel's own odds.

use super::fresnel::{Interface, dielectric};
use super::microfacet::{Distribution, Joint, projected};
use super::{Bsdf, Character, Energy, Rgb, Sample, grey};
use crate::number::{Mask, Number, Vector};

/// Facets of glass, seen from either side.
#[derive(Clone, Copy, Debug)]
pub struct RoughDielectric<N, D> {
    facets: D,
    joint: Joint,
    index: N,
}

/// By how much [1] the index has to be off 1: without a contrast light goes straight on and no facet can be told from
/// where it went.
pub const LEAST_CONTRAST: f64 = 1e-3;

/// What `wo` sees, turned so that it is above the surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Side<N: Number> {
    /// Whether the surface was turned over.
    pub is_inside: N::Mask,
    /// Where light goes to, above the surface.
    pub wo: Vector<N>,
    /// The index of the far side over that of `wo`'s.
    pub eta: N,
}

impl<N: Number> Side<N> {
    #[inline(always)]
    pub fn of(wo: Vector<N>, index: N) -> Self {
        let is_inside = wo.z.lt(N::of(0.0));
        Self { is_inside, wo: wo.flipped(is_inside), eta: N::select(is_inside, N::of(1.0) / index, index) }
    }
}

/// w mirrored in the facet `m`, where w·m = `cos`.
#[inline(always)]
pub(super) fn reflected<N: Number>(w: Vector<N>, m: Vector<N>, cos: N) -> Vector<N> {
    m.scaled(N::of(2.0) * cos) - w
}

/// w refracted by the facet `m`, where w·m = `cos` > 0.
#[inline(always)]
pub(super) fn refracted<N: Number>(w: Vector<N>, m: Vector<N>, cos: N, eta: N, there: Interface<N>) -> Vector<N> {
    // cos/η − cos θ_t as a quotient: the difference vanishes with the contrast.
    let one = N::of(1.0);
    let bend = (one - eta) * (one + eta) / (eta * (cos + eta * there.cos_t));
    m.scaled(bend) - w.scaled(one / eta)
}

/// The odds of the facet times w_o·m |∂ω_m/∂ω_i| [1]: what stands between D and the density of wi, but for the area seen.
#[inline(always)]
fn turned<N: Number>(is_transmitted: N::Mask, cos: N, eta: N, there: Interface<N>) -> N {
    let one = N::of(1.0);
    // The refraction twin of ¼ is cos η² cos θ_t/(w_o·m + η w_i·m)², here without the difference.
    let inverse = (cos + eta * there.cos_t) / ((one - eta) * (one + eta));
    let through = (one - there.reflectance) * cos * there.cos_t * (eta * inverse).squared();
    N::select(is_transmitted, through, N::of(0.25) * there.reflectance)
}

/// (n_o/n_i)².
#[inline(always)]
pub(super) fn compression<N: Number>(is_transmitted: N::Mask, eta: N) -> N {
    N::select(is_transmitted, N::of(1.0) / eta.squared(), N::of(1.0))
}

/// An index held off 1 by [`LEAST_CONTRAST`].
#[inline(always)]
pub(super) fn held_off_one<N: Number>(index: N) -> N {
    let one = N::of(1.0);
    let least = N::of(LEAST_CONTRAST);
    let off = index - one;
    N::select(off.abs().lt(least), N::select(off.lt(N::of(0.0)), one - least, one + least), index)
}

impl<N: Number, D: Distribution<N>> RoughDielectric<N, D> {
    /// Glass whose inside has the given index [1], held off 1 by [`LEAST_CONTRAST`].
    pub fn new(facets: D, joint: Joint, index: N) -> Self {
        Self { facets, joint, index: held_off_one(index) }
    }

    /// G₂/(z_i z_o).
    #[inline(always)]
    fn joint_area(&self, is_transmitted: N::Mask, wi: Vector<N>, wo: Vector<N>) -> N {
        let [i, o] = [wi, wo].map(|w| [w.z.abs(), self.facets.hidden(w)]);
        let back = self.joint.reflected(i, o);
        // Euler's integral is dear, and a metal-like view never asks for it.
        if is_transmitted.any() { N::select(is_transmitted, self.joint.transmitted(i, o), back) } else { back }
    }
}

impl<N: Number, D: Distribution<N>> Bsdf<N> for RoughDielectric<N, D> {
    fn character(&self) -> Character {
        Character {
            transmits: true,
            is_delta: false,
            has_delta: false,
            is_stochastic: false,
            largest_weight: 1.0,
            energy: Energy::Lost,
        }
    }

    #[inline(always)]
    fn eval_pdf(&self, wi: Vector<N>, wo: Vector<N>) -> (Rgb<N>, N) {
        let (zero, one) = (N::of(0.0), N::of(1.0));
        let Side { is_inside, wo, eta } = Side::of(wo, self.index);
        let wi = wi.flipped(is_inside);
        let is_transmitted = wi.z.lt(zero);
        let both = wo + wi.scaled(N::select(is_transmitted, eta, one));
        // Opposite directions, or ones that a rarer far side joins, have no facet or one that looks down.
        let length2 = both.dot(both);
        let some = N::of(f64::from(f32::MIN_POSITIVE));
        let half = both.scaled(one / length2.max(some).sqrt());
        let half = Vector::select(half.z.lt(zero), -half, half);
        let (cos_o, cos_i) = (wo.dot(half), wi.dot(half));
        let is_facing = cos_o.gt(zero) & length2.gt(some);
        let is_met = is_facing & ((is_transmitted & cos_i.lt(zero)) | (!is_transmitted & cos_i.gt(zero)));
        let cos_o = N::select(is_met, cos_o.min(one), one);
        let there = dielectric(cos_o, eta);
        let density = turned(is_transmitted, cos_o, eta, there) * self.facets.density(half);
        let f = density * self.joint_area(is_transmitted, wi, wo) * compression(is_transmitted, eta);
        (grey(f.only(is_met)), (density / projected(&self.facets, wo)).only(is_met))
    }

    #[inline(always)]
    fn sample(&self, wo: Vector<N>, u: [N; 3]) -> Sample<N> {
        let (zero, one) = (N::of(0.0), N::of(1.0));
        let Side { is_inside, wo, eta } = Side::of(wo, self.index);
        let facet = self.facets.visible(wo, [u[0], u[1]]);
        let cos = wo.dot(facet).max(zero).min(one);
        let there = dielectric(cos, eta);
        let is_transmitted = u[2].ge(there.reflectance);
        let wi = Vector::select(is_transmitted, refracted(wo, facet, cos, eta, there), reflected(wo, facet, cos));
        let is_kept = (is_transmitted & wi.z.lt(zero)) | (!is_transmitted & wi.z.gt(zero));
        let area = projected(&self.facets, wo);
        let compression = compression(is_transmitted, eta);
        let share = wi.z.abs() * area * self.joint_area(is_transmitted, wi, wo);
        Sample {
            wi: wi.flipped(is_inside),
            weight: grey(share * compression),
            pdf: turned(is_transmitted, cos, eta, there) * self.facets.density(facet) / area,
            is_delta: N::Mask::of(false),
            is_transmitted,
            compression,
        }
        .only(is_kept)
    }
}
