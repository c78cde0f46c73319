//! Surfaces that scatter: how much of the light from one direction goes to another, each model once for every width of
//! [`Number`].
//!
//! z is the local normal, `wi` (where light comes from) and `wo` (where it goes) point away from the surface. f has no
//! cosine and is the one of radiance: into a medium of another index it carries that medium's n², so that
//! f(wi → wo)/n_o² = f(wo → wi)/n_i². Outside, z > 0, the index is 1.
//!
//! | model | file |
//! |---|---|
//! | Lambert; rough and diffuse | [`lambert`], [`oren_nayar`], [`eon`] |
//! | smooth: mirror, metal, glass | [`smooth`] |
//! | smooth metal and glass under a film | [`coated`] |
//! | smooth glass whose index depends on the wavelength | [`dispersive`] |
//! | slopes of a rough surface, what of them is visible | [`microfacet`] |
//! | rough metal, rough glass, one event | [`rough_conductor`], [`rough_dielectric`] |
//! | a diffuse body under a coat | [`plastic`] |
//! | the same with every bounce, as a walk | [`walk`] |
//! | one bounce, and a second lobe for what it loses | [`compensated`], with the tables of [`losses`] |
//! | what the first bounce returns | [`albedo`], with [`rules`] |
//! | what takes any input | [`guard`] |
//! | a ρ that differs from place to place | [`painted`] |

pub mod albedo;
#[cfg(any(test, feature = "references"))]
pub mod audit;
pub mod coated;
pub mod compensated;
pub mod dispersive;
pub mod eon;
pub mod fresnel;
pub mod guard;
pub mod lambert;
pub mod losses;
pub mod microfacet;
pub mod oren_nayar;
pub mod painted;
pub mod plastic;
pub mod rough_conductor;
pub mod rough_dielectric;
pub mod rules;
pub mod smooth;
#[cfg(test)]
mod tests;
pub mod walk;
mod zoo;

pub use guard::Guarded;
pub use painted::Painted;
pub use zoo::{Entry, INDEX, METAL_INDEX, Setting, zoo};

use crate::number::{Mask, Number, Vector};

/// Three spectral channels.
pub type Rgb<N> = [N; 3];

/// A direction drawn for light to come from.
#[derive(Clone, Copy, Debug)]
pub struct Sample<N: Number> {
    /// Where the light comes from.
    pub wi: Vector<N>,
    /// f·|cos θ_i|/pdf [1], of radiance; 0 where the draw was rejected. Of a delta its share, and for the walk what it
    /// carries.
    pub weight: Rgb<N>,
    /// Density [sr⁻¹] at the drawn facet; 0 for a delta and where rejected.
    pub pdf: N,
    /// Whether the direction had no choice.
    pub is_delta: N::Mask,
    /// Whether the light comes through.
    pub is_transmitted: N::Mask,
    /// (n_o/n_i)² [1], the factor that transmission puts on radiance, not on energy: weight/`compression` is a share of
    /// energy.
    pub compression: N,
}

impl<N: Number> Sample<N> {
    /// Nothing comes from anywhere.
    #[inline(always)]
    pub fn none(wo: Vector<N>) -> Self {
        Self {
            wi: wo,
            weight: grey(N::of(0.0)),
            pdf: N::of(0.0),
            is_delta: N::Mask::of(false),
            is_transmitted: N::Mask::of(false),
            compression: N::of(1.0),
        }
    }

    /// `yes` where the mask is true, `no` elsewhere.
    #[inline(always)]
    pub fn select(mask: N::Mask, yes: Self, no: Self) -> Self {
        let either = |yes: N::Mask, no: N::Mask| (mask & yes) | (!mask & no);
        Self {
            wi: Vector::select(mask, yes.wi, no.wi),
            weight: rgb(|c| N::select(mask, yes.weight[c], no.weight[c])),
            pdf: N::select(mask, yes.pdf, no.pdf),
            is_delta: either(yes.is_delta, no.is_delta),
            is_transmitted: either(yes.is_transmitted, no.is_transmitted),
            compression: N::select(mask, yes.compression, no.compression),
        }
    }

    /// A reflected direction of a density.
    #[inline(always)]
    fn reflected(wi: Vector<N>, weight: Rgb<N>, pdf: N) -> Self {
        Self { weight, pdf, ..Self::none(wi) }
    }

    /// The same where the mask is true, [`Sample::none`] elsewhere.
    #[inline(always)]
    fn only(self, mask: N::Mask) -> Self {
        Self { weight: rgb(|c| self.weight[c].only(mask)), pdf: self.pdf.only(mask), ..self }
    }
}

/// What a model is like, for those who judge it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Character {
    /// Whether light comes through.
    pub transmits: bool,
    /// Whether all its directions are deltas.
    pub is_delta: bool,
    /// Whether some are.
    pub has_delta: bool,
    /// Whether `eval` is an estimate that is right on average only, and `pdf` merely something like the density.
    pub is_stochastic: bool,
    /// The largest weight over compression that is proven [1]; infinite if none is.
    pub largest_weight: f64,
    /// The energy [1] it returns of what it is sent if nothing is absorbed: exactly 1 for models without loss, at most 1
    /// for those of one bounce, and above for the textbook's.
    pub energy: Energy,
}

/// What becomes of light on a surface that absorbs nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Energy {
    /// All of it returns.
    Kept,
    /// What would bounce again is lost.
    Lost,
    /// More than all may return.
    Gained,
}

/// A surface. Directions have length 1 and |z| > 0; [`Guarded`] takes anything.
pub trait Bsdf<N: Number>: Send + Sync {
    /// What it is like.
    fn character(&self) -> Character;

    /// f [sr⁻¹] without the cosine, deltas left out, and the density [sr⁻¹] with which [`Bsdf::sample`] draws `wi` if
    /// light goes to `wo`.
    fn eval_pdf(&self, wi: Vector<N>, wo: Vector<N>) -> (Rgb<N>, N);

    /// A direction for light that goes to `wo` to come from, from three numbers in 0 ≤ u < 1.
    fn sample(&self, wo: Vector<N>, u: [N; 3]) -> Sample<N>;

    /// f [sr⁻¹].
    fn eval(&self, wi: Vector<N>, wo: Vector<N>) -> Rgb<N> {
        self.eval_pdf(wi, wo).0
    }

    /// The density [sr⁻¹].
    fn pdf(&self, wi: Vector<N>, wo: Vector<N>) -> N {
        self.eval_pdf(wi, wo).1
    }

    /// The share [1] of light from everywhere that goes to `wo`, ∫f cos θ_i dω_i (radiance: over (n_o/n_i)² where it comes
    /// through), where the model knows it in closed form or from its tables.
    fn albedo(&self, _wo: Vector<N>) -> Option<Rgb<N>> {
        None
    }
}

/// By channel. An array's own `map` is a call, which would not know of the machine's wider instructions.
#[inline(always)]
pub fn rgb<N>(of: impl Fn(usize) -> N) -> Rgb<N> {
    [of(0), of(1), of(2)]
}

/// The same in all channels.
#[inline(always)]
pub fn grey<N: Number>(value: N) -> Rgb<N> {
    [value; 3]
}

/// Whether both are above the surface.
#[inline(always)]
fn both_above<N: Number>(wi: Vector<N>, wo: Vector<N>) -> N::Mask {
    wi.z.gt(N::of(0.0)) & wo.z.gt(N::of(0.0))
}
