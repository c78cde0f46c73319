//! A harmonic plane wave in a uniform medium that may conduct: E10–E19.
//!
//! E = A e^(i(kz − ωt)) with k² = ω²με + iωμσ = ω²με (1 + iτ), τ = σ/(ωε) the loss tangent, and H = E/Z with
//! Z = ωμ/k (Born & Wolf, *Principles of Optics* (7th ed.), §14.1; Jackson, *Classical Electrodynamics* (3rd ed.),
//! §5.18 and §7.5). The books' Im k = ω√(με/2) (√(1 + τ²) − 1)^½ cancels where the loss is small. Here the larger part
//! of √(1 + iτ) is a sum of positive terms and the smaller one follows from the product of the two, which is τ/2.

use super::constants::{C, EPSILON_0, MU_0, Z_0};
use super::scaled::Scaled;
use num_complex::Complex64;
use std::f64::consts::{FRAC_PI_4, LN_10, TAU};
use std::fmt;

/// A uniform isotropic medium (E3): D = εE, B = μH, J = σE.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Medium {
    epsilon: f64,
    mu: f64,
    sigma: f64,
}

impl Medium {
    /// Empty space.
    pub const VACUUM: Self = Self { epsilon: EPSILON_0, mu: MU_0, sigma: 0.0 };

    /// From ε [F m⁻¹], μ [H m⁻¹], both positive and finite, and σ [S m⁻¹] ≥ 0; σ = ∞ is the perfect conductor.
    pub fn new(epsilon: f64, mu: f64, sigma: f64) -> Result<Self, Invalid> {
        let epsilon = Invalid::unless_positive("eps", epsilon)?;
        let mu = Invalid::unless_positive("mu", mu)?;
        Ok(Self { epsilon, mu, sigma: Invalid::unless_lossy("sigma", sigma)? })
    }

    /// From ε_r [1], μ_r [1] and σ [S m⁻¹]; domain as [`Self::new`].
    pub fn relative(epsilon_r: f64, mu_r: f64, sigma: f64) -> Result<Self, Invalid> {
        let epsilon_r = Invalid::unless_positive("eps_r", epsilon_r)?;
        let mu_r = Invalid::unless_positive("mu_r", mu_r)?;
        Self::new(epsilon_r * EPSILON_0, mu_r * MU_0, sigma)
    }

    /// ε: permittivity [F m⁻¹].
    pub fn epsilon(&self) -> f64 {
        self.epsilon
    }

    /// μ: permeability [H m⁻¹].
    pub fn mu(&self) -> f64 {
        self.mu
    }

    /// σ: conductivity [S m⁻¹].
    pub fn sigma(&self) -> f64 {
        self.sigma
    }

    /// σ/(ωε) [1]: conduction over displacement current at ω > 0 [rad s⁻¹].
    pub fn loss_tangent(&self, omega: f64) -> f64 {
        if self.sigma.is_infinite() { self.sigma } else { self.tangent(Scaled::from(omega)).to_f64() }
    }

    fn tangent(&self, omega: Scaled) -> Scaled {
        Scaled::from(self.sigma) / (omega * Scaled::from(self.epsilon))
    }
}

/// A value that no medium or wave can have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Invalid {
    /// Which input (`eps_r`).
    pub place: &'static str,
    /// What was given.
    pub value: f64,
    /// What it may be.
    pub valid: &'static str,
}

impl Invalid {
    /// `value` if it is positive and finite.
    pub fn unless_positive(place: &'static str, value: f64) -> Result<f64, Self> {
        if value > 0.0 && value.is_finite() { Ok(value) } else { Err(Self { place, value, valid: "positive, finite" }) }
    }

    fn unless_lossy(place: &'static str, value: f64) -> Result<f64, Self> {
        // Adding zero takes the sign off a negative one.
        if value >= 0.0 { Ok(value + 0.0) } else { Err(Self { place, value, valid: "zero to infinity" }) }
    }
}

impl fmt::Display for Invalid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {} is out of range; valid: {}", self.place, Plain(self.value), self.valid)
    }
}

/// A number in a message: its digits, with a power of ten where there would be many zeros.
pub(crate) struct Plain(pub f64);

impl fmt::Display for Plain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = self.0.abs();
        let plain = size == 0.0 || (1e-4..=1e7).contains(&size) || !size.is_finite();
        if plain { write!(f, "{}", self.0) } else { write!(f, "{:e}", self.0) }
    }
}

