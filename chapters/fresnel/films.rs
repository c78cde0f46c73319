//! C15: the same boundary conditions, repeated: coherent stacks of films.

use super::symbols::{K_0, N_1, N_2, THETA_1};
use super::{N_I, N_T};
use crate::figure::{Axis, Chart, Hue, Map, Plot, Ramp};
use crate::setting::{DEFAULT_WAVELENGTH, Kind, Parameter, Setting, THETA, WAVELENGTH};
use crate::vocabulary::{
    ALLOWED_ULPS, Bench, Bound, Check, Derivation, Expects, Extreme, Figure, Heat, Lane, Measured, Quantity, Race,
    Statement, Step, Stress,
};
use light::Complex64;
use light::equation::derivation::Chain;
use light::equation::expr::{exp, i, sin, sqrt};
use light::equation::{Dimension, Equation, Expr, Symbol};
use light::evidence::film::{Reference, condition, reference};
use light::optics::film::textbook::{characteristic_matrix, recursion, transfer_matrix};
use light::optics::film::{Layer, Polarisation, Powers, Stack};
use light::optics::fresnel::amplitudes_between;
use light::optics::material::{self, Medium};
use light::optics::{Direction, Incidence};
use light::precise::{self, Real};
use light::sampling::uniform;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, FRAC_PI_4, TAU};

/// Substrate.
const N_S: Parameter = Parameter { name: "n_s", symbol: "n_s", says: "substrate", default: "bk7", ..N_T };
/// High-index film.
const N_H: Parameter = Parameter { name: "n_h", symbol: "n_H", says: "high-index film", default: "tio2", ..N_T };
/// Low-index film.
const N_L: Parameter = Parameter { name: "n_l", symbol: "n_L", says: "low-index film", default: "mgf2", ..N_T };
/// Length of the mirror.
const PAIRS: Parameter = Parameter {
    name: "pairs",
    symbol: "N",
    says: "low–high pairs under the mirror's first high film: 2N + 1 films",
    default: "10",
    kind: Kind::Number { min: 0.0, max: 200.0, unit: "1" },
};
/// The wavelength that the films are a quarter of.
const DESIGN: Parameter =
    Parameter { says: "vacuum wavelength: each film is a quarter of it thick, in its own medium", ..WAVELENGTH };

const THICKNESS: Symbol = Symbol::scalar("d", Dimension::METRE).real(0.1, 1.0);
const DELTA: Symbol = Symbol::scalar("delta", Dimension::ONE).within(0.2, 1.4);
const N_3: Symbol = Symbol::scalar("n_3", Dimension::ONE).within(1.0, 2.5);
const R: Symbol = Symbol::scalar("r", Dimension::ONE);
const R_12: Symbol = Symbol::scalar("r_12", Dimension::ONE).within(0.1, 0.6);
const R_21: Symbol = Symbol::scalar("r_21", Dimension::ONE).within(0.1, 0.6);
const R_23: Symbol = Symbol::scalar("r_23", Dimension::ONE).within(0.1, 0.6);
const T_12: Symbol = Symbol::scalar("t_12", Dimension::ONE).within(0.4, 0.9);
const T_21: Symbol = Symbol::scalar("t_21", Dimension::ONE).within(0.4, 0.9);
/// What all bounces inside the film send back together.
const B: Symbol = Symbol::scalar("b", Dimension::ONE);

pub(super) const STEP: Step = Step {
    id: "films",
    title: "Stacks of films",
    says: "Waves that bounce between interfaces add up in phase: coatings that reflect nothing, or nearly all.",
    rows: &["C15"],
    parameters: &[N_I, N_S, N_H, N_L, PAIRS, THETA, DESIGN],
    statements: &[
        Statement {
            id: "phase",
            says: "phase across a film of thickness d",
            rows: &["C15"],
            equation: || Equation::new(DELTA, K_0 * THICKNESS * sqrt(N_2.pow(2) - N_1.pow(2) * sin(THETA_1).pow(2))),
        },
        Statement {
            id: "airy",
            says: "a film: both faces and every bounce between them",
            rows: &["C15"],
            equation: || Equation::new(R, airy(1 + R_12 * R_23 * round_trip())),
        },
        Statement {
            id: "quarter_wave",
            says: "a film a quarter of a wave thick, at normal incidence: nothing is left where n₂² = n₁n₃",
            rows: &["C15"],
            equation: || Equation::new(R, quarter_wave()),
        },
    ],
    derivations: &[
        Derivation {
            id: "bounces",
            says: "each bounce repeats the one before times r₂₁r₂₃e^(2iδ): a geometric series",
            rows: &["C15"],
            chain: || bounces(airy(1 + R_12 * R_23 * round_trip())),
            spoiled: || bounces(airy(1 - R_12 * R_23 * round_trip())),
            slip: "r₂₁ is taken for r₁₂, without Stokes' sign",
        },
        Derivation {
            id: "quarter_wave_from_airy",
            says: "with e^(2iδ) = −1 and E36 at both faces",
            rows: &["C15"],
            chain: || quarter(quarter_wave()),
            spoiled: || quarter((N_1 * N_2 - N_3.pow(2)) / (N_1 * N_2 + N_3.pow(2))),
            slip: "film and substrate are interchanged",
        },
    ],
    readout: Some(readout),
    checks: &[BOUNCES, QUARTER_WAVES, REVERSAL, ENERGY, PARRATT],
    stress: &[
        Stress {
            id: "opaque",
            claim: "transmission keeps its digits behind metal films down to 1e−300, and its logarithm far below",
            rows: &["C15"],
            textbook: "the characteristic matrix cos δ, sin δ in f64",
            reference: "Parratt's recursion in 256 bits or more",
            cases: |_| opaque(),
        },
        Stress {
            id: "critical",
            claim: "gaps wide or narrow, at a film's critical angle or a hair beside it, at grazing incidence",
            rows: &["C15"],
            textbook: "Rouard's recursion of Fresnel coefficients in f64",
            reference: "Parratt's recursion in 256 bits or more",
            cases: |_| critical(),
        },
        Stress {
            id: "many",
            claim: "a thousand films keep the digits of R and T",
            rows: &["C15"],
            textbook: "the characteristic matrix in f64",
            reference: "Parratt's recursion in 256 bits or more",
            cases: |_| many(),
        },
    ],
    races: &[
        Race { id: "one_film", claim: "one film costs a fraction of a microsecond", lanes: &ONE_FILM, ..ORDINARY },
        Race { id: "five_films", claim: "five films", lanes: &FIVE_FILMS, ..ORDINARY },
        Race { id: "mirror", claim: "a mirror of 21 films", lanes: &TWENTY_ONE_FILMS, ..ORDINARY },
        OPAQUE_FILM,
    ],
    figures: &[
        Figure {
            id: "antireflection",
            says: "One film takes most of the reflection away, two nearly all at one wavelength, three over a band.",
            rows: &["C15"],
            plot: antireflection,
        },
        Figure {
            id: "mirror_spectrum",
            says: "The mirror's band of high reflectance moves to the blue with the angle.",
            rows: &["C15"],
            plot: mirror_band,
        },
        Figure {
            id: "mirror_map",
            says: "The same mirror over wavelength and angle.",
            rows: &["C15"],
            plot: mirror_map,
        },
        Figure {
            id: "frustrated",
            says: "Total reflection is undone by a second prism near enough: light tunnels through the gap.",
            rows: &["C15"],
            plot: frustrated,
        },
    ],
};

