//! From a setup to rows: what is needed is made, and nothing else.

use super::super::absorber::{Strip, Strips, Wall};
use super::super::aligned::Aligned;
use super::super::medium::{Coefficients, Medium, Surroundings};
use super::super::refusal::{Refusal, demand};
use super::super::span::{Need, Spans};
use super::super::stepping::{FIXED, Stepping, WORD, check_courant, check_grid, check_room, total};
use super::{Fields, Grid, Layout, Plane, Row, Setup, Sides};
use crate::Polarisation;
use fearless_simd::Level;
use num_complex::Complex64;
use std::sync::Arc;

impl Setup {
    pub(in super::super) fn walls_across(&self) -> [Wall; 2] {
        match self.sides {
            Sides::Walls(walls) => walls,
            Sides::Bloch(_) => [Wall::Conductor; 2],
        }
    }

    fn all_media(&self) -> impl Iterator<Item = &Medium> {
        std::iter::once(&self.background).chain(self.regions.iter().map(|region| &region.medium))
    }

    /// The most memory it takes [B], while it is built and after: fields, the map of the media, coefficients, currents
    /// and absorbers. `u64::MAX` if that or more.
    pub fn peak_bytes(&self) -> u64 {
        let [columns, rows] = self.cells.map(|n| (n as u64).saturating_add(1));
        let parts = self.parts() as u64;
        let (uniform, pruned) = (self.regions.is_empty(), self.stepping.pruned);
        let need = if pruned { Need::of_any(self.all_media()) } else { Need::Electrons };
        let [electric, magnetic] = if self.polarisation == Polarisation::S { [1, 2] } else { [2, 1] };
        let tables = if uniform && pruned { 0 } else { electric * need.columns() + magnetic };
        let currents = electric * (need.words() - need.columns()) * parts;
        let thick = |walls: [Wall; 2]| walls.iter().map(|w| w.thickness() as u64).fold(0, u64::saturating_add);
        let (across, along) = (thick(self.walls_across()), thick(self.ends));
        total([
            [columns, rows, (3 * parts + tables + currents) * WORD],
            [columns, rows, if uniform { 0 } else { size_of::<u16>() as u64 }],
            // ψ of two components, and the coefficients of the layers.
            [across, rows, 2 * parts * WORD],
            [along, columns, 2 * parts * WORD],
            [across.saturating_add(along), 6, WORD],
            // A row's coefficients, while runs of equal ones are sought, and what holds it together.
            [columns, 1, size_of::<Coefficients>() as u64],
            [rows, parts, FIXED],
            [1, 1, FIXED],
        ])
    }

    fn check(&self) -> Result<(), Refusal> {
        for cells in self.cells {
            demand(cells >= 1, "number of cells", cells as f64, "at least 1")?;
        }
        check_grid(self.spacing, &self.stepping)?;
        self.walls_across().iter().chain(&self.ends).try_for_each(Wall::check)?;
        self.all_media().try_for_each(Medium::check)?;
        check_courant(&self.stepping, self.all_media(), 2)?;
        let regions = self.regions.len();
        demand(regions < usize::from(u16::MAX), "number of regions", regions as f64, "below 65535")?;
        if let Sides::Bloch(phase) = self.sides {
            demand(phase.is_finite(), "Bloch phase", phase, "finite")?;
        }
        self.stepping.admit(self.peak_bytes())?;
        check_room(self.walls_across(), self.cells[0])?;
        check_room(self.ends, self.cells[1])
    }

    /// Which region each cell belongs to; none if all is background.
    fn map(&self) -> Option<Vec<u16>> {
        let [columns, rows] = self.cells;
        let middle = |i: usize| (i as f64 + 0.5) * self.spacing;
        let of = |i: usize, j: usize| {
            let covering = self.regions.iter().rposition(|region| (region.covers)(middle(i), middle(j)));
            covering.map_or(0, |k| k as u16 + 1)
        };
        (!self.regions.is_empty()).then(|| {
            let mut map = Vec::with_capacity(rows * columns);
            (0..rows).for_each(|j| map.extend((0..columns).map(|i| of(i, j))));
            map
        })
    }
}

impl Plane {
    /// Builds the plane at rest.
    ///
    /// # Errors
    /// No cells, unphysical media, a Courant number beyond the limit, a grid that exceeds the memory limit, absorbers
    /// that leave no room.
    pub fn new(setup: Setup) -> Result<Self, Refusal> {
        setup.check()?;
        let turn = if let Sides::Bloch(phase) = setup.sides { Complex64::cis(phase) } else { Complex64::ONE };
        let mut grid = Grid {
            map: setup.map(),
            turn,
            setup,
            layouts: Vec::new(),
            across: Strips::default(),
            along: Strips::default(),
            sources: Vec::new(),
            level: Level::new(),
        };
        let [columns, rows] = grid.setup.cells;
        let index = |i: usize, j: usize| grid.medium(i, j).bare_index();
        let (spacing, dt, middle) = (grid.setup.spacing, grid.dt(), (columns / 2, rows / 2));
        let beside = [index(0, middle.1), index(columns - 1, middle.1)];
        let across = Strips::new(grid.setup.walls_across(), columns, spacing, dt, beside);
        let beyond = [index(middle.0, 0), index(middle.0, rows - 1)];
        grid.along = Strips::new(grid.setup.ends, rows, spacing, dt, beyond);
        grid.across = across;
        grid.layouts = grid.layouts();
        let rows = (0..=rows).map(|j| Row { parts: grid.row(j), probes: Vec::new() }).collect();
        Ok(Self { grid, rows, incident: None, probes: 0, steps: 0 })
    }
}

