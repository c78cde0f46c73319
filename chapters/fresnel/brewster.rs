//! C11, first half: p alone is not reflected at Brewster's angle.

use super::amplitudes::contrast;
use super::extremes::cases;
use super::symbols::{N_1, N_2, THETA_1, THETA_2};
use super::{INTERFACE, interface, pseudo_brewster};
use crate::figure::{Axis, Chart, Hue, Plot};
use crate::parameter::Setting;
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Quantity, Question, Step, check, derivation, exhibit, figure, question,
    statement, step, stress,
};
use equation::derivation::Chain;
use equation::expr::{cos, pi, sin, tan};
use equation::{Dimension, Equation, Expr, Symbol};
use light::optics::fresnel::{Powers, amplitudes, brewster_angle, critical_angle, powers, refract};
use light::optics::{Direction, Incidence};
use light::references::fresnel::Input;
use std::f64::consts::FRAC_PI_2;

const THETA_B: Symbol = Symbol::scalar("theta_B", Dimension::ONE).within(0.3, 1.2);

pub(super) const EXHIBIT: Exhibit = exhibit(
    "brewster",
    INTERFACE,
    &[figure(
        "zero_of_r_p",
        "R_p on a logarithmic scale for media from water to diamond: each zero stands at its own angle.",
        zeros,
    )],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "The angle at which p does not reflect",
    "At Brewster's angle reflected and refracted ray are at right angles, and r_p changes sign.",
)
.rows(&["C11"])
.statements(&[
    statement("angle", "Brewster's angle", || Equation::new(tan(THETA_B), N_2 / N_1)),
    statement("right_angle", "reflected and refracted ray stand at right angles", || {
        Equation::new(THETA_B + THETA_2, pi() / 2)
    }),
])
.questions(&[P_ALONE])
.derivations(&[
    derivation("from_snell", "where θ₁ + θ₂ is a right angle, Snell's law is tan θ_B = n₂/n₁", || {
        at_right_angle(tan(THETA_1))
    })
    .slip("sine for tangent", || at_right_angle(sin(THETA_1))),
    derivation("nothing_reflected", "there the wave that E38 leaves to be reflected vanishes", || {
        reflected(N_2, N_1, sin(THETA_1), Expr::from(0))
    })
    .slip("s for p", || reflected(N_1, N_2, sin(THETA_1), Expr::from(0))),
])
.readout(readout)
.checks(&[&NOTHING_REFLECTED, &RIGHT_ANGLE])
.stress(&[stress("zero", "R_p keeps its digits however close to its zero", |setting| {
    let offsets = [-1e-3, -1e-6, -1e-9, -1e-12, 0.0, 1e-12, 1e-9, 1e-6];
    let media = [(1.0, 1.5), (1.5, 1.0), (1.0, 2.4)];
    let near = media.iter().flat_map(|&(n_i, n_t)| {
        let angle = brewster_angle(n_i, n_t);
        offsets.map(|offset| Input { direction: Direction::Angle(angle + offset), n_i, n_t: n_t.into() })
    });
    cases(&["R_p"], &[interface(setting)].into_iter().chain(near).collect::<Vec<_>>())
})
.textbook("tan²(θ₁−θ₂)/tan²(θ₁+θ₂)")
.against("256 bits")]);

const P_ALONE: Question = question(
    "p_alone",
    "From the normal to grazing, how does R_p, the reflectance of p light, run at this interface?",
    Answer::Trend {
        replies: [
            "At grazing incidence a surface is a mirror, for p as for s: where anything is reflected at all, the curve \
             ends at its highest.",
            "So it is only between equal media, where nothing is reflected at any angle.",
            "That is s. What p reflects changes its sign on the way: between clear media it passes zero, at a metal it \
             comes near it. And equal media reflect nothing at all.",
            "Both media are the same here: there is nothing to reflect from, at any angle.",
            "At grazing incidence a surface is a mirror: where anything is reflected at all, the curve ends at its highest.",
        ],
        right: |setting, at| at_share(setting, at).r_p,
        // Even where nothing is reflected whoever takes it for s says that it rises.
        slip: |setting, at| at_share(setting, at).r_s + at,
    },
    "Where the media differ, R_p falls until the reflected and the refracted ray stand at right angles, to zero if both \
     are clear, and climbs from there to 1. Equal media reflect nothing.",
);

