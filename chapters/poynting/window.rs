//! C5: a detector averages over many periods, but not over a whole number of them.

use crate::figure::{Axis, Chart, Hue, Mark, Plot, Shape};
use crate::parameter::{Kind, Parameter, Setting};
use crate::plane_wave::{GREEN, VACUUM, described, quantity};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Expects, Heat, Measured, Misled, Question, Race, Step, check, exhibit, figure,
    fitted_order, lane, question, race, step,
};
use light::references::waves::phase;
use light::waves::flux::{Flux, Window};
use yardstick::precise;
use yardstick::quadrature::gauss_legendre;

const PERIODS: Parameter =
    Parameter::new("periods", "N", "how many periods the detector looks", Kind::number(0.1, 1e12, "1")).default("2.3");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "window",
    &[VACUUM, GREEN, PERIODS],
    &[
        figure(
            "windows",
            "The flow as the detector weighs it through a shutter and through soft windows \
             that open at a crest of E, with what it then reads, and by how much it may be off \
             at the worst opening.",
            windows,
        ),
        figure(
            "error",
            "Error of the average, at the worst opening, against its length in periods: the \
             shutter is right after whole half periods, the rest falls as 1/T or faster. From \
             10 periods on the curves would be solid bars; points mark the worst lengths, a \
             quarter of a period beyond whole ones.",
            errors,
        ),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "What a detector reads",
    "A shutter that cuts a period in two leaves an error that falls as 1/T; a soft one \
     does far better.",
)
.rows(&["C5"])
.questions(&[TENFOLD])
.readout(|setting| {
    let (flux, periods) = (super::flux(setting), setting.number("periods"));
    let off = |window: Window| worst(&flux, window, periods);
    vec![
        quantity("duration", "T", "how long it looks", periods / flux.frequency, "s"),
        quantity("box", "Δ(box)", "a shutter's error over the mean, at the worst opening", off(Window::Box), "1"),
        quantity("hann", "Δ(Hann)", "the same of a window 1 − cos", off(Window::Hann), "1"),
        quantity("sine_6", "Δ(sin⁶)", "the same of a window sin⁶", off(Window::Sine6), "1"),
    ]
})
.checks(&[&CLOSED_FORM, &BOX_FALLS, &HANN_FALLS, &BILLION])
.races(&[SAMPLED]);

const TENFOLD: Question = question(
    "tenfold",
    "A shutter opens for ten and a quarter periods, and what it averages is a little off, at the worst moment to \
     open. Ten times as long a look: how many times less is it off?",
    Answer::Number {
        unit: "1",
        tolerance: 0.02,
        right: |_| worst(&CLEAR, Window::Box, 10.25) / worst(&CLEAR, Window::Box, 102.5 - 0.25),
        slips: &[
            Misled {
                value: |_| 10f64.sqrt(),
                reply: "That is how *noise* averages out. Nothing here is random: one cut half-period is all that \
                 is wrong.",
            },
            Misled {
                value: |_| 100.0,
                reply: "A window that opens softly does even better than that; a shutter \
             does not.",
            },
        ],
    },
    "Ten: the cut half-period at the end stays what it is and is shared out over ten times as many.",
);

/// The error over the mean [1] of a look of so many `periods`, at the worst of all moments to open.
pub(super) fn worst(flux: &Flux, window: Window, periods: f64) -> f64 {
    (flux.swing / flux.mean * window.response(2.0, periods)).abs()
}

/// A clear wave of one period a second whose mean flow is 1.
const CLEAR: Flux = Flux { mean: 1.0, swing: 1.0, frequency: 1.0, phase: 0.0, lag: 0.0 };

const CLOSED_FORM: Check<f64> =
    check("closed_form", "what is left of the swing is the window's response at twice the frequency")
        .against(
            "the weighed flow integrated by Gauss's rule, for clear and lossy waves and odd \
             lengths of time",
        )
        .within(1e-13, "1", "96 points on at most eighteen swings are exact to rounding")
        .of(closed_form, 1.0)
        .slip("the frequency of the field for that of the flow", 0.5);

fn closed_form(_: &mut Bench, share: f64) -> Measured {
    let rule = gauss_legendre(96);
    let fluxes = [CLEAR, Flux { mean: 0.5f64.sqrt(), swing: 1.0, frequency: 1.3, phase: 0.2, lag: 0.125 }];
    let cases = fluxes.into_iter().flat_map(|flux| Window::ALL.map(|window| (flux, window)));
    let cases = cases.flat_map(|case| [0.1, 0.5, 1.0, 2.3, 4.25, 6.9].map(|duration| (case, duration)));
    Measured::worst(cases.map(|((flux, window), duration)| {
        let start = 0.37;
        let seen: f64 = rule.iter().map(|(u, weight)| weight * window.weight(*u) * flux.at(start + u * duration)).sum();
        let slow = Flux { frequency: share * flux.frequency, ..flux };
        (slow.average(window, start, duration) - seen, format!("{window:?}, {duration} s"))
    }))
}

