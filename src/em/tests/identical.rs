use super::packet;
use crate::Polarisation;
use crate::em::line::{Ends, Setup};
use crate::em::plane::{self, Region};
use crate::em::{Conduction, Line, Medium, Plane, Stepping};
use fearless_simd::Level;

fn layers() -> Vec<(std::ops::Range<usize>, Medium)> {
    vec![
        (60..100, Medium::dielectric(2.25)),
        (100..103, Medium::dielectric(4.0)),
        (120..160, Medium::conductor(3.0, 1.0)),
        (160..200, Medium::conductor(1.0, 1e6)),
        (220..240, Medium::metal(3e11, 1e10)),
        (240..250, Medium { mu_r: 2.0, ..Medium::VACUUM }),
    ]
}

#[test]
fn a_pruned_line_has_the_fields_of_the_full_one_bit_by_bit() {
    for conduction in [Conduction::SemiImplicit, Conduction::Exponential] {
        let run = |pruned: bool| {
            let stepping = Stepping { pruned, conduction, ..Stepping::at(0.9) };
            let mut setup = Setup::vacuum(300, 1e-3, Ends::open(12), stepping);
            setup.layers = layers();
            let mut line = Line::new(setup).unwrap();
            line.illuminate(40, 1.0, packet(1e10, 1.0)).unwrap();
            line.inject(150, 2.0, packet(2e10, 1.0)).unwrap();
            line.run(400).unwrap();
            line
        };
        let (pruned, full) = (run(true), run(false));
        assert_eq!((pruned.e(), pruned.h()), (full.e(), full.h()));
        assert!(pruned.e().iter().any(|e| e.abs() > 1e-3));
        let (ours, theirs) = (pruned.explain(), full.explain());
        assert!(ours.bytes < theirs.bytes && ours.operations_saved_per_cell() > theirs.operations_saved_per_cell());
        assert!(ours.omissions.iter().any(|omission| omission.id == "electrons"));
        assert!(theirs.omissions.iter().all(|omission| omission.what != "conduction"));
    }
}

#[test]
fn tiles_in_time_change_no_bit() {
    let mut setup = Setup::vacuum(3000, 1e-3, Ends::open(12), Stepping::at(0.9));
    setup.layers = layers();
    let mut whole = Line::new(setup).unwrap();
    whole.illuminate(40, 1.0, packet(1e10, 1.0)).unwrap();
    whole.inject(1024, 2.0, packet(2e10, 1.0)).unwrap();
    whole.probe(1023).unwrap();
    let mut step_by_step = whole.clone();
    whole.run(777).unwrap();
    (0..777).for_each(|_| step_by_step.run(1).unwrap());
    assert_eq!((whole.e(), whole.h(), whole.record(0)), (step_by_step.e(), step_by_step.h(), step_by_step.record(0)));
    assert!(whole.record(0).iter().any(|e| e.abs() > 1e-6));
}

fn plane_of(polarisation: Polarisation, phase: f64, pruned: bool) -> Plane {
    let stepping = Stepping { pruned, ..Stepping::at(0.6) };
    let mut setup = plane::Setup::vacuum([40, 230], 1e-3, polarisation, stepping).bloch(phase, 10);
    setup.regions = layers()
        .into_iter()
        .enumerate()
        .map(|(k, (range, medium))| Region::disc([6e-3 * (k + 1) as f64, range.start as f64 * 8e-4], 7e-3, medium))
        .collect();
    let mut plane = Plane::new(setup).unwrap();
    plane.illuminate(20, 1.0, packet(1e10, 1.0)).unwrap();
    plane.inject([20, 115], 1.0, packet(2e10, 1.0)).unwrap();
    plane.probe([3, 114]).unwrap();
    plane
}

#[test]
fn planes_are_identical_pruned_or_full_at_once_or_in_bands() {
    for polarisation in [Polarisation::S, Polarisation::P] {
        for phase in [0.0, 0.7] {
            let mut reference = plane_of(polarisation, phase, true);
            (0..333).for_each(|_| reference.run_serial(1).unwrap());
            assert!(reference.record(0).iter().any(|z| z.norm() > 1e-7));
            for (pruned, bands) in [(true, 1), (false, 1), (true, 2), (true, 3), (true, 7)] {
                let mut other = plane_of(polarisation, phase, pruned);
                other.run_in_bands(333, bands).unwrap();
                let at = format!("{polarisation:?}, phase {phase}, pruned {pruned}, {bands} bands");
                assert!(other.z() == reference.z(), "{at}");
                assert!(other.record(0) == reference.record(0), "{at}");
            }
        }
    }
}

#[test]
fn every_processor_finds_the_same_bits() {
    // What every processor of this kind can do, and what this one can: without fused products they agree.
    let run = |level: Level| {
        let mut setup = Setup::vacuum(300, 1e-3, Ends::open(12), Stepping::at(0.9));
        setup.layers = layers();
        let mut line = Line::new(setup).unwrap();
        line.level = level;
        line.illuminate(40, 1.0, packet(1e10, 1.0)).unwrap();
        line.run(600).unwrap();
        let planes = [(Polarisation::S, 0.0), (Polarisation::S, 0.7), (Polarisation::P, 0.0), (Polarisation::P, 0.7)];
        let planes = planes.map(|(polarisation, phase)| {
            let mut plane = plane_of(polarisation, phase, true);
            plane.grid.level = level;
            plane.run_serial(333).unwrap();
            (plane.z(), plane.incident())
        });
        (line.e().to_vec(), line.h(), planes)
    };
    assert!(run(Level::baseline()) == run(Level::new()));
}
