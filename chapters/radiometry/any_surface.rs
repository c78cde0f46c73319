//! C7: the same flux through any surface.

use super::solid_angle::HALF_ANGLE;
use super::surfaces::{Patch, ellipsoid, sphere, torus};
use super::symbols::{ALPHA, AREA, INTENSITY, RADIUS, S_R, SOLID_ANGLE};
use crate::diagram::{Diagram, Part, Spot};
use crate::figure::{Hue, Plot};
use crate::parameter::Setting;
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Extreme, Measured, Quantity, Step, check, choice, derivation, exhibit, figure,
    question, step, stress,
};
use equation::Expr;
use equation::derivation::Chain;
use equation::expr::cos;
use glam::DVec3;
use light::radiometry::pattern::Pattern;
use light::radiometry::solid_angle;
use std::f64::consts::{PI, TAU};
use yardstick::precise::{self, BITS, Real};

pub(super) const EXHIBIT: Exhibit = exhibit(
    "any_surface",
    &[HALF_ANGLE],
    &[figure(
        "cone",
        "The same cone of light through spheres about the lamp and beside it: the patches differ, their power does not. What enters the ring leaves it again.",
        cone,
    )],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Whatever shape the detector has",
    "A closed surface takes the whole flux of what it holds, whatever its shape; of what lies outside it takes as much \
     out as in.",
)
.rows(&["C7"])
.questions(&[question(
    "ring",
    "A lamp stands in the hole of a closed ring, as a finger in a doughnut. How much of its power passes the ring's \
     surface, counted outwards?",
    Answer::Choice {
        options: &[
            choice("all of it", "Much of the light misses the ring altogether, and what enters it leaves it again."),
            choice(
                "as much as the ring is wide in the lamp's view",
                "So much enters; but it leaves again, on the far side.",
            ),
            choice("nothing", ""),
        ],
        right: |_| if net(&torus(DVec3::ZERO, 2.0, 0.5, 64), Pattern::Isotropic).abs() < 1e-9 { 2 } else { 0 },
        slip: |_| 0,
    },
    "Every ray that enters the ring leaves it again: inwards and outwards cancel.",
)])
.derivations(&[derivation(
    "tilted_patch",
    "a patch that lies askew is larger by as much as it meets less of the flow, and farther by as much as that is \
     thinner",
    || patch(INTENSITY * SOLID_ANGLE),
)
.slip("the patch's tilt forgotten", || patch(INTENSITY * SOLID_ANGLE * cos(ALPHA)))])
.readout(|setting| {
    let alpha = setting.number("alpha");
    let cap = alpha.tan().abs();
    let through = |says, key, symbol, value| Quantity { key, symbol, says, value, unit: "1" };
    let near = solid_angle::cone(alpha) / (4.0 * PI);
    vec![
        through("share of the flux inside the cone", "near", "Φ_{in}/Φ", near),
        through("share outside it", "far", "Φ_{out}/Φ", solid_angle::cone(PI - alpha) / (4.0 * PI)),
        through("the cone's radius at unit distance", "radius", "tan α", if alpha < PI / 2.0 { cap } else { f64::MAX }),
    ]
})
.checks(&[&SHAPES])
.stress(&[stress(
    "window",
    "a round window takes its share of the flux to the last digits, from a hair's breadth and from afar",
    |_| windows(),
)
.textbook("2π(1 − cos ψ), with cos ψ = h/√(h² + ρ²)")
.against("the same in 512 bits")]);

fn patch(last: Expr) -> Chain {
    Chain::new(S_R * cos(ALPHA) * AREA)
        .because("the power through a small patch")
        .given(S_R, INTENSITY / RADIUS.pow(2), "inverse square")
        .given(AREA, RADIUS.pow(2) * SOLID_ANGLE / cos(ALPHA), "the patch over its cone")
        .then(last, ["inverse square", "the patch over its cone"])
}

/// How a patch counts what flows through it.
type Passing = fn(DVec3, DVec3) -> f64;

/// The flow [W m⁻²] at a place from a lamp of unit flux at the origin, its axis along z.
fn flow(pattern: Pattern, at: DVec3) -> DVec3 {
    let distance = at.length();
    pattern.intensity(1.0, at.z / distance) * at / distance.powi(3)
}

/// What flows out of a surface from a lamp of unit flux at the origin.
fn net(patches: &[Patch], pattern: Pattern) -> f64 {
    patches.iter().map(|patch| flow(pattern, patch.at).dot(patch.area)).sum()
}

const SHAPES: Check<Passing> = check(
    "shapes",
    "spheres about and beside the lamp, ellipsoids and rings all take the same",
)
.against("the flux that the lamp was given; none of it where the lamp is outside")
.within(
    1e-10,
    "1",
    "of 160 rings what is left of the nearest wall, a fifth of the radius away, is e^(−2·160·0.2) ~ 10⁻²⁸; then the rounding of 5·10⁴ terms that reach 25 times the mean",
)
.of(shapes, |flow, area| flow.dot(area))
.slip("the flow's magnitude on every patch, the tilt forgotten", |flow, area| flow.length() * area.length());

