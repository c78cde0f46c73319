//! Integrators to read: one path at a time, one idea more in each.
//!
//! | idea | where |
//! |---|---|
//! | directions all alike, the lecture's own | [`hemisphere`] |
//! | directions by their cosine and by the surface | [`surface`] |
//! | rays to lamps | [`lamps`] |
//! | both, weighed; and an end by chance | [`both`] |
//! | the same of one wavelength | [`spectral`] |
//! | the same with polarisation | [`polarised`] |

pub mod both;
pub mod hemisphere;
pub mod lamps;
pub mod polarised;
pub mod spectral;
pub mod surface;

use super::{Needs, Stage};
use crate::bsdf::{Rgb, rgb};
use crate::geometry::Ray;
use crate::sampling::{Row, Stream};

/// An integrator by name.
#[derive(Clone, Copy)]
pub struct Integrator {
    /// Command-line word.
    pub name: &'static str,
    /// What it does, in a few words.
    pub about: &'static str,
    /// Whether it can do scenes that need this.
    pub fits: fn(&Needs) -> bool,
    /// The radiance [W m⁻² sr⁻¹] that comes along a ray, on average: from the numbers of a path, at most so many edges long.
    pub radiance: fn(&Stage<f64>, Ray<f64>, &mut Numbers<'_>, u32) -> Rgb<f64>,
}

/// Those of the lecture's way to the fast one.
pub const INTEGRATORS: &[Integrator] = &[
    Integrator {
        name: "hemisphere",
        about: "directions all alike over the hemisphere, to a fixed depth",
        fits: |needs| !needs.specular && !needs.clear && !needs.bare_lights && is_plain(needs),
        radiance: hemisphere::radiance,
    },
    Integrator {
        name: "surface",
        about: "directions as the surface scatters, to a fixed depth",
        fits: |needs| !needs.bare_lights && is_plain(needs),
        radiance: surface::radiance,
    },
    Integrator {
        name: "lamps",
        about: "rays to lamps; lamps met by chance count where rays cannot be sent",
        fits: is_plain,
        radiance: lamps::radiance,
    },
    Integrator {
        name: "both",
        about: "rays to lamps and lamps met by chance, weighed by their densities; roulette",
        fits: is_plain,
        radiance: both::radiance,
    },
];

/// Those of what most scenes do without.
pub const RARE: &[Integrator] = &[
    Integrator {
        name: "spectral",
        about: "as both, of one wavelength a path, drawn at the eye; where glass disperses",
        fits: |needs| needs.wavelength && !needs.polariser,
        radiance: spectral::radiance,
    },
    Integrator {
        name: "polarised",
        about: "as both, with what mirrors, metal and glass do to polarised light; not of rough or coated ones",
        fits: |needs| !needs.wavelength && !needs.scalar,
        radiance: polarised::radiance,
    },
];

/// Whether three channels of natural light are enough.
fn is_plain(needs: &Needs) -> bool {
    !needs.wavelength && !needs.polariser
}

/// The numbers of one path, vertex after vertex.
pub struct Numbers<'a> {
    stream: &'a Stream<'a>,
    sample: u32,
    vertex: usize,
}

impl<'a> Numbers<'a> {
    /// Of a sample of a pixel.
    pub fn new(stream: &'a Stream<'a>, sample: u32) -> Self {
        Self { stream, sample, vertex: 0 }
    }

    /// Those of the camera.
    pub fn of_camera(&self) -> Row<f64> {
        self.stream.at(|_| self.sample, |_| 0)
    }

    /// Those of the next vertex.
    pub fn of_next_vertex(&mut self) -> Row<f64> {
        self.vertex += 1;
        self.stream.at(|_| self.sample, |_| self.vertex)
    }
}

/// Light with more of it, as much as a path carries.
pub fn gathered(light: Rgb<f64>, carried: Rgb<f64>, more: Rgb<f64>) -> Rgb<f64> {
    rgb(|c| light[c] + carried[c] * more[c])
}

/// What a path carries, times a factor a channel.
pub fn carried(before: Rgb<f64>, factor: Rgb<f64>) -> Rgb<f64> {
    rgb(|c| before[c] * factor[c])
}
