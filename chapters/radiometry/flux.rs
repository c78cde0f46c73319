//! C6, E26: power through a surface.

use super::symbols::{ALPHA, AREA, FLUX, NORMAL, SURFACE};
use crate::diagram::{Behind, Diagram, Part};
use crate::figure::{Dash, Hue, Plot};
use crate::parameter::{Kind, Parameter, Setting};
use crate::symbols::{S, T};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Misled, Quantity, Step, check, exhibit, figure, question, statement, step,
};
use equation::Equation;
use equation::expr::{Range, abs, cos, dot, integral, mean, partial};
use glam::DVec3;
use light::radiometry::solid_angle::triangle;
use std::f64::consts::FRAC_PI_2;
use yardstick::quadrature::gauss_legendre;

/// Flow of energy.
const FLOW: Parameter =
    Parameter::new("flow", "⟨|S|⟩", "mean flow that meets the surface", Kind::number(0.0, 1e12, "W/m²"))
        .default("1000");
/// Tilt of the surface.
const TILT: Parameter =
    Parameter::new("alpha", "α", "angle between the flow and the normal", Kind::number(0.0, FRAC_PI_2, "rad"))
        .default("60deg");
/// Its size.
const SIZE: Parameter = Parameter::new("area", "A", "area of the surface", Kind::number(0.0, 1e12, "m²")).default("2");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "flux",
    &[FLOW, TILT, SIZE],
    &[figure("tilt", "A surface that is turned away from the flow takes out of it a narrower beam.", tilt)],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Power through a surface",
    "Of the mean flow a surface meets the part along its normal; summed over its area that is a power.",
)
.rows(&["E26"])
.statements(&[
    statement("flux", "radiant flux, in watts", || {
        Equation::new(FLUX, integral(mean(abs(S)) * cos(ALPHA), [AREA.into()], Range::Region(SURFACE)))
    }),
    statement(
        "encyclopaedia",
        "what an encyclopaedia had: the rate of an “energy” that is the flow summed over an area, and so a power already",
        || {
            let summed = integral(dot(S, NORMAL), [AREA.into()], Range::Region(SURFACE));
            Equation::new(FLUX, partial(summed, T))
        },
    )
    .rows(&["C6"])
    .struck_out(),
])
.questions(&[question(
    "share",
    "A window that faced the sun is turned away from it by 60°. Which share of the power still passes?",
    Answer::Number {
        unit: "1",
        tolerance: 0.01,
        right: |_| (FRAC_PI_2 / 1.5).cos(),
        slips: &[
            Misled {
                value: |_| 1.0 / 3.0,
                reply: "The share does not fall evenly with the angle: it is the width of the beam that the window cuts.",
            },
            Misled {
                value: |_| 0.25,
                reply: "Only one cosine: the flow itself has not changed, only how much of it the window meets.",
            },
        ],
    },
    "The window cuts a beam as wide as its shadow across the flow: cos 60° of its area.",
)])
.readout(|setting| {
    let cos = setting.number("alpha").cos();
    let flow = setting.number("flow");
    let quantity = |key, symbol, says, value, unit| Quantity { key, symbol, says, value, unit };
    vec![
        quantity("through", "⟨|S|⟩ cos α", "power on a unit of the surface", flow * cos, "W/m²"),
        quantity("flux", "Φ", "power through all of it", flow * cos * setting.number("area"), "W"),
    ]
})
.checks(&[&WINDOW]);

/// How much of a flow passes a surface of this unit normal [W/m²].
type Passing = fn(DVec3, DVec3) -> f64;

const WINDOW: Check<Passing> = check(
    "window",
    "what passes a window, however it is turned, is what goes into its cone",
)
.against(
    "I Ω, the lamp's intensity times the solid angle of two triangles (Van Oosterom and Strackee 1983), against \
         ∫⟨|S|⟩ cos α dA by Gauss's rule",
)
.within(
    1e-10,
    "1",
    "the window is at least as far as it is wide: 24 points a side leave (1/(1+√2))⁴⁸ ~ 10⁻¹⁸ of an analytic \
         integrand, times at most 10⁴ for the edge-on ones, and rounding",
)
.of(windows, |flow, normal| flow.dot(normal).abs())
.slip("the flow's magnitude, cos α forgotten", |flow, _| flow.length());

fn windows(bench: &mut Bench, passing: Passing) -> Measured {
    let rule = gauss_legendre(24);
    let mut even = || yardstick::random::uniform(&mut bench.stream, -1.0, 1.0);
    let mut place = || DVec3::new(even(), even(), even());
    Measured::worst((0..60).map(|_| {
        let (middle, a, b) = (place().normalize() * 2.0, 0.5 * place(), 0.5 * place());
        let across = a.cross(b);
        let (normal, size) = (across.normalize(), across.length());
        let flow = |at: DVec3| at / at.length().powi(3);
        let row = |(v, weight): &(f64, f64)| -> f64 {
            let cell = |(u, share): &(f64, f64)| share * passing(flow(middle + (u - 0.5) * a + (v - 0.5) * b), normal);
            weight * rule.iter().map(cell).sum::<f64>()
        };
        let through = size * rule.iter().map(row).sum::<f64>();
        let corner = |u: f64, v: f64| (middle + (u - 0.5) * a + (v - 0.5) * b).to_array();
        let halves = [
            [corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0)],
            [corner(0.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0)],
        ];
        let cone: f64 = halves.map(|[a, b, c]| triangle(a, b, c).abs()).iter().sum();
        let tilt = (middle.dot(normal) / 2.0).abs().acos().to_degrees();
        (through / cone - 1.0, format!("α = {tilt:.1}° in the middle, {size:.3} m²"))
    }))
}

fn tilt(setting: &Setting) -> Plot {
    let alpha = setting.number("alpha");
    let (sin, cos) = alpha.sin_cos();
    let half = 0.8;
    let edge = [half * sin, half * cos];
    let height = |share: f64| share * half * cos;
    let start = -1.7;
    // Rays at even distances; those between the rims meet the surface.
    let ray = |at: i32| {
        let y = f64::from(at) / 4.0;
        let meets = y.abs() < half * cos;
        let end = if meets { y * sin / cos.max(1e-9) } else { 1.7 };
        let part = Part::ray_with_heads([start, y], [end, y], if meets { &[0.4] } else { &[0.2] });
        part.hue(if meets { Hue::Ours } else { Hue::Reference })
    };
    let normal = [-0.75 * cos, 0.75 * sin];
    let diagram = Diagram::new("", [-1.9, -1.2], [1.9, 1.2])
        .with_all((-4..=4).map(ray))
        .with(Part::surface([-edge[0], -edge[1]], edge, Behind::Hatched).label("A"))
        .with(Part::vector([0.0; 2], normal).label("n"))
        .with(Part::line([0.0; 2], [-0.9, 0.0]).dash(Dash::Dashed))
        .with(Part::arc([0.0; 2], 0.45, std::f64::consts::PI - alpha, std::f64::consts::PI).label("α"))
        .with(Part::line([-1.45, -height(1.0)], [-1.45, height(1.0)]).hue(Hue::P).label("A cos α"));
    Plot::of(format!("What a surface takes of a flow at α = {:.0}°", alpha.to_degrees()), diagram)
}
