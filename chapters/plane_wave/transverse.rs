//! E15–E17: how E, B and the propagation stand to each other, in direction and in size.

use super::fields::{Plane, direction};
use super::one_way::at_one_cell_a_step;
use super::{VACUUM, quantity};
use crate::setting::{FREQUENCY, Setting};
use crate::symbols::{A_VECTOR, AMPLITUDE, B, E, EPSILON, H, K, K_VECTOR, MU, OMEGA, R, T, V, Z, Z_C};
use crate::vocabulary::{Bench, Bound, Check, Derivation, Measured, Quantity, Statement, Step};
use equation::derivation::{Chain, Claim};
use equation::expr::{abs, cos, cross, curl, divergence, dot, exp, i, partial, sin, sqrt, vector};
use equation::{Dimension, Equation, Expr, Symbol};
use light::Complex64;
use light::optics::{Incidence, fresnel};
use light::waves::constants::{C, Z_0};
use light::waves::{Medium, Wave};
use yardstick::random::uniform;

pub(super) const STEP: Step = Step {
    id: "transverse",
    title: "Square to each other, and in step",
    says: "E, B and the propagation are square to one another; the ratio of the fields is the speed, or an impedance.",
    rows: &["E15", "E16", "E17"],
    parameters: &[VACUUM, FREQUENCY],
    statements: &[
        Statement {
            id: "along",
            says: "no part of E along the propagation",
            rows: &["E15"],
            equation: || Equation::new(dot(vector(0, 0, 1), E), 0),
        },
        Statement {
            id: "square",
            says: "E and B are square to each other",
            rows: &["E15"],
            equation: || Equation::new(dot(E, B), 0),
        },
        Statement {
            id: "ratio",
            says: "the ratio of E to B is the speed of the wave",
            rows: &["E16"],
            equation: || Equation::new(abs(E) / abs(B), 1 / sqrt(MU * EPSILON)),
        },
        Statement {
            id: "speed",
            says: "v, once more",
            rows: &["E16"],
            equation: || Equation::new(V, 1 / sqrt(MU * EPSILON)),
        },
        Statement {
            id: "impedance",
            says: "the ratio of E to H is the characteristic impedance",
            rows: &["E17"],
            equation: || Equation::new(Z_C, sqrt(MU / EPSILON)),
        },
        Statement {
            id: "impedance_ratio",
            says: "by which it is defined",
            rows: &["E17"],
            equation: || Equation::new(Z_C, abs(E) / abs(H)),
        },
    ],
    derivations: &[
        Derivation {
            id: "no_part_along",
            says: "a uniform wave has nothing along z, and Faraday's law turns E into B by a right angle, at the same phase",
            rows: &["E15"],
            chain: || square(vector(0, K / OMEGA * AMPLITUDE * cos(phase()), 0)),
            spoiled: || square(vector(0, K / OMEGA * AMPLITUDE * sin(phase()), 0)),
            slip: "B a quarter of a period late, as in a standing wave",
        },
        Derivation {
            id: "across",
            says: "in any direction: no charges, so nothing along k",
            rows: &["E15"],
            chain: || across(i() * dot(K_VECTOR, E)),
            spoiled: || across(-(i() * dot(K_VECTOR, E))),
            slip: "a wave e^{i(k·r − ωt)} differentiated as if it ran the other way",
        },
        Derivation {
            id: "all_four",
            says: "E across k and B = k×E/ω obey all four equations, whatever the direction",
            rows: &["E15"],
            chain: || solves_maxwell(None, EPSILON * MU * partial(E, T)),
            spoiled: || solves_maxwell(None, -(EPSILON * MU * partial(E, T))),
            slip: "the sign of Ampère's law",
        },
        Derivation {
            id: "size",
            says: "both fields have the same cosine, which cancels",
            rows: &["E16"],
            chain: || ratio(1 / sqrt(MU * EPSILON)),
            spoiled: || ratio(2 / sqrt(MU * EPSILON)),
            slip: "a factor two, as for the average of a square",
        },
        Derivation {
            id: "ohms",
            says: "the same with H = B/μ",
            rows: &["E17"],
            chain: || impedance(sqrt(MU / EPSILON)),
            spoiled: || impedance(2 * sqrt(MU / EPSILON)),
            slip: "a factor two, as for the average of a square",
        },
    ],
    readout: Some(readout),
    checks: &[ANY_DIRECTION, SPLIT, VACUUM_IMPEDANCE, MISMATCH],
    stress: &[],
    races: &[],
    figures: &[],
};

fn phase() -> Expr {
    K * Z - OMEGA * T
}

/// E = A cos(kz − ωt) along x with its B and H.
pub(crate) fn harmonic(start: impl Into<Claim>) -> Chain {
    Chain::new(start)
        .given(E, vector(AMPLITUDE * cos(phase()), 0, 0), "E = A cos(kz − ωt) along x")
        .given(B, vector(0, K / OMEGA * AMPLITUDE * cos(phase()), 0), "∇×E = −∂B/∂t")
        .given(H, B / MU, "B = μH")
        .given(K, OMEGA / V, "k = ω/v")
        .given(V, 1 / sqrt(EPSILON * MU), "v = 1/√(εμ)")
}

