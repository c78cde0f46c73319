//! E32 for the lamps that people build: closed forms for discs, rectangles, polygons and spheres.

use super::extremes;
use super::symbols::{ALPHA, DISTANCE, HEIGHT, IRRADIANCE, NORMAL, OMEGA, RADIANCE, RADIUS_OF, THETA};
use crate::diagram::{Diagram, Part};
use crate::figure::{Axis, Chart, Dash, Hue, Plot};
use crate::parameter::{Kind, Parameter, Setting};
use crate::symbols::R;
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Quantity, Step, check, choice, derivation, exhibit, figure, question,
    statement, step, stress,
};
use equation::derivation::Chain;
use equation::expr::{atan, cos, cross, curl, dot, integral_between, partial, pi, ratio, sin, sqrt};
use equation::{Dimension, Equation, Expr, Symbol};
use glam::DVec3;
use light::radiometry::disc::Disc;
use light::radiometry::sphere::Sphere;
use light::radiometry::{form_factor, polygon, rectangle};
use std::f64::consts::{FRAC_PI_2, PI};
use yardstick::quadrature::gauss_legendre;
use yardstick::random::{Stream, uniform};

/// Radius of the disc.
const SIZE: Parameter = Parameter::new("R", "R", "radius of the disc", Kind::number(1e-3, 1e3, "m")).default("1");
/// Height of its plane.
const PLANE: Parameter = Parameter::new("h", "h", "height of its plane", Kind::number(1e-3, 1e3, "m")).default("0.6");
/// How far it is aside.
const ASIDE: Parameter =
    Parameter::new("a", "a", "how far its centre is aside", Kind::number(-1e3, 1e3, "m")).default("0.5");
