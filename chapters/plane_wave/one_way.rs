//! E12: a wave that runs one way, in both fields.

use super::grid::Grid;
use super::symbols::{B, E, EPSILON, F_B, F_E, MU, T, V, Z};
use crate::vocabulary::{Bound, Check, Derivation, Measured, Statement, Step};
use light::equation::derivation::Chain;
use light::equation::expr::{curl, divergence, partial, vector};
use light::equation::{Equation, Expr};

pub(super) const STEP: Step = Step {
    id: "one_way",
    title: "One way only",
    says: "A wave that runs one way carries E and B of the same shape, bound to each other at every point.",
    rows: &["E12"],
    parameters: &[],
    statements: &[
        Statement {
            id: "electric",
            says: "the electric field of a wave that runs along z",
            rows: &["E12"],
            equation: || Equation::new(E, vector(F_E.at([Z - V * T]), 0, 0)),
        },
        Statement {
            id: "magnetic",
            says: "and its magnetic field",
            rows: &["E12"],
            equation: || Equation::new(B, vector(0, F_B.at([Z - V * T]), 0)),
        },
    ],
    derivations: &[Derivation {
        id: "solves_e5",
        says: "E = f(z − vt) along x and B = f(z − vt)/v along y solve all four equations",
        rows: &["E12"],
        chain: || solves(F_E.at([Z - V * T]) / V),
        spoiled: || solves(-(F_E.at([Z - V * T]) / V)),
        slip: "B on the other side: that wave runs the other way",
    }],
    readout: None,
    checks: &[NOTHING_TURNS_BACK],
    stress: &[],
    races: &[],
    figures: &[],
};

fn solves(b: Expr) -> Chain {
    Chain::new(Equation::new(divergence(E), 0))
        .given(E, vector(F_E.at([Z - V * T]), 0, 0), "E = f_E(z − vt)")
        .given(B, vector(0, b, 0), "f_B = f_E/v")
        .given(EPSILON, 1 / (MU * V.pow(2)), "v = 1/√(εμ)")
        .then(Equation::new(divergence(B), 0), ["∂/∂y = 0"])
        .then(Equation::new(curl(B), EPSILON * MU * partial(E, T)), ["chain rule", "v = 1/√(εμ)"])
        .then(Equation::new(curl(E), -partial(B, T)), ["chain rule"])
}

const NOTHING_TURNS_BACK: Check = Check {
    id: "nothing_turns_back",
    claim: "started with B = E/v, a pulse leaves as one and sends nothing back",
    rows: &["E12"],
    route: "Faraday's and Ampère's laws on a grid at one cell a step; what runs back is ½(E − vB)",
    bound: Bound::AtMost {
        limit: 1e-13,
        unit: "1",
        why: "three hundred steps of a few roundings each, of fields near 1",
    },
    measure: |_| turned_back(1.0),
    spoiled: |_| turned_back(0.99),
    slip: "B one per cent too small",
};

fn turned_back(share: f64) -> Measured {
    let media = [(1.0, 1.0), (2.25, 1.0), (1.0, 4.0), (1e-6, 1e-6)];
    Measured::worst(media.map(|(epsilon, mu): (f64, f64)| {
        let (cells, start, speed) = (600, 150.0, (epsilon * mu).powf(-0.5));
        let shape = |i: f64| (-((i - start) / 20.0).powi(2)).exp();
        let e = (0..=cells).map(|i| shape(f64::from(i))).collect();
        // Half a cell on and half a step later is the same point of the shape.
        let b = (0..cells).map(|i| share * shape(f64::from(i)) / speed).collect();
        let mut grid = Grid::new(e, b, epsilon * mu);
        (0..300).for_each(|_| grid.step());
        let back = (0..cells as usize).map(|i| 0.5 * (grid.e[i] - speed * grid.b[i]));
        let arrived = (0..=cells).map(|i| grid.e[i as usize] - shape(f64::from(i) - 300.0));
        let worst = Measured::worst(back.chain(arrived).map(|value| (value, String::new()))).value;
        (worst, format!("ε = {epsilon}, μ = {mu}"))
    }))
}
