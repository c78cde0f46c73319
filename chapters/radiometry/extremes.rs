//! Lamps at the extremes: far and near, edge-on, on the horizon.

use crate::figure::{Axis, Chart, Hue, Mark, Plot, Shape};
use crate::parameter::Setting;
use crate::vocabulary::{Extreme, digits};
use light::radiometry::disc::Disc;
use light::radiometry::sphere::Sphere;
use light::radiometry::{form_factor, polygon, rectangle, textbook};
use light::references::radiometry::{self as exact, Exact};
use std::f64::consts::{FRAC_PI_2, PI};
use yardstick::precise;

fn case(input: String, quantity: &'static str, reference: Exact, textbook: f64, ours: f64) -> Extreme {
    Extreme { input, quantity, reference: reference.value, textbook, ours, condition: reference.condition, worst_of: 1 }
}

/// Distances over the size of the lamp.
const FAR: [f64; 7] = [1e-6, 1e-3, 0.1, 1.0, 30.0, 1e4, 1e6];

/// Discs over the receiver, beside it and under its horizon.
pub(super) fn discs() -> Vec<Extreme> {
    let facing = FAR.into_iter().flat_map(|height| {
        [0.0, 0.7, 0.999_999, 1.000_001, 3.0, 1e6].map(|offset| Disc { radius: 1.0, height, offset, tilt: 0.0 })
    });
    let facing = facing.map(|disc| {
        let Disc { radius, height, offset, tilt } = disc;
        let textbook = textbook::disc(radius, height, offset);
        case(
            format!("R = 1, h = {height:e}, a = {offset}"),
            "E/L",
            exact::disc(radius, height, offset, tilt),
            textbook,
            of_disc(disc),
        )
    });
    let cut = [1e-3, 0.5, 1e3].into_iter().flat_map(|height: f64| {
        // The far rim is a hair above the horizon; and the near one a hair below.
        let rims = [1.0, -1.0].map(|rim| height.atan2(-(0.5 + rim)));
        rims.into_iter().flat_map(move |tilt| {
            [1e-9, 1e-3, 0.1].map(|hair| Disc { radius: 1.0, height, offset: 0.5, tilt: (tilt - hair).abs() })
        })
    });
    let cut = cut.map(|disc| {
        let Disc { radius, height, offset, tilt } = disc;
        let reference = exact::disc(radius, height, offset, tilt);
        case(
            format!("R = 1, h = {height:e}, a = 0.5, τ = {tilt:?}"),
            "E/L",
            reference,
            clipped_plainly(disc),
            of_disc(disc),
        )
    });
    facing.chain(cut).filter(tells).collect()
}

fn of_disc(disc: Disc) -> f64 {
    disc.irradiance().unwrap_or(f64::NAN)
}

/// The arc's integral by its plain antiderivative, and the chord's.
fn clipped_plainly(Disc { radius, height, offset, tilt }: Disc) -> f64 {
    let (sin, cos) = tilt.sin_cos();
    let line = -height * cos / sin;
    let sum = height * height + offset * offset + radius * radius;
    let (a, b) = (cos * radius * radius, cos * offset * radius - sin * height * radius);
    let swing = 2.0 * offset * radius;
    let arc = ((line - offset) / radius).clamp(-1.0, 1.0).acos();
    let root = (sum * sum - swing * swing).sqrt();
    let kernel = 2.0 / root * (((sum - swing) / (sum + swing)).sqrt() * (arc / 2.0).tan()).atan();
    let chord = (radius * radius - (line - offset) * (line - offset)).max(0.0).sqrt();
    b / swing * arc + (a - b * sum / swing) * kernel + (chord * sin / height).atan()
}

/// Where there is something to see, and not nothing to the last digit.
fn tells(case: &Extreme) -> bool {
    precise::to_f64(&case.reference).abs() > f64::MIN_POSITIVE
}

