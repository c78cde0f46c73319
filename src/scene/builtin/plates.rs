//! After figure 9.2 of Veach, *Robust Monte Carlo Methods for Light Transport Simulation* (1997): plates that show the same
//! lamps, sharp to blurred. A small lamp in a rough plate is found by sampling the lamp, a large one in a smooth plate by
//! sampling the plate, and no single way finds all.

use super::{BLACK, grey, lamp, pinhole, quad, scene, shape};
use crate::bsdf::microfacet::{Joint, Slopes};
use crate::scene::triple::{cross, minus, normalised, plus, times};
use crate::scene::{Energy, Facets, Geometry, Material, Metal, Scene, Triple};

/// Roughness of the plates [1], from the one in front.
const ROUGHNESS: [(&str, f64); 4] = [("smooth", 0.005), ("satin", 0.02), ("brushed", 0.05), ("rough", 0.1)];
/// Radii of the lamps [m] from left to right, and what each sends per channel [W].
const RADII: [f64; 4] = [0.9, 0.3, 0.1, 0.033_333_333_333_333_33];
const POWER: f64 = 160.0;

/// Each plate mirrors the middle of the lamps into the camera.
pub(super) fn veach() -> Scene {
    let (eye, lamps) = ([0.0, 2.0, 15.0], [0.0, 0.0, 0.0]);
    // From the camera's left, which is −x, to its right.
    let balls = RADII.iter().enumerate().map(|(at, radius)| {
        let center = plus(lamps, [2.5 * (at as f64 - 1.5), 0.0, 0.0]);
        lamp(Geometry::Sphere { center, radius: *radius }, [radiance(POWER, *radius); 3])
    });
    let centers = [[0.0, -4.0, 3.8], [0.0, -3.65, 2.4], [0.0, -3.1, 1.1], [0.0, -2.4, -0.1]];
    let plates = ROUGHNESS.iter().zip(centers).map(|((name, _), center)| shape(plate(center, eye, lamps), name));
    let floor = quad([-12.0, -4.6, -4.0], [0.0, 0.0, 22.0], [24.0, 0.0, 0.0]);
    let wall = quad([-12.0, -4.6, -4.0], [24.0, 0.0, 0.0], [0.0, 16.0, 0.0]);
    let shapes = balls.chain(plates).chain([floor, wall].map(|geometry| shape(geometry, "grey"))).collect();
    let metal = |alpha| Material::RoughConductor {
        metal: Metal::Named("aluminium".into()),
        facets: Facets { alpha: [alpha; 2], slopes: Slopes::Ggx },
        masking: Joint::Correlated,
        energy: Energy::Compensated,
        coating: None,
    };
    let metals = ROUGHNESS.iter().map(|(name, alpha)| (*name, metal(*alpha)));
    let materials = metals.chain([("grey", grey(0.4)), BLACK]).collect();
    scene("veach", pinhole(eye, [0.0, -1.6, 2.0], 38.0), materials, shapes)
}

/// The radiance [W m⁻² sr⁻¹] of a ball that sends out `power` [W]: π L over 4π r².
fn radiance(power: f64, radius: f64) -> f64 {
    use std::f64::consts::PI;
    power / (4.0 * PI * PI * radius * radius)
}

/// A plate 8 m wide whose normal halves the angle between what sees it and what it shows.
fn plate(center: Triple, eye: Triple, shown: Triple) -> Geometry {
    let towards = |what| normalised(minus(what, center));
    let normal = normalised(plus(towards(eye), towards(shown)));
    let across = [8.0, 0.0, 0.0];
    let along = normalised(cross(normal, across));
    let corner = minus(center, times(plus(across, along), 0.5));
    quad(corner, across, along)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Shape;
    use crate::scene::triple::dot;

    #[test]
    fn a_plate_shows_the_camera_the_lamps() {
        let Scene { shapes, camera, .. } = veach();
        let plates = shapes.iter().filter_map(|Shape { geometry, emission, material, .. }| match geometry {
            Geometry::Quad { vertices } if emission.is_none() && material != "grey" => Some(*vertices),
            _ => None,
        });
        let mut count = 0;
        for [a, b, c, d] in plates {
            let (center, normal) = (times(plus(a, c), 0.5), normalised(cross(minus(b, a), minus(d, a))));
            let out = normalised(minus(camera.origin, center));
            let mirrored = minus(times(normal, 2.0 * dot(normal, out)), out);
            // The lamps' middle is the origin.
            let way = normalised(times(center, -1.0));
            assert!(dot(normal, out) > 0.0 && dot(mirrored, way) > 1.0 - 1e-12, "{center:?}");
            count += 1;
        }
        assert_eq!(count, ROUGHNESS.len());
    }
}
