//! Two dimensions: s (E_z, H_x, H_y) and p (H_z, E_x, E_y) in the plane (x, y), nothing varying along z.
//!
//! T&H §3.6. With i and j counting cells along x and y, and the magnetic components half a step later:
//!
//! | | at (i, j) | at (i, j + ½) | at (i + ½, j) | at (i + ½, j + ½) |
//! |---|---|---|---|---|
//! | s | E_z | H_x | H_y | |
//! | p | | E_y | E_x | H_z |
//!
//! The books on grids call s TM and p TE, see [`Polarisation`]. Cells carry the media; an E component takes the
//! mean ε and σ of the cells it touches, an H component the harmonic mean of μ, which makes an interface along the grid
//! second-order accurate. Along y stand walls; along x walls, or the structure repeats and the field gains a phase
//! from one period to the next (Bloch): then it is complex, and a second real grid carries its imaginary part.
//!
//! A row holds all its components, and rows are stepped in a wave front that carries several steps at once: rows up to
//! j at step s, then those up to j − 1 at step s + 1, … while they are in cache. Threads take bands of rows: each band shrinks by a
//! row a step at its edges, and then the gaps between bands are filled (trapezoids; Frigo & Strumpen 2005). The
//! arithmetic of a cell is the same in all of them, bit by bit.

mod audit;
mod build;
mod stages;
mod sweep;

use super::Z_0;
use super::absorber::{Cpml, Strips, Wall};
use super::aligned::Aligned;
use super::incident::{Incident, Route};
use super::medium::{Medium, time_step};
use super::pulse::Pulse;
use super::refusal::{Refusal, demand, inside};
use super::span::Spans;
use super::stepping::Stepping;
use crate::Polarisation;
use fearless_simd::Level;
use num_complex::Complex64;
use std::fmt;
use std::ops::Range;
use std::sync::Arc;

/// What stands at the two ends of x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sides {
    /// A wall at each end.
    Walls([Wall; 2]),
    /// The structure repeats, and the field is that of the left side times e^(i phase), phase [rad] = k_x × width.
    /// With phase 0 it is periodic, and real.
    Bloch(f64),
}

/// A part of the plane and what fills it.
#[derive(Clone)]
pub struct Region {
    covers: Arc<dyn Fn(f64, f64) -> bool + Send + Sync>,
    /// What fills it.
    pub medium: Medium,
}

impl Region {
    /// Wherever `covers(x, y)` [m] holds at the middle of a cell.
    pub fn new(covers: impl Fn(f64, f64) -> bool + Send + Sync + 'static, medium: Medium) -> Self {
        Self { covers: Arc::new(covers), medium }
    }

    /// The layer y.start ≤ y < y.end [m].
    pub fn layer(y: Range<f64>, medium: Medium) -> Self {
        Self::new(move |_, at| y.contains(&at), medium)
    }

    /// A disc: centre and radius [m].
    pub fn disc(centre: [f64; 2], radius: f64, medium: Medium) -> Self {
        Self::new(move |x, y| (x - centre[0]).hypot(y - centre[1]) < radius, medium)
    }
}

impl fmt::Debug for Region {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "Region of {:?}", self.medium)
    }
}

/// A plane to be built.
#[derive(Clone, Debug)]
pub struct Setup {
    /// Number of cells along x and y, absorbers included.
    pub cells: [usize; 2],
    /// Δ [m], the same along both.
    pub spacing: f64,
    /// Which components there are.
    pub polarisation: Polarisation,
    /// What stands at the ends of x.
    pub sides: Sides,
    /// What stands at the ends of y.
    pub ends: [Wall; 2],
    /// What fills the cells that no region covers.
    pub background: Medium,
    /// Later regions replace earlier ones.
    pub regions: Vec<Region>,
    /// How it is stepped.
    pub stepping: Stepping,
}

impl Setup {
    /// Vacuum between conductors.
    pub fn vacuum(cells: [usize; 2], spacing: f64, polarisation: Polarisation, stepping: Stepping) -> Self {
        let walls = [Wall::Conductor; 2];
        let (sides, background) = (Sides::Walls(walls), Medium::VACUUM);
        Self { cells, spacing, polarisation, sides, ends: walls, background, regions: Vec::new(), stepping }
    }

    /// The same, open on all four sides: layers of `cells` cells.
    pub fn open(self, cells: usize) -> Self {
        let walls = [Wall::Open(Cpml::thick(cells)); 2];
        Self { sides: Sides::Walls(walls), ends: walls, ..self }
    }

    /// The same, repeating along x with this phase [rad], and open along y.
    pub fn bloch(self, phase: f64, cells: usize) -> Self {
        Self { sides: Sides::Bloch(phase), ends: [Wall::Open(Cpml::thick(cells)); 2], ..self }
    }

    fn parts(&self) -> usize {
        if matches!(self.sides, Sides::Bloch(phase) if phase != 0.0) { 2 } else { 1 }
    }
}

