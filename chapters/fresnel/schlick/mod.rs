//! E44: Schlick's approximation, what it is good for, and what its speed costs.

mod checks;
mod figures;
mod races;

use self::checks::{AS_WRITTEN, ENDS, GLASS, GRAZING_SLOPE, INSIDE, METALS};
use self::figures::{curves, error_map};
use self::races::{SPEED, TABLE};
use super::amplitudes::contrast;
use super::symbols::{N_1, N_2, R_0, R_N, THETA_1, THETA_2};
use super::{INTERFACE, extremes, incidence, interface};
use crate::parameter::Setting;
use crate::vocabulary::{
    Answer, Exhibit, Extreme, Quantity, Question, Step, choice, derivation, exhibit, figure, question, statement, step,
    stress,
};
use equation::derivation::Chain;
use equation::expr::{cos, d, pi, ratio};
use equation::{Dimension, Equation, Expr, Symbol};
use light::Complex64;
use light::optics::fresnel::{critical_angle, powers};
use light::optics::schlick::{normal_reflectance, schlick, schlick_rarer_side};
use light::optics::{Direction, Incidence};
use light::references::fresnel::{Input, NAMES};
use std::f64::consts::FRAC_PI_2;

pub(super) const EXHIBIT: Exhibit = exhibit(
    "schlick",
    INTERFACE,
    &[
        figure("error_map", "Schlick's error over angle and index, with the cosine of either side.", error_map),
        figure(
            "curves",
            "Exact and approximate reflectance: the setting's, out of glass, of a high index, and of a metal.",
            curves,
        ),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Schlick's approximation",
    "A fifth power stands in for R_n: close for glass in air, wrong from inside it.",
)
.rows(&["E44"])
.about("schlick")
.statements(&[
    statement("r_0", "reflectance at normal incidence", || Equation::new(R_0, ((N_1 - N_2) / (N_1 + N_2)).pow(2))),
    statement("schlick", "Schlick's approximation", || Equation::approximate(R_N, fifth_power(cos(THETA_1)))),
    statement("rarer_side", "out of the denser medium it is the refracted angle that reaches 90°", || {
        Equation::approximate(R_N, fifth_power(cos(THETA_2)))
    }),
])
.questions(&[FROM_INSIDE])
.derivations(&[
    derivation("normal_incidence", "R_n from E35 and E38 at θ = 0, where E36 and E39 themselves are 0/0", || {
        at_normal(((N_1 - N_2) / (N_1 + N_2)).pow(2))
    })
    .slip("s and p do not add", || at_normal(((N_1 - N_2) / (N_1 + N_2)).pow(2) / 2)),
    derivation("slope", "how the approximation starts at grazing incidence", || grazing(-5 * (1 - R_0)))
        .slip("the fifth power is differentiated without its factor", || grazing(Expr::from(-5))),
])
.readout(readout)
.checks(&[&AS_WRITTEN, &ENDS, &GRAZING_SLOPE, &GLASS, &INSIDE, &METALS])
.stress(&[stress(
    "beyond_glass",
    "where Schlick keeps no digit the exact form costs little more and keeps them all",
    beyond_glass,
)
.textbook("Schlick's R₀ + (1 − R₀)(1 − cos θ₁)⁵")
.against("R_n from the boundary conditions in 256 bits")])
.races(&[SPEED, TABLE]);

const FROM_INSIDE: Question = question(
    "beyond_critical",
    "Inside glass of n = 1.5 light meets the surface at 50°, beyond the critical angle: R is 1. What does Schlick's \
     formula give with that angle?",
    Answer::Choice {
        options: &[
            choice("nearly 1", "It knows of no critical angle: only at 90° does it reach 1, from either side."),
            choice("about one half", "At 50° the fifth power of 1 − cos θ is still next to nothing."),
            choice("about 0.05", ""),
        ],
        right: |_| {
            let reflectance = schlick(50f64.to_radians().cos(), normal_reflectance(1.5, 1.0.into()));
            match reflectance {
                much if much > 0.9 => 0,
                some if some > 0.2 => 1,
                _ => 2,
            }
        },
        slip: |_| 0,
    },
    "A twentieth of the truth. Out of the denser medium the refracted angle must go in: it is the one that reaches \
     90°.",
);

/// R₀ + (1 − R₀)(1 − cos)⁵
fn fifth_power(cosine: Expr) -> Expr {
    R_0 + (1 - R_0) * (1 - cosine).pow(5)
}

fn at_normal(last: Expr) -> Chain {
    let s = contrast(N_1 * cos(THETA_1), N_2 * cos(THETA_2));
    let p = contrast(N_2 * cos(THETA_1), N_1 * cos(THETA_2));
    Chain::new(ratio(1, 2) * (s.pow(2) + p.pow(2)))
        .because("E42 with the ratios that E35 and E38 give")
        .given(THETA_1, 0, "normal incidence")
        .given(THETA_2, 0, "Snell: sin θ₂ = 0")
        .then(
            ratio(1, 2) * (contrast(N_1.into(), N_2.into()).pow(2) + contrast(N_2.into(), N_1.into()).pow(2)),
            ["cos 0 = 1"],
        )
        .then(last, ["squares do not see the sign"])
}

/// The derivative of the approximation by the cosine, where that is 0.
fn grazing(last: Expr) -> Chain {
    const COSINE: Symbol = Symbol::scalar("c", Dimension::ONE).within(0.1, 0.9);
    let factor = -5 * (1 - R_0);
    Chain::new(Equation::new(d(R_N) / d(COSINE), &factor * (1 - COSINE).pow(4)))
        .given(R_N, fifth_power(COSINE.into()), "Schlick")
        .then(Equation::new(factor * (1 - cos(pi() / 2)).pow(4), last), ["cos θ = 0"])
}

fn readout(setting: &Setting) -> Vec<Quantity> {
    let Input { n_i, n_t, .. } = interface(setting);
    let direction = incidence(setting);
    let r_0 = normal_reflectance(n_i, n_t);
    let (exact, plain) = (powers(direction, n_i, n_t).r_n(), schlick(direction.cos(), r_0));
    let number = |key, symbol, says, value| Quantity { key, symbol, says, value, unit: "1" };
    let mut quantities = vec![
        number("R_0", "R_0", "reflectance at normal incidence", r_0),
        number("R_n", "R_n", "exact", exact),
        number("schlick", "R_S", "Schlick's approximation", plain),
        number("error", "R_S − R_n", "its error", plain - exact),
    ];
    if n_t.im == 0.0 {
        let rarer = schlick_rarer_side(direction.cos(), n_i, n_t.re);
        quantities.push(number("rarer_side", "R_S(θ_2)", "Schlick with the rarer side's cosine", rarer));
    }
    quantities
}

/// From inside, about the critical angle, nearly equal and far apart indices, metals.
fn beyond_glass(setting: &Setting) -> Vec<Extreme> {
    let critical = critical_angle(1.5, 1.0).expect("into the rarer medium");
    let input = |theta, n_i, n, k| Input { direction: Direction::Angle(theta), n_i, n_t: Complex64::new(n, k) };
    let inputs = [
        interface(setting),
        input(0.5, 1.5, 1.0, 0.0),
        input(critical - 1e-6, 1.5, 1.0, 0.0),
        input(critical + 1e-6, 1.5, 1.0, 0.0),
        input(0.9, 1.0, 0.25, 0.0),
        input(1.0, 1.0, 1.0 + 1e-9, 0.0),
        input(FRAC_PI_2 - 1e-6, 1.0, 1.0 + 1e-9, 0.0),
        input(1.3, 1.0, 4.0, 0.0),
        input(1.3, 1.0, 1e6, 0.0),
        input(1.3, 1.0, 3.0, 3.0),
        input(1.4, 1.0, 1.2, 7.0),
        input(FRAC_PI_2 - 1e-3, 1.0, 1e3, 1e3),
    ];
    extremes::cases_against(&["R_n"], &inputs, |input| {
        let cos_i = Incidence::from(input.direction).cos();
        [schlick(cos_i, normal_reflectance(input.n_i, input.n_t)); NAMES.len()]
    })
}
/// The crown glass of the races: cos θ_c = ¾ from inside, so that the kink falls on an entry of every table.
const GLASS_INDEX: f64 = 1.511_857_892_036_909;
