//! What the chapter renders: small, and mostly of a light that is known.

use light::bsdf::Rgb;
use light::bsdf::microfacet::{Joint, Slopes};
use light::radiometry::polygon;
use light::scene::{
    Camera, Emission, Energy, Environment, Facets, Filter, Geometry, Glass, Material, Mesh, Metal, Normals, Scene,
    Shape, Transform, Triple, builtin,
};
use light::transport::estimate::colour;
use light::transport::film::{Film, Halves, branches};
use light::transport::{Manner, Renderer};
use std::collections::BTreeMap;
use std::f64::consts::{FRAC_1_SQRT_2, PI};
use std::sync::{Arc, Mutex};
use yardstick::statistics::Moments;

/// The means of both halves of every pixel [W m⁻² sr⁻¹], of so many pairs of samples.
pub(crate) fn rendered(scene: &Scene, manner: &Manner, pairs: u32) -> Vec<Halves> {
    let renderer = Renderer::new(scene, manner, pairs).expect("a scene without a flaw");
    halves(&renderer, scene, pairs)
}

/// The same of a scene made ready.
pub(crate) fn halves(renderer: &Renderer, scene: &Scene, pairs: u32) -> Vec<Halves> {
    let Camera { width, height, .. } = scene.camera;
    let mut film = Film::new(width, height);
    for branch in branches(0..pairs) {
        let (sums, splats) = (renderer.sums(0..height, branch.clone()), renderer.splats(branch.clone()));
        film.add_lit(branch, sums, splats).expect("a branch that it has not");
    }
    film.halves()
}

/// The mean of both halves of every pixel [W m⁻² sr⁻¹].
pub(crate) fn colours(halves: &[Halves]) -> Vec<Rgb<f64>> {
    halves.iter().map(colour).collect()
}

/// The green of every half of every pixel.
pub(crate) fn greens(halves: &[Halves]) -> Moments {
    halves.iter().flatten().map(|half| f64::from(half[1])).collect()
}

/// Pictures of one small scene by independent seeds, each a number: the mean of its green.
pub(crate) fn runs(count: u64, scene: &Scene, manner: Manner, pairs: u32) -> Moments {
    (0..count).map(|seed| greens(&rendered(scene, &Manner { seed, ..manner }, pairs)).mean()).collect()
}

/// A scene of the lecture, so many pixels wide and high.
pub(super) fn small(name: &str, pixels: u32) -> Scene {
    let mut scene = (builtin::named(name).expect("a scene of the lecture").make)();
    (scene.camera.width, scene.camera.height) = (pixels, pixels);
    scene
}

/// The same where errors of pictures are taken. The box is seen below its lamp: the few pixels that the lamp's rim cuts would
/// outweigh all others.
pub(super) fn view(name: &str, pixels: u32) -> Scene {
    let mut scene = small(name, pixels);
    if name == "cornell" {
        (scene.camera.target, scene.camera.fov_y_deg) = ([2.78, 1.9, 0.0], 24.0);
    }
    scene
}

