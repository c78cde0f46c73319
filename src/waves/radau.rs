//! Radau IIA with three stages for one equation y′ = f(t, y): order 5 and L-stable, so that what is much faster than
//! its steps dies instead of limiting them.
//!
//! E. Hairer & G. Wanner, *Solving Ordinary Differential Equations II* (2nd ed., 1996): §IV.5, table 5.6 (coefficients);
//! §IV.8 (Newton's iteration, the estimate of the error, the choice of the step; their program is RADAU5).

use std::fmt;

/// √6.
const ROOT: f64 = 2.449_489_742_783_178;
/// Where the stages stand in the step.
const C: [f64; 3] = [(4.0 - ROOT) / 10.0, (4.0 + ROOT) / 10.0, 1.0];
/// What each stage takes of f at the stages. The last one ends the step.
const A: [[f64; 3]; 3] = [
    [(88.0 - 7.0 * ROOT) / 360.0, (296.0 - 169.0 * ROOT) / 1800.0, (-2.0 + 3.0 * ROOT) / 225.0],
    [(296.0 + 169.0 * ROOT) / 1800.0, (88.0 + 7.0 * ROOT) / 360.0, (-2.0 - 3.0 * ROOT) / 225.0],
    [(16.0 - ROOT) / 36.0, (16.0 + ROOT) / 36.0, 1.0 / 9.0],
];
/// What the embedded formula of order 3 makes of the stages, (8.19) over γ₀.
const EMBEDDED: [f64; 3] = [(-13.0 - 7.0 * ROOT) / 3.0, (-13.0 + 7.0 * ROOT) / 3.0, -1.0 / 3.0];
/// 1/γ₀, the real eigenvalue of A⁻¹: 30/(6 + ∛81 − ∛9).
const EIGENVALUE: f64 = 3.637_834_252_744_496;

/// An equation y′ = f(t, y).
#[derive(Clone, Copy, Debug)]
pub struct Equation<F, J> {
    /// f(t, y).
    pub rate: F,
    /// ∂f/∂y at (t, y).
    pub slope: J,
}

/// What a run with steps of its own choice found, and at what cost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found {
    /// y at the end.
    pub y: f64,
    /// Evaluations of f.
    pub evaluations: u64,
    /// Steps tried.
    pub steps: u64,
}

/// No step was short enough, or there were too many.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stuck {
    /// The t that was reached.
    pub at: f64,
    /// The last step tried.
    pub step: f64,
}

impl fmt::Display for Stuck {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the solver is stuck at t = {:e} with a step of {:e}", self.at, self.step)
    }
}

impl std::error::Error for Stuck {}

/// Newton's iterations in a step: with the slope of its start, each gains digits or the step is too long.
const ITERATIONS: u64 = 30;
/// The first step of a run, as a share of the whole.
const FIRST: f64 = 1.0 / 64.0;
/// Most steps of a run.
const MOST: u64 = 1_000_000;

impl<F: Fn(f64, f64) -> f64, J: Fn(f64, f64) -> f64> Equation<F, J> {
    /// y at t = `to` from `y` at t = `from` with steps of its own choice at a relative and absolute `tolerance` > 0: a
    /// 64th of the whole at first, and always a half, a quarter, … of it, so that their sum is exact.
    ///
    /// The estimate is of order 3, the result of order 5. As in RADAU5, the estimate is held to 0.1·tolerance^(2/3): steps
    /// then go as tolerance^(1/6), as those of order 5 with a local error within the tolerance do, and the error at the
    /// end goes as tolerance^(5/6).
    ///
    /// # Errors
    /// If no step satisfies the tolerance, or a million do not suffice.
    pub fn adapt(&self, [from, to]: [f64; 2], mut y: f64, tolerance: f64) -> Result<Found, Stuck> {
        let held = 0.1 * tolerance.powf(2.0 / 3.0);
        // How far it has come, and the step, as shares of the whole.
        let (mut done, mut share, mut refused, mut evaluations) = (0.0, FIRST, false, 0);
        for steps in 1..=MOST {
            let (t, h) = (from + done * (to - from), share * (to - from));
            let (scale, rate, slope) = (held * (1.0 + y.abs()), (self.rate)(t, y), (self.slope)(t, y));
            evaluations += 1;
            // A step much longer than solutions take to part would have them meet: its factor vanishes there, too.
            let resolved = h * slope <= 1.0;
            let stages = resolved.then(|| self.stages(t, y, h, slope, 0.01 * scale, &mut evaluations)).flatten();
            let measured = stages.map_or(f64::INFINITY, |z| {
                let error = |rate: f64| (dot(EMBEDDED, z) + h * rate) / (EIGENVALUE - h * slope);
                let mut estimate = error(rate);
                // At the start and after a refusal there may be a fast part, which the step will forget: (8.20).
                if (steps == 1 || refused) && estimate.abs() >= scale {
                    estimate = error((self.rate)(t, y + estimate));
                    evaluations += 1;
                }
                estimate.abs() / scale
            });
            let change = if measured.is_finite() { (0.9 * measured.powf(-0.25)).clamp(0.2, 8.0) } else { 0.2 };
            let mut next = share * change;
            match stages {
                Some(z) if measured < 1.0 => {
                    (done, y) = (done + share, y + z[2]);
                    if done == 1.0 {
                        return Ok(Found { y, evaluations, steps });
                    }
                    next = if refused { next.min(share) } else { next }.min(1.0 - done);
                    refused = false;
                }
                _ => refused = true,
            }
            share = power_of_two_below(next);
            if done + share == done {
                return Err(Stuck { at: t, step: h });
            }
        }
        Err(Stuck { at: from + done * (to - from), step: share * (to - from) })
    }

