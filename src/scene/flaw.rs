//! What is wrong with a scene, and where: one set of rules, whoever made the scene.

pub mod domain;
mod place;
mod rules;
#[cfg(test)]
mod tests;

pub use place::{Part, Place};

use super::Scene;
use std::fmt;

/// Why there can be no picture of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Flaw {
    /// The key in the scene: `camera.width`, `shapes[3].radius`, `materials.white.reflectance[1]`.
    pub place: Place,
    /// What is wrong, and what is valid.
    pub why: String,
    /// Set if a name is not known.
    pub unknown: Option<Unknown>,
}

/// A name that is not known where it stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unknown {
    /// The name as it was given.
    pub word: String,
    /// The names known there.
    pub names: Vec<String>,
}

impl Flaw {
    /// A flaw of a part of what is looked at.
    pub(crate) fn of(part: impl Into<Part>, why: impl Into<String>) -> Self {
        Self { place: Place::default().within(part), why: why.into(), unknown: None }
    }

    /// A flaw of all that is looked at.
    fn of_all(why: impl Into<String>) -> Self {
        Self { place: Place::default(), why: why.into(), unknown: None }
    }

    /// `word` is none of `names`.
    fn unknown(part: impl Into<Part>, why: &str, word: &str, names: impl Iterator<Item = String>) -> Self {
        let unknown = Unknown { word: word.to_owned(), names: names.collect() };
        Self { unknown: Some(unknown), ..Self::of(part, why) }
    }

    /// The same, said of a part of what is looked at.
    pub(crate) fn within(self, part: impl Into<Part>) -> Self {
        Self { place: self.place.within(part), ..self }
    }
}

impl fmt::Display for Flaw {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}: {}", self.place, self.why)?;
        match &self.unknown {
            Some(Unknown { word, names }) => write!(f, ", found `{word}`. Known: {}", names.join(", ")),
            None => Ok(()),
        }
    }
}

impl std::error::Error for Flaw {}

impl Scene {
    /// The first thing that is wrong with it. Numbers are finite and within what is said of them, names are known, and
    /// shapes have an area that is more than what their coordinates' rounding leaves to chance.
    pub fn flaw(&self) -> Option<Flaw> {
        rules::scene(self).err()
    }
}
