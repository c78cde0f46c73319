//! The key to the curves.

use super::canvas::{Across, Anchor, Canvas, Down, Frame, Place};
use super::marks;
use super::palette::Colour;
use super::{TEXT, text};
use chapters::figure::Mark;

const PAD: f64 = 8.0;
const ROW: f64 = 21.0;
const GAP: f64 = 8.0;
const BETWEEN: f64 = 20.0;

/// Where a key stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Among the curves, in a box.
    Inside,
    /// To the right of the frame.
    Beside,
    /// Under the horizontal axis.
    Below,
}

/// The named marks, in `columns`.
#[derive(Clone)]
pub struct Key<'a> {
    /// Where it stands.
    pub side: Side,
    entries: Vec<(&'a Mark, &'a str)>,
    columns: usize,
    sample: f64,
}

impl<'a> Key<'a> {
    /// The key in one column.
    pub fn new(marks: &'a [Mark]) -> Self {
        let entries = marks.iter().filter_map(|mark| Some((mark, marks::entry(mark)?))).collect();
        Self { side: Side::Inside, entries, columns: 1, sample: marks::sample_width(marks) }
    }

    /// Whether there is nothing to explain.
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// The same key in every number of columns that fits into `width`, the fewest first.
    pub fn layouts(&self, width: f64) -> impl DoubleEndedIterator<Item = Self> + '_ {
        let layouts = (1..=self.entries.len()).map(|columns| Self { columns, ..self.clone() });
        layouts.filter(move |key| key.columns == 1 || key.size().0 <= width)
    }

    /// The key to the right of the frame if it takes no more than `share` of the panel's width, else below it.
    pub fn outside(&self, room: &Frame, share: f64) -> Self {
        let (width, height) = self.size();
        if width <= share * room.width() && height < 0.8 * room.height() {
            return Self { side: Side::Beside, ..self.clone() };
        }
        self.below(room)
    }

    /// The key under the axes, in as many columns as there is room for.
    pub fn below(&self, room: &Frame) -> Self {
        let widest = self.layouts(room.width()).next_back().unwrap_or_else(|| self.clone());
        Self { side: Side::Below, ..widest }
    }

    fn rows(&self) -> usize {
        self.entries.len().div_ceil(self.columns)
    }

    /// Width of each column.
    fn widths(&self) -> Vec<f64> {
        let wide = |(_, label): &(&Mark, &str)| self.sample + GAP + text::width(label, TEXT);
        self.entries.chunks(self.rows().max(1)).map(|column| column.iter().map(wide).fold(0.0, f64::max)).collect()
    }

    /// Width and height of the whole.
    pub fn size(&self) -> (f64, f64) {
        let widths = self.widths();
        let between = BETWEEN * widths.len().saturating_sub(1) as f64;
        ((widths.iter().sum::<f64>() + between + 2.0 * PAD).ceil(), self.rows() as f64 * ROW + PAD)
    }

    /// Draws it with its top left corner at a place.
    pub fn draw(&self, canvas: &dyn Canvas, place: Place) {
        let (width, height) = self.size();
        if self.side == Side::Inside {
            let frame = Frame::at(place, width, height);
            canvas.fill(&frame, Colour::Paper, 0.92);
            canvas.outline(&frame, Colour::Edge, 1.0);
        }
        let mut x = place.0 + PAD;
        for (column, wide) in self.entries.chunks(self.rows().max(1)).zip(self.widths()) {
            for (row, (mark, label)) in column.iter().enumerate() {
                let y = place.1 + PAD / 2.0 + (row as f64 + 0.5) * ROW;
                marks::draw_sample(canvas, mark, (x, y), self.sample);
                canvas.text(label, (x + self.sample + GAP, y), Anchor(Across::Left, Down::Middle), TEXT, Colour::Ink);
            }
            x += wide + BETWEEN;
        }
    }
}
