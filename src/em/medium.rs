//! Media, and what one time step in them multiplies by.
//!
//! Conduction makes Ampère's law a relaxation at every cell, ε dE/dt = ∇×H − σE, with x = σΔt/ε per step. Its step is
//! E′ = E + (drive·curl − loss·E) or, the same thing, E′ = keep·E + drive·curl, with keep = 1 − loss:
//!
//! | | loss | keep | drive/(S/ε_r) |
//! |---|---|---|---|
//! | semi-implicit (T&H §3.6.3) | x/(1 + x/2) | (1 − x/2)/(1 + x/2) | 1/(1 + x/2) |
//! | exponential (Holland 1994, T&H §3.6.4) | 1 − e^(−x) | e^(−x) | (1 − e^(−x))/x |
//!
//! In a poor conductor keep rounds to nearly 1 and its rounding error is made anew at every step, always the same
//! way, so that the wave decays at a wrong rate; in a good one loss rounds to 1 and forgets what is left, and where the
//! semi-implicit step rings, keep ≈ −1, so does keep. So a cell is stepped with whichever of loss, keep and 1 + keep is
//! the smallest, computed as itself: E′ = base·E + (drive·curl − rest·E) with base 1, 0 or −1.
//!
//! A Drude metal, ε(ω) = ε_r − ω_p²/(ω² + iγω), adds a current dJ/dt + γJ = ε₀ω_p² E, taken at whole steps and
//! averaged (T&H §9.4.1): it is stable up to the Courant limit of the grid without the metal.

use super::refusal::{Refusal, demand};
use super::{C, EPSILON_0};
use crate::waves::conduction::{Scheme, Update};
use num_complex::Complex64;

/// A homogeneous, isotropic medium.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Medium {
    /// Relative permittivity [1], > 0; of a Drude metal: at infinite frequency.
    pub eps_r: f64,
    /// Relative permeability [1], > 0.
    pub mu_r: f64,
    /// Conductivity [S/m], ≥ 0.
    pub sigma: f64,
    /// Free electrons, if it is a metal with a finite collision rate.
    pub drude: Option<Drude>,
}

/// Free electrons (Drude): J = ε₀ω_p² E/(γ − iω).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drude {
    /// Plasma frequency ω_p [rad/s], > 0.
    pub plasma: f64,
    /// Collision frequency γ [1/s], ≥ 0.
    pub collision: f64,
}

/// How conduction is stepped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Conduction {
    /// σE at the mean of the two steps (Crank–Nicolson): second order; rings in a good conductor.
    SemiImplicit,
    /// The exact relaxation towards a constant curl: second order; decays in a good conductor.
    Exponential,
}

impl Conduction {
    /// One step for x = σΔt/ε ≥ 0 [1]: the gain is what the curl is multiplied by over Δt/ε.
    pub fn update(self, x: f64) -> Update {
        let scheme = match self {
            Self::SemiImplicit => Scheme::SemiImplicit,
            Self::Exponential => Scheme::Exponential,
        };
        Update::new(scheme, 1.0, x, 1.0)
    }
}

impl Medium {
    /// Vacuum.
    pub const VACUUM: Self = Self { eps_r: 1.0, mu_r: 1.0, sigma: 0.0, drude: None };

    /// A clear medium of relative permittivity `eps_r` [1].
    pub const fn dielectric(eps_r: f64) -> Self {
        Self { eps_r, ..Self::VACUUM }
    }

    /// A medium of relative permittivity `eps_r` [1] and conductivity `sigma` [S/m].
    pub const fn conductor(eps_r: f64, sigma: f64) -> Self {
        Self { eps_r, sigma, ..Self::VACUUM }
    }

    /// Free electrons in vacuum: plasma and collision frequency [rad/s, 1/s].
    pub const fn metal(plasma: f64, collision: f64) -> Self {
        Self { drude: Some(Drude { plasma, collision }), ..Self::VACUUM }
    }

    /// Relative permittivity [1] of the continuous medium at ω [rad/s] > 0, conduction and electrons included.
    pub fn permittivity(&self, omega: f64) -> Complex64 {
        let conduction = Complex64::new(self.eps_r, self.sigma / (EPSILON_0 * omega));
        self.drude.map_or(conduction, |Drude { plasma, collision }| {
            conduction - plasma * plasma / (omega * Complex64::new(omega, collision))
        })
    }

    /// Index n + iκ [1], κ ≥ 0, of the continuous medium at ω [rad/s] > 0.
    pub fn index(&self, omega: f64) -> Complex64 {
        (self.permittivity(omega) * self.mu_r).sqrt()
    }

