//! Sums of samples, so kept that no order of rendering can be told from them.
//!
//! A sample has a number, and numbers come in pairs: the first of a pair belongs to one half of the picture, the second to
//! the other, whose random numbers know nothing of each other. The sum over a range of pairs is that of a fixed tree, whose
//! branches span a power of two of pairs and begin at a multiple of it: whoever renders the parts, in whatever order and
//! split, gets the same bits. Pairwise sums lose about log₂ n roundings, so that `f32` is enough.

use crate::bsdf::Rgb;
use std::ops::Range;

/// The sums of a pixel's two halves [W m⁻² sr⁻¹].
pub type Halves = [Rgb<f32>; 2];

/// Binary digits of a unit of [`Splats`] below the brightest lamp: 2⁻⁴⁰ of it is nothing, and 2²³ of it have room.
pub const UNITS: i32 = 40;

/// Light that paths from lamps have brought, row by row, in whole numbers of a unit: whoever adds it, in whatever order,
/// gets the same.
#[derive(Clone, Debug, PartialEq)]
pub struct Splats {
    /// The power of two that is a unit [W m⁻² sr⁻¹].
    exponent: i32,
    /// Of each pixel both halves; [`NO_NUMBER`] where there is none.
    sums: Vec<[[i64; 3]; 2]>,
}

/// Stands for what was not finite, or no longer fits, and stays.
const NO_NUMBER: i64 = i64::MIN;

impl Splats {
    /// None yet, in a unit of 2^`exponent`.
    pub fn none(pixels: usize, exponent: i32) -> Self {
        Self { exponent, sums: vec![[[0; 3]; 2]; pixels] }
    }

    /// The unit's exponent and the sums, for who writes them down.
    pub fn parts(&self) -> (i32, &[[[i64; 3]; 2]]) {
        (self.exponent, &self.sums)
    }

    /// From what was written down.
    pub fn of_parts(exponent: i32, sums: Vec<[[i64; 3]; 2]>) -> Self {
        Self { exponent, sums }
    }

    /// More light for a half of a pixel; of one wavelength a channel's may be below 0.
    pub fn add(&mut self, pixel: usize, half: usize, light: Rgb<f64>) {
        let unit = f64::from(self.exponent).exp2();
        for (sum, light) in self.sums[pixel][half].iter_mut().zip(light) {
            let count = (light / unit).round();
            // Below 2⁶²; a comparison is false of what is not a number.
            let count = if count.abs() < 4.6e18 { count as i64 } else { NO_NUMBER };
            *sum = counted(*sum, count);
        }
    }

    /// With all that another has, of as many pixels and the same unit.
    pub fn merge(&mut self, other: &Self) {
        debug_assert!(self.exponent == other.exponent && self.sums.len() == other.sums.len());
        for (own, more) in self.sums.iter_mut().flatten().flatten().zip(other.sums.iter().flatten().flatten()) {
            *own = counted(*own, *more);
        }
    }

    /// The light of a pixel's halves [W m⁻² sr⁻¹]; not a number where something was not.
    pub fn light(&self, pixel: usize) -> [Rgb<f64>; 2] {
        let unit = f64::from(self.exponent).exp2();
        let light = |count: i64| if count == NO_NUMBER { f64::NAN } else { count as f64 * unit };
        self.sums[pixel].map(|half| half.map(light))
    }
}

/// The sum of counts: once it is no number or does not fit, it stays so, in whatever order as long as none is below 0.
fn counted(a: i64, b: i64) -> i64 {
    if a == NO_NUMBER || b == NO_NUMBER { NO_NUMBER } else { a.checked_add(b).unwrap_or(NO_NUMBER) }
}

/// A sum over pairs of samples.
#[derive(Clone, Debug, PartialEq)]
struct Branch {
    /// The first pair.
    start: u32,
    /// Pairs, a power of two that divides `start`.
    span: u32,
    /// Row by row.
    sums: Vec<Halves>,
    /// What their paths from lamps have brought; None where none are sent.
    splats: Option<Splats>,
}

/// Sums of samples of every pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    width: u32,
    height: u32,
    /// In order, no two of them halves of one.
    branches: Vec<Branch>,
}

