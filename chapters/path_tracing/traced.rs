//! The lecture's oldest question: what did we trace?

use super::scenes::{greens, lit, rendered};
use crate::diagram::{Behind, Diagram, Part};
use crate::figure::{Hue, Plot};
use crate::parameter::Setting;
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Step, check, choice, exhibit, figure, question, step,
};
use light::radiometry;
use light::transport::simple::INTEGRATORS;
use light::transport::{Manner, Method};
use std::f64::consts::PI;

pub(super) const EXHIBIT: Exhibit = exhibit(
    "traced",
    &[],
    &[figure("chain", "What goes along a path: one number a channel, and what each chapter has to say of it.", chain)],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "What did we trace?",
    "Not photons, not fields, not Poynting's vector: radiance, the one quantity of them that a ray does not change.",
)
.rows(&["E53"])
.questions(&[question(
    "what",
    "A ray goes from a wall to the camera, and the same number is at both of its ends, whatever its length. Which number?",
    Answer::Choice {
        options: &[
            choice("the amplitude of the electric field", "It falls as 1/r from every point of the wall."),
            choice("the magnitude of Poynting's vector", "It falls as 1/r²: twice as far, a quarter of the flow."),
            choice("the number of photons that arrive per second", "That is a flux: so many per square metre, and those thin out as the flow does."),
            choice("the radiance", ""),
        ],
        right: |_| {
            // A lamp of 1 W and a wall, from one metre and from twice as far.
            let flow = |r| radiometry::point(1.0, r, 0.0).unwrap_or(f64::NAN);
            let ratios = [(flow(1.0) / flow(2.0)).sqrt(), flow(1.0) / flow(2.0), flow(1.0) / flow(2.0), seen(0.5) / seen(1.0)];
            ratios.iter().position(|ratio| (ratio - 1.0).abs() < 1e-3).unwrap_or(0)
        },
        slip: |_| 1,
    },
    "Fields made it, Poynting's vector carries it, photons deliver it. What a ray keeps is radiance.",
)])
.checks(&[&KEPT]);

/// The radiance [W m⁻² sr⁻¹] of a spot of the lit floor, by a camera so far away [m].
fn seen(away: f64) -> f64 {
    let (scene, _) = lit([0.9, 0.2], 1.0, away, 1);
    greens(&rendered(&scene, &Manner { method: Method::Simple(&INTEGRATORS[2]), ..Manner::default() }, 16)).mean()
}

const KEPT: Check<fn(f64, f64) -> f64> =
    check("kept", "a spot of the floor is as bright from a metre away as from a millimetre")
        .against("the same paths from the same spot, 2 µm wide, by cameras at 1 mm to 1.5 m")
        .within(1e-4, "1", "2 µm of a floor whose light changes over a metre, and single numbers in the picture")
        .of(
            |_: &mut Bench, arrives: fn(f64, f64) -> f64| {
                let near = arrives(seen(1e-3), 1e-3);
                let cases =
                    [0.01, 0.1, 0.5, 1.5].map(|away| (arrives(seen(away), away) / near - 1.0, format!("{away} m")));
                Measured::worst(cases)
            },
            |radiance, _| radiance,
        )
        .slip("thinned out by the square of the distance", |radiance, away| radiance / (4.0 * PI * away * away));

fn chain(_: &Setting) -> Plot {
    let [eye, floor, wall, lamp] = [[-3.6, 1.9], [-0.6, 0.0], [2.6, 1.5], [0.9, 2.9]];
    let diagram = Diagram::new("", [-4.2, -0.8], [4.4, 3.5])
        .with(Part::surface([-4.2, 0.0], [2.6, 0.0], Behind::Hatched))
        .with(Part::surface([2.6, 0.0], [2.6, 3.4], Behind::Hatched))
        .with(Part::surface([0.4, 2.9], [1.4, 2.9], Behind::Nothing).hue(Hue::P).label("lamp"))
        .with(Part::ray_with_heads(lamp, wall, &[0.6]).hue(Hue::Ours))
        .with(Part::ray_with_heads(wall, floor, &[0.55]).hue(Hue::Ours))
        .with(Part::ray_with_heads(floor, eye, &[0.55]).hue(Hue::Ours))
        .with(Part::point(eye).label("eye"))
        .with(Part::point(floor).hue(Hue::Ours))
        .with(Part::point(wall).hue(Hue::Ours))
        .with(Part::note([1.9, 2.5], "L_e").hue(Hue::Ours))
        .with(Part::note([0.7, 0.4], "w_1 L_e").hue(Hue::Ours))
        .with(Part::note([-2.2, 1.5], "w_2 w_1 L_e").hue(Hue::Ours))
        .with(Part::note([-4.0, -0.5], "w = f_r cos θ/p at each corner; nothing on the way").hue(Hue::Reference));
    Plot::of("The light's way, which the path goes backwards", diagram)
}
