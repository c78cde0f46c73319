//! The sheet a figure is drawn on: a `plotters` backend that keeps what it is told as vector shapes.
//!
//! `plotters` counts in whole pixels. The sheet therefore tells it that it is [`FINE`] times finer than it is, which
//! places everything to a 64th of a pixel; the writers [`png`](super::png) and [`svg`](super::svg) read the result.

use super::text;
use plotters::style::FontTransform;
use plotters::style::text_anchor::{HPos, VPos};
use plotters_backend::{BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind};
use std::convert::Infallible;
use tiny_skia::{Path, PathBuilder, Rect};

/// Steps of `plotters` to a pixel of the sheet.
pub const FINE: f64 = 64.0;

/// A number of `plotters` steps in pixels.
fn coarse(steps: impl Into<f64>) -> f32 {
    (steps.into() / FINE) as f32
}

/// What is drawn, from back to front, in pixels from the top left corner.
#[derive(Default)]
pub struct Sheet {
    /// Width.
    pub width: u32,
    /// Height.
    pub height: u32,
    /// From back to front.
    pub items: Vec<Item>,
}

/// Something on a sheet.
pub enum Item {
    /// A filled shape.
    Fill {
        /// Its outline.
        path: Path,
        /// Its colour.
        colour: BackendColor,
    },
    /// A filled disc.
    Disc {
        /// Its centre.
        centre: [f32; 2],
        /// Its radius.
        radius: f32,
        /// Its colour.
        colour: BackendColor,
    },
    /// A stroked line.
    Stroke {
        /// Its middle.
        path: Path,
        /// Its colour.
        colour: BackendColor,
        /// Its width.
        width: f32,
        /// Lengths of strokes and gaps in turn; unbroken if empty.
        dashes: Vec<f32>,
    },
    /// A line of text.
    Text(Text),
    /// A picture of square-cornered cells.
    Image(Image),
}

/// A line of text.
pub struct Text {
    /// In the label markup.
    pub label: String,
    /// Where its baseline starts.
    pub start: [f32; 2],
    /// Size of the font.
    pub size: f32,
    /// Whether it runs upwards rather than to the right.
    pub upwards: bool,
    /// Its colour.
    pub colour: BackendColor,
}

/// A picture of cells, each of one colour.
pub struct Image {
    /// Where it lies.
    pub place: Rect,
    /// Cells in a row.
    pub columns: usize,
    /// sRGB of each cell, row by row from the top.
    pub cells: Vec<[u8; 3]>,
}

impl Image {
    /// Rows of cells.
    pub fn rows(&self) -> usize {
        self.cells.len() / self.columns
    }
}

impl Sheet {
    /// Strokes the line through points given in `plotters` steps, with a pattern of `dashes` in pixels.
    pub fn stroke(
        &mut self,
        points: impl IntoIterator<Item = BackendCoord>,
        style: &impl BackendStyle,
        dashes: &[f32],
    ) {
        let (width, colour) = (coarse(style.stroke_width()), style.color());
        if let Some(path) = line(points, false) {
            self.items.push(Item::Stroke { path, colour, width, dashes: dashes.to_vec() });
        }
    }

    fn fill(&mut self, path: Option<Path>, style: &impl BackendStyle) {
        let colour = style.color();
        self.items.extend(path.map(|path| Item::Fill { path, colour }));
    }

    /// Fills the shape or strokes its outline.
    fn shape(&mut self, path: Option<Path>, style: &impl BackendStyle, fill: bool) {
        if fill {
            return self.fill(path, style);
        }
        let (width, colour) = (coarse(style.stroke_width()), style.color());
        self.items.extend(path.map(|path| Item::Stroke { path, colour, width, dashes: Vec::new() }));
    }
}

/// The line through points given in `plotters` steps, repeated ones left out; a lone point is a line to itself.
fn line(points: impl IntoIterator<Item = BackendCoord>, closed: bool) -> Option<Path> {
    let mut points: Vec<BackendCoord> = points.into_iter().collect();
    points.dedup();
    let (&(x, y), rest) = points.split_first()?;
    let mut path = PathBuilder::new();
    path.move_to(coarse(x), coarse(y));
    for &(x, y) in if rest.is_empty() { &points } else { rest } {
        path.line_to(coarse(x), coarse(y));
    }
    if closed {
        path.close();
    }
    path.finish()
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
        self.shape(line([a, (b.0, a.1), b, (a.0, b.1)], true), style, fill);
        Ok(())
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, path: I, style: &S) -> Done {
        self.stroke(path, style, &[]);
        Ok(())
    }

    fn draw_circle<S: BackendStyle>(&mut self, centre: BackendCoord, radius: u32, style: &S, fill: bool) -> Done {
        let (centre, radius, colour) = ([coarse(centre.0), coarse(centre.1)], coarse(radius), style.color());
        if fill {
            self.items.push(Item::Disc { centre, radius, colour });
        } else {
            self.shape(PathBuilder::from_circle(centre[0], centre[1], radius), style, false);
        }
        Ok(())
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, corners: I, style: &S) -> Done {
        self.fill(line(corners, true), style);
        Ok(())
    }

    /// Sets the text at its anchor; `Top`, `Center` and `Bottom` are those of a capital, so that the baselines of
    /// labels with and without raised runs agree. It runs to the right, or upwards under any rotation.
    fn draw_text<S: BackendTextStyle>(&mut self, label: &str, style: &S, (x, y): BackendCoord) -> Done {
        let size = style.size() / FINE;
        let along = match style.anchor().h_pos {
            HPos::Left => 0.0,
            HPos::Center => -0.5 * text::width(label, size),
            HPos::Right => -text::width(label, size),
        };
        let down = match style.anchor().v_pos {
            VPos::Top => text::CAPITAL * size,
            VPos::Center => 0.5 * text::CAPITAL * size,
            VPos::Bottom => 0.0,
        };
        let upwards = !matches!(style.transform(), FontTransform::None);
        let (dx, dy) = if upwards { (down, -along) } else { (along, down) };
        let start = [coarse(x) + dx as f32, coarse(y) + dy as f32];
        let (label, size, colour) = (label.to_owned(), size as f32, style.color());
        self.items.push(Item::Text(Text { label, start, size, upwards, colour }));
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
