//! One formula, many widths: what a formula needs of a number, so that it can be written once for `f64`, for `f32` and
//! for eight or sixteen `f32` at a time.
//!
//! A formula over [`Number`] has no branch on data: it computes both ways and [`Number::select`]s. No lane ever sees
//! another, and nothing here is fused or left to a system's library, so that lanes give what as many `f32` give, bit
//! for bit and on every machine.

mod dice;
mod elementary;
mod frame;
mod lanes;
mod scalar;
#[cfg(test)]
mod tests;
mod vector;
mod width;

pub use dice::Dice;
pub use elementary::{Erfcx, atan2, beta, erfcx, exp, ln, ln_1p, polynomial, sin_cos_turns};
pub use frame::{Frame, length_and_way};
pub use lanes::{Eight, F32x8, F32x16, Sixteen};
pub use vector::Vector;
pub use width::Width;

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
use fearless_simd::{
    Level, Simd,
    x86::{Avx2, Avx512},
};
use std::fmt::Debug;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};
use std::sync::Arc;
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
use std::sync::LazyLock;

/// A truth value for every lane.
pub trait Mask: Copy + Debug + BitAnd<Output = Self> + BitOr<Output = Self> + Not<Output = Self> {
    /// How many there are.
    const LANES: usize;

    /// The same in every lane.
    fn of(value: bool) -> Self;
    /// Whether it is true in any lane.
    fn any(self) -> bool;
    /// Of one lane.
    fn lane(self, at: usize) -> bool;
    /// One bit a lane, the first lowest.
    fn bits(self) -> u32;

    /// The lanes where it is true, in order.
    #[inline(always)]
    fn lanes(self) -> impl Iterator<Item = usize> {
        let mut left = self.bits();
        std::iter::from_fn(
            #[inline(always)]
            move || {
                let lane = left.trailing_zeros() as usize;
                left &= left.wrapping_sub(1);
                // That it is one of them is for the compiler, which need not look then.
                (lane < Self::LANES).then_some(lane)
            },
        )
    }
}

impl Mask for bool {
    const LANES: usize = 1;

    #[inline(always)]
    fn of(value: bool) -> Self {
        value
    }
    #[inline(always)]
    fn any(self) -> bool {
        self
    }
    #[inline(always)]
    fn lane(self, _: usize) -> bool {
        self
    }
    #[inline(always)]
    fn bits(self) -> u32 {
        self.into()
    }
}

/// A real number, or several that are computed alike.
pub trait Number:
    Copy
    + Debug
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// What a comparison gives.
    type Mask: Mask;
    /// 32 bits a lane.
    type Bits: Copy + Debug;

    /// How many numbers it holds.
    const LANES: usize;
    /// The distance [1] from 1 to the next number.
    const EPSILON: f64;
    /// How far series have to be carried.
    const TERMS: Terms;

    /// `x`, rounded, in every lane.
    fn of(x: f64) -> Self;
    /// A number a lane, rounded.
    fn from_lanes(of: impl FnMut(usize) -> f64) -> Self;
    /// The number in one lane.
    fn lane(self, at: usize) -> f64;

    /// √x, correctly rounded.
    fn sqrt(self) -> Self;
    /// |x|.
    fn abs(self) -> Self;
    /// The smaller; `other` if either is NaN.
    fn min(self, other: Self) -> Self;
    /// The larger; `other` if either is NaN.
    fn max(self, other: Self) -> Self;
    /// x < `other`: false for NaN.
    fn lt(self, other: Self) -> Self::Mask;
    /// x ≤ `other`: false for NaN.
    fn le(self, other: Self) -> Self::Mask;
    /// `yes` where the mask is true, `no` elsewhere.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;

    /// The nearest whole number, for |x| < 2²².
    fn round(self) -> Self;
    /// 2^k for whole k within the range of normal numbers.
    fn power_of_two(k: Self) -> Self;
    /// (m, e) with x = m 2^e and √½ ≤ m < √2, for normal x > 0.
    fn split(self) -> (Self, Self);
    /// `table[x]` of every lane, for whole x within the table; its ends beyond.
    fn look_up(self, table: &[f64]) -> Self;
    /// Four entries of a table from a place on, for whole x ≥ 0 within it.
    fn look_up_four(self, table: &Table) -> [Self; 4];

    /// 32 bits that depend on all bits of x.
    fn bits(self) -> Self::Bits;
    /// Two keys stirred into one.
    fn stirred(one: Self::Bits, other: Self::Bits) -> Self::Bits;
    /// The `count`-th of the numbers in 0 ≤ u < 1, multiples of 2⁻²⁴, that belong to a key.
    fn dice(key: Self::Bits, count: u32) -> Self;

    /// x > `other`.
    #[inline(always)]
    fn gt(self, other: Self) -> Self::Mask {
        other.lt(self)
    }
    /// x ≥ `other`.
    #[inline(always)]
    fn ge(self, other: Self) -> Self::Mask {
        other.le(self)
    }
    /// x².
    #[inline(always)]
    fn squared(self) -> Self {
        self * self
    }
    /// x where the mask is true, 0 elsewhere.
    #[inline(always)]
    fn only(self, mask: Self::Mask) -> Self {
        Self::select(mask, self, Self::of(0.0))
    }
    /// x between `low` and `high`; `low` if NaN.
    #[inline(always)]
    fn clamp(self, low: f64, high: f64) -> Self {
        self.max(Self::of(low)).min(Self::of(high))
    }
}

