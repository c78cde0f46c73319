use super::worst;
use crate::Polarisation;
use crate::em::line::{Ends, Setup};
use crate::em::plane::{self, Sides};
use crate::em::wave::{Problem, Scheme};
use crate::em::{Line, Medium, Plane, Stepping, Z_0, theory};
use num_complex::Complex64;
use std::f64::consts::TAU;
use yardstick::order;

/// A wave of `k` turns along a periodic line, started as the grid would have it: E at 0, H half a step later.
#[test]
fn a_plane_wave_travels_at_the_speed_of_the_dispersion_relation() {
    for (courant, turns, eps_r) in [(0.5, 3.0, 1.0), (0.9, 7.0, 1.0), (1.0, 5.0, 1.0), (0.8, 4.0, 2.25)] {
        let cells = 60;
        let stepping = Stepping::at(courant);
        let mut setup = Setup::vacuum(cells, 1.0, Ends::Periodic, stepping);
        setup.background = Medium::dielectric(eps_r);
        let mut line = Line::new(setup).unwrap();
        let k = TAU * turns / cells as f64;
        let phase = theory::phase_per_step(&[k], courant / eps_r.sqrt()).re;
        let impedance = Z_0 / eps_r.sqrt();
        line.set(|z| (k * z).cos(), |z| (k * z - 0.5 * phase).cos() / impedance);
        let steps = 1000;
        line.run(steps).unwrap();
        let errors = (0..cells).map(|n| line.e()[n] - (k * n as f64 - phase * steps as f64).cos());
        assert!(worst(errors) < 1e-11, "S = {courant}, {turns} turns");
    }
}

#[test]
fn a_bloch_wave_oscillates_at_the_frequency_of_the_dispersion_relation() {
    let (cells, courant) = ([12, 20], 0.6);
    for polarisation in [Polarisation::S, Polarisation::P] {
        for kx in [0.0, 0.05, 0.31] {
            let mut setup = plane::Setup::vacuum(cells, 1.0, polarisation, Stepping::at(courant));
            setup.sides = Sides::Bloch(kx * cells[0] as f64);
            let mut plane = Plane::new(setup).unwrap();
            let ky = std::f64::consts::PI * 3.0 / cells[1] as f64;
            // A standing wave between conductors, at rest half a step before H's first moment in s.
            let across = |y: f64| if polarisation == Polarisation::S { (ky * y).sin() } else { (ky * y).cos() };
            plane.set_z(|x, y| Complex64::cis(kx * x) * across(y));
            let probe = plane.probe([5, 7]).unwrap();
            plane.run(400).unwrap();
            let record = plane.record(probe);
            let phase = theory::phase_per_step(&[kx, ky], courant).re;
            // Any solution of this k obeys f₊ + f₋ = 2 cos(ωΔt) f.
            let scale = worst(record.iter().map(|f| f.norm()));
            let errors = record.windows(3).map(|f| (f[2] + f[0] - 2.0 * phase.cos() * f[1]).norm() / scale);
            assert!(worst(errors) < 1e-13, "{polarisation:?}, k_x = {kx}");
            assert!(scale > 0.0);
        }
    }
}

fn smooth(z: f64) -> f64 {
    (-0.5 * ((z - 0.5) / 0.05).powi(2)).exp()
}

fn rms(scheme: Scheme, profile: &dyn Fn(f64) -> f64, cells: usize) -> f64 {
    let problem = Problem { profile, length: 1.0, distance: 0.3 };
    let courant = 0.9 * scheme.courant_limit().min(1.0);
    let carried = scheme.carry(&problem, cells, courant).unwrap();
    let errors = carried.e.iter().zip(problem.exact(cells)).map(|(e, exact)| (e - exact).powi(2));
    (errors.sum::<f64>() / cells as f64).sqrt()
}

