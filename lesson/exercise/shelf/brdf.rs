//! Chapter brdf: diffuse, facets, the Fresnel term of a renderer.

use crate::exercise::formula::Of;
use crate::exercise::vocabulary::{Exercise, claim, exercise, files, one, real, slip, triple};
use std::f64::consts::PI;

/// α² cos² θ + sin² θ.
fn bracket(alpha: f64, cos: f64) -> f64 {
    alpha * alpha * cos * cos + (1.0 - cos) * (1.0 + cos)
}

fn ggx(alpha: f64, cos: f64) -> f64 {
    alpha * alpha / (PI * bracket(alpha, cos).powi(2))
}

/// Of α, view and normal: D, the cosine between the two, and cos θ (1 + Λ).
fn seen(x: &[f64]) -> [f64; 3] {
    let tan2 = (x[1] * x[1] + x[2] * x[2]) / (x[3] * x[3]);
    let hidden = 0.5 * ((1.0 + x[0] * x[0] * tan2).sqrt() - 1.0);
    [ggx(x[0], x[6]), (x[1] * x[4] + x[2] * x[5] + x[3] * x[6]).max(0.0), x[3] * (1.0 + hidden)]
}

/// r_s and r_p as textbooks have them; NaN where all is reflected.
fn amplitudes(x: &[f64]) -> [f64; 2] {
    let (c, eta) = (x[0], x[1]);
    let q = (eta * eta - (1.0 - c * c)).sqrt();
    [(c - q) / (c + q), (eta * eta * c - q) / (eta * eta * c + q)]
}

pub const EXERCISES: &[Exercise] = &[
    exercise("lambert", "the constant of a diffuse surface", files!("lambert"))
        .of(
            "brdf/lambert",
            &[claim("share", "The hemisphere has 2π sr, but what leaves through it counts with its cosine: that makes π.")],
        )
        .asks("brdf", &[real("rho", "1")], one("1/sr"), &Of::<fn(f64) -> f64>::NEW)
        .slips(&[
            slip("ρ itself. What leaves goes into all directions: per steradian it is less, by π.", |x| vec![x[0]]),
            slip("ρ/4π, as for a point that sends to all sides. A surface sends to one side, weighed by the cosine.", |x| {
                vec![x[0] / (4.0 * PI)]
            }),
        ]),
    exercise("ggx", "how the facets of a rough surface lie", files!("ggx"))
        .of(
            "brdf/facets",
            &[claim("ellipsoid", "α is the ellipsoid's height; many programs square a slider's value to get it, once.")],
        )
        .asks("density", &[real("alpha", "1"), real("cos", "1")], one("1/sr"), &Of::<fn(f64, f64) -> f64>::NEW)
        .slips(&[
            slip("Beckmann's, of Gaussian slopes. The ellipsoid's slopes have a long tail, of powers.", |x| {
                let cos2 = x[1] * x[1];
                let tan2 = (1.0 - x[1]) * (1.0 + x[1]) / cos2;
                vec![(-tan2 / (x[0] * x[0])).exp() / (PI * x[0] * x[0] * cos2 * cos2)]
            }),
            slip("the bracket not squared.", |x| vec![x[0] * x[0] / (PI * bracket(x[0], x[1]))]),
            slip("π forgotten. ∫ D cos θ dω must be 1.", |x| vec![PI * ggx(x[0], x[1])]),
            slip("D cos θ. D itself is asked for; the cosine belongs to the integral.", |x| vec![ggx(x[0], x[1]) * x[1]]),
        ]),
    exercise("visible-normals", "which facets are seen", files!("visible-normals"))
        .of(
            "brdf/facets",
            &[claim("drawn", "Facets that look away are not seen, and those that face the eye show more: ω·m is missing.")],
        )
        .asks(
            "density",
            &[real("alpha", "1"), triple("view", "1"), triple("normal", "1")],
            one("1/sr"),
            &Of::<fn(f64, [f64; 3], [f64; 3]) -> f64>::NEW,
        )
        .slips(&[
            slip("over cos θ alone: masking forgotten. What facets that face the eye show is more, cos θ (1 + Λ).", |x| {
                let [d, shown, _] = seen(x);
                vec![d * shown / x[3]]
            }),
            slip("ω·m forgotten. A facet counts by the area that it shows.", |x| {
                let [d, _, area] = seen(x);
                vec![d / area]
            }),
            slip("the density of the reflected directions. It is that of the normals over 4 ω·m.", |x| {
                let [d, _, area] = seen(x);
                vec![d / (4.0 * area)]
            }),
            slip("not divided by what is seen in all, cos θ (1 + Λ). A density integrates to 1.", |x| {
                let [d, shown, _] = seen(x);
                vec![d * shown]
            }),
        ]),
    exercise("reflectance", "Fresnel's reflectance for a renderer", files!("reflectance"))
        .of(
            "brdf/glass",
            &[claim("polished", "η is the index behind the interface over that before it, as light runs.")],
        )
        .asks("reflectance", &[real("cos_i", "1"), real("eta", "1")], one("1"), &Of::<fn(f64, f64) -> f64>::NEW)
        .stands(&["fresnel"])
        .slips(&[
            slip("NaN beyond the critical angle. Where the refracted ray's cosine would be the root of a negative number, all is \
                  reflected: R = 1.", |x| vec![0.5 * amplitudes(x).map(|r| r * r).iter().sum::<f64>()]),
            slip("0 beyond the critical angle. There is no refracted ray, and so nothing goes through: R = 1.", |x| {
                let both = 0.5 * amplitudes(x).map(|r| r * r).iter().sum::<f64>();
                vec![if both.is_nan() { 0.0 } else { both }]
            }),
            slip("R_s alone. Natural light is half s and half p.", |x| {
                let s = amplitudes(x)[0];
                vec![if s.is_nan() { 1.0 } else { s * s }]
            }),
            slip("R_p alone. Natural light is half s and half p.", |x| {
                let p = amplitudes(x)[1];
                vec![if p.is_nan() { 1.0 } else { p * p }]
            }),
            slip("the square of the fields' mean. s and p stand at right angles: their powers add up, not their fields.", |x| {
                let mean = 0.5 * amplitudes(x).iter().sum::<f64>();
                vec![if mean.is_nan() { 1.0 } else { mean * mean }]
            }),
        ]),
];
