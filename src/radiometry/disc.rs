//! Discs: parallel to the receiver or tilted, beside its axis, cut by its horizon.

use super::Refusal;
use std::f64::consts::PI;
use std::sync::LazyLock;
use yardstick::quadrature::gauss_legendre;

/// A round lamp in the plane z = `height`, its centre at (`offset`, 0, `height`); the receiver's normal is
/// (sin `tilt`, 0, cos `tilt`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc {
    /// R.
    pub radius: f64,
    /// h, positive.
    pub height: f64,
    /// a, of either sign.
    pub offset: f64,
    /// τ [rad], −π … π.
    pub tilt: f64,
}

impl Disc {
    /// E/L [sr] of what is above the horizon: in closed form, but near the horizon, where that would
    /// cancel, as a sum over strips.
    ///
    /// # Errors
    /// If radius or height are not positive or less than 10⁻¹⁵⁰ of the largest length, or offset or tilt are outside their range.
    pub fn irradiance(&self) -> Result<f64, Refusal> {
        let radius = Refusal::unless_positive("R", self.radius)?;
        let height = Refusal::unless_positive("h", self.height)?;
        let offset = Refusal::unless("a", self.offset, true, "finite")?;
        let tilt = Refusal::unless("tau", self.tilt, self.tilt.abs() <= PI, "-pi to pi")?;
        let unit = radius.max(height).max(offset.abs());
        let radius = Refusal::unless_tiny("R", radius, unit)?;
        let height = Refusal::unless_tiny("h", height, unit)?;
        // Turned over, what leans back leans forward.
        let offset = offset.copysign(offset * tilt) / unit;
        let offset = if tilt == 0.0 { offset.abs() } else { offset };
        let (sin, cos) = tilt.abs().sin_cos();
        let seen = Seen { radius, height, offset, sin, cos };
        Ok(seen.irradiance())
    }
}

/// A disc of sizes at most 1 and a tilt of 0 … π.
struct Seen {
    radius: f64,
    height: f64,
    offset: f64,
    sin: f64,
    cos: f64,
}

impl Seen {
    fn irradiance(&self) -> f64 {
        let (low, high) = (self.rim(self.offset - self.radius), self.rim(self.offset + self.radius));
        if low.up >= 0.0 && high.up >= 0.0 {
            self.whole(low.distance * high.distance)
        } else if low.up <= 0.0 && high.up <= 0.0 {
            0.0
        } else {
            self.cut(&low, &high)
        }
    }

    /// The rim where it crosses the x axis.
    fn rim(&self, x: f64) -> Rim {
        let Self { height, sin, cos, .. } = *self;
        Rim { distance: x.hypot(height), up: x * sin + height * cos, back: height * sin - x * cos }
    }

    /// h² + a² − R² [1]: where it is negative, the receiver is under the disc.
    fn power(&self) -> f64 {
        self.height * self.height + (self.offset - self.radius) * (self.offset + self.radius)
    }

    /// With d, the product of the rims' distances.
    fn whole(&self, d: f64) -> f64 {
        let Self { radius, height, offset, sin, cos } = *self;
        let s = self.power();
        let facing = match s >= 0.0 {
            true => 2.0 * PI * (radius * height / d) * (radius * height / (d + s)),
            false => PI * (d - s) / (2.0 * d),
        };
        let sum = height * height + offset * offset + radius * radius;
        let aside = 2.0 * PI * (height * radius / d) * (offset * radius / (sum + d));
        cos * facing + sin * aside
    }

