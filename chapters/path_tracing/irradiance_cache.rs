//! C25: what a few places know of the light on all.

use super::scenes::{closed, colours, greens, halves, rendered, small, view};
use super::symbols::{R, THETA};
use super::ways::shown;
use crate::diagram::{Diagram, Part};
use crate::figure::{self as drawn, Axis, Chart, Hue, Mark, Plot};
use crate::parameter::{Kind, Parameter, Setting};
use crate::vocabulary::{
    Answer, Bench, Check, Entrant, Exhibit, Heat, Measured, Misled, Quantity, Race, Step, check, derivation, exhibit,
    figure, lane, question, race, step,
};
use equation::Expr;
use equation::derivation::Chain;
use equation::expr::{cos, integral_between, pi, sin};
use light::geometry::Structure;
use light::number::{Frame, Vector};
use light::radiometry::polygon;
use light::sampling::Choice;
use light::scene::Scene;
use light::transport::estimate::relative_mse_less;
use light::transport::film::Halves;
use light::transport::irradiance_cache::Caches;
use light::transport::irradiance_cache::hemisphere::{Cells, Fallen, Seen};
use light::transport::irradiance_cache::record::{Cache, Record};
use light::transport::simple::INTEGRATORS;
use light::transport::{Manner, Method, Renderer, Stage};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::sync::{Arc, OnceLock};
use yardstick::order;
use yardstick::random::uniform;

const ALLOWED: Parameter =
    Parameter::new("allowed", "a", "doubt that a record is allowed where it is believed", Kind::number(0.1, 1.5, "1"))
        .default("1");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "cached",
    &[ALLOWED],
    &[
        figure(
            "told",
            "Irradiance along a line of the floor under a bright square, as a few records tell it: by what they know of their own place alone, and by how it changes there.",
            told,
        ),
        figure(
            "records",
            "The box by sixteen samples a pixel, and the records of its last batch, in circles half as wide as each is believed. They crowd where something is near.",
            records,
        ),
        figure(
            "pictures",
            "What comes by way of matt places alone, four samples a pixel: by paths, and by records of which all pixels make use.",
            pictures,
        ),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Light that a few places know",
    "Light by way of matt walls changes slowly: a few hundred places know it for all, and with its gradient, to second order.",
)
.rows(&["C25"])
.derivations(&[
    derivation("split", "in the middle of a sphere of which one half is bright, light changes by 4/πR of itself", || {
        split(4 / (pi() * R))
    })
    .slip("as if all of the edge were overhead", || split(2 / R)),
])
.questions(&[question(
    "half",
    "Records keep their light and its gradient, and you allow them half of the doubt: they stand half as far apart. By which factor does the error of what is interpolated fall?",
    Answer::Number {
        unit: "1",
        tolerance: 0.15,
        right: |_| interpolated(0.4, |fallen| fallen) / interpolated(0.2, |fallen| fallen),
        slips: &[
            Misled { value: |_| 2.0, reply: "So it would if a record told its neighbours nothing but its own light. The gradient takes away what is linear in the distance." },
            Misled { value: |_| 8.0, reply: "What is left is the curvature: it goes as the square of the distance." },
        ],
    },
    "By four. And four times as many records have to be made.",
)])
.readout(|setting| {
    let allowed = setting.number("allowed");
    let quantity = |key, symbol, says, value| Quantity { key, symbol, says, value, unit: "1" };
    vec![
        quantity("reach", "d/R", "how far a record is believed, over the distance of what is around", PI / 4.0 * allowed),
        quantity("plain", "ΔE/E", "error of what records say, by their light alone", interpolated(allowed, plain)),
        quantity("graded", "Δ_gE/E", "the same with their gradients", interpolated(allowed, |fallen| fallen)),
    ]
})
.checks(&[&GRADIENT, &DOUBT, &ORDER, &CLOSED])
.races(&[INDIRECT]);

/// The edge of the bright half is half a circle about the place, at the distance R: as the place is shifted by Δx, it sweeps
/// cos θ dθ Δx/R of what was bright before, which is π/2.
fn split(last: Expr) -> Chain {
    Chain::new(integral_between(cos(THETA) / R, THETA, -pi() / 2, pi() / 2) / (pi() / 2))
        .primitive(sin(THETA) / R, THETA)
        .then(last, ["over E = πL/2"])
}

/// A bright square of 1 W/(m² sr), a metre above the floor's middle.
const SQUARE: [[f64; 3]; 4] = [[-0.5, -0.5, 1.0], [-0.5, 0.5, 1.0], [0.5, 0.5, 1.0], [0.5, -0.5, 1.0]];
const UP: [f64; 3] = [0.0, 0.0, 1.0];

