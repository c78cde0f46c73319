//! C13: total internal reflection.

use super::amplitudes::contrast;
use super::extremes::{cases, describe};
use super::fields::{Wave, flow, waves};
use super::{geometry, incidence, interface};
use crate::figure::{Axis, Chart, Hue, Plot};
use crate::parameter::{Kind, Parameter, Setting, THETA, WAVELENGTH};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Quantity, Question, Step, check, choice, derivation, exhibit, figure,
    question, statement, step, stress,
};
use equation::derivation::Chain;
use equation::expr::{abs, asin, conj, cos, cross, dot, exp, i, laplacian, re, sin, tan, vector};
use equation::{Dimension, Equation, Expr, Symbol};
use light::Complex64;
use light::Polarisation;
use light::optics::film::{Layer, Stack};
use light::optics::fresnel::{amplitudes, critical_angle, evanescent_depth, powers};
use light::optics::{Direction, Incidence};
use light::references::fresnel::Input;
use std::f64::consts::FRAC_PI_2;

use super::symbols::{E_2, ELECTRIC, H_2, MAGNETIC, N_1, N_2, NORMAL, OMEGA, Q_2, T, THETA_1, THETA_2, X, Z, Z_0};

const THETA_C: Symbol = Symbol::scalar("theta_c", Dimension::ONE);
const R: Symbol = Symbol::scalar("r_s", Dimension::ONE);
const DELTA_S: Symbol = Symbol::scalar("delta_s", Dimension::ONE);
const DELTA_P: Symbol = Symbol::scalar("delta_p", Dimension::ONE);
const Q_1: Symbol = Symbol::scalar("q_1", Dimension::ONE).real(0.2, 1.5);
const GAMMA: Symbol = Symbol::scalar("gamma", Dimension::ONE).real(0.1, 1.5);

/// The indices of clear media, which are real.
const N_1R: Symbol = Symbol::scalar("n_1", Dimension::ONE).real(1.2, 2.0);
const N_2R: Symbol = Symbol::scalar("n_2", Dimension::ONE).real(1.0, 1.2);
/// An angle of incidence beyond the critical one.
const THETA_1R: Symbol = Symbol::scalar("theta_1", Dimension::ONE).real(1.3, 1.5);
/// The vacuum wave number.
const K_0R: Symbol = Symbol::scalar("k_0", Dimension::RADIAN_PER_METRE).real(1.0, 2.0);
/// The electric field behind the interface.
const FIELD: Symbol = Symbol::scalar("E", Dimension::VOLT_PER_METRE);
/// The phase of a reflected wave.
const DELTA: Symbol = Symbol::scalar("delta", Dimension::ONE).real(-2.5, -0.5);

