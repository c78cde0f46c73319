//! What an interface does to a plane wave: rows E33–E44 and C10–C15.

pub mod extremes;

use crate::vocabulary::Chapter;

/// The chapter.
pub const CHAPTER: Chapter = Chapter {
    id: "fresnel",
    title: "What an interface does to a plane wave",
    says: "From the boundary conditions to mirrors, glass, metals and stacks of films, with every digit accounted for.",
    builds_on: &["plane-wave", "poynting"],
    prose: include_str!("prose.md"),
    steps: &[],
    functions: &[],
};
