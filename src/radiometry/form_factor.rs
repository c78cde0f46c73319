//! The share [1] of what leaves one surface that arrives at another, both Lambertian (J. R. Howell, *A Catalog of
//! Radiation Heat Transfer Configuration Factors*).

use super::Refusal;
use std::f64::consts::PI;

/// Lengths that can be had [1, any unit]: their ratios' squares stay within the range of `f64`.
pub const LENGTHS: (f64, f64) = (1e-60, 1e60);

fn lengths<const N: usize>(named: [(&'static str, f64); N]) -> Result<[f64; N], Refusal> {
    let (least, most) = LENGTHS;
    for (place, length) in named {
        Refusal::unless(place, length, (least..=most).contains(&length), "1e-60 to 1e60")?;
    }
    Ok(named.map(|(_, length)| length))
}

/// Between two rectangles a × b that face each other at a distance c (Howell C-11).
///
/// # Errors
/// If a length is outside [`LENGTHS`].
pub fn parallel_rectangles(a: f64, b: f64, c: f64) -> Result<f64, Refusal> {
    let [a, b, c] = lengths([("a", a), ("b", b), ("c", c)])?;
    let (x, y) = (a / c, b / c);
    // √(1 + y²) atan(x/√(1 + y²)) − atan x, times x, as two terms that do not cancel.
    let part = |x: f64, y: f64| {
        let slant = y.hypot(1.0);
        let rise = y * (y / (slant + 1.0));
        x * (rise * (x / slant).atan() - (x * rise).atan2(slant + x * x))
    };
    let volume = x / x.hypot(1.0).hypot(y) * y;
    Ok(2.0 / (PI * x) * ((0.5 * (volume * volume).ln_1p() + part(x, y) + part(y, x)) / y))
}

/// From a rectangle w × l to one of h × l that stands on the common edge l at a right angle (Howell C-14).
///
/// # Errors
/// If a length is outside [`LENGTHS`].
pub fn perpendicular_rectangles(w: f64, h: f64, l: f64) -> Result<f64, Refusal> {
    let [w, h, l] = lengths([("w", w), ("h", h), ("l", l)])?;
    let (w, h) = (w / l, h / l);
    let slant = w.hypot(h);
    // The diagonal's term against that of the longer side, which it may nearly equal.
    let (long, short) = (w.max(h), w.min(h));
    let rise = short * (short / (slant + long));
    let angles = long * rise.atan2(1.0 + long * slant) - rise * (1.0 / slant).atan() + short * (1.0 / short).atan();
    // Near −1 its complement is no longer exact, and the logarithm is that of the quotient itself.
    let log = |less: f64, whole: f64| if less < 0.5 { (-less).ln_1p() } else { whole.ln() };
    let side = |w: f64, h: f64| {
        let (near, far) = (w.hypot(1.0), slant.hypot(1.0));
        let (less, whole) = (h / slant / near, w / slant * (far / near));
        w * (w * log(less * less, whole * whole))
    };
    let volume = w / slant.hypot(1.0) * h;
    Ok((angles + 0.25 * ((volume * volume).ln_1p() + side(w, h) + side(h, w))) / (PI * w))
}

/// From a disc of radius r₁ to one of r₂ on the same axis, at a distance h (Howell C-41).
///
/// # Errors
/// If a length is outside [`LENGTHS`].
pub fn coaxial_discs(r1: f64, r2: f64, h: f64) -> Result<f64, Refusal> {
    let [r1, r2, h] = lengths([("r1", r1), ("r2", r2), ("h", h)])?;
    let unit = r1.max(r2).max(h);
    let [r1, r2, h] = [r1 / unit, r2 / unit, h / unit];
    Ok(2.0 * r2 * (r2 / (h * h + r1 * r1 + r2 * r2 + h.hypot(r1 - r2) * h.hypot(r1 + r2))))
}