const BOX_FALLS: Check<Window> = check("box_falls", "a shutter's error falls as 1/T")
    .against("the weighed flow itself, integrated by Gauss's rule half a period at a time")
    .order(1.0, 1e-6, "a quarter of a period beyond whole ones the sine is 1 and the error exactly 1/(2πN)")
    .of(falls, Window::Box)
    .slip("the soft window for the shutter", Window::Hann);

const HANN_FALLS: Check<Window> =
    check("hann_falls", "a window that opens and closes gently has one that falls as 1/T³")
        .against("the weighed flow itself, integrated by Gauss's rule half a period at a time")
        .order(3.0, 0.02, "the next term is smaller by 1/(2N)², and N is 10 and more")
        .of(falls, Window::Hann)
        .slip("the shutter for the soft window", Window::Box);

fn falls(_: &mut Bench, window: Window) -> Measured {
    let points = [10.25, 40.25, 160.25, 640.25].map(|periods| (periods, integrated(window, periods)));
    let value = fitted_order(&points).unwrap_or(f64::NAN);
    Measured::new(value, "10 to 640 periods", points.len())
}

/// What [`worst`] has in closed form, from the weights and the flow alone. The error swings with the moment of opening;
/// two moments an eighth of a period of the field apart tell its amplitude.
fn integrated(window: Window, periods: f64) -> f64 {
    let rule = gauss_legendre(16);
    let stretches = (2.0 * periods).ceil();
    let error = |start: f64| -> f64 {
        let stretch = |at: f64| -> f64 {
            let at = |u: f64| (at + u) / stretches;
            let swing = |u: f64| window.weight(at(u)) * (CLEAR.at(start + at(u) * periods) - CLEAR.mean);
            rule.iter().map(|(u, weight)| weight * swing(*u)).sum()
        };
        (0..stretches as u32).map(|at| stretch(f64::from(at))).sum::<f64>() / stretches
    };
    error(0.0).hypot(error(0.125))
}

const BILLION: Check<fn(Flux, f64) -> f64> =
    check("a_billion_periods", "after a billion periods of light the last cut is still where it belongs")
        .against("sin(4πfT)/(4πfT) from the exact product of f and T in 256 bits")
        .within(
            16.0,
            "ulp",
            "a few roundings of the small error itself, which is looked at relative to its own \
             size",
        )
        .of(billion, |flux, duration| flux.average(Window::Box, 0.0, duration))
        .slip("the sine of the rounded product", |flux, duration| {
            let swing = 4.0 * std::f64::consts::PI * flux.frequency * duration;
            flux.swing * swing.sin() / swing
        });

fn billion(_: &mut Bench, average: fn(Flux, f64) -> f64) -> Measured {
    let cases = [(5.45e14, 1.834e-6), (4.736_123_536_04e14, 2.1e-6), (5.45e14, 0.01), (7.89e14, 1.1), (1e16, 3600.0)];
    Measured::worst(cases.map(|(frequency, duration)| {
        let flux = Flux { frequency, mean: 0.0, ..CLEAR };
        // ∫cos 4πft dt = sin 4πfT/(4πf), and sin 2α = 2 sin α cos α.
        let exact = phase(frequency, duration);
        let two = precise::real(2.0);
        let cycles = precise::real(frequency) * precise::real(duration);
        let left = &exact.sin * &exact.cos / (precise::pi(precise::BITS) * two * cycles);
        (
            precise::relative_error(average(flux, duration), &left) / f64::EPSILON,
            format!("f = {frequency:e} Hz, T = {duration:e} s"),
        )
    }))
}

const SAMPLED: Race = race(
    "sampled",
    "sampled sixteen times a period, the average gets better with its length, and how \
     fast the window decides",
)
.work("samples")
.error("relative error of the mean, opened at a crest", "the mean over whole periods, which is known")
.lanes(&[
    lane("shutter", "shutter", &[18, 66, 258, 1026, 4098], |_, work| sampled(Window::Box, work)).expects(order(1.0)),
    lane("hann", "Hann", &[18, 66, 258, 1026], |_, work| sampled(Window::Hann, work)).expects(order(3.0)),
    lane("sine_6", "sin⁶", &[50, 82, 130, 210, 338], |_, work| sampled(Window::Sine6, work)).expects(order(7.0)),
]);

