//! Rough surfaces as they are: heights, facets, and light that runs among them (C16 by brute force).
//!
//! A microfacet model knows how slopes are spread and guesses the rest: who stands in whose shadow, where light goes that
//! a facet throws at its neighbour. A relief guesses nothing. It is a periodic field of heights with two triangles to a
//! cell, a perfect mirror everywhere, and each ray is followed until it leaves. Lengths are in cells.

mod facet;
mod pyramid;
mod refusal;
mod synthesis;
#[cfg(test)]
mod tests;
mod trace;

pub use trace::{Fate, MOST_STEPS, Path};

use facet::Facet;
use pyramid::Pyramid;
use refusal::only_if;

use crate::waves::plane::Invalid;

/// Heights [cells] on a square grid, continued periodically.
#[derive(Clone, Debug)]
pub struct Relief {
    side: usize,
    heights: Vec<f64>,
    pyramid: Pyramid,
}

impl Relief {
    /// The least and the most cells a side may have; a power of two.
    pub const SIDES: (usize, usize) = (2, 8192);

    /// Of `side`² heights, row by row, within ±10¹² cells.
    pub fn new(side: usize, heights: Vec<f64>) -> Result<Self, Invalid> {
        let side = refusal::side(side)?;
        only_if(heights.len() == side * side, "heights", heights.len() as f64, "as many as the side's square")?;
        for &height in &heights {
            only_if(height.abs() <= Self::HIGHEST, "heights", height, "within ±1e12 cells")?;
        }
        Ok(Self { side, pyramid: Pyramid::over(side, &heights), heights })
    }

    /// Beyond this height [cells] a ray's place would lose the digits that tell neighbours apart.
    const HIGHEST: f64 = 1e12;

    /// Without roughness: a plane mirror.
    pub fn flat(side: usize) -> Result<Self, Invalid> {
        Self::new(refusal::side(side)?, vec![0.0; side * side])
    }

    /// How many cells a side has.
    pub fn side(&self) -> usize {
        self.side
    }

    /// The heights [cells], row by row.
    pub fn heights(&self) -> &[f64] {
        &self.heights
    }

    /// The highest height [cells]: a ray above it that does not fall has left.
    pub fn top(&self) -> f64 {
        self.pyramid.top()
    }

    /// The slopes (∂z/∂x, ∂z/∂y) [1] of all 2 · side² facets: all have the same area below, so these are even draws.
    pub fn slopes(&self) -> impl Iterator<Item = [f64; 2]> {
        let cells = (0..self.side * self.side).map(|at| [(at % self.side) as isize, (at / self.side) as isize]);
        cells.flat_map(|cell| self.facets(cell)).map(|facet| facet.slope)
    }

    /// ⟨s_x² + s_y²⟩ [1] over the facets: α² of a Beckmann distribution.
    pub fn mean_square_slope(&self) -> f64 {
        let sum: f64 = self.slopes().map(|[x, y]| x * x + y * y).sum();
        sum / (2 * self.side * self.side) as f64
    }

    /// How far [1] the distribution of the facets' steepness √(s_x² + s_y²) is from `cdf`, at the worst (Kolmogorov).
    /// NaN where `cdf` is.
    pub fn distance(&self, cdf: impl Fn(f64) -> f64) -> f64 {
        let mut steepness: Vec<f64> = self.slopes().map(|[x, y]| x.hypot(y)).collect();
        steepness.sort_by(f64::total_cmp);
        let count = steepness.len() as f64;
        let gap = |(at, &slope): (usize, &f64)| {
            let place = cdf(slope);
            (place - at as f64 / count).max((at + 1) as f64 / count - place)
        };
        steepness.iter().enumerate().map(gap).max_by(f64::total_cmp).unwrap_or(f64::NAN)
    }

    /// The height at the grid point (x, y), wherever that lies.
    fn height(&self, [x, y]: [isize; 2]) -> f64 {
        // The side is a power of two: its remainder is a mask, for negative numbers too.
        let mask = self.side - 1;
        self.heights[(y as usize & mask) * self.side + (x as usize & mask)]
    }

    /// The two triangles of the cell from (x, y) to (x + 1, y + 1): below the diagonal between these, and above it.
    fn facets(&self, [x, y]: [isize; 2]) -> [Facet; 2] {
        let [near, right, up, far] = [[x, y], [x + 1, y], [x, y + 1], [x + 1, y + 1]].map(|point| self.height(point));
        [
            Facet { height: near, slope: [right - near, far - right] },
            Facet { height: near, slope: [far - up, up - near] },
        ]
    }
}
