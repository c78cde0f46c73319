//! All the models: one more is a file and a line here.

use super::coated::{CoatedDielectric, CoatedMetal, Film};
use super::compensated::Compensated;
use super::eon::Eon;
use super::fresnel::Conductor;
use super::lambert::Lambert;
use super::microfacet::{Beckmann, Distribution, Ggx, Joint, Slopes};
use super::painted::Painted;
use super::plastic::Plastic;
use super::rough_conductor::RoughConductor;
use super::rough_dielectric::RoughDielectric;
use super::walk::{Glass, Walk};
use super::{Bsdf, Character, Guarded, Rgb, Sample, oren_nayar, smooth};
use crate::number::{Number, Vector, vectorised_lanes};
use num_complex::Complex64;

/// What models are made from; each takes what it needs and holds it within what it can do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    /// Reflectance of diffuse bodies and plain mirrors [1], 0 … 1, in three channels.
    pub albedo: [f64; 3],
    /// Roughness along x and y [1]: the root mean square slope times √2 (Beckmann), or its namesake (GGX); 1e−4 … 1.
    pub alpha: [f64; 2],
    /// How slopes are distributed.
    pub slopes: Slopes,
    /// How masking from two sides goes together.
    pub joint: Joint,
    /// Roughness of diffuse bodies [1], 0 … 1.
    pub roughness: f64,
    /// Index of what is clear [1], over that outside.
    pub index: f64,
    /// Indices n + iκ of the metal [1], over that outside, in three channels.
    pub metal: [Complex64; 3],
    /// A film on metal, or on polished glass.
    pub film: Option<Film>,
}

impl Default for Setting {
    /// White, glass, and the metal that absorbs nothing.
    fn default() -> Self {
        Self {
            albedo: [1.0; 3],
            alpha: [0.3; 2],
            slopes: Slopes::Ggx,
            joint: Joint::Correlated,
            roughness: 0.5,
            index: 1.5,
            metal: [Complex64::I; 3],
            film: None,
        }
    }
}

/// Ends of the index [1] of what is clear, over that outside.
pub const INDEX: [f64; 2] = [0.1, 10.0];

/// Ends of n and κ [1] of a metal, over the index outside.
pub const METAL_INDEX: [f64; 2] = [0.0, 1e3];

/// The least n [1] of a film, over the index outside, and its largest thickness [m]: a film of a centimetre is a pane.
const LEAST_FILM: f64 = 1e-3;
const THICKEST: f64 = 1e-2;

/// x between the ends; the lower one if it is not a number.
fn within(x: f64, low: f64, high: f64) -> f64 {
    if x >= low { x.min(high) } else { low }
}

impl Setting {
    /// The nearest setting that models can be made from.
    pub fn held(self) -> Self {
        let part = |x: f64| within(x, METAL_INDEX[0], METAL_INDEX[1]);
        let film = self.film.map(|Film { index, thickness }| Film {
            index: index.map(|index| Complex64::new(within(index.re, LEAST_FILM, METAL_INDEX[1]), part(index.im))),
            thickness: within(thickness, 0.0, THICKEST),
        });
        Self {
            albedo: self.albedo.map(|albedo| within(albedo, 0.0, 1.0)),
            alpha: self.alpha.map(|alpha| within(alpha, 1e-4, 1.0)),
            roughness: within(self.roughness, 0.0, 1.0),
            index: within(self.index, INDEX[0], INDEX[1]),
            metal: self.metal.map(|index| Complex64::new(part(index.re), part(index.im))),
            film,
            ..self
        }
    }

    fn metal<N: Number>(&self) -> Conductor<N> {
        Conductor { n: self.metal.map(|index| N::of(index.re)), k: self.metal.map(|index| N::of(index.im)) }
    }
}

/// Makes a model.
type Make<M> = fn(&Setting) -> Box<M>;

/// A model by name.
#[derive(Clone, Copy)]
pub struct Entry<N: Number> {
    /// Command-line word (`rough-conductor`).
    pub name: &'static str,
    /// What it is, in a few words.
    pub about: &'static str,
    make: Make<dyn Bsdf<N>>,
    paint: Option<Make<dyn Painted<N>>>,
}

impl<N: Number> Entry<N> {
    /// The model, behind its gate.
    pub fn make(&self, setting: &Setting) -> Box<dyn Bsdf<N>> {
        (self.make)(&setting.held())
    }

    /// The model where ρ is that of the place, behind its gate; `None` if it has none.
    pub fn make_painted(&self, setting: &Setting) -> Option<Box<dyn Painted<N>>> {
        self.paint.map(|paint| paint(&setting.held()))
    }

    fn painted(self, paint: Make<dyn Painted<N>>) -> Self {
        Self { paint: Some(paint), ..self }
    }
}

fn boxed<N: Number>(model: impl Bsdf<N> + 'static) -> Box<dyn Bsdf<N>> {
    match N::LANES {
        1 => Box::new(Guarded(model)),
        _ => Box::new(Dispatched(Guarded(model))),
    }
}

fn painted<N: Number>(model: impl Bsdf<N> + Painted<N> + 'static) -> Box<dyn Painted<N>> {
    match N::LANES {
        1 => Box::new(Guarded(model)),
        _ => Box::new(Dispatched(Guarded(model))),
    }
}

/// A model whose every call runs with the widest instructions there are: a call through a pointer is not inlined into one
/// that does already.
struct Dispatched<M>(M);

impl<N: Number, M: Bsdf<N>> Bsdf<N> for Dispatched<M> {
    fn character(&self) -> Character {
        self.0.character()
    }

