//! One row, one half step.

use super::super::absorber::{Grade, Strip};
use super::super::kernel::{Circulation, Difference};
use super::super::span::Update;
use super::{Fields, Grid, Row, Sides};
use crate::Polarisation;
use fearless_simd::Level;
use num_complex::Complex64;

/// The moment at which a row is stepped, and what arrives from outside then.
#[derive(Clone, Copy, Debug)]
pub(super) struct Moment {
    /// Steps run before this one.
    pub step: u64,
    /// The row of the incident wave, Z₀H below it and E in it, at column 0.
    pub incident: Option<(usize, [f64; 2])>,
}

impl Grid {
    /// E of row `j`; `below` is row j − 1, `here` row j.
    #[inline(always)]
    pub(super) fn step_electric(&self, below: Option<&Row>, here: &mut Row, j: usize, moment: Moment) {
        self.wrap_row(here);
        for part in 0..here.parts.len() {
            let under = below.map(|row| &row.parts[part]);
            let here = &mut here.parts[part];
            match (self.setup.polarisation, under) {
                (Polarisation::S, Some(under)) => self.e_z(under, here, j),
                (Polarisation::P, Some(under)) => self.e_xy(under, here, j),
                (Polarisation::P, None) => self.e_y(here, j),
                (Polarisation::S, None) => {}
            }
        }
        self.inject(here, j, moment.step);
        if let Some((_, [h, _])) = moment.incident.filter(|(row, _)| *row == j) {
            // The row takes its curl from a row below in which only the scattered field lives.
            self.add_incident(here, j, h);
        }
        self.wrap_row(here);
        if self.setup.polarisation == Polarisation::S {
            record(here, 0);
        }
    }

    /// H of row `j`; `above` is row j + 1.
    #[inline(always)]
    pub(super) fn step_magnetic(&self, here: &mut Row, above: &Row, j: usize, moment: Moment) {
        for (part, over) in here.parts.iter_mut().zip(&above.parts) {
            match self.setup.polarisation {
                Polarisation::S => self.h_xy(part, over, j),
                Polarisation::P => self.h_z(part, over, j),
            }
        }
        if let Some((_, [_, e])) = moment.incident.filter(|(row, _)| *row == j + 1) {
            // The row takes its curl from a row above in which the total field lives.
            let sign = if self.setup.polarisation == Polarisation::S { 1.0 } else { -1.0 };
            self.add_scattered(here, j, sign * e);
        }
        if self.setup.polarisation == Polarisation::P {
            record(here, 1);
        }
    }

    #[inline(always)]
    fn e_z(&self, under: &Fields, f: &mut Fields, j: usize) {
        let (n, spans) = (self.setup.cells[0], &self.layouts[j].z);
        let x = Difference { ahead: &f.y[1..], behind: &f.y[..n] };
        let y = Difference { ahead: &f.x, behind: &under.x };
        let [currents, _] = &mut f.currents;
        spans.step(self.level, 0..n, &mut f.z, currents, Circulation(x, y));
        let mut of_z = Update { spans, e: &mut f.z, j: currents, curl: x };
        across(self.level, &mut of_z, &self.across.whole, &mut f.psi_zx);
        of_z.curl = flipped(y);
        along(self.level, &mut of_z, &self.along.whole, j, &mut f.psi_zy);
    }

    #[inline(always)]
    fn h_xy(&self, f: &mut Fields, over: &Fields, j: usize) {
        let (n, layout) = (self.setup.cells[0], &self.layouts[j]);
        let y = Difference { ahead: &f.z[..n], behind: &over.z[..n] };
        let x = Difference { ahead: &f.z[1..], behind: &f.z[..n] };
        let mut of_x = Update { spans: &layout.x, e: &mut f.x, j: &mut [], curl: y };
        let mut of_y = Update { spans: &layout.y, e: &mut f.y[1..], j: &mut [], curl: x };
        Update::step_both(self.level, &mut of_x, &mut of_y);
        along(self.level, &mut of_x, &self.along.half, j, &mut f.psi_xy);
        across(self.level, &mut of_y, &self.across.half, &mut f.psi_yx);
    }

    #[inline(always)]
    fn e_xy(&self, under: &Fields, f: &mut Fields, j: usize) {
        let (n, layout) = (self.setup.cells[0], &self.layouts[j]);
        let y = Difference { ahead: &f.z[1..], behind: &under.z[1..] };
        let x = Difference { ahead: &f.z[..n], behind: &f.z[1..] };
        let [j_x, j_y] = &mut f.currents;
        let mut of_x = Update { spans: &layout.x, e: &mut f.x, j: j_x, curl: y };
        let mut of_y = Update { spans: &layout.y, e: &mut f.y, j: j_y, curl: x };
        Update::step_both(self.level, &mut of_x, &mut of_y);
        along(self.level, &mut of_x, &self.along.whole, j, &mut f.psi_xy);
        across(self.level, &mut of_y, &self.across.whole, &mut f.psi_yx);
    }

    /// E_y of the first row, which has no row below it.
    #[inline(always)]
    fn e_y(&self, f: &mut Fields, j: usize) {
        let (n, spans) = (self.setup.cells[0], &self.layouts[j].y);
        let x = Difference { ahead: &f.z[..n], behind: &f.z[1..] };
        let [_, currents] = &mut f.currents;
        spans.step(self.level, 0..n, &mut f.y, currents, x);
        let mut of_y = Update { spans, e: &mut f.y, j: currents, curl: x };
        across(self.level, &mut of_y, &self.across.whole, &mut f.psi_yx);
    }

