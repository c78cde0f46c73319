//! E27, E28: the power through a sphere, and the angle that a sphere is.

use super::sums::{
    AXES, KINK, LEBEDEVS, NEAR, PRODUCTS, SMOOTH, STEP as SHADE, by_chance, by_lebedev, by_product, chance,
};
use super::symbols::{ALPHA, AZIMUTH, FLUX, PLACE, RADIUS, S_R, SOLID_ANGLE, THETA};
use crate::diagram::{Diagram, Part, Spot};
use crate::figure::{Dash, Hue, Plot};
use crate::parameter::{Kind, Parameter, Setting};
use crate::symbols::S;
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Misled, Quantity, Race, Step, check, derivation, exhibit, figure, lane,
    question, race, statement, step,
};
use equation::derivation::Chain;
use equation::expr::{Range, cos, cross, d, dot, integral, integral_between, partial, pi, sin, vector};
use equation::{Equation, Expr};
use glam::DVec3;
use light::radiometry::solid_angle::cone as cone_of;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use yardstick::quadrature::{gauss_legendre, trapezoid};
use yardstick::statistics::chi_square;

/// Half the opening of a cone.
pub(super) const HALF_ANGLE: Parameter =
    Parameter::new("alpha", "α", "half the opening of the cone", Kind::number(0.0, PI, "rad")).default("30deg");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "solid_angle",
    &[HALF_ANGLE],
    &[figure("sphere", "Patches of even steps in θ and φ: towards the pole they narrow with sin θ.", sphere)],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "A sphere round the source",
    "A direction is a place on the unit sphere; all of them together make 4π, and the power through all of them is the flux.",
)
.rows(&["E27", "E28"])
.statements(&[
    statement("flux", "all that a source sends out passes a sphere round it", || {
        Equation::new(FLUX, integral(S_R * RADIUS.pow(2) * sin(THETA), [AZIMUTH.into(), THETA.into()], Range::Closed))
    })
    .rows(&["E27"]),
    statement("element", "the solid angle of a patch of directions", || {
        Equation::new(d(SOLID_ANGLE), sin(THETA) * d(AZIMUTH) * d(THETA))
    })
    .rows(&["E28"]),
])
.derivations(&[
    derivation("area", "two steps along the sphere span a patch of r² sin θ dφ dθ that faces outwards", || {
        area(RADIUS.pow(2) * sin(THETA) * outwards())
    })
    .rows(&["E27", "E28"])
    .slip("a degree of longitude taken to be as long everywhere as at the equator", || area(RADIUS.pow(2) * outwards())),
    derivation("through_the_patch", "so the power through it is the radial flow times r² sin θ", || {
        through(S_R * RADIUS.pow(2) * sin(THETA))
    })
    .rows(&["E27"])
    .slip("r for r²", || through(S_R * RADIUS * sin(THETA))),
    derivation("cone", "a cone of half-angle α; with α = π it is everything", || cone(2 * pi() * (1 - cos(ALPHA))))
        .rows(&["E28"])
        .slip("the cone's projection, as if seen from far", || cone(pi() * sin(ALPHA).pow(2))),
])
.questions(&[question(
    "share",
    "Which share of all directions lies within 60° of an axis?",
    Answer::Number {
        unit: "1",
        tolerance: 0.02,
        right: |_| cone_of(PI / 3.0) / (4.0 * PI),
        slips: &[
            Misled {
                value: |_| 1.0 / 3.0,
                reply: "Directions are not spread evenly over the angle: near the axis there are few of them.",
            },
            Misled {
                value: |_| (PI / 3.0).sin().powi(2) / 4.0,
                reply: "That is the cone's cut seen from far, π sin² α: the cap of the sphere is larger.",
            },
        ],
    },
    "The cap's area is 2π(1 − cos α) of 4π.",
)])
.readout(|setting| {
    let alpha = setting.number("alpha");
    let quantity = |key, symbol, says, value, unit| Quantity { key, symbol, says, value, unit };
    vec![
        quantity("Omega", "Ω", "solid angle of the cone", cone_of(alpha), "sr"),
        quantity("share", "Ω/4π", "of all directions", cone_of(alpha) / (4.0 * PI), "1"),
        quantity("projected", "π sin^2 α", "its cut, seen from far", PI * alpha.sin().powi(2), "sr"),
    ]
})
.checks(&[&PATCHES, &ANTENNAS])
.races(&[
    SUMS.named("smooth", "over a smooth pattern Lebedev's rule gains digits with every few points, the product of two rules nearly as fast").lanes(
        &[
            chance(|bench, work| by_chance(bench, work, SMOOTH)),
            lane("product", "Gauss × trapezoid", &[8, 18, 32, 50, 72], |bench, work| by_product(bench, work, SMOOTH))
                .repeated(AXES)
                .converges(1e-8, "exact to degree 11; of e^(2c) 2^12/12!/2^11 ~ 4·10⁻⁹ of the peak is beyond it"),
            lane("lebedev", "Lebedev", &[14, 50, 110], |bench, work| by_lebedev(bench, work, SMOOTH))
                .repeated(AXES)
                .converges(1e-14, "exact to degree 17; of e^(2c) 2^18/18!/2^17 ~ 3·10⁻¹⁶ of the peak is beyond it"),
        ],
    ),
    SUMS.named("kink", "at the horizon of a flat lamp every rule has an order, and no digits to give away").lanes(&[
        chance(|bench, work| by_chance(bench, work, KINK)),
        lane("product", "Gauss × trapezoid", PRODUCTS, |bench, work| by_product(bench, work, KINK))
            .repeated(AXES)
            .order(1.25, 0.25),
        lane("lebedev", "Lebedev", LEBEDEVS, |bench, work| by_lebedev(bench, work, KINK)).repeated(AXES).order(1.25, 0.25),
    ]),
    SUMS.named("step", "at the edge of a shade rules are hardly better than chance").lanes(&[
        chance(|bench, work| by_chance(bench, work, SHADE)),
        lane("product", "Gauss × trapezoid", PRODUCTS, |bench, work| by_product(bench, work, SHADE))
            .repeated(AXES)
            .order(0.75, 0.25),
        lane("lebedev", "Lebedev", LEBEDEVS, |bench, work| by_lebedev(bench, work, SHADE)).repeated(AXES).order(0.75, 0.25),
    ]),
    SUMS.named("near", "a lamp close to the sphere's wall: digits come slowly, but they come").lanes(&[
        chance(|bench, work| by_chance(bench, work, NEAR)),
        lane("product", "Gauss × trapezoid", &[128, 288, 578, 1152, 2048], |bench, work| by_product(bench, work, NEAR))
            .repeated(AXES)
            .converges(1e-4, "the pole at 1.01 leaves ρ^−64 of degree 63, ρ = 1.152, and that is 10⁻⁴"),
        lane("lebedev", "Lebedev", &[110, 194, 434, 770, 1202, 1730], |bench, work| by_lebedev(bench, work, NEAR))
            .repeated(AXES)
            .converges(1e-4, "ρ^−72 of degree 71, 4·10⁻⁵"),
    ]),
]);

