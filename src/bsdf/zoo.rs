//! All the models: one more is a file and a line here.

use super::fresnel::Conductor;
use super::microfacet::{Beckmann, Distribution, Ggx, Joint};
use super::rough_conductor::RoughConductor;
use super::{Bsdf, Guarded, eon, lambert, oren_nayar, smooth};
use crate::number::Number;
use num_complex::Complex64;

/// What models are made from; each takes what it needs and holds it within what it can do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    /// Reflectance of diffuse bodies and plain mirrors [1], 0 … 1, in three channels.
    pub albedo: [f64; 3],
    /// Roughness along x and y [1]: the root mean square slope times √2 (Beckmann), or its namesake (GGX); 1e−4 … 1.
    pub alpha: [f64; 2],
    /// Roughness of diffuse bodies [1], 0 … 1.
    pub roughness: f64,
    /// Index of what is clear [1], over that outside.
    pub index: f64,
    /// Indices n + iκ of the metal [1], over that outside, in three channels.
    pub metal: [Complex64; 3],
}

impl Default for Setting {
    /// White, glass, and the metal that absorbs nothing.
    fn default() -> Self {
        Self { albedo: [1.0; 3], alpha: [0.3; 2], roughness: 0.5, index: 1.5, metal: [Complex64::I; 3] }
    }
}

/// x between the ends; the lower one if it is not a number.
fn within(x: f64, low: f64, high: f64) -> f64 {
    if x >= low { x.min(high) } else { low }
}

impl Setting {
    /// The nearest setting that models can be made from.
    pub fn held(self) -> Self {
        let part = |x: f64| within(x, 0.0, 1e3);
        Self {
            albedo: self.albedo.map(|albedo| within(albedo, 0.0, 1.0)),
            alpha: self.alpha.map(|alpha| within(alpha, 1e-4, 1.0)),
            roughness: within(self.roughness, 0.0, 1.0),
            index: within(self.index, 0.1, 10.0),
            metal: self.metal.map(|index| Complex64::new(part(index.re), part(index.im))),
        }
    }

    fn metal<N: Number>(&self) -> Conductor<N> {
        Conductor { n: self.metal.map(|index| N::of(index.re)), k: self.metal.map(|index| N::of(index.im)) }
    }
}

/// A model by name.
#[derive(Clone, Copy)]
pub struct Entry<N: Number> {
    /// Command-line word (`rough-conductor`).
    pub name: &'static str,
    /// What it is, in a few words.
    pub about: &'static str,
    make: fn(&Setting) -> Box<dyn Bsdf<N>>,
}

impl<N: Number> Entry<N> {
    /// The model, behind its gate.
    pub fn make(&self, setting: &Setting) -> Box<dyn Bsdf<N>> {
        (self.make)(&setting.held())
    }
}

/// Every model.
pub fn zoo<N: Number>() -> Vec<Entry<N>> {
    fn boxed<N: Number>(model: impl Bsdf<N> + 'static) -> Box<dyn Bsdf<N>> {
        Box::new(Guarded(model))
    }
    let entry = |name, about, make| Entry { name, about, make };
    vec![
        entry("lambert", "diffuse", |s| boxed(lambert::Lambert { albedo: s.albedo.map(N::of) })),
        entry("oren-nayar", "rough and diffuse, as textbooks have it", |s| {
            let sigma = N::of(s.roughness * std::f64::consts::FRAC_PI_2);
            boxed(oren_nayar::OrenNayar { albedo: s.albedo.map(N::of), sigma })
        }),
        entry("eon", "rough and diffuse, its energy kept", |s| {
            boxed(eon::Eon { albedo: s.albedo.map(N::of), roughness: N::of(s.roughness) })
        }),
        entry("mirror", "a plain mirror", |s| boxed(smooth::Mirror { reflectance: s.albedo.map(N::of) })),
        entry("conductor", "polished metal", |s| boxed(smooth::SmoothConductor { metal: s.metal() })),
        entry("dielectric", "polished glass", |s| boxed(smooth::SmoothDielectric { index: N::of(s.index) })),
        entry("rough-conductor", "rough metal, GGX", |s| boxed(rough_metal::<N, Ggx<N>>(s, Joint::Correlated))),
        entry("rough-conductor-beckmann", "rough metal, Gaussian slopes", |s| {
            boxed(rough_metal::<N, Beckmann<N>>(s, Joint::Correlated))
        }),
        entry("rough-conductor-separable", "rough metal, GGX, masked from each side by itself", |s| {
            boxed(rough_metal::<N, Ggx<N>>(s, Joint::Separable))
        }),
    ]
}

fn rough_metal<N: Number, D: Distribution<N>>(setting: &Setting, joint: Joint) -> RoughConductor<N, D> {
    RoughConductor { facets: D::new(setting.alpha.map(N::of)), joint, metal: setting.metal() }
}
