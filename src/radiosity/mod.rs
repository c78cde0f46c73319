//! Light between diffuse surfaces cut into patches, each of one radiance: as many equations as patches (C. M. Goral, K. E.
//! Torrance, D. P. Greenberg, B. Battaile, *Modeling the interaction of light between diffuse surfaces*, SIGGRAPH '84, 213).
//!
//! Radiances [W m⁻² sr⁻¹], not radiosities: π is in the form factors. What a patch absorbs is given, not what it reflects,
//! for that is the number which decides how bright a white room is.
//!
//! | idea | where |
//! |---|---|
//! | a parallelogram or a triangle, and what two of them exchange | [`Patch`], [`exchange`] |
//! | the same of any two polygons, exactly | [`contour`] |
//! | of two rectangles with an edge in common, as the catalogue has it | [`hinge`] |
//! | diffuse faces, and how they are cut | [`Room`], [`Patches`] |
//! | which patch sees how much of which | [`Network`] |
//! | its equations solved: bounce by bounce, shot by shot, at once | [`solve`] |
//! | and by patches that are only as small as their light asks for | [`hierarchy`] |
//! | how fast bounces die out | [`spectrum`] |
//! | rooms whose light is known | [`exact`] |
//! | limits from a few terms | [`limit`] |

pub mod contour;
pub mod exact;
pub mod exchange;
pub mod hierarchy;
pub mod hinge;
pub mod limit;
mod network;
mod patch;
mod room;
mod sight;
pub mod solve;
pub mod spectrum;
#[cfg(test)]
mod tests;

pub use network::{Light, Network, Routes};
pub use patch::{Outline, Patch};
pub use room::{Face, Patches, Room};
