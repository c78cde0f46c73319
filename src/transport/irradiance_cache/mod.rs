//! Irradiance caching: what falls on matt places by way of others changes so slowly from place to place that a few know it for
//! all (G. J. Ward, F. M. Rubinstein and R. D. Clear, *A ray tracing solution for diffuse interreflection*, SIGGRAPH '88, 85).
//!
//! A path goes on to the first matt place. What lamps send there straight is found by rays to them; all else is asked of
//! records near by, each the light of a hemisphere of rays ([`hemisphere`]) with its gradients, interpolated as far as they may
//! be trusted ([`record`]). Where no record is near, the path goes on.
//!
//! Records are wrong twice over: their own noise is smeared out over all places that they tell, and what is interpolated is
//! off by the square of the distance. So caches are renewed: the samples of a pixel come in batches, of one pair, one, two, four
//! and so on, and every batch has a cache of its own, with more rays a record, and records nearer to each other. Rays grow
//! as W^⅔ of the work W of a batch, and the doubt that is allowed falls as W^−⅙: then noise and interpolation fall alike,
//! their squares as W^−⅔, and caches take a fixed share of the time. Either half of a picture has caches of its own, so that
//! their difference tells the noise; it cannot tell what both have in common, which is the interpolation.

pub mod hemisphere;
pub mod record;

use super::picture::DEEP;
use super::simple::lamps::from_lamps;
use super::simple::{Numbers, both, carried, gathered};
use super::{Stage, Vertex};
use crate::bsdf::{Rgb, rgb};
use crate::geometry::Ray;
use crate::sampling::{Choice, Points, balance};
use crate::threads::mapped;
use hemisphere::{Cells, Seen};
use record::{Cache, Record};
use std::f64::consts::FRAC_1_PI;
use std::sync::OnceLock;

/// Samples of pixels in a batch by which others are measured: one a pixel of 256 × 256.
const BATCH: f64 = 65_536.0;
/// The doubt [1] that is allowed in such a batch, and the most in any.
const ALLOWED: [f64; 2] = [0.4, 0.7];
/// Rays of a record in such a batch, and the least and the most in any.
const RAYS: [f64; 3] = [160.0, 16.0, 1_048_576.0];
/// The least radius of a record [pixels, seen from the camera].
const LEAST: f64 = 8.0;
/// The largest, as a share of the way from the camera [1].
const MOST: f64 = 0.25;
/// Places that are looked at together, before their records are known to each other.
const TOGETHER: usize = 128;
/// How often all pixels are looked at: records that came later may have taken of the radii of those before.
const ROUNDS: u32 = 2;
/// Batches: the last has more samples than there are numbers for them.
const BATCHES: u32 = 33;
/// Vertices of rays of a record, and rays, whose numbers are a net's.
const NET: (usize, u32) = (8, 1 << 10);

/// The caches of a picture, each made when it is first asked for.
pub struct Caches {
    /// For rays of records.
    rays: Points,
    /// For paths from the eye to places that may lack one.
    paths: Points,
    /// The angle [1] of a pixel.
    angle: f64,
    pixels: [u32; 2],
    made: Vec<[OnceLock<Cache>; 2]>,
}

/// A matt place that a path has come to.
struct Place<'a> {
    vertex: Vertex<'a, f64>,
    /// Edges up to it.
    edge: u32,
    /// The way up to it [units of the stage].
    way: f64,
}

impl Caches {
    /// For the pictures of a stage.
    pub fn new(stage: &Stage<f64>, choice: Choice, seed: u64) -> Self {
        let seed = seed ^ 0x7265_636f_7264_7300;
        let pixels = stage.size();
        let middle = pixels.map(|count| f64::from(count / 2));
        let [one, other] = [0.0, 1.0].map(|off| stage.camera([middle[0] + off, middle[1]], [0.5; 4]).direction);
        let off = one - other;
        Self {
            rays: Points::new(choice, NET.1, NET.0, seed),
            paths: Points::new(choice, 1 << 6, NET.0, seed ^ 1),
            angle: off.dot(off).sqrt(),
            pixels,
            made: (0..BATCHES).map(|_| [const { OnceLock::new() }; 2]).collect(),
        }
    }

