//! What a width needs besides arithmetic: its lanes one by one.

use super::{F32x8, Number};

/// A width that rays can be traced in: `f32`, `f64`, [`F32x8`] and [`super::F32x16`].
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
