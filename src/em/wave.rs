//! Several ways to carry a wave along a periodic line of vacuum, for races: all start from the same travelling wave
//! E = f(z), Z₀H = f(z) and answer E at the nodes at the same moment, where d'Alembert's f(z − ct) is exact (E10).

use super::line::{Ends, Line, Setup};
use super::refusal::{Refusal, demand};
use super::{Stepping, Z_0};
use num_complex::Complex64;
use rustfft::{Fft, FftPlanner};
use std::f64::consts::{FRAC_PI_2, TAU};
use std::sync::Arc;

/// A way to solve the wave equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scheme {
    /// Centred differences of second order in space and time (Yee 1966).
    Yee,
    /// Staggered differences of fourth order in space (Fang 1989), a composition of fourth order in time (Yoshida 1990).
    FourthOrder,
    /// Derivatives through the spectrum (Liu 1997), staggered, and the same composition in time.
    PseudoSpectral,
    /// Every harmonic turned by its own phase (E13): exact for what the nodes resolve.
    Spectral,
    /// f(z − ct) itself (E10).
    DAlembert,
}

/// A travelling wave on a periodic line.
pub struct Problem<'a> {
    /// f [V/m] of z [m], 0 ≤ z < length.
    pub profile: &'a dyn Fn(f64) -> f64,
    /// Period of the line [m].
    pub length: f64,
    /// How far the wave is carried [m], ct ≥ 0.
    pub distance: f64,
}

/// What a scheme made of a problem.
#[derive(Clone, Debug, PartialEq)]
pub struct Carried {
    /// E [V/m] at z = kΔ, k = 0 … cells − 1.
    pub e: Vec<f64>,
    /// Cells times steps (1 step if none are taken).
    pub work: u64,
}

impl Scheme {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Yee, Self::FourthOrder, Self::PseudoSpectral, Self::Spectral, Self::DAlembert];

    /// Largest stable cΔt/Δ [1]. Leapfrog needs ωΔt ≤ 2 of the fastest wave the differences make, Yoshida's
    /// composition ωΔt ≤ 1.573; the fastest has ωΔ/c = 2, 7/3 or π.
    pub fn courant_limit(self) -> f64 {
        match self {
            Self::Yee => 1.0,
            Self::FourthOrder => 1.573 * 3.0 / 7.0,
            Self::PseudoSpectral => 1.573 / std::f64::consts::PI,
            Self::Spectral | Self::DAlembert => f64::INFINITY,
        }
    }

    /// Carries the wave on `cells` ≥ 4 cells with steps of at most cΔt/Δ = `courant`, shortened to end on time.
    ///
    /// # Errors
    /// Too few cells, a Courant number beyond [`Self::courant_limit`], lengths that are not positive.
    pub fn carry(self, problem: &Problem, cells: usize, courant: f64) -> Result<Carried, Refusal> {
        demand((4..=1 << 26).contains(&cells), "number of cells", cells as f64, "4 to 67108864")?;
        demand(problem.length > 0.0 && problem.length.is_finite(), "length", problem.length, "finite and above 0 m")?;
        let distance = problem.distance;
        demand(distance >= 0.0 && distance.is_finite(), "distance", distance, "finite and at least 0 m")?;
        demand(courant > 0.0, "Courant number", courant, "above 0")?;
        let limit = self.courant_limit();
        if courant > limit {
            return Err(Refusal::Unstable { courant, limit });
        }
        let spacing = problem.length / cells as f64;
        let far = (distance / spacing).is_finite();
        demand(far, "distance", distance, "a finite number of cells")?;
        let stepped = !matches!(self, Self::Spectral | Self::DAlembert);
        let needed = if stepped { distance / (courant * spacing) } else { 1.0 };
        demand(needed < 1e12, "number of steps", needed, "below 1e12")?;
        let steps = (needed.ceil() as u64).max(1);
        let courant = distance / (steps as f64 * spacing);
        let start = |shift: f64| -> Vec<f64> { (0..cells).map(|k| problem.at((k as f64 + shift) * spacing)).collect() };
        let e = match self {
            _ if distance == 0.0 => start(0.0),
            Self::Yee => yee(problem, cells, courant, steps)?,
            Self::FourthOrder => compose(start(0.0), start(0.5), courant, steps, &mut Fourth),
            Self::PseudoSpectral => compose(start(0.0), start(0.5), courant, steps, &mut Spectrum::new(cells)),
            Self::Spectral => Spectrum::new(cells).turn(&start(0.0), distance / spacing),
            Self::DAlembert => start(-distance / spacing),
        };
        Ok(Carried { e, work: steps.saturating_mul(cells as u64) })
    }
}

impl Problem<'_> {
    fn at(&self, z: f64) -> f64 {
        (self.profile)(z.rem_euclid(self.length))
    }

    /// E [V/m] at the nodes as it must be (E10).
    pub fn exact(&self, cells: usize) -> Vec<f64> {
        let spacing = self.length / cells as f64;
        (0..cells).map(|k| self.at(k as f64 * spacing - self.distance)).collect()
    }
}