    /// Lambert's contour integral along the arc above the horizon and the chord that closes it, where it does not cancel.
    fn cut(&self, low: &Rim, high: &Rim) -> f64 {
        let Self { radius, height, offset, sin, cos } = *self;
        // tan of half the arc's angle, and half the chord.
        let half = (high.up / -low.up).sqrt();
        let chord = (high.up * -low.up).sqrt() / sin;
        let (p, q) = (low.distance, high.distance);
        let r = p / q;
        let e = 4.0 * offset * radius / (q * (p + q));
        let full = (r * half).atan();
        let slope = half / (1.0 + r * half * half);
        let bent = if e == 0.0 { slope } else { (e * slope).atan() / e };
        let swing = 4.0 / (q * q * (1.0 + r)) * (bent - e / (2.0 * r) * full);
        let power = self.power();
        // Under the disc both parts of ½Φ − ½ power ∫dφ/r² are positive; beside it those of the integral as it stands.
        let facing = match power < 0.0 {
            true => [half.atan(), -power / (p * q) * full],
            false => [2.0 * radius / (p * q) * full * radius, radius * offset * swing],
        };
        let terms = [cos * facing[0], cos * facing[1], -sin * height * radius * swing, (chord * sin / height).atan()];
        let total: f64 = terms.iter().sum();
        let size: f64 = terms.iter().map(|term| term.abs()).sum();
        if size > MOST * total.abs() { self.strips(low, high) } else { total }
    }

    /// The same as a sum over strips across the lamp.
    fn strips(&self, low: &Rim, high: &Rim) -> f64 {
        let across = Strips {
            opening: (2.0 * self.radius * self.height).atan2(self.power()),
            low: low.distance / self.height,
            high: high.distance / self.height,
        };
        let (seen, hidden) = (high.up.atan2(high.back), (-low.up).atan2(low.back));
        let middle = 0.5 * across.opening;
        let near_high = across.sum(0.0, seen.min(middle), |from_high| seen - from_high);
        if seen <= middle {
            return near_high;
        }
        near_high + across.sum(hidden, middle, |from_low| from_low - hidden)
    }
}

/// A point of the rim.
struct Rim {
    distance: f64,
    /// How high it is above the receiver's horizon.
    up: f64,
    /// How far it is from there to the receiver's back.
    back: f64,
}

/// Strips across the lamp, by the angles at which the receiver sees them. A strip at the height β above the horizon that ends
/// at ±atan Y on both sides sends sin β (Y/(1 + Y²) + atan Y) dβ, and Y² = pq/h² sin u sin v if the lamp's rims, p and q away,
/// are u farther up and v farther down. All of this is positive, so nothing cancels however low the lamp is.
struct Strips {
    /// The angle u + v between the rims.
    opening: f64,
    /// p/h and q/h.
    low: f64,
    high: f64,
}

impl Strips {
    /// From one angle off a rim to another that is at most half the opening, given the height above the horizon.
    fn sum(&self, from: f64, to: f64, height: impl Fn(f64) -> f64) -> f64 {
        static RULE: LazyLock<Vec<(f64, f64)>> = LazyLock::new(|| gauss_legendre(NODES));
        // With u = (u + v) sin² w, Y has no root at the rims; near them it falls to 0 within w ~ 1/Y, so every panel ends
        // at half of what is left, down to there.
        let place = |angle: f64| (angle / self.opening).sqrt().asin();
        let (end, mut top, mut total) = (place(from), place(to), 0.0);
        while top > end {
            let half = 0.5 * top;
            let bottom = if half > end && self.reach(self.opening * half.sin().powi(2)) > 0.25 { half } else { end };
            let node = |&(at, weight): &(f64, f64)| {
                let w = bottom + (top - bottom) * at;
                let angle = self.opening * w.sin().powi(2);
                let reach = self.reach(angle);
                let across = reach / (1.0 + reach * reach) + reach.atan();
                weight * height(angle).sin() * across * (2.0 * w).sin()
            };
            total += (top - bottom) * self.opening * RULE.iter().map(node).sum::<f64>();
            top = bottom;
        }
        total
    }

    /// Y at an angle from either rim.
    fn reach(&self, angle: f64) -> f64 {
        (self.low * angle.sin()).sqrt() * (self.high * (self.opening - angle).sin()).sqrt()
    }
}

/// How much larger than their sum the terms of a contour may be [1].
const MOST: f64 = 4.0;

/// Of Gauss's rule in a panel [1]: the nearest pole, Y = ±i, is at least the panel's length from its end, so that the error
/// falls as (3 + √8)^(−2n).
const NODES: usize = 16;
