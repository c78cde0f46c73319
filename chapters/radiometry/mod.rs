//! Radiometry: rows E26–E32 and C6–C9. One module a step, in teaching order.

mod any_surface;
mod ball;
mod extremes;
mod flux;
mod functions;
mod intensity;
mod irradiance;
mod quadrature;
mod radiance;
mod ray;
mod shapes;
mod solid_angle;
mod sums;
mod surfaces;
mod symbols;

use crate::vocabulary::{Chapter, Gallery, gallery};

/// The chapter.
pub const CHAPTER: Chapter = Chapter {
    id: "radiometry",
    title: "Radiometry",
    says: "Flux, intensity, radiance, irradiance: where energy goes.",
    builds_on: &["poynting"],
    prose: include_str!("prose.md"),
    steps: &[
        flux::STEP,
        solid_angle::STEP,
        intensity::STEP,
        any_surface::STEP,
        radiance::STEP,
        ray::STEP,
        irradiance::STEP,
        shapes::STEP,
        quadrature::STEP,
    ],
    figures: FIGURES,
    functions: functions::FUNCTIONS,
};

/// What its steps show, apart from the evidence.
pub const FIGURES: Gallery = gallery(
    "radiometry",
    &[
        flux::EXHIBIT,
        solid_angle::EXHIBIT,
        intensity::EXHIBIT,
        any_surface::EXHIBIT,
        radiance::EXHIBIT,
        ray::EXHIBIT,
        irradiance::EXHIBIT,
        shapes::EXHIBIT,
        quadrature::EXHIBIT,
    ],
);
