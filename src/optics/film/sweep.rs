//! One pass through a stack, from the substrate to the light, for `L` wavelengths side by side.

use super::lanes::{Complexes, Decay, HalfTurn, Lanes, decay, half_turn};
use super::{Admittance, Layer, Powers, Response, Waves};
use num_complex::Complex64;
use std::f64::consts::{LN_2, TAU};

/// A layer reduced to what its kind needs. `path` is 2π d q [m]: over the wavelength it is the phase δ.
#[derive(Clone, Debug)]
pub(super) enum Coat {
    /// Clear, with nothing but its own medium behind: the wave that runs on is alone, and only turns by δ = path/λ.
    Unbroken { path: f64 },
    /// Clear, and the wave propagates: δ and Y are real.
    Clear { path: f64, y: f64, inverse: f64 },
    /// Clear, beyond its critical angle: δ = i path/λ, Y = i `y`.
    Evanescent { path: f64, y: f64, inverse: f64 },
    /// Clear, at its critical angle: q = 0, and only sin δ/Y = `path`/λ is left.
    Critical { path: f64 },
    /// Absorbing. `loss` are the weights of |ψ|² and |φ|² in 2π d Im(n²) |E|² [m].
    Absorbing { path: Complex64, y: Complex64, inverse: Complex64, loss: (f64, f64) },
}

impl Coat {
    /// `is_unbroken` if there is nothing but the layer's own medium behind.
    pub fn new(layer: &Layer, admittance: &Admittance, is_unbroken: bool) -> Self {
        debug_assert!(layer.thickness.is_finite());
        let Admittance { q, y, inverse, q_over_y, loss } = *admittance;
        let length = TAU * layer.thickness;
        if loss != (0.0, 0.0) {
            Self::Absorbing { path: length * q, y, inverse, loss: (length * loss.0, length * loss.1) }
        } else if q.re > 0.0 && is_unbroken {
            Self::Unbroken { path: length * q.re }
        } else if q.re > 0.0 {
            Self::Clear { path: length * q.re, y: y.re, inverse: inverse.re }
        } else if q.im > 0.0 {
            Self::Evanescent { path: length * q.im, y: y.im, inverse: -inverse.im }
        } else {
            Self::Critical { path: length * q_over_y }
        }
    }
}

/// A sum that carries its rounding error along (Kahan 1965; two-sum of Knuth, TAOCP 2, §4.2.2).
#[derive(Clone, Copy)]
struct Total<const L: usize> {
    sum: Lanes<L>,
    carry: Lanes<L>,
}

impl<const L: usize> Total<L> {
    const ZERO: Self = Self { sum: Lanes::ZERO, carry: Lanes::ZERO };

    #[inline(always)]
    fn add(&mut self, change: Lanes<L>) {
        let change = change + self.carry;
        let sum = self.sum + change;
        let seen = sum - self.sum;
        self.carry = (self.sum - (sum - seen)) + (change - seen);
        self.sum = sum;
    }

    /// Takes the `lanes` of a new value instead.
    fn replace(&mut self, lanes: [bool; L], value: Lanes<L>) {
        for (i, _) in lanes.iter().enumerate().filter(|(_, replaced)| **replaced) {
            (self.sum.0[i], self.carry.0[i]) = (value.0[i], 0.0);
        }
    }

    fn scale(&mut self, factor: Lanes<L>) {
        self.sum = self.sum * factor;
        self.carry = self.carry * factor;
    }
}

/// A complex [`Total`].
#[derive(Clone, Copy)]
struct Carried<const L: usize> {
    re: Total<L>,
    im: Total<L>,
}

impl<const L: usize> Carried<L> {
    fn new(start: Complex64) -> Self {
        let [re, im] = [start.re, start.im].map(|part| Total { sum: Lanes::splat(part), ..Total::ZERO });
        Self { re, im }
    }

    #[inline(always)]
    fn sum(&self) -> Complexes<L> {
        Complexes { re: self.re.sum, im: self.im.sum }
    }

    #[inline(always)]
    fn add(&mut self, change: Complexes<L>) {
        self.re.add(change.re);
        self.im.add(change.im);
    }

    fn replace(&mut self, lanes: [bool; L], value: Complexes<L>) {
        self.re.replace(lanes, value.re);
        self.im.replace(lanes, value.im);
    }

