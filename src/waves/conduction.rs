//! Ampère's law with loss in one cell of a grid, ε dE/dt = −σE + ∇×H: stiff where the charge relaxes (ε/σ) much faster
//! than the field changes. How the usual updates of E do there, and an implicit solver that chooses its own steps.
//!
//! Taflove & Hagness, *Computational Electrodynamics* (3rd ed.), §3.6 (semi-implicit); Holland, IEEE Trans.
//! Electromagn. Compat. 36 (1994) 32 and Schuster, Wu, Ohs & Luebbers, IEEE Trans. Antennas Propag. 53 (2005) 2342
//! (exponential); Hairer & Wanner, *Solving Ordinary Differential Equations II*, §IV.3 (stability) and §IV.8 (Radau IIA).

use super::plane::Invalid;
use super::radau::{Equation, Found, Stuck};

/// How E is taken one step Δt further.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scheme {
    /// E and ∇×H at the old time. Order 1; stable up to σΔt/ε = 2.
    ForwardEuler,
    /// E as the mean of old and new, ∇×H half-way: the usual Yee update. Order 2 at any stiffness; always stable, but a
    /// transient it cannot resolve rings, (−1)ⁿ, instead of dying out.
    SemiImplicit,
    /// Exact for a ∇×H that stays what it is half-way. Order 2 where it resolves the relaxation; where it does not, E
    /// follows ∇×H half a step late: order 1. Always stable, and transients die.
    Exponential,
    /// E and ∇×H at the new time. Order 1, with an error that falls with stiffness; always stable, transients die.
    BackwardEuler,
}

impl Scheme {
    /// Every scheme.
    pub const ALL: [Self; 4] = [Self::ForwardEuler, Self::SemiImplicit, Self::Exponential, Self::BackwardEuler];

    /// The share of the step at which ∇×H is taken.
    pub fn drive_at(self) -> f64 {
        match self {
            Self::ForwardEuler => 0.0,
            Self::SemiImplicit | Self::Exponential => 0.5,
            Self::BackwardEuler => 1.0,
        }
    }
}

/// E → keep · E + gain · ∇×H, the update coefficients known as Ca and Cb. Each keeps its digits at any σΔt/ε from 0 to
/// ∞, and so does 1 − keep, on which a slow decay lives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Update {
    /// Ca [1].
    pub keep: f64,
    /// 1 − Ca [1].
    pub loss: f64,
    /// Cb [Ω m].
    pub gain: f64,
}

impl Update {
    /// Of `scheme` for ε [F m⁻¹] > 0, σ [S m⁻¹] ≥ 0 and Δt [s] > 0, whose products stay within the range of `f64`.
    pub fn new(scheme: Scheme, epsilon: f64, sigma: f64, dt: f64) -> Self {
        debug_assert!(epsilon > 0.0 && sigma >= 0.0 && dt > 0.0);
        let lost = sigma * dt;
        let over = |keep: f64, lost: f64, all: f64| Self { keep: keep / all, loss: lost / all, gain: dt / all };
        match scheme {
            Scheme::ForwardEuler => over(epsilon - lost, lost, epsilon),
            Scheme::SemiImplicit if lost.is_infinite() => Self { keep: -1.0, loss: 2.0, gain: 0.0 },
            Scheme::SemiImplicit => over(epsilon - 0.5 * lost, lost, epsilon + 0.5 * lost),
            Scheme::BackwardEuler if lost.is_infinite() => Self { keep: 0.0, loss: 1.0, gain: 0.0 },
            Scheme::BackwardEuler => over(epsilon, lost, epsilon + lost),
            Scheme::Exponential => {
                let x = lost / epsilon;
                let loss = -(-x).exp_m1();
                // Below rounding (1 − e^(−x))/x is 1, and σ may be 0.
                let gain = if x < f64::EPSILON { dt / epsilon } else { loss / sigma };
                Self { keep: (-x).exp(), loss, gain }
            }
        }
    }

    /// The coefficients as they are usually programmed: Cb of the exponential form is 0/0 without loss and cancels near
    /// it, σ = ∞ is ∞/∞, and 1 − Ca has to be formed from Ca.
    pub fn as_written(scheme: Scheme, epsilon: f64, sigma: f64, dt: f64) -> Self {
        let x = sigma * dt / epsilon;
        let (keep, gain) = match scheme {
            Scheme::ForwardEuler => (1.0 - x, dt / epsilon),
            Scheme::SemiImplicit => ((1.0 - x / 2.0) / (1.0 + x / 2.0), dt / epsilon / (1.0 + x / 2.0)),
            Scheme::Exponential => ((-x).exp(), (1.0 - (-x).exp()) / sigma),
            Scheme::BackwardEuler => (1.0 / (1.0 + x), dt / epsilon / (1.0 + x)),
        };
        Self { keep, loss: 1.0 - keep, gain }
    }

