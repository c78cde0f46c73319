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
    /// E/L [sr], by Lambert's contour integral along the arc above the horizon and the chord that closes it.
    ///
    /// # Errors
    /// If radius or height are not positive, or offset or tilt are outside their range.
    pub fn irradiance(&self) -> Result<f64, Refusal> {
        let radius = Refusal::unless_positive("R", self.radius)?;
        let height = Refusal::unless_positive("h", self.height)?;
        let offset = Refusal::unless("a", self.offset, true, "finite")?;
        let tilt = Refusal::unless("tau", self.tilt, self.tilt.abs() <= PI, "-pi to pi")?;
        let unit = radius.max(height).max(offset.abs());
        let (radius, height) = (radius / unit, height / unit);
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
        let Self { radius, height, offset, sin, cos } = *self;
        // How far the horizon's line, x sin τ + h cos τ = 0, lies below the rims, times sin τ.
        let near = (offset - radius) * sin + height * cos;
        let far = (offset + radius) * sin + height * cos;
        if near >= 0.0 {
            return self.whole();
        }
        if far <= 0.0 {
            return 0.0;
        }
        self.clipped(-near, far)
    }

    /// S, p, q and d = pq: p and q are how far the rims are.
    fn rims(&self) -> [f64; 4] {
        let Self { radius, height, offset, .. } = *self;
        let (p, q) = (height.hypot(offset - radius), height.hypot(offset + radius));
        [height * height + offset * offset + radius * radius, p, q, p * q]
    }

    fn whole(&self) -> f64 {
        let Self { radius, height, offset, sin, cos } = *self;
        let [sum, _, _, d] = self.rims();
        let s = height * height + (offset - radius) * (offset + radius);
        let facing = match s >= 0.0 {
            true => 2.0 * PI * (radius * height / d) * (radius * height / (d + s)),
            false => PI * (d - s) / (2.0 * d),
        };
        let aside = 2.0 * PI * (height * radius / d) * (offset * radius / (sum + d));
        cos * facing + sin * aside
    }

    /// With `below` and `above` of the diameter on either side of the horizon, times sin τ.
    fn clipped(&self, below: f64, above: f64) -> f64 {
        let Self { radius, height, offset, sin, cos } = *self;
        let [_, p, q, d] = self.rims();
        // tan of half the arc's angle, and half the chord.
        let half = (above / below).sqrt();
        let chord = (above * below).sqrt() / sin;
        let r = p / q;
        let e = 4.0 * offset * radius / (q * (p + q));
        let full = (r * half).atan();
        let slope = half / (1.0 + r * half * half);
        let bent = if e == 0.0 { slope } else { (e * slope).atan() / e };
        let even = 2.0 / d * full;
        let swing = 4.0 / (q * q * (1.0 + r)) * (bent - e / (2.0 * r) * full);
        let terms = [
            cos * radius * radius * even,
            cos * radius * offset * swing,
            -sin * height * radius * swing,
            (chord * sin / height).atan(),
        ];
        let total: f64 = terms.iter().sum();
        let size: f64 = terms.iter().map(|term| term.abs()).sum();
        // What cancels is summed in strips instead, which are all of one sign.
        if size > MOST * total.abs() { self.strips(above) } else { total }
    }

    /// The same as a sum over strips across the lamp, from the horizon's line to the far rim.
    fn strips(&self, above: f64) -> f64 {
        static RULE: LazyLock<Vec<(f64, f64)>> = LazyLock::new(|| gauss_legendre(24));
        let Self { radius, height, offset, sin, .. } = *self;
        let width = above / sin;
        let strip = |(s, weight): &(f64, f64)| {
            // Squares from the rim, where the strips' length has its root.
            let from_rim = width * s * s;
            let from_line = width * (1.0 - s) * (1.0 + s);
            let x = offset + radius - from_rim;
            let half = (from_rim * (2.0 * radius - from_rim)).sqrt();
            let distance = x.hypot(height);
            let ratio = half / distance;
            let across = (ratio / (1.0 + ratio * ratio) + ratio.atan()) / (distance * distance * distance);
            weight * 2.0 * width * s * height * from_line * sin * across
        };
        RULE.iter().map(strip).sum()
    }
}

/// How much larger than their sum terms may be [1].
const MOST: f64 = 4.0;