    fn scale(&mut self, factor: Lanes<L>) {
        self.re.scale(factor);
        self.im.scale(factor);
    }
}

/// The fields at the interface reached so far: the true ones over 2^`exponent` e^(`decay` − i `phase`) (−1)^`turns`.
pub(super) struct Sweep<const L: usize> {
    psi: Carried<L>,
    phi: Carried<L>,
    /// 4Y₀ times this, over |2Y₀ incident ψ|², is the absorptance so far.
    absorbed: Total<L>,
    /// Σ Im δ.
    decay: Total<L>,
    /// Σ Re δ of layers that leave the wave that runs on as it is, less half turns.
    phase: Total<L>,
    /// Half turns taken out.
    turns: Lanes<L>,
    exponent: [i32; L],
}

/// Layers between two looks at the size of the fields.
const RESCALE_EVERY: usize = 8;
/// Fields stay within this factor of 1 (or are brought back to it): room for eight layers that each multiply them by
/// 10¹⁶, squared.
const ROOM: f64 = (1_u128 << 64) as f64;

impl<const L: usize> Sweep<L> {
    pub fn run(waves: &Waves, wavelengths: &[f64; L]) -> Self {
        debug_assert!(wavelengths.iter().all(|&w| w > 0.0 && w.is_finite()));
        let wave_number = Lanes(*wavelengths).map(|wavelength| 1.0 / wavelength);
        let mut sweep = Self {
            psi: Carried::new(Complex64::ONE),
            phi: Carried::new(waves.y_s),
            absorbed: Total::ZERO,
            decay: Total::ZERO,
            phase: Total::ZERO,
            turns: Lanes::ZERO,
            exponent: [0; L],
        };
        for coats in waves.coats.chunks(RESCALE_EVERY) {
            for coat in coats {
                sweep.pass(coat, wave_number);
            }
            sweep.rescale();
        }
        sweep
    }

    #[inline(always)]
    fn pass(&mut self, coat: &Coat, wave_number: Lanes<L>) {
        match *coat {
            Coat::Unbroken { path } => self.turn(&half_turn(wave_number * path)),
            Coat::Clear { path, y, inverse } => self.pass_clear(wave_number * path, y, inverse),
            Coat::Evanescent { path, y, inverse } => self.pass_evanescent(wave_number * path, y, inverse),
            Coat::Critical { path } => {
                let change = self.phi.sum().times_minus_i().scaled(wave_number * path);
                self.psi.add(change);
            }
            Coat::Absorbing { path, y, inverse, loss } => {
                let delta = Complexes { re: wave_number * path.re, im: wave_number * path.im };
                let loss = (wave_number * loss.0, wave_number * loss.1);
                self.pass_absorbing(delta, Complexes::splat(y), Complexes::splat(inverse), loss);
            }
        }
    }

    /// What a layer with the phase `delta` takes from the wave, of which it absorbs `absorbed` itself.
    #[inline(always)]
    fn fade(&mut self, delta: Lanes<L>, decay: &Decay<L>, absorbed: Lanes<L>) {
        self.decay.add(delta);
        let behind = self.absorbed.sum;
        self.absorbed.add(behind * decay.exp_m1 + absorbed);
        // Half of it gone, the product is exacter than the change.
        let halved = decay.exp.0.map(|exp| exp < 0.5);
        if halved.contains(&true) {
            self.absorbed.replace(halved, behind * decay.exp + absorbed);
        }
    }

    /// The phase of a layer for which the wave that runs on is left as it is.
    #[inline(always)]
    fn turn(&mut self, half: &HalfTurn<L>) {
        self.phase.add(half.remainder);
        self.turns = self.turns + half.turns;
    }

    #[inline(always)]
    fn pass_clear(&mut self, delta: Lanes<L>, y: f64, inverse: f64) {
        let half = half_turn(delta);
        self.turns = self.turns + half.turns;
        let (across, along) = (half.sin * inverse, half.sin * y);
        let (psi, phi) = (self.psi.sum(), self.phi.sum());
        self.psi.add(phi.times_minus_i().scaled(across) - psi.scaled(half.versine));
        self.phi.add(psi.times_minus_i().scaled(along) - phi.scaled(half.versine));
    }

