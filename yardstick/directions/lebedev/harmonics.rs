//! Spherical harmonics with the symmetry of the cube: all that a rule of that symmetry can get wrong.

use super::super::Direction;

/// One harmonic of degree l and order m, a multiple of 4, made even under all 48 symmetries by the mean over its three
/// axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Harmonic {
    degree: usize,
    order: usize,
}

/// As many harmonics of even degree up to `degree` as there are linearly independent ones: the cube's invariants are
/// polynomials in I₄ = x⁴ + y⁴ + z⁴ and I₆ = x²y²z², so degree l holds one for every way to write l as 4i + 6j.
pub fn invariants(degree: usize) -> Vec<Harmonic> {
    let of_degree = |l: usize| {
        let independent = (0..=l / 6).filter(|j| (l - 6 * j).is_multiple_of(4)).count();
        (0..independent).map(move |k| Harmonic { degree: l, order: 4 * k })
    };
    (0..=degree).step_by(2).flat_map(of_degree).collect()
}

/// The value of each of `harmonics` at a direction, and its gradient in space.
pub fn values(harmonics: &[Harmonic], at: Direction) -> Vec<(f64, [f64; 3])> {
    let top = harmonics.iter().map(|harmonic| harmonic.degree).max().unwrap_or(0);
    let mut sums = vec![(0.0, [0.0; 3]); harmonics.len()];
    for axis in 0..3 {
        let [x, y, z] = [(axis + 1) % 3, (axis + 2) % 3, axis];
        let table: Vec<_> = (0..=top).step_by(4).map(|m| column(top, m, [at[x], at[y], at[z]])).collect();
        for (sum, harmonic) in sums.iter_mut().zip(harmonics) {
            let (value, gradient) = table[harmonic.order / 4][harmonic.degree - harmonic.order];
            sum.0 += value / 3.0;
            for (part, along) in gradient.into_iter().zip([x, y, z]) {
                sum.1[along] += part / 3.0;
            }
        }
    }
    sums
}

/// The real harmonics Q_l(z) Re (x + iy)^m of l = m … `top`, of mean square 1, and their gradients as polynomials.
fn column(top: usize, m: usize, [x, y, z]: Direction) -> Vec<(f64, [f64; 3])> {
    let turned = num_complex::Complex64::new(x, y);
    let around = turned.powu(m as u32);
    let slope = if m == 0 { num_complex::Complex64::ZERO } else { m as f64 * turned.powu(m as u32 - 1) };
    let first: f64 = (1..=m).map(|k| ((2 * k + 1) as f64 / (2 * k) as f64).sqrt()).product();
    // (Q_l, dQ_l/dz) and the pair before it.
    let mut now = (if m == 0 { first } else { first * std::f64::consts::SQRT_2 }, 0.0);
    let mut before = (0.0, 0.0);
    let mut found = Vec::with_capacity(top - m + 1);
    for l in m..=top {
        if l > m {
            let [l, m] = [l as f64, m as f64];
            let span = (l - m) * (l + m);
            let rise = ((2.0 * l + 1.0) * (2.0 * l - 1.0) / span).sqrt();
            // Before l = m + 1 stands nothing: the factor is 0 there.
            let fall = ((2.0 * l + 1.0) * (l - 1.0 - m) * (l - 1.0 + m) / ((2.0 * l - 3.0) * span)).max(0.0).sqrt();
            let next = (rise * z * now.0 - fall * before.0, rise * (now.0 + z * now.1) - fall * before.1);
            (before, now) = (now, next);
        }
        found.push((now.0 * around.re, [now.0 * slope.re, -now.0 * slope.im, now.1 * around.re]));
    }
    found
}