    /// y at t = `to` from `y` at t = `from` by `steps` ≥ 1 equal steps; NaN if the stages of one are not found.
    pub fn march(&self, [from, to]: [f64; 2], y: f64, steps: u64) -> f64 {
        let h = (to - from) / steps as f64;
        (0..steps).fold(y, |y, at| {
            let t = from + at as f64 * h;
            let within = 8.0 * f64::EPSILON * (1.0 + y.abs());
            self.stages(t, y, h, (self.slope)(t, y), within, &mut 0).map_or(f64::NAN, |z| y + z[2])
        })
    }

    /// What the stages of a step `h` add to `y`: Z = hA f(t + ch, y + Z), by Newton's iteration with the slope at the
    /// start until it changes Z by less than `within`; `None` if it does not settle.
    fn stages(&self, t: f64, y: f64, h: f64, slope: f64, within: f64, evaluations: &mut u64) -> Option<[f64; 3]> {
        // Over 1 + |h ∂f/∂y|, so that no product of three leaves the range.
        let (stiffness, unit) = (h * slope, (1.0 + (h * slope).abs()).recip());
        let columns = [0, 1, 2].map(|j| [0, 1, 2].map(|i| (f64::from(u8::from(i == j)) - stiffness * A[i][j]) * unit));
        let mut z = [0.0; 3];
        for _ in 0..ITERATIONS {
            let rates = [0, 1, 2].map(|i| h * (self.rate)(t + C[i] * h, y + z[i]));
            *evaluations += 3;
            let change = solve(columns, [0, 1, 2].map(|i| (dot(A[i], rates) - z[i]) * unit));
            z = [0, 1, 2].map(|i| z[i] + change[i]);
            if change.iter().all(|change| change.abs() <= within) {
                return Some(z);
            }
        }
        None
    }
}

