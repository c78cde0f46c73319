//! C27, first part: wavelengths, only where glass asks for them.

use super::one_ray::judged;
use super::scenes::{needle, rendered, small};
use super::symbols::{N, S_HALF};
use super::ways::{shown, smallest};
use crate::figure::{Axis, Chart, Hue, Plot};
use crate::parameter::{BY_FREQUENCY, Kind, Parameter, Setting};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Extreme, Measured, Misled, Quantity, Step, check, choice, derivation, exhibit,
    figure, question, step, stress,
};
use equation::Expr;
use equation::derivation::Chain;
use equation::expr::sqrt;
use light::colour::response::{BAND, response};
use light::colour::{blackbody, chromaticity, linear_srgb, tristimulus};
use light::media;
use light::number::Vector;
use light::optics::Incidence;
use light::optics::fresnel::powers;
use light::optics::prism::{half_sine, least_deviation};
use light::scene::builtin::prism::on_screen;
use light::scene::{Camera, Scene};
use light::transport::{Manner, Stage};
use std::f64::consts::FRAC_PI_3;
use std::sync::OnceLock;
use yardstick::precise;
use yardstick::statistics::Moments;

const GLASS: Parameter = Parameter::new(
    "glass",
    "",
    "of which the prism is made",
    Kind::Choice(&["sf11", "bk7", "fused-silica", "water", "sapphire"]),
)
.default("sf11");
const WAVELENGTH: Parameter =
    Parameter::new("wavelength", "λ", "of the light, in vacuum", Kind::number(BAND[0], BAND[1], "m"))
        .default("550nm")
        .aliases(&[BY_FREQUENCY]);

