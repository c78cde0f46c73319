//! Named quantities with a unit and a stated domain.

use super::dimension::Dimension;
use std::borrow::Cow;
use std::hash::{Hash, Hasher};

/// Whether a quantity has a direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Rank {
    /// A number.
    Scalar,
    /// An arrow in space, or a field of arrows.
    Vector,
}

/// Where a scalar symbol is sampled: a box in the complex plane, in SI units. An interval on the real axis
/// has a height of zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Domain {
    /// Least and largest real part.
    pub re: (f64, f64),
    /// Least and largest imaginary part.
    pub im: (f64, f64),
}

impl Domain {
    /// Whether 0 is outside.
    pub fn excludes_zero(self) -> bool {
        [self.re, self.im].into_iter().any(|(min, max)| min > 0.0 || max < 0.0)
    }
}

/// A named quantity. Its name is its identity: one name means one quantity within an equation or a chain.
///
/// A name is a letter or the English name of a Greek letter, then optionally `_` and an index, then primes:
/// `n_1`, `theta_1`, `r_s`, `E_1'`, `L_in`, `Phi`.
#[derive(Clone, Debug, PartialEq)]
pub struct Symbol {
    name: Cow<'static, str>,
    dimension: Dimension,
    rank: Rank,
    domain: Domain,
    is_field: bool,
}

impl Symbol {
    /// A scalar. Until said otherwise it is sampled with a real part in 0.25..1.25 and an imaginary part within ±0.25.
    pub const fn scalar(name: &'static str, dimension: Dimension) -> Self {
        let domain = Domain { re: (0.25, 1.25), im: (-0.25, 0.25) };
        Self { name: Cow::Borrowed(name), dimension, rank: Rank::Scalar, domain, is_field: false }
    }

    /// A vector.
    pub const fn vector(name: &'static str, dimension: Dimension) -> Self {
        let mut symbol = Self::scalar(name, dimension);
        symbol.rank = Rank::Vector;
        symbol
    }

    /// The same quantity as a field: it depends on position (x, y, z) and time (t). Any other symbol is a constant to
    /// a derivative by another.
    pub const fn field(mut self) -> Self {
        self.is_field = true;
        self
    }

    /// The same quantity between `min` and `max`, real only: for equations that hold on the real axis alone.
    pub const fn real(mut self, min: f64, max: f64) -> Self {
        self.domain = Domain { re: (min, max), im: (0.0, 0.0) };
        self
    }

    /// The same quantity with a real part between `min` and `max`, sampled on the axis and off it by up to a
    /// quarter of the interval's length: for equations that are analytic.
    pub const fn within(mut self, min: f64, max: f64) -> Self {
        let height = (max - min) / 4.0;
        self.domain = Domain { re: (min, max), im: (-height, height) };
        self
    }

    /// The same quantity in a box of the complex plane.
    pub const fn complex(mut self, re: (f64, f64), im: (f64, f64)) -> Self {
        self.domain = Domain { re, im };
        self
    }

    /// The same quantity under another name, built at run time (`n_3` of a stack).
    pub fn named(mut self, name: impl Into<Cow<'static, str>>) -> Self {
        self.name = name.into();
        self
    }

    /// Its name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Its SI dimension.
    pub fn dimension(&self) -> Dimension {
        self.dimension
    }

    /// Scalar or vector.
    pub fn rank(&self) -> Rank {
        self.rank
    }

    /// Whether it depends on position and time.
    pub fn is_field(&self) -> bool {
        self.is_field
    }

    /// Where it is sampled.
    pub fn domain(&self) -> Domain {
        self.domain
    }
}

impl Hash for Symbol {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.name.hash(state);
    }
}
