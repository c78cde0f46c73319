//! Pixels that are worth more samples.

use super::*;
use crate::transport::looks::several;

/// Pixels along a side of the picture.
const SIDE: u32 = 24;

/// A ball that shines, ahead of a camera that sees it as a circle; its radius in pixels is the other result.
fn ball() -> (Scene, f64) {
    let (radius, distance, fov) = (0.5, 3.0, 30.0_f64);
    let camera = looking([0.0; 3], [0.0, 0.0, 1.0], fov, SIDE);
    let sphere = Geometry::Sphere { center: [0.0, 0.0, distance], radius };
    let lamp = shining(shape(sphere, "black"), [5.0; 3], false);
    // Its rim is where rays touch it: sin = r/d.
    let tangent = f64::tan((radius / distance).asin());
    let pixels = f64::from(SIDE) / 2.0 / (0.5 * fov).to_radians().tan();
    (scene(camera, 2, vec![diffuse("black", [0.0; 3])], vec![lamp]), tangent * pixels)
}

fn factors<N: Width>(of: &Scene) -> Vec<u32> {
    let stage = Stage::<N>::new(of, Structure::Best).expect("a scene without a flaw");
    let pixels: Vec<[u32; 2]> = (0..SIDE * SIDE).map(|at| [at % SIDE, at / SIDE]).collect();
    several(&stage, &Tactics::default(), &pixels)
}

#[test]
fn a_lamps_rim_is_found_wherever_it_crosses_a_pixel() {
    let (ball, radius) = ball();
    let found = factors::<F32x8>(&ball);
    assert_eq!(found, factors::<f32>(&ball));
    let middle = f64::from(SIDE) / 2.0;
    for (at, times) in found.into_iter().enumerate() {
        let [x, y] = [at as u32 % SIDE, at as u32 / SIDE].map(|place| f64::from(place) + 0.5 - middle);
        // The nearest and the farthest point of the pixel, by the distance of its middle along either axis.
        let nearest = (x.abs() - 0.5).max(0.0).hypot((y.abs() - 0.5).max(0.0));
        let farthest = (x.abs() + 0.5).hypot(y.abs() + 0.5);
        let is_crossed = nearest < radius && radius < farthest;
        // A little around it may count too.
        let is_far = (x.hypot(y) - radius).abs() > 0.6 * 2.0_f64.sqrt();
        assert!(!is_crossed || times == 8, "{x} {y}");
        assert!(!is_far || times == 1, "{x} {y}");
    }
}

#[test]
fn a_rim_looked_at_closely_is_as_bright_and_quieter() {
    // All the light of the picture is the circle's area, whatever its rim costs.
    let (ball, radius) = ball();
    let exact = 5.0 * std::f64::consts::PI * radius * radius;
    let with = |extra| {
        let of = |seed| {
            let manner =
                Manner { method: Method::Fast(Tactics { extra, ..Tactics::default() }), seed, ..Manner::default() };
            let renderer = Renderer::new(&ball, &manner, 4).expect("a scene without a flaw");
            let sums = renderer.sums(0..SIDE, 0..4);
            sums.iter().map(|halves| f64::from(halves[0][0] + halves[1][0]) / 8.0).sum::<f64>()
        };
        (0..64).map(of).collect::<Moments>()
    };
    let (many, one) = (with(8), with(1));
    for found in [&many, &one] {
        let p = t_test(found, exact).p;
        assert!(p > SIGNIFICANCE / 2.0, "{} against {exact}: p = {p:.1e}", found.mean());
    }
    // Eight times the samples scatter an eighth, if points are as even as chance; of 64 pictures each a quotient of variances is
    // off by less than 3 but once in 10⁵ times.
    assert!(many.variance() < one.variance() / 8.0 * 3.0, "{} {}", many.variance(), one.variance());
}
