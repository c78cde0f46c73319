//! Path tracing: rows E53 and C21–C27. One module a step, in teaching order.

mod depth;
mod dispersion;
mod extremes;
mod functions;
mod irradiance_cache;
mod lanes;
mod listing;
pub(crate) mod one_ray;
mod photons;
mod picture;
mod polarised;
mod rate;
mod roulette;
pub(crate) mod scenes;
mod symbols;
mod traced;
pub(crate) mod ways;
mod weights;

use crate::vocabulary::{Chapter, Gallery, gallery};

/// The chapter.
pub const CHAPTER: Chapter = Chapter {
    id: "path-tracing",
    title: "Path tracing",
    says: "Pictures by chance: one ray after another, and how far to trust their mean.",
    builds_on: &["radiometry", "brdf", "rendering-equation"],
    prose: PROSE,
    steps: &[
        one_ray::STEP,
        ways::STEP,
        weights::STEP,
        depth::STEP,
        roulette::STEP,
        rate::STEP,
        lanes::STEP,
        irradiance_cache::STEP,
        photons::STEP,
        dispersion::STEP,
        polarised::STEP,
        extremes::STEP,
        picture::STEP,
        traced::STEP,
    ],
    figures: FIGURES,
    functions: functions::FUNCTIONS,
};

/// What its steps show, apart from the evidence.
pub const FIGURES: Gallery = gallery(
    "path-tracing",
    &[
        one_ray::EXHIBIT,
        ways::EXHIBIT,
        weights::EXHIBIT,
        depth::EXHIBIT,
        roulette::EXHIBIT,
        rate::EXHIBIT,
        lanes::EXHIBIT,
        irradiance_cache::EXHIBIT,
        photons::EXHIBIT,
        dispersion::EXHIBIT,
        polarised::EXHIBIT,
        extremes::EXHIBIT,
        picture::EXHIBIT,
        traced::EXHIBIT,
    ],
);

/// The course text, its listings cut from the code that runs.
const PROSE: &str = {
    const TEXT: &str = include_str!("prose.md");
    static FILLED: [u8; listing::length(TEXT)] = listing::filled(TEXT);
    match std::str::from_utf8(&FILLED) {
        Ok(text) => text,
        Err(_) => panic!("listings are text"),
    }
};
