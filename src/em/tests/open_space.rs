use super::{complex, packet, worst};
use crate::Polarisation;
use crate::em::line::{Ends, Setup};
use crate::em::plane;
use crate::em::pulse::amplitude;
use crate::em::{C, Cpml, Line, Medium, Plane, Stepping, Wall};
use std::f64::consts::TAU;

/// 20 cells a wavelength at the carrier.
const SPACING: f64 = 1e-3;
const FREQUENCY: f64 = C / (20.0 * SPACING);
const COURANT: f64 = 0.4;

#[test]
fn the_layer_reflects_less_than_a_millionth_on_a_line() {
    for eps_r in [1.0, 2.25] {
        let setup = |cells| {
            let mut setup = Setup::vacuum(cells, SPACING, Ends::open(30), Stepping::at(0.7));
            setup.background = Medium::dielectric(eps_r);
            setup
        };
        let run = |cells: usize| {
            let mut line = Line::new(setup(cells)).unwrap();
            line.inject(60, 1.0, packet(FREQUENCY, 1.0)).unwrap();
            let probe = line.probe(70).unwrap();
            line.run(1200).unwrap();
            line.record(probe).to_vec()
        };
        // The far end of the long line is not heard of in time; the near one is the same in both.
        let (short, long) = (run(140), run(1500));
        let scale = worst(long.iter().copied());
        let reflected = worst(short.iter().zip(&long).map(|(a, b)| a - b)) / scale;
        assert!(0.0 < reflected && reflected < 1e-6, "ε_r = {eps_r}: {reflected:e}");
    }
}

#[test]
fn a_line_seen_in_a_mirror_is_the_same_line_backwards() {
    let layers = [Cpml { kappa: 3.0, alpha: 0.01, ..Cpml::thick(7) }, Cpml { order: 2.0, ..Cpml::thick(11) }];
    let (near, far) = (Medium::dielectric(4.0), Medium { mu_r: 2.0, ..Medium::dielectric(1.5) });
    let run = |mirrored: bool| {
        let mut setup = Setup::vacuum(60, SPACING, Ends::Walls(layers.map(Wall::Open)), Stepping::at(COURANT));
        setup.layers = vec![(0..25, near), (25..60, far)];
        if mirrored {
            setup.layers = vec![(0..35, far), (35..60, near)];
            setup.ends = Ends::Walls([layers[1], layers[0]].map(Wall::Open));
        }
        let mut line = Line::new(setup).unwrap();
        line.inject(if mirrored { 40 } else { 20 }, 1.0, packet(FREQUENCY, 0.5)).unwrap();
        line.run(300).unwrap();
        line.e().to_vec()
    };
    let mut mirrored = run(true);
    mirrored.reverse();
    assert_eq!(run(false), mirrored);
}

#[test]
fn a_plane_seen_in_a_mirror_is_the_same_plane_backwards() {
    let layers = [6, 9].map(|cells| Wall::Open(Cpml { kappa: 3.0, alpha: 0.01, ..Cpml::thick(cells) }));
    let (columns, rows) = (40, 34);
    for polarisation in [Polarisation::S, Polarisation::P] {
        let run = |mirrored: [bool; 2]| {
            let setup = plane::Setup::vacuum([columns, rows], SPACING, polarisation, Stepping::at(0.6));
            let ends = |mirrored: bool| if mirrored { [layers[1], layers[0]] } else { layers };
            // Each end stands in a medium of its own.
            let medium = move |x: f64, y: f64| {
                let x = if mirrored[0] { columns as f64 * SPACING - x } else { x };
                let y = if mirrored[1] { rows as f64 * SPACING - y } else { y };
                (x < 15.0 * SPACING, y < 20.0 * SPACING)
            };
            let quarter = |left: bool, low: bool, eps_r: f64| {
                plane::Region::new(move |x, y| medium(x, y) == (left, low), Medium::dielectric(eps_r))
            };
            let mut plane = Plane::new(plane::Setup {
                sides: plane::Sides::Walls(ends(mirrored[0])),
                ends: ends(mirrored[1]),
                regions: vec![quarter(true, true, 4.0), quarter(true, false, 2.0), quarter(false, true, 9.0)],
                ..setup
            })
            .unwrap();
            // J_z at a node in s; in p J_x, between two nodes of a row.
            let p = usize::from(polarisation == Polarisation::P);
            let column = if mirrored[0] { columns - 18 - p } else { 18 };
            plane.inject([column, if mirrored[1] { rows - 16 } else { 16 }], 1.0, packet(FREQUENCY, 0.5)).unwrap();
            plane.run(200).unwrap();
            let mut z = plane.z();
            if mirrored[0] {
                z.iter_mut().for_each(|row| row.reverse());
            }
            if mirrored[1] {
                z.reverse();
            }
            z
        };
        let (plain, across, along) = (run([false, false]), run([true, false]), run([false, true]));
        // A mirror across y turns H_z over, and with it the current that drives it where that runs along x.
        let sign = if polarisation == Polarisation::P { -1.0 } else { 1.0 };
        let scale = worst(plain.iter().flatten().copied());
        for (mirrored, sign) in [(across, 1.0), (along, sign)] {
            let off = plain.iter().flatten().zip(mirrored.iter().flatten()).map(|(a, b)| a - sign * b);
            assert!(scale > 0.0 && worst(off) < 1e-13 * scale, "{polarisation:?}");
        }
    }
}

