//! Surfaces: samples with their weight, density and so their value, f = weight · density/cosine, a second and a core.
//! `cargo bench -p light --bench bsdf`

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use light::bsdf::compensated::Compensated;
use light::bsdf::fresnel::Conductor;
use light::bsdf::lambert::Lambert;
use light::bsdf::microfacet::{Beckmann, Distribution, Ggx, Joint};
use light::bsdf::rough_conductor::RoughConductor;
use light::bsdf::rough_dielectric::RoughDielectric;
use light::bsdf::walk::{Glass, Walk};
use light::bsdf::{Bsdf, Guarded};
use light::number::{Dice, F32x8, Number, Vector, vectorised};

fn main() {
    divan::main();
}

const SAMPLES: usize = 8192;

/// Light from a fan of directions: sample, density and value at once.
#[inline(always)]
fn run<N: Number>(model: &impl Bsdf<N>) -> N {
    let mut sum = N::of(0.0);
    let lanes = N::from_lanes(|lane| lane as f64 / 8.0);
    for k in 0..SAMPLES / N::LANES {
        let mut dice = Dice::new(N::of(k as f64), lanes);
        let z = N::of(0.2) + N::of(0.8) * dice.throw();
        let wo = Vector::new((N::of(1.0) - z * z).sqrt(), N::of(0.0), z);
        let drawn = model.sample(wo, [dice.throw(), dice.throw(), dice.throw()]);
        let value = drawn.pdf / drawn.wi.z.abs().max(N::of(1e-7));
        sum = sum + (drawn.weight[0] + drawn.weight[1] + drawn.weight[2]) * value + drawn.pdf;
    }
    sum
}

/// The value and density of two directions.
#[inline(always)]
fn value<N: Number>(model: &impl Bsdf<N>) -> N {
    let mut sum = N::of(0.0);
    let lanes = N::from_lanes(|lane| lane as f64 / 8.0);
    for k in 0..SAMPLES / N::LANES {
        let mut dice = Dice::new(N::of(k as f64), lanes);
        let (x, z) = (N::of(0.2) + N::of(0.8) * dice.throw(), N::of(0.2) + N::of(0.8) * dice.throw());
        let wo = Vector::new((N::of(1.0) - z * z).sqrt(), N::of(0.0), z);
        let wi = Vector::new(N::of(0.0), (N::of(1.0) - x * x).sqrt(), x);
        let (f, pdf) = model.eval_pdf(wi, wo);
        sum = sum + f[0] + f[1] + f[2] + pdf;
    }
    sum
}

fn gold<N: Number>() -> Conductor<N> {
    Conductor { n: [0.14, 0.43, 1.38].map(N::of), k: [4.1, 2.46, 1.92].map(N::of) }
}

fn facets<N: Number, D: Distribution<N>>() -> D {
    D::new([N::of(0.3); 2])
}

fn metal<N: Number, D: Distribution<N>>() -> Guarded<RoughConductor<D, Conductor<N>>> {
    Guarded(RoughConductor { facets: facets(), joint: Joint::Correlated, metal: gold() })
}

fn bench<N: Number>(bencher: Bencher, model: impl Bsdf<N>) {
    bencher.counter(ItemsCount::new(SAMPLES)).bench_local(|| {
        vectorised(
            #[inline(always)]
            || run(black_box(&model)),
        )
    });
}

#[divan::bench]
fn rough_conductor_lanes(bencher: Bencher) {
    bench::<F32x8>(bencher, metal::<_, Ggx<_>>());
}

#[divan::bench]
fn rough_conductor_f32(bencher: Bencher) {
    bench::<f32>(bencher, metal::<_, Ggx<_>>());
}

#[divan::bench]
fn rough_conductor_lanes_without_dispatch(bencher: Bencher) {
    let model = metal::<F32x8, Ggx<_>>();
    bencher.counter(ItemsCount::new(SAMPLES)).bench_local(|| run(black_box(&model)));
}

#[divan::bench]
fn rough_conductor_value_lanes(bencher: Bencher) {
    let model = metal::<F32x8, Ggx<_>>();
    bencher.counter(ItemsCount::new(SAMPLES)).bench_local(|| {
        vectorised(
            #[inline(always)]
            || value(black_box(&model)),
        )
    });
}

#[divan::bench]
fn rough_conductor_beckmann_lanes(bencher: Bencher) {
    bench::<F32x8>(bencher, metal::<_, Beckmann<_>>());
}

#[divan::bench]
fn rough_dielectric_lanes(bencher: Bencher) {
    bench::<F32x8>(bencher, Guarded(RoughDielectric::new(facets::<_, Ggx<_>>(), Joint::Correlated, F32x8::of(1.5))));
}

#[divan::bench]
fn conductor_compensated_lanes(bencher: Bencher) {
    bench::<F32x8>(bencher, Guarded(Compensated::metal(facets::<_, Ggx<_>>(), gold())));
}

#[divan::bench]
fn conductor_walk_lanes(bencher: Bencher) {
    bench::<F32x8>(bencher, Guarded(Walk::new(facets::<_, Ggx<_>>(), gold())));
}

#[divan::bench]
fn conductor_walk_f32(bencher: Bencher) {
    bench::<f32>(bencher, Guarded(Walk::new(facets::<_, Ggx<_>>(), gold())));
}

#[divan::bench]
fn dielectric_walk_lanes(bencher: Bencher) {
    bench::<F32x8>(bencher, Guarded(Walk::new(facets::<_, Ggx<_>>(), Glass::new(F32x8::of(1.5)))));
}

#[divan::bench]
fn lambert_lanes(bencher: Bencher) {
    bench::<F32x8>(bencher, Guarded(Lambert { albedo: [F32x8::of(0.5); 3] }));
}

#[divan::bench]
fn lambert_f32(bencher: Bencher) {
    bench::<f32>(bencher, Guarded(Lambert { albedo: [0.5; 3] }));
}