/// How the receiver is tilted.
const TILT: Parameter = Parameter::new(
    "tau",
    "τ",
    "tilt of the receiver, towards the lamp's side if positive",
    Kind::number(-PI, PI, "rad"),
)
.default("75deg");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "shapes",
    &[SIZE, PLANE, ASIDE, TILT],
    &[
        figure("horizon", "A receiver turns under a disc: first it sees all of it, then its horizon cuts it.", horizon),
        figure(
            "edges",
            "A polygon over the floor: to each edge belongs a vector across its triangle, as long as half its angle; their \
             sum's part along n is what arrives.",
            edges,
        ),
        figure(
            "digits",
            "Digits that the printed forms keep and that the program keeps, from a millionth of the size to a million times it.",
            extremes::digits_kept,
        ),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Lamps of every shape",
    "Only a lamp's rim counts, and so its light has a closed form: for discs, spheres and whatever has straight edges.",
)
.rows(&["E32"])
.statements(&[
    statement("lambert", "a triangle: each edge's angle γ, times the unit vector u across it", || {
        let edge = |(gamma, u): (Symbol, Symbol)| gamma * dot(NORMAL, u);
        let [first, second, third] = EDGES;
        Equation::new(IRRADIANCE, ratio(1, 2) * RADIANCE * (edge(first) + edge(second) + edge(third)))
    }),
    statement("disc", "a disc of radius R over the receiver at height h", || {
        Equation::new(IRRADIANCE, pi() * RADIANCE * RADIUS_OF.pow(2) / (RADIUS_OF.pow(2) + HEIGHT.pow(2)))
    }),
    statement("sphere", "a sphere at the distance d, wholly above the horizon", || {
        Equation::new(IRRADIANCE, pi() * RADIANCE * (RADIUS_OF / DISTANCE).pow(2) * cos(OMEGA))
    }),
    statement("corner", "a rectangle a × b with a corner over the receiver at height h", || {
        let part = |a: Symbol, b: Symbol| {
            let slant = sqrt(a.pow(2) + HEIGHT.pow(2));
            a / &slant * atan(b / slant)
        };
        Equation::new(IRRADIANCE, ratio(1, 2) * RADIANCE * (part(SIDE_A, SIDE_B) + part(SIDE_B, SIDE_A)))
    }),
])
.derivations(&[
    derivation("stokes", "what a surface contributes is the curl of something: its rim alone counts", || {
        stokes(2 * dot(NORMAL, R) * R / dot(R, R).pow(2))
    })
    .slip("a rim's field that falls as 1/r, not 1/r²", || stokes(dot(NORMAL, R) * R / dot(R, R).pow(2))),
    derivation(
        "edge",
        "along a straight edge, p away at its nearest, that sum grows as the angle under which it is seen",
        || edge(NEAREST / (NEAREST.pow(2) + ALONG.pow(2))),
    )
    .slip("the sine of the angle for the angle", || edge(NEAREST.pow(2) / sqrt(NEAREST.pow(2) + ALONG.pow(2)).pow(3))),
    derivation("rings", "a round lamp over the receiver: rings of the sky up to its rim at α", || {
        rings_up_to(pi() * RADIANCE * sin(ALPHA).pow(2))
    })
    .slip("the solid angle of the cone", || rings_up_to(2 * pi() * RADIANCE * (1 - cos(ALPHA)))),
    derivation("disc_from_rings", "a disc's rim", || {
        disc(pi() * RADIANCE * RADIUS_OF.pow(2) / (RADIUS_OF.pow(2) + HEIGHT.pow(2)))
    })
    .slip("the rim's tangent for its sine", || disc(pi() * RADIANCE * (RADIUS_OF / HEIGHT).pow(2))),
    derivation("sphere_from_cone", "a sphere's rim is where a tangent touches it; a tilt takes a cosine", || {
        sphere(pi() * RADIANCE * (RADIUS_OF / DISTANCE).pow(2) * cos(OMEGA))
    })
    .slip("the tangent of the rim for its sine", || {
        let tangent2 = RADIUS_OF.pow(2) / (DISTANCE.pow(2) - RADIUS_OF.pow(2));
        sphere(pi() * RADIANCE * tangent2 * cos(OMEGA))
    }),
])
.questions(&[question(
    "below",
    "Half of a glowing ball is below the horizon: its centre lies exactly on it. What arrives on the ground?",
    Answer::Choice {
        options: &[
            choice(
                "nothing, as cos ω = 0",
                "The formula πL(R/d)² cos ω holds only for balls wholly above the horizon.",
            ),
            choice("less than half of what the whole ball would send", ""),
            choice(
                "half of what the ball sends from the zenith",
                "What comes from low down arrives slantwise: it is far less than half.",
            ),
        ],
        right: |_| {
            let from = |omega: f64| Sphere { radius: 1.0, distance: 2.0, omega }.irradiance().unwrap_or(f64::NAN);
            let share = from(FRAC_PI_2) / from(0.0);
            if share <= 0.0 {
                0
            } else if share < 0.49 {
                1
            } else {
                2
            }
        },
        slip: |_| 0,
    },
    "Its upper half is above the horizon and does arrive, at small angles: of a ball whose centre is two radii away, a ninth or so.",
)])
.readout(|setting| {
    let disc = lamp(setting);
    let facing = Disc { tilt: 0.0, ..disc };
    let quantity = |key, symbol, says, value, unit| Quantity { key, symbol, says, value, unit };
    vec![
        quantity("E", "E/L", "from the disc, over its radiance", arrives(disc), "sr"),
        quantity("E_parallel", "E_∥/L", "on a receiver that is not tilted", arrives(facing), "sr"),
        quantity("share", "E/πL", "of what a whole sky of it would send", arrives(disc) / PI, "1"),
    ]
})
.checks(&[&ON_AXIS, &DISC, &SPHERE, &POLYGON, &CORNER, &FACTORS])
.stress(&[
    stress("discs", "discs near, far, beside the axis and cut by the horizon keep their digits", |_| extremes::discs())
        .textbook("Foote's form of 1915; cut by the horizon the plain antiderivative of the arc")
        .against("contour integrals in 512 bits and more"),
    stress("spheres", "spheres that almost touch, and those almost below the horizon, keep theirs", |_| {
        extremes::spheres()
    })
    .textbook("the form of Lagarde and de Rousiers (2014)")
    .against("Snyder's form in 512 bits and more"),
    stress("polygons", "polygons far away, edge-on and on the horizon keep theirs", |_| extremes::polygons())
        .textbook("Lambert's sum with arc cosines")
        .against("Lambert's sum in 512 bits and more"),
    stress("catalogue", "upright corners and form factors from a millionth to a million of the distance", |_| {
        extremes::factors()
    })
    .textbook("Howell's catalogue as printed")
    .against("the same in 512 bits and more"),
]);

