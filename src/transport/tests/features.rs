//! What the camera sees of surfaces, without any light.

use super::*;
use crate::transport::Feature;

#[test]
fn a_pixel_is_as_far_as_what_its_rays_meet() {
    // A wall whose end runs along the middle of one column of two; so narrow a view that all of it is as far.
    let half = 3.0 * 5e-4_f64.to_radians().tan();
    let end = -half / 2.0;
    let wall = quad([[-1.0, -1.0, 3.0], [end, -1.0, 3.0], [end, 1.0, 3.0], [-1.0, 1.0, 3.0]]);
    let camera = looking([0.0; 3], [0.0, 0.0, 1.0], 1e-3, 2);
    let world = scene(camera, 2, vec![diffuse("wall", [0.5; 3])], vec![shape(wall, "wall")]);
    let renderer = Renderer::new(&world, &Manner::default(), 1).expect("a scene without a flaw");
    let features = renderer.features(0..2);
    let (seen, nothing): (Vec<Feature>, Vec<Feature>) =
        features.iter().partition(|feature| feature.distance.is_finite());
    assert!(seen.len() == 2 && nothing.len() == 2, "{features:?}");
    for feature in seen {
        // Of the rays that meet it the distance, of all rays the normal and the albedo.
        assert!((feature.distance - 3.0).abs() < 1e-4, "{feature:?}");
        assert!((-0.75..-0.25).contains(&feature.normal[2]) && (0.1..0.4).contains(&feature.albedo[0]), "{feature:?}");
    }
    assert!(nothing.iter().all(|one| one.distance == f32::INFINITY && one.normal == [0.0; 3]), "{features:?}");
}
