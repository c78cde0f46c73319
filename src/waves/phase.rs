//! Phases after any number of periods. The rounded product f·t is wrong by half a unit in its last place, and that many
//! cycles: after 1e9 periods of light seven digits of the cosine are gone, after 1e16 all of them. Here the product is
//! kept with its rounding error (Dekker; Veltkamp's splitting), whole cycles are dropped exactly, and only the rest is
//! rounded.
//!
//! Frequencies and times are taken as the exact numbers they are stored as; |a|, |b| and |ab| stay below 1e290.

use crate::wide::Wide;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// The fraction of a·b beyond the nearest whole number, −½ … ½, correctly rounded: the phase in cycles [1] of a
/// frequency [Hz] after a time [s].
pub fn cycles(a: f64, b: f64) -> f64 {
    let (high, low) = (Wide::from(a) * Wide::from(b)).parts();
    // Both remainders are exact; from 2⁵³ cycles on the first is 0 and the second may itself hold whole cycles.
    let (high, low) = (fraction(high), fraction(low));
    let sum = high + low;
    // A whole cycle between them is taken off before the one rounding.
    if sum.abs() > 0.5 { (high - sum.signum()) + low } else { sum }
}

/// x less the nearest whole number, exactly.
fn fraction(x: f64) -> f64 {
    x - x.round()
}

/// e^(2πix) at `x` cycles; cosine and sine each keep their digits, next to their zeros too.
pub fn cis(x: f64) -> Complex64 {
    let x = fraction(x);
    // Measured from the nearest quarter, which is exact.
    let quarter = (4.0 * x).round();
    let (sin, cos) = (TAU * (x - 0.25 * quarter)).sin_cos();
    match quarter as i8 {
        0 => Complex64::new(cos, sin),
        1 => Complex64::new(-sin, cos),
        -1 => Complex64::new(sin, -cos),
        _ => Complex64::new(-cos, -sin),
    }
}

/// e^(iab) for an angular frequency [rad s⁻¹] and a time [s], or a wave number and a length, to a few ε of absolute
/// error: the product's rounding error is turned back by the addition theorem, and the library's sine and cosine
/// reduce any `f64` by as many digits of π as it takes (Payne & Hanek, SIGNUM Newsl. 18 (1983) 19).
pub fn cis_of_product(a: f64, b: f64) -> Complex64 {
    let (high, low) = (Wide::from(a) * Wide::from(b)).parts();
    Complex64::cis(high) * Complex64::cis(low)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::references::waves::phase;
    use proptest::prelude::*;
    use yardstick::precise;

    proptest! {
        #[test]
        fn any_phase_is_right(f in 0.0..17.0_f64, t in -12.0..10.0_f64) {
            let (f, t) = (10f64.powf(f), 10f64.powf(t));
            let exact = phase(f, t);
            prop_assert!(precise::relative_error(cycles(f, t), &exact.cycles) <= 0.5 * f64::EPSILON);
            let found = cis(cycles(f, t));
            for (found, exact) in [(found.re, exact.cos), (found.im, exact.sin)] {
                let error = precise::to_f64(&(precise::real(found) - exact)).abs();
                prop_assert!(error <= 2.0 * f64::EPSILON, "{f} {t} {error}");
            }
        }

        #[test]
        fn sines_keep_their_digits_next_to_their_zeros(quarter in -2..3, away in -15.0..-1.0_f64) {
            let x = 0.25 * f64::from(quarter) + 10f64.powf(away);
            let (found, exact) = (cis(x), phase(x, 1.0));
            prop_assert!(precise::relative_error(found.re, &exact.cos) <= 4.0 * f64::EPSILON, "{x} {found}");
            prop_assert!(precise::relative_error(found.im, &exact.sin) <= 4.0 * f64::EPSILON, "{x} {found}");
        }

        #[test]
        fn any_angle_is_right(omega in 0.0..17.0_f64, t in -12.0..10.0_f64) {
            let (omega, t) = (10f64.powf(omega), 10f64.powf(t));
            let (sin, cos) = (precise::real_at(omega, 512) * precise::real_at(t, 512)).sin_cos();
            let found = cis_of_product(omega, t);
            for (found, exact) in [(found.re, cos), (found.im, sin)] {
                let error = precise::to_f64(&(precise::real(found) - exact)).abs();
                prop_assert!(error <= 3.0 * f64::EPSILON, "{omega} {t} {error}");
            }
        }
    }

    #[test]
    fn whole_and_quarter_cycles_are_exact() {
        for whole in [0.0, 1.0, 7.0, 1e9, 1e15] {
            assert_eq!(cis(cycles(whole, 1.0)), Complex64::ONE);
            assert_eq!(cis(cycles(whole + 0.25, 1.0)).im, 1.0);
        }
        assert_eq!(cis(0.25).re, 0.0);
        assert_eq!(cis(0.5).re, -1.0);
        // 1e30 is no whole number of thirds; its own value is what counts.
        assert_eq!(cycles(1e30, 1.0), 0.0);
    }
}