/// A triangle's edges: their angles, and the unit vectors across them.
const EDGES: [(Symbol, Symbol); 3] = [
    (Symbol::scalar("gamma_1", Dimension::ONE).real(0.2, 1.0), Symbol::vector("u_1", Dimension::ONE)),
    (Symbol::scalar("gamma_2", Dimension::ONE).real(0.2, 1.0), Symbol::vector("u_2", Dimension::ONE)),
    (Symbol::scalar("gamma_3", Dimension::ONE).real(0.2, 1.0), Symbol::vector("u_3", Dimension::ONE)),
];
/// Sides of a rectangle.
const SIDE_A: Symbol = Symbol::scalar("a", Dimension::METRE).real(0.5, 2.0);
const SIDE_B: Symbol = Symbol::scalar("b", Dimension::METRE).real(0.5, 2.0);
/// How near an edge's line comes.
const NEAREST: Symbol = Symbol::scalar("p", Dimension::METRE).real(0.5, 2.0);
/// Place along an edge, from its nearest point.
const ALONG: Symbol = Symbol::scalar("s", Dimension::METRE).real(0.5, 2.0);
fn stokes(last: Expr) -> Chain {
    Chain::new(curl(cross(NORMAL, R) / dot(R, R)))
        .because("half of this, through the surface, is what arrives: Stokes makes it a sum over the rim")
        .then(last, ["∇×(n×r f) = n(2f + rf′) − (n·r) r f′/r"])
}

fn edge(last: Expr) -> Chain {
    Chain::new(partial(atan(ALONG / NEAREST), ALONG))
        .because("the rim's field along an edge is p/(p² + s²): n×r·dr = −n·u p ds, over r² = p² + s²")
        .then(last, ["∂ atan x = 1/(1 + x²)"])
}

fn rings_up_to(last: Expr) -> Chain {
    Chain::new(integral_between(2 * pi() * RADIANCE * cos(THETA) * sin(THETA), THETA, 0, ALPHA))
        .because("rings of the sky, each 2π sin θ dθ")
        .primitive(pi() * RADIANCE * sin(THETA).pow(2), THETA)
        .then(last, ["∂ sin² θ = 2 sin θ cos θ"])
}

fn disc(last: Expr) -> Chain {
    Chain::new(pi() * RADIANCE * sin(ALPHA).pow(2))
        .because("rings of the sky up to the rim")
        .given(sin(ALPHA), RADIUS_OF / sqrt(RADIUS_OF.pow(2) + HEIGHT.pow(2)), "the rim")
        .then(last, ["the rim"])
}

fn sphere(last: Expr) -> Chain {
    Chain::new(pi() * RADIANCE * sin(ALPHA).pow(2) * cos(OMEGA))
        .because("the cone's light as a vector along its axis, and its part along the receiver's normal")
        .given(sin(ALPHA), RADIUS_OF / DISTANCE, "a tangent to the sphere")
        .then(last, ["a tangent to the sphere"])
}

fn lamp(setting: &Setting) -> Disc {
    let [radius, height, offset, tilt] = ["R", "h", "a", "tau"].map(|name| setting.number(name));
    Disc { radius, height, offset, tilt }
}

fn arrives(disc: Disc) -> f64 {
    disc.irradiance().unwrap_or(f64::NAN)
}

/// Why sums over lamps are good to 1e−9.
const OVER_THE_LAMP: &str = "Gauss's rule of 48 points each way or more over the part above the horizon, mapped so that the integrand is analytic, for \
     lamps that are at most 8 times as wide as they are far";

