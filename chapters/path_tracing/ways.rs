//! C21: where to look for light.

use super::one_ray::judged;
use super::scenes::{colours, converged, halves, lit, rendered, runs, small, view};
use crate::diagram::{Behind, Diagram, Part};
use crate::figure::{Hue, Picture, Plot};
use crate::parameter::{Kind, Parameter, Setting};
use crate::vocabulary::{
    Answer, Bench, Check, Entrant, Exhibit, Extreme, Heat, Measured, Race, Step, check, choice, exhibit, figure, lane,
    question, race, step, stress,
};
use light::bsdf::{Rgb, rgb};
use light::sampling::{Choice, warp};
use light::transport::estimate::relative_mse;
use light::transport::film::Halves;
use light::transport::simple::{INTEGRATORS, Integrator, lamps, surface};
use light::transport::{Manner, Method, Renderer};
use std::f64::consts::PI;
use yardstick::precise;
use yardstick::random::uniform;

const DRAWN: Parameter =
    Parameter::new("rays", "N", "how many new rays are drawn", Kind::Count { min: 1, max: 256 }).default("24");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "ways",
    &[DRAWN],
    &[
        figure(
            "rays",
            "New rays from one point: evenly, as the cosine has it, and straight to the lamp. Only those in colour find it.",
            rays,
        ),
        figure("pictures", "The same box by the four ways, sixteen paths a pixel each.", pictures),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Where to look",
    "Evenly, by the surface, straight to the lamps, or both: one mean, and errors that differ by orders of magnitude.",
)
.rows(&["C21"])
.questions(&[question(
    "blind",
    "New rays drawn by the cosine meet the ceiling's lamp only by chance. How many times as many paths do they need for the picture that rays to the lamp make?",
    Answer::Choice {
        options: &[
            choice("about as many: both are right on average", "The mean is the same; what it costs to be near it is not."),
            choice("some five times", "The lamp covers a few hundredths of what a point of the box sees: most paths bring nothing."),
            choice("about a hundred times, or more", ""),
        ],
        right: |_| {
            let error = |integrator: usize| squared_error(&INTEGRATORS[integrator], 16);
            match error(1) / error(3) {
                ratio if ratio < 2.0 => 0,
                ratio if ratio < 30.0 => 1,
                _ => 2,
            }
        },
        slip: |_| 0,
    },
    "The mean square error is a hundred times as large, and it falls as 1/N.",
)])
.checks(&[&SAME])
.stress(&[stress("small_lamp", "the directions to a lamp that is a speck, or fills the sky", specks)
    .textbook("1 − cos α of its cone, with cos α = √(1 − sin² α)")
    .against("the same in arbitrary precision")])
.races(&[WAYS]);

const SAME: Check<&'static [Integrator]> =
    check("same", "all ways of looking find on average what the lamp sends")
        .against("ρE/π by Lambert's closed form, against 64 pictures of one pixel by each of the four, and by many lanes (t-tests)")
        .significant(1e-3)
        .of(
            |_: &mut Bench, ways: &'static [Integrator]| {
                let (scene, exact) = lit([0.9, 0.2], 1.0, 0.005, 1);
                let methods = ways.iter().map(|way| (way.name, Method::Simple(way)));
                let methods = methods.chain([("fast", Method::default())]);
                let found: Vec<Measured> = methods
                    .map(|(name, method)| {
                        let of = judged(&runs(64, &scene, Manner { method, ..Manner::default() }, 64), exact);
                        Measured { at: format!("{name}: {}", of.at), ..of }
                    })
                    .collect();
                smallest(found)
            },
            INTEGRATORS,
        )
        .slip("a lamp that a new ray meets counted again, beside the ray that was sent to it", &[TWICE]);

