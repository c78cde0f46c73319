use super::{complex, packet};
use crate::Polarisation;
use crate::em::line::{Ends, Setup};
use crate::em::plane::{self, Region};
use crate::em::pulse::amplitude;
use crate::em::{C, EPSILON_0, Line, Medium, Plane, Stepping};
use crate::optics::film::{Layer, Stack};
use crate::optics::{Incidence, fresnel};
use num_complex::Complex64;
use std::f64::consts::TAU;
use yardstick::order;

const FREQUENCY: f64 = 15e9;
const OMEGA: f64 = TAU * FREQUENCY;
const WAVELENGTH: f64 = C / FREQUENCY;

/// Amplitudes over the incident one at ω: reflected, and at `beyond` cells behind the surface.
fn on_a_line(per_wavelength: usize, medium: Medium, thickness: Option<usize>, beyond: usize) -> [Complex64; 2] {
    let spacing = WAVELENGTH / per_wavelength as f64;
    let (source, surface) = (30 + per_wavelength, 40 + 2 * per_wavelength);
    let cells = surface + 2 * per_wavelength + thickness.unwrap_or(0) + 60;
    let mut setup = Setup::vacuum(cells, spacing, Ends::open(30), Stepping::at(0.5));
    setup.layers = vec![(surface..thickness.map_or(cells, |d| surface + d), medium)];
    let mut line = Line::new(setup).unwrap();
    line.illuminate(source, 1.0, packet(FREQUENCY, 1.5)).unwrap();
    let probes = [source - 1, surface + beyond].map(|node| line.probe(node).unwrap());
    line.run((50 * per_wavelength * 2) as u64).unwrap();
    let at = |record: &[f64]| amplitude(&complex(record), 0.0, line.dt(), OMEGA);
    let incident = at(line.incident().unwrap());
    probes.map(|probe| at(line.record(probe)) / incident)
}

#[test]
fn a_surface_reflects_and_transmits_as_fresnel_says_to_second_order() {
    for medium in [Medium::dielectric(2.25), Medium::metal(2.5 * OMEGA, 0.3 * OMEGA), Medium::conductor(2.0, 2.0)] {
        let n_t = medium.index(OMEGA);
        let exact = fresnel::amplitudes(Incidence::NORMAL, 1.0, n_t);
        let powers = fresnel::powers(Incidence::NORMAL, 1.0, n_t);
        let points: Vec<_> = [20, 40, 80]
            .into_iter()
            .map(|n| {
                let [r, t] = on_a_line(n, medium, None, 0);
                let error = (r.norm_sqr() - powers.r_s).abs();
                // T = Re n |t|²: the field at the surface itself is the transmitted one.
                let error_t = (t.norm_sqr() * n_t.re - powers.t_s).abs();
                assert!((t.norm() - exact.t_s.norm()).abs() < 0.1);
                (n as f64, error.max(error_t))
            })
            .collect();
        let slope = order::slope(&points).unwrap();
        assert!((slope + 2.0).abs() < 0.3, "{medium:?}: {points:?}, slope {slope}");
        assert!(points[2].1 < 5e-3, "{medium:?}: {points:?}");
    }
}

#[test]
fn a_film_reflects_and_transmits_as_its_stack_does() {
    let n = 60;
    for eps_r in [2.25, 6.0] {
        let cells = 13;
        let layers =
            [Layer { index: Complex64::from(f64::sqrt(eps_r)), thickness: cells as f64 / n as f64 * WAVELENGTH }];
        let stack = Stack { n_i: 1.0, layers: &layers, substrate: Complex64::from(1.0) };
        let exact = stack.response(WAVELENGTH, Incidence::NORMAL, Polarisation::S);
        let [r, t] = on_a_line(n, Medium::dielectric(eps_r), Some(cells), cells + 20);
        let (reflectance, transmittance) = (r.norm_sqr(), t.norm_sqr());
        assert!((reflectance + transmittance - 1.0).abs() < 1e-6, "{reflectance} + {transmittance}");
        let powers = exact;
        assert!((reflectance - powers.reflectance).abs() < 5e-3, "{reflectance} {}", powers.reflectance);
    }
}

#[test]
fn a_wave_in_a_conductor_decays_as_im_k() {
    // σ/(ωε₀) = 2.4: neither a dielectric nor a good conductor.
    let medium = Medium::conductor(1.5, 2.4 * EPSILON_0 * OMEGA);
    let exact = medium.index(OMEGA).im * OMEGA / C;
    let points: Vec<_> = [20, 40, 80]
        .into_iter()
        .map(|n| {
            let depth = n / 4;
            let fields = [0, depth].map(|beyond| on_a_line(n, medium, None, beyond)[1].norm());
            let decay = (fields[0] / fields[1]).ln() / (depth as f64 * WAVELENGTH / n as f64);
            (n as f64, (decay / exact - 1.0).abs())
        })
        .collect();
    let slope = order::slope(&points).unwrap();
    assert!((slope + 2.0).abs() < 0.2 && points[2].1 < 2e-3, "{points:?}, slope {slope}");
}

