//! Coherent stacks in arbitrary precision, by another route than [`optics::film`](crate::optics::film): Parratt's
//! recursion of interface coefficients (Phys. Rev. 95, 359, 1954). How much the answer depends on each input is found by a
//! third.

mod condition;

pub use condition::{Condition, condition};

use crate::Polarisation;
use crate::optics::Direction;
use crate::optics::film::{Layer, Stack};
use crate::optics::incidence::{Incidence, normal_squared};
use num_complex::Complex64;
use yardstick::precise::{BITS, Complex, Real, from_real, pi, real_at};

/// (sin θ, cos θ) of an exact direction at `bits`.
fn sin_cos(direction: Direction, bits: usize) -> (Real, Real) {
    match direction {
        Direction::Angle(theta) => real_at(theta, bits).sin_cos(),
        Direction::Grazing(delta) => {
            let (sin, cos) = real_at(delta, bits).sin_cos();
            (cos, sin)
        }
        Direction::Cos(cos) => {
            let cos = real_at(cos, bits);
            ((real_at(1.0, bits) - &cos * &cos).sqrt(), cos)
        }
    }
}

/// What [`Response`](crate::optics::film::Response) approximates.
#[derive(Clone, Debug)]
pub struct Reference {
    /// Field ratio r [1].
    pub r: Complex,
    /// Field ratio t [1].
    pub t: Complex,
    /// R [1].
    pub reflectance: Real,
    /// T [1].
    pub transmittance: Real,
    /// A = 1 − R − T [1].
    pub absorptance: Real,
    /// ln T [1]; `None` if T = 0.
    pub ln_transmittance: Option<Real>,
}

/// r, t, R, T, A and ln T of a stack at a vacuum wavelength [m] to about 60 digits.
pub fn reference(stack: &Stack, wavelength: f64, direction: Direction, polarisation: Polarisation) -> Reference {
    let scene = Scene::new(stack, wavelength, direction, polarisation);
    let one = from_real(real_at(1.0, scene.bits));
    // Each medium's admittance and the phase factor e^(iδ) across it, from the substrate to the light.
    let coats: Vec<(Complex, Complex)> = scene.kinds.iter().map(|layer| scene.admittance_and_step(layer)).collect();
    let substrate = scene.admittance(&scene.substrate, &scene.tangential);
    let (mut r, mut t, mut below) = (scene.zero(), one.clone(), &substrate);
    let mut crossed = (scene.zero(), one.clone());
    let incident = from_real(scene.y_i.clone());
    for above in scene.order.iter().rev().map(|&kind| Some(&coats[kind])).chain([None]) {
        let y = above.map_or(&incident, |coat| &coat.0);
        let sum = y + below;
        if !sum.is_zero() {
            let rho = (y - below) / &sum;
            let round = &one + &rho * &crossed.0;
            r = (&rho + &crossed.0) / &round;
            // 1 + ρ as 2Y/(Y + Y'): grazing light makes ρ −1 to more digits than there are.
            t = (y + y) / &sum * &crossed.1 / &round;
        }
        if let Some((y, step)) = above {
            crossed = (&r * step * step, &t * step);
            below = y;
        }
    }
    let (reflectance, through) = (r.norm(), t.norm());
    let transmittance = substrate.into_parts().0 / &scene.y_i * through;
    let absorptance = real_at(1.0, scene.bits) - &reflectance - &transmittance;
    let ln_transmittance = (!is_zero(&transmittance)).then(|| transmittance.ln());
    if polarisation == Polarisation::P {
        t = t * from_real(real_at(stack.n_i, scene.bits)) / &scene.substrate;
    }
    Reference { r, t, reflectance, transmittance, absorptance, ln_transmittance }
}

fn is_zero(x: &Real) -> bool {
    x.repr().significand().is_zero()
}

/// The inputs at full precision.
struct Scene {
    bits: usize,
    polarisation: Polarisation,
    /// 2π/λ.
    wave_number: Real,
    /// (n_i sin θ)².
    tangential: Real,
    y_i: Real,
    substrate: Complex,
    /// The different layers of the stack.
    kinds: Vec<Layer>,
    /// Which of them stands where, from the light to the substrate.
    order: Vec<usize>,
}

/// |q²/n²| below which a layer counts as being at its critical angle.
const CRITICAL: f64 = 1e-12;
impl Scene {
    fn new(stack: &Stack, wavelength: f64, direction: Direction, polarisation: Polarisation) -> Self {
        // Twice as many digits for layers at their critical angle, where half of them cancel.
        let incidence = Incidence::from(direction);
        let critical = |layer: &Layer| {
            normal_squared(incidence, stack.n_i, layer.index).norm() < CRITICAL * layer.index.norm_sqr()
        };
        let bits = if stack.layers.iter().any(critical) { 2 * BITS } else { BITS };
        let (sin, cos) = sin_cos(direction, bits);
        let n_i = real_at(stack.n_i, bits);
        let y_i = match polarisation {
            Polarisation::S => &n_i * cos,
            Polarisation::P => cos / &n_i,
        };
        let (mut kinds, mut order) = (Vec::<Layer>::new(), Vec::new());
        for layer in stack.layers {
            let kind = kinds.iter().position(|kind| kind == layer).unwrap_or_else(|| {
                kinds.push(*layer);
                kinds.len() - 1
            });
            order.push(kind);
        }
        Self {
            bits,
            polarisation,
            wave_number: pi(bits) * real_at(2.0, bits) / real_at(wavelength, bits),
            tangential: (&n_i * &n_i) * (&sin * &sin),
            y_i,
            substrate: at(stack.substrate, bits),
            kinds,
            order,
        }
    }

    fn zero(&self) -> Complex {
        at(Complex64::ZERO, self.bits)
    }

    /// q = √(n² − (n_i sin θ)²), with imaginary part ≥ 0.
    fn normal(&self, n: &Complex, tangential: &Real) -> Complex {
        let (re, im) = (n.sqr() - from_real(tangential.clone())).into_parts();
        if !is_zero(&im) {
            return Complex::from_parts(re, im).sqrt();
        }
        if re < Real::ZERO { Complex::from_parts(real_at(0.0, self.bits), (-re).sqrt()) } else { from_real(re.sqrt()) }
    }

    /// As [`Self::normal`], but never zero: exactly at the critical angle by a nudge far below every digit asked for.
    fn normal_nudged(&self, n: &Complex, tangential: &Real) -> Complex {
        let q = self.normal(n, tangential);
        if q.is_zero() { at(Complex64::from(1e-60), self.bits) } else { q }
    }

    /// q/Y: 1 (s) or n² (p).
    fn q_over_y(&self, n: &Complex) -> Complex {
        match self.polarisation {
            Polarisation::S => at(Complex64::ONE, self.bits),
            Polarisation::P => n.sqr(),
        }
    }

    fn admittance(&self, n: &Complex, tangential: &Real) -> Complex {
        self.normal(n, tangential) / self.q_over_y(n)
    }

    fn admittance_and_step(&self, layer: &Layer) -> (Complex, Complex) {
        let n = at(layer.index, self.bits);
        let q = self.normal_nudged(&n, &self.tangential);
        let delta = &q * from_real(&self.wave_number * real_at(layer.thickness, self.bits));
        (q / self.q_over_y(&n), delta.mul_i(false).exp())
    }
}

fn at(z: Complex64, bits: usize) -> Complex {
    Complex::from_parts(real_at(z.re, bits), real_at(z.im, bits))
}
