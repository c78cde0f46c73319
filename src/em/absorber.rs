//! Open space at the edge of a grid: the convolutional perfectly matched layer.
//!
//! J. A. Roden & S. D. Gedney, *Microw. Opt. Technol. Lett.* **27**, 334 (2000); T&H §7.9. In the layer every derivative
//! along its normal is divided by s = κ + σ/(a + iωε₀) (engineers' sign), in time a convolution that one number ψ per
//! derivative carries along: ψ′ = b ψ + c d, with b = e^(−(σ/κ + a)Δt/ε₀) and c = σ(b − 1)/(κ(σ + κa)).
//! s is relative to ε₀ in any medium, so that a wave in one of index n decays as σ n Z₀. Behind it stands a conductor.
//! σ and κ − 1 rise as the power `order` of the depth, a falls linearly.

use super::refusal::{Refusal, demand};
use super::{EPSILON_0, Z_0};

/// A perfectly matched layer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cpml {
    /// Its thickness [cells], ≥ 1.
    pub cells: usize,
    /// Power of the grading [1], 1 to 8.
    pub order: f64,
    /// Reflection at normal incidence that the graded conductivity would have without the grid's own error [1],
    /// 1e−30 to 1, in what stands in the middle of its side: a layer has one grading from end to end, and beside a
    /// medium of m times that index reflects the m-th power.
    pub reflection: f64,
    /// κ at the outer wall [1], ≥ 1: takes up evanescent waves.
    pub kappa: f64,
    /// a at the inner edge [S/m], ≥ 0: takes up low frequencies; 0 for none.
    pub alpha: f64,
}

impl Cpml {
    /// A layer of this thickness [cells] for travelling waves: with 20 cells a wavelength, 30 cells reflect less than
    /// 1e−6 of the amplitude up to 45°.
    pub const fn thick(cells: usize) -> Self {
        Self { cells, order: 4.0, reflection: 1e-12, kappa: 1.0, alpha: 0.0 }
    }

    pub(super) fn check(&self) -> Result<(), Refusal> {
        demand(self.cells >= 1, "thickness of the absorber", self.cells as f64, "at least 1 cell")?;
        demand((1.0..=8.0).contains(&self.order), "order of the absorber's grading", self.order, "1 to 8")?;
        let reflection = self.reflection;
        demand((1e-30..1.0).contains(&reflection), "reflection of the absorber", reflection, "1e−30 to below 1")?;
        demand(self.kappa >= 1.0 && self.kappa.is_finite(), "κ of the absorber", self.kappa, "finite and at least 1")?;
        demand(
            self.alpha >= 0.0 && self.alpha.is_finite(),
            "a of the absorber",
            self.alpha,
            "finite and at least 0 S/m",
        )
    }

    /// At a `depth` [cells] below the inner edge, in a medium of `index` √(ε_r μ_r).
    fn grade(&self, depth: f64, spacing: f64, dt: f64, index: f64) -> Grade {
        let share = (depth / self.cells as f64).clamp(0.0, 1.0);
        let thickness = self.cells as f64 * spacing;
        let largest = -(self.order + 1.0) * self.reflection.ln() / (2.0 * Z_0 * index * thickness);
        let sigma = largest * share.powf(self.order);
        let kappa = 1.0 + (self.kappa - 1.0) * share.powf(self.order);
        let alpha = self.alpha * (1.0 - share);
        let exponent = (sigma / kappa + alpha) * dt / EPSILON_0;
        let c = if sigma > 0.0 { sigma * f64::exp_m1(-exponent) / (kappa * (sigma + kappa * alpha)) } else { 0.0 };
        Grade { b: (-exponent).exp(), c, k: 1.0 / kappa - 1.0 }
    }
}

/// ψ′ = b ψ + c d; the derivative becomes d + ψ′ + k d.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Grade {
    pub b: f64,
    pub c: f64,
    pub k: f64,
}

/// What stands at an end of an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Wall {
    /// A perfect electric conductor: no tangential E.
    Conductor,
    /// Open space: a matched layer inside the grid, and a conductor behind it.
    Open(Cpml),
}

impl Wall {
    pub(super) fn thickness(&self) -> usize {
        match self {
            Self::Conductor => 0,
            Self::Open(cpml) => cpml.cells,
        }
    }

    /// Refuses a layer that is not one.
    pub(super) fn check(&self) -> Result<(), Refusal> {
        match self {
            Self::Conductor => Ok(()),
            Self::Open(cpml) => cpml.check(),
        }
    }
}

/// The graded part of an axis at one end, for components at whole or at half cells.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Strip {
    /// First component in it.
    pub start: usize,
    pub b: Vec<f64>,
    pub c: Vec<f64>,
    pub k: Vec<f64>,
}

impl Strip {
    pub fn range(&self) -> std::ops::Range<usize> {
        self.start..self.start + self.b.len()
    }

    pub fn grades(&self) -> [&[f64]; 3] {
        [&self.b, &self.c, &self.k]
    }

    /// The grade of a component, if the strip holds it.
    pub fn at(&self, i: usize) -> Option<Grade> {
        let inner = i.checked_sub(self.start).filter(|inner| *inner < self.b.len())?;
        Some(Grade { b: self.b[inner], c: self.c[inner], k: self.k[inner] })
    }
}

/// The strips of both ends of an axis.
#[derive(Clone, Debug, PartialEq, Default)]
pub(super) struct Strips {
    /// For components at i, i = 0 … cells.
    pub whole: Vec<Strip>,
    /// For components at i + ½, i = 0 … cells − 1.
    pub half: Vec<Strip>,
}

impl Strips {
    /// For an axis of `cells`; `index` [1] is √(ε_r μ_r) of what stands at each end.
    pub fn new(walls: [Wall; 2], cells: usize, spacing: f64, dt: f64, index: [f64; 2]) -> Self {
        let mut strips = Self::default();
        for (end, wall) in walls.into_iter().enumerate() {
            let Wall::Open(cpml) = wall else { continue };
            let thick = cpml.cells;
            let depth = |position: f64| {
                let from_wall = if end == 0 { position } else { cells as f64 - position };
                thick as f64 - from_wall
            };
            let strip = |start: usize, count: usize, shift: f64| {
                let grade = |i: usize| cpml.grade(depth(i as f64 + shift), spacing, dt, index[end]);
                let grades: Vec<Grade> = (start..start + count).map(grade).collect();
                let column = |of: fn(&Grade) -> f64| grades.iter().map(of).collect();
                Strip { start, b: column(|g| g.b), c: column(|g| g.c), k: column(|g| g.k) }
            };
            // The component on the wall itself is never stepped, the one on the inner edge is not graded.
            let (whole, half) = if end == 0 { (1, 0) } else { (cells + 1 - thick, cells - thick) };
            if thick > 1 {
                strips.whole.push(strip(whole, thick - 1, 0.0));
            }
            strips.half.push(strip(half, thick, 0.5));
        }
        strips
    }
}
