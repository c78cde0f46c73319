//! C14: media that absorb. The index becomes complex, and nothing else changes.

use super::boundary::bounded;
use super::fields::{flow, waves};
use super::symbols::{E_1, E_1R, E_2, K_0, N_1, N_2, Q_2, R_0, R_P, R_S, THETA_1, THETA_2, Z};
use super::{N_I, N_T, extremes, incidence, interface, over_angle, pseudo_brewster, sample_media, total_reflection};
use crate::figure::{Axis, Chart, Hue, Picture, Plot};
use crate::parameter::{Parameter, Setting, THETA, WAVELENGTH};
use crate::vocabulary::{
    ALLOWED_ULPS, Answer, Bench, Check, Exhibit, Extreme, Measured, Quantity, Question, Step, check, choice,
    derivation, exhibit, figure, question, statement, step, stress,
};
use equation::derivation::Chain;
use equation::expr::{conj, cos, exp, i, sin, sqrt, tan};
use equation::value::Bindings;
use equation::{Dimension, Equation, Expr, Symbol};
use light::Complex64;
use light::Polarisation;
use light::colour::response::response;
use light::media::{self, Medium};
use light::optics::fresnel::{Amplitudes, Powers, amplitudes, brewster_angle, critical_angle, powers};
use light::optics::incidence::{normal_squared, outgoing_root};
use light::optics::schlick::normal_reflectance;
use light::optics::{Direction, Incidence};
use light::references::fresnel::{Exact, Input, NAMES};
use std::f64::consts::PI;
use yardstick::order::slope;
use yardstick::precise;
use yardstick::random::uniform;

/// The metal behind the interface.
const METAL: Parameter = N_T.default("gold");

/// The incident index, which is real.
const N_1R: Symbol = Symbol::scalar("n_1", Dimension::ONE).real(1.0, 2.0);
/// Real part of a complex index.
const N: Symbol = Symbol::scalar("n", Dimension::ONE).real(0.1, 4.0);
/// Extinction: its imaginary part.
const KAPPA: Symbol = Symbol::scalar("kappa", Dimension::ONE).real(0.0, 8.0);
/// r_p/r_s, what an ellipsometer measures.
const RHO: Symbol = Symbol::scalar("rho", Dimension::ONE);

