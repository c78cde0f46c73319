//! C16: rough surfaces by brute force.

use super::models::{ALPHA, THETA, way};
use crate::figure::{Axis, Chart, Hue, Map, Plot, Ramp};
use crate::parameter::Setting;
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Heat, Measured, Quantity, Race, Step, check, choice, excess, exhibit, figure, lane,
    question, race, step,
};
use light::bsdf::Bsdf;
use light::bsdf::albedo::albedo;
use light::bsdf::fresnel::Conductor;
use light::bsdf::microfacet::{Beckmann, Distribution, Joint, Slopes};
use light::bsdf::rough_conductor::RoughConductor;
use light::bsdf::walk::{Walk, orders};
use light::number::Vector;
use light::relief::{Fate, Path, Relief};
use std::f64::consts::{FRAC_PI_2, PI};
use yardstick::directions::Points;
use yardstick::random::{Stream, stream, uniform};

pub(super) const EXHIBIT: Exhibit = exhibit(
    "relief",
    &[ALPHA, THETA],
    &[
        figure(
            "heights",
            "A corner of a rough surface as it is simulated: heights drawn by chance, with Gaussian slopes.",
            heights,
        ),
        figure(
            "lobes",
            "Where light goes that comes in at θ_i, over the angle in the plane of incidence: the surface itself, its facets' \
             model of one bounce, and the walk with all of them.",
            lobes,
        ),
        figure(
            "single",
            "The share that leaves after one bounce: the surface itself keeps a little above Smith's masking, and one with \
             the slopes of GGX far from it.",
            single,
        ),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Rough surfaces as they are",
    "Light traced among real heights goes where facets say that it goes, nearly: heights that stand together hide less.",
)
.rows(&["C16"])
.questions(&[question(
    "correlated",
    "Smith's masking takes a facet's height and slope, and its neighbours' heights, for independent. On a real surface \
     neighbours rise together. Does more light or less leave after one bounce?",
    Answer::Choice {
        options: &[
            choice("less", "A neighbour that rises with the facet stands in the way less often, not more."),
            choice("as much", "Nearly; but the difference is there, and always has the same sign."),
            choice("a little more", ""),
        ],
        right: |_| {
            let share = one_bounce(&rough(0.8), PI / 3.0, 20_000, &mut stream(1, "brdf/relief/question"));
            let smith = smith(0.8, PI / 3.0);
            if share < smith - 0.005 {
                0
            } else if share < smith + 0.005 {
                1
            } else {
                2
            }
        },
        slip: |_| 0,
    },
    "A facet on a slope that rises has neighbours that have risen too: it looks over them.",
)])
.readout(|setting| {
    let (alpha, theta) = (setting.number("alpha"), setting.number("theta").min(STEEPEST));
    let share = one_bounce(&rough(alpha), theta, 20_000, &mut stream(0, "brdf/relief/readout"));
    let quantity = |key, symbol, says, value| Quantity { key, symbol, says, value, unit: "1" };
    vec![
        quantity("relief", "P_1", "share of the light that leaves after one bounce, traced", share),
        quantity("smith", "E", "the same by Smith's masking, height-correlated", smith(alpha, theta)),
    ]
})
.checks(&[&SLOPES, &SINGLE, &ABOVE, &WALKED])
.races(&[BOUNCES]);

/// Cells of a side, and over how many heights go together.
const SIDE: usize = 512;
const TOGETHER: f64 = 4.0;
/// The flattest view [rad] that is traced: below the horizon there is nothing.
const STEEPEST: f64 = 1.55;

/// A surface of Gaussian slopes.
fn rough(alpha: f64) -> Relief {
    let mut dice = stream(0, "brdf/relief");
    Relief::gaussian(SIDE, TOGETHER, alpha, || uniform(&mut dice, 0.0, 1.0)).expect("within its range")
}

/// Rays from a direction over all of it, to the end.
fn rays(relief: &Relief, theta: f64, count: usize, dice: &mut Stream) -> Vec<Path> {
    let wi = way(theta, 0.7);
    let points = Points::Stratified.draw(count, dice);
    relief.trace_all([wi.x, wi.y, wi.z], &points, |_| 1.0, 200)
}

/// The share that leaves after one bounce.
fn one_bounce(relief: &Relief, theta: f64, count: usize, dice: &mut Stream) -> f64 {
    let left = rays(relief, theta, count, dice);
    left.iter().filter(|path| path.fate == Fate::Left && path.bounces == 1).count() as f64 / count as f64
}

/// What facets return at one bounce by Smith's masking.
fn smith(alpha: f64, theta: f64) -> f64 {
    albedo(Slopes::Beckmann, alpha, theta.cos())
}

const SLOPES: Check<fn(f64, f64) -> f64> =
    check("slopes", "the facets of the relief have the slopes of Beckmann's distribution")
        .against("1 − e^(−s²/α²), against the slopes of half a million triangles (Kolmogorov's distance)")
        .within(5e-3, "1", "some 128² patches that know nothing of each other: 0.6/128 of distance, rarely more")
        .of(distances, |s, alpha| -f64::exp_m1(-(s / alpha).powi(2)))
        .slip("the slopes of GGX, of the same α", |s, alpha| s * s / (alpha * alpha + s * s));

fn distances(_: &mut Bench, cdf: fn(f64, f64) -> f64) -> Measured {
    Measured::worst([0.1, 0.5].map(|alpha| (rough(alpha).distance(|s| cdf(s, alpha)), format!("α = {alpha}"))))
}

/// Roughnesses and angles at which light is traced.
fn views() -> impl Iterator<Item = (f64, f64)> {
    [0.3, 0.5, 0.8].into_iter().flat_map(|alpha| [0.0, PI / 3.0, 1.48].map(|theta| (alpha, theta)))
}

/// Rays of one view.
const RAYS: usize = 20_000;

const SINGLE: Check<fn(f64, f64) -> f64> = check(
    "one_bounce",
    "what leaves a relief after one bounce is what facets return at one bounce, nearly",
)
.against("Smith's height-correlated masking, by quadrature over Beckmann's slopes, against rays traced among heights")
.within(0.025, "1", "heights that stand together hide less than independent ones: up to 0.020 was found at α = 0.8")
.of(
    |bench: &mut Bench, program: fn(f64, f64) -> f64| {
        Measured::worst(views().map(|(alpha, theta)| {
            let traced = one_bounce(&rough(alpha), theta, RAYS, &mut bench.stream);
            (traced - program(alpha, theta), format!("α = {alpha}, θ = {theta:.2}: traced {traced:.4}"))
        }))
    },
    smith as fn(f64, f64) -> f64,
)
.slip("no facet stands in another's light", |_, _| 1.0);

const ABOVE: Check<fn(f64, f64) -> f64> = check("above", "and never less than that: the relief is on the bright side")
    .against("the same; by how many standard errors of the tracing it falls below")
    .within(3.0, "σ", "three standard errors: once in 740 by chance, for each of nine views")
    .of(
        |bench: &mut Bench, program: fn(f64, f64) -> f64| {
            Measured::worst(views().map(|(alpha, theta)| {
                let traced = one_bounce(&rough(alpha), theta, RAYS, &mut bench.stream);
                let sigma = (traced * (1.0 - traced) / RAYS as f64).sqrt().max(1e-5);
                let below = excess((program(alpha, theta) - traced) / sigma);
                (below, format!("α = {alpha}, θ = {theta:.2}: traced {traced:.4}"))
            }))
        },
        smith as fn(f64, f64) -> f64,
    )
    .slip("no facet stands in another's light", |_, _| 1.0);

/// A walk over white facets of Gaussian slopes.
fn walk(alpha: f64) -> Walk<f64, Beckmann<f64>, Conductor<f64>> {
    Walk::new(Beckmann::new([alpha; 2]), Conductor::perfect())
}

/// The share of walks that meet one facet.
fn walked(alpha: f64, theta: f64, count: u64, dice: &mut Stream) -> f64 {
    let (walk, wo) = (walk(alpha), way(theta, 0.7));
    let mut throw = || uniform(dice, 0.0, 1.0);
    let ones = (0..count).filter(|_| walk.bounces(wo, [(); 3].map(|()| throw())) == 1.0).count();
    ones as f64 / count as f64
}

const WALKED: Check<fn(f64, f64) -> f64> = check(
    "walked",
    "a walk over facets of independent heights leaves after one bounce exactly as often as Smith's masking says",
)
.against("the quadrature, by how many standard errors of 10⁵ walks it is off")
.within(4.0, "σ", "four standard errors: once in 16 000 by chance, for each of nine views")
.of(
    |_: &mut Bench, program: fn(f64, f64) -> f64| {
        Measured::worst(views().map(|(alpha, theta)| {
            let count = 100_000;
            let due = program(alpha, theta);
            let found = orders(Slopes::Beckmann, alpha, theta.cos(), count)[0];
            let sigma = (found * (1.0 - found) / count as f64).sqrt().max(1e-5);
            ((found - due) / sigma, format!("α = {alpha}, θ = {theta:.2}: walked {found:.4}"))
        }))
    },
    smith as fn(f64, f64) -> f64,
)
.slip("each side's masking taken by itself", separable);

/// The same with separable masking.
fn separable(alpha: f64, theta: f64) -> f64 {
    let facets = Beckmann::new([alpha; 2]);
    let model = RoughConductor { facets, joint: Joint::Separable, metal: Conductor::perfect() };
    let wo = way(theta, 0.7);
    let points = Points::Sobol.draw(1 << 14, &mut stream(0, "brdf/relief/separable"));
    let weight = |[u, v]: [f64; 2]| model.sample(wo, [u, v, 0.5]).weight[0];
    points.iter().map(|at| weight(*at)).sum::<f64>() / points.len() as f64
}

const RACED: (f64, f64) = (0.5, PI / 3.0);

const BOUNCES: Race = race(
    "bounces",
    "the walk converges on Smith's energy as chance allows, without end; the relief stops at what its heights share",
)
.work("rays or walks")
.error(
    "error of the share of one bounce",
    "rms over 16 seeds of the walk and 4 of the rays of |P_1 − E| at α = 0.5 and 60°, E by quadrature",
)
.lanes(&[
    lane("walk", "the walk", &[256, 1024, 4096, 16384], |bench, work| {
        let seed = uniform(&mut bench.stream, 0.0, 1.0);
        Heat {
            run: Box::new(move || {
                let mut dice = stream(seed.to_bits(), "brdf/relief/bounces");
                vec![walked(RACED.0, RACED.1, work, &mut dice)]
            }),
            error: Box::new(|found| (found[0] - smith(RACED.0, RACED.1)).abs()),
        }
    })
    .repeated(16)
    .order(0.5, 0.12),
    lane("relief", "rays among heights", &[256, 1024, 4096, 16384], |bench, work| {
        let relief = rough(RACED.0);
        let seed = uniform(&mut bench.stream, 0.0, 1.0);
        Heat {
            run: Box::new(move || {
                let mut dice = stream(seed.to_bits(), "brdf/relief/bounces");
                vec![one_bounce(&relief, RACED.1, work as usize, &mut dice)]
            }),
            error: Box::new(|found| (found[0] - smith(RACED.0, RACED.1)).abs()),
        }
    })
    .repeated(4)
    .breaks(2e-3, "neighbours that rise together: a floor of some 0.007 that no number of rays passes"),
]);

fn heights(setting: &Setting) -> Plot {
    let relief = rough(setting.number("alpha"));
    const SHOWN: usize = 96;
    let values: Vec<f64> = (0..SHOWN * SHOWN).map(|at| relief.heights()[at / SHOWN * SIDE + at % SHOWN]).collect();
    let most = values.iter().fold(0.0_f64, |most, z| most.max(z.abs()));
    let axis = |name: &str| Axis::linear(name, "cells").range(0.0, SHOWN as f64).tick(24.0);
    let map = Map {
        title: String::new(),
        x: axis("x"),
        y: axis("y"),
        colour: Axis::linear("height z", "cells").range(-most, most),
        ramp: Ramp::Diverging,
        columns: SHOWN,
        values,
        marks: Vec::new(),
    };
    Plot::of(format!("A relief of α = {}, heights together over {TOGETHER} cells", setting.number("alpha")), map)
}

/// Bins of the angle in the plane of incidence.
const BINS: usize = 36;

/// The density of the angle in the plane of incidence [1/rad], of weighted directions.
fn angles(directions: impl Iterator<Item = (Vector<f64>, f64)>, count: f64) -> Vec<[f64; 2]> {
    let width = PI / BINS as f64;
    let mut bins = [0.0; BINS];
    for (w, weight) in directions {
        let angle = w.x.atan2(w.z);
        let at = ((angle + FRAC_PI_2) / width) as usize;
        bins[at.min(BINS - 1)] += weight / count / width;
    }
    let steps = |(at, value): (usize, &f64)| {
        let edge = |at: usize| (at as f64 * width - FRAC_PI_2).to_degrees();
        [[edge(at), *value], [edge(at + 1), *value]]
    };
    bins.iter().enumerate().flat_map(steps).collect()
}

fn lobes(setting: &Setting) -> Plot {
    let (alpha, theta) = (setting.number("alpha"), setting.number("theta").min(STEEPEST));
    let count = 30_000;
    let wi = way(theta, PI);
    let mut dice = stream(0, "brdf/relief/lobes");
    let points = Points::Stratified.draw(count, &mut dice);
    let traced = rough(alpha).trace_all([wi.x, wi.y, wi.z], &points, |_| 1.0, 200);
    let traced = traced.into_iter().filter(|path| path.fate == Fate::Left);
    let traced = angles(traced.map(|path| (Vector::of(path.direction), 1.0)), count as f64);
    let mut throw = || [(); 3].map(|()| uniform(&mut dice, 0.0, 1.0));
    let walk = walk(alpha);
    let walked =
        angles((0..count).map(|_| walk.sample(wi, throw())).map(|drawn| (drawn.wi, drawn.weight[0])), count as f64);
    let model =
        RoughConductor { facets: Beckmann::new([alpha; 2]), joint: Joint::Correlated, metal: Conductor::perfect() };
    let modelled =
        angles((0..count).map(|_| model.sample(wi, throw())).map(|drawn| (drawn.wi, drawn.weight[0])), count as f64);
    let chart = Chart::new(
        "",
        Axis::linear("angle of what leaves, in the plane of incidence", "°").range(-90.0, 90.0).tick(30.0),
        Axis::linear("share of the light in an angle", "1/rad"),
    )
    .line(Hue::Reference, "traced among heights", traced)
    .line(Hue::Ours, "the walk", walked)
    .dashed(Hue::Textbook, "facets, one bounce", modelled)
    .at_x(theta.to_degrees(), "mirror");
    Plot::of(format!("Light at {:.0}° on a relief of α = {alpha}", theta.to_degrees()), chart)
}

fn single(setting: &Setting) -> Plot {
    let alpha = setting.number("alpha");
    let angles = [0.0_f64, 15.0, 30.0, 45.0, 60.0, 70.0, 78.0, 85.0];
    let smiths = |slopes: Slopes| -> Vec<[f64; 2]> {
        (0..=176).map(|at| f64::from(at) / 2.0).map(|x| [x, albedo(slopes, alpha, x.to_radians().cos())]).collect()
    };
    let mut dice = stream(0, "brdf/relief/single");
    let traced = |relief: &Relief, dice: &mut Stream| -> Vec<[f64; 2]> {
        angles.map(|x| [x, one_bounce(relief, x.to_radians(), 4_000, dice)]).to_vec()
    };
    let gaussian = traced(&rough(alpha), &mut dice);
    let mut throw = stream(0, "brdf/relief/ggx");
    let tailed = Relief::ggx(SIDE, [TOGETHER, 4.0 * TOGETHER], alpha, || uniform(&mut throw, 0.0, 1.0))
        .expect("within its range");
    let tailed = traced(&tailed, &mut dice);
    let points = |hue, label: &str, points| crate::figure::Mark::Points {
        label: label.into(),
        hue,
        shape: crate::figure::Shape::Disc,
        joined: false,
        points,
    };
    let chart = Chart::new(
        "",
        Axis::linear("angle of incidence θ_i", "°").range(0.0, 90.0).tick(15.0),
        Axis::linear("share that leaves after one bounce", "").range(0.0, 1.05),
    )
    .line(Hue::Nth(0), "Smith, Beckmann's slopes", smiths(Slopes::Beckmann))
    .with(points(Hue::Nth(0), "relief of Gaussian slopes", gaussian))
    .line(Hue::Nth(1), "Smith, slopes of GGX", smiths(Slopes::Ggx))
    .with(points(Hue::Nth(1), "relief with slopes of GGX", tailed));
    Plot::of(format!("One bounce, α = {alpha}"), chart)
}
