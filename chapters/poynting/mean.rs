//! E23: the mean over a period.

use crate::figure::{Axis, Chart, Hue, Plot};
use crate::parameter::Setting;
use crate::plane_wave::transverse::harmonic;
use crate::plane_wave::{GREEN, VACUUM, described, quantity, wave};
use crate::symbols::{AMPLITUDE, E, EPSILON, H, K, OMEGA, PERIOD, S, T, V, Z};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Extreme, Heat, Measured, Misled, Question, Race, Step, check, derivation, exhibit,
    figure, lane, question, race, statement, step, stress,
};
use equation::derivation::Chain;
use equation::expr::{abs, cos, cross, dot, integral_between, mean, pi, ratio, sin, vector};
use equation::{Equation, Expr};
use light::references::waves::phase;
use light::waves::flux::Flux;
use light::waves::flux::{mean_of_pulse_train, pulse_train};
use light::waves::phase::{cis, cycles};
use light::waves::textbook::cos_of_time;
use light::waves::{Medium, Wave};
use std::f64::consts::PI;
use yardstick::precise;
use yardstick::quadrature::{gauss_legendre, simpson, trapezoid};
use yardstick::random::uniform;

pub(super) const EXHIBIT: Exhibit = exhibit(
    "mean",
    &[VACUUM, GREEN],
    &[figure(
        "period",
        "E, H and their product over two periods, with the mean of the product; below zero \
         energy flows back.",
        period,
    )],
);

pub(super) const STEP: Step =
    step(EXHIBIT, "The mean over a period", "A squared cosine is a half on average, so the mean flow is ½vεA².")
        .rows(&["E23"])
        .about("half")
        .statements(&[
            statement(
                "average",
                "the mean flow; in a clear wave S never turns back, so that |⟨S⟩| and ⟨|S|⟩ are \
                 the same",
                || Equation::new(mean(S), 1 / PERIOD * integral_between(S, T, 0, PERIOD)),
            ),
            statement("half", "of a harmonic wave of amplitude A in a clear medium", || {
                Equation::new(abs(mean(S)), ratio(1, 2) * V * EPSILON * AMPLITUDE.pow(2))
            }),
        ])
        .questions(&[OF_THE_PEAK])
        .derivations(&[
            derivation("cosine_squared", "⟨cos²⟩ = ½, by its antiderivative", || cosine_squared(ratio(1, 2)))
                .slip("the mean of |cos| for that of cos²", || cosine_squared(2 / pi())),
            derivation("half_v_epsilon", "S of a harmonic wave, averaged", || {
                half(ratio(1, 2) * V * EPSILON * AMPLITUDE.pow(2))
            })
            .slip("the peak for the mean", || half(V * EPSILON * AMPLITUDE.pow(2))),
        ])
        .readout(|setting| {
            let wave = wave(setting);
            vec![
                quantity("S_avg", "⟨S⟩", "mean flow at an amplitude of 1 V/m", wave.mean_flux, "W/m²"),
                quantity("A_sun", "A", "amplitude that carries 1 kW/m²", (1000.0 / wave.mean_flux).sqrt(), "V/m"),
            ]
        })
        .checks(&[&QUADRATURE, &ALIASES])
        .stress(&[stress(
            "late",
            "on its steep flanks the flow of light keeps its digits a nanosecond, a second and \
             a year after the start",
            |_| late(),
        )
        .textbook("cos² of the rounded product 2πft")
        .against(
            "the exact product f·t less its whole cycles, in 256 bits; f and t are taken as \
             exact, so that cond is 0",
        )])
        .races(&[AVERAGES]);

const OF_THE_PEAK: Question = question(
    "of_the_peak",
    "The flow of a clear wave has a peak of 1 W/m². What is its mean over a period, in W/m²?",
    Answer::Number {
        unit: "W/m²",
        tolerance: 0.01,
        right: |_| {
            let flux = Flux::at_depth(&Wave::new(&Medium::VACUUM, 1.0).expect("a positive frequency"), 1.0, 0.0);
            flux.mean / flux.at(0.0)
        },
        slips: &[
            Misled { value: |_| 2.0 / PI, reply: "That is the mean of |cos|. The flow goes as cos²." },
            Misled { value: |_| 0.0, reply: "That is the mean of the *fields*. S does not change its sign." },
            Misled {
                value: |_| 0.5f64.sqrt(),
                reply: "That is the root of the mean square, as of a voltage. A flow is no amplitude: its plain \
                 mean counts.",
            },
        ],
    },
    "A half: cos² is as often above ½ as below it. So ½vεA², with the amplitude, not the peak of S, squared.",
);

fn phase_at(z: Expr) -> Expr {
    z - OMEGA * T
}

fn cosine_squared(last: Expr) -> Chain {
    let square = cos(phase_at(K * Z)).pow(2);
    let over_a_period = 1 / PERIOD * integral_between(&square, T, 0, PERIOD);
    Chain::new(mean(&square))
        .given(mean(square), &over_a_period, "mean over a period")
        .given(PERIOD, 2 * pi() / OMEGA, "T = 2π/ω")
        .primitive(T / 2 - sin(2 * phase_at(K * Z)) / (4 * OMEGA), T)
        .then(over_a_period, ["mean over a period"])
        .then(last, ["2 cos²α = 1 + cos 2α", "T = 2π/ω"])
}

