//! E31, C9: what belongs to a place and a direction.

use super::symbols::{AREA, FLUX, INTENSITY, RADIANCE, SOLID_ANGLE, THETA};
use crate::figure::{Axis, Chart, Hue, Panel, Picture, Plot};
use crate::parameter::{Kind, Parameter, Setting};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Quantity, Step, check, choice, exhibit, figure, question, statement, step,
};
use equation::Equation;
use equation::expr::{cos, partial};
use glam::DVec3;
use light::radiometry::{disc::Disc, polygon};
use std::f64::consts::{PI, TAU};
use yardstick::order;
use yardstick::quadrature::gauss_legendre;

/// Radius of the lamp over its height.
const WIDTH: Parameter =
    Parameter::new("width", "R/h", "radius of the lamp over its height", Kind::number(1e-2, 1e2, "1")).default("0.5");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "radiance",
    &[WIDTH],
    &[
        figure(
            "floor",
            "A flat lamp over a floor, its elements sending as cos θ, alike to all sides, or along their normal only: of \
             the same flux.",
            floor,
        ),
        figure(
            "balls",
            "Three glowing balls of the same flux: as cos θ the ball looks like a disc, as the sun nearly does; alike to all \
             sides it has a bright rim; along the normals alone only the point that faces us is lit.",
            balls,
        ),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "What belongs to a place and a direction",
    "Intensity over the area that is seen is radiance: a flat source of one radiance sends as cos θ.",
)
.rows(&["E31"])
.statements(&[
    statement("of_intensity", "radiance, in W/(sr m²): the area counts as it is seen", || {
        Equation::new(RADIANCE, partial(INTENSITY, AREA * cos(THETA)))
    }),
    statement("of_flux", "and from the flux", || {
        Equation::new(RADIANCE, partial(partial(FLUX, AREA * cos(THETA)), SOLID_ANGLE))
    }),
])
.questions(&[question(
    "ball",
    "A glowing ball has the same radiance everywhere and in all directions. What does it look like from far?",
    Answer::Choice {
        options: &[
            choice("a disc, as bright at its rim as in its middle", ""),
            choice(
                "a disc that is darker towards its rim",
                "The rim's elements do send less towards us, by cos θ; but as much more of them are seen on the same width.",
            ),
            choice("a bright point in the middle", "So it would be if each element sent along its own normal alone."),
        ],
        right: |_| usize::from((seen(Law::Lambert, 0.9) / seen(Law::Lambert, 0.0) - 1.0).abs() > 1e-9),
        slip: |_| 1,
    },
    "What an element sends falls as cos θ, and so does the width on which it is seen: their quotient is the same.",
)])
.readout(|setting| {
    let width = setting.number("width");
    let [lambert, even, normal] = Law::ALL.map(|law| below(law, width, 0.0));
    let quantity = |key, symbol, says, value| Quantity { key, symbol, says, value, unit: "1" };
    vec![
        quantity("lambert", "E_L/M", "under the middle of the lamp, over what leaves it, by cos θ", lambert),
        quantity("even", "E_0/M", "if its elements sent alike to all sides", even),
        quantity("normal", "E_n/M", "if they sent along their normal alone, as the notes have it", normal),
    ]
})
.checks(&[&SEEN, &FLOOR]);

const SEEN: Check<fn(f64, f64) -> f64> =
    check("seen", "however a lamp is turned, what its intensity says of its radiance is the same")
        .rows(&["E31"])
        .against("the radiance that it was given, by the flow that Lambert's sum finds from far")
        .order(
            2.0,
            0.05,
            "the lamp's corners are as far off the axis on either side: the square of size over distance is left",
        )
        .of(from_afar, |area, cos| area * cos)
        .slip("the lamp's own area, not the one that is seen", |area, _| area);

fn from_afar(_: &mut Bench, seen: fn(f64, f64) -> f64) -> Measured {
    let points: Vec<(f64, f64)> = (2..9)
        .map(|halving| {
            let size = 1.0 / f64::from(1 << halving);
            let worst = [0.0, 0.6, 1.2].map(|theta: f64| {
                let side = DVec3::new(theta.cos(), 0.0, -theta.sin()) * size;
                let other = DVec3::Y * size;
                let corner = DVec3::Z - 0.5 * (side + other);
                let corners = [corner, corner + side, corner + side + other, corner + other].map(|v| v.to_array());
                let flow = polygon::irradiance(&corners, [0.0, 0.0, 1.0]).unwrap_or(f64::NAN);
                // At the distance 1 the flow is the intensity.
                (flow / seen(size * size, theta.cos()) - 1.0).abs()
            });
            (size, Measured::worst(worst.map(|off| (off, String::new()))).value)
        })
        .collect();
    Measured::new(
        order::slope(&points).unwrap_or(f64::NAN),
        "sizes from 1/4 to 1/256 of the distance, tilts 0, 0.6, 1.2",
        21,
    )
}

/// How the elements of a lamp send what leaves them.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Law {
    /// As cos θ.
    Lambert,
    /// Alike to all sides.
    Even,
    /// Along the normal alone.
    Normal,
}

impl Law {
    const ALL: [Self; 3] = [Self::Lambert, Self::Even, Self::Normal];

    fn name(self) -> &'static str {
        match self {
            Self::Lambert => "as cos θ",
            Self::Even => "alike to all sides",
            Self::Normal => "along the normal alone",
        }
    }

    /// What an element sends into a direction [sr⁻¹], of what leaves it; of what goes along the normal alone none goes
    /// anywhere else.
    fn share(self, cos: f64) -> f64 {
        match self {
            Self::Lambert => cos / PI,
            Self::Even => 1.0 / TAU,
            Self::Normal => 0.0,
        }
    }
}