impl std::error::Error for Invalid {}

/// What the medium makes of a harmonic wave.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wave {
    /// ω: angular frequency [rad s⁻¹].
    pub omega: f64,
    /// k: complex wave number [rad m⁻¹], both parts ≥ 0; Im k is the attenuation [Np m⁻¹] (E18, E19).
    pub k: Complex64,
    /// Z = E/H: impedance [Ω] (E17); Im Z ≤ 0, as H lags.
    pub impedance: Complex64,
    /// 1/Im k: depth [m] at which the field has fallen to 1/e; ∞ without loss.
    pub skin_depth: f64,
    /// arg k: phase [rad] by which H lags E, 0 … π/4 in a medium with ε > 0.
    pub phase_lag: f64,
    /// 2π/Re k [m].
    pub wavelength: f64,
    /// ω/Re k [m s⁻¹].
    pub v_phase: f64,
    /// ⟨S⟩ = ½ Re(1/Z) A² at z = 0 for A = 1 V m⁻¹ [W m⁻²] (E23, E24).
    pub mean_flux: f64,
}

/// Loss tangents above this are their own √(1 + τ²), those below its reciprocal change nothing beside 1.
const EXTREME: f64 = (1_u64 << 60) as f64;

impl Wave {
    /// The wave of angular frequency `omega` [rad s⁻¹], positive and finite, in `medium`. Every output is right to a
    /// few roundings wherever it can be represented, for inputs from the whole range of `f64`.
    ///
    /// The perfect conductor is answered by the limit σ → ∞: k = ∞(1 + i), Z = 0, skin depth, wavelength and speed 0,
    /// lag π/4. There ⟨S⟩ = ∞ belongs to the imposed 1 V m⁻¹, which would take an infinite current to uphold; for a given
    /// H it goes to 0 as 1/√σ.
    pub fn new(medium: &Medium, omega: f64) -> Result<Self, Invalid> {
        let omega = Invalid::unless_positive("omega", omega)?;
        if medium.sigma.is_infinite() {
            return Ok(Self::in_perfect_conductor(omega));
        }
        let [scaled_omega, epsilon, mu, half, two] = [omega, medium.epsilon, medium.mu, 0.5, 2.0].map(Scaled::from);
        let tau = medium.tangent(scaled_omega);
        let tangent = tau.to_f64();
        // √(1 + iτ) = a + ib and |1 + iτ|.
        let (a, modulus) = if tangent > EXTREME {
            ((tau * half).sqrt(), tau)
        } else {
            let modulus = tangent.hypot(1.0);
            (Scaled::from((0.5 * (1.0 + modulus)).sqrt()), Scaled::from(modulus))
        };
        let b = tau / (two * a);
        let slowness = (mu * epsilon).sqrt();
        let free = scaled_omega * slowness;
        let (k_re, k_im) = (free * a, free * b);
        let impedance = (mu / epsilon).sqrt() / modulus;
        let one = Scaled::from(1.0);
        Ok(Self {
            omega,
            k: Complex64::new(k_re.to_f64(), k_im.to_f64()),
            impedance: Complex64::new((impedance * a).to_f64(), 0.0 - (impedance * b).to_f64()),
            skin_depth: if medium.sigma == 0.0 { f64::INFINITY } else { (one / k_im).to_f64() },
            phase_lag: if tangent < 1.0 / EXTREME { (half * tau).to_f64() } else { 0.5 * tangent.atan() },
            wavelength: (Scaled::from(TAU) / k_re).to_f64(),
            v_phase: (one / (slowness * a)).to_f64(),
            mean_flux: (half * a * (epsilon / mu).sqrt()).to_f64(),
        })
    }

    fn in_perfect_conductor(omega: f64) -> Self {
        Self {
            omega,
            k: Complex64::new(f64::INFINITY, f64::INFINITY),
            impedance: Complex64::ZERO,
            skin_depth: 0.0,
            phase_lag: FRAC_PI_4,
            wavelength: 0.0,
            v_phase: 0.0,
            mean_flux: f64::INFINITY,
        }
    }

