//! Rough metal and glass with every bounce: a walk over facets of independent heights, which is what Smith's masking is the
//! first step of. Exact on average, whatever the order of scattering.
//!
//! E. Heitz et al., *Multiple-scattering microfacet BSDFs with the Smith model*, ACM TOG 35(4) (2016); without heights as
//! in B. Bitterli and E. d'Eon, *A position-free path integral for homogeneous slabs and multiple scattering on Smith
//! microfacets*, CGF 41(4) (2022): τ = −ln C₁(height) is a depth in which facets are met at random, at the rate 1 + Λ on
//! the way down and Λ on the way up.

use super::coated::CoatedMetal;
use super::fresnel::{Conductor, Reflecting, dielectric};
use super::microfacet::{Beckmann, Distribution, Ggx, Joint, Slopes, projected};
use super::rough_conductor::{self, RoughConductor};
use super::rough_dielectric::{self, RoughDielectric, Side, compression, held_off_one, reflected, refracted};
use super::{Bsdf, Character, Energy, Rgb, Sample, grey, rgb};
use crate::number::{Dice, F32x8, Mask, Number, Vector, exp, ln, ln_1p, vectorised};
use std::f64::consts::FRAC_1_PI;

/// Facets of some matter, with every bounce.
///
/// [`Bsdf::eval`] is an estimate: the first bounce is exact, the others are those of one walk, whose throws belong to the
/// two directions. [`Bsdf::pdf`] is a density to weigh strategies by, the same as [`Bsdf::sample`] gives: that of the first
/// bounce beside an even spread; what is drawn has no density in closed form.
#[derive(Clone, Copy, Debug)]
pub struct Walk<N, D, M> {
    facets: D,
    matter: M,
    /// The share [1] of the even spread in the density.
    spread: N,
}

/// Longer walks are cut: a share of 1e−9 even at α = 1.
const LONGEST: usize = 64;

/// What facets do to a ray.
pub trait Matter<N: Number>: Send + Sync + 'static {
    /// The model of one bounce.
    type Single<'m, D: Distribution<N>>: Bsdf<N>;

    /// The model of one bounce, its masking by heights.
    fn single<D: Distribution<N>>(&self, facets: D) -> Self::Single<'_, D>;

    /// The index [1] inside over that outside, by which light that goes through is bent.
    fn index(&self) -> N;

    /// Sends the ray on from a facet with w·m = `cos`; `u` decides where it can.
    fn scatter(&self, ray: Ray<N>, facet: Vector<N>, cos: N, u: N) -> Ray<N>;

    /// The density [sr⁻¹], times what is left of the light, with which a ray is sent to `wi`, seen from the ray's side:
    /// through the surface where the mask is true.
    fn phase<D: Distribution<N>>(&self, facets: &D, ray: &Ray<N>, through: N::Mask, wi: Vector<N>) -> Rgb<N>;
}

/// A walker among the facets, seen from the side on which it is.
#[derive(Clone, Copy, Debug)]
pub struct Ray<N: Number> {
    /// Where it goes.
    along: Vector<N>,
    /// τ [1]: 0 at the top, without bound below.
    depth: N,
    /// What is left of the light.
    weight: Rgb<N>,
    /// Whether it is on the other side than it began.
    is_through: N::Mask,
    /// The index of the other side over that of its own.
    eta: N,
}

impl<N: Number> Ray<N> {
    /// One that comes from `wo`.
    #[inline(always)]
    fn from(wo: Vector<N>, eta: N) -> Self {
        Self { along: -wo, depth: N::of(0.0), weight: grey(N::of(1.0)), is_through: N::Mask::of(false), eta }
    }

    /// To the next facet, or out where the mask that is returned is true.
    #[inline(always)]
    fn advanced(self, facets: &impl Distribution<N>, u: N) -> (Self, N::Mask) {
        let zero = N::of(0.0);
        let path = -ln(N::of(1.0) - u);
        let (z, hidden) = (self.along.z.abs(), facets.hidden(self.along));
        let is_down = self.along.z.lt(zero);
        let climb = path * z;
        let leaves = !is_down & climb.ge(self.depth * hidden);
        let rate = N::select(is_down, z + hidden, -hidden);
        let is_moving = rate.abs().gt(zero) & !leaves;
        let step = climb / N::select(is_moving, rate, N::of(1.0));
        // Only rounding can lift it above the top.
        (Self { depth: (self.depth + step.only(is_moving)).max(zero), ..self }, leaves)
    }

