//! What `lesson eval` offers from this chapter.

use super::window::worst;
use crate::parameter::{Fault, Function, Kind, Output, Parameter};
use crate::plane_wave::functions::{EPS_R, FREQ, MU_R, NAMED, SIGMA};
use light::waves::constants::{EPSILON_0, MU_0};
use light::waves::flux::{Flux, Window};
use light::waves::{Invalid, Medium, Wave};
use std::f64::consts::TAU;

/// The functions, each with its inputs' units and domains.
pub(super) const FUNCTIONS: &[Function] = &[POYNTING];

const POYNTING: Function = Function {
    name: "poynting",
    says: "the energy of a plane wave E = Re A e^(i(kz − ωt)) at the depth z in a uniform medium, averaged over whole \
           periods, and how far a detector that looks for a number of periods may be off",
    inputs: &[
        EPS_R,
        MU_R,
        SIGMA,
        NAMED,
        FREQ,
        Parameter::new("amplitude", "A", "amplitude A of E at z = 0", Kind::number(0.0, 1e30, "V/m")),
        Parameter::new("z", "z", "depth", Kind::number(0.0, 1e30, "m")),
        Parameter::new("periods", "N", "how many periods the detector looks", Kind::number(1e-3, 1e15, "1")),
    ],
    outputs: &[
        Output::new("S_avg", "mean flow along z", "W/m²"),
        Output::new("heat", "mean power turned to heat, σ⟨E²⟩ = −d⟨S⟩/dz", "W/m³"),
        Output::new("energy", "mean energy of the fields, ¼(ε|E|² + μ|H|²)", "J/m³"),
        Output::new("error_box", "a shutter's error over S_avg, at the worst opening", "1"),
        Output::new("error_hann", "the same of a window 1 − cos", "1"),
    ],
    compute: |setting| {
        let invalid = |found: Invalid| Fault::new(found.place, found.to_string());
        let frequency = setting.number("freq");
        let medium = if setting.given("medium").is_some() {
            // Heat and energy are told by ε, μ and σ: an index alone does not know them.
            setting.conductor("medium").medium(frequency).map_err(|why| Fault::new("medium", why))?
        } else {
            let number = |name| setting.number(name);
            Medium::new(number("eps_r") * EPSILON_0, number("mu_r") * MU_0, number("sigma")).map_err(invalid)?
        };
        let wave = Wave::new(&medium, TAU * frequency).map_err(invalid)?;
        let (depth, periods) = (setting.number("z"), setting.number("periods"));
        let amplitude = setting.number("amplitude");
        let electric = amplitude * (-wave.k.im * depth).exp();
        let magnetic = electric / wave.impedance.norm();
        // Over the mean, so that the depth does not matter, not even where nothing is left of the flow.
        let surface = Flux::at_depth(&wave, 1.0, 0.0);
        let [shutter, hann] = [Window::Box, Window::Hann].map(|window| worst(&surface, window, periods));
        Ok(vec![
            ("S_avg", Flux::at_depth(&wave, amplitude, depth).mean),
            ("heat", 0.5 * medium.sigma() * electric * electric),
            ("energy", 0.25 * (medium.epsilon() * electric * electric + medium.mu() * magnetic * magnetic)),
            ("error_box", shutter),
            ("error_hann", hann),
        ])
    },
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parameter::{Argument, Outcome};

    fn call(sigma: f64, depth: f64, periods: f64) -> Outcome {
        let given = [
            ("eps_r", 4.0),
            ("mu_r", 1.5),
            ("sigma", sigma),
            ("freq_hz", 1e9),
            ("amplitude", 3.0),
            ("z", depth),
            ("periods", periods),
        ];
        let given = given.map(|(name, value)| (name.to_owned(), Argument::Number(value)));
        POYNTING.call(&given)
    }

    #[test]
    fn what_a_slab_takes_is_its_heat() {
        for (sigma, share) in [(1e-3, 0.0), (0.2, 1.0), (3.0, 2.5), (1e4, 0.3)] {
            let medium = Medium::relative(4.0, 1.5, sigma).unwrap();
            let skin = Wave::new(&medium, TAU * 1e9).unwrap().skin_depth;
            let (depth, step) = (share * skin, 1e-4 * skin);
            let flow = |z: f64| call(sigma, z, 1.0).unwrap()[0].1;
            let heat = call(sigma, depth + step, 1.0).unwrap()[1].1;
            let lost = (flow(depth) - flow(depth + 2.0 * step)) / (2.0 * step);
            assert!((lost / heat - 1.0).abs() < 1e-6, "{lost} {heat}");
        }
    }

    #[test]
    fn a_shutter_errs_as_its_closed_form_says() {
        for periods in [0.3, 0.5, 2.3, 7.77, 50.0] {
            let found = call(0.0, 0.0, periods).unwrap();
            let x = TAU * periods;
            assert!((found[3].1 - (x.sin() / x).abs()).abs() < 1e-13, "{periods}");
            // In a clear medium energy runs at the speed of the wave.
            let speed = found[0].1 / found[2].1;
            assert!((speed * (EPSILON_0 * MU_0 * 6.0).sqrt() - 1.0).abs() < 1e-13, "{speed}");
        }
    }

    #[test]
    fn bad_input_is_refused_by_name() {
        assert_eq!(call(-1.0, 0.0, 1.0).unwrap_err().place, "sigma");
        assert_eq!(call(0.0, f64::NAN, 1.0).unwrap_err().place, "z");
        assert_eq!(call(0.0, 0.0, 0.0).unwrap_err().place, "periods");
    }
}