const N_I: Parameter = Parameter { says: "the denser medium, where the light is", ..super::N_I.default("1.5") };
const N_T: Parameter = Parameter::new("n_t", "n_2", "the rarer medium", Kind::ClearMedium).default("1");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "total_reflection",
    &[N_I, N_T, THETA.default("50deg"), WAVELENGTH],
    &[
        figure(
            "geometry",
            "Beyond the critical angle: all comes back, and a wave that fades runs along the surface.",
            geometry::plot,
        ),
        figure("phase", "Phases of r_s and r_p and their difference beyond the critical angle.", phases),
        figure("depth", "How deep the evanescent field reaches, in wavelengths.", depths),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Total reflection",
    "Beyond the critical angle |r| = 1; what remains is a phase, and a wave that clings to the surface.",
)
.rows(&["C13"])
.statements(&[
    statement("critical", "the critical angle", || Equation::new(THETA_C, asin(N_2 / N_1))),
    statement("modulus", "with q₁ = n₁cosθ₁ and n₂cosθ₂ = iγ", || Equation::new(abs(R), Expr::from(1))),
    statement("phase_s", "the phase of s", || Equation::new(tan(DELTA_S / 2), -(GAMMA / Q_1))),
    statement("phase_p", "the phase of p", || {
        Equation::new(tan(DELTA_P / 2), -(N_1R.pow(2) * GAMMA / (N_2R.pow(2) * Q_1)))
    }),
    statement("p_against_s", "the phase of p against s, which turns linear light elliptical", || {
        Equation::new(tan((DELTA_P - DELTA_S) / 2), -(GAMMA * cos(THETA_1R) / (N_1R * sin(THETA_1R).pow(2))))
    }),
])
.questions(&[BEHIND])
.derivations(&[
    derivation(
        "normal_wave",
        "the square of the normal wave number behind the interface, by Snell's law: negative beyond θ_c",
        || normal_wave(sin(THETA_1)),
    )
    .slip("cosine for sine", || normal_wave(cos(THETA_1))),
    derivation("from_e36", "r r* for an imaginary normal wave number behind the interface", || {
        modulus(&[Q_1.into(), Q_2.into()], Expr::from(1))
    })
    .slip("iγ taken as γ", || modulus(&[Q_1.into(), Q_2.into()], (Q_1 - GAMMA).pow(2) / (Q_1 + GAMMA).pow(2))),
    derivation("from_e39", "the same for p", || modulus(&p_pair(), Expr::from(1)))
        .slip("iγ taken as γ", || modulus(&p_pair(), contrast(N_2R.pow(2) * Q_1, N_1R.pow(2) * GAMMA))),
    derivation("half_phase_s", "the phase of r_s, from r_s = e^(iδ)", || {
        phase(&[Q_1.into(), Q_2.into()], GAMMA / Q_1)
    })
    .slip("the wave is ahead instead of behind", || phase(&[Q_1.into(), Q_2.into()], -(GAMMA / Q_1))),
    derivation("half_phase_p", "the same for p", || phase(&p_pair(), N_1R.pow(2) * GAMMA / (N_2R.pow(2) * Q_1)))
        .slip("the phase of s", || phase(&p_pair(), GAMMA / Q_1)),
    derivation(
        "evanescent",
        "the wave that fades with e^(−k₀γz) obeys the wave equation of the rarer medium",
        || evanescent(-(N_2R.pow(2) * K_0R.pow(2))),
    )
    .slip("the index of the denser medium", || evanescent(-(N_1R.pow(2) * K_0R.pow(2)))),
    derivation("relative_phase_from_both", "half the phase of p against s, by the tangent of a difference", || {
        relative_phase(sin(THETA_1R).pow(2))
    })
    .slip("sin θ for sin² θ in the denominator", || relative_phase(sin(THETA_1R))),
    derivation(
        "no_mean_flow",
        "the mean flow through the interface: E and the tangential H are a quarter period apart",
        || normal_flow(Polarisation::S, Expr::from(0)),
    )
    .slip("iγ taken as γ", || normal_flow(Polarisation::S, GAMMA * abs(E_2).pow(2) / (2 * Z_0))),
    derivation("no_mean_flow_p", "the same for p: H and the tangential E are", || {
        normal_flow(Polarisation::P, Expr::from(0))
    })
    .slip("iγ taken as γ", || normal_flow(Polarisation::P, GAMMA * Z_0 * abs(H_2).pow(2) / (2 * N_2R.pow(2)))),
])
.readout(readout)
.checks(&[&RHOMB, &PHASE, &DEPTH, &NO_FLOW])
.stress(&[stress(
    "about_the_critical_angle",
    "the complex amplitudes keep their digits down to the last unit on either side of the critical angle",
    |setting| {
        let own = interface(setting);
        let offsets = [-1e-6, -1e-12, -1e-15, 0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 0.3];
        let near = |n_i: f64, n_t: f64| {
            let critical = critical_angle(n_i, n_t).unwrap_or(FRAC_PI_2);
            offsets.map(|offset| Input {
                direction: Direction::Angle((critical + offset).min(FRAC_PI_2)),
                n_i,
                n_t: n_t.into(),
            })
        };
        let inputs: Vec<Input> = [own].into_iter().chain(near(1.5, 1.0)).chain(near(1.0, 1.0 - 1e-6)).collect();
        cases(&["r_s_re", "r_s_im", "r_p_re", "r_p_im"], &inputs)
    },
)
.textbook("E36, E39 with complex θ₂")
.against("256 bits")]);

const BEHIND: Question = question(
    "behind",
    "In glass, light meets its surface beyond the critical angle, and all of it comes back. What is in the air \
     behind?",
    Answer::Choice {
        options: &[
            choice("nothing", "Fields cannot just end: along the surface E must be the same on both sides."),
            choice(
                "a weak wave that carries a little power away",
                "Then less than all would come back. E and the tangential H behind are a quarter of a period apart.",
            ),
            choice("a field that fades, and on average carries nothing away", ""),
        ],
        right: |_| {
            let (incidence, glass, air) = (Incidence::from_angle(50f64.to_radians()), 1.5, Complex64::ONE);
            let behind = amplitudes(incidence, glass, air);
            match powers(incidence, glass, air).t_n() {
                _ if behind.t_s.norm() == 0.0 => 0,
                0.0 => 2,
                _ => 1,
            }
        },
        slip: |_| 0,
    },
    "A field that clings to the surface: it sloshes in and out twice a period, and fades within a wavelength or so. \
     A second piece of glass near enough takes power from it.",
);