/// What it sends to a place [W m⁻²], by Lambert's closed form.
fn exact(place: [f64; 3], normal: [f64; 3]) -> f64 {
    let seen = SQUARE.map(|corner| std::array::from_fn(|k| corner[k] - place[k]));
    polygon::irradiance(&seen, normal).unwrap_or(f64::NAN)
}

/// The slope of a function at 0, to the sixth power of a step of 1/50.
fn slope(f: impl Fn(f64) -> f64) -> f64 {
    let step = 0.02;
    let across = |k: f64| f(k * step) - f(-k * step);
    (45.0 * across(1.0) - 9.0 * across(2.0) + across(3.0)) / (60.0 * step)
}

type Gathers = fn(&Cells, &[Seen]) -> Fallen;

const GRADIENT: Check<Gathers> = check(
    "gradient",
    "one hemisphere of rays tells the light of its place, and how it changes where that is shifted or turned",
)
.against(
    "Lambert's closed form of a bright square and its slopes by central differences of sixth order, at three places",
)
.within(0.02, "1", "of 40 000 cells those at the square's rim, one in a hundred, are bright or dark as a whole")
.of(
    |_: &mut Bench, gathers: Gathers| {
        let places = [([0.3, 0.1, 0.0], UP), ([0.9, -0.7, 0.0], UP), ([0.2, 0.4, 0.5], [0.36, 0.48, 0.8])];
        Measured::worst(places.into_iter().flat_map(|(place, normal)| missed(place, normal, gathers)))
    },
    Cells::fallen as Gathers,
)
.slip("the edge between two cells taken for that of what is further away", |cells, seen| {
    let far = seen.iter().map(|ray| Seen { distance: if ray.distance < 1e9 { 1e9 } else { ray.distance }, ..*ray });
    Fallen { shifted: cells.fallen(&far.collect::<Vec<_>>()).shifted, ..cells.fallen(seen) }
});

/// How far off a hemisphere of rays is, over the irradiance.
fn missed(place: [f64; 3], normal: [f64; 3], gathers: Gathers) -> Vec<(f64, String)> {
    let (cells, frame) = (Cells::about(40_000.0), Frame::about(Vector::of(normal)));
    let seen = |cell| {
        let way = frame.outward(cells.direction(cell, [0.5; 2]));
        let t = (1.0 - place[2]) / way.z;
        let is_bright = t > 0.0 && [place[0] + t * way.x, place[1] + t * way.y].iter().all(|x| x.abs() <= 0.5);
        let distance = if is_bright { t } else { f64::INFINITY };
        Seen { radiance: [f64::from(u8::from(is_bright)); 3], distance }
    };
    let fallen = gathers(&cells, &(0..cells.count()).map(seen).collect::<Vec<_>>());
    let whole = exact(place, normal);
    let mut found = vec![(fallen.irradiance[1] / whole - 1.0, format!("irradiance at {place:?}"))];
    let (shifted, turned) = (frame.outward(fallen.shifted[1]), frame.outward(fallen.turned[1]));
    for (name, axis) in [("x", frame.x), ("y", frame.y)] {
        let moved = |by: f64| (Vector::of(place) + axis.scaled(by)).lane(0);
        let tilted = |by: f64| (frame.z.scaled(by.cos()) + axis.scaled(by.sin())).lane(0);
        let (by_shift, by_turn) = (slope(|by| exact(moved(by), normal)), slope(|by| exact(place, tilted(by))));
        found.push(((shifted.dot(axis) - by_shift) / whole, format!("shifted along {name} at {place:?}")));
        found.push(((turned.dot(axis) - by_turn) / whole, format!("turned towards {name} at {place:?}")));
    }
    found
}

type Doubts = fn(&Record, Vector<f64>, Vector<f64>) -> f64;

