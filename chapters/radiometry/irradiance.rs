//! E32: what arrives.

use super::symbols::{AREA, HEIGHT, INTENSITY, IRRADIANCE, RADIANCE, RADIUS, SOLID_ANGLE, THETA};
use crate::diagram::{Behind, Diagram, Part, Spot};
use crate::figure::{Axis, Chart, Dash, Hue, Map, Mark, Plot, Ramp, Shape};
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

/// Where a small lamp in the ceiling lights the floor: not so far away that the drawing has no height left.
const SLANT: Parameter = Parameter::new(
    "theta",
    "θ",
    "angle from below a small lamp to where it lights the floor",
    Kind::number(0.0, 80f64.to_radians(), "rad"),
)
.default("40deg");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "irradiance",
    &[ASIDE, TURN, HALF, SLANT],
    &[
        figure(
            "floor",
            "What a square lamp sends to the floor under it. Where its plane meets the floor only its edge is seen.",
            floor,
        ),
        figure("ceiling", "A small lamp in a ceiling lights the floor as cos⁴ θ, a large one more evenly.", ceiling),
        figure(
            "cosines",
            "Where the four cosines come from: the lamp is seen at a slant, the floor is met at a slant, and the way is \
             longer by 1/cos θ, which thins the light as its square.",
            cosines,
        ),
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
        quantity(
            "aslant",
            "cos^4 θ",
            "of what a small lamp in the ceiling sends right below itself, at θ",
            setting.number("theta").cos().powi(4),
            "1",
        ),
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

/// Two small areas, one in the ceiling and one on the floor, and what each shows the other of itself.
fn cosines(setting: &Setting) -> Plot {
    /// The height of the ceiling, unless the way would be longer than that.
    const HIGHEST: f64 = 1.35;
    const LONGEST: f64 = 2.6;
    /// Half the width of either area, and how far along the way the width stands that the other sees.
    const HALF: f64 = 0.17;
    const ALONG: f64 = 0.36;
    /// Length of the normals and radius of the arcs.
    const NORMAL: f64 = 0.8;
    const ARC: f64 = 0.65;
    /// A smaller angle [rad] has no name: there is no room for it.
    const NARROW: f64 = 0.1;
    const WIDE: f64 = 2.1;
    const LOW: f64 = -0.35;
    const HIGH: f64 = HIGHEST - LOW;
    let theta = setting.number("theta");
    let (sin, cos) = theta.sin_cos();
    let height = HIGHEST.min(LONGEST * cos);
    let reach = height * sin / cos;
    // Both in the middle of the window.
    let (floor, ceiling) = ((HIGHEST - height) / 2.0, (HIGHEST + height) / 2.0);
    let (lamp, place) = ([-reach / 2.0, ceiling], [reach / 2.0, floor]);
    let on_way = |share: f64| [(share - 0.5) * reach, ceiling - share * height];
    let along = ALONG.min(0.5 * height);
    // An area, and the lines from its ends to what is seen of it from the other end of the way.
    let seen = |[x, y]: Spot, sign: f64, hue: Hue, names: [&str; 2]| {
        let middle = [x + sign * along * sin, y - sign * along * cos];
        let ends = [-HALF, HALF].map(|end| ([x + end, y], [middle[0] + end * cos * cos, middle[1] + end * cos * sin]));
        let [(a, a_seen), (b, b_seen)] = ends;
        let aid = |from, to| Part::line(from, to).hue(hue).dash(Dash::Dotted);
        let [area, across] = names;
        [
            aid(a, a_seen),
            aid(b, b_seen),
            Part::surface(a, b, Behind::Nothing).hue(hue).label(area),
            Part::line(a_seen, b_seen).hue(hue).label(across),
        ]
    };
    let normal = |[x, y]: Spot, sign: f64| {
        Part::line([x, y], [x, y + sign * NORMAL.min(height)]).dash(Dash::Dashed).hue(Hue::Reference)
    };
    let arc = |at: Spot, from: f64| {
        let arc = Part::arc(at, ARC.min(0.85 * height), from, from + theta);
        if theta < NARROW { arc } else { arc.label("θ") }
    };
    let aside = lamp[0] - 0.6;
    let h = |share: f64| [aside, floor + share * height];
    let diagram = Diagram::new("", [-WIDE, LOW], [WIDE, HIGH])
        .with(Part::surface([WIDE, ceiling], [-WIDE, ceiling], Behind::Hatched))
        .with(Part::surface([-WIDE, floor], [WIDE, floor], Behind::Hatched))
        .with(Part::line(h(0.0), h(1.0)))
        .with(Part::line(h(0.4), h(0.6)).label("h"))
        .with(normal(lamp, -1.0))
        .with(normal(place, 1.0))
        .with(Part::ray_with_heads(lamp, place, &[0.6]))
        // The name stands beside the middle of the way, where most room is.
        .with(Part::ray_with_heads(on_way(0.4), on_way(0.55), &[]).label("r = h / cos θ"))
        .with_all(seen(lamp, 1.0, Hue::P, ["dA", "dA cos θ"]))
        .with_all(seen(place, -1.0, Hue::Ours, ["dA′", "dA′ cos θ"]))
        .with(arc(lamp, -FRAC_PI_2))
        .with(arc(place, FRAC_PI_2))
        .explain(Hue::P, Dash::Solid, "the lamp's tilt: cos θ")
        .explain(Hue::Ours, Dash::Solid, "the floor's tilt: cos θ")
        .explain(Hue::Natural, Dash::Solid, "the way: 1/r² = cos² θ / h²");
    Plot::of(format!("Four cosines at θ = {:.0}°: cos^4 θ = {:.3}", theta.to_degrees(), cos.powi(4)), diagram)
}
