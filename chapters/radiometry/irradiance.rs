//! E32: what arrives.

use super::symbols::{AREA, HEIGHT, INTENSITY, IRRADIANCE, RADIANCE, RADIUS, SOLID_ANGLE, THETA};
use crate::figure::{Axis, Chart, Hue, Map, Mark, Plot, Ramp, Shape};
use crate::parameter::{Kind, Parameter, Setting};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Misled, Quantity, Step, check, derivation, exhibit, figure, question,
    statement, step,
};
use equation::derivation::Chain;
use equation::expr::{Range, cos, integral, integral_between, pi, sin};
use equation::{Equation, Expr};
use light::radiometry::{disc::Disc, polygon};
use std::f64::consts::{FRAC_PI_2, PI};
use yardstick::directions::{Domain, integral as sum, product};
use yardstick::order;

/// Where the lamp stands.
const ASIDE: Parameter =
    Parameter::new("aside", "a/h", "how far the lamp is aside, over its height", Kind::number(-3.0, 3.0, "1"))
        .default("0");
/// How it is turned.
const TURN: Parameter =
    Parameter::new("turn", "τ", "how far it is turned away from the floor", Kind::number(-FRAC_PI_2, FRAC_PI_2, "rad"))
        .default("35deg");
/// How large it is.
const HALF: Parameter =
    Parameter::new("half", "s/h", "half its side over its height", Kind::number(1e-3, 0.9, "1")).default("0.4");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "irradiance",
    &[ASIDE, TURN, HALF],
    &[
        figure(
            "floor",
            "What a square lamp sends to the floor under it. Where its plane meets the floor only its edge is seen.",
            floor,
        ),
        figure("ceiling", "A small lamp in a ceiling lights the floor as cos⁴ θ, a large one more evenly.", ceiling),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "What arrives",
    "Irradiance sums what comes from every direction, weighed by how squarely it arrives.",
)
.rows(&["E32"])
.statements(&[statement("irradiance", "power that arrives on a unit of area", || {
    Equation::new(IRRADIANCE, integral(RADIANCE * cos(THETA), [SOLID_ANGLE.into()], Range::Whole))
})])
.derivations(&[
    derivation("hemisphere", "from a sky of one radiance", || hemisphere(pi() * RADIANCE))
        .slip("the solid angle of the sky for what arrives from it", || hemisphere(2 * pi() * RADIANCE)),
    derivation("cos_4", "a small lamp in a ceiling, on the floor: four cosines", || {
        cos_4(RADIANCE * AREA * cos(THETA).pow(4) / HEIGHT.pow(2))
    })
    .slip("two of them forgotten, those of the distance", || {
        cos_4(RADIANCE * AREA * cos(THETA).pow(2) / HEIGHT.pow(2))
    }),
])
.questions(&[question(
    "level_ground",
    "A whole hemisphere of sky has the radiance 100 W/(sr m²). What arrives on level ground?",
    Answer::Number {
        unit: "W/m²",
        tolerance: 0.01,
        right: |_| 100.0 * sum(&product(Domain::Cosine, 4), |_| 1.0),
        slips: &[
            Misled {
                value: |_| 100.0 * 2.0 * PI,
                reply: "The sky is 2π steradians wide; but what comes from low down arrives slantwise.",
            },
            Misled { value: |_| 100.0, reply: "Radiance is per steradian: there are many of them in the sky." },
        ],
    },
    "π times the radiance: the hemisphere's shadow on the ground is a disc of radius 1.",
)])
.readout(|setting| {
    let lamp = Lamp::of(setting);
    let quantity = |key, symbol, says, value, unit| Quantity { key, symbol, says, value, unit };
    vec![
        quantity("below", "E/L", "under the middle of the map, over the lamp's radiance", lamp.on([0.0; 2]), "sr"),
        quantity("share", "E/πL", "of what a whole sky of it would send", lamp.on([0.0; 2]) / PI, "1"),
    ]
})
.checks(&[&SKY, &SMALL]);

fn hemisphere(last: Expr) -> Chain {
    let ring = || 2 * pi() * RADIANCE * cos(THETA) * sin(THETA);
    Chain::new(integral_between(ring(), THETA, 0, pi() / 2))
        .because("rings of the sky, each 2π sin θ dθ")
        .primitive(pi() * RADIANCE * sin(THETA).pow(2), THETA)
        .then(last, ["∂ sin² θ = 2 sin θ cos θ"])
}

fn cos_4(last: Expr) -> Chain {
    Chain::new(INTENSITY * cos(THETA) / RADIUS.pow(2))
        .because("I/r² onto a floor that is tilted by θ")
        .given(INTENSITY, RADIANCE * AREA * cos(THETA), "a Lambertian lamp")
        .given(RADIUS, HEIGHT / cos(THETA), "r cos θ = h")
        .then(last, ["a Lambertian lamp", "r cos θ = h"])
}

