//! Eight `f32` at once: a plain array, which the compiler turns into the vectors of the machine it is dispatched to.

use super::{Mask, Number, Table, Terms};
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
use fearless_simd::{Simd, SimdFrom, f32x4, i32x8, prelude::*};
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// Eight things side by side.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(32))]
pub struct Eight<T>(pub [T; 8]);

/// Eight `f32`.
pub type F32x8 = Eight<f32>;

/// Lane by lane, written out: an array's own `map` is a call, which would not know of the machine's wider instructions.
macro_rules! lanes {
    ($lane:ident => $value:expr) => {
        Eight([
            {
                let $lane = 0;
                $value
            },
            {
                let $lane = 1;
                $value
            },
            {
                let $lane = 2;
                $value
            },
            {
                let $lane = 3;
                $value
            },
            {
                let $lane = 4;
                $value
            },
            {
                let $lane = 5;
                $value
            },
            {
                let $lane = 6;
                $value
            },
            {
                let $lane = 7;
                $value
            },
        ])
    };
}

impl<T: Copy> Eight<T> {
    #[inline(always)]
    fn map<U>(self, f: impl Fn(T) -> U) -> Eight<U> {
        lanes!(i => f(self.0[i]))
    }

    #[inline(always)]
    fn zip<U: Copy, V>(self, other: Eight<U>, f: impl Fn(T, U) -> V) -> Eight<V> {
        lanes!(i => f(self.0[i], other.0[i]))
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident, $type:ty, $operator:tt) => {
        impl $trait for Eight<$type> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.zip(other, |a, b| a $operator b)
            }
        }
    };
}

operator!(Add, add, f32, +);
operator!(Sub, sub, f32, -);
operator!(Mul, mul, f32, *);
operator!(Div, div, f32, /);
operator!(BitAnd, bitand, u32, &);
operator!(BitOr, bitor, u32, |);

impl Neg for F32x8 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(|a| -a)
    }
}

impl Not for Eight<u32> {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        self.map(|a| !a)
    }
}

/// All bits of a lane or none, as the machine's own masks are.
impl Mask for Eight<u32> {
    #[inline(always)]
    fn of(value: bool) -> Self {
        Self([all(value); 8])
    }
    #[inline(always)]
    fn any(self) -> bool {
        self.bits() != 0
    }
    #[inline(always)]
    fn lane(self, at: usize) -> bool {
        self.0[at] != 0
    }
    #[inline(always)]
    fn bits(self) -> u32 {
        // By the machine's own instruction: bits taken out of lanes one by one break up all that made them.
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        if let Some(avx2) = super::avx2() {
            return avx2.vectorize(
                #[inline(always)]
                || i32x8::simd_from(avx2, self.0.map(|bits| bits as i32)).simd_lt(0).to_bitmask() as u32,
            );
        }
        let mut bits = 0;
        for lane in 0..8 {
            bits |= (self.0[lane] & 1) << lane;
        }
        bits
    }
}

/// Columns of eight rows: lane by lane one of each.
#[inline(always)]
pub(super) fn transposed<const K: usize>(rows: &[[f32; K]; 8]) -> [F32x8; K] {
    let mut columns = [Eight([0.0; 8]); K];
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    if let Some(avx2) = super::avx2() {
        let whole = K / 4 * 4;
        for start in (0..whole).step_by(4) {
            avx2.vectorize(
                #[inline(always)]
                || four(avx2, rows, &mut columns, start),
            );
        }
        for (lane, row) in rows.iter().enumerate() {
            for column in whole..K {
                columns[column].0[lane] = row[column];
            }
        }
        return columns;
    }
    for (lane, row) in rows.iter().enumerate() {
        for column in 0..K {
            columns[column].0[lane] = row[column];
        }
    }
    columns
}

/// Four columns from `start` on, by rounds of interleaving within quarters: a compiler left alone moves the 64 numbers one
/// by one.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
#[inline(always)]
fn four<M: Simd, const K: usize>(machine: M, rows: &[[f32; K]; 8], columns: &mut [F32x8; K], start: usize) {
    macro_rules! quarter {
        ($lane:literal) => {{
            let row = |lane: usize| f32x4::from_slice(machine, &rows[lane][start..start + 4]);
            let ((a, b), (c, d)) = (row($lane).interleave(row($lane + 2)), row($lane + 1).interleave(row($lane + 3)));
            // a: 0 2 of columns 0 and 1, c: 1 3 of them, and so on.
            let ((a, b), (c, d)) = (a.interleave(c), b.interleave(d));
            [a, b, c, d]
        }};
    }
    let (upper, lower) = (quarter!(0), quarter!(4));
    for column in 0..4 {
        columns[start + column].0 = upper[column].combine(lower[column]).into();
    }
}

/// All bits if true.
#[inline(always)]
fn all(value: bool) -> u32 {
    if value { u32::MAX } else { 0 }
}

impl Number for F32x8 {
    type Mask = Eight<u32>;
    type Bits = Eight<u32>;
    const LANES: usize = 8;
    const EPSILON: f64 = f32::EPSILON as f64;
    const TERMS: Terms = <f32 as Number>::TERMS;

    #[inline(always)]
    fn of(x: f64) -> Self {
        Self([x as f32; 8])
    }
    #[inline(always)]
    fn from_lanes(mut of: impl FnMut(usize) -> f64) -> Self {
        lanes!(i => of(i) as f32)
    }
    #[inline(always)]
    fn lane(self, at: usize) -> f64 {
        self.0[at].into()
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        self.map(f32::sqrt)
    }
    #[inline(always)]
    fn abs(self) -> Self {
        self.map(f32::abs)
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        self.zip(other, Number::min)
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.zip(other, Number::max)
    }
    #[inline(always)]
    fn lt(self, other: Self) -> Eight<u32> {
        self.zip(other, |a, b| all(a < b))
    }
    #[inline(always)]
    fn le(self, other: Self) -> Eight<u32> {
        self.zip(other, |a, b| all(a <= b))
    }
    #[inline(always)]
    fn select(mask: Eight<u32>, yes: Self, no: Self) -> Self {
        lanes!(i => f32::from_bits(yes.0[i].to_bits() & mask.0[i] | no.0[i].to_bits() & !mask.0[i]))
    }
    #[inline(always)]
    fn round(self) -> Self {
        self.map(Number::round)
    }
    #[inline(always)]
    fn power_of_two(k: Self) -> Self {
        k.map(Number::power_of_two)
    }
    #[inline(always)]
    fn split(self) -> (Self, Self) {
        let parts = self.map(Number::split);
        (parts.map(|(mantissa, _)| mantissa), parts.map(|(_, exponent)| exponent))
    }
    #[inline(always)]
    fn look_up(self, table: &[f64]) -> Self {
        self.map(|x| x.look_up(table))
    }
    #[inline(always)]
    fn look_up_four(self, table: &Table) -> [Self; 4] {
        let mut rows = [[0.0; 4]; 8];
        for (row, x) in rows.iter_mut().zip(self.0) {
            let at = (x as usize).min(table.rounded.len() - 4);
            row.copy_from_slice(&table.rounded[at..at + 4]);
        }
        transposed(&rows)
    }
    #[inline(always)]
    fn bits(self) -> Eight<u32> {
        self.map(Number::bits)
    }
    #[inline(always)]
    fn stirred(one: Eight<u32>, other: Eight<u32>) -> Eight<u32> {
        one.zip(other, <f32 as Number>::stirred)
    }
    #[inline(always)]
    fn dice(key: Eight<u32>, count: u32) -> Self {
        key.map(|key| Number::dice(key, count))
    }
}