const DISC: Check<fn(Disc) -> f64> = check(
    "disc_by_strips",
    "discs beside the axis, tilted, cut by the horizon: the closed form is the sum over the lamp",
)
.against("∫ cos θ cos θ′/r² dA over the part above the horizon, by a product of two rules")
.within(1e-9, "1", OVER_THE_LAMP)
.of(discs, arrives)
.slip("the tilt taken for a cosine on all of it", |disc| arrives(Disc { tilt: 0.0, ..disc }) * disc.tilt.cos());

fn discs(_: &mut Bench, form: fn(Disc) -> f64) -> Measured {
    let tilts = [0.0, 0.5, 1.2, FRAC_PI_2, 2.0, -0.8];
    let places = [(1.0, 1.0, 0.0), (1.0, 0.3, 0.4), (1.0, 0.25, 1.5), (0.3, 1.0, -2.0), (1.0, 2.0, 3.0)];
    let cases =
        tilts.into_iter().flat_map(|tilt| places.map(|(radius, height, offset)| Disc { radius, height, offset, tilt }));
    Measured::worst(cases.filter_map(|disc| {
        let exact = strips(disc);
        // Wholly below the horizon there is nothing to compare.
        (exact > 0.0).then(|| (form(disc) / exact - 1.0, format!("{disc:?}")))
    }))
}

const ON_AXIS: Check<fn(f64, f64) -> f64> =
    check("on_axis", "over its middle a disc of radius R at the height h lights the floor with L π R²/(R² + h²)")
        .against("∫ cos θ cos θ′/r² dA over the lamp, by a product of two rules")
        .within(1e-9, "1", OVER_THE_LAMP)
        .of(over_its_middle, |radius, height| arrives(Disc { radius, height, offset: 0.0, tilt: 0.0 }))
        .slip("the solid angle in its place: the receiver's cos θ forgotten", |radius, height| {
            2.0 * PI * (1.0 - height / radius.hypot(height))
        });

/// Radius and height [m] to E/L [sr].
fn over_its_middle(_: &mut Bench, form: fn(f64, f64) -> f64) -> Measured {
    let sizes = [(1.0, 1.0), (1.0, 0.25), (0.1, 2.0), (3.0, 1.0), (1e-3, 0.5)];
    Measured::worst(sizes.map(|(radius, height)| {
        let exact = strips(Disc { radius, height, offset: 0.0, tilt: 0.0 });
        (form(radius, height) / exact - 1.0, format!("R = {radius}, h = {height}"))
    }))
}

/// What arrives from a disc, in strips across it from the horizon on.
fn strips(disc: Disc) -> f64 {
    let Disc { radius, height, offset, tilt } = disc;
    let (sin, cos) = tilt.sin_cos();
    // x sin τ + h cos τ > 0: the lamp's side of the horizon.
    let line = -height * cos / sin;
    let (mut from, mut to) = (offset - radius, offset + radius);
    if sin > 0.0 {
        from = from.max(line);
    } else if sin < 0.0 {
        to = to.min(line);
    }
    if from >= to || (sin == 0.0 && cos <= 0.0) {
        return 0.0;
    }
    let rule = gauss_legendre(96);
    // Sines draw points towards both ends, where the strips' length may have a root.
    let bent = |u: f64| ((PI * (u - 0.5)).sin() + 1.0) / 2.0;
    let slope = |u: f64| (PI * (u - 0.5)).cos() * PI / 2.0;
    let strip = |(u, weight): &(f64, f64)| {
        let x = from + (to - from) * bent(*u);
        let half = ((radius - (x - offset)) * (radius + (x - offset))).max(0.0).sqrt();
        let cell = |(v, share): &(f64, f64)| {
            let square = x * x + height * height + (half * (2.0 * v - 1.0)).powi(2);
            share * height * (x * sin + height * cos) / (square * square)
        };
        weight * slope(*u) * (to - from) * 2.0 * half * rule.iter().map(cell).sum::<f64>()
    };
    rule.iter().map(strip).sum()
}

