//! E18: waves where there is a current.

use super::perspective::{LONGEST, span, travelling};
use super::transverse::{oblique, solves_maxwell};
use super::wave_equation::twice;
use super::{described, quantity, wave};
use crate::figure::{Axis, Chart, Dash, Hue, Mark, Plot};
use crate::parameter::{Conductor, FREQUENCY, MEDIUM, Setting};
use crate::symbols::{AMPLITUDE, B, DELTA, E, EPSILON, H, J, K, K_VECTOR, MU, OMEGA, SIGMA, T, Z, Z_C};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Extreme, Measured, Misled, Quantity, Question, Step, check, derivation, exhibit,
    figure, question, statement, step, stress,
};
use equation::derivation::Chain;
use equation::expr::{abs, cos, curl, divergence, dot, exp, i, laplacian, partial, pi, ratio, sin, sqrt, tan, vector};
use equation::{Dimension, Equation, Expr, Symbol};
use light::Complex64;
use light::media;
use light::references::waves::{NAMES, PlaneWave, flat};
use light::waves::constants::EPSILON_0;
use light::waves::{Medium, Wave, textbook};
use std::f64::consts::{PI, TAU};
use yardstick::initial_value::runge_kutta;
use yardstick::precise;

/// The angle by which H lags E.
const PHI: Symbol = Symbol::scalar("phi", Dimension::ONE).real(0.1, 0.7);
/// Amplitude and phase of H.
const AMPLITUDE_H: Symbol = Symbol::scalar("H_0", Dimension::AMPERE_PER_METRE);
/// A wave number that may be complex.
const K_C: Symbol = Symbol::scalar("k", Dimension::RADIAN_PER_METRE).within(0.5, 2.0);