    /// The share [1] that gets out towards `wi`, above the surface, from where the ray is.
    #[inline(always)]
    fn escape(depth: N, facets: &impl Distribution<N>, wi: Vector<N>) -> N {
        exp(-(depth * facets.hidden(wi) / wi.z.abs()))
    }

    /// The depth of the same place from the other side: e^(−τ) + e^(−τ′) = 1.
    #[inline(always)]
    fn depth_beyond(&self) -> N {
        let one = N::of(1.0);
        // 1 − e^(−τ) by Kahan's quotient, and −ln of it where that is near 0.
        let gauss = exp(-self.depth);
        let is_steep = gauss.lt(N::of(0.5));
        let is_level = gauss.ge(one);
        let log = ln(N::select(is_steep | is_level, N::of(0.5), gauss));
        let less = N::select(is_level, self.depth, (gauss - one) * (self.depth / log));
        let less = less.max(N::of(f64::from(f32::MIN_POSITIVE)));
        N::select(is_steep, ln_1p(gauss / (one - gauss)), -ln(less))
    }

    #[inline(always)]
    fn select(mask: N::Mask, yes: Self, no: Self) -> Self {
        Self {
            along: Vector::select(mask, yes.along, no.along),
            depth: N::select(mask, yes.depth, no.depth),
            weight: rgb(|c| N::select(mask, yes.weight[c], no.weight[c])),
            is_through: (yes.is_through & mask) | (no.is_through & !mask),
            eta: N::select(mask, yes.eta, no.eta),
        }
    }
}

impl<N: Number, D: Distribution<N>, M: Matter<N>> Walk<N, D, M> {
    /// Facets of a matter.
    pub fn new(facets: D, matter: M) -> Self {
        // About the share of the light that bounces again.
        let [along, across] = facets.alpha();
        let rough = along * across;
        Self { facets, matter, spread: rough / (N::of(1.0) + N::of(0.5) * rough) }
    }

    /// Walks from `wo` above the surface until it is out, and shows each ray that has met `1 …` facets and goes to its next.
    #[inline(always)]
    fn run(
        &self,
        ray: Ray<N>,
        first: [N; 2],
        mut dice: Dice<N>,
        mut each: impl FnMut(usize, &Ray<N>, N::Mask),
    ) -> (Ray<N>, N::Mask) {
        let mut ray = ray;
        let mut is_in = N::Mask::of(true);
        for order in 0..LONGEST {
            let (there, leaves) = ray.advanced(&self.facets, dice.throw());
            is_in = is_in & !leaves;
            if !is_in.any() {
                break;
            }
            ray = Ray::select(is_in, there, ray);
            each(order, &ray, is_in);
            let u = if order == 0 { first } else { [dice.throw(), dice.throw()] };
            let back = -ray.along;
            let facet = self.facets.visible(back, u);
            let cos = back.dot(facet).max(N::of(0.0)).min(N::of(1.0));
            ray = Ray::select(is_in, self.matter.scatter(ray, facet, cos, dice.throw()), ray);
        }
        (ray, !is_in)
    }

    /// How many facets a walk from `wo` meets.
    #[inline(always)]
    pub fn bounces(&self, wo: Vector<N>, u: [N; 3]) -> N {
        let side = Side::of(wo, self.matter.index());
        let mut count = N::of(0.0);
        self.run(Ray::from(side.wo, side.eta), [u[0], u[1]], Dice::new(u[2], u[0] + u[1]), |_, _, is_in| {
            count = count + N::of(1.0).only(is_in);
        });
        count
    }

    #[inline(always)]
    fn density(&self, single: N, wi: Vector<N>) -> N {
        let sides = if self.character().transmits { 0.5 } else { 1.0 };
        single + self.spread * (N::of(sides * FRAC_1_PI) * wi.z.abs() - single)
    }

