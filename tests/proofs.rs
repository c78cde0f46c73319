//! What the other chapters will derive, proved already: every hop decided symbolically, every side in the right unit,
//! and next to each chain the same with one slip, which is refused.

use light::equation::derivation::{Chain, Claim, Verdict};
use light::equation::expr::{
    abs, cos, cross, curl, divergence, dot, exp, gradient, i, integral_between, laplacian, mean, partial, pi, ratio,
    sin, sqrt, vector,
};
use light::equation::{Dimension as U, Equation, Expr, Symbol};
use light::{precise, sampling};

const Z: Symbol = Symbol::scalar("z", U::METRE).real(0.25, 1.25);
const T: Symbol = Symbol::scalar("t", U::SECOND).real(0.25, 1.25);
const PERIOD: Symbol = Symbol::scalar("T", U::SECOND);
const OMEGA: Symbol = Symbol::scalar("omega", U::HERTZ).real(0.5, 2.0);
const K: Symbol = Symbol::scalar("k", U::RADIAN_PER_METRE).real(0.5, 2.0);
const V: Symbol = Symbol::scalar("v", U::METRE_PER_SECOND).real(0.5, 2.0);
const EPSILON: Symbol = Symbol::scalar("epsilon", U::FARAD_PER_METRE).real(0.5, 2.0);
const MU: Symbol = Symbol::scalar("mu", U::HENRY_PER_METRE).real(0.5, 2.0);
const SIGMA: Symbol = Symbol::scalar("sigma", U::SIEMENS_PER_METRE).real(0.5, 2.0);
const AMPLITUDE: Symbol = Symbol::scalar("A", U::VOLT_PER_METRE).real(0.5, 2.0);

const E: Symbol = Symbol::vector("E", U::VOLT_PER_METRE).field();
const B: Symbol = Symbol::vector("B", U::TESLA).field();
const D: Symbol = Symbol::vector("D", U::COULOMB_PER_SQUARE_METRE).field();
const H: Symbol = Symbol::vector("H", U::AMPERE_PER_METRE).field();
const J: Symbol = Symbol::vector("J", U::AMPERE_PER_SQUARE_METRE).field();
const RHO: Symbol = Symbol::scalar("rho", U::COULOMB_PER_CUBIC_METRE).field();
/// The flow of energy.
const S: Symbol = Symbol::vector("S", U::WATT_PER_SQUARE_METRE);
/// The density of energy.
const ENERGY: Symbol = Symbol::scalar("u", U::JOULE_PER_CUBIC_METRE);

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
    let mut stream = sampling::stream(7, "proofs");
    chain.verify(16, precise::BITS, &mut stream).into_iter().map(|hop| hop.verdict).collect()
}

fn equal(left: impl Into<Expr>, right: impl Into<Expr>) -> Equation {
    Equation::new(left, right)
}

/// ∂²f/∂x²
fn twice(f: impl Into<Expr>, x: Symbol) -> Expr {
    partial(partial(f, &x), x)
}

#[test]
fn continuity_follows_from_maxwell() {
    let chain = |last| {
        Chain::new(-partial(RHO, T))
            .given(RHO, divergence(D), "∇·D = ρ")
            .given(partial(D, T), curl(H) - J, "∇×H = J + ∂D/∂t")
            .then(-partial(divergence(D), T), ["∇·D = ρ"])
            .then(-divergence(partial(D, T)), ["derivatives commute"])
            .then(-divergence(curl(H) - J), ["∇×H = J + ∂D/∂t"])
            .then(last, ["∇·(∇×H) = 0"])
    };
    only_this(chain, divergence(J), -divergence(J));
}

/// A uniform medium without charges, currents and losses.
fn source_free(chain: Chain) -> Chain {
    chain
        .given(divergence(E), 0, "∇·E = 0")
        .given(divergence(B), 0, "∇·B = 0")
        .given(partial(B, T), -curl(E), "∇×E = −∂B/∂t")
        .given(partial(E, T), curl(B) / (EPSILON * MU), "∇×B = εμ ∂E/∂t")
}

#[test]
fn curl_of_curl_is_a_second_time_derivative() {
    let chain = |last| {
        source_free(Chain::new(curl(curl(E))))
            .then(-curl(partial(B, T)), ["∇×E = −∂B/∂t"])
            .then(-partial(curl(B), T), ["derivatives commute"])
            .then(last, ["∇×B = εμ ∂E/∂t"])
    };
    only_this(chain, -(EPSILON * MU * twice(E, T)), EPSILON * MU * twice(E, T));
}