#[test]
fn schemes_have_their_orders_on_a_smooth_pulse() {
    let slope = |scheme, cells: &[usize]| {
        let points: Vec<_> = cells.iter().map(|&n| (n as f64, rms(scheme, &smooth, n))).collect();
        order::slope(&points).unwrap()
    };
    assert!((slope(Scheme::Yee, &[256, 512, 1024, 2048]) + 2.0).abs() < 0.05);
    assert!((slope(Scheme::FourthOrder, &[256, 512, 1024]) + 4.0).abs() < 0.1);
    assert!((slope(Scheme::PseudoSpectral, &[128, 256, 512]) + 4.0).abs() < 0.1);
    // Its spectrum ends far below the 64th harmonic: exp(−(2π·64·0.05)²/2) < 1e−87.
    assert!(rms(Scheme::Spectral, &smooth, 256) < 1e-14);
    assert_eq!(rms(Scheme::DAlembert, &smooth, 256), 0.0);
}

#[test]
fn a_square_pulse_spoils_every_order_but_that_of_no_differences() {
    let square = |z: f64| f64::from(u8::from((0.25..0.5).contains(&z)));
    for scheme in [Scheme::Yee, Scheme::FourthOrder, Scheme::PseudoSpectral] {
        let points: Vec<_> = [256, 512, 1024, 2048].map(|n| (n as f64, rms(scheme, &square, n))).into();
        let slope = order::slope(&points).unwrap();
        // p/(2(p + 1)) in the root mean square (Brenner, Thomée & Wahlbin 1975), below ½ for every p.
        assert!(-0.5 < slope && slope < -0.2, "{scheme:?}: {slope}");
    }
}

#[test]
fn schemes_are_stable_up_to_their_limits() {
    for scheme in [Scheme::Yee, Scheme::FourthOrder, Scheme::PseudoSpectral] {
        let square = |z: f64| f64::from(u8::from((0.25..0.5).contains(&z)));
        let problem = Problem { profile: &square, length: 1.0, distance: 40.0 };
        let carried = scheme.carry(&problem, 64, scheme.courant_limit()).unwrap();
        assert!(worst(carried.e) < 3.0, "{scheme:?}");
        assert!(scheme.carry(&problem, 64, 1.001 * scheme.courant_limit()).is_err());
    }
}

/// Trace of what a step makes of (H, E) of a wave that turns by `angle` [rad] in it: three leapfrog steps, with the
/// lengths that Yoshida (1990) gives them.
fn trace_of_a_composed_step(angle: f64) -> f64 {
    let outer = 1.0 / (2.0 - 2f64.powf(1.0 / 3.0));
    let mut columns = [[1.0, 0.0], [0.0, 1.0]];
    for length in [outer, 1.0 - 2.0 * outer, outer] {
        for [h, e] in &mut columns {
            *h -= 0.5 * length * angle * *e;
            *e += length * angle * *h;
            *h -= 0.5 * length * angle * *e;
        }
    }
    columns[0][0] + columns[1][1]
}

#[test]
fn limits_are_where_the_trace_of_a_step_leaves_two() {
    // Two cells a wave: the differences make (27·2 + 2)/24 of it, the transform kΔ itself.
    for (scheme, fastest) in [(Scheme::FourthOrder, 7.0 / 3.0), (Scheme::PseudoSpectral, std::f64::consts::PI)] {
        let trace = |share: f64| trace_of_a_composed_step(share * scheme.courant_limit() * fastest).abs();
        assert!(trace(1.0) <= 2.0 && trace(1.001) > 2.0, "{scheme:?}: {} {}", trace(1.0), trace(1.001));
    }
}

#[test]
fn only_schemes_that_step_are_refused_for_their_steps() {
    let problem = Problem { profile: &|z| (TAU * z).cos(), length: 1.0, distance: 1e6 };
    for scheme in Scheme::ALL {
        let carried = scheme.carry(&problem, 8, 1e-9);
        let steps = !matches!(scheme, Scheme::Spectral | Scheme::DAlembert);
        assert_eq!(
            carried.map_err(|refusal| refusal.to_string().contains("number of steps")).err(),
            steps.then_some(true)
        );
    }
    assert!(Scheme::DAlembert.carry(&Problem { length: 1e-300, distance: 1e300, ..problem }, 8, 1.0).is_err());
}
