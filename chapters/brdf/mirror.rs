//! E49, E50: mirrors, and the delta that they are.

use super::models::{METAL, METALS, THETA, metal, model, way};
use super::symbols::{DELTA, F_R, L_IN, L_R, PATCH, THETA_I};
use crate::figure::{Axis, Chart, Hue, Panel, Picture, Plot};
use crate::parameter::Setting;
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Misled, Quantity, Step, check, derivation, exhibit, figure, question,
    statement, step,
};
use equation::derivation::Chain;
use equation::expr::cos;
use equation::{Equation, Expr};
use light::bsdf::microfacet::Slopes;
use light::bsdf::{self, Bsdf};
use light::media;
use light::number::Vector;
use light::optics::Incidence;
use light::optics::fresnel::powers;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use yardstick::order;
use yardstick::quadrature::{gauss_legendre, trapezoid};
use yardstick::random::uniform;

pub(super) const EXHIBIT: Exhibit = exhibit(
    "mirror",
    &[METAL, THETA],
    &[
        figure(
            "narrowing",
            "Ever smoother metal: the lobe grows and narrows, and what it sends in all stays.",
            narrowing,
        ),
        figure(
            "swatches",
            "Metals under white light, from their indices at three wavelengths; below, seen at 85°.",
            swatches,
        ),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Mirrors",
    "A mirror's BRDF is a delta over the cosine, so that the radiance that leaves is the radiance that came.",
)
.rows(&["E49", "E50"])
.about("delta")
.statements(&[
    statement("radiance", "radiance comes back as it came, from the mirror's direction", || Equation::new(L_R, L_IN))
        .rows(&["E49"]),
    statement("delta", "a delta: 1/Ω inside a patch of directions Ω, made ever smaller, and over the cosine", || {
        Equation::new(F_R, DELTA / cos(THETA_I))
    })
    .rows(&["E50"]),
])
.derivations(&[derivation(
    "patch",
    "a patch of directions small enough to have one radiance: what must f_r be, that L_r = L_in?",
    || patch(DELTA / cos(THETA_I)),
)
.rows(&["E50"])
.slip("the cosine forgotten", || patch(DELTA.into()))])
.questions(&[question(
    "cosine",
    "A renderer's mirror returns f_r = δ, without the 1/cos θ. How bright is the picture in it at an incidence of 60°, over \
     what it should be?",
    Answer::Number {
        unit: "1",
        tolerance: 0.01,
        right: |_| {
            let wo = way(PI / 3.0, 0.0);
            // f_r cos θ is what meets the radiance: a delta times this.
            let weight = model("mirror", &bsdf::Setting::default()).sample(wo, [0.5; 3]).weight[0];
            weight * wo.z
        },
        slips: &[
            Misled { value: |_| 1.0, reply: "The cosine of E47 is still there, and nothing cancels it." },
            Misled { value: |_| 2.0, reply: "The other way round: a cosine too many darkens." },
        ],
    },
    "Half: the cosine that belongs to the irradiance is not cancelled.",
)])
.readout(|setting| {
    let theta = setting.number("theta").min(FRAC_PI_2 - 1e-6);
    let of = bsdf::Setting { metal: metal(setting.word("metal")), ..bsdf::Setting::default() };
    let [red, green, blue] = model("conductor", &of).sample(way(theta, 0.0), [0.5; 3]).weight;
    let quantity = |key, symbol, says, value| Quantity { key, symbol, says, value, unit: "1" };
    vec![
        quantity("red", "R", "reflected, of 630 nm", red),
        quantity("green", "R", "of 532 nm", green),
        quantity("blue", "R", "of 467 nm", blue),
    ]
})
.checks(&[&ONE, &LIMIT, &POLISHED]);

fn patch(last: Expr) -> Chain {
    Chain::assume(Equation::new(L_R, F_R * L_IN * cos(THETA_I) * PATCH), "E47 of a narrow patch")
        .and(Equation::new(L_R, L_IN), "a perfect mirror")
        .solve_for([F_R, L_R])
        .given(PATCH, 1 / DELTA, "δ of that patch")
        .then(Equation::new(F_R, last), ["linear solve"])
}

const ONE: Check<fn(Vector<f64>) -> Vector<f64>> =
    check("one", "a mirror draws the mirror's direction with certainty, and the delta integrates to one")
        .rows(&["E49"])
        .against("the law of reflection in the plane of wo and n, and a weight of 1 for a perfect mirror")
        .within(
            16.0,
            "ulp",
            "the reference turns by half a turn, φ + π, which rounds by an ulp of 8 at most; the weight is one product",
        )
        .of(drawn, |wo| model("mirror", &bsdf::Setting::default()).sample(wo, [0.3, 0.7, 0.1]).wi)
        .slip("straight back", |wo| wo);

fn drawn(bench: &mut Bench, mirrored: fn(Vector<f64>) -> Vector<f64>) -> Measured {
    let mirror = model("mirror", &bsdf::Setting::default());
    Measured::worst((0..100).flat_map(|_| {
        let (theta, phi) = (uniform(&mut bench.stream, 0.01, 1.55), uniform(&mut bench.stream, 0.0, TAU));
        let wo = way(theta, phi);
        let (found, there) = (mirrored(wo), way(theta, phi + PI));
        let off = ((found.x - there.x).abs()).max((found.y - there.y).abs()).max((found.z - wo.z).abs());
        let weight = mirror.sample(wo, [0.3, 0.7, 0.1]).weight[0];
        [
            (off / f64::EPSILON, format!("direction at θ = {theta:.3}")),
            ((weight - 1.0) / f64::EPSILON, format!("weight at θ = {theta:.3}")),
        ]
    }))
}

const LIMIT: Check<fn(f64) -> f64> = check(
    "limit",
    "ever smoother facets of Gaussian slopes send back ever more nearly the radiance of the mirror's direction",
)
.rows(&["E49", "E50"])
.against("a sky 1 + x/2 in the mirror's direction, against ∫ f_r L cos θ dω over the lobe by a product rule")
.order(2.0, 0.1, "the lobe is even about the mirror's direction to first order in α")
.of(smoother, |_| 1.0)
.slip("the cosine of E50 forgotten", |cos| cos);

fn smoother(_: &mut Bench, factor: fn(f64) -> f64) -> Measured {
    let (theta, wo) = (0.7, way(0.7, 0.0));
    let sky = |w: Vector<f64>| 1.0 + 0.5 * w.x;
    let exact = sky(way(theta, PI));
    let (radii, turns) = (gauss_legendre(40), trapezoid(64));
    let points: Vec<(f64, f64)> = (2..8)
        .map(|halving| {
            let alpha = 0.3 / f64::from(1 << halving);
            let of = bsdf::Setting { alpha: [alpha; 2], slopes: Slopes::Beckmann, ..bsdf::Setting::default() };
            let surface = model("rough-conductor", &of);
            // Over the facets: dω_i = 4 (ω_o·m) dω_m, and dω_m = m_z³ ds of the slopes s.
            let ring = |(u, weight): &(f64, f64)| {
                let slope = 6.0 * alpha * u;
                let along = |(v, share): &(f64, f64)| {
                    let (s, c) = (TAU * v).sin_cos();
                    let m = Vector::new(-slope * c, -slope * s, 1.0).normalised();
                    let facing = wo.dot(m);
                    let wi = m.scaled(2.0 * facing) - wo;
                    share * surface.eval(wi, wo)[0] * sky(wi) * wi.z * 4.0 * facing * m.z.powi(3)
                };
                weight * 6.0 * alpha * slope * TAU * turns.iter().map(along).sum::<f64>()
            };
            let found: f64 = radii.iter().map(ring).sum();
            (alpha, (found * factor(wo.z) / exact - 1.0).abs())
        })
        .collect();
    Measured::new(order::slope(&points).unwrap_or(f64::NAN), "α from 0.075 to 0.0023, at θ = 40°", points.len())
}

/// What a surface reflects of light to a direction, in three channels.
type Reflecting = fn(&dyn Bsdf<f64>, Vector<f64>) -> [f64; 3];

const POLISHED: Check<Reflecting> =
    check("metals", "polished metal reflects as Fresnel's equations for its index say, in all three channels")
        .rows(&["E50", "C17"])
        .against("R_n of chapter fresnel, which adds complex amplitudes")
        .within(64.0, "ulp · (1 + cond)", "two dozen roundings in real arithmetic, one square root of a modulus")
        .of(reflecting, |surface, wo| surface.sample(wo, [0.5; 3]).weight)
        .slip("R at normal incidence for all angles", |surface, _| surface.sample(way(1e-6, 0.0), [0.5; 3]).weight);

fn reflecting(_: &mut Bench, share: fn(&dyn Bsdf<f64>, Vector<f64>) -> [f64; 3]) -> Measured {
    let names = ["gold", "silver", "copper", "aluminium"];
    Measured::worst(names.into_iter().flat_map(|name| {
        let of = bsdf::Setting { metal: metal(name), ..bsdf::Setting::default() };
        let surface = model("conductor", &of);
        let angles = [0.1, 0.7, 1.2, 1.5];
        angles.into_iter().flat_map(move |theta| {
            let found = share(surface.as_ref(), way(theta, 0.0));
            let indices = metal(name);
            (0..3).map(move |channel| {
                let exact = powers(Incidence::from_angle(theta), 1.0, indices[channel]).r_n();
                // Near grazing 1 − R moves with the angle: tan θ of it.
                let error = (found[channel] / exact - 1.0) / (f64::EPSILON * (1.0 + theta.tan()));
                (error, format!("{name} at {:.0} nm, θ = {theta}", media::CHANNELS[channel] * 1e9))
            })
        })
    }))
}

fn narrowing(setting: &Setting) -> Plot {
    let theta = setting.number("theta").clamp(0.05, 1.4);
    let of = |alpha: f64| bsdf::Setting {
        alpha: [alpha; 2],
        metal: metal(setting.word("metal")),
        ..bsdf::Setting::default()
    };
    let wi = way(theta, PI);
    let axes = Chart::new(
        "",
        Axis::linear("angle of what leaves θ_o", "°").range(-90.0, 90.0).tick(30.0),
        Axis::log("f_r cos θ_o (green)", "1/sr").range(1e-3, 1e4),
    );
    let chart = [0.4, 0.1, 0.03, 0.01].into_iter().zip(0..).fold(axes, |chart, (alpha, at)| {
        let surface = model("rough-conductor", &of(alpha));
        let points = (-1780..=1780)
            .map(|step| f64::from(step) / 20.0)
            .map(|x: f64| {
                let wo = Vector::new(x.to_radians().sin(), 0.0, x.to_radians().cos());
                [x, surface.eval(wi, wo)[1] * wo.z]
            })
            .collect();
        chart.line(Hue::Nth(at), format!("α = {alpha}"), points)
    });
    Plot::of(
        format!("Light at {:.0}° on ever smoother {}", theta.to_degrees(), setting.word("metal")),
        chart.at_x(theta.to_degrees(), ""),
    )
}

/// Linear sRGB of light that has these shares at the primaries of BT.2020 (ITU-R BT.2087).
pub(super) fn display([r, g, b]: [f64; 3]) -> [f32; 3] {
    const ROWS: [[f64; 3]; 3] = [[1.6605, -0.5876, -0.0728], [-0.1246, 1.1329, -0.0083], [-0.0182, -0.1006, 1.1187]];
    ROWS.map(|row| (row[0] * r + row[1] * g + row[2] * b).clamp(0.0, 1.0) as f32)
}

fn swatches(_: &Setting) -> Plot {
    const SIDE: usize = 72;
    let swatch = |name: &str| -> Panel {
        let of = bsdf::Setting { metal: metal(name), ..bsdf::Setting::default() };
        let surface = model("conductor", &of);
        let at = |theta: f64| display(surface.sample(way(theta, 0.0), [0.5; 3]).weight);
        let (face_on, grazing) = (at(1e-3), at(85_f64.to_radians()));
        let pixels = (0..SIDE * SIDE).map(|at| if at / SIDE < SIDE * 3 / 4 { face_on } else { grazing }).collect();
        Picture::new(name, SIDE, pixels).exposed(-0.5).into()
    };
    Plot::grid("Polished metals", 6, METALS.iter().filter(|name| **name != "white").map(|name| swatch(name)).collect())
}