const SPHERE: Check<fn(Sphere) -> f64> =
    check("sphere_by_rings", "spheres above, on and below the horizon: the closed form is the sum over their cone")
        .against("rings about the cone's axis, each as far as it is above the horizon, by a product of two rules")
        .within(1e-9, "1", OVER_THE_LAMP)
        .of(spheres, |sphere| sphere.irradiance().unwrap_or(f64::NAN))
        .slip("the horizon forgotten: π(R/d)² cos ω as long as that is positive", |sphere| {
            PI * (sphere.radius / sphere.distance).powi(2) * sphere.omega.cos().max(0.0)
        });

fn spheres(_: &mut Bench, form: fn(Sphere) -> f64) -> Measured {
    let shares = [0.02, 0.3, 0.7, 0.97];
    let cases = shares.into_iter().flat_map(|share: f64| {
        let rim = share.asin();
        // Of the cone's half-angle, how far its axis is above the horizon.
        [3.0, 0.9, 0.3, 0.0, -0.3, -0.9].map(|above| Sphere {
            radius: share,
            distance: 1.0,
            omega: (FRAC_PI_2 - above * rim).clamp(0.0, PI),
        })
    });
    Measured::worst(cases.map(|sphere| (form(sphere) / rings(sphere) - 1.0, format!("{sphere:?}"))))
}

/// What arrives from a sphere, ring by ring about the way to its centre.
fn rings(Sphere { radius, distance, omega }: Sphere) -> f64 {
    let (sin, cos) = omega.sin_cos();
    let rim = (radius / distance).asin();
    let rule = gauss_legendre(48);
    let ring = |theta: f64| {
        // cos of the angle to the receiver's normal is A + B cos φ.
        let (middle, swing) = (cos * theta.cos(), sin * theta.sin());
        let end = if middle >= swing { PI } else { (-middle / swing).clamp(-1.0, 1.0).acos() };
        let part = |(u, weight): &(f64, f64)| weight * (middle + swing * (u * end).cos());
        2.0 * end * rule.iter().map(part).sum::<f64>() * theta.sin()
    };
    // Where the horizon begins to cut; rings change there as a power of 3/2.
    let cut = (FRAC_PI_2 - omega).abs().min(rim);
    let inner = if omega < FRAC_PI_2 { rule.iter().map(|(u, weight)| weight * cut * ring(cut * u)).sum() } else { 0.0 };
    let outer: f64 =
        rule.iter().map(|(u, weight)| weight * 2.0 * u * (rim - cut) * ring(cut + (rim - cut) * u * u)).sum();
    inner + outer
}

/// What arrives from a triangle.
type OfTriangle = fn([DVec3; 3], DVec3) -> f64;

const POLYGON: Check<OfTriangle> = check(
    "polygon_by_area",
    "triangles above the horizon and across it: the sum over the rim is the sum over the lamp",
)
.against("∫ cos θ cos θ′/r² dA over the part above the horizon, cut by hand into triangles, by a product of two rules")
.within(1e-9, "1", OVER_THE_LAMP)
.of(triangles, |corners, normal| {
    polygon::irradiance(&corners.map(|corner| corner.to_array()), normal.to_array()).unwrap_or(f64::NAN)
})
.slip("corners below the horizon are pulled up to it", |corners, normal| {
    let pulled = corners.map(|corner| (corner - corner.dot(normal).min(0.0) * normal).to_array());
    // What was pulled is no longer flat: a triangle always is.
    polygon::irradiance(&pulled, normal.to_array()).unwrap_or(f64::NAN)
});

fn triangles(bench: &mut Bench, form: OfTriangle) -> Measured {
    let dice = &mut bench.stream;
    let cases: Vec<([DVec3; 3], DVec3)> = (0..60).map(|at| case(dice, at % 3)).collect();
    Measured::worst(cases.into_iter().map(|(corners, normal)| {
        let exact: f64 = above(corners, normal).into_iter().map(|part| area(part, normal)).sum();
        (form(corners, normal) / exact - 1.0, format!("{corners:.2?}, normal {normal:.2}"))
    }))
}

