//! What a scene needs: by it integrators say whether they fit, and work is left out.

use crate::scene::{Material, Scene};

/// What a scene needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Needs {
    /// Lamps to send rays to.
    pub lamps: u32,
    /// Lights without a surface, which no path meets by chance.
    pub bare_lights: bool,
    /// Light from behind all shapes.
    pub environment: bool,
    /// Surfaces other than Lambert's.
    pub glossy: bool,
    /// Surfaces whose light has no choice of where to go.
    pub specular: bool,
    /// Surfaces that let light in.
    pub clear: bool,
    /// Matter that absorbs on the way.
    pub absorption: bool,
    /// A lens with an opening.
    pub lens: bool,
}

impl Needs {
    /// Of a scene.
    pub fn of(scene: &Scene) -> Self {
        let used = |test: &dyn Fn(&Material) -> bool| {
            scene.shapes.iter().any(|shape| scene.material(&shape.material).is_some_and(test))
        };
        let shining = scene.shapes.iter().filter(|shape| shape.emission.is_some_and(|e| e.radiance != [0.0; 3]));
        Self {
            lamps: (shining.count() + scene.lights.len()) as u32,
            bare_lights: !scene.lights.is_empty(),
            environment: scene.environment.is_some_and(|radiance| radiance != [0.0; 3]),
            glossy: used(&|material| !matches!(material, Material::Diffuse { .. })),
            specular: used(&Material::is_specular),
            clear: used(&Material::is_clear),
            absorption: used(&|material| material.absorption() != [0.0; 3]),
            lens: scene.camera.aperture > 0.0,
        }
    }
}
