//! More random numbers out of a few: what a walk of unknown length throws, from the three numbers it was given.

use super::Number;

/// A stream of numbers in 0 ≤ u < 1 that depends on its key alone. Any two throws of any two keys are unrelated as far
/// as a hash can make them; it is for walks of tens of throws, not for cryptography.
#[derive(Clone, Copy, Debug)]
pub struct Dice<N: Number> {
    state: N::Bits,
    count: u32,
}

impl<N: Number> Dice<N> {
    /// The stream that belongs to two numbers.
    #[inline(always)]
    pub fn new(one: N, other: N) -> Self {
        Self { state: N::stirred(one.bits(), other.bits()), count: 0 }
    }

    /// The next number.
    #[inline(always)]
    pub fn throw(&mut self) -> N {
        self.count += 1;
        N::dice(self.state, self.count)
    }
}

/// Two keys in one.
#[inline(always)]
pub(super) fn stirred(one: u32, other: u32) -> u32 {
    mixed(one ^ other.rotate_left(16).wrapping_mul(0x9e37_79b1))
}

/// A number of a stream, a multiple of 2⁻²⁴.
#[inline(always)]
pub(super) fn thrown(state: u32, count: u32) -> f32 {
    let bits = mixed(state.wrapping_add(count.wrapping_mul(0x9e37_79b9)));
    // As a signed number, for which every machine has an instruction.
    (bits >> 8) as i32 as f32 * (1.0 / 16_777_216.0)
}

/// 32 bits stirred (C. Wellons, *Prospecting for hash functions* (2018), the one called lowbias32; in the public domain).
#[inline(always)]
fn mixed(bits: u32) -> u32 {
    let bits = (bits ^ (bits >> 16)).wrapping_mul(0x7feb_352d);
    let bits = (bits ^ (bits >> 15)).wrapping_mul(0x846c_a68b);
    bits ^ (bits >> 16)
}