/// A triangle some way off with `below` of its corners below the horizon.
fn case(dice: &mut Stream, below: usize) -> ([DVec3; 3], DVec3) {
    loop {
        let mut vector = |size: f64| DVec3::from_array([(); 3].map(|()| uniform(dice, -size, size)));
        let (normal, middle) = (vector(1.0).normalize(), vector(1.0).normalize());
        let corners = [vector(0.5), vector(0.5), vector(0.5)].map(|off| middle + off);
        let under = corners.iter().filter(|corner| corner.dot(normal) < 0.0).count();
        let face = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        let distance = (face.normalize().dot(corners[0])).abs();
        let clear = corners.iter().all(|corner| corner.dot(normal).abs() > 0.05);
        if under == below && distance > 0.3 && face.length() > 0.05 && clear {
            return (corners, normal);
        }
    }
}

/// The part of a triangle above the horizon, in triangles.
fn above(corners: [DVec3; 3], normal: DVec3) -> Vec<[DVec3; 3]> {
    let height = |corner: DVec3| corner.dot(normal);
    let cut = |a: DVec3, b: DVec3| a + (b - a) * (height(a) / (height(a) - height(b)));
    let [mut a, mut b, mut c] = corners;
    // Turned until the corner that differs from the others is the first.
    while (height(b) > 0.0) != (height(c) > 0.0) {
        (a, b, c) = (b, c, a);
    }
    let (p, q) = (cut(a, b), cut(a, c));
    match (height(a) > 0.0, height(b) > 0.0) {
        (true, true) => vec![[a, b, c]],
        (true, false) => vec![[a, p, q]],
        (false, true) => vec![[p, b, c], [p, c, q]],
        (false, false) => vec![],
    }
}

/// ∫ cos θ cos θ′/r² dA over a triangle above the horizon, by Gauss's rule in a square folded together at a corner.
fn area([a, b, c]: [DVec3; 3], normal: DVec3) -> f64 {
    let (side, other) = (b - a, c - a);
    let face = side.cross(other);
    let rule = gauss_legendre(48);
    let row = |(u, weight): &(f64, f64)| {
        let cell = |(v, share): &(f64, f64)| {
            let place = a + u * ((1.0 - v) * side + v * other);
            share * place.dot(normal) * place.dot(face).abs() / place.length_squared().powi(2)
        };
        weight * u * rule.iter().map(cell).sum::<f64>()
    };
    rule.iter().map(row).sum()
}

const CORNER: Check<fn([f64; 3]) -> [f64; 3]> =
    check("corners", "a rectangle's corner form is the sum over its rim: facing, upright, and as a solid angle")
        .against("Lambert's sum for its four corners and either normal; two triangles of Van Oosterom and Strackee")
        .within(1e-11, "1", "Lambert's sum cancels to a hundredth at worst here, and rounds a few dozen times")
        .of(corners, |[a, b, h]| {
            rectangle::corner(a, b, h).map_or([f64::NAN; 3], |of| [of.parallel, of.perpendicular, of.solid_angle])
        })
        .slip("the whole rectangle's form for its quarter", |[a, b, h]| {
            rectangle::corner(2.0 * a, 2.0 * b, h)
                .map_or([f64::NAN; 3], |of| [of.parallel, of.perpendicular, of.solid_angle])
        });

fn corners(_: &mut Bench, form: fn([f64; 3]) -> [f64; 3]) -> Measured {
    let sizes = [[1.0, 2.0, 0.5], [0.3, 0.1, 1.0], [5.0, 0.2, 1.0], [1.0, 1.0, 0.1], [0.2, 4.0, 3.0]];
    Measured::worst(sizes.into_iter().flat_map(|[a, b, h]| {
        let corners = [[0.0, 0.0, h], [a, 0.0, h], [a, b, h], [0.0, b, h]];
        let rim = |normal: [f64; 3]| polygon::irradiance(&corners, normal).unwrap_or(f64::NAN);
        let half = |b: [f64; 3], c: [f64; 3]| light::radiometry::solid_angle::triangle(corners[0], b, c).abs();
        let exact =
            [rim([0.0, 0.0, 1.0]), rim([1.0, 0.0, 0.0]), half(corners[1], corners[2]) + half(corners[2], corners[3])];
        let names = ["facing", "upright", "solid angle"];
        let found = form([a, b, h]);
        (0..3).map(move |at| (found[at] / exact[at] - 1.0, format!("{}, a = {a}, b = {b}, h = {h}", names[at])))
    }))
}

