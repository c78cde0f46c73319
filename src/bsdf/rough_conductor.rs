//! Rough metal, one bounce: f = D F G₂/(4 cos cos) (K. E. Torrance and E. M. Sparrow, JOSA 57 (1967) 1105), drawn by the
//! facets that are seen. What would bounce again is lost.

use super::fresnel::Reflecting;
use super::microfacet::{Distribution, Joint};
use super::{Bsdf, Character, Energy, Rgb, Sample, both_above, rgb};
use crate::number::{Number, Vector};

/// Facets of metal.
#[derive(Clone, Copy, Debug)]
pub struct RoughConductor<D, M> {
    /// How they lie.
    pub facets: D,
    /// How their masking goes together.
    pub joint: Joint,
    /// What they are made of: metal, bare or under a film.
    pub metal: M,
}

/// The facet's normal that mirrors one direction into the other, and the cosine [1] to either.
#[inline(always)]
pub(super) fn half_vector<N: Number>(wi: Vector<N>, wo: Vector<N>) -> (Vector<N>, N) {
    let both = wi + wo;
    let half = both.scaled(N::of(1.0) / both.dot(both).max(N::of(f64::from(f32::MIN_POSITIVE))).sqrt());
    (half, wo.dot(half).max(N::of(0.0)).min(N::of(1.0)))
}

impl<N: Number, D: Distribution<N>, M: Reflecting<N> + Send + Sync> Bsdf<N> for RoughConductor<D, M> {
    fn character(&self) -> Character {
        Character {
            transmits: false,
            is_delta: false,
            has_delta: false,
            is_stochastic: false,
            largest_weight: 1.0,
            energy: Energy::Lost,
        }
    }

    #[inline(always)]
    fn eval_pdf(&self, wi: Vector<N>, wo: Vector<N>) -> (Rgb<N>, N) {
        let above = both_above(wi, wo);
        let wi = Vector::select(above, wi, Vector::of([0.0, 0.0, 1.0]));
        let wo = Vector::select(above, wo, Vector::of([0.0, 0.0, 1.0]));
        let (half, cos) = half_vector(wi, wo);
        let quarter = N::of(0.25) * self.facets.density(half);
        let shape = quarter * self.joint_area(wi, wo);
        let pdf = (quarter / self.facets.reflecting_area(wo)).only(above);
        let share = self.metal.reflectance(cos);
        (rgb(|c| (share[c] * shape).only(above)), pdf)
    }

    #[inline(always)]
    fn sample(&self, wo: Vector<N>, u: [N; 3]) -> Sample<N> {
        let facet = self.facets.visible_reflecting(wo, [u[0], u[1]]);
        let cos = wo.dot(facet).max(N::of(0.0)).min(N::of(1.0));
        let wi = facet.scaled(N::of(2.0) * cos) - wo;
        let area = self.facets.reflecting_area(wo);
        let carried = wi.z * area * self.joint_area(wi, wo);
        let share = self.metal.reflectance(cos);
        let weight = rgb(|c| share[c] * carried);
        let pdf = N::of(0.25) * self.facets.density(facet) / area;
        Sample::reflected(wi, weight, pdf).only(both_above(wi, wo))
    }
}

impl<D, M> RoughConductor<D, M> {
    /// G₂/(cos cos).
    #[inline(always)]
    fn joint_area<N: Number>(&self, wi: Vector<N>, wo: Vector<N>) -> N
    where
        D: Distribution<N>,
    {
        self.joint.reflected([wi.z, self.facets.area(wi)], [wo.z, self.facets.area(wo)])
    }
}
