//! Rough metal and glass of one bounce, and a second lobe for what that loses: white facets return all, f is the same both
//! ways, and it has a density. The lobe's shape is a guess, its colour nearly right: the [`super::walk`] tells by how much.
//!
//! C. Kulla and A. Conty, *Revisiting physically based shading at Imageworks*, SIGGRAPH course (2017): f = (1 − E_i)(1 − E_o)/
//! (π(1 − ⟨E⟩)), times ⟨F⟩²⟨E⟩/(1 − ⟨F⟩(1 − ⟨E⟩)) for metal (S. Hill's correction: light that is left after one bounce has
//! met two facets), or shared between both sides for glass.

use super::fresnel::Reflecting;
use super::losses::Losses;
use super::microfacet::{Distribution, Joint};
use super::rough_conductor::RoughConductor;
use super::rough_dielectric::{RoughDielectric, Side, compression, held_off_one};
use super::{Bsdf, Character, Energy, Rgb, Sample, grey, rgb};
use crate::number::{Mask, Number, Vector};
use crate::optics::fresnel::diffuse_reflectance;
use crate::sampling::warp::cosine_hemisphere;
use std::f64::consts::FRAC_1_PI;

/// A model of one bounce and the lobe that gives back what it loses.
#[derive(Clone, Debug)]
pub struct Compensated<N, S> {
    single: S,
    /// The index inside [1].
    index: N,
    outside: Lobe<N>,
    /// None for metal.
    inside: Option<Lobe<N>>,
}

/// What one side gives back.
#[derive(Clone, Debug)]
struct Lobe<N> {
    losses: Losses,
    /// The colour [1] of what goes back.
    back: Rgb<N>,
    /// The share [1] that comes from the other side.
    through: N,
}

impl<N: Number, D: Distribution<N>, M: Reflecting<N>> Compensated<N, RoughConductor<D, M>> {
    /// Metal, bare or under a film.
    pub fn metal(facets: D, metal: M) -> Self {
        let losses = Losses::metal(D::SLOPES, facets.alpha().map(|alpha| alpha.lane(0)));
        let back = metal.mean_reflectance().map(|mean| rebound(mean, N::of(losses.mean())));
        let outside = Lobe { losses, back, through: N::of(0.0) };
        let single = RoughConductor { facets, joint: Joint::Correlated, metal };
        Self { single, index: N::of(1.0), outside, inside: None }
    }
}

/// ⟨F⟩²⟨E⟩/(1 − ⟨F⟩(1 − ⟨E⟩)) [1]: what comes of the light that bounces again, if it forgets where it came from.
#[inline(always)]
pub fn rebound<N: Number>(reflectance: N, mean_loss: N) -> N {
    let one = N::of(1.0);
    reflectance.squared() * (one - mean_loss) / (one - reflectance * mean_loss)
}

/// How much comes back of light from everywhere, by three accounts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Returned {
    /// At one bounce [1].
    pub single: f64,
    /// With the second lobe [1].
    pub compensated: f64,
    /// By walks [1].
    pub walked: f64,
}

/// What facets return to `cos` that reflect the share `reflectance` [1] at any angle, if of walks over white ones the
/// shares [`super::walk::orders`] meet 1, 2 … facets: how wrong the second lobe's colour is.
pub fn returned(losses: &Losses, cos: f64, reflectance: f64, orders: &[f64]) -> Returned {
    let loss = losses.at(Vector::new(((1.0 - cos) * (1.0 + cos)).sqrt(), 0.0, cos)).max(0.0);
    let single = reflectance * (1.0 - loss);
    let walked = orders.iter().rev().fold(0.0, |sum, share| (sum + share) * reflectance);
    Returned { single, compensated: single + rebound(reflectance, losses.mean()) * loss, walked }
}

impl<N: Number, D: Distribution<N>> Compensated<N, RoughDielectric<N, D>> {
    /// Glass of an index [1] inside over that outside.
    pub fn glass(facets: D, index: N) -> Self {
        let n = held_off_one(index).lane(0);
        let [outside, inside] = Losses::glass(D::SLOPES, facets.alpha().map(|alpha| alpha.lane(0)), n);
        // Shares that make f n² the same both ways, as n²(1 − ⟨F⟩) is, and add up to 1.
        let passed = 1.0 - diffuse_reflectance(n.max(1.0 / n));
        let (rarer, denser) = (passed, passed / n.max(1.0 / n).powi(2));
        let passed = if n > 1.0 { [rarer, denser] } else { [denser, rarer] };
        let (out, within) = (passed[0] * inside.mean(), passed[1] * outside.mean());
        let share = if out + within > 0.0 { out / (out + within) } else { 0.5 };
        let lobe = |losses, through: f64| Lobe { losses, back: grey(N::of(1.0 - through)), through: N::of(through) };
        let single = RoughDielectric::new(facets, Joint::Correlated, index);
        Self { single, index: N::of(n), outside: lobe(outside, share), inside: Some(lobe(inside, 1.0 - share)) }
    }
}

impl<N: Number, S: Bsdf<N>> Compensated<N, S> {
    /// A choice between the two sides' numbers.
    #[inline(always)]
    fn of_side<T>(&self, is_inside: N::Mask, part: impl Fn(&Lobe<N>) -> T, select: impl Fn(N::Mask, T, T) -> T) -> T {
        match &self.inside {
            None => part(&self.outside),
            Some(inside) => select(is_inside, part(inside), part(&self.outside)),
        }
    }