    #[inline(always)]
    fn single(&self) -> M::Single<'_, D> {
        self.matter.single(self.facets)
    }
}

impl<N: Number, D: Distribution<N>, M: Matter<N>> Bsdf<N> for Walk<N, D, M> {
    fn character(&self) -> Character {
        Character { is_stochastic: true, energy: Energy::Kept, ..self.single().character() }
    }

    #[inline(always)]
    fn eval_pdf(&self, wi: Vector<N>, wo: Vector<N>) -> (Rgb<N>, N) {
        let (first, single) = self.single().eval_pdf(wi, wo);
        let transmits = self.character().transmits;
        let is_asked = if transmits { N::Mask::of(true) } else { super::both_above(wi, wo) };
        let pdf = self.density(single, wi).only(is_asked);
        let Side { is_inside, wo, eta } = Side::of(wo, self.matter.index());
        let wi = wi.flipped(is_inside);
        let is_far = wi.z.lt(N::of(0.0));
        // Numbers that belong to the two directions, in proportions that have no common measure.
        let key = |a: f64, b: f64| wi.x * N::of(a) + wi.y * N::of(b) + wo.x * N::of(b * b) + wo.y * N::of(a * b);
        let mut dice = Dice::new(key(0.754_877_666, 0.569_840_290), key(0.819_172_513, -0.671_043_606));
        let first_facet = [dice.throw(), dice.throw()];
        let mut more = grey(N::of(0.0));
        let turned = wi.flipped(N::Mask::of(true));
        self.run(Ray::from(wo, eta), first_facet, dice, |order, ray, is_in| {
            if order > 0 {
                let wi = Vector::select(ray.is_through, turned, wi);
                let through = wi.z.lt(N::of(0.0));
                let depth = if transmits { N::select(through, ray.depth_beyond(), ray.depth) } else { ray.depth };
                let escape = Ray::escape(depth, &self.facets, wi).only(is_in);
                let phase = self.matter.phase(&self.facets, ray, through, wi);
                more = rgb(|c| more[c] + phase[c] * escape);
            }
        });
        let factor = compression(is_far, eta) / wi.z.abs();
        (rgb(|c| first[c] + (more[c] * factor).only(is_asked)), pdf)
    }

    #[inline(always)]
    fn sample(&self, wo: Vector<N>, u: [N; 3]) -> Sample<N> {
        let side = Side::of(wo, self.matter.index());
        let dice = Dice::new(u[2], u[0] + u[1]);
        let (ray, is_out) = self.run(Ray::from(side.wo, side.eta), [u[0], u[1]], dice, |_, _, _| ());
        let wi = ray.along.flipped(ray.is_through).flipped(side.is_inside);
        let compression = compression(ray.is_through, side.eta);
        let pdf = self.density(self.single().eval_pdf(wi, wo).1, wi);
        let may = if self.character().transmits { is_out } else { is_out & !side.is_inside };
        Sample {
            wi,
            weight: rgb(|c| ray.weight[c] * compression),
            pdf,
            is_delta: N::Mask::of(false),
            is_transmitted: ray.is_through,
            compression,
        }
        .only(may)
    }
}

/// The shares [1] of walks from the cosine `cos` over white facets that meet 1, 2 … of them; their standard errors are
/// √(p(1 − p)/`walks`).
pub fn orders(slopes: Slopes, alpha: f64, cos: f64, walks: usize) -> Vec<f64> {
    fn count<D: Distribution<F32x8>>(alpha: f64, cos: f64, walks: usize) -> Vec<f64> {
        let walk = Walk::new(D::new([F32x8::of(alpha); 2]), Conductor::perfect());
        let wo = Vector::of([((1.0 - cos) * (1.0 + cos)).sqrt(), 0.0, cos]);
        let mut shares = vec![0.0; LONGEST];
        for k in 0..walks.div_ceil(8) {
            let mut dice = Dice::new(F32x8::of(k as f64), F32x8::from_lanes(|lane| lane as f64));
            let bounces = vectorised(
                #[inline(always)]
                || walk.bounces(wo, [dice.throw(), dice.throw(), dice.throw()]),
            );
            for lane in 0..8 {
                shares[bounces.lane(lane) as usize - 1] += 1.0 / (8 * walks.div_ceil(8)) as f64;
            }
        }
        shares
    }
    match slopes {
        Slopes::Ggx => count::<Ggx<F32x8>>(alpha, cos, walks),
        Slopes::Beckmann => count::<Beckmann<F32x8>>(alpha, cos, walks),
    }
}

