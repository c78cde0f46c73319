//! Poynting's theorem for a plane wave, every term in closed form (C3): what flows into a slab is stored or turned to
//! heat, at every instant, ∂u/∂t + ∂S/∂z = −σE² with u = ½εE² + ½μH² (Jackson (3rd ed.), §6.7).

use super::phase::cis_of_product;
use super::plane::{Invalid, Medium, Wave};
use num_complex::Complex64;

/// The real fields E [V m⁻¹] and H [A m⁻¹] at a place and time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fields {
    /// E.
    pub e: f64,
    /// H.
    pub h: f64,
}

/// A plane wave with the medium it runs in: E = A e^(−z Im k) cos(z Re k − ωt).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Running {
    medium: Medium,
    wave: Wave,
    amplitude: f64,
}

impl Running {
    /// At `omega` [rad s⁻¹], with `amplitude` A [V m⁻¹] at z = 0, in a medium of finite conductivity.
    pub fn new(medium: Medium, omega: f64, amplitude: f64) -> Result<Self, Invalid> {
        if medium.sigma().is_infinite() {
            return Err(Invalid { place: "sigma", value: medium.sigma(), valid: "finite, where fields are asked for" });
        }
        Ok(Self { medium, wave: Wave::new(&medium, omega)?, amplitude })
    }

    /// Its wave.
    pub fn wave(&self) -> &Wave {
        &self.wave
    }

    /// E and H at z [m] and t [s].
    pub fn fields(&self, z: f64, t: f64) -> Fields {
        let electric = self.amplitude * self.propagator(z) * cis_of_product(self.wave.omega, t).conj();
        Fields { e: electric.re, h: (electric * self.admittance()).re }
    }

    /// u = ½εE² + ½μH² [J m⁻³].
    pub fn energy_density(&self, z: f64, t: f64) -> f64 {
        let Fields { e, h } = self.fields(z, t);
        0.5 * (self.medium.epsilon() * e * e + self.medium.mu() * h * h)
    }

    /// S = EH [W m⁻²] (E20).
    pub fn flux(&self, z: f64, t: f64) -> f64 {
        let Fields { e, h } = self.fields(z, t);
        e * h
    }

    /// σE² [W m⁻³].
    pub fn heating(&self, z: f64, t: f64) -> f64 {
        self.medium.sigma() * self.fields(z, t).e.powi(2)
    }

    /// e^(ikz).
    fn propagator(&self, z: f64) -> Complex64 {
        cis_of_product(self.wave.k.re, z) * (-self.wave.k.im * z).exp()
    }

    /// H/E of the complex amplitudes, k/(ωμ).
    fn admittance(&self) -> Complex64 {
        self.wave.k / self.wave.omega / self.medium.mu()
    }

    /// The terms of the balance of the slab `near` ≤ z ≤ `far` [m] at the time t [s]. Stored energy and heat are
    /// integrals of E² and H², the flow is the difference of E·H at the two faces: routes that share the fields alone.
    pub fn balance(&self, near: f64, far: f64, t: f64) -> Balance {
        let (steady, swinging) = self.squares(near, far);
        let turned = swinging * cis_of_product(2.0 * self.wave.omega, t).conj();
        // ∂/∂t of e^(−2iωt)
        let rate = Complex64::new(0.0, -2.0 * self.wave.omega) * turned;
        let admittance = self.admittance();
        let (epsilon, mu) = (self.medium.epsilon(), self.medium.mu());
        Balance {
            stored: 0.5 * (epsilon * rate.re + mu * (admittance * admittance * rate).re),
            heat: self.medium.sigma() * (steady + turned.re),
            outflow: self.flux(far, t) - self.flux(near, t),
            scale: self.peak_flux(near),
        }
    }

    /// The same averaged over a period: nothing more is stored, what does not come out is heat.
    pub fn mean_balance(&self, near: f64, far: f64) -> Balance {
        let (steady, _) = self.squares(near, far);
        let decay = 2.0 * self.wave.k.im;
        let entering = self.amplitude * self.amplitude * self.wave.mean_flux * (-decay * near).exp();
        let outflow = entering * (-decay * (far - near)).exp_m1();
        Balance { stored: 0.0, heat: self.medium.sigma() * steady, outflow, scale: self.peak_flux(near) }
    }

    /// The largest S [W m⁻²] at z [m] over a period: mean and swing together.
    fn peak_flux(&self, z: f64) -> f64 {
        let field = self.amplitude * self.propagator(z).norm();
        field * field * (self.wave.mean_flux + 0.5 * self.admittance().norm())
    }

