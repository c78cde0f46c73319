//! Pictures: every pixel's samples, each pixel on one thread.

use super::film::{Halves, Splats, added, tree};
use super::irradiance_cache::Caches;
use super::irradiance_cache::record::Cache;
use super::kernel::{Tactics, Work};
use super::photons::Photons;
use super::pilot::Pilot;
use super::radiosity::{self, Radiosity, Solution};
use super::simple::{INTEGRATORS, Integrator, Numbers, RARE};
use super::{Needless, Needs, Stage, caustics, looks};
use crate::bsdf::{Rgb, rgb};
use crate::geometry::Structure;
use crate::number::{F32x8, Mask, Vector, Width, best_lanes, vectorised_lanes};
use crate::sampling::{Choice, Points, Stream};
use crate::scene::{Flaw, Scene};
use crate::threads::mapped;
use std::ops::Range;
use std::sync::OnceLock;

/// How a picture is made.
#[derive(Clone, Copy, Default)]
pub struct Manner {
    /// The integrator.
    pub method: Method,
    /// How rays are met.
    pub structure: Structure,
    /// Where numbers come from.
    pub choice: Choice,
    /// Of all numbers.
    pub seed: u64,
    /// What is done although the scene may not need it ([`Needs::left_out`]): the same picture, for more work.
    pub needless: Needless,
}

/// An integrator.
#[derive(Clone, Copy)]
pub enum Method {
    /// As many paths at once as the machine has lanes.
    Fast(Tactics),
    /// One to read.
    Simple(&'static Integrator),
    /// By light that was left where it fell ([`super::photons`]); not of skies and lights without a surface.
    Photons,
    /// By what a few places know of the light on all ([`super::irradiance_cache`]).
    Cached,
    /// By patches whose light is found at once ([`super::radiosity`]); of flat diffuse shapes alone.
    Radiosity,
}

impl Default for Method {
    fn default() -> Self {
        Self::Fast(Tactics::default())
    }
}

impl Method {
    /// All of them, the fast one first.
    pub fn all() -> impl Iterator<Item = Self> {
        let simple = INTEGRATORS.iter().chain(RARE).map(Self::Simple);
        std::iter::once(Self::default()).chain(simple).chain([Self::Photons, Self::Cached, Self::Radiosity])
    }

    /// The one for scenes that need this, if nothing is asked: the fast one, and behind a polariser the only one that looks at it.
    pub fn usual(needs: &Needs) -> Self {
        let polarised = RARE.iter().find(|one| needs.polariser && one.name == "polarised");
        polarised.map_or_else(Self::default, Self::Simple)
    }

    /// Command-line word.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Fast(_) => "fast",
            Self::Simple(integrator) => integrator.name,
            Self::Photons => "photon-map",
            Self::Cached => "irradiance-cache",
            Self::Radiosity => "radiosity",
        }
    }

    /// What it does, in a few words.
    pub fn about(&self) -> &'static str {
        match self {
            Self::Fast(_) => "as many paths at once as the machine has lanes, and only what the scene needs",
            Self::Simple(integrator) => integrator.about,
            Self::Photons => "light sent from lamps and left where it falls: blurred, less with every sample",
            Self::Cached => "light by way of matt places, known at a few: interpolated, closer with every sample",
            Self::Radiosity => "flat diffuse shapes in patches, solved at once, and gathered: finer with every sample",
        }
    }

    /// Whether it can do scenes that need this.
    pub fn fits(&self, needs: &Needs) -> bool {
        match self {
            Self::Fast(_) => !needs.polariser,
            Self::Simple(integrator) => (integrator.fits)(needs),
            Self::Photons => !needs.environment && !needs.bare_lights && !needs.wavelength && !needs.polariser,
            Self::Cached => !needs.wavelength && !needs.polariser,
            Self::Radiosity => {
                let is_diffuse = !needs.glossy && !needs.specular && !needs.clear && !needs.absorption;
                is_diffuse && !needs.environment && !needs.bare_lights && !needs.wavelength && !needs.polariser
            }
        }
    }

    /// What of a scene without a flaw it cannot do, if a look at its needs does not tell.
    pub fn refusal(&self, scene: &Scene) -> Option<Flaw> {
        match self {
            Self::Radiosity => radiosity::refusal(scene),
            _ => None,
        }
    }
}

/// A scene ready for pictures of it.
pub struct Renderer {
    engine: Engine,
    points: Points,
    /// For paths from lamps.
    light: Points,
    /// Where numbers come from, and of how many vertices.
    numbers: (Choice, usize, u64),
    /// Pairs that the points are made for.
    pairs: u32,
    several: Several,
}

