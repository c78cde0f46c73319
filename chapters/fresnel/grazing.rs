//! C12: everything is a mirror at grazing incidence, on a rendered object too.

use super::amplitudes::contrast;
use super::{INTERFACE, incidence, interface};
use crate::figure::{Axis, Chart, Hue, Panel, Picture, Plot};
use crate::parameter::Setting;
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Quantity, Question, Step, check, choice, derivation, exhibit, figure,
    question, statement, step,
};
use equation::derivation::Chain;
use equation::expr::{cos, d, ratio, sqrt};
use equation::{Dimension, Equation, Expr, Symbol};
use glam::DVec3;
use light::Complex64;
use light::optics::Incidence;
use light::optics::fresnel::powers;
use light::optics::incidence::mirrored;

use super::symbols::{N_REL, R_N, THETA_1};

pub(super) const EXHIBIT: Exhibit = exhibit(
    "grazing",
    INTERFACE,
    &[
        figure(
            "sphere",
            "A polished dark sphere on a tiled floor: as it is, its reflectance alone, and \
             with R_n held at its value face on.",
            sphere,
        ),
        figure(
            "what_is_lost",
            "1 − R_n against the cosine: a straight line on logarithmic axes, for glass and \
             metals alike.",
            approach,
        ),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Everything is a mirror at grazing incidence",
    "However clear the medium, its reflectance rises to one as the light grazes it.",
)
.rows(&["C12"])
.statements(&[statement("near_grazing", "near grazing, with n = n₂/n₁ > 1", || {
    Equation::approximate(R_N, 1 - 2 * (N_REL.pow(2) + 1) / sqrt(N_REL.pow(2) - 1) * cos(THETA_1))
})])
.questions(&[LIMITS])
.derivations(&[
    derivation("derivative", "dR_n/dc with c = cos θ₁, and the refracted cosine by Snell's law", || {
        derivative(slope(N_REL.pow(2)))
    })
    .slip("n for n² before the part of p", || derivative(slope(N_REL.into()))),
    derivation("slope", "that at grazing incidence, c = 0", || at_grazing(N_REL.pow(2) + 1))
        .slip("s and p do not add", || at_grazing(N_REL.pow(2) - 1)),
])
.readout(|setting| {
    let input = interface(setting);
    let share = |incidence| powers(incidence, input.n_i, input.n_t).r_n();
    let at = |degrees: f64| share(Incidence::from_angle(degrees.to_radians()));
    let all = [
        ("R_n", "R_n", "at the angle set", share(incidence(setting))),
        ("R_n_0", "R_n(0°)", "face on", at(0.0)),
        ("R_n_80", "R_n(80°)", "ten degrees above the surface", at(80.0)),
        ("R_n_89", "R_n(89°)", "one degree above it", at(89.0)),
    ];
    all.map(|(key, symbol, says, value)| Quantity { key, symbol, says, value, unit: "1" }).into()
})
.checks(&[&APPROACH]);

const LIMITS: Question = question(
    "limits",
    "Face on, water reflects 2 % and diamond 17 %. To which values do they tend as one looks along their surface?",
    Answer::Choice {
        options: &[
            choice(
                "each to its own, diamond to the higher",
                "The index only says how *fast* the curve gets there. A wave that skims the surface has nothing \
                 across it to match.",
            ),
            choice("both to all of the light", ""),
            choice(
                "both to one half: p goes in and s comes back",
                "So it is near Brewster's angle of a high index. Further on p comes back too.",
            ),
        ],
        right: |_| {
            let [water, diamond] = [1.33, 2.42].map(|n| powers(Incidence::from_cos(1e-9), 1.0, n.into()).r_n());
            match () {
                () if (water - diamond).abs() > 1e-3 => 0,
                () if water > 0.99 => 1,
                () => 2,
            }
        },
        slip: |_| 0,
    },
    "Both to one: at grazing incidence everything is a mirror, as every wet road at sunset shows.",
);

/// cos θ₁
const COSINE: Symbol = Symbol::scalar("c", Dimension::ONE).within(0.1, 0.9);

/// n cos θ₂ by Snell's law: √(n² − 1 + c²).
fn refracted() -> Expr {
    sqrt(N_REL.pow(2) - 1 + COSINE.pow(2))
}

/// dR_n/dc, in which the part of p has `weight`.
fn slope(weight: Expr) -> Expr {
    let part = |near: Expr| (&near - refracted()) / (near + refracted()).pow(3);
    let (s, p) = (part(COSINE.into()), part(N_REL.pow(2) * COSINE));
    2 * (N_REL.pow(2) - 1) / refracted() * (s + weight * p)
}

fn derivative(last: Expr) -> Chain {
    let (s, p) = (contrast(COSINE.into(), refracted()), contrast(N_REL.pow(2) * COSINE, refracted()));
    Chain::new(d(R_N) / d(COSINE))
        .given(R_N, ratio(1, 2) * (s.pow(2) + p.pow(2)), "E42")
        .then(last, ["derivative of a square", "derivative of a quotient", "derivative of a root"])
}

fn at_grazing(factor: Expr) -> Chain {
    Chain::new(slope(N_REL.pow(2)))
        .because("dR_n/dc")
        .given(COSINE, 0, "grazing incidence")
        .then(-(2 * (N_REL.pow(2) - 1) / sqrt(N_REL.pow(2) - 1) * ((1 + N_REL.pow(2)) / (N_REL.pow(2) - 1))), ["c = 0"])
        .then(-(2 * factor / sqrt(N_REL.pow(2) - 1)), ["cancel n² − 1"])
}

const APPROACH: Check<fn(f64) -> f64> =
    check("approach", "1 − R_n falls in proportion to cos θ, with the slope 2(n²+1)/√(n²−1)")
        .against("T_n at cos θ from 1e−4 to 1e−12 against the series' first term")
        .within(20.0, "cos θ", "the next term of the series is of relative order cos θ, times at most n² + 1")
        .of(slope_found, |n| 2.0 * (n * n + 1.0) / (n * n - 1.0).sqrt())
        .slip("the slope of s alone", |n| 4.0 / (n * n - 1.0).sqrt());

fn slope_found(_: &mut Bench, slope: fn(f64) -> f64) -> Measured {
    let cosines = [1e-4, 1e-6, 1e-9, 1e-12];
    let cases = [1.33, 1.5, 2.4, 4.0].into_iter().flat_map(|n| cosines.map(|cos| (n, cos)));
    Measured::worst(cases.map(|(n, cos)| {
        let lost = powers(Incidence::from_cos(cos), 1.0, Complex64::from(n)).t_n();
        let relative = lost / (cos * slope(n)) - 1.0;
        // Below one ulp the series is exact and only rounding is left.
        (relative / cos.max(f64::EPSILON), format!("n = {n}, cos θ = {cos:e}"))
    }))
}

fn approach(setting: &Setting) -> Plot {
    let own = interface(setting);
    let curve = |n_i: f64, n_t: Complex64| {
        (0..=120)
            .map(|step| 10f64.powf(-12.0 + f64::from(step) / 10.0))
            .map(|cos| [cos, powers(Incidence::from_cos(cos), n_i, n_t).t_n()])
            .collect()
    };
    let mut chart = Chart::new("", Axis::log("cos θ_1", ""), Axis::log("1 − R_n", ""));
    let at = |name: &str| light::media::named(name).and_then(|material| material.index(550e-9).ok());
    for (hue, name) in ["bk7", "silicon", "gold", "silver"].into_iter().enumerate() {
        if let Some(index) = at(name) {
            chart = chart.line(Hue::Nth(hue as u8), name, curve(1.0, index));
        }
    }
    Plot::of(
        "What a grazed surface does not reflect",
        chart.dashed(Hue::Natural, super::own_media(setting), curve(own.n_i, own.n_t)),
    )
}

/// Width and height of each picture [pixel], and rays a pixel along each side.
const SIZE: usize = 200;
const RAYS: usize = 3;

fn sphere(setting: &Setting) -> Plot {
    let own = interface(setting);
    let share = move |cos: f64| powers(Incidence::from_cos(cos.clamp(0.0, 1.0)), own.n_i, own.n_t).r_n();
    let face_on = share(1.0);
    let pictures: [(&str, Panel); 3] = [
        ("R_n of the angle", picture(|ray| look(ray, &share))),
        (
            "R_n alone",
            picture(|ray| {
                meet(ray).map_or(DVec3::splat(0.02), |(_, normal)| DVec3::splat(share(-ray.direction.dot(normal))))
            }),
        ),
        ("R_n held at its value face on", picture(|ray| look(ray, &|_| face_on))),
    ];
    let panels = pictures.map(|(title, panel)| match panel {
        Panel::Picture(picture) => Panel::Picture(Picture { title: title.into(), ..picture }),
        other => other,
    });
    Plot::grid("The Fresnel effect on a polished sphere", 3, panels.into())
}

/// A ray from `origin` along the unit vector `direction`.
#[derive(Clone, Copy)]
struct Ray {
    origin: DVec3,
    direction: DVec3,
}

/// The unit sphere's centre; it rests on the floor y = 0.
const CENTRE: DVec3 = DVec3::new(0.0, 1.0, 0.0);

/// Where and with which normal the ray meets the sphere.
fn meet(ray: Ray) -> Option<(DVec3, DVec3)> {
    let from = ray.origin - CENTRE;
    let along = from.dot(ray.direction);
    let miss = (from - along * ray.direction).length_squared();
    let distance = -along - (1.0 - miss).max(0.0).sqrt();
    (miss < 1.0 && distance > 1e-9).then(|| {
        let point = ray.origin + distance * ray.direction;
        (point, point - CENTRE)
    })
}

/// Radiance along the ray: the sphere reflects its surroundings with `share` of the cosine, and is dark beneath.
fn look(ray: Ray, share: &impl Fn(f64) -> f64) -> DVec3 {
    let Some((point, normal)) = meet(ray) else { return surroundings(ray) };
    let cos = -ray.direction.dot(normal);
    let onwards = Ray { origin: point, direction: mirrored(ray.direction.into(), normal.into()).into() };
    let reflected = share(cos);
    reflected * surroundings(onwards) + (1.0 - reflected) * DVec3::new(0.012, 0.018, 0.03)
}

/// A tiled floor under a sky that is bright at the horizon, with one lamp.
fn surroundings(ray: Ray) -> DVec3 {
    let up = ray.direction.y;
    if up < -1e-9 {
        let point = ray.origin - ray.origin.y / up * ray.direction;
        let tile = (point.x.floor() + point.z.floor()).rem_euclid(2.0);
        let near = (-0.06 * (point - ray.origin).length()).exp();
        // The sphere shades the floor under it.
        let shade = 1.0 - 0.75 * (-(point.x * point.x + point.z * point.z)).exp();
        let floor = if tile < 1.0 { DVec3::new(0.55, 0.52, 0.48) } else { DVec3::new(0.12, 0.13, 0.15) };
        return near * shade * floor + (1.0 - near) * DVec3::new(0.5, 0.52, 0.55);
    }
    let sky = DVec3::new(0.75, 0.82, 0.95).lerp(DVec3::new(0.12, 0.25, 0.55), up.sqrt());
    let lamp = DVec3::new(-0.5, 0.75, 0.45).normalize();
    if ray.direction.dot(lamp) > 0.985 { DVec3::splat(6.0) } else { sky }
}

/// What a pinhole camera in front of the sphere sees, as a panel.
fn picture(radiance: impl Fn(Ray) -> DVec3) -> Panel {
    let origin = DVec3::new(0.0, 1.55, 4.2);
    let forward = (DVec3::new(0.0, 0.92, 0.0) - origin).normalize();
    let right = forward.cross(DVec3::Y).normalize();
    let up = right.cross(forward);
    let side = (SIZE * RAYS) as f64;
    let view = |across: usize, down: usize| {
        let offset = |at: usize| 0.62 * ((at as f64 + 0.5) / side - 0.5);
        let direction = (forward + offset(across) * right - offset(down) * up).normalize();
        radiance(Ray { origin, direction })
    };
    let pixel = |x: usize, y: usize| {
        let rays = (0..RAYS * RAYS).map(|at| view(x * RAYS + at % RAYS, y * RAYS + at / RAYS));
        (rays.sum::<DVec3>() / (RAYS * RAYS) as f64).as_vec3().to_array()
    };
    let pixels = (0..SIZE * SIZE).map(|at| pixel(at % SIZE, at / SIZE)).collect();
    Picture::new(String::new(), SIZE, pixels).into()
}
