//! From the square to directions and places, each with its density.

use crate::number::{Number, Vector, sin_cos_turns};
use std::f64::consts::{FRAC_1_PI, PI};

/// A direction of the upper half, all alike, and its density [sr⁻¹], 1/2π.
#[inline(always)]
pub fn uniform_hemisphere<N: Number>(u: [N; 2]) -> (Vector<N>, N) {
    let (sin, cos) = sin_cos_turns(u[1]);
    let one = N::of(1.0);
    let height = one - u[0];
    let radius = (u[0] * (one + height)).sqrt();
    (Vector::new(radius * cos, radius * sin, height), N::of(0.5 * FRAC_1_PI))
}

/// A direction of the upper half by its cosine, and its density [sr⁻¹], cos θ/π.
#[inline(always)]
pub fn cosine_hemisphere<N: Number>(u: [N; 2]) -> (Vector<N>, N) {
    let (sin, cos) = sin_cos_turns(u[1]);
    let (radius, height) = (u[0].sqrt(), (N::of(1.0) - u[0]).sqrt());
    (Vector::new(radius * cos, radius * sin, height), height * N::of(FRAC_1_PI))
}

/// A direction of the whole sphere, all alike.
#[inline(always)]
pub fn sphere<N: Number>(u: [N; 2]) -> Vector<N> {
    let (sin, cos) = sin_cos_turns(u[1]);
    let one = N::of(1.0);
    let height = one - u[0] - u[0];
    // 1 − (1 − 2u)² without the loss at the poles.
    let radius = (N::of(4.0) * u[0] * (one - u[0])).sqrt();
    Vector::new(radius * cos, radius * sin, height)
}

/// A place in the disc of radius 1, all alike.
#[inline(always)]
pub fn disc<N: Number>(u: [N; 2]) -> [N; 2] {
    let (sin, cos) = sin_cos_turns(u[1]);
    let radius = u[0].sqrt();
    [radius * cos, radius * sin]
}

/// A place in the triangle of corners (0, 0), (1, 0), (0, 1), all alike.
#[inline(always)]
pub fn triangle<N: Number>(u: [N; 2]) -> [N; 2] {
    let root = u[0].sqrt();
    [N::of(1.0) - root, u[1] * root]
}

/// A direction within a cone about z, all alike: with its 1 − cos θ, for its cosine is no use to those who need the sine.
#[inline(always)]
pub fn cone<N: Number>(one_minus_cos: N, u: [N; 2]) -> (Vector<N>, N) {
    let (sin, cos) = sin_cos_turns(u[1]);
    let off = one_minus_cos * u[0];
    let radius = (off * (N::of(2.0) - off)).max(N::of(0.0)).sqrt();
    (Vector::new(radius * cos, radius * sin, N::of(1.0) - off), off)
}

/// The density [sr⁻¹] of [`cone`].
#[inline(always)]
pub fn cone_density<N: Number>(one_minus_cos: N) -> N {
    N::of(1.0) / (N::of(2.0 * PI) * one_minus_cos)
}

/// 1 − cos θ of an angle by the square of its sine, θ ≤ 90°: without loss where it is small.
#[inline(always)]
pub fn one_minus_cos<N: Number>(sin2: N) -> N {
    let one = N::of(1.0);
    sin2 / (one + (one - sin2).max(N::of(0.0)).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A map from the square keeps shares if the part of the domain below any level is the part of the square that it comes
    /// from: of a grid of midpoints, the share of what `at` puts below `level`.
    fn share(at: impl Fn([f64; 2]) -> f64, level: f64) -> f64 {
        const SIDE: usize = 400;
        let mut below = 0;
        for k in 0..SIDE * SIDE {
            let u = [k / SIDE, k % SIDE].map(|k| (k as f64 + 0.5) / SIDE as f64);
            below += usize::from(at(u) < level);
        }
        below as f64 / (SIDE * SIDE) as f64
    }

    #[test]
    fn shares_of_the_square_are_shares_of_the_domain() {
        for level in [0.1, 0.35, 0.7, 0.95] {
            let squared = |v: Vector<f64>| v.dot(v);
            // Heights of a hemisphere all alike; by the cosine their square; of a sphere (1 + z)/2.
            let tries = [
                ("uniform", share(|u| uniform_hemisphere(u).0.z, level), level),
                ("cosine", share(|u| cosine_hemisphere(u).0.z, level), level * level),
                ("sphere", share(|u| sphere(u).z, level), (1.0 + level) / 2.0),
                ("disc", share(|u| f64::hypot(disc(u)[0], disc(u)[1]), level), level * level),
                ("triangle", share(|u| triangle(u)[0], level), 1.0 - (1.0 - level).powi(2)),
                ("its other side", share(|u| triangle(u)[1], level), 1.0 - (1.0 - level).powi(2)),
                ("cone", share(|u| cone(0.3, u).1, 0.3 * level), level),
            ];
            for (name, found, exact) in tries {
                // A grid of 400 sees a straight edge to 1/400.
                assert!((found - exact).abs() < 2.6e-3, "{name}: {found} against {exact}");
            }
            for u in [[0.0, 0.3], [0.5, 0.9], [0.999, 0.1]] {
                for v in [uniform_hemisphere(u).0, cosine_hemisphere(u).0, sphere(u), cone(1e-9, u).0, cone(0.3, u).0] {
                    assert!((squared(v) - 1.0).abs() < 1e-14);
                }
            }
        }
    }

    #[test]
    fn densities_are_one_over_what_they_spread_over() {
        assert_eq!(uniform_hemisphere([0.4, 0.2]).1, 1.0 / (2.0 * PI));
        let (w, pdf) = cosine_hemisphere([0.4, 0.2]);
        assert!((pdf - w.z / PI).abs() < 1e-16);
        assert_eq!(cone_density(1.0), 1.0 / (2.0 * PI));
        // The Sun, 4.65 mrad in radius: 1 − cos by its series, where the difference itself keeps eleven digits.
        let sin2 = 4.65e-3_f64.sin().powi(2);
        let series = 4.65e-3_f64.powi(2) / 2.0 - 4.65e-3_f64.powi(4) / 24.0 + 4.65e-3_f64.powi(6) / 720.0;
        assert!((one_minus_cos(sin2) / series - 1.0).abs() < 1e-15);
    }
}