fn round_trip() -> Expr {
    exp(2 * i() * DELTA)
}

fn airy(denominator: Expr) -> Expr {
    (R_12 + R_23 * round_trip()) / denominator
}

fn quarter_wave() -> Expr {
    (N_1 * N_3 - N_2.pow(2)) / (N_1 * N_3 + N_2.pow(2))
}

/// Airy's sum (1833), by what it does to itself: b = first bounce + b bounced once more.
fn bounces(last: Expr) -> Chain {
    let (first, ratio) = (T_12 * R_23 * T_21 * round_trip(), R_21 * R_23 * round_trip());
    let summed = &first / (1 - &ratio);
    let denominator = 1 + R_12 * R_23 * round_trip();
    Chain::new(Equation::new(B, &first + &ratio * B))
        .because("through the first face, off the second, out again; and all further bounces")
        .given(B, summed.clone(), "linear solve")
        .given(R_21, -Expr::from(R_12), "Stokes")
        .given(T_21, (1 - R_12.pow(2)) / T_12, "Stokes")
        .then(Equation::new(R_12 + B, R_12 + summed), ["linear solve"])
        .then(
            (R_12 * &denominator + (1 - R_12.pow(2)) * R_23 * round_trip()) / denominator,
            ["Stokes", "common denominator"],
        )
        .then(last, ["cancel"])
}

fn quarter(last: Expr) -> Chain {
    let step = |near: Symbol, far: Symbol| (&near - &far) / (near + far);
    Chain::new((R_12 - R_23) / (1 - R_12 * R_23))
        .because("e^(2iδ) = −1")
        .given(R_12, step(N_1, N_2), "E36 at θ = 0")
        .given(R_23, step(N_2, N_3), "E36 at θ = 0")
        .then(
            ((N_1 - N_2) * (N_2 + N_3) - (N_2 - N_3) * (N_1 + N_2))
                / ((N_1 + N_2) * (N_2 + N_3) - (N_1 - N_2) * (N_2 - N_3)),
            ["E36", "common denominator"],
        )
        .then(last, ["multiply out"])
}

/// A stack that owns its films.
#[derive(Clone, Debug)]
struct Films {
    n_i: f64,
    layers: Vec<Layer>,
    substrate: Complex64,
}

impl Films {
    fn stack(&self) -> Stack<'_> {
        Stack { n_i: self.n_i, layers: &self.layers, substrate: self.substrate }
    }

    /// R [1] of natural light.
    fn natural(&self, wavelength: f64, incidence: Incidence) -> f64 {
        let [s, p] = BOTH.map(|polarisation| self.stack().response(wavelength, incidence, polarisation).reflectance);
        0.5 * (s + p)
    }
}

const BOTH: [Polarisation; 2] = [Polarisation::S, Polarisation::P];

fn film(n: f64, k: f64, thickness: f64) -> Layer {
    Layer { index: Complex64::new(n, k), thickness }
}

/// A film a quarter of the `design` wavelength thick.
fn quarter_film(n: f64, design: f64) -> Layer {
    film(n, 0.0, design / (4.0 * n))
}

/// The setting's mirror at a wavelength: its films keep the thickness that the setting's wavelength gave them. `None`
/// outside a material's data.
fn mirror(setting: &Setting, wavelength: f64) -> Option<Films> {
    let design = setting.wavelength();
    let medium = |name: &str| setting.medium(name).index(wavelength).ok();
    let coat = |name: &str| Some(Layer { index: medium(name)?, thickness: design / (4.0 * setting.index(name).re) });
    let (high, low) = (coat("n_h")?, coat("n_l")?);
    let count = 2 * setting.number("pairs").round() as usize + 1;
    let layers = (0..count).map(|at| if at % 2 == 0 { high } else { low }).collect();
    Some(Films { n_i: medium("n_i")?.re, layers, substrate: medium("n_s")? })
}

