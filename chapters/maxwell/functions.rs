//! What `lesson eval` offers from this chapter.

use crate::function::{Arguments, Function, Input, Output};
use crate::setting::Fault;
use light::em::line::{Ends, Line, Setup};
use light::em::theory::{growth_per_step, phase_per_step};
use light::em::{C, Medium, Stepping, Z_0};
use std::f64::consts::TAU;

/// The functions, each with its inputs' units and domains.
pub(super) const FUNCTIONS: &[Function] = &[YEE];

const YEE: Function = Function {
    name: "yee",
    says: "a ring of cells of one medium on the Yee grid, on which a wave of 1 V/m runs round; the solver itself refuses \
           unphysical media, steps beyond the Courant limit (unless unstable = 1) and grids beyond its memory",
    inputs: &[
        input("eps_r", "relative permittivity", "1", Some(1.0)),
        input("mu_r", "relative permeability", "1", Some(1.0)),
        input("sigma", "conductivity", "S/m", Some(0.0)),
        input("spacing", "size of a cell", "m", Some(1e-3)),
        input("cells", "cells of the ring", "1", Some(100.0)),
        input("waves", "whole waves round the ring", "1", Some(5.0)),
        input("courant", "Courant number cΔt/Δ, with c of the vacuum", "1", Some(0.5)),
        input("steps", "time steps", "1", Some(1000.0)),
        input("unstable", "1 to take a Courant number beyond the limit", "1", Some(0.0)),
    ],
    outputs: &[
        Output { name: "dt", says: "time step", unit: "s" },
        Output {
            name: "bytes",
            says: "memory of fields and coefficients once built; while it is built it takes more",
            unit: "B",
        },
        Output {
            name: "v_phase",
            says: "speed of the wave on the grid without conduction; nan if it is short enough to \
                   grow",
            unit: "m/s",
        },
        Output { name: "growth", says: "ln of the growth of the shortest wave per step", unit: "1" },
        Output {
            name: "E_max",
            says: "largest electric field after the last step; nan or infinite if it blew up",
            unit: "V/m",
        },
    ],
    call: |arguments| {
        let number = |name| arguments.number(name);
        let medium = Medium { eps_r: number("eps_r")?, mu_r: number("mu_r")?, sigma: number("sigma")?, drude: None };
        let stepping = Stepping { unstable: flag(arguments, "unstable")?, ..Stepping::at(number("courant")?) };
        let (cells, steps) = (whole(arguments, "cells")?, whole(arguments, "steps")?);
        let refused = |refusal: light::em::Refusal| Fault::new("yee", refusal.to_string());
        let setup =
            Setup { background: medium, ..Setup::vacuum(cells as usize, number("spacing")?, Ends::Periodic, stepping) };
        let mut line = Line::new(setup).map_err(refused)?;
        if cells.saturating_add(OVERHEAD).saturating_mul(steps) > MOST_WORK {
            return Err(Fault::new(
                "steps",
                format!("{steps} are too many for {cells} cells; valid: up to {}", MOST_WORK / (cells + OVERHEAD)),
            ));
        }
        let waves = whole(arguments, "waves")?;
        if !(1..=cells / 2).contains(&waves) {
            return Err(Fault::new("waves", format!("{waves} do not fit; valid: 1 to half the cells, {}", cells / 2)));
        }
        let k = TAU * waves as f64 / cells as f64;
        let relative = stepping.courant / (medium.eps_r * medium.mu_r).sqrt();
        let phase = phase_per_step(&[k], relative).re;
        let spacing = line.setup().spacing;
        let admittance = (medium.eps_r / medium.mu_r).sqrt() / Z_0;
        line.set(|z| (k * z / spacing).cos(), |z| admittance * (k * z / spacing - 0.5 * phase).cos());
        line.run(steps).map_err(refused)?;
        let is_stable = relative * (0.5 * k).sin().abs() <= 1.0;
        let speed = phase / (stepping.courant * k) * C;
        Ok(vec![
            ("dt", line.dt()),
            ("bytes", line.explain().bytes as f64),
            ("v_phase", if is_stable { speed } else { f64::NAN }),
            ("growth", growth_per_step(relative)),
            ("E_max", line.e().iter().map(|e| e.abs()).max_by(f64::total_cmp).unwrap_or(f64::NAN)),
        ])
    },
};

/// Cells times steps that are run, counting what a step takes beside its cells: some minutes.
const MOST_WORK: u64 = 100_000_000_000;
const OVERHEAD: u64 = 100;

const fn input(name: &'static str, says: &'static str, unit: &'static str, default: Option<f64>) -> Input {
    Input { name, says, unit, domain: None, default }
}

/// The input `name`, 0 or 1.
fn flag(arguments: &Arguments, name: &str) -> Result<bool, Fault> {
    match whole(arguments, name)? {
        0 => Ok(false),
        1 => Ok(true),
        other => Err(Fault::new(name, format!("{other} is out of range; valid: 0 or 1"))),
    }
}

/// The input `name`, which counts something.
fn whole(arguments: &Arguments, name: &str) -> Result<u64, Fault> {
    let value = arguments.number(name)?;
    if (0.0..=1e15).contains(&value) && value.fract() == 0.0 {
        return Ok(value as u64);
    }
    Err(Fault::new(
        name,
        format!("{} is out of range; valid: whole numbers from 0 to 1e15", crate::setting::number(value)),
    ))
}
