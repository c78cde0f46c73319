//! Pictures by radiosity: a scene of flat diffuse shapes is cut into patches, the light of all of them is found at once
//! ([`crate::radiosity`]), and the eye gathers it.
//!
//! What a pixel shows is found by rays: lamps as path tracing finds them, by rays to them and by chance, each weighed; and what
//! comes from all other places by one ray, whose patch knows what it sends back. So shadows of lamps are sharp, and what is
//! constant over a patch is seen only by way of another surface.
//!
//! Patches are wrong by their size, whatever the number of samples. So they are renewed, as caches are
//! ([`super::irradiance_cache`]): every batch of samples has patches of its own, their number as the root of the batch's samples,
//! so that form factors, which are as many as pairs, take a fixed share of the time. What is left after all bounces is as
//! the patch's size, about the fourth root of the work. Both halves of a picture have the same patches: their difference
//! does not know of it.

use super::picture::DEEP;
use super::simple::lamps::from_lamps;
use super::simple::{Numbers, carried, gathered};
use super::{Stage, Vertex};
use crate::bsdf::{Rgb, rgb};
use crate::geometry::{Hit, Ray};
use crate::radiosity::{Light, Network, Outline, Patches, Room, Routes, solve};
use crate::sampling::balance;
use crate::scene::{Flaw, Scene};
use std::sync::OnceLock;

/// Samples of pixels in a batch by which others are measured, and patches of such a batch: one a pixel of 256 × 256.
const BATCH: f64 = 65_536.0;
const PATCHES: f64 = 256.0;
/// The least and the most: of so many all pairs take twice 128 MiB while they are solved.
const BOUNDS: [f64; 2] = [128.0, 4096.0];
/// Faces of which there is an answer: of every two all others are asked whether they come between.
pub const MOST_FACES: usize = 128;
/// Batches: the last has more samples than there are numbers for them.
const BATCHES: u32 = 33;
/// Patches up to which equations are solved by elimination, which keeps all digits however white the room is.
const AT_ONCE: usize = 600;
/// Steps of conjugate gradients, and the residual [1] that is small enough.
const STEPS: [u32; 4] = [16, 32, 64, 256];
const STILL: f64 = 1e-10;

/// How a network's equations were solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Solver {
    /// By elimination without differences.
    Direct,
    /// By so many steps of conjugate gradients.
    Conjugate(u32),
    /// By as many bounces as the scene's paths may have.
    Bounces(u32),
}

/// The light of one batch's patches.
pub struct Solution {
    patches: Patches,
    /// What every patch sends back of what arrives [W m⁻² sr⁻¹], without what it sends by itself.
    reflected: Vec<Rgb<f64>>,
    /// What is known of it.
    pub facts: Facts,
}

/// What is known of a solution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facts {
    /// Faces, and of these backs that light gets to.
    pub faces: usize,
    /// Those.
    pub backs: usize,
    /// Patches.
    pub patches: usize,
    /// Pairs, by how their form factors were found.
    pub routes: Routes,
    /// The least and the largest sum of a row of form factors [1]: what a patch sees of all others.
    pub sums: [f64; 2],
    /// How the equations were solved.
    pub solver: Solver,
    /// The largest |L_e + ρFL − L| of any patch and channel over the brightest [1]; of a series that was ended, its next term.
    pub residual: f64,
    /// The mean over all patches' area and channels of what they send back [W m⁻² sr⁻¹].
    pub mean: f64,
}

