//! C24: the picture, for eyes and for numbers.

use super::scenes::{colours, greens, rendered, small};
use super::ways::shown;
use crate::figure::{Axis, Chart, Hue, Panel, Picture, Plot};
use crate::parameter::{Kind, Parameter, Setting};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Extreme, Measured, Misled, Quantity, Step, check, excess, exhibit, figure, question,
    step, stress,
};
use light::scene::Scene;
use light::tone::{Curve, decoded, encoded};
use light::transport::Manner;
use yardstick::precise;

const SCENE: Parameter = Parameter::new(
    "scene",
    "",
    "which of the lecture's scenes",
    Kind::Choice(&["cornell", "glass", "veach", "metals", "far", "tiny"]),
)
.default("cornell");
const STOPS: Parameter =
    Parameter::new("stops", "s", "exposure, in factors of two", Kind::number(-8.0, 8.0, "1")).default("1");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "picture",
    &[SCENE, STOPS],
    &[
        figure(
            "curves",
            "What a screen takes for a grey of some radiance, by the curves that bring it into range.",
            curves,
        ),
        figure("pictures", "One picture by each of them.", pictures),
        figure("bounces", "Light that came straight from the lamp, and all of it.", bounces),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "The picture",
    "Radiance has no upper end and screens have: numbers go into the file for numbers, and a curve makes those for eyes.",
)
.rows(&["C24"])
.questions(&[question(
    "edge",
    "A pixel lies on an edge: half of its paths find white paper that is as bright as the screen can be, half find black. Which of 0 … 255 does an sRGB screen get for it?",
    Answer::Number {
        unit: "1",
        tolerance: 0.02,
        right: |_| 255.0 * encoded(0.5),
        slips: &[
            Misled { value: |_| 127.5, reply: "That is the mean of the codes. Radiance is what must be averaged: half the light is code 188." },
            Misled { value: |_| 255.0 * decoded(0.5), reply: "That is the curve the wrong way round." },
        ],
    },
    "188: half the light, which eye and screen take for far more than half.",
)])
.readout(|setting| {
    let name = setting.word("scene");
    let [straight, all] = [Some(2), Some(16)].map(|depth| {
        let scene = Scene { max_depth: depth, ..small(name, 16) };
        greens(&rendered(&scene, &Manner::default(), 16)).mean()
    });
    let shown = |curve: Curve| curve.apply([all * setting.number("stops").exp2(); 3])[1];
    vec![
        Quantity { key: "mean", symbol: "⟨L⟩", says: "mean radiance of the picture (green)", value: all, unit: "W/(m² sr)" },
        Quantity {
            key: "indirect",
            symbol: "1 − L_2/L",
            says: "share of it that came by more than one surface",
            value: 1.0 - straight / all,
            unit: "1",
        },
        Quantity {
            key: "code",
            symbol: "c",
            says: "what a screen takes for a grey of that radiance, of 255, by AgX",
            value: 255.0 * encoded(shown(Curve::Agx)),
            unit: "1",
        },
    ]
})
.checks(&[&ROUND_TRIP, &BYTES])
.stress(&[stress("bright", "lamps of any radiance, up to what numbers can be: white", bright)
    .textbook("the curves' quotients as they are printed, cut at 1")
    .against("1, which both curves have passed there")]);

const ROUND_TRIP: Check<fn(f64) -> f64> =
    check("round_trip", "each of a screen's 256 codes is itself again after being read as light")
        .against("the code, against that of its own light, by IEC 61966-2-1 both ways")
        .within(
            0.01,
            "1",
            "of a code: the standard's constants have four digits, and its two pieces miss each other by 1e-4 of one",
        )
        .of(
            |_: &mut Bench, light: fn(f64) -> f64| {
                Measured::worst((0..=255).map(|code| {
                    let back = 255.0 * encoded(light(f64::from(code) / 255.0));
                    (back - f64::from(code), format!("code {code}"))
                }))
            },
            decoded as fn(f64) -> f64,
        )
        .slip("the plain power 2.2", |taken| taken.powf(2.2));

