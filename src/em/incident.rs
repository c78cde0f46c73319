//! A plane wave by itself: what a source of total and scattered field adds to a grid; T&H §5.6 and §5.10.
//!
//! The wave is stepped by the grid's own rules on a line of its own, so that it enters the grid exactly: dispersion,
//! loss and all. In a plane it is E(y) e^(ik_x x), and the differences along x are factors, 2i sin(k_xΔ/2). Taken out of
//! the component that lies along y, its i leaves every field real (here s; in p E and H change places):
//!
//! ∂E ∝ −∂H/∂y − qG,  ∂H ∝ −∂E/∂y,  ∂G ∝ qE,  q = 2 sin(k_xΔ/2).
//!
//! No echo falsifies it: a step carries the wave by at most a cell, so that the line is stepped only as far as the wave
//! has come, and of [`LENGTH`] cells the last [`ABSORBER`] are a graded layer, which is not heard of for twice as many
//! steps as there are cells before it. What comes back thereafter has crossed the layer twice.

use super::absorber::{Cpml, Strip, Strips, Wall};
use super::aligned::Aligned;
use super::kernel::{Curl, Difference};
use super::medium::{Coefficients, Medium, Surroundings, time_step};
use super::pulse::Pulse;
use super::refusal::{Refusal, demand};
use super::span::Spans;
use super::stepping::{Stepping, WORD};
use crate::Polarisation;
use fearless_simd::Level;
use std::ops::Range;

/// Cells of the wave's own line, and those of them that absorb.
const LENGTH: usize = 4096;
const ABSORBER: usize = 512;

/// Where a wave travels.
pub(super) struct Route<'a> {
    pub medium: &'a Medium,
    pub stepping: &'a Stepping,
    /// Δ [m].
    pub spacing: f64,
    /// k_xΔ [rad].
    pub phase: f64,
    pub polarisation: Polarisation,
}

/// A plane wave that enters a grid at a node or row and travels towards larger ones.
#[derive(Clone, Debug)]
pub(super) struct Incident {
    /// Where the total field begins. The wave's own line begins one node before.
    pub at: usize,
    /// Tangential E [V/m] at node k.
    e: Aligned,
    /// Tangential Z₀H [V/m] at k − ½, of the sign of H_y on a line.
    h: Aligned,
    electric: Spans,
    magnetic: Spans,
    currents: Vec<f64>,
    along: Option<Along>,
    strips: Strips,
    psi: [Vec<f64>; 2],
    amplitude: f64,
    pulse: Pulse,
    dt: f64,
    /// Steps of the grid before the first of the wave.
    start: u64,
    steps: u64,
    /// Z₀H half a cell before its entry, and E there, for each step of the block at hand.
    pub ahead: Vec<[f64; 2]>,
    /// The z component: E at its entry or, in p, Z₀H half a cell beyond.
    pub record: Vec<f64>,
    polarisation: Polarisation,
}

/// The component along the direction in which the line runs: of H in s, of E in p.
#[derive(Clone, Debug)]
struct Along {
    field: Vec<f64>,
    spans: Spans,
    currents: Vec<f64>,
    q: f64,
}

impl Incident {
    /// Bytes it takes, at most: three fields, and the currents and coefficients of two electric components while they
    /// are made.
    pub const BYTES: u64 = LENGTH as u64 * 12 * WORD;

    /// A wave of tangential E = `amplitude` [V/m] × pulse one node before `at`, from the moment after `start` steps on.
    ///
    /// # Errors
    /// If the amplitude or the pulse is not finite.
    pub fn new(at: usize, route: &Route, amplitude: f64, pulse: Pulse, start: u64) -> Result<Self, Refusal> {
        demand(amplitude.is_finite(), "amplitude of a source", amplitude, "finite")?;
        pulse.check()?;
        let Route { medium, spacing, phase, polarisation, .. } = *route;
        let Stepping { courant, conduction, .. } = *route.stepping;
        let dt = time_step(courant, spacing);
        let of_e = Surroundings::mean([medium]).coefficients(courant, dt, conduction);
        let of_h = Coefficients::magnetic(courant, medium.mu_r);
        let spans = |first: usize, c: Coefficients| Spans::new(first..LENGTH, None, |_| c);
        let (electric, magnetic) = (spans(1, of_e), spans(0, of_h));
        let along = (phase != 0.0).then(|| {
            let spans = if polarisation == Polarisation::S { spans(0, of_h) } else { spans(0, of_e) };
            let currents = vec![0.0; spans.currents];
            Along { field: vec![0.0; LENGTH], spans, currents, q: 2.0 * (0.5 * phase).sin() }
        });
        let walls = [Wall::Conductor, Wall::Open(Cpml::thick(ABSORBER))];
        let strips = Strips::new(walls, LENGTH, spacing, dt, [1.0, medium.bare_index()]);
        let zeros = |strips: &[Strip]| vec![0.0; strips.iter().map(|strip| strip.b.len()).sum()];
        Ok(Self {
            at,
            e: Aligned::zeros(LENGTH + 1, 0),
            h: Aligned::zeros(LENGTH + 1, 1),
            currents: vec![0.0; electric.currents],
            electric,
            magnetic,
            along,
            psi: [zeros(&strips.whole), zeros(&strips.half)],
            strips,
            amplitude,
            pulse,
            dt,
            start,
            steps: 0,
            ahead: Vec::new(),
            record: Vec::new(),
            polarisation,
        })
    }

