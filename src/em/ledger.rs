//! Charge and energy on the grid, balanced step by step.
//!
//! The discrete fields have balances of their own that hold to rounding, whatever the spacing (T&H §3.6.9; Poynting's
//! theorem after Yee's own averages). With E̅ the mean of E before and after a step and H the field between, the energy
//! W = ½ Σ ε E² + ½ Σ μ H·H₋ (H₋ half a step earlier) changes by
//!
//! W′ − W = Δt (inflow of E̅ × H through the border − Σ E̅·J),
//!
//! term by term (C3), and the discrete divergence of εE + Σ JΔt does not change at all (E2), nor that of μH. J is found
//! here from E before and after the step, by Ohm's law and by the electrons' equation, neither from the curl nor from
//! the coefficients of the update.

use super::medium::{Conduction, Surroundings, time_step};
use super::refusal::{Refusal, inside};
use super::{EPSILON_0, Line};
use std::ops::RangeInclusive;

/// The energy of a part of the grid over one step: [J/m²] on a line, [J/m] in a plane.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Balance {
    /// In the fields and the motion of free electrons, before the step.
    pub before: f64,
    /// The same after it.
    pub after: f64,
    /// What entered through the border, minus what left.
    pub inflow: f64,
    /// What conduction and collisions turned into heat.
    pub heat: f64,
    /// The largest failure of charge continuity (p) or of ∇·B = 0 (s) at any node, over the largest of its terms [1]; 0 on
    /// a line, where nothing flows along E.
    pub divergence: f64,
}

impl Balance {
    /// What does not balance, over the energy there is [1]; 0 where there is none.
    pub fn residual(&self) -> f64 {
        let scale = self.before.abs().max(self.after.abs());
        let rest = (self.after - self.before) + self.heat - self.inflow;
        if scale == 0.0 { rest } else { rest.abs() / scale }
    }

    pub(super) fn scaled(self, unit: f64) -> Self {
        let [before, after, inflow, heat] = [self.before, self.after, self.inflow, self.heat].map(|w| w * unit);
        Self { before, after, inflow, heat, ..self }
    }
}

/// One E component over one step.
struct Component<'a> {
    around: &'a Surroundings,
    courant: f64,
    dt: f64,
    conduction: Conduction,
    e: [f64; 2],
    j: [f64; 2],
}

/// What passed at an E component in one step, in units of ε₀.
struct Passed {
    /// JΔt.
    charge: f64,
    /// Energy in the field and in the electrons, before and after.
    energy: [f64; 2],
    heat: f64,
}

impl Component<'_> {
    fn passed(&self) -> Passed {
        let ([e, e_after], [j, j_after], s) = (self.e, self.j, self.courant);
        let (plasma2, collision) = self.around.electrons(self.dt);
        let eps_r = self.around.eps_r();
        let mean = 0.5 * (e + e_after);
        let loss = self.around.conduction(self.dt);
        let conducted = match self.conduction {
            Conduction::Exponential if plasma2 == 0.0 && loss > 0.0 => {
                // σ times the mean over the step of the e^(−xt/Δt) that leads from E to E′.
                let x = loss / eps_r;
                loss * e_after + eps_r * (1.0 - x / x.exp_m1()) * (e - e_after)
            }
            _ => loss * mean,
        };
        let (mut charge, mut heat) = (conducted, conducted * mean);
        let mut energy = [e, e_after].map(|e| 0.5 * eps_r * e * e);
        if plasma2 > 0.0 {
            let flow = 0.5 * s * (j + j_after);
            charge += flow;
            heat += collision / plasma2 * flow * flow;
            for (energy, j) in energy.iter_mut().zip([j, j_after]) {
                *energy += 0.5 * (s * j) * (s * j) / plasma2;
            }
        }
        Passed { charge, energy, heat }
    }
}

/// ½ μ_r H·H₋ of a component whose update is H = H₋ + drive·curl, drive = S/μ_r.
fn magnetic_energy(courant: f64, drive: f64, h: f64, curl: f64) -> f64 {
    0.5 * (courant / drive) * h * (h - drive * curl)
}