    /// 1 − E of `w`, seen from its side, and its mean.
    #[inline(always)]
    fn loss(&self, w: Vector<N>) -> (N, N) {
        let is_inside = w.z.lt(N::of(0.0));
        self.of_side(
            is_inside,
            #[inline(always)]
            |lobe| (lobe.losses.at(w).max(N::of(0.0)), N::of(lobe.losses.mean())),
            #[inline(always)]
            |mask, yes, no| (N::select(mask, yes.0, no.0), N::select(mask, yes.1, no.1)),
        )
    }

    /// The share of `wo`'s lobe that comes through.
    #[inline(always)]
    fn through(&self, wo: Vector<N>) -> N {
        self.of_side(
            wo.z.lt(N::of(0.0)),
            #[inline(always)]
            |lobe| lobe.through,
            #[inline(always)]
            |mask, yes, no| N::select(mask, yes, no),
        )
    }

    /// Whether light can go from one to the other.
    #[inline(always)]
    fn joins(&self, wi: Vector<N>, wo: Vector<N>) -> N::Mask {
        if self.inside.is_some() { N::Mask::of(true) } else { super::both_above(wi, wo) }
    }

    /// Of the second lobe f |cos θ_i| over compression, and its density without the odds of its being chosen.
    #[inline(always)]
    fn second(&self, loss_o: N, wi: Vector<N>, wo: Vector<N>) -> (Rgb<N>, N) {
        let is_through = (wi.z * wo.z).lt(N::of(0.0));
        let (loss_i, mean) = self.loss(wi);
        let cosine = wi.z.abs() * N::of(FRAC_1_PI);
        let is_lossy = mean.gt(N::of(0.0));
        let shape = (loss_o * loss_i * cosine / N::select(is_lossy, mean, N::of(1.0))).only(is_lossy);
        let through = self.through(wo);
        let back = self.of_side(
            wo.z.lt(N::of(0.0)),
            #[inline(always)]
            |lobe| lobe.back,
            #[inline(always)]
            |mask, yes, no| rgb(|c| N::select(mask, yes[c], no[c])),
        );
        let odds = N::select(is_through, through, N::of(1.0) - through);
        (rgb(|c| shape * N::select(is_through, through, back[c])), odds * cosine)
    }
}

impl<N: Number, S: Bsdf<N>> Bsdf<N> for Compensated<N, S> {
    fn character(&self) -> Character {
        let mut largest_weight = 0.0_f64;
        let lobes = || std::iter::once(&self.outside).chain(&self.inside);
        for (here, there) in lobes().flat_map(|here| lobes().map(move |there| (here, there))) {
            let peak = if there.losses.mean() > 0.0 { there.losses.largest() / there.losses.mean() } else { 0.0 };
            largest_weight = largest_weight.max((1.0 + here.losses.largest()) * peak.max(1.0));
        }
        Character { largest_weight, energy: Energy::Kept, ..self.single.character() }
    }

    #[inline(always)]
    fn eval_pdf(&self, wi: Vector<N>, wo: Vector<N>) -> (Rgb<N>, N) {
        let is_asked = self.joins(wi, wo);
        let (f, pdf) = self.single.eval_pdf(wi, wo);
        let (loss, _) = self.loss(wo);
        let (second, density) = self.second(loss, wi, wo);
        let Side { is_inside, eta, .. } = Side::of(wo, self.index);
        let factor = compression(wi.flipped(is_inside).z.lt(N::of(0.0)), eta) / wi.z.abs();
        let pdf = (pdf + loss * density) / (N::of(1.0) + loss);
        (rgb(|c| (f[c] + second[c] * factor).only(is_asked)), pdf.only(is_asked))
    }

    /// By the facets that are seen, or, with odds of the loss to 1, by the cosine.
    #[inline(always)]
    fn sample(&self, wo: Vector<N>, u: [N; 3]) -> Sample<N> {
        let (zero, one) = (N::of(0.0), N::of(1.0));
        let (loss, _) = self.loss(wo);
        let choice = u[2] * (one + loss);
        let is_second = choice.ge(one);
        let single = self.single.sample(wo, [u[0], u[1], choice.min(N::of(1.0 - N::EPSILON))]);
        let rest = (choice - one) / N::select(loss.gt(zero), loss, one);
        let is_through = rest.lt(self.through(wo));
        let wi = cosine_hemisphere([u[0], u[1]]).0.flipped(wo.z.lt(zero)).flipped(is_through);
        let wi = Vector::select(is_second, wi, single.wi);
        // Of the first lobe's own draws value and density come from the facet, which knows them better.
        let Side { is_inside, eta, .. } = Side::of(wo, self.index);
        let is_transmitted = wi.flipped(is_inside).z.lt(zero);
        let compression = compression(is_transmitted, eta);
        // Few surfaces lose much: as a rule no lane asks what the first lobe has to say of the second one's draws.
        let (f, pdf) = if is_second.any() { self.single.eval_pdf(wi, wo) } else { (grey(zero), zero) };
        let (second, density) = self.second(loss, wi, wo);
        let first = N::select(is_second, pdf, single.pdf);
        let pdf = (first + loss * density) / (one + loss);
        let is_drawn = self.joins(wi, wo) & pdf.gt(zero) & (is_second | single.pdf.gt(zero));
        let over = one / N::select(is_drawn, pdf, one);
        let weight = rgb(|channel| {
            let carried = N::select(is_second, f[channel] * wi.z.abs(), single.weight[channel] * single.pdf);
            (carried + second[channel] * compression) * over
        });
        Sample { wi, weight, pdf, is_delta: N::Mask::of(false), is_transmitted, compression }.only(is_drawn)
    }
}