#[test]
fn the_layer_reflects_less_than_a_millionth_in_the_plane() {
    for polarisation in [Polarisation::S, Polarisation::P] {
        for degrees in [0.0, 45.0] {
            let columns = 2;
            let k_x = TAU * FREQUENCY / C * f64::to_radians(degrees).sin();
            let run = |rows: usize| {
                let phase = k_x * SPACING * columns as f64;
                let setup = plane::Setup::vacuum([columns, rows], SPACING, polarisation, Stepping::at(0.6));
                let mut setup = setup.bloch(phase, 30);
                setup.ends[0] = Wall::Conductor;
                let mut plane = Plane::new(setup).unwrap();
                plane.illuminate(10, 1.0, packet(FREQUENCY, 4.0)).unwrap();
                let probe = plane.probe([0, 30]).unwrap();
                plane.run(2000).unwrap();
                plane.record(probe)
            };
            let (short, long) = (run(90), run(600));
            let at = |record: &[_]| amplitude(record, 0.0, 0.6 * SPACING / C, TAU * FREQUENCY);
            let difference: Vec<_> = short.iter().zip(&long).map(|(a, b)| a - b).collect();
            let reflected = at(&difference).norm() / at(&long).norm();
            assert!(0.0 < reflected && reflected < 1e-6, "{polarisation:?} at {degrees}°: {reflected:e}");
        }
    }
}

#[test]
fn the_incident_wave_does_not_leak() {
    let mut line = Line::new(Setup::vacuum(200, SPACING, Ends::open(30), Stepping::at(0.8))).unwrap();
    line.illuminate(100, 1.0, packet(FREQUENCY, 1.0)).unwrap();
    let (before, after) = (line.probe(99).unwrap(), line.probe(100).unwrap());
    line.run(600).unwrap();
    let scale = worst(line.record(after).iter().copied());
    // The far layer begins 70 cells on: before 2 × 70/0.8 steps its echo is not back, and nothing is there but rounding.
    let leaked = worst(line.record(before).iter().take(170).copied()) / scale;
    assert!(leaked < 1e-14, "{leaked:e}");
    let errors = line.record(after).iter().zip(line.incident().unwrap()).map(|(a, b)| a - b);
    assert!(worst(errors.take(170)) < 1e-14 * scale.max(1.0));
    for polarisation in [Polarisation::S, Polarisation::P] {
        for phase in [0.0, 0.9] {
            for medium in [Medium::VACUUM, Medium::conductor(2.25, 0.01), Medium::metal(3e10, 1e9)] {
                let setup = plane::Setup::vacuum([5, 300], SPACING, polarisation, Stepping::at(0.6));
                let mut plane = Plane::new(plane::Setup { background: medium, ..setup.bloch(phase, 30) }).unwrap();
                plane.illuminate(40, 1.0, packet(FREQUENCY, 1.0)).unwrap();
                let [before, after, entry] = [[3, 38], [3, 41], [0, 40]].map(|at| plane.probe(at).unwrap());
                // The far layer begins 230 rows on.
                plane.run(500).unwrap();
                let scale = worst(plane.record(after).iter().map(|z| z.norm()));
                let leaked = worst(plane.record(before).iter().map(|z| z.norm())) / scale;
                assert!(leaked < 1e-13, "{polarisation:?}, phase {phase}, {medium:?}: {leaked:e}");
                let (entered, incident) = (plane.record(entry), plane.incident().unwrap());
                assert_eq!(entered.len(), incident.len());
                let off = worst(entered.iter().zip(&incident).map(|(a, b)| (a - b).norm()));
                let entered = worst(entered.iter().map(|z| z.norm()));
                assert!(off < 1e-13 * entered, "{polarisation:?}, phase {phase}, {medium:?}: {off:e} of {entered:e}");
            }
        }
    }
}

#[test]
fn the_echo_of_an_incident_wave_is_faint_when_it_comes_at_last() {
    let ends = Ends::Walls([Wall::Open(Cpml::thick(30)), Wall::Open(Cpml::thick(600))]);
    let mut line = Line::new(Setup::vacuum(700, SPACING, ends, Stepping::at(0.8))).unwrap();
    line.illuminate(60, 1.0, packet(FREQUENCY, 1.0)).unwrap();
    let before = line.probe(59).unwrap();
    line.run(12_000).unwrap();
    let leaked = worst(line.record(before).iter().copied());
    assert!(leaked < 1e-12, "{leaked:e}");
}

#[test]
fn a_conductor_behind_reflects_everything() {
    let ends = Ends::Walls([Wall::Open(Cpml::thick(30)), Wall::Conductor]);
    let mut line = Line::new(Setup::vacuum(200, SPACING, ends, Stepping::at(0.8))).unwrap();
    line.illuminate(60, 1.0, packet(FREQUENCY, 1.0)).unwrap();
    let probe = line.probe(50).unwrap();
    line.run(1500).unwrap();
    let dt = line.dt();
    let [back, there] = [line.record(probe), line.incident().unwrap()]
        .map(|record| amplitude(&complex(record), 0.0, dt, TAU * FREQUENCY).norm());
    assert!((back / there - 1.0).abs() < 1e-6, "{}", back / there);
}