fn readout(setting: &Setting) -> Vec<Quantity> {
    let wavelength = setting.wavelength();
    let incidence = super::incidence(setting);
    let films = mirror(setting, wavelength).expect("validated when it was set");
    let [s, p] = BOTH.map(|polarisation| films.stack().response(wavelength, incidence, polarisation));
    let number = |key, symbol, says, value| Quantity { key, symbol, says, value, unit: "1" };
    vec![
        number("films", "2N + 1", "films", films.layers.len() as f64),
        Quantity {
            key: "d_h",
            symbol: "d_H",
            says: "thickness of a high-index film",
            value: films.layers[0].thickness,
            unit: "m",
        },
        number("R_s", "R_s", "reflectance, s", s.reflectance),
        number("R_p", "R_p", "reflectance, p", p.reflectance),
        number("T_s", "T_s", "transmittance, s", s.transmittance),
        number("T_p", "T_p", "transmittance, p", p.transmittance),
        number("A_s", "A_s", "absorbed in the films, s", s.absorptance),
        number("A_p", "A_p", "absorbed in the films, p", p.absorptance),
    ]
}

const BOUNCES: Check = Check {
    id: "every_bounce",
    claim: "the field that a film reflects is the sum of all bounces in it",
    rows: &["C15"],
    route: "bounce after bounce in f64, with Fresnel's coefficients at each face, until they vanish",
    bound: Bound::AtMost { limit: 128.0, unit: "ε", why: "a dozen roundings in each of up to a hundred bounces" },
    measure: |bench| against_bounces(bench, |t_12, t_21| t_12 * t_21),
    spoiled: |bench| against_bounces(bench, |t_12, _| t_12 * t_12),
    slip: "the light leaves the film with t₁₂, not t₂₁",
};

fn against_bounces(bench: &mut Bench, passage: fn(Complex64, Complex64) -> Complex64) -> Measured {
    let films = [(1.38, 0.0, 1.52, 0.0), (2.35, 0.0, 1.52, 0.0), (1.5, 0.05, 3.0, 1.0), (0.2, 3.4, 1.52, 0.0)];
    let cases = films.into_iter().flat_map(|(n, k, n_s, k_s)| {
        let theta = uniform(&mut bench.stream, 0.0, 1.5);
        let thickness = uniform(&mut bench.stream, 10e-9, 300e-9);
        let films = Films { n_i: 1.0, layers: vec![film(n, k, thickness)], substrate: Complex64::new(n_s, k_s) };
        BOTH.map(move |polarisation| (films.clone(), theta, polarisation))
    });
    Measured::worst(cases.map(|(films, theta, polarisation)| {
        let incidence = Incidence::from_angle(theta);
        let ours = films.stack().response(DEFAULT_WAVELENGTH, incidence, polarisation).r;
        let sum = sum_of_bounces(&films, incidence, polarisation, passage);
        ((ours - sum).norm() / f64::EPSILON, format!("{polarisation:?}, {:?}, θ = {theta:.3}", films.layers[0]))
    }))
}

/// r₁₂ + t₁₂t₂₁ Σ r₂₃ (r₂₁r₂₃)^m e^(2i(m+1)δ) of a single film.
fn sum_of_bounces(
    films: &Films,
    incidence: Incidence,
    polarisation: Polarisation,
    passage: fn(Complex64, Complex64) -> Complex64,
) -> Complex64 {
    let (n_1, n_2, n_3) = (Complex64::from(films.n_i), films.layers[0].index, films.substrate);
    let beta = n_1 * incidence.sin();
    let face = |near, far| {
        let a = amplitudes_between(beta, near, far);
        if polarisation == Polarisation::S { (a.r_s, a.t_s) } else { (a.r_p, a.t_p) }
    };
    let ((r_12, t_12), (r_21, t_21), (r_23, _)) = (face(n_1, n_2), face(n_2, n_1), face(n_2, n_3));
    let q = ((n_2 - beta) * (n_2 + beta)).sqrt();
    let there_and_back = (Complex64::I * 2.0 * TAU / DEFAULT_WAVELENGTH * films.layers[0].thickness * q).exp();
    let mut bounce = passage(t_12, t_21) * r_23 * there_and_back;
    let mut sum = r_12;
    for _ in 0..2000 {
        sum += bounce;
        bounce *= r_21 * r_23 * there_and_back;
    }
    sum
}

const QUARTER_WAVES: Check = Check {
    id: "quarter_waves",
    claim: "mirrors of quarter waves transmit what the closed form says, from one film to 101",
    rows: &["C15"],
    route: "each quarter wave turns an admittance Y into n²/Y (Born & Wolf, 7th ed., §1.6.5): T = 4n₁Y/(n₁ + Y)²",
    bound: Bound::AtMost {
        limit: 512.0,
        unit: "ε",
        why: "a few roundings for each of 101 films; the rounded thickness does not count, since T is stationary there",
    },
    measure: |_| against_admittance(|n, y| n * n / y),
    spoiled: |_| against_admittance(|n, y| n * y),
    slip: "Y becomes nY",
};