fn square(b: Expr) -> Chain {
    Chain::new(Equation::new(dot(vector(0, 0, 1), E), 0))
        .given(E, vector(AMPLITUDE * cos(phase()), 0, 0), "E = A cos(kz − ωt) along x")
        .given(B, b, "the same cosine along y")
        .then(Equation::new(dot(E, B), 0), ["x and y are square"])
        .then(Equation::new(curl(E), -partial(B, T)), ["∂cos", "in step"])
}

/// E = A e^{i(k·r − ωt)}: a wave in any direction, damped where k is complex.
pub(super) fn oblique(start: impl Into<Claim>) -> Chain {
    Chain::new(start).given(E, A_VECTOR * exp(i() * (dot(K_VECTOR, R) - OMEGA * T)), "E = A e^{i(k·r − ωt)}")
}

/// A stands across k.
pub(crate) fn across_k(chain: Chain) -> Chain {
    let k = |name| Symbol::scalar(name, Dimension::RADIAN_PER_METRE);
    let a = |name| Symbol::scalar(name, Dimension::VOLT_PER_METRE);
    let rest = (k("k_x") * a("A_x") + k("k_y") * a("A_y")) / k("k_z");
    chain.given(a("A_z"), -rest, "k·A = 0")
}

fn across(last: Expr) -> Chain {
    oblique(divergence(E)).then(last, ["∇ = ik"]).because("which vanishes if k·E does")
}

/// Such a wave in all four equations, with `displacement` in Ampère's law and `sigma` where the medium conducts.
pub(super) fn solves_maxwell(sigma: Option<Symbol>, displacement: Expr) -> Chain {
    let k_squared = || dot(K_VECTOR, K_VECTOR);
    let (chain, ampere) = (oblique(Equation::new(divergence(E), 0)), |right| Equation::new(curl(B), right));
    let chain = across_k(chain.given(B, cross(K_VECTOR, E) / OMEGA, "B = k×E/ω"));
    let (chain, ampere) = match sigma {
        None => (chain.given(MU, k_squared() / (EPSILON * OMEGA.pow(2)), "k² = εμω²"), ampere(displacement)),
        Some(sigma) => {
            let both = EPSILON * OMEGA.pow(2) + i() * &sigma * OMEGA;
            (chain.given(MU, k_squared() / both, "k² = εμω² + iμσω"), ampere(MU * sigma * E + displacement))
        }
    };
    chain
        .then(Equation::new(divergence(B), 0), ["∇ = ik", "k·(k×A) = 0"])
        .then(Equation::new(curl(E), -partial(B, T)), ["∇ = ik, ∂/∂t = −iω"])
        .then(ampere, ["k×(k×A) = −k²A", "∇ = ik, ∂/∂t = −iω"])
}

fn ratio(last: Expr) -> Chain {
    harmonic(abs(E) / abs(B)).then(OMEGA / K, ["cancel the cosine"]).then(last, ["k = ω/v", "v = 1/√(εμ)"])
}

fn impedance(last: Expr) -> Chain {
    harmonic(abs(E) / abs(H)).then(MU * OMEGA / K, ["cancel the cosine"]).then(last, ["k = ω/v", "v = 1/√(εμ)"])
}

fn readout(setting: &Setting) -> Vec<Quantity> {
    let wave = super::wave(setting);
    vec![
        quantity("v_phase", "v", "speed of the phase", wave.v_phase, "m/s"),
        quantity("Z_re", "Re Z", "E over H, the part in phase", wave.impedance.re, "Ω"),
        quantity("Z_im", "Im Z", "E over H, the part out of phase", wave.impedance.im, "Ω"),
    ]
}

const ANY_DIRECTION: Check = Check {
    id: "any_direction",
    claim: "whatever the direction, k·E = k·B = E·B = 0 and both fields vanish together",
    rows: &["E15"],
    route: "the moments at which E, found by bisection, passes through zero; there B is looked at",
    bound: Bound::AtMost {
        limit: 64.0,
        unit: "ε",
        why: "cross products of unit vectors, and a phase of a few radians",
    },
    measure: |bench| any_direction(bench, |plane, _| plane),
    spoiled: |bench| any_direction(bench, |plane, tilt| Plane { e: plane.e + 1e-6 * tilt, ..plane }),
    slip: "E tilted by a millionth out of the plane across",
};

