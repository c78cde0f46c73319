//! Whether a mean is what it should be, or two are alike.

use super::Moments;
use super::tails::student_two_sided;

/// How far two means may be apart for rounding alone, in units of ε times the larger: the project's promise of
/// accuracy. A test looks only at what is beyond. Without it a sampler whose every weight is 1 up to rounding would be
/// refused for the last digit, in which its numbers do not scatter; numbers that do scatter never notice.
pub const ROUNDING: f64 = 16.0;

/// What a test of means found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeanTest {
    /// The deviation beyond rounding over its standard error [1].
    pub statistic: f64,
    /// Degrees of freedom [1]; infinite where the standard error is taken as known.
    pub dof: f64,
    /// How often a true claim looks at least as bad [1], two-sided; NaN if there were too few numbers to tell.
    pub p: f64,
}

impl MeanTest {
    fn new(one: f64, other: f64, standard_error: f64, dof: f64) -> Self {
        let rounding = ROUNDING * f64::EPSILON * one.abs().max(other.abs());
        // Spelt out, for `max` would swallow NaN.
        let gap = (one - other).abs();
        let beyond = if gap <= rounding { 0.0 } else { gap - rounding };
        // Where nothing scatters, equal means are 0/0 and stand, unequal ones have infinite odds against them.
        let statistic = if beyond == 0.0 && standard_error >= 0.0 { 0.0 } else { beyond / standard_error };
        // Infinities are overflows, not a reason to let everything pass.
        let is_tested = [one, other, standard_error].into_iter().all(f64::is_finite);
        let p = if is_tested { student_two_sided(statistic, dof) } else { f64::NAN };
        Self { statistic: statistic.copysign(one - other), dof, p }
    }
}

/// Student's t-test of the claim that the numbers behind `sample` have the mean `expected`, in their unit. Exact for
/// normal numbers; for others it becomes so as they grow many, in the far tail last. A sample without scatter passes
/// (p = 1) if its mean is `expected` up to [`ROUNDING`] and else fails (p = 0). NaN for fewer than two numbers.
pub fn t_test(sample: &Moments, expected: f64) -> MeanTest {
    MeanTest::new(sample.mean(), expected, sample.standard_error(), sample.count().saturating_sub(1) as f64)
}

/// The z-test of the claim that `mean` is `expected`, where the mean's `standard_error` (in the same unit) is known or
/// comes from so many numbers that it might as well be. Without scatter as [`t_test`].
pub fn z_test(mean: f64, standard_error: f64, expected: f64) -> MeanTest {
    MeanTest::new(mean, expected, standard_error, f64::INFINITY)
}

/// Welch's test of the claim that two samples have one mean, whatever their variances (B. L. Welch, *Biometrika* 34
/// (1947) 28), with Satterthwaite's degrees of freedom. Without scatter as [`t_test`]; NaN if either has fewer than two
/// numbers.
pub fn welch(one: &Moments, other: &Moments) -> MeanTest {
    let (u, v) = (one.standard_error(), other.standard_error());
    let error = u.hypot(v);
    let freedom = |moments: &Moments| moments.count().saturating_sub(1) as f64;
    // By shares, so that tiny errors do not underflow in the fourth power. Without scatter the number does not matter.
    let share = |part: f64| if error == 0.0 { 0.5 } else { (part / error).powi(2) };
    let dof = 1.0 / (share(u).powi(2) / freedom(one) + share(v).powi(2) / freedom(other));
    MeanTest::new(one.mean(), other.mean(), error, dof)
}

#[cfg(test)]
mod tests {
    use super::{ROUNDING, t_test, welch, z_test};
    use crate::statistics::Moments;
    use proptest::prelude::*;

    fn moments(numbers: &[f64]) -> Moments {
        numbers.iter().copied().collect()
    }

    /// Student's own example (*Biometrika* 6 (1908) 1): hours of sleep gained with two drugs by ten patients.
    const FIRST: [f64; 10] = [0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0];
    const SECOND: [f64; 10] = [1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4];

    #[test]
    fn infinite_means_pass_nothing() {
        for (mean, expected) in [(f64::INFINITY, 0.0), (1.0, f64::INFINITY), (f64::NEG_INFINITY, f64::NEG_INFINITY)] {
            assert!(z_test(mean, 1.0, expected).p.is_nan(), "{mean} against {expected}");
        }
    }

