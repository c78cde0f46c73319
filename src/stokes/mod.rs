//! Polarised light: Stokes vectors, and Mueller matrices of what changes them.
//!
//! A beam goes along d, and x, y are axes across it with x × y = d. For fields e^(−iωt) its Stokes vector is
//! S₀ = ⟨|E_x|² + |E_y|²⟩, S₁ = ⟨|E_x|² − |E_y|²⟩, S₂ + iS₃ = 2⟨E_x* E_y⟩: S₁ > 0 along x, S₂ > 0 halfway from x to y, and S₃ > 0
//! where the field at a place turns from x to y, right-handed about d (IEEE Std 145; IAU, Trans. IAU 15B (1973) 166). Books that look
//! into the beam and call the same light left-handed have S₃ with the other sign.
//!
//! At an interface x is s, across the plane of incidence, for all three waves, and y = d × s is −p of the crate's conventions for
//! each of them: field ratios are then r_s, r_p (E36, E39) and t_s, t_p (E37, E40) as they stand.
//!
//! E. Collett, *Field Guide to Polarization* (2005); A. Wilkie and A. Weidlich, *How to write a polarisation ray tracer*, SIGGRAPH Asia
//! 2011 courses.

#[cfg(test)]
mod tests;

use crate::optics::Incidence;
use crate::optics::fresnel::{amplitudes, powers};
use num_complex::Complex64;

/// S₀ … S₃, in the unit of S₀.
pub type Stokes = [f64; 4];

/// Natural light of an intensity.
pub const fn natural(intensity: f64) -> Stokes {
    [intensity, 0.0, 0.0, 0.0]
}

/// The degree of polarisation [1]; not a number of no light.
pub fn degree([s_0, s_1, s_2, s_3]: Stokes) -> f64 {
    s_1.hypot(s_2).hypot(s_3) / s_0
}

/// The degree of polarisation [1] of natural light that is reflected at a surface of index `n` > 1 over that before it, of the angle of
/// incidence θ by `sin2` = sin² θ: 2 sin² θ u/(sin⁴ θ + u²) with u = cos θ √(n² − sin² θ). It is 1 where u = sin² θ, at Brewster's angle.
/// R_s − R_p has no digits near the normal, where this keeps its own.
pub fn reflected_degree(sin2: f64, n: f64) -> f64 {
    let cos2 = 1.0 - sin2;
    let u2 = cos2 * ((n - 1.0) * (n + 1.0) + cos2);
    2.0 * sin2 * u2.sqrt() / (sin2 * sin2 + u2)
}

/// What becomes of a Stokes vector [1].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mueller(pub [[f64; 4]; 4]);

impl Mueller {
    /// Nothing.
    pub const NOTHING: Self = Self([[0.0; 4]; 4]);

    /// What changes nothing.
    pub const IDENTITY: Self =
        Self([[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]]);

    /// What takes E_x to `a` E_x and E_y to `b` E_y.
    // ANCHOR: mueller
    pub fn of_fields(a: Complex64, b: Complex64) -> Self {
        let (x, y) = (a.norm_sqr(), b.norm_sqr());
        // 2⟨E_x* E_y⟩ = S₂ + iS₃ is turned and scaled as a whole.
        let both = a.conj() * b;
        let (mean, half) = (0.5 * (x + y), 0.5 * (x - y));
        Self([
            [mean, half, 0.0, 0.0],
            [half, mean, 0.0, 0.0],
            [0.0, 0.0, both.re, -both.im],
            [0.0, 0.0, both.im, both.re],
        ])
    }
    // ANCHOR_END: mueller

    /// The same light by axes turned by an angle [rad] from x to y.
    pub fn turn(angle: f64) -> Self {
        let (sin, cos) = (2.0 * angle).sin_cos();
        Self([[1.0, 0.0, 0.0, 0.0], [0.0, cos, sin, 0.0], [0.0, -sin, cos, 0.0], [0.0, 0.0, 0.0, 1.0]])
    }

    /// An ideal polariser whose axis is at an angle [rad] from x to y.
    pub fn polariser(angle: f64) -> Self {
        let (sin, cos) = (2.0 * angle).sin_cos();
        let row = [1.0, cos, sin, 0.0];
        Self([0, 1, 2, 3].map(|i| [0, 1, 2, 3].map(|j| 0.5 * row[i] * row[j])))
    }

