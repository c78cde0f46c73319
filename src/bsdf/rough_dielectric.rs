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

/// The density [sr⁻¹] of where light comes from that goes to `w`, above or below the surface, by the facets that are seen
/// from there: of reflection, or of refraction where the mask is true.
#[inline(always)]
pub(super) fn phase<N: Number>(
    facets: &impl Distribution<N>,
    eta: N,
    is_transmitted: N::Mask,
    wi: Vector<N>,
    w: Vector<N>,
) -> N {
    let (zero, one) = (N::of(0.0), N::of(1.0));
    let both = w + wi.scaled(N::select(is_transmitted, eta, one));
    // Opposite directions, or ones that a rarer far side joins, have no facet or one that looks down.
    let length2 = both.dot(both);
    let some = N::of(f64::from(f32::MIN_POSITIVE));
    let half = both.scaled(one / length2.max(some).sqrt());
    let half = Vector::select(half.z.lt(zero), -half, half);
    let (cos, cos_i) = (w.dot(half), wi.dot(half));
    let is_beyond = N::select(is_transmitted, -cos_i, cos_i).gt(zero);
    let is_met = cos.gt(zero) & is_beyond & length2.gt(some);
    let cos = N::select(is_met, cos.min(one), one);
    let turned = turned(is_transmitted, cos, eta, dielectric(cos, eta));
    (turned * facets.density(half) / projected(facets, w).max(some)).only(is_met)
}

impl<N: Number, D: Distribution<N>> RoughDielectric<N, D> {
    /// Glass whose inside has the given index [1], held off 1 by [`LEAST_CONTRAST`].
    pub fn new(facets: D, joint: Joint, index: N) -> Self {
        Self { facets, joint, index: held_off_one(index) }
    }

    /// The share [1] that one facet sends on without another, both ways together: a facet as seen from `wo`, drawn by two
    /// numbers in 0 ≤ u < 1.
    #[inline(always)]
    pub fn energy(&self, wo: Vector<N>, u: [N; 2]) -> N {
        let (side, facet, cos, there) = self.meet(wo, u);
        let (_, back, _) = self.send(N::Mask::of(false), &side, facet, cos, there);
        let (_, through, _) = self.send(N::Mask::of(true), &side, facet, cos, there);
        there.reflectance * back + (N::of(1.0) - there.reflectance) * through
    }

    /// A facet that is seen, at what cosine, and what it does.
    #[inline(always)]
    fn meet(&self, wo: Vector<N>, u: [N; 2]) -> (Side<N>, Vector<N>, N, Interface<N>) {
        let side = Side::of(wo, self.index);
        let facet = self.facets.visible(side.wo, u);
        let cos = side.wo.dot(facet).max(N::of(0.0)).min(N::of(1.0));
        (side, facet, cos, dielectric(cos, side.eta))
    }

    /// Where a facet sends light to, or through, the share [1] of it that no other facet stops, and whether it goes to the
    /// side that it should: then it is drawn, though so little may be left that the width cannot hold it.
    #[inline(always)]
    fn send(
        &self,
        through: N::Mask,
        side: &Side<N>,
        facet: Vector<N>,
        cos: N,
        there: Interface<N>,
    ) -> (Vector<N>, N, N::Mask) {
        let zero = N::of(0.0);
        let wo = side.wo;
        let wi = Vector::select(through, refracted(wo, facet, cos, side.eta, there), reflected(wo, facet, cos));
        let is_kept = N::select(through, -wi.z, wi.z).gt(zero);
        let share = wi.z.abs() * self.facets.area(wo) * self.joint_area(through, wi, wo);
        (wi, share.only(is_kept), is_kept)
    }

    /// G₂/(z_i z_o).
    #[inline(always)]
    fn joint_area(&self, is_transmitted: N::Mask, wi: Vector<N>, wo: Vector<N>) -> N {
        let (i, o) = ([wi.z.abs(), self.facets.area(wi)], [wo.z.abs(), self.facets.area(wo)]);
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
        let Side { is_inside, wo, eta } = Side::of(wo, self.index);
        let wi = wi.flipped(is_inside);
        let is_transmitted = wi.z.lt(N::of(0.0));
        let pdf = phase(&self.facets, eta, is_transmitted, wi, wo);
        let weight = self.joint_area(is_transmitted, wi, wo) * self.facets.area(wo);
        (grey(pdf * weight * compression(is_transmitted, eta)), pdf)
    }

    #[inline(always)]
    fn sample(&self, wo: Vector<N>, u: [N; 3]) -> Sample<N> {
        let (side, facet, cos, there) = self.meet(wo, [u[0], u[1]]);
        let is_transmitted = u[2].ge(there.reflectance);
        let (wi, share, is_kept) = self.send(is_transmitted, &side, facet, cos, there);
        let compression = compression(is_transmitted, side.eta);
        let turned = turned(is_transmitted, cos, side.eta, there);
        Sample {
            wi: wi.flipped(side.is_inside),
            weight: grey(share * compression),
            pdf: turned * self.facets.density(facet) / self.facets.area(side.wo),
            is_delta: N::Mask::of(false),
            is_transmitted,
            compression,
        }
        .only(is_kept)
    }
}
