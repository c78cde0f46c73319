//! C3: the heat that the grid books, beside what the formulas of films leave of every wave of a pulse.

use super::agreement::worst_order;
use crate::vocabulary::{Check, check, fitted_order};
use light::Polarisation;
use light::em::line::{self, Ends, Line};
use light::em::plane::{self, Plane, Region};
use light::em::{C, Conduction, EPSILON_0, Medium, Pulse, Stepping, Z_0};
use light::optics::Incidence;
use light::optics::film::{Layer, Response, Stack};
use std::f64::consts::{PI, TAU};
use yardstick::quadrature::gauss;

pub(super) const HEAT: Check<fn(&Response) -> f64> = check(
    "heat_of_a_pulse",
    "what a pulse leaves as heat in a layer that conducts, or is a metal, approaches what the \
     formulas of films leave of each of its waves, with the second power of the cell",
)
.rows(&["C3"])
.against(
    "1 − R − T of chapter fresnel's film solver with ε(ω), integrated over the spectrum of the \
     pulse: nothing of the grid is in it",
)
.order(2.0, 0.25, "centred differences; 24 to 56 cells a wave are not yet the limit")
.of::<fn(&Response) -> f64>(
    |_, heat| worst_order(2.0, orders(heat)),
    |film| 1.0 - film.reflectance - film.transmittance,
)
.slip("what is reflected is counted as heat too", |film| 1.0 - film.transmittance);

/// The carrier [rad/s]: a wave of 1 m in vacuum.
const OMEGA: f64 = TAU * C;
/// Standard deviation of the pulse [s].
const WIDTH: f64 = 1.0 / (0.12 * OMEGA);
/// When its peak enters [s].
const DELAY: f64 = 6.0 * WIDTH;
/// Thickness of the layer [m].
const THICK: f64 = 0.25;
/// Cells of an absorber.
const ABSORBER: usize = 14;

/// What the pulse meets, how conduction is stepped, and its name.
const LAYERS: [(Medium, Conduction, &str); 3] = [
    (Medium::conductor(4.0, 2.0 * EPSILON_0 * OMEGA), Conduction::SemiImplicit, "conductor, semi-implicit"),
    (Medium::conductor(4.0, 2.0 * EPSILON_0 * OMEGA), Conduction::Exponential, "conductor, exponential"),
    (Medium::metal(1.5 * OMEGA, 0.3 * OMEGA), Conduction::Exponential, "metal"),
];

/// The order in the cell of each layer's heat, on a line and in a plane.
fn orders(heat: fn(&Response) -> f64) -> impl Iterator<Item = (f64, String)> {
    LAYERS.into_iter().flat_map(move |(medium, conduction, name)| {
        let exact = in_theory(medium, heat);
        [None, Some(Polarisation::S), Some(Polarisation::P)].map(|polarisation| {
            let missed = [24, 36, 56].map(|cells| {
                let found = on_the_grid(medium, conduction, polarisation, cells);
                (cells as f64, (found - exact).abs())
            });
            let place = polarisation.map_or("line".into(), |p| format!("plane, {p:?}"));
            (fitted_order(&missed).unwrap_or(f64::NAN), format!("{name}, {place}"))
        })
    })
}

/// Share of the pulse's energy that becomes heat, `heat` of each of its waves: |Ê|² goes as e^(−(ω − ω₀)²w²).
fn in_theory(medium: Medium, heat: fn(&Response) -> f64) -> f64 {
    let weighted = |u: f64| {
        let omega = OMEGA + u / WIDTH;
        let layers = [Layer { index: medium.index(omega), thickness: THICK }];
        let stack = Stack { n_i: 1.0, layers: &layers, substrate: 1.0.into() };
        (-u * u).exp() * heat(&stack.response(TAU * C / omega, Incidence::NORMAL, Polarisation::S))
    };
    gauss(64, -6.0, 6.0, weighted) / PI.sqrt()
}

/// The same by the grid's ledger, with so many cells to a metre, on a line or in one column of a plane.
fn on_the_grid(medium: Medium, conduction: Conduction, plane: Option<Polarisation>, cells: usize) -> f64 {
    let spacing = 1.0 / cells as f64;
    let thick = (THICK * cells as f64).round() as usize;
    let (lamp, first) = (ABSORBER + 4, ABSORBER + 8);
    let (face, back) = (first + 2, first + 2 + thick);
    let (last, all) = (back + 2, back + 6 + ABSORBER);
    let stepping = Stepping { conduction, ..Stepping::at(0.7) };
    let pulse = Pulse::Modulated { frequency: C, delay: DELAY, width: WIDTH };
    // As long again as the pulse takes to enter, for what goes to and fro in the layer.
    let steps = (3.0 * DELAY * C / (0.7 * spacing)).ceil() as u64;
    let heat: f64 = match plane {
        None => {
            let vacuum = line::Setup::vacuum(all, spacing, Ends::open(ABSORBER), stepping);
            let setup = line::Setup { layers: vec![(face..back, medium)], ..vacuum };
            let mut line = Line::new(setup).expect("within all limits");
            line.illuminate(lamp, 1.0, pulse).expect("an open node");
            (0..steps).map(|_| line.audited_step(first..=last).expect("between lamp and absorber").heat).sum()
        }
        Some(polarisation) => {
            let vacuum = plane::Setup::vacuum([1, all], spacing, polarisation, stepping).bloch(0.0, ABSORBER);
            let layer = Region::layer(face as f64 * spacing..back as f64 * spacing, medium);
            let mut plane = Plane::new(plane::Setup { regions: vec![layer], ..vacuum }).expect("within all limits");
            plane.illuminate(lamp, 1.0, pulse).expect("an open row");
            let heat = |_| plane.audited_step(first..=last).expect("between lamp and absorber").heat;
            (0..steps).map(heat).sum::<f64>() / spacing
        }
    };
    // ∫E²dt of the pulse is half that of its envelope.
    heat / (0.5 * PI.sqrt() * WIDTH / Z_0)
}
