//! E51: what a surface sends back of all that arrives.

use super::symbols::{F_R, L_IN, L_R, OMEGA, RHO, THETA};
use crate::diagram::{Behind, Diagram, Part};
use crate::figure::{Dash, Hue, Plot};
use crate::parameter::{Kind, Parameter, Setting};
use crate::vocabulary::{
    Answer, Bench, Check, Entrant, Exhibit, Heat, Measured, Misled, Quantity, Race, Step, check, derivation, exhibit,
    figure, lane, question, race, statement, step,
};
use equation::derivation::Chain;
use equation::expr::{Range, cos, d, integral, integral_between, pi, sin};
use equation::{Equation, Expr};
use light::bsdf::Bsdf;
use light::bsdf::eon::Eon;
use light::number::Vector;
use light::radiometry::polygon;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use yardstick::directions::{Direction, Domain, Points, Rule, integral as sum, product, sampled};

const SEEN: Parameter =
    Parameter::new("theta", "θ_r", "angle to the normal from which the floor is seen", Kind::number(0.0, 1.5, "rad"))
        .default("60deg");
const ROUGHNESS: Parameter =
    Parameter::new("roughness", "r", "roughness of the plaster", Kind::number(0.0, 1.0, "1")).default("0.8");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "reflected",
    &[SEEN, ROUGHNESS],
    &[figure(
        "bundles",
        "One direction out of many: the sky in bundles, each with its own L_in, and what all of them together send to the eye. \
         The bars are what each bundle adds.",
        bundles,
    )],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "What a surface sends back",
    "One bundle of light adds f L cos θ dω to what leaves; all of them together are an integral over the hemisphere.",
)
.rows(&["E51"])
.statements(&[statement("reflected", "all that arrives, each direction by its own share, in W/(sr m²)", || {
    Equation::new(L_R, integral(L_IN * cos(THETA) * F_R, [OMEGA.into()], Range::Whole))
})])
.derivations(&[
    derivation("bundle", "the BRDF's definition (E47), read the other way: what one bundle adds", || bundle(d(L_R)))
        .slip("the irradiance per steradian taken for radiance, cos θ forgotten", || bundle(d(L_R) / cos(THETA))),
    derivation("even", "a Lambertian floor under a sky of one radiance sends back ρ of it", || even(RHO * L_IN))
        .slip("the hemisphere's solid angle for its projected one", || even(2 * RHO * L_IN)),
])
.questions(&[question(
    "white",
    "A floor that absorbs nothing lies under a sky of 100 W/(sr m²) and scatters diffusely. What is its radiance?",
    Answer::Number {
        unit: "W/(m² sr)",
        tolerance: 0.01,
        right: |_| 100.0 * sum(&product(Domain::Cosine, 4), |_| 1.0 / PI),
        slips: &[
            Misled {
                value: |_| 100.0 * PI,
                reply: "That is what arrives on a unit of area. What leaves is spread over directions again: 1/π.",
            },
            Misled {
                value: |_| 200.0,
                reply: "The sky is 2π wide, but low light arrives slantwise: the cosine halves it.",
            },
        ],
    },
    "As much as the sky's: a floor that absorbs nothing is not to be told from the sky.",
)])
.readout(|setting| {
    let surface = plaster(setting.number("roughness"));
    let wo = way(setting.number("theta"));
    let quantity = |key, symbol, says, value| Quantity { key, symbol, says, value, unit: "1" };
    vec![
        quantity("half", "L_r/L", "of a sky that is bright on the eye's side alone", side(&surface, wo, 1.0)),
        quantity("other", "L_r/L", "of one that is bright on the other side", side(&surface, wo, -1.0)),
        quantity("all", "L_r/L", "of an even sky: a body that absorbs nothing", exact(&surface, wo)),
    ]
})
.checks(&[&LAMP, &PLASTER])
.races(&[RULES]);

fn bundle(last: Expr) -> Chain {
    Chain::new(L_IN * cos(THETA) * F_R * d(OMEGA))
        .given(F_R, d(L_R) / (L_IN * cos(THETA) * d(OMEGA)), "E47")
        .then(last, ["E47"])
}

fn even(last: Expr) -> Chain {
    let ring = || L_IN * cos(THETA) * F_R * 2 * pi() * sin(THETA);
    Chain::new(integral_between(ring(), THETA, 0, pi() / 2))
        .because("rings of the sky, each 2π sin θ dθ")
        .given(F_R, RHO / pi(), "Lambert's floor")
        .primitive(RHO * L_IN * sin(THETA).pow(2), THETA)
        .then(last, ["Lambert's floor", "∂ sin² θ = 2 sin θ cos θ"])
}

