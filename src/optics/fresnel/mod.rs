//! Fresnel's coefficients of a plane interface, in the form that keeps its digits.
//!
//! Born & Wolf, *Principles of Optics* (7th ed.), §1.5 (clear media), §14.2 (conductors); signs as in the crate's
//! conventions. With q_i = n_i cos θ_i and q_t = √(n_t² − n_i² sin² θ_i), Im q_t ≥ 0, the lecture's E36–E40 read
//! r_s = (q_i − q_t)/(q_i + q_t) and r_p = (n_t² q_i − n_i² q_t)/(n_t² q_i + n_i² q_t).
//! The differences in the numerators are where digits go: near normal incidence, near equal indices, near
//! Brewster's angle. They never appear here; with q_i² − q_t² = n_i² − n_t² each is replaced by a product whose
//! factors are differences of *inputs*, which are exact. Sums of products of one sign need no such care.

mod angles;
mod natural;

pub use angles::{Dip, brewster_angle, critical_angle, dip, evanescent_depth, refract, retarding_angles};
pub(crate) use natural::clear;
pub use natural::{diffuse_reflectance, natural_reflectance, natural_reflectance_absorbing};

use super::incidence::{Incidence, brewster_balance, normal_squared, outgoing_root};
use num_complex::Complex64;

/// Ratios of electric field amplitudes to the incident one [1], with respect to e^(−iωt).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Amplitudes {
    /// Reflected, s (E36).
    pub r_s: Complex64,
    /// Transmitted, s (E37).
    pub t_s: Complex64,
    /// Reflected, p (E39).
    pub r_p: Complex64,
    /// Transmitted, p (E40).
    pub t_p: Complex64,
}

/// Shares of the incident power, normal to the interface [1] (E41–E43).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Powers {
    /// R_s: reflected, s.
    pub r_s: f64,
    /// T_s: transmitted, s.
    pub t_s: f64,
    /// R_p: reflected, p.
    pub r_p: f64,
    /// T_p: transmitted, p.
    pub t_p: f64,
}

impl Powers {
    /// R_n: reflected share of natural light, the mean of s and p (E42).
    pub fn r_n(&self) -> f64 {
        0.5 * (self.r_s + self.r_p)
    }

    /// T_n: transmitted share of natural light (E43).
    pub fn t_n(&self) -> f64 {
        0.5 * (self.t_s + self.t_p)
    }
}

/// Field ratios at the interface from the clear medium `n_i` (1e−9 … 1e9) into `n_t` = n + iκ, n ≥ 0 and κ ≥ 0 but not
/// both zero; n = 0 is a metal without loss, which reflects everything. A κ below 1e−280 may lose digits in its square.
/// Real and imaginary part each keep their digits. Total reflection is an answer: complex r of modulus 1.
pub fn amplitudes(incidence: Incidence, n_i: f64, n_t: Complex64) -> Amplitudes {
    let Some(side) = Solution::new(incidence, n_i, n_t) else { return NOTHING_THERE };
    let Solution { q_i, q_t, cos_i, s_norm, p_norm, .. } = side;
    let t_s = Complex64::new(q_i + q_t.re, 0.0 - q_t.im) / s_norm * (2.0 * q_i);
    let t_p = side.along / (n_t.norm_sqr() * p_norm) * (2.0 * cos_i * n_i);
    Amplitudes { r_s: side.r_s(), t_s, r_p: side.r_p(), t_p }
}

/// Shares of power at the interface from the clear medium `n_i` into `n_t`; domain as [`amplitudes`].
/// T is computed by itself, not as 1 − R, so that it keeps its digits where it is small.
pub fn powers(incidence: Incidence, n_i: f64, n_t: Complex64) -> Powers {
    let Some(side) = Solution::new(incidence, n_i, n_t) else {
        return Powers { r_s: 0.0, t_s: 1.0, r_p: 0.0, t_p: 1.0 };
    };
    if side.q_t.re == 0.0 {
        return Powers { r_s: 1.0, t_s: 0.0, r_p: 1.0, t_p: 0.0 };
    }
    let [r_s, r_p] = side.reflectances();
    Powers {
        r_s,
        t_s: 4.0 * side.q_i * (side.q_t.re / side.s_norm),
        r_p,
        t_p: 4.0 * side.cos_i * (side.g.re / side.p_norm),
    }
}

/// The answer between equal media.
const NOTHING_THERE: Amplitudes = {
    let (zero, one) = (Complex64::new(0.0, 0.0), Complex64::new(1.0, 0.0));
    Amplitudes { r_s: zero, t_s: one, r_p: zero, t_p: one }
};