fn half(last: Expr) -> Chain {
    let flow = || dot(vector(0, 0, 1), S);
    let over_a_period = 1 / PERIOD * integral_between(flow(), T, 0, PERIOD);
    let angle = || phase_at(OMEGA / V * Z);
    let power = || V * EPSILON * AMPLITUDE.pow(2);
    harmonic(mean(flow()))
        .because("S runs along z")
        .given(S, cross(E, H), "S = E×H")
        .given(mean(flow()), &over_a_period, "mean over a period")
        .given(PERIOD, 2 * pi() / OMEGA, "T = 2π/ω")
        .primitive(power() * (T / 2 - sin(2 * angle()) / (4 * OMEGA)), T)
        .then(over_a_period, ["mean over a period"])
        .then(1 / PERIOD * integral_between(power() * cos(angle()).pow(2), T, 0, PERIOD), ["S = E×H", "v = 1/√(εμ)"])
        .then(last, ["⟨cos²⟩ = ½"])
}

const QUADRATURE: Check<fn(&Wave) -> f64> = check("quadrature", "the program's mean flow is ½vεA² in clear media")
    .against(
        "E·B/μ of the two cosines, averaged over a period by Gauss's rule; neither v nor ½ \
         is put in",
    )
    .within(64.0, "ulp", "forty terms, and a dozen roundings in k and Z")
    .of(averaged, |wave| wave.mean_flux)
    .slip("the peak for the mean", |wave| 2.0 * wave.mean_flux);

fn averaged(_: &mut Bench, program: fn(&Wave) -> f64) -> Measured {
    let media = [(1.0, 1.0), (2.25, 1.0), (80.0, 1.0), (1.0, 1000.0), (1e-3, 1e-3)];
    let rule = gauss_legendre(40);
    Measured::worst(media.map(|(epsilon_r, mu_r)| {
        let medium = Medium::relative(epsilon_r, mu_r, 0.0).expect("a clear medium");
        let wave = Wave::new(&medium, 3e15).expect("a positive frequency");
        // B of Faraday's law, k/ω times E.
        let flow = |share: f64| cis(share).re.powi(2) * (wave.k.re / wave.omega) / medium.mu();
        let mean: f64 = rule.iter().map(|(share, weight)| weight * flow(*share)).sum();
        ((program(&wave) / mean - 1.0) / f64::EPSILON, format!("ε_r = {epsilon_r}, μ_r = {mu_r}"))
    }))
}

const ALIASES: Check<fn(u32) -> u32> = check(
    "aliases",
    "over a period the trapezoid errs by the harmonics that its points take for the \
     mean, and by nothing else",
)
.against(
    "Σ 2I_{jn}(10)/I_0(10), j = 1, 2, …, the harmonics of the pulse train e^(10(cos \
     2πx − 1)), by power series",
)
.within(1e-14, "1", "sums of up to 48 terms of either sign, and one division")
.of(aliases, |points| points)
.slip("the harmonics of one interval more", |points| points + 1);

fn aliases(_: &mut Bench, first: fn(u32) -> u32) -> Measured {
    let mean = mean_of_pulse_train(SHARPNESS);
    Measured::worst([4, 6, 8, 12, 16, 24, 32, 48].map(|points| {
        let missed: f64 = (1..=12).map(|j| 2.0 * bessel_i(j * first(points))).sum();
        let found = total(&trapezoid(points as usize), 0.0, 1.0);
        (found / mean - 1.0 - missed / bessel_i(0), format!("{points} points"))
    }))
}

/// I_n(10), by its power series (DLMF §10.25.2): all terms are positive.
fn bessel_i(order: u32) -> f64 {
    let first = (1..=order).fold(1.0, |term, k| term * SHARPNESS / f64::from(k));
    let terms = (1..60).scan(first, |term, m| {
        *term *= SHARPNESS * SHARPNESS / (f64::from(m) * f64::from(m + order));
        Some(*term)
    });
    first + terms.sum::<f64>()
}

/// Moments where the flow is steep: an eighth of a period, or a little more, beyond a whole number of periods.
fn late() -> Vec<Extreme> {
    let frequencies = [50.0, 1e9, 4.736_123_536_04e14, 5.45e14, 1e16];
    let starts = [0.0_f64, 1e-15, 1e-9, 1e-6, 0.02, 1.0, 3.155_76e7];
    // In a year of light a period is shorter than what a time can tell apart: the phase there is steep by chance.
    let each = frequencies.into_iter().flat_map(|f| {
        starts.into_iter().zip(1..).map(move |(start, at)| (f, ((f * start).floor() + 0.1 + 0.013 * f64::from(at)) / f))
    });
    each.map(|(f, t)| {
        let exact = phase(f, t).cos;
        Extreme {
            input: format!("f = {f:e} Hz, t = {t:e} s"),
            quantity: "S/S_{max}",
            reference: &exact * &exact,
            textbook: cos_of_time(f, t).powi(2),
            ours: cis(cycles(f, t)).re.powi(2),
            condition: 0.0,
            worst_of: 1,
        }
    })
    .filter(|case| precise::to_f64(&case.reference) > f64::MIN_POSITIVE)
    .collect()
}

