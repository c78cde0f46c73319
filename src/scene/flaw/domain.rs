//! Which numbers are valid where.

use super::{Flaw, Part};
use crate::scene::Triple;
use std::fmt;

/// From one number to another.
#[derive(Clone, Copy, Debug)]
pub(super) struct Domain {
    least: f64,
    most: f64,
    unit: &'static str,
    /// Whether the ends are valid.
    ends: [bool; 2],
}

impl Domain {
    /// With both ends.
    pub(super) const fn new(least: f64, most: f64, unit: &'static str) -> Self {
        Self { least, most, unit, ends: [true; 2] }
    }

    /// Without the lower end.
    pub(super) const fn above(least: f64, most: f64, unit: &'static str) -> Self {
        Self { least, most, unit, ends: [false, true] }
    }

    /// Without the ends.
    pub(super) const fn between(least: f64, most: f64, unit: &'static str) -> Self {
        Self { least, most, unit, ends: [false; 2] }
    }

    /// Refuses a number outside, and what is none.
    pub(super) fn holds(&self, part: impl Into<Part>, value: f64) -> Result<(), Flaw> {
        let from = if self.ends[0] { value >= self.least } else { value > self.least };
        let to = if self.ends[1] { value <= self.most } else { value < self.most };
        match from && to {
            true => Ok(()),
            false => Err(Flaw::of(part, format!("{} is out of range; valid: {self}", Shown(value)))),
        }
    }

    /// The same of three.
    pub(super) fn holds_all(&self, part: impl Into<Part>, values: Triple) -> Result<(), Flaw> {
        let each = (0..3).try_for_each(|at| self.holds(at, values[at]));
        each.map_err(|flaw| flaw.within(part))
    }
}

impl fmt::Display for Domain {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let (least, most) = (Shown(self.least), Shown(self.most));
        match self.ends {
            [true, true] => write!(f, "{least} to {most}")?,
            [false, true] => write!(f, "above {least}, up to {most}")?,
            [_, false] => write!(f, "above {least}, below {most}")?,
        }
        if self.unit.is_empty() { Ok(()) } else { write!(f, " {}", self.unit) }
    }
}

/// A number as people write it: without a point if it is whole, with an exponent if it is large or small.
pub(super) struct Shown(pub(super) f64);

impl fmt::Display for Shown {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let size = self.0.abs();
        if self.0 == 0.0 || !size.is_finite() || (1e-4..1e6).contains(&size) {
            write!(f, "{}", self.0)
        } else {
            write!(f, "{:e}", self.0)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_belong_to_a_domain_where_it_says_so_and_no_nan_does() {
        let says = |domain: Domain, value| domain.holds("x", value).err().map(|flaw| flaw.to_string());
        let [closed, above, between] = [Domain::new, Domain::above, Domain::between].map(|of| of(0.0, 1e12, "m"));
        for (domain, low, high) in [(closed, true, true), (above, false, true), (between, false, false)] {
            assert_eq!([says(domain, 0.0).is_none(), says(domain, 1e12).is_none()], [low, high], "{domain}");
            assert_eq!(says(domain, 1.0), None);
            for bad in [f64::NAN, f64::INFINITY, -1.0, 2e12] {
                assert!(says(domain, bad).is_some(), "{domain} takes {bad}");
            }
        }
        assert_eq!(says(above, -0.5).unwrap(), "x: -0.5 is out of range; valid: above 0, up to 1e12 m");
        assert_eq!(
            says(Domain::between(0.0, 180.0, "deg"), 180.0).unwrap(),
            "x: 180 is out of range; valid: above 0, below 180 deg"
        );
        assert_eq!(says(Domain::new(0.0, 1.0, ""), f64::NAN).unwrap(), "x: NaN is out of range; valid: 0 to 1");
    }
}
