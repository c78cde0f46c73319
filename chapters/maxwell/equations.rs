//! E1: the four laws, and a solution that carries charge and current.

use crate::figure::{Axis, Dash, Hue, Map, Mark, Panel, Plot, Ramp};
use crate::parameter::{Kind, Parameter, Setting};
use crate::symbols::{B, D, E, H, J, RHO, T};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Misled, Quantity, Question, Step, check, exhibit, figure, question,
    statement, step,
};
use equation::Equation;
use equation::expr::{curl, divergence, partial};
use light::fields::charge::MovingCharge;
use light::fields::{Vector, dot};
use light::waves::constants::C;
use std::f64::consts::{PI, TAU};
use yardstick::quadrature::{gauss, gauss_legendre};
use yardstick::random::uniform;

const BETA: Parameter =
    Parameter::new("beta", "β", "speed of the charge over that of light", Kind::number(-0.99, 0.99, "1"))
        .default("0.9");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "equations",
    &[BETA],
    &[figure(
        "moving_charge",
        "A fast charge: its field is pressed into the plane across its way, and the \
         magnetic field circles the way.",
        moving_charge,
    )],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "The four laws",
    "Charge is where electric flux begins and ends, magnetic flux has no ends, and \
     each field circles the change of the other.",
)
.rows(&["E1"])
.about("ampere_maxwell")
.statements(&[
    statement("gauss", "electric flux begins and ends at charges", || Equation::new(divergence(D), RHO)),
    statement("no_monopoles", "magnetic flux never begins or ends", || Equation::new(divergence(B), 0)),
    statement("faraday", "the electric field circles a magnetic flux that changes", || {
        Equation::new(curl(E), -partial(B, T))
    }),
    statement("ampere_maxwell", "the magnetic field circles currents and an electric flux that changes", || {
        Equation::new(curl(H), J + partial(D, T))
    }),
])
.questions(&[ABREAST])
.readout(readout)
.checks(&[&ENDS_OF_FLUX, &INDUCTION, &CIRCULATION]);

const ABREAST: Question = question(
    "abreast",
    "A charge flies past at 0.8 of the speed of light. As it passes, how strong is its electric field beside its \
     way, over that of the same charge at rest there?",
    Answer::Number {
        unit: "1",
        tolerance: 0.01,
        right: |_| over_rest([1.0, 0.0, 0.0], 0),
        slips: &[
            Misled {
                value: |_| 1.0,
                reply: "That is Coulomb's law, which holds for charges at rest. As many field lines leave a charge \
                 in flight, but they are pressed together.",
            },
            Misled {
                value: |_| over_rest([0.0, 0.0, 1.0], 2),
                reply: "So weak is it ahead of the charge and behind it. What is missing there is found abreast.",
            },
            Misled {
                value: |_| over_rest([1.0, 0.0, 0.0], 0).recip(),
                reply: "The wrong way round: the lines are pressed into the plane across the way, so it is stronger \
                 there.",
            },
        ],
    },
    "5/3, which is 1/√(1 − β²): weaker ahead and behind, stronger abreast, and as much flux in all, for that counts \
     the charge.",
);

/// A component of E at a place, of a charge of β = 0.8 that passes the origin, over that of one at rest.
fn over_rest(place: Vector, axis: usize) -> f64 {
    let [passing, at_rest] = [0.8, 0.0].map(|beta| MovingCharge { charge: 1e-9, beta }.e(place, 0.0)[axis]);
    passing / at_rest
}

fn charge(setting: &Setting) -> MovingCharge {
    MovingCharge { charge: 1e-9, beta: setting.number("beta") }
}

fn readout(setting: &Setting) -> Vec<Quantity> {
    let charge = charge(setting);
    let abreast = charge.e([1.0, 0.0, 0.0], 0.0)[0];
    let quantity = |key, symbol, says, value, unit| Quantity { key, symbol, says, value, unit };
    vec![
        quantity("e_abreast", "E", "field of 1 nC, 1 m beside its way", abreast, "V/m"),
        quantity("e_ahead", "E", "field 1 m ahead of it", charge.e([0.0, 0.0, 1.0], 0.0)[2], "V/m"),
        quantity("b_abreast", "B", "magnetic flux density 1 m beside its way", charge.b([1.0, 0.0, 0.0], 0.0)[1], "T"),
    ]
}

/// Nodes along each direction of a quadrature: enough for rounding to remain at the distances used here.
const NODES: usize = 96;