    #[inline(always)]
    fn pass_evanescent(&mut self, delta: Lanes<L>, y: f64, inverse: f64) {
        let decay = decay(delta * 2.0);
        self.fade(delta, &decay, Lanes::ZERO);
        let (psi, phi) = (self.psi.sum(), self.phi.sum());
        let backward = Complexes { re: psi.re - phi.im * inverse, im: psi.im + phi.re * inverse };
        let change = backward.scaled(decay.exp_m1 * 0.5);
        self.psi.add(change);
        self.phi.add(Complexes { re: change.im * y, im: change.re * -y });
        let opaque = decay.exp.0.map(|exp| exp < OPAQUE);
        if opaque.contains(&true) {
            let (y, inverse) = (Complex64::new(0.0, y), Complex64::new(0.0, -inverse));
            let step = Complexes { re: decay.exp, im: Lanes::ZERO };
            self.replace(opaque, &Split::new(psi, phi, Complexes::splat(inverse)), step, Complexes::splat(y));
        }
    }

    /// The fields in front of opaque layers, from the two waves behind.
    fn replace(&mut self, opaque: [bool; L], split: &Split<L>, step: Complexes<L>, y: Complexes<L>) {
        let (forward, backward) = (split.forward, step * split.backward);
        let half = Lanes::splat(0.5);
        self.psi.replace(opaque, (forward + backward).scaled(half));
        self.phi.replace(opaque, (y * (forward - backward)).scaled(half));
    }

    #[inline(always)]
    fn pass_absorbing(
        &mut self,
        delta: Complexes<L>,
        y: Complexes<L>,
        inverse: Complexes<L>,
        loss: (Lanes<L>, Lanes<L>),
    ) {
        let half = half_turn(delta.re);
        let decay = decay(delta.im * 2.0);
        self.turn(&half);
        let (psi, phi) = (self.psi.sum(), self.phi.sum());
        let split = Split::new(psi, phi, inverse);
        let opaque = decay.exp.0.map(|exp| exp < OPAQUE);
        let squares = MeanSquares::new(delta, &half, &decay);
        let mut absorbed = squares.of(psi, phi * inverse) * loss.0 + squares.of(phi, y * psi) * loss.1;

        let sin2 = half.sin.squared();
        let u = Complexes { re: decay.exp_m1 * (-sin2 + 0.5) - sin2, im: decay.exp * (half.sin * half.cos) };
        let change = u * split.backward;
        self.psi.add(change);
        self.phi.add(Complexes::ZERO - y * change);
        if opaque.contains(&true) {
            // e^(2iδ)
            let step = Complexes { re: decay.exp * (sin2 * -2.0 + 1.0), im: u.im * 2.0 };
            self.replace(opaque, &split, step, y);
            let across = split.absorbed(delta, &half, &decay, loss, y);
            for (i, _) in opaque.iter().enumerate().filter(|(_, opaque)| **opaque) {
                absorbed.0[i] = across.0[i];
            }
        }
        self.fade(delta.im, &decay, absorbed);
    }

    /// Brings fields that have left the room back to about 1, by a power of two.
    fn rescale(&mut self) {
        let size = |z: Complexes<L>| z.re.zip(z.im, |a, b| a.abs().max(b.abs()));
        let size = size(self.psi.sum()).zip(size(self.phi.sum()), f64::max);
        if size.0.iter().all(|s| (1.0 / ROOM..=ROOM).contains(s)) {
            return;
        }
        let shift = size.map(|s| if (1.0 / ROOM..=ROOM).contains(&s) { 0.0 } else { s.log2().floor() });
        let factor = shift.map(|shift| (-shift).exp2());
        self.psi.scale(factor);
        self.phi.scale(factor);
        self.absorbed.scale(factor.squared());
        for (exponent, shift) in self.exponent.iter_mut().zip(shift.0) {
            *exponent += shift as i32;
        }
    }

    /// Y₀ψ ∓ φ: twice Y₀ times the reflected and the incident wave.
    #[inline(always)]
    fn incident_waves(&self, waves: &Waves) -> (Complexes<L>, Complexes<L>) {
        let y_i = Lanes::splat(waves.y_i);
        let (psi, phi) = (self.psi.sum().scaled(y_i), self.phi.sum());
        (psi - phi, psi + phi)
    }

