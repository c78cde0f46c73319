//! What an interface does to a plane wave: rows E33–E44 and C10–C15. One module a step, in teaching order.

mod amplitudes;
mod boundary;
mod brewster;
mod digits;
mod dip;
mod energy;
mod extremes;
pub(crate) mod fields;
mod films;
mod functions;
mod geometry;
mod grazing;
mod hemisphere;
mod metals;
mod natural;
mod powers;
mod schlick;
mod snell;
mod symbols;
mod total_reflection;

use crate::parameter::{Kind, Parameter, Setting, THETA, WAVELENGTH};
use crate::vocabulary::{Chapter, Gallery, gallery};
use light::Complex64;
use light::optics::{Direction, Incidence, fresnel};
use light::references::fresnel::Input;
use std::f64::consts::FRAC_PI_2;

/// The chapter.
pub const CHAPTER: Chapter = Chapter {
    id: "fresnel",
    title: "What an interface does to a plane wave",
    says: "From the boundary conditions to mirrors, glass, metals and stacks of films, with every digit accounted for.",
    builds_on: &["plane-wave", "poynting"],
    prose: include_str!("prose.md"),
    steps: &[
        snell::STEP,
        boundary::STEP,
        amplitudes::R_S_STEP,
        amplitudes::T_S_STEP,
        amplitudes::R_P_STEP,
        amplitudes::T_P_STEP,
        powers::STEP,
        natural::STEP,
        energy::STEP,
        digits::STEP,
        brewster::STEP,
        dip::STEP,
        grazing::STEP,
        total_reflection::STEP,
        metals::STEP,
        schlick::STEP,
        films::STEP,
    ],
    figures: FIGURES,
    functions: functions::FUNCTIONS,
};

/// What its steps show, apart from the evidence.
pub const FIGURES: Gallery = gallery(
    "fresnel",
    &[
        snell::EXHIBIT,
        boundary::EXHIBIT,
        amplitudes::R_S_EXHIBIT,
        amplitudes::T_S_EXHIBIT,
        amplitudes::R_P_EXHIBIT,
        amplitudes::T_P_EXHIBIT,
        powers::EXHIBIT,
        natural::EXHIBIT,
        energy::EXHIBIT,
        digits::EXHIBIT,
        brewster::EXHIBIT,
        dip::EXHIBIT,
        grazing::EXHIBIT,
        total_reflection::EXHIBIT,
        metals::EXHIBIT,
        schlick::EXHIBIT,
        films::EXHIBIT,
    ],
);

/// The medium the light comes from.
const N_I: Parameter = Parameter::new("n_i", "n_1", "medium of incidence (clear)", Kind::ClearMedium).default("1");

/// The medium behind the interface.
const N_T: Parameter = Parameter::new("n_t", "n_2", "medium behind the interface", Kind::Medium).default("1.5");

/// What most steps let the learner change.
pub(crate) const INTERFACE: &[Parameter] = &[N_I, N_T, THETA, WAVELENGTH];

/// The interface that the setting describes.
pub(crate) fn interface(setting: &Setting) -> Input {
    Input {
        direction: Direction::Angle(setting.number("theta")),
        n_i: setting.index("n_i").re,
        n_t: setting.index("n_t"),
    }
}

/// The direction of incidence in the setting.
fn incidence(setting: &Setting) -> Incidence {
    Incidence::from_angle(setting.number("theta"))
}

/// Angles of incidence [°] for curves, evenly spaced, both ends included; the last stands a hair before grazing.
fn curve_degrees() -> impl Iterator<Item = f64> {
    (0..=360).map(|quarter| (f64::from(quarter) / 4.0).min(89.999))
}

/// A curve over the angle of incidence [°] at which `value` is defined.
fn over_angle(value: impl Fn(Incidence) -> f64) -> Vec<[f64; 2]> {
    curve_degrees().map(|degrees| [degrees, value(Incidence::from_angle(degrees.to_radians()))]).collect()
}

