//! Waves in closed form: plane waves in media that may conduct, pulses through their spectra, averages of the energy
//! flow, and the stiff equation of a conducting cell. What a grid does with the same equations is not here.

pub mod conduction;
pub mod constants;
pub mod energy;
pub mod flux;
pub mod harmonics;
pub mod phase;
pub mod plane;
pub mod radau;
mod scaled;
pub mod textbook;

pub use plane::{Invalid, Medium, Wave};