fn specks(_: &Setting) -> Vec<Extreme> {
    let sines = [1e-150, 1e-12, 1e-9, 1e-6, 1e-3, 0.5, 1.0 - 1e-12];
    sines
        .map(|sin: f64| {
            let square = sin * sin;
            let (one, exact) = (precise::real_at(1.0, 2048), precise::real_at(square, 2048));
            let root = (&one - &exact).sqrt();
            let cos = precise::to_f64(&root);
            Extreme {
                input: format!("sin α = {sin:e}"),
                quantity: "1 − cos α",
                reference: &one - &root,
                textbook: 1.0 - (1.0 - square).sqrt(),
                ours: warp::one_minus_cos(square),
                // By sin²: (1 + cos)/(2 cos).
                condition: (1.0 + cos) / (2.0 * cos),
                worst_of: 1,
            }
        })
        .into()
}

/// The smallest of independent p-values as one of a family.
pub(crate) fn smallest(found: Vec<Measured>) -> Measured {
    let count = found.len();
    let worst = found.into_iter().min_by(|one, other| one.value.total_cmp(&other.value));
    let Measured { value, at, .. } = worst.unwrap_or_else(|| Measured::new(f64::NAN, "no case", 0));
    Measured::new(yardstick::statistics::family(value, count), at, count)
}

/// Both ways, each in full.
const TWICE: Integrator = Integrator {
    name: "twice",
    about: "rays to lamps and lamps met by chance, not weighed",
    fits: |_| true,
    radiance: |stage, ray, numbers, depth| {
        let by_lamps = lamps::radiance(stage, ray, numbers, depth);
        let by_chance = surface::radiance(stage, ray, numbers, depth);
        rgb(|c| by_lamps[c] + by_chance[c])
    },
};

/// Pixels along a side of the raced box.
const SIDE: u32 = 24;
/// Pairs of samples of what it is held against.
const REFERENCE: u32 = 2048;

/// The relative mean square error [1] of a box of a few pixels by sixteen paths each.
fn squared_error(integrator: &'static Integrator, side: u32) -> f64 {
    let manner = Manner { method: Method::Simple(integrator), ..Manner::default() };
    let found = colours(&rendered(&view("cornell", side), &manner, 8));
    relative_mse(&found, &converged("cornell", side, 512))
}

/// A run of a race: a picture of a scene of the lecture by so many paths a pixel. Its error is the root of the relative mean
/// square error against one that is all but converged.
pub(super) fn heat(bench: &mut Bench, name: &'static str, manner: Manner, work: u64) -> Heat {
    let seed = uniform(&mut bench.stream, 0.0, 1.0).to_bits();
    let (scene, pairs) = (view(name, SIDE), (work / 2).max(1) as u32);
    let renderer = Renderer::new(&scene, &Manner { seed, ..manner }, pairs).expect("a scene of the lecture");
    let exact = converged(name, SIDE, REFERENCE);
    Heat {
        run: Box::new(move || {
            let of = |pixel: &Halves| pixel.iter().flatten().map(|x| f64::from(*x)).collect::<Vec<_>>();
            halves(&renderer, &scene, pairs).iter().flat_map(of).collect()
        }),
        error: Box::new(move |found| {
            let of = |pixel: &[f64]| -> Rgb<f64> { std::array::from_fn(|c| 0.5 * (pixel[c] + pixel[3 + c])) };
            relative_mse(&found.chunks_exact(6).map(of).collect::<Vec<_>>(), &exact).sqrt()
        }),
    }
}

/// How the error of a race of pictures is taken.
pub(super) const ERROR: (&str, &str) = (
    "relative error of the picture",
    "root of the mean over 24 × 24 pixels and channels of (x − ref)²/(ref² + 0.01), rms over seeds; the reference is the fast \
     integrator's, 4096 paths a pixel by a seed of its own",
);

/// Of independent paths: what differs is where they look.
fn looked(bench: &mut Bench, method: Method, work: u64) -> Heat {
    heat(bench, "cornell", Manner { method, choice: Choice::Independent, ..Manner::default() }, work)
}

