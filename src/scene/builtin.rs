//! The scenes of the lecture.

mod balls;
mod furnace;
mod plates;
mod pool;
pub mod prism;
pub mod rhomb;
mod room;
#[cfg(test)]
mod tests;

use super::{Camera, Emission, Filter, Geometry, Material, Scene, Shape, Transform, Triple};

/// A scene that needs no file.
#[derive(Clone, Copy, Debug)]
pub struct Builtin {
    /// Command-line word.
    pub name: &'static str,
    /// What it shows, in a few words.
    pub about: &'static str,
    /// Makes it.
    pub make: fn() -> Scene,
}

/// All of them.
pub const BUILTIN: &[Builtin] = &[
    entry("cornell", "the Cornell box: diffuse walls and blocks, one lamp", room::cornell),
    entry("glass", "the box with a mirror and a ball of glass: a caustic", room::glass),
    entry("prism", "a slit of light through a prism of dense flint: a rainbow", prism::prism),
    entry("polariser", "a pool through a polariser that takes the sky's glare off the water", pool::polariser),
    entry(
        "rhomb",
        "Fresnel's rhomb before dark glass, through a polariser: circular light before linear",
        rhomb::rhomb,
    ),
    entry(
        "veach",
        "four plates of metal, ever rougher, and four lamps of one power: which sampling sees which?",
        plates::veach,
    ),
    entry("metals", "three balls of rough metal under a lamp and a grey sky", balls::metals),
    entry("mesh", "a ball of 200 000 triangles, under the same", balls::mesh),
    entry("furnace", "what absorbs nothing, under a white sky: not to be seen", furnace::furnace),
    entry(
        "enclosure",
        "inside a glowing sphere: radiance 1/(1 − ρ), and 1 − ρ^d of that if paths end after d edges",
        furnace::enclosure,
    ),
    entry("far", "the box 1000 km from the origin: the same picture, if no digit is lost", room::far),
    entry("tiny", "the box a millionth of its size: the same picture", room::tiny),
];

const fn entry(name: &'static str, about: &'static str, make: fn() -> Scene) -> Builtin {
    Builtin { name, about, make }
}

/// The scene called `name`.
pub fn named(name: &str) -> Option<&'static Builtin> {
    BUILTIN.iter().find(|builtin| builtin.name == name)
}

/// The most edges of a path where a scene sets an end.
const DEPTH: u32 = 16;

/// A pinhole upright that takes a square picture of 256 × 256 pixels.
fn pinhole(origin: Triple, target: Triple, fov_y_deg: f64) -> Camera {
    Camera {
        origin,
        target,
        up: Camera::UP,
        fov_y_deg,
        width: 256,
        height: 256,
        aperture: 0.0,
        focus: None,
        polariser_deg: None,
    }
}

/// A scene under a black sky.
fn scene(name: &str, camera: Camera, materials: Vec<(&str, Material)>, shapes: Vec<Shape>) -> Scene {
    Scene {
        name: name.to_owned(),
        max_depth: Some(DEPTH),
        filter: Filter::Box,
        camera,
        environment: None,
        materials: materials.into_iter().map(|(name, material)| (name.to_owned(), material)).collect(),
        shapes,
        lights: Vec::new(),
    }
}

/// A shape where it was made, dark by itself.
fn shape(geometry: Geometry, material: &str) -> Shape {
    Shape { geometry, material: material.to_owned(), emission: None, transform: Transform::default() }
}

/// A shape that sends out `radiance` [W m⁻² sr⁻¹] on its normal's side, and reflects nothing if its material is [`BLACK`].
fn lamp(geometry: Geometry, radiance: Triple) -> Shape {
    Shape { emission: Some(Emission { radiance, two_sided: false }), ..shape(geometry, BLACK.0) }
}

/// The material of lamps.
const BLACK: (&str, Material) = ("black", Material::Diffuse { reflectance: [0.0; 3] });

fn grey(reflectance: f64) -> Material {
    Material::Diffuse { reflectance: [reflectance; 3] }
}

/// A rectangle that spans `across` and `along` from a corner, its normal across × along.
fn quad(corner: Triple, across: Triple, along: Triple) -> Geometry {
    use super::triple::plus;
    Geometry::Quad { vertices: [corner, plus(corner, across), plus(plus(corner, across), along), plus(corner, along)] }
}
