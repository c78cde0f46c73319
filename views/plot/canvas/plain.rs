//! The canvas without `plotters`.

use super::{Anchor, Canvas, Frame, Place};
use crate::plot::palette::{Colour, Paint};
use crate::plot::sheet::{FINE, Sheet, Step, fine};
use std::cell::RefCell;

/// A sheet being drawn on by nobody else.
pub struct Plain(RefCell<Sheet>);

impl Canvas for Plain {
    fn new(width: u32, height: u32) -> Self {
        Self(RefCell::new(Sheet { width, height, items: Vec::new() }))
    }

    fn finish(self) -> Sheet {
        self.0.into_inner()
    }

    fn curve(&self, places: &[Place], colour: Colour, width: f64, dashes: &[f32]) {
        self.0.borrow_mut().stroke(places.iter().copied().map(fine), false, colour.into(), steps(width), dashes);
    }

    fn curves(&self, frame: &Frame, pieces: &[Vec<Place>], colour: Colour, width: f64, dashes: &[f32]) {
        let ((left, top), (right, bottom)) = (fine((frame.left, frame.top)), fine((frame.right, frame.bottom)));
        for points in pieces {
            let points = points.iter().map(|(x, y)| (between(left, right, *x), between(bottom, top, *y)));
            self.0.borrow_mut().stroke(points, false, colour.into(), steps(width), dashes);
        }
    }

    fn outline(&self, frame: &Frame, colour: Colour, width: f64) {
        self.0.borrow_mut().stroke(corners(frame), true, colour.into(), steps(width), &[]);
    }

    fn fill(&self, frame: &Frame, colour: Colour, alpha: f64) {
        self.0.borrow_mut().fill(corners(frame), Paint { colour, alpha });
    }

    fn polygon(&self, corners: &[Place], colour: Colour, alpha: f64) {
        self.0.borrow_mut().fill(corners.iter().copied().map(fine), Paint { colour, alpha });
    }

    fn disc(&self, centre: Place, radius: f64, colour: Colour) {
        self.0.borrow_mut().disc(fine(centre), steps(radius), colour.into());
    }

    fn set(&self, label: &str, place: Place, anchor: Anchor, size: f64, colour: Colour, upwards: bool) {
        self.0.borrow_mut().text(label, fine(place), anchor, size, colour.into(), upwards);
    }

    fn image(&self, frame: &Frame, columns: usize, cells: Vec<[u8; 3]>) {
        self.0.borrow_mut().image(frame, columns, cells);
    }
}

/// A length in steps of the sheet.
fn steps(length: f64) -> u32 {
    (length * FINE).round() as u32
}

fn corners(frame: &Frame) -> [Step; 4] {
    let ((left, top), (right, bottom)) = (fine((frame.left, frame.top)), fine((frame.right, frame.bottom)));
    [(left, top), (right, top), (right, bottom), (left, bottom)]
}

/// The step at a fraction of the way, rounded back towards the start as `plotters` does it, lest one canvas leave out
/// a repeated point that the other keeps.
fn between(from: i32, to: i32, share: f64) -> i32 {
    let way = f64::from(to - from);
    let slack = 1e-3 * way.signum();
    if from == to { to } else { from + (way * share + slack).trunc() as i32 }
}
