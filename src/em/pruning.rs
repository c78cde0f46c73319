//! What a scene left out of its grid, and what that saved.
//!
//! The measure is the grid that keeps everything: in every cell six coefficients and a current for each E component and
//! one coefficient for each H component. [`super::Stepping::pruned`] unset builds that grid; its fields are the same.

use super::Cpml;
use super::line::{Ends, Line};
use super::plane::Plane;
use super::span::{Need, Spans};
use super::stepping::WORD;
use crate::Polarisation;

/// Something a scene does not need.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Omission {
    /// One word for it.
    pub id: &'static str,
    /// What was left out.
    pub what: &'static str,
    /// Why it is not missed.
    pub why: &'static str,
    /// Memory saved [B].
    pub bytes: u64,
    /// Multiplications, additions and subtractions saved in each step.
    pub operations: u64,
}

/// What a grid takes, and what was left out of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Explanation {
    /// Number of cells.
    pub cells: u64,
    /// Memory of fields, coefficients and currents [B].
    pub bytes: u64,
    /// What was left out.
    pub omissions: Vec<Omission>,
}

impl Explanation {
    fn omit(&mut self, [id, what, why]: [&'static str; 3], bytes: u64, operations: u64) {
        if bytes + operations > 0 {
            self.omissions.push(Omission { id, what, why, bytes, operations });
        }
    }

    /// Memory saved [B per cell].
    pub fn bytes_saved_per_cell(&self) -> f64 {
        self.omissions.iter().map(|o| o.bytes).sum::<u64>() as f64 / self.cells as f64
    }

    /// Operations saved in each step [1 per cell].
    pub fn operations_saved_per_cell(&self) -> f64 {
        self.omissions.iter().map(|o| o.operations).sum::<u64>() as f64 / self.cells as f64
    }

    /// What the media did not ask for. Rows that share one layout are told by `rows`.
    fn media<'a>(&mut self, electric: impl Iterator<Item = &'a Spans>, magnetic: impl Iterator<Item = &'a Spans>) {
        let mut electric_cells = [0u64; 4];
        let mut shared = 0;
        for span in electric.flat_map(|spans| &spans.list) {
            electric_cells[span.need as usize] += span.range.len() as u64;
            shared += span.spared();
        }
        for span in magnetic.flat_map(|spans| &spans.list) {
            shared += span.spared();
        }
        let [clear, loss, conduction, _] = electric_cells;
        let step = |from: Need, to: Need| to.operations() - from.operations();
        self.omit(
            ["electrons", "free electrons", "no metal with a finite collision rate there"],
            (clear + loss + conduction) * 4 * WORD,
            (clear + loss + conduction) * step(Need::Conduction, Need::Electrons),
        );
        self.omit(
            ["dominant_conduction", "dominant conduction", "σ is zero or faint there"],
            (clear + loss) * WORD,
            (clear + loss) * step(Need::Loss, Need::Conduction),
        );
        self.omit(["conduction", "conduction", "σ is zero there"], clear * WORD, clear * step(Need::Clear, Need::Loss));
        self.omit(["coefficients", "coefficients cell by cell", "one set serves a uniform run"], shared * WORD, 0);
    }

    /// An end without absorber, along which `cells` cells lie.
    fn closed_end(&mut self, cells: u64, components: u64) {
        let thick = Cpml::thick(20).cells as u64 * cells * components;
        // ψ′ = bψ + cd and E += drive(ψ′ + kd): seven operations.
        self.omit(
            ["absorber", "an absorber of 20 cells", "the end is a conductor or repeats"],
            thick * WORD,
            thick * 7,
        );
    }
}

impl Line {
    /// What the line left out.
    pub fn explain(&self) -> Explanation {
        let cells = self.setup().cells as u64;
        let bytes = 2 * (cells + 1) * WORD + self.electric.bytes() + self.magnetic.bytes();
        let mut explanation = Explanation { cells, bytes, omissions: Vec::new() };
        explanation.media([&self.electric].into_iter(), [&self.magnetic].into_iter());
        for wall in self.setup().walls() {
            if wall.thickness() == 0 {
                explanation.closed_end(1, 2);
            }
        }
        if self.setup().ends != Ends::Periodic {
            explanation.omit(["images", "images across the ends", "the line does not repeat"], 0, 2);
        }
        // H along the propagation: its field and its update, and its difference in that of E.
        explanation.omit(
            ["second_dimension", "the second dimension", "nothing varies across the line"],
            cells * WORD,
            cells * 5,
        );
        explanation
    }
}

impl Plane {
    /// What the plane left out.
    pub fn explain(&self) -> Explanation {
        let [columns, rows] = self.setup().cells.map(|n| n as u64);
        let (cells, parts) = (columns * rows, self.parts() as u64);
        let fields = 3 * (columns + 1) * (rows + 1) * WORD;
        let layouts = || self.layouts().skip(1);
        let tables: u64 = self.distinct_layouts().map(|l| l.x.bytes() + l.y.bytes() + l.z.bytes()).sum();
        let mut explanation = Explanation { cells, bytes: fields * parts + tables, omissions: Vec::new() };
        match self.setup().polarisation {
            Polarisation::S => {
                explanation.media(layouts().map(|l| &l.z), layouts().flat_map(|l| [&l.x, &l.y]));
            }
            Polarisation::P => {
                explanation.media(layouts().flat_map(|l| [&l.x, &l.y]), layouts().map(|l| &l.z));
            }
        }
        let [left, right] = self.setup().walls_across().map(|wall| wall.thickness() == 0);
        let [bottom, top] = self.setup().ends.map(|wall| wall.thickness() == 0);
        for (closed, along) in [(left, rows), (right, rows), (bottom, columns), (top, columns)] {
            if closed {
                explanation.closed_end(along * parts, 2);
            }
        }
        if parts == 1 {
            // Two components of one difference, one of two.
            explanation.omit(["imaginary_part", "the imaginary part", "no Bloch phase"], fields, cells * 10);
        }
        explanation
    }
}
