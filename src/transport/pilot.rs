//! What a picture's pixels are worth: told by two samples of each, of numbers that no sample of the picture has.
//!
//! Noise is dear in few pixels and cheap in most. By the variance V of a pixel's samples, over its mean square as the picture's
//! error has it, samples are best taken as √V. And of what a sample gathers, some has come from the lamps to the first place that
//! it meets, and the rest by longer ways, which take most of the time. If of K samples one alone goes on, K times as heavy,
//! their variance is A + K B, with B the mean square of what longer ways bring, and their time C + D/K: best is K = √(AD/BC)
//! (E. Veach, *Robust Monte Carlo methods for light transport simulation* (1997), §10.4.1). Both are guesses from few samples,
//! taken together with their neighbours': a bad one wastes work, and no mean depends on it.

use super::Stage;
use super::film::Halves;
use super::kernel::{Tactics, Work};
use super::picture::mapped;
use crate::number::{Width, vectorised_lanes};
use crate::sampling::{Choice, Points, Stream};

/// What is done for a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// Of how many samples each one is the mean; a power of two.
    pub samples: u32,
    /// Of how many paths one goes on from the second place that it meets; of 0 none does.
    pub onward: u32,
}

impl Effort {
    /// What is done if nothing is known.
    pub const PLAIN: Self = Self { samples: 1, onward: 1 };
    /// To see what comes to the first place alone.
    const DIRECT: Self = Self { samples: 1, onward: 0 };
}

/// The most pixels that are asked; of larger pictures one in every few columns and rows.
const MOST_ASKED: u32 = 1 << 18;

/// What is added to a mean square, as in the picture's error.
const FLOOR: f64 = 0.01;

/// D/C: paths that go on send two rays an edge more, over some two edges; before, they have sent three.
const TIME_ONWARD: f64 = 1.5;

/// The largest of both parts of an effort: a few samples do not know rare things well.
pub const MOST: Effort = Effort { samples: 16, onward: 8 };

/// The efforts of a picture's pixels.
pub struct Pilot {
    /// Pixels along a side of those that have one effort.
    side: u32,
    columns: u32,
    efforts: Vec<Effort>,
}

impl Pilot {
    /// Of a stage, by numbers of a choice and a seed for so many vertices.
    pub fn new<N: Width>(stage: &Stage<N>, tactics: &Tactics, choice: Choice, vertices: usize, seed: u64) -> Self {
        let [width, height] = stage.size();
        let asked = |side: u32| u64::from(width.div_ceil(side)) * u64::from(height.div_ceil(side));
        let side = (0..).map(|power| 1 << power).find(|side| asked(*side) <= u64::from(MOST_ASKED)).unwrap_or(1);
        let [columns, rows] = [width, height].map(|size| size.div_ceil(side));
        let middle = |at: u32, size: u32| (at * side + side / 2).min(size - 1);
        let pixels: Vec<[u32; 2]> =
            (0..columns * rows).map(|at| [middle(at % columns, width), middle(at / columns, height)]).collect();
        let points = Points::new(choice, 1, vertices, seed ^ 0x70_696c_6f74);
        let whole = tried(stage, tactics, &points, &pixels, Effort::PLAIN);
        let direct = tried(stage, tactics, &points, &pixels, Effort::DIRECT);
        let found: Vec<Found> = whole.iter().zip(&direct).map(|(whole, direct)| Found::of(whole, direct)).collect();
        Self { side, columns, efforts: efforts(&found, columns) }
    }

    /// The effort of a pixel.
    pub fn effort(&self, [column, row]: [u32; 2]) -> Effort {
        self.efforts[(row / self.side * self.columns + column / self.side) as usize]
    }
}

/// A pair of samples of every pixel.
fn tried<N: Width>(
    stage: &Stage<N>,
    tactics: &Tactics,
    points: &Points,
    pixels: &[[u32; 2]],
    effort: Effort,
) -> Vec<Halves> {
    let blocks: Vec<&[[u32; 2]]> = pixels.chunks(Work::<N>::together(1)).collect();
    let of = |pixels: &&[[u32; 2]]| {
        vectorised_lanes::<N, _>(
            #[inline(always)]
            || {
                let streams: Vec<Stream<'_>> = pixels.iter().map(|pixel| points.of_pixel(*pixel)).collect();
                let efforts = vec![effort; pixels.len()];
                Work { stage, tactics, pixels, efforts: &efforts, streams: &streams }.branch(0..1)
            },
        )
    };
    mapped(&blocks, of).concat()
}

/// What two samples tell, by channel: their mean, their variance, and the mean square of what longer ways bring.
#[derive(Clone, Copy, Default)]
struct Found {
    mean: [f64; 3],
    variance: [f64; 3],
    longer: [f64; 3],
}

impl Found {
    fn of(whole: &Halves, direct: &Halves) -> Self {
        let of = |c: usize, halves: &Halves| [f64::from(halves[0][c]), f64::from(halves[1][c])];
        let mut found = Self::default();
        for c in 0..3 {
            let ([a, b], [near, far]) = (of(c, whole), of(c, direct));
            found.mean[c] = 0.5 * (a + b);
            found.variance[c] = 0.5 * (a - b).powi(2);
            found.longer[c] = 0.5 * ((a - near).powi(2) + (b - far).powi(2));
        }
        found
    }

    fn add(&mut self, weight: f64, other: &Self) {
        for c in 0..3 {
            self.mean[c] += weight * other.mean[c];
            self.variance[c] += weight * other.variance[c];
            self.longer[c] += weight * other.longer[c];
        }
    }

    /// Variance and square over the square of the mean: what is of the picture's error.
    fn relative(&self) -> [f64; 2] {
        let over = |part: &[f64; 3]| (0..3).map(|c| part[c] / (self.mean[c].powi(2) + FLOOR)).sum::<f64>() / 3.0;
        [over(&self.variance), over(&self.longer)].map(|x| if x.is_finite() { x } else { 0.0 })
    }
}

/// The efforts of pixels, row by row, by what was found of them.
fn efforts(found: &[Found], columns: u32) -> Vec<Effort> {
    let (columns, rows) = (columns as usize, found.len() / (columns as usize).max(1));
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
        mean.relative()
    };
    let choices: Vec<(f64, u32)> = (0..found.len())
        .map(|at| {
            let [variance, longer] = about(at);
            let rest = (variance - longer).max(0.0);
            let onward = power_of_two((rest * TIME_ONWARD / longer).sqrt(), MOST.onward);
            (variance + f64::from(onward - 1) * longer, onward)
        })
        .collect();
    let mean = choices.iter().map(|(variance, _)| variance).sum::<f64>() / choices.len() as f64;
    let effort = |(variance, onward): &(f64, u32)| Effort {
        samples: power_of_two((variance / mean).sqrt(), MOST.samples),
        onward: *onward,
    };
    choices.iter().map(effort).collect()
}

/// The nearest power of two to a number, from 1 to the most, by quotients; 1 of what is no number.
fn power_of_two(x: f64, most: u32) -> u32 {
    if x > 1.0 { x.log2().round().exp2().min(f64::from(most)) as u32 } else { 1 }
}
