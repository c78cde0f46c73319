//! `chapters`: what we claim. The lecture as data; every view (terminal, JSON, tests, book, coverage)
//! is a walk over [`CURRICULUM`].

pub mod diagram;
pub mod figure;
pub mod fresnel;
pub mod function;
pub mod lecture;
pub mod maxwell;
pub mod plane_wave;
pub mod poynting;
pub mod setting;
mod symbols;
pub mod vocabulary;

pub use vocabulary::{Chapter, Step};

/// The chapters in teaching order: the only list of them.
pub const CURRICULUM: &[&Chapter] = &[&maxwell::CHAPTER, &plane_wave::CHAPTER, &poynting::CHAPTER, &fresnel::CHAPTER];

/// How many checks of the curriculum rest on random numbers: what their significance is shared among.
pub fn statistical_checks() -> usize {
    let steps = CURRICULUM.iter().flat_map(|chapter| chapter.steps);
    steps.flat_map(|step| step.checks).filter(|check| check.bound.is_statistical()).count()
}