    /// The batch of a sample of a pixel.
    pub fn batch(sample: u32) -> u32 {
        let pair = sample / 2;
        if pair == 0 { 0 } else { 1 + pair.ilog2() }
    }

    /// A batch's samples of one half of the picture, by those that others are measured by [1].
    fn work(&self, batch: u32) -> f64 {
        let pairs = f64::from(batch.saturating_sub(1)).exp2();
        f64::from(self.pixels[0]) * f64::from(self.pixels[1]) * pairs / BATCH
    }

    /// The doubt [1] that a batch's caches are allowed.
    pub fn allowed(&self, batch: u32) -> f64 {
        (ALLOWED[0] * self.work(batch).powf(-1.0 / 6.0)).min(ALLOWED[1])
    }

    /// The rays of a batch's records.
    pub fn cells(&self, batch: u32) -> Cells {
        Cells::about((RAYS[0] * self.work(batch).powf(2.0 / 3.0)).clamp(RAYS[1], RAYS[2]))
    }

    /// The cache of a sample. Not to be asked for by many threads at once before it is made: they would wait.
    pub fn of_sample(&self, stage: &Stage<f64>, sample: u32) -> &Cache {
        let (batch, half) = (Self::batch(sample), sample % 2);
        self.made[batch as usize][half as usize].get_or_init(|| self.filled(stage, batch, half))
    }

    /// The cache of a batch for one half of the picture.
    ///
    /// Places are looked at in an order that leaps about in the picture, some together: which records there are, and in
    /// which order, does not depend on the threads.
    fn filled(&self, stage: &Stage<f64>, batch: u32, half: u32) -> Cache {
        let [width, height] = self.pixels;
        let count = u64::from(width) * u64::from(height);
        // Steps of a golden section, made prime to the count.
        let step = (0..).map(|more| (count as f64 * 0.618_034) as u64 + more).find(|step| divisor(*step, count) == 1);
        let step = step.unwrap_or(1);
        let cells = self.cells(batch);
        let mut cache = Cache::new(self.allowed(batch));
        for round in 0..ROUNDS {
            let mut at = 0;
            while at < count {
                let some: Vec<u64> = (at..count.min(at + TOGETHER as u64)).collect();
                let of = |number: &u64| {
                    let pixel = (u128::from(*number) * u128::from(step) % u128::from(count)) as u64;
                    let pixel = [(pixel % u64::from(width)) as u32, (pixel / u64::from(width)) as u32];
                    let sample = 2 * (batch * ROUNDS + round) + half;
                    self.lacking(stage, &cache, pixel, sample, &cells)
                };
                let lacking: Vec<Record> = mapped(&some, of).into_iter().flatten().collect();
                let first = cache.records().len();
                lacking.into_iter().for_each(|record| cache.add(record));
                cache.adapt(first);
                at += TOGETHER as u64;
            }
        }
        cache
    }

    /// The record of the matt place that a path through a pixel comes to, if the cache knows nothing of it.
    fn lacking(
        &self,
        stage: &Stage<f64>,
        cache: &Cache,
        pixel: [u32; 2],
        sample: u32,
        cells: &Cells,
    ) -> Option<Record> {
        let stream = self.paths.of_pixel(pixel);
        let [a, b, c, d, ..] = stream.row::<f64>(|_| sample, |_| 0);
        let ray = stage.camera(pixel.map(f64::from), [a, b, c, d]);
        let depth = stage.max_depth().unwrap_or(DEEP);
        let Place { vertex, edge, way } = matt(stage, ray, &mut Numbers::new(&stream, sample), depth)?;
        let (point, normal, edges) = (vertex.surface.point, vertex.frame.z, depth - edge);
        if cache.irradiance(point, normal, edges).is_some() {
            return None;
        }
        let rays = self.rays.of_pixel([pixel[0] + pixel[1] * self.pixels[0], sample]);
        let seen = |cell: u32| {
            let number = 2 * cell + sample % 2;
            let [u, v, ..] = rays.row::<f64>(|_| number, |_| 0);
            let direction = vertex.frame.outward(cells.direction(cell, [u, v]));
            found(stage, stage.leave(&vertex, direction), &mut Numbers::new(&rays, number), edges)
        };
        let fallen = cells.fallen(&(0..cells.count()).map(seen).collect::<Vec<_>>());
        let bounds = [LEAST * self.angle * way, MOST * way];
        Some(Record::new(point, &vertex.frame, edges, &fallen, bounds))
    }

