//! The energy flow of a harmonic plane wave at one place: instantaneous, as a detector averages it, in closed form
//! (E20, E23, E24, C5).
//!
//! With E = A cos 2π(ft − φ) and H behind it by the lag λ, S = EH = |E||H| cos cos = mean + swing cos 2π(2ft − 2φ − λ).
//! In a lossy medium mean < swing: twice a period energy flows back.

use super::phase::{cis, cycles};
use super::plane::Wave;
use num_complex::Complex64;
use std::f64::consts::{PI, TAU};

/// S(t) at one place [W m⁻²].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flux {
    /// ⟨S⟩ over whole periods [W m⁻²].
    pub mean: f64,
    /// Amplitude of what swings about it at twice the wave's frequency [W m⁻²].
    pub swing: f64,
    /// The wave's frequency f [Hz].
    pub frequency: f64,
    /// φ: by how much E lags cos 2πft [cycles].
    pub phase: f64,
    /// λ: by how much H lags E [cycles].
    pub lag: f64,
}

impl Flux {
    /// Of `wave` with a field of `amplitude` [V m⁻¹] at z = 0, at the depth z [m] ≥ 0.
    pub fn at_depth(wave: &Wave, amplitude: f64, depth: f64) -> Self {
        let power = amplitude * amplitude * (-2.0 * wave.k.im * depth).exp();
        Self {
            mean: power * wave.mean_flux,
            swing: power * 0.5 / wave.impedance.norm(),
            frequency: wave.frequency(),
            phase: cycles(wave.k.re / TAU, depth),
            lag: wave.phase_lag / TAU,
        }
    }

    /// S [W m⁻²] at the time t [s], as the product of the two fields.
    pub fn at(&self, time: f64) -> f64 {
        let electric = cycles(self.frequency, time) - self.phase;
        2.0 * self.swing * cis(electric).re * cis(electric - self.lag).re
    }

    /// What a detector reads that weighs the time from `start` for a `duration` [s] by `window`: the mean, and the swing
    /// as far as the window lets it through.
    pub fn average(&self, window: Window, start: f64, duration: f64) -> f64 {
        let double = 2.0 * self.frequency;
        let middle = cycles(double, start) + cycles(self.frequency, duration) - 2.0 * self.phase - self.lag;
        self.mean + self.swing * window.response(double, duration) * cis(middle).re
    }
}

/// ⟨S⟩ = ½ Re(E H*) [W m⁻²] from the complex amplitudes of E [V m⁻¹] and H [A m⁻¹] (E24).
pub fn mean_by_phasors(electric: Complex64, magnetic: Complex64) -> f64 {
    0.5 * (electric * magnetic.conj()).re
}

/// How a detector weighs the time it looks. Each is a sum Σ aₖ cos 2πku over 0 ≤ u ≤ 1 (F. J. Harris, Proc. IEEE 66
/// (1978) 51; A. H. Nuttall, IEEE Trans. ASSP 29 (1981) 84), and the more of its derivatives vanish at both ends, the
/// faster an oscillation averages out with the number x of its periods in the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Window {
    /// Shutter open, shutter closed: falls as 1/x.
    Box,
    /// 1 − cos 2πu = 2 sin² πu: falls as 1/x³.
    Hann,
    /// Harris's four terms with side lobes at −92 dB; its ends stand at 6e−5, so that it falls as 1/x after all.
    BlackmanHarris,
    /// (16/5) sin⁶ πu, four terms of which five derivatives vanish at the ends: falls as 1/x⁷.
    Sine6,
}

/// aₖ of Harris's window.
const BLACKMAN_HARRIS: [f64; 4] = [0.35875, 0.48829, 0.14128, 0.01168];

impl Window {
    /// Every window.
    pub const ALL: [Self; 4] = [Self::Box, Self::Hann, Self::BlackmanHarris, Self::Sine6];

    /// Weight [1] at the share 0 ≤ u ≤ 1 of the duration, of mean 1.
    pub fn weight(self, u: f64) -> f64 {
        let sin2 = cis(0.5 * u).im.powi(2);
        match self {
            Self::Box => 1.0,
            Self::Hann => 2.0 * sin2,
            Self::BlackmanHarris => {
                let [a_0, a_1, a_2, a_3] = BLACKMAN_HARRIS;
                (a_0 - a_1 * cis(u).re + a_2 * cis(2.0 * u).re - a_3 * cis(3.0 * u).re) / a_0
            }
            Self::Sine6 => 3.2 * sin2 * sin2 * sin2,
        }
    }