fn against_admittance(turn: fn(f64, f64) -> f64) -> Measured {
    let designs = [(1, 1.38, 1.38), (1, 2.35, 1.0), (3, 2.35, 1.38), (21, 2.35, 1.38), (101, 2.0, 1.45)];
    Measured::worst(designs.map(|(count, high, low)| {
        let films = quarter_wave_mirror(count, high, low);
        let powers = films.stack().response(DEFAULT_WAVELENGTH, Incidence::NORMAL, Polarisation::S);
        let admittance = films.layers.iter().rev().fold(films.substrate.re, |y, layer| turn(layer.index.re, y));
        let sum = films.n_i + admittance;
        let closed = 4.0 * films.n_i * admittance / (sum * sum);
        ((powers.transmittance / closed - 1.0) / f64::EPSILON, format!("{count} films of {high} and {low}"))
    }))
}

/// `count` films of alternating index, the high one first, on glass.
fn quarter_wave_mirror(count: usize, high: f64, low: f64) -> Films {
    let layers = (0..count).map(|at| quarter_film(if at % 2 == 0 { high } else { low }, DEFAULT_WAVELENGTH));
    Films { n_i: 1.0, layers: layers.collect(), substrate: Complex64::from(1.52) }
}

/// `count` films at random between clear media, some of them absorbing as much as `most`.
fn random_films(bench: &mut Bench, count: usize, most: f64) -> (Films, f64) {
    let mut draw = |low, high| uniform(&mut bench.stream, low, high);
    let layers = (0..count)
        .map(|at| film(draw(1.2, 2.6), if at % 2 == 0 { draw(0.0, most) } else { 0.0 }, draw(20e-9, 300e-9)))
        .collect();
    (Films { n_i: draw(1.0, 1.2), layers, substrate: Complex64::from(draw(1.3, 1.9)) }, draw(0.0, 1.4))
}

const REVERSAL: Check = Check {
    id: "reversal",
    claim: "a stack transmits as much from behind as from the front, even one that absorbs",
    rows: &["C15"],
    route: "the same films in reverse order, lit along the refracted ray",
    bound: Bound::AtMost {
        limit: 256.0,
        unit: "ε",
        why: "some ten roundings a film, magnified by the phases (up to 20 rad) and by the rounded angle of return",
    },
    measure: |bench| from_behind(bench, |there, back| back.transmittance / there.transmittance - 1.0),
    spoiled: |bench| from_behind(bench, |there, back| back.reflectance / there.reflectance - 1.0),
    slip: "the same is claimed of reflection",
};

fn from_behind(bench: &mut Bench, change: fn(&Powers, &Powers) -> f64) -> Measured {
    Measured::worst((0..12).flat_map(|_| {
        let (films, theta) = random_films(bench, 6, 0.1);
        let there = Incidence::from_angle(theta);
        let sin = films.n_i * there.sin() / films.substrate.re;
        let back = Incidence::from_angle(sin.asin());
        let layers = films.layers.iter().rev().copied().collect();
        let reversed = Films { n_i: films.substrate.re, layers, substrate: films.n_i.into() };
        BOTH.map(|polarisation| {
            let [there, back] = [(&films, there), (&reversed, back)].map(|(films, incidence)| {
                let mut powers = [Powers { reflectance: 0.0, transmittance: 0.0, absorptance: 0.0 }];
                films.stack().waves(incidence, polarisation).powers(&[DEFAULT_WAVELENGTH], &mut powers);
                powers[0]
            });
            (change(&there, &back) / f64::EPSILON, format!("{polarisation:?}, θ = {theta:.3}, six films"))
        })
    }))
}

const ENERGY: Check = Check {
    id: "energy",
    claim: "|r|², the flow that t carries and what the films absorb make up the incident power",
    rows: &["C15"],
    route: "r and t as fields, A from the losses film by film: three numbers that share no sum",
    bound: Bound::AtMost { limit: 64.0, unit: "ε", why: "some ten roundings for each of six films" },
    measure: |bench| balance(bench, |flux, t| flux * t.norm_sqr()),
    spoiled: |bench| balance(bench, |_, t| t.norm_sqr()),
    slip: "T taken as |t|²",
};

fn balance(bench: &mut Bench, through: fn(f64, Complex64) -> f64) -> Measured {
    Measured::worst((0..24).flat_map(|_| {
        let (films, theta) = random_films(bench, 6, 0.5);
        let incidence = Incidence::from_angle(theta);
        let sin_s = films.n_i * incidence.sin() / films.substrate.re;
        let cos_s = ((1.0 - sin_s) * (1.0 + sin_s)).sqrt();
        let flux = films.substrate.re * cos_s / (films.n_i * incidence.cos());
        BOTH.map(|polarisation| {
            let found = films.stack().response(DEFAULT_WAVELENGTH, incidence, polarisation);
            let sum = found.r.norm_sqr() + through(flux, found.t) + found.absorptance;
            ((sum - 1.0) / f64::EPSILON, format!("{polarisation:?}, θ = {theta:.3}, six films"))
        })
    }))
}

const PARRATT: Check = Check {
    id: "parratt",
    claim: "R, T and A of stacks at random are right to the last digits that the inputs fix",
    rows: &["C15"],
    route: "Parratt's recursion of interface coefficients (1954) in 256 bits: another form, another precision",
    bound: Bound::AtMost {
        limit: ALLOWED_ULPS,
        unit: "ε(1+κ)",
        why: "the project's promise: no more than a few roundings beyond what the inputs' own rounding does",
    },
    measure: |bench| against_parratt(bench, 1.0),
    spoiled: |bench| against_parratt(bench, 0.5),
    slip: "the wave crosses each film once where it should there and back",
};