    /// The radiance [W m⁻² sr⁻¹] that comes along a ray, by the cache of its sample.
    // ANCHOR: irradiance_cache
    pub fn radiance(
        stage: &Stage<f64>,
        cache: &Cache,
        mut ray: Ray<f64>,
        numbers: &mut Numbers<'_>,
        depth: u32,
    ) -> Rgb<f64> {
        let (mut light, mut carries) = ([0.0; 3], [1.0; 3]);
        let mut pdf = f64::INFINITY;
        for edge in 1..=depth {
            let Some(vertex) = stage.meet(&ray) else {
                let weight = balance(pdf, stage.density_to_sky(&ray));
                return gathered(light, carries, stage.sky(&ray).map(|sky| sky * weight));
            };
            carries = carried(carries, vertex.clarity);
            let weight = balance(pdf, stage.density_to(&ray, &vertex, true));
            light = gathered(light, carries, vertex.emitted().map(|emitted| emitted * weight));
            if edge == depth {
                break;
            }
            let is_matt = is_matt(&vertex);
            let row = numbers.of_next_vertex();
            // No other way finds the lamps of a matt place: what is recorded is without them.
            light = gathered(
                light,
                carries,
                from_lamps(
                    stage,
                    &vertex,
                    row.lamp,
                    |by_ray, by_chance| if is_matt { 1.0 } else { balance(by_ray, by_chance) },
                ),
            );
            if is_matt && let Some(fallen) = cache.irradiance(vertex.surface.point, vertex.frame.z, depth - edge) {
                let albedo = vertex.met.paint();
                return gathered(light, carries, rgb(|c| albedo[c] * FRAC_1_PI * fallen[c]));
            }
            let drawn = vertex.scatter(row.surface);
            carries = carried(carries, drawn.weight);
            if carries == [0.0; 3] {
                break;
            }
            pdf = match is_matt {
                true => f64::MIN_POSITIVE,
                false if drawn.is_delta => f64::INFINITY,
                false => drawn.pdf,
            };
            ray = stage.leave(&vertex, vertex.frame.outward(drawn.wi));
        }
        light
    }
    // ANCHOR_END: irradiance_cache
}

/// The first matt place on a path from the eye of at most so many edges, if there may be light to be recorded.
fn matt<'a>(stage: &'a Stage<f64>, mut ray: Ray<f64>, numbers: &mut Numbers<'_>, depth: u32) -> Option<Place<'a>> {
    let mut way = 0.0;
    for edge in 1..depth {
        let vertex = stage.meet(&ray)?;
        way += vertex.distance;
        let row = numbers.of_next_vertex();
        if is_matt(&vertex) {
            return (vertex.met.paint() != [0.0; 3]).then_some(Place { vertex, edge, way });
        }
        let drawn = vertex.scatter(row.surface);
        if drawn.weight == [0.0; 3] {
            return None;
        }
        ray = stage.leave(&vertex, vertex.frame.outward(drawn.wi));
    }
    None
}

/// What comes along a ray from a place to which rays to lamps are sent, by paths of at most so many edges: all but what a lamp
/// that it meets sends by itself.
fn found(stage: &Stage<f64>, ray: Ray<f64>, numbers: &mut Numbers<'_>, edges: u32) -> Seen {
    let Some(vertex) = stage.meet(&ray) else {
        let radiance = if stage.has_panorama() { [0.0; 3] } else { stage.sky(&ray) };
        return Seen { radiance, distance: f64::INFINITY };
    };
    let own = carried(vertex.clarity, vertex.emitted());
    let all = both::radiance(stage, ray, numbers, edges);
    Seen { radiance: rgb(|c| (all[c] - own[c]).max(0.0)), distance: vertex.distance }
}

/// Whether its light is asked of records: Lambert's surfaces, on the side that is met.
fn is_matt(vertex: &Vertex<'_, f64>) -> bool {
    vertex.met.is_lambert() && vertex.wo.z > 0.0
}

fn divisor(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { divisor(b, a % b) }
}