/// (n₂cosθ₂)² = −γ².
pub(super) fn normal_wave(projection: Expr) -> Chain {
    Chain::assume(Equation::new(N_1 * sin(THETA_1), N_2 * sin(THETA_2)), "Snell")
        .then(Equation::new((N_2 * cos(THETA_2)).pow(2), N_2.pow(2) - (N_2 * sin(THETA_2)).pow(2)), ["sin² + cos² = 1"])
        .then(N_2.pow(2) - (N_1 * projection).pow(2), ["Snell"])
}

/// What r_p is the contrast of: n₂cosθ₁ and n₁cosθ₂, times n₁n₂.
fn p_pair() -> [Expr; 2] {
    [N_2R.pow(2) * Q_1, N_1R.pow(2) * Q_2]
}

/// r with an imaginary q₂.
fn beyond_critical(chain: Chain) -> Chain {
    chain.given(Q_2, i() * GAMMA, "beyond the critical angle")
}

/// r r* of the contrast of a pair, the second of which has the factor q₂.
fn modulus([near, far]: &[Expr; 2], last: Expr) -> Chain {
    let r = contrast(near.clone(), far.clone());
    let behind = far.replace(&Q_2.into(), &(i() * GAMMA));
    beyond_critical(Chain::new(&r * conj(r.clone())))
        .because("|r|²")
        .then((near - &behind) * (near + &behind) / ((near + &behind) * (near - behind)), ["q₂ = iγ", "conjugate"])
        .then(last, ["cancel"])
}

/// What the tangent of half the phase is: −`ratio`.
fn phase([near, far]: &[Expr; 2], ratio: Expr) -> Chain {
    let r = contrast(near.clone(), far.clone());
    let half = || DELTA / 2;
    beyond_critical(Chain::assume(Equation::new(r, exp(i() * DELTA)), "|r| = 1: only a phase is left"))
        .then(Equation::new((1 - exp(i() * DELTA)) / (1 + exp(i() * DELTA)), far / near), ["solve for the ratio"])
        .then(Equation::new(-(i() * sin(half()) / cos(half())), far / near), ["divide by e^(iδ/2)", "Euler"])
        .then(Equation::new(tan(half()), -ratio), ["q₂ = iγ", "divide by −i"])
}

fn evanescent(factor: Expr) -> Chain {
    let along = N_1R * sin(THETA_1R) * X;
    let premise = Equation::new(GAMMA.pow(2), (N_1R * sin(THETA_1R)).pow(2) - N_2R.pow(2));
    beyond_critical(Chain::assume(premise, "(n₂cosθ₂)² = −γ²"))
        .given(FIELD, E_2 * exp(i() * (K_0R * (&along + Q_2 * Z) - OMEGA * T)), "E₂e^(i(k·r − ωt))")
        .then(Equation::new(FIELD, E_2 * exp(-(K_0R * GAMMA * Z)) * exp(i() * (K_0R * along - OMEGA * T))), ["q₂ = iγ"])
        .then(
            Equation::new(laplacian(FIELD), (GAMMA.pow(2) - (N_1R * sin(THETA_1R)).pow(2)) * K_0R.pow(2) * FIELD),
            ["derivative of an exponential"],
        )
        .then(factor * FIELD, ["(n₂cosθ₂)² = −γ²"])
}

/// tan(δ_p/2 − δ_s/2), with `spread` for the sin² θ₁ that is left.
fn relative_phase(spread: Expr) -> Chain {
    let (half_s, half_p) = (-(GAMMA / Q_1), -(N_1R.pow(2) * GAMMA / (N_2R.pow(2) * Q_1)));
    let square = (N_1R * sin(THETA_1R)).pow(2) - GAMMA.pow(2);
    Chain::new((&half_p - &half_s) / (1 + &half_p * &half_s))
        .because("tan(a − b) = (tan a − tan b)/(1 + tan a tan b)")
        .given(Q_1, N_1R * cos(THETA_1R), "q₁ = n₁cosθ₁")
        .given(N_2R.pow(2), square, "(n₂cosθ₂)² = −γ²")
        .then(
            -((N_1R.pow(2) - N_2R.pow(2)) * GAMMA * Q_1 / (N_2R.pow(2) * Q_1.pow(2) + N_1R.pow(2) * GAMMA.pow(2))),
            ["common denominator"],
        )
        .then(-(GAMMA * Q_1 / (N_1R * sin(THETA_1R)).pow(2)), ["(n₂cosθ₂)² = −γ²", "sin² + cos² = 1"])
        .then(-(GAMMA * cos(THETA_1R) / (N_1R * spread)), ["q₁ = n₁cosθ₁"])
}

