//! One dimension: E_x and H_y along z.
//!
//! ∂D_x/∂t = −∂H_y/∂z − J_x, ∂B_y/∂t = −∂E_x/∂z. E_k stands at z = kΔ, k = 0 … N, and H_(k+½) in the middle of cell k,
//! half a step later; T&H §3.6. Cells carry the media; E takes the mean of its two.
//!
//! Time runs through tiles: a tile of cells is stepped many times while it is in cache, each step one cell further
//! to the left, so that what it needs from its left neighbour is there and what it needs from its right is not yet
//! overwritten (time skewing; Wonnacott 2000). The arithmetic of a cell is the same, bit by bit.

use super::Z_0;
use super::absorber::{Cpml, Strip, Strips, Wall};
use super::aligned::Aligned;
use super::incident::{Incident, Route};
use super::kernel::Difference;
use super::medium::{Coefficients, Medium, Surroundings, time_step};
use super::pulse::Pulse;
use super::refusal::{Refusal, demand, inside};
use super::span::{Need, Spans};
use super::stepping::{FIXED, Stepping, WORD, check_courant, check_grid, check_room, total};
use crate::Polarisation;
use fearless_simd::Level;
use std::ops::Range;

/// What stands at the two ends of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ends {
    /// A wall at each end.
    Walls([Wall; 2]),
    /// The end is the beginning.
    Periodic,
}

impl Ends {
    /// Open space at both ends: layers of `cells` cells.
    pub const fn open(cells: usize) -> Self {
        Self::Walls([Wall::Open(Cpml::thick(cells)); 2])
    }
}

/// A line to be built.
#[derive(Clone, Debug, PartialEq)]
pub struct Setup {
    /// Number of cells N, absorbers included.
    pub cells: usize,
    /// Δ [m].
    pub spacing: f64,
    /// What stands at the ends.
    pub ends: Ends,
    /// What fills the cells that no layer claims.
    pub background: Medium,
    /// Cells and what fills them; later layers replace earlier ones.
    pub layers: Vec<(Range<usize>, Medium)>,
    /// How it is stepped.
    pub stepping: Stepping,
}

impl Setup {
    /// Vacuum.
    pub fn vacuum(cells: usize, spacing: f64, ends: Ends, stepping: Stepping) -> Self {
        Self { cells, spacing, ends, background: Medium::VACUUM, layers: Vec::new(), stepping }
    }

    pub(super) fn walls(&self) -> [Wall; 2] {
        match self.ends {
            Ends::Walls(walls) => walls,
            Ends::Periodic => [Wall::Conductor; 2],
        }
    }

    fn all_media(&self) -> impl Iterator<Item = &Medium> {
        std::iter::once(&self.background).chain(self.layers.iter().map(|(_, medium)| medium))
    }

    /// The most memory it takes [B], while it is built and after: fields, coefficients, currents and absorbers.
    /// `u64::MAX` if that or more.
    pub fn peak_bytes(&self) -> u64 {
        let cells = (self.cells as u64).saturating_add(1);
        let uniform = self.layers.is_empty() && self.stepping.pruned;
        let need = if self.stepping.pruned { Need::of_any(self.all_media()) } else { Need::Electrons };
        let words = if uniform { need.words() - need.columns() } else { need.words() + 1 };
        let thick: u64 = self.walls().iter().map(|wall| wall.thickness() as u64).fold(0, u64::saturating_add);
        total([
            [cells, 2, WORD],
            [cells, words, WORD],
            // Each cell's medium and coefficients, while runs of equal ones are sought.
            [cells, 1, (size_of::<Medium>() + size_of::<Coefficients>()) as u64],
            // ψ and its three coefficients, for E and for H.
            [thick, 8, WORD],
            [self.layers.len() as u64, 4, FIXED],
            [1, 1, FIXED],
        ])
    }

    fn check(&self) -> Result<(), Refusal> {
        demand(self.cells >= 1, "number of cells", self.cells as f64, "at least 1")?;
        check_grid(self.spacing, &self.stepping)?;
        self.walls().iter().try_for_each(Wall::check)?;
        self.all_media().try_for_each(Medium::check)?;
        check_courant(&self.stepping, self.all_media(), 1)?;
        self.stepping.admit(self.peak_bytes())?;
        for (range, _) in &self.layers {
            let thickness = range.end as f64 - range.start as f64;
            demand(range.start < range.end, "thickness of a layer", thickness, "at least 1 cell")?;
            inside("the end of a layer", range.end, 1, self.cells)?;
        }
        check_room(self.walls(), self.cells)
    }

