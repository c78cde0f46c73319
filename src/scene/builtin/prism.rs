//! Newton's experiment: a slit, a prism on a white table, and a screen.
//!
//! A small lamp at the end of a black tunnel shines through a slit. The prism stands so that the light of the d line goes through it along its
//! base, where it is bent least (2 arcsin(n sin ½A) − A with the angle A of its edge), and the screen is where that light goes.
//! Lamp and slit are so narrow that a wavelength's image is about a tenth of the rainbow.

use super::{BLACK, grey, lamp, pinhole, quad, scene, shape};
use crate::bsdf::dispersive::D_LINE;
use crate::media;
use crate::optics::prism::{deviation, least_deviation};
use crate::scene::triple::{minus, plus, times};
use crate::scene::{Environment, Geometry, Glass, Material, Mesh, Normals, Scene, Triple};
use std::f64::consts::FRAC_PI_3;
use std::sync::Arc;

/// Of which glass, and the angle of its edge.
const GLASS: &str = "sf11";
const APEX: f64 = FRAC_PI_3;
/// Side and height of the prism [m].
const SIDE: f64 = 0.04;
const HEIGHT: f64 = 0.05;
/// Where the lamp is, how high, and its radius [m]; light goes along x.
const LAMP: f64 = -0.42;
const LEVEL: f64 = 0.02;
const RADIUS: f64 = 0.0015;
/// Where the slit is, and half its width [m].
const SLIT: f64 = -0.05;
const HALF: f64 = 0.0015;
/// How far behind the prism the screen is [m].
const SCREEN: f64 = 0.6;

/// The prism's cross-section on the table: its first face's middle is the origin.
fn section(n: f64) -> [Triple; 3] {
    let half = 0.5 * least_deviation(APEX, n).unwrap_or_default();
    // Along the way within the glass, and towards the edge.
    let (base, edge) = ([half.cos(), 0.0, -half.sin()], [half.sin(), 0.0, half.cos()]);
    let tall = SIDE * (APEX / 2.0).cos();
    let at = |x: f64, z: f64| plus(plus(times(base, x), times(edge, z)), [0.0, 1e-4, 0.0]);
    let middle = at(-SIDE / 4.0, tall / 2.0);
    [at(-SIDE / 2.0, 0.0), at(SIDE / 2.0, 0.0), at(0.0, tall)].map(|corner| {
        let [x, _, z] = minus(corner, middle);
        [x, 1e-4, z]
    })
}

/// The index [1] of the prism at a vacuum wavelength [m] that is seen.
fn index(wavelength: f64) -> f64 {
    media::named(GLASS).and_then(|glass| glass.index(wavelength).ok()).map_or(1.5, |index| index.re)
}

/// Where on the screen, along x [m], light of a wavelength [m] that is seen falls that goes through the slit's middle: by Snell's
/// law at both faces.
pub fn on_screen(wavelength: f64) -> Option<f64> {
    let theta = 0.5 * (least_deviation(APEX, index(D_LINE))? + APEX);
    let half = theta - APEX / 2.0;
    let bent = deviation(theta, APEX, index(wavelength))?;
    // In the plane of x and z: along the base and towards the edge, of which the d line goes along the first.
    let (base, edge) = ([half.cos(), -half.sin()], [half.sin(), half.cos()]);
    let along = |x: f64, z: f64| [base[0] * x + edge[0] * z, base[1] * x + edge[1] * z];
    let (sin, cos) = (APEX / 2.0).sin_cos();
    let turned = (theta.sin() / index(wavelength)).asin() - APEX / 2.0;
    let inside = along(turned.cos(), turned.sin());
    let normal = along(cos, sin);
    let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
    let way = dot(along(SIDE / 2.0, 0.0), normal) / dot(inside, normal);
    let [x, z] = inside.map(|part| part * way);
    Some(x + (z + SCREEN) / bent.tan())
}