/// A linear share of light as it is after being kept in a byte.
type Kept = fn(f64) -> f64;

const BYTES: Check<Kept> =
    check("bytes", "a byte a channel is enough for eyes: from a twentieth of white on no step is seen")
        .against("the radiance itself, over a thousand of them from 1/20 to 1")
        .within(0.02, "1", "a difference of 2 % is about what eyes can tell (Weber's fraction)")
        .of(
            |_: &mut Bench, kept: Kept| {
                Measured::worst(
                    (0..=1000)
                        .map(|k| 0.05 * 20f64.powf(f64::from(k) / 1000.0))
                        .map(|x: f64| (excess((kept(x) / x - 1.0).abs()), format!("L = {x:.4} of white"))),
                )
            },
            |x| decoded((255.0 * encoded(x)).round() / 255.0),
        )
        .slip("a byte that counts light evenly", |x| (255.0 * x).round() / 255.0);

fn bright(_: &Setting) -> Vec<Extreme> {
    let radiances = [10.0, 1e6, 1e100, 1e160, 1e308];
    let of = |curve: Curve, name: &'static str, printed: fn(f64) -> f64| {
        radiances.map(|x| Extreme {
            input: format!("L = {x:e}, {}", title(curve)),
            quantity: name,
            reference: precise::real(1.0),
            // Not by `min`, which would take 1 for a number that is none.
            textbook: if printed(x) > 1.0 { 1.0 } else { printed(x) },
            ours: curve.apply([x; 3])[1],
            condition: 0.0,
            worst_of: 1,
        })
    };
    let reinhard = of(Curve::Reinhard, "shown", |x| x * (1.0 + x / 16.0) / (1.0 + x));
    let aces = of(Curve::Aces, "shown", |x| x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14));
    [reinhard, aces].concat()
}

/// A curve's name, as it is written.
fn title(curve: Curve) -> &'static str {
    match curve {
        Curve::None => "cut at white",
        Curve::Reinhard => "Reinhard",
        Curve::Aces => "ACES-like",
        Curve::Agx => "AgX-like",
    }
}

fn curves(setting: &Setting) -> Plot {
    let exposure = setting.number("stops").exp2();
    let mut chart = Chart::new(
        "",
        Axis::log("radiance L, white paper at 1", "").range(1e-3, 100.0),
        Axis::linear("what the screen takes", "").range(0.0, 1.0),
    );
    for (k, curve) in Curve::ALL.into_iter().enumerate() {
        let at = |k: i32| 10f64.powf(f64::from(k) / 20.0 - 3.0);
        let points = (0..=100).map(at).map(|x| [x, encoded(curve.apply([exposure * x; 3])[1])]).collect();
        chart = chart.line(Hue::Nth(k as u8), title(curve), points);
    }
    Plot::of(format!("From radiance to screen, at {:+} stops", setting.number("stops")), chart)
}

fn pictures(setting: &Setting) -> Plot {
    let (name, exposure) = (setting.word("scene"), setting.number("stops").exp2());
    let found = colours(&rendered(&small(name, 96), &Manner::default(), 8));
    let panel = |curve: Curve| {
        let of = |colour: &[f64; 3]| curve.apply(colour.map(|x| exposure * x)).map(|x| x as f32);
        Panel::from(Picture::new(title(curve), 96, found.iter().map(of).collect()))
    };
    Plot::grid(
        format!("{name}, 16 paths a pixel, {:+} stops", setting.number("stops")),
        2,
        Curve::ALL.map(panel).into(),
    )
}

fn bounces(setting: &Setting) -> Plot {
    let name = setting.word("scene");
    let panel = |(depth, title): (u32, &str)| {
        let scene = Scene { max_depth: Some(depth), ..small(name, 72) };
        Panel::from(shown(title, &rendered(&scene, &Manner::default(), 8), 72))
    };
    let depths = [(2, "straight from lamps"), (3, "by one surface more"), (16, "by fifteen")];
    Plot::grid(format!("{name}: what came how"), 3, depths.map(panel).into())
}