    fn eval_pdf(&self, wi: Vector<N>, wo: Vector<N>) -> (Rgb<N>, N) {
        vectorised_lanes::<N, _>(
            #[inline(always)]
            || self.0.eval_pdf(wi, wo),
        )
    }

    fn sample(&self, wo: Vector<N>, u: [N; 3]) -> Sample<N> {
        vectorised_lanes::<N, _>(
            #[inline(always)]
            || self.0.sample(wo, u),
        )
    }

    fn albedo(&self, wo: Vector<N>) -> Option<Rgb<N>> {
        vectorised_lanes::<N, _>(
            #[inline(always)]
            || self.0.albedo(wo),
        )
    }
}

impl<N: Number, M: Painted<N>> Painted<N> for Dispatched<M> {
    fn painted_eval_pdf(&self, rho: Rgb<N>, wi: Vector<N>, wo: Vector<N>) -> (Rgb<N>, N) {
        vectorised_lanes::<N, _>(
            #[inline(always)]
            || self.0.painted_eval_pdf(rho, wi, wo),
        )
    }

    fn painted_sample(&self, rho: Rgb<N>, wo: Vector<N>, u: [N; 3]) -> Sample<N> {
        vectorised_lanes::<N, _>(
            #[inline(always)]
            || self.0.painted_sample(rho, wo, u),
        )
    }
}

/// A model of facets whose slopes are distributed as the setting says.
macro_rules! with_facets {
    ($setting:ident, $facets:ident => $model:expr) => {
        with_facets!($setting, $facets => $model, boxed)
    };
    ($setting:ident, $facets:ident => $model:expr, $boxed:ident) => {
        match $setting.slopes {
            Slopes::Ggx => {
                let $facets = Ggx::new($setting.alpha.map(N::of));
                $boxed($model)
            }
            Slopes::Beckmann => {
                let $facets = Beckmann::new($setting.alpha.map(N::of));
                $boxed($model)
            }
        }
    };
}

fn lambert<N: Number>(of: &Setting) -> Lambert<N> {
    Lambert { albedo: of.albedo.map(N::of) }
}

fn eon<N: Number>(of: &Setting) -> Eon<N> {
    Eon { albedo: of.albedo.map(N::of), roughness: N::of(of.roughness) }
}

/// Every model.
pub fn zoo<N: Number>() -> Vec<Entry<N>> {
    let entry = |name, about, make| Entry { name, about, make, paint: None };
    vec![
        entry("lambert", "diffuse", |s| boxed(lambert(s))).painted(|s| painted(lambert(s))),
        entry("oren-nayar", "rough and diffuse, as textbooks have it", |s| {
            let sigma = N::of(s.roughness * std::f64::consts::FRAC_PI_2);
            boxed(oren_nayar::OrenNayar { albedo: s.albedo.map(N::of), sigma })
        }),
        entry("eon", "rough and diffuse, its energy kept", |s| boxed(eon(s))).painted(|s| painted(eon(s))),
        entry("mirror", "a plain mirror", |s| boxed(smooth::Mirror { reflectance: s.albedo.map(N::of) })),
        entry("conductor", "polished metal", |s| match &s.film {
            Some(film) => boxed(smooth::SmoothConductor { metal: CoatedMetal::new(film, s.metal) }),
            None => boxed(smooth::SmoothConductor { metal: s.metal::<N>() }),
        }),
        entry("dielectric", "polished glass", |s| match &s.film {
            Some(film) => boxed(CoatedDielectric::new(film, s.index)),
            None => boxed(smooth::SmoothDielectric { index: N::of(s.index) }),
        }),
        entry("rough-conductor", "rough metal, one bounce", |s| {
            let joint = s.joint;
            match &s.film {
                Some(film) => {
                    let metal = CoatedMetal::new(film, s.metal);
                    with_facets!(s, facets => RoughConductor { facets, joint, metal })
                }
                None => with_facets!(s, facets => RoughConductor { facets, joint, metal: s.metal::<N>() }),
            }
        }),
        entry(
            "rough-dielectric",
            "rough glass, one event",
            |s| with_facets!(s, facets => RoughDielectric::new(facets, s.joint, N::of(s.index))),
        ),
        entry("plastic", "a diffuse body under a polished coat", |s| boxed(Plastic::smooth(s.albedo, s.index)))
            .painted(|s| painted(Plastic::smooth(s.albedo, s.index))),
        entry(
            "rough-plastic",
            "a diffuse body under a rough coat",
            |s| with_facets!(s, facets => Plastic::rough(facets, s.albedo, s.index)),
        )
        .painted(|s| with_facets!(s, facets => Plastic::rough(facets, s.albedo, s.index), painted)),
        entry("conductor-walk", "rough metal, every bounce walked", |s| match &s.film {
            Some(film) => {
                let metal = CoatedMetal::new(film, s.metal);
                with_facets!(s, facets => Walk::new(facets, metal))
            }
            None => with_facets!(s, facets => Walk::new(facets, s.metal::<N>())),
        }),
        entry(
            "dielectric-walk",
            "rough glass, every event walked",
            |s| with_facets!(s, facets => Walk::new(facets, Glass::new(N::of(s.index)))),
        ),
        entry("conductor-compensated", "rough metal, what one bounce loses given back", |s| match &s.film {
            Some(film) => {
                let metal = CoatedMetal::new(film, s.metal);
                with_facets!(s, facets => Compensated::metal(facets, metal))
            }
            None => with_facets!(s, facets => Compensated::metal(facets, s.metal::<N>())),
        }),
        entry(
            "dielectric-compensated",
            "rough glass, what one event loses given back",
            |s| with_facets!(s, facets => Compensated::glass(facets, N::of(s.index))),
        ),
    ]
}
