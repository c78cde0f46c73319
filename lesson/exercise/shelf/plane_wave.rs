//! Chapter plane-wave: how fast, how long, how deep.

use crate::exercise::formula::Of;
use crate::exercise::vocabulary::{Exercise, claim, exercise, files, one, real, slip};
use light::waves::constants::{C, MU_0};
use std::f64::consts::TAU;

pub const EXERCISES: &[Exercise] = &[
    exercise("light-speed", "the speed of light from a condenser and a coil", files!("light-speed"))
        .of(
            "plane-wave/speed",
            &[claim("weighed_and_timed", "The wave equation has v²: εμv² = 1. The units tell as well: 1/(εμ) is in m²/s².")],
        )
        .asks("speed", &[real("epsilon", "F/m"), real("mu", "H/m")], one("m/s"), &Of::<fn(f64, f64) -> f64>::NEW)
        .slips(&[
            slip("√(εμ), upside down. The stiffer the medium, the slower the wave: a speed in m/s is 1 over that.", |x| {
                vec![(x[0] * x[1]).sqrt()]
            }),
            slip("√(μ/ε), which is a resistance: the impedance of the vacuum, 377 Ω.", |x| vec![(x[1] / x[0]).sqrt()]),
        ]),
    exercise("wavelength", "the wavelength in a medium", files!("wavelength"))
        .of(
            "plane-wave/cosine",
            &[claim("zeros", "The medium slows the wave: by the root of ε_r μ_r, and its waves are as much shorter.")],
        )
        .asks(
            "wavelength",
            &[real("omega", "rad/s"), real("epsilon_r", "1"), real("mu_r", "1")],
            one("m"),
            &Of::<fn(f64, f64, f64) -> f64>::NEW,
        )
        .slips(&[
            slip("ω taken for f. A period is 2π/ω: a factor 2π is missing.", |x| vec![C / (x[0] * (x[1] * x[2]).sqrt())]),
            slip("no root over ε_r μ_r. It is v² that goes with 1/(εμ).", |x| vec![TAU * C / (x[0] * x[1] * x[2])]),
            slip("μ_r forgotten. Light may not mind magnets, but waves of other frequencies meet media that are magnetic.", |x| {
                vec![TAU * C / (x[0] * x[1].sqrt())]
            }),
            slip("multiplied by the index. Waves in a denser medium are slower and shorter, not longer.", |x| {
                vec![TAU * C / x[0] * (x[1] * x[2]).sqrt()]
            }),
        ]),
    exercise("skin-depth", "how deep a field reaches into a metal", files!("skin-depth"))
        .of(
            "plane-wave/conductor",
            &[claim("handbook", "ω = 2πf: k² = iωμσ has the angular frequency.")],
        )
        .asks("skin_depth", &[real("frequency", "Hz"), real("sigma", "S/m")], one("m"), &Of::<fn(f64, f64) -> f64>::NEW)
        .slips(&[
            slip("√(1/(ωμσ)). It is 1/|k|; the imaginary part of k is less, by the √2 in √i = (1 + i)/√2.", |x| {
                vec![(1.0 / (TAU * x[0] * MU_0 * x[1])).sqrt()]
            }),
            slip("half the depth: at that the power, E², has fallen to 1/e. The field's depth is asked for.", |x| {
                vec![0.5 * (2.0 / (TAU * x[0] * MU_0 * x[1])).sqrt()]
            }),
        ]),
];
