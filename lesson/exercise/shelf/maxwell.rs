//! Chapter maxwell: the grid and a medium.

use crate::exercise::formula::Of;
use crate::exercise::vocabulary::{Exercise, claim, exercise, files, one, real, slip};
use light::fields::tensor::Tensor;

pub const EXERCISES: &[Exercise] = &[
    exercise("grid-dispersion", "how far a wave on a grid turns in a step", files!("grid-dispersion"))
        .of(
            "maxwell/grid",
            &[claim(
                "speed",
                "Differences over a cell and a step are no derivatives: each brings a sine of half its phase.",
            )],
        )
        .asks("phase_per_step", &[real("k", "rad"), real("courant", "1")], one("rad"), &Of::<fn(f64, f64) -> f64>::NEW)
        .slips(&[
            slip(
                "the arcsine alone. It is half of the phase that sin(φ/2) = S sin(k/2) gives: twice that is asked for.",
                |x| vec![(x[1] * (0.5 * x[0]).sin()).asin()],
            ),
            slip("whole phases for halves. Fields are half a cell and half a step apart: sin(φ/2), sin(k/2).", |x| {
                vec![(x[1] * x[0].sin()).asin()]
            }),
        ]),
    exercise("grid-growth", "how fast an unstable grid explodes", files!("grid-growth"))
        .of(
            "maxwell/grid",
            &[claim(
                "growth",
                "The scheme is of second order in time: near the limit the rate goes as the root of the excess.",
            )],
        )
        .asks("growth_per_step", &[real("courant", "1")], one("1"), &Of::<fn(f64) -> f64>::NEW)
        .slips(&[
            slip("arcosh S. It is the growth of half a step: cosh(γ/2) = S.", |x| vec![x[0].acosh()]),
            slip("2 ln S. So it is for large S alone, and there without the factor 2 in e^(γ/2) = 2S.", |x| {
                vec![2.0 * x[0].ln()]
            }),
        ]),
    exercise("grains", "what a block of crystal grains does as a whole", files!("grains"))
        .of(
            "maxwell/media",
            &[claim(
                "grains",
                "In a grain that gives way easily the field is weaker: the field is not the same in all of them.",
            )],
        )
        .asks(
            "permittivity",
            &[real("eps_x", "1"), real("eps_y", "1"), real("eps_z", "1")],
            one("1"),
            &Of::<fn(&Tensor) -> f64>::NEW,
        )
        .slips(&[
            slip(
                "the harmonic mean, as of layers across the field. So D is the same in all grains, which it is not.",
                |x| vec![3.0 / x.iter().map(|axis| axis.recip()).sum::<f64>()],
            ),
            slip(
                "the geometric mean. So it would be in two dimensions; in three a ball has ε_i + 2ε in its dipole.",
                |x| vec![x.iter().product::<f64>().cbrt()],
            ),
        ]),
];