    /// Entries of its record, and bytes of each.
    pub fn recorded(&self) -> (usize, u64) {
        (self.record.len(), WORD)
    }

    /// Steps the wave through the next `deep` steps of its grid.
    pub fn look_ahead(&mut self, deep: usize, level: Level) {
        self.ahead.clear();
        for _ in 0..deep {
            let before = self.h[1];
            // As far as the wave has come.
            let front = (self.steps + 1).min(LENGTH as u64) as usize;
            self.step_electric(front, level);
            self.step_magnetic(front, level);
            self.steps += 1;
            self.ahead.push([before, self.e[1]]);
            self.record.push(if self.polarisation == Polarisation::S { self.e[1] } else { -self.h[2] });
        }
    }

    fn step_electric(&mut self, front: usize, level: Level) {
        let Self { e, h, currents, electric: spans, .. } = self;
        let curl = Difference { ahead: &h[..LENGTH], behind: &h[1..] };
        match &mut self.along {
            Some(along) if self.polarisation == Polarisation::S => {
                spans.step(level, 0..front, e, currents, Oblique { curl, along: &along.field, q: along.q });
            }
            Some(along) => {
                along.step(front, &h[1..], level);
                spans.step(level, 0..front, e, currents, curl);
            }
            None => spans.step(level, 0..front, e, currents, curl),
        }
        for strip in &self.strips.whole {
            spans.absorb(level, strip.range(), 0..front, e, currents, &mut self.psi[0], curl, strip.grades());
        }
        e[0] = self.amplitude * self.pulse.at((self.start + self.steps + 1) as f64 * self.dt);
    }

    fn step_magnetic(&mut self, front: usize, level: Level) {
        let Self { e, h, magnetic: spans, .. } = self;
        let curl = Difference { ahead: &e[..LENGTH], behind: &e[1..] };
        let h = &mut h[1..];
        match &mut self.along {
            Some(along) if self.polarisation == Polarisation::P => {
                spans.step(level, 0..front, h, &mut [], Oblique { curl, along: &along.field, q: along.q });
            }
            Some(along) => {
                along.step(front, e, level);
                spans.step(level, 0..front, h, &mut [], curl);
            }
            None => spans.step(level, 0..front, h, &mut [], curl),
        }
        for strip in &self.strips.half {
            spans.absorb(level, strip.range(), 0..front, h, &mut [], &mut self.psi[1], curl, strip.grades());
        }
    }
}

impl Along {
    fn step(&mut self, front: usize, of: &[f64], level: Level) {
        self.spans.step(level, 0..front, &mut self.field, &mut self.currents, Share { of, q: self.q });
    }
}

/// A difference along the line, and what the phase across it makes of the component along it.
#[derive(Clone, Copy)]
struct Oblique<'a> {
    curl: Difference<'a>,
    along: &'a [f64],
    q: f64,
}

impl Curl for Oblique<'_> {
    #[inline(always)]
    fn cut(self, range: Range<usize>) -> Self {
        Self { curl: self.curl.cut(range.clone()), along: &self.along[range], ..self }
    }
    #[inline(always)]
    fn at(self, i: usize) -> f64 {
        self.curl.at(i) - self.q * self.along[i]
    }
}

/// What the phase across the line makes of one component.
#[derive(Clone, Copy)]
struct Share<'a> {
    of: &'a [f64],
    q: f64,
}

impl Curl for Share<'_> {
    #[inline(always)]
    fn cut(self, range: Range<usize>) -> Self {
        Self { of: &self.of[range], ..self }
    }
    #[inline(always)]
    fn at(self, i: usize) -> f64 {
        self.q * self.of[i]
    }
}
