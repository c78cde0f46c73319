//! Chapter rendering-equation: bounces, and who sees whom.

use crate::exercise::formula::Of;
use crate::exercise::vocabulary::{Exercise, claim, exercise, files, one, real, slip};

pub const EXERCISES: &[Exercise] = &[
    exercise("series", "all bounces of light in a closed room", files!("series"))
        .of(
            "rendering-equation/series",
            &[claim("sum", "The first term counts: the walls shine themselves, L_e, before anything is reflected.")],
        )
        .asks("brightness", &[real("absorbed", "1")], one("1"), &Of::<fn(f64) -> f64>::NEW)
        .slips(&[
            slip("1 + ρ, the first bounce alone. What was reflected once is reflected again.", |x| vec![2.0 - x[0]]),
            slip(
                "1/ρ. The rest of the series is ρ times all of it: L(1 − ρ) = L_e, and 1 − ρ is what is absorbed.",
                |x| vec![1.0 / (1.0 - x[0])],
            ),
            slip("1/(1 − ρ²). Each bounce brings ρ, not ρ².", |x| vec![1.0 / (x[0] * (2.0 - x[0]))]),
        ]),
    exercise("discs", "what one disc sees of another", files!("discs"))
        .of(
            "rendering-equation/form_factors",
            &[claim("discs", "A small disc sees much of a large one, and the large one little of it: S₁F₁₂ = S₂F₂₁.")],
        )
        .asks(
            "form_factor",
            &[real("r_1", "m"), real("r_2", "m"), real("h", "m")],
            one("1"),
            &Of::<fn(f64, f64, f64) -> f64>::NEW,
        )
        .slips(&[
            slip(
                "r₂²/(r₂² + h²), what the middle of the first disc sees. Places aside see less: the mean is asked for.",
                |x| vec![x[1] * x[1] / (x[1] * x[1] + x[2] * x[2])],
            ),
            slip("(r₂/h)², as for discs that are far apart.", |x| vec![(x[1] / x[2]).powi(2)]),
            slip("the other root. A share is at most 1: it is the smaller one.", |x| {
                let (a, b) = (x[0] / x[2], x[1] / x[2]);
                let s = 1.0 + (1.0 + b * b) / (a * a);
                vec![0.5 * (s + (s * s - 4.0 * (b / a).powi(2)).sqrt())]
            }),
        ]),
];
