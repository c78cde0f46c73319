//! C8: what stays the same along a ray.

use super::symbols::{AREA, AREA_2, N_1, N_2, RADIANCE, RADIANCE_1, RADIANCE_2, RADIUS, SOLID_ANGLE, THETA, THETA_2};
use crate::vocabulary::{Exhibit, Step, derivation, exhibit, step};
use equation::derivation::Chain;
use equation::expr::{cos, partial, sin};
use equation::{Equation, Expr, Symbol};

pub(super) const EXHIBIT: Exhibit = exhibit("ray", &[], &[]);

pub(super) const STEP: Step =
    step(EXHIBIT, "Along a ray", "Radiance does not fade with the distance; in another medium only L/n² is the same.")
        .rows(&["C8"])
        .derivations(&[
            derivation(
                "both_ends",
                "two small surfaces that see each other: what leaves one is what comes to the other",
                || both_ends(RADIANCE * AREA_2 * cos(THETA_2) * SOLID_ANGLE),
            )
            .slip("the far surface's tilt left out", || both_ends(RADIANCE * AREA_2 * SOLID_ANGLE)),
            derivation("refraction", "Snell's law squeezes a bundle: n² cos θ dω is the same on both sides", || {
                refraction((N_1 / N_2).pow(2))
            })
            .slip("n for n²", || refraction(N_1 / N_2)),
            derivation("brighter", "the same power in a smaller étendue: L/n² is the same on both sides", || {
                brighter((N_2 / N_1).pow(2) * RADIANCE_1)
            })
            .slip("radiance held constant through the surface", || brighter(RADIANCE_1.into())),
        ]);

fn both_ends(last: Expr) -> Chain {
    let seen = || AREA_2 * cos(THETA_2) / RADIUS.pow(2);
    Chain::new(RADIANCE * AREA * cos(THETA) * seen())
        .because("L dA cos θ dω, and dω is what the far surface takes of the near one's view")
        .given(SOLID_ANGLE, AREA * cos(THETA) / RADIUS.pow(2), "dω′ of the near surface")
        .then(last, ["dω′ of the near surface"])
}

/// cos θ dω = ½ d(sin² θ) dφ, and the azimuth is the same on both sides: what remains of it, twice.
fn bundle(angle: Symbol) -> Expr {
    partial(sin(angle).pow(2), THETA)
}

fn refraction(last: Expr) -> Chain {
    Chain::new(bundle(THETA_2) / bundle(THETA))
        .because("cos θ′ dω′ over cos θ dω, since cos θ dω = ½ d(sin² θ) dφ")
        .given(sin(THETA_2), N_1 * sin(THETA) / N_2, "Snell")
        .then(last, ["Snell"])
}

fn brighter(last: Expr) -> Chain {
    Chain::assume(Equation::new(RADIANCE_2 * bundle(THETA_2), RADIANCE_1 * bundle(THETA)), "nothing is lost")
        .given(sin(THETA_2), N_1 * sin(THETA) / N_2, "Snell")
        .solve_for([RADIANCE_2])
        .then(Equation::new(RADIANCE_2, last), ["Snell"])
}
