//! E29, E30: what a source sends in one direction.

use super::symbols::{FLUX, INTENSITY, RADIUS, S_R, SOLID_ANGLE, THETA};
use crate::figure::{Axis, Chart, Hue, Plot};
use crate::parameter::{Kind, Parameter, Setting};
use crate::plane_wave::fields::Dipole;
use crate::symbols::{R, S};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Misled, Quantity, Step, check, derivation, exhibit, figure, question,
    statement, step,
};
use equation::derivation::Chain;
use equation::expr::{Range, cos, divergence, dot, integral, integral_between, partial, pi, ratio, sin, sqrt};
use equation::{Equation, Expr};
use glam::DVec3;
use light::radiometry::pattern::Pattern;
use light::radiometry::solid_angle;
use std::f64::consts::{PI, TAU};
use yardstick::order;
use yardstick::quadrature::{gauss_legendre, trapezoid};

/// What the source sends in all.
const POWER: Parameter =
    Parameter::new("flux", "Φ", "what the source sends in all", Kind::number(0.0, 1e12, "W")).default("100");
/// Where it is looked at from.
const POLAR: Parameter =
    Parameter::new("theta", "θ", "angle to its normal or axis", Kind::number(0.0, PI, "rad")).default("40deg");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "intensity",
    &[POWER, POLAR],
    &[figure("patterns", "The same flux, shared in three ways among the directions.", patterns)],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "What goes one way",
    "Flow times r² no longer depends on the distance: it belongs to the source and the direction.",
)
.rows(&["E29", "E30"])
.statements(&[
    statement("intensity", "radiant intensity, in W/sr", || Equation::new(INTENSITY, S_R * RADIUS.pow(2)))
        .rows(&["E29"]),
    statement("flux", "all directions together", || {
        Equation::new(FLUX, integral(INTENSITY, [SOLID_ANGLE.into()], Range::Closed))
    })
    .rows(&["E30"]),
    statement("density", "and in one of them", || Equation::new(INTENSITY, partial(FLUX, SOLID_ANGLE))).rows(&["E30"]),
])
.derivations(&[
    derivation(
        "inverse_square",
        "in empty space nothing is lost on the way, and that makes the radial flow fall as 1/r²",
        || inverse_square(squared() * sqrt(squared())),
    )
    .rows(&["E29"])
    .slip("a flow that falls as 1/r", || inverse_square(squared())),
    derivation("cone", "in a cone that widens by dθ: what it gains in power over what it gains in angle", || {
        cone(INTENSITY.into())
    })
    .rows(&["E30"])
    .slip("the angle θ itself for the solid angle", || cone(2 * pi() * sin(THETA) * INTENSITY)),
    derivation(
        "antenna",
        "a short antenna sends sin² θ: two thirds of what its best direction would send everywhere",
        || antenna(ratio(8, 3) * pi() * INTENSITY),
    )
    .rows(&["E30"])
    .slip("the mean of sin² over θ for that over directions", || antenna(2 * pi() * INTENSITY)),
])
.questions(&[question(
    "lambert",
    "A lamp that sends alike everywhere is replaced by a flat one that sends as cos θ, and only to its front; both send \
     the same flux. How many times brighter is the flat one straight ahead?",
    Answer::Number {
        unit: "1",
        tolerance: 0.01,
        right: |_| Pattern::Lambertian.intensity(1.0, 1.0) / Pattern::Isotropic.intensity(1.0, 1.0),
        slips: &[
            Misled {
                value: |_| 2.0,
                reply: "Half the directions make it twice as bright; the cosine then takes as much from the sides again.",
            },
            Misled { value: |_| 8.0, reply: "The mean of cos θ over the hemisphere is a half, not a quarter." },
        ],
    },
    "Φ/π against Φ/4π: twice for the half that is dark, and twice again for the mean of cos θ.",
)])
.readout(|setting| {
    let (flux, cos) = (setting.number("flux"), setting.number("theta").cos());
    let quantity = |key, symbol, says, pattern: Pattern| {
        Quantity { key, symbol, says, value: pattern.intensity(flux, cos), unit: "W/sr" }
    };
    vec![
        quantity("I_isotropic", "I_{iso}", "of a source that sends alike everywhere", Pattern::Isotropic),
        quantity("I_lambertian", "I_L", "of a flat one that sends as cos θ", Pattern::Lambertian),
        quantity("I_antenna", "I_a", "of a short antenna along the axis", Pattern::Antenna),
    ]
})
.checks(&[&DISTANCES, &CONES]);

/// r², of a place.
fn squared() -> Expr {
    dot(R, R)
}

fn inverse_square(fall: Expr) -> Chain {
    Chain::new(divergence(S))
        .given(S, INTENSITY * R / fall, "S = I/r², outwards")
        .then(Expr::from(0), ["∂(1/r³)", "∇·r = 3"])
}

fn cone(last: Expr) -> Chain {
    Chain::new(partial(FLUX, THETA) / partial(SOLID_ANGLE, THETA))
        .given(partial(FLUX, THETA), 2 * pi() * sin(THETA) * INTENSITY, "the ring at θ")
        .given(SOLID_ANGLE, 2 * pi() * (1 - cos(THETA)), "Ω of a cone")
        .then(last, ["Ω of a cone"])
}

