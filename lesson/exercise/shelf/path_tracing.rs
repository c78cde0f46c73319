//! Chapter path-tracing: weights, chance, depth, and what a screen makes of it.

use crate::exercise::formula::Of;
use crate::exercise::vocabulary::{Exercise, claim, exercise, files, one, real, slip, whole};

const PLANCK: f64 = 6.626_070_15e-34;
const C: f64 = 299_792_458.0;
const BOLTZMANN: f64 = 1.380_649e-23;

/// hc/(λkT).
fn exponent(x: &[f64]) -> f64 {
    PLANCK * C / (x[0] * BOLTZMANN * x[1])
}

pub const EXERCISES: &[Exercise] = &[
    exercise("balance", "how two ways of drawing share a path", files!("balance"))
        .of(
            "path-tracing/weights",
            &[claim("sum", "Both ways have one sample each: none counts twice in the sum.")],
        )
        .asks("share", &[real("p", "1/sr"), real("q", "1/sr")], one("1"), &Of::<fn(f64, f64) -> f64>::NEW)
        .slips(&[
            slip("the power heuristic, p²/(p² + q²). It sums to one as well, but the balance heuristic is in proportion to p.", |x| {
                let square = (x[0] / x[1]).powi(2);
                vec![if square.is_finite() { square / (square + 1.0) } else { 1.0 }]
            }),
            slip("each way by one half. It is right on average, but keeps the noise of the worse way.", |_| vec![0.5]),
            slip("the other way's share: q stands above the line.", |x| vec![x[1] / (x[0] + x[1])]),
        ]),
    exercise("roulette", "how much roulette scatters", files!("roulette"))
        .of(
            "path-tracing/roulette",
            &[claim("squares", "⟨X²⟩ has the square of the weight ρ/q, met with the probability q: ρ²/q.")],
        )
        .asks("scatter", &[real("absorbed", "1"), real("ended", "1")], one("1"), &Of::<fn(f64, f64) -> f64>::NEW)
        .slips(&[
            slip("the variance. Its root is asked for.", |x| {
                let (rho, q) = (1.0 - x[0], 1.0 - x[1]);
                vec![rho * rho * x[1] / (q - rho * rho)]
            }),
            slip("q and 1 − q exchanged: `ended` is the chance that a path ends.", |x| {
                let rho = 1.0 - x[0];
                vec![rho * ((1.0 - x[1]) / (x[1] - rho * rho)).sqrt()]
            }),
            slip("the standard deviation itself. Over the mean, 1/(1 − ρ), is asked for.", |x| {
                let (rho, q) = (1.0 - x[0], 1.0 - x[1]);
                vec![rho * (x[1] / (q - rho * rho)).sqrt() / x[0]]
            }),
        ]),
    exercise("depth", "a room by paths that are cut", files!("depth"))
        .of(
            "path-tracing/depth",
            &[claim("series", "The camera's own edge is the first: a path of one edge finds L_e and nothing else.")],
        )
        .asks("brightness", &[real("absorbed", "1"), whole("edges")], one("1"), &Of::<fn(f64, u32) -> f64>::NEW)
        .stands(&["white"])
        .slips(&[
            slip("(1 − ρ^d)/(1 − ρ) with ρ = 1 − a made first. It is right, but of a white wall's a nothing is left in 1 − a: \
                  divide by a, and take ρ^d by its logarithm.", |x| {
                let rho: f64 = 1.0 - x[0];
                vec![(1.0 - rho.powf(x[1])) / (1.0 - rho)]
            }),
            slip("1/(1 − ρ), all of the light. Paths that are cut miss ρ^d of it.", |x| vec![1.0 / x[0]]),
            slip("one term too few: the first is 1, L_e itself.", |x| {
                vec![-((x[1] - 1.0) * (-x[0]).ln_1p()).exp_m1() / x[0]]
            }),
        ]),
    exercise("srgb", "from a screen's code to light", files!("srgb"))
        .of(
            "path-tracing/picture",
            &[claim("round_trip", "sRGB is near a power of 2.2, but of two pieces: a straight one and a power of 2.4.")],
        )
        .asks("light", &[real("code", "1")], one("1"), &Of::<fn(f64) -> f64>::NEW)
        .slips(&[
            slip("the way back: from light to code. Half the code is about a fifth of the light.", |x| {
                vec![if x[0] <= 0.003_130_8 { 12.92 * x[0] } else { 1.055 * x[0].powf(1.0 / 2.4) - 0.055 }]
            }),
            slip("the code itself, as if it counted light.", |x| vec![x[0]]),
            slip("the power alone. Below 0.04045 the curve is straight: code/12.92.", |x| {
                vec![((x[0] + 0.055) / 1.055).powf(2.4)]
            }),
        ]),
    exercise("blackbody", "the light of what glows", files!("blackbody"))
        .of("path-tracing/dispersion", &[claim("locus", "The −1 is missing: photons come in crowds where λT is large.")])
        .asks("radiance", &[real("wavelength", "m"), real("temperature", "K")], one("W/(m³ sr)"), &Of::<fn(f64, f64) -> f64>::NEW)
        .slips(&[
            slip("Wien's law: the −1 behind the exponential is missing. Photons come in crowds where λT is large.", |x| {
                vec![2.0 * PLANCK * C * C / x[0].powi(5) * (-exponent(x)).exp()]
            }),
            slip("Rayleigh and Jeans's law, 2ckT/λ⁴: no photons at all. Towards the blue it grows without end.", |x| {
                vec![2.0 * C * BOLTZMANN * x[1] / x[0].powi(4)]
            }),
            slip("per frequency, in λ: 2hc/λ³. Per wavelength is asked for, and dν is c/λ² dλ.", |x| {
                vec![2.0 * PLANCK * C / x[0].powi(3) / exponent(x).exp_m1()]
            }),
        ]),
];
