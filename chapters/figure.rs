//! Figures as data. Nothing here knows how they are drawn.
//!
//! Labels are in the markup of [`crate::text`].

use crate::diagram::Diagram;

/// A figure: one or more panels side by side.
#[derive(Clone, Debug, PartialEq)]
pub struct Plot {
    /// Heading, in the label markup.
    pub title: String,
    /// Left to right, wrapped into rows of `columns`.
    pub panels: Vec<Panel>,
    /// Panels in a row (at least 1); those with axes stand at most two in a row, lest their text be lost.
    pub columns: usize,
}

impl Plot {
    /// A figure of a single panel.
    pub fn of(title: impl Into<String>, panel: impl Into<Panel>) -> Self {
        Self { title: title.into(), panels: vec![panel.into()], columns: 1 }
    }

    /// A figure of several panels, `columns` to a row.
    pub fn grid(title: impl Into<String>, columns: usize, panels: Vec<Panel>) -> Self {
        Self { title: title.into(), panels, columns: columns.max(1) }
    }
}

/// One part of a figure.
#[derive(Clone, Debug, PartialEq)]
pub enum Panel {
    /// Curves and points on axes.
    Chart(Chart),
    /// A colour map of a grid of values.
    Map(Map),
    /// A picture in linear radiance.
    Picture(Picture),
    /// Geometry with names.
    Diagram(Diagram),
}

impl From<Chart> for Panel {
    fn from(chart: Chart) -> Self {
        Self::Chart(chart)
    }
}

impl From<Map> for Panel {
    fn from(map: Map) -> Self {
        Self::Map(map)
    }
}

impl From<Picture> for Panel {
    fn from(picture: Picture) -> Self {
        Self::Picture(picture)
    }
}

impl From<Diagram> for Panel {
    fn from(diagram: Diagram) -> Self {
        Self::Diagram(diagram)
    }
}

/// How an axis runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Evenly.
    Linear,
    /// Evenly in the logarithm; values that are not positive are not drawn.
    Log,
}

/// An axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Name of the quantity.
    pub label: String,
    /// Unit, empty if it has none.
    pub unit: String,
    /// Linear or logarithmic.
    pub scale: Scale,
    /// First and last value; from the data where `None`.
    pub range: Option<(f64, f64)>,
    /// Distance of labelled ticks on a linear axis; chosen where `None` (30 suits degrees), none at all where infinite.
    pub tick: Option<f64>,
}

impl Axis {
    /// A linear axis over the data.
    pub fn linear(label: impl Into<String>, unit: impl Into<String>) -> Self {
        Self { label: label.into(), unit: unit.into(), scale: Scale::Linear, range: None, tick: None }
    }

    /// A logarithmic axis over the data.
    pub fn log(label: impl Into<String>, unit: impl Into<String>) -> Self {
        Self { scale: Scale::Log, ..Self::linear(label, unit) }
    }

    /// A linear axis for shares of a whole: curves at 0 and at 1 stay clear of the frame.
    pub fn share(label: impl Into<String>) -> Self {
        Self::linear(label, "").range(-0.03, 1.03).tick(0.2)
    }

    /// A linear axis without name and ticks, for drawings in perspective; two of them have no frame either.
    pub fn bare(first: f64, last: f64) -> Self {
        Self::linear("", "").range(first, last).tick(f64::INFINITY)
    }

    /// Whether it shows no ticks.
    pub fn is_bare(&self) -> bool {
        self.tick == Some(f64::INFINITY)
    }

    /// The same axis from `first` to `last`.
    pub fn range(self, first: f64, last: f64) -> Self {
        Self { range: Some((first, last)), ..self }
    }

    /// The same axis with a labelled tick every `tick`.
    pub fn tick(self, tick: f64) -> Self {
        Self { tick: Some(tick), ..self }
    }
}

/// Curves and points on a pair of axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    /// Heading of the panel; may be empty.
    pub title: String,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Drawn in order, the last on top.
    pub marks: Vec<Mark>,
}

impl Chart {
    /// Empty axes.
    pub fn new(title: impl Into<String>, x: Axis, y: Axis) -> Self {
        Self { title: title.into(), x, y, marks: Vec::new() }
    }

