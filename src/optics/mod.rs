//! Optics of plane waves: interfaces, films, and the media they are made of.

pub mod film;
pub mod fresnel;
pub mod incidence;
pub mod material;
pub mod schlick;
pub mod textbook;

pub use incidence::{Direction, Incidence};
