//! E15–E17: how E, B and the propagation stand to each other, in direction and in size.

use super::fields::{Plane, direction};
use super::one_way::at_one_cell_a_step;
use super::{VACUUM, quantity};
use crate::diagram::{Diagram, Part};
use crate::figure::{Hue, Plot};
use crate::parameter::{FREQUENCY, Setting};
use crate::symbols::{A_VECTOR, AMPLITUDE, B, E, EPSILON, H, K, K_VECTOR, MU, OMEGA, R, T, V, Z, Z_C};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Misled, Quantity, Question, Step, check, derivation, exhibit, figure,
    question, statement, step,
};
use equation::derivation::{Chain, Claim};
use equation::expr::{abs, cos, cross, curl, divergence, dot, exp, i, partial, sin, sqrt, vector};
use equation::{Dimension, Equation, Expr, Symbol};
use light::Complex64;
use light::optics::{Incidence, fresnel};
use light::waves::constants::{C, Z_0};
use light::waves::{Medium, Wave};
use std::f64::consts::TAU;
use yardstick::random::uniform;

pub(super) const EXHIBIT: Exhibit = exhibit(
    "transverse",
    &[VACUUM, FREQUENCY],
    &[figure(
        "side_view",
        "E, B and k along a clear wave: E up where B comes out of the page, and the other way half a wavelength on.",
        square,
    )],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Square to each other, and in step",
    "E, B and the propagation are square to one another; the ratio of the fields is the speed, or an impedance.",
)
.rows(&["E15", "E16", "E17"])
.about("impedance")
.statements(&[
    statement("along", "no part of E along the propagation", || Equation::new(dot(vector(0, 0, 1), E), 0))
        .rows(&["E15"]),
    statement("square", "E and B are square to each other", || Equation::new(dot(E, B), 0)).rows(&["E15"]),
    statement("ratio", "the ratio of E to B is the speed of the wave", || {
        Equation::new(abs(E) / abs(B), 1 / sqrt(MU * EPSILON))
    })
    .rows(&["E16"]),
    statement("speed", "v, once more", || Equation::new(V, 1 / sqrt(MU * EPSILON))).rows(&["E16"]),
    statement("impedance", "the ratio of E to H is the characteristic impedance", || {
        Equation::new(Z_C, sqrt(MU / EPSILON))
    })
    .rows(&["E17"]),
    statement("impedance_ratio", "by which it is defined", || Equation::new(Z_C, abs(E) / abs(H))).rows(&["E17"]),
])
.questions(&[SHARE])
.derivations(&[
    derivation("no_part_along", "without charges a wave that runs along z has nothing along z", || {
        no_part_along(vector(0, 0, 1))
    })
    .rows(&["E15"])
    .slip("the divergence read as a curl: nothing would be left across", || no_part_along(vector(1, 0, 0))),
    derivation("in_step", "Faraday's law turns E into B by a right angle, at the same phase", || {
        in_step(vector(0, K / OMEGA * AMPLITUDE * cos(phase()), 0))
    })
    .rows(&["E15"])
    .slip("B a quarter of a period late, as in a standing wave", || {
        in_step(vector(0, K / OMEGA * AMPLITUDE * sin(phase()), 0))
    }),
    derivation("across", "in any direction: no charges, so nothing along k", || across(i() * dot(K_VECTOR, E)))
        .rows(&["E15"])
        .slip("a wave e^{i(k·r − ωt)} differentiated as if it ran the other way", || {
            across(-(i() * dot(K_VECTOR, E)))
        }),
    derivation("all_four", "E across k and B = k×E/ω obey all four equations, whatever the direction", || {
        solves_maxwell(None, EPSILON * MU * partial(E, T))
    })
    .rows(&["E15"])
    .slip("the sign of Ampère's law", || solves_maxwell(None, -(EPSILON * MU * partial(E, T)))),
    derivation("size", "both fields have the same cosine, which cancels", || ratio(1 / sqrt(MU * EPSILON)))
        .rows(&["E16"])
        .slip("a factor two, as for the average of a square", || ratio(2 / sqrt(MU * EPSILON))),
    derivation("ohms", "the same with H = B/μ", || impedance(sqrt(MU / EPSILON)))
        .rows(&["E17"])
        .slip("a factor two, as for the average of a square", || impedance(2 * sqrt(MU / EPSILON))),
])
.readout(readout)
.checks(&[&ANY_DIRECTION, &SPLIT, &VACUUM_IMPEDANCE, &MISMATCH]);

const SHARE: Question = question(
    "magnetic_share",
    "In sunlight E has some 900 V/m and B some 3 µT. Which share of the light's energy is in the magnetic field?",
    Answer::Number {
        unit: "1",
        tolerance: 0.01,
        right: |_| {
            let wave = Wave::new(&Medium::VACUUM, C).expect("a positive frequency");
            let (electric, magnetic) = (Medium::VACUUM.epsilon(), Medium::VACUUM.mu() / wave.impedance.norm_sqr());
            magnetic / (electric + magnetic)
        },
        slips: &[
            Misled {
                value: |_| 0.0,
                reply: "The number of teslas is small only because a tesla is large. Compare ½εE² and ½μH².",
            },
            Misled { value: |_| 1.0, reply: "Neither field could run without the other." },
        ],
    },
    "One half, in any clear medium: E/H = √(μ/ε) says just that μH² is εE².",
);

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

