//! A plane wave on a layered structure, solved on the grid: what comes back and what goes through.

use light::Complex64;
use light::Polarisation;
use light::em::line::{Ends, Line, Setup as LineSetup};
use light::em::plane::{self, Plane, Region};
use light::em::pulse::amplitude;
use light::em::{C, Medium, Pulse, Stepping};
use light::optics::Incidence;
use light::optics::film::{Layer, Stack};
use std::f64::consts::TAU;

/// Films on a substrate, in vacuum.
#[derive(Clone, Debug)]
pub(super) struct Scene {
    /// Angle of incidence [rad].
    pub theta: f64,
    /// s or p.
    pub polarisation: Polarisation,
    /// Thickness over the vacuum wavelength, and ε_r, in the order of the light.
    pub films: Vec<(f64, f64)>,
    /// What lies behind.
    pub substrate: Medium,
}

/// Vacuum wavelength [m] of all runs: nothing depends on it.
const WAVELENGTH: f64 = 1.0;
const OMEGA: f64 = TAU * C / WAVELENGTH;
/// Rows of an absorber.
const ABSORBER: usize = 14;
/// S in two dimensions.
const COURANT: f64 = 0.7;

impl Scene {
    /// Whether anything comes out behind.
    fn is_clear(&self) -> bool {
        self.substrate.sigma == 0.0 && self.substrate.drude.is_none()
    }

    /// (R, T) by the formulas of chapter `fresnel`; T = 0 behind what absorbs.
    pub fn exact(&self) -> (f64, f64) {
        let index = |eps: f64| Complex64::from(eps.sqrt());
        let layers: Vec<Layer> = self
            .films
            .iter()
            .map(|&(thickness, eps)| Layer { index: index(eps), thickness: thickness * WAVELENGTH })
            .collect();
        let stack = Stack { n_i: 1.0, layers: &layers, substrate: self.substrate.index(OMEGA) };
        let response = stack.response(WAVELENGTH, Incidence::from_angle(self.theta), self.polarisation);
        (response.reflectance, if self.is_clear() { response.transmittance } else { 0.0 })
    }

    /// The same on a grid with so many cells to the vacuum wavelength; films must be whole numbers of cells.
    ///
    /// One column with a Bloch phase holds the wave of fixed k_x; its pulse is so long that next to nothing of it is
    /// slower than light grazing the interface, which no absorber takes.
    pub fn on_grid(&self, cells: usize) -> (f64, f64) {
        let spacing = WAVELENGTH / cells as f64;
        let k_x = OMEGA / C * self.theta.sin();
        let film_rows: Vec<usize> =
            self.films.iter().map(|(thickness, _)| (thickness * cells as f64).round() as usize).collect();
        let incident = ABSORBER + 4;
        let face = incident + 4;
        let back = face + film_rows.iter().sum::<usize>();
        // Behind a metal as much of it as swallows what has entered.
        let rows = back + if self.is_clear() { 6 } else { cells } + ABSORBER;
        let height = |row: usize| row as f64 * spacing;
        let mut regions = vec![Region::layer(height(back)..height(rows), self.substrate)];
        let mut at = face;
        for (&(_, eps), &count) in self.films.iter().zip(&film_rows) {
            regions.push(Region::layer(height(at)..height(at + count), Medium::dielectric(eps)));
            at += count;
        }
        let to_flux: fn(f64) -> f64 = match self.polarisation {
            Polarisation::S => |_| 1.0,
            Polarisation::P => |eps| 1.0 / eps,
        };
        let vacuum = plane::Setup::vacuum([1, rows], spacing, self.polarisation, Stepping::at(COURANT));
        let mut grid = Plane::new(plane::Setup { regions, ..vacuum.bloch(k_x * spacing, ABSORBER) })
            .expect("a grid within all limits");
        let (pulse, duration) = self.pulse();
        grid.illuminate(incident, 1.0, pulse).expect("an open row");
        let returned = grid.probe([0, incident - 3]).expect("on the grid");
        let passed = grid.probe([0, back + 3]).expect("on the grid");
        let steps = (duration / grid.dt()).ceil() as u64;
        grid.run(steps).expect("some steps");
        let spectrum = |record: &[Complex64]| amplitude(record, grid.dt(), grid.dt(), OMEGA).norm_sqr();
        let sent = spectrum(&grid.incident().expect("a wave was sent"));
        let normal = |eps: f64| (eps - self.theta.sin().powi(2)).sqrt();
        let eps = self.substrate.eps_r;
        let through = if self.is_clear() { normal(eps) * to_flux(eps) / normal(1.0) } else { 0.0 };
        (spectrum(&grid.record(returned)) / sent, through * spectrum(&grid.record(passed)) / sent)
    }

    /// The pulse, and when all is over [s].
    fn pulse(&self) -> (Pulse, f64) {
        let spread = OMEGA * ((1.0 - self.theta.sin()) / 6.0).min(0.12);
        let width = spread.recip();
        let optical: f64 = self.films.iter().map(|(thickness, eps)| thickness * eps.sqrt()).sum();
        let delay = 6.0 * width;
        let pulse = Pulse::Modulated { frequency: C / WAVELENGTH, delay, width };
        (pulse, 2.0 * delay + (6.0 + 12.0 * optical) * WAVELENGTH / C)
    }
}

/// k [rad/m] of a wave of 1 m vacuum wavelength in a conductor of loss tangent `tau`, from the fields at two nodes of a
/// grid with `cells` cells to 1/|k|.
pub(super) fn wave_number_on_grid(tau: f64, cells: usize) -> Complex64 {
    const PATH: usize = 2;
    let reduced = exact_wave_number(tau).norm().recip();
    let spacing = reduced / cells as f64;
    let medium = Medium::conductor(1.0, tau * OMEGA * light::em::EPSILON_0);
    let depth = 3 * cells;
    let setup = LineSetup {
        background: medium,
        ..LineSetup::vacuum(depth + PATH * cells + 20 * cells, spacing, Ends::open(10), Stepping::at(0.5))
    };
    let mut line = Line::new(setup).expect("a line within all limits");
    let width = 3.0 / OMEGA;
    let pulse = Pulse::Modulated { frequency: C / WAVELENGTH, delay: 6.0 * width, width };
    line.inject(depth, 1.0, pulse).expect("a node of the line");
    let probes = [depth + cells, depth + (1 + PATH) * cells].map(|node| line.probe(node).expect("on the line"));
    let steps = (12.0 * width / line.dt()).ceil() as u64 + 40 * (depth + 20 * cells) as u64;
    line.run(steps).expect("some steps");
    let [near, far] = probes.map(|probe| {
        let record: Vec<Complex64> = line.record(probe).iter().map(|&e| e.into()).collect();
        amplitude(&record, line.dt(), line.dt(), OMEGA)
    });
    -Complex64::i() * (far / near).ln() / (PATH as f64 * reduced)
}

/// k [rad/m] of the same wave by E18.
pub(super) fn exact_wave_number(tau: f64) -> Complex64 {
    use light::waves::{Medium, Wave};
    let sigma = tau * OMEGA * light::waves::constants::EPSILON_0;
    let medium = Medium::relative(1.0, 1.0, sigma).expect("a physical medium");
    Wave::new(&medium, OMEGA).expect("a frequency").k
}
