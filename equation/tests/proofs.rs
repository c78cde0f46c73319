//! What the other chapters will derive, proved already: every hop decided symbolically, every side in the right unit,
//! and next to each chain the same with one slip, which is refused.

use equation::derivation::{Chain, Claim, Verdict};
use equation::expr::{cos, cross, dot, integral_between, partial, pi, sin, vector};
use equation::{Dimension as U, Equation, Expr, Symbol};
use yardstick::{precise, random};

const RADIUS: Symbol = Symbol::scalar("R", U::METRE).real(0.5, 2.0);
const THETA: Symbol = Symbol::scalar("theta", U::ONE).real(0.2, 2.9);
const PHI: Symbol = Symbol::scalar("phi", U::ONE).real(0.0, 6.2);

/// Every hop of the chain to `right` is proved; the one to `wrong` is refuted, and no other.
fn only_this(chain: impl Fn(Claim) -> Chain, right: impl Into<Claim>, wrong: impl Into<Claim>) {
    let verdicts = judged(&chain(right.into()));
    assert!(!verdicts.is_empty() && verdicts.iter().all(|verdict| *verdict == Verdict::Proved), "{verdicts:#?}");
    let verdicts = judged(&chain(wrong.into()));
    let (last, before) = verdicts.split_last().expect("a chain has hops");
    assert!(before.iter().all(|verdict| *verdict == Verdict::Proved), "{verdicts:#?}");
    assert!(matches!(last, Verdict::Refuted { .. }), "{last:?}");
}

fn judged(chain: &Chain) -> Vec<Verdict> {
    assert_eq!(chain.units(), Ok(()));
    let mut stream = random::stream(7, "proofs");
    chain.verify(16, precise::BITS, &mut stream).into_iter().map(|hop| hop.verdict).collect()
}

fn equal(left: impl Into<Expr>, right: impl Into<Expr>) -> Equation {
    Equation::new(left, right)
}

#[test]
fn a_patch_of_a_sphere_is_its_solid_angle_times_the_radius_squared() {
    let outwards = || vector(sin(THETA) * cos(PHI), sin(THETA) * sin(PHI), cos(THETA));
    let place = || RADIUS * outwards();
    let chain = |last: Claim| {
        Chain::new(dot(outwards(), cross(partial(place(), THETA), partial(place(), PHI))))
            .then(
                dot(
                    outwards(),
                    cross(
                        vector(RADIUS * cos(THETA) * cos(PHI), RADIUS * cos(THETA) * sin(PHI), -(RADIUS * sin(THETA))),
                        vector(-(RADIUS * sin(THETA) * sin(PHI)), RADIUS * sin(THETA) * cos(PHI), 0),
                    ),
                ),
                ["the sides of the patch"],
            )
            .then(last, ["sin² + cos² = 1"])
    };
    only_this(chain, RADIUS.pow(2) * sin(THETA), RADIUS.pow(2) * cos(THETA));
}

#[test]
fn the_whole_sphere_is_four_pi() {
    let chain = |last| {
        let over_height = integral_between(sin(THETA), THETA, 0, pi());
        Chain::new(integral_between(&over_height, PHI, 0, 2 * pi()))
            .primitive(-cos(THETA), THETA)
            .then(2 * pi() * over_height, ["the same for every φ"])
            .then(2 * pi() * (-cos(pi()) + cos(0)), ["primitive −cos θ"])
            .then(last, ["cos π = −1"])
    };
    only_this(chain, 4 * pi(), 2 * pi());
}

#[test]
fn a_lambertian_surface_that_reflects_rho_has_rho_over_pi() {
    const ALBEDO: Symbol = Symbol::scalar("rho", U::ONE);
    const BRDF: Symbol = Symbol::scalar("k", U::ONE);
    let chain = |last| {
        let over_height = integral_between(BRDF * cos(THETA) * sin(THETA), THETA, 0, pi() / 2);
        Chain::assume(equal(integral_between(over_height, PHI, 0, 2 * pi()), ALBEDO), "the reflected share is ρ")
            .solve_for([BRDF])
            .primitive(BRDF * sin(THETA).pow(2) / 2, THETA)
            .then(equal(BRDF * pi(), ALBEDO), ["primitive ½ sin² θ"])
            .then(last, ["divide by π"])
    };
    only_this(chain, equal(BRDF, ALBEDO / pi()), equal(BRDF, ALBEDO / (2 * pi())));
}

const ALBEDO: Symbol = Symbol::scalar("rho", U::ONE).within(0.1, 0.9);
const EMITTED: Symbol = Symbol::scalar("L_e", U::WATT_PER_SQUARE_METRE);
const RADIANCE: Symbol = Symbol::scalar("L", U::WATT_PER_SQUARE_METRE);

#[test]
fn a_furnace_glows_with_a_geometric_series() {
    let fixed = |last| {
        Chain::assume(equal(RADIANCE, EMITTED + ALBEDO * RADIANCE), "what leaves is emitted or reflected")
            .solve_for([RADIANCE])
            .then(equal((1 - ALBEDO) * RADIANCE, EMITTED), ["collect L"])
            .then(last, ["divide by 1 − ρ"])
    };
    only_this(fixed, equal(RADIANCE, EMITTED / (1 - ALBEDO)), equal(RADIANCE, EMITTED / (1 + ALBEDO)));
}

#[test]
fn the_sum_of_the_first_bounces_is_proved_by_induction() {
    /// ρᴺ
    const POWER: Symbol = Symbol::scalar("p", U::ONE);
    let partial_sum = |power: Expr| EMITTED * (1 - power) / (1 - ALBEDO);
    let start = |last| Chain::new(partial_sum(Expr::from(POWER))).given(POWER, 1, "no bounce").then(last, ["ρ⁰ = 1"]);
    only_this(start, 0 * EMITTED, EMITTED + Expr::from(0));
    let step = |last| {
        Chain::new(EMITTED + ALBEDO * partial_sum(POWER.into()))
            .then((EMITTED * (1 - ALBEDO) + ALBEDO * EMITTED * (1 - POWER)) / (1 - ALBEDO), ["common denominator"])
            .then(last, ["collect ρp"])
    };
    only_this(step, partial_sum(ALBEDO * POWER), partial_sum(ALBEDO + POWER));
    let rest = |last| Chain::new(EMITTED / (1 - ALBEDO) - partial_sum(POWER.into())).then(last, ["collect"]);
    only_this(rest, POWER * EMITTED / (1 - ALBEDO), EMITTED / (1 - ALBEDO) * (1 - POWER));
}
