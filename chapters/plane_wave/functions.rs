//! What `lesson eval` offers from this chapter.

use crate::parameter::{
    Alias, BY_WAVELENGTH, CONDUCTIVITY, FREQUENCY, Fault, Function, Kind, MEDIUM, Output, Parameter, RELATIVE, Setting,
};
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
    says: "a plane wave e^(i(kz − ωt)) of 1 V/m at z = 0 in a uniform medium; give eps_r mu_r sigma freq, or the \
           absolute eps mu sigma omega, or a medium by name",
    inputs: &[
        EPS_R,
        MU_R,
        Parameter::new("eps", "ε", "permittivity, instead of eps_r", Kind::number(ABSOLUTE.0, ABSOLUTE.1, "F/m"))
            .instead_of(&["eps_r"]),
        Parameter::new("mu", "μ", "permeability, instead of mu_r", Kind::number(ABSOLUTE.0, ABSOLUTE.1, "H/m"))
            .instead_of(&["mu_r"]),
        SIGMA,
        NAMED,
        FREQ,
        Parameter::new(
            "omega",
            "ω",
            "angular frequency, instead of freq",
            Kind::number(FREQUENCIES.0, FREQUENCIES.1, "rad/s"),
        )
        .instead_of(&["freq"]),
    ],
    outputs: &[
        Output::new("k_re", "wave number: phase per metre", "rad/m"),
        Output::new("k_im", "decay of the field per metre", "1/m"),
        Output::new("Z_re", "impedance E/H, real part", "Ω"),
        Output::new("Z_im", "imaginary part; negative where H lags", "Ω"),
        Output::new("skin_depth", "1/k_im; inf without loss", "m"),
        Output::new("phase_lag", "by which H lags E", "rad"),
        Output::new("wavelength", "2π/k_re", "m"),
        Output::new("v_phase", "ω/k_re", "m/s"),
        Output::new("S_avg", "mean energy flow at z = 0", "W/m²"),
    ],
    compute: |setting| {
        let wave = wave(setting)?;
        Ok(NAMES.into_iter().zip(flat(&wave)).collect())
    },
};

/// ε_r of a medium.
pub(crate) const EPS_R: Parameter =
    Parameter::new("eps_r", "ε_r", "relative permittivity", Kind::number(RELATIVE.0, RELATIVE.1, "1"));
/// μ_r of a medium.
pub(crate) const MU_R: Parameter =
    Parameter::new("mu_r", "μ_r", "relative permeability", Kind::number(RELATIVE.0, RELATIVE.1, "1"));
/// σ of a medium.
pub(crate) const SIGMA: Parameter =
    Parameter::new("sigma", "σ", "conductivity", Kind::number(CONDUCTIVITY.0, CONDUCTIVITY.1, "S/m"));
/// All three by name.
pub(crate) const NAMED: Parameter = MEDIUM.required().instead_of(&["eps_r", "mu_r", "sigma"]);
/// The frequency, which is part of the question here.
pub(crate) const FREQ: Parameter =
    Parameter { kind: Kind::number(FREQUENCIES.0, FREQUENCIES.1, "Hz"), ..FREQUENCY.required() }
        .aliases(&[Alias::same("freq_hz"), BY_WAVELENGTH]);

fn wave(setting: &Setting) -> Result<Wave, Fault> {
    if setting.given("medium").is_some() {
        return setting.conductor("medium").wave(setting.frequency()).map_err(|why| Fault::new("medium", why));
    }
    let absolute =
        |name, relative, unit: f64| setting.optional(name).unwrap_or_else(|| setting.number(relative) * unit);
    let (epsilon, mu) = (absolute("eps", "eps_r", EPSILON_0), absolute("mu", "mu_r", MU_0));
    let invalid = |found: Invalid| Fault::new(found.place, found.to_string());
    let medium = Medium::new(epsilon, mu, setting.number("sigma")).map_err(invalid)?;
    Wave::new(&medium, absolute("omega", "freq", TAU)).map_err(invalid)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parameter::{Argument, Outcome};

    fn call(given: &[(&str, f64)]) -> Outcome {
        let given: Vec<_> = given.iter().map(|(name, x)| ((*name).to_owned(), Argument::Number(*x))).collect();
        PLANE_WAVE.call(&given)
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
    fn names_and_wavelengths_give_the_same_wave() {
        let call = |given: &[(&str, &str)]| {
            let given: Vec<_> = given.iter().map(|(name, x)| ((*name).to_owned(), Argument::from(*x))).collect();
            PLANE_WAVE.call(&given)
        };
        let named = call(&[("medium", "copper"), ("freq", "50Hz")]);
        assert_eq!(named, call(&[("medium", "1/1/5.8e7"), ("freq_hz", "50")]));
        assert_eq!(call(&[("medium", "gold"), ("wavelength", "550nm")]).unwrap()[6].0, "wavelength");
        // Water's ions are known at this frequency only, not at the default one.
        assert!(call(&[("medium", "water"), ("omega", "1e3")]).is_ok());
        assert_eq!(call(&[("medium", "copper"), ("freq", "1GHz"), ("sigma", "1")]).unwrap_err().place, "medium");
        assert_eq!(call(&[("medium", "copper"), ("freq", "1e13")]).unwrap_err().place, "medium");
        assert_eq!(
            call(&[("medium", "copper"), ("freq", "1e9"), ("wavelength", "1")]).unwrap_err().place,
            "wavelength"
        );
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