/// A picture of that which is all but converged: by the fast integrator, with a seed that nothing else has. Made once.
pub(super) fn converged(name: &'static str, pixels: u32, pairs: u32) -> Arc<Vec<Rgb<f64>>> {
    type Known = BTreeMap<(&'static str, u32, u32), Arc<Vec<Rgb<f64>>>>;
    static KNOWN: Mutex<Known> = Mutex::new(BTreeMap::new());
    let mut known = KNOWN.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    let made = known.entry((name, pixels, pairs)).or_insert_with(|| {
        let manner = Manner { seed: 0x5eed, ..Manner::default() };
        Arc::new(colours(&rendered(&view(name, pixels), &manner, pairs)))
    });
    Arc::clone(made)
}

fn shape(geometry: Geometry, material: &str, shines: Option<Emission>) -> Shape {
    Shape { geometry, material: material.into(), emission: shines, transform: Transform::default() }
}

fn diffuse(name: &str, reflectance: f64) -> (String, Material) {
    (name.into(), Material::Diffuse { reflectance: [reflectance; 3] })
}

/// A square picture.
fn looking(origin: Triple, target: Triple, fov_y_deg: f64, pixels: u32) -> Camera {
    Camera {
        origin,
        target,
        up: [0.0, 0.6, 0.8],
        fov_y_deg,
        width: pixels,
        height: pixels,
        aperture: 0.0,
        focus: None,
        polariser_deg: None,
    }
}

fn scene(camera: Camera, depth: u32, materials: Vec<(String, Material)>, shapes: Vec<Shape>) -> Scene {
    Scene {
        name: "small".into(),
        max_depth: Some(depth),
        filter: Filter::Box,
        camera,
        environment: None,
        materials,
        shapes,
        lights: Vec::new(),
    }
}

/// A grey floor that covers all of the picture, under a sky of radiance 1 and nothing else: each sample is one direction.
pub(super) fn under_the_sky(reflectance: f64, pixels: u32) -> Scene {
    let camera = looking([0.0, 0.0, 1.0], [0.0, 0.0, 0.0], 40.0, pixels);
    let camera = Camera { up: Camera::UP, ..camera };
    let dark = scene(camera, 2, vec![diffuse("floor", reflectance)], vec![shape(floor(), "floor", None)]);
    Scene { environment: Some(Environment::Constant([1.0; 3])), ..dark }
}

fn floor() -> Geometry {
    Geometry::Quad { vertices: [[-4.0, -4.0, 0.0], [4.0, -4.0, 0.0], [4.0, 4.0, 0.0], [-4.0, 4.0, 0.0]] }
}

/// Reflectance of the lit floor [1], and radiance of its lamp [W m⁻² sr⁻¹].
pub(super) const LIT: (f64, f64) = (0.5, 2.0);

/// A place of a floor, seen through a needle's eye from so far away [m], and the radiance that comes from there: ρE/π of a
/// square lamp of a side [m], 1 m above the floor's middle, by Lambert's closed form.
pub(super) fn lit(at: [f64; 2], side: f64, away: f64, pixels: u32) -> (Scene, f64) {
    let ([x, y], half) = (at, 0.5 * side);
    let corners = [[-half, -half, 1.0], [-half, half, 1.0], [half, half, 1.0], [half, -half, 1.0]];
    // Almost along the floor, below the lamp.
    let camera = looking([x, y - 0.8 * away, 0.6 * away], [x, y, 0.0], 1e-4 / away, pixels);
    let lamp = Emission { radiance: [LIT.1; 3], two_sided: false };
    let shapes = vec![shape(floor(), "floor", None), shape(Geometry::Quad { vertices: corners }, "black", Some(lamp))];
    let seen = corners.map(|[a, b, height]| [a - x, b - y, height]);
    let sum = polygon::irradiance(&seen, [0.0, 0.0, 1.0]).expect("a lamp above the floor");
    (scene(camera, 2, vec![diffuse("floor", LIT.0), diffuse("black", 0.0)], shapes), LIT.0 / PI * LIT.1 * sum)
}

/// The inside of a ball of radius 1 m that shines and absorbs everywhere alike ([`light::transport::enclosure`]), by paths of at
/// most so many edges.
pub(crate) fn closed(absorbed: f64, edges: Option<u32>, pixels: u32) -> Scene {
    let wall = Emission { radiance: [1.0; 3], two_sided: true };
    let ball = shape(Geometry::Sphere { center: [0.0; 3], radius: 1.0 }, "wall", Some(wall));
    let camera = looking([0.1, 0.2, -0.7], [0.0; 3], 90.0, pixels);
    Scene { max_depth: edges, ..scene(camera, 1, vec![diffuse("wall", 1.0 - absorbed)], vec![ball]) }
}

/// A spot of a plate of metal of a roughness, seen through a needle's eye 5 m away at 45°; towards its mirror's direction, as far
/// away, a ball of a radius [m] that shines.
pub(super) fn plate(alpha: f64, radius: f64, pixels: u32) -> Scene {
    let facets = Facets { alpha: [alpha; 2], slopes: Slopes::Ggx };
    let metal = Metal::Named("aluminium".into());
    let metal =
        Material::RoughConductor { metal, facets, masking: Joint::Correlated, energy: Energy::Single, coating: None };
    let away = 5.0 * FRAC_1_SQRT_2;
    let lamp = Emission { radiance: [1.0; 3], two_sided: false };
    let ball = Geometry::Sphere { center: [0.0, away, away], radius };
    let shapes = vec![shape(floor(), "plate", None), shape(ball, "black", Some(lamp))];
    let camera = looking([0.0, -away, away], [0.0; 3], 1e-4, pixels);
    scene(camera, 2, vec![("plate".into(), metal), diffuse("black", 0.0)], shapes)
}

/// A needle's ray into a prism of 60° of a glass, that goes through along its base if it is bent by an angle [rad]; and behind it a
/// strip of radiance 1 that begins where it then goes, and reaches to where light is bent more.
pub(super) fn needle(glass: &str, bent: f64) -> Scene {
    let half = 0.5 * bent;
    // Along x within the glass; the edge is up, along y, and the prism long in z.
    let (side, tall) = (0.3, 0.3 * 3f64.sqrt() / 2.0);
    let section = [[-0.5 * side, -0.5 * tall, -0.1], [0.5 * side, -0.5 * tall, -0.1], [0.0, 0.5 * tall, -0.1]];
    let mesh = Arc::new(Mesh::prism(section, [0.0, 0.0, 0.2]));
    let prism = Geometry::Mesh { file: None, normals: Normals::Flat, mesh };
    // Halfway up, a quarter of the side from the middle.
    let (entry, exit) = ([-0.25 * side, 0.0], [0.25 * side, 0.0]);
    let out = [half.cos(), -half.sin()];
    let at = |along: f64, down: f64, z: f64| {
        [exit[0] + along * out[0] + down * out[1], exit[1] + along * out[1] - down * out[0], z]
    };
    let strip = [at(8.0, 0.0, -1.0), at(8.0, 0.0, 1.0), at(8.0, 3.0, 1.0), at(8.0, 3.0, -1.0)];
    let camera = Camera {
        up: [0.0, 0.0, 1.0],
        ..looking([entry[0] - 0.5 * out[0], entry[1] + 0.5 * out[1], 0.0], [entry[0], entry[1], 0.0], 1e-5, 1)
    };
    let clear = Material::Dispersive { glass: Glass::Named(glass.into()), outside: 1.0, absorption: [0.0; 3] };
    let lamp = Emission { radiance: [1.0; 3], two_sided: true };
    let shapes = vec![shape(prism, "prism", None), shape(Geometry::Quad { vertices: strip }, "black", Some(lamp))];
    // Camera, two faces, strip.
    scene(camera, 3, vec![("prism".into(), clear), diffuse("black", 0.0)], shapes)
}

/// A needle's ray that meets two plates of glass of an index, at an angle [rad] from the normal each, the plane of incidence of the second
/// turned by an angle [rad] from that of the first; and a lamp of radiance 1 where it then goes: Malus's polariscope.
pub(super) fn polariscope(index: f64, theta: f64, turned: f64) -> Scene {
    let bend = PI - 2.0 * theta;
    let (there, next) = ([1.0, 0.0, 0.0], [bend.cos(), bend.sin(), 0.0]);
    let side = [-bend.sin() * turned.cos(), bend.cos() * turned.cos(), turned.sin()];
    let last: Triple = std::array::from_fn(|k| next[k] * bend.cos() + side[k] * bend.sin());
    let between = |from: Triple, to: Triple| -> Triple {
        let off: Triple = std::array::from_fn(|k| to[k] - from[k]);
        let length = off.iter().map(|x| x * x).sum::<f64>().sqrt();
        off.map(|x| x / length)
    };
    let disc = |center, normal, radius| Geometry::Disc { center, normal, radius };
    let second = next.map(|x| 2.0 * x);
    let lamp = std::array::from_fn(|k| second[k] + 2.0 * last[k]);
    let shapes = vec![
        shape(disc([0.0; 3], between(there, next), 0.1), "glass", None),
        shape(disc(second, between(next, last), 0.1), "glass", None),
        shape(disc(lamp, last, 0.2), "black", Some(Emission { radiance: [1.0; 3], two_sided: true })),
    ];
    let clear = Material::Dielectric { ior: index, outside: 1.0, absorption: [0.0; 3], coating: None };
    let camera = Camera { up: [0.0, 1.0, 0.0], ..looking([-2.0, 0.0, 0.0], [0.0; 3], 1e-6, 1) };
    // Camera, two plates, lamp.
    scene(camera, 3, vec![("glass".into(), clear), diffuse("black", 0.0)], shapes)
}
