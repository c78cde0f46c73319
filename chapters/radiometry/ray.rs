//! C8: what stays the same along a ray.

use super::ball::{self, Ray, onward};
use super::symbols::{AREA, AREA_2, N_1, N_2, RADIANCE, RADIANCE_1, RADIANCE_2, RADIUS, SOLID_ANGLE, THETA, THETA_2};
use crate::figure::{Axis, Chart, Dash, Hue, Mark, Plot};
use crate::parameter::{Kind, Parameter, Setting};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Misled, Quantity, Step, check, derivation, exhibit, figure, question, step,
};
use equation::derivation::Chain;
use equation::expr::{cos, partial, sin};
use equation::{Equation, Expr, Symbol};
use glam::DVec3;
use light::optics::incidence::refracted;
use light::radiometry::disc::Disc;
use std::f64::consts::PI;
use yardstick::quadrature::gauss;
use yardstick::random::uniform;

/// Index of the glass.
const GLASS: Parameter =
    Parameter::new("n", "n", "index of lens and water", Kind::number(1.0, 4.0, "1")).default("1.5");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "ray",
    &[GLASS],
    &[
        figure("distance", "A round lamp from ever farther: its irradiance falls, its radiance does not.", distance),
        figure(
            "bundle",
            "A bundle of rays as an area of places and directions: free space shears it, a lens shears it the other way, \
             and its area stays.",
            sheared,
        ),
        figure(
            "image",
            "A small source and its image by a ball of glass. By as much as the image is smaller its bundle is wider; where \
             it stands in the glass there is more of L, by n². L/n² is what stays.",
            ball::image,
        ),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Along a ray",
    "Radiance does not fade with the distance; in another medium only L/n² is the same.",
)
.rows(&["C8"])
.derivations(&[
    derivation(
        "both_ends",
        "two small surfaces that see each other: what leaves one is what comes to the other",
        || both_ends(RADIANCE * AREA_2 * cos(THETA_2) * SOLID_ANGLE),
    )
    .slip("the far surface's tilt left out", || both_ends(RADIANCE * AREA_2 * SOLID_ANGLE)),
    derivation("refraction", "Snell's law squeezes a bundle: n² cos θ dω is the same on both sides", || {
        refraction((N_1 / N_2).pow(2))
    })
    .slip("n for n²", || refraction(N_1 / N_2)),
    derivation("brighter", "the same power in a smaller étendue: L/n² is the same on both sides", || {
        brighter((N_2 / N_1).pow(2) * RADIANCE_1)
    })
    .slip("radiance held constant through the surface", || brighter(RADIANCE_1.into())),
])
.questions(&[question(
    "twice",
    "You walk back from a lamp until it is twice as far. How many times darker is a pixel that still lies wholly \
             inside its picture?",
    Answer::Number {
        unit: "1",
        tolerance: 0.01,
        right: |_| radiance(1.0, 10.0) / radiance(1.0, 20.0),
        slips: &[
            Misled {
                value: |_| 4.0,
                reply: "So the whole lamp gets darker; but its picture is four times smaller as well.",
            },
            Misled {
                value: |_| 2.0,
                reply: "Nothing falls as 1/r here: the flow falls as 1/r², the picture's area too.",
            },
        ],
    },
    "The same: what the pixel takes in falls as 1/r² from each point, and it sees r² times more points.",
)])
.readout(|setting| {
    let n = setting.number("n");
    let quantity = |key, symbol, says, value| Quantity { key, symbol, says, value, unit: "1" };
    vec![
        quantity("inside", "L_2/L_1", "radiance behind the interface, over that before it", n * n),
        quantity("cone", "sin θ_c", "sine of half the opening of the cone into which a whole sky is squeezed", 1.0 / n),
    ]
})
.checks(&[&DISTANCES, &LENS, &INTERFACE]);

fn both_ends(last: Expr) -> Chain {
    let seen = || AREA_2 * cos(THETA_2) / RADIUS.pow(2);
    Chain::new(RADIANCE * AREA * cos(THETA) * seen())
        .because("L dA cos θ dω, and dω is what the far surface takes of the near one's view")
        .given(SOLID_ANGLE, AREA * cos(THETA) / RADIUS.pow(2), "dω′ of the near surface")
        .then(last, ["dω′ of the near surface"])
}

/// cos θ dω = ½ d(sin² θ) dφ, and the azimuth is the same on both sides: what remains of it, twice.
fn bundle(angle: Symbol) -> Expr {
    partial(sin(angle).pow(2), THETA)
}

