//! Rough metal: what is drawn follows its density, weights keep their bound, and f is the same both ways.

use super::direction;
use crate::bsdf::microfacet::{Beckmann, Distribution, Ggx, Joint, Slopes, visible_density};
use crate::bsdf::{Bsdf, Sample, Setting, zoo};
use crate::number::Vector;
use yardstick::random::{stream, uniform};
use yardstick::statistics::{chi_square, sidak};

/// p of the claim that visible facets fill the sampler's own square as their density says: it is 1 there, so counts are even.
/// The place comes back from the facet by another route than the drawing, through the view's azimuth and shares.
fn evenness<D: Distribution<f64>>(alpha: [f64; 2], wo: Vector<f64>, address: &str) -> f64 {
    const SIDE: usize = 16;
    let (facets, mut random) = (D::new(alpha), stream(11, address));
    let mut counts = vec![0_u64; SIDE * SIDE];
    let draws = 100_000;
    for _ in 0..draws {
        let u = [uniform(&mut random, 0.0, 1.0), uniform(&mut random, 0.0, 1.0)];
        let m = facets.visible(wo, u);
        let at = facets.place(wo, m).map(|u| ((u.rem_euclid(1.0) * SIDE as f64) as usize).min(SIDE - 1));
        counts[at[0] * SIDE + at[1]] += 1;
    }
    chi_square(&counts, &vec![draws as f64 / (SIDE * SIDE) as f64; SIDE * SIDE]).p
}

fn views() -> impl Iterator<Item = ([f64; 2], f64)> {
    let alphas = [[1e-4; 2], [0.01; 2], [0.3; 2], [1.0; 2], [1.0, 0.1]];
    alphas.into_iter().flat_map(|alpha| [0.99, 0.5, 0.1, 1e-3].map(|cos| (alpha, cos)))
}

#[test]
fn visible_facets_fill_their_square() {
    // Forty tests, at 1e−3 together.
    for (alpha, cos) in views() {
        let wo = direction(cos, 0.7);
        for p in [
            evenness::<Ggx<f64>>(alpha, wo, &format!("ggx {alpha:?} {cos}")),
            evenness::<Beckmann<f64>>(alpha, wo, &format!("beckmann {alpha:?} {cos}")),
        ] {
            assert!(p > sidak(1e-3, 40), "α {alpha:?} μ {cos}: p {p}");
        }
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