    fn medium(&self, cell: usize) -> Medium {
        self.layers.iter().rfind(|(range, _)| range.contains(&cell)).map_or(self.background, |(_, medium)| *medium)
    }

    /// The medium of each cell.
    pub(super) fn media(&self) -> Vec<Medium> {
        let mut cells = vec![self.background; self.cells];
        for (range, medium) in &self.layers {
            cells[range.clone()].fill(*medium);
        }
        cells
    }
}

/// A signal at one node.
#[derive(Clone, Debug)]
struct Source {
    node: usize,
    amplitude: f64,
    pulse: Pulse,
    /// Whether the field itself is imposed, and not a current.
    hard: bool,
}

/// How many nodes make a tile, and for how many steps it is kept in cache.
const TILE: usize = 1024;
const DEEP: usize = 64;

/// Fields along a line, and everything that steps them.
#[derive(Clone, Debug)]
pub struct Line {
    setup: Setup,
    /// E_k [V/m], k = 0 … N.
    pub(super) e: Aligned,
    /// Z₀H_(k−½) [V/m], k = 1 … N; the first is the image of the last if periodic.
    pub(super) h: Aligned,
    pub(super) electric: Spans,
    pub(super) magnetic: Spans,
    pub(super) currents: Vec<f64>,
    strips: Strips,
    psi_e: Vec<Vec<f64>>,
    psi_h: Vec<Vec<f64>>,
    sources: Vec<Source>,
    incident: Option<Incident>,
    probes: Vec<(usize, Vec<f64>)>,
    steps: u64,
    /// What the processor can do.
    pub(super) level: Level,
}

impl Line {
    /// Builds the line at rest.
    ///
    /// # Errors
    /// No cells, unphysical media, a Courant number beyond the limit, a grid that exceeds the memory limit, absorbers
    /// that leave no room, layers outside the grid.
    pub fn new(setup: Setup) -> Result<Self, Refusal> {
        setup.check()?;
        let (media, n) = (setup.media(), setup.cells);
        let Stepping { courant, conduction, pruned, .. } = setup.stepping;
        let dt = time_step(courant, setup.spacing);
        let first = usize::from(setup.ends != Ends::Periodic);
        let all = |need| (!pruned).then_some(need);
        let electric = Spans::new(first..n, all(Need::Electrons), |k| {
            let cells = [&media[(k + n - 1) % n], &media[k]];
            Surroundings::mean(cells).coefficients(courant, dt, conduction)
        });
        let magnetic = Spans::new(0..n, all(Need::Clear), |k| Coefficients::magnetic(courant, media[k].mu_r));
        let index = [&media[0], &media[n - 1]].map(Medium::bare_index);
        let strips = Strips::new(setup.walls(), n, setup.spacing, dt, index);
        let zeros = |strips: &[Strip]| strips.iter().map(|strip| vec![0.0; strip.b.len()]).collect();
        Ok(Self {
            e: Aligned::zeros(n + 1, 0),
            h: Aligned::zeros(n + 1, 1),
            currents: vec![0.0; electric.currents],
            psi_e: zeros(&strips.whole),
            psi_h: zeros(&strips.half),
            electric,
            magnetic,
            strips,
            sources: Vec::new(),
            incident: None,
            probes: Vec::new(),
            steps: 0,
            level: Level::new(),
            setup,
        })
    }

    /// What it was built from.
    pub fn setup(&self) -> &Setup {
        &self.setup
    }

    /// Δt [s].
    pub fn dt(&self) -> f64 {
        time_step(self.setup.stepping.courant, self.setup.spacing)
    }

    /// How many steps it has run; E is at `steps`·Δt, H half a step later.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// E_x [V/m] at z = kΔ, k = 0 … N.
    pub fn e(&self) -> &[f64] {
        &self.e
    }

    /// H_y [A/m] at z = (k + ½)Δ, k = 0 … N − 1.
    pub fn h(&self) -> Vec<f64> {
        self.h[1..].iter().map(|h| h / Z_0).collect()
    }