    /// The power of x with which the response falls at last.
    pub fn order(self) -> u32 {
        match self {
            Self::Box | Self::BlackmanHarris => 1,
            Self::Hann => 3,
            Self::Sine6 => 7,
        }
    }

    /// The share [1] of an oscillation of a `frequency` [Hz] that is left after averaging over a `duration` [s], with
    /// respect to the middle of the window: ∫ weight(u) cos(2πx(u − ½)) du, x = frequency · duration. It is
    /// sin(πx)/(πx) · P(x²)/Π(x² − k²) over the window's harmonics k; whole x are exact zeros beyond them.
    pub fn response(self, frequency: f64, duration: f64) -> f64 {
        // P from x⁰ on, and the highest harmonic. P's coefficients are differences of the aₖ that vanish with the
        // derivatives at the ends: given here, since the subtraction would leave rounding in their place.
        const HARRIS: [f64; 4] = [-36.0, 1.22511 / 0.35875, -0.02913 / 0.35875, 0.00006 / 0.35875];
        let (numerator, harmonics): (&[f64], i32) = match self {
            Self::Box => (&[1.0], 0),
            Self::Hann => (&[-1.0], 1),
            Self::BlackmanHarris => (&HARRIS, 3),
            Self::Sine6 => (&[-36.0], 3),
        };
        let x = (frequency * duration).abs();
        let top = numerator.iter().rev().fold(0.0, |sum, coefficient| sum * x * x + coefficient);
        let nearest = x.round();
        if nearest > f64::from(harmonics) {
            let below: f64 = (1..=harmonics).map(|k| (x - f64::from(k)) * (x + f64::from(k))).product();
            return cis(cycles(0.5 * frequency.abs(), duration.abs())).im / (PI * x) * (top / below);
        }
        // sin πx = ±sin π(x − n) at the nearest harmonic n, whose factor of the denominator it cancels.
        let (near, offset) = (nearest as i32, cycles(frequency.abs(), duration.abs()));
        let sinc = if offset == 0.0 { 1.0 } else { cis(0.5 * offset).im / (PI * offset) };
        let others = (-harmonics..=harmonics).filter(|k| *k != near).map(|k| x - f64::from(k)).product::<f64>();
        (if near % 2 == 0 { sinc } else { -sinc }) * top / others
    }
}

/// The flux [1] of a train of smooth pulses e^(2q(cos 2πx − 1)) at `x` cycles, of peak 1: all harmonics are there, so
/// that rules of quadrature over a whole period have something to converge on.
pub fn pulse_train(sharpness: f64, x: f64) -> f64 {
    (-4.0 * sharpness * cis(0.5 * x).im.powi(2)).exp()
}

