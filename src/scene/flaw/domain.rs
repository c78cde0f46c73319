//! Which numbers are valid where.

use super::{Flaw, Part};
use crate::bsdf::microfacet::LEAST_ALPHA;
use crate::bsdf::{INDEX, METAL_INDEX};
use crate::scene::Triple;
use std::fmt;

/// From one number to another; shown as `above 0, up to 1e12 m`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Domain {
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

/// Lengths beyond that [m] are mistakes: light takes an hour for it.
pub(super) const FAR: f64 = 1e12;
/// The most of a power's density, in any of its units: the square of a sum of it is still a single number.
const BRIGHT: f64 = 1e15;

/// Reflectance, and whatever else is a share [1].
pub const SHARE: Domain = Domain::new(0.0, 1.0, "");
/// A coordinate of a place [m].
pub const COORDINATE: Domain = Domain::new(-FAR, FAR, "m");
/// A component of a direction, which has any length that can be told from 0 and from infinity.
pub const DIRECTION: Domain = Domain::new(-FAR, FAR, "");
/// A length that is there [m].
pub const LENGTH: Domain = Domain::above(0.0, FAR, "m");
/// The radius of a lens [m]; 0 is a pinhole.
pub const APERTURE: Domain = Domain::new(0.0, FAR, "m");
/// The full angle that a picture is high [deg].
pub const FIELD_OF_VIEW: Domain = Domain::between(0.0, 180.0, "deg");
/// A channel of radiance [W m⁻² sr⁻¹].
pub const RADIANCE: Domain = Domain::new(0.0, BRIGHT, "W m⁻² sr⁻¹");
/// A factor [1] of light.
pub const FACTOR: Domain = Domain::new(0.0, BRIGHT, "");
/// Squares of a pattern along a side [1].
pub const SQUARES: Domain = Domain::above(0.0, 1e6, "");
/// A place on an image [1]; beyond 0 to 1 it is repeated.
pub const PLACE: Domain = Domain::new(-1e6, 1e6, "");
/// A channel of intensity [W sr⁻¹].
pub const INTENSITY: Domain = Domain::new(0.0, BRIGHT, "W sr⁻¹");
/// A channel of irradiance [W m⁻²].
pub const IRRADIANCE: Domain = Domain::new(0.0, BRIGHT, "W m⁻²");
/// Roughness of facets [1].
pub const ALPHA: Domain = Domain::new(LEAST_ALPHA, 1.0, "");
/// The index of what is clear [1].
pub const IOR: Domain = Domain::new(INDEX[0], INDEX[1], "");
/// Abbe's number [1]: glass has 18 to 95.
pub const ABBE: Domain = Domain::new(1.0, 1e6, "");
/// n or κ of a metal [1].
pub const METAL: Domain = Domain::new(METAL_INDEX[0], METAL_INDEX[1], "");
/// Absorption on the way [m⁻¹].
pub const ABSORPTION: Domain = Domain::new(0.0, FAR, "m⁻¹");
/// The thickness of a film [nm]: of a millimetre it is a pane, through which no light keeps its phase.
pub const FILM: Domain = Domain::above(0.0, 1e6, "nm");
/// A turn [deg].
pub const TURN: Domain = Domain::new(-1e6, 1e6, "deg");
/// A factor [1] of size, of either sign.
pub const SCALE: Domain = Domain::new(-FAR, FAR, "");

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
