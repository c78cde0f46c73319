//! E29, E30: what a source sends in one direction.

use super::symbols::{FLUX, INTENSITY, RADIUS, S_R, SOLID_ANGLE, THETA};
use crate::symbols::{R, S};
use crate::vocabulary::{Exhibit, Step, derivation, exhibit, statement, step};
use equation::derivation::Chain;
use equation::expr::{Range, cos, divergence, dot, integral, integral_between, partial, pi, ratio, sin, sqrt};
use equation::{Equation, Expr};

pub(super) const EXHIBIT: Exhibit = exhibit("intensity", &[], &[]);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "What goes one way",
    "Flow times r² no longer depends on the distance: it belongs to the source and the direction.",
)
.rows(&["E29", "E30"])
.statements(&[
    statement("intensity", "radiant intensity, in W/sr", || Equation::new(INTENSITY, S_R * RADIUS.pow(2)))
        .rows(&["E29"]),
    statement("flux", "all directions together", || {
        Equation::new(FLUX, integral(INTENSITY, [SOLID_ANGLE.into()], Range::Closed))
    })
    .rows(&["E30"]),
    statement("density", "and in one of them", || Equation::new(INTENSITY, partial(FLUX, SOLID_ANGLE))).rows(&["E30"]),
])
.derivations(&[
    derivation(
        "inverse_square",
        "in empty space nothing is lost on the way, and that makes the radial flow fall as 1/r²",
        || inverse_square(squared() * sqrt(squared())),
    )
    .rows(&["E29"])
    .slip("a flow that falls as 1/r", || inverse_square(squared())),
    derivation("cone", "in a cone that widens by dθ: what it gains in power over what it gains in angle", || {
        cone(INTENSITY.into())
    })
    .rows(&["E30"])
    .slip("the angle θ itself for the solid angle", || cone(2 * pi() * sin(THETA) * INTENSITY)),
    derivation(
        "antenna",
        "a short antenna sends sin² θ: two thirds of what its best direction would send everywhere",
        || antenna(ratio(8, 3) * pi() * INTENSITY),
    )
    .rows(&["E30"])
    .slip("the mean of sin² over θ for that over directions", || antenna(2 * pi() * INTENSITY)),
]);

/// r², of a place.
fn squared() -> Expr {
    dot(R, R)
}

fn inverse_square(fall: Expr) -> Chain {
    Chain::new(divergence(S))
        .given(S, INTENSITY * R / fall, "S = I/r², outwards")
        .then(Expr::from(0), ["∂(1/r³)", "∇·r = 3"])
}

fn cone(last: Expr) -> Chain {
    Chain::new(partial(FLUX, THETA) / partial(SOLID_ANGLE, THETA))
        .given(partial(FLUX, THETA), 2 * pi() * sin(THETA) * INTENSITY, "the ring at θ")
        .given(SOLID_ANGLE, 2 * pi() * (1 - cos(THETA)), "Ω of a cone")
        .then(last, ["Ω of a cone"])
}

fn antenna(last: Expr) -> Chain {
    let ring = || 2 * pi() * INTENSITY * sin(THETA).pow(2) * sin(THETA);
    Chain::new(integral_between(ring(), THETA, 0, pi()))
        .primitive(2 * pi() * INTENSITY * (cos(THETA).pow(3) / 3 - cos(THETA)), THETA)
        .then(last, ["sin² = 1 − cos²"])
}