fn antenna(last: Expr) -> Chain {
    let ring = || 2 * pi() * INTENSITY * sin(THETA).pow(2) * sin(THETA);
    Chain::new(integral_between(ring(), THETA, 0, pi()))
        .primitive(2 * pi() * INTENSITY * (cos(THETA).pow(3) / 3 - cos(THETA)), THETA)
        .then(last, ["sin² = 1 − cos²"])
}

const DISTANCES: Check<fn(f64) -> f64> = check(
    "distances",
    "the mean flow of an antenna along the radius, times r², is the same near and far",
)
.rows(&["E29"])
.against("p²ω⁴μ sin² θ/(32π² v) of the far field (Jackson (9.23)) against the mean of E×B/μ of the whole field (9.18)")
.within(
    1e-11,
    "1",
    "at r = 0.1/k fields a thousand times larger cancel, and at r = 10⁴/k the phase is rounded to 10⁻¹²",
)
.of(distances, |r| r * r)
.slip("r for r²", |r| r);

fn distances(_: &mut Bench, growth: fn(f64) -> f64) -> Measured {
    let dipole = Dipole { speed: 1.0 };
    let places = [0.1, 0.3, 1.0, 10.0, 1e3, 1e4].into_iter().flat_map(|r| [0.2, 0.9, 1.5].map(|theta| (r, theta)));
    Measured::worst(places.map(|(r, theta): (f64, f64)| {
        let n = DVec3::new(theta.sin(), 0.0, theta.cos());
        let moments = 8;
        let flow = |time: f64| dipole.e(r * n, time).cross(dipole.b(r * n, time)).dot(n);
        let mean =
            (0..moments).map(|at| flow(TAU * f64::from(at) / f64::from(moments))).sum::<f64>() / f64::from(moments);
        // p/(4πε) = k = v = 1 makes p²ω⁴μ/(32π² v) a half.
        (mean * growth(r) / (0.5 * theta.sin().powi(2)) - 1.0, format!("kr = {r}, θ = {theta}"))
    }))
}

const CONES: Check<fn(f64) -> f64> =
    check("cones", "the flux of ever narrower cones over their solid angle is the intensity in their middle")
        .rows(&["E30"])
        .against("sin² θ at θ = 1, against what goes into cones about it, by product rules")
        .order(2.0, 0.02, "the pattern is smooth: what is odd about the middle cancels, and the square is left")
        .of(cones, solid_angle::cone)
        .slip("the opening taken for half of it", |half| solid_angle::cone(2.0 * half));

fn cones(_: &mut Bench, angle: fn(f64) -> f64) -> Measured {
    let middle = DVec3::new(1.0_f64.sin(), 0.0, 1.0_f64.cos());
    let (across, aside) = (DVec3::Y.cross(middle), DVec3::Y);
    let exact = Pattern::Antenna.intensity(1.0, middle.z);
    let (rings, turns) = (gauss_legendre(8), trapezoid(16));
    let points: Vec<(f64, f64)> = (1..8)
        .map(|halving| {
            let half = 0.5 / f64::from(1 << halving);
            // z from cos α to 1, of which 1 − z is small.
            let cap = solid_angle::cone(half) / TAU;
            let ring = |(u, weight): &(f64, f64)| {
                let low = u * cap;
                let sin = (low * (2.0 - low)).sqrt();
                let along = |(v, share): &(f64, f64)| {
                    let (s, c) = (TAU * v).sin_cos();
                    let way = middle * (1.0 - low) + sin * (c * across + s * aside);
                    share * Pattern::Antenna.intensity(1.0, way.z)
                };
                weight * TAU * cap * turns.iter().map(along).sum::<f64>()
            };
            let through: f64 = rings.iter().map(ring).sum();
            (half, (through / angle(half) - exact).abs())
        })
        .collect();
    let found = order::slope(&points).unwrap_or(f64::NAN);
    Measured::new(found, format!("half-angles from {:.2} to {:.4} rad", points[0].0, points[6].0), points.len())
}

fn patterns(setting: &Setting) -> Plot {
    let (flux, theta) = (setting.number("flux"), setting.number("theta"));
    // In units of Φ/4π, the isotropic one's: the same picture for every flux.
    let curve = |pattern: Pattern| -> Vec<[f64; 2]> {
        let unit = Pattern::Isotropic.intensity(1.0, 1.0);
        let at = |step: i32| PI * f64::from(step) / 180.0;
        (-180..=180)
            .map(at)
            .map(|t| (t, pattern.intensity(1.0, t.cos()) / unit))
            .map(|(t, i)| [i * t.sin(), i * t.cos()])
            .collect()
    };
    let chart = Chart::new(
        "",
        Axis::linear("I across the axis, over Φ/4π", "").range(-4.8, 4.8).tick(1.0),
        Axis::linear("I along the axis, over Φ/4π", "").range(-1.4, 4.4).tick(1.0),
    )
    .line(Hue::Nth(0), "alike everywhere", curve(Pattern::Isotropic))
    .line(Hue::Nth(1), "as cos θ, from a flat lamp", curve(Pattern::Lambertian))
    .line(Hue::Nth(2), "as sin² θ, from an antenna", curve(Pattern::Antenna))
    .dashed(
        Hue::Reference,
        format!("θ = {:.0}°", theta.to_degrees()),
        vec![[0.0; 2], [4.2 * theta.sin(), 4.2 * theta.cos()]],
    );
    Plot::of(format!("{flux} W, shared in three ways"), chart)
}
