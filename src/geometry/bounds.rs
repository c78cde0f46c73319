//! Boxes along the axes.

use crate::scene::Triple;

/// The least box along the axes that holds what it is of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The least corner [m].
    pub low: Triple,
    /// The largest [m].
    pub high: Triple,
}

impl Bounds {
    /// Of nothing: any union with it is the other.
    pub const NOTHING: Self = Self { low: [f64::INFINITY; 3], high: [f64::NEG_INFINITY; 3] };

    /// Of points.
    pub fn of(points: impl IntoIterator<Item = Triple>) -> Self {
        points.into_iter().fold(Self::NOTHING, |all, point| all.union(&Self { low: point, high: point }))
    }

    /// Of both.
    #[inline]
    pub fn union(&self, other: &Self) -> Self {
        Self {
            low: std::array::from_fn(|axis| self.low[axis].min(other.low[axis])),
            high: std::array::from_fn(|axis| self.high[axis].max(other.high[axis])),
        }
    }

    /// The largest |coordinate| [m] in it; 0 of nothing.
    pub fn reach(&self) -> f64 {
        let far = self.low.map(|low| -low).into_iter().chain(self.high);
        far.fold(0.0, f64::max)
    }
}