/// Why two films cannot be one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Clash {
    /// Width and height [pixels] of both.
    Size([[u32; 2]; 2]),
    /// Pairs that both have.
    Overlap(Range<u32>),
    /// Light of paths from lamps, in one and not in the other, or in another unit.
    Light,
}

impl Film {
    /// Without a sample.
    pub fn new(width: u32, height: u32) -> Self {
        Self { width, height, branches: Vec::new() }
    }

    /// [pixels].
    pub fn size(&self) -> [u32; 2] {
        [self.width, self.height]
    }

    /// Pairs of samples a pixel.
    pub fn pairs(&self) -> u32 {
        self.branches.iter().map(|branch| branch.span).sum()
    }

    /// Which pairs it has, in order, as few ranges as can be.
    pub fn ranges(&self) -> Vec<Range<u32>> {
        let mut ranges: Vec<Range<u32>> = Vec::new();
        for branch in &self.branches {
            let (start, end) = (branch.start, branch.start + branch.span);
            match ranges.last_mut() {
                Some(last) if last.end == start => last.end = end,
                _ => ranges.push(start..end),
            }
        }
        ranges
    }

    /// The branches that make it up, in order, and their sums.
    pub fn branches(&self) -> impl ExactSizeIterator<Item = (Range<u32>, &[Halves])> {
        self.branches.iter().map(|branch| (branch.start..branch.start + branch.span, &branch.sums[..]))
    }

    /// With the sums over one more branch, row by row.
    ///
    /// # Errors
    /// If it has some of these pairs.
    ///
    /// # Panics
    /// If the range is no branch of the tree ([`branches`]), or there is not a sum a pixel.
    pub fn add(&mut self, range: Range<u32>, sums: Vec<Halves>) -> Result<(), Clash> {
        self.add_lit(range, sums, None)
    }

    /// The same with the light that paths from lamps have brought in these pairs ([`super::caustics::splats`]).
    ///
    /// # Errors
    /// If it has some of these pairs, or has pairs without such light or in another unit.
    ///
    /// # Panics
    /// As [`Film::add`], and if there is not such a sum a pixel.
    pub fn add_lit(&mut self, range: Range<u32>, sums: Vec<Halves>, splats: Option<Splats>) -> Result<(), Clash> {
        let span = range.end - range.start;
        assert!(span.is_power_of_two() && range.start.is_multiple_of(span), "{range:?} is no branch");
        let pixels = self.width as usize * self.height as usize;
        let lit = splats.as_ref().map_or(pixels, |splats| splats.sums.len());
        assert_eq!([sums.len(), lit], [pixels; 2], "a sum a pixel");
        self.insert(Branch { start: range.start, span, sums, splats })
    }

    /// Of every branch the range of pairs, the sums and what paths from lamps have brought, for who writes them down.
    pub fn parts(&self) -> impl Iterator<Item = (Range<u32>, &[Halves], Option<&Splats>)> {
        self.branches.iter().map(|one| (one.start..one.start + one.span, &*one.sums, one.splats.as_ref()))
    }

    /// With all that another has.
    ///
    /// # Errors
    /// If it is of another size, or has some of the same pairs; then nothing has changed.
    pub fn merge(&mut self, other: Self) -> Result<(), Clash> {
        if self.size() != other.size() {
            return Err(Clash::Size([self.size(), other.size()]));
        }
        for branch in &other.branches {
            self.free(branch)?;
        }
        other.branches.into_iter().try_for_each(|branch| self.insert(branch))
    }