/// What arrives on a floor under a round lamp of `radius` at height 1, `aside` from its axis, of an exitance of 1 [1].
fn below(law: Law, radius: f64, aside: f64) -> f64 {
    match law {
        Law::Lambert => {
            let disc = Disc { radius, height: 1.0, offset: aside, tilt: 0.0 };
            disc.irradiance().unwrap_or(f64::NAN) / PI
        }
        Law::Normal => f64::from(u8::from(aside <= radius)),
        Law::Even => over_disc(radius, |place| sent(|cos| law.share(cos), place, aside)),
    }
}

/// ∫ f dA over the disc of `radius` at height 1, by a product rule.
fn over_disc(radius: f64, f: impl Fn(DVec3) -> f64) -> f64 {
    let turns = 64;
    let ring = |(u, weight): (f64, f64)| {
        let r = radius * u;
        let along = |at: i32| {
            let (sin, cos) = (TAU * f64::from(at) / f64::from(turns)).sin_cos();
            f(DVec3::new(r * cos, r * sin, 1.0))
        };
        weight * radius * r * TAU / f64::from(turns) * (0..turns).map(along).sum::<f64>()
    };
    gauss_legendre(48).into_iter().map(ring).sum()
}

const FLOOR: Check<fn(f64) -> f64> = check(
    "elements",
    "a lamp whose elements send as cos θ lights a floor as a surface of one radiance does",
)
.rows(&["C9"])
.against("the closed form of a disc, against the sum over the elements of what each sends, by a product rule")
.within(
    1e-10,
    "1",
    "the lamp is at most as wide as it is high: of 48 rings and 64 turns e^(−64·asinh 1) ~ 10⁻²⁴ is left, and the \
             rounding of 3000 terms",
)
.of(elements, |cos| cos / PI)
.slip("alike to all sides, without cos θ", |_| 1.0 / TAU);

/// What a floor takes from elements that send `share` of their exitance into a direction [sr⁻¹].
fn elements(_: &mut Bench, share: fn(f64) -> f64) -> Measured {
    let places = [0.1, 0.5, 1.0].into_iter().flat_map(|radius| [0.0, 0.7, 2.0, 10.0].map(|aside| (radius, aside)));
    Measured::worst(places.map(|(radius, aside)| {
        let found = over_disc(radius, |place| sent(share, place, aside));
        (found / below(Law::Lambert, radius, aside) - 1.0, format!("R = {radius} h, {aside} h aside"))
    }))
}

/// What an element at a `place` above the floor adds `aside` from the axis, of its exitance [m⁻²].
fn sent(share: impl Fn(f64) -> f64, place: DVec3, aside: f64) -> f64 {
    let to = place - DVec3::new(aside, 0.0, 0.0);
    let cos = place.z / to.length();
    share(cos) * cos / to.length_squared()
}

fn floor(setting: &Setting) -> Plot {
    let width = setting.number("width");
    let reach = 3.0 * (1.0 + width);
    let curve = |law: Law| -> Vec<[f64; 2]> {
        (-300..=300).map(|at| reach * f64::from(at) / 300.0).map(|x| [x, below(law, width, x.abs())]).collect()
    };
    let axes = Chart::new(
        "",
        Axis::linear("place x / h", "").range(-reach, reach),
        Axis::linear("irradiance over the lamp's exitance E/M", "").range(0.0, 1.05),
    );
    let chart =
        Law::ALL.into_iter().zip(0..).fold(axes, |chart, (law, at)| chart.line(Hue::Nth(at), law.name(), curve(law)));
    Plot::of(format!("On the floor under a round lamp, R = {width} h"), chart)
}

/// The radiance of a ball at a distance `aside` from its middle, over its radius, of an exitance of 1 [sr⁻¹].
fn seen(law: Law, aside: f64) -> f64 {
    let cos = ((1.0 - aside) * (1.0 + aside)).max(0.0).sqrt();
    // A shade that ends a hair before the rim, where it might be infinite.
    law.share(cos.max(1e-3)) / cos.max(1e-3)
}

fn balls(_: &Setting) -> Plot {
    const SIDE: usize = 160;
    let ball = |law: Law| -> Panel {
        let pixel = |at: usize| {
            let place = |at: usize| (at as f64 + 0.5) / SIDE as f64 * 2.4 - 1.2;
            let aside = place(at % SIDE).hypot(place(at / SIDE));
            let bright = match law {
                // All of the flux that is seen comes from within a pixel or two of the middle.
                Law::Normal if aside < 2.4 / SIDE as f64 => 1.0,
                Law::Normal => 0.0,
                _ if aside < 1.0 => 0.6 * PI * seen(law, aside),
                _ => 0.0,
            };
            [bright as f32; 3]
        };
        let pixels = (0..SIDE * SIDE).map(pixel).collect();
        Picture::new(law.name(), SIDE, pixels).into()
    };
    Plot::grid("A ball of one exitance, its elements sending", 3, Law::ALL.map(ball).into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn elements_share_all_that_leaves_them() {
        for law in [Law::Lambert, Law::Even] {
            let sum: f64 = gauss_legendre(4).iter().map(|(cos, weight)| weight * TAU * law.share(*cos)).sum();
            assert!((sum - 1.0).abs() < 1e-15);
        }
        // Under the middle, alike to all sides: the solid angle over 2π, 1 − cos α.
        let found = below(Law::Even, 2.0, 0.0);
        let sin2 = 4.0 / 5.0;
        assert!((found - (1.0 - (1.0_f64 - sin2).sqrt())).abs() < 1e-12, "{found}");
    }
}
