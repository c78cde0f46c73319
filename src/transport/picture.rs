//! Pictures: every pixel's samples, each pixel on one thread.

use super::Stage;
use super::film::Halves;
use super::kernel::{Tactics, Work};
use super::simple::{Integrator, Numbers};
use crate::bsdf::rgb;
use crate::number::{Width, vectorised_lanes};
use crate::sampling::Points;
use std::ops::Range;

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
        super::film::tree(&pairs)
    })
}

fn by_pixel(width: u32, rows: Range<u32>, of: impl Fn([u32; 2]) -> Halves + Sync) -> Vec<Halves> {
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