/// How peaked the pulses of the race are.
const SHARPNESS: f64 = 5.0;

/// Over a whole period all but chance converge faster than any power, so that no order is asserted of them; the check
/// `aliases` holds every error of the trapezoid against what it must be.
const AVERAGES: Race = race(
    "averages",
    "over a whole period the plainest rule is the best: the trapezoid gains digits in \
     proportion to its points",
)
.work("evaluations of S")
.error(
    "relative error of the mean",
    "relative error of the mean of a train of pulses e^(10(cos 2πx − 1)), against \
     e^(−10) I₀(10) by its series",
)
.lanes(&[
    lane("monte_carlo", "Monte Carlo", &[16, 64, 256, 1024, 4096, 16384], |bench, work| {
        let weight = 1.0 / work as f64;
        summed((0..work).map(|_| (uniform(&mut bench.stream, 0.0, 1.0), weight)).collect())
    })
    .repeated(32)
    .order(0.5, 0.15),
    lane("simpson_half", "Simpson, over 0.4 of the period", &[16, 32, 64, 128, 256], |_, work| {
        part_of_a_period(simpson(work as usize))
    })
    .order(4.0, 0.4),
    lane("trapezoid_half", "trapezoid, over 0.4 of the period", &[16, 32, 64, 128, 256], |_, work| {
        part_of_a_period(trapezoid(work as usize))
    })
    .order(2.0, 0.2),
    lane("simpson", "Simpson", &[8, 16, 24, 32, 48], |_, work| summed(simpson(work as usize))).converges(
        1e-10,
        "of 48 points the harmonic 24 is taken for the mean with a third of its weight, ⅔ \
         I₂₄(10)/I₀(10) = 6·10⁻¹¹",
    ),
    lane("gauss", "Gauss", &[8, 12, 16, 24, 32], |_, work| summed(gauss_legendre(work as usize))).converges(
        4e-6,
        "64/15 M ρ⁻⁶⁴ over the mean, M the largest value on the ellipse of half-axes 0.4 \
         and 1.08, ρ their sum (Trefethen, SIAM Rev. 50, 2008, theorem 4.5)",
    ),
    lane("trapezoid", "trapezoid", &[4, 8, 12, 16, 24], |_, work| summed(trapezoid(work as usize)))
        .converges(2e-10, "of 24 points the harmonic 24 is taken for the mean, 2 I₂₄(10)/I₀(10) = 1.9·10⁻¹⁰"),
    lane("trapezoid_enough", "trapezoid, 32 points and more", &[32, 64, 128], |_, work| {
        summed(trapezoid(work as usize))
    })
    .within(1e-13, "the harmonics that it takes for the mean are below rounding"),
]);

fn total(rule: &[(f64, f64)], from: f64, to: f64) -> f64 {
    let flow = |share: f64| pulse_train(SHARPNESS, from + (to - from) * share);
    rule.iter().map(|(share, weight)| weight * flow(*share)).sum()
}

/// The mean over the period by a rule on 0 … 1, timed.
fn summed(rule: Vec<(f64, f64)>) -> Heat {
    Heat {
        run: Box::new(move || vec![total(&rule, 0.0, 1.0)]),
        error: Box::new(|mean| (mean[0] / mean_of_pulse_train(SHARPNESS) - 1.0).abs()),
    }
}

/// The mean over a part of the period by a rule on 0 … 1, timed: a cut anywhere takes the trapezoid's gift away.
fn part_of_a_period(rule: Vec<(f64, f64)>) -> Heat {
    let (from, to) = (0.1, 0.5);
    Heat {
        run: Box::new(move || vec![total(&rule, from, to)]),
        error: Box::new(move |mean| (mean[0] / total(&gauss_legendre(64), from, to) - 1.0).abs()),
    }
}

fn period(setting: &Setting) -> Plot {
    let flux = super::flux(setting);
    let peak = 2.0 * flux.swing;
    let times = || (0..=600).map(|at| f64::from(at) / 300.0);
    let curve = |value: &dyn Fn(f64) -> f64| times().map(|x| [x, value(x)]).collect::<Vec<_>>();
    let chart = Chart::new(
        "",
        Axis::linear("time t / T", "").range(0.0, 2.0).tick(0.25),
        Axis::linear("over the amplitude, S over |E||H|", "").range(-1.1, 1.1),
    )
    .line(Hue::S, "E", curve(&|x| cis(x).re))
    .dashed(Hue::P, "H", curve(&|x| cis(x - flux.lag).re))
    .line(Hue::Transmitted, "S", curve(&|x| flux.at(x / flux.frequency) / peak))
    .at_y(flux.mean / peak, "⟨S⟩")
    .at_y(0.0, "");
    Plot::of(format!("The flow over two periods in {}", described(setting)), chart)
}