    /// The means of both halves, row by row; black without samples.
    pub fn halves(&self) -> Vec<Halves> {
        let scale = 1.0 / self.pairs().max(1) as f32;
        let mut sums = vec![[[0.0; 3]; 2]; self.width as usize * self.height as usize];
        // From the smallest branch on, as the tree would.
        let mut order: Vec<&Branch> = self.branches.iter().collect();
        order.sort_by_key(|branch| (branch.span, branch.start));
        for branch in order {
            sums.iter_mut().zip(&branch.sums).for_each(|(sum, more)| *sum = added(*sum, *more));
        }
        let mut splats: Option<Splats> = None;
        for more in self.branches.iter().filter_map(|branch| branch.splats.as_ref()) {
            match &mut splats {
                Some(all) => all.merge(more),
                None => splats = Some(more.clone()),
            }
        }
        let Some(splats) = splats else {
            return sums.iter().map(|halves| halves.map(|half| half.map(|sum| sum * scale))).collect();
        };
        let lit = |(pixel, halves): (usize, &Halves)| {
            let light = splats.light(pixel);
            let mean = |half: usize, c: usize| (halves[half][c] + light[half][c] as f32) * scale;
            [0, 1].map(|half| [0, 1, 2].map(|c| mean(half, c)))
        };
        sums.iter().enumerate().map(lit).collect()
    }

    fn free(&self, new: &Branch) -> Result<(), Clash> {
        let unit = |branch: &Branch| branch.splats.as_ref().map(|splats| splats.exponent);
        if self.branches.first().is_some_and(|own| unit(own) != unit(new)) {
            return Err(Clash::Light);
        }
        let range = new.start..new.start + new.span;
        let shared = self.branches.iter().find_map(|branch| {
            let both = range.start.max(branch.start)..range.end.min(branch.start + branch.span);
            (!both.is_empty()).then_some(both)
        });
        shared.map_or(Ok(()), |both| Err(Clash::Overlap(both)))
    }

    fn insert(&mut self, mut new: Branch) -> Result<(), Clash> {
        self.free(&new)?;
        // Two halves of a branch are one, and that may be a half again.
        while let Some(at) = self.branches.iter().position(|branch| branch.is_other_half(&new)) {
            let other = self.branches.remove(at);
            let (mut first, second) = if other.start < new.start { (other, new) } else { (new, other) };
            first.sums.iter_mut().zip(&second.sums).for_each(|(sum, more)| *sum = added(*sum, *more));
            if let (Some(splats), Some(more)) = (&mut first.splats, &second.splats) {
                splats.merge(more);
            }
            new = Branch { span: 2 * first.span, ..first };
        }
        let at = self.branches.partition_point(|branch| branch.start < new.start);
        self.branches.insert(at, new);
        Ok(())
    }
}

impl Branch {
    fn is_other_half(&self, other: &Self) -> bool {
        self.span == other.span && self.start ^ other.start == self.span
    }
}

/// Sum by sum.
#[inline]
pub fn added(a: Halves, b: Halves) -> Halves {
    std::array::from_fn(|half| std::array::from_fn(|c| a[half][c] + b[half][c]))
}

/// The branches of the tree that make up a range of pairs, in order.
pub fn branches(range: Range<u32>) -> impl Iterator<Item = Range<u32>> {
    let mut start = range.start;
    std::iter::from_fn(move || {
        let left = range.end.checked_sub(start).filter(|left| *left > 0)?;
        let largest = if start == 0 { 1 << 31 } else { 1_u32 << start.trailing_zeros() };
        let span = largest.min(1 << left.ilog2());
        let branch = start..start + span;
        start += span;
        Some(branch)
    })
}

