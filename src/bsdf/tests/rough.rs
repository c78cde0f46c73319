//! Rough metal: what is drawn follows its density, weights keep their bound, and f is the same both ways.

use super::direction;
use crate::bsdf::microfacet::{Beckmann, Distribution, Ggx, Joint, Slopes, visible_density};
use crate::bsdf::rules::golden;
use crate::bsdf::{Bsdf, Sample, Setting, zoo};
use crate::number::{Number, Vector};
use yardstick::random::{stream, uniform};

fn views() -> impl Iterator<Item = ([f64; 2], f64)> {
    let alphas = [[1e-4; 2], [0.01; 2], [0.3; 2], [1.0; 2], [1.0, 0.1]];
    alphas.into_iter().flat_map(|alpha| [0.99, 0.5, 0.1, 1e-3].map(|cos| (alpha, cos)))
}

/// The largest distance [ε] of a place from the numbers that the facet there was drawn by, and where.
fn displacement<N: Number, D: Distribution<N>>() -> (f64, String) {
    let mut worst = (0.0, String::new());
    // From below too, where walks look from.
    let below = [([1.0; 2], -0.5), ([0.3; 2], -0.1), ([1.0, 0.1], -0.05)];
    for (alpha, cos) in views().chain(below) {
        let up = direction(f64::abs(cos), 0.7).flipped(cos < 0.0);
        let (facets, wo) = (D::new(alpha.map(N::of)), Vector::<N>::of(up.lane(0)));
        // All over the square, and ever nearer to its corners.
        let spread = (0..1000).map(|k| golden(k, 1000));
        let ends = spread.clone().enumerate().map(|(k, [u, v])| {
            let [near, far] = [u, v].map(|x| 10_f64.powf(-16.0 * x));
            [if k % 2 == 0 { near } else { 1.0 - near }, if k % 3 == 0 { far } else { 1.0 - far }]
        });
        for u in spread.chain(ends) {
            let u = u.map(|u| N::of(u).min(N::of(1.0 - N::EPSILON)));
            let m = facets.visible(wo, u);
            let place = facets.place(wo, m);
            let [off, turn] = [0, 1].map(|axis| place[axis].lane(0) - u[axis].lane(0));
            // A whole turn is none, and about the top of a cap, or its nadir, a turn is little.
            let part = u[0].lane(0);
            let turn = (turn - turn.round()) * (part * (1.0 - part)).sqrt();
            // The half vector of a cap's directions cancels where the facet is seen edge-on.
            let seen = if D::SLOPES == Slopes::Ggx { seen_cosine(alpha, up, m.lane(0)) } else { 1.0 };
            let off = off.abs().max(turn.abs()) * seen / N::EPSILON;
            if !(off.is_finite() && off <= worst.0) {
                worst = (off, format!("α {alpha:?} μ {cos} u {u:?}: {place:?}"));
            }
        }
    }
    worst
}

/// The cosine [1] at which a facet is seen once the surface is stretched so that α = 1.
fn seen_cosine([along, across]: [f64; 2], w: Vector<f64>, [x, y, z]: [f64; 3]) -> f64 {
    let ball = Vector::new(along * w.x, across * w.y, w.z).normalised();
    ball.dot(Vector::new(x / along, y / across, z).normalised()).abs()
}

#[test]
fn visible_facets_come_from_their_place() {
    // The place comes back from the facet by another route than the drawing, through the view's azimuth and shares; that it
    // does makes facets of even numbers fill the square evenly. A dozen roundings lie between.
    let ggx = [displacement::<f64, Ggx<f64>>(), displacement::<f32, Ggx<f32>>()];
    let beckmann = [displacement::<f64, Beckmann<f64>>(), displacement::<f32, Beckmann<f32>>()];
    for (off, place) in ggx.into_iter().chain(beckmann) {
        assert!(off <= 16.0, "{off} at {place}");
    }
}

