//! The lecture's own: from every vertex one new ray, its direction as likely as any other, until the path is long enough.

use super::{Numbers, carried, gathered};
use crate::bsdf::{Rgb, rgb};
use crate::geometry::Ray;
use crate::sampling::warp::uniform_hemisphere;
use crate::transport::Stage;

/// The radiance [W m⁻² sr⁻¹] that comes along a ray, by E51 with one direction for all: f L cos θ over its density 1/2π.
// ANCHOR: hemisphere
pub fn radiance(stage: &Stage<f64>, mut ray: Ray<f64>, numbers: &mut Numbers<'_>, depth: u32) -> Rgb<f64> {
    let (mut light, mut carries) = ([0.0; 3], [1.0; 3]);
    for edge in 1..=depth {
        let Some(vertex) = stage.meet(&ray) else {
            return gathered(light, carries, stage.sky(&ray));
        };
        light = gathered(light, carries, vertex.emitted());
        if edge < depth {
            let [u, v, _] = numbers.of_next_vertex().surface;
            let (wi, pdf) = uniform_hemisphere([u, v]);
            let f = vertex.f(wi);
            carries = carried(carries, rgb(|c| f[c] * wi.z / pdf));
            ray = stage.leave(&vertex, vertex.frame.outward(wi));
        }
    }
    light
}
// ANCHOR_END: hemisphere
