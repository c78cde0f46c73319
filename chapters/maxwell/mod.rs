//! From the four laws to fields on a grid: rows E1–E4, C1 and C2. One module a step, in teaching order.

mod agreement;
mod conduction;
mod continuity;
mod equations;
mod functions;
mod grid;
mod heat;
mod interface;
mod left_out;
mod media;
mod scattering;
mod surface_current;
mod symbols;
mod throughput;

use crate::vocabulary::{Chapter, Gallery, gallery};

/// The chapter.
pub const CHAPTER: Chapter = Chapter {
    id: "maxwell",
    title: "Maxwell's equations",
    says: "From the four laws to what they say at an interface, and a solver that keeps them to the last digit.",
    builds_on: &[],
    prose: include_str!("prose.md"),
    steps: &[
        equations::STEP,
        continuity::STEP,
        media::STEP,
        interface::STEP,
        surface_current::STEP,
        grid::STEP,
        agreement::STEP,
        conduction::STEP,
        left_out::STEP,
    ],
    figures: FIGURES,
    functions: functions::FUNCTIONS,
};

/// What its steps show, apart from the evidence.
pub const FIGURES: Gallery = gallery(
    "maxwell",
    &[
        equations::EXHIBIT,
        continuity::EXHIBIT,
        media::EXHIBIT,
        interface::EXHIBIT,
        surface_current::EXHIBIT,
        grid::EXHIBIT,
        agreement::EXHIBIT,
        conduction::EXHIBIT,
        left_out::EXHIBIT,
    ],
);
