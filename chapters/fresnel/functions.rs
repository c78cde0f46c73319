//! What `lesson eval` offers from this chapter.

use crate::function::{Argument, Arguments, Function, Input, Output, number};
use crate::setting::{Fault, INDEX_MAX, INDEX_MIN, excerpt};
use light::Complex64;
use light::Polarisation;
use light::optics::film::{Layer, Stack};
use light::optics::fresnel::{amplitudes, powers};
use light::optics::schlick::{normal_reflectance, schlick_by_versine};
use light::optics::{Direction, Incidence};
use std::f64::consts::FRAC_PI_2;

/// The functions, each with its inputs' units and domains.
pub(super) const FUNCTIONS: &[Function] = &[FRESNEL, SCHLICK, THIN_FILM];

const FRESNEL: Function = Function {
    name: "fresnel",
    says: "a plane interface: field ratios for e^(−iωt) (r_p with the sign that makes it −r_s at normal incidence) and \
           shares of power; T is the flow into the second medium at the interface",
    inputs: INTERFACE,
    outputs: &[
        one("r_s_re", "reflected over incident electric field, s, real part"),
        one("r_s_im", "imaginary part"),
        one("t_s_re", "transmitted over incident electric field, s, real part"),
        one("t_s_im", "imaginary part"),
        one("r_p_re", "reflected over incident electric field, p, real part"),
        one("r_p_im", "imaginary part"),
        one("t_p_re", "transmitted over incident electric field, p, real part"),
        one("t_p_im", "imaginary part"),
        one("R_s", "reflected share of power, s"),
        one("T_s", "transmitted share of power, s"),
        one("R_p", "reflected share of power, p"),
        one("T_p", "transmitted share of power, p"),
        one("R_n", "reflected share of natural light"),
        one("T_n", "transmitted share of natural light"),
    ],
    call: |arguments| {
        let (incidence, n_1, n_2) = interface(arguments)?;
        let (a, p) = (amplitudes(incidence, n_1, n_2), powers(incidence, n_1, n_2));
        Ok(vec![
            ("r_s_re", a.r_s.re),
            ("r_s_im", a.r_s.im),
            ("t_s_re", a.t_s.re),
            ("t_s_im", a.t_s.im),
            ("r_p_re", a.r_p.re),
            ("r_p_im", a.r_p.im),
            ("t_p_re", a.t_p.re),
            ("t_p_im", a.t_p.im),
            ("R_s", p.r_s),
            ("T_s", p.t_s),
            ("R_p", p.r_p),
            ("T_p", p.t_p),
            ("R_n", p.r_n()),
            ("T_n", p.t_n()),
        ])
    },
};

const SCHLICK: Function = Function {
    name: "schlick",
    says: "Schlick's approximation R₀ + (1 − R₀)(1 − cos θ₁)⁵ of the reflectance of natural light, as he wrote it: \
           from a denser medium it misses total reflection",
    inputs: INTERFACE,
    outputs: &[one("R", "approximate reflected share of natural light")],
    call: |arguments| {
        let (incidence, n_1, n_2) = interface(arguments)?;
        Ok(vec![("R", schlick_by_versine(incidence.versine(), normal_reflectance(n_1, n_2)))])
    },
};

const INTERFACE: &[Input] = &[
    index("n1", "index of the clear medium of incidence"),
    index("n2", "real part of the index behind the interface"),
    extinction("k2", "its imaginary part; positive absorbs"),
    angle("theta1", "angle of incidence, from the normal; or give cos_theta1"),
    cosine("cos_theta1", "its cosine, instead of theta1"),
];

const fn index(name: &'static str, says: &'static str) -> Input {
    Input { name, says, unit: "1", domain: Some((INDEX_MIN, INDEX_MAX)), default: None }
}

const fn extinction(name: &'static str, says: &'static str) -> Input {
    Input { name, says, unit: "1", domain: Some((0.0, INDEX_MAX)), default: Some(0.0) }
}

const fn angle(name: &'static str, says: &'static str) -> Input {
    Input { name, says, unit: "rad", domain: Some((0.0, FRAC_PI_2)), default: None }
}

const fn cosine(name: &'static str, says: &'static str) -> Input {
    Input { name, says, unit: "1", domain: Some((0.0, 1.0)), default: None }
}

const fn one(name: &'static str, says: &'static str) -> Output {
    Output { name, says, unit: "1" }
}