/// The unit vector in the direction (θ, φ).
fn outwards() -> Expr {
    vector(sin(THETA) * cos(AZIMUTH), sin(THETA) * sin(AZIMUTH), cos(THETA))
}

fn area(last: Expr) -> Chain {
    Chain::new(cross(partial(PLACE, THETA), partial(PLACE, AZIMUTH)))
        .because("the sides of the patch are the steps that θ and φ make")
        .given(PLACE, RADIUS * outwards(), "a place on the sphere")
        .then(last, ["∂/∂θ, ∂/∂φ", "sin² + cos² = 1"])
}

fn through(last: Expr) -> Chain {
    Chain::new(dot(S, cross(partial(PLACE, THETA), partial(PLACE, AZIMUTH))))
        .given(PLACE, RADIUS * outwards(), "a place on the sphere")
        .given(S, S_R * outwards(), "the flow far out is radial")
        .then(last, ["∂/∂θ, ∂/∂φ", "sin² + cos² = 1"])
}

fn cone(last: Expr) -> Chain {
    let rings = |to: Expr| integral_between(2 * pi() * sin(THETA), THETA, 0, to);
    Chain::new(rings(ALPHA.into()))
        .because("rings of directions, each 2π sin θ dθ")
        .primitive(-2 * pi() * cos(THETA), THETA)
        .then(last, ["∫ sin θ dθ = −cos θ"])
        .then(Equation::new(rings(pi()), 4 * pi()), ["cos π = −1"])
}