/// Of how many samples each one of a pixel is the mean, by a pilot and by what it shows ([`looks`]): row by row, known once a
/// row is worked on.
pub struct Several {
    pilot: Option<Pilot>,
    rows: Vec<OnceLock<Vec<u32>>>,
}

impl Several {
    /// Of a stage.
    pub fn new<N: Width>(stage: &Stage<N>, tactics: &Tactics, (choice, vertices, seed): (Choice, usize, u64)) -> Self {
        let pilot = tactics.pilot.then(|| Pilot::new(stage, tactics, choice, vertices, seed));
        Self { pilot, rows: (0..stage.size()[1]).map(|_| OnceLock::new()).collect() }
    }

    /// Of a picture whose integrator does the same for every pixel.
    fn alike() -> Self {
        Self { pilot: None, rows: Vec::new() }
    }

    /// Of the pixels of a row.
    fn of_row<N: Width>(&self, stage: &Stage<N>, tactics: &Tactics, row: u32) -> &[u32] {
        let look = || {
            let pixels: Vec<[u32; 2]> = (0..stage.size()[0]).map(|column| [column, row]).collect();
            let worth = |pixel| self.pilot.as_ref().map_or(1, |pilot| pilot.samples(pixel));
            let seen = looks::several(stage, tactics, &pixels);
            seen.into_iter().zip(pixels).map(|(seen, pixel)| seen.max(worth(pixel))).collect()
        };
        self.rows[row as usize].get_or_init(look)
    }
}

enum Engine {
    Fast(Wide, Tactics),
    Simple(Box<Stage<f64>>, &'static Integrator),
    Photons(Box<Stage<f64>>, Box<Photons>),
    Cached(Box<Stage<f64>>, Box<Caches>),
    Radiosity(Box<Stage<f64>>, Box<Radiosity>),
}

/// A stage of so many lanes. Sixteen are left out where assertions are on: they are a third of all code to compile, and eight
/// give the same bits; `path-tracing/lanes/widths` holds the program to that.
enum Wide {
    #[cfg(not(debug_assertions))]
    Sixteen(Box<Stage<crate::number::F32x16>>),
    Eight(Box<Stage<F32x8>>),
    One(Box<Stage<f32>>),
}

/// The same of a stage, whatever its lanes.
macro_rules! in_width {
    ($wide:expr, $stage:ident => $same:expr) => {
        match $wide {
            #[cfg(not(debug_assertions))]
            Wide::Sixteen($stage) => $same,
            Wide::Eight($stage) => $same,
            Wide::One($stage) => $same,
        }
    };
}

impl Engine {
    /// How many pairs of numbers so many pairs of samples ask for.
    fn numbered(&self, pairs: u32) -> u32 {
        match self {
            Self::Fast(wide, tactics) => {
                let is_looked_at = in_width!(wide, stage => stage.is_looked_at());
                pairs.saturating_mul(tactics.most_samples(is_looked_at))
            }
            Self::Simple(..) | Self::Photons(..) | Self::Cached(..) | Self::Radiosity(..) => pairs,
        }
    }
}

/// Edges of a path where nothing else ends it: the lecture's own integrators stop by a depth.
pub(super) const DEEP: u32 = 64;

/// Vertices whose numbers are a net's, if a scene does not say how many there are.
const VERTICES: u32 = 16;

impl Renderer {
    /// Of a scene without a flaw, for samples of numbers below 2·`pairs`; those after have numbers that are worse.
    ///
    /// # Errors
    /// If a medium is not known.
    pub fn new(scene: &Scene, manner: &Manner, pairs: u32) -> Result<Self, Flaw> {
        let Manner { structure, needless, .. } = manner;
        let engine = match manner.method {
            Method::Fast(tactics) => {
                let wide = match tactics.lanes.min(best_lanes()) {
                    0..8 => Wide::One(Box::new(Stage::with(scene, *structure, needless)?)),
                    #[cfg(not(debug_assertions))]
                    16.. => Wide::Sixteen(Box::new(Stage::with(scene, *structure, needless)?)),
                    _ => Wide::Eight(Box::new(Stage::with(scene, *structure, needless)?)),
                };
                Engine::Fast(wide, tactics)
            }
            Method::Simple(integrator) => {
                Engine::Simple(Box::new(Stage::with(scene, *structure, needless)?), integrator)
            }
            Method::Photons => {
                let stage = Box::new(Stage::with(scene, *structure, needless)?);
                let photons = Box::new(Photons::new(&stage, manner.choice, manner.seed));
                Engine::Photons(stage, photons)
            }
            Method::Cached => {
                let stage = Box::new(Stage::with(scene, *structure, needless)?);
                let caches = Box::new(Caches::new(&stage, manner.choice, manner.seed));
                Engine::Cached(stage, caches)
            }
            Method::Radiosity => {
                let stage = Box::new(Stage::with(scene, *structure, needless)?);
                Engine::Radiosity(stage, Box::new(Radiosity::new(scene)?))
            }
        };
        let vertices = scene.max_depth.unwrap_or(VERTICES).min(VERTICES) as usize;
        let light = match &engine {
            Engine::Fast(wide, _) if in_width!(wide, stage => stage.caustics().is_some()) => {
                caustics::points(manner.choice, manner.seed)
            }
            _ => Points::new(Choice::Independent, 1, 0, manner.seed),
        };
        let points = Points::new(manner.choice, engine.numbered(pairs), vertices, manner.seed);
        let numbers = (manner.choice, vertices, manner.seed);
        let several = match &engine {
            Engine::Fast(wide, tactics) => in_width!(wide, stage => Several::new(stage, tactics, numbers)),
            Engine::Simple(..) | Engine::Photons(..) | Engine::Cached(..) | Engine::Radiosity(..) => Several::alike(),
        };
        Ok(Self { engine, points, light, numbers, pairs, several })
    }

