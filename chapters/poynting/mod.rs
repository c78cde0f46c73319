//! Energy flow: rows E20–E24 and C3–C5. One module a step, in teaching order.

mod flow;
mod functions;
mod mean;
mod orders;
mod phasor;
mod theorem;
mod window;

use crate::parameter::Setting;
use crate::plane_wave::wave;
use crate::vocabulary::{Chapter, Gallery, gallery};
use light::waves::flux::Flux;

/// The chapter.
pub const CHAPTER: Chapter = Chapter {
    id: "poynting",
    title: "The flow of energy",
    says: "From the fields to what a detector reads: the Poynting vector, its balance and its average.",
    builds_on: &["plane-wave"],
    prose: include_str!("prose.md"),
    steps: &[flow::STEP, theorem::STEP, orders::STEP, mean::STEP, phasor::STEP, window::STEP],
    figures: FIGURES,
    functions: functions::FUNCTIONS,
};

/// What its steps show, apart from the evidence.
pub const FIGURES: Gallery = gallery(
    "poynting",
    &[flow::EXHIBIT, theorem::EXHIBIT, orders::EXHIBIT, mean::EXHIBIT, phasor::EXHIBIT, window::EXHIBIT],
);

/// The flow at z = 0 of the setting's wave, of amplitude 1 V/m.
fn flux(setting: &Setting) -> Flux {
    Flux::at_depth(&wave(setting), 1.0, 0.0)
}