const SKY: Check<fn(f64) -> f64> = check(
    "sky",
    "what comes from a sky that is brighter above is the sum of L cos θ over it",
)
.against(
    "7π/9 of the zenith's radiance, the integral of the overcast sky (1 + 2 cos θ)/3 (P. Moon and D. E. Spencer 1942)",
)
.within(1e-14, "1", "a product rule that is exact for it")
.of(overcast, |cos| cos)
.slip("cos θ forgotten", |_| 1.0);

fn overcast(_: &mut Bench, weight: fn(f64) -> f64) -> Measured {
    let found = sum(&product(Domain::Hemisphere, 8), |way| (1.0 + 2.0 * way[2]) / 3.0 * weight(way[2]));
    Measured::new((found / (7.0 * PI / 9.0) - 1.0).abs(), "the whole sky", 1)
}

const SMALL: Check<fn(f64) -> f64> =
    check("small", "a lamp in a ceiling that is small over its height lights the floor as cos⁴ θ")
        .against("Lambert's sum for its square, halved again and again")
        .order(2.0, 0.05, "the square's middle is its centre of mass: what is odd about it cancels")
        .of(shrinking, |cos| cos.powi(4))
        .slip("cos² θ: the distance's own cosines forgotten", |cos| cos * cos);

fn shrinking(_: &mut Bench, law: fn(f64) -> f64) -> Measured {
    let points: Vec<(f64, f64)> = (2..9)
        .map(|halving| {
            let half = 0.5 / f64::from(1 << halving);
            let worst = [0.0, 0.4, 1.0, 3.0].map(|x: f64| {
                let corners =
                    [[x - half, -half, 1.0], [x + half, -half, 1.0], [x + half, half, 1.0], [x - half, half, 1.0]];
                let found = polygon::irradiance(&corners, [0.0, 0.0, 1.0]).unwrap_or(f64::NAN);
                (found / (4.0 * half * half * law(1.0 / x.hypot(1.0))) - 1.0).abs()
            });
            (half, Measured::worst(worst.map(|off| (off, String::new()))).value)
        })
        .collect();
    Measured::new(
        order::slope(&points).unwrap_or(f64::NAN),
        "sides from 1/4 to 1/256 of the height, up to 72° aside",
        28,
    )
}

/// A square lamp over a floor, at the height 1.
struct Lamp {
    corners: [[f64; 3]; 4],
}

impl Lamp {
    fn of(setting: &Setting) -> Self {
        let [aside, turn, half] = ["aside", "turn", "half"].map(|name| setting.number(name));
        let (sin, cos) = turn.sin_cos();
        let corner = |u: f64, v: f64| [aside + half * u * cos, half * v, 1.0 + half * u * sin];
        Self { corners: [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)] }
    }

    /// E/L [sr] on the floor at a place.
    fn on(&self, [x, y]: [f64; 2]) -> f64 {
        let seen = self.corners.map(|[u, v, w]| [u - x, v - y, w]);
        polygon::irradiance(&seen, [0.0, 0.0, 1.0]).unwrap_or(f64::NAN)
    }
}

fn floor(setting: &Setting) -> Plot {
    let lamp = Lamp::of(setting);
    const CELLS: usize = 90;
    let reach = 3.0;
    let place = |at: usize| ((at as f64 + 0.5) / CELLS as f64 * 2.0 - 1.0) * reach;
    let values: Vec<f64> = (0..CELLS * CELLS).map(|at| lamp.on([place(at % CELLS), place(at / CELLS)])).collect();
    let most = values.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
    let axis = |name: &str| Axis::linear(name, "").range(-reach, reach).tick(1.0);
    let rim = lamp.corners.iter().chain(&lamp.corners[..1]).map(|corner| [corner[0], corner[1]]).collect();
    let map = Map {
        title: String::new(),
        x: axis("x / h"),
        y: axis("y / h"),
        colour: Axis::linear("E / L", "sr").range(0.0, most),
        ramp: Ramp::Sequential,
        columns: CELLS,
        values,
        marks: vec![Mark::Points { label: String::new(), hue: Hue::P, shape: Shape::Ring, joined: true, points: rim }],
    };
    Plot::of("The floor under a square lamp (its outline from above)", map)
}

fn ceiling(_: &Setting) -> Plot {
    let curve = |radius: f64| -> Vec<[f64; 2]> {
        let on = |x: f64| Disc { radius, height: 1.0, offset: x, tilt: 0.0 }.irradiance().unwrap_or(f64::NAN);
        let middle = on(0.0);
        (-200..=200).map(|at| f64::from(at) / 50.0).map(|x| [x, on(x) / middle]).collect()
    };
    let law = (-200..=200).map(|at| f64::from(at) / 50.0).map(|x: f64| [x, x.hypot(1.0).powi(-4)]).collect();
    let chart = Chart::new(
        "",
        Axis::linear("place x / h", "").range(-4.0, 4.0),
        Axis::linear("irradiance over that below the middle", "").range(0.0, 1.05),
    )
    .line(Hue::Nth(0), "R = 0.1 h", curve(0.1))
    .line(Hue::Nth(1), "R = h", curve(1.0))
    .line(Hue::Nth(2), "R = 3 h", curve(3.0))
    .dashed(Hue::Reference, "cos⁴ θ", law);
    Plot::of("A round lamp in the ceiling", chart)
}