/// Its mean over a period, e^(−2q) I₀(2q) (DLMF §10.32.1), for 0 ≤ q ≤ 300.
pub fn mean_of_pulse_train(sharpness: f64) -> f64 {
    // All terms of I₀'s series are positive (DLMF §10.25.2).
    let (mut term, mut total, mut m) = ((-2.0 * sharpness).exp(), 0.0, 0.0);
    while m < sharpness + 1.0 || term > f64::EPSILON * 0.01 * total {
        total += term;
        m += 1.0;
        term *= (sharpness / m) * (sharpness / m);
    }
    total
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::waves::Medium;
    use proptest::prelude::*;
    use yardstick::quadrature::{gauss_legendre, simpson, trapezoid};

    fn over(rule: &[(f64, f64)], f: impl Fn(f64) -> f64) -> f64 {
        rule.iter().map(|&(u, weight)| weight * f(u)).sum()
    }

    proptest! {
        #[test]
        fn responses_agree_with_quadrature(x in 0.0..40.0_f64, snap in 0..3) {
            let x = if snap == 0 { x.round() } else { x };
            let rule = gauss_legendre(96);
            for window in Window::ALL {
                let found = window.response(x, 1.0);
                let expected = over(&rule, |u| window.weight(u) * (TAU * x * (u - 0.5)).cos());
                prop_assert!((found - expected).abs() < 1e-14, "{window:?} {x} {found} {expected}");
            }
        }

        #[test]
        fn averages_agree_with_quadrature(lag in 0.0..0.125_f64, phase in -0.5..0.5, start in 0.0..3.0, duration in 0.1..9.0) {
            let flux = Flux { mean: (TAU * lag).cos(), swing: 1.0, frequency: 1.3, phase, lag };
            let rule = gauss_legendre(96);
            for window in Window::ALL {
                let expected = over(&rule, |u| window.weight(u) * flux.at(start + u * duration));
                prop_assert!((flux.average(window, start, duration) - expected).abs() < 1e-13, "{window:?}");
            }
        }

        #[test]
        fn three_routes_to_the_mean(log_sigma in -12.0..8.0_f64, log_f in 0.0..15.0_f64, amplitude in 0.1..10.0) {
            let medium = Medium::relative(2.0, 1.0, 10f64.powf(log_sigma)).unwrap();
            let wave = Wave::new(&medium, TAU * 10f64.powf(log_f)).unwrap();
            let flux = Flux::at_depth(&wave, amplitude, 0.0);
            let e = Complex64::from(amplitude);
            let phasors = mean_by_phasors(e, e / wave.impedance);
            prop_assert!((phasors / flux.mean - 1.0).abs() < 1e-14);
            // S is a single harmonic about its mean: three points of the trapezoid say all.
            let period = 1.0 / flux.frequency;
            let trapezoid = over(&trapezoid(3), |u| flux.at(u * period));
            prop_assert!((trapezoid / flux.mean - 1.0).abs() < 1e-14, "{trapezoid} {}", flux.mean);
        }
    }

    #[test]
    fn responses_fall_as_they_should() {
        // The envelope between whole numbers, where |sin πx| = 1.
        for window in Window::ALL {
            let at = |x: f64| window.response(x + 0.5, 1.0).abs();
            let slope = (at(1e6) / at(1e7)).log10();
            assert!((slope - f64::from(window.order())).abs() < 0.01, "{window:?} {slope}");
            assert_eq!(window.response(1e9, 1.0), 0.0);
        }
        assert!(Window::BlackmanHarris.response(5.5, 1.0).abs() < 10f64.powf(-92.0 / 20.0));
    }

    #[test]
    fn a_second_of_light_keeps_its_phase() {
        let flux = Flux { mean: 1.0, swing: 1.0, frequency: 5.45e14, phase: 0.0, lag: 0.0 };
        // 545 of its periods make a picosecond exactly, so half a second later the flux has come back to the same value.
        let (early, late) = (flux.at(2f64.powi(-60)), flux.at(0.5 + 2f64.powi(-52)));
        assert!((0.0..=2.0).contains(&early) && (0.0..=2.0).contains(&late));
        let exact = crate::references::waves::phase(5.45e14, 0.5 + 2f64.powi(-52));
        let expected = 2.0 * yardstick::precise::to_f64(&exact.cos).powi(2);
        assert!((late - expected).abs() < 4.0 * f64::EPSILON, "{late} {expected}");
        let naive = 2.0 * crate::waves::textbook::cos_of_time(5.45e14, 0.5 + 2f64.powi(-52)).powi(2);
        assert!((naive - expected).abs() > 1e-3, "{naive} {expected}");
    }

    #[test]
    fn what_a_box_leaves_of_a_billion_periods_keeps_its_digits() {
        // The ripple alone: ∫cos(4πft) dt/T = sin(4πfT)/(4πfT).
        let ripple = Flux { mean: 0.0, swing: 1.0, frequency: 5.45e14, phase: 0.0, lag: 0.0 };
        for periods in [1.0e3, 1.0e6, 1.0e9, 1.0e12] {
            let duration = (periods + 0.3) / ripple.frequency;
            let sine =
                yardstick::precise::to_f64(&crate::references::waves::phase(2.0 * ripple.frequency, duration).sin);
            let expected = sine / (4.0 * PI * ripple.frequency * duration);
            let found = ripple.average(Window::Box, 0.0, duration);
            assert!((found / expected - 1.0).abs() < 1e-14, "{periods}: {found} {expected}");
            let smooth = ripple.average(Window::Sine6, 0.0, duration).abs();
            assert!(smooth < 1e3 * periods.powi(-7), "{periods}: {smooth}");
        }
    }

    #[test]
    fn the_trapezoid_converges_exponentially_over_a_period() {
        let mean = mean_of_pulse_train(5.0);
        // I₀(10) e^(−10), Abramowitz & Stegun, table 9.8.
        assert!((mean - 0.127_833_337_163).abs() < 1e-12, "{mean}");
        let error = |rule: &[(f64, f64)]| (over(rule, |u| pulse_train(5.0, u)) / mean - 1.0).abs();
        assert!(error(&trapezoid(8)) > 1e-3 && error(&trapezoid(16)) < 1e-4 && error(&trapezoid(32)) < 1e-13);
        assert!(error(&simpson(32)) > 1e-6 && error(&simpson(64)) < 1e-13);
        assert!(error(&gauss_legendre(40)) < 1e-12);
    }
}
