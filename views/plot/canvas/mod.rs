//! Drawing in pixels of the sheet: what a figure may ask for, and the two that do it.
//!
//! With the feature `plotters` the shapes go through that library; without it our own canvas puts the same shapes onto
//! the same sheet, for readers such as a browser's module that cannot carry `plotters` along. A test holds both equal.

#[cfg(any(test, not(feature = "plotters")))]
mod plain;
#[cfg(feature = "plotters")]
mod with_plotters;

#[cfg(any(test, not(feature = "plotters")))]
pub use plain::Plain;
#[cfg(feature = "plotters")]
pub use with_plotters::WithPlotters;

use super::palette::Colour;
use super::sheet::Sheet;

/// The canvas that figures are drawn on.
#[cfg(feature = "plotters")]
pub type Usual = WithPlotters;
/// The canvas that figures are drawn on.
#[cfg(not(feature = "plotters"))]
pub type Usual = Plain;

/// A place on the sheet, in pixels from its top left corner.
pub type Place = (f64, f64);

/// A rectangle on the sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// Left edge.
    pub left: f64,
    /// Top edge.
    pub top: f64,
    /// Right edge.
    pub right: f64,
    /// Bottom edge.
    pub bottom: f64,
}

impl Frame {
    /// The rectangle with its top left corner at a place.
    pub fn at((left, top): Place, width: f64, height: f64) -> Self {
        Self { left, top, right: left + width, bottom: top + height }
    }

    /// Distance of its sides.
    pub fn width(&self) -> f64 {
        self.right - self.left
    }

    /// Distance of top and bottom.
    pub fn height(&self) -> f64 {
        self.bottom - self.top
    }

    /// The place at fractions of its width from the left and of its height from the bottom.
    pub fn place(&self, x: f64, y: f64) -> Place {
        (self.left + x * self.width(), self.bottom - y * self.height())
    }

    /// Grown by as much on every side.
    pub fn grown(&self, by: f64) -> Self {
        Self { left: self.left - by, top: self.top - by, right: self.right + by, bottom: self.bottom + by }
    }

    /// Whether two rectangles share more than an edge.
    pub fn meets(&self, other: &Self) -> bool {
        self.left < other.right && other.left < self.right && self.top < other.bottom && other.top < self.bottom
    }
}

/// Where a text stands against its place: across and down, as of a capital.
#[derive(Clone, Copy)]
pub struct Anchor(pub Across, pub Down);

/// What of a text stands at its place, along the line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Across {
    /// Its start.
    Left,
    /// Its middle.
    Middle,
    /// Its end.
    Right,
}

/// What of a text stands at its place, across the line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Down {
    /// The top of a capital.
    Top,
    /// The middle of a capital.
    Middle,
    /// The baseline.
    Bottom,
}

/// A sheet being drawn on.
pub trait Canvas {
    /// An empty sheet, of whole pixels.
    fn new(width: u32, height: u32) -> Self
    where
        Self: Sized;

    /// The sheet as drawn.
    fn finish(self) -> Sheet
    where
        Self: Sized;

    /// A line through places, with a pattern of strokes and gaps.
    fn curve(&self, places: &[Place], colour: Colour, width: f64, dashes: &[f32]);

    /// Curves through points given as fractions of the frame, from its bottom left corner.
    fn curves(&self, frame: &Frame, pieces: &[Vec<Place>], colour: Colour, width: f64, dashes: &[f32]);

    /// The outline of a rectangle.
    fn outline(&self, frame: &Frame, colour: Colour, width: f64);

    /// A filled rectangle.
    fn fill(&self, frame: &Frame, colour: Colour, alpha: f64);

    /// A filled polygon.
    fn polygon(&self, corners: &[Place], colour: Colour, alpha: f64);

    /// A filled disc.
    fn disc(&self, centre: Place, radius: f64, colour: Colour);

    /// A line of text, to the right or `upwards`.
    fn set(&self, label: &str, place: Place, anchor: Anchor, size: f64, colour: Colour, upwards: bool);

    /// A picture of cells, `columns` to a row, from the top left.
    fn image(&self, frame: &Frame, columns: usize, cells: Vec<[u8; 3]>);

    /// A straight line.
    fn line(&self, from: Place, to: Place, colour: Colour, width: f64) {
        self.curve(&[from, to], colour, width, &[]);
    }

    /// A line of text.
    fn text(&self, label: &str, place: Place, anchor: Anchor, size: f64, colour: Colour) {
        self.set(label, place, anchor, size, colour, false);
    }

    /// A line of text that runs upwards.
    fn text_upwards(&self, label: &str, place: Place, anchor: Anchor, size: f64, colour: Colour) {
        self.set(label, place, anchor, size, colour, true);
    }
}