/// The order at which a window's last response falls, to the slope that its first ones still bend.
const fn order(order: f64) -> Expects {
    Expects::Order { order, tolerance: 0.15 * order }
}

/// The midpoint rule at sixteen samples a period of the field, over a length that leaves an eighth of it.
fn sampled(window: Window, work: u64) -> Heat {
    let rate = 16.0;
    let duration = work as f64 / rate;
    Heat {
        run: Box::new(move || {
            let at = |sample: u64| (sample as f64 + 0.5) / work as f64;
            let sum: f64 = (0..work).map(|sample| window.weight(at(sample)) * CLEAR.at(at(sample) * duration)).sum();
            vec![sum / work as f64]
        }),
        error: Box::new(|mean| (mean[0] - CLEAR.mean).abs()),
    }
}

fn windows(setting: &Setting) -> Plot {
    let (flux, set) = (super::flux(setting), setting.number("periods"));
    // More than a few dozen periods would be a solid bar.
    let periods = set.min(12.0);
    let (peak, duration) = (2.0 * flux.swing, periods / flux.frequency);
    let most = Window::ALL.map(|window| window.weight(0.5)).into_iter().fold(0.0, f64::max);
    let least = most * (flux.mean - flux.swing) / peak;
    let panel = |(at, window): (usize, Window)| {
        let curve = |value: &dyn Fn(f64) -> f64| -> Vec<[f64; 2]> {
            (0..=1200).map(|at| f64::from(at) / 1200.0).map(|u| [u * periods, value(u)]).collect()
        };
        let seen = flux.average(window, 0.0, set / flux.frequency);
        // One key for all.
        let name = |name: &str| if at == 0 { name.to_owned() } else { String::new() };
        Chart::new(
            format!("{}: error at most {}", name_of(window), power(worst(&flux, window, set))),
            Axis::linear("time in periods", "").range(0.0, periods),
            Axis::linear("weight, and S over its peak", "").range(1.1 * least - 0.1, 1.1 * most),
        )
        .dashed(Hue::Reference, name("weight"), curve(&|u| window.weight(u)))
        .line(Hue::Transmitted, name("S, weighed"), curve(&|u| window.weight(u) * flux.at(u * duration) / peak))
        .at_y(seen / peak, "reads")
        .into()
    };
    let number = crate::parameter::number;
    let title = match number(set) {
        drawn if periods == set => format!("{drawn} periods in {}", described(setting)),
        all => format!("{all} periods in {}, drawn as {}", described(setting), number(periods)),
    };
    Plot::grid(title, 2, Window::ALL.into_iter().enumerate().map(panel).collect())
}

fn name_of(window: Window) -> &'static str {
    match window {
        Window::Box => "shutter",
        Window::Hann => "Hann",
        Window::BlackmanHarris => "Blackman–Harris",
        Window::Sine6 => "sin⁶",
    }
}

/// `2.0·10^{−2}`, in the markup of labels.
fn power(x: f64) -> String {
    if x == 0.0 {
        return "0".into();
    }
    let text = format!("{x:.1e}").replace('-', "−");
    text.split_once('e').map_or(text.clone(), |(digits, power)| format!("{digits}·10^{{{power}}}"))
}

fn errors(setting: &Setting) -> Plot {
    let flux = super::flux(setting);
    let chart = Chart::new(
        "",
        Axis::log("length in periods N (from 10 on the worst ones)", "").range(0.3, 1e4),
        Axis::log("error over the mean, at the worst opening", "").range(1e-16, 10.0),
    );
    // Everywhere while the curves can be told apart, then at the worst lengths alone.
    let near = || (60..=2000).map(|at| f64::from(at) / 200.0);
    let far = || (20..=80).map(|at| (10f64.powf(f64::from(at) / 20.0)).floor() + 0.25);
    let chart = Window::ALL.into_iter().enumerate().fold(chart, |chart, (at, window)| {
        let left = |periods: f64| [periods, worst(&flux, window, periods)];
        let hue = Hue::Nth(at as u8);
        let envelope = far().map(left).filter(|point| point[1] > 1e-16);
        chart.line(hue, name_of(window), near().map(left).filter(|point| point[1] > 1e-16).collect()).with(
            Mark::Points { label: String::new(), hue, shape: Shape::Disc, joined: false, points: envelope.collect() },
        )
    });
    Plot::of(
        "How long must one look?",
        chart.at_x(setting.number("periods"), format!("N = {}", setting.text("periods"))),
    )
}