const ENDS_OF_FLUX: Check<fn(&MovingCharge, Vector, f64) -> Vector> =
    check("flux_ends_at_charges", "D flows out of a closed surface as much as there is charge inside, B not at all")
        .against(
            "the field of a charge in flight, integrated over spheres that hold it off-centre \
             or not at all",
        )
        .within(1e-13, "1", "quadrature with 96 × 96 nodes, which is past rounding, of ten thousand terms")
        .of(flux_through_spheres, MovingCharge::d)
        .slip("Coulomb's field flattened without growing stronger abreast", |charge, place, t| {
            let flat = ((1.0 - charge.beta) * (1.0 + charge.beta)).sqrt();
            charge.d(place, t).map(|d| flat * d)
        });

/// What is wrong with the flux out of spheres around the charge, and beside it, over the charge.
fn flux_through_spheres(bench: &mut Bench, d: fn(&MovingCharge, Vector, f64) -> Vector) -> Measured {
    let speeds = [0.0, 0.5, -0.8, bench.setting().number("beta").clamp(-0.9, 0.9)];
    Measured::worst(speeds.into_iter().flat_map(|beta| {
        let charge = MovingCharge { charge: 1.0, beta };
        let mut inside = || uniform(&mut bench.stream, -0.25, 0.25);
        let centre = [inside(), inside(), inside()];
        let beside = [2.0, centre[1], centre[2]];
        let place = format!("β = {beta}, centre {centre:.2?}");
        [
            (flux(centre, |place| d(&charge, place, 0.0)) - 1.0, format!("D, {place}")),
            (flux(beside, |place| d(&charge, place, 0.0)), format!("D, charge outside, β = {beta}")),
            // In units of the flux of D, by way of H = vD.
            (flux(centre, |place| charge.h(place, 0.0)) / C, format!("B, {place}")),
        ]
    }))
}

/// ∮ f·dA over the unit sphere about `centre`.
fn flux(centre: Vector, f: impl Fn(Vector) -> Vector) -> f64 {
    let rule = gauss_legendre(NODES);
    let rings = rule.iter().map(|&(u, weight)| {
        let cos = 2.0 * u - 1.0;
        let sin = ((1.0 - cos) * (1.0 + cos)).sqrt();
        let around: f64 = circle(|c, s| {
            let outwards = [sin * c, sin * s, cos];
            dot(f([0, 1, 2].map(|axis| centre[axis] + outwards[axis])), outwards)
        });
        2.0 * weight * around
    });
    rings.sum()
}

/// ∫ f(cos φ, sin φ) dφ over a turn.
fn circle(f: impl Fn(f64, f64) -> f64) -> f64 {
    let step = TAU / NODES as f64;
    (0..NODES).map(|at| (at as f64 * step).sin_cos()).map(|(sin, cos)| step * f(cos, sin)).sum()
}

/// A disc of radius 1 [m], leaning, that the charge's way pierces off-centre.
#[derive(Clone, Copy, Debug)]
struct Disc {
    centre: Vector,
    /// Two unit vectors in it, square to each other.
    along: [Vector; 2],
}

impl Disc {
    /// Leaning by `tilt` [rad].
    fn leaning(centre: Vector, tilt: f64) -> Self {
        let (sin, cos) = tilt.sin_cos();
        Self { centre, along: [[cos, 0.0, -sin], [0.0, 1.0, 0.0]] }
    }

    fn normal(&self) -> Vector {
        light::fields::cross(self.along[0], self.along[1])
    }

    /// The place at radius ρ in the direction whose cosine and sine are given.
    fn place(&self, radius: f64, cos: f64, sin: f64) -> Vector {
        let [u, v] = self.along;
        [0, 1, 2].map(|axis| self.centre[axis] + radius * (cos * u[axis] + sin * v[axis]))
    }

    /// ∫ f·dA
    fn flux(&self, f: impl Fn(Vector) -> Vector) -> f64 {
        let normal = self.normal();
        let rings = gauss_legendre(NODES)
            .into_iter()
            .map(|(radius, weight)| weight * radius * circle(|cos, sin| dot(f(self.place(radius, cos, sin)), normal)));
        rings.sum()
    }

    /// ∮ f·dl around the rim.
    fn circulation(&self, f: impl Fn(Vector) -> Vector) -> f64 {
        let [u, v] = self.along;
        circle(|cos, sin| {
            let forward = [0, 1, 2].map(|axis| cos * v[axis] - sin * u[axis]);
            dot(f(self.place(1.0, cos, sin)), forward)
        })
    }
}

/// A charge that flies through a leaning disc during 2τ.
struct Passage {
    charge: MovingCharge,
    disc: Disc,
    /// τ [s].
    half: f64,
}