impl Grid {
    /// One layout for every row; neighbours of the same kind share it.
    fn layouts(&self) -> Vec<Arc<Layout>> {
        let rows = self.setup.cells[1];
        let mut layouts: Vec<Arc<Layout>> = Vec::with_capacity(rows + 1);
        for j in 0..=rows {
            let same = |a: usize, b: usize| self.cells_of(a) == self.cells_of(b);
            let (below, here) = (j.saturating_sub(1), j.min(rows - 1));
            let shared = layouts.last().filter(|_| same(below, here) && same(below.saturating_sub(1), below));
            let layout = shared.map_or_else(|| Arc::new(self.layout(j)), Arc::clone);
            layouts.push(layout);
        }
        layouts
    }

    fn cells_of(&self, j: usize) -> &[u16] {
        let columns = self.setup.cells[0];
        self.map.as_ref().map_or(&[], |map| &map[j * columns..(j + 1) * columns])
    }

    /// For row `j`: what lies between the cells of rows j − 1 and j, and in row j. Beyond a wall lies what is before it.
    fn layout(&self, j: usize) -> Layout {
        let [columns, rows] = self.setup.cells;
        let Stepping { courant, conduction, pruned, .. } = self.setup.stepping;
        let dt = self.dt();
        let (below, here) = (j.saturating_sub(1), j.min(rows - 1));
        let electric = |range, at: fn(&Self, usize, usize) -> Surroundings| {
            let step = |i| at(self, i, j).coefficients(courant, dt, conduction);
            Spans::new(range, (!pruned).then_some(Need::Electrons), step)
        };
        let cell = |i: usize, j: usize| self.medium(i, j);
        let first = usize::from(matches!(self.setup.sides, Sides::Walls(_)));
        let between = |a: &Medium, b: &Medium| {
            // Along H's own direction B is continuous, and 1/μ is averaged.
            let mu_r = if a.mu_r == b.mu_r { a.mu_r } else { 2.0 / (1.0 / a.mu_r + 1.0 / b.mu_r) };
            Coefficients::magnetic(courant, mu_r)
        };
        let magnetic =
            |range, at: &dyn Fn(usize) -> Coefficients| Spans::new(range, (!pruned).then_some(Need::Clear), at);
        match self.setup.polarisation {
            Polarisation::S => Layout {
                z: electric(first..columns, Self::around_z),
                x: magnetic(first..columns, &|i| between(cell(self.left(i), here), cell(i, here))),
                y: magnetic(0..columns, &|i| between(cell(i, below), cell(i, here))),
            },
            Polarisation::P => Layout {
                x: electric(0..columns, Self::around_x),
                y: electric(first..columns, Self::around_y),
                z: magnetic(0..columns, &|i| Coefficients::magnetic(courant, cell(i, here).mu_r)),
            },
        }
    }

    fn left(&self, i: usize) -> usize {
        (i + self.setup.cells[0] - 1) % self.setup.cells[0]
    }

    /// Around E_z at (i, j).
    pub(in super::super) fn around_z(&self, i: usize, j: usize) -> Surroundings {
        let (left, below, here) = (self.left(i), j.saturating_sub(1), j.min(self.setup.cells[1] - 1));
        let cell = |i, j| self.medium(i, j);
        Surroundings::mean([cell(left, below), cell(i, below), cell(left, here), cell(i, here)])
    }

    /// Around E_x at (i + ½, j).
    pub(in super::super) fn around_x(&self, i: usize, j: usize) -> Surroundings {
        Surroundings::mean([self.medium(i, j.saturating_sub(1)), self.medium(i, j.min(self.setup.cells[1] - 1))])
    }

    /// Around E_y at (i, j + ½).
    pub(in super::super) fn around_y(&self, i: usize, j: usize) -> Surroundings {
        let here = j.min(self.setup.cells[1] - 1);
        Surroundings::mean([self.medium(self.left(i), here), self.medium(i, here)])
    }

    /// The fields of row `j` at rest.
    fn row(&self, j: usize) -> Vec<Fields> {
        let [columns, _] = self.setup.cells;
        let layout = &self.layouts[j];
        let zeros = |count: usize| vec![0.0; count];
        let (whole, half) = (&self.across.whole, &self.across.half);
        let strips = |list: &[Strip]| list.iter().map(|s| zeros(s.b.len())).collect();
        let graded = |list: &[Strip]| zeros(if list.iter().any(|s| s.at(j).is_some()) { columns } else { 0 });
        let (rows_whole, rows_half) = (&self.along.whole, &self.along.half);
        let fields = match self.setup.polarisation {
            Polarisation::S => Fields {
                currents: [zeros(layout.z.currents), Vec::new()],
                psi_zx: strips(whole),
                psi_yx: strips(half),
                psi_zy: graded(rows_whole),
                psi_xy: graded(rows_half),
                ..Fields::default()
            },
            Polarisation::P => Fields {
                currents: [zeros(layout.x.currents), zeros(layout.y.currents)],
                psi_zx: strips(half),
                psi_yx: strips(whole),
                psi_zy: graded(rows_half),
                psi_xy: graded(rows_whole),
                ..Fields::default()
            },
        };
        // The image of the last component at i + ½ stands before the first.
        let [image_y, image_z] = if self.setup.polarisation == Polarisation::S { [1, 0] } else { [0, 1] };
        let full = Fields {
            x: Aligned::zeros(columns, 0),
            y: Aligned::zeros(columns + 1, image_y),
            z: Aligned::zeros(columns + 1, image_z),
            ..fields
        };
        vec![full; self.setup.parts()]
    }
}