    /// Sets the fields: E_x [V/m] of z [m] at the present time, H_y [A/m] of z half a step later. E on a conductor
    /// stays zero.
    pub fn set(&mut self, e: impl Fn(f64) -> f64, h: impl Fn(f64) -> f64) {
        let (n, spacing) = (self.setup.cells, self.setup.spacing);
        let first = usize::from(self.setup.ends != Ends::Periodic);
        for k in first..n {
            self.e[k] = e(k as f64 * spacing);
        }
        for k in 0..n {
            self.h[k + 1] = Z_0 * h((k as f64 + 0.5) * spacing);
        }
        self.wrap();
    }

    /// A current J_x = `amplitude` [A/m²] × pulse at a node: a source that waves pass through.
    ///
    /// # Errors
    /// If the node is not stepped.
    pub fn inject(&mut self, node: usize, amplitude: f64, pulse: Pulse) -> Result<(), Refusal> {
        self.add_source(
            "a current",
            Source { node, amplitude: amplitude * Z_0 * self.setup.spacing, pulse, hard: false },
        )
    }

    /// E_x = `amplitude` [V/m] × pulse at a node, whatever arrives there: a source that reflects.
    ///
    /// # Errors
    /// If the node is not stepped.
    pub fn impose(&mut self, node: usize, amplitude: f64, pulse: Pulse) -> Result<(), Refusal> {
        self.add_source("an imposed field", Source { node, amplitude, pulse, hard: true })
    }

    fn add_source(&mut self, what: &'static str, source: Source) -> Result<(), Refusal> {
        demand(source.amplitude.is_finite(), "amplitude of a source", source.amplitude, "finite")?;
        source.pulse.check()?;
        inside(what, source.node, 1, self.setup.cells - 1)?;
        self.sources.push(source);
        Ok(())
    }

    /// A plane wave of E_x = `amplitude` [V/m] × pulse, travelling to the right, that exists from `node` on (total
    /// field) and not before it (scattered field); T&H §5.6. It is stepped on a line of its own, of the medium at the
    /// node, which it enters one cell earlier: exact for 7000 steps, and to 1e−12 of the pulse's peak thereafter. It
    /// replaces an earlier one.
    ///
    /// # Errors
    /// If the node lies in an absorber, next to a wall or between two media, or the line is periodic.
    pub fn illuminate(&mut self, node: usize, amplitude: f64, pulse: Pulse) -> Result<(), Refusal> {
        let walls = self.setup.walls();
        let last = if self.setup.ends == Ends::Periodic { 0 } else { self.setup.cells - walls[1].thickness() };
        inside("an incident wave", node, walls[0].thickness() + 1, last.saturating_sub(1))?;
        let Setup { ref stepping, spacing, .. } = self.setup;
        stepping.admit(self.setup.peak_bytes().saturating_add(Incident::BYTES))?;
        let medium = &self.setup.medium(node);
        if self.setup.medium(node - 1) != *medium {
            return Err(Refusal::Mixed { what: "an incident wave", at: node });
        }
        let route = Route { medium, stepping, spacing, phase: 0.0, polarisation: Polarisation::S };
        self.incident = Some(Incident::new(node, &route, amplitude, pulse, self.steps)?);
        Ok(())
    }

    /// Records E_x at a node after every step from now on; the answer names the record.
    ///
    /// # Errors
    /// If the node is not on the line.
    pub fn probe(&mut self, node: usize) -> Result<usize, Refusal> {
        inside("a probe", node, 0, self.setup.cells - 1)?;
        self.probes.push((node, Vec::new()));
        Ok(self.probes.len() - 1)
    }

    /// E_x [V/m] after each step since the probe was set.
    pub fn record(&self, probe: usize) -> &[f64] {
        &self.probes[probe].1
    }

    /// E_x [V/m] of the incident wave at its node after each step since it was set.
    pub fn incident(&self) -> Option<&[f64]> {
        self.incident.as_ref().map(|incident| &incident.record[..])
    }

