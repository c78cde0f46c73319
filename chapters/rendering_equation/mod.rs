//! Light that bounces: rows E51, E52, C19 and C20. One module a step, in teaching order.

mod cornell;
mod edge;
mod enclosures;
mod extremes;
mod form_factors;
mod operator;
mod radiosity;
mod reflected;
mod rendering;
mod rooms;
mod series;
mod slanted;
mod solvers;
mod symbols;

use crate::vocabulary::{Chapter, Gallery, gallery};

/// The chapter.
pub const CHAPTER: Chapter = Chapter {
    id: "rendering-equation",
    title: "Light that bounces",
    says: "Light that bounces: its series, and rooms solved.",
    builds_on: &["radiometry", "brdf"],
    prose: include_str!("prose.md"),
    steps: &[
        reflected::STEP,
        rendering::STEP,
        series::STEP,
        operator::STEP,
        enclosures::STEP,
        form_factors::STEP,
        radiosity::STEP,
        extremes::STEP,
    ],
    figures: FIGURES,
    functions: &[],
};

/// What its steps show, apart from the evidence.
pub const FIGURES: Gallery = gallery(
    "rendering-equation",
    &[
        reflected::EXHIBIT,
        rendering::EXHIBIT,
        series::EXHIBIT,
        operator::EXHIBIT,
        enclosures::EXHIBIT,
        form_factors::EXHIBIT,
        radiosity::EXHIBIT,
        extremes::EXHIBIT,
    ],
);
