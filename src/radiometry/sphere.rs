//! Spheres, partly below the horizon too.

use super::Refusal;
use std::f64::consts::PI;
use std::sync::LazyLock;
use yardstick::quadrature::gauss_legendre;

/// A glowing sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// R, its radius.
    pub radius: f64,
    /// d, from the receiver to its centre; more than R.
    pub distance: f64,
    /// ω [rad], 0 … π, between the receiver's normal and the way to its centre.
    pub omega: f64,
}

impl Sphere {
    /// E/L [sr] (the closed form for one that the horizon cuts: J. M. Snyder, *Area Light Sources for Real-Time
    /// Graphics*, MSR-TR-96-11, 1996). With s = R/d, c = √(1 − s²), q = √(s² − cos² ω) and t = q/c it is
    /// s²(cos ω·atan2(q, −c cos ω) + t) − (t − atan t) where the horizon cuts; below it, a difference of one function at
    /// two places, which is taken as such.
    ///
    /// # Errors
    /// If the radius is not positive, the receiver is inside, or ω is outside 0 … π.
    pub fn irradiance(&self) -> Result<f64, Refusal> {
        let radius = Refusal::unless_positive("R", self.radius)?;
        let distance = self.distance;
        Refusal::unless("d", distance, distance > radius, "more than R: the receiver is outside the sphere")?;
        let omega = Refusal::unless("omega", self.omega, (0.0..=PI).contains(&self.omega), "0 to pi")?;
        let (sine, height) = (radius / distance, omega.cos());
        if height >= sine {
            return Ok(PI * sine * sine * height);
        }
        if height <= -sine {
            return Ok(0.0);
        }
        // (d − R)/d is exact up to its rounding, whatever is left of it.
        let cosine = ((distance - radius) / distance * ((distance + radius) / distance)).sqrt();
        let cut = ((sine - height) * (sine + height)).sqrt();
        let t = cut / cosine;
        Ok(match height >= 0.0 {
            true => sine * sine * (height * cut.atan2(-height * cosine) + t) - excess(t),
            false => t * t * t / (1.0 + t * t) * gap((t / height).powi(2), t * t, (1.0 - height) * (1.0 + height)),
        })
    }
}

/// t − atan t, by its series where that is small.
fn excess(t: f64) -> f64 {
    if t > 0.3 {
        return t - t.atan();
    }
    let square = t * t;
    // 13 terms: 0.09¹³/27 is below the rounding of 1/3.
    let sum = (0..13).rev().fold(0.0, |sum, k| 1.0 / f64::from(2 * k + 3) - square * sum);
    t * square * sum
}

/// A(v) − A(w) for v ≥ w ≥ 0, A(v) = (1 + v)(√v − atan √v)/v^{3/2} = ∫₀¹ u²(1 + v)/(1 + vu²) du; `shrink` is 1 − w/v.
fn gap(v: f64, w: f64, shrink: f64) -> f64 {
    // Nodes for poles no nearer than u = ±i/2.
    static RULE: LazyLock<Vec<(f64, f64)>> = LazyLock::new(|| gauss_legendre(20));
    if v <= 4.0 {
        let term = |(u, weight): &(f64, f64)| {
            let square = u * u;
            weight * square * ((1.0 - u) * (1.0 + u)) / ((1.0 + v * square) * (1.0 + w * square))
        };
        return v * shrink * RULE.iter().map(term).sum::<f64>();
    }
    let (x, y) = (v.sqrt(), w.sqrt());
    if w < 0.25 * v {
        let small = excess(y) / (y * w) * (1.0 + w);
        let large = (1.0 + v) / v * (1.0 - x.atan() / x);
        // y³ may underflow: A(0) = 1/3.
        return large - if w > 1e-200 { small } else { 1.0 / 3.0 };
    }
    // In 1/√v, with x − y = v·shrink/(x + y) taken out of every term.
    let step = v * shrink / (x + y);
    let (p, q) = (1.0 / x, 1.0 / y);
    let turned = (step / (1.0 + x * y)).atan() / step;
    step * (p * q * ((1.0 + p * p + p * q + q * q) * x.atan() - (p + q)) - q * (1.0 + q * q) * turned)
}
