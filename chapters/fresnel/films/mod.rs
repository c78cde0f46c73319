//! C15: the same boundary conditions, repeated: coherent stacks of films.

mod checks;
mod extremes;
mod figures;
mod races;

use self::checks::{BOUNCES, ENERGY, PARRATT, QUARTER_WAVES, REVERSAL};
use self::extremes::{critical, many, opaque};
use self::figures::{antireflection, bounces as bounces_drawn, frustrated, mirror_band, mirror_map};
use self::races::{FIVE_FILMS, ONE_FILM, OPAQUE_FILM, ORDINARY, TWENTY_ONE_FILMS};
use super::N_I;
use super::amplitudes::{contrast, r_p, r_s, t_p, t_s};
use super::symbols::{K_0, N_1, N_2, THETA_1, THETA_2};
use crate::parameter::{Kind, Parameter, Setting, THETA, WAVELENGTH};
use crate::vocabulary::{
    Answer, Exhibit, Quantity, Question, Step, choice, derivation, exhibit, figure, question, statement, step, stress,
};
use equation::derivation::Chain;
use equation::expr::{cos, exp, i, pi, sin, sqrt};
use equation::{Dimension, Equation, Expr, Symbol};
use light::Complex64;
use light::Polarisation;
use light::optics::Incidence;
use light::optics::film::{Layer, Stack};

/// Substrate.
const N_S: Parameter = Parameter::new("n_s", "n_s", "substrate", Kind::Medium).default("bk7");
/// High-index film.
const N_H: Parameter = Parameter::new("n_h", "n_H", "high-index film", Kind::Medium).default("tio2");
/// Low-index film.
const N_L: Parameter = Parameter::new("n_l", "n_L", "low-index film", Kind::Medium).default("mgf2");
/// Length of the mirror.
const PAIRS: Parameter = Parameter::new(
    "pairs",
    "N",
    "low–high pairs under the mirror's first high film: 2N + 1 films",
    Kind::Count { min: 0, max: 200 },
)
.default("10");
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
/// The field that is continuous: E for s, H for p, at the film's back.
const PSI: Symbol = Symbol::scalar("psi", Dimension::ONE).within(0.5, 1.5);
/// Its partner, φ = Yψ for a wave that runs on.
const PHI: Symbol = Symbol::scalar("phi", Dimension::ONE).within(0.5, 1.5);
/// The film's admittance: q for s, q/n² for p.
const Y: Symbol = Symbol::scalar("Y", Dimension::ONE).within(0.5, 2.0);
/// The admittances on the three sides of the two faces.
const Y_1: Symbol = Symbol::scalar("Y_1", Dimension::ONE).within(0.5, 2.0);
const Y_2: Symbol = Symbol::scalar("Y_2", Dimension::ONE).within(0.5, 2.0);
const Y_3: Symbol = Symbol::scalar("Y_3", Dimension::ONE).within(0.5, 2.0);
/// The wave behind the film.
const THROUGH: Symbol = Symbol::scalar("t", Dimension::ONE);
const PSI_ON: Symbol = Symbol::scalar("psi_+", Dimension::ONE);
const PSI_BACK: Symbol = Symbol::scalar("psi_-", Dimension::ONE);
/// What all bounces inside the film send back together.
const B: Symbol = Symbol::scalar("b", Dimension::ONE);