/// Metal: all of what is not absorbed goes back. Written once for what is bare and for what is under a film: a model for all
/// that reflects would shut out glass, which might.
macro_rules! metal {
    ($metal:ty) => {
        impl<N: Number> Matter<N> for $metal {
            type Single<'m, D: Distribution<N>> = RoughConductor<D, &'m Self>;

            fn single<D: Distribution<N>>(&self, facets: D) -> RoughConductor<D, &Self> {
                RoughConductor { facets, joint: Joint::Correlated, metal: self }
            }

            #[inline(always)]
            fn index(&self) -> N {
                N::of(1.0)
            }

            #[inline(always)]
            fn scatter(&self, ray: Ray<N>, facet: Vector<N>, cos: N, _: N) -> Ray<N> {
                let share = self.reflectance(cos);
                let weight = rgb(|c| ray.weight[c] * share[c]);
                Ray { along: reflected(-ray.along, facet, cos), weight, ..ray }
            }

            #[inline(always)]
            fn phase<D: Distribution<N>>(&self, facets: &D, ray: &Ray<N>, _: N::Mask, wi: Vector<N>) -> Rgb<N> {
                let back = -ray.along;
                let (half, cos) = rough_conductor::half_vector(wi, back);
                let seen = projected(facets, back).max(N::of(f64::from(f32::MIN_POSITIVE)));
                let density = N::of(0.25) * facets.density(half) / seen;
                let share = self.reflectance(cos);
                // A facet that looks down is none.
                let is_facet = half.z.gt(N::of(0.0));
                rgb(|c| (ray.weight[c] * share[c] * density).only(is_facet))
            }
        }
    };
}

metal!(Conductor<N>);
metal!(CoatedMetal);

/// Glass: light goes back or through with Fresnel's odds.
#[derive(Clone, Copy, Debug)]
pub struct Glass<N> {
    index: N,
}

impl<N: Number> Glass<N> {
    /// Of an index [1] inside over that outside, held off 1 by [`rough_dielectric::LEAST_CONTRAST`].
    pub fn new(index: N) -> Self {
        Self { index: held_off_one(index) }
    }
}

impl<N: Number> Matter<N> for Glass<N> {
    type Single<'m, D: Distribution<N>> = RoughDielectric<N, D>;

    fn single<D: Distribution<N>>(&self, facets: D) -> RoughDielectric<N, D> {
        RoughDielectric::new(facets, Joint::Correlated, self.index)
    }

    #[inline(always)]
    fn index(&self) -> N {
        self.index
    }

    #[inline(always)]
    fn scatter(&self, ray: Ray<N>, facet: Vector<N>, cos: N, u: N) -> Ray<N> {
        let there = dielectric(cos, ray.eta);
        let back = -ray.along;
        let stays = Ray { along: reflected(back, facet, cos), ..ray };
        let crosses = Ray {
            along: refracted(back, facet, cos, ray.eta, there).flipped(N::Mask::of(true)),
            depth: ray.depth_beyond(),
            is_through: !ray.is_through,
            eta: N::of(1.0) / ray.eta,
            ..ray
        };
        Ray::select(u.lt(there.reflectance), stays, crosses)
    }

    #[inline(always)]
    fn phase<D: Distribution<N>>(&self, facets: &D, ray: &Ray<N>, through: N::Mask, wi: Vector<N>) -> Rgb<N> {
        let density = rough_dielectric::phase(facets, ray.eta, through, wi, -ray.along);
        rgb(|c| ray.weight[c] * density)
    }
}