/// E27 as a sum, whatever is summed.
const SUMS: Race = race("", "")
    .rows(&["E27"])
    .work("directions")
    .error("relative error of the flux", "rms over 24 axes of the relative error, against the closed form");

const PATCHES: Check<fn(f64, f64) -> f64> =
    check("patches", "random directions fall into patches as sin θ dφ dθ has it")
        .rows(&["E28"])
        .against("directions of triples of numbers of Gauss's distribution, which prefer none")
        .significant(1e-3)
        .of(counted, |from, to| (from.cos() - to.cos()) / 2.0)
        .slip("rings of even width are taken to be alike, sin θ forgotten", |from, to| (to - from) / PI);

/// Rings of a sphere, each of so many patches.
const RINGS: usize = 18;
const PATCHES_OF_A_RING: usize = 12;
/// Directions drawn.
const DRAWN: usize = 100_000;

fn counted(bench: &mut Bench, ring: fn(f64, f64) -> f64) -> Measured {
    let edge = |at: usize| at as f64 / RINGS as f64 * PI;
    let share = |at: usize| ring(edge(at), edge(at + 1)) / PATCHES_OF_A_RING as f64;
    let expected: Vec<f64> = (0..RINGS).flat_map(|at| [DRAWN as f64 * share(at); PATCHES_OF_A_RING]).collect();
    let mut observed = vec![0; expected.len()];
    for _ in 0..DRAWN {
        let way = gaussian(&mut bench.stream);
        let theta = (way.x.hypot(way.y)).atan2(way.z);
        let phi = way.y.atan2(way.x) / TAU + 0.5;
        let ring = ((theta / PI * RINGS as f64) as usize).min(RINGS - 1);
        let patch = ((phi * PATCHES_OF_A_RING as f64) as usize).min(PATCHES_OF_A_RING - 1);
        observed[ring * PATCHES_OF_A_RING + patch] += 1;
    }
    let test = chi_square(&observed, &expected);
    Measured::new(test.p, format!("χ² = {:.1}, {} degrees of freedom", test.statistic, test.dof), DRAWN)
}

/// Three numbers of Gauss's distribution (G. E. P. Box and M. E. Muller, 1958): their direction is as likely as any, by
/// the symmetry of e^(−r²/2) alone and without a word about sines.
fn gaussian(stream: &mut yardstick::random::Stream) -> DVec3 {
    let mut even = || 1.0 - yardstick::random::uniform(stream, 0.0, 1.0);
    let mut pair = || {
        let (radius, turn) = ((-2.0 * even().ln()).sqrt(), TAU * even());
        [radius * turn.cos(), radius * turn.sin()]
    };
    let ([x, y], [z, _]) = (pair(), pair());
    DVec3::new(x, y, z)
}

const ANTENNAS: Check<fn(f64) -> f64> = check(
    "antennas",
    "the flow of two antennas in step, summed over θ and φ, is what their mutual resistance says",
)
.rows(&["E27"])
.against(
    "1 + (3/2)(sin x/x + cos x/x² − sin x/x³), x = kd, the resistance that short antennas side by side put on each \
             other (C. A. Balanis, *Antenna Theory*, §8.6, for short ones)",
)
.within(
    1e-12,
    "1",
    "sums of some 10³ terms; the rule is exact to degree 59, and of e^(ix cos γ) with x ≤ 15 what is left is below \
             J₆₀(15) ~ (15/2)⁶⁰/60! ~ 10⁻³⁰",
)
.of(together, f64::sin)
.slip("dφ dθ, the sine forgotten", |_| 2.0 / PI);

