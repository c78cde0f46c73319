//! The canvas over `plotters`, whose backend the sheet is.
//!
//! `plotters` counts in whole pixels. The sheet therefore tells it that it is [`FINE`] times finer than it is, which
//! places everything to a 64th of a pixel. Its colours are three bytes: the first says which [`Colour`] is meant, so
//! that the role arrives and not only its looks.

use super::{Across, Anchor, Canvas, Down, Frame, Place};
use crate::plot::palette::{Colour, Paint};
use crate::plot::sheet::{FINE, Sheet, Step, fine};
use crate::plot::text;
use plotters::coord::Shift;
use plotters::coord::cartesian::Cartesian2d;
use plotters::coord::types::RangedCoordf64;
use plotters::drawing::DrawingArea;
use plotters::element::{Circle, Drawable, PathElement, PointCollection, Polygon, Rectangle, Text};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, FontFamily, FontTransform, RGBColor, ShapeStyle, TextStyle};
use plotters_backend::{BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind};
use std::cell::RefCell;
use std::convert::Infallible;
use std::rc::Rc;

/// Why no drawing call fails: the sheet's error type has no values, and it is borrowed by one call at a time.
const TAKES: &str = "a sheet takes every mark";

/// A sheet and the `plotters` area that it stands behind.
pub struct WithPlotters {
    sheet: Rc<RefCell<Sheet>>,
    area: DrawingArea<Sheet, Shift>,
}

impl Canvas for WithPlotters {
    fn new(width: u32, height: u32) -> Self {
        let sheet = Rc::new(RefCell::new(Sheet { width, height, items: Vec::new() }));
        let area = DrawingArea::from(&sheet);
        Self { sheet, area }
    }

    fn finish(self) -> Sheet {
        self.sheet.take()
    }

    fn line(&self, from: Place, to: Place, colour: Colour, width: f64) {
        self.area.draw(&PathElement::new([fine(from), fine(to)], stroke(colour, width))).expect(TAKES);
    }

    fn curve(&self, places: &[Place], colour: Colour, width: f64, dashes: &[f32]) {
        let points = places.iter().copied().map(fine).collect();
        self.area.draw(&Curve { points, style: stroke(colour, width), dashes }).expect(TAKES);
    }

    fn curves(&self, frame: &Frame, pieces: &[Vec<Place>], colour: Colour, width: f64, dashes: &[f32]) {
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

    fn outline(&self, frame: &Frame, colour: Colour, width: f64) {
        self.area.draw(&rectangle(frame, stroke(colour, width))).expect(TAKES);
    }

    fn fill(&self, frame: &Frame, colour: Colour, alpha: f64) {
        self.area.draw(&rectangle(frame, numbered(colour).mix(alpha).filled())).expect(TAKES);
    }

    fn polygon(&self, corners: &[Place], colour: Colour, alpha: f64) {
        let corners: Vec<_> = corners.iter().copied().map(fine).collect();
        self.area.draw(&Polygon::new(corners, numbered(colour).mix(alpha).filled())).expect(TAKES);
    }

    fn disc(&self, centre: Place, radius: f64, colour: Colour) {
        let style = numbered(colour).filled();
        self.area.draw(&Circle::new(fine(centre), (radius * FINE).round(), style)).expect(TAKES);
    }

    fn set(&self, label: &str, place: Place, Anchor(across, down): Anchor, size: f64, colour: Colour, upwards: bool) {
        let across = match across {
            Across::Left => HPos::Left,
            Across::Middle => HPos::Center,
            Across::Right => HPos::Right,
        };
        let down = match down {
            Down::Top => VPos::Top,
            Down::Middle => VPos::Center,
            Down::Bottom => VPos::Bottom,
        };
        let turn = if upwards { FontTransform::Rotate270 } else { FontTransform::None };
        let font = (FontFamily::SansSerif, size * FINE);
        let colour = numbered(colour);
        let style = TextStyle::from(font).color(&colour).pos(Pos::new(across, down)).transform(turn);
        self.area.draw(&Text::new(label.to_owned(), fine(place), style)).expect(TAKES);
    }

    fn image(&self, frame: &Frame, columns: usize, cells: Vec<[u8; 3]>) {
        self.sheet.borrow_mut().image(frame, columns, cells);
    }
}

/// A role as `plotters` carries it.
fn numbered(colour: Colour) -> RGBColor {
    RGBColor(colour as u8, 0, 0)
}

/// The role that `plotters` brings, and how strongly it covers.
fn paint(BackendColor { rgb: (number, ..), alpha }: BackendColor) -> Paint {
    Paint { colour: Colour::ALL[usize::from(number)], alpha }
}

fn stroke(colour: Colour, width: f64) -> ShapeStyle {
    Color::stroke_width(&numbered(colour), (width * FINE).round() as u32)
}

fn rectangle(frame: &Frame, style: ShapeStyle) -> Rectangle<Step> {
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
    fn draw<I: Iterator<Item = BackendCoord>>(&self, points: I, sheet: &mut Sheet, _: (u32, u32)) -> Done {
        let ShapeStyle { color, stroke_width, .. } = &self.style;
        sheet.stroke(points, false, paint(color.to_backend_color()), *stroke_width, self.dashes);
        Ok(())
    }
}

type Done = Result<(), DrawingErrorKind<Infallible>>;

impl DrawingBackend for Sheet {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        (self.width.saturating_mul(FINE as u32), self.height.saturating_mul(FINE as u32))
    }

