//! E32: what arrives.

use super::symbols::{AREA, HEIGHT, INTENSITY, IRRADIANCE, NORMAL, RADIANCE, RADIUS, SOLID_ANGLE, THETA};
use crate::symbols::R;
use crate::vocabulary::{Exhibit, Step, derivation, exhibit, statement, step};
use equation::derivation::Chain;
use equation::expr::{Range, cos, cross, curl, dot, integral, integral_between, pi, sin};
use equation::{Equation, Expr};

pub(super) const EXHIBIT: Exhibit = exhibit("irradiance", &[], &[]);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "What arrives",
    "Irradiance sums what comes from every direction, weighed by how squarely it arrives.",
)
.rows(&["E32"])
.statements(&[statement("irradiance", "power that arrives on a unit of area", || {
    Equation::new(IRRADIANCE, integral(RADIANCE * cos(THETA), [SOLID_ANGLE.into()], Range::Whole))
})])
.derivations(&[
    derivation("hemisphere", "from a sky of one radiance", || hemisphere(pi() * RADIANCE))
        .slip("the solid angle of the sky for what arrives from it", || hemisphere(2 * pi() * RADIANCE)),
    derivation("cos_4", "a small lamp in a ceiling, on the floor: four cosines", || {
        cos_4(RADIANCE * AREA * cos(THETA).pow(4) / HEIGHT.pow(2))
    })
    .slip("two of them forgotten, those of the distance", || {
        cos_4(RADIANCE * AREA * cos(THETA).pow(2) / HEIGHT.pow(2))
    }),
    derivation("stokes", "what a surface contributes is the curl of something: its rim alone counts", || {
        stokes(2 * dot(NORMAL, R) * R / dot(R, R).pow(2))
    })
    .slip("a rim's field that falls as 1/r, not 1/r²", || stokes(dot(NORMAL, R) * R / dot(R, R).pow(2))),
]);

fn hemisphere(last: Expr) -> Chain {
    let ring = || 2 * pi() * RADIANCE * cos(THETA) * sin(THETA);
    Chain::new(integral_between(ring(), THETA, 0, pi() / 2))
        .because("rings of the sky, each 2π sin θ dθ")
        .primitive(pi() * RADIANCE * sin(THETA).pow(2), THETA)
        .then(last, ["∂ sin² θ = 2 sin θ cos θ"])
}

fn cos_4(last: Expr) -> Chain {
    Chain::new(INTENSITY * cos(THETA) / RADIUS.pow(2))
        .because("I/r² onto a floor that is tilted by θ")
        .given(INTENSITY, RADIANCE * AREA * cos(THETA), "a Lambertian lamp")
        .given(RADIUS, HEIGHT / cos(THETA), "r cos θ = h")
        .then(last, ["a Lambertian lamp", "r cos θ = h"])
}

fn stokes(last: Expr) -> Chain {
    Chain::new(curl(cross(NORMAL, R) / dot(R, R)))
        .because("half of this, through the surface, is what arrives: Stokes makes it a sum over the rim")
        .then(last, ["∇×(n×r f) = n(2f + rf′) − (n·r) r f′/r"])
}
