//! What a width needs besides arithmetic: its lanes one by one.

use super::lanes::transposed;
use super::{Eight, F32x8, Number};

/// A width that rays can be traced in: `f32`, `f64` and [`F32x8`].
pub trait Width: Number {
    /// What a lane holds.
    type Scalar: Width<Scalar = Self::Scalar, Pack = Self::Pack> + PartialOrd + Default + From<f32>;
    /// As many numbers as primitives are tried at once by a single ray.
    type Pack: Width<Scalar = Self::Scalar, Pack = Self::Pack>;

    /// `x` in every lane.
    fn all(x: Self::Scalar) -> Self;
    /// A number a lane.
    fn each(of: impl FnMut(usize) -> Self::Scalar) -> Self;
    /// The number in one lane.
    fn get(self, lane: usize) -> Self::Scalar;
    /// The whole number ≥ 0 in one lane; 0 for what is below, or not a number.
    fn place(self, lane: usize) -> usize;
    /// Transposed: lane by lane a row.
    fn columns<const K: usize>(rows: impl FnMut(usize) -> [Self::Scalar; K]) -> [Self; K];
}

macro_rules! single {
    ($float:ty, $pack:ty) => {
        impl Width for $float {
            type Scalar = $float;
            type Pack = $pack;
            #[inline(always)]
            fn all(x: $float) -> Self {
                x
            }
            #[inline(always)]
            fn each(mut of: impl FnMut(usize) -> $float) -> Self {
                of(0)
            }
            #[inline(always)]
            fn get(self, _: usize) -> $float {
                self
            }
            #[inline(always)]
            fn place(self, _: usize) -> usize {
                self as usize
            }
            #[inline(always)]
            fn columns<const K: usize>(mut rows: impl FnMut(usize) -> [$float; K]) -> [Self; K] {
                rows(0)
            }
        }
    };
}

single!(f32, F32x8);
single!(f64, f64);

impl Width for F32x8 {
    type Scalar = f32;
    type Pack = F32x8;
    #[inline(always)]
    fn all(x: f32) -> Self {
        Eight([x; 8])
    }
    #[inline(always)]
    fn each(mut of: impl FnMut(usize) -> f32) -> Self {
        let mut all = Eight([0.0; 8]);
        for lane in 0..8 {
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
        let mut all = [[0.0; K]; 8];
        for (lane, row) in all.iter_mut().enumerate() {
            *row = rows(lane);
        }
        transposed(&all)
    }
}