impl Solution {
    /// Of about so many patches, paths of at most so many edges from the patch on if that is said.
    pub fn new(room: &Room, backs: usize, count: f64, edges: Option<u32>) -> Self {
        let patches = room.cut_within((room.area() / count).sqrt(), BOUNDS[1] as usize);
        let (network, routes) = Network::counted(&patches);
        let n = network.len();
        let (mut solver, mut residual) = (Solver::Direct, 0.0_f64);
        let sent_back = [0, 1, 2].map(|channel| -> Vec<f64> {
            let light = Light::of(&patches, channel);
            let (found, by, left) = solved(&network, &light, edges);
            (solver, residual) = (by, worse(residual, left));
            // What is no number has to be seen.
            let reflected = |(all, own): (&f64, &f64)| if all.is_nan() { *all } else { (all - own).max(0.0) };
            found.iter().zip(&light.emitted).map(reflected).collect()
        });
        let reflected: Vec<Rgb<f64>> = (0..n).map(|at| rgb(|c| sent_back[c][at])).collect();
        let sums = (0..n).map(|at| network.row(at).iter().sum::<f64>());
        let sums = sums.fold([f64::INFINITY, 0.0], |[least, most], sum| [-worse(-least, -sum), worse(most, sum)]);
        let area: f64 = network.areas.iter().sum();
        let light = network.areas.iter().zip(&reflected).map(|(area, light)| area * light.iter().sum::<f64>() / 3.0);
        let mean = light.sum::<f64>() / area;
        let faces = room.faces.len();
        let facts = Facts { faces, backs, patches: n, routes, sums, solver, residual, mean };
        Self { patches, reflected, facts }
    }

    /// The mean of what a face sends back [W m⁻² sr⁻¹], in one channel.
    pub fn mean(&self, face: usize, channel: usize) -> f64 {
        let values: Vec<f64> = self.reflected.iter().map(|light| light[channel]).collect();
        self.patches.mean(face, &values)
    }
}

/// The larger one, or what is no number.
fn worse(one: f64, other: f64) -> f64 {
    if one >= other || one.is_nan() { one } else { other }
}

fn solved(network: &Network, light: &Light, edges: Option<u32>) -> (Vec<f64>, Solver, f64) {
    let residual = |found: &[f64]| {
        let most = found.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        let off = |at: usize| {
            (light.emitted[at] + light.reflected(at) * network.arriving(at, found) - found[at]).abs() / most
        };
        (0..network.len()).map(off).fold(0.0, worse)
    };
    let told = |found: Vec<f64>, by| {
        let left = residual(&found);
        (found, by, left)
    };
    if let Some(edges) = edges {
        return told(solve::series(network, light, edges.max(1)), Solver::Bounces(edges.max(1) - 1));
    }
    if network.len() <= AT_ONCE {
        return told(solve::direct(network, light), Solver::Direct);
    }
    let mut last = told(solve::conjugate(network, light, STEPS[0]), Solver::Conjugate(STEPS[0]));
    for steps in &STEPS[1..] {
        if last.2 <= STILL {
            break;
        }
        last = told(solve::conjugate(network, light, *steps), Solver::Conjugate(*steps));
    }
    last
}

/// A scene's patches, batch by batch, each made when it is first asked for.
pub struct Radiosity {
    room: Room,
    /// The face that is each face's back, if light gets there.
    backs: Vec<Option<usize>>,
    /// Edges of paths from a patch on, if a depth ends them.
    edges: Option<u32>,
    pixels: f64,
    made: Vec<OnceLock<Solution>>,
}

impl Radiosity {
    /// Of a scene without a flaw.
    ///
    /// # Errors
    /// If it is not all of flat diffuse shapes, of not too many faces, that shine on one side.
    pub fn new(scene: &Scene) -> Result<Self, Flaw> {
        let room = room(scene)?;
        let (room, backs) = room.with_backs();
        // The first edge is the eye's, the second the one that gathers.
        let edges = scene.max_depth.map(|depth| depth.saturating_sub(1));
        let pixels = f64::from(scene.camera.width) * f64::from(scene.camera.height);
        Ok(Self { room, backs, edges, pixels, made: (0..BATCHES).map(|_| OnceLock::new()).collect() })
    }

    /// The batch of a sample of a pixel.
    fn batch(sample: u32) -> u32 {
        let pair = sample / 2;
        if pair == 0 { 0 } else { 1 + pair.ilog2() }
    }

    /// Patches of a batch, about.
    fn patches(&self, batch: u32) -> f64 {
        let pairs = f64::from(batch.saturating_sub(1)).exp2();
        (PATCHES * (2.0 * pairs * self.pixels / BATCH).sqrt()).clamp(BOUNDS[0], BOUNDS[1])
    }