/// n·½ Re(E×H*) behind the interface.
fn normal_flow(polarisation: Polarisation, last: Expr) -> Chain {
    let [.., electric] = ELECTRIC;
    let [.., magnetic] = MAGNETIC;
    let wave_vector = vector(N_1R * sin(THETA_1R), 0, Q_2);
    let chain = Chain::new(dot(NORMAL, re(cross(&electric, conj(&magnetic)))) / 2)
        .because("n·⟨S⟩ behind the interface")
        .given(NORMAL, vector(0, 0, 1), "z along the normal");
    let quarter = |flow: Expr| re(i() * flow) / 2;
    match polarisation {
        Polarisation::S => {
            beyond_critical(chain.given(&electric, vector(0, E_2, 0), "s: E across the plane of incidence").given(
                magnetic,
                cross(wave_vector, electric) / Z_0,
                "H = k×E/(k₀Z₀)",
            ))
            .then(re(E_2 * conj(Q_2 * E_2 / Z_0)) / 2, ["components"])
            .then(quarter(-(GAMMA * abs(E_2).pow(2) / Z_0)), ["q₂ = iγ"])
        }
        Polarisation::P => {
            beyond_critical(chain.given(&magnetic, vector(0, H_2, 0), "p: H across the plane of incidence").given(
                electric,
                cross(magnetic, wave_vector) * Z_0 / N_2R.pow(2),
                "E = H×k Z₀/(k₀n²)",
            ))
            .then(re(Q_2 * Z_0 * H_2 * conj(H_2) / N_2R.pow(2)) / 2, ["components"])
            .then(quarter(GAMMA * Z_0 * abs(H_2).pow(2) / N_2R.pow(2)), ["q₂ = iγ"])
        }
    }
    .then(last, ["the real part of an imaginary number"])
}

fn readout(setting: &Setting) -> Vec<Quantity> {
    let input = interface(setting);
    let a = amplitudes(incidence(setting), input.n_i, input.n_t);
    let depth = evanescent_depth(incidence(setting), input.n_i, input.n_t.re) * setting.wavelength();
    vec![
        Quantity {
            key: "theta_c",
            symbol: "θ_c",
            says: "critical angle; there is none into a denser medium",
            value: critical_angle(input.n_i, input.n_t.re).unwrap_or(f64::NAN),
            unit: "rad",
        },
        Quantity { key: "phase_s", symbol: "δ_s", says: "phase of r_s", value: a.r_s.arg(), unit: "rad" },
        Quantity { key: "phase_p", symbol: "δ_p", says: "phase of r_p", value: a.r_p.arg(), unit: "rad" },
        Quantity {
            key: "retardation",
            symbol: "δ_p−δ_s",
            says: "phase of p relative to s",
            value: (a.r_p / a.r_s).arg(),
            unit: "rad",
        },
        Quantity {
            key: "depth",
            symbol: "d",
            says: "1/e depth of the field behind the interface",
            value: depth,
            unit: "m",
        },
    ]
}

/// Phase of p relative to s [rad] under total reflection.
fn retardation(theta: f64, n: f64) -> f64 {
    let a = amplitudes(Incidence::from_angle(theta), n, Complex64::from(1.0));
    (a.r_p / a.r_s).arg()
}

const RHOMB: Check<fn(f64) -> f64> =
    check("fresnel_rhomb", "glass of n = 1.51 turns p against s by an eighth of a period at 48°37′ and at 54°37′")
        .against("Born & Wolf, Principles of Optics (7th ed.), §1.5.4: Fresnel's rhomb")
        .within(0.1, "°", "the angles are printed to a minute of arc, over which the phase moves by up to 0.05°")
        .of(rhomb, |phase| phase)
        .slip("the phase of the power in place of the field's", |phase| 2.0 * phase);