fn refraction(last: Expr) -> Chain {
    Chain::new(bundle(THETA_2) / bundle(THETA))
        .because("cos θ′ dω′ over cos θ dω, since cos θ dω = ½ d(sin² θ) dφ")
        .given(sin(THETA_2), N_1 * sin(THETA) / N_2, "Snell")
        .then(last, ["Snell"])
}

fn brighter(last: Expr) -> Chain {
    Chain::assume(Equation::new(RADIANCE_2 * bundle(THETA_2), RADIANCE_1 * bundle(THETA)), "nothing is lost")
        .given(sin(THETA_2), N_1 * sin(THETA) / N_2, "Snell")
        .solve_for([RADIANCE_2])
        .then(Equation::new(RADIANCE_2, last), ["Snell"])
}

/// The radiance of a round lamp of `radius` and radiance 1 as a detector `away` takes it to be: what arrives over
/// the sum of the cosine over the directions in which the lamp is seen.
fn radiance(radius: f64, away: f64) -> f64 {
    let arrives = Disc { radius, height: away, offset: 0.0, tilt: 0.0 }.irradiance().unwrap_or(f64::NAN);
    arrives / gauss(4, away / radius.hypot(away), 1.0, |cos| 2.0 * PI * cos)
}

const DISTANCES: Check<fn(f64) -> f64> = check(
    "distances",
    "what a pixel takes in over its own étendue does not depend on how far the lamp is",
)
.against("the radiance that the lamp was given, against closed forms of what a small square of it sends to the pixel")
.within(
    1e-6,
    "1",
    "the square is a thousandth as wide as it is far: its corners' cosines differ from the middle's by a part in \
             10⁶ over 6, twice",
)
.of(pixels, |distance| distance * distance)
.slip("radiance taken to fall as 1/r²", |_| 1.0);

fn pixels(_: &mut Bench, growth: fn(f64) -> f64) -> Measured {
    Measured::worst([1.0, 3.0, 10.0, 1e3, 1e6].map(|distance: f64| {
        // A pixel sees a square of the lamp as wide as its angle is at that distance.
        let half = 0.5e-3 * distance;
        let corners =
            [[-half, -half, distance], [half, -half, distance], [half, half, distance], [-half, half, distance]];
        let arrives = light::radiometry::polygon::irradiance(&corners, [0.0, 0.0, 1.0]).unwrap_or(f64::NAN);
        let etendue = (2.0 * half).powi(2) / growth(distance);
        (arrives / etendue - 1.0, format!("{distance:e} m away"))
    }))
}

/// Place and direction across the axis as numbers: x, y, and the direction's parts along them times the index.
fn coordinates((place, way): Ray, n: f64) -> [f64; 4] {
    [place.x, place.y, n * way.x, n * way.y]
}

/// The ray of such numbers at the plane z.
fn ray([x, y, p, q]: [f64; 4], z: f64, n: f64) -> Ray {
    let (p, q) = (p / n, q / n);
    (DVec3::new(x, y, z), DVec3::new(p, q, (1.0 - p * p - q * q).sqrt()))
}

/// The determinant of how a `map` stretches small boxes about `at`, by central differences of five points.
fn stretch(at: [f64; 4], map: impl Fn([f64; 4]) -> [f64; 4]) -> f64 {
    const STEP: f64 = 1e-3;
    let column = |axis: usize| {
        let moved = |steps: f64| {
            let mut there = at;
            there[axis] += steps * STEP;
            map(there)
        };
        let [b, a, c, d] = [moved(-2.0), moved(-1.0), moved(1.0), moved(2.0)];
        std::array::from_fn::<f64, 4, _>(|row| (8.0 * (c[row] - a[row]) - (d[row] - b[row])) / (12.0 * STEP))
    };
    let [a, b, c, d] = [0, 1, 2, 3].map(column);
    glam::DMat4::from_cols(a.into(), b.into(), c.into(), d.into()).determinant().abs()
}

const LENS: Check<fn(f64) -> f64> =
    check("lens", "a ball lens changes places and directions, but not the étendue dx dy dp dq of a bundle")
        .against(
            "Liouville's theorem: the determinant is 1, of rays traced by Snell's law, near the axis and far from it",
        )
        .within(
            1e-8,
            "1",
            "differences of the fourth order, 10⁻³ apart: (10⁻³)⁴/30 times derivatives up to 10⁴, and rounding",
        )
        .of(lens, |n| n)
        .slip("p without the index at the plane inside", |_| 1.0);