const LAMP: Check<fn(f64) -> f64> = check(
    "lamp",
    "a floor under a square lamp: summed over the directions in which it sees the lamp, the integral is ρ/π of what arrives",
)
.against("ρE/π with Lambert's closed form, against f L cos θ over 1 000 000 even directions of which some meet the lamp")
.within(
    2e-3,
    "1",
    "a lattice of 1000 × 1000 directions cuts the lamp's rim at some 3000 of them, half of each uncertain and its sign at random: √3000/2 of 26 000",
)
.of(
    |_: &mut Bench, weight: fn(f64) -> f64| {
        let (half, side) = (0.3, 1000);
        let at = |k: usize| (k as f64 + 0.5) / side as f64;
        let points: Vec<[f64; 2]> = (0..side * side).map(|k| [at(k % side), at(k / side)]).collect();
        let is_lamp = |way: Direction, x: f64| (way[0] / way[2] - x).abs() < half && (way[1] / way[2]).abs() < half;
        Measured::worst([0.0, 0.5].map(|x| {
            let f = 0.5 / PI;
            let seen = |way: Direction| if is_lamp(way, x) { f * weight(way[2]) } else { 0.0 };
            let found = sum(&sampled(Domain::Hemisphere, &points), seen);
            let corners = [[-half, -half], [half, -half], [half, half], [-half, half]].map(|[a, b]| [a + x, b, 1.0]);
            let exact = f * polygon::irradiance(&corners, [0.0, 0.0, 1.0]).unwrap_or(f64::NAN);
            (found / exact - 1.0, format!("lamp {x} m aside, 1 m above"))
        }))
    },
    |cos| cos,
)
.slip("cos θ forgotten", |_| 1.0);

/// Rough white plaster.
fn plaster(roughness: f64) -> Eon<f64> {
    Eon { albedo: [1.0; 3], roughness }
}

fn way(theta: f64) -> Vector<f64> {
    Vector::new(theta.sin(), 0.0, theta.cos())
}

/// What it sends to `wo` under a sky of radiance 1.
fn exact(surface: &Eon<f64>, wo: Vector<f64>) -> f64 {
    surface.albedo(wo).map_or(f64::NAN, |albedo| albedo[1])
}

/// What a direction adds, per steradian.
fn adds(surface: &Eon<f64>, wo: Vector<f64>, wi: Direction) -> f64 {
    surface.eval(Vector::of(wi), wo)[1] * wi[2]
}

/// Under a sky that is bright on one side alone.
fn side(surface: &Eon<f64>, wo: Vector<f64>, sign: f64) -> f64 {
    sum(&product(Domain::Hemisphere, 48), |wi| if wi[0] * sign > 0.0 { adds(surface, wo, wi) } else { 0.0 })
}

const PLASTER: Check<fn(f64) -> f64> =
    check("plaster", "white plaster, smooth and rough, sends back all of an even sky, whichever way it is seen")
        .against("1: it absorbs nothing, and light of one radiance everywhere stays what it is")
        .within(2e-3, "1", "96 × 192 directions over a kink in f: the square of 1/96, with a factor of some ten")
        .of(
            |_: &mut Bench, weight: fn(f64) -> f64| {
                let rule = product(Domain::Hemisphere, 96);
                let cases = [0.0, 0.3, 1.0].into_iter().flat_map(|r| [0.05, 0.8, 1.4].map(|theta| (r, theta)));
                Measured::worst(cases.map(|(r, theta)| {
                    let (surface, wo) = (plaster(r), way(theta));
                    let found = sum(&rule, |wi| surface.eval(Vector::of(wi), wo)[1] * weight(wi[2]));
                    (found - 1.0, format!("r = {r}, θ = {theta}"))
                }))
            },
            |cos| cos,
        )
        .slip("the sine of a latitude for the cosine", |cos| (1.0 - cos * cos).sqrt());

/// How the raced floor is seen.
const RACED: (f64, f64) = (1.0, 1.2);
const WORKS: &[u64] = &[64, 256, 1024, 4096, 16384];
const RUNS: u32 = 32;

fn heat(rule: Rule, weighs: bool) -> Heat {
    let (surface, wo) = (plaster(RACED.0), way(RACED.1));
    Heat {
        run: Box::new(move || {
            let of = |wi: Direction| surface.eval(Vector::of(wi), wo)[1] * if weighs { wi[2] } else { 1.0 };
            vec![sum(&rule, of)]
        }),
        error: Box::new(move |found| (found[0] - 1.0).abs()),
    }
}

