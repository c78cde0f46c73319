//! Rays to lamps: at every vertex the light that comes straight from each of them, and one new ray for what comes by others.

use super::{Numbers, carried, gathered};
use crate::bsdf::{Rgb, rgb};
use crate::geometry::Ray;
use crate::transport::{Stage, Vertex};

// ANCHOR: lamps
/// What rays to the lamps bring to a vertex [W m⁻² sr⁻¹]. Each counts by a weight [1] of its density [sr⁻¹] and of that with which the
/// surface would have drawn the same direction.
pub(in crate::transport) fn from_lamps(
    stage: &Stage<f64>,
    vertex: &Vertex<'_, f64>,
    at: [f64; 2],
    weight: impl Fn(f64, f64) -> f64,
) -> Rgb<f64> {
    let mut light = [0.0; 3];
    for lamp in stage.lamps() {
        let arrival = lamp.sample(vertex.start, at);
        let wi = vertex.frame.inward(arrival.wi);
        let (f, by_chance) = vertex.f_pdf(wi);
        if f != [0.0; 3] && stage.sees(vertex, &arrival) {
            let share = wi.z.abs() * weight(arrival.pdf, by_chance);
            light = rgb(|c| light[c] + f[c] * arrival.share[c] * share);
        }
    }
    light
}

/// The radiance [W m⁻² sr⁻¹] that comes along a ray. A lamp that the new ray meets has been counted already, unless no ray
/// could be sent to it: from the camera, or where the direction had no choice.
pub fn radiance(stage: &Stage<f64>, mut ray: Ray<f64>, numbers: &mut Numbers<'_>, depth: u32) -> Rgb<f64> {
    let (mut light, mut carries) = ([0.0; 3], [1.0; 3]);
    let mut counts = true;
    for edge in 1..=depth {
        let Some(vertex) = stage.meet(&ray) else {
            // A sky to which rays are sent has been counted by them, too.
            let counts = counts || stage.density_to_sky(&ray) == 0.0;
            return if counts { gathered(light, carries, stage.sky(&ray)) } else { light };
        };
        carries = carried(carries, vertex.clarity);
        if counts {
            light = gathered(light, carries, vertex.emitted());
        }
        if edge < depth {
            let row = numbers.of_next_vertex();
            light = gathered(light, carries, from_lamps(stage, &vertex, row.lamp, |_, _| 1.0));
            let drawn = vertex.scatter(row.surface);
            carries = carried(carries, drawn.weight);
            counts = drawn.is_delta;
            ray = stage.leave(&vertex, vertex.frame.outward(drawn.wi));
        }
    }
    light
}
// ANCHOR_END: lamps