const fn way(id: &'static str, label: &'static str, prepare: fn(&mut Bench, u64) -> Heat) -> Entrant {
    lane(id, label, &[4, 16, 64], prepare).repeated(4)
}

const WAYS: Race = race("ways", "the box by four ways and by many lanes: all fall as 1/√N, from where they start")
    .work("paths a pixel, independent")
    .error(ERROR.0, ERROR.1)
    .lanes(&[
        // Few paths find the lamp and bring much: their mean square is still uncertain at a few paths.
        way("hemisphere", "evenly", |bench, work| looked(bench, Method::Simple(&INTEGRATORS[0]), work))
            .order(0.5, 0.15),
        way("surface", "by the cosine", |bench, work| looked(bench, Method::Simple(&INTEGRATORS[1]), work))
            .order(0.5, 0.15),
        way("lamps", "to the lamps", |bench, work| looked(bench, Method::Simple(&INTEGRATORS[2]), work))
            .order(0.5, 0.1),
        way("both", "both, weighed", |bench, work| looked(bench, Method::Simple(&INTEGRATORS[3]), work))
            .order(0.5, 0.1),
        way("fast", "both, many lanes", |bench, work| looked(bench, Method::default(), work)).order(0.5, 0.1),
    ]);

fn rays(setting: &Setting) -> Plot {
    let n = setting.number("rays") as usize;
    // Each in the middle of its cell.
    let numbers: Vec<f64> = (0..n).map(|k| (k as f64 + 0.5) / n as f64).collect();
    // In the plane of the drawing: a lamp, seen from the origin between two angles.
    let (lamp, height, reach) = ([0.6, 1.3], 2.2, 2.2);
    let found = |[x, y]: [f64; 2]| y > 0.0 && (lamp[0]..=lamp[1]).contains(&(x / y * height));
    let spread = |sin: f64| [sin, (1.0 - sin * sin).max(0.0).sqrt()];
    let even = numbers.iter().map(|u| PI * (u - 0.5)).map(|t| [t.sin(), t.cos()]).collect::<Vec<_>>();
    let cosine = numbers.iter().map(|u| spread(2.0 * u - 1.0)).collect();
    let towards = numbers.iter().map(|u| [lamp[0] + (lamp[1] - lamp[0]) * u, height]).collect();
    let panel = |title: &str, ways: Vec<[f64; 2]>, ends_there: bool| {
        let drawn = ways.into_iter().map(|way| {
            let is_found = found(way);
            let [x, y] = way;
            // Up to the ceiling, or the rim of what is shown.
            let scale =
                if ends_there { 1.0 } else { (height / y.max(1e-9)).min(if is_found { f64::MAX } else { reach }) };
            Part::line([0.0, 0.0], [scale * x, scale * y]).hue(if is_found { Hue::Ours } else { Hue::Reference })
        });
        Diagram::new(title, [-2.3, -0.5], [2.3, 2.7])
            .with(Part::surface([-2.3, 0.0], [2.3, 0.0], Behind::Hatched))
            .with(Part::surface([lamp[0], height], [lamp[1], height], Behind::Nothing).hue(Hue::P).label("lamp"))
            .with_all(drawn)
            .into()
    };
    let panels =
        vec![panel("evenly", even, false), panel("by the cosine", cosine, false), panel("to the lamp", towards, true)];
    Plot::grid(format!("{n} new rays from a point of the floor"), 3, panels)
}

fn pictures(_: &Setting) -> Plot {
    let panel = |way: &'static Integrator| {
        let manner = Manner { method: Method::Simple(way), ..Manner::default() };
        shown(way.name, &rendered(&small("cornell", 64), &manner, 8), 64).into()
    };
    Plot::grid("The box by 16 paths a pixel", 2, INTEGRATORS.iter().map(panel).collect())
}

/// A picture of the means of pixels.
pub(super) fn shown(title: &str, halves: &[Halves], width: usize) -> Picture {
    Picture::new(title, width, colours(halves).into_iter().map(|colour| colour.map(|x| x as f32)).collect())
}