/// Error in ε(1 + κ) of films whose thickness is `scale` times what it should be.
fn against_parratt(bench: &mut Bench, scale: f64) -> Measured {
    let cases = [(1, 0.0), (3, 0.2), (5, 0.0)];
    Measured::worst(cases.into_iter().zip(BOTH.into_iter().cycle()).flat_map(|((count, most), polarisation)| {
        let (films, theta) = random_films(bench, count, most);
        let angle = Direction::Angle(theta);
        let exact = reference(&films.stack(), DEFAULT_WAVELENGTH, angle, polarisation);
        let kappa = condition(&films.stack(), DEFAULT_WAVELENGTH, angle, polarisation);
        let scaled = films.layers.iter().map(|layer| Layer { thickness: layer.thickness * scale, ..*layer }).collect();
        let ours = Films { layers: scaled, ..films.clone() };
        let ours = ours.stack().response(DEFAULT_WAVELENGTH, Incidence::from(angle), polarisation);
        let error = move |name: &str, ours: f64, exact: &Real, kappa: f64| {
            let error = precise::relative_error(ours, exact) / (f64::EPSILON * (1.0 + kappa));
            (error, format!("{name} of {count} films, {polarisation:?}, θ = {theta:.3}"))
        };
        [
            error("R", ours.reflectance, &exact.reflectance, kappa.reflectance),
            error("T", ours.transmittance, &exact.transmittance, kappa.transmittance),
        ]
    }))
}

/// The powers that a textbook form gives.
type TextbookForm = fn(&Stack, f64, Incidence, Polarisation) -> Powers;

/// Which number of a stack is looked at.
#[derive(Clone, Copy, Debug)]
enum Output {
    Reflectance,
    Transmittance,
    LnTransmittance,
}

/// One number of a stack at 550 nm beside its reference and a textbook form.
fn extreme(
    input: &str,
    films: &Films,
    angle: Direction,
    polarisation: Polarisation,
    output: Output,
    form: TextbookForm,
) -> Extreme {
    let stack = films.stack();
    let exact = reference(&stack, DEFAULT_WAVELENGTH, angle, polarisation);
    let kappa = condition(&stack, DEFAULT_WAVELENGTH, angle, polarisation);
    let ours = stack.response(DEFAULT_WAVELENGTH, Incidence::from(angle), polarisation);
    let book = form(&stack, DEFAULT_WAVELENGTH, Incidence::from(angle), polarisation);
    let (quantity, reference, textbook, ours, condition) = match output {
        Output::Reflectance => ("R", exact.reflectance, book.reflectance, ours.reflectance, kappa.reflectance),
        Output::Transmittance => {
            ("T", exact.transmittance, book.transmittance, ours.transmittance, kappa.transmittance)
        }
        Output::LnTransmittance => (
            "ln T",
            exact.ln_transmittance.unwrap_or(precise::real(0.0)),
            book.transmittance.ln(),
            ours.ln_transmittance,
            kappa.ln_transmittance,
        ),
    };
    Extreme {
        input: format!("{input}, {}", if polarisation == Polarisation::S { "s" } else { "p" }),
        quantity,
        reference,
        textbook,
        ours,
        condition,
        worst_of: 1,
    }
}

/// A film between `n_i` and a substrate.
fn between(n_i: f64, layer: Layer, substrate: f64) -> Films {
    Films { n_i, layers: vec![layer], substrate: substrate.into() }
}

fn opaque() -> Vec<Extreme> {
    let silver = |thickness| between(1.0, film(0.055, 3.32, thickness), 1.52);
    let dense = |thickness| between(1.0, film(3.0, 1e3, thickness), 1.52);
    let case = |name: &str, films: Films, theta, output| {
        extreme(name, &films, Direction::Angle(theta), Polarisation::P, output, characteristic_matrix)
    };
    vec![
        case("silver, 1 µm, θ = 45°", silver(1e-6), FRAC_PI_4, Output::Transmittance),
        case("silver, 8.9 µm, θ = 45°", silver(8.9e-6), FRAC_PI_4, Output::Transmittance),
        case("silver, 20 µm, θ = 45°", silver(20e-6), FRAC_PI_4, Output::LnTransmittance),
        case("silver, 1 mm, θ = 45°", silver(1e-3), FRAC_PI_4, Output::LnTransmittance),
        case("silver, 1 mm, θ = 45°", silver(1e-3), FRAC_PI_4, Output::Reflectance),
        case("n = 3 + 1000i, 100 nm, θ = 1.5", dense(1e-7), 1.5, Output::LnTransmittance),
        case("n = 3 + 1000i, 1 m, θ = 0", dense(1.0), 0.0, Output::LnTransmittance),
    ]
}

