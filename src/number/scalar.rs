//! One number at a time.

use super::dice::{stirred, thrown};
use super::{Number, Table, Terms};

/// What both widths write alike: `$whole` are the integers of as many bits, without and with a sign, and `$bits` folds
/// one into 32 bits.
macro_rules! scalar {
    ($float:ident, $whole:ident, $signed:ident, $terms:expr, $bits:expr) => {
        impl Number for $float {
            type Mask = bool;
            type Bits = u32;
            const LANES: usize = 1;
            const EPSILON: f64 = $float::EPSILON as f64;
            const TERMS: Terms = $terms;

            #[inline(always)]
            fn of(x: f64) -> Self {
                x as $float
            }
            #[inline(always)]
            fn from_lanes(mut of: impl FnMut(usize) -> f64) -> Self {
                of(0) as $float
            }
            #[inline(always)]
            fn lane(self, _: usize) -> f64 {
                self.into()
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                $float::sqrt(self)
            }
            #[inline(always)]
            fn abs(self) -> Self {
                $float::abs(self)
            }
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                if self < other { self } else { other }
            }
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                if self > other { self } else { other }
            }
            #[inline(always)]
            fn lt(self, other: Self) -> bool {
                self < other
            }
            #[inline(always)]
            fn le(self, other: Self) -> bool {
                self <= other
            }
            #[inline(always)]
            fn select(mask: bool, yes: Self, no: Self) -> Self {
                // By bits: a branch on data that nobody can predict costs more than both ways.
                let all = (mask as $whole).wrapping_neg();
                $float::from_bits(yes.to_bits() & all | no.to_bits() & !all)
            }
            #[inline(always)]
            fn round(self) -> Self {
                // A library's `floor` is a call where the machine lacks the instruction; this sum has no room for fractions.
                const ROUNDER: $float = 1.5 / $float::EPSILON;
                (self + ROUNDER) - ROUNDER
            }
            #[inline(always)]
            fn power_of_two(k: Self) -> Self {
                // The whole number stands in the low bits of the sum; shifted up it is an exponent.
                const BIAS: $whole = $float::MAX_EXP as $whole - 1;
                let sum = k + 1.5 / $float::EPSILON;
                $float::from_bits(sum.to_bits().wrapping_add(BIAS) << ($float::MANTISSA_DIGITS - 1))
            }
            #[inline(always)]
            fn split(self) -> (Self, Self) {
                const MANTISSA: u32 = $float::MANTISSA_DIGITS - 1;
                // Counted from √½, so that an exponent begins there and not at 1.
                let root = (std::f64::consts::FRAC_1_SQRT_2 as $float).to_bits();
                let exponent = (self.to_bits().wrapping_sub(root) as $signed) >> MANTISSA;
                let mantissa = self.to_bits().wrapping_sub((exponent << MANTISSA) as $whole);
                ($float::from_bits(mantissa), exponent as $float)
            }
            #[inline(always)]
            fn look_up(self, table: &[f64]) -> Self {
                table[(self as usize).min(table.len() - 1)] as $float
            }
            #[inline(always)]
            fn look_up_four(self, table: &Table) -> [Self; 4] {
                let at = (self as usize).min(table.entries.len() - 4);
                let entry = |k: usize| table.entries[at + k] as $float;
                [entry(0), entry(1), entry(2), entry(3)]
            }
            #[inline(always)]
            fn bits(self) -> u32 {
                let fold: fn($whole) -> u32 = $bits;
                fold(self.to_bits())
            }
            #[inline(always)]
            fn stirred(one: u32, other: u32) -> u32 {
                stirred(one, other)
            }
            #[inline(always)]
            fn dice(key: u32, count: u32) -> Self {
                thrown(key, count) as $float
            }
        }
    };
}

scalar!(
    f64,
    u64,
    i64,
    Terms { sine: 10, exponential: 14, logarithm: 11, arctangent: 13, gaussian: (14, 0.45), least_exponent: -708.0 },
    |bits| (bits >> 32) as u32 ^ (bits as u32).wrapping_mul(0x9e37_79b1)
);
scalar!(
    f32,
    u32,
    i32,
    Terms { sine: 6, exponential: 8, logarithm: 5, arctangent: 6, gaussian: (7, 0.62), least_exponent: -87.0 },
    |bits| bits
);