    /// A surface that returns a share [1] of all light, and of it nothing but its intensity.
    pub fn depolariser(share: f64) -> Self {
        let mut all = Self::NOTHING;
        all.0[0][0] = share;
        all
    }

    /// Reflection at an interface from the clear medium `n_i` into `n_t`; domain as [`amplitudes`].
    pub fn reflection(incidence: Incidence, n_i: f64, n_t: Complex64) -> Self {
        let ratios = amplitudes(incidence, n_i, n_t);
        Self::of_fields(ratios.r_s, ratios.r_p)
    }

    /// Passage through an interface between clear media, as a share of power through it: with (n_t cos θ_t)/(n_i cos θ_i) |t|² and not
    /// with |t|² (E41). Nothing under total reflection.
    pub fn transmission(incidence: Incidence, n_i: f64, n_t: f64) -> Self {
        let (ratios, shares) = (amplitudes(incidence, n_i, n_t.into()), powers(incidence, n_i, n_t.into()));
        // Where light passes, both t are real and > 0; their powers keep the digits.
        let field = |share: f64, ratio: Complex64| Complex64::from(share.sqrt().copysign(ratio.re));
        Self::of_fields(field(shares.t_s, ratios.t_s), field(shares.t_p, ratios.t_p))
    }

    /// Of a mirror that returns a share [1] of any light: what a perfect conductor does to phases.
    pub fn mirror(share: f64) -> Self {
        let field = Complex64::from(share.sqrt());
        Self::of_fields(-field, field)
    }

    /// What becomes of a Stokes vector.
    pub fn apply(&self, light: Stokes) -> Stokes {
        self.0.map(|row| (0..4).map(|k| row[k] * light[k]).sum())
    }

    /// What is seen of light, by what is asked of it after this: a row times the matrix.
    pub fn asked(&self, row: [f64; 4]) -> [f64; 4] {
        [0, 1, 2, 3].map(|k| (0..4).map(|j| row[j] * self.0[j][k]).sum())
    }

    /// First `before`, then this.
    pub fn after(&self, before: &Self) -> Self {
        Self(self.0.map(|row| before.asked(row)))
    }

    /// The four eigenvalues' signs told by pivots: the largest by which the coherency matrix of the map fails to be one, ≤ 0 [1] of
    /// its trace (S. R. Cloude, *Optik* 75 (1986) 26): 0 for all that a mixture of fields' changes can do.
    pub fn impossible(&self) -> f64 {
        let [one, i, zero] = [Complex64::ONE, Complex64::I, Complex64::ZERO];
        // Of (E_x, E_y)ᵀ(E_x*, E_y*): ½ Σ S_k σ_k for S₂ + iS₃ = 2 E_x* E_y.
        let sigma = [
            [[one, zero], [zero, one]],
            [[one, zero], [zero, -one]],
            [[zero, one], [one, zero]],
            [[zero, -i], [i, zero]],
        ];
        let mut h = [[zero; 4]; 4];
        for (k, row) in self.0.iter().enumerate() {
            for (l, m) in row.iter().enumerate() {
                for (a, b) in (0..4).flat_map(|a| (0..4).map(move |b| (a, b))) {
                    h[a][b] += 0.25 * m * sigma[k][a / 2][b / 2] * sigma[l][a % 2][b % 2].conj();
                }
            }
        }
        let trace: f64 = (0..4).map(|k| h[k][k].re).sum();
        let mut worst: f64 = 0.0;
        // Cholesky with the largest pivot first: what is left after it must have none below 0.
        let mut left: Vec<usize> = (0..4).collect();
        while let Some(at) =
            (0..left.len()).max_by(|a, b| h[left[*a]][left[*a]].re.total_cmp(&h[left[*b]][left[*b]].re))
        {
            let pivot = left.swap_remove(at);
            let size = h[pivot][pivot].re;
            let least = left.iter().map(|k| h[*k][*k].re).fold(size, f64::min);
            worst = worst.min(least / trace);
            if size <= 1e-12 * trace {
                // Nothing may be left beside the diagonal either.
                let beside = left.iter().map(|k| h[pivot][*k].norm()).fold(0.0, f64::max);
                worst = worst.min(-beside / trace);
                continue;
            }
            for k in left.clone() {
                for l in left.clone() {
                    let part = h[k][pivot] * h[pivot][l] / size;
                    h[k][l] -= part;
                }
            }
        }
        worst
    }
}
