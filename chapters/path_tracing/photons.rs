//! C26: light that is left where it falls.

use super::one_ray::judged;
use super::scenes::{LIT, lit, rendered, small};
use super::symbols::{R, S};
use super::ways::{ERROR, heat, shown};
use crate::figure::{self as drawn, Axis, Chart, Hue, Mark, Plot};
use crate::parameter::{Kind, Parameter, Setting};
use crate::vocabulary::{
    Answer, Bench, Check, Entrant, Exhibit, Heat, Misled, Quantity, Race, Step, check, derivation, exhibit, figure,
    lane, question, race, step,
};
use equation::Expr;
use equation::derivation::Chain;
use equation::expr::{integral_between, pi};
use light::geometry::Structure;
use light::number::Vector;
use light::sampling::Choice;
use light::scene::{Emission, Geometry, Scene, Shape};
use light::transport::photons::{Map, Photons};
use light::transport::simple::INTEGRATORS;
use light::transport::{Manner, Method, Stage};
use std::f64::consts::{PI, TAU};
use yardstick::statistics::Moments;

const RADIUS: Parameter =
    Parameter::new("radius", "r", "of the disc about a place in which photons count", Kind::number(0.02, 1.0, "m"))
        .default("0.3");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "photons",
    &[RADIUS],
    &[
        figure(
            "blur",
            "Irradiance along a line of the floor under a square lamp, told by one map of 4096 paths, for three radii. Wide discs are smooth and flatten the top; narrow ones are right on average, and rough.",
            blur,
        ),
        figure(
            "pictures",
            "A ball of glass and one of mirror in the box, sixteen samples a pixel each: by paths from the eye, and by maps of photons.",
            pictures,
        ),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Light left where it falls",
    "Photons from the lamps find what lies behind glass, and a map of them is wrong by the square of its radius, whatever the number of rays.",
)
.rows(&["C26"])
.derivations(&[
    derivation("disc", "the weight (2/πr²)(1 − s²/r²) has the mean square distance r²/3", || disc(R.pow(2) / 3))
        .slip("as if all of the disc counted alike", || disc(R.pow(2) / 2)),
])
.questions(&[question(
    "eight",
    "A picture is the mean over samples, each with a map of its own, and the radii shrink so that noise and blur fall alike. You render eight times as many samples. By which factor does the blur fall?",
    Answer::Number {
        unit: "1",
        tolerance: 0.03,
        right: |_| {
            let stage = staged(&lit(PLACE, SIDE, AWAY, 8).0);
            let photons = Photons::new(&stage, Choice::Net, 0);
            (photons.radii(63)[1] / photons.radii(511)[1]).powi(2)
        },
        slips: &[
            Misled { value: |_| 8f64.sqrt(), reply: "So falls the noise of a path tracer. Here a part of each sample's gain is given to a narrower disc." },
            Misled { value: |_| 8.0, reply: "The blur goes as r², but r shrinks more slowly than that: fewer photons lie in narrower discs." },
        ],
    },
    "By two: r² falls as N^−⅓. That is the price of an error that goes away at all.",
)])
.readout(|setting| {
    let radius = setting.number("radius");
    let quantity = |key, symbol, says, value, unit| Quantity { key, symbol, says, value, unit };
    vec![
        quantity("exact", "E", "irradiance of the place, by Lambert's closed form", fallen(PLACE), "W/m²"),
        quantity("blurred", "E_r", "as maps of that radius have it on average", blurred(radius), "W/m²"),
    ]
})
.checks(&[&BLUR, &FLUX])
.races(&[GLASS]);

/// ∫s²w dA over the disc, with w as it is derived for.
fn disc(last: Expr) -> Chain {
    let weight = 2 / (pi() * R.pow(2)) * (1 - S.pow(2) / R.pow(2));
    Chain::new(integral_between(S.pow(2) * weight * 2 * pi() * S, S, 0, Expr::from(R)))
        .primitive(S.pow(4) / R.pow(2) - 2 * S.pow(6) / (3 * R.pow(4)), S)
        .then(last, ["in rings 2πs ds"])
}

/// Where on the floor; the lamp's side [m], and how far away the camera is [m].
const PLACE: [f64; 2] = [0.05, 0.0];
const SIDE: f64 = 1.0;
const AWAY: f64 = 0.5;

fn staged(scene: &Scene) -> Stage<f64> {
    Stage::new(scene, Structure::Best).expect("a scene of the lecture")
}

/// Irradiance [W m⁻²] of a place of the floor, by the closed form of the radiance it returns.
fn fallen(at: [f64; 2]) -> f64 {
    lit(at, SIDE, AWAY, 1).1 * PI / LIT.0
}

/// What maps of a radius say of the place on average: the mean over the disc about it, by its weight.
fn blurred(radius: f64) -> f64 {
    const RINGS: u32 = 64;
    const TURNS: u32 = 32;
    // In the weight's own measure, 2(1 − v) dv with v = s²/r², rings count alike.
    let away = |ring: u32| radius * (1.0 - (1.0 - (f64::from(ring) + 0.5) / f64::from(RINGS)).sqrt()).sqrt();
    let around =
        (0..RINGS).flat_map(|ring| (0..TURNS).map(move |turn| (ring, TAU * f64::from(turn) / f64::from(TURNS))));
    let [x, y] = PLACE;
    let fallen = around.map(|(ring, turn)| fallen([x + away(ring) * turn.cos(), y + away(ring) * turn.sin()]));
    fallen.sum::<f64>() / f64::from(RINGS * TURNS)
}