fn critical() -> Vec<Extreme> {
    let gap = |thickness| between(1.5, film(1.0, 0.0, thickness), 1.5);
    let own = |thickness| between(1.0, film(1.0, 0.0, thickness), 1.5);
    let edge = (1.0f64 / 1.5).asin();
    let case = |name: &str, films: Films, angle, polarisation, output| {
        extreme(name, &films, angle, polarisation, output, recursion)
    };
    let mut cases = vec![
        case(
            "air gap of 100 µm, θ = 60°",
            gap(1e-4),
            Direction::Angle(FRAC_PI_3),
            Polarisation::S,
            Output::LnTransmittance,
        ),
        case("air gap of 1 pm, θ = 60°", gap(1e-12), Direction::Angle(FRAC_PI_3), Polarisation::P, Output::Reflectance),
        case(
            "film on glass, 1e−12 from grazing",
            own(1e-7),
            Direction::Grazing(1e-12),
            Polarisation::S,
            Output::Transmittance,
        ),
        case(
            "film on glass, 1e−18 from grazing",
            own(1e-7),
            Direction::Grazing(1e-18),
            Polarisation::P,
            Output::Transmittance,
        ),
    ];
    for (offset, name) in [(0.0, "at"), (1e-12, "1e−12 beyond"), (-1e-12, "1e−12 below")] {
        for (polarisation, thickness) in [(Polarisation::S, 1e-7), (Polarisation::P, 1e-7)] {
            let name = format!("air gap of 100 nm, {name} its critical angle");
            let angle = Direction::Angle(edge + offset);
            cases.push(case(&name, gap(thickness), angle, polarisation, Output::Reflectance));
        }
    }
    cases
}

fn many() -> Vec<Extreme> {
    let mut tinted = quarter_wave_mirror(1000, 3.5, 1.38);
    for layer in &mut tinted.layers {
        layer.index.im = 1e-6;
    }
    let gaps =
        (0..1000).map(|at| film(if at % 2 == 0 { 1.0 } else { 1.5 }, 0.0, if at % 2 == 0 { 1e-6 } else { 1e-7 }));
    let gaps = Films { n_i: 1.5, layers: gaps.collect(), substrate: 1.5.into() };
    let case = |name: &str, films: &Films, theta, output| {
        extreme(name, films, Direction::Angle(theta), Polarisation::S, output, characteristic_matrix)
    };
    vec![
        case("1000 quarter waves of 3.5 and 1.38, κ = 1e−6", &tinted, 0.0, Output::Reflectance),
        case("500 air gaps of 1 µm between films of glass, θ = 60°", &gaps, FRAC_PI_3, Output::LnTransmittance),
    ]
}

const ORDINARY: Race = Race {
    id: "",
    claim: "",
    rows: &["C15"],
    work: "evaluations of one stack at one wavelength",
    reference: "largest relative error of T; Parratt's recursion in 256 bits at some of the wavelengths",
    lanes: &[],
};

const ONE_FILM: [Lane; 4] = lanes::<1>();
const FIVE_FILMS: [Lane; 4] = lanes::<5>();
const TWENTY_ONE_FILMS: [Lane; 4] = lanes::<21>();

const EVALUATIONS: &[u64] = &[256, 1024, 4096];

/// Textbook and program on a mirror of `COUNT` quarter waves over the visible, where no form breaks.
const fn lanes<const COUNT: usize>() -> [Lane; 4] {
    const ROUNDING: Expects = Expects::Within {
        limit: 1e-11,
        why: "roundings, magnified by T's condition at the edges of the mirror's band",
    };
    [
        Lane {
            id: "characteristic_matrix",
            label: "characteristic matrix",
            works: EVALUATIONS,
            expects: ROUNDING,
            repeats: 1,
            prepare: |_, work| {
                singly(work, visible_mirror(COUNT), |s, w, i, p| characteristic_matrix(s, w, i, p).transmittance)
            },
        },
        Lane {
            id: "transfer_matrix",
            label: "transfer matrix",
            works: EVALUATIONS,
            expects: ROUNDING,
            repeats: 1,
            prepare: |_, work| {
                singly(work, visible_mirror(COUNT), |s, w, i, p| transfer_matrix(s, w, i, p).transmittance)
            },
        },
        Lane {
            id: "single",
            label: "this program, one at a time",
            works: EVALUATIONS,
            expects: ROUNDING,
            repeats: 1,
            prepare: |_, work| singly(work, visible_mirror(COUNT), |s, w, i, p| s.response(w, i, p).transmittance),
        },
        Lane {
            id: "batch",
            label: "this program, many wavelengths at once",
            works: EVALUATIONS,
            expects: ROUNDING,
            repeats: 1,
            prepare: |_, work| in_batch(work, visible_mirror(COUNT)),
        },
    ]
}

fn visible_mirror(count: usize) -> Films {
    quarter_wave_mirror(count, 2.35, 1.38)
}

/// A protected silver mirror 20 µm thick.
fn thick_mirror() -> Films {
    let protection = quarter_film(1.38, DEFAULT_WAVELENGTH);
    Films { n_i: 1.0, layers: vec![protection, film(0.055, 3.32, 20e-6)], substrate: 1.52.into() }
}

const OPAQUE_FILM: Race = Race {
    id: "opaque_film",
    claim: "behind opaque silver the textbook forms lose every digit, however long they compute",
    reference: "largest relative error of ln T; Parratt's recursion in 256 bits at some of the wavelengths",
    lanes: &[
        Lane {
            id: "characteristic_matrix",
            label: "characteristic matrix",
            works: EVALUATIONS,
            expects: Expects::Breaks { limit: 1e-3, why: "cos δ and sin δ overflow" },
            repeats: 1,
            prepare: |_, work| opaque_heat(work, |s, w, i, p| characteristic_matrix(s, w, i, p).transmittance.ln()),
        },
        Lane {
            id: "transfer_matrix",
            label: "transfer matrix, Im δ clamped",
            works: EVALUATIONS,
            expects: Expects::Breaks { limit: 1e-3, why: "the clamp holds T near 1e−31" },
            repeats: 1,
            prepare: |_, work| opaque_heat(work, |s, w, i, p| transfer_matrix(s, w, i, p).transmittance.ln()),
        },
        Lane {
            id: "recursion",
            label: "recursion of coefficients",
            works: EVALUATIONS,
            expects: Expects::Breaks { limit: 1e-3, why: "T itself underflows" },
            repeats: 1,
            prepare: |_, work| opaque_heat(work, |s, w, i, p| recursion(s, w, i, p).transmittance.ln()),
        },
        Lane {
            id: "single",
            label: "this program",
            works: EVALUATIONS,
            expects: Expects::Within { limit: 1e-14, why: "the decay is a sum of exponents, never multiplied out" },
            repeats: 1,
            prepare: |_, work| opaque_heat(work, |s, w, i, p| s.response(w, i, p).ln_transmittance),
        },
    ],
    ..ORDINARY
};

