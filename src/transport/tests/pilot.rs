//! What a few samples of each pixel say it is worth.

use super::*;
use crate::transport::pilot::{MOST, Pilot};

/// A floor that is dark to the left and lit by a far lamp behind a grid of bars to the right.
fn barred(pixels: u32) -> Scene {
    let floor = quad([[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]]);
    let glow = quad([[-1.0, -1.0, 0.001], [0.0, -1.0, 0.001], [0.0, 1.0, 0.001], [-1.0, 1.0, 0.001]]);
    let lamp = quad([[0.2, -0.4, 1.0], [0.2, 0.4, 1.0], [1.0, 0.4, 1.0], [1.0, -0.4, 1.0]]);
    let bar = |x: f64| {
        let [from, to] = [x, x + 0.05];
        shape(quad([[from, -1.0, 0.5], [to, -1.0, 0.5], [to, 1.0, 0.5], [from, 1.0, 0.5]]), "black")
    };
    let mut shapes: Vec<Shape> = (0..10).map(|at| bar(0.1 * f64::from(at))).collect();
    shapes.extend([
        shape(floor, "grey"),
        shining(shape(glow, "black"), [0.5; 3], false),
        shining(shape(lamp, "black"), [9.0; 3], false),
    ]);
    let camera = Camera { up: [0.0, 1.0, 0.0], ..looking([0.0, 0.0, 4.0], [0.0; 3], 26.0, pixels) };
    scene(camera, 2, vec![diffuse("grey", [0.5; 3]), diffuse("black", [0.0; 3])], shapes)
}

fn worth(of: &Scene) -> Vec<u32> {
    let stage = Stage::<F32x8>::new(of, Structure::Best).expect("a scene without a flaw");
    let pilot = Pilot::new(&stage, &Tactics::default(), Choice::Net, 8, 1);
    let [width, height] = stage.size();
    (0..width * height).map(|at| pilot.samples([at % width, at / width])).collect()
}

#[test]
fn noise_is_given_more_samples_than_quiet() {
    const SIDE: usize = 32;
    let found = worth(&barred(SIDE as u32));
    assert!(found.iter().all(|samples| samples.is_power_of_two() && *samples <= MOST), "{found:?}");
    // To the left all is known by one sample; of what lies to the right little is. Along the border neighbours are heard.
    let mean = |columns: std::ops::Range<usize>| {
        let some = found.chunks(SIDE).flat_map(|row| &row[columns.clone()]);
        some.map(|samples| f64::from(*samples)).sum::<f64>() / (SIDE * columns.len()) as f64
    };
    let [quiet, noisy] = [mean(0..SIDE / 2 - 2), mean(SIDE / 2 + 2..SIDE)];
    assert_eq!(quiet, 1.0);
    assert!(noisy > 1.5, "{noisy}");
}

#[test]
fn a_pilot_changes_no_mean_and_gains_more_than_it_costs() {
    let barred = barred(32);
    let plain = Tactics { pilot: false, extra: 1, ..Tactics::default() };
    let with_pilot = Tactics { extra: 1, ..Tactics::default() };
    let of = |tactics, seed| filmed(&barred, &with(tactics, seed), &[0..64]).halves();
    let (piloted, alike) = (of(with_pilot, 1), of(plain, 2));
    let p = normal_two_sided(apart(&piloted, &alike));
    assert!(p > SIGNIFICANCE, "p = {p:.1e}");
    // The picture's error against the samples that it took: taken alike, both are 1.
    let error = |picture: &[Halves]| -> f64 {
        let of = |halves: &Halves| {
            let [a, b] = halves.map(|half| f64::from(half[1]));
            (a - b).powi(2) / ((0.5 * (a + b)).powi(2) + 0.01)
        };
        picture.iter().map(of).sum()
    };
    let taken = worth(&barred).iter().map(|samples| f64::from(*samples)).sum::<f64>() / 1024.0;
    let gain = error(&alike) / error(&piloted) / taken;
    assert!(gain > 1.0, "{gain} with {taken} samples");
}

#[test]
fn nothing_is_worth_more_where_nothing_errs() {
    let mut dark = barred(9);
    dark.shapes.iter_mut().for_each(|shape| shape.emission = None);
    assert_eq!(worth(&dark), [1; 81]);
    let single = worth(&barred(1));
    assert_eq!(single.len(), 1);
}

#[test]
fn large_pictures_share_their_pilot() {
    // Wide, flat, and of no even number: no pixel is left without.
    for size in [[2049, 700], [100_000, 3]] {
        let mut wide = barred(1);
        [wide.camera.width, wide.camera.height] = size;
        let stage = Stage::<F32x8>::new(&wide, Structure::Best).expect("a scene without a flaw");
        let pilot = Pilot::new(&stage, &Tactics::default(), Choice::Net, 8, 1);
        let [width, height] = size;
        for pixel in [[0, 0], [width - 1, 0], [0, height - 1], [width - 1, height - 1]] {
            assert!(pilot.samples(pixel) >= 1);
        }
        assert_eq!(pilot.samples([0, 0]), pilot.samples([1, 1]), "two pixels of one square");
    }
}
