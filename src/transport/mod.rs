//! How light gets from lamps to the picture.
//!
//! | idea | where |
//! |---|---|
//! | what a scene needs | [`Needs`] |
//! | a scene made ready for rays | [`Stage`] |
//! | the camera's rays | [`Lens`] |
//! | lamps as a point sees them | [`lamp`] |
//! | an image all around as one of them | [`panorama`] |
//! | what surfaces are made of, lane by lane | [`surfaces`] |
//! | integrators to read, one idea more in each | [`simple`] |
//! | the fast one, as many paths at once as a number has lanes | [`kernel`] |
//! | which pixels are worth more samples, by what is seen | [`looks`] |
//! | and by a few samples | [`pilot`] |
//! | light by way of mirrors and glass, from the lamp on | [`caustics`] |
//! | light left where it falls | [`photons`] |
//! | light that a few places know for all | [`irradiance_cache`] |
//! | light that patches know, found at once | [`radiosity`] |
//! | all pixels | [`picture`] |
//! | sums of samples that no order of rendering can change | [`film`] |
//! | the room whose light is known | [`enclosure`] |
//! | lanes that wait for each other | [`waiting`] |
//! | how wrong a picture is, by its own halves | [`estimate`] |

pub mod caustics;
pub mod enclosure;
pub mod estimate;
pub mod film;
pub mod irradiance_cache;
pub mod kernel;
pub mod lamp;
pub mod lens;
pub mod looks;
pub mod needs;
pub mod panorama;
mod patterns;
pub mod photons;
pub mod picture;
pub mod pilot;
pub mod radiosity;
pub mod simple;
pub mod stage;
pub mod surfaces;
#[cfg(test)]
mod tests;
pub mod waiting;

pub use lens::Lens;
pub use needs::{LeftOut, Needless, Needs};
pub use picture::{Feature, Manner, Method, Renderer};
pub use stage::{Stage, Vertex};