    /// Makes it ready for samples of numbers below 2·`pairs`; those it was ready for stay what they are.
    pub fn expect(&mut self, pairs: u32) {
        if pairs > self.pairs {
            let (choice, vertices, seed) = self.numbers;
            self.points = Points::new(choice, self.engine.numbered(pairs), vertices, seed);
            self.pairs = pairs;
        }
    }

    /// What the scene ready for rays occupies in memory [B].
    pub fn bytes(&self) -> usize {
        match &self.engine {
            Engine::Fast(wide, _) => in_width!(wide, stage => stage.bytes()),
            Engine::Simple(stage, _) | Engine::Photons(stage, _) | Engine::Cached(stage, _) => stage.bytes(),
            Engine::Radiosity(stage, _) => stage.bytes(),
        }
    }

    /// What the scene needs.
    pub fn needs(&self) -> &Needs {
        match &self.engine {
            Engine::Fast(wide, _) => in_width!(wide, stage => stage.needs()),
            Engine::Simple(stage, _) | Engine::Photons(stage, _) | Engine::Cached(stage, _) => stage.needs(),
            Engine::Radiosity(stage, _) => stage.needs(),
        }
    }

    /// What paths from lamps bring to the whole picture in some pairs of samples, to be added to the film with their
    /// [`Renderer::sums`]; None where none are sent, which does not depend on the pairs.
    pub fn splats(&self, pairs: Range<u32>) -> Option<Splats> {
        match &self.engine {
            Engine::Fast(wide, tactics) if tactics.follows() => {
                in_width!(wide, stage => caustics::splats(stage, &self.light, pairs))
            }
            _ => None,
        }
    }

    /// Whether some rows of a picture take no longer than their part of all.
    pub fn goes_by_rows(&self) -> bool {
        !matches!(self.engine, Engine::Photons(..))
    }

    /// The patches behind the picture, if there are any.
    pub fn radiosity(&self) -> Option<&Radiosity> {
        match &self.engine {
            Engine::Radiosity(_, radiosity) => Some(radiosity),
            _ => None,
        }
    }

    /// Sums over a branch of pairs of samples ([`super::film`]) of some rows of the picture, row by row.
    pub fn sums(&self, rows: Range<u32>, pairs: Range<u32>) -> Vec<Halves> {
        match &self.engine {
            Engine::Fast(wide, tactics) => {
                in_width!(wide, stage => fast(stage, tactics, &self.several, &self.points, rows, pairs))
            }
            Engine::Simple(stage, integrator) => {
                let depth = stage.max_depth().unwrap_or(DEEP);
                simple(stage, integrator, depth, &self.points, rows, pairs)
            }
            Engine::Photons(stage, photons) => by_photons(stage, photons, &self.points, rows, pairs),
            Engine::Cached(stage, caches) => by_caches(stage, caches, &self.points, rows, pairs),
            Engine::Radiosity(stage, radiosity) => by_patches(stage, radiosity, &self.points, rows, pairs),
        }
    }
}

impl Renderer {
    /// What the camera sees of the scene's surfaces, pixel by pixel of some rows, without any light.
    pub fn features(&self, rows: Range<u32>) -> Vec<Feature> {
        match &self.engine {
            Engine::Fast(wide, _) => in_width!(wide, stage => features(stage, &self.points, rows)),
            Engine::Simple(stage, _) | Engine::Photons(stage, _) | Engine::Cached(stage, _) => {
                features(stage, &self.points, rows)
            }
            Engine::Radiosity(stage, _) => features(stage, &self.points, rows),
        }
    }
}

/// What a pixel shows of surfaces, by `LOOKS` rays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Feature {
    /// Distance from the camera along the ray [m], the mean of the rays that meet something; infinite where none does.
    pub distance: f32,
    /// The normal that shades, on the side that is seen; a mean of unit vectors, and of 0 of the rays that meet nothing.
    pub normal: [f32; 3],
    /// The share [1] of light from all around that goes to the camera; that of nothing is 0.
    pub albedo: Rgb<f32>,
}

