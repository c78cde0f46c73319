//! The outlines of the embedded font, for where text becomes pixels.

use super::text;
use tiny_skia::{Path, PathBuilder};
use ttf_parser::OutlineBuilder;

/// Outline of a label whose baseline starts at the origin, y downwards; nothing if it has no ink.
pub fn outline(label: &str, size: f64) -> Option<Path> {
    let mut pen = Pen { path: PathBuilder::new(), x: 0.0, y: 0.0, scale: 0.0 };
    for run in text::runs(label) {
        pen.scale = (size * run.size / text::units_per_em()) as f32;
        pen.y = (-size * run.rise) as f32;
        let mut x = run.x;
        for character in run.text.chars() {
            pen.x = (size * x) as f32;
            text::FACE.outline_glyph(text::glyph(character), &mut pen);
            x += run.size * text::advance(character.encode_utf8(&mut [0; 4]));
        }
    }
    pen.path.finish()
}

/// Draws glyphs, given in font units with y upwards, at a place and size.
struct Pen {
    path: PathBuilder,
    x: f32,
    y: f32,
    scale: f32,
}

impl Pen {
    fn at(&self, x: f32, y: f32) -> (f32, f32) {
        (self.x + self.scale * x, self.y - self.scale * y)
    }
}

impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.at(x, y);
        self.path.move_to(x, y);
    }
    fn line_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.at(x, y);
        self.path.line_to(x, y);
    }
    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let ((x1, y1), (x, y)) = (self.at(x1, y1), self.at(x, y));
        self.path.quad_to(x1, y1, x, y);
    }
    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let ((x1, y1), (x2, y2), (x, y)) = (self.at(x1, y1), self.at(x2, y2), self.at(x, y));
        self.path.cubic_to(x1, y1, x2, y2, x, y);
    }
    fn close(&mut self) {
        self.path.close();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn outlines_end_where_the_measure_says() {
        let bounds = outline("θ_B = 56°", 15.0).unwrap().bounds();
        // Up to the side bearing of the last glyph.
        assert!((f64::from(bounds.right()) - text::width("θ_B = 56°", 15.0)).abs() < 0.1 * 15.0);
        assert!(outline(" ", 15.0).is_none());
    }

    proptest! {
        #[test]
        fn any_label_has_an_outline_or_no_ink(label in "[_^{}a-zθ⁻\\PC]{0,40}") {
            outline(&label, 15.0);
        }
    }
}
