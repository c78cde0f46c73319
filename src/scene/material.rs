//! What surfaces are made of.

use super::{Flaw, Pattern, Triple};
use crate::bsdf::microfacet::{Joint, Slopes};
use crate::colour::response::BAND;
use crate::media::{self, Substance};
use num_complex::Complex64;

/// Glass whose index depends on the wavelength.
#[derive(Clone, Debug, PartialEq)]
pub enum Glass {
    /// By its name in [`media`]: one of [`glasses`].
    Named(String),
    /// By two numbers ([`media::cauchy`]).
    Abbe {
        /// Index at the d line [1].
        ior: f64,
        /// Abbe's number [1].
        abbe: f64,
    },
}

impl Glass {
    /// Its index [1] at a vacuum wavelength [m].
    ///
    /// # Errors
    /// If there is no medium of that name, or it is not known there.
    pub fn index(&self, wavelength: f64) -> Result<f64, Flaw> {
        match self {
            Self::Named(name) => {
                let medium =
                    media::named(name).ok_or_else(|| Flaw::of("glass", format!("`{name}` is no known medium")))?;
                let index = medium.index(wavelength).map_err(|error| Flaw::of("glass", error.to_string()))?;
                Ok(index.re)
            }
            Self::Abbe { ior, abbe } => Ok(media::cauchy(*ior, *abbe, wavelength)),
        }
    }
}

/// A material. What is opaque reflects on both of its sides, but for [`Material::Plastic`], whose back is black.
#[derive(Clone, Debug, PartialEq)]
pub enum Material {
    /// Lambert's.
    Diffuse {
        /// ρ [1], 0 … 1.
        reflectance: Triple,
    },
    /// Rough and diffuse (EON).
    RoughDiffuse {
        /// ρ [1], 0 … 1.
        reflectance: Triple,
        /// [1], 0 … 1.
        roughness: f64,
    },
    /// A mirror that is the same at every angle.
    Mirror {
        /// [1], 0 … 1.
        reflectance: Triple,
    },
    /// Polished metal.
    Conductor {
        /// Which.
        metal: Metal,
        /// A film upon it.
        coating: Option<Coating>,
    },
    /// Rough metal.
    RoughConductor {
        /// Which.
        metal: Metal,
        /// How its facets lie.
        facets: Facets,
        /// How masking from two sides goes together.
        masking: Joint,
        /// What becomes of light that meets several facets.
        energy: Energy,
        /// A film upon it.
        coating: Option<Coating>,
    },
    /// Polished glass.
    Dielectric {
        /// Index inside [1].
        ior: f64,
        /// Index outside [1].
        outside: f64,
        /// Absorption inside [m⁻¹]; radiance falls as e^(−aℓ).
        absorption: Triple,
        /// A film upon it.
        coating: Option<Coating>,
    },
    /// Polished glass whose index depends on the wavelength.
    Dispersive {
        /// Which.
        glass: Glass,
        /// Index outside [1].
        outside: f64,
        /// Absorption inside [m⁻¹].
        absorption: Triple,
    },
    /// Rough glass.
    RoughDielectric {
        /// Index inside [1].
        ior: f64,
        /// Index outside [1].
        outside: f64,
        /// Absorption inside [m⁻¹].
        absorption: Triple,
        /// How its facets lie.
        facets: Facets,
        /// What becomes of light that meets several facets.
        energy: Energy,
    },
    /// A diffuse body under a clear coat.
    Plastic {
        /// The coat's index [1].
        ior: f64,
        /// ρ of the body [1], 0 … 1.
        reflectance: Triple,
        /// Roughness [1] of the coat; None is polished.
        alpha: Option<f64>,
    },
    /// One of [`Material::Diffuse`], [`Material::RoughDiffuse`] and [`Material::Plastic`] whose ρ changes from place to place.
    Patterned {
        /// Which, with the mean of ρ.
        of: Box<Material>,
        /// ρ.
        pattern: Pattern,
    },
}

impl Material {
    /// The same, its ρ from place to place; None if there is no ρ to be drawn.
    pub fn patterned(mut self, pattern: Pattern) -> Option<Self> {
        match &mut self {
            Self::Diffuse { reflectance }
            | Self::RoughDiffuse { reflectance, .. }
            | Self::Plastic { reflectance, .. } => {
                *reflectance = pattern.mean();
            }
            _ => return None,
        }
        Some(Self::Patterned { of: Box::new(self), pattern })
    }

    /// What it is without its pattern.
    pub fn base(&self) -> &Self {
        match self {
            Self::Patterned { of, .. } => of,
            _ => self,
        }
    }

    /// Its pattern.
    pub fn pattern(&self) -> Option<&Pattern> {
        match self {
            Self::Patterned { pattern, .. } => Some(pattern),
            _ => None,
        }
    }
}

/// Of what a conductor is made.
#[derive(Clone, Debug, PartialEq)]
pub enum Metal {
    /// By its name in [`media`], at [`media::CHANNELS`]: one of [`metals`].
    Named(String),
    /// By channel.
    Indices {
        /// n [1].
        eta: Triple,
        /// κ [1].
        k: Triple,
    },
}

/// How the facets of a rough surface lie.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facets {
    /// Roughness along the surface's two axes [1].
    pub alpha: [f64; 2],
    /// How slopes are distributed.
    pub slopes: Slopes,
}

/// What becomes of light that meets several facets.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Energy {
    /// A second lobe gives it back.
    #[default]
    Compensated,
    /// It is lost.
    Single,
    /// It is walked.
    Walk,
}

impl Energy {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Compensated, Self::Single, Self::Walk];

    /// Its word in a scene file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Compensated => "compensated",
            Self::Single => "single",
            Self::Walk => "walk",
        }
    }
}

/// The least κ [1] of a metal: what is clear has 1e−7 and less, what shines 1 and more.
const METALLIC: f64 = 0.5;

/// The media that are metals at [`media::CHANNELS`].
pub fn metals() -> impl Iterator<Item = &'static Substance> {
    let shines = |known: &Substance| known.colour().is_ok_and(|index| index.iter().all(|index| index.im > METALLIC));
    media::optical().filter(move |known| shines(known))
}

/// The media that films are made of: all that are known at [`media::CHANNELS`].
pub fn films() -> impl Iterator<Item = &'static Substance> {
    media::optical().filter(|known| known.colour().is_ok())
}

/// The most κ [1] of what is clear: a millimetre of it takes a hundredth. And the least n [1] of a body that can be seen.
const CLEAR: f64 = 1e-6;
const SOLID: f64 = 1.01;

/// The media that dispersing bodies are made of: clear, and known at all wavelengths that are seen.
pub fn glasses() -> impl Iterator<Item = &'static Substance> {
    let is_clear = |index: Complex64| index.im < CLEAR && index.re > SOLID;
    media::optical().filter(move |medium| BAND.iter().all(|end| medium.index(*end).is_ok_and(is_clear)))
}

/// A film of a named medium.
#[derive(Clone, Debug, PartialEq)]
pub struct Coating {
    /// Its name in [`media`]: one of [`films`].
    pub medium: String,
    /// [nm].
    pub thickness_nm: f64,
}
