//! E53: one new ray instead of an integral.

use super::scenes::{greens, lit, rendered, runs, under_the_sky};
use super::symbols::{F_R, L, L_E, L_IN, OMEGA, P, RHO, THETA, X};
use crate::diagram::{Behind, Diagram, Part};
use crate::figure::{Dash, Hue, Plot};
use crate::parameter::{Kind, Parameter, Setting};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Extreme, Measured, Misled, Quantity, Step, check, derivation, exhibit, figure,
    question, statement, step, stress,
};
use equation::derivation::Chain;
use equation::expr::{Range, cos, integral, integral_between, pi, sin};
use equation::{Equation, Expr};
use light::bsdf::{Rgb, rgb};
use light::geometry::Ray;
use light::sampling::{Choice, warp};
use light::transport::simple::{INTEGRATORS, Integrator, Numbers, carried, gathered};
use light::transport::{Manner, Method, Stage};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use yardstick::precise;
use yardstick::statistics::{Moments, t_test};

/// The direction that is drawn.
const TURN: Parameter =
    Parameter::new("theta", "θ", "angle of the new ray to the normal", Kind::number(-FRAC_PI_2, FRAC_PI_2, "rad"))
        .default("35deg");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "one_ray",
    &[TURN],
    &[figure(
        "second_eye",
        "Ray 1 meets a floor whose light we do not know. Ray 2 goes to look: its start is a new eye.",
        second_eye,
    )],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "One new ray",
    "An integral that nobody can do is the mean of f L cos θ/p over directions drawn with density p: one of them is enough.",
)
.rows(&["E53"])
.about("estimate")
.statements(&[
    statement("seen", "what the camera's ray sees, and the light in it that is not known", || {
        Equation::new(L, L_E + integral(F_R * L_IN * cos(THETA), [OMEGA.into()], Range::Whole))
    }),
    statement("estimate", "what one direction says of the integral, in the integral's own unit", || {
        Equation::new(X, F_R * L_IN * cos(THETA) / P)
    }),
])
.derivations(&[
    derivation("mean", "what a direction adds to the mean, X p dω, is what it adds to the integral: p cancels", || {
        mean(F_R * L_IN * cos(THETA))
    })
    .slip("cos θ forgotten", || mean(F_R * L_IN)),
    derivation(
        "second_moment",
        "directions drawn evenly, p = 1/2π, over a floor f_r = ρ/π under a sky of one radiance: ⟨X²⟩ is 4/3 of ⟨X⟩²",
        || second_moment(4 * RHO.pow(2) * L_IN.pow(2) / 3),
    )
    .slip("as if every direction said the mean", || second_moment(RHO.pow(2) * L_IN.pow(2))),
])
.questions(&[question(
    "weight",
    "A direction is drawn evenly over the hemisphere. By which number of steradians must f L cos θ of it be multiplied?",
    Answer::Number {
        unit: "1",
        tolerance: 0.01,
        right: |_| 1.0 / warp::uniform_hemisphere([0.3, 0.6]).1,
        slips: &[
            Misled { value: |_| 1.0, reply: "Then the answer would be a mean over directions, not a sum over them." },
            Misled { value: |_| PI, reply: "π is what directions count that the cosine has drawn, and the cosine is then gone." },
            Misled { value: |_| 2.0 * TAU, reply: "Half of the sphere lies under the floor." },
        ],
    },
    "1/p = 2π: each direction stands for the whole hemisphere.",
)])
.readout(|setting| {
    let cos = setting.number("theta").cos();
    let quantity = |key, symbol, says, value, unit| Quantity { key, symbol, says, value, unit };
    vec![
        quantity("even", "X/ρL", "what this direction says, of directions drawn evenly", 2.0 * cos, "1"),
        quantity("density", "p", "their density", 1.0 / TAU, "1/sr"),
    ]
})
.checks(&[&MEAN, &SCATTER])
.stress(&[stress("zenith", "directions drawn close to the normal and close to the floor", zeniths)
    .textbook("sin θ = √(1 − z²) with z = 1 − u")
    .against("the same in arbitrary precision")]);

/// What a direction adds to ⟨X⟩ = ∫Xp dω.
fn mean(last: Expr) -> Chain {
    Chain::new(X * P).given(X, F_R * L_IN * cos(THETA) / P, "the estimate").then(last, ["the estimate", "p cancels"])
}

/// ∫X² p dω with p = 1/2π and f = ρ/π, in rings of 2π sin θ dθ.
fn second_moment(last: Expr) -> Chain {
    let ring = |x: Expr| integral_between(x * sin(THETA), THETA, 0, pi() / 2);
    let one = || F_R * L_IN * cos(THETA) / P;
    Chain::new(ring(one().pow(2) * P * 2 * pi()))
        .given(F_R, RHO / pi(), "Lambert's floor")
        .given(P, 1 / (2 * pi()), "drawn evenly")
        .primitive(-4 * RHO.pow(2) * L_IN.pow(2) * cos(THETA).pow(3) / 3, THETA)
        .then(last, ["∂ cos³ θ = −3 cos² θ sin θ"])
}