pub(super) const EXHIBIT: Exhibit = exhibit(
    "dispersion",
    &[GLASS, WAVELENGTH],
    &[
        figure(
            "responses",
            "What each channel of a picture sees of a wavelength: rows of the sRGB matrix times the standard observer, in daylight. They reach below zero.",
            responses,
        ),
        figure(
            "rainbow",
            "The lecture's prism, and its screen from nearby. White ticks at its foot, from left to right, stand where Snell's law puts 430, 480, 530, 580, 630 and 680 nm; further up lines bend to the left, for what goes through a prism at a slant is turned more.",
            rainbow,
        ),
        figure("spread", "The least deviation of a prism of 60° over the wavelength, for five media.", spread),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Wavelengths where glass asks for them",
    "A path carries three channels until glass would part them; then one wavelength is drawn, and the channels weigh what they see of it.",
)
.rows(&["C27"])
.derivations(&[
    derivation("symmetric", "where the deviation is least, both faces bend alike: the slopes balance in no other way", || {
        balance((N.pow(2) - 1) * (S_HALF.pow(2) - OTHER.pow(2)))
    })
    .slip("n for n²", || balance((N - 1) * (S_HALF.pow(2) - OTHER.pow(2)))),
    derivation("half_sine", "sin ½δ as a product, which keeps its digits where the index is nearly 1", || {
        product((N - 1) * (N + 1))
    })
    .slip("(n − 1)² for n² − 1", || product((N - 1).pow(2))),
])
.questions(&[question(
    "negative",
    "A laser of 500 nm shines on white paper: one single wavelength. What does the red channel of the picture hold?",
    Answer::Choice {
        options: &[
            choice("nothing: it is green", "To match it with a screen's three lamps one would have to take red *away*."),
            choice("a little red, as green lamps have too", "So much green that even less red than none would be needed."),
            choice("less than nothing", ""),
        ],
        right: |_| {
            let [red, green, _] = response().at(500e-9);
            if red < -0.01 * green { 2 } else if red > 0.01 * green { 1 } else { 0 }
        },
        slip: |_| 0,
    },
    "No screen shows the colours of single wavelengths. Below zero they stay in the file; what the screen cannot show is cut last, when many wavelengths have been added up.",
), question(
    "bends",
    "A prism of 60° is made of glass with n = 1.5. By how many degrees, at least, does it turn light?",
    Answer::Number {
        unit: "°",
        tolerance: 0.01,
        right: |_| least_deviation(FRAC_PI_3, 1.5).map_or(f64::NAN, f64::to_degrees),
        slips: &[
            Misled { value: |_| 30.0, reply: "(n − 1)A is what thin prisms do. At 60° the sines are no angles any more." },
            Misled { value: |_| 2.0 * 0.75f64.asin().to_degrees(), reply: "That is δ + A: the angle A of the edge has to be taken off." },
        ],
    },
    "37.2°: 2 arcsin(1.5 sin 30°) − 60°.",
)])
.readout(|setting| {
    let (name, wavelength) = (setting.word("glass"), setting.number("wavelength"));
    let n = index(name, wavelength);
    let bent = |wavelength| least_deviation(FRAC_PI_3, index(name, wavelength)).unwrap_or(f64::NAN);
    let [red, green, blue] = response().at(wavelength).map(|r| r * 1e-9);
    let quantity = |key, symbol, says, value, unit| Quantity { key, symbol, says, value, unit };
    vec![
        quantity("index", "n", "of the glass", n, "1"),
        quantity("deviation", "δ", "least deviation by a prism of 60°", bent(wavelength).to_degrees(), "°"),
        quantity("spread", "δ_F − δ_C", "between the lines F, 486 nm, and C, 656 nm", (bent(486.1e-9) - bent(656.3e-9)).to_degrees(), "°"),
        quantity("red", "r_R", "what red sees of that wavelength", red, "1/nm"),
        quantity("green", "r_G", "what green sees", green, "1/nm"),
        quantity("blue", "r_B", "what blue sees", blue, "1/nm"),
    ]
})
.checks(&[&SNELL, &GLOWS])
.stress(&[stress("prisms", "prisms of hardly any glass, hardly any angle, and just before nothing gets through", prisms)
    .textbook("sin(arcsin(n s) − arcsin s), with s = sin ½A")
    .against("n s √(1 − s²) − s √(1 − n²s²) in 256 bits")]);

/// sin of the angle within the glass at the other face.
const OTHER: equation::Symbol = equation::Symbol::scalar("u", equation::Dimension::ONE).real(0.1, 0.5);

/// cos² β₁ cos² θ₂ − cos² β₂ cos² θ₁, with sin θ = n sin β on either side: the squares of dθ/dβ = n cos β/cos θ, over each other.
fn balance(last: Expr) -> Chain {
    let (one, other) = (S_HALF.pow(2), OTHER.pow(2));
    let cos2 = |sin2: &Expr| 1 - sin2.clone();
    let bent = |sin2: &Expr| 1 - N.pow(2) * sin2.clone();
    Chain::new(cos2(&other) * bent(&one) - cos2(&one) * bent(&other))
        .because("cos²β₂ cos²θ₁ − cos²β₁ cos²θ₂ with Snell's sin θ = n sin β")
        .then(-(last), ["multiply out"])
}

/// sin(α − β) with sin α = n s, sin β = s.
fn product(contrast: Expr) -> Chain {
    let (near, far) = (sqrt(1 - S_HALF.pow(2)), sqrt(1 - N.pow(2) * S_HALF.pow(2)));
    Chain::new(N * S_HALF * &near - S_HALF * &far)
        .because("sin α cos β − cos α sin β, with sin α = n s and sin β = s")
        .then(
            S_HALF * (N.pow(2) * (1 - S_HALF.pow(2)) - (1 - N.pow(2) * S_HALF.pow(2))) / (N * &near + &far),
            ["times and over the sum"],
        )
        .then(S_HALF * contrast / (N * near + far), ["s² cancels"])
}

/// n [1] at a wavelength [m] in the band.
fn index(name: &str, wavelength: f64) -> f64 {
    let known = media::named(name).and_then(|medium| medium.index(wavelength).ok());
    known.map_or(f64::NAN, |index| index.re)
}

/// What a strip shows that begins where light of a wavelength [m] goes, and reaches to where shorter ones do: ∫ r_c T₁T₂ dλ, by Snell's
/// law and E42 at both faces of a prism that light of that wavelength goes through alike.
fn passed(name: &str, last: f64, seen: fn(f64) -> [f64; 3]) -> [f64; 3] {
    const STEPS: u32 = 4000;
    let theta = (index(name, last) * (FRAC_PI_3 / 2.0).sin()).asin();
    let step = (last - BAND[0]) / f64::from(STEPS);
    let mut sum = [0.0; 3];
    for k in 0..STEPS {
        let wavelength = BAND[0] + step * (f64::from(k) + 0.5);
        let n = index(name, wavelength);
        let second = FRAC_PI_3 - (theta.sin() / n).asin();
        let there = powers(Incidence::from_angle(theta), 1.0, n.into()).t_n();
        let back = powers(Incidence::from_angle(second), n, 1.0.into()).t_n();
        let seen = seen(wavelength);
        sum = std::array::from_fn(|c| sum[c] + seen[c] * there * back * step);
    }
    sum
}

const SNELL: Check<fn(f64) -> [f64; 3]> =
    check("snell", "through a prism a channel sees of a strip what wavelengths go there by Snell's law")
        .against("∫ r_c T dλ over the wavelengths that least deviation sends there, against 64 runs by many lanes for three strips and three channels (t-tests)")
        .significant(1e-3)
        .of(
            |_: &mut Bench, seen: fn(f64) -> [f64; 3]| {
                let name = "sf11";
                let strips = [490e-9, 550e-9, 610e-9].map(|last| {
                    let bent = least_deviation(FRAC_PI_3, index(name, last)).unwrap_or(f64::NAN);
                    let scene = needle(name, bent);
                    let mut found = [Moments::default(), Moments::default(), Moments::default()];
                    for seed in 0..64 {
                        let halves = rendered(&scene, &Manner { seed, ..Manner::default() }, 128);
                        for (c, moments) in found.iter_mut().enumerate() {
                            moments.add(halves.iter().flatten().map(|half| f64::from(half[c])).sum::<f64>() / 2.0);
                        }
                    }
                    let exact = passed(name, last, seen);
                    [0, 1, 2].map(|c| {
                        let of = judged(&found[c], exact[c]);
                        Measured { at: format!("to {:.0} nm, channel {c}: {}", last * 1e9, of.at), ..of }
                    })
                });
                smallest(strips.concat())
            },
            |wavelength| response().at(wavelength),
        )
        .slip("what is below zero cut off before the mean", |wavelength| response().at(wavelength).map(|r| r.max(0.0)));

const GLOWS: Check<fn(f64, f64) -> f64> =
    check("locus", "what glows has the colours that are printed, from 1667 K to 100 000 K; and an even spectrum is in the middle")
        .against("u and v of the locus: A. R. Robertson, J. Opt. Soc. Am. 58 (1968) 1528, table 1; x = y = ⅓ of the even spectrum, to 5e-5, as the CIE has it")
        .within(1.0, "1", "over 8e-6: five digits are printed, ±5e-6, and a sum every 5 nm is good to about 2e-6")
        .of(
            |_: &mut Bench, glows: fn(f64, f64) -> f64| {
                let printed = [
                    (10.0, [0.18066, 0.26589]),
                    (50.0, [0.18388, 0.27709]),
                    (100.0, [0.19032, 0.29326]),
                    (150.0, [0.19962, 0.30921]),
                    (250.0, [0.22511, 0.33439]),
                    (400.0, [0.27218, 0.35407]),
                    (600.0, [0.33724, 0.36051]),
                ];
                let even = chromaticity(tristimulus(|_| 1.0));
                let even = even.map(|x| ((x - 1.0 / 3.0) / 5e-5, "an even spectrum".to_owned()));
                let all = printed.into_iter().flat_map(|(mired, printed)| {
                    let [x, y, z] = tristimulus(|wavelength| glows(wavelength, 1e6 / mired));
                    let whole = x + 15.0 * y + 3.0 * z;
                    let found = [4.0 * x / whole, 6.0 * y / whole];
                    [0, 1].map(|k| ((found[k] - printed[k]) / 8e-6, format!("{:.0} K, {}", 1e6 / mired, ["u", "v"][k])))
                });
                Measured::worst(all.chain(even))
            },
            blackbody as fn(f64, f64) -> f64,
        )
        .slip("Wien's law for Planck's", |wavelength: f64, temperature: f64| {
            let c_2 = 1.438_776_877e-2;
            wavelength.powi(-5) * (-c_2 / (wavelength * temperature)).exp()
        });

fn prisms(_: &Setting) -> Vec<Extreme> {
    let tried = [
        (0.5, 1.0 + 1e-15),
        (0.5, 1.0 + 1e-9),
        (0.5, 1.000_277),
        (1e-9, 1.5),
        (1e-150, 1.5),
        (0.5, 1.7847),
        (0.5, 2.0 - 1e-9),
        (0.5, 2.0),
        (0.9999, 1.0001),
    ];
    tried
        .map(|(s, n): (f64, f64)| {
            let (s_exact, n_exact) = (precise::real_at(s, 1024), precise::real_at(n, 1024));
            let one = precise::real_at(1.0, 1024);
            let sin = &n_exact * &s_exact;
            let cosines = [&one - &s_exact * &s_exact, &one - &sin * &sin].map(|square| square.sqrt());
            let reference = &sin * &cosines[0] - &s_exact * &cosines[1];
            // |x ∂y/∂x|/|y| of both inputs: of y = sin(α − β), with dα = (n ds + s dn)/cos α and dβ = ds/cos β.
            let [near, far] = [&cosines[0], &cosines[1]].map(precise::to_f64);
            let y = precise::to_f64(&reference);
            let slope = (1.0 - y * y).sqrt();
            let condition = slope * ((n * s / far).abs() + (n * s / far - s / near).abs()) / y.abs();
            Extreme {
                input: format!("sin ½A = {s:e}, n = {n:.10}"),
                quantity: "sin ½δ",
                reference,
                textbook: ((n * s).asin() - s.asin()).sin(),
                ours: half_sine(s, n).unwrap_or(f64::NAN),
                condition,
                worst_of: 1,
            }
        })
        .into()
}

fn responses(setting: &Setting) -> Plot {
    let points = |c: usize| {
        let at = |nm: i32| [f64::from(nm), response().at(f64::from(nm) * 1e-9)[c] * 1e-9];
        (380..=760).step_by(5).map(at).collect::<Vec<_>>()
    };
    let chart = Chart::new(
        "",
        Axis::linear("wavelength λ", "nm").range(380.0, 760.0).tick(50.0),
        Axis::linear("response r_c", "1/nm"),
    )
    .line(Hue::P, "red", points(0))
    .line(Hue::Nth(2), "green", points(1))
    .line(Hue::S, "blue", points(2))
    .at_y(0.0, "")
    .at_x(setting.number("wavelength") * 1e9, "λ");
    Plot::of("What a channel sees", chart)
}

/// The lecture's prism, its screen seen from nearby.
fn near(pixels: [u32; 2]) -> Scene {
    let mut scene = small("prism", pixels[0]);
    let middle = [0.275, 0.05, -0.6];
    scene.camera = Camera {
        origin: [middle[0], 0.22, -0.16],
        target: middle,
        fov_y_deg: 16.0,
        width: pixels[0],
        height: pixels[1],
        ..scene.camera
    };
    scene
}

fn rainbow(_: &Setting) -> Plot {
    // It is the same in every setting.
    static DRAWN: OnceLock<Plot> = OnceLock::new();
    DRAWN.get_or_init(drawn).clone()
}

fn drawn() -> Plot {
    const WIDE: u32 = 144;
    const HIGH: u32 = 80;
    let whole = small("prism", 112);
    let view = shown("from the end of the table", &rendered(&whole, &Manner::default(), 128), 112);
    let scene = near([WIDE, HIGH]);
    let mut close = shown("its screen from nearby", &rendered(&scene, &Manner::default(), 512), WIDE as usize);
    let stage = Stage::<f64>::new(&scene, Default::default()).expect("a scene of the lecture");
    for nm in [430.0, 480.0, 530.0, 580.0, 630.0, 680.0] {
        let Some(x) = on_screen(nm * 1e-9) else { continue };
        let [a, b, c] = scene.camera.origin;
        for k in 0..8 {
            let to = Vector::of([x - a, 0.001 + 0.001 * f64::from(k) - b, -0.6 - c]);
            let [column, row] = stage.lens().place(to.normalised());
            if (0.0..f64::from(WIDE)).contains(&column) && (0.0..f64::from(HIGH)).contains(&row) {
                close.pixels[row as usize * WIDE as usize + column as usize] = [1.0; 3];
            }
        }
    }
    Plot::grid("A slit of light through a prism of dense flint", 2, vec![view.into(), close.into()])
}

fn spread(setting: &Setting) -> Plot {
    let mut chart = Chart::new(
        "",
        Axis::linear("wavelength λ", "nm").range(380.0, 760.0).tick(50.0),
        Axis::linear("least deviation δ, over that at 588 nm", "°"),
    );
    let bent =
        |name: &str, nm: f64| least_deviation(FRAC_PI_3, index(name, nm * 1e-9)).map_or(f64::NAN, f64::to_degrees);
    let points = |name: &str| {
        let at = |k: i32| 380.0 + 5.0 * f64::from(k);
        (0..=76).map(|k| [at(k), bent(name, at(k)) - bent(name, 587.56)]).collect::<Vec<_>>()
    };
    for (k, name) in ["water", "fused-silica", "bk7", "sf10", "sf11"].into_iter().enumerate() {
        chart = chart.line(Hue::Nth(k as u8), name, points(name));
    }
    chart = chart.dashed(Hue::Natural, setting.word("glass"), points(setting.word("glass")));
    Plot::of("How far glass spreads what it bends", chart)
}

/// The colour [1] of a black body of a temperature [K]: x, y, and red, green, blue at the luminance 1; and its luminance [cd m⁻²].
pub(super) fn glow(temperature: f64) -> ([f64; 2], [f64; 3], f64) {
    let xyz = tristimulus(|wavelength| blackbody(wavelength, temperature));
    let whole = xyz[1];
    (chromaticity(xyz), linear_srgb(xyz.map(|part| part / whole)), light::colour::EFFICACY * whole)
}
