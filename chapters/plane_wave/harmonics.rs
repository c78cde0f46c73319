//! E13: a pulse is a sum of harmonics.

use super::rms_difference;
use crate::figure::Mark;
use crate::figure::{Axis, Chart, Hue, Plot, Shape};
use crate::parameter::{Kind, Parameter, Setting};
use crate::symbols::{K, OMEGA, T, WAVE, Z};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Expects, Heat, Measured, Quantity, Question, Race, Step, check, choice, exhibit,
    figure, lane, question, race, statement, step,
};
use equation::expr::{Range, exp, i, integral};
use equation::{Dimension, Equation, Symbol};
use light::waves::harmonics::Spectrum;
use std::f64::consts::PI;
use yardstick::quadrature::gauss_legendre;

/// What a wave holds of each frequency.
const SPECTRUM: Symbol = Symbol::scalar("a", Dimension::VOLT_PER_METRE.times(Dimension::SECOND));

const HARMONICS: Parameter =
    Parameter::new("harmonics", "M", "how many harmonics are kept", Kind::Count { min: 1, max: 2000 }).default("15");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "harmonics",
    &[HARMONICS],
    &[
        figure(
            "partial_sums",
            "Partial sums of a square pulse: the horns at the edges get narrower with more harmonics, but not lower.",
            gibbs,
        ),
        figure("spectra", "How much of each harmonic a smooth and a square pulse hold.", spectra),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "One frequency suffices",
    "Any pulse of finite energy is a sum of cosines, each of which can be followed by itself.",
)
.rows(&["E13"])
.statements(&[statement("sum", "the wave as a sum over frequencies, each with its own k", || {
    let each = SPECTRUM.at([OMEGA.into()]) * exp(i() * (K * Z - OMEGA * T));
    Equation::new(WAVE.at([Z.into(), T.into()]), integral(each, [OMEGA.into()], Range::Whole))
})])
.questions(&[HORNS])
.readout(readout)
.checks(&[&THROUGH_THE_SPECTRUM, &PARSEVAL, &GIBBS])
.races(&[TRUNCATED]);

const HORNS: Question = question(
    "horns",
    "A square pulse is put together from its harmonics, and overshoots beside its edges. What becomes of these \
     horns as more and more harmonics are taken?",
    Answer::Choice {
        options: &[
            choice(
                "they shrink to nothing",
                "Their *energy* does, since they get narrower. Their height is another question.",
            ),
            choice("they get narrower and stay as high", ""),
            choice("they grow", "Then the sums would not converge in the mean square, as Parseval says they do."),
        ],
        right: |_| {
            let horn = |harmonics: usize| {
                let series = Spectrum::of_square(0.5, PERIOD, harmonics).expect("a width within the period");
                series.at(0.25 - 0.5 / (harmonics as f64 + 1.0)) - 1.0
            };
            match horn(1023) / horn(63) {
                share if share < 0.5 => 0,
                share if share < 1.5 => 1,
                _ => 2,
            }
        },
        slip: |_| 0,
    },
    "They stay 9 % of the edge high, however many harmonics there are, and move ever closer to it. At every point \
     beside the edge the sum is right in the end.",
);

/// The period [m] that holds a pulse; its harmonics are those of a string of that length.
const PERIOD: f64 = 1.0;
/// Width of the smooth pulse e^(−z²/2w²) [m].
const SMOOTH: f64 = 0.04;
/// Width of the square one [m].
const SQUARE: f64 = 0.3;

/// The nearest repetition of `z` to the origin.
fn nearest(z: f64) -> f64 {
    z - (z / PERIOD).round() * PERIOD
}

fn smooth(z: f64) -> f64 {
    (-0.5 * (nearest(z) / SMOOTH).powi(2)).exp()
}

fn square(z: f64) -> f64 {
    if nearest(z).abs() < 0.5 * SQUARE { 1.0 } else { 0.0 }
}

