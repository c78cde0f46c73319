use super::worst;
use crate::Polarisation;
use crate::em::line::{Ends, Setup};
use crate::em::plane;
use crate::em::{Line, Medium, Plane, Stepping, theory};
use num_complex::Complex64;

fn noise(n: usize) -> f64 {
    // A fixed sequence without structure: all wave numbers take part.
    (n as f64 * 12.9898).sin() * 43758.5453 % 1.0
}

fn line_at(courant: f64, medium: Medium) -> Line {
    let stepping = Stepping { unstable: true, ..Stepping::at(courant) };
    let mut setup = Setup::vacuum(64, 1e-3, Ends::Periodic, stepping);
    setup.background = medium;
    let mut line = Line::new(setup).unwrap();
    line.set(|z| noise((z * 1e3) as usize), |_| 0.0);
    line
}

fn plane_at(courant: f64, polarisation: Polarisation) -> Plane {
    let stepping = Stepping { unstable: true, ..Stepping::at(courant) };
    let mut plane = Plane::new(plane::Setup::vacuum([16, 16], 1e-3, polarisation, stepping)).unwrap();
    plane.set_z(|x, y| Complex64::from(noise((x * 1e3) as usize * 16 + (y * 1e3) as usize)));
    plane
}

#[test]
fn just_below_the_limit_a_hundred_thousand_steps_are_stable() {
    let drude = Medium::metal(3e11, 0.0);
    // A wave of amplitude 1 in E with no H beside it swings up to 1/cos(ωΔt/2) ≤ 1/√(1 − S²).
    let courant: f64 = 1.0 - 1e-6;
    let bound = 2.0 / ((1.0 - courant) * (1.0 + courant)).sqrt();
    for medium in [Medium::VACUUM, drude] {
        let mut line = line_at(courant, medium);
        line.run(100_000).unwrap();
        assert!(worst(line.e().iter().copied()) < bound);
    }
    for polarisation in [Polarisation::S, Polarisation::P] {
        let mut plane = plane_at(theory::courant_limit(2) * courant, polarisation);
        plane.run(100_000).unwrap();
        assert!(worst(plane.z().into_iter().flatten()) < bound);
    }
}

#[test]
fn a_metal_that_runs_into_a_layer_is_stable_for_a_hundred_thousand_steps() {
    // A well resolved metal and one at the edge of the grid; without collisions, or nearly, nothing else damps it.
    for (plasma, collision) in [(0.3, 1e-4), (1.5, 0.0)] {
        let dt = 0.7e-3 / crate::em::C;
        let metal = Medium::metal(plasma / dt, collision / dt);
        for polarisation in [Polarisation::S, Polarisation::P] {
            // Its surface meets the layers on the left and right at a right angle, and it fills the one below.
            let mut setup = plane::Setup::vacuum([14, 16], 1e-3, polarisation, Stepping::at(0.7)).open(5);
            setup.regions = vec![plane::Region::layer(f64::NEG_INFINITY..8e-3, metal)];
            let mut plane = Plane::new(setup).unwrap();
            plane.set_z(|x, y| Complex64::from(noise((x * 1e3) as usize * 16 + (y * 1e3) as usize)));
            plane.run_serial(1000).unwrap();
            let early = worst(plane.z().into_iter().flatten());
            plane.run_serial(99_000).unwrap();
            let late = worst(plane.z().into_iter().flatten());
            assert!(late < 2.0 * early, "{polarisation:?}, ω_pΔt = {plasma}, γΔt = {collision}: {early:e} to {late:e}");
        }
    }
}

/// ln of the growth per step, over the second half of 2n steps.
fn growth(n: u64, mut largest_after: impl FnMut(u64) -> f64) -> f64 {
    let (first, second) = (largest_after(n), largest_after(n));
    (second / first).ln() / n as f64
}

#[test]
fn just_above_the_limit_fields_grow_at_the_rate_of_theory() {
    for excess in [1.0 + 1e-4, 1.001, 1.01, 1.1] {
        let rate = theory::growth_per_step(excess);
        let n = (30.0 / rate) as u64;
        let mut line = line_at(excess, Medium::VACUUM);
        line.set(|z| if (z * 1e3).round() as i64 % 2 == 0 { 1e-100 } else { -1e-100 }, |_| 0.0);
        let measured = growth(n, |n| {
            line.run(n).unwrap();
            worst(line.e().iter().copied())
        });
        assert!((measured / rate - 1.0).abs() < 1e-3, "S = {excess}: {measured} against {rate}");
    }
    // Between conductors the largest k_i is π − π/16: the wave of the table (i, j) = (15, 15), and theory knows it.
    let courant = 1.1 * theory::courant_limit(2);
    let k = std::f64::consts::PI * 15.0 / 16.0;
    let rate = theory::phase_per_step(&[k, k], courant).im;
    assert!(rate > 0.0);
    let mut plane = plane_at(courant, Polarisation::S);
    plane.set_z(|x, y| Complex64::from(1e-100 * (k * x * 1e3).sin() * (k * y * 1e3).sin()));
    let measured = growth((40.0 / rate) as u64, |n| {
        plane.run(n).unwrap();
        worst(plane.z().into_iter().flatten())
    });
    assert!((measured / rate - 1.0).abs() < 1e-3, "{measured} against {rate}");
}
