//! Chapter fresnel: where light goes at an interface, and how much.

use crate::exercise::formula::Of;
use crate::exercise::vocabulary::{Exercise, Taken, claim, exercise, files, one, real, slip};

const RAY: &[Taken] = &[real("theta_i", "rad"), real("n_i", "1"), real("n_t", "1")];

/// Normal parts of the wave numbers [1], over ω/c: n cos θ before and behind the interface; and both cosines.
fn parts(x: &[f64]) -> [f64; 2] {
    let sin_t = x[1] * x[0].sin() / x[2];
    [x[0].cos(), (1.0 - sin_t * sin_t).sqrt()]
}

pub const EXERCISES: &[Exercise] = &[
    exercise("snell", "where the refracted ray goes", files!("snell"))
        .of(
            "fresnel/snell",
            &[claim("fermat", "Into the denser medium the ray bends towards the normal: there the sine is smaller.")],
        )
        .asks("refracted_sine", RAY, one("1"), &Of::<fn(f64, f64, f64) -> f64>::NEW)
        .slips(&[
            slip("the angle itself. Its sine is asked for.", |x| vec![(x[1] * x[0].sin() / x[2]).asin()]),
            slip("angles for sines, as for small angles. What is the same on both sides is n sin θ.", |x| vec![x[1] * x[0] / x[2]]),
            slip("the sine of the angle of incidence: the ray goes straight on. The wave number changes by n.", |x| vec![x[0].sin()]),
            slip("the cosine for the sine. Angles count from the normal; along the interface lies the sine.", |x| {
                vec![x[1] * x[0].cos() / x[2]]
            }),
        ]),
    exercise("r-s", "how much of an s wave an interface sends back", files!("r-s"))
        .of(
            "fresnel/r_s",
            &[claim("as_written", "At a denser medium E turns over: where it meets n_t > n_i, r_s is negative.")],
        )
        .asks("r_s", RAY, one("1"), &Of::<fn(f64, f64, f64) -> f64>::NEW)
        .slips(&[
            slip("r_p. For s, n goes with the cosine of its own side: it is H that has the cosine.", |x| {
                let [i, t] = parts(x);
                vec![(x[2] * i - x[1] * t) / (x[2] * i + x[1] * t)]
            }),
            slip("−r_p: each n stands with the other side's cosine.", |x| {
                let [i, t] = parts(x);
                vec![(x[1] * t - x[2] * i) / (x[2] * i + x[1] * t)]
            }),
            slip("R_s, the power. The field itself is asked for, with its sign.", |x| {
                let [i, t] = parts(x);
                vec![((x[1] * i - x[2] * t) / (x[1] * i + x[2] * t)).powi(2)]
            }),
            slip("(n_i − n_t)/(n_i + n_t), as along the normal. At an angle only the part of H along the interface counts.", |x| {
                vec![(x[1] - x[2]) / (x[1] + x[2])]
            }),
            slip("t_s, what goes through: 1 + r = t.", |x| {
                let [i, t] = parts(x);
                vec![2.0 * x[1] * i / (x[1] * i + x[2] * t)]
            }),
        ]),
    exercise("brewster", "the angle at which no p light comes back", files!("brewster"))
        .of(
            "fresnel/brewster",
            &[
                claim("minimum", "tan θ is the index behind the interface over that before it: into glass it is above 45°."),
                claim("square", "sin θ_t = cos θ_i and Snell's law make a tangent: n_i sin θ = n_t cos θ."),
            ],
        )
        .asks("brewster_angle", &[real("n_i", "1"), real("n_t", "1")], one("rad"), &Of::<fn(f64, f64) -> f64>::NEW)
        .slips(&[slip("degrees. Angles are in radians here.", |x| vec![(x[1] / x[0]).atan().to_degrees()])]),
    exercise("schlick", "reflectance in one power of the cosine", files!("schlick"))
        .of(
            "fresnel/schlick",
            &[
                claim("both_ends", "At grazing incidence all is reflected: R₀ + … must come to 1 there, not to 1 + R₀."),
                claim("glass_in_air", "Schlick's power is the fifth."),
            ],
        )
        .asks("schlick", &[real("cos_i", "1"), real("r_0", "1")], one("1"), &Of::<fn(f64, f64) -> f64>::NEW)
        .slips(&[
            slip("a power of the cosine. What rises towards grazing is 1 − cos θ.", |x| {
                vec![x[1] + (1.0 - x[1]) * x[0].powi(5)]
            }),
            slip("the weight at the other end: R₀ belongs to the normal, 1 to grazing incidence.", |x| {
                vec![1.0 - (1.0 - x[1]) * (1.0 - x[0]).powi(5)]
            }),
        ]),
];
