//! One wavelength for every path, drawn at the eye: what glass does to light is then all that it does to this wavelength, and a
//! channel gets what it sees of it. The plainest way, and a wasteful one: paths that meet nothing that disperses are coloured for
//! nothing. The fast integrator draws a wavelength where it is needed ([`crate::bsdf::dispersive`]).

use super::lamps::from_lamps;
use super::{Numbers, carried, gathered};
use crate::bsdf::Rgb;
use crate::bsdf::dispersive::Hue;
use crate::colour::response::response;
use crate::geometry::Ray;
use crate::sampling::balance;
use crate::transport::Stage;

/// Vertices before a path may end by chance.
const PATIENCE: u32 = 6;

/// The radiance [W m⁻² sr⁻¹] that comes along a ray.
// ANCHOR: spectral
pub fn radiance(stage: &Stage<f64>, mut ray: Ray<f64>, numbers: &mut Numbers<'_>, depth: u32) -> Rgb<f64> {
    let drawn = response().draw(numbers.of_camera().wavelength);
    let mut hue = Hue::of(drawn.wavelength);
    let (mut light, mut carries) = ([0.0; 3], drawn.weight);
    let mut pdf = f64::INFINITY;
    let mut squeeze = 1.0;
    for edge in 1..=depth {
        let Some(vertex) = stage.meet(&ray) else {
            let weight = balance(pdf, stage.density_to_sky(&ray));
            return gathered(light, carries, stage.sky(&ray).map(|sky| sky * weight));
        };
        carries = carried(carries, vertex.clarity);
        // How densely rays to this lamp would have come here, against the density of the one that did.
        let weight = balance(pdf, stage.density_to(&ray, &vertex, true));
        light = gathered(light, carries, vertex.emitted().map(|emitted| emitted * weight));
        if edge == depth {
            break;
        }
        let row = numbers.of_next_vertex();
        light = gathered(light, carries, from_lamps(stage, &vertex, row.lamp, balance));
        let drawn = vertex.scatter_hued(&row, &mut hue);
        carries = carried(carries, drawn.weight);
        // A draw that failed has no density either.
        if carries == [0.0; 3] {
            break;
        }
        pdf = if drawn.is_delta { f64::INFINITY } else { drawn.pdf };
        squeeze *= drawn.compression;
        ray = stage.leave(&vertex, vertex.frame.outward(drawn.wi));
        // Whoever goes on stands for those who do not. Radiance that a medium squeezes is no more energy.
        let chance =
            if edge < PATIENCE { 1.0 } else { carries.into_iter().map(f64::abs).fold(0.0, f64::max) / squeeze };
        if row.survival >= chance {
            break;
        }
        carries = carries.map(|carries| carries / chance.min(1.0));
    }
    light
}
// ANCHOR_END: spectral
