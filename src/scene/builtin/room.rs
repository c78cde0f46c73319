//! The Cornell box and what is made of it.
//!
//! Coordinates [m] after the data that Cornell's Program of Computer Graphics measured (*Cornell Box Data*, 1998), there in
//! millimetres and a tenth as large. The walls are made rectangles, as Mitsuba's and PBRT's are; so is the lamp 5 mm below
//! the ceiling. Each block's top was measured as four points that no parallelogram fits: its fourth corner, 3 mm off in the
//! short block and 1 in the tall one, follows from the others. Reflectances and the lamp's radiance are three-channel fits
//! to the measured spectra in the manner of PBRT's scenes.

use super::{BLACK, grey, lamp, pinhole, quad, scene, shape};
use crate::scene::triple::{minus, plus, times};
use crate::scene::{Geometry, Material, Scene, Shape, Triple};

/// Width, height and depth of the room [m].
const ROOM: Triple = [5.56, 5.488, 5.592];

/// Three corners of a block's top [m], seen from above clockwise from the camera's left.
type Top = [Triple; 3];
const SHORT: Top = [[1.30, 1.65, 0.65], [0.82, 1.65, 2.25], [2.40, 1.65, 2.72]];
#[expect(clippy::approx_constant, reason = "a corner's place, no circle's")]
const TALL: Top = [[4.23, 3.30, 2.47], [2.65, 3.30, 2.96], [3.14, 3.30, 4.56]];

/// The Cornell box: sixteen quads.
pub(super) fn cornell() -> Scene {
    let blocks = [SHORT, TALL].into_iter().flat_map(block).map(|geometry| shape(geometry, "white"));
    room("cornell", blocks)
}

/// The box, without its blocks, with a mirror and a ball of glass.
pub(super) fn glass() -> Scene {
    let ball = |center, material| shape(Geometry::Sphere { center, radius: 1.0 }, material);
    let mut glass = room("glass", [ball([3.9, 1.0, 3.7], "mirror"), ball([1.7, 1.0, 1.9], "glass")]);
    let mirror = Material::Mirror { reflectance: [1.0; 3] };
    let clear = Material::Dielectric { ior: 1.5, outside: 1.0, absorption: [0.0; 3], coating: None };
    glass.materials.extend([("mirror".to_owned(), mirror), ("glass".to_owned(), clear)]);
    glass
}

/// The box [m] away from the origin.
pub(super) fn far() -> Scene {
    let by = [1e6, -1e6, 1e6];
    Scene { name: "far".into(), ..placed(cornell(), |point| plus(point, by)) }
}

/// The box so many times as large.
pub(super) fn tiny() -> Scene {
    Scene { name: "tiny".into(), ..placed(cornell(), |point| times(point, 1e-6)) }
}

/// A room of quads, moved point by point.
fn placed(scene: Scene, place: impl Fn(Triple) -> Triple) -> Scene {
    let mut placed = scene;
    for point in [&mut placed.camera.origin, &mut placed.camera.target] {
        *point = place(*point);
    }
    for shape in &mut placed.shapes {
        if let Geometry::Quad { vertices } = &mut shape.geometry {
            *vertices = vertices.map(&place);
        }
    }
    placed
}

/// The room with its lamp, and what stands in it.
fn room(name: &str, inside: impl IntoIterator<Item = Shape>) -> Scene {
    let [width, height, depth] = ROOM;
    let [x, y, z] = [[width, 0.0, 0.0], [0.0, height, 0.0], [0.0, 0.0, depth]];
    let origin = [0.0; 3];
    // All normals point inward. Seen by the camera, x goes left.
    let walls = [
        (quad(origin, z, x), "white"),
        (quad(y, x, z), "white"),
        (quad(z, y, x), "white"),
        (quad(x, z, y), "red"),
        (quad(origin, y, z), "green"),
    ];
    // Not in the ceiling: of two surfaces in one place, rounding would choose.
    let light = quad([2.13, 5.483, 2.27], [1.30, 0.0, 0.0], [0.0, 0.0, 1.05]);
    let walls = walls.into_iter().map(|(geometry, material)| shape(geometry, material));
    let shapes = walls.chain([lamp(light, [17.0, 12.0, 4.0])]).chain(inside);
    let materials = vec![
        ("white", grey(0.73)),
        ("red", Material::Diffuse { reflectance: [0.63, 0.065, 0.05] }),
        ("green", Material::Diffuse { reflectance: [0.14, 0.45, 0.091] }),
        BLACK,
    ];
    scene(name, pinhole([2.78, 2.73, -8.0], [2.78, 2.73, 0.0], 39.3), materials, shapes.collect())
}

/// The top and the four sides of a block that stands on the floor, their normals outward.
fn block([a, b, c]: Top) -> Vec<Geometry> {
    let down = [0.0, -a[1], 0.0];
    let (along, across) = (minus(b, a), minus(c, b));
    let side = |corner, edge| quad(corner, edge, down);
    vec![
        quad(a, along, across),
        side(b, times(along, -1.0)),
        side(c, times(across, -1.0)),
        side(plus(a, across), along),
        side(a, across),
    ]
}
