//! In which order rows are stepped.

use super::super::incident::Incident;
use super::super::refusal::{Refusal, demand};
use super::super::stepping::WORD;
use super::stages::Moment;
use super::{Grid, Plane, Row};

/// What a wave front may keep in cache [B]: a share of the last level, which is fast enough, for the sake of long rows.
const CACHE: u64 = 2 << 20;
/// What is at hand at once [B].
const NEAREST: u64 = 32 << 10;
/// The most rows that are stepped before the next step follows.
const WIDEST: u64 = 8;
/// The most steps that are carried at once.
const DEEPEST: u64 = 32;

/// Rows lo ≤ j < hi at step s = 0, each end moving by so many rows a step.
#[derive(Clone, Copy, Debug)]
struct Band {
    lo: isize,
    hi: isize,
    lo_moves: isize,
    hi_moves: isize,
}

impl Band {
    fn holds(&self, j: isize, s: usize) -> bool {
        let s = s as isize;
        self.lo + s * self.lo_moves <= j && j < self.hi + s * self.hi_moves
    }
}

/// Some steps, and what arrives from outside in them.
#[derive(Clone, Copy, Debug)]
struct Block<'a> {
    start: u64,
    deep: usize,
    /// How many rows are stepped before the next step follows.
    wide: usize,
    incident: Option<(usize, &'a [[f64; 2]])>,
}

impl Plane {
    /// Steps `steps` times, on one core or, with the feature `parallel`, on all of the current thread pool; the fields
    /// are the same bit by bit.
    ///
    /// # Errors
    /// If `steps` is zero, or what is recorded in them would exceed the memory limit.
    pub fn run(&mut self, steps: u64) -> Result<(), Refusal> {
        #[cfg(feature = "parallel")]
        let bands = rayon::current_num_threads();
        #[cfg(not(feature = "parallel"))]
        let bands = 1;
        self.run_in_bands(steps, bands)
    }

    /// The same on one core.
    ///
    /// # Errors
    /// As [`Self::run`].
    pub fn run_serial(&mut self, steps: u64) -> Result<(), Refusal> {
        self.run_in_bands(steps, 1)
    }

    pub(in super::super) fn run_in_bands(&mut self, steps: u64, bands: usize) -> Result<(), Refusal> {
        demand(steps >= 1, "number of steps", steps as f64, "at least 1")?;
        let probes = self.rows.iter().flat_map(|row| &row.probes);
        let records = probes.map(|(_, _, record)| (record.len(), 2 * WORD));
        let records = records.chain(self.incident.as_ref().map(Incident::recorded));
        let wave = if self.incident.is_some() { Incident::BYTES } else { 0 };
        let setup = &self.grid.setup;
        setup.stepping.admit_records(setup.peak_bytes().saturating_add(wave), steps, records)?;
        let mut left = steps;
        while left > 0 {
            let deep = left.min(self.deep());
            self.block(deep as usize, bands);
            left -= deep;
        }
        Ok(())
    }

    /// How many steps are carried at once: as many as there are rows that fit the cache.
    fn deep(&self) -> u64 {
        (CACHE / self.row_bytes()).saturating_sub(2).clamp(1, DEEPEST)
    }

    /// How many rows are stepped before the next step follows: with the two beside them they stay in the nearest cache,
    /// where the next step finds all but one of them.
    fn wide(&self) -> usize {
        (NEAREST / self.row_bytes()).saturating_sub(2).clamp(1, WIDEST) as usize
    }

    fn row_bytes(&self) -> u64 {
        let setup = &self.grid.setup;
        (setup.cells[0] as u64 + 1) * 3 * WORD * setup.parts() as u64
    }

