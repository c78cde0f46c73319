//! No bit pattern gets anything but finite numbers out of a model.

use crate::bsdf::microfacet::{Joint, Slopes};
use crate::bsdf::{Bsdf, Sample, Setting, zoo};
use crate::number::{Eight, F32x8, Number, Vector};
use proptest::prelude::*;

/// What `model` answers to anything is finite, and a direction that it draws with any weight has a length of 1.
fn answers<N: Number>(name: &str, model: &dyn Bsdf<N>, wi: Vector<N>, wo: Vector<N>, u: [N; 3]) {
    let (f, pdf) = model.eval_pdf(wi, wo);
    let Sample { wi: drawn, weight, pdf: density, compression, .. } = model.sample(wo, u);
    let albedo = model.albedo(wo).unwrap_or([N::of(0.0); 3]);
    for lane in 0..N::LANES {
        let numbers = f.into_iter().chain(weight).chain(albedo).chain([pdf, density, compression]);
        for number in numbers {
            let number = number.lane(lane);
            assert!(number.is_finite() && number >= 0.0, "{name}: {number} from wi {wi:?} wo {wo:?} u {u:?}");
        }
        let length2: f64 = drawn.lane(lane).iter().map(|x| x * x).sum();
        assert!((length2 - 1.0).abs() < 1.5e-3, "{name}: drew {drawn:?} for {wo:?} and {u:?}");
    }
}

/// Numbers where formulas break, and any others.
fn bits() -> impl Strategy<Value = f32> {
    prop_oneof![
        any::<u32>().prop_map(f32::from_bits),
        -1.0..1.0_f32,
        prop::sample::select(vec![0.0, -0.0, 1.0, -1.0, 1e-45, -1e-45, 1e-38, 1e-20, 1e-7, -1e-7, f32::NAN, f32::MAX]),
    ]
}

/// Three numbers, as they are or brought to length 1.
fn vector() -> impl Strategy<Value = [f32; 3]> {
    (prop::array::uniform3(bits()), any::<bool>()).prop_map(|(v, unit)| {
        let length = v.iter().map(|x| f64::from(*x).powi(2)).sum::<f64>().sqrt();
        if unit { v.map(|x| (f64::from(x) / length) as f32) } else { v }
    })
}

fn setting() -> impl Strategy<Value = Setting> {
    let kind = (any::<bool>(), any::<bool>());
    let parts = (prop::array::uniform3(bits()), prop::array::uniform2(bits()), bits(), bits(), bits(), bits(), kind);
    parts.prop_map(|(albedo, alpha, roughness, index, n, k, (is_ggx, is_correlated))| Setting {
        albedo: albedo.map(f64::from),
        alpha: alpha.map(f64::from),
        slopes: if is_ggx { Slopes::Ggx } else { Slopes::Beckmann },
        joint: if is_correlated { Joint::Correlated } else { Joint::Separable },
        roughness: roughness.into(),
        index: index.into(),
        metal: [num_complex::Complex64::new(n.into(), k.into()); 3],
        film: None,
    })
}

#[test]
fn what_is_not_fit_sees_nothing() {
    let up = [0.6, 0.0, 0.8];
    let unfit =
        [[0.6, 0.0, 0.79], [1.0, 0.0, 5e-8], [0.6, f32::NAN, 0.8], [f32::NAN; 3], [0.0; 3], [f32::INFINITY, 0.0, 0.0]];
    let of = |[x, y, z]: [f32; 3]| Vector::new(x, y, z);
    for entry in zoo::<f32>() {
        let model = entry.make(&Setting::default());
        for unfit in unfit {
            for (wi, wo) in [(unfit, up), (up, unfit), (unfit, unfit)] {
                let (f, pdf) = model.eval_pdf(of(wi), of(wo));
                assert_eq!((f, pdf), ([0.0; 3], 0.0), "{} {wi:?} {wo:?}", entry.name);
            }
            let drawn = model.sample(of(unfit), [0.3; 3]);
            assert_eq!((drawn.weight, drawn.pdf), ([0.0; 3], 0.0), "{} {unfit:?}", entry.name);
            assert!(model.albedo(of(unfit)).is_none_or(|albedo| albedo == [0.0; 3]), "{} {unfit:?}", entry.name);
        }
        // Numbers outside 0 ≤ u < 1 count as one half.
        for outside in [1.0, -1e-9, f32::NAN, f32::INFINITY] {
            for axis in 0..3 {
                let (mut u, mut half) = ([0.3, 0.6, 0.2], [0.3, 0.6, 0.2]);
                (u[axis], half[axis]) = (outside, 0.5);
                let [found, expected] = [u, half].map(|u| format!("{:?}", model.sample(of(up), u)));
                assert_eq!(found, expected, "{} {outside} at {axis}", entry.name);
            }
        }
    }
}