const THIN_FILM: Function = Function {
    name: "thin-film",
    says: "a coherent stack of films: fields for e^(−iωt) (r of p as in `fresnel`, t at the substrate's surface), shares \
           of power, and ln T, which stays finite where T underflows",
    inputs: &[
        Input { name: "lambda_nm", says: "vacuum wavelength", unit: "nm", domain: Some(WAVELENGTHS), default: None },
        index("n0", "index of the clear medium that the light comes from"),
        structured("layers", "list of {n, k = 0, d_nm}, in the order in which the light meets them; may be empty"),
        structured("substrate", "{n, k = 0} of what lies behind"),
        angle("theta0", "angle of incidence in n0, from the normal; or give cos_theta0"),
        cosine("cos_theta0", "its cosine, instead of theta0"),
        structured("pol", "polarisation: \"s\" or \"p\""),
    ],
    outputs: &[
        one("r_re", "reflected over incident electric field, real part"),
        one("r_im", "imaginary part"),
        one(
            "t_re",
            "electric field at the substrate over incident field at the first interface, real \
             part",
        ),
        one("t_im", "imaginary part"),
        one("R", "reflected share of power"),
        one("T", "share of power that enters the substrate"),
        one("A", "share of power absorbed in the films"),
        one("ln_T", "natural logarithm of T; -inf if nothing propagates behind"),
    ],
    call: |arguments| {
        let wavelength = arguments.number("lambda_nm")? * 1e-9;
        let n_i = arguments.number("n0")?;
        let layers = layers(arguments)?;
        let substrate = given(arguments, "substrate")?;
        let substrate = medium("substrate", &fields("substrate", substrate, &["n", "k"])?)?;
        let incidence = direction(arguments, "theta0", "cos_theta0")?;
        let polarisation = polarisation(given(arguments, "pol")?)?;
        let found = Stack { n_i, layers: &layers, substrate }.response(wavelength, incidence, polarisation);
        Ok(vec![
            ("r_re", found.r.re),
            ("r_im", found.r.im),
            ("t_re", found.t.re),
            ("t_im", found.t.im),
            ("R", found.reflectance),
            ("T", found.transmittance),
            ("A", found.absorptance),
            ("ln_T", found.ln_transmittance),
        ])
    },
};

/// Vacuum wavelengths taken [nm].
const WAVELENGTHS: (f64, f64) = (1e-3, 1e12);
/// Thicknesses taken [nm].
const THICKNESSES: (f64, f64) = (0.0, 1e15);
/// The longest stack taken.
const MOST_LAYERS: usize = 100_000;

const fn structured(name: &'static str, says: &'static str) -> Input {
    Input { name, says, unit: "", domain: None, default: None }
}

fn given<'a>(arguments: &Arguments<'a>, name: &str) -> Result<&'a Argument, Fault> {
    arguments.get(name).ok_or_else(|| Fault::new(name, "missing"))
}

fn layers(arguments: &Arguments) -> Result<Vec<Layer>, Fault> {
    let Argument::List(list) = given(arguments, "layers")? else {
        return Err(Fault::new("layers", "must be a list of {n, k, d_nm}"));
    };
    if list.len() > MOST_LAYERS {
        return Err(Fault::new("layers", format!("{} layers; valid: 0 to {MOST_LAYERS}", list.len())));
    }
    let layer = |(at, argument): (usize, &Argument)| {
        let place = format!("layers[{at}]");
        let fields = fields(&place, argument, &["n", "k", "d_nm"])?;
        let thickness = required(&place, &fields, "d_nm", THICKNESSES)? * 1e-9;
        Ok(Layer { index: medium(&place, &fields)?, thickness })
    };
    list.iter().enumerate().map(layer).collect()
}

/// The fields of the record at `place`, each of them `known` and given once.
fn fields<'a>(place: &str, argument: &'a Argument, known: &[&str]) -> Result<Vec<(&'a str, &'a Argument)>, Fault> {
    let Argument::Record(record) = argument else {
        return Err(Fault::new(place, format!("must have the fields {}", known.join(", "))));
    };
    for (at, (name, _)) in record.iter().enumerate() {
        let place = || format!("{place}.{}", excerpt(name));
        if !known.contains(&name.as_str()) {
            return Err(Fault::new(place(), format!("no such field; there are: {}", known.join(", "))));
        }
        if record[..at].iter().any(|(earlier, _)| earlier == name) {
            return Err(Fault::new(place(), "given twice"));
        }
    }
    Ok(record.iter().map(|(name, argument)| (name.as_str(), argument)).collect())
}

/// The index n + ik of the record at `place`.
fn medium(place: &str, fields: &[(&str, &Argument)]) -> Result<Complex64, Fault> {
    let n = required(place, fields, "n", (INDEX_MIN, INDEX_MAX))?;
    let k = optional(place, fields, "k", (0.0, INDEX_MAX))?.unwrap_or(0.0);
    Ok(Complex64::new(n, k))
}

fn required(place: &str, fields: &[(&str, &Argument)], name: &str, domain: (f64, f64)) -> Result<f64, Fault> {
    let missing = || Fault::new(format!("{place}.{name}"), format!("missing; valid: {} to {}", domain.0, domain.1));
    optional(place, fields, name, domain)?.ok_or_else(missing)
}

fn optional(place: &str, fields: &[(&str, &Argument)], name: &str, domain: (f64, f64)) -> Result<Option<f64>, Fault> {
    let found = fields.iter().find(|(given, _)| *given == name);
    found.map(|(_, argument)| number(&format!("{place}.{name}"), argument, "1", Some(domain))).transpose()
}

