//! Surfaces that scatter: rows E45–E50 and C16–C18. One module a step, in teaching order.

mod definition;
mod energy;
mod facets;
mod functions;
mod glass;
mod lambert;
mod mirror;
mod models;
mod relief;
mod sampling;
mod symbols;

use crate::vocabulary::{Chapter, Gallery, gallery};

/// The chapter.
pub const CHAPTER: Chapter = Chapter {
    id: "brdf",
    title: "Surfaces that scatter",
    says: "From mirrors to paper: what a surface sends where, drawn by chance and kept to its energy.",
    builds_on: &["radiometry", "fresnel"],
    prose: include_str!("prose.md"),
    steps: &[
        definition::STEP,
        lambert::STEP,
        mirror::STEP,
        facets::STEP,
        relief::STEP,
        sampling::STEP,
        energy::STEP,
        glass::STEP,
    ],
    figures: FIGURES,
    functions: functions::FUNCTIONS,
};

/// What its steps show, apart from the evidence.
pub const FIGURES: Gallery = gallery(
    "brdf",
    &[
        definition::EXHIBIT,
        lambert::EXHIBIT,
        mirror::EXHIBIT,
        facets::EXHIBIT,
        relief::EXHIBIT,
        sampling::EXHIBIT,
        energy::EXHIBIT,
        glass::EXHIBIT,
    ],
);