const MEAN: Check<&'static Integrator> = check(
    "floor",
    "one new ray from the floor, drawn evenly and weighed with 2π cos θ, finds on average what a lamp sends there",
)
.against("ρE/π with Lambert's closed form of a square lamp, against 64 independent pictures of one pixel (t-test)")
.significant(1e-3)
.of(
    |_: &mut Bench, integrator: &'static Integrator| {
        let (scene, exact) = lit([0.9, 0.2], 1.0, 0.005, 1);
        let found = runs(64, &scene, Manner { method: Method::Simple(integrator), ..Manner::default() }, 64);
        judged(&found, exact)
    },
    &INTEGRATORS[0],
)
.slip("the cosine forgotten", &FLAT);

/// The notes' integrator with its weight wrong.
const FLAT: Integrator = Integrator {
    name: "flat",
    about: "directions all alike, their cosine forgotten",
    fits: |_| true,
    radiance: |stage: &Stage<f64>, mut ray: Ray<f64>, numbers: &mut Numbers<'_>, depth: u32| -> Rgb<f64> {
        let (mut light, mut carries) = ([0.0; 3], [1.0; 3]);
        for _ in 0..depth {
            let Some(vertex) = stage.meet(&ray) else { return gathered(light, carries, stage.sky(&ray)) };
            light = gathered(light, carries, vertex.emitted());
            let [u, v, _] = numbers.of_next_vertex().surface;
            let (wi, pdf) = warp::uniform_hemisphere([u, v]);
            let f = vertex.f(wi);
            carries = carried(carries, rgb(|c| f[c] / pdf));
            ray = stage.leave(&vertex, vertex.frame.outward(wi));
        }
        light
    },
};

/// A t-test of numbers against what they should be on average.
pub(crate) fn judged(found: &Moments, exact: f64) -> Measured {
    let at = format!("mean {:.5} ± {:.5}, exact {exact:.5}", found.mean(), found.standard_error());
    Measured::new(t_test(found, exact).p, at, found.count() as usize)
}

const SCATTER: Check<fn() -> f64> = check("scatter", "one direction of those says the mean ± 58 %")
    .against("⟨X²⟩/⟨X⟩² = 4/3 as derived, against 32 768 single directions (t-test)")
    .significant(1e-3)
    .of(
        |_: &mut Bench, moment: fn() -> f64| {
            let manner =
                Manner { method: Method::Simple(&INTEGRATORS[0]), choice: Choice::Independent, ..Manner::default() };
            let samples = rendered(&under_the_sky(1.0, 128), &manner, 1);
            // Under a white sky a white floor's mean is 1.
            let squares: Moments = samples.iter().flatten().map(|half| f64::from(half[1]).powi(2)).collect();
            let mut measured = judged(&squares, moment());
            measured.at = format!("⟨X²⟩: {}; ⟨X⟩ = {:.4}", measured.at, greens(&samples).mean());
            measured
        },
        || 4.0 / 3.0,
    )
    .slip("as if every direction said the mean", || 1.0);

fn zeniths(_: &Setting) -> Vec<Extreme> {
    let numbers = [1e-300, 1e-30, 1e-18, 1e-12, 1e-6, 0.3, 1.0 - 1e-9, 1.0 - f64::EPSILON / 2.0];
    numbers
        .map(|u: f64| {
            let ([one, two], exact) = ([1.0, 2.0].map(precise::real), precise::real(u));
            let z = &one - &exact;
            let up = 1.0 - u;
            Extreme {
                input: format!("u = {u:e}"),
                quantity: "sin θ",
                reference: (&exact * (&two - &exact)).sqrt(),
                textbook: (1.0 - up * up).sqrt(),
                ours: warp::uniform_hemisphere([u, 0.0]).0.x,
                condition: precise::to_f64(&(&z / (&two - &exact))),
                worst_of: 1,
            }
        })
        .into()
}

fn second_eye(setting: &Setting) -> Plot {
    let theta = setting.number("theta");
    let (eye, spot) = ([-3.4, 2.0], [0.0, 0.0]);
    let end = [3.0 * theta.sin(), 3.0 * theta.cos()];
    let dome = (0..=60).map(|k| PI * f64::from(k) / 60.0).map(|t| [1.2 * t.cos(), 1.2 * t.sin()]).collect();
    let diagram = Diagram::new("", [-4.0, -0.7], [4.0, 3.3])
        .with(Part::surface([-4.0, 0.0], [4.0, 0.0], Behind::Hatched))
        .with(Part::curve(dome).hue(Hue::Reference).dash(Dash::Dashed))
        .with(Part::line(spot, [0.0, 2.6]).dash(Dash::Dashed).label("n"))
        .with(Part::ray_with_heads(eye, spot, &[0.6]).hue(Hue::Natural))
        .with(Part::ray_with_heads(spot, end, &[0.7]).hue(Hue::Ours).label("ray 2"))
        .with(Part::arc(spot, 0.8, FRAC_PI_2, FRAC_PI_2 - theta).hue(Hue::Ours).label("θ"))
        .with(Part::point(eye).label("eye"))
        .with(Part::point(spot).hue(Hue::Ours).label("a new eye"))
        .with(Part::note([-2.1, 1.4], "ray 1"))
        .with(Part::note([-3.3, 0.3], "p over the hemisphere").hue(Hue::Reference));
    Plot::of("One new ray, drawn with a density p", diagram)
}
