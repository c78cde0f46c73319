//! Rays to lamps: at every vertex the light that comes straight from each of them, and one new ray for what comes by others.

use super::{Numbers, carried, gathered};
use crate::bsdf::{Rgb, rgb};
use crate::geometry::Ray;
use crate::transport::Stage;

/// The radiance [W m⁻² sr⁻¹] that comes along a ray. A lamp that the new ray meets has been counted already, unless no ray
/// could be sent to it: from the camera, or where the direction had no choice.
// ANCHOR: lamps
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
            for lamp in stage.lamps() {
                let arrival = lamp.sample(vertex.start, row.lamp);
                let wi = vertex.frame.inward(arrival.wi);
                let f = vertex.f(wi);
                if f != [0.0; 3] && stage.sees(&vertex, &arrival) {
                    light = gathered(light, carries, rgb(|c| f[c] * wi.z.abs() * arrival.share[c]));
                }
            }
            let drawn = vertex.scatter(row.surface);
            carries = carried(carries, drawn.weight);
            counts = drawn.is_delta;
            ray = stage.leave(&vertex, vertex.frame.outward(drawn.wi));
        }
    }
    light
}
// ANCHOR_END: lamps
