//! Quadrature rules whose nodes have closed forms.

use std::f64::consts::{FRAC_PI_2, PI};

/// A node of a rule on 0 … 1.
#[derive(Clone, Copy, Debug)]
pub struct Node {
    /// Where it lies.
    pub at: f64,
    /// 1 − `at`, with its own digits.
    pub left: f64,
    /// Its weight; they sum up to 1.
    pub weight: f64,
}

/// Fejér's first rule of `n` nodes: exact for polynomials of degree n − 1, and for analytic functions about as good as
/// Gauss's (L. N. Trefethen, SIAM Rev. 50 (2008) 67).
pub fn fejer(n: usize) -> Vec<Node> {
    let count = n as f64;
    let node = |k: usize| {
        let theta = PI * (k as f64 + 0.5) / count;
        let dip = |j: usize| (2.0 * j as f64 * theta).cos() / (4 * j * j - 1) as f64;
        let weight = (1.0 - 2.0 * (1..=n / 2).map(dip).sum::<f64>()) / count;
        Node { at: (0.5 * theta).sin().powi(2), left: (0.5 * theta).cos().powi(2), weight }
    };
    (0..n).map(node).collect()
}

/// The double exponential rule of `n` nodes, whose nodes crowd at both ends (H. Takahasi and M. Mori, Publ. RIMS 9 (1974)
/// 721).
pub fn tanh_sinh(n: usize) -> Vec<Node> {
    // Beyond, weights are below 1e−17.
    const REACH: f64 = 3.2;
    let step = 2.0 * REACH / (n - 1) as f64;
    let node = |k: usize| {
        let t = -REACH + step * k as f64;
        let grown = (2.0 * FRAC_PI_2 * t.sinh()).exp();
        let (at, left) = (grown / (1.0 + grown), 1.0 / (1.0 + grown));
        Node { at, left, weight: step * PI * t.cosh() * at * left }
    };
    (0..n).map(node).collect()
}

/// The `k`-th of `n` points of the square whose second coordinates step by the golden section: sums over them see no rows,
/// and converge faster than a grid's across edges.
pub fn golden(k: usize, n: usize) -> [f64; 2] {
    const INVERSE: f64 = 0.618_033_988_749_894_8;
    [(k as f64 + 0.5) / n as f64, (k as f64 * INVERSE).fract()]
}

#[cfg(test)]
mod tests {
    use super::{Node, fejer, tanh_sinh};

    fn integral(rule: &[Node], f: impl Fn(f64) -> f64) -> f64 {
        rule.iter().map(|node| node.weight * f(node.at)).sum()
    }

    #[test]
    fn fejers_rule_is_exact_for_polynomials() {
        for n in 1..=40 {
            for power in 0..n as i32 {
                let exact = 1.0 / f64::from(power + 1);
                assert!((integral(&fejer(n), |x| x.powi(power)) - exact).abs() < 1e-14, "n {n}, power {power}");
            }
        }
    }

    #[test]
    fn the_double_exponential_rule_bears_roots_and_logarithms_at_the_ends() {
        let rule = tanh_sinh(64);
        assert!((integral(&rule, |x| x.sqrt().recip()) - 2.0).abs() < 1e-7);
        assert!((integral(&rule, |x| -x.ln()) - 1.0).abs() < 1e-14);
        for node in rule {
            assert!((node.at + node.left - 1.0).abs() < 1e-15);
        }
    }
}