    /// With one more mark.
    pub fn with(mut self, mark: Mark) -> Self {
        self.marks.push(mark);
        self
    }

    /// With a solid curve.
    pub fn line(self, hue: Hue, label: impl Into<String>, points: Vec<[f64; 2]>) -> Self {
        self.with(Mark::Line { label: label.into(), hue, dash: Dash::Solid, points })
    }

    /// With a dashed curve.
    pub fn dashed(self, hue: Hue, label: impl Into<String>, points: Vec<[f64; 2]>) -> Self {
        self.with(Mark::Line { label: label.into(), hue, dash: Dash::Dashed, points })
    }

    /// With a lying bar of the length `x` between two heights.
    pub fn bar(self, hue: Hue, label: impl Into<String>, x: f64, [low, high]: [f64; 2]) -> Self {
        self.with(Mark::Bar { label: label.into(), hue, end: [[x, low], [x, high]] })
    }

    /// With a vertical reference line.
    pub fn at_x(self, x: f64, label: impl Into<String>) -> Self {
        self.with(Mark::AtX { x, label: label.into() })
    }

    /// With a horizontal reference line.
    pub fn at_y(self, y: f64, label: impl Into<String>) -> Self {
        self.with(Mark::AtY { y, label: label.into() })
    }
}

/// Something drawn on axes. Points that are NaN or infinite break a curve and are not drawn.
#[derive(Clone, Debug, PartialEq)]
pub enum Mark {
    /// A curve.
    Line {
        /// Legend entry; none if empty.
        label: String,
        /// Colour.
        hue: Hue,
        /// Stroke.
        dash: Dash,
        /// (x, y) in axis units.
        points: Vec<[f64; 2]>,
    },
    /// Separate points, joined by a thin line if `joined`.
    Points {
        /// Legend entry; none if empty.
        label: String,
        /// Colour.
        hue: Hue,
        /// Shape of each point.
        shape: Shape,
        /// Whether a thin line joins them.
        joined: bool,
        /// (x, y) in axis units.
        points: Vec<[f64; 2]>,
    },
    /// Points whose y is no finite number, in a band of their own above the frame that says so.
    Broken {
        /// Colour.
        hue: Hue,
        /// Shape of each point.
        shape: Shape,
        /// Their x in axis units.
        at: Vec<f64>,
    },
    /// Points whose y is exactly 0, which a logarithmic axis cannot hold, in a band of their own under the frame.
    Vanished {
        /// Colour.
        hue: Hue,
        /// Shape of each point.
        shape: Shape,
        /// Their x in axis units.
        at: Vec<f64>,
    },
    /// A bar that lies: from the left edge of the frame to its end.
    Bar {
        /// Legend entry; none if empty.
        label: String,
        /// Colour.
        hue: Hue,
        /// The lower and the upper corner of its end, (x, y) in axis units.
        end: [[f64; 2]; 2],
    },
    /// A thin vertical reference line with its name; beyond the axis only the name, with an arrow.
    AtX {
        /// Where.
        x: f64,
        /// Written beside it.
        label: String,
    },
    /// A thin horizontal reference line with its name.
    AtY {
        /// Where.
        y: f64,
        /// Written beside it.
        label: String,
    },
}

/// Colours by role, distinct to colour-blind eyes and kept the same throughout the lecture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Hue {
    /// s polarisation.
    S,
    /// p polarisation.
    P,
    /// Natural light, or the exact answer.
    Natural,
    /// What is transmitted.
    Transmitted,
    /// The program's own method.
    Ours,
    /// The textbook form.
    Textbook,
    /// A reference or an aid to the eye.
    Reference,
    /// The k-th of several equals.
    Nth(u8),
}

/// Stroke of a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dash {
    /// Unbroken.
    Solid,
    /// Broken.
    Dashed,
    /// Dotted.
    Dotted,
}

/// Shape of a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// ●
    Disc,
    /// ■
    Square,
    /// ▲
    Triangle,
    /// ◆
    Diamond,
    /// ✕
    Cross,
    /// ○
    Ring,
}