/// From what to what a form factor goes: facing rectangles a × b, c apart; rectangles w × l and h × l at a right angle;
/// discs of radii r₁ and r₂, h apart.
type Factors = fn([f64; 3]) -> [f64; 3];

const FACTORS: Check<Factors> =
    check("factors", "form factors are the mean over the one surface of what arrives there from the other, over π")
        .against("closed forms of what arrives at a point, summed over the surface by a product of two rules")
        .within(
            1e-7,
            "1",
            "at the common edge what arrives has a step in its slope: points drawn together there, 80 each way, leave some 10⁻⁸ of it",
        )
        .of(factors, |[a, b, c]| {
            let all = [
                form_factor::parallel_rectangles(a, b, c),
                form_factor::perpendicular_rectangles(a, b, c),
                form_factor::coaxial_discs(a, b, c),
            ];
            all.map(|found| found.unwrap_or(f64::NAN))
        })
        .slip("the way back for the way there", |[a, b, c]| {
            let all = [
                form_factor::parallel_rectangles(a, b, c),
                form_factor::perpendicular_rectangles(b, a, c),
                form_factor::coaxial_discs(b, a, c),
            ];
            all.map(|found| found.unwrap_or(f64::NAN))
        });

fn factors(_: &mut Bench, form: Factors) -> Measured {
    let rule = gauss_legendre(80);
    let over = |f: &dyn Fn(f64, f64) -> f64| -> f64 {
        rule.iter().map(|(u, weight)| weight * rule.iter().map(|(v, share)| share * f(*u, *v)).sum::<f64>()).sum()
    };
    let sizes = [[1.0, 2.0, 0.5], [0.3, 1.0, 1.0], [2.0, 0.7, 1.5]];
    Measured::worst(sizes.into_iter().flat_map(|[a, b, c]| {
        let from = |corners: [[f64; 3]; 4]| polygon::irradiance(&corners, [0.0, 0.0, 1.0]).unwrap_or(f64::NAN) / PI;
        let facing = over(&|u, v| {
            let (x, y) = (u * a, v * b);
            from([[-x, -y, c], [a - x, -y, c], [a - x, b - y, c], [-x, b - y, c]])
        });
        let upright = over(&|u, v| {
            // Sixth powers draw the points to the edge.
            let (x, y) = (a * u.powi(6), c * v);
            6.0 * u.powi(5) * from([[-x, -y, 0.0], [-x, c - y, 0.0], [-x, c - y, b], [-x, -y, b]])
        });
        let round = over(&|u, _| 2.0 * u * arrives(Disc { radius: b, height: c, offset: u * a, tilt: 0.0 }) / PI);
        let (found, exact) = (form([a, b, c]), [facing, upright, round]);
        let names = ["facing rectangles", "rectangles at a right angle", "discs on an axis"];
        (0..3).map(move |at| (found[at] / exact[at] - 1.0, format!("{}, {a}, {b}, {c}", names[at])))
    }))
}

fn horizon(setting: &Setting) -> Plot {
    let disc = lamp(setting);
    let turned = || (-180..=180).map(f64::from);
    let whole = |degrees: f64| {
        let tau = degrees.to_radians();
        let part = |tilt: f64| arrives(Disc { tilt, ..disc });
        // The vector of the whole disc, taken where the horizon does not cut it: facing the lamp's axis and its side.
        let up = part(0.0);
        let aside = vector_aside(disc);
        up * tau.cos() + aside * tau.sin()
    };
    let chart =
        Chart::new("", Axis::linear("tilt τ", "°").range(-180.0, 180.0).tick(60.0), Axis::linear("E / L", "sr"))
            .line(
                Hue::Ours,
                "cut by the horizon",
                turned().map(|x| [x, arrives(Disc { tilt: x.to_radians(), ..disc })]).collect(),
            )
            .dashed(Hue::Textbook, "the horizon forgotten", turned().map(|x| [x, whole(x)]).collect())
            .at_x(disc.tilt.to_degrees(), format!("{:.0}°", disc.tilt.to_degrees()))
            .at_y(0.0, "");
    Plot::of(format!("A disc of radius {} m at height {} m, {} m aside", disc.radius, disc.height, disc.offset), chart)
}

