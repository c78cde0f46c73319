//! Eight or sixteen `f32` at once: plain arrays, which the compiler turns into the vectors of the machine they are dispatched to.

use super::{Mask, Number, Table, Terms, Width};
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
use fearless_simd::{Simd, SimdFrom, f32x4, i32x8, i32x16, prelude::*};
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// Eight `f32`.
pub type F32x8 = Eight<f32>;

/// Sixteen `f32`.
pub type F32x16 = Sixteen<f32>;

/// All bits if true.
#[inline(always)]
fn all(value: bool) -> u32 {
    if value { u32::MAX } else { 0 }
}

macro_rules! operator {
    ($pack:ident, $trait:ident, $method:ident, $type:ty, $operator:tt) => {
        impl $trait for $pack<$type> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.zip(other, |a, b| a $operator b)
            }
        }
    };
}

/// So many things side by side, and what a number is that is made of them. Lane by lane, written out: an array's own `map` is a
/// call, which would not know of the machine's wider instructions.
macro_rules! pack {
    ($(#[$doc:meta])* $pack:ident, $count:literal of [$($lane:literal)*], $align:literal, $machine:ident, $whole:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[repr(align($align))]
        pub struct $pack<T>(pub [T; $count]);

        impl<T: Copy> $pack<T> {
            #[inline(always)]
            fn map<U>(self, f: impl Fn(T) -> U) -> $pack<U> {
                $pack([$(f(self.0[$lane])),*])
            }

            #[inline(always)]
            fn zip<U: Copy, V>(self, other: $pack<U>, f: impl Fn(T, U) -> V) -> $pack<V> {
                $pack([$(f(self.0[$lane], other.0[$lane])),*])
            }
        }

        operator!($pack, Add, add, f32, +);
        operator!($pack, Sub, sub, f32, -);
        operator!($pack, Mul, mul, f32, *);
        operator!($pack, Div, div, f32, /);
        operator!($pack, BitAnd, bitand, u32, &);
        operator!($pack, BitOr, bitor, u32, |);

        impl Neg for $pack<f32> {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                self.map(|a| -a)
            }
        }

        impl Not for $pack<u32> {
            type Output = Self;
            #[inline(always)]
            fn not(self) -> Self {
                self.map(|a| !a)
            }
        }

        /// All bits of a lane or none, as the machine's own masks are.
        impl Mask for $pack<u32> {
            const LANES: usize = $count;

            #[inline(always)]
            fn of(value: bool) -> Self {
                Self([all(value); $count])
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
                if let Some(machine) = super::$machine() {
                    return machine.vectorize(
                        #[inline(always)]
                        || $whole::simd_from(machine, self.map(|bits| bits as i32).0).simd_lt(0).to_bitmask() as u32,
                    );
                }
                let mut bits = 0;
                for lane in 0..$count {
                    bits |= (self.0[lane] & 1) << lane;
                }
                bits
            }
        }

        impl $pack<f32> {
            /// Columns of as many rows: lane by lane one of each.
            #[inline(always)]
            fn transposed<const K: usize>(rows: &[[f32; K]; $count]) -> [Self; K] {
                let mut columns = [$pack([0.0; $count]); K];
                #[cfg_attr(not(any(target_arch = "x86", target_arch = "x86_64")), allow(unused_mut))]
                let mut start = 0;
                #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
                if let Some(avx2) = super::avx2() {
                    while start + 4 <= K {
                        for lane in (0..$count).step_by(8) {
                            let block = avx2.vectorize(
                                #[inline(always)]
                                || four(avx2, &rows[lane..lane + 8], start),
                            );
                            for column in 0..4 {
                                columns[start + column].0[lane..lane + 8].copy_from_slice(&block[column]);
                            }
                        }
                        start += 4;
                    }
                }
                for (lane, row) in rows.iter().enumerate() {
                    for column in start..K {
                        columns[column].0[lane] = row[column];
                    }
                }
                columns
            }
        }

        impl Width for $pack<f32> {
            type Scalar = f32;
            type Pack = F32x8;
            #[inline(always)]
            fn all(x: f32) -> Self {
                Self([x; $count])
            }
            #[inline(always)]
            fn each(mut of: impl FnMut(usize) -> f32) -> Self {
                let mut all = Self([0.0; $count]);
                for lane in 0..$count {
                    all.0[lane] = of(lane);
                }
                all
            }
            #[inline(always)]
            fn get(self, lane: usize) -> f32 {
                self.0[lane]
            }
            #[inline(always)]
            fn place(self, lane: usize) -> usize {
                self.0[lane] as usize
            }
            #[inline(always)]
            fn columns<const K: usize>(mut rows: impl FnMut(usize) -> [f32; K]) -> [Self; K] {
                let mut all = [[0.0; K]; $count];
                for (lane, row) in all.iter_mut().enumerate() {
                    *row = rows(lane);
                }
                Self::transposed(&all)
            }
        }

        impl Number for $pack<f32> {
            type Mask = $pack<u32>;
            type Bits = $pack<u32>;
            const LANES: usize = $count;
            const EPSILON: f64 = f32::EPSILON as f64;
            const TERMS: Terms = <f32 as Number>::TERMS;

            #[inline(always)]
            fn of(x: f64) -> Self {
                Self([x as f32; $count])
            }
            #[inline(always)]
            fn from_lanes(mut of: impl FnMut(usize) -> f64) -> Self {
                Self([$(of($lane) as f32),*])
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
            fn lt(self, other: Self) -> $pack<u32> {
                self.zip(other, |a, b| all(a < b))
            }
            #[inline(always)]
            fn le(self, other: Self) -> $pack<u32> {
                self.zip(other, |a, b| all(a <= b))
            }
            #[inline(always)]
            fn select(mask: $pack<u32>, yes: Self, no: Self) -> Self {
                Self([$(f32::from_bits(yes.0[$lane].to_bits() & mask.0[$lane] | no.0[$lane].to_bits() & !mask.0[$lane])),*])
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
                let mut rows = [[0.0; 4]; $count];
                for (row, x) in rows.iter_mut().zip(self.0) {
                    let at = (x as usize).min(table.rounded.len() - 4);
                    row.copy_from_slice(&table.rounded[at..at + 4]);
                }
                Self::transposed(&rows)
            }
            #[inline(always)]
            fn bits(self) -> $pack<u32> {
                self.map(Number::bits)
            }
            #[inline(always)]
            fn stirred(one: $pack<u32>, other: $pack<u32>) -> $pack<u32> {
                one.zip(other, <f32 as Number>::stirred)
            }
            #[inline(always)]
            fn dice(key: $pack<u32>, count: u32) -> Self {
                key.map(|key| Number::dice(key, count))
            }
        }
    };
}

pack! {
    /// Eight things side by side.
    Eight, 8 of [0 1 2 3 4 5 6 7], 32, avx2, i32x8
}

pack! {
    /// Sixteen things side by side, for machines that have such vectors ([`super::best_lanes`]).
    Sixteen, 16 of [0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15], 64, avx512, i32x16
}

/// Four columns from `start` on of eight rows, by rounds of interleaving within quarters: a compiler left alone moves the 64
/// numbers one by one.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
#[inline(always)]
fn four<M: Simd, const K: usize>(machine: M, rows: &[[f32; K]], start: usize) -> [[f32; 8]; 4] {
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
    let mut columns = [[0.0; 8]; 4];
    for column in 0..4 {
        columns[column] = upper[column].combine(lower[column]).into();
    }
    columns
}
