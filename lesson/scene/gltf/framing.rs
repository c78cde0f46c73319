//! A camera for files that have none.

use super::HEIGHT;
use light::scene::{Camera, Geometry, Shape, Triple};

/// Its angle [deg].
const FOV_Y_DEG: f64 = 40.0;

/// A camera before all shapes, a little from above.
pub fn camera(shapes: &[Shape]) -> Camera {
    let corners = shapes.iter().flat_map(|shape| match &shape.geometry {
        Geometry::Mesh { mesh, .. } => &mesh.positions[..],
        _ => &[],
    });
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for corner in corners {
        for axis in 0..3 {
            low[axis] = low[axis].min(f64::from(corner[axis]));
            high[axis] = high[axis].max(f64::from(corner[axis]));
        }
    }
    if low[0] > high[0] {
        (low, high) = ([-1.0; 3], [1.0; 3]);
    }
    let middle: Triple = std::array::from_fn(|axis| 0.5 * (low[axis] + high[axis]));
    let radius = 0.5 * (0..3).map(|axis| (high[axis] - low[axis]).powi(2)).sum::<f64>().sqrt();
    // The ball about it touches the picture's edges.
    let distance = radius.max(1e-6) / (FOV_Y_DEG.to_radians() / 2.0).sin();
    let way = [0.4, 0.3, 1.0];
    let length = way.iter().map(|part: &f64| part * part).sum::<f64>().sqrt();
    Camera {
        origin: std::array::from_fn(|axis| middle[axis] + distance * way[axis] / length),
        target: middle,
        up: Camera::UP,
        fov_y_deg: FOV_Y_DEG,
        width: HEIGHT,
        height: HEIGHT,
        aperture: 0.0,
        focus: None,
        polariser_deg: None,
    }
}
