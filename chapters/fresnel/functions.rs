//! What `lesson eval` offers from this chapter.

use crate::function::{Arguments, Function, Input, Output};
use crate::setting::{Fault, INDEX_MAX, INDEX_MIN};
use light::Complex64;
use light::optics::fresnel::{amplitudes, powers};
use light::optics::schlick::{normal_reflectance, schlick};
use light::optics::{Direction, Incidence};
use std::f64::consts::FRAC_PI_2;

/// The functions, each with its inputs' units and domains.
pub(super) const FUNCTIONS: &[Function] = &[FRESNEL, SCHLICK];

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
        Ok(vec![("R", schlick(incidence.cos(), normal_reflectance(n_1, n_2)))])
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
