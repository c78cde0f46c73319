//! Waves: rows E5–E19. One module a step, in teaching order.

mod conductor;
mod cosine;
mod dalembert;
pub(crate) mod fields;
pub(crate) mod functions;
mod harmonics;
mod methods;
mod one_way;
mod perspective;
mod source_free;
mod speed;
pub(crate) mod transverse;
mod wave_equation;

use crate::parameter::{FREQUENCY, MEDIUM, Parameter, Setting};
use crate::vocabulary::{Chapter, Gallery, Quantity, gallery};
use light::waves::Wave;
use yardstick::statistics::rms;

/// The chapter.
pub const CHAPTER: Chapter = Chapter {
    id: "plane-wave",
    title: "Waves",
    says: "From Maxwell's equations to a wave of one frequency in any medium: its speed, its shape, its decay.",
    builds_on: &["maxwell"],
    prose: include_str!("prose.md"),
    steps: &[
        source_free::STEP,
        wave_equation::STEP,
        dalembert::STEP,
        methods::STEP,
        speed::STEP,
        one_way::STEP,
        harmonics::STEP,
        cosine::STEP,
        transverse::STEP,
        conductor::STEP,
    ],
    figures: FIGURES,
    functions: functions::FUNCTIONS,
};

/// What its steps show, apart from the evidence.
pub const FIGURES: Gallery = gallery(
    "plane-wave",
    &[
        source_free::EXHIBIT,
        wave_equation::EXHIBIT,
        dalembert::EXHIBIT,
        methods::EXHIBIT,
        speed::EXHIBIT,
        one_way::EXHIBIT,
        harmonics::EXHIBIT,
        cosine::EXHIBIT,
        transverse::EXHIBIT,
        conductor::EXHIBIT,
    ],
);

/// The medium of the steps where nothing is lost.
pub(crate) const VACUUM: Parameter = MEDIUM.default("vacuum");
/// The frequency of green light, 550 nm.
pub(crate) const GREEN: Parameter = FREQUENCY.default("545THz");

/// The wave of the setting's frequency in its medium.
pub(crate) fn wave(setting: &Setting) -> Wave {
    setting.conductor("medium").wave(setting.frequency()).expect("validated when it was set")
}

/// `copper at 1 GHz`: the setting as a heading.
pub(crate) fn described(setting: &Setting) -> String {
    let frequency = setting.text("freq");
    let unit = frequency.trim_start_matches(|c: char| !c.is_alphabetic() || c == 'e');
    let number = &frequency[..frequency.len() - unit.len()];
    let unit = if unit.is_empty() { "Hz" } else { unit };
    format!("{} at {} {unit}", setting.text("medium"), number.trim_end())
}

/// The root of the mean square of what two lists differ by, place by place.
fn rms_difference(found: &[f64], exact: &[f64]) -> f64 {
    rms(&found.iter().zip(exact).map(|(found, exact)| found - exact).collect::<Vec<_>>())
}

pub(crate) const fn quantity(
    key: &'static str,
    symbol: &'static str,
    says: &'static str,
    value: f64,
    unit: &'static str,
) -> Quantity {
    Quantity { key, symbol, says, value, unit }
}
