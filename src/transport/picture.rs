//! Pictures: every pixel's samples, each pixel on one thread.

use super::film::{Halves, tree};
use super::kernel::{Tactics, Work};
use super::simple::{Integrator, Numbers};
use super::{Needs, Stage};
use crate::bsdf::rgb;
use crate::geometry::Structure;
use crate::number::{F32x8, Width, vectorised_lanes};
use crate::sampling::{Choice, Points};
use crate::scene::{Flaw, Scene};
use std::ops::Range;

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
}

/// An integrator.
#[derive(Clone, Copy)]
pub enum Method {
    /// Eight paths at once.
    Fast(Tactics),
    /// One to read.
    Simple(&'static Integrator),
}

impl Default for Method {
    fn default() -> Self {
        Self::Fast(Tactics::default())
    }
}

/// A scene ready for pictures of it.
pub struct Renderer {
    engine: Engine,
    points: Points,
}

enum Engine {
    Fast(Box<Stage<F32x8>>, Tactics),
    Simple(Box<Stage<f64>>, &'static Integrator),
}

/// Edges of a path where nothing else ends it: the lecture's own integrators stop by a depth.
const DEEP: u32 = 64;

/// Vertices whose numbers are a net's, if a scene does not say how many there are.
const VERTICES: u32 = 16;

impl Renderer {
    /// Of a scene without a flaw, for samples of numbers below 2·`pairs`; those after have numbers that are worse.
    ///
    /// # Errors
    /// If a medium is not known.
    pub fn new(scene: &Scene, manner: &Manner, pairs: u32) -> Result<Self, Flaw> {
        let engine = match manner.method {
            Method::Fast(tactics) => Engine::Fast(Box::new(Stage::new(scene, manner.structure)?), tactics),
            Method::Simple(integrator) => Engine::Simple(Box::new(Stage::new(scene, manner.structure)?), integrator),
        };
        let vertices = scene.max_depth.unwrap_or(VERTICES).min(VERTICES) as usize;
        Ok(Self { engine, points: Points::new(manner.choice, pairs, vertices, manner.seed) })
    }

    /// What the scene needs.
    pub fn needs(&self) -> &Needs {
        match &self.engine {
            Engine::Fast(stage, _) => stage.needs(),
            Engine::Simple(stage, _) => stage.needs(),
        }
    }

    /// Sums over a branch of pairs of samples ([`super::film`]) of some rows of the picture, row by row.
    pub fn sums(&self, rows: Range<u32>, pairs: Range<u32>) -> Vec<Halves> {
        match &self.engine {
            Engine::Fast(stage, tactics) => fast(stage, tactics, &self.points, rows, pairs),
            Engine::Simple(stage, integrator) => {
                let depth = stage.max_depth().unwrap_or(DEEP);
                simple(stage, integrator, depth, &self.points, rows, pairs)
            }
        }
    }
}

/// Sums over a branch of pairs of samples ([`super::film`]) of some rows of a picture, row by row.
pub fn fast<N: Width>(
    stage: &Stage<N>,
    tactics: &Tactics,
    points: &Points,
    rows: Range<u32>,
    pairs: Range<u32>,
) -> Vec<Halves> {
    by_pixel(stage.size()[0], rows, |pixel| {
        let work = Work { stage, tactics, stream: points.of_pixel(pixel), pixel };
        vectorised_lanes::<N, _>(
            #[inline(always)]
            || work.branch(pairs.clone()),
        )
    })
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
            let ray = stage.camera(pixel, [a, b, c, d]);
            let light = (integrator.radiance)(stage, ray, &mut Numbers::new(&stream, sample), depth);
            rgb(|c| light[c] as f32)
        };
        let pairs: Vec<Halves> = pairs.clone().map(|pair| [one(2 * pair), one(2 * pair + 1)]).collect();
        tree(&pairs)
    })
}

fn by_pixel<T: Send>(width: u32, rows: Range<u32>, of: impl Fn([u32; 2]) -> T + Sync) -> Vec<T> {
    let pixel = |at: usize| [at as u32 % width, rows.start + at as u32 / width];
    let all = 0..(width as usize * rows.len());
    #[cfg(feature = "parallel")]
    {
        use rayon::prelude::*;
        all.into_par_iter().map(|at| of(pixel(at))).collect()
    }
    #[cfg(not(feature = "parallel"))]
    all.map(|at| of(pixel(at))).collect()
}