fn no_part_along(direction: Expr) -> Chain {
    let [a_x, a_y, a_z] = ["A_x", "A_y", "A_z"].map(|name| Symbol::scalar(name, Dimension::VOLT_PER_METRE));
    let amplitude = vector(a_x, a_y, &a_z);
    Chain::assume(Equation::new(divergence(E), 0), "∇·E = 0")
        .given(E, amplitude * exp(i() * phase()), "E = A e^{i(kz − ωt)}")
        .solve_for([a_z])
        .then(Equation::new(dot(direction, E), 0), ["∂/∂x = ∂/∂y = 0", "∂/∂z = ik"])
}

fn in_step(b: Expr) -> Chain {
    Chain::new(Equation::new(dot(E, B), 0))
        .because("x and y are square to each other")
        .given(E, vector(AMPLITUDE * cos(phase()), 0, 0), "E = A cos(kz − ωt) along x")
        .given(B, b, "the same cosine along y")
        .then(Equation::new(curl(E), -partial(B, T)), ["∂cos", "in step"])
}

/// E = A e^{i(k·r − ωt)}: a wave in any direction, damped where k is complex.
pub(super) fn oblique(start: impl Into<Claim>) -> Chain {
    Chain::new(start).given(E, A_VECTOR * exp(i() * (dot(K_VECTOR, R) - OMEGA * T)), "E = A e^{i(k·r − ωt)}")
}

/// A stands across k: it is k×G with some G, whichever way k points.
pub(crate) fn across_k(chain: Chain) -> Chain {
    const G: Symbol = Symbol::vector("G", Dimension::VOLT);
    chain.given(A_VECTOR, cross(K_VECTOR, G), "k·A = 0")
}

fn across(last: Expr) -> Chain {
    oblique(divergence(E)).then(last, ["∇ = ik"]).because("which is nought without charges, and so k·E is")
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

const ANY_DIRECTION: Check<fn(Plane, glam::DVec3) -> Plane> =
    check("any_direction", "whatever the direction, k·E = k·B = E·B = 0 and both fields vanish together")
        .rows(&["E15"])
        .against("the moments at which E, found by bisection, passes through zero; there B is looked at")
        .within(64.0, "ulp", "cross products of unit vectors, and a phase of a few radians")
        .of(any_direction, |plane, _| plane)
        .slip("E tilted by a millionth out of the plane across", |plane, tilt| Plane {
            e: plane.e + 1e-6 * tilt,
            ..plane
        });

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
const SPLIT: Check<fn(&Wave) -> f64> =
    check("split_pulse", "a pulse of E without B splits into two halves, in each of which |E|/|B| = v")
        .rows(&["E16"])
        .against("the solver of chapter maxwell, from a start with B = 0")
        .within(1e-12, "1", "at one cell a step the grid carries either half unchanged but for a few roundings a step")
        .of(split, |wave| wave.v_phase)
        .slip("c in place of v", |_| C);

fn split(_: &mut Bench, speed: fn(&Wave) -> f64) -> Measured {
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

const VACUUM_IMPEDANCE: Check<fn(&Wave) -> f64> = check("vacuum_impedance", "empty space has an impedance of 376.73 Ω")
    .rows(&["E17"])
    .against("CODATA 2022: Z₀ = 376.730 313 412(59) Ω")
    .within(2e-10, "1", "the uncertainty CODATA states, 1.6e−10")
    .of(vacuum, |wave| wave.impedance.re)
    .slip("120π Ω, with c rounded to 3e8 m/s", |_| 120.0 * std::f64::consts::PI);

fn vacuum(_: &mut Bench, impedance: fn(&Wave) -> f64) -> Measured {
    let frequencies = [1e-3, 1.0, 1e9, 1e16];
    Measured::worst(frequencies.map(|omega| {
        let wave = Wave::new(&Medium::VACUUM, omega).expect("a positive frequency");
        (impedance(&wave) / 376.730_313_412 - 1.0, format!("ω = {omega} rad/s"))
    }))
}

const MISMATCH: Check<fn(Complex64) -> Complex64> =
    check("mismatch", "what an interface sends back is (Z₂ − Z₁)/(Z₂ + Z₁), as on a line with a wrong end")
        .rows(&["E17"])
        .against("the Fresnel coefficient at normal incidence, which knows indices and no impedance")
        .within(16.0, "ulp", "a few roundings on either side, of numbers below 1")
        .of(mismatch, |z| z)
        .slip("the impedances upside down", |z| Z_0 * Z_0 / z);

fn mismatch(_: &mut Bench, amend: fn(Complex64) -> Complex64) -> Measured {
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

/// A wavelength and a half, from the side.
fn square(_: &Setting) -> Plot {
    let (length, turns) = (6.0, 1.5);
    let field = |z: f64| (turns * TAU * z / length).cos();
    let curve = (0..=240).map(|at| length * f64::from(at) / 240.0).map(|z| [z, field(z)]).collect();
    let arrows = (0..=18).map(|at| length * f64::from(at) / 18.0).filter(|z| field(*z).abs() > 0.2).map(|z| {
        let arrow = Part::vector([z, 0.0], [z, field(z)]).hue(Hue::S);
        if z == 0.0 { arrow.label("E") } else { arrow }
    });
    let across = (0..4).map(|half| {
        let z = f64::from(half) * length / 3.0;
        let part = Part::across([z, -0.35 * field(z)], field(z) > 0.0).hue(Hue::P);
        if half == 0 { part.label("B") } else { part }
    });
    let diagram = Diagram::new("", [-0.5, -1.25], [7.1, 1.4])
        .with(Part::ray([0.0, 0.0], [6.9, 0.0]).label("k"))
        .with(Part::curve(curve).hue(Hue::S))
        .with_all(arrows)
        .with_all(across)
        .with(Part::line([0.0, 1.2], [4.0, 1.2]).hue(Hue::Reference).label("λ"));
    Plot::of("Square to each other, and in step", diagram)
}
