//! The angles at which an interface of clear media does something special, and what lies behind it beyond them.

use crate::optics::incidence::{Incidence, normal_squared, outgoing_root};
use num_complex::Complex64;

/// Angle of incidence [rad] at which p is not reflected at all between clear media: tan θ_B = n_t/n_i.
pub fn brewster_angle(n_i: f64, n_t: f64) -> f64 {
    n_t.atan2(n_i)
}

/// Angle of incidence [rad] from which on everything is reflected, sin θ_c = n_t/n_i; `None` into the denser medium.
pub fn critical_angle(n_i: f64, n_t: f64) -> Option<f64> {
    // atan2 keeps the digits that asin would lose at n_t ≈ n_i, where cos θ_c = √((n_i − n_t)(n_i + n_t))/n_i.
    (n_t < n_i).then(|| n_t.atan2(((n_i - n_t) * (n_i + n_t)).sqrt()))
}

/// Angles of incidence [rad] at which total reflection, out of glass of `n` [1] into the vacuum, turns the phase of p against
/// that of s by `turn` [rad], 0 < `turn` < π, the steeper one first: with T = tan(½ turn) the roots
/// sin²θ of (1 + T²)x² − (1 + 1/n²)x + 1/n² = 0. `None` where none does: the most is
/// tan(½ turn) = (n² − 1)/(2n).
/// (M. Born and E. Wolf, *Principles of Optics*, 7th ed., §1.5.4, eqs. (60) and (61))
pub fn retarding_angles(n: f64, turn: f64) -> Option<[f64; 2]> {
    let (m, tan2) = ((1.0 / n).powi(2), (0.5 * turn).tan().powi(2));
    let (gap, slope) = ((n - 1.0) * (n + 1.0) / n.powi(2), 1.0 + tan2);
    let root = gap.powi(2) - 4.0 * m * tan2;
    if !(root >= 0.0 && n > 1.0) {
        return None;
    }
    let root = root.sqrt();
    // The larger root of that equation for sin²θ, and of the one for cos²θ; the others by their products, which keep digits.
    let (sin2, cos2) = ((1.0 + m + root) / (2.0 * slope), (gap + 2.0 * tan2 + root) / (2.0 * slope));
    let angle = |sin2: f64, cos2: f64| sin2.sqrt().atan2(cos2.sqrt());
    Some([angle(m / slope / sin2, cos2), angle(sin2, tan2 / slope / cos2)])
}

/// Snell's law (E33): sin θ_t = n_i sin θ_i / n_t between clear media, as the refracted direction;
/// `None` beyond the critical angle. Cosine and sine both keep their digits.
pub fn refract(incidence: Incidence, n_i: f64, n_t: f64) -> Option<(f64, f64)> {
    let q2 = normal_squared(incidence, n_i, Complex64::new(n_t, 0.0)).re;
    (q2 >= 0.0).then(|| (n_i * incidence.sin() / n_t, q2.sqrt() / n_t))
}

/// 1/e depth of the *field* behind a totally reflecting interface over the vacuum wavelength [1]:
/// 1/(2π |q_t|); infinite at and below the critical angle (E33, C13).
pub fn evanescent_depth(incidence: Incidence, n_i: f64, n_t: f64) -> f64 {
    let q_t = outgoing_root(normal_squared(incidence, n_i, Complex64::new(n_t, 0.0)));
    1.0 / (std::f64::consts::TAU * q_t.im)
}

/// The least reflectance of natural light, where that is not at normal incidence.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dip {
    /// Angle of incidence [rad].
    pub theta: f64,
    /// R_n there [1].
    pub r_n: f64,
}