/// The irradiance [W m⁻²] of places of the floor as maps of so many paths tell it, map by map.
fn told(paths: u32, maps: u32, radius: f64, places: &[[f64; 2]]) -> Vec<Vec<f64>> {
    // As many pixels as ask for so many paths.
    let pixels = (f64::from(paths) * 4.0).sqrt() as u32;
    let (scene, _) = lit(PLACE, SIDE, AWAY, pixels);
    let stage = staged(&scene);
    let photons = Photons::new(&stage, Choice::Independent, 7);
    let [a, b, c] = scene.camera.origin;
    let place = |[x, y]: [f64; 2]| Vector::of([x - a, y - b, -c].map(|x| x * stage.scale()));
    let of = |sample| {
        let map = Map::new(photons.sent(&stage, sample), radius * stage.scale());
        // What the floor returns falls on the lamp, which is black, or leaves: all that falls here is the lamp's own.
        places.iter().map(|at| map.irradiance(place(*at), Vector::of([0.0, 0.0, 1.0]), 8)[1]).collect()
    };
    (0..maps).map(of).collect()
}

const BLUR: Check<fn(f64) -> f64> =
    check("disc_mean", "on average a map tells the mean of the irradiance over its disc, not that of the place")
        .against("Lambert's closed form of a square lamp, averaged by quadrature, against 512 independent maps of radius 0.35 m (t-test)")
        .significant(1e-3)
        .of(
            |_: &mut Bench, blurred: fn(f64) -> f64| {
                let radius = 0.35;
                let found: Moments = told(1 << 10, 512, radius, &[PLACE]).into_iter().flatten().collect();
                judged(&found, blurred(radius))
            },
            blurred as fn(f64) -> f64,
        )
        .slip("as if the disc had no width", |_| fallen(PLACE));

const FLUX: Check<fn(f64) -> f64> =
    check("flux", "what falls anywhere in a closed room is the lamps' flux over what is absorbed, Φ/(1 − ρ)")
        .against("the sum over all photons of 32 maps, in a room that returns 70 % everywhere (t-test)")
        .significant(1e-3)
        .of(
            |_: &mut Bench, falls: fn(f64) -> f64| {
                let rho = 0.7;
                let stage = staged(&room(rho));
                let photons = Photons::new(&stage, Choice::Independent, 11);
                let flux: f64 = stage.lamps().iter().map(|lamp| lamp.flux(1.0)).sum();
                let fallen = |sample| {
                    let all = photons.sent(&stage, sample);
                    all.iter().map(|photon| photon.flux.iter().sum::<f64>()).sum::<f64>() / flux
                };
                judged(&(0..32).map(fallen).collect(), falls(rho))
            },
            |rho| 1.0 / (1.0 - rho),
        )
        .slip("the light that returns counted once", |rho| 1.0 + rho);

/// A ball whose wall returns a share of the light of a lamp in it.
fn room(rho: f64) -> Scene {
    let mut room = super::scenes::closed(1.0 - rho, None, 64);
    let lamp = Emission { radiance: [1.0; 3], two_sided: false };
    room.shapes[0].emission = None;
    let ball = Geometry::Sphere { center: [0.2, 0.3, 0.1], radius: 0.2 };
    let material = room.shapes[0].material.clone();
    room.shapes.push(Shape { geometry: ball, emission: Some(lamp), material, ..room.shapes[0].clone() });
    room
}

const fn raced(id: &'static str, label: &'static str, prepare: fn(&mut Bench, u64) -> Heat) -> Entrant {
    lane(id, label, &[4, 16, 64], prepare).repeated(2)
}

fn by(bench: &mut Bench, method: Method, work: u64) -> Heat {
    heat(bench, "glass", Manner { method, ..Manner::default() }, work)
}

const GLASS: Race = race("glass", "a ball of glass: what paths from the eye find by chance alone, photons bring")
    .work("samples a pixel")
    .error(ERROR.0, ERROR.1)
    .lanes(&[
        raced("photons", "maps of photons", |bench, work| by(bench, Method::Photons, work)).order(0.4, 0.2),
        raced("both", "paths from the eye, to read", |bench, work| by(bench, Method::Simple(&INTEGRATORS[3]), work))
            .breaks(0.3, "sparks: the lamp is met through the glass by chance alone"),
        raced("fast", "many lanes, and paths from the lamp", |bench, work| by(bench, Method::default(), work))
            .order(0.5, 0.2),
    ]);

fn blur(setting: &Setting) -> Plot {
    let own = setting.number("radius");
    let places: Vec<[f64; 2]> = (-40..=40).map(|k| [f64::from(k) * 0.05, PLACE[1]]).collect();
    let mut chart = Chart::new("", Axis::linear("x", "m").range(-2.0, 2.0), Axis::linear("irradiance E", "W/m²"));
    for (hue, radius) in [(Hue::Nth(0), 0.1), (Hue::Nth(1), 0.8), (Hue::Ours, own)] {
        let told = told(1 << 12, 1, radius, &places).into_iter().flatten();
        let points = places.iter().zip(told).map(|([x, _], e)| [*x, e]).collect();
        let label = format!("r = {radius} m");
        chart = chart.with(Mark::Points { label, hue, shape: drawn::Shape::Disc, joined: true, points });
    }
    let exact = places.iter().map(|at| [at[0], fallen(*at)]).collect();
    Plot::of("What a map of photons tells", chart.line(Hue::Reference, "Lambert's closed form", exact))
}

fn pictures(_: &Setting) -> Plot {
    const PIXELS: u32 = 96;
    let panel = |title: &str, method| {
        let manner = Manner { method, ..Manner::default() };
        shown(title, &rendered(&small("glass", PIXELS), &manner, 8), PIXELS as usize).into()
    };
    let panels =
        vec![panel("paths from the eye", Method::Simple(&INTEGRATORS[3])), panel("maps of photons", Method::Photons)];
    Plot::grid("Glass by 16 samples a pixel", 2, panels)
}
