//! What is wrong with a scene, and where.

use std::fmt;

/// Why there can be no picture of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Flaw {
    /// The key in the scene, as a path: `camera.width`, `shapes[3].radius`, `materials.white.reflectance[1]`.
    pub place: String,
    /// What is wrong, and what is valid.
    pub why: String,
}

impl fmt::Display for Flaw {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}: {}", self.place, self.why)
    }
}

impl std::error::Error for Flaw {}