proptest! {
    // Tables make models dear: few of them, asked often.
    #![proptest_config(ProptestConfig::with_cases(4))]
    #[test]
    fn gets_finite_numbers(setting in setting(), plain in any::<bool>(), cases in prop::collection::vec((vector(), vector(), prop::array::uniform3(bits())), 400)) {
        let setting = if plain { Setting { metal: Setting::default().metal, index: 1.5, alpha: [setting.alpha[0]; 2], ..setting } } else { setting };
        let of = |v: [f32; 3]| Vector::new(v[0], v[1], v[2]);
        let wide = |v: [f32; 3]| Vector::of(v.map(f64::from));
        for (narrow, doubled) in zoo::<f32>().iter().zip(zoo::<f64>()) {
            let (single, double) = (narrow.make(&setting), doubled.make(&setting));
            for (wi, wo, u) in &cases {
                answers(narrow.name, single.as_ref(), of(*wi), of(*wo), *u);
                answers(narrow.name, double.as_ref(), wide(*wi), wide(*wo), u.map(f64::from));
            }
        }
    }

    #[test]
    fn eight_lanes_are_eight_surfaces(plain in any::<bool>(), setting in setting(), groups in prop::collection::vec(prop::array::uniform8((vector(), vector(), prop::array::uniform3(bits()))), 40)) {
        let setting = if plain { Setting { metal: Setting::default().metal, index: 1.5, alpha: [setting.alpha[0]; 2], ..setting } } else { setting };
        let gather = |of: &dyn Fn(usize) -> f32| Eight(std::array::from_fn(of)) as F32x8;
        let all = |of: &dyn Fn(usize) -> [f32; 3]| Vector::new(gather(&|i| of(i)[0]), gather(&|i| of(i)[1]), gather(&|i| of(i)[2]));
        for (narrow, wide) in zoo::<f32>().iter().zip(zoo::<F32x8>()) {
            let (one, eight) = (narrow.make(&setting), wide.make(&setting));
            for cases in &groups {
                let (wi, wo) = (all(&|i| cases[i].0), all(&|i| cases[i].1));
                let u: [F32x8; 3] = std::array::from_fn(|k| gather(&|i| cases[i].2[k]));
                let (f, pdf) = eight.eval_pdf(wi, wo);
                let sample = eight.sample(wo, u);
                for (i, (wi, wo, u)) in cases.iter().enumerate() {
                    let of = |v: &[f32; 3]| Vector::new(v[0], v[1], v[2]);
                    let (lone_f, lone_pdf) = one.eval_pdf(of(wi), of(wo));
                    let lone = one.sample(of(wo), *u);
                    let lanes = [f[0], f[1], f[2], pdf, sample.wi.x, sample.wi.y, sample.wi.z, sample.weight[0], sample.pdf];
                    let alone = [lone_f[0], lone_f[1], lone_f[2], lone_pdf, lone.wi.x, lone.wi.y, lone.wi.z, lone.weight[0], lone.pdf];
                    for (k, (lane, alone)) in lanes.into_iter().zip(alone).enumerate() {
                        prop_assert_eq!(lane.0[i].to_bits(), alone.to_bits(), "{} output {} lane {}", narrow.name, k, i);
                    }
                }
            }
        }
    }
}
