//! A row of cells, cut into runs that need the same update.

use super::aligned::VECTOR;
use super::kernel::{self, Coefficient, Curl, Difference};
use super::medium::{Coefficients, Medium};
use super::stepping::WORD;
use fearless_simd::{Level, dispatch};
use std::ops::Range;

/// What a cell needs beyond E += drive·curl, each including the one before.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Need {
    /// Nothing.
    Clear,
    /// Some conduction.
    Loss,
    /// Conduction that dominates.
    Conduction,
    /// A current of free electrons.
    Electrons,
}

impl Need {
    pub const fn columns(self) -> u64 {
        match self {
            Self::Clear => 1,
            Self::Loss => 2,
            Self::Conduction => 3,
            Self::Electrons => 6,
        }
    }

    /// Multiplications, additions and subtractions a cell takes beyond the curl itself.
    pub const fn operations(self) -> u64 {
        match self {
            Self::Clear => 2,
            Self::Loss => 4,
            Self::Conduction => 5,
            Self::Electrons => 11,
        }
    }

    /// The most that any cell of `media`, or of a mean of them, can need.
    pub fn of_any<'a>(media: impl Iterator<Item = &'a Medium>) -> Self {
        let of = |medium: &Medium| match medium {
            Medium { drude: Some(_), .. } => Self::Electrons,
            Medium { sigma, .. } if *sigma > 0.0 => Self::Conduction,
            _ => Self::Clear,
        };
        media.map(of).max().unwrap_or(Self::Clear)
    }

    /// Coefficients, and current, that an E component of its own needs [f64].
    pub fn words(self) -> u64 {
        self.columns() + u64::from(self == Self::Electrons)
    }

    fn of(c: &Coefficients) -> Self {
        match c {
            _ if c.gain != 0.0 => Self::Electrons,
            _ if c.base != 1.0 => Self::Conduction,
            _ if c.rest != 0.0 => Self::Loss,
            _ => Self::Clear,
        }
    }
}

/// A run of cells with the same needs.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Span {
    pub range: Range<usize>,
    pub need: Need,
    /// Whether one set of coefficients serves all.
    same: bool,
    /// Column by column: drive, rest, base, share, memory, gain, as far as needed.
    table: Vec<f64>,
    /// Where its currents start in the row's.
    currents: usize,
}

/// A row's updates of one field component.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Spans {
    pub list: Vec<Span>,
    /// How many currents of free electrons the row holds.
    pub currents: usize,
}

/// The columns of a table that are asked for by themselves.
const DRIVE: usize = 0;
const GAIN: usize = 5;

/// Shorter runs are not worth a loop of their own.
const SHORTEST: usize = 16;

impl Spans {
    /// For the components `range` of a row: each run gets what it needs or, if `all` is given, every cell gets that
    /// much, with coefficients of its own.
    pub fn new(range: Range<usize>, all: Option<Need>, at: impl Fn(usize) -> Coefficients) -> Self {
        let cells: Vec<Coefficients> = range.clone().map(at).collect();
        let runs = match all {
            Some(need) => vec![Run { range: 0..cells.len(), need, same: false }],
            None => merged(runs(&cells)),
        };
        let mut spans = Self::default();
        for run in runs {
            spans.add_run(run, range.start, &cells);
        }
        spans
    }

    fn add_run(&mut self, run: Run, first: usize, cells: &[Coefficients]) {
        let (cells, same) = (&cells[run.range.clone()], run.same);
        let column = |k: usize| move |c: &Coefficients| [c.drive, c.rest, c.base, c.share, c.memory, c.gain][k];
        let kept = if same { &cells[..1] } else { cells };
        let table = (0..run.need.columns() as usize).flat_map(|k| kept.iter().map(column(k))).collect();
        let range = first + run.range.start..first + run.range.end;
        let currents = self.currents;
        self.currents += if run.need == Need::Electrons { range.len() } else { 0 };
        self.list.push(Span { range, need: run.need, same, table, currents });
    }

    /// Steps the components within `window` of the row `e`. `curl` and `e` are indexed alike.
    ///
    /// Here and in [`Self::absorb`] the loops are compiled once for each `level` of the processor; they are the same
    /// multiplications and additions in the same order, so that the numbers are too.
    pub fn step<D: Curl>(&self, level: Level, window: Range<usize>, e: &mut [f64], j: &mut [f64], curl: D) {
        dispatch!(level, _ => self.step_spans(window, e, j, curl));
    }

