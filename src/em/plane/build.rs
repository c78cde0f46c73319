//! From a setup to rows: what is needed is made, and nothing else.

use super::super::absorber::{Strip, Strips, Wall};
use super::super::line::{check_courant, check_grid};
use super::super::medium::{Coefficients, Medium, Surroundings};
use super::super::refusal::{Refusal, demand};
use super::super::span::{Need, Spans};
use super::super::{Stepping, WORD};
use super::{Fields, Grid, Layout, Plane, Polarisation, Row, Setup, Sides};
use std::sync::Arc;

impl Setup {
    pub(in super::super) fn walls_across(&self) -> [Wall; 2] {
        match self.sides {
            Sides::Walls(walls) => walls,
            Sides::Bloch(_) => [Wall::Conductor; 2],
        }
    }

    /// Bytes of the fields alone.
    fn bytes(&self) -> u64 {
        let [columns, rows] = self.cells.map(|n| (n as u64).saturating_add(1));
        columns.saturating_mul(rows).saturating_mul(3 * WORD * self.parts() as u64)
    }

    fn check(&self) -> Result<(), Refusal> {
        for cells in self.cells {
            demand(cells >= 1, "number of cells", cells as f64, "at least 1")?;
        }
        check_grid(self.spacing, &self.stepping, self.bytes())?;
        let media = || std::iter::once(&self.background).chain(self.regions.iter().map(|region| &region.medium));
        media().try_for_each(Medium::check)?;
        check_courant(&self.stepping, media(), 2)?;
        let regions = self.regions.len();
        demand(regions < usize::from(u16::MAX), "number of regions", regions as f64, "below 65535")?;
        if let Sides::Bloch(phase) = self.sides {
            demand(phase.is_finite(), "Bloch phase", phase, "finite")?;
        }
        for (walls, cells) in [(self.walls_across(), self.cells[0]), (self.ends, self.cells[1])] {
            walls.iter().try_for_each(Wall::check)?;
            let thick = walls[0].thickness().saturating_add(walls[1].thickness());
            demand(thick < cells, "thickness of both absorbers", thick as f64, "less than the number of cells")?;
        }
        Ok(())
    }

    /// Which region each cell belongs to; none if all is background.
    fn map(&self) -> Option<Vec<u16>> {
        let [columns, rows] = self.cells;
        let middle = |i: usize| (i as f64 + 0.5) * self.spacing;
        let of = |i: usize, j: usize| {
            let covering = self.regions.iter().rposition(|region| (region.covers)(middle(i), middle(j)));
            covering.map_or(0, |k| k as u16 + 1)
        };
        let all = || (0..rows).flat_map(|j| (0..columns).map(move |i| of(i, j))).collect();
        (!self.regions.is_empty()).then(all)
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
        let mut grid = Grid {
            map: setup.map(),
            setup,
            layouts: Vec::new(),
            across: Strips::default(),
            along: Strips::default(),
            sources: Vec::new(),
            entry: None,
        };
        let [columns, rows] = grid.setup.cells;
        let impedance = |i: usize, j: usize| {
            let medium = grid.medium(i, j);
            (medium.mu_r / medium.eps_r).sqrt()
        };
        let (spacing, dt, middle) = (grid.setup.spacing, grid.dt(), (columns / 2, rows / 2));
        let beside = [impedance(0, middle.1), impedance(columns - 1, middle.1)];
        let across = Strips::new(grid.setup.walls_across(), columns, spacing, dt, beside);
        let beyond = [impedance(middle.0, 0), impedance(middle.0, rows - 1)];
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
            Polarisation::Tm => Layout {
                z: electric(first..columns, Self::around_z),
                x: magnetic(first..columns, &|i| between(cell(self.left(i), here), cell(i, here))),
                y: magnetic(0..columns, &|i| between(cell(i, below), cell(i, here))),
            },
            Polarisation::Te => Layout {
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
            Polarisation::Tm => Fields {
                currents: [zeros(layout.z.currents), Vec::new()],
                psi_zx: strips(whole),
                psi_yx: strips(half),
                psi_zy: graded(rows_whole),
                psi_xy: graded(rows_half),
                ..Fields::default()
            },
            Polarisation::Te => Fields {
                currents: [zeros(layout.x.currents), zeros(layout.y.currents)],
                psi_zx: strips(half),
                psi_yx: strips(whole),
                psi_zy: graded(rows_half),
                psi_xy: graded(rows_whole),
                ..Fields::default()
            },
        };
        let full = Fields { x: zeros(columns), y: zeros(columns + 1), z: zeros(columns + 1), ..fields };
        vec![full; self.setup.parts()]
    }
}
