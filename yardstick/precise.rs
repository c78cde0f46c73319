//! Arbitrary precision: the yardstick that `f64` results are held against.
//!
//! Thin names over `dashu`: every leaf is made here with its precision set, because a number without
//! one would be taken as exact and stop the precision from spreading through a formula.

use dashu_base::Approximation;
use dashu_cmplx::CBig;
use dashu_float::{FBig, round::mode::HalfEven};
use num_complex::Complex64;

/// A real number of chosen binary precision.
pub type Real = FBig<HalfEven, 2>;
/// A complex number of chosen binary precision.
pub type Complex = CBig<HalfEven, 2>;

/// The precision [bit] used where nothing else is said: 77 decimal digits.
pub const BITS: usize = 256;

/// The exact value of a finite `x`, carried at [`BITS`].
pub fn real(x: f64) -> Real {
    real_at(x, BITS)
}

/// The exact value of a finite `x`, carried at `bits` of precision (at least 53).
///
/// # Panics
/// If `x` is not finite.
pub fn real_at(x: f64, bits: usize) -> Real {
    let exact = Real::try_from(x).expect("a finite number");
    exact.with_precision(bits.max(53)).value()
}

/// The exact value of a finite `z`, carried at [`BITS`].
pub fn complex(z: Complex64) -> Complex {
    Complex::from_parts(real(z.re), real(z.im))
}

/// `x` as a complex number.
pub fn from_real(x: Real) -> Complex {
    let bits = x.precision();
    Complex::from_parts(x, real_at(0.0, bits))
}

/// The nearest `f64`; ±∞ and 0 beyond its range.
pub fn to_f64(x: &Real) -> f64 {
    match x.to_f64() {
        Approximation::Exact(value) | Approximation::Inexact(value, _) => value,
    }
}

/// The nearest pair of `f64`.
pub fn to_complex64(z: &Complex) -> Complex64 {
    let (re, im) = z.clone().into_parts();
    Complex64::new(to_f64(&re), to_f64(&im))
}

/// π at `bits` of precision.
pub fn pi(bits: usize) -> Real {
    dashu_float::Context::<HalfEven>::new(bits).pi::<2>(None).value()
}

/// |`ours` − `exact`| / |`exact`| [1], correct even where `exact` lies outside the range of `f64`.
/// 0 if both are zero; ∞ if `ours` is not finite or only `exact` is zero.
pub fn relative_error(ours: f64, exact: &Real) -> f64 {
    if !ours.is_finite() {
        return f64::INFINITY;
    }
    let bits = exact.precision().max(BITS);
    let difference = real_at(ours, bits) - exact;
    if difference.repr().significand().is_zero() {
        return 0.0;
    }
    if exact.repr().significand().is_zero() {
        return f64::INFINITY;
    }
    to_f64(&(difference / exact)).abs()
}
