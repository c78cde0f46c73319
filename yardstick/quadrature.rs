//! Quadrature rules, for integrals that have a second route.

use std::f64::consts::PI;

/// Nodes and weights of the n-point Gauss–Legendre rule on 0 … 1, n ≥ 1: exact for polynomials of degree 2n − 1.
/// Newton's iteration on Legendre's recurrence from Tricomi's guess (Press et al., *Numerical Recipes*, §4.6).
pub fn gauss_legendre(n: usize) -> Vec<(f64, f64)> {
    let count = n as f64;
    let node = |at: usize| {
        let mut x = (PI * (at as f64 + 0.75) / (count + 0.5)).cos();
        let mut slope = 1.0;
        for _ in 0..100 {
            let (mut value, mut before) = (1.0, 0.0);
            for degree in 1..=n {
                let degree = degree as f64;
                (value, before) = (((2.0 * degree - 1.0) * x * value - (degree - 1.0) * before) / degree, value);
            }
            slope = count * (x * value - before) / (x * x - 1.0);
            let step = value / slope;
            x -= step;
            if step.abs() < 1e-15 {
                break;
            }
        }
        (0.5 * (1.0 - x), 1.0 / ((1.0 - x * x) * slope * slope))
    };
    (0..n).map(node).collect()
}

/// ∫ f dx from `from` to `to` by the n-point Gauss–Legendre rule, n ≥ 1, in the unit of f times that of x.
pub fn gauss(n: usize, from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
    let length = to - from;
    gauss_legendre(n).into_iter().map(|(at, weight)| weight * length * f(from + at * length)).sum()
}

/// Nodes and weights of the trapezoid with n ≥ 1 intervals on 0 … 1: order 2, but exponentially accurate over a whole
/// period of a smooth periodic function, exact up to its harmonic n − 1 (Trefethen & Weideman, SIAM Rev. 56 (2014) 385).
pub fn trapezoid(n: usize) -> Vec<(f64, f64)> {
    let weight = |at: usize| if at == 0 || at == n { 0.5 } else { 1.0 };
    (0..=n).map(|at| (at as f64 / n as f64, weight(at) / n as f64)).collect()
}

/// Nodes and weights of Simpson's rule with n intervals, even and ≥ 2, on 0 … 1: order 4.
///
/// # Panics
/// If n is odd or 0.
pub fn simpson(n: usize) -> Vec<(f64, f64)> {
    assert!(n > 0 && n.is_multiple_of(2), "Simpson's rule needs an even number of intervals, not {n}");
    let weight = |at: usize| if at == 0 || at == n { 1.0 } else { [2.0, 4.0][at % 2] };
    (0..=n).map(|at| (at as f64 / n as f64, weight(at) / (3 * n) as f64)).collect()
}

#[cfg(test)]
mod tests {
    use super::{gauss_legendre, simpson, trapezoid};
    use crate::order::slope;

    #[test]
    fn composite_rules_have_their_orders() {
        let error = |rule: Vec<(f64, f64)>| {
            let integral: f64 = rule.iter().map(|(x, w)| w * x.exp()).sum();
            (integral - 1.0_f64.exp_m1()).abs()
        };
        for (rule, order) in [(trapezoid as fn(usize) -> Vec<(f64, f64)>, 2.0), (simpson, 4.0)] {
            let points: Vec<_> = (2..7).map(|k| (f64::from(1 << k), error(rule(1 << k)))).collect();
            assert!((slope(&points).unwrap() + order).abs() < 0.02);
        }
    }

    #[test]
    fn integrates_every_polynomial_it_should() {
        for n in 1..=40 {
            let rule = gauss_legendre(n);
            for power in 0..2 * n as i32 {
                let integral: f64 = rule.iter().map(|(x, w)| w * x.powi(power)).sum();
                let exact = 1.0 / f64::from(power + 1);
                assert!((integral - exact).abs() < 1e-14, "n = {n}, power {power}: {integral}");
            }
        }
    }
}