fn yee(problem: &Problem, cells: usize, courant: f64, steps: u64) -> Result<Vec<f64>, Refusal> {
    let spacing = problem.length / cells as f64;
    let mut line = Line::new(Setup::vacuum(cells, spacing, Ends::Periodic, Stepping::at(courant)))?;
    // H starts half a step later, when the wave has moved on.
    line.set(|z| problem.at(z), |z| problem.at(z - 0.5 * courant * spacing) / Z_0);
    line.run(steps)?;
    Ok(line.e()[..cells].to_vec())
}

/// A staggered derivative along the line, times the spacing.
trait Derivative {
    /// `out`[k] += `factor` × the difference of `f` about k − ½ (`f` at whole, `out` at half places: `forward`) or the
    /// other way round.
    fn add(&mut self, f: &[f64], out: &mut [f64], factor: f64, forward: bool);
}

/// Yoshida, *Phys. Lett. A* **150**, 262 (1990): three leapfrog steps, the middle one backwards, make one of fourth order.
fn compose(mut e: Vec<f64>, mut h: Vec<f64>, courant: f64, steps: u64, derivative: &mut impl Derivative) -> Vec<f64> {
    let outer = 1.0 / (2.0 - 2f64.cbrt());
    let inner = 1.0 - 2.0 * outer;
    for _ in 0..steps {
        for (of_h, of_e) in [(0.5 * outer, outer), (0.5 * (outer + inner), inner), (0.5 * (outer + inner), outer)] {
            derivative.add(&e, &mut h, -courant * of_h, true);
            derivative.add(&h, &mut e, -courant * of_e, false);
        }
        derivative.add(&e, &mut h, -courant * 0.5 * outer, true);
    }
    e
}

/// (27 (f(½) − f(−½)) − (f(3/2) − f(−3/2)))/24.
struct Fourth;

impl Derivative for Fourth {
    fn add(&mut self, f: &[f64], out: &mut [f64], factor: f64, forward: bool) {
        let n = f.len();
        let (near, far) = (factor * 27.0 / 24.0, -factor / 24.0);
        // Forward, the place k + ½ lies between k and k + 1; backward, k lies between k − ½ and k + ½.
        let shift = usize::from(forward);
        let at = |k: usize, by: usize| f[(k + n + by + shift - 2) % n];
        let wrapped = |k: usize| near * (at(k, 2) - at(k, 1)) + far * (at(k, 3) - at(k, 0));
        for k in [0, 1, n - 2, n - 1] {
            out[k] += wrapped(k);
        }
        let first = shift;
        let inner = &mut out[2..n - 2];
        let count = inner.len();
        let [a, b, c, d] = [0, 1, 2, 3].map(|by| &f[first + by..first + by + count]);
        for k in 0..count {
            inner[k] += near * (c[k] - b[k]) + far * (d[k] - a[k]);
        }
    }
}

/// Transforms of one length.
struct Spectrum {
    forward: Arc<dyn Fft<f64>>,
    back: Arc<dyn Fft<f64>>,
    values: Vec<Complex64>,
    scratch: Vec<Complex64>,
}

impl Spectrum {
    fn new(cells: usize) -> Self {
        let mut planner = FftPlanner::new();
        let (forward, back) = (planner.plan_fft_forward(cells), planner.plan_fft_inverse(cells));
        let scratch = forward.get_inplace_scratch_len().max(back.get_inplace_scratch_len());
        let zero = Complex64::default();
        Self { forward, back, values: vec![zero; cells], scratch: vec![zero; scratch] }
    }

    /// Multiplies the spectrum of the real `f` by `factor(kΔ)`, kΔ = 0 … π [rad]; negative k by its conjugate.
    fn filter(&mut self, f: &[f64], factor: impl Fn(f64) -> Complex64) {
        let n = f.len();
        for (value, f) in self.values.iter_mut().zip(f) {
            *value = Complex64::from(f);
        }
        self.forward.process_with_scratch(&mut self.values, &mut self.scratch);
        let share = 1.0 / n as f64;
        for k in 0..=n / 2 {
            let factor = factor(TAU * k as f64 * share) * share;
            // The wave that alternates from node to node has no sign of k: only what keeps it real can be kept.
            let factor = if 2 * k == n { factor.re.into() } else { factor };
            self.values[k] *= factor;
            if k > 0 && 2 * k != n {
                self.values[n - k] *= factor.conj();
            }
        }
        self.back.process_with_scratch(&mut self.values, &mut self.scratch);
    }

    /// f moved by `cells` to the right.
    fn turn(&mut self, f: &[f64], cells: f64) -> Vec<f64> {
        let n = f.len() as f64;
        // Whole turns of the line change nothing and would cost digits of the phase.
        let cells = cells % n;
        self.filter(f, |k| Complex64::cis(-k * cells));
        self.values.iter().map(|value| value.re).collect()
    }
}

impl Derivative for Spectrum {
    fn add(&mut self, f: &[f64], out: &mut [f64], factor: f64, forward: bool) {
        let half = if forward { 0.5 } else { -0.5 };
        // ik e^(±ikΔ/2): the derivative half a cell on.
        self.filter(f, |k| Complex64::from_polar(factor * k, k * half + FRAC_PI_2));
        for (out, value) in out.iter_mut().zip(&self.values) {
            *out += value.re;
        }
    }
}