    /// The wave of angular frequency `omega` [rad s⁻¹] in a non-magnetic medium known by its refractive index n + iκ,
    /// n > 0 and κ ≥ 0: k = (ω/c)(n + iκ). Metals at optical frequencies, where ε < 0, are within reach here alone.
    pub fn with_index(index: Complex64, omega: f64) -> Result<Self, Invalid> {
        let omega = Invalid::unless_positive("omega", omega)?;
        let n = Invalid::unless_positive("n", index.re)?;
        let kappa = Invalid::unless_lossy("k", index.im)?;
        let (free, modulus) = (omega / C, n.hypot(kappa));
        let k = Complex64::new(n, kappa) * free;
        Ok(Self {
            omega,
            k,
            impedance: Complex64::new(n / modulus, 0.0 - kappa / modulus) * (Z_0 / modulus),
            skin_depth: 1.0 / k.im,
            phase_lag: kappa.atan2(n),
            wavelength: TAU / k.re,
            v_phase: C / n,
            mean_flux: 0.5 * n / Z_0,
        })
    }

    /// Frequency ω/2π [Hz].
    pub fn frequency(&self) -> f64 {
        self.omega / TAU
    }

    /// Attenuation of the field [dB m⁻¹]: 20 lg e · Im k.
    pub fn attenuation_db(&self) -> f64 {
        self.k.im * (20.0 / LN_10)
    }

