//! What a picture's pixels are worth: told by two samples of each, of numbers that no sample of the picture has.
//!
//! Noise is large in few pixels and small in most, and so is what a sample costs. By the variance V of a pixel's samples, over its
//! mean square as the picture's error has it, and their cost C, samples are best taken as √(V/C) (W. G. Cochran, *Sampling
//! techniques* (1977), §5.5: strata of unequal cost). Both are guesses from two samples and those of the neighbours: a bad
//! one wastes work, and no mean depends on it.

use super::Stage;
use super::film::Halves;
use super::kernel::{Tactics, Work};
use crate::number::{Width, vectorised_lanes};
use crate::sampling::{Choice, Points, Stream};
use crate::threads::mapped;
use std::cell::Cell;

/// The most pixels that are asked; of larger pictures one in every few columns and rows.
const MOST_ASKED: u64 = 1 << 18;

/// What is added to a mean square, as in the picture's error.
const FLOOR: f64 = 0.01;

/// What a path costs before its first edge, in edges.
const START: f64 = 0.5;

/// Samples [1] in place of one where noise over cost is as in the whole picture. Most of a picture is quieter than the whole,
/// and there is no less than one sample: with more here, more of those that noise is worth are taken, and more of all.
const BASE: f64 = 1.25;

/// The most samples in place of one: two do not know rare things well.
pub const MOST: u32 = 16;

/// Of how many samples each one of a picture's pixels is worth to be the mean.
pub struct Pilot {
    /// Pixels along a side of those that are worth as many.
    side: u32,
    columns: u32,
    samples: Vec<u32>,
}

impl Pilot {
    /// Of a stage, by numbers of a choice and a seed for so many vertices.
    pub fn new<N: Width>(stage: &Stage<N>, tactics: &Tactics, choice: Choice, vertices: usize, seed: u64) -> Self {
        let [width, height] = stage.size();
        let side = side([width, height]);
        let [columns, rows] = [width, height].map(|size| size.div_ceil(side));
        let middle = |at: u32, size: u32| (at * side + side / 2).min(size - 1);
        let pixels: Vec<[u32; 2]> =
            (0..columns * rows).map(|at| [middle(at % columns, width), middle(at / columns, height)]).collect();
        let points = Points::new(choice, 1, vertices, seed ^ 0x70_696c_6f74);
        Self { side, columns, samples: worth(&tried(stage, tactics, &points, &pixels), columns) }
    }

    /// How many samples in place of one a pixel is worth; a power of two.
    pub fn samples(&self, [column, row]: [u32; 2]) -> u32 {
        self.samples[(row / self.side * self.columns + column / self.side) as usize]
    }
}

/// Pixels along a side of those that share a pair of samples.
fn side(size: [u32; 2]) -> u32 {
    let asked = |side: u32| size.map(|size| u64::from(size.div_ceil(side))).into_iter().product::<u64>();
    let mut side = 1;
    while asked(side) > MOST_ASKED {
        side *= 2;
    }
    side
}

/// What a pair of samples of every pixel tells.
fn tried<N: Width>(stage: &Stage<N>, tactics: &Tactics, points: &Points, pixels: &[[u32; 2]]) -> Vec<Found> {
    let blocks: Vec<&[[u32; 2]]> = pixels.chunks(Work::<N>::together(1)).collect();
    let of = |pixels: &&[[u32; 2]]| {
        vectorised_lanes::<N, _>(
            #[inline(always)]
            || {
                let streams: Vec<Stream<'_>> = pixels.iter().map(|pixel| points.of_pixel(*pixel)).collect();
                let edges = vec![Cell::new(0); pixels.len()];
                let several = vec![1; pixels.len()];
                let work = Work { stage, tactics, pixels, several: &several, streams: &streams, edges: Some(&edges) };
                let halves = work.branch(0..1);
                halves.iter().zip(&edges).map(|(halves, edges)| Found::of(halves, edges.get())).collect::<Vec<_>>()
            },
        )
    };
    mapped(&blocks, of).concat()
}

/// What two samples tell: by channel their mean and variance, and of both the edges of their paths.
#[derive(Clone, Copy, Default)]
struct Found {
    mean: [f64; 3],
    variance: [f64; 3],
    edges: f64,
}

impl Found {
    fn of(halves: &Halves, edges: u32) -> Self {
        let by =
            |of: fn(f64, f64) -> f64| std::array::from_fn(|c| of(f64::from(halves[0][c]), f64::from(halves[1][c])));
        Self { mean: by(|a, b| 0.5 * (a + b)), variance: by(|a, b| 0.5 * (a - b).powi(2)), edges: f64::from(edges) }
    }

    fn add(&mut self, weight: f64, other: &Self) {
        for c in 0..3 {
            self.mean[c] += weight * other.mean[c];
            self.variance[c] += weight * other.variance[c];
        }
        self.edges += weight * other.edges;
    }

    /// V and C.
    fn variance_and_cost(&self) -> [f64; 2] {
        let over = |c: usize| self.variance[c] / (self.mean[c].powi(2) + FLOOR);
        let variance = (over(0) + over(1) + over(2)) / 3.0;
        [if variance.is_finite() { variance } else { 0.0 }, START + 0.5 * self.edges]
    }
}

/// What pixels are worth, row by row, by what was found of them.
fn worth(found: &[Found], columns: u32) -> Vec<u32> {
    let (columns, rows) = (columns as usize, found.len() / columns as usize);
    let about = |at: usize| {
        let (column, row) = (at % columns, at / columns);
        let (mut sum, mut weights) = (Found::default(), 0.0);
        for y in row.saturating_sub(1)..(row + 2).min(rows) {
            for x in column.saturating_sub(1)..(column + 2).min(columns) {
                let weight = 1.0 / (1 + x.abs_diff(column) + y.abs_diff(row)) as f64;
                sum.add(weight, &found[y * columns + x]);
                weights += weight;
            }
        }
        let mut mean = Found::default();
        mean.add(1.0 / weights, &sum);
        mean.variance_and_cost()
    };
    let all: Vec<[f64; 2]> = (0..found.len()).map(about).collect();
    let [variance, cost] = all.iter().fold([0.0; 2], |[v, c], one| [v + one[0], c + one[1]]);
    all.iter().map(|[v, c]| power_of_two(BASE * (v / c * cost / variance).sqrt())).collect()
}

/// The nearest power of two, by quotients, from 1 to the most; 1 of what is no number.
fn power_of_two(x: f64) -> u32 {
    if x > 1.0 { x.log2().round().exp2().min(f64::from(MOST)) as u32 } else { 1 }
}
