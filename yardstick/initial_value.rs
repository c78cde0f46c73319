//! Ordinary differential equations stepped from their start, for answers that have a second route.

use std::ops::{Add, Mul};

/// y after one step h of y′ = `rate`(y) by the classic method of fourth order (Kutta 1901), in the unit of y.
pub fn runge_kutta<T, const N: usize>(y: [T; N], h: f64, rate: impl Fn([T; N]) -> [T; N]) -> [T; N]
where
    T: Copy + Add<Output = T> + Mul<f64, Output = T>,
{
    let moved = |by: [T; N], share: f64| std::array::from_fn(|at| y[at] + by[at] * (h * share));
    let first = rate(y);
    let second = rate(moved(first, 0.5));
    let third = rate(moved(second, 0.5));
    let fourth = rate(moved(third, 1.0));
    std::array::from_fn(|at| y[at] + (first[at] + (second[at] + third[at]) * 2.0 + fourth[at]) * (h / 6.0))
}

#[cfg(test)]
mod tests {
    use super::runge_kutta;
    use crate::order::slope;

    #[test]
    fn turns_a_circle_with_order_four() {
        let error = |steps: u32| {
            let turned = (0..steps).fold([1.0, 0.0], |y, _| runge_kutta(y, 1.0 / f64::from(steps), |[x, y]| [-y, x]));
            (turned[0] - 1.0_f64.cos()).hypot(turned[1] - 1.0_f64.sin())
        };
        let points: Vec<_> = [8, 16, 32, 64].map(|steps| (f64::from(steps), error(steps))).into();
        assert!((slope(&points).unwrap() + 4.0).abs() < 0.05);
    }
}
