//! Waves in arbitrary precision: plane waves by the plainest formulas, phases after any number of periods, and the
//! conducting cell, in numbers wide enough not to mind; with the condition numbers of what they give.

use super::fresnel::Pair;
use crate::waves::conduction::Scheme;
use crate::waves::{Medium, Wave};
use std::sync::LazyLock;
use yardstick::precise::{self, Real};

/// The outputs of a plane wave, real and imaginary parts apart, in the order of [`NAMES`]; `None` where infinite.
pub type Outputs = [Option<Real>; NAMES.len()];

/// The names of [`Outputs`].
pub const NAMES: [&str; 9] =
    ["k_re", "k_im", "Z_re", "Z_im", "skin_depth", "phase_lag", "wavelength", "v_phase", "S_avg"];

/// What `wave` says of the outputs, in the order of [`NAMES`].
pub fn flat(wave: &Wave) -> [f64; NAMES.len()] {
    let (k, z) = (wave.k, wave.impedance);
    [k.re, k.im, z.re, z.im, wave.skin_depth, wave.phase_lag, wave.wavelength, wave.v_phase, wave.mean_flux]
}

/// A plane wave, exact for every purpose of `f64`: k = √(ω²με + iωμσ), and all else from k.
#[derive(Debug)]
pub struct PlaneWave {
    /// ε, μ, σ, ω.
    inputs: [Real; 4],
    /// In the order of [`NAMES`].
    pub outputs: Outputs,
}

impl PlaneWave {
    /// In a medium of finite conductivity, at `omega` [rad s⁻¹].
    pub fn new(medium: &Medium, omega: f64) -> Self {
        let inputs = [medium.epsilon(), medium.mu(), medium.sigma(), omega].map(precise::real);
        let k = wave_number(&inputs);
        let lag = (&k.1 / &k.0).atan();
        Self { outputs: outputs(&inputs, &k, lag), inputs }
    }

    /// The condition number of each output [1]: Σ |∂ ln y/∂ ln x| over ε, μ, σ and ω; 0 where nothing moves it.
    pub fn conditions(&self) -> [f64; NAMES.len()] {
        let step = precise::real(STEP);
        let (k, lag) = (wave_number(&self.inputs), self.outputs[5].as_ref().expect("always finite"));
        let norm = &k.0 * &k.0 + &k.1 * &k.1;
        let mut conditions = [0.0; NAMES.len()];
        for moved in 0..self.inputs.len() {
            let mut inputs = self.inputs.clone();
            inputs[moved] = &inputs[moved] + &inputs[moved] * &step;
            let turned = wave_number(&inputs);
            // For so small a step the angle between the two is their cross product: no second arctangent.
            let lag = lag + (&k.0 * &turned.1 - &k.1 * &turned.0) / &norm;
            let there = outputs(&inputs, &turned, lag);
            for ((sum, there), here) in conditions.iter_mut().zip(there).zip(&self.outputs) {
                if let (Some(there), Some(here)) = (there, here) {
                    *sum += quotient(&there, here);
                }
            }
        }
        conditions
    }
}

/// Relative step of the difference quotients: far below f64, far above the rounding of [`precise::BITS`].
const STEP: f64 = 1e-30;

/// |∂ ln y/∂ ln x| [1] from y after a relative step of x, and y before it.
fn quotient(there: &Real, here: &Real) -> f64 {
    let change = there - here;
    if is_zero(&change) { 0.0 } else { precise::to_f64(&(change / here)).abs() / STEP }
}

fn is_zero(x: &Real) -> bool {
    x.repr().significand().is_zero()
}

fn wave_number([epsilon, mu, sigma, omega]: &[Real; 4]) -> Pair {
    Pair(omega * omega * mu * epsilon, omega * mu * sigma).root()
}

/// 2π.
static CIRCLE: LazyLock<Real> = LazyLock::new(|| precise::pi(precise::BITS) * precise::real(2.0));

fn outputs([_, mu, _, omega]: &[Real; 4], k: &Pair, lag: Real) -> Outputs {
    let [zero, one, half] = [0.0, 1.0, 0.5].map(precise::real);
    let z = Pair(omega * mu, zero).over(k);
    let skin_depth = (!is_zero(&k.1)).then(|| one / &k.1);
    let (wavelength, speed) = (&*CIRCLE / &k.0, omega / &k.0);
    let flux = half * &k.0 / (omega * mu);
    let [k_re, k_im] = [&k.0, &k.1].map(|part| Some(part.clone()));
    [k_re, k_im, Some(z.0), Some(z.1), skin_depth, Some(lag), Some(wavelength), Some(speed), Some(flux)]
}

/// A phase after many periods.
#[derive(Debug)]
pub struct Phase {
    /// f·t less the nearest whole number.
    pub cycles: Real,
    /// cos 2πft.
    pub cos: Real,
    /// sin 2πft.
    pub sin: Real,
}

/// The phase of a `frequency` [Hz] at a `time` [s], both exact.
pub fn phase(frequency: f64, time: f64) -> Phase {
    // A product of two f64 has 106 bits, so nothing is rounded but the functions.
    let product = precise::real(frequency) * precise::real(time);
    let cycles = &product - product.round();
    let (sin, cos) = (&cycles * &*CIRCLE).sin_cos();
    Phase { cycles, cos, sin }
}

/// Ca, 1 − Ca and Cb of [`Update`](crate::waves::conduction::Update), and the condition number of each [1] over ε, σ
/// and Δt.
pub fn update(scheme: Scheme, epsilon: f64, sigma: f64, dt: f64) -> [(Real, f64); 3] {
    let (inputs, step) = ([epsilon, sigma, dt].map(precise::real), precise::real(STEP));
    let mut found = coefficients(scheme, &inputs).map(|here| (here, 0.0));
    for moved in 0..inputs.len() {
        let mut inputs = inputs.clone();
        inputs[moved] = &inputs[moved] + &inputs[moved] * &step;
        for ((here, sum), there) in found.iter_mut().zip(coefficients(scheme, &inputs)) {
            *sum += quotient(&there, here);
        }
    }
    found
}

fn coefficients(scheme: Scheme, [epsilon, sigma, dt]: &[Real; 3]) -> [Real; 3] {
    let [one, half] = [1.0, 0.5].map(precise::real);
    let x = sigma * dt / epsilon;
    let free = dt / epsilon;
    match scheme {
        Scheme::ForwardEuler => [one - &x, x, free],
        Scheme::SemiImplicit => {
            let all = &one + &half * &x;
            [(one - half * &x) / &all, x / &all, free / all]
        }
        Scheme::BackwardEuler => {
            let all = &one + &x;
            [one / &all, x / &all, free / all]
        }
        Scheme::Exponential => {
            let lost = -(-x.clone()).exp_m1();
            let gain = if is_zero(sigma) { free } else { &lost / sigma };
            [(-x).exp(), lost, gain]
        }
    }
}

/// E of a [`Cell`](crate::waves::conduction::Cell) of loss tangent `tau` at θ, from `start` at 0.
pub fn cell(tau: f64, start: f64, theta: f64) -> Real {
    let [tau, start, theta] = [tau, start, theta].map(precise::real);
    let (sin, cos) = theta.sin_cos();
    let size = (precise::real(1.0) + &tau * &tau).sqrt();
    let decay = (-(&tau * &theta)).exp();
    (&tau * cos + sin) / &size + (start - tau / size) * decay
}