/// What the setting's interface reflects at a share of a right angle.
fn at_share(setting: &Setting, at: f64) -> Powers {
    let input = interface(setting);
    powers(Incidence::from_angle(at * FRAC_PI_2), input.n_i, input.n_t)
}

/// Snell's law where the reflected and the refracted ray stand at right angles.
fn square_rays() -> Chain {
    Chain::assume(Equation::new(N_1 * sin(THETA_1), N_2 * sin(THETA_2)), "Snell").given(
        THETA_2,
        pi() / 2 - THETA_1,
        "right angle",
    )
}

fn at_right_angle(left: Expr) -> Chain {
    square_rays()
        .then(Equation::new(N_1 * sin(THETA_1), N_2 * cos(THETA_1)), ["right angle: sin θ₂ = cos θ₁"])
        .then(Equation::new(left, N_2 / N_1), ["divide by n₁ cos θ₁"])
}

/// E36 or E39 as the boundary conditions give them, before Snell's law puts the indices away.
fn reflected(near: Symbol, far: Symbol, turned: Expr, last: Expr) -> Chain {
    let start = contrast(&near * cos(THETA_1), &far * cos(THETA_2));
    square_rays()
        .then(Equation::new(start, contrast(near * cos(THETA_1), far * turned)), ["right angle: cos θ₂ = sin θ₁"])
        .then(last, ["Snell"])
}

fn readout(setting: &Setting) -> Vec<Quantity> {
    let input = interface(setting);
    let angle = pseudo_brewster(input.n_i, input.n_t);
    let there = powers(Incidence::from_angle(angle), input.n_i, input.n_t);
    let (place, kept) = if input.n_t.im == 0.0 {
        ("Brewster's angle", "what is left of s there, and with it of all reflected light")
    } else {
        ("angle of least R_p, which stands for Brewster's in an absorbing medium", "what is left of s there")
    };
    let all = [
        ("theta_B", "θ_B", place, angle, "rad"),
        ("R_p_at_B", "R_p(θ_B)", "what is left of p there", there.r_p, "1"),
        ("R_s_at_B", "R_s(θ_B)", kept, there.r_s, "1"),
    ];
    all.map(|(key, symbol, says, value, unit)| Quantity { key, symbol, says, value, unit }).into()
}

const NOTHING_REFLECTED: Check<fn(f64, f64) -> f64> =
    check("minimum", "the least R_p over all angles, none, is at arctan(n₂/n₁)")
        .against("bisection for the angle at which r_p changes its sign, by values alone")
        .within(
            4.0,
            "ulp",
            "relative: the two angles between which r_p changes its sign are neighbours, half an ε to an ε apart, the \
             arctangent rounds its argument and its value, and so does the critical angle at which the search may end",
        )
        .of(distance_of_zero, brewster_angle)
        .slip("the angle of the way back", |n_i, n_t| brewster_angle(n_t, n_i));