#[test]
fn the_squares_area_is_the_visible_density() {
    // |∂(u₁, u₂)/∂ω| by differences: the square knows nothing of D or Λ.
    fn worst<D: Distribution<f64>>() -> f64 {
        let mut worst = 0.0_f64;
        for (alpha, cos) in views().filter(|(alpha, cos)| alpha[0] > 0.1 && *cos > 0.01) {
            let (facets, wo) = (D::new(alpha), direction(cos, 0.7));
            for u in [[0.2, 0.3], [0.6, 0.8], [0.45, 0.55]] {
                let m = facets.visible(wo, u);
                // Two directions across m, one of length 1 each.
                let east = Vector::new(m.z, 0.0, -m.x).normalised();
                let north =
                    Vector::new(m.y * east.z - m.z * east.y, m.z * east.x - m.x * east.z, m.x * east.y - m.y * east.x);
                let step = 1e-5;
                let slope = |way: Vector<f64>| {
                    let [ahead, behind] = [step, -step].map(|by| facets.place(wo, (m + way.scaled(by)).normalised()));
                    let turn = |d: f64| d - d.round();
                    [turn(ahead[0] - behind[0]) / (2.0 * step), turn(ahead[1] - behind[1]) / (2.0 * step)]
                };
                let (e, n) = (slope(east), slope(north));
                let area = (e[0] * n[1] - e[1] * n[0]).abs();
                let off = (area / visible_density(&facets, wo, m) - 1.0).abs();
                assert!(off.is_finite(), "α {alpha:?} μ {cos}");
                worst = worst.max(off);
            }
        }
        worst
    }
    assert!(worst::<Ggx<f64>>() < 1e-5, "{}", worst::<Ggx<f64>>());
    assert!(worst::<Beckmann<f64>>() < 1e-5, "{}", worst::<Beckmann<f64>>());
}

#[test]
fn samples_agree_with_value_and_density() {
    let kinds = [
        (Slopes::Ggx, Joint::Correlated),
        (Slopes::Ggx, Joint::Separable),
        (Slopes::Beckmann, Joint::Correlated),
        (Slopes::Beckmann, Joint::Separable),
    ];
    for entry in zoo::<f64>().iter().filter(|entry| ["rough-conductor", "rough-dielectric"].contains(&entry.name)) {
        for ((slopes, joint), (alpha, cos)) in kinds.into_iter().flat_map(|kind| views().map(move |view| (kind, view)))
        {
            let model = entry.make(&Setting { alpha, slopes, joint, ..Setting::default() });
            for cos in [cos, -cos].into_iter().filter(|cos| *cos > 0.0 || model.character().transmits) {
                let place = format!("{} {slopes:?} {joint:?} α {alpha:?} μ {cos}", entry.name);
                let (wo, mut random) = (direction(cos, 0.7), stream(12, &place));
                for _ in 0..300 {
                    let drawn = model.sample(wo, [(); 3].map(|()| uniform(&mut random, 0.0, 1.0)));
                    let bound = model.character().largest_weight * drawn.compression;
                    assert!(drawn.weight[0] <= bound * (1.0 + 1e-10), "{place}: {drawn:?}");
                    agree(model.as_ref(), wo, &drawn, alpha[0].min(alpha[1]), &place);
                }
            }
        }
    }
}

/// That value, density and weight are one, and f the same both ways.
fn agree(model: &dyn Bsdf<f64>, wo: Vector<f64>, drawn: &Sample<f64>, alpha: f64, place: &str) {
    // The half vector of narrow lobes keeps fewer digits than the facet: ε/(α μ) of a lobe.
    let close = 1e-9 + 1e-14 / (alpha * wo.z * wo.z).powi(2);
    if drawn.pdf == 0.0 || drawn.wi.z.abs() < 1e-6 || close > 1e-2 {
        return;
    }
    let (f, pdf) = model.eval_pdf(drawn.wi, wo);
    let weight = f[0] * drawn.wi.z.abs() / pdf;
    assert!((pdf / drawn.pdf - 1.0).abs() < close, "{place}: {pdf} {drawn:?}");
    assert!((weight - drawn.weight[0]).abs() < close, "{place}: {weight} {drawn:?}");
    // What is carried into the denser side is n² as much radiance.
    let back = model.eval(wo, drawn.wi)[0] * drawn.compression;
    assert!((back / f[0] - 1.0).abs() < 1e-6, "{place}: {f:?} {back}");
}