/// What amplitudes and powers share: the normal wave numbers and the two denominators. All but the inputs is in
/// units of 1/`unit`, its square or its fourth power, so that nothing underflows at the faintest grazing contrast.
/// What is made of it multiplies by cos θ_i last: the smallest factor, near grazing, may take only the result out of
/// the range of normal numbers.
struct Solution {
    incidence: Incidence,
    n_i: f64,
    n_t: Complex64,
    /// cos θ_i.
    cos_i: f64,
    /// n_i cos θ_i.
    q_i: f64,
    /// q_t² and q_t.
    q2_t: Complex64,
    q_t: Complex64,
    /// n_t² − n_i², its real part from exact differences.
    contrast: Complex64,
    /// n_i q_t / n_t²: what cos θ_i is weighed against in p.
    g: Complex64,
    /// n_t* (cos_i + g*): what t_p is proportional to.
    along: Complex64,
    /// |q_i + q_t|².
    s_norm: f64,
    /// |cos θ_i + g|².
    p_norm: f64,
}

impl Solution {
    /// None between equal media: there is no interface to speak of.
    #[inline]
    fn new(incidence: Incidence, n_i: f64, n_t: Complex64) -> Option<Self> {
        debug_assert!(n_i > 0.0 && n_t.re >= 0.0 && n_t.im >= 0.0 && n_t != Complex64::ZERO);
        let contrast = Complex64::new((n_t.re - n_i) * (n_t.re + n_i) - n_t.im * n_t.im, 2.0 * n_t.re * n_t.im);
        if contrast.re == 0.0 && contrast.im == 0.0 {
            return None;
        }
        let q2_t = normal_squared(incidence, n_i, n_t);
        let q_t = outgoing_root(q2_t);
        let (cos_i, q_i) = (incidence.cos(), n_i * incidence.cos());
        let unit = if q_i.max(q_t.re).max(q_t.im) < FAINT { MAGNIFIED } else { 1.0 };
        let (cos_i, q_i, q_t) = (cos_i * unit, q_i * unit, q_t * unit);
        let (q2_t, contrast) = (q2_t * unit * unit, contrast * unit * unit);
        // q_t n_t* = forward + i·aside. The latter, n Im q_t − κ Re q_t, would cancel; from Re q_t Im q_t = nκ and
        // q_t² = n_t² − n_i² sin² θ_i it is a product of what is never negative.
        let n_i_sin = n_i * incidence.sin();
        let modulus = n_t.norm_sqr();
        let forward = n_t.re * q_t.re + n_t.im * q_t.im;
        let turned = n_t.re * n_t.re + q_t.im * q_t.im / (unit * unit);
        let aside = n_t.re * q_t.im * (n_i_sin * n_i_sin / turned);
        let scale = n_i / (modulus * modulus);
        let g =
            Complex64::new(scale * (forward * n_t.re + aside * n_t.im), scale * (aside * n_t.re - forward * n_t.im));
        let lift = n_i / modulus;
        let along = Complex64::new(n_t.re * cos_i + lift * forward, 0.0 - (n_t.im * cos_i + lift * aside));
        let (s_sum, p_sum) = (q_i + q_t.re, cos_i + g.re);
        let s_norm = s_sum * s_sum + q_t.im * q_t.im;
        let p_norm = p_sum * p_sum + g.im * g.im;
        Some(Self { incidence, n_i, n_t, cos_i, q_i, q2_t, q_t, contrast, g, along, s_norm, p_norm })
    }

    /// R_s and R_p. Where much is reflected the difference q_i − q_t has its digits, and |q_i − q_t|² + 4 q_i Re q_t =
    /// |q_i + q_t|² makes R + T one to rounding. Where little is, r_s = −(n_t² − n_i²)/(q_i + q_t)² and r_p =
    /// (n_t² − n_i²)(n_t² cos² θ_i − n_i² sin² θ_i)/(n_t² cos θ_i + n_i q_t)².
    fn reflectances(&self) -> [f64; 2] {
        let Self { incidence, n_i, n_t, cos_i, q_i, q_t, g, s_norm, p_norm, .. } = *self;
        let contrast = self.contrast.norm_sqr();
        let (direct_s, direct_p) = ((q_i - q_t).norm_sqr(), (cos_i - g).norm_sqr());
        let r_s = if direct_s > 0.25 * s_norm { direct_s / s_norm } else { contrast / (s_norm * s_norm) };
        if direct_p > 0.25 * p_norm {
            return [r_s, direct_p / p_norm];
        }
        let (cos, square, modulus) = (incidence.cos(), square(n_t), n_t.norm_sqr());
        let p_norm = modulus * modulus * p_norm;
        let turned = square.im * cos * cos;
        let balance = brewster_balance(incidence, n_i, n_t, square.re);
        [r_s, contrast * (balance * balance + turned * turned) / (p_norm * p_norm)]
    }