/// The largest power of two that a normal `x` > 0 reaches.
fn power_of_two_below(x: f64) -> f64 {
    f64::from_bits(x.to_bits() & f64::INFINITY.to_bits())
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// x of Mx = b by Cramer's rule, M by its columns.
fn solve([a, b, c]: [[f64; 3]; 3], right: [f64; 3]) -> [f64; 3] {
    let cross =
        |a: [f64; 3], b: [f64; 3]| [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    let determinant = dot(a, cross(b, c));
    [dot(right, cross(b, c)), dot(a, cross(right, c)), dot(a, cross(b, right))].map(|minor| minor / determinant)
}

#[cfg(test)]
mod tests {
    use super::*;
    use yardstick::order;

    #[test]
    fn coefficients_integrate_powers_exactly() {
        for power in 1..=5 {
            let rates = C.map(|c| f64::from(power) * c.powi(power - 1));
            // The stages up to order 3, the step up to order 5.
            let stages = if power <= 3 { 0..3 } else { 2..3 };
            for i in stages {
                assert!((dot(A[i], rates) - C[i].powi(power)).abs() < 4.0 * f64::EPSILON, "stage {i}, power {power}");
            }
            // The embedded formula up to order 3, with its share of f at the start.
            let embedded = dot(EMBEDDED, C.map(|c| c.powi(power))) + f64::from(u8::from(power == 1));
            assert_eq!(embedded.abs() < 16.0 * f64::EPSILON, power <= 3, "power {power}: {embedded}");
        }
        let eigenvalue = 30.0 / (6.0 + 81f64.cbrt() - 9f64.cbrt());
        assert!((EIGENVALUE / eigenvalue - 1.0).abs() < 4.0 * f64::EPSILON && (ROOT * ROOT - 6.0).abs() < 2e-15);
    }

    fn fitted(steps: &[u64], error: impl Fn(u64) -> f64) -> f64 {
        let points: Vec<_> = steps.iter().map(|&n| (n as f64, error(n).abs())).collect();
        -order::slope(&points).unwrap()
    }

    #[test]
    fn the_order_is_5_where_steps_resolve_what_happens() {
        // y′ = y cos t, linear, and y′ = −2ty², not.
        let growth = Equation { rate: |t: f64, y: f64| y * t.cos(), slope: |t: f64, _: f64| t.cos() };
        let found = fitted(&[4, 8, 16, 32, 64], |n| growth.march([0.0, 2.0], 1.0, n) - 2f64.sin().exp());
        assert!((found - 5.0).abs() < 0.2, "{found}");
        let bell = Equation { rate: |t: f64, y: f64| -2.0 * t * y * y, slope: |t: f64, y: f64| -4.0 * t * y };
        let found = fitted(&[8, 16, 32, 64, 128], |n| bell.march([0.0, 2.0], 1.0, n) - 0.2);
        assert!((found - 5.0).abs() < 0.2, "{found}");
    }

    #[test]
    fn a_step_multiplies_by_its_rational_function_which_vanishes_far_out() {
        // Hairer & Wanner, table 3.1: the subdiagonal Padé approximation (2, 3) of e^z.
        for z in [-1e-3, -0.1, -1.0, -10.0, -1e3, -1e6, -1e12, -1e100, 0.5] {
            let decay = Equation { rate: |_, y: f64| z * y, slope: |_, _| z };
            let below = 1.0 - 0.6 * z + 0.15 * z * z - z * z * z / 60.0;
            let exact = if below.is_finite() { (1.0 + 0.4 * z + 0.05 * z * z) / below } else { 0.0 };
            let found = decay.march([0.0, 1.0], 1.0, 1);
            assert!((found - exact).abs() < 1e-14, "{z}: {found} {exact}");
            assert!(z > 0.0 || found.abs() < 1.0);
        }
    }

    /// A. Prothero & A. Robinson, *Math. Comp.* 28, 145 (1974): y′ = λ(y − φ) + φ′, whose solution from φ(0) is φ.
    #[test]
    fn stiffness_costs_orders_but_not_digits() {
        let phi = |t: f64| (1.0 + t).sin();
        for stiffness in [1e6, 1e9, 1e12, 1e100] {
            let robinson = Equation {
                rate: |t: f64, y: f64| -stiffness * (y - phi(t)) + (1.0 + t).cos(),
                slope: |_, _| -stiffness,
            };
            let error = |start: f64, n: u64| robinson.march([0.0, 1.0], start, n) - phi(1.0);
            // The stages are of order 3, and what they miss of φ, h⁴, is over λh: h³/λ.
            if stiffness == 1e6 {
                let found = fitted(&[2, 4, 8, 16, 32], |n| error(phi(0.0), n));
                assert!((found - 3.0).abs() < 0.1, "{found}");
            }
            // A start that is not φ is forgotten, by 3/(λh) a step.
            for start in [phi(0.0), phi(0.0) + 1.0] {
                let far = error(start, 4).abs();
                assert!(far < 0.02 / stiffness + 8.0 * f64::EPSILON, "λ = −{stiffness:e} from {start}: {far:e}");
            }
        }
    }

    #[test]
    fn newton_finds_the_stages_of_a_stiff_equation_that_is_not_linear() {
        // Logistic growth by a factor of 999 within 1e−3 of the run, then a balance of great stiffness.
        let rate = 1e4;
        let growth = Equation { rate: |_, y: f64| rate * y * (1.0 - y), slope: |_, y: f64| rate * (1.0 - 2.0 * y) };
        for end in [5e-4, 1e-3, 1.0] {
            for tolerance in [1e-4, 1e-6, 1e-8, 1e-10] {
                let found = growth.adapt([0.0, end], 1e-3, tolerance).unwrap();
                let exact = 1.0 / (1.0 + 999.0 * (-rate * end).exp());
                let error = (found.y - exact).abs();
                assert!(error < 100.0 * tolerance, "{end} at {tolerance:e}: {error:e}, {found:?}");
            }
        }
    }

    #[test]
    fn the_error_goes_as_the_tolerance_to_five_sixths() {
        let growth = Equation { rate: |t: f64, y: f64| y * t.cos(), slope: |t: f64, _: f64| t.cos() };
        // Halving steps, sixth powers of the tolerance: a step of the stairs.
        let tolerances = (0..4).map(|k| 1e-5 / 64f64.powi(k));
        let points: Vec<_> = tolerances
            .map(|tolerance| {
                (tolerance, (growth.adapt([0.0, 2.0], 1.0, tolerance).unwrap().y - 2f64.sin().exp()).abs())
            })
            .collect();
        let found = order::slope(&points).unwrap();
        assert!((found - 5.0 / 6.0).abs() < 0.08, "{found}: {points:?}");
    }

    #[test]
    fn a_solution_that_ends_is_told_with_its_end() {
        // y′ = y² from 1 ends at t = 1.
        let explosion = Equation { rate: |_, y: f64| y * y, slope: |_, y: f64| 2.0 * y };
        let stuck = explosion.adapt([0.0, 2.0], 1.0, 1e-6).unwrap_err();
        assert!((stuck.at - 1.0).abs() < 1e-3, "{stuck}");
        let nowhere = Equation { rate: |_, _| f64::NAN, slope: |_, _| 0.0 };
        assert_eq!(nowhere.adapt([0.0, 1.0], 1.0, 1e-6).unwrap_err().at, 0.0);
    }
}