/// The most lanes of any width.
pub const MOST_LANES: usize = 16;

/// Numbers to be looked up, as each width would have them.
#[derive(Clone, Debug)]
pub struct Table {
    entries: Arc<[f64]>,
    /// The same, and some more so that four can be loaded from any.
    rounded: Arc<[f32]>,
}

impl Table {
    /// Of its entries.
    pub fn new(entries: Arc<[f64]>) -> Self {
        let rounded = entries.iter().map(|x| *x as f32).chain([0.0; 4]).collect();
        Self { entries, rounded }
    }
}

impl std::ops::Deref for Table {
    type Target = [f64];
    fn deref(&self) -> &[f64] {
        &self.entries
    }
}

/// Terms that a width's series need, so that what is left out is below its rounding.
#[derive(Clone, Copy, Debug)]
pub struct Terms {
    /// Of sin x/x and cos x for |x| ≤ π/4.
    pub sine: usize,
    /// Of e^x for |x| ≤ ½ ln 2.
    pub exponential: usize,
    /// Of artanh x/x for |x| ≤ 3 − 2√2.
    pub logarithm: usize,
    /// Of arctan x/x for |x| ≤ tan(π/16).
    pub arctangent: usize,
    /// Steps of the midpoint rule for erfcx, and their length [1].
    pub gaussian: (usize, f64),
    /// The least exponent [1] of e that gives a normal number.
    pub least_exponent: f64,
}

/// Runs `work` with the widest instructions that the machine has: what is inlined into it and works on [`F32x8`] becomes
/// vector code. The numbers are the same with and without.
#[inline]
pub fn vectorised<R>(work: impl FnOnce() -> R) -> R {
    // Two copies of the work, not three: what lies between the oldest machines and these gains little.
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    if let Some(avx2) = avx2() {
        return avx2.vectorize(work);
    }
    work()
}

/// What the machine has.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
static WIDEST: LazyLock<Level> = LazyLock::new(Level::new);

/// The instructions of machines since 2013, if this is one.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
#[inline(always)]
pub(crate) fn avx2() -> Option<Avx2> {
    WIDEST.as_avx2()
}

/// Those of machines with vectors of sixteen `f32`, if this is one.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
#[inline(always)]
fn avx512() -> Option<Avx512> {
    WIDEST.as_avx512()
}

/// How many lanes are worth it on this machine: 1, 8 or 16.
pub fn best_lanes() -> usize {
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    return if avx512().is_some() {
        16
    } else if avx2().is_some() {
        8
    } else {
        1
    };
    #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
    8
}

/// Runs `work` with the instructions that are as wide as `N`, and once for each width, not for each width and machine: the
/// code is large.
///
/// # Panics
/// If the machine has none as wide: `N` has more than [`best_lanes`].
#[inline(always)]
pub fn vectorised_lanes<N: Number, R>(work: impl FnOnce() -> R) -> R {
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    match N::LANES {
        1 => work(),
        16 => avx512().expect("sixteen lanes are asked of machines that have them").vectorize(work),
        _ => avx2().expect("eight lanes are asked of machines that have them").vectorize(work),
    }
    #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
    work()
}