    /// (q_i − q_t)(q_i + q_t*)/|q_i + q_t|². Its real part needs q_i² − |q_t|², which is
    /// (q_i⁴ − |q_t|⁴)/(q_i² + |q_t|²) with q_t² = q_i² + contrast.
    fn r_s(&self) -> Complex64 {
        let Self { q_i, q2_t, q_t, contrast, s_norm, .. } = *self;
        let q2_i = q_i * q_i;
        let excess = contrast.re * (q2_i + q2_t.re) + contrast.im * contrast.im;
        let re = -excess / ((q2_i + q_t.norm_sqr()) * s_norm);
        // 0 − x, not −x: nothing absorbed is +0.
        Complex64::new(re, 0.0 - 2.0 * q_i * (q_t.im / s_norm))
    }

    /// (cos_i − g)(cos_i + g*)/|cos_i + g|².
    fn r_p(&self) -> Complex64 {
        let Self { cos_i, g, p_norm, .. } = *self;
        let (cos2, g2) = (cos_i * cos_i, g.norm_sqr());
        let difference = if (cos2 - g2).abs() > 0.5 * cos2 { cos2 - g2 } else { self.brewster_difference(g2) };
        Complex64::new(difference / p_norm, 0.0 - 2.0 * cos_i * (g.im / p_norm))
    }

    /// cos² θ_i − |g|² near its zero, from cos⁴ θ_i |n_t|⁸ − n_i⁴ |q_t|⁴ in factors that do not cancel:
    /// (n_t² − n_i²)(n_t² cos² θ_i − n_i² sin² θ_i)(…) for clear media, plus what absorption adds.
    fn brewster_difference(&self, g2: f64) -> f64 {
        let Self { incidence, n_i, n_t, cos_i, q2_t, contrast, .. } = *self;
        let (n2_i, square) = (n_i * n_i, square(n_t));
        let (cos2, plain_cos2) = (cos_i * cos_i, incidence.cos() * incidence.cos());
        let balance = brewster_balance(incidence, n_i, n_t, square.re);
        let (re2, im2) = (square.re * square.re, square.im * square.im);
        let clear = contrast.re * balance * (cos2 * re2 + n2_i * q2_t.re);
        let absorbed = contrast.im * contrast.im * (plain_cos2 * plain_cos2 * (2.0 * re2 + im2) - n2_i * n2_i);
        let modulus = n_t.norm_sqr();
        let modulus4 = modulus * modulus * modulus * modulus;
        (clear + absorbed) / (modulus4 * (cos2 + g2))
    }
}

/// Normal wave numbers below this are magnified before they are squared, by a power of two.
const FAINT: f64 = 1e-70;
const MAGNIFIED: f64 = f64::from_bits((1023 + 400) << 52);

/// n², its real part as a product, so that n ≈ κ loses nothing.
fn square(n: Complex64) -> Complex64 {
    Complex64::new((n.re - n.im) * (n.re + n.im), 2.0 * n.re * n.im)
}

/// Field ratios between any two media, either of which may absorb, for a tangential index β = n sin θ [1]
/// common to both sides (complex if the incident wave is inhomogeneous). Accurate relative to each ratio's modulus.
/// Interchanging the media gives the wave from the other side.
pub fn amplitudes_between(beta: Complex64, n_i: Complex64, n_t: Complex64) -> Amplitudes {
    let (square_i, square_t, beta2) = (n_i * n_i, n_t * n_t, beta * beta);
    let (q_i, q_t) = (upward_root((n_i - beta) * (n_i + beta)), upward_root((n_t - beta) * (n_t + beta)));
    let contrast = (n_t - n_i) * (n_t + n_i);
    let (s, p) = (q_i + q_t, square_t * q_i + square_i * q_t);
    let balance = square_i * square_t - beta2 * (square_i + square_t);
    Amplitudes {
        r_s: -contrast / (s * s),
        t_s: 2.0 * q_i / s,
        r_p: contrast * balance / (p * p),
        t_p: 2.0 * n_i * n_t * q_i / p,
    }
}

