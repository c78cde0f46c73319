//! What of a polygon is above the receiver's horizon, and Lambert's sum over its edges.
//!
//! The terms of ½ Σ γ n·(u × v)/|u × v| cancel: for a far polygon because neighbouring edges nearly undo each other, near
//! the horizon because all do. They are taken with twice the digits, and with Σ u × v written by the differences of
//! directions, which for a far polygon are as small as it is:
//!
//! E/L = ½ n·Σ (u − u₀) × (v − u₀) + ½ Σ (γ/sin γ − 1) n·(u × v).
//!
//! Where even that leaves too little, all edges are low, and what remains is ½ Σ ∫ T²/(1 + T²) dφ, T the tangent of the
//! height above the horizon: the sum of areas between edges and horizon, projected.

use super::checked::Polygon;
use super::wide::WideVector;
use crate::wide::Wide;
use std::sync::LazyLock;
use yardstick::quadrature::gauss_legendre;

/// A corner above the horizon, or on it.
#[derive(Clone, Copy)]
struct Corner {
    at: WideVector,
    distance: Wide,
    height: Wide,
}

impl Corner {
    fn new(at: WideVector, height: Wide) -> Self {
        Self { at, distance: at.norm(), height }
    }

    /// The tangent of the height above the horizon.
    fn tangent(&self) -> f64 {
        let level = (self.distance - self.height) * (self.distance + self.height);
        f64::from(self.height / level.sqrt())
    }

    /// u − u₀ of two directions.
    fn turned_from(&self, first: &Self) -> WideVector {
        let apart = self.at.minus(first.at);
        // The difference of the distances from that of their squares.
        let farther = apart.dot(self.at.plus(first.at)) / (self.distance + first.distance);
        apart.minus(first.at.times(farther / first.distance)).times(Wide::from(1.0) / self.distance)
    }
}

/// The polygon above the horizon.
pub(super) struct Clipped {
    corners: Vec<Corner>,
    normal: WideVector,
}

impl Clipped {
    /// By I. E. Sutherland and G. W. Hodgman, *Comm. ACM* 17 (1974) 32: one closed chain, whatever the number of pieces.
    pub(super) fn new(polygon: &Polygon) -> Self {
        let normal = polygon.normal;
        let whole: Vec<(WideVector, Wide)> = polygon
            .corners
            .iter()
            .map(|&corner| WideVector::from(corner))
            .map(|corner| (corner, corner.dot(normal)))
            .collect();
        let mut corners = Vec::with_capacity(whole.len() + 1);
        for (at, &(here, height)) in whole.iter().enumerate() {
            let (there, other) = whole[(at + 1) % whole.len()];
            let (is_up, is_other_up) = (f64::from(height) >= 0.0, f64::from(other) >= 0.0);
            if is_up {
                corners.push(Corner::new(here, height));
            }
            if is_up != is_other_up {
                let share = height / (height - other);
                let crossing = here.plus(there.minus(here).times(share));
                corners.push(Corner::new(crossing, Wide::from(0.0)));
            }
        }
        Self { corners, normal }
    }

    fn pairs(&self) -> impl Iterator<Item = (&Corner, &Corner)> {
        self.corners.iter().zip(self.corners.iter().cycle().skip(1))
    }

    /// E/L [sr], negative if the corners run clockwise as seen from the receiver.
    pub(super) fn irradiance(&self) -> f64 {
        let Some(first) = self.corners.first() else { return 0.0 };
        let (mut sum, mut size) = (Wide::from(0.0), 0.0);
        for (here, there) in self.pairs() {
            let chords = here.turned_from(first).cross(there.turned_from(first)).dot(self.normal);
            let bent = bent(here, there, self.normal);
            sum = sum + chords + bent;
            size += f64::from(chords).abs() + f64::from(bent).abs();
        }
        let total = 0.5 * f64::from(sum);
        if total.abs() > KEPT * size {
            return total;
        }
        let (low, low_size) = self.low();
        // Whichever has lost less in rounding.
        if f64::EPSILON * low_size < f64::EPSILON * f64::EPSILON * size { low } else { total }
    }

    /// The same where all edges are low, and the sum of its terms' sizes.
    fn low(&self) -> (f64, f64) {
        let strip = |(here, there): (&Corner, &Corner)| {
            let across = f64::from(here.at.cross(there.at).dot(self.normal));
            let along = f64::from(here.at.dot(there.at) - here.height * there.height);
            let turn = across.atan2(along);
            if turn == 0.0 { 0.0 } else { -0.5 * turn * mean_square(here.tangent(), there.tangent(), turn) }
        };
        self.pairs().map(strip).fold((0.0, 0.0), |(sum, size), strip| (sum + strip, size + strip.abs()))
    }
}

/// What of a sum with twice the digits must be left for it to have all digits of `f64` [1].
const KEPT: f64 = 1e-13;

/// (γ/sin γ − 1) n·(u × v).
fn bent(here: &Corner, there: &Corner, normal: WideVector) -> Wide {
    let across = here.at.cross(there.at);
    let (size, along) = (across.norm(), here.at.dot(there.at));
    let product = here.distance * there.distance;
    if f64::from(size) == 0.0 {
        return Wide::from(0.0);
    }
    let sin = size / product;
    across.dot(normal) / product * excess(sin, || Wide::atan2(size, along), f64::from(along) > 0.0)
}

/// γ/sin γ − 1, for a small acute γ by the series of the arc sine.
fn excess(sin: Wide, angle: impl Fn() -> Wide, is_acute: bool) -> Wide {
    if !is_acute || f64::from(sin) > 0.1 {
        return angle() / sin - Wide::from(1.0);
    }
    let square = sin * sin;
    // 16 terms: the next is below 0.1³² of the first.
    (1..=16).rev().fold(Wide::from(0.0), |sum, n| {
        let odd = Wide::from(f64::from(2 * n - 1));
        let next = odd * odd / Wide::from(f64::from(2 * n * (2 * n + 1)));
        square * next * (Wide::from(1.0) + sum)
    })
}

/// The mean over an edge's azimuth of T²/(1 + T²), whose T runs from one tangent to another over an angle `turn`.
fn mean_square(from: f64, to: f64, turn: f64) -> f64 {
    static RULE: LazyLock<Vec<(f64, f64)>> = LazyLock::new(|| gauss_legendre(24));
    let sin = turn.sin();
    let square = |&(at, weight): &(f64, f64)| {
        let tangent = (from * ((1.0 - at) * turn).sin() + to * (at * turn).sin()) / sin;
        weight * (tangent * tangent / (1.0 + tangent * tangent))
    };
    RULE.iter().map(square).sum()
}
