//! Drawing in pixels of the sheet, over the `plotters` area that the sheet stands behind.

use super::sheet::{FINE, Image, Item, Sheet};
use plotters::coord::Shift;
use plotters::coord::cartesian::Cartesian2d;
use plotters::coord::types::RangedCoordf64;
use plotters::drawing::DrawingArea;
use plotters::element::{Circle, Drawable, PathElement, PointCollection, Polygon, Rectangle, Text};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, FontFamily, FontTransform, RGBColor, ShapeStyle, TextStyle};
use std::cell::RefCell;
use std::rc::Rc;
use tiny_skia::Rect;

/// A place on the sheet, in pixels from its top left corner.
pub type Place = (f64, f64);

/// Why no drawing call fails: the sheet's error type has no values, and it is borrowed by one call at a time.
const TAKES: &str = "a sheet takes every mark";

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
    #[cfg(test)]
    pub fn meets(&self, other: &Self) -> bool {
        self.left < other.right && other.left < self.right && self.top < other.bottom && other.top < self.bottom
    }
}

/// Where a text stands against its place: `h` across and `v` down, as of a capital.
#[derive(Clone, Copy)]
pub struct Anchor(pub HPos, pub VPos);

/// A sheet being drawn on.
pub struct Canvas {
    sheet: Rc<RefCell<Sheet>>,
    area: DrawingArea<Sheet, Shift>,
}

impl Canvas {
    /// An empty sheet.
    pub fn new(width: f64, height: f64) -> Self {
        let sheet = Sheet { width: width.ceil() as u32, height: height.ceil() as u32, items: Vec::new() };
        let sheet = Rc::new(RefCell::new(sheet));
        let area = DrawingArea::from(&sheet);
        Self { sheet, area }
    }

    /// The sheet as drawn.
    pub fn finish(self) -> Sheet {
        self.sheet.take()
    }

    /// A straight line.
    pub fn line(&self, from: Place, to: Place, colour: RGBColor, width: f64) {
        self.area.draw(&PathElement::new([fine(from), fine(to)], stroke(colour, width))).expect(TAKES);
    }

    /// A line through places, with a pattern of strokes and gaps.
    pub fn curve(&self, places: &[Place], colour: RGBColor, width: f64, dashes: &[f32]) {
        let points = places.iter().copied().map(fine).collect();
        self.area.draw(&Curve { points, style: stroke(colour, width), dashes }).expect(TAKES);
    }

    /// Curves through points given as fractions of the frame, from its bottom left corner.
    pub fn curves(&self, frame: &Frame, pieces: &[Vec<Place>], colour: RGBColor, width: f64, dashes: &[f32]) {
        let ((left, top), (right, bottom)) = (fine((frame.left, frame.top)), fine((frame.right, frame.bottom)));
        let unit = || RangedCoordf64::from(0.0..1.0);
        let axes = self.area.apply_coord_spec(Cartesian2d::<RangedCoordf64, RangedCoordf64>::new(
            unit(),
            unit(),
            (left..right, bottom..top),
        ));
        for points in pieces {
            axes.draw(&Curve { points: points.clone(), style: stroke(colour, width), dashes }).expect(TAKES);
        }
    }

    /// The outline of a rectangle.
    pub fn outline(&self, frame: &Frame, colour: RGBColor, width: f64) {
        self.area.draw(&rectangle(frame, stroke(colour, width))).expect(TAKES);
    }

    /// A filled rectangle.
    pub fn fill(&self, frame: &Frame, colour: RGBColor, alpha: f64) {
        self.area.draw(&rectangle(frame, colour.mix(alpha).filled())).expect(TAKES);
    }

    /// A filled polygon.
    pub fn polygon(&self, corners: &[Place], colour: RGBColor) {
        let corners: Vec<_> = corners.iter().copied().map(fine).collect();
        self.area.draw(&Polygon::new(corners, colour.filled())).expect(TAKES);
    }

    /// A filled disc.
    pub fn disc(&self, centre: Place, radius: f64, colour: RGBColor) {
        self.area.draw(&Circle::new(fine(centre), (radius * FINE).round(), colour.filled())).expect(TAKES);
    }

    /// A line of text.
    pub fn text(&self, label: &str, place: Place, anchor: Anchor, size: f64, colour: RGBColor) {
        self.set(label, place, anchor, size, colour, FontTransform::None);
    }

    /// A line of text that runs upwards.
    pub fn text_upwards(&self, label: &str, place: Place, anchor: Anchor, size: f64, colour: RGBColor) {
        self.set(label, place, anchor, size, colour, FontTransform::Rotate270);
    }

    fn set(&self, label: &str, place: Place, anchor: Anchor, size: f64, colour: RGBColor, turn: FontTransform) {
        let font = (FontFamily::SansSerif, size * FINE);
        let style = TextStyle::from(font).color(&colour).pos(Pos::new(anchor.0, anchor.1)).transform(turn);
        self.area.draw(&Text::new(label.to_owned(), fine(place), style)).expect(TAKES);
    }

    /// A picture of cells, `columns` to a row, from the top left.
    pub fn image(&self, frame: &Frame, columns: usize, cells: Vec<[u8; 3]>) {
        let [left, top, right, bottom] = [frame.left, frame.top, frame.right, frame.bottom].map(|edge| edge as f32);
        if let Some(place) = Rect::from_ltrb(left, top, right, bottom).filter(|_| columns > 0 && !cells.is_empty()) {
            self.sheet.borrow_mut().items.push(Item::Image(Image { place, columns, cells }));
        }
    }
}

/// A place in steps of `plotters`.
fn fine((x, y): Place) -> (i32, i32) {
    ((x * FINE).round() as i32, (y * FINE).round() as i32)
}

fn stroke(colour: RGBColor, width: f64) -> ShapeStyle {
    colour.stroke_width((width * FINE).round() as u32)
}

fn rectangle(frame: &Frame, style: ShapeStyle) -> Rectangle<(i32, i32)> {
    Rectangle::new([fine((frame.left, frame.top)), fine((frame.right, frame.bottom))], style)
}

/// A line that may be dashed, which `plotters` styles cannot say.
struct Curve<'a, P> {
    points: Vec<P>,
    style: ShapeStyle,
    dashes: &'a [f32],
}

impl<'a, P: 'a> PointCollection<'a, P> for &'a Curve<'_, P> {
    type Point = &'a P;
    type IntoIter = &'a [P];
    fn point_iter(self) -> &'a [P] {
        &self.points
    }
}

impl<P> Drawable<Sheet> for Curve<'_, P> {
    fn draw<I: Iterator<Item = (i32, i32)>>(
        &self,
        points: I,
        sheet: &mut Sheet,
        _: (u32, u32),
    ) -> Result<(), plotters_backend::DrawingErrorKind<std::convert::Infallible>> {
        sheet.stroke(points, &self.style, self.dashes);
        Ok(())
    }
}