/// A colour map over a regular grid in axis space (logarithmic axes are divided evenly in the logarithm).
#[derive(Clone, Debug, PartialEq)]
pub struct Map {
    /// Heading of the panel; may be empty.
    pub title: String,
    /// Horizontal axis; its range must be set.
    pub x: Axis,
    /// Vertical axis; its range must be set.
    pub y: Axis,
    /// The quantity shown; its range must be set.
    pub colour: Axis,
    /// Colours used.
    pub ramp: Ramp,
    /// Cells along x.
    pub columns: usize,
    /// Row by row from the bottom, `columns` values a row; NaN is drawn as hatched "broken".
    pub values: Vec<f64>,
    /// Lines drawn over it.
    pub marks: Vec<Mark>,
}

/// Colours of a map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ramp {
    /// From dark (low) to bright (high), even in lightness.
    Sequential,
    /// Two colours that meet in white at the middle of the range.
    Diverging,
}

impl Picture {
    /// Of `width` pixels a row, in linear radiance.
    pub fn new(title: impl Into<String>, width: usize, pixels: Vec<[f32; 3]>) -> Self {
        Self { title: title.into(), width, pixels }
    }

    /// Brighter by so many stops, each a factor of two; the caption says so.
    pub fn exposed(mut self, stops: f32) -> Self {
        let factor = stops.exp2();
        self.pixels.iter_mut().for_each(|pixel| *pixel = pixel.map(|part| part * factor));
        self.title = format!("{}, {stops:+} stops", self.title);
        self
    }

    /// Where this differs from a `reference` of the same size and by how much, in false colours: the difference of
    /// luminance (ITU-R BT.709), in the unit of the pixels. The range is even about zero and holds all of it.
    ///
    /// # Panics
    /// If the two differ in size.
    pub fn errors(&self, reference: &Self, title: impl Into<String>) -> Map {
        assert!(self.width == reference.width && self.pixels.len() == reference.pixels.len(), "pictures of one size");
        let luminance = |[r, g, b]: [f32; 3]| f64::from(0.2126 * r + 0.7152 * g + 0.0722 * b);
        let off = |(one, other): (&[f32; 3], &[f32; 3])| luminance(*one) - luminance(*other);
        let by_rows: Vec<f64> = self.pixels.iter().zip(&reference.pixels).map(off).collect();
        let most =
            by_rows.iter().filter(|off| off.is_finite()).fold(f64::MIN_POSITIVE, |most, off| most.max(off.abs()));
        let rows = by_rows.len() / self.width.max(1);
        Map {
            title: title.into(),
            x: Axis::bare(0.0, self.width as f64),
            y: Axis::bare(0.0, rows as f64),
            colour: Axis::linear("error of luminance", "").range(-most, most),
            ramp: Ramp::Diverging,
            columns: self.width,
            // A map begins at the bottom, a picture at the top.
            values: by_rows.chunks(self.width.max(1)).rev().flatten().copied().collect(),
            marks: Vec::new(),
        }
    }
}

/// A picture in linear radiance (sRGB primaries), row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Caption under the panel, in the label markup; may be empty.
    pub title: String,
    /// Pixels in a row.
    pub width: usize,
    /// Linear red, green and blue of each pixel; 1 is display white.
    pub pixels: Vec<[f32; 3]>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stop_is_a_factor_of_two() {
        let picture = Picture::new("a", 1, vec![[0.25, 0.5, 1.0]]).exposed(-1.0);
        assert_eq!((picture.pixels[0], picture.title.as_str()), ([0.125, 0.25, 0.5], "a, -1 stops"));
    }

    #[test]
    fn errors_are_signed_and_upright() {
        let grey = |top: f32, bottom: f32| Picture::new("", 1, vec![[top; 3], [bottom; 3]]);
        let map = grey(0.5, 1.0).errors(&grey(0.5, 0.75), "off");
        assert!((map.values[0] - 0.25).abs() < 1e-7 && map.values[1] == 0.0, "{:?}", map.values);
        assert_eq!((map.columns, map.colour.range), (1, Some((-map.values[0], map.values[0]))));
    }
}