pub(super) const EXHIBIT: Exhibit = exhibit(
    "metals",
    &[N_I, METAL, THETA, WAVELENGTH],
    &[
        figure("colour", "Why gold is yellow: reflectance at normal incidence over the visible.", over_the_visible),
        figure("angle", "R_p dips at the pseudo-Brewster angle, and never to zero.", against_angle),
        figure("phase", "No polarisation comes back in phase: linear light leaves a metal elliptical.", phases),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Metals and other media that absorb",
    "An absorbing medium has a complex index, and the same formulas hold.",
)
.rows(&["C14"])
.about("normal_reflectance")
.statements(&[
    statement("index", "the wave in the medium decays as e^(−κk₀z)", || Equation::new(N_2, N + i() * KAPPA)),
    statement("normal_wave", "its normal wave number over that of the vacuum", || {
        Equation::new(Q_2, sqrt(N_2.pow(2) - N_1.pow(2) * sin(THETA_1).pow(2)))
    }),
    statement("r_s", "reflected over incident electric field, s", || {
        Equation::new(R_S, contrast(N_1 * cos(THETA_1), Q_2.into()))
    }),
    statement("r_p", "reflected over incident electric field, p", || {
        Equation::new(R_P, contrast(N_2.pow(2) * cos(THETA_1), N_1 * Q_2))
    }),
    statement("normal_reflectance", "at normal incidence", || Equation::new(R_0, at_normal_incidence(KAPPA.pow(2)))),
    statement("ellipsometer", "modulus and phase of ρ = r_p/r_s at one angle give the index back", || {
        Equation::new(N_2, from_ellipsometer())
    }),
])
.questions(&[GOLD])
.derivations(&[
    derivation("decay", "a wave along the normal: what is imaginary in the index fades it", || {
        fading(exp(-(KAPPA * K_0 * Z)) * exp(i() * N * K_0 * Z))
    })
    .slip("κ with the sign of the other time convention", || fading(exp(KAPPA * K_0 * Z) * exp(i() * N * K_0 * Z))),
    derivation(
        "normal_wave_from_snell",
        "the square of n₂cosθ₂ by Snell's law, whose sines may be complex",
        || total_reflection::normal_wave(sin(THETA_1)),
    )
    .slip("cosine for sine", || total_reflection::normal_wave(cos(THETA_1))),
    derivation("s_from_boundary", "E35 solved for E₁′/E₁, with q₂ for n₂cosθ₂", || {
        reflected(Polarisation::S, contrast(N_1 * cos(THETA_1), Q_2.into()))
    })
    .slip("the sign of r_s", || reflected(Polarisation::S, contrast(Q_2.into(), N_1 * cos(THETA_1)))),
    derivation("p_from_boundary", "E38 solved for E₁′/E₁, with q₂ for n₂cosθ₂", || {
        reflected(Polarisation::P, contrast(N_2.pow(2) * cos(THETA_1), N_1 * Q_2))
    })
    .slip("n₁² for n₁", || reflected(Polarisation::P, contrast(N_2.pow(2) * cos(THETA_1), N_1.pow(2) * Q_2))),
    derivation("along_the_normal", "|r|² of either at θ = 0, with n₂ = n + iκ", || {
        squared_at_normal(at_normal_incidence(KAPPA.pow(2)))
    })
    .slip("the complex index is squared where its modulus should be", || {
        squared_at_normal(at_normal_incidence(-KAPPA.pow(2)))
    }),
    derivation(
        "ellipsometry",
        "the square of what the ellipsometer's equation says, by r_s and r_p: that of the index",
        || inverted(R_P / R_S),
    )
    .slip("ρ by r_p of the other convention", || inverted(-(R_P / R_S))),
])
.readout(readout)
.checks(&[&ENERGY, &NORMAL, &PHASE, &TABLE, &MIRRORS, &CONTINUITY])
.stress(&[
    stress(
        "conductors",
        "reflected and transmitted power keep their digits for κ up to 1000, towards the normal and grazing",
        |setting| extremes::cases(&["R_p", "T_p"], &[vec![interface(setting)], conductors()].concat()),
    )
    .textbook("E36–E42 with complex θ₂ = asin(n₁ sin θ₁/n₂)")
    .against("the boundary conditions solved in 256 bits"),
    stress(
        "traces",
        "a trace of absorption is neither lost nor blown up at the critical angle and at Brewster's",
        traces,
    )
    .textbook("E36–E42 with complex θ₂ = asin(n₁ sin θ₁/n₂)")
    .against("the boundary conditions solved in 256 bits"),
]);

const GOLD: Question = question(
    "gold",
    "Why is gold yellow?",
    Answer::Choice {
        options: &[
            choice(
                "it reflects yellow, and neither red nor blue",
                "Then it would be a dim metal with a narrow band. In red it is as good a mirror as silver.",
            ),
            choice("it reflects all but blue", ""),
            choice(
                "it reflects all colours alike; the yellow comes from inside",
                "Nothing comes back from inside: within a few tens of nanometres the light is gone.",
            ),
        ],
        right: |_| {
            let gold = media::named("gold").expect("a known metal");
            let [blue, yellow, red] = [450e-9, 580e-9, 680e-9]
                .map(|wavelength| normal_reflectance(1.0, gold.index(wavelength).expect("within the data")));
            match () {
                () if (red - blue).abs() < 0.1 => 2,
                () if yellow > red + 0.1 => 0,
                () => 1,
            }
        },
        slip: |_| 0,
    },
    "Red, yellow and a good deal of green come back, blue hardly: what is left of white light without blue is \
     yellow.",
);

fn contrast(near: Expr, far: Expr) -> Expr {
    (&near - &far) / (near + far)
}

/// ((n − n₁)² + κ²)/((n + n₁)² + κ²), whose `absorbed` term the planted mistake takes with the wrong sign.
fn at_normal_incidence(absorbed: Expr) -> Expr {
    ((N - N_1).pow(2) + &absorbed) / ((N + N_1).pow(2) + absorbed)
}

/// n₁ sin θ₁ √(1 + tan² θ₁ ((1 − ρ)/(1 + ρ))²) (Azzam & Bashara, *Ellipsometry and Polarized Light*, §4.2).
fn from_ellipsometer() -> Expr {
    N_1 * sin(THETA_1) * sqrt(1 + tan(THETA_1).pow(2) * ((1 - RHO) / (1 + RHO)).pow(2))
}

/// e^(ik₀n₂z) of a complex index.
fn fading(last: Expr) -> Chain {
    Chain::new(exp(i() * K_0 * N_2 * Z))
        .because("E over E at the interface, θ₂ = 0")
        .given(N_2, N + i() * KAPPA, "complex index")
        .then(last, ["complex index", "i² = −1"])
}

/// E₁′/E₁ by the boundary conditions.
fn reflected(polarisation: Polarisation, last: Expr) -> Chain {
    bounded(polarisation)
        .solve_for([E_1R, E_2])
        .given(cos(THETA_2), Q_2 / N_2, "q₂ = n₂cosθ₂")
        .then(Equation::new(E_1R / E_1, last), ["linear solve", "q₂ = n₂cosθ₂"])
}

/// r r* at normal incidence, where q₂ = n₂.
fn squared_at_normal(last: Expr) -> Chain {
    let r = contrast(N_1R.into(), N_2.into());
    Chain::new(&r * conj(r.clone()))
        .because("|r|², q₁ = n₁ and q₂ = n₂")
        .given(N_2, N + i() * KAPPA, "complex index")
        .then(last, ["conjugate", "i² = −1"])
}

/// n₁² sin² θ₁ (1 + tan² θ₁ ((1 − ρ)/(1 + ρ))²) is n₂².
fn inverted(ratio: Expr) -> Chain {
    let along = N_1 * sin(THETA_1);
    let square = Q_2.pow(2) + along.pow(2);
    Chain::new(from_ellipsometer().pow(2))
        .given(RHO, ratio, "definition of ρ")
        .given(R_S, contrast(N_1 * cos(THETA_1), Q_2.into()), "r_s")
        .given(R_P, contrast(N_2.pow(2) * cos(THETA_1), N_1 * Q_2), "r_p")
        .given(N_2.pow(2), &square, "q₂² = n₂² − n₁²sin²θ₁")
        .then(
            along.pow(2) * (1 + (Q_2 * cos(THETA_1) / (N_1 * sin(THETA_1).pow(2)) * tan(THETA_1)).pow(2)),
            ["r_s", "r_p"],
        )
        .then(square, ["tan θ = sin θ/cos θ"])
        .then(N_2.pow(2), ["q₂² = n₂² − n₁²sin²θ₁"])
}

fn readout(setting: &Setting) -> Vec<Quantity> {
    let Input { n_i, n_t, .. } = interface(setting);
    let direction = incidence(setting);
    let (a, p) = (amplitudes(direction, n_i, n_t), powers(direction, n_i, n_t));
    let q_t = outgoing_root(normal_squared(direction, n_i, n_t));
    let number = |key, symbol, says, value| Quantity { key, symbol, says, value, unit: "1" };
    let angle = |key, symbol, says, value| Quantity { key, symbol, says, value, unit: "rad" };
    vec![
        number("n", "n", "real part of the index", n_t.re),
        number("kappa", "κ", "extinction", n_t.im),
        number("R_0", "R_0", "reflectance at normal incidence", normal_reflectance(n_i, n_t)),
        number("R_s", "R_s", "reflectance, s", p.r_s),
        number("R_p", "R_p", "reflectance, p", p.r_p),
        number("R_n", "R_n", "reflectance of natural light", p.r_n()),
        angle("phase_s", "arg r_s", "phase step of the reflected field, s", a.r_s.arg()),
        angle("phase_p", "arg r_p", "phase step of the reflected field, p", a.r_p.arg()),
        angle("pseudo_brewster", "θ_B", "where R_p is least", pseudo_brewster(n_i, n_t)),
        Quantity {
            key: "depth",
            symbol: "d",
            says: "depth at which 1/e of the power is left; infinite in a clear medium",
            value: setting.wavelength() / (4.0 * PI * q_t.im),
            unit: "m",
        },
    ]
}

const ENERGY: Check<fn(Polarisation, &Input, &Amplitudes) -> f64> = check(
    "energy_flow",
    "what is not reflected flows into the metal: R + T = 1, although no wave keeps its power there",
)
.against("½ Re(E×H*) of the transmitted wave's full field vectors just behind the interface")
.within(32.0, "ulp", "a dozen roundings in R, in the amplitudes and in the vectors' products")
.of(imbalance, carried)
.slip("Re n₂ · Re cos θ₂ is taken for Re(n₂ cos θ₂)", carried_by_parts);

/// R + T − 1 [ε] in absorbing media at every angle of a fan, with T from `through`.
fn imbalance(bench: &mut Bench, through: fn(Polarisation, &Input, &Amplitudes) -> f64) -> Measured {
    let own = interface(bench.setting());
    let media = sample_media().into_iter().chain([(own.n_i, own.n_t)]).filter(|(_, n_t)| n_t.im > 0.0);
    let fan = [0.0, 10.0, 45.0, 60.0, 75.0, 85.0, 89.9].map(|degrees: f64| Direction::Angle(degrees.to_radians()));
    let inputs = media.flat_map(|(n_i, n_t)| fan.map(|direction| Input { direction, n_i, n_t }));
    Measured::worst(inputs.flat_map(|input| {
        let incidence = Incidence::from(input.direction);
        let (a, p) = (amplitudes(incidence, input.n_i, input.n_t), powers(incidence, input.n_i, input.n_t));
        [(Polarisation::S, p.r_s), (Polarisation::P, p.r_p)].map(|(polarisation, reflected)| {
            let sum = reflected + through(polarisation, &input, &a);
            ((sum - 1.0) / f64::EPSILON, format!("{polarisation:?}, {}", extremes::describe(&input)))
        })
    }))
}

/// T by the flow of the fields.
fn carried(polarisation: Polarisation, input: &Input, a: &Amplitudes) -> f64 {
    let [incident, _, transmitted] = waves(polarisation, input.direction.into(), input.n_i, input.n_t, a);
    flow(&transmitted) / flow(&incident)
}

/// T as E41 has it for clear media, with real parts put in.
fn carried_by_parts(polarisation: Polarisation, input: &Input, a: &Amplitudes) -> f64 {
    let incidence = Incidence::from(input.direction);
    let cos_t = outgoing_root(normal_squared(incidence, input.n_i, input.n_t)) / input.n_t;
    let t = if polarisation == Polarisation::S { a.t_s } else { a.t_p };
    input.n_t.re * cos_t.re / (input.n_i * incidence.cos()) * t.norm_sqr()
}

const NORMAL: Check<fn() -> Expr> =
    check("at_normal_incidence", "the program's R at normal incidence is the equation on the page")
        .against("the equation above, as the object on the page, in 256-bit arithmetic")
        .within(
            ALLOWED_ULPS,
            "ulp · (1 + cond)",
            "the project's promise: no more than a few roundings beyond what the inputs' own rounding does",
        )
        .of::<fn() -> Expr>(
            |bench, equation| against_equation(bench, &equation()),
            || at_normal_incidence(KAPPA.pow(2)),
        )
        .slip("the complex index is squared where its modulus should be", || at_normal_incidence(-KAPPA.pow(2)));

/// Error of the program's R_n at normal incidence against `equation`, in ulp · (1 + cond): random metals, some with indices
/// near the incident one, and the setting's own.
fn against_equation(bench: &mut Bench, equation: &Expr) -> Measured {
    let own = interface(bench.setting());
    let mut media = vec![(own.n_i, own.n_t)];
    media.extend((0..10).map(|_| {
        let n_i = uniform(&mut bench.stream, 1.0, 2.0);
        let n = n_i * (1.0 + 10f64.powf(uniform(&mut bench.stream, -9.0, 0.5)));
        (n_i, Complex64::new(n, 10f64.powf(uniform(&mut bench.stream, -9.0, 3.0))))
    }));
    let at = NAMES.iter().position(|name| *name == "R_n").expect("an output");
    Measured::worst(media.into_iter().map(|(n_i, n_t)| {
        let input = Input { direction: Direction::Angle(0.0), n_i, n_t };
        let mut bindings = Bindings::new();
        for (symbol, value) in [(N_1, n_i), (N, n_t.re), (KAPPA, n_t.im)] {
            bindings.bind(symbol.name(), precise::from_real(precise::real(value)));
        }
        let program = powers(Incidence::NORMAL, n_i, n_t).r_n();
        let exact = equation.evaluate(&bindings);
        let error = exact.map_or(f64::NAN, |exact| precise::relative_error(program, &exact.into_parts().0));
        (error / (f64::EPSILON * (1.0 + Exact::new(&input).conditions()[at])), extremes::describe(&input))
    }))
}

const PHASE: Check<fn(Complex64) -> Complex64> = check(
    "inversion",
    "modulus and phase of r_p/r_s give the index back that they were computed from",
)
.against("the ellipsometer's closed inversion: no square root's branch, no continuity of fields")
.within(
    32.0,
    "ulp · (1 + cond)",
    "a dozen roundings in each ratio; cond is what the inversion makes of them: 1 − ρ² is small for good metals, and \
             n²/(n₁ sin θ₁)² may be left of two greater numbers",
)
.of(index_from_ratio, |ratio| ratio)
.slip("the phase has the sign of the other time convention", |ratio| ratio.conj());

fn index_from_ratio(bench: &mut Bench, amend: fn(Complex64) -> Complex64) -> Measured {
    let own = interface(bench.setting());
    let media = sample_media().into_iter().chain([(own.n_i, own.n_t)]).filter(|(_, n_t)| n_t.im > 0.01);
    let cases = media.flat_map(|media| [50.0, 60.0, 70.0, 80.0].map(|degrees: f64| (media, degrees.to_radians())));
    Measured::worst(cases.filter_map(|((n_i, n_t), theta)| {
        let a = amplitudes(Incidence::from_angle(theta), n_i, n_t);
        let mut bindings = Bindings::new();
        bindings.bind(N_1.name(), Complex64::from(n_i));
        bindings.bind(THETA_1.name(), Complex64::from(theta));
        let ratio = a.r_p / a.r_s;
        let condition = of_inversion(ratio, n_t / (n_i * theta.sin()));
        bindings.bind(RHO.name(), amend(ratio));
        let back = from_ellipsometer().evaluate(&bindings).unwrap_or(Complex64::new(f64::NAN, f64::NAN));
        // Which of the two roots absorbs is known.
        let error = (back - n_t).norm().min((back + n_t).norm()) / n_t.norm();
        let allowed = f64::EPSILON * (1.0 + condition);
        let place = format!("n {n_i} → {n_t}, θ = {:.0}°", theta.to_degrees());
        // Where rounding leaves no digit there is nothing to give back: a mirror so good that ρ = −1.
        (allowed < 1.0 / 64.0).then(|| (error / allowed, place))
    }))
}

/// What a relative error of ρ, and one of every sum, is multiplied by in x = n₂/(n₁ sin θ₁) = √(1 + w²), w = tan θ₁
/// (1 − ρ)/(1 + ρ): dw/w = −2 dρ/(1 − ρ²), dx/x = w dw/x².
fn of_inversion(ratio: Complex64, x: Complex64) -> f64 {
    let square = x * x;
    let w = (square - 1.0).norm();
    (1.0 + w * (1.0 + 2.0 * (1.0 + ratio.norm()) / (1.0 - ratio * ratio).norm())) / square.norm()
}

const TABLE: Check<fn(Complex64) -> f64> =
    check("handbook", "the indices and reflectances of a printed table belong together")
        .against("Born & Wolf, Principles of Optics (7th ed.), table 14.1: n, nκ and R at 589.3 nm")
        .within(0.006, "1", "R is printed to 0.01, and n to two or three digits")
        .of(printed, |n_t| powers(Incidence::NORMAL, 1.0, n_t).r_n())
        .slip("the printed nκ is taken for κ, and multiplied by n once more", |n_t| {
            powers(Incidence::NORMAL, 1.0, Complex64::new(n_t.re, n_t.re * n_t.im)).r_n()
        });

/// Sodium, silver, magnesium, gold, copper, aluminium: n, nκ, R.
const PRINTED: [(&str, f64, f64, f64); 6] = [
    ("sodium", 0.044, 2.42, 0.97),
    ("silver", 0.20, 3.44, 0.94),
    ("magnesium", 0.37, 4.42, 0.93),
    ("gold", 0.47, 2.83, 0.82),
    ("copper", 0.62, 2.57, 0.73),
    ("aluminium", 1.44, 5.23, 0.83),
];

fn printed(_: &mut Bench, reflectance: fn(Complex64) -> f64) -> Measured {
    let error = |(metal, n, k, printed): (&str, f64, f64, f64)| {
        (reflectance(Complex64::new(n, k)) - printed, format!("{metal}, n = {n}, nκ = {k}"))
    };
    Measured::worst(PRINTED.map(error))
}

const MIRRORS: Check<fn(Complex64) -> f64> = check("mirrors", "the program's metals reflect as much as mirrors do")
    .against(
        "photometry of freshly evaporated mirrors: G. Hass, in American Institute of Physics Handbook (3rd ed.), §6g",
    )
    .within(
        0.05,
        "1",
        "evaporated films differ by a few hundredths with their grain and roughness, off the absorption edges",
    )
    .of(against_mirrors, |n_t| powers(Incidence::NORMAL, 1.0, n_t).r_n())
    .slip("the index without its imaginary part", |n_t| powers(Incidence::NORMAL, 1.0, n_t.re.into()).r_n());

/// Metal, vacuum wavelength [nm], R.
const MEASURED_MIRRORS: [(&str, f64, f64); 12] = [
    ("aluminium", 500.0, 0.918),
    ("aluminium", 550.0, 0.915),
    ("aluminium", 600.0, 0.911),
    ("silver", 500.0, 0.979),
    ("silver", 550.0, 0.983),
    ("silver", 600.0, 0.986),
    ("gold", 500.0, 0.477),
    ("gold", 600.0, 0.919),
    ("gold", 650.0, 0.955),
    ("copper", 500.0, 0.600),
    ("copper", 650.0, 0.966),
    ("copper", 700.0, 0.975),
];

fn against_mirrors(_: &mut Bench, reflectance: fn(Complex64) -> f64) -> Measured {
    Measured::worst(MEASURED_MIRRORS.map(|(name, nanometres, measured)| {
        let index = media::named(name).and_then(|metal| metal.index(nanometres * 1e-9).ok());
        (index.map_or(f64::NAN, reflectance) - measured, format!("{name}, {nanometres} nm"))
    }))
}

const CONTINUITY: Check<fn(Complex64) -> Complex64> =
    check("vanishing_absorption", "as κ → 0 the amplitudes go over into those of the clear medium, in proportion to κ")
        .against("the clear medium's amplitudes in 256 bits; slope of the difference over six decades of κ")
        .within(
            0.01,
            "1",
            "r is analytic in the index away from the critical angle; the slope is off by what is left of κ² = 1e−4",
        )
        .of(approach, |r| r)
        .slip("the root on the other branch behind total reflection", |r| r.conj());

/// One of the amplitudes.
type Ratio = fn(&Amplitudes) -> Complex64;

/// How far the slope of |r(κ) − r(0)| is from 1, in partial and in total reflection.
fn approach(_: &mut Bench, amend: fn(Complex64) -> Complex64) -> Measured {
    let cases = [(1.0, 1.5, 0.3), (1.0, 1.5, 1.3), (1.5, 1.0, 0.3), (1.5, 1.0, 0.9), (1.5, 1.0, 1.3)];
    Measured::worst(cases.into_iter().flat_map(|(n_i, n, theta)| {
        let direction = Direction::Angle(theta);
        let at = |k: f64| amplitudes(Incidence::from(direction), n_i, Complex64::new(n, k));
        let exact = Exact::new(&Input { direction, n_i, n_t: n.into() }).outputs.map(|part| precise::to_f64(&part));
        let clear = |at: usize| Complex64::new(exact[at], exact[at + 1]);
        let ratios: [(Ratio, Complex64); 4] =
            [(|a| a.r_s, clear(0)), (|a| a.t_s, clear(2)), (|a| a.r_p, clear(4)), (|a| a.t_p, clear(6))];
        ratios.map(|(ratio, clear)| {
            let trace = (2..=8).map(|decade| 10f64.powi(-decade));
            let points: Vec<_> = trace.map(|k| (k, (amend(ratio(&at(k))) - clear).norm())).collect();
            (slope(&points).unwrap_or(f64::NAN) - 1.0, format!("n {n_i} → {n} + iκ, θ = {theta}"))
        })
    }))
}

/// Metals from nearly clear to nearly perfect, along the normal and beside it, oblique, and grazing.
fn conductors() -> Vec<Input> {
    let metals = [(0.05, 1e3), (3.0, 3.0), (1e3, 1e3), (4.0, 0.03)];
    let directions = [Direction::Angle(0.0), Direction::Angle(1e-9), Direction::Angle(1.2), Direction::Grazing(1e-30)];
    let each = |(n, k)| directions.map(|direction| Input { direction, n_i: 1.0, n_t: Complex64::new(n, k) });
    metals.into_iter().flat_map(each).collect()
}

/// A clear medium with a trace of absorption, at its special angles and a little beside them.
fn traces(_: &Setting) -> Vec<Extreme> {
    let critical = critical_angle(1.5, 1.0).expect("into the rarer medium");
    let brewster = brewster_angle(1.0, 1.5);
    let grid = [1e-300, 1e-12, 1e-6].into_iter().flat_map(|k| [0.0, 1e-12].map(|offset| (k, offset)));
    grid.flat_map(|(k, offset)| {
        let input = |n_i, n, theta| Input { direction: Direction::Angle(theta), n_i, n_t: Complex64::new(n, k) };
        let beyond = [input(1.5, 1.0, critical + offset), input(1.5, 1.0, critical + offset + 0.1)];
        let mut cases = extremes::cases(&["T_s"], &beyond);
        cases.extend(extremes::cases(&["r_p_re"], &[input(1.0, 1.5, brewster + offset)]));
        cases
    })
    .collect()
}

/// Curves of normal-incidence reflectance: four metals, and the setting's medium if it is another.
fn over_the_visible(setting: &Setting) -> Plot {
    let (from, own) = (setting.medium("n_i"), setting.medium("n_t"));
    let metals = ["silver", "aluminium", "gold", "copper"].map(|name| media::named(name).expect("a listed metal"));
    let mut media: Vec<(&str, Medium)> = metals.iter().map(|metal| (metal.name, Medium::Named(metal))).collect();
    if media.iter().all(|(_, medium)| *medium != own) {
        media.push((if let Medium::Named(known) = own { known.name } else { "n_2" }, own));
    }
    let mut chart = Chart::new(
        "",
        Axis::linear("vacuum wavelength λ", "nm").range(380.0, 750.0).tick(50.0),
        Axis::share("reflectance R_0"),
    );
    let swatches = swatches(&from, &media);
    for (place, (name, medium)) in (0..).zip(media) {
        let reflectance = |nanometres: f64| {
            let wavelength = nanometres * 1e-9;
            let (n_i, n_t) = (from.index(wavelength).ok()?, medium.index(wavelength).ok()?);
            Some(powers(Incidence::NORMAL, n_i.re, n_t).r_n())
        };
        let wavelengths = (0..=185).map(|step| 380.0 + 2.0 * f64::from(step));
        let curve = wavelengths.map(|nanometres| [nanometres, reflectance(nanometres).unwrap_or(f64::NAN)]);
        chart = chart.line(Hue::Nth(place), name, curve.collect());
    }
    Plot::grid("Metals at normal incidence", 1, vec![chart.into(), swatches.into()])
}

/// What the media look like under light of all wavelengths alike, as the eye weighs them: one patch for each.
fn swatches(from: &Medium, media: &[(&str, Medium)]) -> Picture {
    const PATCH: [usize; 2] = [60, 36];
    let of = |medium: &Medium| -> [f32; 3] {
        let (mut seen, mut white) = ([0.0; 3], [0.0; 3]);
        for nanometres in (380..=750).step_by(5) {
            let wavelength = f64::from(nanometres) * 1e-9;
            let (Ok(n_i), Ok(n_t)) = (from.index(wavelength), medium.index(wavelength)) else { continue };
            let share = powers(Incidence::NORMAL, n_i.re, n_t).r_n();
            for (at, weight) in response().at(wavelength).into_iter().enumerate() {
                seen[at] += share * weight;
                white[at] += weight;
            }
        }
        // Of what was never measured there is nothing to see.
        [0, 1, 2].map(|at| (seen[at] / white[at]).max(0.0) as f32)
    };
    let colours: Vec<[f32; 3]> = media.iter().map(|(_, medium)| of(medium)).collect();
    let row = || colours.iter().flat_map(|colour| [*colour; PATCH[0]]);
    let names: Vec<&str> = media.iter().map(|(name, _)| *name).collect();
    let title = format!("{}: as the eye sees their curves", names.join(", "));
    Picture::new(title, PATCH[0] * colours.len(), (0..PATCH[1]).flat_map(|_| row()).collect())
}

fn against_angle(setting: &Setting) -> Plot {
    let Input { n_i, n_t, .. } = interface(setting);
    let curve = |power: fn(&Powers) -> f64| over_angle(|incidence| power(&powers(incidence, n_i, n_t)));
    let chart = Chart::new(
        super::own_media(setting),
        Axis::linear("angle of incidence θ_1", "°").range(0.0, 90.0).tick(15.0),
        Axis::share("reflectance R"),
    )
    .line(Hue::S, "R_s", curve(|p| p.r_s))
    .line(Hue::P, "R_p", curve(|p| p.r_p))
    .line(Hue::Natural, "R_n", curve(|p| p.r_n()))
    .at_x(pseudo_brewster(n_i, n_t).to_degrees(), "R_p least");
    Plot::of("Reflectance of an absorbing medium", chart)
}

fn phases(setting: &Setting) -> Plot {
    let Input { n_i, n_t, .. } = interface(setting);
    let curve = |ratio: fn(&Amplitudes) -> Complex64| {
        over_angle(|incidence| ratio(&amplitudes(incidence, n_i, n_t)).arg().to_degrees())
    };
    // Along the normal it is half a turn, either way round: one of them, lest the curve jump.
    let one_way = |[theta, degrees]: [f64; 2]| [theta, if degrees > 90.0 { degrees - 360.0 } else { degrees }];
    let between = curve(|a| a.r_p / a.r_s).into_iter().map(one_way).collect();
    let chart = Chart::new(
        super::own_media(setting),
        Axis::linear("angle of incidence θ_1", "°").range(0.0, 90.0).tick(15.0),
        Axis::linear("phase of the reflected field", "°").range(-180.0, 180.0).tick(60.0),
    )
    .line(Hue::S, "δ_s", curve(|a| a.r_s))
    .line(Hue::P, "δ_p", curve(|a| a.r_p))
    .dashed(Hue::Natural, "δ_p − δ_s", between)
    .at_x(pseudo_brewster(n_i, n_t).to_degrees(), "R_p least");
    Plot::of("Phase on reflection", chart)
}