    #[inline(always)]
    fn step_spans<D: Curl>(&self, window: Range<usize>, e: &mut [f64], j: &mut [f64], curl: D) {
        for span in &self.list {
            let (start, end) = (span.range.start.max(window.start), span.range.end.min(window.end));
            // The few cells before the first whole vector are stepped apart.
            let head = start.next_multiple_of(VECTOR).min(end);
            for range in [start..head, head..end] {
                if range.start < range.end {
                    let inner = range.start - span.range.start..range.end - span.range.start;
                    span.step(inner, &mut e[range.clone()], j, curl.cut(range));
                }
            }
        }
    }

    /// Adds what an absorber does within `strip` of the row; `psi` and the grades are indexed from the strip's start.
    #[expect(clippy::too_many_arguments, reason = "a row's fields, and nothing that belongs together")]
    pub fn absorb<G: Coefficient>(
        &self,
        level: Level,
        strip: Range<usize>,
        window: Range<usize>,
        e: &mut [f64],
        j: &mut [f64],
        psi: &mut [f64],
        d: Difference,
        grades: [G; 3],
    ) {
        for span in &self.list {
            let start = span.range.start.max(strip.start).max(window.start);
            let end = span.range.end.min(strip.end).min(window.end);
            if start >= end {
                continue;
            }
            let of_strip = start - strip.start..end - strip.start;
            let (e, psi, d) = (&mut e[start..end], &mut psi[of_strip.clone()], d.cut(start..end));
            let grades = grades.map(|grade| grade.cut(of_strip.clone()));
            let inner = start - span.range.start..end - span.range.start;
            dispatch!(level, _ => span.absorb(inner, e, j, psi, d, grades));
        }
    }

    /// E += drive·amount at one component, after its step: what a current or a known incident field adds to the curl.
    pub fn push(&self, i: usize, e: &mut [f64], j: &mut [f64], amount: f64) {
        let Some(span) = self.list.iter().find(|span| span.range.contains(&i)) else { return };
        let k = i - span.range.start;
        let added = span.value(DRIVE, k) * amount;
        e[i] += added;
        if span.need == Need::Electrons {
            j[span.currents + k] += span.value(GAIN, k) * added;
        }
    }

    /// Its range and coefficient, if it is one clear run with one coefficient.
    fn uniform(&self) -> Option<(Range<usize>, f64)> {
        let [span] = &self.list[..] else { return None };
        (span.need == Need::Clear && span.same).then(|| (span.range.clone(), span.table[DRIVE]))
    }

    /// What the curl is multiplied by at a component [1]; 0 if it is not stepped.
    pub fn drive(&self, i: usize) -> f64 {
        let of = |span: &&Span| span.range.contains(&i);
        self.list.iter().find(of).map_or(0.0, |span| span.value(DRIVE, i - span.range.start))
    }

    /// The current of free electrons at a component [V/m], from the row's currents.
    pub fn current(&self, i: usize, j: &[f64]) -> f64 {
        let of = |span: &&Span| span.need == Need::Electrons && span.range.contains(&i);
        self.list.iter().find(of).map_or(0.0, |span| j[span.currents + i - span.range.start])
    }

    /// Bytes of its coefficients.
    pub fn bytes(&self) -> u64 {
        self.list.iter().map(|span| span.table.len()).sum::<usize>() as u64 * WORD
    }
}

/// One component of a row, about to be stepped.
pub(super) struct Update<'a, D> {
    pub spans: &'a Spans,
    pub e: &'a mut [f64],
    pub j: &'a mut [f64],
    /// Indexed as `e` is.
    pub curl: D,
}

impl<D: Curl> Update<'_, D> {
    /// Steps two components of a row; in one loop where both are uniform and clear, for their curls share what they load.
    pub fn step_both<B: Curl>(level: Level, one: &mut Self, two: &mut Update<B>) {
        match (one.spans.uniform(), two.spans.uniform()) {
            (Some(a), Some(b)) => dispatch!(level, _ => one.step_clear(a, two, b)),
            _ => {
                one.spans.step(level, 0..usize::MAX, one.e, one.j, one.curl);
                two.spans.step(level, 0..usize::MAX, two.e, two.j, two.curl);
            }
        }
    }

    #[inline(always)]
    fn step_clear<B: Curl>(
        &mut self,
        (a, of_a): (Range<usize>, f64),
        two: &mut Update<B>,
        (b, of_b): (Range<usize>, f64),
    ) {
        let end = a.end.min(b.end);
        let start = a.start.max(b.start).next_multiple_of(VECTOR).min(end);
        for (a, b) in [(a.start..start, b.start..start), (end..a.end, end..b.end)] {
            kernel::clear(&mut self.e[a.clone()], self.curl.cut(a), of_a);
            kernel::clear(&mut two.e[b.clone()], two.curl.cut(b), of_b);
        }
        let both = start..end;
        let fields = [&mut self.e[both.clone()], &mut two.e[both.clone()]];
        kernel::clear_both(fields, (self.curl.cut(both.clone()), two.curl.cut(both)), [of_a, of_b]);
    }
}