    /// ∫E² dz over the slab as (s, w): s + Re(w e^(−2iωt)) [V² m⁻¹].
    fn squares(&self, near: f64, far: f64) -> (f64, Complex64) {
        let (k, depth) = (self.wave.k, far - near);
        let power = 0.5 * self.amplitude * self.amplitude;
        let decay = 2.0 * k.im;
        let steady = if decay * depth == 0.0 { depth } else { -(-decay * depth).exp_m1() / decay };
        let start = self.propagator(near);
        let swinging =
            start * start * exp_m1(Complex64::new(-decay, 2.0 * k.re) * depth) / Complex64::new(-decay, 2.0 * k.re);
        (power * (-decay * near).exp() * steady, power * swinging)
    }
}

/// e^z − 1 without cancellation.
fn exp_m1(z: Complex64) -> Complex64 {
    let half = (0.5 * z.im).sin();
    Complex64::new(z.re.exp_m1() * z.im.cos() - 2.0 * half * half, z.re.exp() * z.im.sin())
}

/// Powers per area of a slab [W m⁻²]; the first three add up to 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Balance {
    /// d/dt of the stored energy.
    pub stored: f64,
    /// Turned to heat.
    pub heat: f64,
    /// Leaving through the far face less entering through the near one.
    pub outflow: f64,
    /// The most that flows through the near face at any time: what the terms are rounded against.
    pub scale: f64,
}

impl Balance {
    /// What is missing from the balance, over its scale [1].
    pub fn residual(&self) -> f64 {
        (self.stored + self.heat + self.outflow) / self.scale
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn running() -> impl Strategy<Value = (Running, f64)> {
        let parts = (0.0..4.0, 0.0..3.0, prop_oneof![Just(None), (-9.0..9.0).prop_map(Some)], 0.0..16.0);
        parts.prop_map(|(epsilon_r, mu_r, tau, omega)| {
            let (omega, epsilon_r) = (10f64.powf(omega), 10f64.powf(epsilon_r));
            let sigma = tau.map_or(0.0, |tau| 10f64.powf(tau) * omega * epsilon_r * super::super::constants::EPSILON_0);
            let medium = Medium::relative(epsilon_r, 10f64.powf(mu_r), sigma).unwrap();
            let running = Running::new(medium, omega, 2.5).unwrap();
            (running, running.wave.wavelength)
        })
    }

    proptest! {
        #[test]
        fn the_balance_closes((running, wavelength) in running(), near in 0.0..1.5, depth in 1e-3..3.0, t in 0.0..5.0) {
            let (near, far) = (near * wavelength, (near + depth) * wavelength);
            let balance = running.balance(near, far, t / running.wave.omega);
            // k's own rounding turns the phase by ε · |k| far.
            let allowed = 32.0 * f64::EPSILON * (1.0 + running.wave.k.norm() * far);
            prop_assert!(balance.residual().abs() <= allowed, "{balance:?} {}", balance.residual());
            let mean = running.mean_balance(near, far);
            prop_assert!(mean.residual().abs() <= allowed, "{mean:?}");
        }

        #[test]
        fn both_fluxes_are_one((running, wavelength) in running(), z in 0.0..1.0, t in 0.0..9.0) {
            let (z, t) = (z * wavelength, t / running.wave.omega);
            let flux = crate::waves::flux::Flux::at_depth(&running.wave, running.amplitude, z);
            prop_assert!((flux.at(t) - running.flux(z, t)).abs() <= 1e-13 * running.peak_flux(z));
        }

        #[test]
        fn the_pieces_are_the_integrals((running, wavelength) in running(), near in 0.0..0.5, t in 0.0..5.0) {
            let (near, far, t) = (near * wavelength, (near + 0.7) * wavelength, t / running.wave.omega);
            let rule = yardstick::quadrature::gauss_legendre(24);
            let over = |f: &dyn Fn(f64) -> f64| -> f64 {
                rule.iter().map(|&(u, weight)| weight * (far - near) * f(near + u * (far - near))).sum()
            };
            let balance = running.balance(near, far, t);
            let heat = over(&|z| running.heating(z, t));
            prop_assert!((heat - balance.heat).abs() <= 1e-12 * balance.scale, "{heat} {balance:?}");
            let step = 1e-4 / running.wave.omega;
            let stored = |t: f64| over(&|z| running.energy_density(z, t));
            let rate = (stored(t + step) - stored(t - step)) / (2.0 * step);
            prop_assert!((rate - balance.stored).abs() <= 1e-6 * balance.scale, "{rate} {balance:?}");
        }
    }
}