/// Rays that tell what a pixel shows.
const LOOKS: u32 = 16;

fn features<N: Width>(stage: &Stage<N>, points: &Points, rows: Range<u32>) -> Vec<Feature> {
    let of = |pixel| {
        let stream = points.of_pixel(pixel);
        let (mut sums, mut hits) = ([0.0; 7], 0.0);
        for start in (0..LOOKS).step_by(N::LANES) {
            let sample = |lane: usize| start + lane as u32;
            let u = stream.row::<N>(sample, |_| 0);
            let ray = stage.camera(pixel.map(|at| N::of(f64::from(at))), [u[0], u[1], u[2], u[3]]);
            let hit = stage.closest(&ray, N::Mask::of(true));
            let met = hit.is_some();
            let vertex = stage.vertex(&ray, &hit, met);
            let back = -ray.direction;
            let albedo = vertex.met.sample(met, vertex.wo, stream.at(sample, |_| 1).surface).weight;
            let normal = vertex.frame.z;
            let normal = Vector::select(normal.dot(back).lt(N::of(0.0)), -normal, normal);
            let seen = [hit.t, normal.x, normal.y, normal.z, albedo[0], albedo[1], albedo[2]];
            for lane in (0..N::LANES).filter(|lane| met.lane(*lane)) {
                sums = std::array::from_fn(|k| sums[k] + seen[k].lane(lane));
                hits += 1.0;
            }
        }
        let [_, x, y, z, red, green, blue] = sums.map(|sum| (sum / f64::from(LOOKS)) as f32);
        let distance = if hits > 0.0 { (sums[0] / hits / stage.scale()) as f32 } else { f32::INFINITY };
        Feature { distance, normal: [x, y, z], albedo: [red, green, blue] }
    };
    by_pixel(stage.size()[0], rows, of)
}

/// Sums over a branch of pairs of samples ([`super::film`]) of some rows of a picture, row by row.
pub fn fast<N: Width>(
    stage: &Stage<N>,
    tactics: &Tactics,
    several: &Several,
    points: &Points,
    rows: Range<u32>,
    pairs: Range<u32>,
) -> Vec<Halves> {
    let width = stage.size()[0];
    let lines: Vec<u32> = rows.collect();
    let line = |row: u32| -> Vec<[u32; 2]> { (0..width).map(|column| [column, row]).collect() };
    let several = mapped(&lines, |row| several.of_row(stage, tactics, *row)).concat();
    let all = lines.iter().map(|row| line(*row)).collect::<Vec<_>>().concat();
    let together = Work::<N>::together(pairs.end - pairs.start);
    let blocks: Vec<_> = all.chunks(together).zip(several.chunks(together)).collect();
    let of = |(pixels, several): &(&[[u32; 2]], &[u32])| {
        vectorised_lanes::<N, _>(
            #[inline(always)]
            || {
                let streams: Vec<Stream<'_>> = pixels.iter().map(|pixel| points.of_pixel(*pixel)).collect();
                Work { stage, tactics, pixels, several, streams: &streams, edges: None }.branch(pairs.clone())
            },
        )
    };
    mapped(&blocks, of).concat()
}

/// The same by an integrator to read, its paths at most so many edges long.
pub fn simple(
    stage: &Stage<f64>,
    integrator: &Integrator,
    depth: u32,
    points: &Points,
    rows: Range<u32>,
    pairs: Range<u32>,
) -> Vec<Halves> {
    by_pixel(stage.size()[0], rows, |pixel| {
        let stream = points.of_pixel(pixel);
        let one = |sample: u32| {
            let [a, b, c, d, ..] = stream.row::<f64>(|_| sample, |_| 0);
            let ray = stage.camera(pixel.map(f64::from), [a, b, c, d]);
            let light = (integrator.radiance)(stage, ray, &mut Numbers::new(&stream, sample), depth);
            rgb(|c| light[c] as f32)
        };
        let pairs: Vec<Halves> = pairs.clone().map(|pair| [one(2 * pair), one(2 * pair + 1)]).collect();
        tree(&pairs)
    })
}

