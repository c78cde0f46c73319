//! Chapter radiometry: directions, lamps, floors.

use crate::exercise::formula::Of;
use crate::exercise::vocabulary::{Exercise, claim, exercise, files, one, real, slip};
use std::f64::consts::PI;

pub const EXERCISES: &[Exercise] = &[
    exercise("rings", "how much of a sphere is between two angles", files!("rings"))
        .of(
            "radiometry/solid_angle",
            &[claim("patches", "Near the pole a ring is short: dω = sin θ dθ dφ.")],
        )
        .asks("share", &[real("from", "rad"), real("to", "rad")], one("1"), &Of::<fn(f64, f64) -> f64>::NEW)
        .slips(&[
            slip("the share of a hemisphere. All directions are asked for: 4π, not 2π.", |x| vec![x[0].cos() - x[1].cos()]),
            slip("the solid angle, in sr. The share is that over 4π.", |x| vec![2.0 * PI * (x[0].cos() - x[1].cos())]),
            slip("a difference of sines. The primitive of sin θ is −cos θ.", |x| vec![0.5 * (x[1].sin() - x[0].sin())]),
        ]),
    exercise("cos4", "how light falls off towards the edge of a floor", files!("cos4"))
        .of(
            "radiometry/irradiance",
            &[claim("small", "The lamp is farther away, too, by 1/cos θ, and 1/r² makes two more cosines of that.")],
        )
        .asks("law", &[real("cos", "1")], one("1"), &Of::<fn(f64) -> f64>::NEW)
        .slips(&[
            slip("cos³ θ. Both the lamp is seen at a slant and the floor is turned away: one cosine each, and two of the distance. \
                  Three are what a point in the ceiling has that sends alike to all sides.", |x| vec![x[0].powi(3)]),
            slip("cos θ. That is the floor's own; the lamp is seen at a slant, and it is farther away.", |x| vec![x[0]]),
        ]),
    exercise("disc", "the light of a round lamp overhead", files!("disc"))
        .of(
            "radiometry/shapes",
            &[claim("on_axis", "What comes from aside falls on the receiver at a slant: each direction counts with its cosine.")],
        )
        .asks("irradiance", &[real("radius", "m"), real("height", "m")], one("sr"), &Of::<fn(f64, f64) -> f64>::NEW)
        .slips(&[
            slip("πR²/h², as if all of the lamp were straight above. That holds for a lamp that is small or far.", |x| {
                vec![PI * (x[0] / x[1]).powi(2)]
            }),
            slip("R²/(R² + h²), the form factor. The irradiance over the radiance is π times that.", |x| {
                vec![x[0] * x[0] / (x[0] * x[0] + x[1] * x[1])]
            }),
            slip("sin θ of the rim for its square: ∫ sin θ cos θ dθ is ½ sin² θ.", |x| vec![PI * x[0] / x[0].hypot(x[1])]),
        ]),
];
