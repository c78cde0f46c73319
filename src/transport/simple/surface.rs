//! Directions as the surface scatters: a diffuse one by their cosine, a mirror in its one.

use super::{Numbers, carried, gathered};
use crate::bsdf::Rgb;
use crate::geometry::Ray;
use crate::transport::Stage;

/// The radiance [W m⁻² sr⁻¹] that comes along a ray; cosine and density are in the weight that the surface gives.
// ANCHOR: surface
pub fn radiance(stage: &Stage<f64>, mut ray: Ray<f64>, numbers: &mut Numbers<'_>, depth: u32) -> Rgb<f64> {
    let (mut light, mut carries) = ([0.0; 3], [1.0; 3]);
    for edge in 1..=depth {
        let Some(vertex) = stage.meet(&ray) else {
            return gathered(light, carries, stage.sky(&ray));
        };
        carries = carried(carries, vertex.clarity);
        light = gathered(light, carries, vertex.emitted());
        if edge < depth {
            let drawn = vertex.scatter(numbers.of_next_vertex().surface);
            carries = carried(carries, drawn.weight);
            ray = stage.leave(&vertex, vertex.frame.outward(drawn.wi));
        }
    }
    light
}
// ANCHOR_END: surface