impl Span {
    /// How many coefficients were not stored because one set serves all.
    pub fn spared(&self) -> u64 {
        if self.same { (self.range.len() - 1) as u64 * self.need.columns() } else { 0 }
    }

    /// A coefficient at the k-th component of the run.
    fn value(&self, column: usize, k: usize) -> f64 {
        if self.same { self.table[column] } else { self.table[column * self.range.len() + k] }
    }

    #[inline(always)]
    fn column(&self, k: usize, inner: Range<usize>) -> &[f64] {
        if self.same {
            &self.table[k..k + 1]
        } else {
            let start = k * self.range.len();
            &self.table[start + inner.start..start + inner.end]
        }
    }

    #[inline(always)]
    fn step<D: Curl>(&self, inner: Range<usize>, e: &mut [f64], j: &mut [f64], curl: D) {
        let each = |k: usize| self.column(k, inner.clone());
        let same = |k: usize| self.table[k];
        let of_currents = self.currents + inner.start..self.currents + inner.end;
        match (self.need, self.same) {
            (Need::Clear, true) => kernel::clear(e, curl, same(0)),
            (Need::Clear, false) => kernel::clear(e, curl, each(0)),
            (Need::Loss, true) => kernel::lossy(e, curl, [0, 1].map(same)),
            (Need::Loss, false) => kernel::lossy(e, curl, [0, 1].map(each)),
            (Need::Conduction, true) => kernel::conducting(e, curl, [0, 1, 2].map(same)),
            (Need::Conduction, false) => kernel::conducting(e, curl, [0, 1, 2].map(each)),
            (Need::Electrons, true) => kernel::full(e, &mut j[of_currents], curl, [0, 1, 2, 3, 4, 5].map(same)),
            (Need::Electrons, false) => kernel::full(e, &mut j[of_currents], curl, [0, 1, 2, 3, 4, 5].map(each)),
        }
    }

    #[inline(always)]
    fn absorb<G: Coefficient>(
        &self,
        inner: Range<usize>,
        e: &mut [f64],
        j: &mut [f64],
        psi: &mut [f64],
        d: Difference,
        grades: [G; 3],
    ) {
        let each = |k: usize| self.column(k, inner.clone());
        let same = |k: usize| self.table[k];
        let of_currents = self.currents + inner.start..self.currents + inner.end;
        match (self.need, self.same) {
            (Need::Electrons, true) => {
                kernel::absorb(e, psi, d, grades, same(DRIVE), kernel::follow(&mut j[of_currents], same(GAIN)));
            }
            (Need::Electrons, false) => {
                kernel::absorb(e, psi, d, grades, each(DRIVE), kernel::follow(&mut j[of_currents], each(GAIN)));
            }
            (_, true) => kernel::absorb(e, psi, d, grades, same(DRIVE), |_, _| ()),
            (_, false) => kernel::absorb(e, psi, d, grades, each(DRIVE), |_, _| ()),
        }
    }
}

struct Run {
    range: Range<usize>,
    need: Need,
    /// Whether all its cells have the same coefficients.
    same: bool,
}

/// The longest runs of cells that share all coefficients.
fn runs(cells: &[Coefficients]) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    for (i, cell) in cells.iter().enumerate() {
        match runs.last_mut() {
            Some(run) if &cells[run.range.start] == cell => run.range.end = i + 1,
            _ => runs.push(Run { range: i..i + 1, need: Need::of(cell), same: true }),
        }
    }
    runs
}

/// Joins neighbours of which one is too short to stand alone; the joint run has the needs of both.
fn merged(runs: Vec<Run>) -> Vec<Run> {
    let mut merged: Vec<Run> = Vec::with_capacity(runs.len());
    for run in runs {
        match merged.last_mut() {
            Some(last) if last.range.len() < SHORTEST || run.range.len() < SHORTEST => {
                *last = Run { range: last.range.start..run.range.end, need: last.need.max(run.need), same: false };
            }
            _ => merged.push(run),
        }
    }
    merged
}