    pub fn powers_into(&self, waves: &Waves, powers: &mut [Powers]) {
        let (reflected, incident) = self.incident_waves(waves);
        let incident = incident.norm_sqr();
        let reflectance = reflected.norm_sqr().zip(incident, |a, b| a / b);
        let unit = incident.map(|b| 4.0 * waves.y_i / b);
        let absorptance = unit * self.absorbed.sum;
        for (i, powers) in powers.iter_mut().enumerate() {
            *powers = if incident.0[i] == 0.0 {
                UNHINDERED
            } else {
                let transmittance = faded(unit.0[i] * waves.y_s.re, 2.0 * self.decay.sum.0[i], 2 * self.exponent[i]);
                Powers { reflectance: reflectance.0[i], transmittance, absorptance: absorptance.0[i] }.balanced()
            };
        }
    }
}

impl Powers {
    /// R + T + A = 1: where R or T is the larger part, the others, each with all its digits, know it best.
    fn balanced(self) -> Self {
        let Self { reflectance, transmittance, absorptance } = self;
        if reflectance + absorptance <= transmittance {
            Self { transmittance: 1.0 - (reflectance + absorptance), ..self }
        } else if transmittance + absorptance <= reflectance {
            Self { reflectance: 1.0 - (transmittance + absorptance), ..self }
        } else {
            self
        }
    }
}

/// Grazing light through nothing but its own medium.
const UNHINDERED: Powers = Powers { reflectance: 0.0, transmittance: 1.0, absorptance: 0.0 };

impl Sweep<1> {
    pub fn response(&self, waves: &Waves) -> Response {
        let mut powers = UNHINDERED;
        self.powers_into(waves, std::slice::from_mut(&mut powers));
        let Powers { reflectance, transmittance, absorptance } = powers;
        let (reflected, incident) = self.incident_waves(waves);
        let (reflected, incident) = (first(reflected), first(incident));
        if incident.norm_sqr() == 0.0 {
            let (r, t, ln_transmittance) = (Complex64::ZERO, Complex64::ONE, 0.0);
            return Response { r, t, reflectance, transmittance, absorptance, ln_transmittance };
        }
        let (decay, exponent) = (self.decay.sum.0[0], self.exponent[0]);
        let sign = if self.turns.0[0] % 2.0 == 0.0 { 1.0 } else { -1.0 };
        let size = sign * faded(2.0 * waves.y_i, decay, exponent);
        let t = waves.t_unit * Complex64::from_polar(1.0, self.phase.sum.0[0]) * size / incident;
        let kept_back = reflectance + absorptance;
        let ln_transmittance = if kept_back <= transmittance {
            (-kept_back).ln_1p()
        } else {
            (4.0 * waves.y_i / incident.norm_sqr()).ln() + waves.y_s.re.ln()
                - 2.0 * (decay + f64::from(exponent) * LN_2)
        };
        Response { r: reflected / incident, t, reflectance, transmittance, absorptance, ln_transmittance }
    }
}

fn first(z: Complexes<1>) -> Complex64 {
    Complex64::new(z.re.0[0], z.im.0[0])
}

/// x e^(−decay) 2^(−exponent), without overflow on the way.
fn faded(x: f64, decay: f64, exponent: i32) -> f64 {
    if decay == 0.0 && exponent == 0 {
        return x;
    }
    if decay > 600.0 || exponent.abs() > 900 {
        return x * (-decay - f64::from(exponent) * LN_2).exp();
    }
    x * (-decay).exp() * f64::from(-exponent).exp2()
}

/// e^(−2 Im δ) below which a layer counts as opaque. What it hides must not matter in front of it, not even by its
/// rounding: there the fields and the absorption are made of the two waves, whose forward one alone remains.
const OPAQUE: f64 = 1.0 / 16.0;

/// Twice the forward and the backward wave at the back of a layer.
struct Split<const L: usize> {
    forward: Complexes<L>,
    backward: Complexes<L>,
}

impl<const L: usize> Split<L> {
    #[inline(always)]
    fn new(psi: Complexes<L>, phi: Complexes<L>, inverse: Complexes<L>) -> Self {
        let other = phi * inverse;
        Self { forward: psi + other, backward: psi - other }
    }

