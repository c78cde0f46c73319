//! Where the answer is known: everything has the same radiance.

use super::{grey, pinhole, scene, shape};
use crate::bsdf::microfacet::{Joint, Slopes};
use crate::scene::{Emission, Energy, Environment, Facets, Geometry, Material, Metal, Scene, Shape};

/// What absorbs nothing: metal with ε = −1.
fn white() -> Metal {
    Metal::Indices { eta: [0.0; 3], k: [1.0; 3] }
}

/// A ball of each kind of material, none of which absorbs, under a sky of radiance 1: whatever comes back is 1. Paths have
/// no end but the sky.
pub(super) fn furnace() -> Scene {
    let facets = |alpha, slopes| Facets { alpha, slopes };
    let smooth = facets([0.2; 2], Slopes::Ggx);
    let (ior, outside, absorption) = (1.5, 1.0, [0.0; 3]);
    let masking = Joint::Correlated;
    let metal = |facets, energy| Material::RoughConductor { metal: white(), facets, masking, energy, coating: None };
    let glass = |facets, energy| Material::RoughDielectric { ior, outside, absorption, facets, energy };
    let rough = facets([0.5, 0.1], Slopes::Beckmann);
    let materials = vec![
        ("diffuse", grey(1.0)),
        ("rough_diffuse", Material::RoughDiffuse { reflectance: [1.0; 3], roughness: 1.0 }),
        ("mirror", Material::Mirror { reflectance: [1.0; 3] }),
        ("conductor", Material::Conductor { metal: white(), coating: None }),
        ("rough_conductor", metal(smooth, Energy::Compensated)),
        ("walked_conductor", metal(rough, Energy::Walk)),
        ("dielectric", Material::Dielectric { ior, outside, absorption, coating: None }),
        ("rough_dielectric", glass(smooth, Energy::Compensated)),
        ("walked_dielectric", glass(rough, Energy::Walk)),
        ("plastic", Material::Plastic { ior, reflectance: [1.0; 3], alpha: None }),
        ("rough_plastic", Material::Plastic { ior, reflectance: [1.0; 3], alpha: Some(0.3) }),
    ];
    // Rows of four, apart.
    let ball = |(at, (name, _)): (usize, &(&str, Material))| {
        let (column, row) = ((at % 4) as f64, (at / 4) as f64);
        let center = [2.5 * (1.5 - column), 2.5 * (1.0 - row), 0.0];
        shape(Geometry::Sphere { center, radius: 1.0 }, name)
    };
    let balls = materials.iter().enumerate().map(ball).collect();
    let made = scene("furnace", pinhole([0.0, 0.0, -16.0], [0.0; 3], 36.0), materials, balls);
    Scene { max_depth: None, environment: Some(Environment::Constant([1.0; 3])), ..made }
}

/// The inside of a sphere that sends out radiance 1 and reflects half: ∑ρᵏ = 1/(1 − ρ) = 2 from everywhere, and of paths of
/// at most d edges (1 − ρᵈ)/(1 − ρ). Three channels, three ρ.
pub(super) fn enclosure() -> Scene {
    let wall = Shape {
        emission: Some(Emission { radiance: [1.0; 3], two_sided: true }),
        ..shape(Geometry::Sphere { center: [0.0; 3], radius: 1.0 }, "wall")
    };
    let wall_of = Material::Diffuse { reflectance: [0.5, 0.75, 0.25] };
    // Off the middle, where all directions would be the normal.
    let camera = pinhole([0.1, 0.2, -0.7], [0.0; 3], 90.0);
    Scene { max_depth: None, ..scene("enclosure", camera, vec![("wall", wall_of)], vec![wall]) }
}