/// R of the half space or film at ω for k_x of `degrees` in vacuum.
fn in_a_plane(polarisation: Polarisation, degrees: f64, n: usize, medium: Medium, thickness: Option<usize>) -> f64 {
    let spacing = WAVELENGTH / n as f64;
    let sine = f64::to_radians(degrees).sin();
    let (source, surface) = (30 + n / 2, 40 + n);
    let rows = surface + n + 60;
    let setup = plane::Setup::vacuum([1, rows], spacing, polarisation, Stepping::at(0.7));
    let mut setup = setup.bloch(OMEGA / C * sine * spacing, 30);
    let end = thickness.map_or(f64::INFINITY, |d| (surface + d) as f64);
    setup.regions = vec![Region::layer(surface as f64 * spacing..end * spacing, medium)];
    let mut plane = Plane::new(setup).unwrap();
    // Standard deviation of the spectrum ω/(2π cycles): six of them lie above the frequency that grazes, ω sin θ.
    let cycles = (1.0 / (1.0 - sine)).max(1.5);
    plane.illuminate(source, 1.0, packet(FREQUENCY, cycles)).unwrap();
    let probe = plane.probe([0, source - 3]).unwrap();
    plane.run(((12.0 * cycles + 20.0) * n as f64 / 0.7) as u64).unwrap();
    let at = |record: &[Complex64]| amplitude(record, 0.0, plane.dt(), OMEGA);
    (at(&plane.record(probe)) / at(&plane.incident().unwrap())).norm_sqr()
}

#[test]
fn a_magnetic_half_space_reflects_obliquely_to_second_order() {
    // A wrong mean of μ at the surface turns r by an imaginary share of the first order. |r| does not see that while r
    // is real, so the medium conducts.
    let medium = Medium { mu_r: 4.0, ..Medium::conductor(1.5, 1.5 * EPSILON_0 * OMEGA) };
    let epsilon = medium.permittivity(OMEGA);
    for (degrees, polarisation) in
        [45.0, 70.0].into_iter().flat_map(|at| [(at, Polarisation::S), (at, Polarisation::P)])
    {
        let sine = f64::to_radians(degrees).sin();
        // k_y over that of the vacuum on both sides; continuous are k_y/μ · E_z and k_y/ε · H_z.
        let [near, far] = [1.0.into(), epsilon * medium.mu_r].map(|n2: Complex64| (n2 - sine * sine).sqrt());
        let far = far / if polarisation == Polarisation::S { medium.mu_r.into() } else { epsilon };
        let exact = ((near - far) / (near + far)).norm_sqr();
        let error = |n: usize| (in_a_plane(polarisation, degrees, n, medium, None) - exact).abs();
        let points: Vec<_> = [24, 36, 54].into_iter().map(|n| (n as f64, error(n))).collect();
        let slope = order::slope(&points).unwrap();
        assert!((slope + 2.0).abs() < 0.3, "{polarisation:?} at {degrees}°: {points:?}, slope {slope}");
    }
}

fn metal() -> Medium {
    Medium::metal(2.5 * OMEGA, 0.3 * OMEGA)
}

#[test]
fn oblique_reflection_is_that_of_fresnel_and_of_the_stack() {
    let n = 30;
    // Truncation of second order: (kΔ)².
    let limit = (TAU / n as f64).powi(2);
    for degrees in [0.0, 30.0, 56.0, 70.0] {
        let incidence = Incidence::from_angle(f64::to_radians(degrees));
        for medium in [Medium::dielectric(2.25), metal()] {
            let exact = fresnel::powers(incidence, 1.0, medium.index(OMEGA));
            for (polarisation, exact) in [(Polarisation::S, exact.r_s), (Polarisation::P, exact.r_p)] {
                let measured = in_a_plane(polarisation, degrees, n, medium, None);
                assert!(
                    (measured - exact).abs() < limit,
                    "{polarisation:?} at {degrees}°, {medium:?}: {measured} {exact}"
                );
            }
        }
        let cells = 9;
        let layers = [Layer { index: Complex64::from(2.0), thickness: cells as f64 / n as f64 * WAVELENGTH }];
        let stack = Stack { n_i: 1.0, layers: &layers, substrate: Complex64::from(1.0) };
        for polarisation in [Polarisation::S, Polarisation::P] {
            let exact = stack.response(WAVELENGTH, incidence, polarisation).reflectance;
            let measured = in_a_plane(polarisation, degrees, n, Medium::dielectric(4.0), Some(cells));
            assert!((measured - exact).abs() < limit, "film, {polarisation:?} at {degrees}°: {measured} {exact}");
        }
    }
}

#[test]
fn a_metal_reflects_obliquely_to_second_order_though_its_surface_is_the_mean_of_both_sides() {
    for (degrees, polarisation) in [(56.0, Polarisation::S), (56.0, Polarisation::P), (70.0, Polarisation::P)] {
        let powers = fresnel::powers(Incidence::from_angle(f64::to_radians(degrees)), 1.0, metal().index(OMEGA));
        let exact = if polarisation == Polarisation::S { powers.r_s } else { powers.r_p };
        let error = |n: usize| (in_a_plane(polarisation, degrees, n, metal(), None) - exact).abs();
        let points: Vec<_> = [24, 36, 54].into_iter().map(|n| (n as f64, error(n))).collect();
        let slope = order::slope(&points).unwrap();
        assert!((slope + 2.0).abs() < 0.3, "{polarisation:?} at {degrees}°: {points:?}, slope {slope}");
    }
}
