//! The direction of an incident wave, without loss at either end of the quarter circle.

use num_complex::Complex64;

/// An angle of incidence, kept as the pair (sin θ, cos θ), each accurate to rounding: near grazing the
/// cosine, near the normal the sine is what carries the digits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Incidence {
    sin: f64,
    cos: f64,
}

impl Incidence {
    /// Along the normal.
    pub const NORMAL: Self = Self { sin: 0.0, cos: 1.0 };

    /// From the angle to the normal [rad], 0 ≤ θ ≤ π/2.
    pub fn from_angle(theta: f64) -> Self {
        debug_assert!((0.0..=std::f64::consts::FRAC_PI_2).contains(&theta));
        Self { sin: theta.sin(), cos: theta.cos() }
    }

    /// From the angle to the surface, δ = π/2 − θ [rad], 0 ≤ δ ≤ π/2: exact where θ itself could not
    /// tell neighbouring directions apart.
    pub fn from_grazing(delta: f64) -> Self {
        debug_assert!((0.0..=std::f64::consts::FRAC_PI_2).contains(&delta));
        Self { sin: delta.cos(), cos: delta.sin() }
    }

    /// From cos θ [1], 0 ≤ cos θ ≤ 1.
    pub fn from_cos(cos: f64) -> Self {
        debug_assert!((0.0..=1.0).contains(&cos));
        Self { sin: ((1.0 - cos) * (1.0 + cos)).sqrt(), cos }
    }

    /// sin θ [1].
    pub fn sin(self) -> f64 {
        self.sin
    }

    /// cos θ [1].
    pub fn cos(self) -> f64 {
        self.cos
    }
}

/// The square of the normal wave number over the vacuum wave number, (n cos θ_n)² = n² − n_i² sin² θ [1], of a
/// wave in the medium `n` whose tangential wave number was set in the clear medium `n_i`.
///
/// Near grazing n² − n_i² + (n_i cos θ)² keeps the digits that n² − (n_i sin θ)² would lose in rounding sin θ;
/// towards the normal it is the other way round (for n ≪ n_i).
pub fn normal_squared(incidence: Incidence, n_i: f64, n: Complex64) -> Complex64 {
    let re = if incidence.cos < incidence.sin {
        let n_i_cos = n_i * incidence.cos;
        (n.re - n_i) * (n.re + n_i) + n_i_cos * n_i_cos - n.im * n.im
    } else {
        let n_i_sin = n_i * incidence.sin;
        (n.re - n_i_sin) * (n.re + n_i_sin) - n.im * n.im
    };
    Complex64::new(re, 2.0 * n.re * n.im)
}

/// The square root with an imaginary part ≥ 0 and a real part ≥ 0 of a `square` with an imaginary part ≥ 0:
/// the wave that runs, or decays, away from where it comes from. Both parts keep their relative accuracy.
pub fn outgoing_root(square: Complex64) -> Complex64 {
    let (a, b) = (square.re, square.im);
    debug_assert!(b >= 0.0);
    if b == 0.0 {
        return if a >= 0.0 { Complex64::new(a.sqrt(), 0.0) } else { Complex64::new(0.0, (-a).sqrt()) };
    }
    // Kahan (1987): the larger part by a sum without cancellation, the smaller from the product 2·re·im = b.
    let larger = ((a.abs() + a.hypot(b)) * 0.5).sqrt();
    let smaller = 0.5 * b / larger;
    if a >= 0.0 { Complex64::new(larger, smaller) } else { Complex64::new(smaller, larger) }
}
