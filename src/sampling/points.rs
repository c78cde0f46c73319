//! Numbers for paths: one net for all pixels, shifted for each.
//!
//! A path asks for a [`Row`] at the camera and one at every vertex. Each pair of numbers in a row goes through the samples as
//! the first two axes of Sobol's net do under Owen's scrambling, in an order of its own ([`yardstick::directions::shuffled`]):
//! one net of all axes has pairs of them that are worse than chance for some numbers of samples. They are made once. A
//! pixel adds to them, bit by bit without carry, a hash of itself, the axis and the seed (T. Kollig and A. Keller, *Efficient
//! multidimensional sampling*, CGF 21(3) (2002) 557): every number stays even over [0, 1), the samples of a pixel stay nets,
//! and pixels know nothing of each other. After the last sample the net begins again, moved by another hash: its samples are
//! as even as before. What a path asks beyond the rows made is hashed.

use crate::number::{Number, Width};
use yardstick::directions::{MOST_SOBOL, net, shuffled};

/// Numbers of a row [1].
pub const ROW: usize = 8;

/// What a vertex may ask for, 0 ≤ u < 1; at the camera the first two are the place in the pixel, the next two that on the
/// lens.
#[derive(Clone, Copy, Debug)]
pub struct Row<N> {
    /// A place on a lamp.
    pub lamp: [N; 2],
    /// A direction.
    pub surface: [N; 3],
    /// Which lamp; one of a pair with the last of the direction.
    pub which: N,
    /// Whether the path goes on.
    pub survival: N,
    /// Which wavelength, where a path needs one.
    pub wavelength: N,
}

impl<N> Row<N> {
    /// The numbers in their order.
    #[inline(always)]
    pub fn of([a, b, c, d, e, which, survival, wavelength]: [N; ROW]) -> Self {
        Self { lamp: [a, b], surface: [c, d, e], which, survival, wavelength }
    }
}

/// Where numbers come from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Choice {
    /// The net.
    #[default]
    Net,
    /// A hash of everything: independent of each other.
    Independent,
}

/// The numbers of all paths.
#[derive(Clone, Debug)]
pub struct Points {
    /// Row upon row of a sample, sample upon sample.
    net: Vec<[u32; ROW]>,
    /// Rows a sample.
    rows: usize,
    /// Pairs of samples, a power of two.
    samples: u32,
    seed: u32,
}

/// The most rows a sample.
const MOST_ROWS: usize = 33;
/// The most rows in all: 16 MB.
const MOST: usize = 1 << 19;

impl Points {
    /// For so many pairs of samples a pixel, of so many vertices. More samples come as nets beside the first, the numbers of
    /// more vertices are independent.
    pub fn new(choice: Choice, pairs: u32, vertices: usize, seed: u64) -> Self {
        let seed = stirred(seed as u32, (seed >> 32) as u32);
        let rows = if choice == Choice::Net { (vertices + 1).min(MOST_ROWS) } else { 0 };
        let most = MOST_SOBOL.min(MOST / rows.max(1)) as u32;
        let samples = pairs.clamp(1, most).next_power_of_two().min(1 << most.ilog2());
        let row = |sample: u32, row: usize| {
            std::array::from_fn(|k| {
                let pair = (row * ROW + k) as u32 / 2;
                net(shuffled(sample, stirred(seed, !pair)), k as u32 % 2, stirred(seed, 2 * pair + k as u32 % 2))
            })
        };
        let net = (0..samples).flat_map(|sample| (0..rows).map(move |at| row(sample, at))).collect();
        Self { net, rows, samples, seed }
    }

    /// The numbers of a pixel.
    #[inline]
    pub fn of_pixel(&self, pixel: [u32; 2]) -> Stream<'_> {
        let key = stirred(stirred(self.seed, pixel[0]), pixel[1]);
        let keys = [stirred(key, 0), stirred(key, 1)];
        let shift = |key: u32, row: usize| std::array::from_fn(|k| stirred(key, (row * ROW + k) as u32));
        let shifts = (0..self.rows).flat_map(|row| keys.map(|key| shift(key, row))).collect();
        Stream { points: self, keys, shifts }
    }
}

