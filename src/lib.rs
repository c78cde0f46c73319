//! `light`: what is true. The physics of rendering, and nothing else: it prints, parses, plots and times nothing, and
//! knows no equations. The feature `references` adds the same formulas in arbitrary precision, for those who check.
//!
//! # Conventions, stated once
//!
//! - SI units, `f64`, angles in radians. A unit stands in brackets in the documentation: [W m⁻² sr⁻¹].
//! - Fields vary as e^(i(k·r − ωt)); an absorbing medium has the index n + iκ with κ ≥ 0, so a wave
//!   decays along its propagation, and every transmitted normal wave number has an imaginary part ≥ 0.
//! - s: the electric field is perpendicular to the plane of incidence; p: it lies in it.
//!   `r_p` compares electric fields with the sign of the lecture's E39, so that at normal incidence
//!   `r_p` = −`r_s` (the magnetic fields of p are counted alike: E₁ − E₁′, H₁ + H₁′, E38).
//! - `n_i`, `cos_i`: the side the light comes from; `n_t`, `cos_t`: the other side.
//! - z is the local normal; `wi` and `wo` both point away from the surface.
//! - The same inputs and seed give the same bits, whatever the number of threads.
//!
//! # Where things are
//!
//! | idea | formula | claimed in |
//! |---|---|---|
//! | charges in flight, tensors, sheets with current | [`fields`] | `maxwell`, to `surface_current` |
//! | fields stepped on a grid | [`em`] | `maxwell`, from `grid` |
//! | directions without loss at either end | [`optics::incidence`] | `fresnel/snell` |
//! | interface: amplitudes, powers, Brewster, dip | [`optics::fresnel`] | `fresnel`, `r_s` to `metals` |
//! | the same as the lecture writes it | [`optics::textbook`] | `fresnel/digits` |
//! | Schlick and its descendants | [`optics::schlick`] | `fresnel/schlick` |
//! | stacks of films | [`optics::film`] | `fresnel/films` |
//! | where a prism sends light | [`optics::prism`] | `path-tracing/dispersion` |
//! | surfaces that scatter | [`bsdf`] | `brdf` |
//! | one formula for `f64`, `f32` and eight or sixteen `f32` | [`number`] | `brdf` |
//! | media by name: indices, (ε, μ, σ) | [`media`] | every step, by name |
//! | plane waves in lossy media | [`waves::plane`] | `plane-wave` |
//! | pulses by their spectra | [`waves::harmonics`] | `plane-wave` |
//! | energy flow, its averages and its balance | [`waves::flux`], [`waves::energy`] | `poynting` |
//! | phases after any number of periods | [`waves::phase`] | `poynting` |
//! | conduction, a stiff equation, and its solver | [`waves::conduction`], [`waves::radau`] | `maxwell/conduction` |
//! | what lamps of any shape send to a place | [`radiometry`] | `radiometry` |
//! | light between diffuse patches | [`radiosity`] | `rendering-equation` |
//! | rough surfaces as heights, and rays among them | [`relief`] | `brdf` |
//! | points for paths, and how they become directions | [`sampling`] | `path-tracing` |
//! | how light gets from lamps to the picture | [`transport`] | `path-tracing` |
//! | spectra, eyes, and what a channel means | [`colour`] | `path-tracing/dispersion` |
//! | polarised light, and what changes it | [`stokes`] | `path-tracing/polarised` |
//! | from radiance to what a screen shows | [`tone`] | `path-tracing` |
//! | what is rendered, as data | [`scene`] | `path-tracing` |
//! | what a ray meets | [`geometry`] | `path-tracing` |
//! | s and p | [`Polarisation`] | everywhere |
//! | references in arbitrary precision, condition numbers | `references` | every stress |

pub mod bsdf;
pub mod colour;
pub mod em;
pub mod fields;
pub mod geometry;
pub mod media;
pub mod number;
pub mod optics;
mod polarisation;
pub mod radiometry;
pub mod radiosity;
#[cfg(any(test, feature = "references"))]
pub mod references;
pub mod relief;
pub mod sampling;
pub mod scene;
pub mod stokes;
mod threads;
pub mod tone;
pub mod transport;
pub mod waves;
mod wide;

pub use num_complex::Complex64;
pub use polarisation::Polarisation;
