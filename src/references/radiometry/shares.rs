//! Form factors as J. R. Howell's *Catalog of Radiation Heat Transfer Configuration Factors* prints them.

use yardstick::precise::{Real, pi, real_at};

/// 1 with the precision of `x`.
pub(super) fn one(x: &Real) -> Real {
    number(1.0, x)
}

/// `value` with the precision of `x`.
pub(super) fn number(value: f64, x: &Real) -> Real {
    real_at(value, x.precision())
}

/// π with the precision of `x`.
pub(super) fn pi_of(x: &Real) -> Real {
    pi(x.precision())
}

pub(super) fn parallel_rectangles(inputs: &[Real]) -> Real {
    let (x, y) = (&inputs[0] / &inputs[2], &inputs[1] / &inputs[2]);
    let one = one(&x);
    let (x2, y2) = (&one + &x * &x, &one + &y * &y);
    let log = (&x2 * &y2 / (&x2 + &y * &y)).ln() / number(2.0, &x);
    let side = |x: &Real, square: &Real| {
        let s = square.sqrt();
        x * &s * (x / &s).atan() - x * x.atan()
    };
    number(2.0, &x) / (pi_of(&x) * &x * &y) * (log + side(&x, &y2) + side(&y, &x2))
}

pub(super) fn perpendicular_rectangles(inputs: &[Real]) -> Real {
    let (w, h) = (&inputs[0] / &inputs[2], &inputs[1] / &inputs[2]);
    let one = one(&w);
    let (w2, h2) = (&w * &w, &h * &h);
    let sum = &w2 + &h2;
    let all = &one + &sum;
    let turned = |x: &Real| x * (&one / x).atan();
    let angles = turned(&w) + turned(&h) - turned(&sum.sqrt());
    let power = |square: &Real| square * (square * &all / ((&one + square) * &sum)).ln();
    let logs = ((&one + &w2) * (&one + &h2) / &all).ln() + power(&w2) + power(&h2);
    (angles + logs / number(4.0, &w)) / (pi_of(&w) * &w)
}

pub(super) fn coaxial_discs(inputs: &[Real]) -> Real {
    let [r1, r2, h] = [&inputs[0], &inputs[1], &inputs[2]];
    let ratio = r2 / r1;
    let square = &ratio * &ratio;
    let s = one(r1) + (h * h + r2 * r2) / (r1 * r1);
    (&s - (&s * &s - number(4.0, r1) * square).sqrt()) / number(2.0, r1)
}
