//! Models by name, as steps and functions set them.

use crate::parameter::{Kind, Parameter, Setting};
use light::Complex64;
use light::bsdf::microfacet::{LEAST_ALPHA, Slopes};
use light::bsdf::{self, Bsdf, zoo};
use light::media;
use light::number::Vector;
use std::f64::consts::FRAC_PI_2;

/// The names of the zoo; a test holds them to it.
pub(super) const NAMES: &[&str] = &[
    "lambert",
    "oren-nayar",
    "eon",
    "mirror",
    "conductor",
    "dielectric",
    "rough-conductor",
    "rough-dielectric",
    "plastic",
    "rough-plastic",
    "conductor-walk",
    "dielectric-walk",
    "conductor-compensated",
    "dielectric-compensated",
];

pub(super) const MODEL: Parameter =
    Parameter::new("model", "", "which surface", Kind::Choice(NAMES)).default("rough-conductor");
pub(super) const SLOPES: Parameter =
    Parameter::new("slopes", "", "how its facets' slopes are spread", Kind::Choice(&["ggx", "beckmann"]))
        .default("ggx");
pub(super) const ALPHA: Parameter =
    Parameter::new("alpha", "α", "roughness of facets", Kind::number(LEAST_ALPHA, 1.0, "1")).default("0.3");
pub(super) const ALPHA_Y: Parameter =
    Parameter::new("alpha_y", "α_y", "roughness along y, if it is another", Kind::number(LEAST_ALPHA, 1.0, "1"))
        .instead_of(&[]);
pub(super) const ROUGHNESS: Parameter =
    Parameter::new("roughness", "r", "roughness of a diffuse body", Kind::number(0.0, 1.0, "1")).default("0.5");
pub(super) const ALBEDO: Parameter =
    Parameter::new("albedo", "ρ", "share that a diffuse body or a plain mirror returns", Kind::number(0.0, 1.0, "1"))
        .default("0.8");
/// The metals by name, of media that are known over the visible; white is ε = −1.
pub(super) const METALS: &[&str] = &["gold", "silver", "copper", "aluminium", "chromium", "white"];
pub(super) const METAL: Parameter =
    Parameter::new("metal", "", "which metal; white absorbs nothing", Kind::Choice(METALS)).default("gold");
pub(super) const INDEX: Parameter = Parameter::new(
    "n",
    "n",
    "index of what is clear, over that outside; rough glass is held off 1 by 1e-3, for at 1 its facets cannot be told",
    Kind::number(1.0 / 4.0, 4.0, "1"),
)
.default("1.5");
pub(super) const THETA: Parameter =
    Parameter::new("theta", "θ_i", "angle of incidence", Kind::number(0.0, FRAC_PI_2, "rad")).default("45deg");

/// The indices of a metal at [`media::CHANNELS`].
pub(super) fn metal(name: &str) -> [Complex64; 3] {
    if name == "white" {
        return [Complex64::I; 3];
    }
    let known = media::named(name).expect("a metal of the list");
    known.colour().expect("known over the visible")
}

/// What a model is made from, of those of its parameters that the step has.
pub(super) fn made_from(setting: &Setting) -> bsdf::Setting {
    let has = |name: &str| setting.entries().any(|(parameter, _, _)| parameter.name == name);
    let number = |name: &'static str, or: f64| if has(name) { setting.number(name) } else { or };
    let plain = bsdf::Setting::default();
    let across = number("alpha_y", number("alpha", plain.alpha[1]));
    bsdf::Setting {
        albedo: [number("albedo", plain.albedo[0]); 3],
        alpha: [number("alpha", plain.alpha[0]), across],
        roughness: number("roughness", plain.roughness),
        index: number("n", plain.index),
        metal: if has("metal") { metal(setting.word("metal")) } else { plain.metal },
        slopes: if has("slopes") && setting.word("slopes") == "beckmann" { Slopes::Beckmann } else { Slopes::Ggx },
        ..plain
    }
}

/// The model `name` of the zoo.
pub(super) fn model(name: &str, of: &bsdf::Setting) -> Box<dyn Bsdf<f64>> {
    zoo::<f64>().iter().find(|entry| entry.name == name).expect("a name of the zoo").make(of)
}

/// The model of the setting.
pub(super) fn chosen(setting: &Setting) -> Box<dyn Bsdf<f64>> {
    model(setting.word("model"), &made_from(setting))
}

/// The unit vector at an angle to the normal and an azimuth [rad].
pub(super) fn way(theta: f64, phi: f64) -> Vector<f64> {
    Vector::of([theta.sin() * phi.cos(), theta.sin() * phi.sin(), theta.cos()])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_those_of_the_zoo() {
        assert!(zoo::<f64>().iter().map(|entry| entry.name).eq(NAMES.iter().copied()));
    }
}