fn distance_of_zero(bench: &mut Bench, angle: fn(f64, f64) -> f64) -> Measured {
    let own = interface(bench.setting());
    let mut media = vec![(1.0, 1.33), (1.0, 1.5), (1.0, 2.4), (1.5, 1.0), (1.0, 4.0), (1.0, 1e8), (1e9, 1e-9)];
    // A metal's r_p turns its phase and has no sign to change.
    if own.n_t.im == 0.0 && own.n_t.re != own.n_i {
        media.push((own.n_i, own.n_t.re));
    }
    Measured::worst(media.into_iter().map(|(n_i, n_t)| {
        let is_before = |theta: f64| {
            let r_p = amplitudes(Incidence::from_angle(theta), n_i, n_t.into()).r_p.re;
            (r_p > 0.0) == (n_t > n_i)
        };
        // Beyond the critical angle r_p turns its phase too.
        let (mut before, mut behind) = (0.0, critical_angle(n_i, n_t).unwrap_or(FRAC_PI_2));
        while f64::next_up(before) < behind {
            let middle = 0.5 * (before + behind);
            *(if is_before(middle) { &mut before } else { &mut behind }) = middle;
        }
        ((behind / angle(n_i, n_t) - 1.0) / f64::EPSILON, format!("n {n_i} → {n_t}"))
    }))
}

const RIGHT_ANGLE: Check<fn(f64, f64) -> f64> =
    check("square", "there the reflected and the refracted ray stand at right angles")
        .against("Snell's law at the angle that the arctangent gives")
        .within(8.0, "ulp", "a handful of roundings of angles below π/2")
        .of(out_of_square, brewster_angle)
        .slip("the arcsine, as for the critical angle", |n_i, n_t| (n_t.min(n_i) / n_t.max(n_i)).asin());

fn out_of_square(_: &mut Bench, angle: fn(f64, f64) -> f64) -> Measured {
    let media = [(1.0, 1.33), (1.0, 1.5), (1.0, 2.4), (1.5, 1.0), (1.0, 4.0), (1.33, 1.5)];
    Measured::worst(media.map(|(n_i, n_t)| {
        let theta = angle(n_i, n_t);
        // Somebody's own angle may be none.
        let incidence = (0.0..=FRAC_PI_2).contains(&theta).then(|| Incidence::from_angle(theta));
        let refracted = incidence.and_then(|incidence| refract(incidence, n_i, n_t));
        let refracted = refracted.map_or(f64::NAN, |(sin, cos)| sin.atan2(cos));
        ((theta + refracted - FRAC_PI_2) / f64::EPSILON, format!("n {n_i} → {n_t}"))
    }))
}

fn zeros(setting: &Setting) -> Plot {
    let own = interface(setting);
    let media = [("water", 1.334), ("glass", 1.519), ("sapphire", 1.770), ("diamond", 2.423)];
    let reflectance = |n_i: f64, n_t: light::Complex64| {
        let brewster = brewster_angle(n_i, n_t.re).to_degrees();
        super::over_angle_near(brewster, move |incidence| powers(incidence, n_i, n_t).r_p)
    };
    let mut chart = Chart::new(
        "",
        Axis::linear("angle of incidence θ_1", "°").range(0.0, 90.0).tick(15.0),
        Axis::log("R_p", "").range(1e-10, 1.0),
    );
    for (at, (name, n)) in media.into_iter().enumerate() {
        chart = chart.line(Hue::Nth(at as u8), format!("{name}, n = {n}"), reflectance(1.0, n.into()));
    }
    chart = chart.dashed(Hue::Natural, super::own_media(setting), reflectance(own.n_i, own.n_t));
    Plot::of("Where p is not reflected", chart)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vocabulary::Given;

    /// What every textbook says of any pair of media, however alike or far apart.
    #[test]
    fn p_falls_and_rises_wherever_media_differ() {
        let different = ["1.5", "1.05", "1.001", "1.000001", "2.4", "1e9", "0.7", "1e-9", "gold", "0.05+4i"];
        for (n_t, right) in different.map(|n_t| (n_t, 3)).into_iter().chain([("1", 1)]) {
            let changes = [("n_t".to_owned(), n_t.to_owned())];
            let setting = Setting::defaults(INTERFACE).with(&changes).unwrap();
            assert_eq!(P_ALONE.right(&setting), Given::Option(right), "n_t = {n_t}");
        }
    }
}