/// The same by maps of light, of every sample its own: the fewer the calls for all rows, the fewer maps are made.
fn by_photons(
    stage: &Stage<f64>,
    photons: &Photons,
    points: &Points,
    rows: Range<u32>,
    pairs: Range<u32>,
) -> Vec<Halves> {
    if pairs.end - pairs.start > 1 {
        // As the tree has it, but of all pixels at once.
        let middle = pairs.start + (pairs.end - pairs.start) / 2;
        let of = |pairs| by_photons(stage, photons, points, rows.clone(), pairs);
        let (low, high) = (of(pairs.start..middle), of(middle..pairs.end));
        return low.into_iter().zip(high).map(|(low, high)| added(low, high)).collect();
    }
    let depth = stage.max_depth().unwrap_or(DEEP);
    let of_half = |half: u32| {
        let sample = 2 * pairs.start + half;
        let maps = photons.maps(stage, sample);
        by_pixel(stage.size()[0], rows.clone(), |pixel| {
            let stream = points.of_pixel(pixel);
            let [a, b, c, d, ..] = stream.row::<f64>(|_| sample, |_| 0);
            let ray = stage.camera(pixel.map(f64::from), [a, b, c, d]);
            let light = Photons::radiance(stage, &maps, ray, &mut Numbers::new(&stream, sample), depth);
            rgb(|c| light[c] as f32)
        })
    };
    of_half(0).into_iter().zip(of_half(1)).map(|(first, second)| [first, second]).collect()
}

/// The same by records of light, each batch of samples its own.
fn by_caches(stage: &Stage<f64>, caches: &Caches, points: &Points, rows: Range<u32>, pairs: Range<u32>) -> Vec<Halves> {
    let depth = stage.max_depth().unwrap_or(DEEP);
    // Made here, on all threads, before any of them asks.
    let all: Vec<&Cache> = (2 * pairs.start..2 * pairs.end).map(|sample| caches.of_sample(stage, sample)).collect();
    by_pixel(stage.size()[0], rows, |pixel| {
        let stream = points.of_pixel(pixel);
        let one = |sample: u32| {
            let [a, b, c, d, ..] = stream.row::<f64>(|_| sample, |_| 0);
            let ray = stage.camera(pixel.map(f64::from), [a, b, c, d]);
            let cache = all[(sample - 2 * pairs.start) as usize];
            let light = Caches::radiance(stage, cache, ray, &mut Numbers::new(&stream, sample), depth);
            rgb(|c| light[c] as f32)
        };
        let pairs: Vec<Halves> = pairs.clone().map(|pair| [one(2 * pair), one(2 * pair + 1)]).collect();
        tree(&pairs)
    })
}

/// The same by patches, of each batch of samples its own.
fn by_patches(
    stage: &Stage<f64>,
    radiosity: &Radiosity,
    points: &Points,
    rows: Range<u32>,
    pairs: Range<u32>,
) -> Vec<Halves> {
    let depth = stage.max_depth();
    // Made here, on all threads, before any of them asks.
    let all: Vec<&Solution> = pairs.clone().map(|pair| radiosity.of_sample(2 * pair)).collect();
    by_pixel(stage.size()[0], rows, |pixel| {
        let stream = points.of_pixel(pixel);
        let one = |sample: u32| {
            let [a, b, c, d, ..] = stream.row::<f64>(|_| sample, |_| 0);
            let ray = stage.camera(pixel.map(f64::from), [a, b, c, d]);
            let solution = all[(sample / 2 - pairs.start) as usize];
            let light = radiosity.radiance(stage, solution, ray, &mut Numbers::new(&stream, sample), depth);
            rgb(|c| light[c] as f32)
        };
        let pairs: Vec<Halves> = pairs.clone().map(|pair| [one(2 * pair), one(2 * pair + 1)]).collect();
        tree(&pairs)
    })
}

fn by_pixel<T: Send>(width: u32, rows: Range<u32>, of: impl Fn([u32; 2]) -> T + Sync + Send) -> Vec<T> {
    let all: Vec<[u32; 2]> = rows.flat_map(|row| (0..width).map(move |column| [column, row])).collect();
    mapped(&all, |pixel| of(*pixel))
}
