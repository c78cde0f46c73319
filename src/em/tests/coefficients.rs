use crate::em::medium::{Conduction, Medium, Surroundings};
use crate::em::{EPSILON_0, Line, Stepping, line};

/// σΔt/ε from 1e−30 to 1e30, far beyond σ/(ωε) from 1e−6 to 1e12 at any sampling.
fn steps() -> impl Iterator<Item = f64> {
    (-300..=300).map(|p| 10f64.powf(f64::from(p) / 10.0))
}

#[test]
fn a_cell_is_stepped_with_the_smallest_of_loss_keep_and_one_plus_keep() {
    let dt = 1e-12;
    for x in steps() {
        let medium = Medium::conductor(2.0, x * 2.0 * EPSILON_0 / dt);
        for conduction in [Conduction::SemiImplicit, Conduction::Exponential] {
            let around = Surroundings::mean([&medium, &medium]);
            let c = around.coefficients(0.5, dt, conduction);
            let step = conduction.update(around.conduction(dt) / 2.0);
            assert!((c.base - c.rest - step.keep).abs() <= f64::EPSILON * 2.0, "x = {x}");
            assert!(c.rest.abs() <= 0.70, "x = {x}: {}", c.rest);
        }
    }
}

#[test]
fn a_faint_loss_is_not_rounded_into_another() {
    // A standing wave in a closed box loses e^(−x/2) a step; with keep = 1 − x as one number x would be rounded to
    // a multiple of ε/2, here by up to one part in two.
    let (cells, x, steps) = (32, 3.1e-16, 400_000);
    let stepping = Stepping::at(0.5);
    let mut setup = line::Setup::vacuum(cells, 1.0, line::Ends::Periodic, stepping);
    let mut energy = |sigma: f64| {
        setup.background = Medium::conductor(1.0, sigma);
        let mut line = Line::new(setup.clone()).unwrap();
        line.set(|z| (std::f64::consts::TAU * z / 32.0).sin(), |_| 0.0);
        line.run(steps).unwrap();
        line.audited_step(1..=31).unwrap().before
    };
    let clear = energy(0.0);
    let dt = 0.5 / crate::em::C;
    let lossy = energy(x * EPSILON_0 / dt);
    let lost = (clear - lossy) / clear;
    let due = -f64::exp_m1(-x * steps as f64);
    // Both runs round at random: √steps ε or so, a sixth of what is lost.
    assert!((lost / due - 1.0).abs() < 0.3, "lost {lost:e}, due {due:e}");
}