fn opaque_heat(work: u64, logarithm: SingleForm) -> Heat {
    let exact = |found: Reference| found.ln_transmittance.expect("something comes through");
    raced(work, thick_mirror(), exact, one_by_one(logarithm))
}

/// θ of the races [rad]: oblique, so that no short cut of normal incidence helps.
const RACE_ANGLE: f64 = 0.5;
/// How many results of a run are held against 256 bits.
const SAMPLE: usize = 8;

/// `count` wavelengths over the visible.
fn wavelengths(count: u64) -> Vec<f64> {
    (0..count).map(|at| 400e-9 + 300e-9 * (at as f64 + 0.5) / count as f64).collect()
}

/// One number of a stack at one wavelength.
type SingleForm = fn(&Stack, f64, Incidence, Polarisation) -> f64;

fn one_by_one(form: SingleForm) -> impl FnMut(&Films, &[f64], &mut [f64]) {
    let incidence = Incidence::from_angle(RACE_ANGLE);
    move |films, wavelengths, found| {
        for (found, &wavelength) in found.iter_mut().zip(wavelengths) {
            *found = form(&films.stack(), wavelength, incidence, Polarisation::S);
        }
    }
}

/// T of `films`, one wavelength after the other.
fn singly(work: u64, films: Films, transmittance: SingleForm) -> Heat {
    raced(work, films, |found| found.transmittance, one_by_one(transmittance))
}

/// T of `films`, all wavelengths in one call.
fn in_batch(work: u64, films: Films) -> Heat {
    let incidence = Incidence::from_angle(RACE_ANGLE);
    let mut powers = vec![Powers { reflectance: 0.0, transmittance: 0.0, absorptance: 0.0 }; work as usize];
    let method = move |films: &Films, wavelengths: &[f64], found: &mut [f64]| {
        films.stack().waves(incidence, Polarisation::S).powers(wavelengths, &mut powers);
        for (found, powers) in found.iter_mut().zip(&powers) {
            *found = powers.transmittance;
        }
    };
    raced(work, films, |found| found.transmittance, method)
}

/// A run of `work` wavelengths; a few of its results are handed on and held against 256 bits.
fn raced(
    work: u64,
    films: Films,
    exact: fn(Reference) -> Real,
    mut method: impl FnMut(&Films, &[f64], &mut [f64]) + 'static,
) -> Heat {
    let wavelengths = wavelengths(work);
    let places = (0..wavelengths.len()).step_by(wavelengths.len() / SAMPLE);
    let sample: Vec<f64> = places.clone().map(|place| wavelengths[place]).collect();
    let judged = films.clone();
    let mut found = vec![0.0; wavelengths.len()];
    Heat {
        run: Box::new(move || {
            method(&films, &wavelengths, &mut found);
            places.clone().map(|place| found[place]).collect()
        }),
        error: Box::new(move |found| {
            let errors = found.iter().zip(&sample).map(|(&found, &wavelength)| {
                let angle = Direction::Angle(RACE_ANGLE);
                let exact = exact(reference(&judged.stack(), wavelength, angle, Polarisation::S));
                (precise::relative_error(found, &exact), String::new())
            });
            Measured::worst(errors).value
        }),
    }
}

/// Coatings of the setting's substrate, of real media, each film a quarter of 550 nm thick; the third has a half wave of
/// titania between the other two, which does nothing at the centre and widens the band.
fn antireflection(setting: &Setting) -> Plot {
    let designs: [(&str, &[(&str, f64)]); 4] = [
        ("bare", &[]),
        ("MgF_2", &[("mgf2", 1.0)]),
        ("MgF_2, Al_2O_3", &[("mgf2", 1.0), ("sapphire", 1.0)]),
        ("MgF_2, 2 TiO_2, Al_2O_3", &[("mgf2", 1.0), ("tio2", 2.0), ("sapphire", 1.0)]),
    ];
    let curves = designs.map(|(label, coats)| {
        let curve = (0..=175).map(|step| 400.0 + 2.0 * f64::from(step)).map(|nanometres| {
            let films = coated(setting, coats, nanometres * 1e-9);
            let reflectance = films.map(|films| films.natural(nanometres * 1e-9, Incidence::NORMAL));
            [nanometres, reflectance.unwrap_or(f64::NAN)]
        });
        (label, curve.collect::<Vec<_>>())
    });
    let most = curves[0].1.iter().map(|point| point[1]).filter(|r| r.is_finite()).fold(0.01, f64::max);
    let axes = Chart::new(
        "",
        Axis::linear("vacuum wavelength λ", "nm").range(400.0, 750.0).tick(50.0),
        Axis::linear("reflectance R", "").range(0.0, 1.1 * most),
    );
    let hues = (0..).map(Hue::Nth);
    let chart = curves.into_iter().zip(hues).fold(axes, |chart, ((label, curve), hue)| chart.line(hue, label, curve));
    Plot::of("Antireflection coatings", chart)
}

