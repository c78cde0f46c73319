//! The lecture's E36–E42 exactly as written, to be held against the forms of [`super::fresnel`]. They are right in
//! exact arithmetic; in `f64` they are 0/0 at normal incidence and lose digits near it, near equal indices and
//! near grazing. Nothing else in the project calls them.

use super::fresnel::{Amplitudes, Powers};
use num_complex::Complex64;

/// E36, E37, E39, E40 with θ₂ from Snell's law; complex θ₂ beyond the critical angle and in absorbing media.
pub fn amplitudes(theta_i: f64, n_i: f64, n_t: Complex64) -> Amplitudes {
    let theta_t = transmitted_angle(theta_i, n_i, n_t);
    let theta_i = Complex64::from(theta_i);
    let (difference, sum) = (theta_i - theta_t, theta_i + theta_t);
    let through = 2.0 * theta_t.sin() * theta_i.cos() / sum.sin();
    Amplitudes {
        r_s: -difference.sin() / sum.sin(),
        t_s: through,
        r_p: tan(difference) / tan(sum),
        t_p: through / difference.cos(),
    }
}

/// sin/cos: the library's complex tangent is 0/0 within 1e−8 of a right angle, which is not the formula's fault.
fn tan(z: Complex64) -> Complex64 {
    z.sin() / z.cos()
}

/// E41: R = |r|², T = Re(n₂ cos θ₂)/(n₁ cos θ₁) |t|² for s, with n₂* in place of n₂ for p.
pub fn powers(theta_i: f64, n_i: f64, n_t: Complex64) -> Powers {
    let Amplitudes { r_s, t_s, r_p, t_p } = amplitudes(theta_i, n_i, n_t);
    let cos_t = transmitted_angle(theta_i, n_i, n_t).cos();
    let q_i = n_i * theta_i.cos();
    Powers {
        r_s: r_s.norm_sqr(),
        t_s: (n_t * cos_t).re / q_i * t_s.norm_sqr(),
        r_p: r_p.norm_sqr(),
        t_p: (n_t.conj() * cos_t).re / q_i * t_p.norm_sqr(),
    }
}

/// θ₂ = asin(n₁ sin θ₁ / n₂), on the branch that decays or runs away from the interface.
fn transmitted_angle(theta_i: f64, n_i: f64, n_t: Complex64) -> Complex64 {
    let sine = n_i * theta_i.sin() / n_t;
    if sine.im == 0.0 && sine.re <= 1.0 {
        return Complex64::from(sine.re.asin());
    }
    let angle = sine.asin();
    if (n_t * angle.cos()).im >= 0.0 { angle } else { std::f64::consts::PI - angle }
}

/// R_n of clear media by the cosines, as most renderers have it: cos θ₂ = √(1 − (n₁/n₂)² (1 − cos² θ₁)),
/// r_s = (n₁ cos θ₁ − n₂ cos θ₂)/(n₁ cos θ₁ + n₂ cos θ₂) and its like for p. Keeps more digits than the angles,
/// but its numerators still cancel.
pub fn natural_reflectance_by_cosines(cos_i: f64, n_i: f64, n_t: f64) -> f64 {
    let ratio = n_i / n_t;
    let sin2_t = ratio * ratio * (1.0 - cos_i * cos_i);
    if sin2_t >= 1.0 {
        return 1.0;
    }
    let cos_t = (1.0 - sin2_t).sqrt();
    let r_s = (n_i * cos_i - n_t * cos_t) / (n_i * cos_i + n_t * cos_t);
    let r_p = (n_t * cos_i - n_i * cos_t) / (n_t * cos_i + n_i * cos_t);
    0.5 * (r_s * r_s + r_p * r_p)
}