fn polarisation(argument: &Argument) -> Result<Polarisation, Fault> {
    match argument {
        Argument::Text(text) if text == "s" => Ok(Polarisation::S),
        Argument::Text(text) if text == "p" => Ok(Polarisation::P),
        _ => Err(Fault::new("pol", "must be \"s\" or \"p\"")),
    }
}

fn interface(arguments: &Arguments) -> Result<(Incidence, f64, Complex64), Fault> {
    let n_1 = arguments.number("n1")?;
    let n_2 = Complex64::new(arguments.number("n2")?, arguments.number("k2")?);
    Ok((direction(arguments, "theta1", "cos_theta1")?, n_1, n_2))
}

/// The direction from exactly one of its two fields.
fn direction(arguments: &Arguments, angle: &str, cosine: &str) -> Result<Incidence, Fault> {
    match (arguments.optional(angle)?, arguments.optional(cosine)?) {
        (Some(theta), None) => Ok(Direction::Angle(theta).into()),
        (None, Some(cos)) => Ok(Direction::Cos(cos).into()),
        (None, None) => Err(Fault::new(angle, format!("missing; give {angle} or {cosine}"))),
        (Some(_), Some(_)) => Err(Fault::new(cosine, format!("given beside {angle}; give one of them"))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn call(function: &Function, given: &[(&str, Argument)]) -> Result<Vec<(&'static str, f64)>, Fault> {
        let given: Vec<_> = given.iter().map(|(name, argument)| ((*name).to_owned(), argument.clone())).collect();
        (function.call)(&Arguments::new(function, &given)?)
    }

    fn record(fields: &[(&str, f64)]) -> Argument {
        Argument::Record(fields.iter().map(|(name, value)| ((*name).to_owned(), Argument::Number(*value))).collect())
    }

    fn thin_film(layers: Vec<Argument>) -> Result<Vec<(&'static str, f64)>, Fault> {
        let given = [
            ("lambda_nm", Argument::Number(550.0)),
            ("n0", Argument::Number(1.0)),
            ("layers", Argument::List(layers)),
            ("substrate", record(&[("n", 1.52)])),
            ("theta0", Argument::Text("0deg".into())),
            ("pol", Argument::Text("p".into())),
        ];
        call(&THIN_FILM, &given)
    }

    #[test]
    fn a_quarter_wave_of_magnesium_fluoride_leaves_a_hundredth() {
        let found = thin_film(vec![record(&[("n", 1.38), ("d_nm", 550.0 / 4.0 / 1.38)])]).unwrap();
        let (name, reflectance) = found[4];
        let amplitude = (1.52 - 1.38 * 1.38) / (1.52 + 1.38 * 1.38);
        assert_eq!(name, "R");
        assert!((reflectance - amplitude * amplitude).abs() < 1e-15);
    }

    #[test]
    fn outputs_are_those_declared() {
        let interface = [("n1", 1.0), ("n2", 1.5), ("cos_theta1", 0.5)].map(|(name, x)| (name, Argument::Number(x)));
        let found = [
            (&FRESNEL, call(&FRESNEL, &interface).unwrap()),
            (&SCHLICK, call(&SCHLICK, &interface).unwrap()),
            (&THIN_FILM, thin_film(vec![]).unwrap()),
        ];
        for (function, found) in found {
            let names = found.iter().map(|(name, _)| *name);
            assert!(names.eq(function.outputs.iter().map(|output| output.name)), "{}", function.name);
        }
    }

    #[test]
    fn faults_name_their_field() {
        let good = record(&[("n", 1.38), ("d_nm", 100.0)]);
        let place = |bad: Argument| thin_film(vec![good.clone(), bad]).unwrap_err().place;
        assert_eq!(place(record(&[("n", -1.0), ("d_nm", 1.0)])), "layers[1].n");
        assert_eq!(place(record(&[("n", 1.5)])), "layers[1].d_nm");
        assert_eq!(place(record(&[("n", 1.5), ("d_nm", f64::NAN)])), "layers[1].d_nm");
        assert_eq!(place(record(&[("n", 1.5), ("d_nm", 1.0), ("colour", 1.0)])), "layers[1].colour");
        assert_eq!(place(Argument::Number(1.0)), "layers[1]");
        assert_eq!(thin_film(vec![good; MOST_LAYERS + 1]).unwrap_err().place, "layers");
        let both = [("n1", 1.0), ("n2", 1.5), ("theta1", 0.1), ("cos_theta1", 0.5)];
        assert_eq!(call(&FRESNEL, &both.map(|(name, x)| (name, Argument::Number(x)))).unwrap_err().place, "cos_theta1");
        let neither = [("n1", 1.0), ("n2", 1.5)].map(|(name, x)| (name, Argument::Number(x)));
        assert_eq!(call(&SCHLICK, &neither).unwrap_err().place, "theta1");
    }
}