/// Beams of a lamp, a rainbow, and what is needed for it.
pub(super) fn prism() -> Scene {
    let mesh = Arc::new(Mesh::prism(section(index(D_LINE)), [0.0, HEIGHT, 0.0]));
    let wedge = Geometry::Mesh { file: None, normals: Normals::Flat, mesh };
    // A tunnel from behind the lamp to the slit, through which alone light gets out.
    let (back, wide, tall) = (LAMP - 0.01, 0.02, 0.05);
    let plate = |at: f64, [left, right]: [f64; 2]| quad([at, 0.0, left], [0.0, tall, 0.0], [0.0, 0.0, right - left]);
    let side = |z: f64| quad([back, 0.0, z], [SLIT - back, 0.0, 0.0], [0.0, tall, 0.0]);
    let lid = quad([back, tall, -wide], [0.0, 0.0, 2.0 * wide], [SLIT - back, 0.0, 0.0]);
    let tunnel = [
        plate(SLIT, [-wide, -HALF]),
        plate(SLIT, [HALF, wide]),
        plate(back, [-wide, wide]),
        side(-wide),
        side(wide),
        lid,
    ];
    let table = quad([-2.0, 0.0, -2.0], [0.0, 0.0, 4.0], [4.0, 0.0, 0.0]);
    let screen = quad([-0.1, 0.0, -SCREEN], [0.7, 0.0, 0.0], [0.0, 0.16, 0.0]);
    let bulb = Geometry::Disc { center: [LAMP, LEVEL, 0.0], normal: [1.0, 0.0, 0.0], radius: RADIUS };
    let shapes = [shape(wedge, "glass"), lamp(bulb, [1e6; 3]), shape(table, "table"), shape(screen, "white")]
        .into_iter()
        .chain(tunnel.map(|side| shape(side, "tunnel")))
        .collect();
    let glass = Material::Dispersive { glass: Glass::Named(GLASS.to_owned()), outside: 1.0, absorption: [0.0; 3] };
    let materials = vec![("glass", glass), ("table", grey(0.6)), ("white", grey(0.8)), ("tunnel", grey(0.05)), BLACK];
    let camera = pinhole([0.08, 0.5, 0.55], [0.08, 0.0, -0.27], 36.0);
    Scene { environment: Some(Environment::Constant([0.04; 3])), ..scene("prism", camera, materials, shapes) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bsdf::dispersive::Hue;
    use crate::geometry::{Ray, Structure};
    use crate::number::Vector;
    use crate::sampling::Row;
    use crate::transport::Stage;

    #[test]
    fn rays_of_every_wavelength_meet_the_screen_where_it_is_said() {
        // From the lamp's middle along x, through the triangles of the prism as the renderer has them.
        let scene = prism();
        let stage = Stage::<f64>::new(&scene, Structure::Best).expect("a scene of the lecture");
        let eye = scene.camera.origin;
        for wavelength in [400e-9, 450e-9, 500e-9, 550e-9, D_LINE, 650e-9, 700e-9] {
            let start = minus([LAMP + 0.02, LEVEL, 0.0], eye);
            let mut ray =
                Ray { origin: Vector::of(times(start, stage.scale())), direction: Vector::of([1.0, 0.0, 0.0]) };
            let mut hue = Hue::of(wavelength);
            for _ in 0..2 {
                let vertex = stage.meet(&ray).expect("the prism");
                assert!(!vertex.met.is_lambert(), "nothing is in the way");
                let row = Row::of([0.5, 0.5, 0.5, 0.5, 1.0 - 1e-9, 0.5, 0.5, 0.5]);
                let drawn = vertex.scatter_hued(&row, &mut hue);
                assert!(drawn.is_transmitted);
                ray = stage.leave(&vertex, vertex.frame.outward(drawn.wi));
            }
            if wavelength == D_LINE {
                let bent = least_deviation(APEX, index(D_LINE)).expect("light gets through");
                let found = (-ray.direction.z).atan2(ray.direction.x);
                assert!((found - bent).abs() < 1e-6, "{found} against {bent}");
            }
            let vertex = stage.meet(&ray).expect("the screen");
            assert!(vertex.met.is_lambert() && (vertex.met.paint()[0] - 0.8).abs() < 1e-6);
            let x = vertex.surface.point.x / stage.scale() + eye[0];
            let said = on_screen(wavelength).expect("it gets through");
            // Corners of meshes are kept in single numbers.
            assert!((x - said).abs() < 2e-6, "{wavelength:e}: {x} against {said}");
        }
    }
}