const DOUBT: Check<Doubts> = check(
    "doubt",
    "within a sphere of which one half is bright, light changes by no more than its record's doubt",
)
.against(
    "the change itself, by 40 000 rays from each of 44 places in and about the middle, shifted or turned, over the doubt",
)
.within(1.02, "1", "all of the doubt, and two per cent for cells at the edge")
.of(
    |_: &mut Bench, doubt: Doubts| {
        let fallen = Fallen {
            irradiance: [FRAC_PI_2; 3],
            turned: [Vector::of([0.0; 3]); 3],
            shifted: [Vector::of([0.0; 3]); 3],
            distance: 1.0,
        };
        let record = Record::new(Vector::of([0.0; 3]), &Frame::about(Vector::of(UP)), 1, &fallen, [1.0; 2]);
        // Where neither is changed there is no doubt to hold a change against.
            let cases = (0..48).filter(|k| k / 4 % 4 > 0 || k / 16 != 1).map(|k| {
            let [way, shift, turn] = [k % 4, k / 4 % 4, k / 16].map(f64::from);
            let (sin, cos) = (TAU * way / 4.0).sin_cos();
            let place = [0.1 * shift * cos, 0.1 * shift * sin, 0.0];
            let tilt = 0.15 * (turn - 1.0);
            let normal = [tilt.sin(), 0.0, tilt.cos()];
            let change = (within_split(place, normal) / FRAC_PI_2 - 1.0).abs();
            let doubt = doubt(&record, Vector::of(place), Vector::of(normal));
            (change / doubt.max(1e-9), format!("{place:?}, turned by {tilt}"))
        });
        Measured::worst(cases)
    },
    Record::doubt as Doubts,
)
.slip("as if nothing changed where a surface turns", |record, place, _| record.doubt(place, record.normal));

/// Irradiance [W m⁻²] within a sphere of radius 1 m whose half x > 0 shines.
fn within_split(place: [f64; 3], normal: [f64; 3]) -> f64 {
    // Cut along the edge as it is seen from the middle.
    let (cells, frame) = (Cells { rings: 112, sectors: 352 }, Frame::about(Vector::of(normal)));
    let from = Vector::of(place);
    let bright = |cell: &u32| {
        let way = frame.outward(cells.direction(*cell, [0.5; 2]));
        let half = from.dot(way);
        let t = (half * half + 1.0 - from.dot(from)).sqrt() - half;
        from.x + t * way.x > 0.0
    };
    PI * (0..cells.count()).filter(bright).count() as f64 / f64::from(cells.count())
}

type Keeps = fn(Fallen) -> Fallen;

/// A record without its gradients.
fn plain(fallen: Fallen) -> Fallen {
    Fallen { shifted: [Vector::of([0.0; 3]); 3], ..fallen }
}

/// Records of the floor up to so many metres from the middle, half as far from each other as they may doubt. Along x they are
/// not even: what a record gets wrong on one side would be made up for by the next on the other.
fn floor(allowed: f64, half: f64, keeps: Keeps) -> Cache {
    let mut cache = Cache::new(allowed);
    let up = Frame::about(Vector::of(UP));
    let spacing = 0.5 * allowed;
    let count = (half / spacing).ceil() as i32 + 1;
    let at = |x: f64, y: f64| exact([x, y, 0.0], UP);
    for (x, y) in (-count..=count).flat_map(|x| (-count..=count).map(move |y| (x, y))) {
        let stray = 0.8 * ((0.618_034 * f64::from(x + 7 * y)).rem_euclid(1.0) - 0.5);
        let (x, y) = ((f64::from(x) + stray) * spacing, f64::from(y) * spacing);
        let shift = Vector::of([slope(|by| at(x + by, y)), slope(|by| at(x, y + by)), 0.0]);
        let fallen = Fallen {
            irradiance: [at(x, y); 3],
            turned: [Vector::of([0.0; 3]); 3],
            shifted: [up.inward(shift); 3],
            distance: 1.0,
        };
        cache.add(Record::new(Vector::of([x, y, 0.0]), &up, 1, &keeps(fallen), [1.0; 2]));
    }
    cache
}

/// The error of what records of the floor say between them, rms over 30 by 30 places, over what falls on the middle.
fn interpolated(allowed: f64, keeps: Keeps) -> f64 {
    let cache = floor(allowed, 0.5, keeps);
    let square = |k: i32| {
        let [x, y] = [k % 30, k / 30].map(|k| f64::from(k) * 0.033 - 0.47);
        let told = cache.irradiance(Vector::of([x, y, 0.0]), Vector::of(UP), 1);
        (told.map_or(f64::NAN, |told| told[1]) - exact([x, y, 0.0], UP)).powi(2) / 900.0
    };
    (0..900).map(square).sum::<f64>().sqrt() / exact([0.0; 3], UP)
}

const ORDER: Check<Keeps> =
    check("second_order", "what records say between them is off by the square of the doubt that they are allowed")
        .against("Lambert's closed form of a bright square above the floor, at four doubts from 0.4 to 0.05")
        .order(2.0, 0.25, "the gradient leaves the curvature, and that the square of the distance")
        .of(
            |_: &mut Bench, keeps: Keeps| {
                let points: Vec<(f64, f64)> =
                    [0.4, 0.2, 0.1, 0.05].iter().map(|allowed| (*allowed, interpolated(*allowed, keeps))).collect();
                Measured::new(order::slope(&points).unwrap_or(f64::NAN), "four doubts", points.len())
            },
            (|fallen| fallen) as Keeps,
        )
        .slip("the gradient with its sign turned", |fallen| Fallen {
            shifted: fallen.shifted.map(|way| -way),
            ..fallen
        });