/// The numbers of a pixel. Its samples come in pairs, the first and the second of which belong to two nets that know nothing
/// of each other: what differs between the two halves of a picture is its error.
#[derive(Clone, Debug)]
pub struct Stream<'a> {
    points: &'a Points,
    /// Of either half.
    keys: [u32; 2],
    /// Of every row those of both.
    shifts: Vec<[u32; ROW]>,
}

impl Stream<'_> {
    /// The row of a sample of the pixel at a vertex, that of the camera being 0; of each lane its own.
    #[inline(always)]
    pub fn row<N: Width>(&self, sample: impl Fn(usize) -> u32, vertex: impl Fn(usize) -> usize) -> [N; ROW] {
        N::columns(
            #[inline(always)]
            |lane| unit(self.bits(sample(lane), vertex(lane))),
        )
    }

    /// Whether all samples below `end` are the net's own.
    pub fn holds(&self, end: u32) -> bool {
        end.div_ceil(2) <= self.points.samples
    }

    /// Rows of a sample that are the net's own.
    pub fn rows(&self) -> usize {
        self.points.rows
    }

    /// One lane of [`Stream::row`].
    #[inline(always)]
    pub fn single<S: Copy + Default + From<f32>>(&self, sample: u32, vertex: usize) -> [S; ROW] {
        unit(self.bits(sample, vertex))
    }

    /// The same of a sample and a vertex that are the net's own ([`Stream::holds`], [`Stream::rows`]).
    #[inline(always)]
    pub fn single_of_net<S: Copy + Default + From<f32>>(&self, sample: u32, vertex: usize) -> [S; ROW] {
        unit(self.shifted(sample, vertex))
    }

    /// The row that a vertex asks for.
    #[inline(always)]
    pub fn at<N: Width>(&self, sample: impl Fn(usize) -> u32, vertex: impl Fn(usize) -> usize) -> Row<N> {
        Row::of(self.row(sample, vertex))
    }

    #[inline(always)]
    fn bits(&self, sample: u32, vertex: usize) -> [u32; ROW] {
        if vertex < self.points.rows {
            let block = sample / 2 / self.points.samples;
            let bits = self.shifted(sample - 2 * block * self.points.samples, vertex);
            if block == 0 { bits } else { self.moved(bits, sample, block, vertex) }
        } else {
            self.hashed(sample, vertex)
        }
    }

    /// The net again, elsewhere.
    #[inline(never)]
    fn moved(&self, bits: [u32; ROW], sample: u32, block: u32, vertex: usize) -> [u32; ROW] {
        let key = stirred(stirred(self.keys[sample as usize % 2], block), vertex as u32);
        std::array::from_fn(|k| bits[k] ^ stirred(key, k as u32))
    }

    #[inline(always)]
    fn shifted(&self, sample: u32, vertex: usize) -> [u32; ROW] {
        let (half, pair) = (sample as usize % 2, sample as usize / 2);
        let (row, shift) = (&self.points.net[pair * self.points.rows + vertex], &self.shifts[2 * vertex + half]);
        let mut bits = [0; ROW];
        for k in 0..ROW {
            bits[k] = row[k] ^ shift[k];
        }
        bits
    }

    #[inline(never)]
    fn hashed(&self, sample: u32, vertex: usize) -> [u32; ROW] {
        let key = stirred(stirred(self.keys[sample as usize % 2], sample), !(vertex as u32));
        std::array::from_fn(|k| stirred(key, k as u32))
    }
}

/// Two keys in one.
#[inline(always)]
fn stirred(one: u32, other: u32) -> u32 {
    <f32 as Number>::stirred(one, other)
}