/// One real grid's share of a row: E_z(i, j), H_x(i, j + ½), H_y(i + ½, j) in s; H_z(i + ½, j + ½), E_x(i + ½, j),
/// E_y(i, j + ½) in p. Components at i + ½ of the array that is differenced along x stand at i + 1, after the image of
/// the last one. All in V/m.
#[derive(Clone, Debug, Default)]
struct Fields {
    x: Aligned,
    y: Aligned,
    z: Aligned,
    currents: [Vec<f64>; 2],
    /// What absorbers remember, by component and direction of the derivative.
    psi_zx: Vec<Vec<f64>>,
    psi_yx: Vec<Vec<f64>>,
    psi_zy: Vec<f64>,
    psi_xy: Vec<f64>,
}

/// A row of cells.
#[derive(Clone, Debug)]
struct Row {
    /// Real part and, with a Bloch phase, imaginary part.
    parts: Vec<Fields>,
    /// Column, number and record of its probes.
    probes: Vec<(usize, usize, Vec<Complex64>)>,
}

/// How the rows of one kind are stepped.
#[derive(Debug, PartialEq, Default)]
pub(super) struct Layout {
    pub x: Spans,
    pub y: Spans,
    pub z: Spans,
}

/// A current at a component.
#[derive(Clone, Debug)]
struct Source {
    at: [usize; 2],
    /// Current times spacing times Z₀ [V/m].
    amplitude: f64,
    pulse: Pulse,
}

/// Everything about the grid that steps do not change.
#[derive(Clone, Debug)]
pub(super) struct Grid {
    setup: Setup,
    layouts: Vec<Arc<Layout>>,
    /// Each cell's medium, if there is more than one: 0 is the background, k the region k − 1.
    map: Option<Vec<u16>>,
    across: Strips,
    along: Strips,
    /// e^(i phase) from one period to the next.
    turn: Complex64,
    sources: Vec<Source>,
    /// What the processor can do.
    pub(super) level: Level,
}

/// Fields in a plane, and everything that steps them.
#[derive(Clone, Debug)]
pub struct Plane {
    pub(super) grid: Grid,
    rows: Vec<Row>,
    incident: Option<Incident>,
    probes: usize,
    steps: u64,
}

impl Plane {
    /// What it was built from.
    pub fn setup(&self) -> &Setup {
        &self.grid.setup
    }

    /// Δt [s].
    pub fn dt(&self) -> f64 {
        self.grid.dt()
    }

    /// How many steps it has run; E is at `steps`·Δt, H half a step later.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// The component along z, row by row: in s E_z [V/m] at (i, j), i = 0 … N, j = 0 … M; in p H_z [A/m] at
    /// (i + ½, j + ½), i = 0 … N − 1, j = 0 … M − 1. The real part, where it is complex.
    pub fn z(&self) -> Vec<Vec<f64>> {
        let [_, rows] = self.grid.setup.cells;
        match self.grid.setup.polarisation {
            Polarisation::S => self.rows.iter().map(|row| row.parts[0].z.to_vec()).collect(),
            Polarisation::P => {
                let si = |row: &Row| row.parts[0].z[1..].iter().map(|h| h / Z_0).collect();
                self.rows[..rows].iter().map(si).collect()
            }
        }
    }

    /// Sets the z component from its real and imaginary part at (x, y) [m]: E_z [V/m] at the present time, or H_z [A/m]
    /// half a step later. Components on a conductor stay zero, and the imaginary part is dropped where fields are real.
    pub fn set_z(&mut self, field: impl Fn(f64, f64) -> Complex64) {
        let [columns, rows] = self.grid.setup.cells;
        let (spacing, scale) = (self.grid.setup.spacing, [1.0, Z_0][usize::from(self.is_p())]);
        let (shift, offset) = if self.is_p() { (0.5, 1) } else { (0.0, 0) };
        let periodic = matches!(self.grid.setup.sides, Sides::Bloch(_));
        let first = usize::from(!self.is_p());
        let first_column = usize::from(!self.is_p() && !periodic);
        for j in first..rows {
            for i in first_column..columns {
                let value = scale * field((i as f64 + shift) * spacing, (j as f64 + shift) * spacing);
                for (part, value) in self.rows[j].parts.iter_mut().zip([value.re, value.im]) {
                    part.z[i + offset] = value;
                }
            }
            self.grid.wrap_row(&mut self.rows[j]);
        }
    }

    pub(super) fn parts(&self) -> usize {
        self.grid.setup.parts()
    }

    /// The layout of every row.
    pub(super) fn layouts(&self) -> impl Iterator<Item = &Layout> {
        self.grid.layouts.iter().map(Arc::as_ref)
    }

    /// Every layout once.
    pub(super) fn distinct_layouts(&self) -> impl Iterator<Item = &Layout> {
        let layouts = &self.grid.layouts;
        let new = |j: &usize| *j == 0 || !Arc::ptr_eq(&layouts[j - 1], &layouts[*j]);
        (0..layouts.len()).filter(new).map(|j| layouts[j].as_ref())
    }

    fn is_p(&self) -> bool {
        self.grid.setup.polarisation == Polarisation::P
    }