impl Line {
    /// One step, and the energy balance of the nodes `nodes` with the cells between them: a part without sources,
    /// incident waves and absorbers, up to the nodes on conductors.
    ///
    /// # Errors
    /// If the part lies outside the stepped nodes or reaches into an absorber.
    pub fn audited_step(&mut self, nodes: RangeInclusive<usize>) -> Result<Balance, Refusal> {
        let (setup, (a, b)) = (self.setup().clone(), nodes.into_inner());
        let walls = setup.walls();
        let closed = usize::from(setup.ends == super::line::Ends::Periodic);
        let (first, last) = (walls[0].thickness().max(closed), setup.cells - walls[1].thickness().max(closed));
        inside("the first node of an audit", a, first, last)?;
        inside("the last node of an audit", b, a, last)?;
        let media = setup.media();
        let before = self.clone();
        self.run(1)?;
        let (s, dt) = (setup.stepping.courant, time_step(setup.stepping.courant, setup.spacing));
        let mut balance = Balance::default();
        let stepped = a.max(1)..=b.min(setup.cells - 1);
        for k in stepped.clone() {
            let passed = Component {
                around: &Surroundings::mean([&media[k - 1], &media[k]]),
                courant: s,
                dt,
                conduction: setup.stepping.conduction,
                e: [&before, self].map(|line| line.e[k]),
                j: [&before, self].map(|line| line.electric.current(k, &line.currents)),
            }
            .passed();
            balance.before += passed.energy[0];
            balance.after += passed.energy[1];
            balance.heat += passed.heat;
        }
        for k in a..b {
            let energy =
                |line: &Self| magnetic_energy(s, line.magnetic.drive(k), line.h[k + 1], line.e[k] - line.e[k + 1]);
            balance.before += energy(&before);
            balance.after += energy(self);
        }
        // Nothing flows through a conductor.
        let flow = |k: usize, h: usize| {
            if stepped.contains(&k) { s * 0.5 * (before.e[k] + self.e[k]) * before.h[h] } else { 0.0 }
        };
        balance.inflow = flow(a, a) - flow(b, b + 1);
        Ok(balance.scaled(EPSILON_0 * setup.spacing))
    }
}

/// A balance of a plane being drawn up.
pub(super) struct Ledger {
    pub courant: f64,
    pub dt: f64,
    pub conduction: Conduction,
    pub balance: Balance,
}

impl Ledger {
    /// Books an E component; answers the change of ε_r E and JΔt/ε₀.
    pub fn electric(&mut self, around: &Surroundings, e: [f64; 2], j: [f64; 2]) -> [f64; 2] {
        let (courant, dt, conduction) = (self.courant, self.dt, self.conduction);
        let passed = Component { around, courant, dt, conduction, e, j }.passed();
        self.balance.before += passed.energy[0];
        self.balance.after += passed.energy[1];
        self.balance.heat += passed.heat;
        [around.eps_r() * (e[1] - e[0]), passed.charge]
    }

    /// Books an H component, before and after: its field and the curl it was last stepped with.
    pub fn magnetic(&mut self, drive: f64, h: [f64; 2], curl: [f64; 2]) {
        self.balance.before += magnetic_energy(self.courant, drive, h[0], curl[0]);
        self.balance.after += magnetic_energy(self.courant, drive, h[1], curl[1]);
    }

    /// Books the flow E̅·H through the border, inwards.
    pub fn border(&mut self, e: [f64; 2], h: f64) {
        self.balance.inflow += self.courant * 0.5 * (e[0] + e[1]) * h;
    }

    /// Books the terms of a divergence that should cancel.
    pub fn divergence(&mut self, terms: &[f64], largest: f64) {
        let rest: f64 = terms.iter().sum();
        let share = if largest > 0.0 { rest.abs() / largest } else { rest.abs() };
        if share.total_cmp(&self.balance.divergence).is_gt() {
            self.balance.divergence = share;
        }
    }
}
