//! E52: what arrives has left another surface.

use super::rooms::{network, unequal};
use super::symbols::{F_R, L_E, L_IN, L_O, OMEGA, THETA};
use crate::diagram::{Behind, Diagram, Part};
use crate::figure::{Dash, Hue, Plot};
use crate::parameter::{Kind, Parameter, Setting};
use crate::path_tracing::one_ray::judged;
use crate::path_tracing::ways::smallest;
use crate::plane_wave::fields::direction;
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Quantity, Step, check, choice, exhibit, figure, question, statement, step,
};
use equation::Equation;
use equation::expr::{Range, cos, integral};
use glam::DVec3;
use light::radiosity::exact::{Wall, sphere};
use light::radiosity::{Light, Network, solve};
use std::f64::consts::FRAC_PI_2;
use yardstick::directions::Domain;
use yardstick::random::{Stream, uniform};
use yardstick::statistics::Moments;

const BOUNCES: Parameter =
    Parameter::new("bounces", "k", "how often the question is asked again", Kind::Count { min: 1, max: 6 })
        .default("3");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "rendering",
    &[BOUNCES],
    &[figure(
        "question",
        "What arrives here has left there, and what left there had arrived from elsewhere. One way out of all, asked again at \
         each end.",
        asked,
    )],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Everything lights everything",
    "What leaves a place is what it sends out by itself and what it sends back; and what arrives has left another place.",
)
.rows(&["E52"])
.statements(&[statement("rendering", "what leaves: by itself, and of what arrives, in W/(sr m²)", || {
    Equation::new(L_O, L_E + integral(L_IN * cos(THETA) * F_R, [OMEGA.into()], Range::Whole))
})])
.questions(&[question(
    "unknown",
    "L_o at a place follows from L_in there. What is L_in?",
    Answer::Choice {
        options: &[
            choice("the light of the lamps", "They are one part of it: what walls send back arrives as well."),
            choice("L_o of the place that is seen in that direction", ""),
            choice("the irradiance, divided by π", "So much only if it comes evenly from everywhere."),
        ],
        right: |_| {
            // In the unequal room the floor is lit by dark walls too: more arrives than lamps alone send.
            let (_, network, light) = network(&unequal(), 1);
            let all = solve::direct(&network, &light);
            usize::from(network.arriving(2, &all) > 1.01 * network.arriving(2, &light.emitted))
        },
        slip: |_| 0,
    },
    "Radiance does not change on its way, so the unknown on the left is, elsewhere, the unknown under the integral.",
)])
.readout(|_| {
    let (_, network, light) = network(&unequal(), 1);
    let all = solve::direct(&network, &light);
    let quantity = |key, symbol, says, value| Quantity { key, symbol, says, value, unit: "W/(m² sr)" };
    vec![
        quantity("lamps", "L_1", "of a floor in a room with two bright walls: what the lamps alone make of it",
            light.emitted[2] + light.reflected(2) * network.arriving(2, &light.emitted)),
        quantity("all", "L", "and all that bounces", all[2]),
    ]
})
.checks(&[&RAYS, &BALANCE]);

/// What leaves, of what is sent out, the reflectance and what arrives.
type Leaves = fn(f64, f64, f64) -> f64;

/// A sphere's cap above z = 0.4 and the rest of it.
const CAP: (f64, Wall, Wall) = (0.3, Wall { absorbed: 0.4, emitted: 1.0 }, Wall { absorbed: 0.15, emitted: 0.1 });

const RAYS: Check<Leaves> = check(
    "rays",
    "in a sphere of two kinds of wall the known radiance is what each place sends out and sends back, seen by rays",
)
.against("Σ L_e/Σ a of the sphere, against the mean over 20 000 rays from each of four places, as the cosine draws them (t-tests)")
.significant(1e-3)
.of(
    |bench: &mut Bench, leaves: Leaves| {
        let (share, cap, rest) = CAP;
        let known = sphere(&[(share, cap), (1.0 - share, rest)]);
        // The cap's area is its height over the diameter.
        let of = |place: DVec3| usize::from(place.z < 1.0 - 2.0 * share);
        let walls = [cap, rest];
        let tests = (0..4).map(|_| {
            let here = direction(&mut bench.stream);
            let (wall, mut found) = (walls[of(here)], Moments::default());
            for _ in 0..20_000 {
                let there = chord(here, &mut bench.stream);
                found.extend([leaves(wall.emitted, 1.0 - wall.absorbed, known[of(there)])]);
            }
            judged(&found, known[of(here)])
        });
        smallest(tests.collect())
    },
    |emitted, rho, arriving| emitted + rho * arriving,
)
.slip("what is sent out by itself dimmed by ρ as well", |emitted, rho, arriving| rho * (emitted + arriving));

