//! E12: a wave that runs one way, in both fields.

use crate::symbols::{B, E, EPSILON, F_B, F_E, MU, T, V, Z};
use crate::vocabulary::{Bench, Check, Exhibit, Measured, Step, check, derivation, exhibit, statement, step};
use equation::derivation::Chain;
use equation::expr::{curl, divergence, partial, vector};
use equation::{Equation, Expr};
use light::em::line::{Ends, Line, Setup};
use light::em::{Medium, Stepping, Wall, Z_0};

pub(super) const EXHIBIT: Exhibit = exhibit("one_way", &[], &[]);

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
.derivations(&[derivation(
    "solves_e5",
    "E = f(z − vt) along x and B = f(z − vt)/v along y solve all four equations",
    || solves(F_E.at([Z - V * T]) / V),
)
.slip("B on the other side: that wave runs the other way", || solves(-(F_E.at([Z - V * T]) / V)))])
.checks(&[&NOTHING_TURNS_BACK]);

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