/// The first 24 bits after the point: the same numbers in every width.
#[inline(always)]
fn unit<S: Copy + Default + From<f32>>(bits: [u32; ROW]) -> [S; ROW] {
    let mut unit = [S::default(); ROW];
    for k in 0..ROW {
        unit[k] = S::from((bits[k] >> 8) as i32 as f32 * (1.0 / 16_777_216.0));
    }
    unit
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::F32x8;
    use yardstick::statistics::{chi_square, sidak};

    const PAIRS: u32 = 256;

    fn numbers(stream: &Stream<'_>, vertex: usize, axis: usize, half: u32) -> Vec<f64> {
        (0..PAIRS).map(|pair| stream.row::<f64>(|_| 2 * pair + half, |_| vertex)[axis]).collect()
    }

    #[test]
    fn every_pair_of_numbers_of_a_pixel_is_a_net() {
        let points = Points::new(Choice::Net, PAIRS, 3, 5);
        let stream = points.of_pixel([3, 4]);
        for (vertex, axis, half) in [(0, 0, 0), (1, 2, 1), (2, 4, 0), (3, 6, 1)] {
            let (x, y) = (numbers(&stream, vertex, axis, half), numbers(&stream, vertex, axis + 1, half));
            // 256 points: one in every box of area 1/256, whatever its shape.
            for columns in [1, 2, 4, 8, 16, 32, 64, 128, 256_usize] {
                let rows = 256 / columns;
                let mut boxes = vec![0; 256];
                for (x, y) in x.iter().zip(&y) {
                    boxes[(x * columns as f64) as usize * rows + (y * rows as f64) as usize] += 1;
                }
                assert!(boxes.iter().all(|count| *count == 1), "vertex {vertex}, axis {axis}: {columns} by {rows}");
            }
        }
    }

    #[test]
    fn pixels_halves_and_pairs_know_nothing_of_each_other() {
        let points = Points::new(Choice::Net, PAIRS, 3, 6);
        let least = sidak(1e-4, 4);
        let mut grids = vec![vec![0_u64; 64]; 4];
        for pixel in 0..64 {
            let (here, beside) = (points.of_pixel([pixel, 9]), points.of_pixel([pixel + 1, 9]));
            let of = |stream: &Stream<'_>, vertex, axis, half| numbers(stream, vertex, axis, half)[pixel as usize % 7];
            let first = of(&here, 1, 0, 0);
            // One number a pixel of each, for the samples of one pixel do know each other.
            for (grid, other) in
                grids.iter_mut().zip([of(&here, 1, 0, 1), of(&beside, 1, 0, 0), of(&here, 1, 2, 0), of(&here, 2, 0, 0)])
            {
                grid[(first * 2.0) as usize * 2 + (other * 2.0) as usize] += 1;
            }
        }
        for grid in grids {
            let p = chi_square(&grid[..4], &[16.0; 4]).p;
            assert!(p > least, "{:?}: p = {p:.1e}", &grid[..4]);
        }
    }

    #[test]
    fn all_widths_have_the_same_numbers_and_they_never_end() {
        let points = Points::new(Choice::Net, 16, 2, 7);
        let stream = points.of_pixel([0, 0]);
        // Within the net, beyond its samples, and beyond its rows.
        for (sample, vertex) in [(3, 1), (1_000_003, 1), (3, 40), (u32::MAX, 1_000_000)] {
            let (lanes, one) = (
                stream.row::<F32x8>(|lane| sample - lane as u32 % 2, |_| vertex),
                stream.row::<f64>(|_| sample, |_| vertex),
            );
            for axis in 0..ROW {
                assert_eq!(lanes[axis].lane(0), one[axis]);
                assert!((0.0..1.0).contains(&one[axis]));
            }
        }
        let mean = |vertex: usize| {
            (0..4096).map(|sample| stream.row::<f64>(|_| 64 + sample, |_| vertex)[3]).sum::<f64>() / 4096.0
        };
        // Of independent numbers: 4.5 standard errors of 1/√(12 · 4096).
        assert!((mean(1) - 0.5).abs() < 0.0203 && (mean(99) - 0.5).abs() < 0.0203);
        let independent = Points::new(Choice::Independent, 16, 2, 7);
        // A second net, not the first again and no part of it.
        let second: Vec<f64> = (0..16).map(|pair| stream.row::<f64>(|_| 2 * (16 + pair), |_| 1)[3]).collect();
        let mut parts: Vec<usize> = second.iter().map(|x| (x * 16.0) as usize).collect();
        parts.sort_unstable();
        assert_eq!(parts, (0..16).collect::<Vec<_>>());
        assert_ne!(second, (0..16).map(|pair| stream.row::<f64>(|_| 2 * pair, |_| 1)[3]).collect::<Vec<_>>());
        assert_ne!(independent.of_pixel([0, 0]).row::<f64>(|_| 3, |_| 1), stream.row::<f64>(|_| 3, |_| 1));
    }
}