fn readout(setting: &Setting) -> Vec<Quantity> {
    let kept = setting.number("harmonics") as usize;
    let [square, smooth] = [square_series(4096), smooth_series(256)];
    let lost = |spectrum: &Spectrum| spectrum.tail(kept) / spectrum.mean_square().sqrt();
    let overshoot = square_series(kept).at(0.5 * SQUARE - 0.5 / (kept as f64 + 1.0)) - 1.0;
    let all = [
        ("lost_square", "Δ(square)", "rms share of the square pulse beyond them", lost(&square)),
        ("lost_smooth", "Δ(smooth)", "rms share of the smooth pulse beyond them", lost(&smooth)),
        ("overshoot", "ΔE", "overshoot of the square pulse beside its edge; 8.95 % in the limit", overshoot),
    ];
    all.map(|(key, symbol, says, value)| Quantity { key, symbol, says, value, unit: "1" }).into()
}

fn square_series(harmonics: usize) -> Spectrum {
    Spectrum::of_square(SQUARE, PERIOD, harmonics).expect("a width within the period")
}

fn smooth_series(harmonics: usize) -> Spectrum {
    Spectrum::of_gaussian(SMOOTH, PERIOD, harmonics).expect("a width within the period")
}

const THROUGH_THE_SPECTRUM: Check<f64> =
    check("through_the_spectrum", "a pulse taken apart into harmonics, moved and put together again is d'Alembert's")
        .against("d'Alembert: the shape evaluated at z − vt")
        .within(
            1e-13,
            "1",
            "two transforms of 256 samples, each right to a few ulp times the logarithm of their number",
        )
        .of(through_the_spectrum, 1.0)
        .slip("e^{+ik vt} for e^{−ik vt}: the pulse runs the other way", -1.0);

fn through_the_spectrum(_: &mut Bench, sense: f64) -> Measured {
    let places = 256;
    let spectrum = Spectrum::of(smooth, PERIOD, places).expect("finite samples");
    let ways = [0.0, 1e-3, 0.123, 0.5, 0.77, 3.3, 1000.25];
    Measured::worst(ways.map(|way| {
        let found = spectrum.shifted(sense * way).samples(places).expect("a number of places");
        let exact = (0..places).map(|j| smooth(j as f64 / places as f64 * PERIOD - way));
        let worst = Measured::worst(found.iter().zip(exact).map(|(found, exact)| (found - exact, String::new())));
        (worst.value, format!("vt = {way} m"))
    }))
}

const PARSEVAL: Check<f64> = check("parseval", "the harmonics hold the energy of the pulse, no more and no less")
    .against("the mean of E² over the samples, without any transform")
    .within(32.0, "ulp", "sums of up to 1025 squares, and transforms whose errors average out")
    .of(parseval, 1.0)
    .slip("the harmonics of negative frequency forgotten", 0.5);

fn parseval(bench: &mut Bench, share: f64) -> Measured {
    let counts = [3, 65, 257, 1025];
    Measured::worst(counts.into_iter().flat_map(|count| {
        let at = |j: usize| j as f64 / count as f64 * PERIOD;
        let noise = (0..count).map(|_| yardstick::random::uniform(&mut bench.stream, -1.0, 1.0)).collect::<Vec<_>>();
        let pulses = [
            ("smooth", (0..count).map(|j| smooth(at(j))).collect()),
            ("square", (0..count).map(|j| square(at(j))).collect()),
            ("noise", noise),
        ];
        pulses.map(|(name, samples): (_, Vec<f64>)| {
            let spectrum = Spectrum::of_samples(&samples, PERIOD).expect("finite samples");
            let constant = spectrum.coefficients()[0].re.powi(2);
            let harmonics = constant + share * (spectrum.mean_square() - constant);
            let energy = samples.iter().map(|sample| sample * sample).sum::<f64>() / count as f64;
            ((harmonics / energy - 1.0) / f64::EPSILON, format!("{name}, {count} samples"))
        })
    }))
}

