//! `chapters`: what we claim. The lecture as data; every view (terminal, JSON, tests, book, coverage)
//! is a walk over [`CURRICULUM`].

pub mod brdf;
pub mod diagram;
pub mod figure;
pub mod fresnel;
mod histogram;
pub mod judge;
pub mod lecture;
pub mod maxwell;
pub mod parameter;
pub mod path_tracing;
pub mod plane_wave;
pub mod poynting;
pub mod radiometry;
pub mod rendering_equation;
mod symbols;
pub mod text;
pub mod vocabulary;

pub use vocabulary::{Chapter, Step};

/// The chapters in teaching order: the only list of them.
pub const CURRICULUM: &[&Chapter] = &[
    &maxwell::CHAPTER,
    &plane_wave::CHAPTER,
    &poynting::CHAPTER,
    &radiometry::CHAPTER,
    &fresnel::CHAPTER,
    &brdf::CHAPTER,
    &rendering_equation::CHAPTER,
    &path_tracing::CHAPTER,
];

/// Every step with its chapter, in teaching order.
pub fn steps() -> impl Iterator<Item = (&'static Chapter, &'static Step)> + Clone {
    CURRICULUM.iter().flat_map(|chapter| chapter.steps.iter().map(move |step| (*chapter, step)))
}

/// How many checks of the curriculum rest on random numbers: what their significance is shared among.
pub fn statistical_checks() -> usize {
    steps().flat_map(|(_, step)| step.checks).filter(|check| check.head().bound.is_statistical()).count()
}