    /// Steps `steps` times.
    ///
    /// # Errors
    /// If `steps` is zero, or what is recorded in them would exceed the memory limit.
    pub fn run(&mut self, steps: u64) -> Result<(), Refusal> {
        demand(steps >= 1, "number of steps", steps as f64, "at least 1")?;
        let probes = self.probes.iter().map(|(_, record)| (record.len(), WORD));
        let records = probes.chain(self.incident.as_ref().map(Incident::recorded));
        self.setup.stepping.admit_records(self.peak_bytes(), steps, records)?;
        let mut left = steps;
        while left > 0 {
            let deep = left.min(if self.setup.ends == Ends::Periodic { 1 } else { DEEP as u64 });
            self.block(deep as usize);
            left -= deep;
        }
        Ok(())
    }

    fn peak_bytes(&self) -> u64 {
        self.setup.peak_bytes().saturating_add(if self.incident.is_some() { Incident::BYTES } else { 0 })
    }

    /// `deep` steps, tile by tile.
    fn block(&mut self, deep: usize) {
        if let Some(incident) = &mut self.incident {
            incident.look_ahead(deep, self.level);
        }
        let n = self.setup.cells;
        let clip = |at: usize, back: usize, end: usize| at.saturating_sub(back).min(end);
        for start in (0..n + deep + 1).step_by(TILE) {
            for s in 0..deep {
                self.step_electric(clip(start, s, n)..clip(start + TILE, s, n), s);
                self.step_magnetic(clip(start, s + 1, n)..clip(start + TILE, s + 1, n), s);
            }
        }
        self.wrap();
        self.steps += deep as u64;
    }

    /// The images across a periodic end.
    fn wrap(&mut self) {
        if self.setup.ends == Ends::Periodic {
            let n = self.setup.cells;
            (self.e[n], self.h[0]) = (self.e[0], self.h[n]);
        }
    }

    /// E of the nodes `window`, in step `s` of the block.
    fn step_electric(&mut self, window: Range<usize>, s: usize) {
        if window.is_empty() {
            return;
        }
        let n = self.setup.cells;
        let curl = Difference { ahead: &self.h[..n], behind: &self.h[1..] };
        self.electric.step(self.level, window.clone(), &mut self.e[..n], &mut self.currents, curl);
        for (strip, psi) in self.strips.whole.iter().zip(&mut self.psi_e) {
            self.electric.absorb(
                self.level,
                strip.range(),
                window.clone(),
                &mut self.e,
                &mut self.currents,
                psi,
                curl,
                strip.grades(),
            );
        }
        let time = (self.steps + s as u64) as f64;
        let dt = time_step(self.setup.stepping.courant, self.setup.spacing);
        for source in self.sources.iter().filter(|source| window.contains(&source.node)) {
            if source.hard {
                self.e[source.node] = source.amplitude * source.pulse.at((time + 1.0) * dt);
            } else {
                let j = source.amplitude * source.pulse.at((time + 0.5) * dt);
                self.electric.push(source.node, &mut self.e, &mut self.currents, -j);
            }
        }
        if let Some(incident) = self.incident.as_ref().filter(|incident| window.contains(&incident.at)) {
            self.electric.push(incident.at, &mut self.e, &mut self.currents, incident.ahead[s][0]);
        }
        if window.start == 0 && self.setup.ends == Ends::Periodic {
            self.e[n] = self.e[0];
        }
        for (node, record) in self.probes.iter_mut().filter(|(node, _)| window.contains(node)) {
            record.push(self.e[*node]);
        }
    }

    /// H of the cells `window`, in step `s` of the block.
    fn step_magnetic(&mut self, window: Range<usize>, s: usize) {
        if window.is_empty() {
            return;
        }
        let n = self.setup.cells;
        let curl = Difference { ahead: &self.e[..n], behind: &self.e[1..] };
        let h = &mut self.h[1..];
        self.magnetic.step(self.level, window.clone(), h, &mut [], curl);
        for (strip, psi) in self.strips.half.iter().zip(&mut self.psi_h) {
            self.magnetic.absorb(self.level, strip.range(), window.clone(), h, &mut [], psi, curl, strip.grades());
        }
        if let Some(incident) = self.incident.as_ref().filter(|incident| window.contains(&(incident.at - 1))) {
            let cell = incident.at - 1;
            self.magnetic.push(cell, h, &mut [], incident.ahead[s][1]);
        }
    }
}