const GIBBS: Check<f64> =
    check("gibbs", "however many harmonics there are, they overshoot an edge by 8.95 % of its height")
        .against("Wilbraham's integral Si(π)/π − ½ by Gauss's rule; the program sums the series")
        .within(2e-4, "1", "the first correction falls as 1/M², and the least M is 127")
        .of(overshoot, PI)
        .slip("a horn half as wide", PI / 2.0);

fn overshoot(_: &mut Bench, upper: f64) -> Measured {
    let sinc: f64 = gauss_legendre(24).iter().map(|(u, weight)| weight * upper * (upper * u).sin() / (upper * u)).sum();
    let wilbraham = sinc / PI - 0.5;
    Measured::worst([127, 511, 2047].map(|harmonics| {
        let series = Spectrum::of_square(0.5, PERIOD, harmonics).expect("a width within the period");
        let peak = series.at(0.25 - 0.5 / (harmonics as f64 + 1.0)) - 1.0;
        (peak - wilbraham, format!("{harmonics} harmonics"))
    }))
}

/// Places for each harmonic at which the sums are formed; at the works raced none lies on an edge of the square pulse.
const PLACES: usize = 16;
/// How far the pulses have run [m].
const WAY: f64 = 0.37;

const TRUNCATED: Race = race(
    "truncated",
    "a smooth pulse needs few harmonics and a square one never has enough; the fast transform sums them all at once",
)
.work("harmonics")
.error("rms error of E", "root mean square over sixteen places a harmonic, against d'Alembert")
.lanes(&[
    lane("square_one_by_one", "square pulse, one by one", &[16, 32, 64, 128], |_, work| {
        raced(square, square_series(work as usize), one_by_one)
    })
    .expects(HALF),
    lane("square_transformed", "square pulse, fast transform", &[16, 32, 64, 128, 256, 512], |_, work| {
        raced(square, square_series(work as usize), transformed)
    })
    .expects(HALF),
    lane("smooth_one_by_one", "smooth pulse, one by one", FEW, |_, work| {
        raced(smooth, smooth_series(work as usize), one_by_one)
    })
    .expects(TAIL),
    lane("smooth_transformed", "smooth pulse, fast transform", FEW, |_, work| {
        raced(smooth, smooth_series(work as usize), transformed)
    })
    .expects(TAIL),
    lane("smooth_all", "smooth pulse, all that count", &[40, 80, 160, 320], |_, work| {
        raced(smooth, smooth_series(work as usize), transformed)
    })
    .expects(ALL),
]);

/// By Parseval the error is what the harmonics left out hold together: 1/m each, 1/√M in sum.
const HALF: Expects = Expects::Order { order: 0.5, tolerance: 0.1 };
/// Harmonics of the smooth pulse that still leave something to be seen.
const FEW: &[u64] = &[4, 6, 8, 10, 12, 14, 16, 20, 24];
/// It falls faster than any power, so that it has no order.
const TAIL: Expects =
    Expects::Converges { last: 4e-10, why: "√(2Σ|c_m|²) over m > 24 is 3.9·10⁻¹⁰, by Parseval" };
const ALL: Expects = Expects::Within { limit: 1e-13, why: "what is left out is below rounding" };

/// At as many places as `spectrum` can fill.
fn transformed(spectrum: &Spectrum) -> Vec<f64> {
    spectrum.samples(PLACES * spectrum.coefficients().len()).expect("a number of places")
}

fn one_by_one(spectrum: &Spectrum) -> Vec<f64> {
    let count = PLACES * spectrum.coefficients().len();
    (0..count).map(|j| spectrum.at(j as f64 / count as f64 * PERIOD)).collect()
}