fn shapes(_: &mut Bench, passing: Passing) -> Measured {
    let n = 160;
    let surfaces = [
        ("sphere about the lamp, r = 0.01 m", 1.0, sphere(DVec3::ZERO, 0.01, n)),
        ("sphere about the lamp, r = 1 km", 1.0, sphere(DVec3::ZERO, 1000.0, n)),
        ("sphere, the lamp half way out", 1.0, sphere(DVec3::new(0.3, 0.0, 0.4), 1.0, n)),
        ("sphere, the lamp at 0.8 of the way", 1.0, sphere(DVec3::new(0.0, 0.48, -0.64), 1.0, n)),
        (
            "ellipsoid 1 : 2 : 3, the lamp aside",
            1.0,
            ellipsoid(DVec3::new(0.2, 0.4, 0.9), DVec3::new(1.0, 2.0, 3.0), n),
        ),
        ("ring, the lamp in its tube", 1.0, torus(DVec3::new(-2.1, 0.0, 0.1), 2.0, 0.5, n)),
        ("ring, the lamp in its hole", 0.0, torus(DVec3::new(0.1, 0.2, 0.0), 2.0, 0.5, n)),
        ("sphere, the lamp outside", 0.0, sphere(DVec3::new(1.0, 1.0, 1.0), 1.0, n)),
    ];
    Measured::worst(surfaces.iter().flat_map(|(name, share, patches)| {
        [Pattern::Isotropic, Pattern::Antenna].map(|pattern| {
            let found: f64 = patches.iter().map(|patch| passing(flow(pattern, patch.at), patch.area)).sum();
            (found - share, format!("{name}, {}", pattern.name()))
        })
    }))
}

/// Round windows seen from their axis, from 10⁻⁹ to 10⁹ of their radius away.
fn windows() -> Vec<Extreme> {
    let shares = [1e-9, 1e-6, 1e-3, 0.1, 1.0, 3.0, 1e2, 1e4, 1e6, 1e9];
    let each = shares.into_iter().flat_map(|distance| [0.7, 1.0, 1.3].map(|radius| (distance * radius, radius)));
    each.map(|(distance, radius)| {
        let bits = 2 * BITS;
        let (h, rho) = (precise::real_at(distance, bits), precise::real_at(radius, bits));
        let cos: Real = &h / (&h * &h + &rho * &rho).sqrt();
        let cosine = precise::to_f64(&cos);
        Extreme {
            input: format!("h = {distance:e} m, ρ = {radius} m"),
            quantity: "Ω",
            reference: precise::pi(bits) * precise::real_at(2.0, bits) * (precise::real_at(1.0, bits) - cos),
            textbook: TAU * (1.0 - distance / distance.hypot(radius)),
            ours: solid_angle::disc(radius, distance),
            // By h and by ρ, which enter through their ratio: (1 + cos ψ) cos ψ each.
            condition: 2.0 * (1.0 + cosine) * cosine,
            worst_of: 1,
        }
    })
    .collect()
}

fn cone(setting: &Setting) -> Plot {
    let alpha = setting.number("alpha").clamp(0.03, 1.2);
    // So finely that the ends of what the cone cuts out of it are in their places; a fifteenth of it draws the circle.
    let circle = |[x, y]: Spot, radius: f64| -> Vec<Spot> {
        (0..=1440)
            .map(|at| TAU * f64::from(at) / 1440.0)
            .map(|t| [x + radius * t.cos(), y + radius * t.sin()])
            .collect()
    };
    let is_lit = |[x, y]: &Spot| y.atan2(*x).abs() <= alpha;
    let surfaces =
        [([0.0, 0.0], 0.55, "1"), ([0.35, 0.15], 1.05, "2"), ([2.05, 0.0], 0.35, "ring"), ([-2.05, 0.0], 0.35, "")];
    let mut diagram = Diagram::new("", [-2.6, -1.5], [2.6, 1.5]);
    for (centre, radius, name) in surfaces {
        let rim = circle(centre, radius);
        let runs = rim.chunk_by(|one, next| is_lit(one) == is_lit(next)).filter(|run| run.len() > 1 && is_lit(&run[0]));
        diagram = diagram
            .with(Part::curve(rim.iter().step_by(15).copied().collect()).hue(Hue::Reference).label(name))
            .with_all(runs.map(|run| Part::curve(run.to_vec()).hue(Hue::Ours)));
    }
    let far = 2.55;
    let edge = |sign: f64| Part::ray([0.0; 2], [far * alpha.cos(), sign * far * alpha.sin()]).hue(Hue::P);
    Plot::of(
        "One cone through many surfaces",
        diagram
            .with(edge(1.0))
            .with(edge(-1.0))
            .with(Part::point([0.0; 2]).label("lamp"))
            .with(Part::arc([0.0; 2], 0.3, 0.0, alpha).label("α")),
    )
}
