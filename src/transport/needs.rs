//! What a scene needs: by it integrators say whether they fit, and work is left out.

use crate::scene::{Environment, Material, Scene};

/// What a scene needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Needs {
    /// Lamps to send rays to; a sky that is an image is one.
    pub lamps: u32,
    /// Lights without a surface, which no path meets by chance.
    pub bare_lights: bool,
    /// Lamps with one, whose rims a picture may show.
    pub rims: bool,
    /// Light from behind all shapes.
    pub environment: bool,
    /// That of an image, to which rays are sent as to a lamp.
    pub panorama: bool,
    /// Surfaces other than Lambert's.
    pub glossy: bool,
    /// Surfaces whose light has no choice of where to go.
    pub specular: bool,
    /// Surfaces that cast a lamp's light, gathered, on others.
    pub casters: bool,
    /// Surfaces that let light in.
    pub clear: bool,
    /// Matter that absorbs on the way.
    pub absorption: bool,
    /// Glass whose index depends on the wavelength.
    pub wavelength: bool,
    /// Reflectances that change from place to place.
    pub patterns: bool,
    /// A filter before the camera.
    pub polariser: bool,
    /// Surfaces of which it is not known what they do to polarised light.
    pub scalar: bool,
    /// A lens with an opening.
    pub lens: bool,
    /// A hierarchy of boxes; a [`super::Stage`] knows.
    pub hierarchy: bool,
    /// Primitives that no shadow test has to look at, as a [`super::Stage`] has found.
    pub walls: u32,
    /// Paths from lamps by way of those that cast it, as a [`super::Stage`] has found.
    pub light_paths: bool,
}

/// Work that a picture does without.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LeftOut {
    /// Which.
    pub what: &'static str,
    /// The reason.
    pub why: &'static str,
    /// What does it all the same; None where there is nothing to be done.
    pub needless: Option<Needless>,
}

/// Work that is done although the scene may not need it: the same picture, later.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Needless {
    /// A hierarchy of boxes, however few the shapes.
    pub hierarchy: bool,
    /// Shadow tests of what has everything on one side.
    pub walls: bool,
    /// Light from a sky, black where there is none.
    pub sky: bool,
    /// Models of surfaces, Lambert's too.
    pub models: bool,
    /// Looking in every pixel for a mirror, glass or the rim of a lamp.
    pub looks: bool,
    /// Absorption on the way, through air too.
    pub absorption: bool,
    /// Places on a lens, whose opening may have no size.
    pub lens: bool,
    /// Wavelengths, although every index is one number.
    pub wavelengths: bool,
}

impl Needless {
    /// None of it.
    pub const NOTHING: Self = Self {
        hierarchy: false,
        walls: false,
        sky: false,
        models: false,
        looks: false,
        absorption: false,
        lens: false,
        wavelengths: false,
    };
    /// All of it.
    pub const EVERYTHING: Self = Self {
        hierarchy: true,
        walls: true,
        sky: true,
        models: true,
        looks: true,
        absorption: true,
        lens: true,
        wavelengths: true,
    };
}

impl Needs {
    /// Of a scene, before anyone has looked at where its shapes are.
    pub fn of(scene: &Scene) -> Self {
        let used = |test: &dyn Fn(&Material) -> bool| {
            scene.shapes.iter().any(|shape| scene.material(&shape.material).is_some_and(test))
        };
        let shining =
            scene.shapes.iter().filter(|shape| shape.emission.is_some_and(|e| e.radiance != [0.0; 3])).count();
        let sky = scene.environment.as_ref().filter(|sky| !sky.is_black());
        let panorama = matches!(sky, Some(Environment::Image(_)));
        Self {
            lamps: (shining + scene.lights.len() + usize::from(panorama)) as u32,
            bare_lights: !scene.lights.is_empty(),
            rims: shining > 0,
            environment: sky.is_some(),
            panorama,
            glossy: used(&|material| !matches!(material.base(), Material::Diffuse { .. })),
            specular: used(&Material::is_specular),
            casters: used(&Material::casts),
            clear: used(&Material::is_clear),
            absorption: used(&|material| material.absorption() != [0.0; 3]),
            wavelength: used(&Material::disperses),
            patterns: used(&|material| material.pattern().is_some()),
            polariser: scene.camera.polariser_deg.is_some(),
            scalar: used(&|material| !material.is_polarising()),
            lens: scene.camera.aperture > 0.0,
            hierarchy: true,
            walls: 0,
            light_paths: false,
        }
    }

    /// What the fast integrator leaves out of a picture that needs this, and why.
    pub fn left_out(&self) -> Vec<LeftOut> {
        let light_paths = if self.casters {
            "no lamp has a surface, or a lens or a wide filter shows a place in many pixels"
        } else {
            "nothing is polished enough to cast a lamp's light on anything"
        };
        let none = Needless::NOTHING;
        let all = [
            (
                !self.hierarchy,
                "hierarchy of boxes",
                "of so few shapes trying all is faster",
                Some(Needless { hierarchy: true, ..none }),
            ),
            (
                self.walls > 0,
                "shadow tests of walls",
                "all there is lies on one side of them",
                Some(Needless { walls: true, ..none }),
            ),
            (!self.light_paths, "paths from lamps", light_paths, None),
            (self.lamps < 2, "choice among lamps", "there are not two of them", None),
            (!self.environment, "light from the sky", "it is black", Some(Needless { sky: true, ..none })),
            (
                self.environment && !self.panorama,
                "rays to the sky",
                "it is the same all around: directions by the surface do better",
                None,
            ),
            (
                !self.glossy,
                "models of surfaces",
                "all scatter as Lambert's does",
                Some(Needless { models: true, ..none }),
            ),
            (
                !self.specular && !self.rims,
                "more samples where a mirror, glass or the rim of a lamp is seen",
                "there is none",
                Some(Needless { looks: true, ..none }),
            ),
            (
                !self.absorption,
                "absorption on the way",
                "nothing clear absorbs",
                Some(Needless { absorption: true, ..none }),
            ),
            (
                !self.wavelength,
                "wavelengths",
                "no glass disperses: three channels go the same ways",
                Some(Needless { wavelengths: true, ..none }),
            ),
            (!self.patterns, "places on images", "every reflectance is the same all over its shape", None),
            (
                !self.polariser,
                "polarisation",
                "no filter is before the camera, and light is taken for natural wherever it is reflected",
                None,
            ),
            (!self.lens, "places on the lens", "it is a pinhole", Some(Needless { lens: true, ..none })),
        ];
        let left_out = all.into_iter().filter(|(is_left_out, ..)| *is_left_out);
        left_out.map(|(_, what, why, needless)| LeftOut { what, why, needless }).collect()
    }
}
