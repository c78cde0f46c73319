//! D, Λ and G₁ against arbitrary precision, in every width.

use crate::bsdf::microfacet::{Beckmann, Distribution, Ggx, lambda, masking};
use crate::number::{F32x8, Number, Vector};
use crate::references::microfacet::{NAMES, Slopes, microfacet};
use yardstick::precise::relative_error;

/// The largest |error|/(ε(1 + κ)), and where.
fn worst<N: Number, D: Distribution<N>>(slopes: Slopes) -> [(f64, String); 3] {
    let mut worst = [const { (0.0, String::new()) }; 3];
    for alpha in [1e-4, 1e-3, 0.03, 0.2, 0.5, 1.0] {
        // Across the lobe of facets, and to grazing.
        let slopes_ = [0.0, 0.01, 0.3, 1.0, 1.7, 3.0, 5.0].map(|x: f64| (x * alpha).atan());
        let grazing = [0.3, 0.9, 1.3, 1.5, 1.57, std::f64::consts::FRAC_PI_2 - 1e-6];
        for theta in slopes_.into_iter().chain(grazing) {
            let rounded = |x: f64| N::of(x).lane(0);
            let w = [theta.sin() * 0.8, theta.sin() * 0.6, theta.cos()].map(rounded);
            let alpha = rounded(alpha);
            let (exact, conditions) = microfacet(slopes, alpha, w);
            let facets = D::new([N::of(alpha); 2]);
            let v = Vector::of(w);
            let ours = [facets.density(v), lambda(&facets, v), masking(&facets, v)];
            for k in 0..3 {
                let tiny = exact[k] < yardstick::precise::real(1e-36);
                let error = relative_error(ours[k].lane(0), &exact[k]);
                let ratio = error / (N::EPSILON * (1.0 + conditions[k]));
                if !tiny && (ratio > worst[k].0 || ratio.is_nan()) {
                    worst[k] = (ratio, format!("{} α {alpha} w {w:?}: {}", NAMES[k], ours[k].lane(0)));
                }
            }
        }
    }
    worst
}

fn within_two_roundings<N: Number, D: Distribution<N>>(slopes: Slopes) {
    for (ratio, place) in worst::<N, D>(slopes) {
        assert!(ratio <= 2.0, "{ratio} at {place}");
    }
}

#[test]
fn ggx_keeps_its_digits() {
    within_two_roundings::<f64, Ggx<f64>>(Slopes::Ggx);
    within_two_roundings::<f32, Ggx<f32>>(Slopes::Ggx);
    within_two_roundings::<F32x8, Ggx<F32x8>>(Slopes::Ggx);
}

#[test]
fn beckmann_keeps_its_digits() {
    within_two_roundings::<f64, Beckmann<f64>>(Slopes::Beckmann);
    within_two_roundings::<f32, Beckmann<f32>>(Slopes::Beckmann);
    within_two_roundings::<F32x8, Beckmann<F32x8>>(Slopes::Beckmann);
}