pub(super) const EXHIBIT: Exhibit = exhibit(
    "conductor",
    &[MEDIUM, FREQUENCY],
    &[
        figure("perspective", "E and B of a wave that decays, in perspective: B trails behind E.", perspective),
        figure(
            "decay",
            "E and H against depth at one instant, between their envelopes, and S, whose \
             envelope falls twice as fast.",
            decay,
        ),
        figure(
            "skin_depths",
            "Skin depth against frequency over fifteen decades, as far as each medium was \
             measured; metals appear again as light meets them.",
            skin_depths,
        ),
        figure(
            "lags",
            "By how much H lags E, and how much of the field is lost over a wavelength, \
             against σ/(ωε).",
            lags,
        ),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Where there is a current",
    "A current makes k and Z complex: the wave decays as it runs, and H lags E, by up \
     to an eighth of a period where ε > 0 and σ are real (metals in light are not \
     such).",
)
.rows(&["E18"])
.statements(&[
    statement("wave_number", "the square of the complex wave number", || {
        Equation::new(K.pow(2), EPSILON * MU * OMEGA.pow(2) + i() * MU * SIGMA * OMEGA)
    }),
    statement("impedance", "the complex impedance, E over H", || Equation::new(Z_C, OMEGA * MU / K)),
    statement("lag", "twice the angle by which H lags E", || Equation::new(tan(2 * PHI), SIGMA / (OMEGA * EPSILON))),
    statement("skin_depth", "the depth at which the field has fallen to 1/e, in a good conductor", || {
        Equation::approximate(DELTA, sqrt(2 / (OMEGA * MU * SIGMA)))
    }),
])
.questions(&[DEEPER])
.derivations(&[
    derivation("telegraph", "Ampère's law with J = σE, and the curl of Faraday's", || {
        telegraph(MU * SIGMA * partial(E, T))
    })
    .slip("the current that the field drives is taken for one that drives the field", || {
        telegraph(-(MU * SIGMA * partial(E, T)))
    }),
    derivation("dispersion", "a wave e^{i(k·r − ωt)} in that equation", || dispersion(i() * MU * SIGMA * OMEGA))
        .slip("the sign that belongs to e^{+iωt}: the wave would grow", || dispersion(-(i() * MU * SIGMA * OMEGA))),
    derivation("all_four", "with that k the wave obeys all four equations, whatever the direction", || {
        solves_maxwell(Some(SIGMA), EPSILON * MU * partial(E, T))
    })
    .slip("the displacement current runs backwards", || solves_maxwell(Some(SIGMA), -(EPSILON * MU * partial(E, T)))),
    derivation("ohms", "Faraday's law ties H to E", || ohms(OMEGA * MU / K_C))
        .slip("H on the other side of E: that wave runs back", || ohms(-(OMEGA * MU / K_C))),
    derivation(
        "angle_of_k",
        "H lags E by the angle of k, whose square has σ/(ωε) for the tangent of twice that angle",
        || lag(SIGMA / (OMEGA * EPSILON)),
    )
    .slip("displacement current over conduction", || lag(OMEGA * EPSILON / SIGMA)),
    derivation("good_conductor", "k = (1 + i)/δ where the displacement current is nothing beside σE", || {
        good_conductor(sqrt(2 / (OMEGA * MU * SIGMA)))
    })
    .slip("the two under the root is lost", || good_conductor(sqrt(1 / (OMEGA * MU * SIGMA)))),
    derivation("eighth_of_a_period", "and there H lags E by 45°", || eighth_of_a_period(ratio(1, 4)))
        .slip("a quarter of a period, as in a coil", || eighth_of_a_period(ratio(1, 2))),
])
.readout(readout)
.checks(&[&HANDBOOK, &INTEGRATED])
.stress(&[stress(
    "any_medium",
    "from the best insulator to the best conductor, 1 mHz to 1e16 Hz, every output \
     stays within 16 ulp · (1 + cond)",
    |_| families().iter().flat_map(|(name, inputs)| worst_cases(name, inputs)).collect(),
)
.textbook("√(√(1 + τ²) ∓ 1)")
.against(
    "k = √(ω²εμ + iωμσ) in 256 bits; cond from difference quotients with a relative step \
     of 1e−30",
)]);

const DEEPER: Question = question(
    "deeper",
    "Into copper a field of 1 GHz reaches two micrometres. How deep does one of 4 GHz reach, over that?",
    Answer::Number {
        unit: "1",
        tolerance: 0.01,
        right: |_| {
            let [fast, slow] = [4e9, 1e9].map(|frequency| {
                let copper = media::named("copper").and_then(|copper| copper.wave(frequency).ok());
                copper.expect("known there").skin_depth
            });
            fast / slow
        },
        slips: &[
            Misled { value: |_| 0.25, reply: "By k² = iωμσ it is the *square* of the depth that goes as 1/ω." },
            Misled {
                value: |_| 2.0,
                reply: "The faster the field swings, the more current it drives, and the sooner that has used it \
                 up.",
            },
            Misled {
                value: |_| 1.0,
                reply: "Only where displacement current rules, as in poor conductors, does the depth not ask for ω.",
            },
        ],
    },
    "One half: δ = √(2/(ωμσ)). It falls as the root over eleven decades, as the figure shows, until electrons no \
     longer keep up with the field.",
);

/// Maxwell's equations with J = σE and no charges.
fn telegraph(conduction: Expr) -> Chain {
    Chain::new(curl(curl(E)))
        .given(divergence(E), 0, "∇·E = 0")
        .given(divergence(B), 0, "∇·B = 0")
        .given(J, SIGMA * E, "J = σE")
        .given(partial(B, T), -curl(E), "∇×E = −∂B/∂t")
        .given(partial(E, T), curl(B) / (EPSILON * MU) - J / EPSILON, "∇×B = μJ + εμ ∂E/∂t")
        .then(-partial(curl(B), T), ["∇×E = −∂B/∂t", "derivatives commute"])
        .then(-(MU * partial(J, T)) - EPSILON * MU * twice(E, T), ["∇×B = μJ + εμ ∂E/∂t"])
        .then(-(MU * SIGMA * partial(E, T)) - EPSILON * MU * twice(E, T), ["J = σE"])
        .then(Equation::new(laplacian(E), conduction + EPSILON * MU * twice(E, T)), ["∇×∇× = ∇∇· − ∇²", "∇·E = 0"])
}

fn dispersion(loss: Expr) -> Chain {
    let square = EPSILON * MU * OMEGA.pow(2) + loss;
    oblique(laplacian(E) - MU * SIGMA * partial(E, T) - EPSILON * MU * twice(E, T))
        .because("nought, by the wave equation with a current")
        .then((square - dot(K_VECTOR, K_VECTOR)) * E, ["∇ = ik, ∂/∂t = −iω"])
        .because("so the factor in front of E vanishes")
}

fn ohms(impedance: Expr) -> Chain {
    let along = |amplitude: Symbol| amplitude * exp(i() * (K_C * Z - OMEGA * T));
    Chain::assume(
        Equation::new(dot(vector(0, 1, 0), curl(E)), -(MU * dot(vector(0, 1, 0), partial(H, T)))),
        "Faraday's law",
    )
    .given(E, vector(along(AMPLITUDE), 0, 0), "E = A e^{i(kz − ωt)} along x")
    .given(H, vector(0, along(AMPLITUDE_H), 0), "H along y, of any size and phase")
    .solve_for([AMPLITUDE_H])
    .then(Equation::new(AMPLITUDE / AMPLITUDE_H, impedance), ["∂/∂z = ik, ∂/∂t = −iω"])
}

fn lag(tangent: Expr) -> Chain {
    Chain::assume(Equation::new(abs(K_C).pow(2) * cos(2 * PHI), EPSILON * MU * OMEGA.pow(2)), "Re k²")
        .and(Equation::new(abs(K_C).pow(2) * sin(2 * PHI), MU * SIGMA * OMEGA), "Im k²")
        .solve_for([EPSILON, SIGMA])
        .then(Equation::new(tan(2 * PHI), sin(2 * PHI) / cos(2 * PHI)), ["tan = sin/cos"])
        .then(tangent, ["k² = εμω² + iμσω"])
}

fn good_conductor(depth: Expr) -> Chain {
    Chain::new(((1 + i()) / DELTA).pow(2))
        .because("k² with k = (1 + i)/δ: a wave that turns by a radian while it falls to 1/e")
        .given(DELTA, depth, "δ = √(2/(ωμσ))")
        .then(2 * i() / DELTA.pow(2), ["(1 + i)² = 2i"])
        .then(i() * MU * SIGMA * OMEGA, ["δ = √(2/(ωμσ))"])
}

fn eighth_of_a_period(share: Expr) -> Chain {
    Chain::new(OMEGA * MU / ((1 + i()) / DELTA))
        .because("Z = ωμ/k with k = (1 + i)/δ")
        .given(MU, 2 / (OMEGA * SIGMA * DELTA.pow(2)), "δ = √(2/(ωμσ))")
        .then((1 - i()) / (SIGMA * DELTA), ["δ = √(2/(ωμσ))", "conjugate"])
        .then(sqrt(Expr::from(2)) / (SIGMA * DELTA) * exp(-(i() * pi() * share)), ["e^{−iπ/4} = (1 − i)/√2"])
}

fn readout(setting: &Setting) -> Vec<Quantity> {
    let wave = wave(setting);
    let tangent = setting.conductor("medium").loss_tangent(setting.frequency());
    let tangent =
        tangent.map(|value| quantity("loss_tangent", "σ/(ωε)", "conduction over displacement current", value, "1"));
    let depth = wave.skin_depth;
    let depth = quantity("skin_depth", "δ", "depth at which the field has fallen to 1/e", depth, "m");
    let rest = vec![
        quantity("k_re", "Re k", "phase per metre", wave.k.re, "rad/m"),
        quantity("k_im", "Im k", "decay per metre", wave.k.im, "1/m"),
        quantity("attenuation", "A", "the decay in decibels", wave.attenuation_db(), "dB/m"),
        quantity("Z_re", "Re Z", "E over H, the part in phase", wave.impedance.re, "Ω"),
        quantity("Z_im", "Im Z", "E over H, the part out of phase", wave.impedance.im, "Ω"),
        quantity("phase_lag", "φ", "by which H lags E", wave.phase_lag, "rad"),
        quantity("wavelength", "λ", "wavelength in the medium", wave.wavelength, "m"),
        quantity("v_phase", "v", "speed of the phase", wave.v_phase, "m/s"),
    ];
    tangent.into_iter().chain(Some(depth).filter(|depth| depth.value.is_finite())).chain(rest).collect()
}

const HANDBOOK: Check<fn(f64, f64) -> f64> =
    check("handbook", "the skin depths of four metals at 10 GHz are those of the handbooks")
        .against("Pozar, Microwave Engineering (4th ed.), example 1.2")
        .within(1.5e-3, "1", "printed to three digits, from a constant that has three")
        .of(handbook, |frequency, sigma| depth(TAU * frequency, sigma))
        .slip("f taken for ω", depth);

/// The skin depth [m] of a metal, by the program.
fn depth(omega: f64, sigma: f64) -> f64 {
    let metal = Medium::relative(1.0, 1.0, sigma);
    metal.ok().and_then(|metal| Wave::new(&metal, omega).ok()).map_or(f64::NAN, |wave| wave.skin_depth)
}

/// Frequency [Hz] and conductivity [S/m] to depth [m].
fn handbook(_: &mut Bench, depth: fn(f64, f64) -> f64) -> Measured {
    let printed = [
        ("aluminium", 3.816e7, 8.14e-7),
        ("copper", 5.813e7, 6.60e-7),
        ("gold", 4.098e7, 7.86e-7),
        ("silver", 6.173e7, 6.40e-7),
    ];
    Measured::worst(printed.map(|(name, sigma, printed)| (depth(10e9, sigma) / printed - 1.0, name.to_owned())))
}

/// Whatever a wave is like deep inside, on the way to the surface the part that decays inwards outgrows the other.
const INTEGRATED: Check<f64> = check(
    "integrated",
    "k and Z are those of the two curl equations, integrated from deep inside to the \
     surface",
)
.against(
    "dE/dz = iωμH and dH/dz = (iωε − σ)E by Runge and Kutta's fourth-order rule, from \
     a wall at E = H",
)
.within(
    1e-9,
    "1",
    "steps of a few thousandths of 1/|k|, over which the rule errs by |kh|⁵/120; what \
     runs back is e^(−50)",
)
.of(integrated, 1.0)
.slip("the displacement current runs backwards", -1.0);

fn integrated(_: &mut Bench, displacement: f64) -> Measured {
    let tangents = [0.3, 1.0, 5.0, 100.0, 1e6, 1e12];
    Measured::worst(tangents.map(|tangent| {
        let omega = 1e9;
        let medium = Medium::relative(4.0, 2.0, tangent * omega * 4.0 * EPSILON_0).expect("a medium");
        let wave = Wave::new(&medium, omega).expect("a positive frequency");
        let (scale, depths) = (wave.k.norm(), 26.0);
        // Dimensionless: z in 1/|k|, H in E/|Z|, so that dE/dz = iaH and dH/dz = (ib − c)E.
        let ohms = wave.impedance.norm();
        let a = Complex64::new(0.0, omega * medium.mu() / (scale * ohms));
        let b = Complex64::new(-medium.sigma(), displacement * omega * medium.epsilon()) * (ohms / scale);
        let slope = |[e, h]: [Complex64; 2]| [a * h, b * e];
        let total = depths * scale / wave.k.im;
        let per_unit = 250.0;
        let steps = (total * per_unit).ceil() as usize;
        let mut fields = [Complex64::ONE; 2];
        let mut halfway = fields;
        let marker = (per_unit * 0.5) as usize;
        for step in 0..steps {
            if steps - step == marker {
                halfway = fields;
            }
            fields = runge_kutta(fields, -1.0 / per_unit, slope);
            // The decaying wave grows towards the surface; only ratios matter.
            let size = fields[0].norm();
            if size > 1e3 {
                fields = fields.map(|field| field / size);
                halfway = halfway.map(|field| field / size);
            }
        }
        let impedance = fields[0] / fields[1] * ohms;
        let k = Complex64::new(0.0, -1.0) * (halfway[0] / fields[0]).ln() / (marker as f64 / per_unit) * scale;
        let off = ((impedance - wave.impedance) / wave.impedance).norm().max(((k - wave.k) / wave.k).norm());
        (off, format!("σ/(ωε) = {tangent}"))
    }))
}

/// Inputs with what they have in common.
type Family = (&'static str, Vec<(Medium, f64)>);

fn families() -> Vec<Family> {
    let frequencies = [1e-3, 1.0, 50.0, 1e6, 1e9, 5.45e14, 1e16];
    let with = |parameters: &[(f64, f64, f64)]| -> Vec<(Medium, f64)> {
        let media =
            parameters.iter().filter_map(|&(epsilon_r, mu_r, sigma)| Medium::relative(epsilon_r, mu_r, sigma).ok());
        media.flat_map(|medium| frequencies.map(|f| (medium, TAU * f))).collect()
    };
    let powers = |from: i32, to: i32| (from..=to).map(|power| format!("1e{power}").parse::<f64>().expect("a number"));
    let traces: Vec<_> = powers(-30, -9).step_by(3).map(|sigma| (2.1, 1.0, sigma)).collect();
    let between: Vec<_> = powers(-6, 3).flat_map(|sigma| [(80.0, 1.0, sigma), (1.0, 1.0, sigma)]).collect();
    let metals: Vec<_> = powers(4, 12).flat_map(|sigma| [(1.0, 1.0, sigma), (1.0, 5000.0, sigma)]).collect();
    let beyond: Vec<_> = powers(20, 300).step_by(40).map(|sigma| (1.0, 1.0, sigma)).collect();
    let known =
        media::electric().flat_map(|known| frequencies.map(|f| Some((known.medium(f).ok()?, TAU * f)))).flatten();
    vec![
        ("a trace of conduction", with(&traces)),
        ("neither one nor the other", with(&between)),
        ("metals", with(&metals)),
        ("towards the perfect conductor", with(&beyond)),
        ("lossless", with(&[(1.0, 1.0, 0.0), (2.1, 1.0, 0.0), (1e-6, 1e6, 0.0)])),
        ("media by name", known.collect()),
    ]
}

/// For every output the input of a family at which the program uses up most of what it is allowed, and the one at which
/// the textbook loses most.
fn worst_cases(name: &str, inputs: &[(Medium, f64)]) -> Vec<Extreme> {
    let mut worst: Vec<Option<(f64, Extreme)>> = vec![None; NAMES.len()];
    let mut lost: Vec<Option<(f64, Extreme)>> = vec![None; NAMES.len()];
    for (medium, omega) in inputs {
        let Ok(wave) = Wave::new(medium, *omega) else { continue };
        let exact = PlaneWave::new(medium, *omega);
        let (ours, written, conditions) = (flat(&wave), flat(&textbook::wave(medium, *omega)), exact.conditions());
        for at in 0..NAMES.len() {
            let Some(reference) = &exact.outputs[at] else { continue };
            let extreme = || Extreme {
                input: format!("{name}: {}", describe(medium, *omega)),
                quantity: NAMES[at],
                reference: reference.clone(),
                textbook: written[at],
                ours: ours[at],
                condition: conditions[at],
                worst_of: inputs.len(),
            };
            let keep = |slot: &mut Option<(f64, Extreme)>, value: f64| {
                let value = if value.is_nan() { f64::INFINITY } else { value };
                if slot.as_ref().is_none_or(|(most, _)| value > *most) {
                    *slot = Some((value, extreme()));
                }
            };
            keep(&mut worst[at], precise::relative_error(ours[at], reference) / (1.0 + conditions[at]));
            keep(&mut lost[at], precise::relative_error(written[at], reference));
        }
    }
    // One row of the two where they are the same.
    let both = worst.into_iter().zip(lost).flat_map(|(worst, lost)| {
        let same = worst.as_ref().zip(lost.as_ref()).is_some_and(|(a, b)| a.1.input == b.1.input);
        [worst, lost.filter(|_| !same)]
    });
    both.flatten().map(|(_, extreme)| extreme).collect()
}

fn describe(medium: &Medium, omega: f64) -> String {
    let relative = medium.epsilon() / EPSILON_0;
    format!("ε_r = {relative:.3e}, σ = {:e} S/m, f = {:e} Hz", medium.sigma(), omega / TAU)
}

fn perspective(setting: &Setting) -> Plot {
    let wave = wave(setting);
    let shown = match span(&wave) {
        far if far < LONGEST => format!("five skin depths, {far:.1} wavelengths"),
        far => format!("{far} wavelengths"),
    };
    Plot::of(
        format!("E (blue, upright) and B (red, across) along z, in {}", described(setting)),
        travelling(shown, &wave, 0.0),
    )
}

fn decay(setting: &Setting) -> Plot {
    let wave = wave(setting);
    let title = format!("Decay and lag in {}", described(setting));
    let (rate, turn, far) = (wave.k.im / wave.k.re, TAU, span(&wave));
    let curve = |value: &dyn Fn(f64) -> f64| -> Vec<[f64; 2]> {
        (0..=600).map(|at| far * f64::from(at) / 600.0).map(|z| [z, value(z)]).collect()
    };
    let envelope = |z: f64| (-rate * turn * z).exp();
    let lag = wave.phase_lag;
    let chart = Chart::new(
        "",
        Axis::linear("depth z / λ", "").range(0.0, far),
        Axis::linear("field over its amplitude at z = 0", "").range(-1.05, 1.05),
    )
    .line(Hue::S, "E", curve(&|z| envelope(z) * (turn * z).cos()))
    .dashed(Hue::P, "H", curve(&|z| envelope(z) * (turn * z + lag).cos()))
    .line(
        Hue::Transmitted,
        "S over |E||H| at z = 0",
        curve(&|z| envelope(z).powi(2) * (turn * z).cos() * (turn * z + lag).cos()),
    )
    .at_y(0.0, "");
    if wave.k.im == 0.0 {
        return Plot::of(title, chart);
    }
    let dotted =
        |label: &str, points| Mark::Line { label: label.into(), hue: Hue::Natural, dash: Dash::Dotted, points };
    let chart = chart
        .dashed(Hue::Reference, "±e^{−z/δ}", curve(&envelope))
        .dashed(Hue::Reference, "", curve(&|z| -envelope(z)))
        .with(dotted("e^{−2z/δ}", curve(&|z| envelope(z).powi(2))));
    Plot::of(title, chart)
}

/// Substances whose skin depths are drawn.
const DRAWN: [&str; 6] = ["copper", "aluminium", "iron", "graphite", "sea-water", "soil"];

fn skin_depths(setting: &Setting) -> Plot {
    let depths = |medium: Conductor| -> Vec<[f64; 2]> {
        let frequencies = (0..=600).map(|at| 10f64.powf(f64::from(at) / 40.0));
        let depth = |f: f64| medium.wave(f).map_or(f64::NAN, |wave| wave.skin_depth);
        frequencies.map(|f| [f, depth(f)]).collect()
    };
    let mut chart = Chart::new(
        "",
        Axis::log("frequency f", "Hz").range(1.0, 1e15),
        Axis::log("skin depth δ", "m").range(1e-9, 1e4),
    );
    let known: Vec<_> = DRAWN.iter().filter_map(|name| media::named(name)).collect();
    for (at, known) in known.iter().enumerate() {
        chart = chart.line(Hue::Nth(at as u8), known.name, depths(Conductor::Substance(known)));
    }
    let own = setting.conductor("medium");
    if known.iter().all(|known| Conductor::Substance(known) != own) {
        chart = chart.dashed(Hue::Natural, setting.text("medium"), depths(own));
    }
    Plot::of(
        "Skin depth, as far as each medium is known",
        chart.at_x(setting.frequency(), format!("f = {}", setting.text("freq"))),
    )
}

fn lags(setting: &Setting) -> Plot {
    let tangents = || (0..=400).map(|at| 10f64.powf(f64::from(at) / 25.0 - 6.0));
    let wave_at = |tangent: f64| {
        let medium = Medium::relative(1.0, 1.0, tangent * EPSILON_0).expect("a medium");
        Wave::new(&medium, 1.0).expect("a positive frequency")
    };
    let own = setting.conductor("medium").loss_tangent(setting.frequency());
    let axis = || Axis::log("σ/(ωε)", "").range(1e-6, 1e10);
    let (shown, note) = match own {
        Some(own) if (1e-6..=1e10).contains(&own) => (Some(own), String::new()),
        Some(_) => (None, format!(" ({}: off the axis)", described(setting))),
        None => (None, format!(" ({}: by its index, no σ)", described(setting))),
    };
    let mark = |chart: Chart| shown.into_iter().fold(chart, |chart, own| chart.at_x(own, described(setting)));
    let lag = Chart::new("Lag", axis(), Axis::linear("lag of H behind E, φ", "°").range(0.0, 55.0).tick(15.0))
        .line(Hue::Ours, "", tangents().map(|tangent| [tangent, wave_at(tangent).phase_lag.to_degrees()]).collect())
        .at_y(45.0, "45°");
    let lost = Chart::new("Decay", axis(), Axis::log("1 − |E(λ)|/|E(0)|", "").range(1e-6, 10.0))
        .line(
            Hue::Ours,
            "lost over a wavelength",
            tangents()
                .map(wave_at)
                .zip(tangents())
                .map(|(wave, t)| [t, -(-TAU * wave.k.im / wave.k.re).exp_m1()])
                .collect(),
        )
        .dashed(Hue::Reference, "π σ/(ωε)", tangents().map(|t| [t, PI * t]).collect());
    Plot::grid(format!("A conductor is what has σ ≫ ωε{note}"), 2, vec![mark(lag).into(), mark(lost).into()])
}