/// Spheres far and near, on the horizon and almost below it.
pub(super) fn spheres() -> Vec<Extreme> {
    let shares = [1e-6, 1e-2, 0.5, 0.9, 1.0 - 1e-6, 1.0 - 1e-12];
    let cases = shares.into_iter().flat_map(|share: f64| {
        let rim = share.asin();
        let high = [0.0, FRAC_PI_2 - rim].map(|omega| omega.max(0.0));
        let low = [0.5, 0.99, 1.0 - 1e-6].map(|above| (FRAC_PI_2 + above * rim).min(PI));
        [high[0], high[1], FRAC_PI_2, low[0], low[1], low[2]].map(|omega| (share, omega))
    });
    cases
        .map(|(share, omega)| {
            let found = Sphere { radius: share, distance: 1.0, omega }.irradiance().unwrap_or(f64::NAN);
            let (reference, textbook) = (exact::sphere(share, 1.0, omega), textbook::sphere(share, 1.0, omega));
            case(format!("R = {share:?}, d = 1, ω = {omega:?}"), "E/L", reference, textbook, found)
        })
        .filter(tells)
        .collect()
}

/// A square of side 1 turned by `turn` about an edge of its own, its middle at a distance along a way of inclination
/// `height` [rad] over the horizon.
fn square(distance: f64, height: f64, turn: f64) -> [[f64; 3]; 4] {
    let (s, c) = height.sin_cos();
    let (t, u) = turn.sin_cos();
    // Across the way, in the horizon; and up the turned square.
    let up = [-s * u + c * t, 0.0, c * u + s * t];
    let corner = |v: f64, w: f64| [distance * c + w * up[0], v, distance * s + w * up[2]];
    [corner(-0.5, -0.5), corner(0.5, -0.5), corner(0.5, 0.5), corner(-0.5, 0.5)]
}

/// Squares far, near, turned edge-on and almost on the horizon.
pub(super) fn polygons() -> Vec<Extreme> {
    let normal = [0.0, 0.0, 1.0];
    let places = [(1e6, 1.0), (1e3, 0.3), (30.0, 0.03), (3.0, 0.2), (1.0, 1.2), (1e4, 1e-4)];
    let cases = places.into_iter().flat_map(|(distance, height)| {
        [0.0, 1.0, FRAC_PI_2 - 1e-6].map(|turn| {
            (format!("{distance:e} sides away, {height} rad up, turned by {turn:.3}"), square(distance, height, turn))
        })
    });
    // A ceiling so near that it fills the sky.
    let ceiling = [1e-3, 1e-6].map(|h| {
        (format!("a ceiling {h:e} over the receiver"), [[-1.0, -1.0, h], [1.0, -1.0, h], [1.0, 1.0, h], [-1.0, 1.0, h]])
    });
    cases
        .chain(ceiling)
        .filter(|(_, corners)| corners.iter().all(|corner| corner[2] > 0.0))
        .map(|(input, corners)| {
            let found = polygon::irradiance(&corners, normal).unwrap_or(f64::NAN);
            case(input, "E/L", exact::polygon(&corners, normal), textbook::polygon(&corners, normal), found)
        })
        .collect()
}

/// Rectangles with a corner over the receiver, and form factors.
pub(super) fn factors() -> Vec<Extreme> {
    let sizes =
        [[1.0, 1.0, 1e-6], [1.0, 2.0, 1e-3], [1.0, 1.0, 1.0], [1.0, 0.5, 1e3], [1.0, 1.0, 1e6], [1e-3, 1.0, 1e3]];
    let each = |[a, b, c]: [f64; 3]| {
        let unless = |found: Result<f64, light::radiometry::Refusal>| found.unwrap_or(f64::NAN);
        let input = format!("{a}, {b}, {c:e}");
        let upright = rectangle::corner(a, b, c).map_or(f64::NAN, |of| of.perpendicular);
        let [_, perpendicular, _] = exact::corner(a, b, c);
        [
            case(
                format!("corner a, b, h = {input}"),
                "E_⊥/L",
                perpendicular,
                textbook::perpendicular_corner(a, b, c),
                upright,
            ),
            case(
                format!("facing a, b, c = {input}"),
                "F",
                exact::parallel_rectangles(a, b, c),
                textbook::parallel_rectangles(a, b, c),
                unless(form_factor::parallel_rectangles(a, b, c)),
            ),
            case(
                format!("upright w, h, l = {input}"),
                "F",
                exact::perpendicular_rectangles(a, b, c),
                textbook::perpendicular_rectangles(a, b, c),
                unless(form_factor::perpendicular_rectangles(a, b, c)),
            ),
            case(
                format!("discs r_1, r_2, h = {input}"),
                "F",
                exact::coaxial_discs(a, b, c),
                textbook::coaxial_discs(a, b, c),
                unless(form_factor::coaxial_discs(a, b, c)),
            ),
        ]
    };
    sizes.into_iter().flat_map(each).collect()
}

