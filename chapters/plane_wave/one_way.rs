//! E12: a wave that runs one way, in both fields.

use super::fields::Plane;
use crate::diagram::{Diagram, Part};
use crate::figure::{Dash, Hue, Plot};
use crate::parameter::Setting;
use crate::symbols::{B, E, EPSILON, F_B, F_E, MU, T, V, Z};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Question, Step, check, derivation, exhibit, figure, question, statement,
    step,
};
use equation::derivation::Chain;
use equation::expr::{curl, divergence, partial, vector};
use equation::{Equation, Expr};
use glam::DVec3;
use light::em::line::{Ends, Line, Setup};
use light::em::{Medium, Stepping, Wall, Z_0};
use std::f64::consts::PI;

pub(super) const EXHIBIT: Exhibit = exhibit(
    "one_way",
    &[],
    &[figure(
        "one_shape",
        "A wave to the right at two instants: E upright, B across it, of one shape and out of the page where E points up.",
        one_shape,
    )],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "One way only",
    "A wave that runs one way carries E and B of the same shape, bound to each other at every point.",
)
.rows(&["E12"])
.statements(&[
    statement("electric", "the electric field of a wave that runs along z", || {
        Equation::new(E, vector(F_E.at([Z - V * T]), 0, 0))
    }),
    statement("magnetic", "and its magnetic field", || Equation::new(B, vector(0, F_B.at([Z - V * T]), 0))),
])
.questions(&[BOUND])
.derivations(&[derivation(
    "solves_e5",
    "E = f(z − vt) along x and B = f(z − vt)/v along y solve all four equations",
    || solves(F_E.at([Z - V * T]) / V),
)
.slip("B on the other side: that wave runs the other way", || solves(-(F_E.at([Z - V * T]) / V)))])
.checks(&[&NOTHING_TURNS_BACK]);

const BOUND: Question = question(
    "bound",
    "A wave runs along +z. Where its E points along +x, its B points along +y. A little further on E points along \
     −x. Which sign has B_y there?",
    Answer::Sign {
        replies: [
            "B is f(z − vt)/v: it turns round with E, so that E×B still points ahead.",
            "B is bound to E at every point; it is zero only where E is.",
            "Then E×B would point back: that part of the wave would run the other way.",
        ],
        right: |_| ahead(-1.0),
        slip: |_| ahead(1.0),
    },
    "Negative. The two fields turn round together; what never turns is E×B, the way the wave runs.",
);

/// B_y of a wave along z in the vacuum where its E_x has a sign.
fn ahead(sign: f64) -> f64 {
    let wave = Plane::new(&light::waves::Medium::VACUUM, light::waves::constants::C, DVec3::Z, DVec3::X, 0.0);
    // A half wavelength, π/k, takes E from its crest to its trough.
    let place = DVec3::Z * (0.5 * (1.0 - sign) * PI / wave.k.z);
    wave.at(place, 0.0).1.y
}

fn solves(b: Expr) -> Chain {
    Chain::new(Equation::new(divergence(E), 0))
        .given(E, vector(F_E.at([Z - V * T]), 0, 0), "E = f_E(z − vt)")
        .given(B, vector(0, b, 0), "f_B = f_E/v")
        .given(EPSILON, 1 / (MU * V.pow(2)), "v = 1/√(εμ)")
        .then(Equation::new(divergence(B), 0), ["∂/∂y = 0"])
        .then(Equation::new(curl(B), EPSILON * MU * partial(E, T)), ["chain rule", "v = 1/√(εμ)"])
        .then(Equation::new(curl(E), -partial(B, T)), ["chain rule"])
}

const NOTHING_TURNS_BACK: Check<f64> =
    check("nothing_turns_back", "started with B = E/v, a pulse leaves as one and sends nothing back")
        .against("the solver of chapter maxwell at one cell a step; what runs back is ½(E − Z H)")
        .within(1e-13, "1", "three hundred steps of a few roundings each, of fields near 1")
        .of(turned_back, 1.0)
        .slip("B one per cent too small", 0.99);

fn turned_back(_: &mut Bench, share: f64) -> Measured {
    let media = [(1.0, 1.0), (2.25, 1.0), (1.0, 4.0), (1e-6, 1e-6), (80.0, 1e3)];
    Measured::worst(media.map(|(eps_r, mu_r): (f64, f64)| {
        const CELLS: usize = 600;
        let shape = |z: f64| (-((z - 150.0) / 20.0).powi(2)).exp();
        let impedance = (mu_r / eps_r).sqrt() * Z_0;
        let mut line = at_one_cell_a_step(CELLS, eps_r, mu_r);
        // Half a cell on and half a step later is the same point of the shape.
        line.set(shape, |z| share * shape(z - 0.5) / impedance);
        line.run(300).expect("some steps");
        let h = line.h();
        let back = (0..CELLS).map(|cell| 0.5 * (line.e()[cell] - impedance * h[cell]));
        let arrived = (0..=CELLS).map(|node| line.e()[node] - shape(node as f64 - 300.0));
        let worst = Measured::worst(back.chain(arrived).map(|value| (value, String::new()))).value;
        (worst, format!("ε_r = {eps_r}, μ_r = {mu_r}"))
    }))
}

/// A line of so many cells of 1 m of a clear medium between conductors, whose waves run one cell a step: then the grid
/// makes no error but rounding.
pub(super) fn at_one_cell_a_step(cells: usize, eps_r: f64, mu_r: f64) -> Line {
    let background = Medium { mu_r, ..Medium::dielectric(eps_r) };
    let stepping = Stepping::at((eps_r * mu_r).sqrt());
    let vacuum = Setup::vacuum(cells, 1.0, Ends::Walls([Wall::Conductor; 2]), stepping);
    Line::new(Setup { background, ..vacuum }).expect("a stable step")
}

/// One shape that runs to the right, with both its fields.
fn one_shape(_: &Setting) -> Plot {
    // Two bumps of either sign: B must turn round with E.
    let shape = |z: f64| (-(z - 1.1).powi(2) * 6.0).exp() - 0.7 * (-(z - 2.0).powi(2) * 6.0).exp();
    let way = 2.6;
    let curve = |shift: f64| (0..=200).map(|at| 0.016 * f64::from(at)).map(move |z| [z + shift, shape(z)]).collect();
    let fields = [0.9, 1.1, 1.3, 1.8, 2.0, 2.2].map(|z| {
        let arrow = Part::vector([z, 0.0], [z, shape(z)]).hue(Hue::S);
        if z == 1.1 { arrow.label("E") } else { arrow }
    });
    let across = [1.1, 2.0].map(|z| {
        let part = Part::across([z, -0.3 * shape(z).signum()], shape(z) > 0.0).hue(Hue::P);
        if z == 1.1 { part.label("B") } else { part }
    });
    let diagram = Diagram::new("", [-0.3, -1.1], [6.4, 1.45])
        .with(Part::ray([0.0, 0.0], [6.2, 0.0]).hue(Hue::Reference).label("z"))
        .with(Part::curve(curve(way)).hue(Hue::Natural).dash(Dash::Dashed).label("a time t later"))
        .with(Part::curve(curve(0.0)).hue(Hue::Natural))
        .with_all(fields)
        .with_all(across)
        .with(Part::vector([1.1, 1.2], [1.1 + way, 1.2]).label("v t"));
    Plot::of("One way, with both fields", diagram)
}
