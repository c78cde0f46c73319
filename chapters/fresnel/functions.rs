//! What `lesson eval` offers from this chapter.

use super::{N_I, N_T};
use crate::parameter::{
    Alias, BY_FREQUENCY, Fault, Function, INDEX_MAX, INDEX_MIN, Kind, Output, Parameter, Setting, THETA, WAVELENGTH,
};
use light::Complex64;
use light::Polarisation;
use light::media::Medium;
use light::optics::film::{Layer, Stack};
use light::optics::fresnel::{amplitudes, powers};
use light::optics::schlick::{normal_reflectance, schlick_by_versine};
use light::optics::{Direction, Incidence};

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
    compute: |setting| {
        let (incidence, n_1, n_2) = interface(setting)?;
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
    compute: |setting| {
        let (incidence, n_1, n_2) = interface(setting)?;
        Ok(vec![("R", schlick_by_versine(incidence.versine(), normal_reflectance(n_1, n_2)))])
    },
};

/// An interface, by the names that the chapter's steps use; the older ones are aliases.
const INTERFACE: &[Parameter] = &[
    N_I.required().aliases(&[Alias::same("n1")]),
    Parameter { kind: Kind::MediumInParts, ..N_T.required().aliases(&[Alias::same("n2")]) },
    extinction("k_t", "κ_2", "imaginary part of n_t where that is a plain number; positive absorbs")
        .aliases(&[Alias::same("k2")]),
    THETA.required().aliases(&[Alias::same("theta1")]),
    COS_THETA.aliases(&[Alias::same("cos_theta1")]),
    WAVELENGTH,
];

/// The other way to give an angle of incidence: near grazing an angle has lost the digits that its cosine keeps.
const COS_THETA: Parameter =
    Parameter::new("cos_theta", "cos θ_1", "its cosine, instead of theta", Kind::number(0.0, 1.0, "1"))
        .instead_of(&["theta"]);

const fn extinction(name: &'static str, symbol: &'static str, says: &'static str) -> Parameter {
    Parameter::new(name, symbol, says, Kind::number(0.0, INDEX_MAX, "1")).default("0")
}

const fn one(name: &'static str, says: &'static str) -> Output {
    Output::new(name, says, "1")
}

