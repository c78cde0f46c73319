//! Surfaces: samples with their weight and density, and the value at what was drawn, a second and a core.
//! `cargo bench -p light --bench bsdf`

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use light::bsdf::fresnel::Conductor;
use light::bsdf::lambert::Lambert;
use light::bsdf::microfacet::{Distribution, Ggx, Joint};
use light::bsdf::rough_conductor::RoughConductor;
use light::bsdf::{Bsdf, Guarded};
use light::number::{Dice, F32x8, Number, Vector, vectorised};

fn main() {
    divan::main();
}

const SAMPLES: usize = 8192;

/// Draws, and asks for the value of what was drawn; light from a fan of directions.
#[inline(always)]
fn run<N: Number>(model: &impl Bsdf<N>) -> N {
    let mut sum = N::of(0.0);
    let lanes = N::from_lanes(|lane| lane as f64 / 8.0);
    for k in 0..SAMPLES / N::LANES {
        let mut dice = Dice::new(N::of(k as f64), lanes);
        let z = N::of(0.2) + N::of(0.8) * dice.throw();
        let wo = Vector::new((N::of(1.0) - z * z).sqrt(), N::of(0.0), z);
        let drawn = model.sample(wo, [dice.throw(), dice.throw(), dice.throw()]);
        let (f, pdf) = model.eval_pdf(drawn.wi, wo);
        sum = sum + drawn.weight[0] + f[0] + f[1] + f[2] + pdf + drawn.pdf;
    }
    sum
}

fn gold<N: Number>() -> RoughConductor<N, Ggx<N>> {
    let metal = Conductor { n: [0.14, 0.43, 1.38].map(N::of), k: [4.1, 2.46, 1.92].map(N::of) };
    RoughConductor { facets: Ggx::new([N::of(0.3); 2]), joint: Joint::Correlated, metal }
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
    bench::<F32x8>(bencher, Guarded(gold()));
}

#[divan::bench]
fn rough_conductor_f32(bencher: Bencher) {
    bench::<f32>(bencher, Guarded(gold()));
}

#[divan::bench]
fn rough_conductor_lanes_without_dispatch(bencher: Bencher) {
    let model = Guarded(gold::<F32x8>());
    bencher.counter(ItemsCount::new(SAMPLES)).bench_local(|| run(black_box(&model)));
}

#[divan::bench]
fn lambert_lanes(bencher: Bencher) {
    bench::<F32x8>(bencher, Guarded(Lambert { albedo: [F32x8::of(0.5); 3] }));
}

#[divan::bench]
fn lambert_f32(bencher: Bencher) {
    bench::<f32>(bencher, Guarded(Lambert { albedo: [0.5; 3] }));
}
