//! What `lesson eval` offers from this chapter.

use crate::parameter::{Fault, Function, Kind, Output, Parameter, Range};
use light::em::line::{Ends, Line, Setup};
use light::em::theory::{growth_per_step, phase_per_step};
use light::em::{C, Medium, Stepping, Z_0};
use std::f64::consts::TAU;

/// The functions, each with its inputs' units and domains.
pub(super) const FUNCTIONS: &[Function] = &[YEE];

const YEE: Function = Function {
    name: "yee",
    says: "a ring of cells of one medium on the Yee grid, on which a wave of 1 V/m runs round; the solver itself refuses \
           steps beyond the Courant limit (unless unstable = 1) and grids beyond its memory",
    inputs: &[
        Parameter::new("eps_r", "ε_r", "relative permittivity", Kind::Number(Range::positive(MOST, "1"))).default("1"),
        Parameter::new("mu_r", "μ_r", "relative permeability", Kind::Number(Range::positive(MOST, "1"))).default("1"),
        Parameter::new("sigma", "σ", "conductivity", Kind::number(0.0, MOST, "S/m")).default("0"),
        Parameter::new("spacing", "Δ", "size of a cell", Kind::number(1.0 / MOST, MOST, "m")).default("0.001"),
        Parameter::new("cells", "N", "cells of the ring", COUNT).default("100"),
        Parameter::new("waves", "m", "whole waves round the ring, 1 to half the cells", WAVES).default("5"),
        Parameter::new(
            "courant",
            "S",
            "Courant number cΔt/Δ, with c of the vacuum",
            Kind::Number(Range::positive(MOST, "1")),
        )
        .default("0.5"),
        Parameter::new("steps", "", "time steps", COUNT).default("1000"),
        Parameter::new("unstable", "", "1 to take a Courant number beyond the limit", Kind::Count { min: 0, max: 1 })
            .default("0"),
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
    compute: |setting| {
        let number = |name| setting.number(name);
        let whole = |name| setting.number(name) as u64;
        let medium = Medium { eps_r: number("eps_r"), mu_r: number("mu_r"), sigma: number("sigma"), drude: None };
        let stepping = Stepping { unstable: whole("unstable") == 1, ..Stepping::at(number("courant")) };
        let (cells, steps) = (whole("cells"), whole("steps"));
        let refused = |refusal: light::em::Refusal| Fault::new("yee", refusal.to_string());
        let setup =
            Setup { background: medium, ..Setup::vacuum(cells as usize, number("spacing"), Ends::Periodic, stepping) };
        let mut line = Line::new(setup).map_err(refused)?;
        if cells.saturating_add(OVERHEAD).saturating_mul(steps) > MOST_WORK {
            return Err(Fault::new(
                "steps",
                format!("{steps} are too many for {cells} cells; valid: up to {}", MOST_WORK / (cells + OVERHEAD)),
            ));
        }
        let waves = whole("waves");
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

/// The largest number that the solver takes: beyond every number of physics in SI units.
const MOST: f64 = 1e30;
/// Their end depends on the cells, and whoever asks for none is told so.
const WAVES: Kind = Kind::Count { min: 0, max: 1_000_000_000_000_000 };
/// At least one; a double holds them all.
const COUNT: Kind = Kind::Count { min: 1, max: 1_000_000_000_000_000 };