/// The tree's sum over a branch of what its pairs have.
pub fn tree(pairs: &[Halves]) -> Halves {
    match pairs {
        [] => [[0.0; 3]; 2],
        [one] => *one,
        _ => {
            let (first, second) = pairs.split_at(pairs.len() / 2);
            added(tree(first), tree(second))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// What a pair of a pixel has: numbers whose sums round.
    fn pair(pixel: usize, number: u32) -> Halves {
        let value =
            |k: u32| ((number * 7 + k * 13 + pixel as u32 * 5) as f32).sin() * 1e3f32.powi((number % 5) as i32 - 2);
        [[value(0), value(1), value(2)], [value(3), value(4), value(5)]]
    }

    fn rendered(film: &mut Film, range: Range<u32>) -> Result<(), Clash> {
        for branch in branches(range) {
            let sums = (0..6).map(|pixel| tree(&branch.clone().map(|k| pair(pixel, k)).collect::<Vec<_>>()));
            film.add(branch.clone(), sums.collect())?;
        }
        Ok(())
    }

    proptest! {
        /// Any cuts, rendered in any order, on any two films.
        #[test]
        fn no_split_and_no_order_can_be_told(
            mut cuts in proptest::collection::vec(0_u32..200, 0..6),
            order in any::<u64>(),
            owners in any::<u32>(),
        ) {
            let mut whole = Film::new(3, 2);
            rendered(&mut whole, 0..200).expect("new");
            cuts.extend([0, 200]);
            cuts.sort_unstable();
            let mut parts: Vec<Range<u32>> = cuts.windows(2).map(|ends| ends[0]..ends[1]).collect();
            let at = order as usize % parts.len();
            parts.rotate_left(at);
            let mut films = [Film::new(3, 2), Film::new(3, 2)];
            for (k, part) in parts.into_iter().enumerate() {
                rendered(&mut films[(owners >> k & 1) as usize], part).expect("no overlap");
            }
            let [mut one, other] = films;
            one.merge(other).expect("no overlap");
            prop_assert_eq!(one, whole);
        }
    }

    #[test]
    fn what_a_film_has_it_does_not_take_again() {
        let mut film = Film::new(3, 2);
        rendered(&mut film, 0..10).expect("new");
        let mut other = Film::new(3, 2);
        rendered(&mut other, 9..12).expect("new");
        let before = film.clone();
        assert_eq!(film.merge(other), Err(Clash::Overlap(9..10)));
        assert_eq!(film.merge(Film::new(2, 3)), Err(Clash::Size([[3, 2], [2, 3]])));
        assert_eq!(film, before);
        assert_eq!(film.ranges(), vec![0..10; 1]);
        assert_eq!(film.pairs(), 10);
    }

    #[test]
    fn light_that_is_no_number_stays_none() {
        let add = |order: [f64; 3]| {
            let mut splats = Splats::none(1, -10);
            order.into_iter().for_each(|light| splats.add(0, 1, [light, 1.0, 0.0]));
            splats
        };
        for bad in [f64::NAN, f64::INFINITY, 1e30] {
            let splats = add([0.5, bad, 0.25]);
            assert_eq!(splats, add([bad, 0.25, 0.5]));
            let [[first, ..], [light, next, _]] = splats.light(0);
            assert!(first == 0.0 && light.is_nan() && next == 3.0, "{bad}");
        }
        // What no longer fits is seen, in whatever order: three times 2⁶¹ units.
        let large = 2f64.powi(61 - 10);
        assert!(add([large; 3]).light(0)[1][0] == 3.0 * large);
        let mut twice = add([large; 3]);
        twice.merge(&add([large; 3]));
        assert!(twice.light(0)[1][0].is_nan());
        let mut film = Film::new(1, 1);
        film.add_lit(0..1, vec![[[1.0; 3]; 2]], Some(add([f64::NAN, 0.0, 0.0]))).expect("new");
        let [[first, second]] = film.halves()[..] else { panic!("one pixel") };
        assert!(first == [1.0; 3] && second[0].is_nan() && second[1] == 4.0);
    }

    #[test]
    fn means_are_those_of_the_pairs() {
        let mut film = Film::new(3, 2);
        rendered(&mut film, 5..42).expect("new");
        for (pixel, halves) in film.halves().into_iter().enumerate() {
            for (half, c) in [(0, 0), (1, 2)] {
                let exact = (5..42).map(|k| f64::from(pair(pixel, k)[half][c])).sum::<f64>() / 37.0;
                let size = (5..42).map(|k| f64::from(pair(pixel, k)[half][c]).abs()).sum::<f64>() / 37.0;
                // Six levels of the tree and six branches.
                assert!((f64::from(halves[half][c]) - exact).abs() <= 13.0 * f64::from(f32::EPSILON) * size);
            }
        }
    }

    #[test]
    fn branches_begin_at_their_own_multiples() {
        assert!(branches(0..0).next().is_none());
        assert_eq!(branches(0..256).collect::<Vec<_>>(), vec![0..256]);
        assert_eq!(branches(3..13).collect::<Vec<_>>(), vec![3..4, 4..8, 8..12, 12..13]);
    }
}