    /// Absorption in the layer, as by [`MeanSquares`] where that does not cancel: the waves e^(∓iδ) give
    /// (1 − e^(−2β))/(2β) and e^(−2β) times that, β = Im δ, and their interference e^(−2β) sinc(α) e^(iα), α = Re δ.
    fn absorbed(
        &self,
        delta: Complexes<L>,
        half: &HalfTurn<L>,
        decay: &Decay<L>,
        loss: (Lanes<L>, Lanes<L>),
        y: Complexes<L>,
    ) -> Lanes<L> {
        let (f, b) = (self.forward, self.backward);
        let alone =
            (f.norm_sqr() + decay.exp * b.norm_sqr()) * (-decay.exp_m1).zip(delta.im, |m, beta| m / (2.0 * beta));
        let sinc = half.sin.zip(delta.re, |sin, alpha| sin / alpha.max(f64::MIN_POSITIVE));
        let (re, im) = (f.re * b.re + f.im * b.im, f.re * b.im - f.im * b.re);
        let both = decay.exp * sinc * (re * half.cos - im * half.sin) * 2.0;
        ((alone + both) * loss.0 + (alone - both) * y.norm_sqr() * loss.1) * 0.25
    }
}

/// Means over a layer of the products of cos(k₀ q z) and sin(k₀ q z), times e^(−2 Im δ).
struct MeanSquares<const L: usize> {
    /// ⟨|cos|²⟩
    cos_cos: Lanes<L>,
    /// ⟨|sin|²⟩
    sin_sin: Lanes<L>,
    /// ⟨cos* sin⟩
    cos_sin: Complexes<L>,
}

impl<const L: usize> MeanSquares<L> {
    fn new(delta: Complexes<L>, half: &HalfTurn<L>, decay: &Decay<L>) -> Self {
        let alpha = delta.re.map(|x| x.max(f64::MIN_POSITIVE));
        let beta = delta.im.map(|x| x.max(f64::MIN_POSITIVE));
        let (sinc, turn) = (half.sin.zip(alpha, |sin, a| sin / a), alpha * 2.0);
        let (slope, fall) = (decay.exp_m1.zip(beta, |m, b| m / b), beta * 2.0);
        // 1 − sin(2α)/(2α) and (sinh(2β)/(2β) − 1) e^(−2β): both ≥ 0, by series where they are small.
        let sinc_gap = cubic_gap(-turn.squared()).where_below_one(turn, -(sinc * half.cos) + 1.0) * decay.exp;
        let sinhc_gap = (-cubic_gap(fall.squared()) * decay.exp)
            .where_below_one(fall, -(slope * (decay.exp + 1.0) * 0.25) - decay.exp);
        Self {
            cos_cos: decay.exp + (sinhc_gap - sinc_gap) * 0.5,
            sin_sin: (sinhc_gap + sinc_gap) * 0.5,
            cos_sin: Complexes { re: half.sin * sinc * decay.exp * 0.5, im: decay.exp_m1 * slope * 0.125 },
        }
    }

    /// ⟨|a cos − i b sin|²⟩
    #[inline(always)]
    fn of(&self, a: Complexes<L>, b: Complexes<L>) -> Lanes<L> {
        let (re, im) = (a.re * b.re + a.im * b.im, a.re * b.im - a.im * b.re);
        a.norm_sqr() * self.cos_cos + b.norm_sqr() * self.sin_sin + (im * self.cos_sin.re + re * self.cos_sin.im) * 2.0
    }
}

/// −Σ xᵏ/(2k+1)! from k = 1: 1 − sin(y)/y at x = −y², 1 − sinh(y)/y at x = y², for |x| ≤ 1.
#[inline(always)]
fn cubic_gap<const L: usize>(x: Lanes<L>) -> Lanes<L> {
    const TERMS: [f64; 8] = [
        1.0 / 6.0,
        1.0 / 120.0,
        1.0 / 5040.0,
        1.0 / 362880.0,
        1.0 / 39916800.0,
        1.0 / 6227020800.0,
        1.0 / 1307674368000.0,
        1.0 / 355687428096000.0,
    ];
    -x * x.polynomial(&TERMS)
}