    /// E after the step from `field` [V m⁻¹] under `drive` = ∇×H [A m⁻²].
    pub fn step(&self, field: f64, drive: f64) -> f64 {
        if self.loss.abs() < 0.5 {
            field + (self.gain * drive - self.loss * field)
        } else {
            self.keep * field + self.gain * drive
        }
    }
}

/// A conducting cell driven by a harmonic ∇×H, in the units that leave one number: with θ = ωt, τ = σ/(ωε) and E over
/// its own final amplitude |∇×H|/√(σ² + ω²ε²), Ampère's law reads dE/dθ = −τE + √(1 + τ²) cos θ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    tau: f64,
}

impl Cell {
    /// Of loss tangent τ [1], 0 … 1e150.
    pub fn new(tau: f64) -> Result<Self, Invalid> {
        if (0.0..=1e150).contains(&tau) {
            Ok(Self { tau })
        } else {
            Err(Invalid { place: "tau", value: tau, valid: "0 to 1e150" })
        }
    }

    fn drive(&self, theta: f64) -> f64 {
        self.tau.hypot(1.0) * theta.cos()
    }

    /// The steady oscillation (τ cos θ + sin θ)/√(1 + τ²) that everything ends in.
    pub fn settled(&self, theta: f64) -> f64 {
        (self.tau * theta.cos() + theta.sin()) / self.tau.hypot(1.0)
    }

    /// E at θ ≥ 0 from `start` at θ = 0, in closed form. What the start lacks of the steady oscillation decays as
    /// e^(−τθ); where that is slow, τ(cos θ − e^(−τθ)) is formed from both differences to 1.
    pub fn exact(&self, start: f64, theta: f64) -> f64 {
        let half = (0.5 * theta).sin();
        let grown = -2.0 * half * half - (-self.tau * theta).exp_m1();
        (self.tau * grown + theta.sin()) / self.tau.hypot(1.0) + start * (-self.tau * theta).exp()
    }

    /// E at θ = `end` from `start` at 0 by `steps` ≥ 1 equal steps of `scheme`; infinite or NaN if it blows up.
    pub fn march(&self, scheme: Scheme, start: f64, end: f64, steps: u64) -> f64 {
        let step = end / steps as f64;
        let update = Update::new(scheme, 1.0, self.tau, step);
        (0..steps).fold(start, |field, at| update.step(field, self.drive((at as f64 + scheme.drive_at()) * step)))
    }