const CLOSED: Check<fn(f64, i32) -> f64> = check(
    "closed",
    "in a closed room that is the same everywhere every path is counted once, by a ray to the lamp or by a record",
)
.against("1 + ρ + … + ρ^(d − 1) for d = 2, 3 and 5 edges, against a picture by records")
.within(
    1e-6,
    "1",
    "single numbers in the picture; in a ball rays to the wall are as dense as the cosine: there is no noise",
)
.of(
    |_: &mut Bench, sum: fn(f64, i32) -> f64| {
        let manner = Manner { method: Method::Cached, ..Manner::default() };
        let cases = [2_u32, 3, 5].map(|edges| {
            let found = greens(&rendered(&closed(0.4, Some(edges), 8), &manner, 4)).mean();
            (found / sum(0.6, edges as i32) - 1.0, format!("{edges} edges"))
        });
        Measured::worst(cases)
    },
    |rho, edges| (0..edges).map(|k| rho.powi(k)).sum(),
)
.slip(
    "the wall that a record's rays meet counted with its own light, which rays to lamps have brought",
    |rho, edges| rho + (0..edges).map(|k| rho.powi(k)).sum::<f64>(),
);

/// Pixels along a side of the raced box.
const SIDE: u32 = 48;

/// The box, and with only what lamps send straight.
fn box_and_direct(pixels: u32) -> [Scene; 2] {
    let scene = view("cornell", pixels);
    [Scene { max_depth: Some(2), ..scene.clone() }, scene]
}

/// What comes by way of others: of the same numbers all light, less what comes straight.
fn indirect(all: &[Halves], direct: &[Halves]) -> Vec<Halves> {
    let less = |half: usize, all: &Halves, direct: &Halves| std::array::from_fn(|c| all[half][c] - direct[half][c]);
    all.iter().zip(direct).map(|(all, direct)| [less(0, all, direct), less(1, all, direct)]).collect()
}

/// That of the box by 4096 paths a pixel. Made once.
fn truth() -> Arc<Vec<Halves>> {
    static KNOWN: OnceLock<Arc<Vec<Halves>>> = OnceLock::new();
    let made = || {
        let manner = Manner { seed: 0x5eed, ..Manner::default() };
        let [direct, all] = box_and_direct(SIDE).map(|scene| rendered(&scene, &manner, 2048));
        Arc::new(indirect(&all, &direct))
    };
    Arc::clone(KNOWN.get_or_init(made))
}

/// A picture with all of its light, and caches of its own, timed; judged by what of it comes by way of others.
fn by(bench: &mut Bench, method: Method, work: u64) -> Heat {
    let seed = uniform(&mut bench.stream, 0.0, 1.0).to_bits();
    let manner = Manner { method, seed, ..Manner::default() };
    let pairs = (work / 2).max(1) as u32;
    let [direct, scene] = box_and_direct(SIDE);
    let reference = truth();
    Heat {
        run: Box::new(move || {
            let renderer = Renderer::new(&scene, &manner, pairs).expect("a scene of the lecture");
            let of = |pixel: &Halves| pixel.iter().flatten().map(|x| f64::from(*x)).collect::<Vec<_>>();
            halves(&renderer, &scene, pairs).iter().flat_map(of).collect()
        }),
        error: Box::new(move |found| {
            let all: Vec<Halves> = found
                .chunks_exact(6)
                .map(|pixel| [0, 3].map(|half| std::array::from_fn(|c| pixel[half + c] as f32)))
                .collect();
            let own = indirect(&all, &rendered(&direct, &manner, pairs));
            relative_mse_less(&colours(&own), &reference).0.max(0.0).sqrt()
        }),
    }
}

const fn raced(id: &'static str, label: &'static str, prepare: fn(&mut Bench, u64) -> Heat) -> Entrant {
    lane(id, label, &[4, 16, 64], prepare).repeated(2)
}