    fn ensure_prepared(&mut self) -> Done {
        Ok(())
    }

    fn present(&mut self) -> Done {
        Ok(())
    }

    fn draw_pixel(&mut self, (x, y): BackendCoord, colour: BackendColor) -> Done {
        self.draw_rect((x, y), (x + 1, y + 1), &colour, true)
    }

    fn draw_line<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, style: &S) -> Done {
        self.draw_path([from, to], style)
    }

    fn draw_rect<S: BackendStyle>(&mut self, a: BackendCoord, b: BackendCoord, style: &S, fill: bool) -> Done {
        let (corners, paint) = ([a, (b.0, a.1), b, (a.0, b.1)], paint(style.color()));
        if fill {
            self.fill(corners, paint)
        } else {
            self.stroke(corners, true, paint, style.stroke_width(), &[])
        }
        Ok(())
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, path: I, style: &S) -> Done {
        self.stroke(path, false, paint(style.color()), style.stroke_width(), &[]);
        Ok(())
    }

    /// A circle that is not filled has corners, too small to be seen.
    fn draw_circle<S: BackendStyle>(&mut self, centre: BackendCoord, radius: u32, style: &S, fill: bool) -> Done {
        let paint = paint(style.color());
        if fill {
            self.disc(centre, radius, paint);
        } else {
            let corner = |k: i32| {
                let (sin, cos) = (std::f64::consts::TAU * f64::from(k) / 96.0).sin_cos();
                let along = |share: f64| (f64::from(radius) * share).round() as i32;
                (centre.0 + along(cos), centre.1 + along(sin))
            };
            self.stroke((0..96).map(corner), true, paint, style.stroke_width(), &[]);
        }
        Ok(())
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, corners: I, style: &S) -> Done {
        self.fill(corners, paint(style.color()));
        Ok(())
    }

    /// It runs to the right, or upwards under any rotation.
    fn draw_text<S: BackendTextStyle>(&mut self, label: &str, style: &S, place: BackendCoord) -> Done {
        let across = match style.anchor().h_pos {
            HPos::Left => Across::Left,
            HPos::Center => Across::Middle,
            HPos::Right => Across::Right,
        };
        let down = match style.anchor().v_pos {
            VPos::Top => Down::Top,
            VPos::Center => Down::Middle,
            VPos::Bottom => Down::Bottom,
        };
        let upwards = !matches!(style.transform(), FontTransform::None);
        self.text(label, place, Anchor(across, down), style.size() / FINE, paint(style.color()), upwards);
        Ok(())
    }

    fn estimate_text_size<S: BackendTextStyle>(
        &self,
        label: &str,
        style: &S,
    ) -> Result<(u32, u32), DrawingErrorKind<Infallible>> {
        let height = (text::CAPITAL + text::DESCENT) * style.size();
        Ok((text::width(label, style.size()).ceil() as u32, height.ceil() as u32))
    }
}