#[test]
fn the_electric_field_obeys_the_wave_equation() {
    let chain = |last| {
        source_free(Chain::new(equal(curl(curl(E)), gradient(divergence(E)) - laplacian(E))))
            .then(-laplacian(E), ["∇·E = 0"])
            .then(last, ["∇×(∇×E) = −εμ ∂²E/∂t²"])
    };
    let wave = |sign: i32| equal(laplacian(E) + sign * EPSILON * MU * twice(E, T), 0);
    only_this(chain, wave(-1), wave(1));
}

#[test]
fn so_does_the_magnetic_field() {
    let chain = |last| {
        source_free(Chain::new(curl(curl(B))))
            .then(EPSILON * MU * partial(curl(E), T), ["∇×B = εμ ∂E/∂t"])
            .then(-(EPSILON * MU * twice(B, T)), ["∇×E = −∂B/∂t"])
            .then(gradient(divergence(B)) - laplacian(B), ["∇×∇× = ∇∇· − ∇²"])
            .then(-laplacian(B), ["∇·B = 0"])
            .then(last, ["the third line"])
    };
    let wave = |factor: Expr| equal(laplacian(B) - factor * twice(B, T), 0);
    only_this(chain, wave(EPSILON * MU), wave(2 * EPSILON * MU));
}

/// A field that depends on z and t alone.
const WAVE: Symbol = Symbol::scalar("f", U::VOLT_PER_METRE);

#[test]
fn a_plane_wave_has_a_wave_equation_in_one_dimension() {
    let chain = |last| {
        Chain::new(laplacian(E) - EPSILON * MU * twice(E, T))
            .given(E, vector(WAVE.at([Z.into(), T.into()]), 0, 0), "along x, the same for all x and y")
            .then(last, ["∂/∂x = ∂/∂y = 0"])
    };
    let f = || WAVE.at([Z.into(), T.into()]);
    let reduced = |sign: i32| vector(twice(f(), Z) + sign * EPSILON * MU * twice(f(), T), 0, 0);
    only_this(chain, reduced(-1), reduced(1));
}

#[test]
fn any_two_waves_running_apart_solve_it() {
    const FIELD: Symbol = Symbol::scalar("E", U::VOLT_PER_METRE);
    const F_1: Symbol = Symbol::scalar("f_1", U::VOLT_PER_METRE);
    const F_2: Symbol = Symbol::scalar("f_2", U::VOLT_PER_METRE);
    let chain = |last| {
        let way = || T / sqrt(EPSILON * MU);
        Chain::new(FIELD + Expr::from(0))
            .given(FIELD, F_1.at([Z - way()]) + F_2.at([Z + way()]), "d'Alembert")
            .then(F_1.at([Z - way()]) + F_2.at([Z + way()]), ["d'Alembert"])
            .then(last, ["chain rule"])
    };
    let wave = |sign: i32| equal(twice(FIELD, Z), sign * EPSILON * MU * twice(FIELD, T));
    only_this(chain, wave(1), wave(-1));
}

#[test]
fn one_way_waves_solve_maxwells_equations() {
    let chain = |last| {
        let f = || WAVE.at([Z - V * T]);
        Chain::new(equal(divergence(E), 0))
            .given(E, vector(f(), 0, 0), "E = f(z − vt)")
            .given(B, vector(0, f() / V, 0), "B = f(z − vt)/v")
            .given(EPSILON, 1 / (MU * V.pow(2)), "v = 1/√(εμ)")
            .then(equal(divergence(B), 0), ["chain rule"])
            .then(equal(curl(E), -partial(B, T)), ["chain rule"])
            .then(last, ["chain rule"])
    };
    let ampere = |sign: i32| equal(curl(B), sign * EPSILON * MU * partial(E, T));
    only_this(chain, ampere(1), ampere(-1));
}

/// The wave vector, in any direction; complex where the wave is damped.
const K_VECTOR: Symbol = Symbol::vector("k", U::RADIAN_PER_METRE);
/// Amplitude and phase of the field along each axis.
const A: Symbol = Symbol::vector("A", U::VOLT_PER_METRE);
/// Place.
const R: Symbol = Symbol::vector("r", U::METRE);

