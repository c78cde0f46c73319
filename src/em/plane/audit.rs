//! The balances of a plane: see [`super::super::ledger`].

use super::super::EPSILON_0;
use super::super::ledger::{Balance, Ledger};
use super::super::medium::Surroundings;
use super::super::refusal::{Refusal, demand, inside};
use super::super::span::Spans;
use super::{Fields, Plane, Sides};
use crate::Polarisation;
use std::ops::RangeInclusive;

/// What changed at the components of a row that a divergence is made of, and the largest of it.
struct Changes {
    x: Vec<Vec<f64>>,
    y: Vec<Vec<f64>>,
    largest: f64,
}

impl Plane {
    /// One step, and the balances of the rows `rows` across the whole width, which must be closed: periodic or between
    /// conductors. The part must be free of sources, incident waves and absorbers.
    ///
    /// # Errors
    /// If the sides are open, or the rows lie outside the stepped ones or reach into an absorber.
    pub fn audited_step(&mut self, rows: RangeInclusive<usize>) -> Result<Balance, Refusal> {
        let (a, b) = rows.into_inner();
        let across = self.across_open();
        demand(!across, "the number of open sides of an audit", f64::from(u8::from(across)), "none")?;
        let setup = self.setup();
        let [low, high] = setup.ends.map(|wall| wall.thickness().max(1));
        inside("the first row of an audit", a, low, setup.cells[1] - high)?;
        inside("the last row of an audit", b, a, setup.cells[1] - high)?;
        let unit = EPSILON_0 * setup.spacing * setup.spacing;
        let mut before = self.clone();
        self.run_serial(1)?;
        before.wrap();
        self.wrap();
        Ok(self.balance_since(&before, a, b).scaled(unit))
    }

    fn across_open(&self) -> bool {
        matches!(self.grid.setup.sides, Sides::Walls(walls) if walls.iter().any(|wall| wall.thickness() > 0))
    }

    /// Brings the images across periodic sides up to date.
    fn wrap(&mut self) {
        let Self { grid, rows, .. } = self;
        rows.iter_mut().for_each(|row| grid.wrap_row(row));
    }

    /// What rows `a` to `b` balanced in the step from `before` to now.
    fn balance_since(&self, before: &Self, a: usize, b: usize) -> Balance {
        let stepping = &self.grid.setup.stepping;
        let mut ledger = Ledger {
            courant: stepping.courant,
            dt: self.dt(),
            conduction: stepping.conduction,
            balance: Balance::default(),
        };
        for part in 0..self.grid.setup.parts() {
            let changes = match self.grid.setup.polarisation {
                Polarisation::S => self.book_s(before, part, a, b, &mut ledger),
                Polarisation::P => self.book_p(before, part, a, b, &mut ledger),
            };
            changes.book(self.grid.setup.polarisation, &mut ledger);
        }
        ledger.balance
    }

    fn fields(&self, j: usize, part: usize) -> &Fields {
        &self.rows[j].parts[part]
    }

    fn book_s(&self, before: &Self, part: usize, a: usize, b: usize, ledger: &mut Ledger) -> Changes {
        let n = self.grid.setup.cells[0];
        let mut changes = Changes { x: Vec::new(), y: Vec::new(), largest: 0.0 };
        for j in a..=b {
            let layout = &self.grid.layouts[j];
            let at = |j: usize| [before.fields(j, part), self.fields(j, part)];
            let (here, under) = (at(j), at(j - 1));
            for i in stepped(&layout.z) {
                let e = here.map(|f| f.z[i]);
                ledger.electric(&self.grid.around_z(i, j), e, currents(&layout.z, i, here, 0));
                if j == a {
                    ledger.border(e, under[0].x[i]);
                }
                if j == b {
                    ledger.border(e, -here[0].x[i]);
                }
            }
            for i in stepped(&layout.y) {
                ledger.magnetic(layout.y.drive(i), here.map(|f| f.y[i + 1]), here.map(|f| f.z[i + 1] - f.z[i]));
            }
            if j < b {
                let over = at(j + 1);
                for i in stepped(&layout.x) {
                    let curl = [0, 1].map(|t| here[t].z[i] - over[t].z[i]);
                    ledger.magnetic(layout.x.drive(i), here.map(|f| f.x[i]), curl);
                }
            }
            let s = ledger.courant;
            let change = |spans: &Spans, of: fn(&Fields) -> &[f64], i: usize| {
                s / spans.drive(i) * (of(here[1])[i] - of(here[0])[i])
            };
            // H_x on a conductor at the side stays zero.
            let of_x = |i: usize| if layout.x.drive(i % n) == 0.0 { 0.0 } else { change(&layout.x, |f| &f.x, i % n) };
            // With a Bloch phase the image on the right is turned; its cell is left out.
            let last = if self.grid.setup.parts() == 2 { n - 1 } else { n };
            changes
                .push((0..=last).map(of_x).collect(), (0..last).map(|i| change(&layout.y, |f| &f.y[1..], i)).collect());
        }
        changes
    }

