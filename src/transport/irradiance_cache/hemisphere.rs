//! What comes to a place from all around, by one ray a cell of the hemisphere, and how that changes from place to place (G. J.
//! Ward and P. S. Heckbert, *Irradiance gradients*, Eurographics Workshop on Rendering 1992, 85).
//!
//! Rings and sectors cut the hemisphere into cells of one share of the cosine. All that is told here is exact for what has one
//! radiance within each cell: the irradiance; its change where the surface turns; and where it is shifted, if the wall between
//! two cells is an edge of what is nearer of both (ibid., §4; J. Křivánek and P. Gautron, *Practical global illumination with
//! irradiance caching* (2009), §3.2).

use crate::bsdf::{Rgb, rgb};
use crate::number::Vector;
use crate::sampling::warp::cosine_hemisphere;
use std::f64::consts::{PI, TAU};

/// What a ray has found.
#[derive(Clone, Copy, Debug)]
pub struct Seen {
    /// The radiance [W m⁻² sr⁻¹] that comes along it.
    pub radiance: Rgb<f64>,
    /// From how far [m]; infinite of a sky.
    pub distance: f64,
}

/// Rings by sectors of a hemisphere, ring by ring from its pole on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cells {
    /// Of equal sin².
    pub rings: u32,
    /// About the normal.
    pub sectors: u32,
}

/// The light on a place, along its own axes: z is the normal.
#[derive(Clone, Copy, Debug)]
pub struct Fallen {
    /// Irradiance E [W m⁻²].
    pub irradiance: Rgb<f64>,
    /// ∂E/∂n [W m⁻²], along the surface: of a normal n′ near by the irradiance is E + n′·∂E/∂n.
    pub turned: [Vector<f64>; 3],
    /// ∂E/∂x [W m⁻³], along the surface.
    pub shifted: [Vector<f64>; 3],
    /// The harmonic mean [m] of the distances by their cosine; infinite if there is but sky.
    pub distance: f64,
}

impl Cells {
    /// About so many, as wide as they are high where it matters: π sectors a ring.
    pub fn about(count: f64) -> Self {
        let rings = (count / PI).sqrt().round().max(2.0);
        Self { rings: rings as u32, sectors: (PI * rings).round() as u32 }
    }

    /// How many.
    pub fn count(&self) -> u32 {
        self.rings * self.sectors
    }

    /// A direction within a cell, by its cosine, from two numbers 0 ≤ u < 1.
    pub fn direction(&self, cell: u32, [u, v]: [f64; 2]) -> Vector<f64> {
        let [ring, sector] = [cell / self.sectors, cell % self.sectors].map(f64::from);
        cosine_hemisphere([(ring + u) / f64::from(self.rings), (sector + v) / f64::from(self.sectors)]).0
    }

    // ANCHOR: gradients
    /// The light of one ray a cell.
    ///
    /// # Panics
    /// If there is not one a cell.
    pub fn fallen(&self, seen: &[Seen]) -> Fallen {
        assert_eq!(seen.len(), self.count() as usize, "a ray a cell");
        let [rings, sectors] = [self.rings, self.sectors].map(f64::from);
        let share = PI / (rings * sectors);
        let at = |ring: u32, sector: u32| &seen[(ring * self.sectors + sector % self.sectors) as usize];
        // ∫ cos φ dφ over half a sector: of a direction that turns with φ it is what is left along the middle.
        let chord = (PI / sectors).sin();
        let mut all = Fallen { irradiance: [0.0; 3], turned: NONE, shifted: NONE, distance: 0.0 };
        let mut nearness = 0.0;
        for ring in 0..self.rings {
            // sin² of the ring's inner and outer rim.
            let [inner, outer] = [f64::from(ring) / rings, f64::from(ring + 1) / rings];
            let tan = rings * (tangents(outer) - tangents(inner));
            let [sin_inner, sin_outer] = [inner.sqrt(), outer.sqrt()];
            for sector in 0..self.sectors {
                let own = at(ring, sector);
                let (middle, start) = (azimuth(sector, 0.5, sectors), azimuth(sector, 0.0, sectors));
                all.irradiance = rgb(|c| all.irradiance[c] + share * own.radiance[c]);
                nearness += 1.0 / (own.distance * f64::from(self.count()));
                more(&mut all.turned, own.radiance, middle.scaled(share * tan * chord * sectors / PI));
                if ring > 0 {
                    // The rim moves by cos θ/r, and with it sin θ dφ of the hemisphere, of cosine cos θ.
                    let rim = 2.0 * chord * sin_inner * (1.0 - inner);
                    more(
                        &mut all.shifted,
                        step(at(ring - 1, sector), own),
                        middle.scaled(rim / nearer(at(ring - 1, sector), own)),
                    );
                }
                // The side moves by 1/r, and with it dθ of cosine cos θ.
                let before = at(ring, sector + self.sectors - 1);
                let across = Vector::new(-start.y, start.x, 0.0);
                more(&mut all.shifted, step(before, own), across.scaled((sin_outer - sin_inner) / nearer(before, own)));
            }
        }
        all.distance = 1.0 / nearness;
        all
    }
    // ANCHOR_END: gradients
}

const NONE: [Vector<f64>; 3] = [Vector { x: 0.0, y: 0.0, z: 0.0 }; 3];

/// ∫ tan θ d(sin² θ) from the pole on, up to a sin².
fn tangents(sin2: f64) -> f64 {
    sin2.sqrt().asin() - (sin2 * (1.0 - sin2)).sqrt()
}

/// Along the surface, a part of a sector further than where it begins.
fn azimuth(sector: u32, part: f64, sectors: f64) -> Vector<f64> {
    let (sin, cos) = (TAU * (f64::from(sector) + part) / sectors).sin_cos();
    Vector::new(cos, sin, 0.0)
}

fn step(from: &Seen, to: &Seen) -> Rgb<f64> {
    rgb(|c| to.radiance[c] - from.radiance[c])
}

fn nearer(one: &Seen, other: &Seen) -> f64 {
    one.distance.min(other.distance)
}

fn more(sum: &mut [Vector<f64>; 3], light: Rgb<f64>, way: Vector<f64>) {
    for (sum, light) in sum.iter_mut().zip(light) {
        *sum = *sum + way.scaled(light);
    }
}
