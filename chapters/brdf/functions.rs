//! What `lesson eval` offers from this chapter.

use super::facets::measured;
use super::models::{ALBEDO, ALPHA, ALPHA_Y, INDEX, METAL, MODEL, ROUGHNESS, SLOPES, made_from, model};
use crate::parameter::{Fault, Function, Kind, Output, Parameter, Range};
use light::bsdf::albedo::albedo;
use light::bsdf::guard::LEAST_COSINE;
use light::bsdf::microfacet::Slopes;
use light::number::Vector;
use std::f64::consts::FRAC_PI_2;

/// The functions, each with its inputs' units and domains.
pub(super) const FUNCTIONS: &[Function] = &[MICROFACET, ALBEDO_OF, BRDF];

/// How facets' slopes are spread, called the model here.
const KIND: Parameter =
    Parameter::new("model", "", "how the facets' slopes are spread", Kind::Choice(&["ggx", "beckmann"]));

fn slopes(word: &str) -> Slopes {
    if word == "beckmann" { Slopes::Beckmann } else { Slopes::Ggx }
}

const MICROFACET: Function = Function {
    name: "microfacet",
    says: "facets of a rough surface whose normal is at θ, and what is masked of a view at θ (Smith)",
    inputs: &[
        KIND,
        ALPHA.required(),
        Parameter::new("theta", "θ", "angle to the surface's normal", Kind::number(0.0, FRAC_PI_2, "rad")),
    ],
    outputs: &[
        Output::new("D", "density of the facets' normals, per area of the mean surface", "1/sr"),
        Output::new("lambda", "hidden over seen area of facets; some 10¹⁶ α at 90°", "1"),
        Output::new("G1", "share of the facets facing θ that is seen", "1"),
    ],
    compute: |setting| {
        let (alpha, theta) = (setting.number("alpha"), setting.number("theta"));
        let w = Vector::new(theta.sin(), 0.0, theta.cos());
        let [d, hidden, seen] = measured(slopes(setting.word("model")), alpha, w);
        Ok(vec![("D", d), ("lambda", hidden), ("G1", seen)])
    },
};

const ALBEDO_OF: Function = Function {
    name: "albedo",
    says: "the share of light from everywhere that rough metal returns at one bounce if it absorbs nothing, masking \
           correlated by height; to 1e-8",
    inputs: &[
        KIND,
        ALPHA.required(),
        Parameter::new("mu", "μ", "cosine of the view to the surface's normal", Kind::number(1e-7, 1.0, "1")),
    ],
    outputs: &[Output::new("E", "share returned", "1")],
    compute: |setting| {
        let found = albedo(slopes(setting.word("model")), setting.number("alpha"), setting.number("mu"));
        Ok(vec![("E", found)])
    },
};

/// A direction, of any length but none.
const WAY: Kind = Kind::Vector(Range::new(-1e150, 1e150, "1"));

/// The models with facets, and their likes.
const FACETED: &[&str] = &[
    "rough-conductor",
    "rough-dielectric",
    "rough-plastic",
    "conductor-walk",
    "dielectric-walk",
    "conductor-compensated",
    "dielectric-compensated",
];

