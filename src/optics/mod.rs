//! Optics of plane waves: interfaces and films.

pub mod film;
pub mod fresnel;
pub mod incidence;
pub mod prism;
pub mod schlick;
pub mod textbook;

pub use incidence::{Direction, Incidence};
