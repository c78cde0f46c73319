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

    /// What the media did not ask for.
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
        let numbers = 2 * (cells + 1) + self.electric.currents as u64;
        let bytes = numbers * WORD + self.electric.bytes() + self.magnetic.bytes();
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
        // Rows may share their coefficients, but not their currents.
        let currents: usize = self.layouts().map(|l| l.x.currents + l.y.currents + l.z.currents).sum();
        let bytes = (fields + currents as u64 * WORD) * parts + tables;
        let mut explanation = Explanation { cells, bytes, omissions: Vec::new() };
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::em::plane::Sides;
    use crate::em::{Medium, Stepping, Wall, line, plane};

    fn line_of(medium: Medium) -> Explanation {
        let walls = Ends::Walls([Wall::Conductor; 2]);
        let vacuum = line::Setup::vacuum(100, 1.0, walls, Stepping::at(0.5));
        Line::new(line::Setup { background: medium, ..vacuum }).unwrap().explain()
    }

    /// Counted by hand: E is stepped at 99 nodes, H in 100 cells.
    #[test]
    fn a_line_of_vacuum_takes_its_fields_and_two_numbers() {
        let vacuum = line_of(Medium::VACUUM);
        assert_eq!(vacuum.bytes, (2 * 101 + 2) * WORD);
        let saved: Vec<_> = vacuum.omissions.iter().map(|o| (o.id, o.bytes / WORD, o.operations)).collect();
        let absorber = ("absorber", 40, 280);
        assert_eq!(
            saved,
            [
                ("electrons", 99 * 4, 99 * 6),
                ("dominant_conduction", 99, 99),
                ("conduction", 99, 99 * 2),
                ("coefficients", 98 + 99, 0),
                absorber,
                absorber,
                ("images", 0, 2),
                ("second_dimension", 100, 500),
            ]
        );
    }

    /// Coefficients of E, as the medium needs them, one of H, and a current of electrons a node.
    #[test]
    fn a_line_takes_what_its_medium_needs() {
        let words = |medium| line_of(medium).bytes / WORD - 2 * 101;
        assert_eq!(words(Medium::dielectric(4.0)), 1 + 1);
        assert_eq!(words(Medium::conductor(4.0, 1e-6)), 2 + 1);
        assert_eq!(words(Medium::conductor(4.0, 1e3)), 3 + 1);
        assert_eq!(words(Medium::metal(1e8, 1e6)), 6 + 1 + 99);
    }

    /// All rows share the coefficients, each has its currents: E_z at nodes in s, E_x and E_y in p; twice with a phase.
    #[test]
    fn a_plane_of_metal_has_currents_in_every_row() {
        for (polarisation, of_row, coefficients) in [(Polarisation::S, 10, 6 + 2), (Polarisation::P, 20, 12 + 1)] {
            for (phase, parts) in [(0.0, 1), (0.3, 2)] {
                let vacuum = plane::Setup::vacuum([10, 30], 1.0, polarisation, Stepping::at(0.5));
                let (background, sides) = (Medium::metal(1e8, 1e6), Sides::Bloch(phase));
                let plane = Plane::new(plane::Setup { background, sides, ..vacuum }).unwrap();
                let words = parts * (3 * 11 * 31 + of_row * 31) + coefficients;
                assert_eq!(plane.explain().bytes, words * WORD, "{polarisation:?}, phase {phase}");
            }
        }
    }
}
