//! Numbers in memory where the processor loads them fastest.

use std::ops::{Deref, DerefMut};

/// What a vector of four `f64` must start at a multiple of [numbers], lest every other one straddle two lines of cache.
pub(super) const VECTOR: usize = 4;

/// A fixed number of `f64`, of which a chosen one starts a vector.
#[derive(Debug, Default)]
pub(super) struct Aligned {
    values: Vec<f64>,
    start: usize,
    len: usize,
    first: usize,
}

impl Aligned {
    /// `len` zeros; the one with index `first`, below [`VECTOR`], starts a vector.
    pub fn zeros(len: usize, first: usize) -> Self {
        let values = vec![0.0; len + 2 * VECTOR];
        // Where alignment cannot be had, any start is as right.
        let boundary = values.as_ptr().align_offset(VECTOR * size_of::<f64>()).min(VECTOR);
        Self { values, start: boundary + VECTOR - first, len, first }
    }
}

impl Clone for Aligned {
    /// A copy lies elsewhere, and aligns anew.
    fn clone(&self) -> Self {
        let mut copy = Self::zeros(self.len, self.first);
        copy.copy_from_slice(self);
        copy
    }
}

impl Deref for Aligned {
    type Target = [f64];

    #[inline(always)]
    fn deref(&self) -> &[f64] {
        &self.values[self.start..self.start + self.len]
    }
}

impl DerefMut for Aligned {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut [f64] {
        &mut self.values[self.start..self.start + self.len]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_copy_is_aligned_as_its_original() {
        for (len, first) in [(0, 0), (1, 1), (17, 0), (17, 1), (300, 3)] {
            let mut numbers = Aligned::zeros(len, first);
            numbers.iter_mut().enumerate().for_each(|(k, value)| *value = k as f64);
            for numbers in [numbers.clone(), numbers] {
                assert!(numbers.iter().enumerate().all(|(k, value)| *value == k as f64));
                if len > first {
                    assert_eq!(numbers[first..].as_ptr().align_offset(VECTOR * size_of::<f64>()), 0);
                }
            }
        }
    }
}