const INDIRECT: Race =
    race("indirect", "light by way of others in the box: what a few hundred places know, and what every path must find")
        .work("samples a pixel")
        .error(
            "relative error of what comes by way of others",
            "root of the mean over 48 × 48 pixels and channels of (x − ref)²/(ref² + 0.01) of all light less what lamps send \
             straight, both by the same numbers, rms over seeds; the reference is the fast integrator's, 4096 paths a pixel by a \
             seed of its own, and its noise, as its halves tell it, is taken off",
        )
        .lanes(&[
            // Squares of noise and of interpolation fall as W^−⅔; whole batches, and nets, make it a little more or less.
            raced("cache", "records", |bench, work| by(bench, Method::Cached, work)).order(0.33, 0.15),
            raced("both", "paths from the eye, to read", |bench, work| by(bench, Method::Simple(&INTEGRATORS[3]), work))
                .order(0.5, 0.15),
            raced("fast", "many lanes", |bench, work| by(bench, Method::default(), work)).order(0.5, 0.15),
        ]);

fn told(setting: &Setting) -> Plot {
    let allowed = setting.number("allowed");
    let axis = Axis::linear("x", "m").range(-2.0, 2.0);
    let mut chart = Chart::new("", axis, Axis::linear("irradiance E", "W/m²"));
    let places: Vec<f64> = (-100..=100).map(|k| f64::from(k) * 0.02).collect();
    let line = |of: &dyn Fn(f64) -> f64| places.iter().map(|x| [*x, of(*x)]).collect::<Vec<_>>();
    let by = |keeps: Keeps| {
        let cache = floor(allowed, 2.0, keeps);
        line(&|x| cache.irradiance(Vector::of([x, 0.0, 0.0]), Vector::of(UP), 1).map_or(f64::NAN, |told| told[1]))
    };
    chart = chart
        .line(Hue::Reference, "Lambert's closed form", line(&|x| exact([x, 0.0, 0.0], UP)))
        .line(Hue::Nth(1), "their light alone", by(plain))
        .line(Hue::Ours, "light and gradient", by(|fallen| fallen));
    let along = floor(allowed, 2.0, plain);
    let known = along.records().iter().filter(|record| record.place.y == 0.0 && record.place.x.abs() <= 2.0);
    let points = known.map(|record| [record.place.x, record.irradiance[1]]).collect();
    let label = "records".into();
    Plot::of(
        "What a few records say of the floor",
        chart.with(Mark::Points { label, hue: Hue::P, shape: drawn::Shape::Disc, joined: false, points }),
    )
}

fn records(_: &Setting) -> Plot {
    const PIXELS: u32 = 96;
    let scene = small("cornell", PIXELS);
    let manner = Manner { method: Method::Cached, ..Manner::default() };
    let picture = shown("sixteen samples a pixel", &rendered(&scene, &manner, 8), PIXELS as usize);
    let stage = Stage::new(&scene, Structure::Best).expect("a scene of the lecture");
    let caches = Caches::new(&stage, Choice::Net, 0);
    let cache = caches.of_sample(&stage, 15);
    let lens = stage.lens();
    let seen = |place: Vector<f64>| {
        let [x, y] = lens.place((place - lens.origin()).normalised());
        [x, -y]
    };
    let circle = |record: &Record| {
        let (axes, half) = (Frame::about(record.normal), 0.5 * cache.reach(record));
        let at = |k: u32| {
            let (sin, cos) = (TAU * f64::from(k) / 12.0).sin_cos();
            seen(record.place + axes.outward(Vector::new(half * cos, half * sin, 0.0)))
        };
        (0..12).map(|k| Part::line(at(k), at(k + 1)).hue(Hue::Ours)).collect::<Vec<_>>()
    };
    let size = f64::from(PIXELS);
    let corners = [[0.0, 0.0], [size, 0.0], [size, -size], [0.0, -size]];
    let frame = (0..4).map(|k| Part::line(corners[k], corners[(k + 1) % 4]).hue(Hue::Reference));
    let title = format!("{} records", cache.records().len());
    let diagram = Diagram::new(title, [0.0, -size], [size, 0.0])
        .with_all(frame)
        .with_all(cache.records().iter().flat_map(circle));
    Plot::grid("The box, and what it knows of its light", 2, vec![picture.into(), diagram.into()])
}

fn pictures(_: &Setting) -> Plot {
    const PIXELS: u32 = 96;
    let panel = |title: &str, method| {
        let manner = Manner { method, ..Manner::default() };
        let [direct, all] =
            [Some(2), None].map(|depth| rendered(&Scene { max_depth: depth, ..small("cornell", PIXELS) }, &manner, 2));
        shown(title, &indirect(&all, &direct), PIXELS as usize).into()
    };
    let panels = vec![panel("paths from the eye", Method::Simple(&INTEGRATORS[3])), panel("records", Method::Cached)];
    Plot::grid("Light by way of others, by four samples a pixel", 2, panels)
}