    fn book_p(&self, before: &Self, part: usize, a: usize, b: usize, ledger: &mut Ledger) -> Changes {
        let n = self.grid.setup.cells[0];
        let mut changes = Changes { x: Vec::new(), y: Vec::new(), largest: 0.0 };
        for j in a..=b {
            let layout = &self.grid.layouts[j];
            let at = |j: usize| [before.fields(j, part), self.fields(j, part)];
            let (here, under) = (at(j), at(j - 1));
            let (mut of_x, mut of_y) = (vec![0.0; n], vec![0.0; n + 1]);
            for i in stepped(&layout.x) {
                let e = here.map(|f| f.x[i]);
                of_x[i] = booked(ledger, &self.grid.around_x(i, j), e, currents(&layout.x, i, here, 0));
                if j == a {
                    ledger.border(e, -under[0].z[i + 1]);
                }
                if j == b {
                    ledger.border(e, here[0].z[i + 1]);
                }
            }
            if j < b {
                let over = at(j + 1);
                for i in stepped(&layout.y) {
                    let (e, j_e) = (here.map(|f| f.y[i]), currents(&layout.y, i, here, 1));
                    of_y[i] = booked(ledger, &self.grid.around_y(i, j), e, j_e);
                }
                for i in stepped(&layout.z) {
                    let curl = [0, 1].map(|t| (over[t].x[i] - here[t].x[i]) - (here[t].y[i + 1] - here[t].y[i]));
                    ledger.magnetic(layout.z.drive(i), here.map(|f| f.z[i + 1]), curl);
                }
            }
            changes.push(of_x, of_y);
        }
        changes
    }
}

/// Books an E component and answers what changed of ε_r E + JΔt/ε₀ there.
fn booked(ledger: &mut Ledger, around: &Surroundings, e: [f64; 2], j: [f64; 2]) -> f64 {
    ledger.electric(around, e, j).iter().sum()
}

fn stepped(spans: &Spans) -> impl Iterator<Item = usize> {
    let ends = (spans.list.first(), spans.list.last());
    if let (Some(first), Some(last)) = ends { first.range.start..last.range.end } else { 0..0 }
}

fn currents(spans: &Spans, i: usize, fields: [&Fields; 2], component: usize) -> [f64; 2] {
    fields.map(|f| spans.current(i, &f.currents[component]))
}

impl Changes {
    fn push(&mut self, x: Vec<f64>, y: Vec<f64>) {
        let largest = x.iter().chain(&y).map(|change| change.abs()).max_by(f64::total_cmp).unwrap_or(0.0);
        self.largest = if largest.total_cmp(&self.largest).is_gt() { largest } else { self.largest };
        self.x.push(x);
        self.y.push(y);
    }

    /// The divergence at every place that is surrounded by booked components.
    fn book(&self, polarisation: Polarisation, ledger: &mut Ledger) {
        for j in 1..self.x.len() {
            match polarisation {
                // At (i + ½, j − ½): H_x(i, ·), H_x(i + 1, ·) and H_y(·, j − 1), H_y(·, j).
                Polarisation::S => {
                    for i in 0..self.y[j].len() {
                        let (x, above, below) = (&self.x[j - 1], &self.y[j], &self.y[j - 1]);
                        ledger.divergence(&[x[i + 1], -x[i], above[i], -below[i]], self.largest);
                    }
                }
                // At (i, j): E_x(i ± ½, j) and E_y(i, j ± ½); the last row has no E_y above it.
                Polarisation::P if j + 1 < self.x.len() => {
                    for i in 1..self.x[j].len() {
                        let (x, above, below) = (&self.x[j], &self.y[j], &self.y[j - 1]);
                        ledger.divergence(&[x[i], -x[i - 1], above[i], -below[i]], self.largest);
                    }
                }
                Polarisation::P => {}
            }
        }
    }
}
