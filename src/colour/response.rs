//! What a channel of a picture means, in wavelengths.
//!
//! A renderer of three channels takes radiances and reflectances to be constant over what a channel sees. What it sees is
//! r_c(λ): a row of the sRGB matrix times the observer's x̄, ȳ, z̄, times daylight, so that white paper in white light is (1, 1, 1).
//! Where an index depends on the wavelength, the channel c is ∫r_c L dλ. The r_c have parts below 0: no single wavelength
//! but is outside what a screen can show, and what is too little in one channel is too much in another until many wavelengths
//! add up to a colour.

use super::{STEP, daylight, matching, srgb};
use crate::sampling::Shares;
use std::sync::LazyLock;

/// The ends of what is seen [m]: beyond them lie 5e-5 of X, 4e-6 of Y and 2e-4 of Z of daylight, and some media are not known.
pub const BAND: [f64; 2] = [380e-9, 760e-9];

/// Nodes of the tables, [`STEP`] apart.
const NODES: usize = 77;

/// The responses of the three channels, and how wavelengths are drawn.
#[derive(Clone, Debug)]
pub struct Response {
    /// r_c [m⁻¹] at the nodes; between them, straight.
    nodes: Vec<[f64; 3]>,
    /// ∫Σ|r_c| from node to node.
    shares: Shares,
}

/// A wavelength that was drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drawn {
    /// In vacuum [m].
    pub wavelength: f64,
    /// r_c over its density [1]: 1 on average in every channel.
    pub weight: [f64; 3],
}

/// The one there is.
pub fn response() -> &'static Response {
    static RESPONSE: LazyLock<Response> = LazyLock::new(Response::new);
    &RESPONSE
}

impl Response {
    fn new() -> Self {
        let matrix = srgb();
        let at = |k: usize| BAND[0] + STEP * k as f64;
        // The nodes are those of the CIE's tables; a rounding beside one changes nothing that can be seen.
        let seen = |k: usize| matching(at(k)).map(|part| part * daylight(at(k)));
        let raw: Vec<[f64; 3]> = (0..NODES).map(|k| matrix.map(|row| super::dot(row, seen(k)))).collect();
        let whole: [f64; 3] =
            std::array::from_fn(|c| raw.windows(2).map(|ends| 0.5 * (ends[0][c] + ends[1][c]) * STEP).sum());
        let nodes: Vec<[f64; 3]> = raw.iter().map(|row| std::array::from_fn(|c| row[c] / whole[c])).collect();
        let size = |row: &[f64; 3]| row.iter().map(|r| r.abs()).sum::<f64>();
        let shares = Shares::new(nodes.windows(2).map(|ends| 0.5 * (size(&ends[0]) + size(&ends[1])) * STEP));
        Self { nodes, shares: shares.expect("an eye that sees") }
    }

    /// r_c [m⁻¹] at a wavelength [m]; 0 outside [`BAND`].
    pub fn at(&self, wavelength: f64) -> [f64; 3] {
        let place = (wavelength - BAND[0]) / STEP;
        if !(place >= 0.0 && place <= (NODES - 1) as f64) {
            return [0.0; 3];
        }
        let first = (place as usize).min(NODES - 2);
        self.between(first, place - first as f64)
    }

    fn between(&self, first: usize, part: f64) -> [f64; 3] {
        let (a, b) = (self.nodes[first], self.nodes[first + 1]);
        std::array::from_fn(|c| a[c] + (b[c] - a[c]) * part)
    }

    /// The wavelength that belongs to a number 0 ≤ u < 1: from node to node by Σ|r_c|, and evenly in between.
    pub fn draw(&self, u: f64) -> Drawn {
        let (interval, part) = self.shares.pick(u);
        let density = self.shares.share(interval) / STEP;
        let weight = self.between(interval, part).map(|r| r / density);
        Drawn { wavelength: BAND[0] + STEP * (interval as f64 + part), weight }
    }

    /// ∫r_c f dλ of a function of the wavelength [m], by Simpson's rule between nodes: f is taken where it is smooth.
    pub fn mean(&self, of: impl Fn(f64) -> f64) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for first in 0..NODES - 1 {
            for (part, weight) in [(0.0, 1.0 / 6.0), (0.5, 4.0 / 6.0), (1.0, 1.0 / 6.0)] {
                let value = of(BAND[0] + STEP * (first as f64 + part)) * weight * STEP;
                let seen = self.between(first, part);
                sum = std::array::from_fn(|c| sum[c] + seen[c] * value);
            }
        }
        sum
    }
}
