//! The sheet a figure is drawn on keeps what it is told as vector shapes; the writers read them.
//!
//! It is ruled in steps of a 64th of a pixel ([`FINE`]), which places everything finer than eyes can tell and lets
//! crowded points fall together.

use super::canvas::{Across, Anchor, Down, Frame, Place};
use super::palette::Paint;
use super::text;

/// Steps to a pixel of the sheet.
pub const FINE: f64 = 64.0;

/// A place on the sheet in steps from its top left corner.
pub type Step = (i32, i32);

/// The step nearest to a place.
pub fn fine((x, y): Place) -> Step {
    ((x * FINE).round() as i32, (y * FINE).round() as i32)
}

/// A number of steps in pixels.
fn coarse(steps: impl Into<f64>) -> f32 {
    (steps.into() / FINE) as f32
}

fn place((x, y): Step) -> [f32; 2] {
    [coarse(x), coarse(y)]
}

/// What is drawn, from back to front, in pixels from the top left corner.
#[derive(Debug, Default)]
pub struct Sheet {
    /// Width.
    pub width: u32,
    /// Height.
    pub height: u32,
    /// From back to front.
    pub items: Vec<Item>,
}

/// Something on a sheet.
#[derive(Debug)]
pub enum Item {
    /// A filled shape.
    Fill {
        /// Its outline.
        path: Path,
        /// Its colour.
        paint: Paint,
    },
    /// A filled disc.
    Disc {
        /// Its centre.
        centre: [f32; 2],
        /// Its radius.
        radius: f32,
        /// Its colour.
        paint: Paint,
    },
    /// A stroked line.
    Stroke {
        /// Its middle.
        path: Path,
        /// Its colour.
        paint: Paint,
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

/// A line with corners, at least two points long. (Figures need no more of a path, so that no library for paths is
/// needed where only SVG is written.)
#[derive(Clone, Debug)]
pub struct Path {
    /// Its corners.
    pub points: Vec<[f32; 2]>,
    /// Whether it returns to its start.
    pub is_closed: bool,
}

/// A line of text.
#[derive(Debug)]
pub struct Text {
    /// In the label markup.
    pub label: String,
    /// Where its baseline starts.
    pub start: [f32; 2],
    /// Size of the font.
    pub size: f32,
    /// Whether it runs upwards rather than to the right.
    pub upwards: bool,
    /// What of it stands where it was placed: who draws letters at widths of their own asks for it.
    #[cfg_attr(not(feature = "png"), allow(dead_code))]
    pub along: Across,
    /// Its colour.
    pub paint: Paint,
}

/// A picture of cells, each of one colour.
#[derive(Debug)]
pub struct Image {
    /// Where it lies.
    pub place: Frame,
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
    /// Strokes the line through points, `width` steps wide, with a pattern of `dashes` in pixels.
    pub fn stroke(
        &mut self,
        points: impl IntoIterator<Item = Step>,
        is_closed: bool,
        paint: Paint,
        width: u32,
        dashes: &[f32],
    ) {
        if let Some(path) = path(points, is_closed) {
            self.items.push(Item::Stroke { path, paint, width: coarse(width), dashes: dashes.to_vec() });
        }
    }

    /// Fills the shape with these corners.
    pub fn fill(&mut self, corners: impl IntoIterator<Item = Step>, paint: Paint) {
        self.items.extend(path(corners, true).map(|path| Item::Fill { path, paint }));
    }

    /// Fills a disc.
    pub fn disc(&mut self, centre: Step, radius: u32, paint: Paint) {
        self.items.push(Item::Disc { centre: place(centre), radius: coarse(radius), paint });
    }

    /// Sets text at its anchor. That is one of a capital, so that the baselines of labels with and without raised runs
    /// agree.
    pub fn text(&mut self, label: &str, at: Step, anchor: Anchor, size: f64, paint: Paint, upwards: bool) {
        let along = match anchor.0 {
            Across::Left => 0.0,
            Across::Middle => -0.5 * text::width(label, size),
            Across::Right => -text::width(label, size),
        };
        let down = match anchor.1 {
            Down::Top => text::CAPITAL * size,
            Down::Middle => 0.5 * text::CAPITAL * size,
            Down::Bottom => 0.0,
        };
        let (dx, dy) = if upwards { (down, -along) } else { (along, down) };
        let [x, y] = place(at);
        let start = [x + dx as f32, y + dy as f32];
        self.items.push(Item::Text(Text {
            label: label.to_owned(),
            start,
            size: size as f32,
            upwards,
            along: anchor.0,
            paint,
        }));
    }

    /// Lays a picture of cells, `columns` to a row, from the top left.
    pub fn image(&mut self, place: &Frame, columns: usize, cells: Vec<[u8; 3]>) {
        let has_size = place.width() >= 0.0 && place.height() >= 0.0;
        if has_size && columns > 0 && !cells.is_empty() {
            self.items.push(Item::Image(Image { place: *place, columns, cells }));
        }
    }
}

/// The line through points, repeated ones left out; a lone point is a line to itself.
fn path(points: impl IntoIterator<Item = Step>, is_closed: bool) -> Option<Path> {
    let mut points: Vec<Step> = points.into_iter().collect();
    points.dedup();
    if let [lone] = points[..] {
        points.push(lone);
    }
    (!points.is_empty()).then(|| Path { points: points.into_iter().map(place).collect(), is_closed })
}