/// The part across its axis of the light of a whole disc [sr], as if no horizon cut it.
fn vector_aside(Disc { radius, height, offset, .. }: Disc) -> f64 {
    let sum = height * height + offset * offset + radius * radius;
    let d = height.hypot(offset - radius) * height.hypot(offset + radius);
    2.0 * PI * (height * radius / d) * (offset * radius / (sum + d))
}

/// A quadrilateral over the floor in an oblique view, with its edges' vectors, and its shadow's shadow in Nusselt's disc.
fn edges(_: &Setting) -> Plot {
    let corners = [[-0.5, 0.3, 0.9], [0.7, -0.2, 1.1], [0.9, 0.8, 1.3], [-0.1, 1.1, 1.1]];
    let flat = plane(corners);
    let view = |v: [f64; 3]| [v[0] + 0.45 * v[1], v[2] + 0.3 * v[1] - 0.05 * v[0]];
    let vectors = polygon::edges(&flat);
    let mut oblique = Diagram::new("", [-1.5, -0.9], [2.1, 2.1])
        .with(
            Part::curve(
                [[-0.9, -0.7], [0.9, -0.7], [0.9, 0.9], [-0.9, 0.9], [-0.9, -0.7]]
                    .map(|[x, y]| view([x, y, 0.0]))
                    .to_vec(),
            )
            .hue(Hue::Reference)
            .label("floor"),
        )
        .with(Part::vector([0.0; 2], view([0.0, 0.0, 0.55])).label("n"));
    let mut disc = Diagram::new("", [-1.25, -1.15], [1.25, 1.15])
        .with(
            Part::curve((0..=120).map(|at| f64::from(at) / 60.0 * PI).map(|t| [t.cos(), t.sin()]).collect())
                .hue(Hue::Reference),
        )
        .with(Part::point([0.0; 2]).label("receiver"));
    for (at, vector) in vectors.iter().enumerate() {
        let (a, b) = (flat[at], flat[(at + 1) % flat.len()]);
        let hue = Hue::Nth(at as u8);
        oblique = oblique
            .with(Part::line([0.0; 2], view(a)).dash(Dash::Dashed).hue(Hue::Reference))
            .with(Part::line(view(a), view(b)).hue(hue))
            .with(Part::vector([0.0; 2], view(vector.map(|part| 1.6 * part))).hue(hue).label(format!("Γ_{}", at + 1)));
        let (a, b) = (DVec3::from_array(a), DVec3::from_array(b));
        let arc =
            (0..=40).map(|step| a.lerp(b, f64::from(step) / 40.0).normalize()).map(|way| [way.x, way.y]).collect();
        disc = disc
            .with(Part::curve(arc).hue(hue).label(format!("{}", at + 1)))
            .with(Part::line([0.0; 2], a.normalize().truncate().to_array()).dash(Dash::Dashed).hue(Hue::Reference));
    }
    let found = polygon::irradiance(&flat, [0.0, 0.0, 1.0]).unwrap_or(f64::NAN);
    Plot::grid(
        format!("Lambert's edges, and the area that they enclose in Nusselt's disc: E/L = {found:.3} sr"),
        2,
        vec![oblique.into(), disc.into()],
    )
}

/// The last corner moved along z into the plane of the first three.
fn plane(corners: [[f64; 3]; 4]) -> [[f64; 3]; 4] {
    let [a, b, c, d] = corners.map(DVec3::from_array);
    let face = (b - a).cross(c - a);
    let flat = d + DVec3::Z * ((a - d).dot(face) / face.z);
    [a, b, c, flat].map(|corner| corner.to_array())
}