fn rhomb(_: &mut Bench, amend: fn(f64) -> f64) -> Measured {
    let angles = [48.0 + 37.0 / 60.0, 54.0 + 37.0 / 60.0];
    Measured::worst(angles.map(|degrees: f64| {
        let phase = amend(retardation(degrees.to_radians(), 1.51).abs());
        (phase.to_degrees() - 45.0, format!("θ = {degrees:.3}°"))
    }))
}

const PHASE: Check<fn(f64) -> f64> =
    check("relative_phase", "tan(δ/2) = cosθ √(sin²θ − n²)/sin²θ for the phase δ of p against s")
        .against("Born & Wolf §1.5.4, eq. (60), in real arithmetic; the program's route is complex")
        .within(64.0, "ulp", "a dozen roundings, and √ next to its zero")
        .of(against_phase_formula, |sin| sin * sin)
        .slip("sin θ for sin² θ in the denominator", |sin| sin);

fn against_phase_formula(_: &mut Bench, denominator: fn(f64) -> f64) -> Measured {
    let media = [1.33, 1.5, 2.4];
    let cases = media.into_iter().flat_map(|n| (1..20).map(move |step| (n, f64::from(step) / 20.0)));
    Measured::worst(cases.filter_map(|(n, share)| {
        let critical = critical_angle(n, 1.0)?;
        let theta = critical + share * (FRAC_PI_2 - critical);
        let (sin, cos) = theta.sin_cos();
        let closed = 2.0 * (cos * (sin * sin - 1.0 / (n * n)).sqrt() / denominator(sin)).atan();
        Some(((retardation(theta, n).abs() - closed) / f64::EPSILON, format!("n = {n}, θ = {theta:.4}")))
    }))
}

const DEPTH: Check<f64> = check("tunnelling", "behind the interface the field falls to 1/e in the depth shown")
    .against("a second prism brought near: ln T through the gap falls by 2/depth for each metre, by the film formulas")
    .within(
        16.0,
        "ulp",
        "gaps of 20 and 40 depths: ln T, −80 at most, is off by three roundings of the path and three more, twice as \
             much beside the difference; what is not exponential is below e^(−40), 0.02 ε",
    )
    .of(tunnelled, 2.0)
    .slip("the depth of the power for that of the field", 1.0);

fn tunnelled(_: &mut Bench, fields_in_power: f64) -> Measured {
    let cases = [(1.5, 0.8), (1.5, 1.3), (2.4, 0.6), (1.33, 1.0)];
    let each =
        cases.into_iter().flat_map(|case| [Polarisation::S, Polarisation::P].map(|polarisation| (case, polarisation)));
    Measured::worst(each.map(|((n, theta), polarisation)| {
        let incidence = Incidence::from_angle(theta);
        let depth = evanescent_depth(incidence, n, 1.0);
        let ln_t = |depths: f64| {
            let layers = [Layer { index: Complex64::from(1.0), thickness: depths * depth }];
            let stack = Stack { n_i: n, layers: &layers, substrate: n.into() };
            stack.response(1.0, incidence, polarisation).ln_transmittance
        };
        let fall = (ln_t(20.0) - ln_t(40.0)) / 20.0;
        let place = format!("{polarisation:?}, n = {n}, θ = {theta}");
        ((fall / fields_in_power - 1.0) / f64::EPSILON, place)
    }))
}

const NO_FLOW: Check<fn(&Wave) -> f64> = check(
    "no_flow",
    "no energy crosses: none before the interface, where the waves meet, and none behind it",
)
.against(
    "Re(E×H*)·n of the field vectors: of the incident and the reflected wave together, over that of the incident \
             one, and of the evanescent wave, over |k||E|²",
)
.within(16.0, "ulp", "|r| = 1 up to eight roundings, doubled in its square; behind, E and H are a quarter period apart")
.of(net_flow, flow)
.slip("the conjugate is forgotten: Re(E×H)", |wave| flow(&Wave { h: wave.h.map(|h| h.conj()), ..*wave }));

