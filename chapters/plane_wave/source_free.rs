//! E5: Maxwell's equations where there is nothing but a uniform medium.

use super::fields::{Patch, Plane, crowd, outflows, over_time};
use crate::diagram::{Diagram, Part};
use crate::figure::{Hue, Plot};
use crate::parameter::Setting;
use crate::symbols::{B, D, E, EPSILON, H, J, MU, RHO, T};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Question, Step, check, derivation, exhibit, figure, question, statement,
    step,
};
use equation::derivation::Chain;
use equation::expr::{curl, divergence, partial};
use equation::{Equation, Expr, Symbol};
use glam::DVec3;
use light::waves::Medium;
use light::waves::constants::C;
use std::f64::consts::TAU;
use yardstick::random::uniform;

pub(super) const EXHIBIT: Exhibit = exhibit(
    "source_free",
    &[],
    &[figure("circles", "Each field winds round the growth of the other: B by the right hand, E against it.", circles)],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Nothing but a medium",
    "Without charges and currents four equations in two fields are left, and each field feeds the other.",
)
.rows(&["E5"])
.statements(&[
    statement("no_charge", "no electric field line begins or ends", || Equation::new(divergence(E), 0)),
    statement("no_pole", "and no magnetic one, ever", || Equation::new(divergence(B), 0)),
    statement("faraday", "a changing magnetic field winds an electric one round itself", || {
        Equation::new(curl(E), -partial(B, T))
    }),
    statement("ampere", "a changing electric field winds a magnetic one round itself", || {
        Equation::new(curl(B), EPSILON * MU * partial(E, T))
    }),
])
.questions(&[CIRCLES])
.derivations(&[
    derivation("gauss", "∇·D = ρ in a uniform medium without charges", || gauss(EPSILON))
        .slip("∇·D = ε ∇·E also where ε changes from place to place", || gauss(EPSILON.field())),
    derivation("displacement", "∇×H = J + ∂D/∂t in a uniform medium without currents", || {
        displacement(EPSILON * MU * partial(E, T))
    })
    .slip("the displacement current runs backwards, as ∂B/∂t does in Faraday's law", || {
        displacement(-(EPSILON * MU * partial(E, T)))
    }),
])
.checks(&[&INTEGRAL_FORM]);

const CIRCLES: Question = question(
    "winds",
    "In empty space an electric field points upwards and grows. Seen from above and counted counter-clockwise, \
     which sign has the circulation of B around it?",
    Answer::Sign {
        replies: [
            "That is Faraday's law, for E around a B that grows. If both laws had this sign, fields would not \
             swing; they would run away.",
            "Without charges in motion Ampère's law as it stood before Maxwell says so. An electric field that \
             grows counts as a current.",
            "∇×B = εμ ∂E/∂t has no minus: B circles the growth of E as it circles a current.",
        ],
        right: |_| circulation_over_growth(|(_, b)| b, |(e, _)| e),
        slip: |_| circulation_over_growth(|(e, _)| e, |(_, b)| b),
    },
    "Positive, by the right hand, as around a current; E circles the growth of B the other way. This one minus \
     between two laws makes waves.",
);

/// What circles round a patch in a plane wave over what grows through it.
fn circulation_over_growth(circling: fn((DVec3, DVec3)) -> DVec3, growing: fn((DVec3, DVec3)) -> DVec3) -> f64 {
    let wave = Plane::new(&Medium::VACUUM, C, DVec3::Z, DVec3::X, 0.3);
    let side = 1e-2;
    // Where the field that grows points along the patch's normal.
    let normal = growing((wave.e, wave.b)).normalize();
    let across = DVec3::Z.cross(normal);
    let patch = Patch { corner: DVec3::ZERO, sides: [DVec3::Z * side, across * side] };
    let later = 1e-2 / C;
    let flux = |time| patch.flux(&|place, time| growing(wave.at(place, time)), time);
    patch.circulation(&|place, time| circling(wave.at(place, time)), 0.5 * later) / (flux(later) - flux(0.0))
}

fn gauss(permittivity: Symbol) -> Chain {
    Chain::new(divergence(E))
        .given(E, D / &permittivity, "D = εE")
        .given(divergence(D), RHO, "∇·D = ρ")
        .given(RHO, 0, "no charges")
        .then(divergence(D) / &permittivity, ["D = εE", "ε is the same everywhere"])
        .then(RHO / permittivity, ["∇·D = ρ"])
        .then(Equation::new(divergence(E), 0), ["no charges"])
}