const fn along(name: &'static str, unit: U) -> Symbol {
    Symbol::scalar(name, unit)
}

/// E = A exp(i(k·r − ωt)) with k·A = 0 and B = k×E/ω, in a medium that conducts with `sigma`.
fn oblique(start: impl Into<Claim>, sigma: Expr) -> Chain {
    let k = |axis| along(axis, U::RADIAN_PER_METRE);
    let a = |axis| along(axis, U::VOLT_PER_METRE);
    let across = (k("k_x") * a("A_x") + k("k_y") * a("A_y")) / k("k_z");
    Chain::new(start)
        .given(E, A * exp(i() * (dot(K_VECTOR, R) - OMEGA * T)), "plane wave")
        .given(B, cross(K_VECTOR, E) / OMEGA, "B = k×E/ω")
        .given(a("A_z"), -across, "k·A = 0")
        .given(MU, dot(K_VECTOR, K_VECTOR) / (EPSILON * OMEGA.pow(2) + i() * sigma * OMEGA), "dispersion")
}

#[test]
fn an_oblique_plane_wave_is_transverse_and_obeys_the_dispersion_relation() {
    let plane = |start: Expr| Chain::new(start).given(E, A * exp(i() * (dot(K_VECTOR, R) - OMEGA * T)), "plane wave");
    let transverse = |last| plane(divergence(E)).then(last, ["∇ = ik on a plane wave"]);
    only_this(transverse, i() * dot(K_VECTOR, E), -(i() * dot(K_VECTOR, E)));
    let dispersion = |last| plane(laplacian(E) - EPSILON * MU * twice(E, T)).then(last, ["∇ = ik, ∂/∂t = −iω"]);
    let k_squared = || dot(K_VECTOR, K_VECTOR);
    only_this(
        dispersion,
        (EPSILON * MU * OMEGA.pow(2) - k_squared()) * E,
        (EPSILON * MU * OMEGA.pow(2) + k_squared()) * E,
    );
    let lossy = |last| {
        plane(laplacian(E) - MU * SIGMA * partial(E, T) - EPSILON * MU * twice(E, T)).then(last, ["∇ = ik, ∂/∂t = −iω"])
    };
    let complex = |sign: i32| (EPSILON * MU * OMEGA.pow(2) + sign * i() * MU * SIGMA * OMEGA - k_squared()) * E;
    only_this(lossy, complex(1), complex(-1));
}

fn solves_maxwell(sigma: Expr) {
    let chain = |last| {
        oblique(equal(divergence(E), 0), sigma.clone())
            .then(equal(divergence(B), 0), ["∇ = ik", "k·(k×A) = 0"])
            .then(equal(curl(E), -partial(B, T)), ["∇ = ik, ∂/∂t = −iω"])
            .then(last, ["k×(k×A) = −k²A", "dispersion"])
    };
    let ampere = |sign: i32| equal(curl(B), MU * &sigma * E + sign * EPSILON * MU * partial(E, T));
    only_this(chain, ampere(1), ampere(-1));
}

#[test]
fn an_oblique_plane_wave_solves_all_of_maxwell() {
    solves_maxwell(Expr::from(0) * SIGMA);
}

#[test]
fn and_so_does_a_damped_one_in_a_conductor() {
    solves_maxwell(SIGMA.into());
}

/// A wave along z whose electric field is along x, E = A cos(kz − ωt), in a medium with ε and μ.
fn harmonic(start: impl Into<Claim>) -> Chain {
    let phase = || K * Z - OMEGA * T;
    Chain::new(start)
        .given(E, vector(AMPLITUDE * cos(phase()), 0, 0), "E = A cos(kz − ωt) along x")
        .given(B, vector(0, K / OMEGA * AMPLITUDE * cos(phase()), 0), "∇×E = −∂B/∂t")
        .given(H, B / MU, "B = μH")
        .given(K, OMEGA / V, "k = ω/v")
        .given(V, 1 / sqrt(EPSILON * MU), "v = 1/√(εμ)")
}

