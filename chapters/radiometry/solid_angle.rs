//! E27, E28: the power through a sphere, and the angle that a sphere is.

use super::symbols::{ALPHA, AZIMUTH, FLUX, PLACE, RADIUS, S_R, SOLID_ANGLE, THETA};
use crate::symbols::S;
use crate::vocabulary::{Exhibit, Step, derivation, exhibit, statement, step};
use equation::derivation::Chain;
use equation::expr::{Range, cos, cross, d, dot, integral, integral_between, partial, pi, sin, vector};
use equation::{Equation, Expr};

pub(super) const EXHIBIT: Exhibit = exhibit("solid_angle", &[], &[]);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "A sphere round the source",
    "A direction is a place on the unit sphere; all of them together make 4π, and the power through all of them is the flux.",
)
.rows(&["E27", "E28"])
.statements(&[
    statement("flux", "all that a source sends out passes a sphere round it", || {
        Equation::new(FLUX, integral(S_R * RADIUS.pow(2) * sin(THETA), [AZIMUTH.into(), THETA.into()], Range::Closed))
    })
    .rows(&["E27"]),
    statement("element", "the solid angle of a patch of directions", || {
        Equation::new(d(SOLID_ANGLE), sin(THETA) * d(AZIMUTH) * d(THETA))
    })
    .rows(&["E28"]),
])
.derivations(&[
    derivation("area", "two steps along the sphere span a patch of r² sin θ dφ dθ that faces outwards", || {
        area(RADIUS.pow(2) * sin(THETA) * outwards())
    })
    .rows(&["E27", "E28"])
    .slip("a degree of longitude taken to be as long everywhere as at the equator", || area(RADIUS.pow(2) * outwards())),
    derivation("through_the_patch", "so the power through it is the radial flow times r² sin θ", || {
        through(S_R * RADIUS.pow(2) * sin(THETA))
    })
    .rows(&["E27"])
    .slip("r for r²", || through(S_R * RADIUS * sin(THETA) * Expr::from(1))),
    derivation("cone", "a cone of half-angle α; with α = π it is everything", || cone(2 * pi() * (1 - cos(ALPHA))))
        .rows(&["E28"])
        .slip("the cone's projection, as if seen from far", || cone(pi() * sin(ALPHA).pow(2))),
]);

/// The unit vector in the direction (θ, φ).
fn outwards() -> Expr {
    vector(sin(THETA) * cos(AZIMUTH), sin(THETA) * sin(AZIMUTH), cos(THETA))
}

fn area(last: Expr) -> Chain {
    Chain::new(cross(partial(PLACE, THETA), partial(PLACE, AZIMUTH)))
        .because("the sides of the patch are the steps that θ and φ make")
        .given(PLACE, RADIUS * outwards(), "a place on the sphere")
        .then(last, ["∂/∂θ, ∂/∂φ", "sin² + cos² = 1"])
}

fn through(last: Expr) -> Chain {
    Chain::new(dot(S, cross(partial(PLACE, THETA), partial(PLACE, AZIMUTH))))
        .given(PLACE, RADIUS * outwards(), "a place on the sphere")
        .given(S, S_R * outwards(), "the flow far out is radial")
        .then(last, ["∂/∂θ, ∂/∂φ", "sin² + cos² = 1"])
}

fn cone(last: Expr) -> Chain {
    let rings = |to: Expr| integral_between(2 * pi() * sin(THETA), THETA, 0, to);
    Chain::new(rings(ALPHA.into()))
        .because("rings of directions, each 2π sin θ dθ")
        .primitive(-2 * pi() * cos(THETA), THETA)
        .then(last, ["∫ sin θ dθ = −cos θ"])
        .then(Equation::new(rings(pi()), 4 * pi()), ["cos π = −1"])
}
