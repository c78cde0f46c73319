//! A figure in the pixels of a terminal that shows them, in whole rows of its text.

use super::cells::{COLUMN, laid_out};
use super::{encode, png};
use crate::block::pale;
use chapters::figure::Plot;

/// A picture that stands among the rows of a terminal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pixels {
    width: u32,
    /// Of each row.
    height: u32,
    /// sRGB from the top, of whole rows.
    rgb: Vec<u8>,
}

/// The figure in at most so many `columns`, and `rows` to a panel, of cells that are so many pixels wide and high.
pub fn pixels(plot: &Plot, columns: usize, rows: usize, [wide, high]: [u32; 2]) -> Pixels {
    let layout = laid_out(plot, columns, rows);
    let density = layout.shrink * f64::from(wide) / COLUMN;
    let width = layout.columns as u32 * wide;
    let height = (f64::from(layout.sheet.height) * density).ceil().max(1.0) as u32;
    let rgb = png::painted(&layout.sheet, density, width, height.next_multiple_of(high));
    Pixels { width, height: high, rgb }
}

impl Pixels {
    /// Pixels across.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Pixels down each row.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// sRGB by pixel, row by row of the terminal.
    pub fn rows(&self) -> impl Iterator<Item = &[u8]> {
        self.rgb.chunks_exact((3 * self.width * self.height) as usize)
    }

    /// A row as a PNG.
    pub fn png(&self, row: &[u8]) -> Vec<u8> {
        encode::quick_png(self.width, self.height, row)
    }

    /// The same, further from what catches the eye.
    pub fn dimmed(&self) -> Self {
        Self { rgb: self.rgb.iter().map(|part| pale(*part)).collect(), ..*self }
    }
}