    /// Patches of a sample, about.
    pub fn count(&self, sample: u32) -> f64 {
        self.patches(Self::batch(sample))
    }

    /// The light of a sample's patches. Not to be asked for by many threads at once before it is made: they would wait.
    pub fn of_sample(&self, sample: u32) -> &Solution {
        let count = self.count(sample);
        // Batches of as many patches, as the least and the most are, have the same.
        let batch = (0..=Self::batch(sample)).find(|batch| self.patches(*batch) == count).unwrap_or(0);
        let backs = self.backs.iter().flatten().count();
        self.made[batch as usize].get_or_init(|| Solution::new(&self.room, backs, count, self.edges))
    }

    /// The radiance [W m⁻² sr⁻¹] that comes along a ray, by the patches of its sample.
    // ANCHOR: radiosity
    pub fn radiance(
        &self,
        stage: &Stage<f64>,
        solution: &Solution,
        ray: Ray<f64>,
        numbers: &mut Numbers<'_>,
        depth: Option<u32>,
    ) -> Rgb<f64> {
        let depth = depth.unwrap_or(DEEP);
        let Some((vertex, _)) = met(stage, &ray) else { return stage.sky(&ray) };
        let mut light = vertex.emitted();
        if depth < 2 {
            return light;
        }
        let row = numbers.of_next_vertex();
        light = gathered(light, [1.0; 3], from_lamps(stage, &vertex, row.lamp, balance));
        let drawn = vertex.scatter(row.surface);
        if drawn.weight == [0.0; 3] {
            return light;
        }
        let carries = carried([1.0; 3], drawn.weight);
        let ray = stage.leave(&vertex, vertex.frame.outward(drawn.wi));
        let Some((vertex, hit)) = met(stage, &ray) else { return gathered(light, carries, stage.sky(&ray)) };
        let weight = balance(drawn.pdf, stage.density_to(&ray, &vertex, true));
        light = gathered(light, carries, vertex.emitted().map(|emitted| emitted * weight));
        let is_back = ray.direction.dot(vertex.surface.normal) > 0.0;
        gathered(light, carries, self.sent_back(solution, &hit, is_back))
    }
    // ANCHOR_END: radiosity

    /// What the patch that was met sends back.
    fn sent_back(&self, solution: &Solution, hit: &Hit<f64>, is_back: bool) -> Rgb<f64> {
        let front = hit.primitive as usize;
        let face = if is_back { self.backs[front] } else { Some(front) };
        let place = place(self.room.faces[front].patch.outline, hit, is_back);
        face.map_or([0.0; 3], |face| solution.reflected[solution.patches.at(face, place)])
    }
}

/// Where on a face, or on its back, it was met: shares [1] of its edges.
pub(super) fn place(outline: Outline, hit: &Hit<f64>, is_back: bool) -> [f64; 2] {
    let [u, v] = match outline {
        Outline::Parallelogram => [hit.u, hit.v].map(|along| 0.5 * (along + 1.0)),
        Outline::Triangle => [hit.u, hit.v],
    };
    // A back's edges are in the other order.
    if is_back { [v, u] } else { [u, v] }
}

/// What a ray meets, and where on it.
fn met<'a>(stage: &'a Stage<f64>, ray: &Ray<f64>) -> Option<(Vertex<'a, f64>, Hit<f64>)> {
    let hit = stage.closest(ray, true);
    hit.t.is_finite().then(|| (stage.vertex(ray, &hit, true), hit))
}

/// The scene's faces.
fn room(scene: &Scene) -> Result<Room, Flaw> {
    let room = Room::of(scene)?;
    match room.faces.len() {
        0 => Err(Flaw::of("shapes", "there is none to be cut into patches")),
        1..=MOST_FACES => Ok(room),
        faces => Err(Flaw::of("shapes", format!("have {faces} faces, and all see all; valid: up to {MOST_FACES}"))),
    }
}

/// Why a scene has no radiosity, if it has none.
pub fn refusal(scene: &Scene) -> Option<Flaw> {
    room(scene).err()
}