    /// E at θ = `end` from `start` at 0 by Radau IIA (3 stages, order 5, L-stable) with steps of its own choice, at a
    /// relative and absolute `tolerance`; or where it gave up.
    pub fn adaptive(&self, start: f64, end: f64, tolerance: f64) -> Result<Found, Stuck> {
        let ampere = Equation { rate: |theta, field| self.drive(theta) - self.tau * field, slope: |_, _| -self.tau };
        ampere.adapt([0.0, end], start, tolerance)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::references::waves as exact;
    use proptest::prelude::*;
    use yardstick::order;
    use yardstick::precise;

    proptest! {
        #[test]
        fn coefficients_keep_their_digits_at_both_ends(epsilon in -12.0..0.0_f64, x in -320.0..4.0_f64, dt in -20.0..3.0_f64) {
            let (epsilon, dt) = (10f64.powf(epsilon), 10f64.powf(dt));
            let sigma = 10f64.powf(x) * (epsilon / dt);
            prop_assume!(sigma == 0.0 || sigma * dt > 1e-290);
            for scheme in Scheme::ALL {
                let ours = Update::new(scheme, epsilon, sigma, dt);
                for (found, (exact, condition)) in
                    [ours.keep, ours.loss, ours.gain].into_iter().zip(exact::update(scheme, epsilon, sigma, dt))
                {
                    let vanishes = found == 0.0 && precise::to_f64(&exact).abs() < f64::MIN_POSITIVE;
                    let error = precise::relative_error(found, &exact);
                    prop_assert!(vanishes || error <= 16.0 * f64::EPSILON * (1.0 + condition), "{scheme:?} {x} {ours:?} {error}");
                }
            }
        }

        #[test]
        fn the_closed_form_is_exact(tau in -12.0..14.0_f64, start in -2.0..2.0, theta in -9.0..1.5_f64) {
            let (tau, theta) = (10f64.powf(tau), 10f64.powf(theta));
            let cell = Cell::new(tau).unwrap();
            let error = precise::to_f64(&(exact::cell(tau, start, theta) - precise::real(cell.exact(start, theta)))).abs();
            prop_assert!(error <= 8.0 * f64::EPSILON, "{tau} {theta} {error}");
            // From rest, early: to all digits.
            let error = precise::relative_error(cell.exact(0.0, 1e-3 * theta.min(1.0)), &exact::cell(tau, 0.0, 1e-3 * theta.min(1.0)));
            prop_assert!(error <= 16.0 * f64::EPSILON, "{tau} {theta} {error}");
        }
    }

    #[test]
    fn the_ends_are_limits() {
        for scheme in Scheme::ALL {
            let free = Update::new(scheme, 2.0, 0.0, 0.5);
            assert_eq!(free, Update { keep: 1.0, loss: 0.0, gain: 0.25 }, "{scheme:?}");
        }
        let keeps = [Scheme::SemiImplicit, Scheme::Exponential, Scheme::BackwardEuler].map(|scheme| {
            let perfect = Update::new(scheme, 1.0, f64::INFINITY, 1.0);
            assert_eq!(perfect.gain, 0.0);
            perfect.keep
        });
        assert_eq!(keeps, [-1.0, 0.0, 0.0]);
        assert!(Update::as_written(Scheme::Exponential, 1.0, 0.0, 1.0).gain.is_nan());
        for scheme in [Scheme::SemiImplicit, Scheme::Exponential, Scheme::BackwardEuler] {
            let (written, ours) =
                (Update::as_written(scheme, 1.0, 2.8e-16, 1.0), Update::new(scheme, 1.0, 2.8e-16, 1.0));
            assert!(
                (ours.loss / 2.8e-16 - 1.0).abs() < 1e-14 && (written.loss / 2.8e-16 - 1.0).abs() > 1e-2,
                "{scheme:?}"
            );
        }
        assert!(Update::as_written(Scheme::SemiImplicit, 1.0, f64::INFINITY, 1.0).keep.is_nan());
    }

    fn errors(scheme: Scheme, tau: f64, settled: bool, steps: &[u64]) -> Vec<(f64, f64)> {
        let cell = Cell::new(tau).unwrap();
        let start = if settled { cell.settled(0.0) } else { 0.0 };
        let error = |n: u64| (cell.march(scheme, start, 5.0, n) - cell.exact(start, 5.0)).abs();
        steps.iter().map(|&n| (n as f64, error(n))).collect()
    }

    #[test]
    fn orders_are_as_stated() {
        let steps = [64, 128, 256, 512, 1024];
        let slow = [
            (Scheme::ForwardEuler, 1.0),
            (Scheme::SemiImplicit, 2.0),
            (Scheme::Exponential, 2.0),
            (Scheme::BackwardEuler, 1.0),
        ];
        for tau in [1e-6, 1e-2, 1.0] {
            for (scheme, order) in slow {
                let found = -order::slope(&errors(scheme, tau, false, &steps)).unwrap();
                assert!((found - order).abs() < 0.1, "{scheme:?} τ = {tau}: {found}");
            }
        }
        let stiff = [(Scheme::SemiImplicit, 2.0), (Scheme::Exponential, 1.0), (Scheme::BackwardEuler, 1.0)];
        for tau in [1e9, 1e12] {
            for (scheme, order) in stiff {
                if scheme == Scheme::BackwardEuler && tau > 1e11 {
                    continue; // its error is below rounding there
                }
                let points = errors(scheme, tau, true, &steps);
                let found = -order::slope(&points).unwrap();
                assert!((found - order).abs() < 0.1, "{scheme:?} τ = {tau}: {found} {points:?}");
            }
        }
    }

    #[test]
    fn stability_is_as_stated() {
        for (steps, grows) in [(100, false), (98, true)] {
            // 200/100 is the limit; 200/98 is beyond it, by 1.04 a step.
            let cell = Cell::new(200.0).unwrap();
            let far = cell.march(Scheme::ForwardEuler, 1.0, 40.0, 40 * steps);
            assert_eq!(far.abs() > 1e6, grows, "{steps} {far}");
        }
        for tau in [1e6, 1e12] {
            let ringing = errors(Scheme::SemiImplicit, tau, false, &[64])[0].1;
            assert!(ringing > 0.1, "{ringing}");
            for scheme in [Scheme::Exponential, Scheme::BackwardEuler] {
                assert!(errors(scheme, tau, false, &[64])[0].1 < 0.06);
            }
        }
    }

    #[test]
    fn the_adaptive_solver_needs_few_steps_however_stiff() {
        for tau in [1e-6, 1.0, 1e3, 1e6, 1e9, 1e12] {
            let cell = Cell::new(tau).unwrap();
            let found = cell.adaptive(0.0, 5.0, 1e-8).unwrap();
            let error = (found.y - cell.exact(0.0, 5.0)).abs();
            assert!(error < 1e-6 && found.steps < 500, "τ = {tau}: {found:?} {error}");
        }
    }

    #[test]
    fn the_adaptive_solver_keeps_its_tolerance() {
        for tau in [1e-3, 1.0, 1e3, 1e6, 1e12] {
            let cell = Cell::new(tau).unwrap();
            for n in 0..=60 {
                let tolerance = 10f64.powf(-4.0 - 0.1 * f64::from(n));
                let error = (cell.adaptive(0.0, 5.0, tolerance).unwrap().y - cell.exact(0.0, 5.0)).abs();
                assert!(error < 10.0 * tolerance, "τ = {tau}: {error:e} at {tolerance:e}");
            }
        }
    }

    #[test]
    fn bad_input_is_named() {
        assert!([-1.0, f64::NAN, f64::INFINITY].iter().all(|tau| Cell::new(*tau).unwrap_err().place == "tau"));
    }
}
