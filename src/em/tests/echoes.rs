//! What a layer sends back, against what its grading promises.

use super::{complex, packet};
use crate::Polarisation;
use crate::em::line::{Ends, Setup};
use crate::em::plane::{self, Sides};
use crate::em::pulse::amplitude;
use crate::em::{C, Cpml, EPSILON_0, Line, Medium, Plane, Stepping, Wall};
use num_complex::Complex64;
use std::f64::consts::TAU;

const SPACING: f64 = 1e-3;

fn index(medium: &Medium) -> f64 {
    (medium.eps_r * medium.mu_r).sqrt()
}

/// 0.4 cells of the medium's own speed a step.
fn stepping(medium: &Medium) -> Stepping {
    Stepping::at(0.4 * index(medium))
}

/// Δt [s].
fn time_step(medium: &Medium) -> f64 {
    stepping(medium).courant * SPACING / C
}

/// The layer in question at an `end`, and at the other one a layer that takes all.
fn walls(layer: Cpml, end: usize) -> [Wall; 2] {
    let rest = Cpml::thick(30);
    (if end == 0 { [layer, rest] } else { [rest, layer] }).map(Wall::Open)
}

/// The wave of ω [rad/s] that comes back from `layer` over the one that goes in: a layer of many cells, which waves of
/// either kind do not come back from, tells the two apart.
fn echo(layer: Cpml, omega: f64, dt: f64, run: impl Fn(Cpml) -> Vec<Complex64>) -> Complex64 {
    let [with, without] = [layer, Cpml::thick(60)].map(|layer| amplitude(&run(layer), 0.0, dt, omega));
    (with - without) / without
}

/// At the inner edge of a layer at an `end` of a line in `medium`.
fn echo_on_a_line(medium: Medium, layer: Cpml, end: usize, omega: f64) -> Complex64 {
    let dt = time_step(&medium);
    echo(layer, omega, dt, |layer| {
        let cells = 70 + layer.cells;
        let mut setup = Setup::vacuum(cells, SPACING, Ends::Walls(walls(layer, end)), stepping(&medium));
        setup.background = medium;
        let mut line = Line::new(setup).unwrap();
        let at = |before: usize| if end == 0 { layer.cells + before } else { cells - layer.cells - before };
        line.inject(at(20), 1.0, packet(omega / TAU, 1.0)).unwrap();
        let probe = line.probe(at(0)).unwrap();
        line.run((18.0 * TAU / (omega * dt)) as u64).unwrap();
        complex(line.record(probe))
    })
}

/// At the inner edge of a layer at an `end` of a column that repeats with a phase of `k_x` [rad/m]; in p half a cell
/// before it, where H_z stands.
fn echo_in_a_plane(
    polarisation: Polarisation,
    medium: Medium,
    layer: Cpml,
    end: usize,
    [omega, k_x]: [f64; 2],
) -> Complex64 {
    let dt = time_step(&medium);
    // So many cycles that the spectrum ends, six standard deviations away, before the frequency that grazes and before 0.
    let grazing = C * k_x / index(&medium);
    let cycles = 6.0 / TAU * (omega / (omega - grazing).abs()).max(1.0);
    echo(layer, omega, dt, |layer| {
        let rows = 70 + layer.cells;
        let vacuum = plane::Setup::vacuum([1, rows], SPACING, polarisation, stepping(&medium));
        let (sides, ends) = (Sides::Bloch(k_x * SPACING), walls(layer, end));
        let mut plane = Plane::new(plane::Setup { sides, ends, background: medium, ..vacuum }).unwrap();
        let at = |before: usize| if end == 0 { layer.cells + before } else { rows - layer.cells - before };
        plane.inject([0, at(20)], 1.0, packet(omega / TAU, cycles)).unwrap();
        let below = usize::from(polarisation == Polarisation::P && end == 1);
        let probe = plane.probe([0, at(below)]).unwrap();
        plane.run_serial(((12.0 * cycles + 6.0) * TAU / (omega * dt)) as u64).unwrap();
        plane.record(probe)
    })
}

/// k [rad/m] across the layer of the grid's wave of ω and k_x [rad/s, rad/m], travelling or evanescent.
fn wave_number(medium: Medium, [omega, k_x]: [f64; 2]) -> Complex64 {
    let dt = time_step(&medium);
    let in_time = (0.5 * omega * dt).sin() / 0.4;
    let along = (0.5 * k_x * SPACING).sin();
    2.0 * Complex64::from(in_time * in_time - along * along).sqrt().asin() / SPACING
}