    /// √(ε_r μ_r) [1], without conduction and electrons.
    pub(super) fn bare_index(&self) -> f64 {
        (self.eps_r * self.mu_r).sqrt()
    }

    /// Refuses what is not physical, NaN included, and what no product of two such numbers could hold.
    pub(super) fn check(&self) -> Result<(), Refusal> {
        let positive = |value: f64| value > 0.0 && value <= HUGE;
        let not_negative = |value: f64| (0.0..=HUGE).contains(&value);
        demand(positive(self.eps_r), "relative permittivity", self.eps_r, "above 0 and at most 1e30")?;
        demand(positive(self.mu_r), "relative permeability", self.mu_r, "above 0 and at most 1e30")?;
        demand(not_negative(self.sigma), "conductivity", self.sigma, "0 to 1e30 S/m")?;
        let Some(Drude { plasma, collision }) = self.drude else { return Ok(()) };
        demand(positive(plasma), "plasma frequency", plasma, "above 0 and at most 1e30 rad/s")?;
        demand(not_negative(collision), "collision frequency", collision, "0 to 1e30 1/s")
    }
}

/// Beyond every number of physics in SI units, and small enough that squares of products do not overflow.
pub(super) const HUGE: f64 = 1e30;

/// What surrounds one E component: the mean of the cells it touches, which makes E along an interface
/// second-order accurate.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Surroundings {
    eps_r: f64,
    sigma: f64,
    /// Σ ω_p².
    plasma2: f64,
    /// Σ ω_p² γ.
    collision: f64,
}

impl Surroundings {
    /// The mean of `cells`; electrons of several metals collide at the rate that keeps their mean dissipation.
    pub fn mean<const N: usize>(cells: [&Medium; N]) -> Self {
        let mut sum = Self::default();
        for cell in cells {
            sum.eps_r += cell.eps_r;
            sum.sigma += cell.sigma;
            if let Some(Drude { plasma, collision }) = cell.drude {
                sum.plasma2 += plasma * plasma;
                sum.collision += plasma * plasma * collision;
            }
        }
        let share = 1.0 / N as f64;
        Self {
            eps_r: sum.eps_r * share,
            sigma: sum.sigma * share,
            plasma2: sum.plasma2 * share,
            collision: if sum.plasma2 > 0.0 { sum.collision / sum.plasma2 } else { 0.0 },
        }
    }

    /// Relative permittivity [1] at infinite frequency.
    pub fn eps_r(&self) -> f64 {
        self.eps_r
    }

    /// σ over ε₀ per step, σΔt/ε₀ [1].
    pub fn conduction(&self, dt: f64) -> f64 {
        self.sigma * dt / EPSILON_0
    }

    /// ω_p²Δt² and γΔt [1].
    pub fn electrons(&self, dt: f64) -> (f64, f64) {
        (self.plasma2 * dt * dt, self.collision * dt)
    }

    /// Coefficients of its step.
    pub fn coefficients(&self, courant: f64, dt: f64, conduction: Conduction) -> Coefficients {
        let (plasma2, collision) = self.electrons(dt);
        let pole = 1.0 + 0.5 * collision;
        let pull = 0.5 * plasma2 / (self.eps_r * pole);
        // Electrons are stepped semi-implicitly, and conduction with them.
        let scheme = if plasma2 > 0.0 { Conduction::SemiImplicit } else { conduction };
        let step = scheme.update(self.conduction(dt) / self.eps_r + pull);
        let (base, rest) = match step.keep {
            keep if keep >= 0.5 => (1.0, step.loss),
            keep if keep > -0.5 => (0.0, -keep),
            // Only the semi-implicit step goes there, and its 1 + keep is 2/(1 + x/2).
            _ => (-1.0, -2.0 * step.gain),
        };
        Coefficients {
            drive: courant / self.eps_r * step.gain,
            base,
            rest,
            share: 1.0 / pole,
            memory: (1.0 - 0.5 * collision) / pole,
            gain: 0.5 * plasma2 / (courant * pole),
        }
    }
}

/// E′ = base·E + (drive·(curl − share·J) − rest·E) and J′ = memory·J + gain·(E + E′), all in V/m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Coefficients {
    pub drive: f64,
    pub base: f64,
    pub rest: f64,
    pub share: f64,
    pub memory: f64,
    pub gain: f64,
}

impl Coefficients {
    /// H′ = H + (S/μ_r)·curl.
    pub fn magnetic(courant: f64, mu_r: f64) -> Self {
        Self { drive: courant / mu_r, base: 1.0, rest: 0.0, share: 1.0, memory: 1.0, gain: 0.0 }
    }
}

/// Time step [s] of a grid.
pub(super) fn time_step(courant: f64, spacing: f64) -> f64 {
    courant * spacing / C
}
