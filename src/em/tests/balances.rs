use crate::Polarisation;
use crate::em::line::{Ends, Setup};
use crate::em::plane::{self, Region, Sides};
use crate::em::{Conduction, EPSILON_0, Line, Medium, Plane, Stepping, Z_0};
use num_complex::Complex64;

/// Clear, faintly conducting, a Drude metal, magnetic, strongly conducting.
fn media() -> [Medium; 5] {
    [
        Medium::dielectric(2.25),
        Medium::conductor(4.0, 1e-3),
        Medium::metal(2e11, 3e10),
        Medium { mu_r: 3.0, ..Medium::conductor(2.0, 0.1) },
        Medium::conductor(1.0, 1e3),
    ]
}

#[test]
fn energy_on_a_line_balances_at_every_step() {
    for conduction in [Conduction::SemiImplicit, Conduction::Exponential] {
        let stepping = Stepping { conduction, ..Stepping::at(0.9) };
        let mut setup = Setup::vacuum(200, 1e-3, Ends::open(12), stepping);
        setup.layers = media().into_iter().enumerate().map(|(k, m)| (40 + 25 * k..65 + 25 * k, m)).collect();
        let mut line = Line::new(setup).unwrap();
        line.set(|z| (-((z - 0.06) / 0.01).powi(2)).exp(), |z| (-((z - 0.07) / 0.01).powi(2)).exp() / Z_0);
        let (mut inflow, mut heat) = (0.0, 0.0);
        for step in 0..600 {
            let balance = line.audited_step(30..=180).unwrap();
            assert!(balance.residual() < 1e-14 * 10.0, "{conduction:?}, step {step}: {:e}", balance.residual());
            inflow += balance.inflow;
            heat += balance.heat;
        }
        // Not for want of anything to balance.
        assert!(heat > 1e-3 * EPSILON_0 * 0.01 && inflow != 0.0);
    }
}

#[test]
fn charge_and_energy_balance_in_the_plane_at_every_step() {
    for polarisation in [Polarisation::S, Polarisation::P] {
        for conduction in [Conduction::SemiImplicit, Conduction::Exponential] {
            for sides in [
                Sides::Bloch(0.0),
                Sides::Bloch(0.4),
                Sides::Walls([plane::Setup::vacuum([1, 1], 1.0, polarisation, Stepping::at(0.5)).ends[0]; 2]),
            ] {
                let stepping = Stepping { conduction, ..Stepping::at(0.6) };
                let mut setup = plane::Setup::vacuum([24, 40], 1e-3, polarisation, stepping);
                setup.sides = sides;
                setup.regions = media()
                    .into_iter()
                    .enumerate()
                    .map(|(k, m)| Region::disc([4e-3 * (k as f64 + 0.7), 6e-3 * (k as f64 + 0.9)], 3.3e-3, m))
                    .collect();
                let mut plane = Plane::new(setup).unwrap();
                plane.set_z(|x, y| Complex64::new((700.0 * x + 300.0 * y).sin(), (500.0 * x - 900.0 * y).cos()));
                plane.run(20).unwrap();
                let mut heat = 0.0;
                for step in 0..100 {
                    let balance = plane.audited_step(5..=33).unwrap();
                    let at = format!("{polarisation:?}, {conduction:?}, {sides:?}, step {step}");
                    assert!(balance.residual() < 1e-13, "{at}: energy {:e}", balance.residual());
                    assert!(balance.divergence < 1e-13, "{at}: divergence {:e}", balance.divergence);
                    heat += balance.heat;
                }
                assert!(heat > 0.0);
            }
        }
    }
}

#[test]
fn where_nothing_is_nothing_is_amiss() {
    for polarisation in [Polarisation::S, Polarisation::P] {
        let setup = plane::Setup::vacuum([4, 8], 1e-3, polarisation, Stepping::at(0.6));
        let balance = Plane::new(setup).unwrap().audited_step(2..=6).unwrap();
        assert_eq!((balance.residual(), balance.divergence), (0.0, 0.0), "{polarisation:?}");
    }
}

#[test]
fn a_lossless_box_keeps_its_energy() {
    let mut setup = Setup::vacuum(100, 1e-3, Ends::Walls([crate::em::Wall::Conductor; 2]), Stepping::at(0.9));
    setup.layers = vec![(30..60, Medium::dielectric(5.0)), (50..80, Medium { mu_r: 2.0, ..Medium::VACUUM })];
    let mut line = Line::new(setup).unwrap();
    line.set(|z| (-((z - 0.03) / 0.01).powi(2)).exp(), |_| 0.0);
    let start = line.audited_step(0..=100).unwrap().before;
    line.run(100_000).unwrap();
    let end = line.audited_step(0..=100).unwrap();
    assert_eq!(end.heat, 0.0);
    // Rounding walks at random: √(10⁵) ε.
    assert!((end.after / start - 1.0).abs() < 1e-12, "{:e}", end.after / start - 1.0);
}