    fn block(&mut self, deep: usize, bands: usize) {
        if let Some(incident) = &mut self.incident {
            incident.look_ahead(deep, self.grid.level);
        }
        let incident = self.incident.as_ref().map(|incident| (incident.at, &incident.ahead[..]));
        let block = Block { start: self.steps, deep, wide: self.wide(), incident };
        let rows = self.rows.len() as isize - 1;
        // A band must outlast its shrinking from both sides.
        let bands = bands.clamp(1, (rows as usize / (2 * deep + 4)).max(1));
        if bands == 1 {
            let all = Band { lo: 0, hi: rows, lo_moves: 0, hi_moves: 0 };
            self.grid.sweep(&mut self.rows, 0, block, all, all);
        } else {
            in_bands(&self.grid, &mut self.rows, block, bands);
        }
        self.steps += deep as u64;
    }
}

/// Bands first, each shrinking; then what they left, growing about each border.
fn in_bands(grid: &Grid, rows: &mut [Row], block: Block, bands: usize) {
    let count = rows.len() - 1;
    let border = |band: usize| band * count / bands;
    let last = |band: usize| if band == bands { count + 1 } else { border(band) };
    let mut rest = &mut rows[..];
    let mut windows = Vec::with_capacity(bands);
    for band in 0..bands {
        let (window, others) = std::mem::take(&mut rest).split_at_mut(last(band + 1) - border(band));
        rest = others;
        let (a, b) = (border(band) as isize, border(band + 1) as isize);
        let (first, end) = (band == 0, band + 1 == bands);
        let (lo, lo_moves) = if first { (a, 0) } else { (a + 1, 1) };
        let hi_moves = if end { 0 } else { -1 };
        let e = Band { lo, hi: b, lo_moves, hi_moves };
        let h = Band { hi: if end { b } else { b - 1 }, ..e };
        windows.push((window, border(band), e, h));
    }
    each(windows, |(window, first, e, h)| grid.sweep(window, first, block, e, h));
    let middle = |band: usize| (border(band) + border(band + 1)) / 2;
    let mut windows = Vec::with_capacity(bands - 1);
    let (_, mut rest) = rows.split_at_mut(middle(0));
    for band in 1..bands {
        let (window, others) = std::mem::take(&mut rest).split_at_mut(middle(band) - middle(band - 1));
        rest = others;
        let b = border(band) as isize;
        let e = Band { lo: b, hi: b + 1, lo_moves: -1, hi_moves: 1 };
        let h = Band { lo: b - 1, ..e };
        windows.push((window, middle(band - 1), e, h));
    }
    each(windows, |(window, first, e, h)| grid.sweep(window, first, block, e, h));
}

#[cfg(feature = "parallel")]
fn each<T: Send>(items: Vec<T>, f: impl Fn(T) + Send + Sync) {
    use rayon::prelude::*;
    items.into_par_iter().for_each(f);
}

#[cfg(not(feature = "parallel"))]
fn each<T>(items: Vec<T>, f: impl Fn(T)) {
    items.into_iter().for_each(f);
}

impl Grid {
    /// Steps the bands of E and H in a wave front: rows up to j at step s before those up to j − 1 at step s + 1. `window` holds all
    /// rows that are read or written, from row `first` on.
    fn sweep(&self, window: &mut [Row], first: usize, block: Block, e: Band, h: Band) {
        let deep = block.deep as isize;
        let least = e.lo.min(h.lo) - deep;
        let most = e.hi.max(h.hi) + 2 * deep + 1;
        for front in (least..most).step_by(block.wide) {
            for s in 0..block.deep {
                let incident = block.incident.map(|(row, ahead)| (row, ahead[s]));
                let moment = Moment { step: block.start + s as u64, incident };
                let front = front - s as isize;
                for j in front..front + block.wide as isize {
                    if e.holds(j, s) {
                        let (below, here) = window.split_at_mut(j as usize - first);
                        self.step_electric(below.last(), &mut here[0], j as usize, moment);
                    }
                    if h.holds(j - 1, s) {
                        let (here, above) = window.split_at_mut(j as usize - first);
                        self.step_magnetic(here.last_mut().expect("a row"), &above[0], j as usize - 1, moment);
                    }
                }
            }
        }
    }
}