/// Curve points refined around `centre` [°], where the curve turns sharply: a critical or Brewster's angle.
fn over_angle_near(centre: f64, value: impl Fn(Incidence) -> f64) -> Vec<[f64; 2]> {
    let near =
        (-60..=60).map(|step: i32| centre + f64::from(step.signum()) * 10f64.powf(f64::from(step.abs()) / 12.0 - 5.0));
    let mut degrees: Vec<f64> =
        curve_degrees().chain(near).filter(|degrees| (0.0..=89.999).contains(degrees)).collect();
    degrees.sort_by(f64::total_cmp);
    degrees.into_iter().map(|degrees| [degrees, value(Incidence::from_angle(degrees.to_radians()))]).collect()
}

/// Clear and absorbing pairs on which checks are made besides the setting's own.
fn sample_media() -> Vec<(f64, Complex64)> {
    let clear = [(1.0, 1.5), (1.0, 2.4), (1.33, 1.52), (1.5, 1.0), (2.4, 1.0), (1.0, 4.0)];
    let metals = [(1.0, 0.2, 3.4), (1.0, 1.4, 7.6), (1.5, 0.05, 4.0)];
    let clear = clear.map(|(n_i, n_t)| (n_i, Complex64::new(n_t, 0.0)));
    clear.into_iter().chain(metals.map(|(n_i, n, k)| (n_i, Complex64::new(n, k)))).collect()
}

/// `n 1 → 1.5` or `n 1 → 0.4222 + 2.473i`: the pair of media as a heading.
pub(crate) fn media(n_i: f64, n_t: Complex64) -> String {
    let short = |x: f64| {
        let rounded = (x * 1e4).round() / 1e4;
        if rounded == x || (1e-2..1e4).contains(&x) { format!("{rounded}") } else { format!("{x:.3e}") }
    };
    let absorbed = if n_t.im == 0.0 { String::new() } else { format!(" + {}i", short(n_t.im)) };
    format!("n {} → {}{absorbed}", short(n_i), short(n_t.re))
}

/// `1 → 1.5`, `1 → gold, 550 nm`: the setting's media as they were named, for a label.
pub(crate) fn own_media(setting: &Setting) -> String {
    let (n_i, n_t) = (setting.text("n_i"), setting.text("n_t"));
    let is_named = [&n_i, &n_t].iter().any(|text| text.starts_with(char::is_alphabetic));
    let nanometres = (setting.wavelength() * 1e12).round() / 1e3;
    let at = if is_named { format!(", {nanometres} nm") } else { String::new() };
    format!("{n_i} → {n_t}{at}")
}

/// The sample media and the setting's own pair, each at every angle of a coarse fan.
pub(crate) fn sample_inputs(setting: &Setting) -> Vec<Input> {
    let own = interface(setting);
    let fan = [0.0, 10.0, 25.0, 41.0, 45.0, 56.0, 70.0, 80.0, 89.0, 89.99]
        .map(|degrees: f64| Direction::Angle(degrees.to_radians()));
    let media = sample_media().into_iter().chain([(own.n_i, own.n_t)]);
    let each = |(n_i, n_t)| fan.map(|direction| Input { direction, n_i, n_t });
    media.flat_map(each).chain([own]).collect()
}

/// Place of the least value of a unimodal `f` (Kiefer 1953).
fn golden_section(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let ratio = 0.5 * (5f64.sqrt() - 1.0);
    for _ in 0..90 {
        let (left, right) = (high - ratio * (high - low), low + ratio * (high - low));
        if f(left) < f(right) { high = right } else { low = left }
    }
    0.5 * (low + high)
}

/// The angle of incidence [rad] at which R_p is least: Brewster's in a clear medium.
fn pseudo_brewster(n_i: f64, n_t: Complex64) -> f64 {
    if n_t.im == 0.0 {
        return fresnel::brewster_angle(n_i, n_t.re);
    }
    let reflectance = |theta: f64| fresnel::powers(Incidence::from_angle(theta), n_i, n_t).r_p;
    golden_section(reflectance, 0.0, FRAC_PI_2)
}