/// Where a ray ends that starts at a place of the unit sphere, inward, drawn by the cosine.
fn chord(here: DVec3, dice: &mut Stream) -> DVec3 {
    let normal = -here;
    let (x, y) = normal.any_orthonormal_pair();
    let [u, v] = [(); 2].map(|()| uniform(dice, 0.0, 1.0));
    let [a, b, c] = Domain::Cosine.at([u, v]);
    let way = a * x + b * y + c * normal;
    here - 2.0 * here.dot(way) * way
}

/// What a patch absorbs, of the network, its light, the solution and the patch.
type Absorbs = fn(&Network, &Light, &[f64], usize) -> f64;

const BALANCE: Check<Absorbs> = check("balance", "a closed room absorbs all that its lamps send: the equation keeps energy")
    .against("Σ A L_e of the lamps, against Σ A a of what arrives, in a room of unequal walls")
    .within(1e-12, "1", "a few hundred patches' sums, and what form factors miss of 1: their sixteen terms' roundings over the area of a patch")
    .of(
        |_: &mut Bench, absorbs: Absorbs| {
            Measured::worst([1, 4].map(|n| {
                let (_, network, light) = network(&unequal(), n);
                let found = solve::direct(&network, &light);
                let sum = |of: &dyn Fn(usize) -> f64| (0..network.len()).map(|at| network.areas[at] * of(at)).sum::<f64>();
                let sent = sum(&|at| light.emitted[at]);
                (sum(&|at| absorbs(&network, &light, &found, at)) / sent - 1.0, format!("{n} × {n} patches a wall"))
            }))
        },
        |network, light, found, at| light.absorbed[at] * network.arriving(at, found),
    )
    .slip("a share of what leaves, not of what arrives", |_, light, found, at| light.absorbed[at] * found[at]);

fn asked(setting: &Setting) -> Plot {
    let bounces = setting.number("bounces") as usize;
    // A room in section; from the floor to walls and on, and at last a lamp.
    let [low, high] = [[-3.0, 0.0], [3.0, 3.0]];
    let corners = [[low[0], low[1]], [high[0], low[1]], [high[0], high[1]], [low[0], high[1]]];
    let stops = [[-0.6, 0.0], [3.0, 1.9], [-1.4, 3.0], [-3.0, 1.2], [1.6, 0.0], [2.2, 3.0], [-3.0, 2.1]];
    let eye = [-2.3, 1.0];
    let names = ["L_o", "L_{in}, that was L_o", "and so on"];
    let walls = (0..4).map(|at| Part::surface(corners[(at + 1) % 4], corners[at], Behind::Nothing));
    let hops = stops.windows(2).take(bounces).enumerate().map(|(at, pair)| {
        let part = Part::ray_with_heads(pair[1], pair[0], &[0.55]).hue(Hue::Nth(at.min(3) as u8));
        if at < 2 { part.label(names[at + 1]) } else { part }
    });
    let fan = stops.iter().take(bounces).flat_map(|at| {
        // About the wall's normal.
        let inward = match at {
            [x, _] if *x == low[0] => 0.0,
            [x, _] if *x == high[0] => 2.0 * FRAC_PI_2,
            [_, y] if *y == low[1] => FRAC_PI_2,
            _ => -FRAC_PI_2,
        };
        (-2..=2).map(move |k| {
            let angle = inward + 0.4 * FRAC_PI_2 * f64::from(k);
            let end = [at[0] + 0.45 * angle.cos(), at[1] + 0.45 * angle.sin()];
            Part::line(*at, end).hue(Hue::Reference).dash(Dash::Dotted)
        })
    });
    let diagram = Diagram::new("", [-3.5, -0.5], [3.5, 3.5])
        .with_all(walls)
        .with_all(fan)
        .with_all(hops)
        .with(Part::ray_with_heads(stops[0], eye, &[0.6]).hue(Hue::Ours).label(names[0]))
        .with(Part::point(eye).label("eye"))
        .with_all(stops.iter().take(bounces + 1).map(|at| Part::point(*at)))
        .with(Part::line([0.2, 2.95], [1.2, 2.95]).hue(Hue::P).label("lamp"));
    Plot::of("What arrives has left elsewhere", diagram)
}