fn drawn(bench: &mut Bench, domain: Domain, points: Points, work: u64) -> Heat {
    let rule = sampled(domain, &points.draw(work as usize, &mut bench.stream));
    heat(rule, domain == Domain::Hemisphere)
}

const fn by(id: &'static str, label: &'static str, prepare: fn(&mut Bench, u64) -> Heat) -> Entrant {
    lane(id, label, WORKS, prepare).repeated(RUNS)
}

const RULES: Race = race(
    "rules",
    "one integral by five rules: chance falls as 1/√N whatever it draws, points that avoid each other and products fall faster",
)
.work("directions")
.error(
    "relative error of L_r",
    "rms over 32 seeds of the relative error, against 1: rough white plaster, seen at 69°, under an even sky",
)
.lanes(&[
    by("uniform", "evenly, by chance", |bench, work| drawn(bench, Domain::Hemisphere, Points::Random, work))
        .order(0.5, 0.1),
    by("cosine", "as the cosine has it, by chance", |bench, work| drawn(bench, Domain::Cosine, Points::Random, work))
        .order(0.5, 0.1),
    by("stratified", "by the cosine, one in each cell", |bench, work| {
        drawn(bench, Domain::Cosine, Points::Stratified, work)
    })
    .order(1.0, 0.15),
    by("sobol", "by the cosine, a scrambled net", |bench, work| drawn(bench, Domain::Cosine, Points::Sobol, work))
        .order(1.25, 0.25),
    lane("product", "Gauss in cos θ times even in φ", &[32, 128, 512, 2048, 8192, 32768], |_, work| {
        heat(product(Domain::Hemisphere, ((work / 2) as f64).sqrt().round() as usize), true)
    })
    .order(1.0, 0.3),
    lane("closed", "the closed form", &[1], |_, _| {
        let (surface, wo) = (plaster(RACED.0), way(RACED.1));
        Heat {
            run: Box::new(move || vec![exact(&surface, std::hint::black_box(wo))]),
            error: Box::new(|found| (found[0] - 1.0).abs()),
        }
    })
    .within(1e-14, "a few dozen roundings of an albedo that has a closed form, and what is given back beside it"),
]);

fn bundles(setting: &Setting) -> Plot {
    let (surface, theta) = (plaster(setting.number("roughness")), setting.number("theta"));
    let wo = way(theta);
    let count = 15;
    let width = PI / f64::from(count);
    let of = |k: i32| -FRAC_PI_2 + (f64::from(k) + 0.5) * width;
    let place = |angle: f64, r: f64| [r * angle.sin(), r * angle.cos()];
    // In the plane of the drawing a bundle is a strip of the sky, sin θ wide.
    let added = |angle: f64| {
        let wi = Vector::new(angle.sin(), 0.0, angle.cos());
        surface.eval(wi, wo)[1] * angle.cos() * angle.sin().abs()
    };
    let most = (0..count).map(|k| added(of(k))).fold(1e-9, f64::max);
    let sky = (0..=60).map(|k| place(-FRAC_PI_2 + PI * f64::from(k) / 60.0, 2.0)).collect();
    let bars = (0..count).map(|k| {
        let angle = of(k);
        Part::line(place(angle, 2.0), place(angle, 2.0 + 0.7 * added(angle) / most)).hue(Hue::P)
    });
    let rays = (0..count).map(|k| Part::line([0.0; 2], place(of(k), 1.95)).hue(Hue::Reference).dash(Dash::Dotted));
    let one = of(3);
    let diagram = Diagram::new("", [-3.4, -0.5], [3.4, 3.1])
        .with(Part::surface([-3.3, 0.0], [3.3, 0.0], Behind::Hatched))
        .with(Part::curve(sky).hue(Hue::Reference))
        .with_all(rays)
        .with_all(bars)
        .with(Part::line([0.0; 2], [0.0, 1.2]).dash(Dash::Dashed).label("n"))
        .with(Part::ray_with_heads(place(one, 1.95), [0.0; 2], &[0.5]).hue(Hue::P).label("L_{in}"))
        .with(Part::arc([0.0; 2], 0.75, FRAC_PI_2, FRAC_PI_2 - one).label("θ_i"))
        .with(Part::ray_with_heads([0.0; 2], place(theta, 1.7), &[0.85]).hue(Hue::Ours).label("L_r"))
        .explain(Hue::P, Dash::Solid, "what each bundle adds, f_r L_{in} cos θ dω")
        .explain(Hue::Reference, Dash::Solid, "the sky");
    let degrees = (360.0 * theta / TAU).round();
    Plot::of(format!("Rough plaster seen at {degrees}°, under an even sky"), diagram)
}
