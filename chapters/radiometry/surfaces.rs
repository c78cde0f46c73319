//! Closed surfaces as small patches, and flows from a point through them.

use glam::DVec3;
use std::f64::consts::TAU;
use yardstick::quadrature::{gauss_legendre, trapezoid};

/// A patch of a surface.
#[derive(Clone, Copy, Debug)]
pub struct Patch {
    /// Where it is [m].
    pub at: DVec3,
    /// Its area [m²] as a vector along its outward normal.
    pub area: DVec3,
}

/// The ellipsoid about `centre` with these half-axes [m], of `n` rings of 2n patches: Gauss's rule across the rings, the
/// trapezoid along them.
pub fn ellipsoid(centre: DVec3, axes: DVec3, n: usize) -> Vec<Patch> {
    let across = DVec3::new(axes.y * axes.z, axes.z * axes.x, axes.x * axes.y);
    let ring = |(u, share): (f64, f64)| {
        let z = 2.0 * u - 1.0;
        let sin = ((1.0 - z) * (1.0 + z)).sqrt();
        round(2 * n).map(move |(turn, step)| {
            let out = DVec3::new(sin * turn.cos(), sin * turn.sin(), z);
            Patch { at: centre + axes * out, area: across * out * (2.0 * share * step) }
        })
    };
    gauss_legendre(n).into_iter().flat_map(ring).collect()
}

/// The sphere about `centre` [m].
pub fn sphere(centre: DVec3, radius: f64, n: usize) -> Vec<Patch> {
    ellipsoid(centre, DVec3::splat(radius), n)
}

/// The ring of a tube: `large` [m] from the middle of the ring to the middle of the tube, `small` the radius of the tube;
/// 2n patches along the ring, n round the tube.
pub fn torus(centre: DVec3, large: f64, small: f64, n: usize) -> Vec<Patch> {
    let cut = |(turn, step): (f64, f64)| {
        round(n).map(move |(roll, part)| {
            let out = DVec3::new(roll.cos() * turn.cos(), roll.cos() * turn.sin(), roll.sin());
            let spine = DVec3::new(turn.cos(), turn.sin(), 0.0) * large;
            let distance = large + small * roll.cos();
            Patch { at: centre + spine + small * out, area: out * (small * distance * step * part) }
        })
    };
    round(2 * n).flat_map(cut).collect()
}

/// `n` even steps round a circle: where [rad], and how long each is [rad].
fn round(n: usize) -> impl Iterator<Item = (f64, f64)> {
    trapezoid(n).into_iter().skip(1).map(move |(share, _)| (TAU * share, TAU / n as f64))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn areas_are_those_of_the_books() {
        let area = |patches: &[Patch]| patches.iter().map(|patch| patch.area.length()).sum::<f64>();
        let sum = |patches: &[Patch]| patches.iter().map(|patch| patch.area).sum::<DVec3>().length();
        let (ball, ring) = (sphere(DVec3::X, 2.0, 12), torus(DVec3::Y, 3.0, 1.0, 24));
        assert!((area(&ball) / (16.0 * PI) - 1.0).abs() < 1e-13);
        assert!((area(&ring) / (12.0 * PI * PI) - 1.0).abs() < 1e-13);
        // Prolate, 1 : 1 : 2, with e = √3/2: 2πa²(1 + (c/(a e)) asin e).
        let e = 0.75_f64.sqrt();
        let egg = ellipsoid(DVec3::ZERO, DVec3::new(1.0, 1.0, 2.0), 60);
        assert!((area(&egg) / (TAU * (1.0 + 2.0 / e * e.asin())) - 1.0).abs() < 1e-12);
        assert!(sum(&ball) < 1e-12 && sum(&ring) < 1e-12 && sum(&egg) < 1e-12);
    }
}