/// `shape` from its harmonics after the way that it runs.
fn raced(shape: fn(f64) -> f64, spectrum: Spectrum, sum: fn(&Spectrum) -> Vec<f64>) -> Heat {
    let spectrum = spectrum.shifted(WAY);
    Heat {
        run: Box::new(move || sum(&spectrum)),
        error: Box::new(move |found| {
            let exact = (0..found.len()).map(|j| shape(j as f64 / found.len() as f64 * PERIOD - WAY));
            rms_difference(found, &exact.collect::<Vec<_>>())
        }),
    }
}

fn gibbs(setting: &Setting) -> Plot {
    let own = setting.number("harmonics") as usize;
    let mut counts = vec![own, 4 * own + 3];
    counts.retain(|count| *count <= 8000);
    let edge = 0.5 * SQUARE;
    // Evenly, and a dozen places to every swing of the finest sum next to the edges.
    let finest = 1.0 / (24.0 * *counts.last().expect("its own at least") as f64);
    let beside = [-edge, edge].into_iter().flat_map(|edge| (-360..=360).map(move |at| edge + f64::from(at) * finest));
    let mut places: Vec<f64> = (-1500..=1500).map(|at| f64::from(at) / 3000.0).chain(beside).collect();
    places.sort_by(f64::total_cmp);
    let exact = || vec![[-0.5, 0.0], [-edge, 0.0], [-edge, 1.0], [edge, 1.0], [edge, 0.0], [0.5, 0.0]];
    let panel = |title: &str, from: f64, to: f64, low: f64, high: f64, name: fn(String) -> String| {
        let axes =
            Chart::new(title, Axis::linear("z", "m").range(from, to), Axis::linear("E / A", "").range(low, high));
        let chart = counts.iter().enumerate().fold(axes, |chart, (at, count)| {
            let series = square_series(*count);
            let shown = places.iter().filter(|z| (from..=to).contains(*z));
            let points = shown.map(|&z| [z, series.at(z)]).collect();
            chart.line(Hue::Nth(at as u8), name(format!("M = {count}")), points)
        });
        chart.dashed(Hue::Reference, name("the pulse".into()), exact())
    };
    let overshoot = light::waves::harmonics::GIBBS_OVERSHOOT;
    // One key for both.
    let whole = panel("The pulse", -0.5, 0.5, -0.25, 1.25, |_| String::new());
    let beside = panel("Beside an edge", 0.05, 0.2, 0.75, 1.15, |name| name).at_y(1.0 + overshoot, "8.95 %");
    Plot::grid("A square pulse from its harmonics", 2, vec![whole.into(), beside.into()])
}

fn spectra(setting: &Setting) -> Plot {
    let most = 60;
    let points = |spectrum: Spectrum| -> Vec<[f64; 2]> {
        let all = spectrum.coefficients().iter().enumerate().skip(1).map(|(m, c)| [m as f64, c.norm()]);
        // Every tenth harmonic of the square pulse is zero.
        all.filter(|[_, size]| *size > 1e-16).collect()
    };
    let mark =
        |label: &str, hue, shape, points| Mark::Points { label: label.into(), hue, shape, joined: false, points };
    let chart = Chart::new(
        "",
        Axis::linear("harmonic m", "").range(0.0, most as f64),
        Axis::log("share |c_m|", "").range(1e-16, 1.0),
    )
    .dashed(Hue::Reference, "1/(πm)", (1..=most).map(|m| m as f64).map(|m| [m, 1.0 / (PI * m)]).collect())
    .with(mark("square pulse", Hue::Nth(0), Shape::Square, points(square_series(most))))
    .with(mark("smooth pulse", Hue::Nth(1), Shape::Disc, points(smooth_series(most))));
    let own = setting.number("harmonics");
    let (chart, beyond) = match own <= most as f64 {
        true => (chart.at_x(own, format!("M = {own}")), String::new()),
        false => (chart, format!(" (M = {own} is off the axis)")),
    };
    Plot::of(format!("What a pulse holds of each harmonic{beyond}"), chart)
}