/// Passages at several speeds; the charge starts and ends 1.5 m from the plane z = 0.
fn passages(bench: &mut Bench) -> Vec<Passage> {
    [0.3, 0.6, 0.85]
        .map(|beta| {
            let mut shift = || uniform(&mut bench.stream, -0.3, 0.3);
            let disc = Disc::leaning([shift(), shift(), 0.0], shift() + 0.4);
            Passage { charge: MovingCharge { charge: 1.0, beta }, disc, half: 1.5 / (beta * C) }
        })
        .into()
}

const INDUCTION: Check<f64> = check(
    "induction",
    "the circulation of E around a disc, summed over time, is the magnetic flux that \
     the disc has lost",
)
.against(
    "a charge flies through a leaning disc: line, surface and time integrals of its \
     field by Gauss and trapezoid",
)
.within(
    1e-10,
    "1",
    "past the rule's own error, rounding of Coulomb's part of the field, which is far \
     larger and cancels round the rim",
)
.of(induction, -1.0)
.slip("Lenz's rule turned round", 1.0);

fn induction(bench: &mut Bench, sign: f64) -> Measured {
    Measured::worst(passages(bench).iter().map(|Passage { charge, disc, half }| {
        let circulated = gauss(NODES, -half, *half, |t| disc.circulation(|place| charge.e(place, t)));
        let through = |t| disc.flux(|place| charge.b(place, t));
        let gained = through(*half) - through(-half);
        ((circulated - sign * gained) / gained, format!("β = {}", charge.beta))
    }))
}

const CIRCULATION: Check<f64> = check(
    "displacement",
    "the circulation of H, summed over time, is the charge that went through plus the \
     electric flux gained",
)
.against("the same passage: the charge that went through is known without any field")
.within(1e-13, "1", "past the rule's own error, rounding of a million terms")
.of(displacement, 1.0)
.slip("Ampère's law without Maxwell's term ∂D/∂t", 0.0);

/// What is wrong with Ampère's law, over the charge, if the flux of D counts `share`.
fn displacement(bench: &mut Bench, share: f64) -> Measured {
    Measured::worst(passages(bench).iter().map(|Passage { charge, disc, half }| {
        let circulated = gauss(NODES, -half, *half, |t| disc.circulation(|place| charge.h(place, t)));
        let through = |t| disc.flux(|place| charge.d(place, t));
        let gained = through(*half) - through(-half);
        (circulated - share * gained - charge.charge, format!("β = {}", charge.beta))
    }))
}

/// |D| around a charge at rest and around the setting's, in the plane of its way.
fn moving_charge(setting: &Setting) -> Plot {
    let panel = |beta: f64| -> Panel {
        const CELLS: usize = 160;
        let charge = MovingCharge { charge: 1e-9, beta };
        let at = |cell: usize| 2.0 * (cell as f64 + 0.5) / CELLS as f64 - 1.0;
        let values = (0..CELLS * CELLS).map(|cell| {
            let field = charge.e([at(cell / CELLS), 0.0, at(cell % CELLS)], 0.0);
            dot(field, field).sqrt()
        });
        Panel::Map(Map {
            title: format!("β = {beta}"),
            x: Axis::linear("z, the way it goes", "m").range(-1.0, 1.0),
            y: Axis::linear("x", "m").range(-1.0, 1.0),
            colour: Axis::log("|E| of 1 nC", "V/m").range(1.0, 1e4),
            ramp: Ramp::Sequential,
            columns: CELLS,
            values: values.collect(),
            marks: field_lines(beta),
        })
    };
    Plot::grid("The field of a charge", 2, vec![panel(0.0), panel(setting.number("beta"))])
}

/// Straight lines away from the charge, as dense as the field is strong: those of a charge at rest, flattened.
fn field_lines(beta: f64) -> Vec<Mark> {
    let flat = ((1.0 - beta) * (1.0 + beta)).sqrt();
    let line = |at: u32| {
        let (sin, cos) = (PI * (f64::from(at) + 0.5) / 7.0).sin_cos();
        let length = (flat * cos).hypot(sin).recip();
        let end = |reach: f64| [reach * length * flat * cos, reach * length * sin];
        let (tip, back) = (end(0.95), end(0.95 - 0.07 / length));
        let side = [0.5 * (tip[1] - back[1]), -0.5 * (tip[0] - back[0])];
        // The way out, and the two sides of its head.
        let points =
            vec![end(0.08), tip, [back[0] + side[0], back[1] + side[1]], tip, [back[0] - side[0], back[1] - side[1]]];
        Mark::Line { label: String::new(), hue: Hue::Reference, dash: Dash::Solid, points }
    };
    (0..14).map(line).collect()
}
