//! C20 on a room that everybody knows: the Cornell box by patches and by paths.

use super::rooms::traced;
use crate::figure::{Panel, Picture, Plot};
use crate::parameter::Setting;
use crate::path_tracing::scenes::{colours, rendered};
use crate::vocabulary::{Bench, Check, Measured, check};
use light::geometry::{Quad, Ray};
use light::number::Vector;
use light::radiosity::{Light, Network, Room, solve};
use light::scene::{Camera, Scene, Triple, builtin};
use light::transport::Manner;

/// How a room is made of a scene.
type Made = fn(&Scene) -> Room;

pub(super) const CORNELL: Check<Made> = check("walls", "the walls of the Cornell box are as bright by patches as by paths, blocks and all")
    .against("paths that look at the three walls, some 50 000 of them each or more, against patches of at most 0.6 m")
    .within(0.02, "1", "patches are a ninth of the room: (1/9)² = 1.2 % by the order that means have; and four standard errors of the paths")
    .of(
        |_: &mut Bench, made: Made| {
            let scene = scene();
            let room = made(&scene);
            let walls = [2, 3, 4];
            let patches = room.cut_to(0.6);
            let (network, light) = (Network::of(&patches), Light::of(&patches, 1));
            let found = solve::conjugate(&network, &light, 24);
            Measured::worst(walls.into_iter().map(|wall| {
                // A whole wall, 5.6 m × 5.5 m, from near it: no block comes between.
                let paths = traced(&scene, &room.faces[wall].patch, 0.5, 8, 1);
                let mean = patches.mean(wall, &found);
                let at = format!("wall {wall}: {mean:.4} by patches, {:.4} ± {:.4} by paths", paths.mean(), paths.standard_error());
                (mean / paths.mean() - 1.0, at)
            }))
        },
        |scene| Room::of(scene).expect("flat and diffuse"),
    )
    .slip("the blocks left out", |scene| {
        let mut room = Room::of(scene).expect("flat and diffuse");
        room.faces.truncate(6);
        room
    });

/// The box, its paths without an end but chance.
fn scene() -> Scene {
    Scene { max_depth: None, ..(builtin::named("cornell").expect("a scene of the lecture").make)() }
}

/// Pixels along a side of its pictures.
const SIDE: u32 = 96;

pub(super) fn pictures(_: &Setting) -> Plot {
    let mut scene = scene();
    (scene.camera.width, scene.camera.height) = (SIDE, SIDE);
    let paths = colours(&rendered(&scene, &Manner::default(), 32));
    let picture = |title: &str, pixels: Vec<Triple>| {
        Picture::new(title, SIDE as usize, pixels.into_iter().map(|pixel| pixel.map(|x| x as f32)).collect())
    };
    let [patches, paths] = [picture("by patches of 0.8 m", by_patches(&scene)), picture("by 64 paths a pixel", paths)];
    let off = patches.errors(&paths, "difference");
    Plot::grid("The Cornell box", 3, vec![patches.into(), paths.into(), Panel::Map(off)])
}

/// What the camera sees of patches, a ray a pixel.
fn by_patches(scene: &Scene) -> Vec<Triple> {
    let room = Room::of(scene).expect("flat and diffuse");
    let patches = room.cut_to(0.8);
    let network = Network::of(&patches);
    let found = [0, 1, 2].map(|channel| solve::conjugate(&network, &Light::of(&patches, channel), 24));
    let quads: Vec<Quad<f64>> = room.faces.iter().map(|face| Quad::new(face.patch.corner, face.patch.edges)).collect();
    let seen = |direction: Vector<f64>| -> Triple {
        let ray = Ray { origin: Vector::of(scene.camera.origin), direction };
        let meetings = quads.iter().map(|quad| quad.meet(&ray)).enumerate().filter(|(_, meeting)| meeting.is_met);
        let Some((face, meeting)) = meetings.min_by(|one, other| one.1.t.total_cmp(&other.1.t)) else {
            return [0.0; 3];
        };
        // A back is black.
        if direction.dot(Vector::of(room.faces[face].patch.normal())) >= 0.0 {
            return [0.0; 3];
        }
        let at = patches.at(face, [meeting.u, meeting.v].map(|along| 0.5 * (along + 1.0)));
        found.each_ref().map(|channel| channel[at])
    };
    rays(&scene.camera).map(seen).collect()
}

/// Through the middle of each pixel, row by row from the top.
fn rays(camera: &Camera) -> impl Iterator<Item = Vector<f64>> {
    let [origin, target, up] = [camera.origin, camera.target, camera.up].map(Vector::<f64>::of);
    let ahead = (target - origin).normalised();
    let right = ahead.cross(up).normalised();
    let up = right.cross(ahead);
    let half = (0.5 * camera.fov_y_deg).to_radians().tan();
    let (width, height) = (camera.width, camera.height);
    (0..width * height).map(move |at| {
        let place = |at: u32, of: u32| (2.0 * f64::from(at) + 1.0) / f64::from(of) - 1.0;
        let [x, y] = [place(at % width, width), -place(at / width, height)];
        let x = x * f64::from(width) / f64::from(height);
        ahead + right.scaled(half * x) + up.scaled(half * y)
    })
}