const THIN_FILM: Function = Function {
    name: "thin-film",
    says: "a coherent stack of films: fields for e^(−iωt) (r of p as in `fresnel`, t at the substrate's surface), shares \
           of power, and ln T, which stays finite where T underflows",
    inputs: &[
        Parameter { kind: Kind::number(WAVELENGTHS.0, WAVELENGTHS.1, "m"), ..WAVELENGTH.required() }
            .aliases(&[Alias::counted_in("lambda_nm", "nm"), BY_FREQUENCY]),
        N_I.required().aliases(&[Alias::same("n0")]),
        Parameter::new(
            "layers",
            "",
            "the films, in the order in which the light meets them; may be none",
            Kind::List { of: &Kind::Record(LAYER), most: 100_000 },
        ),
        Parameter::new("substrate", "n_s", "what lies behind", Kind::Record(SUBSTRATE))
            .aliases(&[Alias::same("n_s"), Alias::same("n_t")]),
        THETA.required().aliases(&[Alias::same("theta0")]),
        COS_THETA.aliases(&[Alias::same("cos_theta0")]),
        Parameter::new("pol", "", "polarisation", Kind::Choice(&["s", "p"])),
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
    compute: |setting| {
        let wavelength = setting.wavelength();
        let layer = |(at, fields): (usize, &Setting)| {
            let index = index(fields, "n", "k", wavelength).map_err(|fault| fault.within(&format!("layers[{at}]")))?;
            Ok(Layer { index, thickness: fields.number("d") })
        };
        let layers: Vec<Layer> = setting.records("layers").enumerate().map(layer).collect::<Result<_, Fault>>()?;
        let substrate = index(setting.fields("substrate"), "n", "k", wavelength);
        let substrate = substrate.map_err(|fault| fault.within("substrate"))?;
        let polarisation = if setting.word("pol") == "s" { Polarisation::S } else { Polarisation::P };
        let n_i = setting.index("n_i").re;
        let found = Stack { n_i, layers: &layers, substrate }.response(wavelength, incidence(setting), polarisation);
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

/// A nanometre [m].
const NM: f64 = 1e-9;
/// Vacuum wavelengths taken [m], to the last bit those that a picometre and a kilometre are in nanometres.
const WAVELENGTHS: (f64, f64) = (1e-3 * NM, 1e12 * NM);

const N: Parameter =
    Parameter::new("n", "n", "index, or a medium by name", Kind::MediumInParts).aliases(&[Alias::same("medium")]);
const K: Parameter = extinction("k", "κ", "imaginary part of n where that is a plain number");
const SUBSTRATE: &[Parameter] = &[N, K];
const LAYER: &[Parameter] = &[
    N,
    K,
    Parameter::new("d", "d", "thickness", Kind::number(0.0, 1e15 * NM, "m"))
        .aliases(&[Alias::counted_in("d_nm", "nm")]),
];

fn interface(setting: &Setting) -> Result<(Incidence, f64, Complex64), Fault> {
    let n_2 = index(setting, "n_t", "k_t", setting.wavelength())?;
    Ok((incidence(setting), setting.index("n_i").re, n_2))
}

/// The index of the medium `n`, whose imaginary part may stand apart in `k`.
fn index(setting: &Setting, n: &'static str, k: &'static str, wavelength: f64) -> Result<Complex64, Fault> {
    let (medium, extinction) = (setting.medium(n), setting.number(k));
    match medium {
        Medium::Constant(index) if index.re == 0.0 && index.im + extinction < INDEX_MIN => {
            let place = setting.given(n).unwrap_or(n);
            Err(Fault::new(place, format!("0 needs {k} of at least {INDEX_MIN:e}: a metal without loss")))
        }
        Medium::Constant(index) if index.im == 0.0 => Ok(Complex64::new(index.re, extinction)),
        _ if extinction != 0.0 => {
            let (place, other) = (setting.given(k).unwrap_or(k), setting.given(n).unwrap_or(n));
            Err(Fault::new(place, format!("given beside {other} = {}, which has its own", setting.text(n))))
        }
        medium => medium.index(wavelength).map_err(|out| Fault::new(n, out.to_string())),
    }
}

/// The direction, by its angle or by its cosine.
fn incidence(setting: &Setting) -> Incidence {
    match setting.optional("cos_theta") {
        Some(cos) => Direction::Cos(cos).into(),
        None => Direction::Angle(setting.number("theta")).into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parameter::Argument;
    use light::media;

    fn call(function: &Function, given: &[(&str, Argument)]) -> Result<Vec<(&'static str, f64)>, Fault> {
        let given: Vec<_> = given.iter().map(|(name, argument)| ((*name).to_owned(), argument.clone())).collect();
        function.call(&given)
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
    fn a_metal_without_loss_reflects_everything() {
        let angle = [("n_i", Argument::from(1.5)), ("theta", "40deg".into())];
        let whole = call(&FRESNEL, &[&angle[..], &[("n_t", "0+2i".into())]].concat()).unwrap();
        let parts = call(&FRESNEL, &[&angle[..], &[("n_t", 0.0.into()), ("k_t", 2.0.into())]].concat()).unwrap();
        assert_eq!(whole, parts);
        assert_eq!((whole[8], whole[10]), (("R_s", 1.0), ("R_p", 1.0)));
        let nothing = call(&FRESNEL, &[&angle[..], &[("n_t", 0.0.into())]].concat()).unwrap_err();
        assert_eq!(nothing.place, "n_t");
        let film = thin_film(vec![record(&[("n", 0.0), ("k", 3.0), ("d_nm", 20.0)])]).unwrap();
        assert_eq!(film[6], ("A", 0.0));
        assert_eq!(thin_film(vec![record(&[("n", 0.0), ("d_nm", 20.0)])]).unwrap_err().place, "layers[0].n");
    }

    #[test]
    fn a_substrate_is_given_as_other_media_are() {
        let on = |name: &str, substrate: Argument| {
            let rest =
                [("wavelength", "550nm".into()), ("n_i", 1.0.into()), ("theta", 0.3.into()), ("pol", "s".into())];
            call(&THIN_FILM, &[&rest[..], &[("layers", Argument::List(vec![])), (name, substrate)]].concat())
        };
        let bk7 = on("substrate", Argument::record([("n", "bk7".into())])).unwrap();
        assert_eq!(on("substrate", "bk7".into()).unwrap(), bk7);
        assert_eq!(on("n_s", "bk7".into()).unwrap(), bk7);
        assert_eq!(on("n_t", "bk7".into()).unwrap(), bk7);
        assert_eq!(on("substrate", 1.52.into()), on("substrate", record(&[("n", 1.52)])));
        assert_eq!(on("substrate", "0.2+3.4i".into()), on("substrate", record(&[("n", 0.2), ("k", 3.4)])));
        assert_eq!(on("substrate", "kryptonite".into()).unwrap_err().place, "substrate");
    }

    #[test]
    fn faults_name_their_field() {
        let good = record(&[("n", 1.38), ("d_nm", 100.0)]);
        let place = |bad: Argument| thin_film(vec![good.clone(), bad]).unwrap_err().place;
        assert_eq!(place(record(&[("n", -1.0), ("d_nm", 1.0)])), "layers[1].n");
        assert_eq!(place(record(&[("n", 1.5)])), "layers[1].d");
        assert_eq!(place(record(&[("n", 1.5), ("d_nm", f64::NAN)])), "layers[1].d_nm");
        assert_eq!(place(record(&[("n", 1.5), ("d_nm", 1.0), ("colour", 1.0)])), "layers[1].colour");
        assert_eq!(place(Argument::Number(1.0)), "layers[1]");
        assert_eq!(thin_film(vec![good; 100_001]).unwrap_err().place, "layers");
        let both = [("n1", 1.0), ("n2", 1.5), ("theta1", 0.1), ("cos_theta1", 0.5)];
        assert_eq!(call(&FRESNEL, &both.map(|(name, x)| (name, Argument::Number(x)))).unwrap_err().place, "cos_theta1");
        let neither = [("n1", 1.0), ("n2", 1.5)].map(|(name, x)| (name, Argument::Number(x)));
        assert_eq!(call(&SCHLICK, &neither).unwrap_err().place, "theta");
    }

    #[test]
    fn media_stand_by_name_where_a_step_takes_them() {
        let at = |medium: &[(&str, Argument)]| {
            let rest = [("n_i", 1.0.into()), ("theta", "45deg".into()), ("wavelength", "550nm".into())];
            call(&FRESNEL, &[&rest, medium].concat())
        };
        let index = Medium::Named(media::named("gold").unwrap()).index(550.0 * NM).unwrap();
        let numbers = at(&[("n2", index.re.into()), ("k2", index.im.into())]);
        assert_eq!(at(&[("n_t", "gold".into())]), numbers);
        assert_eq!(at(&[("n_t", Argument::record([("n", index.re.into()), ("k", index.im.into())]))]), numbers);
        assert_eq!(at(&[("n_t", "gold".into()), ("k2", 1.0.into())]).unwrap_err().place, "k2");
        let film = |fields| thin_film(vec![Argument::record(fields)]).unwrap();
        let numbers = film(vec![("n", index.re.into()), ("k", index.im.into()), ("d_nm", 20.0.into())]);
        assert_eq!(film(vec![("medium", "gold".into()), ("d_nm", 20.0.into())]), numbers);
        assert_eq!(film(vec![("n", "gold".into()), ("d", "20nm".into())]), numbers);
        let both = Argument::record([("n", "gold".into()), ("k", 1.0.into()), ("d_nm", 1.0.into())]);
        assert_eq!(thin_film(vec![both]).unwrap_err().place, "layers[0].k");
    }
}