const BRDF: Function = Function {
    name: "brdf",
    says: "a surface's f_r, or f_t through it (of radiance), without the cosine and without deltas, and the density with \
           which wi is drawn for light that goes to wo; z is the normal, both point away from the surface, outside is z > 0",
    inputs: &[
        Parameter { default: None, ..MODEL },
        Parameter { only_with: Some(("model", FACETED)), ..ALPHA },
        Parameter { only_with: Some(("model", FACETED)), ..ALPHA_Y },
        Parameter { only_with: Some(("model", FACETED)), ..SLOPES },
        Parameter { only_with: Some(("model", &["oren-nayar", "eon"])), ..ROUGHNESS },
        Parameter {
            only_with: Some(("model", &["lambert", "oren-nayar", "eon", "mirror", "plastic", "rough-plastic"])),
            ..ALBEDO
        },
        Parameter {
            only_with: Some(("model", &["conductor", "rough-conductor", "conductor-walk", "conductor-compensated"])),
            ..METAL.default("white")
        },
        Parameter {
            only_with: Some((
                "model",
                &[
                    "dielectric",
                    "rough-dielectric",
                    "dielectric-walk",
                    "dielectric-compensated",
                    "plastic",
                    "rough-plastic",
                ],
            )),
            ..INDEX
        },
        Parameter::new("wi", "ω_i", "where the light comes from; any length", WAY),
        Parameter::new("wo", "ω_o", "where it goes; any length", WAY),
    ],
    outputs: &[
        Output::new(
            "f",
            "of the middle one of three wavelengths, 532 nm; 0 where there is only a delta; of a walk an estimate, exact for the first bounce and from a single walk beyond",
            "1/sr",
        ),
        Output::new("pdf", "density of wi", "1/sr"),
        Output::new("f_red", "at 630 nm", "1/sr"),
        Output::new("f_blue", "at 467 nm", "1/sr"),
    ],
    compute: |setting| {
        let wi = direction("wi", setting.vector("wi"))?;
        let wo = direction("wo", setting.vector("wo"))?;
        let surface = model(setting.word("model"), &made_from(setting));
        let ([red, green, blue], pdf) = surface.eval_pdf(wi, wo);
        // Adding zero takes the sign off a negative one.
        Ok(vec![("f", green), ("pdf", pdf + 0.0), ("f_red", red), ("f_blue", blue)])
    },
};

/// The unit vector along `way`.
fn direction(place: &'static str, way: [f64; 3]) -> Result<Vector<f64>, Fault> {
    let largest = way.iter().fold(0.0_f64, |most, part| most.max(part.abs()));
    if largest == 0.0 {
        return Err(Fault::new(place, "is no direction: all three are 0; valid: any other"));
    }
    // The largest first: the squares of the others may leave the range.
    let unit: Vector<f64> = Vector::of(way.map(|part| part / largest)).normalised();
    if unit.z.abs() < LEAST_COSINE {
        return Err(Fault::new(place, format!("lies in the surface; valid: |cos θ| of at least {LEAST_COSINE:e}")));
    }
    Ok(unit)
}

#[cfg(test)]
mod tests {
    use super::super::models::NAMES;
    use super::*;
    use crate::parameter::Argument;

    fn call(given: &[(&str, Argument)]) -> Result<Vec<(&'static str, f64)>, Fault> {
        let given: Vec<_> = given.iter().map(|(name, argument)| ((*name).to_owned(), argument.clone())).collect();
        BRDF.call(&given)
    }

    fn ways() -> [(&'static str, Argument); 2] {
        let way = |parts: [f64; 3]| Argument::List(parts.map(Argument::Number).to_vec());
        [("wi", way([0.6, 0.0, 0.8])), ("wo", way([-5.0, 1.0, 8.6]))]
    }

    #[test]
    fn every_model_answers() {
        for name in NAMES {
            let found = call(&[&ways()[..], &[("model", (*name).into())]].concat()).unwrap();
            assert!(found.iter().all(|(_, value)| value.is_finite() && *value >= 0.0), "{name}: {found:?}");
        }
    }

    #[test]
    fn what_a_model_does_not_have_is_refused() {
        let fault = call(&[&ways()[..], &[("model", "lambert".into()), ("alpha", 0.1.into())]].concat()).unwrap_err();
        assert_eq!(fault.place, "alpha");
        let null = Argument::List(vec![0.0.into(), 0.0.into(), 0.0.into()]);
        let fault = call(&[("model", "lambert".into()), ("wi", null), ways()[1].clone()]).unwrap_err();
        assert_eq!(fault.place, "wi");
    }

    #[test]
    fn lambert_is_its_albedo_over_pi() {
        let found = call(&[&ways()[..], &[("model", "lambert".into()), ("albedo", 0.5.into())]].concat()).unwrap();
        assert!((found[0].1 - 0.5 / std::f64::consts::PI).abs() < 1e-16);
    }
}
