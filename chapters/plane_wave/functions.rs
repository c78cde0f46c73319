//! What `lesson eval` offers from this chapter.

use crate::function::{Arguments, Function, Input, Output};
use crate::setting::{CONDUCTIVITY, Fault, RELATIVE};
use light::references::waves::{NAMES, flat};
use light::waves::constants::{EPSILON_0, MU_0};
use light::waves::{Invalid, Medium, Wave};
use std::f64::consts::TAU;

/// The functions, each with its inputs' units and domains.
pub(super) const FUNCTIONS: &[Function] = &[PLANE_WAVE];

/// Absolute permittivities and permeabilities taken: any that a relative one can give, and more.
const ABSOLUTE: (f64, f64) = (1e-30, 1e30);

/// Frequencies taken [Hz], and angular ones [rad/s].
pub(crate) const FREQUENCIES: (f64, f64) = (1e-12, 1e24);

const PLANE_WAVE: Function = Function {
    name: "plane-wave",
    says: "a plane wave e^(i(kz − ωt)) of 1 V/m at z = 0 in a uniform medium; give eps_r mu_r sigma freq_hz, or the \
           absolute eps mu sigma omega",
    inputs: &[
        input("eps_r", "relative permittivity; or give eps", "1", RELATIVE),
        input("mu_r", "relative permeability; or give mu", "1", RELATIVE),
        input("eps", "permittivity, instead of eps_r", "F/m", ABSOLUTE),
        input("mu", "permeability, instead of mu_r", "H/m", ABSOLUTE),
        input("sigma", "conductivity", "S/m", CONDUCTIVITY),
        input("freq_hz", "frequency; or give omega", "Hz", FREQUENCIES),
        input("omega", "angular frequency, instead of freq_hz", "rad/s", FREQUENCIES),
    ],
    outputs: &[
        output("k_re", "wave number: phase per metre", "rad/m"),
        output("k_im", "decay of the field per metre", "1/m"),
        output("Z_re", "impedance E/H, real part", "Ω"),
        output("Z_im", "imaginary part; negative where H lags", "Ω"),
        output("skin_depth", "1/k_im; inf without loss", "m"),
        output("phase_lag", "by which H lags E", "rad"),
        output("wavelength", "2π/k_re", "m"),
        output("v_phase", "ω/k_re", "m/s"),
        output("S_avg", "mean energy flow at z = 0", "W/m²"),
    ],
    call: |arguments| {
        let wave = wave(arguments)?;
        Ok(NAMES.into_iter().zip(flat(&wave)).collect())
    },
};

pub(crate) const fn input(name: &'static str, says: &'static str, unit: &'static str, domain: (f64, f64)) -> Input {
    Input { name, says, unit, domain: Some(domain), default: None }
}

pub(crate) const fn output(name: &'static str, says: &'static str, unit: &'static str) -> Output {
    Output { name, says, unit }
}

fn wave(arguments: &Arguments) -> Result<Wave, Fault> {
    let epsilon = either(arguments, ["eps_r", "eps"])?;
    let mu = either(arguments, ["mu_r", "mu"])?;
    let sigma = arguments.number("sigma")?;
    let frequency = either(arguments, ["freq_hz", "omega"])?;
    let absolute = |value: Either, unit: f64| match value {
        Either::First(relative) => relative * unit,
        Either::Second(absolute) => absolute,
    };
    let invalid = |found: Invalid| Fault::new(found.place, found.to_string());
    let medium = Medium::new(absolute(epsilon, EPSILON_0), absolute(mu, MU_0), sigma).map_err(invalid)?;
    Wave::new(&medium, absolute(frequency, TAU)).map_err(invalid)
}

/// Which of two names a number was given under.
enum Either {
    First(f64),
    Second(f64),
}

/// The number given under exactly one of two names.
fn either(arguments: &Arguments, [first, second]: [&'static str; 2]) -> Result<Either, Fault> {
    match (arguments.optional(first)?, arguments.optional(second)?) {
        (Some(value), None) => Ok(Either::First(value)),
        (None, Some(value)) => Ok(Either::Second(value)),
        (None, None) => Err(Fault::new(first, format!("missing; give {first} or {second}"))),
        (Some(_), Some(_)) => Err(Fault::new(second, format!("given beside {first}; give one of them"))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::function::{Argument, Outcome};

    fn call(given: &[(&str, f64)]) -> Outcome {
        let given: Vec<_> = given.iter().map(|(name, x)| ((*name).to_owned(), Argument::Number(*x))).collect();
        (PLANE_WAVE.call)(&Arguments::new(&PLANE_WAVE, &given)?)
    }

    const COPPER: [(&str, f64); 4] = [("eps_r", 1.0), ("mu_r", 1.0), ("sigma", 5.8e7), ("freq_hz", 50.0)];

    #[test]
    fn copper_at_mains_frequency_has_a_skin_of_nine_millimetres() {
        let found = call(&COPPER).unwrap();
        assert!(found.iter().map(|(name, _)| *name).eq(PLANE_WAVE.outputs.iter().map(|output| output.name)));
        let depth = found.iter().find(|(name, _)| *name == "skin_depth").unwrap().1;
        assert!((depth - 9.35e-3).abs() < 1e-5, "{depth}");
    }

    #[test]
    fn absolute_and_relative_inputs_agree() {
        let absolute = [("eps", EPSILON_0), ("mu", MU_0), ("sigma", 5.8e7), ("omega", TAU * 50.0)];
        assert_eq!(call(&absolute), call(&COPPER));
    }

    #[test]
    fn unphysical_media_are_refused_by_name() {
        for (name, bad) in
            [("eps_r", 0.0), ("eps_r", -1.0), ("mu_r", 0.0), ("sigma", -1.0), ("sigma", f64::NAN), ("freq_hz", 0.0)]
        {
            let given = COPPER.map(|(own, x)| (own, if own == name { bad } else { x }));
            assert_eq!(call(&given).unwrap_err().place, name, "{bad}");
        }
        assert_eq!(call(&[&COPPER[..], &[("omega", 1.0)]].concat()).unwrap_err().place, "omega");
        assert_eq!(call(&COPPER[1..]).unwrap_err().place, "eps_r");
    }
}