/// A distance, the exact value there, the textbook's and the program's.
type Kept = (f64, Exact, f64, f64);

/// Digits kept over the distance, by textbook and program: a disc beside its axis, a sphere of which a quarter of the width is above the horizon, a
/// square turned aside.
pub(super) fn digits_kept(_: &Setting) -> Plot {
    let distances = || (0..=36).map(|step| 10f64.powf(-6.0 + f64::from(step) / 3.0));
    let disc = |distance: f64| {
        let disc = Disc { radius: 1.0, height: distance, offset: 2.0, tilt: 0.0 };
        (exact::disc(1.0, distance, 2.0, 0.0), textbook::disc(1.0, distance, 2.0), of_disc(disc))
    };
    let sphere = |distance: f64| {
        let (distance, rim) = (1.0 + distance, (1.0 / (1.0 + distance)).asin());
        let omega = FRAC_PI_2 + 0.5 * rim;
        let found = Sphere { radius: 1.0, distance, omega }.irradiance().unwrap_or(f64::NAN);
        (exact::sphere(1.0, distance, omega), textbook::sphere(1.0, distance, omega), found)
    };
    let polygon = |distance: f64| {
        let corners = square(distance + 0.6, 1.0, 1.0);
        let found = polygon::irradiance(&corners, [0.0, 0.0, 1.0]).unwrap_or(f64::NAN);
        (exact::polygon(&corners, [0.0, 0.0, 1.0]), textbook::polygon(&corners, [0.0, 0.0, 1.0]), found)
    };
    let panel = |title: &str, of: &dyn Fn(f64) -> (Exact, f64, f64), first: bool| {
        let found: Vec<Kept> = distances().map(|x| (x, of(x))).map(|(x, (e, t, o))| (x, e, t, o)).collect();
        let kept = |value: f64, exact: &Exact| digits(precise::relative_error(value, &exact.value));
        let name = |name: &str| if first { name.to_owned() } else { String::new() };
        let points = |hue, shape, label: &str, value: fn(&Kept) -> f64| Mark::Points {
            label: name(label),
            hue,
            shape,
            joined: true,
            points: found.iter().map(|at| [at.0, kept(value(at), &at.1)]).collect(),
        };
        let owed = found.iter().map(|at| [at.0, digits(f64::EPSILON * (1.0 + at.1.condition))]).collect();
        Chart::new(
            title,
            Axis::log("distance over the size", ""),
            Axis::linear("digits kept", "").range(0.0, 16.5).tick(4.0),
        )
        .dashed(Hue::Reference, name("what the condition number leaves"), owed)
        .with(points(Hue::Textbook, Shape::Cross, "as textbooks print it", |at| at.2))
        .with(points(Hue::Ours, Shape::Disc, "the program", |at| at.3))
        .into()
    };
    Plot::grid(
        "Digits kept, from very near to very far",
        2,
        vec![
            panel("a disc, two radii aside", &disc, true),
            panel("a sphere, a quarter of its width above the horizon", &sphere, false),
            panel("a square, turned aside", &polygon, false),
        ],
    )
}