pub(super) const EXHIBIT: Exhibit = exhibit(
    "films",
    &[N_I, N_S, N_H, N_L, PAIRS, THETA, DESIGN],
    &[
        figure(
            "round_trips",
            "A film and the waves in it: each way round adds r_{21}r_{23}e^{2iδ}, and all that comes out on one side adds up.",
            bounces_drawn,
        ),
        figure(
            "antireflection",
            "One film takes most of the reflection away, two nearly all at one wavelength, \
             three over a band.",
            antireflection,
        ),
        figure(
            "mirror_spectrum",
            "The mirror's band of high reflectance moves to the blue with the angle.",
            mirror_band,
        ),
        figure("mirror_map", "The same mirror over wavelength and angle.", mirror_map),
        figure(
            "frustrated",
            "Total reflection is undone by a second prism near enough: light tunnels through \
             the gap.",
            frustrated,
        ),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Stacks of films",
    "Waves that bounce between interfaces add up in phase: coatings that reflect \
     nothing, or nearly all.",
)
.rows(&["C15"])
.about("airy")
.statements(&[
    statement("phase", "phase across a film of thickness d", || {
        Equation::new(DELTA, K_0 * THICKNESS * sqrt(N_2.pow(2) - N_1.pow(2) * sin(THETA_1).pow(2)))
    }),
    statement("airy", "a film: both faces and every bounce between them", || {
        Equation::new(R, airy(1 + R_12 * R_23 * round_trip()))
    }),
    statement(
        "quarter_wave",
        "a film a quarter of a wave thick, at normal incidence: nothing is left where n₂² \
         = n₁n₃",
        || Equation::new(R, quarter_wave()),
    ),
])
.questions(&[ONE_MORE_FACE])
.derivations(&[
    derivation(
        "layer",
        "ψ at a film's face from ψ and φ at its back, with the growing wave e^(−iδ) taken \
         out",
        || layer((1 + round_trip()) * PSI / 2 + (1 - round_trip()) * PHI / (2 * Y)),
    )
    .slip("the sign of the wave that runs back", || {
        layer((1 + round_trip()) * PSI / 2 - (1 - round_trip()) * PHI / (2 * Y))
    }),
    derivation("stokes_s", "the way back through a face, s: r′ = −r and t t′ = 1 − r² (Stokes)", || {
        stokes(r_s(), t_s(), 1 - R_12.pow(2))
    })
    .slip("the sign of r²", || stokes(r_s(), t_s(), 1 + R_12.pow(2))),
    derivation("stokes_p", "the same for p", || stokes(r_p(), t_p(), 1 - R_12.pow(2)))
        .slip("t_s for t_p", || stokes(r_p(), t_s(), 1 - R_12.pow(2))),
    derivation(
        "bounces",
        "each bounce repeats the one before times r₂₁r₂₃e^(2iδ): a geometric series",
        || bounces(airy(1 + R_12 * R_23 * round_trip())),
    )
    .slip("r₂₁ is taken for r₁₂, without Stokes' sign", || bounces(airy(1 - R_12 * R_23 * round_trip()))),
    derivation("both_faces", "the boundary conditions at both faces at once: the same sum", || {
        at_both_faces(airy(1 + R_12 * R_23 * round_trip()))
    })
    .slip("the sign of the second bounce", || at_both_faces(airy(1 - R_12 * R_23 * round_trip()))),
    derivation("quarter_wave_from_airy", "with e^(2iδ) = −1 and E36 at both faces", || quarter(quarter_wave()))
        .slip("film and substrate are interchanged", || quarter((N_1 * N_2 - N_3.pow(2)) / (N_1 * N_2 + N_3.pow(2)))),
])
.readout(readout)
.checks(&[&BOUNCES, &QUARTER_WAVES, &REVERSAL, &ENERGY, &PARRATT])
.stress(&[
    stress(
        "opaque",
        "transmission keeps its digits behind metal films down to 1e−300, and its \
         logarithm far below",
        |_| opaque(),
    )
    .textbook("the characteristic matrix cos δ, sin δ in f64")
    .against("Parratt's recursion in 256 bits or more"),
    stress(
        "critical",
        "gaps wide or narrow, at a film's critical angle or a hair beside it, at grazing \
         incidence",
        |_| critical(),
    )
    .textbook("Rouard's recursion of Fresnel coefficients in f64")
    .against("Parratt's recursion in 256 bits or more"),
    stress("many", "thousands of films keep the digits of R, T and A", |_| many())
        .textbook("the characteristic matrix in f64")
        .against("Parratt's recursion in 256 bits or more"),
])
.races(&[
    ORDINARY.named("one_film", "one film costs a fraction of a microsecond").lanes(&ONE_FILM),
    ORDINARY
        .named("five_films", "five films: many wavelengths at once cost a fraction of one at a time")
        .lanes(&FIVE_FILMS),
    ORDINARY.named("mirror", "a mirror of 21 films: the same").lanes(&TWENTY_ONE_FILMS),
    OPAQUE_FILM,
]);

const ONE_MORE_FACE: Question = question(
    "one_more_face",
    "A lens of n = 1.52 reflects 4 % at its face. It gets a film of n = 1.38, a quarter of a wave thick. What does \
     it reflect now?",
    Answer::Choice {
        options: &[
            choice(
                "more: there is one more face to reflect",
                "Two reflections need not add. The second one comes back half a period late.",
            ),
            choice(
                "as much: the film's faces only share the step in index",
                "Without the film's thickness it would be so. A quarter of a wave there and a quarter back are half \
                 a period.",
            ),
            choice("less: a third or so", ""),
            choice(
                "nothing",
                "For that the two reflections must be equal, which asks for an index of √1.52 = 1.23, lower than \
                 any solid film's.",
            ),
        ],
        right: |_| {
            let lens = |layers: Vec<Layer>| {
                let films = Films { n_i: 1.0, layers, substrate: 1.52.into() };
                films.natural(550e-9, Incidence::NORMAL)
            };
            let (bare, coated) = (lens(Vec::new()), lens(vec![quarter_film(1.38, 550e-9)]));
            match coated / bare {
                share if share > 1.05 => 0,
                share if share > 0.95 => 1,
                share if share > 0.01 => 2,
                _ => 3,
            }
        },
        slip: |_| 0,
    },
    "1.3 %: the second reflection is half a period late and takes most of the first one away. Amplitudes add, not \
     powers.",
);

fn round_trip() -> Expr {
    exp(2 * i() * DELTA)
}

fn airy(denominator: Expr) -> Expr {
    (R_12 + R_23 * round_trip()) / denominator
}

fn quarter_wave() -> Expr {
    (N_1 * N_3 - N_2.pow(2)) / (N_1 * N_3 + N_2.pow(2))
}

/// Across a film: the wave ψ₊ that runs on lags by δ at the face, ψ₋ that runs back is ahead by as much.
fn layer(last: Expr) -> Chain {
    let at_face = PSI_ON * exp(-(i() * DELTA)) + PSI_BACK * exp(i() * DELTA);
    Chain::assume(Equation::new(PSI_ON + PSI_BACK, PSI), "ψ at the back")
        .and(Equation::new(Y * (PSI_ON - PSI_BACK), PHI), "φ at the back")
        .solve_for([PSI_ON, PSI_BACK])
        .then(Equation::new(&at_face, cos(DELTA) * PSI - i() * sin(DELTA) / Y * PHI), ["linear solve", "Euler"])
        .then(
            Equation::new(
                exp(i() * DELTA) * at_face,
                exp(i() * DELTA) * (cos(DELTA) * PSI - i() * sin(DELTA) / Y * PHI),
            ),
            ["times e^(iδ)"],
        )
        .then(last, ["Euler", "e^(iδ) multiplied in: nothing grows"])
}

/// The way back through a face: E36 and E37, or E39 and E40, with the angles exchanged; `last` is t₁₂t₂₁.
fn stokes(r: Expr, t: Expr, last: Expr) -> Chain {
    let way_back = |ratio: &Expr| {
        let [one, two, other] = [THETA_1, THETA_2, Symbol::scalar("alpha", Dimension::ONE)].map(Expr::from);
        ratio.replace(&one, &other).replace(&two, &one).replace(&other, &two)
    };
    Chain::new(Equation::new(R_21, -Expr::from(R_12)))
        .because("sine and tangent of θ₁ − θ₂ change sign with it")
        .given(R_21, way_back(&r), "angles exchanged")
        .given(T_21, way_back(&t), "angles exchanged")
        .given(R_12, r, "Fresnel")
        .given(T_12, t, "Fresnel")
        .then(Equation::new(T_12 * T_21, last), ["square of a sum"])
}

/// Airy's sum (1833), by what it does to itself: b = first bounce + b bounced once more.
fn bounces(last: Expr) -> Chain {
    let (first, ratio) = (T_12 * R_23 * T_21 * round_trip(), R_21 * R_23 * round_trip());
    let denominator = 1 + R_12 * R_23 * round_trip();
    Chain::assume(Equation::new(B, &first + &ratio * B), "one bounce, and all further ones")
        .because("through the first face, off the second, out again; and all further bounces")
        .solve_for([B])
        .given(R_21, -Expr::from(R_12), "Stokes")
        .given(T_21, (1 - R_12.pow(2)) / T_12, "Stokes")
        .then(Equation::new(R_12 + B, R_12 + &first / (1 - &ratio)), ["linear solve"])
        .then(
            (R_12 * &denominator + (1 - R_12.pow(2)) * R_23 * round_trip()) / denominator,
            ["Stokes", "common denominator"],
        )
        .then(last, ["cancel"])
}

/// The same film as two boundary conditions at each face, all at once.
fn at_both_faces(last: Expr) -> Chain {
    let (on, back) = (exp(i() * DELTA), exp(-(i() * DELTA)));
    let step = |near: Symbol, far: Symbol| contrast(near.into(), far.into());
    let (first, second) = (step(Y_1, Y_2), step(Y_2, Y_3));
    Chain::assume(Equation::new(1 + R, PSI_ON + PSI_BACK), "ψ at the first face")
        .and(Equation::new(Y_1 * (1 - R), Y_2 * (PSI_ON - PSI_BACK)), "φ at the first face")
        .and(Equation::new(PSI_ON * &on + PSI_BACK * &back, THROUGH), "ψ at the second face")
        .and(Equation::new(Y_2 * (PSI_ON * on - PSI_BACK * back), Y_3 * THROUGH), "φ at the second face")
        .solve_for([R, PSI_ON, PSI_BACK, THROUGH])
        .given(R_12, &first, "one face alone")
        .given(R_23, &second, "one face alone")
        .then(
            Equation::new(R, (&first + &second * round_trip()) / (1 + first * second * round_trip())),
            ["linear solve", "times e^(iδ)"],
        )
        .then(last, ["one face alone"])
}

fn quarter(last: Expr) -> Chain {
    let step = |near: Symbol, far: Symbol| contrast(near.into(), far.into());
    Chain::new(airy(1 + R_12 * R_23 * round_trip()))
        .given(DELTA, pi() / 2, "a quarter of a wave")
        .given(R_12, step(N_1, N_2), "E36 at θ = 0")
        .given(R_23, step(N_2, N_3), "E36 at θ = 0")
        .then((R_12 - R_23) / (1 - R_12 * R_23), ["e^(iπ) = −1"])
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
    // |n|, not its real part: a metal without loss has none.
    let coat =
        |name: &str| Some(Layer { index: medium(name)?, thickness: design / (4.0 * setting.index(name).norm()) });
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