    #[test]
    fn students_own_data() {
        // R's manual, data set `sleep`: t = −1.8608, df = 17.776, p = 0.07939, and paired
        // t = −4.0621, df = 9, p = 0.002833.
        let apart = welch(&moments(&FIRST), &moments(&SECOND));
        assert!((apart.statistic + 1.8608).abs() < 5e-5, "{apart:?}");
        assert!((apart.dof - 17.776).abs() < 5e-4 && (apart.p - 0.07939).abs() < 5e-6, "{apart:?}");
        let gained: Moments = FIRST.iter().zip(&SECOND).map(|(one, other)| one - other).collect();
        let paired = t_test(&gained, 0.0);
        assert!((paired.statistic + 4.0621).abs() < 5e-5 && paired.dof == 9.0, "{paired:?}");
        assert!((paired.p - 0.002833).abs() < 5e-7, "{paired:?}");
    }

    #[test]
    fn what_does_not_scatter_is_equal_or_not() {
        let ones = moments(&[1.0; 20]);
        let hair = 1.0 + ROUNDING * f64::EPSILON;
        assert_eq!((t_test(&ones, 1.0).p, t_test(&ones, hair).p, t_test(&ones, hair + 1e-15).p), (1.0, 1.0, 0.0));
        assert_eq!((welch(&ones, &ones).p, welch(&ones, &moments(&[1.1; 3])).p), (1.0, 0.0));
        assert_eq!((z_test(0.0, 0.0, 0.0).p, z_test(0.0, 0.0, 1e-300).p), (1.0, 0.0));
    }

    #[test]
    fn rounding_is_no_evidence() {
        // Weights that should be 1 and are 1 up to the last digit, all to one side.
        let weights: Moments = (0..10_000).map(|k| 1.0 + f64::EPSILON * f64::from(1 + k % 2)).collect();
        assert_eq!(t_test(&weights, 1.0).p, 1.0);
        assert_eq!(t_test(&weights, 1.0 + 1e-13).p, 0.0);
        // What is beyond rounding counts, and only that: 24 of 40 units.
        let weights: Moments = (0..1000).map(|k| 1.0 + f64::EPSILON * f64::from(1000 * (k % 2) - 500)).collect();
        let test = t_test(&weights, 1.0 - 40.0 * f64::EPSILON);
        assert!((test.statistic * weights.standard_error() / f64::EPSILON - 24.0).abs() < 2.0, "{test:?}");
    }

    #[test]
    fn too_few_numbers_tell_nothing() {
        for test in
            [t_test(&moments(&[]), 0.0), t_test(&moments(&[1.0]), 1.0), welch(&moments(&[1.0]), &moments(&FIRST))]
        {
            assert!(test.p.is_nan(), "{test:?}");
        }
        assert!(t_test(&moments(&[1.0, f64::NAN, 2.0]), 1.0).p.is_nan());
        assert!(t_test(&moments(&FIRST), f64::NAN).p.is_nan());
        assert!(z_test(1.0, f64::NAN, 1.0).p.is_nan() && z_test(1.0, f64::INFINITY, 2.0).p.is_nan());
    }

    #[test]
    fn a_sample_without_scatter_leaves_the_others_freedom() {
        let test = welch(&moments(&FIRST), &moments(&[0.0; 50]));
        assert!((test.dof - 9.0).abs() < 1e-12);
    }

    proptest! {
        #[test]
        fn p_values_are_numbers_between_0_and_1(
            numbers in prop::collection::vec(-1e3..1e3_f64, 2..30),
            exponent in -140..140_i32,
            expected in -1e3..1e3_f64,
        ) {
            let scale = 10f64.powi(exponent);
            let sample: Moments = numbers.iter().map(|x| x * scale).collect();
            let tests = [
                t_test(&sample, expected * scale),
                welch(&sample, &numbers.iter().map(|x| x * scale * 0.5).collect()),
                z_test(sample.mean(), sample.standard_error(), expected * scale),
            ];
            for test in tests {
                prop_assert!((0.0..=1.0).contains(&test.p), "{test:?}");
            }
        }

        #[test]
        fn welch_is_between_the_samples_freedoms(
            one in prop::collection::vec(-1.0..1.0_f64, 2..30), other in prop::collection::vec(-9.0..9.0_f64, 2..30),
        ) {
            let test = welch(&moments(&one), &moments(&other));
            let least = one.len().min(other.len()) as f64 - 1.0;
            prop_assert!(test.dof >= least * (1.0 - 1e-12));
            prop_assert!(test.dof <= (one.len() + other.len()) as f64 - 2.0 + 1e-9);
            let back = welch(&moments(&other), &moments(&one));
            prop_assert!((back.p - test.p).abs() <= 1e-13 && back.statistic == -test.statistic);
        }
    }
}