/// e^(2ik∫s dz): down the layer and back, s = κ + σ/(a − iωε₀) integrated by the midpoint rule. As on the grid, the
/// convolution that s is in time is a sum over whole steps.
fn promised(medium: Medium, layer: Cpml, omega: f64, k: Complex64) -> Complex64 {
    let Cpml { cells, order, reflection, kappa, alpha } = layer;
    let (thickness, dt) = (cells as f64 * SPACING, time_step(&medium));
    let stretch = |share: f64| {
        // ∫σ n Z₀ dz = −½ ln R.
        let per_epsilon = C / index(&medium) / thickness;
        let sigma = -0.5 * reflection.ln() * (order + 1.0) * share.powf(order) * per_epsilon;
        let fall = Complex64::new(-alpha * (1.0 - share) / EPSILON_0, omega) * dt;
        1.0 + (kappa - 1.0) * share.powf(order) + sigma * dt / (1.0 - fall.exp())
    };
    let parts = 1000;
    let mean: Complex64 = (0..parts).map(|at| stretch((f64::from(at) + 0.5) / f64::from(parts))).sum();
    (Complex64::i() * 2.0 * k * thickness * mean / f64::from(parts)).exp()
}

/// A layer that lets back so much of a wave along its normal, for want of loss.
fn faint(cells: usize, reflection: f64) -> Cpml {
    Cpml { order: 3.0, reflection, ..Cpml::thick(cells) }
}

#[test]
fn echoes_are_the_promised_ones_in_any_medium_at_either_end() {
    for (eps_r, mu_r) in [(1.0, 1.0), (9.0, 1.0), (80.0, 1.0), (1.0, 9.0), (4.0, 2.5)] {
        let medium = Medium { mu_r, ..Medium::dielectric(eps_r) };
        // 20 cells a wavelength.
        let omega = TAU * C / (20.0 * SPACING * index(&medium));
        let (plain, low) = (faint(24, 0.05), omega * EPSILON_0);
        let layers = [
            plain,
            Cpml { kappa: 1.5, ..plain },
            Cpml { alpha: 3.0 * low, ..plain },
            Cpml { kappa: 1.5, alpha: 2.0 * low, ..plain },
        ];
        for (layer, end) in layers.into_iter().flat_map(|layer| [(layer, 0), (layer, 1)]) {
            let found = echo_on_a_line(medium, layer, end, omega);
            // The conductor behind turns E over.
            let expected = -promised(medium, layer, omega, wave_number(medium, [omega, 0.0]));
            let off = (found / expected - 1.0).norm();
            // e^x − 1 for x = σΔt/ε₀, up to 0.1 here, in an exponent of −ln R = 3; and what κ = 1.5 does to a wave of
            // 20 cells, of which it leaves 13.
            assert!(off < 0.15, "{medium:?}, {layer:?}, end {end}: {found:e} against {expected:e}");
        }
    }
}

#[test]
fn slanting_and_evanescent_echoes_are_the_promised_ones_in_the_plane() {
    let k_x = TAU / 55.0 / SPACING;
    for (eps_r, mu_r, end) in [(9.0, 1.0, 1), (2.0, 2.0, 0)] {
        let medium = Medium { mu_r, ..Medium::dielectric(eps_r) };
        let grazing = C * k_x / index(&medium);
        // At 45°; and at half the frequency that grazes, where a wave falls by e^1.2 on its way through the layer.
        let (slanting, evanescent) = (2f64.sqrt() * grazing, 0.5 * grazing);
        let plain = faint(12, 0.3);
        let cases = [
            (slanting, plain),
            (slanting, Cpml { alpha: 2.0 * slanting * EPSILON_0, ..plain }),
            (evanescent, Cpml { kappa: 4.0, ..plain }),
            (evanescent, Cpml { alpha: 2.0 * evanescent * EPSILON_0, ..plain }),
        ];
        for (polarisation, (omega, layer)) in
            [Polarisation::S, Polarisation::P].into_iter().flat_map(|p| cases.map(|case| (p, case)))
        {
            let found = echo_in_a_plane(polarisation, medium, layer, end, [omega, k_x]);
            let k = wave_number(medium, [omega, k_x]);
            // The conductor turns E over, and not H.
            let (turned, before) = if polarisation == Polarisation::S { (-1.0, 0.0) } else { (1.0, 0.5 * SPACING) };
            let expected = turned * (Complex64::i() * 2.0 * k * before).exp() * promised(medium, layer, omega, k);
            let off = (found / expected - 1.0).norm();
            // As on the line: x is 0.08 here, and the exponent 1.2.
            let at = format!("{polarisation:?}, {medium:?}, {layer:?}, ω = {omega:e}");
            assert!(off < 0.1, "{at}: {found:e} against {expected:e}");
        }
    }
}
