//! The rooms of the chapter, by patches and as scenes.

use crate::figure::Picture;
use crate::path_tracing::scenes::{greens, rendered};
use light::radiosity::{Face, Light, Network, Patch, Patches, Room, limit, solve};
use light::scene::{Camera, Emission, Filter, Geometry, Material, Scene, Shape, Transform, Triple};
use light::transport::{Manner, Method};
use std::f64::consts::PI;
use yardstick::statistics::Moments;

/// A room of unequal walls: what each absorbs [1] and what it sends out [W m⁻² sr⁻¹], those across x, y and z in pairs.
pub(super) const UNEQUAL: Triple = [1.0, 0.8, 0.6];
const WALLS: [(f64, f64); 6] = [(0.3, 0.0), (0.7, 0.0), (0.2, 0.0), (0.5, 1.0), (0.25, 0.4), (0.6, 0.0)];

/// That room.
pub(super) fn unequal() -> Room {
    Room::cuboid(UNEQUAL, WALLS)
}

/// A cube whose walls absorb alike and of which one shines.
pub(super) fn cube(absorbed: f64) -> Room {
    Room::cuboid([1.0; 3], std::array::from_fn(|face| (absorbed, f64::from(u8::from(face == 3)))))
}

/// The patches of a room, n × n a face, what they see of each other, and what they do with light.
pub(super) fn network(room: &Room, n: usize) -> (Patches, Network, Light) {
    let patches = room.cut(n);
    let (network, light) = (Network::of(&patches), Light::of(&patches, 1));
    (patches, network, light)
}

/// The mean radiance of every face, by n × n patches each.
pub(super) fn means(room: &Room, n: usize) -> Vec<f64> {
    let (patches, network, light) = network(room, n);
    let found = solve::conjugate(&network, &light, STEPS);
    (0..room.faces.len()).map(|face| patches.mean(face, &found)).collect()
}

/// The same by n × n patches that are finer towards the walls' edges.
pub(super) fn graded(room: &Room, n: usize) -> Vec<f64> {
    let patches = room.cut_graded(n);
    let (network, light) = (Network::of(&patches), Light::of(&patches, 1));
    let found = solve::conjugate(&network, &light, STEPS);
    (0..room.faces.len()).map(|face| patches.mean(face, &found)).collect()
}

/// The limit of the means of all faces, of four graded cuts n, n + 2, n + 4 and n + 6.
pub(super) fn extrapolated(room: &Room, n: usize) -> Vec<f64> {
    let cuts = [0, 2, 4, 6].map(|more| (1.0 / (n + more) as f64, graded(room, n + more)));
    let of = |face: usize| limit::without(&cuts.each_ref().map(|(h, means)| (*h, means[face])), &POWERS);
    (0..room.faces.len()).map(of).collect()
}

/// The powers of h in the error of graded cuts' means.
const POWERS: [f64; 3] = [2.0, 4.0, 5.0];

/// Steps that conjugate gradients need at most in these rooms: each takes a digit or so.
const STEPS: u32 = 24;

/// A room as the renderer has it.
pub(super) fn scene(room: &Room) -> Scene {
    let material = |at: usize| format!("face {at}");
    let shape = |(at, face): (usize, &Face)| Shape {
        geometry: Geometry::Quad { vertices: face.patch.corners() },
        material: material(at),
        emission: (face.emitted != [0.0; 3]).then_some(Emission { radiance: face.emitted, two_sided: false }),
        transform: Transform::default(),
    };
    let diffuse = |(at, face): (usize, &Face)| {
        (material(at), Material::Diffuse { reflectance: face.absorbed.map(|share| 1.0 - share) })
    };
    Scene {
        name: "room".into(),
        max_depth: None,
        filter: Filter::Box,
        camera: facing(&room.faces[0].patch, 0.1),
        environment: None,
        materials: room.faces.iter().enumerate().map(diffuse).collect(),
        shapes: room.faces.iter().enumerate().map(shape).collect(),
        lights: Vec::new(),
    }
}

/// A camera whose picture is one patch and nothing else, seen from `away` [m]: the patch's mean is then its picture's.
fn facing(patch: &Patch, away: f64) -> Camera {
    let (target, normal) = (patch.at([0.5; 2]), patch.normal());
    let up = patch.edges[1];
    let [width, height] = patch.edges.map(|edge| edge.iter().map(|x| x * x).sum::<f64>().sqrt());
    // As few pixels as have the patch's form.
    let off = |rows: &u32| (width / height * f64::from(*rows) + 0.5).fract() - 0.5;
    let rows = (1..100).find(|rows| off(rows).abs() < 1e-2).unwrap_or(100);
    let columns = (width / height * f64::from(rows)).round() as u32;
    Camera {
        origin: [0, 1, 2].map(|axis| target[axis] + away * normal[axis]),
        target,
        up,
        fov_y_deg: 2.0 * (0.5 * height / away).atan() * 180.0 / PI,
        width: columns,
        height: rows,
        aperture: 0.0,
        focus: None,
        polariser_deg: None,
    }
}

/// The mean radiance of a patch (green), by so many independent pictures of so many paths a pixel.
pub(super) fn traced(scene: &Scene, patch: &Patch, away: f64, runs: u64, pairs: u32) -> Moments {
    seen(scene, patch, away, (Method::default(), runs, pairs))
}

/// The same by any integrator.
pub(super) fn seen(scene: &Scene, patch: &Patch, away: f64, (method, runs, pairs): (Method, u64, u32)) -> Moments {
    let scene = Scene { camera: facing(patch, away), ..scene.clone() };
    let of = |seed| greens(&rendered(&scene, &Manner { method, seed, ..Manner::default() }, pairs)).mean();
    (0..runs).map(of).collect()
}

/// What is about an unfolded box: neither black nor white.
const PAPER: [f32; 3] = [0.6, 0.63, 0.68];

/// The walls of a box unfolded, `side` pixels each way a wall: the floor and the ceiling below and above the far wall, whatever
/// their sizes drawn square.
pub(super) fn net(patches: &Patches, side: usize, title: String, colour: impl Fn(usize) -> [f64; 3]) -> Picture {
    let place = |row: usize, column: usize| {
        let (cell, wall) = (row / side, column / side);
        let share = |at: usize| ((at % side) as f64 + 0.5) / side as f64;
        let (s, t) = (share(column), 1.0 - share(row));
        // The wall, and where on it along the axes x, y and z.
        match (cell, wall) {
            (1, 0) => Some((0, [0.0, t, s])),
            (1, 1) => Some((5, [s, t, 1.0])),
            (1, 2) => Some((1, [1.0, t, 1.0 - s])),
            (1, 3) => Some((4, [1.0 - s, t, 0.0])),
            (0, 1) => Some((3, [s, 1.0, 1.0 - t])),
            (2, 1) => Some((2, [s, 0.0, t])),
            _ => None,
        }
    };
    let pixel = |at: usize| {
        let Some((face, along)) = place(at / (4 * side), at % (4 * side)) else { return PAPER };
        let (axis, is_high) = (face / 2, face % 2 == 1);
        let [first, second] = [along[(axis + 1) % 3], along[(axis + 2) % 3]];
        let place = if is_high { [second, first] } else { [first, second] };
        colour(patches.at(face, place)).map(|x| x as f32)
    };
    Picture::new(title, 4 * side, (0..12 * side * side).map(pixel).collect())
}
