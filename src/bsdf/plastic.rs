//! A diffuse body under a clear coat, smooth or rough: what the coat does not send back goes in, is scattered evenly, and
//! comes out or is sent back by the coat from below, as often as it takes.
//!
//! f = f_coat + T_i T_o ρ/(π n²(1 − ρ R̄)), with T = 1 − E_coat and R̄ what the coat sends back of even light from below: the
//! form of Mitsuba's `plastic` with `nonlinear` colours (W. Jakob, *Mitsuba documentation* (2014), §8.2.6). As even light
//! passes either way alike, n²(1 − R̄) = 1 − ⟨E_coat⟩: a white body returns all that its coat lets in, and f is the same both
//! ways. What a rough coat loses at one bounce goes to the body.

use super::fresnel::{Conductor, Reflecting};
use super::losses::Losses;
use super::microfacet::{Distribution, Joint};
use super::rough_conductor::RoughConductor;
use super::rules::fejer;
use super::smooth::SmoothConductor;
use super::{Bsdf, Character, Energy, Painted, Rgb, Sample, both_above, rgb};
use crate::number::{Number, Vector};
use crate::sampling::warp::cosine_hemisphere;
use std::f64::consts::{FRAC_1_PI, FRAC_PI_2, PI};

/// A coated body.
#[derive(Clone, Debug)]
pub struct Plastic<N, C> {
    coat: C,
    /// The coat's surface, as if polished.
    clear: Conductor<N>,
    /// 1 − E_coat/R, where the coat is rough.
    rough: Option<Losses>,
    /// 1 − ⟨E_coat⟩ [1].
    passed: N,
    /// 1 − R̄ [1].
    out: N,
    /// What comes out of the light that went in [1], over π(1 − ⟨E_coat⟩).
    body: Rgb<N>,
    largest_weight: f64,
}

/// The least share [1] of draws for either part.
const LEAST_SHARE: f64 = 0.25;

impl<N: Number> Plastic<N, SmoothConductor<Conductor<N>>> {
    /// A body of albedo ρ [1] under a polished coat of an index [1].
    pub fn smooth(albedo: [f64; 3], index: f64) -> Self {
        let clear = clear(index);
        Self::new(SmoothConductor { metal: clear }, clear, None, albedo, index)
    }
}

impl<N: Number, D: Distribution<N>> Plastic<N, RoughConductor<D, Conductor<N>>> {
    /// A body of albedo ρ [1] under a rough coat of an index [1].
    pub fn rough(facets: D, albedo: [f64; 3], index: f64) -> Self {
        let metal = clear(index);
        let alpha = [facets.alpha()[0].lane(0), facets.alpha()[1].lane(0)];
        let rough = Losses::coat(D::SLOPES, alpha, index);
        Self::new(RoughConductor { facets, joint: Joint::Correlated, metal }, metal, Some(rough), albedo, index)
    }
}

/// What does not absorb, as a metal whose κ is 0.
fn clear<N: Number>(index: f64) -> Conductor<N> {
    Conductor { n: [N::of(index); 3], k: [N::of(0.0); 3] }
}

/// E_coat [1] of `w`.
#[inline(always)]
fn returned<N: Number>(clear: &Conductor<N>, rough: Option<&Losses>, w: Vector<N>) -> N {
    let [smooth, ..] = clear.reflectance(w.z.abs().min(N::of(1.0)));
    match rough {
        None => smooth,
        Some(rough) => (smooth - smooth * rough.at(w)).max(N::of(0.0)).min(N::of(1.0)),
    }
}

impl<N: Number, C> Plastic<N, C> {
    fn new(coat: C, metal: Conductor<N>, rough: Option<Losses>, albedo: [f64; 3], index: f64) -> Self {
        let passed = 1.0 - mean(&clear(index), rough.as_ref());
        // ρ(1 − R̄)/(1 − ρ R̄).
        let out = passed / index.powi(2);
        let body = rgb(|c| N::of(FRAC_1_PI / passed * albedo[c] * out / (1.0 - albedo[c] * (1.0 - out))));
        let largest_weight = (1.0 / LEAST_SHARE).max(1.0 / ((1.0 - LEAST_SHARE) * passed));
        Self { coat, clear: metal, rough, passed: N::of(passed), out: N::of(out), body, largest_weight }
    }

    #[inline(always)]
    fn returned(&self, w: Vector<N>) -> N {
        returned(&self.clear, self.rough.as_ref(), w)
    }

    /// f of a body of which that comes out.
    #[inline(always)]
    fn body(&self, body: Rgb<N>, wi: Vector<N>, returned_o: N) -> Rgb<N> {
        let passed = (N::of(1.0) - self.returned(wi)) * (N::of(1.0) - returned_o);
        rgb(|c| body[c] * passed)
    }

    /// What comes out of a body of another ρ [1].
    #[inline(always)]
    fn painted(&self, rho: Rgb<N>) -> Rgb<N> {
        let one = N::of(1.0);
        rgb(|c| N::of(FRAC_1_PI) / self.passed * rho[c] * self.out / (one - rho[c] * (one - self.out)))
    }

