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

/// A sum over pairs of samples.
#[derive(Clone, Debug, PartialEq)]
struct Branch {
    /// The first pair.
    start: u32,
    /// Pairs, a power of two that divides `start`.
    span: u32,
    /// Row by row.
    sums: Vec<Halves>,
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
        let span = range.end - range.start;
        assert!(span.is_power_of_two() && range.start.is_multiple_of(span), "{range:?} is no branch");
        assert_eq!(sums.len(), self.width as usize * self.height as usize, "a sum a pixel");
        self.insert(Branch { start: range.start, span, sums })
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
            self.free(branch.start..branch.start + branch.span)?;
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
        sums.iter().map(|halves| halves.map(|half| half.map(|sum| sum * scale))).collect()
    }

    fn free(&self, range: Range<u32>) -> Result<(), Clash> {
        let shared = self.branches.iter().find_map(|branch| {
            let both = range.start.max(branch.start)..range.end.min(branch.start + branch.span);
            (!both.is_empty()).then_some(both)
        });
        shared.map_or(Ok(()), |both| Err(Clash::Overlap(both)))
    }

    fn insert(&mut self, mut new: Branch) -> Result<(), Clash> {
        self.free(new.start..new.start + new.span)?;
        // Two halves of a branch are one, and that may be a half again.
        while let Some(at) = self.branches.iter().position(|branch| branch.is_other_half(&new)) {
            let other = self.branches.remove(at);
            let (mut first, second) = if other.start < new.start { (other, new) } else { (new, other) };
            first.sums.iter_mut().zip(&second.sums).for_each(|(sum, more)| *sum = added(*sum, *more));
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