#[test]
fn electric_and_magnetic_field_stand_square_and_in_a_fixed_ratio() {
    let faraday = |last| harmonic(equal(curl(E), -partial(B, T))).then(last, ["chain rule"]);
    let ampere = |sign: i32| equal(curl(H), sign * EPSILON * partial(E, T));
    only_this(faraday, ampere(1), ampere(-1));
    let square = |last| harmonic(equal(dot(vector(0, 0, 1), E), 0)).then(last, ["across z and each other"]);
    only_this(square, equal(dot(E, B), 0), equal(dot(E, E), 0));
    let ratio = |last| harmonic(abs(E) / abs(B)).then(OMEGA / K, ["cancel the cosine"]).then(last, ["k = ω/v"]);
    only_this(ratio, 1 / sqrt(MU * EPSILON), sqrt(MU * EPSILON) * V.pow(2) * 2);
    let impedance =
        |last| harmonic(abs(E) / abs(H)).then(MU * OMEGA / K, ["cancel the cosine"]).then(last, ["k = ω/v"]);
    only_this(impedance, sqrt(MU / EPSILON), MU / EPSILON / sqrt(MU / EPSILON) * 2);
}

/// The mean of cos²(kz − ωt) over a period.
fn mean_square(chain: Chain) -> Chain {
    let phase = || K * Z - OMEGA * T;
    chain.given(PERIOD, 2 * pi() / OMEGA, "period").primitive(T / 2 - sin(2 * phase()) / (4 * OMEGA), T)
}

#[test]
fn the_mean_of_a_cosine_squared_is_one_half() {
    let chain = |last| {
        let square = cos(K * Z - OMEGA * T).pow(2);
        let over_a_period = 1 / PERIOD * integral_between(&square, T, 0, PERIOD);
        mean_square(Chain::new(mean(&square)).given(mean(square), &over_a_period, "mean"))
            .then(over_a_period, ["mean"])
            .then(last, ["2 cos²α = 1 + cos 2α"])
    };
    only_this(chain, ratio(1, 2), Expr::from(1));
}

#[test]
fn the_mean_flow_is_half_of_v_epsilon_a_squared() {
    let flow = || dot(vector(0, 0, 1), S);
    let chain = |last| {
        let over_a_period = 1 / PERIOD * integral_between(flow(), T, 0, PERIOD);
        let square = || cos(OMEGA / V * Z - OMEGA * T).pow(2);
        let chain = harmonic(mean(flow())).given(S, cross(E, H), "S = E×H").given(mean(flow()), &over_a_period, "mean");
        chain
            .given(PERIOD, 2 * pi() / OMEGA, "period")
            .primitive(V * EPSILON * AMPLITUDE.pow(2) * (T / 2 - sin(2 * (OMEGA / V * Z - OMEGA * T)) / (4 * OMEGA)), T)
            .then(over_a_period, ["mean"])
            .then(
                1 / PERIOD * integral_between(V * EPSILON * AMPLITUDE.pow(2) * square(), T, 0, PERIOD),
                ["S = E×H", "v = 1/√(εμ)"],
            )
            .then(last, ["⟨cos²⟩ = ½"])
    };
    let right = || ratio(1, 2) * V * EPSILON * AMPLITUDE.pow(2);
    only_this(chain, right(), 2 * right());
}

#[test]
fn poyntings_theorem_follows_from_maxwell() {
    let chain = |last| {
        Chain::new(divergence(S))
            .given(S, cross(E, H), "S = E×H")
            .given(ENERGY, (EPSILON * dot(E, E) + MU * dot(H, H)) / 2, "u = ½(εE² + μH²)")
            .given(partial(H, T), -curl(E) / MU, "∇×E = −∂B/∂t")
            .given(partial(E, T), (curl(H) - J) / EPSILON, "∇×H = J + ∂D/∂t")
            .then(dot(H, curl(E)) - dot(E, curl(H)), ["∇·(E×H)"])
            .then(
                -(MU * dot(H, partial(H, T))) - EPSILON * dot(E, partial(E, T)) - dot(J, E),
                ["∇×E = −∂B/∂t", "∇×H = J + ∂D/∂t"],
            )
            .then(-partial(ENERGY, T) - dot(J, E), ["u = ½(εE² + μH²)"])
            .then(last, ["to the left"])
    };
    let balance = |sign: i32| equal(divergence(S) + partial(ENERGY, T), sign * dot(J, E));
    only_this(chain, balance(-1), balance(1));
}

const RADIUS: Symbol = Symbol::scalar("R", U::METRE).real(0.5, 2.0);
const THETA: Symbol = Symbol::scalar("theta", U::ONE).real(0.2, 2.9);
const PHI: Symbol = Symbol::scalar("phi", U::ONE).real(0.0, 6.2);

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