    #[inline(always)]
    fn h_z(&self, f: &mut Fields, over: &Fields, j: usize) {
        let (n, spans) = (self.setup.cells[0], &self.layouts[j].z);
        let y = Difference { ahead: &over.x, behind: &f.x };
        let x = Difference { ahead: &f.y[1..], behind: &f.y[..n] };
        let z = &mut f.z[1..];
        spans.step(self.level, 0..n, z, &mut [], Circulation(y, x));
        let mut of_z = Update { spans, e: z, j: &mut [], curl: flipped(x) };
        across(self.level, &mut of_z, &self.across.half, &mut f.psi_zx);
        of_z.curl = y;
        along(self.level, &mut of_z, &self.along.half, j, &mut f.psi_zy);
    }

    /// The images across periodic sides, of the components that are differenced along x.
    pub(super) fn wrap_row(&self, row: &mut Row) {
        if !matches!(self.setup.sides, Sides::Bloch(_)) {
            return;
        }
        let n = self.setup.cells[0];
        // Whole components run from their image on the right, half ones from theirs on the left.
        let (last, first): (Array, Array) = match self.setup.polarisation {
            Polarisation::S => (|f| &mut f.z, |f| &mut f.y),
            Polarisation::P => (|f| &mut f.y, |f| &mut f.z),
        };
        match &mut row.parts[..] {
            [re] => {
                let (whole, half) = (last(re)[0], first(re)[n]);
                (last(re)[n], first(re)[0]) = (whole, half);
            }
            [re, im] => {
                let whole = Complex64::new(last(re)[0], last(im)[0]) * self.turn;
                let half = Complex64::new(first(re)[n], first(im)[n]) * self.turn.conj();
                (last(re)[n], last(im)[n]) = (whole.re, whole.im);
                (first(re)[0], first(im)[0]) = (half.re, half.im);
            }
            _ => {}
        }
    }

    fn inject(&self, row: &mut Row, j: usize, step: u64) {
        for source in self.sources.iter().filter(|source| source.at[1] == j) {
            let i = source.at[0];
            let j_now = source.amplitude * source.pulse.at((step as f64 + 0.5) * self.dt());
            let layout = &self.layouts[j];
            let fields = &mut row.parts[0];
            match self.setup.polarisation {
                Polarisation::S => layout.z.push(i, &mut fields.z, &mut fields.currents[0], -j_now),
                Polarisation::P => layout.x.push(i, &mut fields.x, &mut fields.currents[0], -j_now),
            }
        }
    }

    fn add_incident(&self, row: &mut Row, j: usize, h: f64) {
        let layout = &self.layouts[j];
        let turned = self.turned(h);
        for (part, f) in row.parts.iter_mut().enumerate() {
            for i in 0..self.setup.cells[0] {
                match self.setup.polarisation {
                    Polarisation::S => layout.z.push(i, &mut f.z, &mut f.currents[0], turned(i)[part]),
                    Polarisation::P => layout.x.push(i, &mut f.x, &mut f.currents[0], turned(i)[part]),
                }
            }
        }
    }

    fn add_scattered(&self, row: &mut Row, j: usize, e: f64) {
        let layout = &self.layouts[j];
        let turned = self.turned(e);
        for (part, f) in row.parts.iter_mut().enumerate() {
            for i in 0..self.setup.cells[0] {
                match self.setup.polarisation {
                    Polarisation::S => layout.x.push(i, &mut f.x, &mut [], turned(i)[part]),
                    Polarisation::P => layout.z.push(i, &mut f.z[1..], &mut [], turned(i)[part]),
                }
            }
        }
    }

    /// Real and imaginary part at column i of what is `at_origin` at column 0.
    fn turned(&self, at_origin: f64) -> impl Fn(usize) -> [f64; 2] {
        let Sides::Bloch(phase) = self.setup.sides else { unreachable!("incident waves need periodic sides") };
        let step = phase / self.setup.cells[0] as f64;
        move |i| {
            let value = if step == 0.0 { at_origin.into() } else { at_origin * Complex64::cis(step * i as f64) };
            [value.re, value.im]
        }
    }
}

/// One of a row's arrays.
type Array = fn(&mut Fields) -> &mut [f64];

/// Absorbers at the ends of x.
#[inline(always)]
fn across(level: Level, of: &mut Update<Difference>, strips: &[Strip], psi: &mut [Vec<f64>]) {
    for (strip, psi) in strips.iter().zip(psi) {
        of.spans.absorb(level, strip.range(), 0..usize::MAX, of.e, of.j, psi, of.curl, strip.grades());
    }
}

/// Absorbers at the ends of y, of which a row meets one or none.
#[inline(always)]
fn along(level: Level, of: &mut Update<Difference>, strips: &[Strip], row: usize, psi: &mut [f64]) {
    if let Some(Grade { b, c, k }) = strips.iter().find_map(|strip| strip.at(row)) {
        of.spans.absorb(level, 0..psi.len(), 0..usize::MAX, of.e, of.j, psi, of.curl, [b, c, k]);
    }
}

fn flipped(d: Difference) -> Difference {
    Difference { ahead: d.behind, behind: d.ahead }
}

fn record(row: &mut Row, offset: usize) {
    let Row { parts, probes } = row;
    for (column, _, record) in probes {
        let part = |k: usize| parts.get(k).map_or(0.0, |f: &Fields| f.z[*column + offset]);
        record.push(Complex64::new(part(0), part(1)));
    }
}
