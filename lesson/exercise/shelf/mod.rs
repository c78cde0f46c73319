//! The exercises, a file a chapter.

use super::vocabulary::Exercise;

mod brdf;
mod fresnel;
mod maxwell;
mod path_tracing;
mod plane_wave;
mod poynting;
mod radiometry;
mod rendering_equation;

/// By the chapters' order.
const SHELF: [&[Exercise]; 8] = [
    maxwell::EXERCISES,
    plane_wave::EXERCISES,
    poynting::EXERCISES,
    radiometry::EXERCISES,
    fresnel::EXERCISES,
    brdf::EXERCISES,
    rendering_equation::EXERCISES,
    path_tracing::EXERCISES,
];

/// All of them.
pub fn all() -> impl Iterator<Item = &'static Exercise> + Clone {
    SHELF.into_iter().flatten()
}