    /// n + iκ = ck/ω [1], the refractive index that [`crate::optics`] works with.
    pub fn index(&self) -> Complex64 {
        self.k / (self.omega / C)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::references::waves::{NAMES, PlaneWave, flat};
    use yardstick::precise;
    use yardstick::random::{stream, uniform};

    /// The worst error of any output over what 16 ulp · (1 + cond) allows, where the answer is a normal number.
    fn excess(medium: &Medium, omega: f64) -> (f64, &'static str) {
        let exact = PlaneWave::new(medium, omega);
        let (ours, conditions) = (flat(&Wave::new(medium, omega).unwrap()), exact.conditions());
        let of = |at: usize| match &exact.outputs[at] {
            None => {
                if ours[at] == f64::INFINITY {
                    0.0
                } else {
                    f64::INFINITY
                }
            }
            Some(exact) => {
                let size = precise::to_f64(exact).abs();
                if !(f64::MIN_POSITIVE..=f64::MAX).contains(&size) {
                    let end = if size > 1.0 { f64::INFINITY } else { size };
                    return if (ours[at].abs() - end).abs() <= 5e-324 || ours[at].abs() == end {
                        0.0
                    } else {
                        f64::INFINITY
                    };
                }
                precise::relative_error(ours[at], exact) / (16.0 * f64::EPSILON * (1.0 + conditions[at]))
            }
        };
        (0..NAMES.len()).map(|at| (of(at), NAMES[at])).max_by(|a, b| a.0.total_cmp(&b.0)).unwrap()
    }

    fn power(stream: &mut yardstick::random::Stream, low: f64, high: f64) -> f64 {
        10f64.powf(uniform(stream, low, high))
    }

    #[test]
    fn every_output_keeps_its_digits_everywhere() {
        let mut stream = stream(0, "waves/plane");
        let mut worst = (0.0, "", String::new());
        let mut cases = 0;
        let mut judge = |medium: Result<Medium, Invalid>, omega: f64| {
            // What overflows is a perfect conductor, and what underflows no medium at all.
            let Some(medium) = medium.ok().filter(|medium| medium.sigma().is_finite()) else { return };
            let (found, name) = excess(&medium, omega);
            cases += 1;
            if found.total_cmp(&worst.0).is_gt() {
                worst = (found, name, format!("{medium:?} ω = {omega}"));
            }
        };
        for _ in 0..5000 {
            let (epsilon_r, mu_r) = (power(&mut stream, -3.0, 5.0), power(&mut stream, -3.0, 6.0));
            let omega = power(&mut stream, -3.0, 17.0);
            // Loss tangents from 1e−300 to 1e300, and real conductivities.
            let tau = power(&mut stream, -300.0, 300.0);
            judge(Medium::relative(epsilon_r, mu_r, tau * omega * epsilon_r * EPSILON_0), omega);
            judge(Medium::relative(epsilon_r, mu_r, power(&mut stream, -18.0, 9.0)), omega);
        }
        // Anything that f64 can hold.
        for _ in 0..2000 {
            let mut any = || power(&mut stream, -323.0, 308.0);
            judge(Medium::new(any(), any(), any()), any());
        }
        for omega in [6e-3, 1.0, 314.0, 6e9, 3.4e15, 6e16] {
            for sigma in [0.0, 5e-324, 1e-310, 1e-30, 1e-12, 1.0, 5.8e7, 1e12, 1e300, f64::MAX] {
                judge(Medium::relative(1.0, 1.0, sigma), omega);
            }
        }
        assert!(cases > 10_000, "{cases}");
        assert!(worst.0 <= 1.0, "{worst:?}");
    }

    #[test]
    fn the_vacuum_has_its_constants() {
        let wave = Wave::new(&Medium::VACUUM, TAU * 5.45e14).unwrap();
        assert_eq!((wave.v_phase, wave.k.im, wave.skin_depth), (C, 0.0, f64::INFINITY));
        // CODATA 2022: ε₀ to its last printed digit, Z₀ = 376.730 313 412(59) Ω.
        assert!((EPSILON_0 / 8.854_187_818_8e-12 - 1.0).abs() < 2e-12);
        assert!((wave.impedance.re / 376.730_313_412 - 1.0).abs() < 1e-12);
        assert!((wave.mean_flux * 2.0 * Z_0 - 1.0).abs() < 4.0 * f64::EPSILON);
    }

    #[test]
    fn the_perfect_conductor_is_where_good_ones_lead() {
        let wave = |sigma: f64| Wave::new(&Medium::relative(1.0, 1.0, sigma).unwrap(), 1e9).unwrap();
        let (perfect, good) = (wave(f64::INFINITY), wave(1e300));
        assert_eq!(perfect.phase_lag, good.phase_lag);
        let ends =
            [perfect.skin_depth, perfect.wavelength, perfect.v_phase, perfect.impedance.norm(), 1.0 / perfect.k.re];
        assert_eq!(ends, [0.0; 5]);
        assert!([good.skin_depth, good.wavelength, good.v_phase, good.impedance.norm()].iter().all(|x| *x < 1e-130));
    }

    #[test]
    fn the_books_forms_lose_what_these_keep() {
        use crate::waves::textbook;
        let error = |found: f64, medium: &Medium, at: usize| {
            precise::relative_error(found, PlaneWave::new(medium, 1e9).outputs[at].as_ref().unwrap())
        };
        // Half of the digits are gone at a loss tangent of 1e−4, all of them at 1e−8.
        for (sigma, least) in [(1e-6, 1e-10), (8e-11, 1e-2), (1e-20, 1.0)] {
            let medium = Medium::relative(1.0, 1.0, sigma).unwrap();
            assert!(error(textbook::wave(&medium, 1e9).k.im, &medium, 1) >= least, "{sigma}");
            assert!(error(Wave::new(&medium, 1e9).unwrap().k.im, &medium, 1) < 1e-15);
        }
        // τ² overflows long before anything else does.
        let beyond = Medium::relative(1.0, 1.0, 1e160).unwrap();
        assert!(textbook::wave(&beyond, 1e9).k.im.is_infinite());
        assert!(Wave::new(&beyond, 1e9).unwrap().k.im.is_finite());
    }

    #[test]
    fn decibels_are_nepers_times_8_686() {
        let wave = Wave::new(&Medium::relative(72.5, 1.0, 4.79).unwrap(), TAU * 1e4).unwrap();
        assert!((wave.attenuation_db() / wave.k.im - 8.685_889_638_065_037).abs() < 1e-14);
    }

    #[test]
    fn bad_input_is_named() {
        let place = |medium: Result<Medium, Invalid>| medium.unwrap_err().place;
        for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(place(Medium::relative(bad, 1.0, 0.0)), "eps_r");
            assert_eq!(place(Medium::relative(1.0, bad, 0.0)), "mu_r");
            assert_eq!(place(Medium::new(bad, 1.0, 0.0)), "eps");
            assert_eq!(place(Medium::new(1.0, bad, 0.0)), "mu");
            assert_eq!(Wave::new(&Medium::VACUUM, bad).unwrap_err().place, "omega");
            assert_eq!(Wave::with_index(Complex64::new(bad, 0.0), 1.0).unwrap_err().place, "n");
        }
        assert_eq!(place(Medium::relative(1.0, 1.0, -1e-9)), "sigma");
        let message = Medium::relative(1.0, 1.0, f64::NAN).unwrap_err().to_string();
        assert_eq!(message, "sigma: NaN is out of range; valid: zero to infinity");
        let message = |eps_r: f64| Medium::relative(eps_r, 1.0, 0.0).unwrap_err().to_string();
        assert_eq!(message(-1e300), "eps_r: -1e300 is out of range; valid: positive, finite");
        assert_eq!(message(-0.25), "eps_r: -0.25 is out of range; valid: positive, finite");
    }
}