fn net_flow(bench: &mut Bench, flow: fn(&Wave) -> f64) -> Measured {
    let own = interface(bench.setting());
    let cases = [(1.5, 1.0), (2.4, 1.0), (1.52, 1.33), (own.n_i, own.n_t.re)];
    let inputs = cases.into_iter().filter_map(|(n_i, n_t)| Some((n_i, n_t, critical_angle(n_i, n_t)?)));
    let inputs = inputs.flat_map(|(n_i, n_t, critical)| {
        [1e-9, 1e-3, 0.1, 0.3].map(|past| Input {
            direction: Direction::Angle((critical + past).min(FRAC_PI_2)),
            n_i,
            n_t: n_t.into(),
        })
    });
    Measured::worst(inputs.flat_map(|input| {
        let incidence = Incidence::from(input.direction);
        let a = amplitudes(incidence, input.n_i, input.n_t);
        let tangential = input.n_i * incidence.sin();
        [Polarisation::S, Polarisation::P].into_iter().flat_map(move |polarisation| {
            let [incident, reflected, behind] = waves(polarisation, incidence, input.n_i, input.n_t, &a);
            let before = flow(&incident.plus(&reflected)) / (input.n_i * incidence.cos());
            // |k|² = |k_x|² + |k_z|², which for an evanescent wave is more than n².
            let wave_number =
                tangential.hypot((tangential - input.n_t.re).max(0.0).sqrt() * (tangential + input.n_t.re).sqrt());
            let strength = wave_number * behind.e.iter().map(|x| x.norm_sqr()).sum::<f64>();
            [("before", before), ("behind", flow(&behind) / strength)].map(|(side, share)| {
                (share / f64::EPSILON, format!("{side} the interface, {polarisation:?}, {}", describe(&input)))
            })
        })
    }))
}

fn phases(setting: &Setting) -> Plot {
    let own = interface(setting);
    let Some(critical) = critical_angle(own.n_i, own.n_t.re) else { return nothing_total() };
    let curve = |phase: fn(&light::optics::fresnel::Amplitudes) -> f64| {
        let points = super::over_angle_near(critical.to_degrees(), |incidence| {
            phase(&amplitudes(incidence, own.n_i, own.n_t)).to_degrees()
        });
        points.into_iter().filter(|point| point[0] >= critical.to_degrees()).collect::<Vec<_>>()
    };
    let chart = Chart::new(
        super::media(own.n_i, own.n_t),
        Axis::linear("angle of incidence θ_1", "°").range(critical.to_degrees().floor() - 2.0, 90.0),
        Axis::linear("phase", "°").range(-180.0, 180.0).tick(45.0),
    )
    .line(Hue::S, "δ_s", curve(|a| a.r_s.arg()))
    .line(Hue::P, "δ_p", curve(|a| a.r_p.arg()))
    .dashed(Hue::Natural, "δ_p − δ_s", curve(|a| (a.r_p / a.r_s).arg()))
    .at_x(critical.to_degrees(), "θ_c")
    .at_y(0.0, "");
    Plot::of("Phases under total reflection", chart)
}

fn depths(setting: &Setting) -> Plot {
    let own = interface(setting);
    let mut chart = Chart::new(
        "",
        Axis::linear("angle of incidence θ_1", "°").range(0.0, 90.0).tick(15.0),
        Axis::log("1/e depth of the field / λ", ""),
    );
    let media = [
        (1.333, 1.0, "water → air"),
        (1.519, 1.0, "glass → air"),
        (1.519, 1.333, "glass → water"),
        (2.423, 1.0, "diamond → air"),
    ];
    for (at, (n_i, n_t, label)) in media.into_iter().enumerate() {
        chart = chart.line(Hue::Nth(at as u8), label, depth_curve(n_i, n_t));
    }
    if critical_angle(own.n_i, own.n_t.re).is_some() {
        chart = chart.dashed(Hue::Natural, super::own_media(setting), depth_curve(own.n_i, own.n_t.re));
    }
    Plot::of("How deep the evanescent field reaches", chart)
}

fn depth_curve(n_i: f64, n_t: f64) -> Vec<[f64; 2]> {
    let Some(critical) = critical_angle(n_i, n_t) else { return Vec::new() };
    let all = super::over_angle_near(critical.to_degrees(), |incidence| evanescent_depth(incidence, n_i, n_t));
    all.into_iter().filter(|point| point[1].is_finite() && point[0] > critical.to_degrees()).collect()
}

/// What is drawn where nothing is totally reflected.
fn nothing_total() -> Plot {
    let empty = Chart::new(
        "into a denser medium nothing is totally reflected",
        Axis::linear("angle of incidence θ_1", "°").range(0.0, 90.0),
        Axis::linear("phase", "°").range(-180.0, 180.0),
    );
    Plot::of("Phases under total reflection", empty)
}