fn any_direction(bench: &mut Bench, amend: fn(Plane, glam::DVec3) -> Plane) -> Measured {
    let medium = Medium::relative(2.25, 1.3, 0.0).expect("a clear medium");
    let mut cases = Vec::new();
    for _ in 0..100 {
        let (run, swing) = (direction(&mut bench.stream), direction(&mut bench.stream));
        let phase = uniform(&mut bench.stream, 0.0, 1.0);
        let plane = amend(Plane::new(&medium, 1e15, run, swing, phase), run);
        let (k, e, b) = (plane.k.normalize(), plane.e, plane.b / plane.b.length());
        let zero = zero_of(|time| plane.at(glam::DVec3::ZERO, time).0.dot(e), 0.0, std::f64::consts::PI / plane.omega);
        let there = plane.at(glam::DVec3::ZERO, zero).1.dot(b) / plane.b.length();
        let at = format!("k along {k:.3}");
        cases.extend([k.dot(e), k.dot(b), e.dot(b), there].map(|value| (value / f64::EPSILON, at.clone())));
    }
    Measured::worst(cases)
}

/// Where `f` changes its sign between two places, by bisection to the last digit.
pub(super) fn zero_of(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let rises = f(low) < 0.0;
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if (f(middle) < 0.0) == rises { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// Neither speed nor impedance is put in: ε and μ are, and the grid finds out.
const SPLIT: Check = Check {
    id: "split_pulse",
    claim: "a pulse of E without B splits into two halves, in each of which |E|/|B| = v",
    rows: &["E16"],
    route: "the solver of chapter maxwell, from a start with B = 0",
    bound: Bound::AtMost {
        limit: 1e-12,
        unit: "1",
        why: "at one cell a step the grid carries either half unchanged but for a few roundings a step",
    },
    measure: |_| split(|wave| wave.v_phase),
    spoiled: |_| split(|_| C),
    slip: "c in place of v",
};

fn split(speed: fn(&Wave) -> f64) -> Measured {
    let media = [(1.0, 1.0), (2.25, 1.0), (4.0, 2.0), (80.0, 1.0)];
    Measured::worst(media.map(|(epsilon_r, mu_r)| {
        let medium = Medium::relative(epsilon_r, mu_r, 0.0).expect("a clear medium");
        let wave = Wave::new(&medium, 1e9).expect("a positive frequency");
        let mut line = at_one_cell_a_step(1200, epsilon_r, mu_r);
        line.set(|z| (-((z - 600.0) / 40.0).powi(2)).exp(), |_| 0.0);
        line.run(300).expect("some steps");
        let most = |values: &[f64]| values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        let ratio = most(&line.e()[600..]) / (medium.mu() * most(&line.h()[600..]));
        (ratio / speed(&wave) - 1.0, format!("ε_r = {epsilon_r}, μ_r = {mu_r}"))
    }))
}

const VACUUM_IMPEDANCE: Check = Check {
    id: "vacuum_impedance",
    claim: "empty space has an impedance of 376.73 Ω",
    rows: &["E17"],
    route: "CODATA 2022: Z₀ = 376.730 313 412(59) Ω",
    bound: Bound::AtMost { limit: 2e-10, unit: "1", why: "the uncertainty CODATA states, 1.6e−10" },
    measure: |_| vacuum(|wave| wave.impedance.re),
    spoiled: |_| vacuum(|_| 120.0 * std::f64::consts::PI),
    slip: "120π Ω, with c rounded to 3e8 m/s",
};

fn vacuum(impedance: fn(&Wave) -> f64) -> Measured {
    let frequencies = [1e-3, 1.0, 1e9, 1e16];
    Measured::worst(frequencies.map(|omega| {
        let wave = Wave::new(&Medium::VACUUM, omega).expect("a positive frequency");
        (impedance(&wave) / 376.730_313_412 - 1.0, format!("ω = {omega} rad/s"))
    }))
}

const MISMATCH: Check = Check {
    id: "mismatch",
    claim: "what an interface sends back is (Z₂ − Z₁)/(Z₂ + Z₁), as on a line with a wrong end",
    rows: &["E17"],
    route: "the Fresnel coefficient at normal incidence, which knows indices and no impedance",
    bound: Bound::AtMost { limit: 16.0, unit: "ε", why: "a few roundings on either side, of numbers below 1" },
    measure: |_| mismatch(|z| z),
    spoiled: |_| mismatch(|z| Z_0 * Z_0 / z),
    slip: "the impedances upside down",
};

fn mismatch(amend: fn(Complex64) -> Complex64) -> Measured {
    let cases = [1.33, 1.5, 2.4, 4.0, 9.0];
    Measured::worst(cases.map(|n: f64| {
        let glass = Medium::relative(n * n, 1.0, 0.0).expect("a clear medium");
        let [z_1, z_2] =
            [Medium::VACUUM, glass].map(|medium| amend(Wave::new(&medium, 1e15).expect("positive").impedance));
        let line = (z_2 - z_1) / (z_2 + z_1);
        let r_s = fresnel::amplitudes(Incidence::NORMAL, 1.0, n.into()).r_s;
        ((line - r_s).norm() / f64::EPSILON, format!("n = {n}"))
    }))
}