/// The root with Im ≥ 0, and Re > 0 on the real axis.
fn upward_root(square: Complex64) -> Complex64 {
    if square.im >= 0.0 {
        return outgoing_root(square);
    }
    // The mirror image about the imaginary axis.
    let root = outgoing_root(square.conj());
    Complex64::new(-root.re, root.im)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::optics::Direction;
    use crate::references::fresnel::{Exact, Input};
    use proptest::prelude::*;
    use yardstick::precise;

    pub fn index() -> impl Strategy<Value = f64> {
        prop_oneof![0.3..5.0, Just(1.0), Just(1.5)]
    }

    pub fn extinction() -> impl Strategy<Value = f64> {
        prop_oneof![Just(0.0), 1e-12..1e-3, 0.0..8.0]
    }

    pub fn angle() -> impl Strategy<Value = f64> {
        prop_oneof![
            Just(0.0),
            0.0..1.57,
            (0.0_f64..12.0).prop_map(|p| std::f64::consts::FRAC_PI_2 - 10f64.powf(-p - 0.5))
        ]
    }

    fn close(a: Complex64, b: Complex64, tolerance: f64) -> bool {
        (a - b).norm() <= tolerance * (1.0 + a.norm().max(b.norm()))
    }

    proptest! {
        #[test]
        fn energy_is_conserved_into_any_medium(theta in angle(), n_i in index(), n in index(), k in extinction()) {
            let p = powers(Incidence::from_angle(theta), n_i, Complex64::new(n, k));
            for sum in [p.r_s + p.t_s, p.r_p + p.t_p, p.r_n() + p.t_n()] {
                prop_assert!((sum - 1.0).abs() <= 8.0 * f64::EPSILON, "{sum}");
            }
        }

        #[test]
        fn both_routes_agree(theta in 0.0..1.5, n_i in index(), n in index(), k in extinction()) {
            let n_t = Complex64::new(n, k);
            let incidence = Incidence::from_angle(theta);
            let careful = amplitudes(incidence, n_i, n_t);
            let general = amplitudes_between(Complex64::from(n_i * incidence.sin()), Complex64::from(n_i), n_t);
            // The general form takes sin θ alone, which decides nothing within 1e−9 of a critical angle.
            prop_assume!(normal_squared(incidence, n_i, n_t).norm() > 1e-6);
            for (a, b) in [(careful.r_s, general.r_s), (careful.t_s, general.t_s), (careful.r_p, general.r_p), (careful.t_p, general.t_p)] {
                prop_assert!(close(a, b, 1e-9), "{a} {b}");
            }
        }

        #[test]
        fn reversal_and_stokes(beta in 0.0..2.0, n_a in index(), k_a in extinction(), n_b in index(), k_b in extinction()) {
            let (a, b, beta) = (Complex64::new(n_a, k_a), Complex64::new(n_b, k_b), Complex64::from(beta));
            let (there, back) = (amplitudes_between(beta, a, b), amplitudes_between(beta, b, a));
            // t_p compares electric fields; reversal keeps t t′ = 1 − r² because the index ratios cancel.
            for (r, r_back, t, t_back) in [(there.r_s, back.r_s, there.t_s, back.t_s), (there.r_p, back.r_p, there.t_p, back.t_p)] {
                prop_assume!(r.norm() < 1e3);
                prop_assert!(close(r, -r_back, 1e-12), "r {r} {r_back}");
                prop_assert!(close(t * t_back, 1.0 - r * r, 1e-9), "{} {}", t * t_back, 1.0 - r * r);
            }
        }

        #[test]
        fn vanishing_absorption_changes_nothing(theta in angle(), n_i in index(), n in index()) {
            let incidence = Incidence::from_angle(theta);
            let clear = amplitudes(incidence, n_i, Complex64::from(n));
            let traced = amplitudes(incidence, n_i, Complex64::new(n, 1e-200));
            for (a, b) in [(clear.r_s, traced.r_s), (clear.t_s, traced.t_s), (clear.r_p, traced.r_p), (clear.t_p, traced.t_p)] {
                prop_assert!(close(a, b, 1e-15), "{a} {b}");
            }
        }
    }

    /// The worst error of all outputs against 256 bits, in ulp · (1 + cond), but of those that no `f64` holds with all its digits.
    fn worst_error(direction: Direction, n_i: f64, n_t: Complex64) -> f64 {
        let incidence = Incidence::from(direction);
        let (a, p) = (amplitudes(incidence, n_i, n_t), powers(incidence, n_i, n_t));
        let parts = [a.r_s, a.t_s, a.r_p, a.t_p].into_iter().flat_map(|z| [z.re, z.im]);
        let ours = parts.chain([p.r_s, p.t_s, p.r_p, p.t_p, p.r_n(), p.t_n()]);
        let exact = Exact::new(&Input { direction, n_i, n_t });
        let errors = ours.zip(&exact.outputs).zip(exact.conditions()).map(|((ours, exact), condition)| {
            if precise::to_f64(exact).abs() < f64::MIN_POSITIVE && ours.abs() <= f64::MIN_POSITIVE {
                return 0.0;
            }
            precise::relative_error(ours, exact) / (f64::EPSILON * (1.0 + condition))
        });
        errors.max_by(f64::total_cmp).expect("outputs")
    }

    /// Any index that a parameter admits, even over its orders of magnitude, and the ends.
    fn any_index() -> impl Strategy<Value = f64> {
        prop_oneof![Just(1e-9), Just(1e9), Just(1.0), (-9.0..9.0).prop_map(|power: f64| 10f64.powf(power))]
    }

    /// Any direction, down to the last one that differs from the normal and from the surface.
    fn any_direction() -> impl Strategy<Value = Direction> {
        prop_oneof![
            Just(Direction::Angle(0.0)),
            Just(Direction::Angle(std::f64::consts::FRAC_PI_2)),
            (0.0..1.57).prop_map(Direction::Angle),
            (-300.0..0.0).prop_map(|power: f64| Direction::Angle(10f64.powf(power))),
            (-300.0..0.0).prop_map(|power: f64| Direction::Cos(10f64.powf(power))),
        ]
    }

    proptest! {
        #[test]
        fn the_promise_holds_over_the_whole_domain(
            direction in any_direction(),
            n_i in any_index(),
            n in prop_oneof![Just(0.0), any_index()],
            k in prop_oneof![Just(0.0), any_index()],
        ) {
            prop_assume!(n > 0.0 || k > 0.0);
            let worst = worst_error(direction, n_i, Complex64::new(n, k));
            prop_assert!(worst <= 16.0, "{worst} ulp · (1 + cond)");
        }
    }

    #[test]
    fn nothing_underflows_on_the_way_to_a_small_share() {
        let cases = [
            (1.69e-281, 1e-4, Complex64::new(1e-9, 1e9)),
            (5.7e-240, 1e9, Complex64::new(1e-9, 0.0)),
            (6e-295, 1e-9, Complex64::new(1.0, 8e8)),
        ];
        for (cos, n_i, n_t) in cases {
            let worst = worst_error(Direction::Cos(cos), n_i, n_t);
            assert!(worst <= 16.0, "{worst} at n {n_i:e} → {n_t:e}, cos θ = {cos:e}");
        }
    }

    #[test]
    fn a_metal_without_loss_only_turns_the_phase() {
        // Real ε < 0: r_s = (c − iγ)/(c + iγ) with c = cos θ, γ = √(κ² + sin² θ), and for p with κ²c in place of c, turned.
        for (kappa, theta) in [(2.0, 0.0), (0.5, 0.7), (3.4, 1.5)] {
            let found = amplitudes(Incidence::from_angle(theta), 1.0, Complex64::new(0.0, kappa));
            let shares = powers(Incidence::from_angle(theta), 1.0, Complex64::new(0.0, kappa));
            assert_eq!((shares.r_n(), shares.t_n()), (1.0, 0.0));
            let (sin, cos) = theta.sin_cos();
            let gamma = kappa.hypot(sin);
            let turned = |near: f64, far: f64| Complex64::new(near, -far) / Complex64::new(near, far);
            assert!((found.r_s - turned(cos, gamma)).norm() <= 4.0 * f64::EPSILON);
            assert!((found.r_p - turned(kappa * kappa * cos, -gamma)).norm() <= 4.0 * f64::EPSILON);
        }
    }

    #[test]
    fn a_vacant_interface_reflects_nothing_even_at_grazing() {
        let there = powers(Incidence::from_cos(0.0), 1.3, Complex64::from(1.3));
        assert_eq!((there.r_n(), there.t_n()), (0.0, 1.0));
        let other = powers(Incidence::from_cos(0.0), 1.0, Complex64::from(1.3));
        assert!((other.r_n() - 1.0).abs() <= 4.0 * f64::EPSILON);
        assert_eq!(other.t_n(), 0.0);
    }
}
