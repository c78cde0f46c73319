//! How fast bounces die out: the eigenvalues of ρF, which is symmetric but for a scale a patch.

use super::{Light, Network};

/// An eigenvalue [1] and its light: radiances whose bounce is themselves, times the eigenvalue.
#[derive(Clone, Debug, PartialEq)]
pub struct Mode {
    /// By how much a bounce changes it.
    pub value: f64,
    /// Radiance of each patch; its square, weighed by A/ρ, sums to 1.
    pub radiances: Vec<f64>,
}

/// All modes, the largest eigenvalue first, by Jacobi's rotations (*J. reine angew. Math.* 30 (1846) 51). Every patch must
/// reflect something. Work grows as n³.
pub fn modes(network: &Network, light: &Light) -> Vec<Mode> {
    let n = network.len();
    let weight: Vec<f64> = (0..n).map(|at| (light.reflected(at) / network.areas[at]).sqrt()).collect();
    let mut matrix: Vec<Vec<f64>> = (0..n)
        .map(|i| (0..n).map(|j| weight[i] * weight[j] * network.areas[i] * network.row(i)[j]).collect())
        .collect();
    let mut turned: Vec<Vec<f64>> = (0..n).map(|i| (0..n).map(|j| f64::from(u8::from(i == j))).collect()).collect();
    for _ in 0..MOST_SWEEPS {
        let off: f64 = (0..n).flat_map(|i| matrix[i][..i].iter()).map(|x| x * x).sum();
        if off <= (f64::EPSILON * f64::EPSILON) * n as f64 {
            break;
        }
        for p in 0..n {
            for q in p + 1..n {
                rotate(&mut matrix, &mut turned, p, q);
            }
        }
    }
    let mut modes: Vec<Mode> = (0..n)
        .map(|at| Mode {
            value: matrix[at][at],
            radiances: turned[at].iter().zip(&weight).map(|(part, weight)| part * weight).collect(),
        })
        .collect();
    modes.sort_by(|one, other| other.value.total_cmp(&one.value));
    modes
}

/// Convergence is quadratic; as many are never needed.
const MOST_SWEEPS: usize = 30;

/// Turns axes p and q until their entry vanishes; `turned` has the new axes as rows.
fn rotate(matrix: &mut [Vec<f64>], turned: &mut [Vec<f64>], p: usize, q: usize) {
    let between = matrix[p][q];
    if between == 0.0 {
        return;
    }
    let theta = (matrix[q][q] - matrix[p][p]) / (2.0 * between);
    let tan = theta.signum() / (theta.abs() + theta.hypot(1.0));
    let cos = 1.0 / tan.hypot(1.0);
    let sin = tan * cos;
    let turn = |a: &mut f64, b: &mut f64| (*a, *b) = (cos * *a - sin * *b, sin * *a + cos * *b);
    for row in matrix.iter_mut() {
        let (left, right) = row.split_at_mut(q);
        turn(&mut left[p], &mut right[0]);
    }
    for rows in [matrix, turned] {
        let (upper, lower) = rows.split_at_mut(q);
        upper[p].iter_mut().zip(lower[0].iter_mut()).for_each(|(a, b)| turn(a, b));
    }
}

/// The condition number [1] of the symmetric form of 1 − ρF, by its modes.
pub fn condition(modes: &[Mode]) -> f64 {
    match modes {
        [first, .., last] => (1.0 - last.value) / (1.0 - first.value),
        _ => 1.0,
    }
}

/// The factor [1] by which the error of the series falls a term, in the end: the largest |eigenvalue|.
pub fn radius(modes: &[Mode]) -> f64 {
    modes.iter().map(|mode| mode.value.abs()).fold(0.0, f64::max)
}
