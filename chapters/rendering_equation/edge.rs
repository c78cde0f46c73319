//! Race of C20: one form factor where it is hardest, at a common edge.

use crate::vocabulary::{Heat, Judge, Race, lane, race};
use light::radiosity::Patch;
use light::radiosity::exchange::{around, by_middles, by_rim, exchange};
use light::references::radiometry as precisely;
use std::f64::consts::PI;
use yardstick::precise;
use yardstick::random::uniform;

/// A square and one that stands on its edge: the hardest pair, for r falls to nothing.
fn hinged() -> [Patch; 2] {
    [
        Patch::parallelogram([0.0; 3], [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]),
        Patch::parallelogram([0.0; 3], [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]),
    ]
}

fn wrong() -> Judge {
    let exact = precisely::perpendicular_rectangles(1.0, 1.0, 1.0).value;
    Box::new(move |found| precise::relative_error(found[0], &exact))
}

pub(super) const EDGE: Race = race(
    "edge",
    "two squares with a common edge: pairs of points are slow where r is 0; the rim of one and points of the other do better; rims of both, and closed forms, are exact",
)
.work("pairs of points, or points")
.error("relative error of F", "relative error (rms over 32 seeds by chance), against Howell's C-14 in 512 bits")
.lanes(&[
    lane("chance", "pairs of points by chance", &[256, 1024, 4096, 16384, 65536], |bench, work| {
        let [one, other] = hinged();
        let points: Vec<[f64; 4]> =
            (0..work).map(|_| [(); 4].map(|()| uniform(&mut bench.stream, 0.0, 1.0))).collect();
        Heat {
            run: Box::new(move || {
                let adds = |[a, b, c, d]: &[f64; 4]| {
                    let ([x, y, _], [_, eta, z]) = (one.at([*a, *b]), other.at([*c, *d]));
                    x * z / (x * x + z * z + (y - eta) * (y - eta)).powi(2)
                };
                vec![points.iter().map(adds).sum::<f64>() / (PI * points.len() as f64)]
            }),
            error: wrong(),
        }
    })
    .repeated(32)
    .order(0.5, 0.2),
    lane("middles", "pairs of middles of small squares", &[16, 256, 4096, 65536], |_, work| {
        let n = (work as f64).sqrt().sqrt().round() as usize;
        Heat {
            run: Box::new(move || {
                let [one, other] = hinged();
                vec![by_middles(&one, &other, n, |_, _| true)[1]]
            }),
            error: wrong(),
        }
    })
    .order(0.25, 0.08),
    lane("rim", "points of one, the rim of the other", &[16, 64, 256, 1024], |_, work| {
        let n = (work as f64).sqrt().round() as usize;
        Heat {
            run: Box::new(move || {
                let [one, other] = hinged();
                vec![by_rim(&one, &other, n)]
            }),
            error: wrong(),
        }
    })
    .order(1.0, 0.15),
    lane("contour", "around both", &[1], |_, _| Heat {
        run: Box::new(|| {
            let [one, other] = std::hint::black_box(hinged());
            vec![around(&one, &other)]
        }),
        error: wrong(),
    })
    .within(1e-13, "eight pairs of parallel edges, a few ulp each, over a sum of 0.2"),
    lane("closed", "sixteen terms", &[1], |_, _| Heat {
        run: Box::new(|| {
            let [one, other] = std::hint::black_box(hinged());
            vec![exchange(&one, &other)]
        }),
        error: wrong(),
    })
    .within(1e-14, "sixteen terms of order 1, a few ulp each, over a sum of 0.2"),
]);
