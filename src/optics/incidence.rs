//! The direction of an incident wave, without loss at either end of the quarter circle.

use crate::wide::Wide;
use num_complex::Complex64;

/// How a direction of incidence is given; the number is taken as exact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Direction {
    /// Angle to the normal [rad], 0 ≤ θ ≤ π/2.
    Angle(f64),
    /// Angle to the surface, δ = π/2 − θ [rad], 0 ≤ δ ≤ π/2: exact where θ itself could not tell neighbouring
    /// directions apart.
    Grazing(f64),
    /// cos θ [1], 0 ≤ cos θ ≤ 1.
    Cos(f64),
}

/// An angle of incidence as the pair (sin θ, cos θ), each accurate to rounding: near grazing the cosine, near the
/// normal the sine is what carries the digits. It remembers how it was given, for the few cases that need more.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Incidence {
    sin: f64,
    cos: f64,
    direction: Direction,
}

impl From<Direction> for Incidence {
    fn from(direction: Direction) -> Self {
        let (sin, cos) = match direction {
            Direction::Angle(theta) => (theta.sin(), theta.cos()),
            Direction::Grazing(delta) => (delta.cos(), delta.sin()),
            Direction::Cos(cos) => (((1.0 - cos) * (1.0 + cos)).sqrt(), cos),
        };
        debug_assert!((0.0..=1.0).contains(&sin) && (0.0..=1.0).contains(&cos), "{direction:?}");
        Self { sin, cos, direction }
    }
}

impl Incidence {
    /// Along the normal.
    pub const NORMAL: Self = Self { sin: 0.0, cos: 1.0, direction: Direction::Cos(1.0) };

    /// From the angle to the normal [rad], 0 ≤ θ ≤ π/2.
    pub fn from_angle(theta: f64) -> Self {
        Direction::Angle(theta).into()
    }

    /// From cos θ [1], 0 ≤ cos θ ≤ 1.
    pub fn from_cos(cos: f64) -> Self {
        Direction::Cos(cos).into()
    }

    /// sin θ [1].
    pub fn sin(self) -> f64 {
        self.sin
    }

    /// 1 − cos θ [1], with the digits that the subtraction would lose near the normal.
    pub fn versine(self) -> f64 {
        match self.direction {
            Direction::Angle(theta) => 2.0 * (0.5 * theta).sin().powi(2),
            Direction::Grazing(_) | Direction::Cos(_) => 1.0 - self.cos,
        }
    }

    /// cos θ [1].
    pub fn cos(self) -> f64 {
        self.cos
    }

    /// sin² θ with twice the digits.
    fn sin_squared(self) -> Wide {
        match self.direction {
            Direction::Angle(theta) => {
                let (sin, _) = Wide::sin_cos(theta);
                sin * sin
            }
            Direction::Grazing(delta) => {
                let (_, cos) = Wide::sin_cos(delta);
                cos * cos
            }
            Direction::Cos(cos) => Wide::from(1.0) - Wide::from(cos) * Wide::from(cos),
        }
    }
}

/// The direction in which a mirror sends on what runs along `direction`; `normal` is its unit normal, of either sense (E33).
pub fn mirrored(direction: [f64; 3], normal: [f64; 3]) -> [f64; 3] {
    let along: f64 = direction.iter().zip(normal).map(|(d, n)| d * n).sum();
    std::array::from_fn(|axis| direction[axis] - 2.0 * along * normal[axis])
}

/// The direction in which what runs along the unit vector `direction` goes on behind an interface between two clear media
/// (E33): the part along the interface is scaled by n_i/n_t, the part across it follows. `normal` is its unit normal, of
/// either sense. `None` where everything is reflected.
pub fn refracted(direction: [f64; 3], normal: [f64; 3], n_i: f64, n_t: f64) -> Option<[f64; 3]> {
    let across: f64 = direction.iter().zip(normal).map(|(d, n)| d * n).sum();
    let q = outgoing_root(normal_squared(Incidence::from_cos(across.abs().min(1.0)), n_i, n_t.into()));
    let go_on =
        |axis: usize| (n_i * (direction[axis] - across * normal[axis]) + q.re.copysign(across) * normal[axis]) / n_t;
    (q.im == 0.0).then(|| std::array::from_fn(go_on))
}

/// The square of the normal wave number over the vacuum wave number, (n cos θ_n)² = n² − n_i² sin² θ [1], of a
/// wave in the medium `n` whose tangential wave number was set in the clear medium `n_i`.
///
/// Near grazing n² − n_i² + (n_i cos θ)² keeps the digits that n² − (n_i sin θ)² would lose in rounding sin θ;
/// towards the normal it is the other way round (for n ≪ n_i). Near a critical angle both would leave only the
/// rounding of sin θ; there the difference is formed with twice the digits.
pub fn normal_squared(incidence: Incidence, n_i: f64, n: Complex64) -> Complex64 {
    let absorbed = n.im * n.im;
    let (re, size) = if incidence.cos < incidence.sin {
        let (contrast, n_i_cos) = ((n.re - n_i) * (n.re + n_i), n_i * incidence.cos);
        (contrast + n_i_cos * n_i_cos - absorbed, contrast.abs())
    } else {
        let n_i_sin = n_i * incidence.sin;
        ((n.re - n_i_sin) * (n.re + n_i_sin) - absorbed, n.re * n.re)
    };
    let re = if nearly_cancelled(re, size) { wide_difference(incidence, n_i, n, Wide::from(1.0)) } else { re };
    Complex64::new(re, 2.0 * n.re * n.im)
}

/// Re(n²) cos² θ − n_i² sin² θ [1], which vanishes at Brewster's angle of a clear medium; `square` is Re(n²).
pub(super) fn brewster_balance(incidence: Incidence, n_i: f64, n: Complex64, square: f64) -> f64 {
    let (cos, sin) = (incidence.cos, incidence.sin);
    if square < 0.0 {
        return square * cos * cos - n_i * n_i * sin * sin;
    }
    let (balance, size) = if square < n_i * n_i {
        // Out of the denser medium the same is Re(q²) − Re(n²) sin² θ, whose terms are the smaller ones: from the
        // critical angle on they have one sign.
        let taken = square * sin * sin;
        (normal_squared(incidence, n_i, n).re - taken, taken)
    } else {
        let (n_cos, n_sin, k_cos) = (n.re * cos, n_i * sin, n.im * cos);
        ((n_cos - n_sin) * (n_cos + n_sin) - k_cos * k_cos, n_sin * n_sin)
    };
    if nearly_cancelled(balance, size) {
        return wide_difference(incidence, n_i, n, Wide::from(1.0) - incidence.sin_squared());
    }
    balance
}

/// Whether a difference of terms of a given `size` is worth forming with twice the digits.
fn nearly_cancelled(difference: f64, size: f64) -> bool {
    difference.abs() < size / 64.0
}

/// Re(n²)·`weight` − n_i² sin² θ with twice the digits.
#[cold]
fn wide_difference(incidence: Incidence, n_i: f64, n: Complex64, weight: Wide) -> f64 {
    let [n_i, re, im] = [n_i, n.re, n.im].map(Wide::from);
    ((re * re - im * im) * weight - n_i * n_i * incidence.sin_squared()).into()
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
