//! Waves in arbitrary precision: plane waves by the plainest formulas, phases after any number of periods, and the
//! conducting cell, in numbers wide enough not to mind; with the condition numbers of what they give.

use super::fresnel::Pair;
use crate::precise::{self, Real};
use crate::waves::{Medium, Wave};

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
        Self { outputs: outputs(&inputs), inputs }
    }

    /// The condition number of each output [1]: Σ |∂ ln y/∂ ln x| over ε, μ, σ and ω; 0 where nothing moves it.
    pub fn conditions(&self) -> [f64; NAMES.len()] {
        let step = precise::real(STEP);
        let mut conditions = [0.0; NAMES.len()];
        for moved in 0..self.inputs.len() {
            let mut inputs = self.inputs.clone();
            inputs[moved] = &inputs[moved] + &inputs[moved] * &step;
            for ((sum, there), here) in conditions.iter_mut().zip(outputs(&inputs)).zip(&self.outputs) {
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

fn outputs([epsilon, mu, sigma, omega]: &[Real; 4]) -> Outputs {
    let [zero, one, half] = [0.0, 1.0, 0.5].map(precise::real);
    let square = Pair(omega * omega * mu * epsilon, omega * mu * sigma);
    let k = square.root();
    let z = Pair(omega * mu, zero).over(&k);
    let skin_depth = (!is_zero(&k.1)).then(|| &one / &k.1);
    let lag = (&k.1 / &k.0).atan();
    let wavelength = precise::pi(precise::BITS) / &half / &k.0;
    let flux = half * &k.0 / (omega * mu);
    let speed = omega / &k.0;
    let finite = [k.0, k.1, z.0, z.1, lag, wavelength, speed, flux].map(Some);
    let [k_re, k_im, z_re, z_im, lag, wavelength, speed, flux] = finite;
    [k_re, k_im, z_re, z_im, skin_depth, lag, wavelength, speed, flux]
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
    let (sin, cos) = (&cycles * precise::pi(precise::BITS) * precise::real(2.0)).sin_cos();
    Phase { cycles, cos, sin }
}