/// Étendue from a plane before a ball of glass to one behind it, and to one in its middle.
fn lens(bench: &mut Bench, index: fn(f64) -> f64) -> Measured {
    let n = 1.5;
    let mut even = |size: f64| uniform(&mut bench.stream, -size, size);
    let rays: Vec<[f64; 4]> = (0..40).map(|_| [even(0.4), even(0.4), even(0.1), even(0.1)]).collect();
    Measured::worst(rays.into_iter().flat_map(|at| {
        let lost = [f64::NAN; 4];
        let behind =
            stretch(at, |at| ball::through(ray(at, -2.0, 1.0), n, 2.0).map_or(lost, |there| coordinates(there, 1.0)));
        let inside = stretch(at, |at| {
            ball::entering(ray(at, -2.0, 1.0), n).map_or(lost, |there| coordinates(onward(there, 0.0), index(n)))
        });
        let place = format!("x = {:.2}, y = {:.2}, p = {:.2}, q = {:.2}", at[0], at[1], at[2], at[3]);
        [(behind - 1.0, format!("behind the ball, {place}")), (inside - 1.0, format!("in its middle, {place}"))]
    }))
}

const INTERFACE: Check<fn(f64) -> f64> =
    check("interface", "the sky, squeezed by refraction into a cone, still fills the étendue π")
        .against(
            "n² times the projected solid angle of the cone of sin θ = 1/n, whose rim is a ray that grazes the surface",
        )
        .within(1e-12, "1", "a dozen roundings; the grazing ray comes 10⁻¹³ short of the rim")
        .of(squeezed, |n| n * n)
        .slip("n for n²", |n| n);

fn squeezed(_: &mut Bench, factor: fn(f64) -> f64) -> Measured {
    Measured::worst([1.1, 1.33, 1.5, 2.4, 4.0].map(|n: f64| {
        let grazing = DVec3::new(1.0, 0.0, -1e-13).normalize();
        let rim = refracted(grazing.to_array(), [0.0, 0.0, 1.0], 1.0, n).map_or(f64::NAN, |way| way[0].hypot(way[1]));
        (factor(n) * rim * rim - 1.0, format!("n = {n}"))
    }))
}

fn distance(_: &Setting) -> Plot {
    let distances = || (0..=80).map(|step| 10f64.powf(f64::from(step) / 40.0));
    let arrives =
        |away: f64| Disc { radius: 1.0, height: away, offset: 0.0, tilt: 0.0 }.irradiance().unwrap_or(f64::NAN) / PI;
    let chart =
        Chart::new("", Axis::log("distance over the lamp's radius", ""), Axis::log("over the value at the lamp", ""))
            .line(Hue::Ours, "radiance L", distances().map(|x| [x, radiance(1.0, x)]).collect())
            .line(Hue::P, "irradiance E", distances().map(|x| [x, arrives(x)]).collect())
            .dashed(Hue::Reference, "1/r²", distances().map(|x| [x, x.powi(-2)]).collect());
    Plot::of("What fades and what does not", chart)
}

/// The rim of a bundle at four planes: where it starts, later, before and behind a ball of glass.
fn sheared(setting: &Setting) -> Plot {
    let n = setting.number("n");
    let rim = |at: i32| {
        let (sin, cos) = (2.0 * PI * f64::from(at) / 120.0).sin_cos();
        [0.1 * cos, 0.0, 0.12 * sin, 0.0]
    };
    let start: Vec<[f64; 4]> = (0..=120).map(rim).collect();
    let (before, behind) = (-1.6, 2.4);
    let free = |at: [f64; 4], to: f64| coordinates(onward(ray(at, -3.0, 1.0), to), 1.0);
    let glass = |at: [f64; 4], to: f64| {
        ball::through(ray(at, -3.0, 1.0), n, to).map_or([f64::NAN; 4], |found| coordinates(found, 1.0))
    };
    let curve = |map: &dyn Fn([f64; 4]) -> [f64; 4]| -> Vec<[f64; 2]> {
        start.iter().map(|at| map(*at)).map(|at| [at[0], at[2]]).collect()
    };
    let line = |hue, label: &str, points| Mark::Line { label: label.into(), hue, dash: Dash::Solid, points };
    let chart =
        Chart::new("", Axis::linear("place x over the ball's radius", ""), Axis::linear("direction p = sin θ", ""))
            .with(line(Hue::Nth(0), "at the start", curve(&|at| at)))
            .with(line(Hue::Nth(1), "later, in free space", curve(&|at| free(at, before))))
            .with(line(Hue::Nth(2), "behind the ball", curve(&|at| glass(at, 1.1))))
            .with(line(Hue::Nth(3), "later still", curve(&|at| glass(at, behind))));
    Plot::of(format!("A bundle of rays through a ball of n = {n}"), chart)
}