/// The setting's substrate under films of the named materials, `quarters` quarter waves of 550 nm thick.
fn coated(setting: &Setting, coats: &[(&str, f64)], wavelength: f64) -> Option<Films> {
    let layers = coats.iter().map(|&(name, quarters)| {
        let medium = Medium::Material(material::named(name)?);
        let design = medium.index(DEFAULT_WAVELENGTH).ok()?.re;
        Some(Layer { index: medium.index(wavelength).ok()?, thickness: quarters * DEFAULT_WAVELENGTH / (4.0 * design) })
    });
    let substrate = setting.medium("n_s").index(wavelength).ok()?;
    let n_i = setting.medium("n_i").index(wavelength).ok()?.re;
    Some(Films { n_i, layers: layers.collect::<Option<_>>()?, substrate })
}

/// Wavelengths [m] about the setting's, as far as its mirror's first band reaches.
const BAND: (f64, f64) = (0.7, 1.4);

fn mirror_band(setting: &Setting) -> Plot {
    let design = setting.wavelength();
    let oblique = super::incidence(setting);
    let curve = |value: &dyn Fn(&Films, f64) -> f64| -> Vec<[f64; 2]> {
        let steps = (0..=700).map(|step| design * (BAND.0 + (BAND.1 - BAND.0) * f64::from(step) / 700.0));
        let reflectance = |wavelength| mirror(setting, wavelength).map_or(f64::NAN, |films| value(&films, wavelength));
        steps.map(|wavelength| [wavelength * 1e9, reflectance(wavelength)]).collect()
    };
    let polarised = |polarisation| {
        curve(&move |films: &Films, wavelength| films.stack().response(wavelength, oblique, polarisation).reflectance)
    };
    let degrees = setting.number("theta").to_degrees();
    let chart = Chart::new(
        "",
        Axis::linear("vacuum wavelength λ", "nm").range(design * BAND.0 * 1e9, design * BAND.1 * 1e9),
        Axis::linear("reflectance R", "").range(0.0, 1.0),
    )
    .line(Hue::Natural, "θ_1 = 0°", curve(&|films, wavelength| films.natural(wavelength, Incidence::NORMAL)))
    .line(Hue::S, format!("R_s, θ_1 = {degrees:.0}°"), polarised(Polarisation::S))
    .line(Hue::P, format!("R_p, θ_1 = {degrees:.0}°"), polarised(Polarisation::P));
    Plot::of(format!("A mirror of {} films", 2 * setting.number("pairs").round() as usize + 1), chart)
}

const MAP_COLUMNS: usize = 160;
const MAP_ROWS: usize = 90;

fn mirror_map(setting: &Setting) -> Plot {
    let design = setting.wavelength();
    let stacks: Vec<_> = (0..MAP_COLUMNS)
        .map(|column| {
            let across = (column as f64 + 0.5) / MAP_COLUMNS as f64;
            let wavelength = design * (BAND.0 + (BAND.1 - BAND.0) * across);
            (wavelength, mirror(setting, wavelength))
        })
        .collect();
    let mut values = Vec::with_capacity(MAP_COLUMNS * MAP_ROWS);
    for row in 0..MAP_ROWS {
        let incidence = Incidence::from_angle((row as f64 + 0.5) / MAP_ROWS as f64 * FRAC_PI_2);
        values.extend(
            stacks.iter().map(|(wavelength, films)| {
                films.as_ref().map_or(f64::NAN, |films| films.natural(*wavelength, incidence))
            }),
        );
    }
    let map = Map {
        title: String::new(),
        x: Axis::linear("vacuum wavelength λ", "nm").range(design * BAND.0 * 1e9, design * BAND.1 * 1e9),
        y: Axis::linear("angle of incidence θ_1", "°").range(0.0, 90.0).tick(30.0),
        colour: Axis::linear("reflectance R_n", "").range(0.0, 1.0),
        ramp: Ramp::Sequential,
        columns: MAP_COLUMNS,
        values,
        marks: Vec::new(),
    };
    Plot::of("The mirror over wavelength and angle", map)
}

fn frustrated(_: &Setting) -> Plot {
    let mut chart = Chart::new(
        "n 1.5 → air gap → 1.5",
        Axis::log("gap over wavelength d/λ", "").range(1e-2, 1e1),
        Axis::log("transmittance T", "").range(1e-12, 1.0),
    );
    for (place, degrees) in (0..).zip([45.0f64, 60.0, 75.0]) {
        let incidence = Incidence::from(Direction::Angle(degrees.to_radians()));
        let curve = |polarisation| -> Vec<[f64; 2]> {
            let gaps = (0..=240).map(|step| 10f64.powf(f64::from(step) / 80.0 - 2.0));
            let through = |gap: f64| {
                let films = between(1.5, film(1.0, 0.0, gap * DEFAULT_WAVELENGTH), 1.5);
                films.stack().response(DEFAULT_WAVELENGTH, incidence, polarisation).transmittance
            };
            gaps.map(|gap| [gap, through(gap)]).collect()
        };
        chart = chart.line(Hue::Nth(place), format!("s, {degrees:.0}°"), curve(Polarisation::S)).dashed(
            Hue::Nth(place),
            format!("p, {degrees:.0}°"),
            curve(Polarisation::P),
        );
    }
    Plot::of("Frustrated total reflection", chart)
}