    /// The share of draws that go to the coat.
    #[inline(always)]
    fn share(returned: N) -> N {
        returned.clamp(LEAST_SHARE, 1.0 - LEAST_SHARE)
    }
}

/// 2∫E_coat μ dμ [1], averaged over azimuths.
fn mean(clear: &Conductor<f64>, rough: Option<&Losses>) -> f64 {
    const AZIMUTHS: usize = 16;
    let around = |cos: f64| {
        let sin = ((1.0 - cos) * (1.0 + cos)).sqrt();
        let along = |k: usize| {
            let phi = FRAC_PI_2 * (k as f64 + 0.5) / AZIMUTHS as f64;
            returned(clear, rough, Vector::new(sin * phi.cos(), sin * phi.sin(), cos))
        };
        (0..AZIMUTHS).map(along).sum::<f64>() / AZIMUTHS as f64
    };
    // From the critical angle up where there is one; below it all is sent back. Bunched there, for R has a root.
    let critical = (1.0 - clear.n[0].powi(2)).max(0.0).sqrt();
    let part = |from: f64, to: f64| -> f64 {
        let node = |node: &super::rules::Node| {
            let (cos, slope) = (from + (to - from) * node.at * node.at, 2.0 * node.at * (to - from));
            node.weight * slope * 2.0 * cos * around(cos)
        };
        fejer(64).iter().map(node).sum()
    };
    part(0.0, critical) + part(critical, 1.0)
}

/// By what comes out of the body.
impl<N: Number, C: Bsdf<N>> Plastic<N, C> {
    #[inline(always)]
    fn eval_pdf_of(&self, body: Rgb<N>, wi: Vector<N>, wo: Vector<N>) -> (Rgb<N>, N) {
        let above = both_above(wi, wo);
        let (f, pdf) = self.coat.eval_pdf(wi, wo);
        let returned = self.returned(wo);
        let (body, share) = (self.body(body, wi, returned), Self::share(returned));
        let cosine = wi.z * N::of(FRAC_1_PI);
        (rgb(|c| (f[c] + body[c]).only(above)), (share * pdf + (N::of(1.0) - share) * cosine).only(above))
    }

    #[inline(always)]
    fn sample_of(&self, body: Rgb<N>, wo: Vector<N>, u: [N; 3]) -> Sample<N> {
        let (zero, one) = (N::of(0.0), N::of(1.0));
        let returned = self.returned(wo);
        let share = Self::share(returned);
        let is_coat = u[2].lt(share);
        let drawn = self.coat.sample(wo, u);
        let wi = Vector::select(is_coat, drawn.wi, cosine_hemisphere([u[0], u[1]]).0);
        let is_delta = drawn.is_delta & is_coat;
        let cosine = wi.z * N::of(FRAC_1_PI);
        let (f, density) = self.coat.eval_pdf(wi, wo);
        let pdf = share * N::select(is_coat, drawn.pdf, density) + (one - share) * cosine;
        let is_drawn = both_above(wi, wo) & (!is_coat | drawn.pdf.gt(zero));
        let over = one / N::select(is_drawn, pdf, one);
        let body = self.body(body, wi, returned);
        let weight = rgb(|c| {
            let coat = N::select(is_coat, drawn.weight[c] * drawn.pdf, f[c] * wi.z);
            let spread = ((coat + body[c] * wi.z) * over).only(is_drawn);
            N::select(is_delta, drawn.weight[c] / share, spread)
        });
        let pdf = N::select(is_delta, zero, pdf).only(is_drawn);
        Sample { weight, is_delta, ..Sample::reflected(wi, weight, pdf) }
    }
}

impl<N: Number, C: Bsdf<N>> Bsdf<N> for Plastic<N, C> {
    fn character(&self) -> Character {
        Character {
            has_delta: self.coat.character().is_delta,
            is_delta: false,
            largest_weight: self.largest_weight,
            energy: Energy::Kept,
            ..self.coat.character()
        }
    }

    #[inline(always)]
    fn eval_pdf(&self, wi: Vector<N>, wo: Vector<N>) -> (Rgb<N>, N) {
        self.eval_pdf_of(self.body, wi, wo)
    }

    #[inline(always)]
    fn sample(&self, wo: Vector<N>, u: [N; 3]) -> Sample<N> {
        self.sample_of(self.body, wo, u)
    }

    #[inline(always)]
    fn albedo(&self, wo: Vector<N>) -> Option<Rgb<N>> {
        let returned = self.returned(wo);
        let passed = N::of(1.0) - returned;
        let inverse = N::of(PI) * self.passed;
        let above = wo.z.gt(N::of(0.0));
        Some(rgb(|c| (returned + passed * self.body[c] * inverse).only(above)))
    }
}

impl<N: Number, C: Bsdf<N>> Painted<N> for Plastic<N, C> {
    #[inline(always)]
    fn painted_eval_pdf(&self, rho: Rgb<N>, wi: Vector<N>, wo: Vector<N>) -> (Rgb<N>, N) {
        self.eval_pdf_of(self.painted(rho), wi, wo)
    }

    #[inline(always)]
    fn painted_sample(&self, rho: Rgb<N>, wo: Vector<N>, u: [N; 3]) -> Sample<N> {
        self.sample_of(self.painted(rho), wo, u)
    }
}