/// The dip of R_n between clear media of relative index `n` = n_t/n_i (C11); `None` for 2−√3 ≤ n ≤ 2+√3, where R_n
/// rises from normal incidence on. In x = q_t/q_i, R_n is stationary at x + n²/x = (n⁴ − 6n² + 1)/(n² + 1), and
/// there equals ½ − 2n²/(n² − 1)².
pub fn dip(n: f64) -> Option<Dip> {
    let n2 = n * n;
    let sum = (n2 * n2 - 6.0 * n2 + 1.0) / (n2 + 1.0);
    // (n² + 1)(sum − 2n) = (n² − 4n + 1)(n + 1)²: what is under the root vanishes at the threshold.
    let excess = (n2 - 4.0 * n + 1.0) * (n + 1.0) * (n + 1.0) / (n2 + 1.0);
    if excess <= 0.0 {
        return None;
    }
    let root = (excess * (sum + 2.0 * n)).sqrt();
    // tan² θ = (x² − n²)/(n² − 1) with x − n = (excess + root)/2 from outside; from inside x is n² over that one.
    let (beyond, outer) = (0.5 * (excess + root), 0.5 * (sum + root));
    let difference = if n > 1.0 { beyond * (outer + n) } else { n * beyond / outer * (n + n2 / outer) };
    let contrast = (n - 1.0) * (n + 1.0);
    Some(Dip { theta: (difference / contrast.abs()).sqrt().atan(), r_n: 0.5 - 2.0 * n2 / (contrast * contrast) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::optics::fresnel::amplitudes;
    use std::f64::consts::FRAC_PI_2;

    #[test]
    fn the_critical_angle_is_crossed_without_a_step() {
        for (n_i, n_t) in [(1.5, 1.0), (2.4, 1.0), (1.5, 1.33), (1.0, 0.999)] {
            let critical = critical_angle(n_i, n_t).unwrap();
            for offset in [1e-15, 1e-12, 1e-9, 1e-6] {
                let [below, above] = [critical - offset, critical + offset]
                    .map(|theta| amplitudes(Incidence::from_angle(theta), n_i, Complex64::from(n_t)));
                // r − r_c goes as the square root of the distance, times 1/cos θ_c and, for p, (n_i/n_t)².
                let allowed = 12.0 * (offset + 2e-16).sqrt() / critical.cos().powf(1.5) * (n_i / n_t).powi(2);
                assert!((below.r_s - above.r_s).norm() <= allowed, "{n_i} {n_t} {offset}");
                assert!((below.r_p - above.r_p).norm() <= allowed, "{n_i} {n_t} {offset}");
            }
        }
    }

    #[test]
    fn total_reflection_turns_by_what_was_asked() {
        // Born & Wolf, §1.5.4: glass of 1.51, 45°, printed to a minute.
        let printed = [48.0 + 37.0 / 60.0, 54.0 + 37.0 / 60.0].map(f64::to_radians);
        let [one, other] = retarding_angles(1.51, std::f64::consts::FRAC_PI_4).unwrap();
        assert!((one - printed[0]).abs() < 3e-4 && (other - printed[1]).abs() < 3e-4, "{one} {other}");
        for n in [1.01, 1.5, 2.4, 4.0, 100.0] {
            let most = 2.0 * f64::atan((n * n - 1.0) / (2.0 * n));
            for part in [1e-6, 0.1, 0.5, 0.9, 0.999] {
                let turn = part * most;
                let angles = retarding_angles(n, turn).unwrap();
                let in_order = critical_angle(n, 1.0).unwrap() <= angles[0] && angles[0] <= angles[1];
                assert!(in_order && angles[1] < FRAC_PI_2, "{n} {turn}: {angles:?}");
                for theta in angles {
                    let a = amplitudes(Incidence::from_angle(theta), n, Complex64::from(1.0));
                    let found = (a.r_p / a.r_s).arg().abs();
                    // Next to the critical angle the square of the turn goes with the angle, by 8cot³θ; elsewhere the turn does.
                    let allowed = 64.0 * f64::EPSILON * (turn + 8.0 / theta.tan().powi(3));
                    assert!((found * found - turn * turn).abs() < allowed, "{n} {turn}: {found}");
                }
            }
            assert_eq!(retarding_angles(n, most * 1.001), None);
        }
        for (n, turn) in [(1.0, 0.1), (0.5, 0.1), (f64::NAN, 0.1), (1.5, f64::NAN)] {
            assert_eq!(retarding_angles(n, turn), None, "{n} {turn}");
        }
    }
}
