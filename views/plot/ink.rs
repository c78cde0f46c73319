//! Where there is ink already, so that names and keys can go where there is none.

use super::canvas::{Frame, Place};

/// Side of a cell in pixels.
const CELL: f64 = 2.0;

/// A grid over a frame that counts inked cells.
pub struct Ink {
    frame: Frame,
    columns: usize,
    rows: usize,
    inked: Vec<bool>,
}

impl Ink {
    /// No ink.
    pub fn none(frame: Frame) -> Self {
        let cells = |length: f64| (length / CELL).ceil().max(1.0) as usize;
        let (columns, rows) = (cells(frame.width()), cells(frame.height()));
        Self { frame, columns, rows, inked: vec![false; columns * rows] }
    }

    /// Inks the cells under a line, `width` wide.
    pub fn line(&mut self, from: Place, to: Place, width: f64) {
        let length = (to.0 - from.0).hypot(to.1 - from.1);
        let steps = (length / CELL).ceil().max(1.0) as usize;
        for k in 0..=steps {
            let t = k as f64 / steps as f64;
            let (x, y) = (from.0 + t * (to.0 - from.0), from.1 + t * (to.1 - from.1));
            self.rectangle(&Frame { left: x, top: y, right: x, bottom: y }.grown(width / 2.0));
        }
    }

    /// Inks the cells that a rectangle touches.
    pub fn rectangle(&mut self, frame: &Frame) {
        let (columns, rows) = self.cells(frame);
        for row in rows {
            self.inked[row * self.columns..][columns.clone()].fill(true);
        }
    }

    fn cells(&self, frame: &Frame) -> (std::ops::Range<usize>, std::ops::Range<usize>) {
        let span = |low: f64, high: f64, count: usize| {
            let first = ((low / CELL).floor().max(0.0) as usize).min(count);
            first..((high / CELL).floor() + 1.0).clamp(first as f64, count as f64) as usize
        };
        (
            span(frame.left - self.frame.left, frame.right - self.frame.left, self.columns),
            span(frame.top - self.frame.top, frame.bottom - self.frame.top, self.rows),
        )
    }

    /// A survey of what is inked so far.
    pub fn survey(&self) -> Survey<'_> {
        Survey { ink: self, table: self.table() }
    }

    /// Inked cells above and to the left of each corner of a cell.
    fn table(&self) -> Vec<u32> {
        let stride = self.columns + 1;
        let mut table = vec![0; stride * (self.rows + 1)];
        for row in 0..self.rows {
            let mut sum = 0;
            for column in 0..self.columns {
                sum += u32::from(self.inked[row * self.columns + column]);
                table[(row + 1) * stride + column + 1] = table[row * stride + column + 1] + sum;
            }
        }
        table
    }
}

/// Answers at once whether a box holds ink.
pub struct Survey<'a> {
    ink: &'a Ink,
    table: Vec<u32>,
}

impl Survey<'_> {
    /// Whether no cell that a rectangle touches is inked.
    pub fn is_clear(&self, frame: &Frame) -> bool {
        let (columns, rows) = self.ink.cells(frame);
        let at = |row: usize, column: usize| self.table[row * (self.ink.columns + 1) + column];
        at(rows.end, columns.end) + at(rows.start, columns.start)
            == at(rows.start, columns.end) + at(rows.end, columns.start)
    }

    /// Of the places for the top left corner of a box, the one nearest to a corner of the frame at which neither the
    /// box nor `clearance` around it holds ink; none if there is no such place.
    pub fn clear_place(&self, width: f64, height: f64, inset: f64, clearance: f64) -> Option<Place> {
        let inner = self.ink.frame.grown(-inset);
        let (room_x, room_y) = (inner.width() - width, inner.height() - height);
        let places = steps(room_x).flat_map(|x| steps(room_y).map(move |y| (x, y)));
        let mut ranked: Vec<(f64, Place)> = places
            .map(|(x, y)| {
                let away = x.min(room_x - x) + y.min(room_y - y);
                // Among corners as good, the upper right is where a key is looked for first.
                let left = f64::from(u8::from(x < room_x / 2.0));
                let low = f64::from(u8::from(y > room_y / 2.0));
                (away + left + 2.0 * low, (inner.left + x, inner.top + y))
            })
            .collect();
        ranked.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut places = ranked.into_iter().map(|(_, place)| place);
        places.find(|place| self.is_clear(&Frame::at(*place, width, height).grown(clearance)))
    }
}

/// Steps of two cells from 0 to `room`, both included; none if it is negative.
fn steps(room: f64) -> impl Iterator<Item = f64> {
    let count = if room < 0.0 { 0 } else { (room / (2.0 * CELL)).ceil() as usize + 1 };
    (0..count).map(move |k| (2.0 * CELL * k as f64).min(room))
}
