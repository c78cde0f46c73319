//! The label of an axis, in as many lines as it needs.

use super::canvas::{Across, Anchor, Canvas, Down};
use super::palette::Colour;
use super::{TEXT, text};
use chapters::figure::Axis;

/// Distance of baselines.
const LINE: f64 = 18.0;
/// Between the label and what it stands beside, beyond the leading.
const GAP: f64 = 6.0;

/// Name and unit of an axis, broken into lines.
pub struct Label {
    lines: Vec<String>,
}

impl Label {
    /// The label of an axis in lines no longer than `limit`, where words allow.
    pub fn new(axis: &Axis, limit: f64) -> Self {
        Self { lines: text::wrap(&full(axis), TEXT, limit) }
    }

    /// Room it takes across its lines.
    pub fn thickness(&self) -> f64 {
        if self.lines.is_empty() { 0.0 } else { GAP + LINE * self.lines.len() as f64 }
    }

    /// Writes it under `top`, around `middle` but between `ends`.
    pub fn draw_under(&self, canvas: &dyn Canvas, top: f64, middle: f64, ends: (f64, f64)) {
        let mut baseline = top - 2.0;
        for line in &self.lines {
            baseline += LINE;
            let place = (between(middle, text::width(line, TEXT), ends), baseline);
            canvas.text(line, place, Anchor(Across::Middle, Down::Bottom), TEXT, Colour::Ink);
        }
    }

    /// Writes it upwards to the right of `left`, around `middle` but between `ends`.
    pub fn draw_upwards(&self, canvas: &dyn Canvas, left: f64, middle: f64, ends: (f64, f64)) {
        let mut baseline = left - 4.0;
        for line in &self.lines {
            baseline += LINE;
            let place = (baseline, between(middle, text::width(line, TEXT), ends));
            canvas.text_upwards(line, place, Anchor(Across::Middle, Down::Bottom), TEXT, Colour::Ink);
        }
    }
}

/// Name and unit of an axis.
pub fn full(axis: &Axis) -> String {
    match (axis.label.as_str(), axis.unit.as_str()) {
        (label, "") => label.to_owned(),
        (label, unit) => format!("{label} [{unit}]").trim_start().to_owned(),
    }
}

/// The place nearest to `middle` for something of a length, so that it lies between two ends if it can.
fn between(middle: f64, length: f64, (first, last): (f64, f64)) -> f64 {
    middle.min(last - length / 2.0).max(first + length / 2.0)
}