    /// A current `amplitude` [A/m²] × pulse: J_z at node (i, j) in s, J_x at (i + ½, j) in p.
    ///
    /// # Errors
    /// If the place is not stepped.
    pub fn inject(&mut self, at: [usize; 2], amplitude: f64, pulse: Pulse) -> Result<(), Refusal> {
        let [columns, rows] = self.grid.setup.cells;
        let amplitude = amplitude * Z_0 * self.grid.setup.spacing;
        demand(amplitude.is_finite(), "amplitude of a source", amplitude, "finite")?;
        pulse.check()?;
        let first = usize::from(!self.is_p() && matches!(self.grid.setup.sides, Sides::Walls(_)));
        inside("the column of a current", at[0], first, columns - 1)?;
        inside("the row of a current", at[1], 1, rows - 1)?;
        self.grid.sources.push(Source { at, amplitude, pulse });
        Ok(())
    }

    /// A plane wave of tangential electric field `amplitude` [V/m] × pulse × e^(ik_x x) that travels towards larger y
    /// and exists from row `row` on (total field) and not before it (scattered field); T&H §5.10. k_x is that of the
    /// sides' Bloch phase, so sin θ = ck_x/(nω). It is stepped on a line of its own, of the medium at the row, which it
    /// enters one row earlier: exact for 7000 steps, and thereafter but for the echo of a layer of 512 cells. It replaces
    /// an earlier one.
    ///
    /// Of a short pulse some frequencies lie near ck_x/n, where the wave grazes: it hardly moves along y and no layer
    /// absorbs it. Keep its spectrum clear of them: (1 − sin θ) ω above some six of its standard deviations.
    ///
    /// # Errors
    /// If the sides do not repeat, the row lies in an absorber or next to a wall, or its cells and those of the row
    /// before it are not all of one medium.
    pub fn illuminate(&mut self, row: usize, amplitude: f64, pulse: Pulse) -> Result<(), Refusal> {
        let setup = &self.grid.setup;
        let [columns, rows] = setup.cells;
        let valid = "periodic or Bloch-periodic sides (a number)";
        let Sides::Bloch(phase) = setup.sides else {
            return Err(Refusal::OutOfRange { what: "the phase of an incident wave", given: f64::NAN, valid });
        };
        let last = (rows - setup.ends[1].thickness()).saturating_sub(1);
        inside("the row of an incident wave", row, setup.ends[0].thickness() + 1, last)?;
        let Setup { ref stepping, spacing, polarisation, .. } = *setup;
        stepping.admit(setup.peak_bytes().saturating_add(Incident::BYTES))?;
        let medium = self.grid.medium(0, row);
        if (row - 1..=row).any(|j| (0..columns).any(|i| self.grid.medium(i, j) != medium)) {
            return Err(Refusal::Mixed { what: "an incident wave in row", at: row });
        }
        let route = Route { medium, stepping, spacing, phase: phase / columns as f64, polarisation };
        self.incident = Some(Incident::new(row, &route, amplitude, pulse, self.steps)?);
        Ok(())
    }

    /// Records the z component at (i, j) (s) or (i + ½, j + ½) (p) after every step from now on.
    ///
    /// # Errors
    /// If the place is not on the grid.
    pub fn probe(&mut self, at: [usize; 2]) -> Result<usize, Refusal> {
        let [columns, rows] = self.grid.setup.cells;
        inside("the column of a probe", at[0], 0, columns - 1)?;
        inside("the row of a probe", at[1], 0, rows - 1)?;
        self.rows[at[1]].probes.push((at[0], self.probes, Vec::new()));
        self.probes += 1;
        Ok(self.probes - 1)
    }

    /// The z component [V/m or A/m] after each step since the probe was set.
    pub fn record(&self, probe: usize) -> Vec<Complex64> {
        let scale = if self.is_p() { 1.0 / Z_0 } else { 1.0 };
        let mut probes = self.rows.iter().flat_map(|row| &row.probes);
        let found = probes.find(|(_, number, _)| *number == probe);
        found.map(|(_, _, record)| record.iter().map(|z| z * scale).collect()).unwrap_or_default()
    }

    /// The incident wave's z component [V/m or A/m] at column 0 after each step: E_z in its row, H_z half a row above.
    pub fn incident(&self) -> Option<Vec<Complex64>> {
        let scale = if self.is_p() { 1.0 / Z_0 } else { 1.0 };
        let incident = self.incident.as_ref()?;
        Some(incident.record.iter().map(|z| Complex64::from(z * scale)).collect())
    }
}

impl Grid {
    fn dt(&self) -> f64 {
        time_step(self.setup.stepping.courant, self.setup.spacing)
    }

    /// The medium of a cell.
    fn medium(&self, i: usize, j: usize) -> &Medium {
        match self.map.as_ref().map_or(0, |map| map[j * self.setup.cells[0] + i]) {
            0 => &self.setup.background,
            k => &self.setup.regions[usize::from(k) - 1].medium,
        }
    }
}