fn displacement(last: Expr) -> Chain {
    Chain::new(curl(B))
        .given(B, MU * H, "B = μH")
        .given(E, D / EPSILON, "D = εE")
        .given(partial(D, T), curl(H) - J, "∇×H = J + ∂D/∂t")
        .given(J, 0, "no currents")
        .then(MU * curl(H), ["B = μH"])
        .then(MU * (J + partial(D, T)), ["∇×H = J + ∂D/∂t"])
        .then(last, ["D = εE", "no currents"])
}

/// No derivative is taken: what winds round the edge of a patch is what changes inside.
const INTEGRAL_FORM: Check<fn(Plane) -> Plane> = check(
    "integral_form",
    "the program's plane waves obey all four laws, twenty at once in glass",
)
.against(
    "the laws in integral form, by Gauss's rule: flux through cubes, circulation round patches over a stretch of time",
)
.within(
    1e-12,
    "1",
    "14 points over at most half a wavelength are exact to rounding; sums of a few thousand rounded cosines",
)
.of(integral_form, |plane| plane)
.slip("|E|/|B| = c in glass too", |plane| Plane { b: plane.b / GLASS, ..plane });

/// Index of the glass.
const GLASS: f64 = 1.5;

fn integral_form(bench: &mut Bench, amend: fn(Plane) -> Plane) -> Measured {
    let glass = Medium::relative(GLASS * GLASS, 1.0, 0.0).expect("a clear medium");
    let wavelength = 550e-9;
    let omega = TAU * C / wavelength;
    let waves: Vec<Plane> = crowd(&mut bench.stream, &glass, omega, 20).into_iter().map(amend).collect();
    let e = |place, time| waves.iter().map(|wave| wave.at(place, time).0).sum::<DVec3>();
    let b = |place, time| waves.iter().map(|wave| wave.at(place, time).1).sum::<DVec3>();
    let size = (waves.len() as f64).sqrt();
    let size_b = size * waves[0].b.length();
    let mut cases = Vec::new();
    for round in 0..6 {
        let mut length = |most: f64| uniform(&mut bench.stream, -most, most) * wavelength;
        let corner = DVec3::new(length(3.0), length(3.0), length(3.0));
        let mut side = || DVec3::new(length(0.2), length(0.2), length(0.2));
        let patch = Patch { corner, sides: [side(), side()] };
        let (from, to) = (0.1 * f64::from(round) / omega, (1.0 + 0.3 * f64::from(round)) / omega);
        let edge = patch.sides[0].length() + patch.sides[1].length();
        let changed = |field| patch.flux(field, to) - patch.flux(field, from);
        let wound = |field| over_time(from, to, |time| patch.circulation(field, time));
        let cube = 0.2 * wavelength;
        let out = |field| outflows(field, corner, cube, from).iter().sum::<f64>();
        let at = format!("round {round}");
        cases.extend([
            (out(&e) / (size * cube * cube), format!("∇·E, {at}")),
            (out(&b) / (size_b * cube * cube), format!("∇·B, {at}")),
            ((wound(&e) + changed(&b)) / (size * edge * (to - from)), format!("Faraday, {at}")),
            (
                (wound(&b) - glass.epsilon() * glass.mu() * changed(&e)) / (size_b * edge * (to - from)),
                format!("Ampère, {at}"),
            ),
        ]);
    }
    Measured::worst(cases)
}

fn circles(_: &Setting) -> Plot {
    let panel = |title: &str, grows: &str, winds: &str, hues: [Hue; 2], sense: f64| {
        let ring = |turn: f64| [turn.cos(), turn.sin()];
        let around: Vec<_> = (0..=96).map(|at| ring(f64::from(at) * TAU / 96.0)).collect();
        let arrows = (0..6).map(|at| {
            let turn = f64::from(at) * TAU / 6.0 + 0.4;
            // A short way of the ring, ending in its head.
            let part = Part::vector(ring(turn - 0.12 * sense), ring(turn + 0.12 * sense)).hue(hues[1]);
            if at == 0 { part.label(winds) } else { part }
        });
        Diagram::new(title, [-1.6, -1.35], [1.6, 1.35])
            .with(Part::curve(around).hue(hues[1]))
            .with_all(arrows)
            .with(Part::across([0.0; 2], true).hue(hues[0]).label(grows))
            .into()
    };
    let panels = vec![
        panel("∇×B = εμ ∂E/∂t", "∂E/∂t", "B", [Hue::S, Hue::P], 1.0),
        panel("∇×E = −∂B/∂t", "∂B/∂t", "E", [Hue::P, Hue::S], -1.0),
    ];
    Plot::grid("Each field winds round the growth of the other", 2, panels)
}