fn together(_: &mut Bench, sine: fn(f64) -> f64) -> Measured {
    // θ by Gauss's rule in cos θ would bring the sine with it: here it stands in the sum.
    let (rings, turns) = (gauss_legendre(60), trapezoid(60));
    Measured::worst([0.3, 1.0, 2.5, 5.0, 10.0, 15.0].map(|x: f64| {
        let flow = |theta: f64, phi: f64| {
            let n = DVec3::new(theta.sin() * phi.cos(), theta.sin() * phi.sin(), theta.cos());
            // Both along z, a distance d apart along x: |1 + e^(ikd n_x)|²/2 times the pattern of one.
            (1.0 - n.z * n.z) * (1.0 + (x * n.x).cos())
        };
        let ring = |(u, weight): &(f64, f64)| {
            let theta = PI * u;
            let along: f64 = turns.iter().map(|(v, share)| share * flow(theta, TAU * v)).sum();
            PI * weight * TAU * along * sine(theta)
        };
        let total: f64 = rings.iter().map(ring).sum();
        let mutual = 1.5 * (x.sin() / x + x.cos() / x.powi(2) - x.sin() / x.powi(3));
        (total / (8.0 * PI / 3.0) / (1.0 + mutual) - 1.0, format!("kd = {x}"))
    }))
}

/// The sphere from outside, with circles of latitude and longitude, and the cone's rim.
fn sphere(setting: &Setting) -> Plot {
    let alpha = setting.number("alpha");
    let view = View::new(0.5, 0.9);
    let curve = |points: Vec<DVec3>, hue: Hue| view.front(points).into_iter().map(move |run| Part::curve(run).hue(hue));
    let arc = |count: i32, place: &dyn Fn(f64) -> DVec3| -> Vec<DVec3> {
        (0..=count).map(|at| place(f64::from(at) / f64::from(count))).collect()
    };
    let mut diagram = Diagram::new("", [-1.7, -1.1], [1.7, 1.1]);
    for step in 1..12 {
        let theta = PI * f64::from(step) / 12.0;
        diagram = diagram.with_all(curve(arc(180, &|t| outward(theta, TAU * t)), Hue::Reference));
    }
    for step in 0..24 {
        let phi = TAU * f64::from(step) / 24.0;
        diagram = diagram.with_all(curve(arc(90, &|t| outward(PI * t, phi)), Hue::Reference));
    }
    let outline = (0..=120).map(|at| TAU * f64::from(at) / 120.0).map(|t| [t.cos(), t.sin()]).collect();
    let [theta, phi] = [PI / 12.0 * 5.0, TAU / 24.0];
    let (next, on) = (theta + PI / 12.0, phi + TAU / 24.0);
    let patch = [
        arc(20, &|t| outward(theta + t * (next - theta), phi)),
        arc(20, &|t| outward(next, phi + t * (on - phi))),
        arc(20, &|t| outward(next + t * (theta - next), on)),
        arc(20, &|t| outward(theta, on + t * (phi - on))),
    ];
    let diagram = diagram
        .with(Part::curve(outline).hue(Hue::Reference))
        .with_all(curve(arc(360, &|t| outward(alpha, TAU * t)), Hue::Ours))
        .with_all(curve(patch.concat(), Hue::P))
        .with_all(view.front(vec![DVec3::Z]).into_iter().flatten().map(|at| Part::point(at).hue(Hue::S)))
        .explain(Hue::Ours, Dash::Solid, "the cone's rim")
        .explain(Hue::P, Dash::Solid, "a patch sin θ dφ dθ");
    let share = 100.0 * cone_of(alpha) / (4.0 * PI);
    Plot::of(format!("α = {:.0}°: {share:.1} % of the sphere", alpha.to_degrees()), diagram)
}

/// The unit vector at θ and φ.
fn outward(theta: f64, phi: f64) -> DVec3 {
    DVec3::new(theta.sin() * phi.cos(), theta.sin() * phi.sin(), theta.cos())
}

/// A sphere seen from far, from a direction.
struct View {
    right: DVec3,
    up: DVec3,
    eye: DVec3,
}

impl View {
    /// From a height above the equator and an azimuth [rad].
    fn new(height: f64, azimuth: f64) -> Self {
        let eye = outward(FRAC_PI_2 - height, azimuth);
        let right = DVec3::Z.cross(eye).normalize();
        Self { right, up: eye.cross(right), eye }
    }

    /// The runs of places of the unit sphere that are seen; those behind it are not.
    fn front(&self, places: Vec<DVec3>) -> Vec<Vec<Spot>> {
        let is_seen = |place: &DVec3| place.dot(self.eye) >= -1e-9;
        let runs = places.chunk_by(|one, next| is_seen(one) == is_seen(next)).filter(|run| is_seen(&run[0]));
        runs.map(|run| run.iter().map(|place| [place.dot(self.right), place.dot(self.up)]).collect()).collect()
    }
}
