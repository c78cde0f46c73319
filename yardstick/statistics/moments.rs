//! Mean and variance of a stream of numbers, in one pass.

/// How many numbers there were, their mean and their variance. Merging parts gives what one pass gives, up to rounding.
/// Their squares must stay in range: 10⁻¹⁵⁰ to 10¹⁵⁰ in magnitude, or 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Moments {
    count: u64,
    mean: f64,
    /// Σ (x − mean)².
    squares: f64,
}

impl Moments {
    /// Takes in one more number, in any unit (B. P. Welford, *Technometrics* 4 (1962) 419).
    pub fn add(&mut self, value: f64) {
        self.count += 1;
        let step = value - self.mean;
        self.mean += step / self.count as f64;
        self.squares += step * (value - self.mean);
    }

    /// Takes in all that `other` has seen (Chan, Golub & LeVeque, *The American Statistician* 37 (1983) 242, eq. 2.1).
    pub fn merge(&mut self, other: &Self) {
        if other.count == 0 {
            return;
        }
        let share = other.count as f64 / (self.count + other.count) as f64;
        let step = other.mean - self.mean;
        self.squares += other.squares + step * step * share * self.count as f64;
        self.mean += step * share;
        self.count += other.count;
    }

    /// How many numbers.
    pub fn count(&self) -> u64 {
        self.count
    }

    /// Their mean, in their unit; NaN if there is none.
    pub fn mean(&self) -> f64 {
        if self.count == 0 { f64::NAN } else { self.mean }
    }

    /// The unbiased estimate of the variance, Σ (x − mean)²/(n − 1), in their unit squared; NaN for fewer than two.
    pub fn variance(&self) -> f64 {
        if self.count < 2 { f64::NAN } else { self.squares / (self.count - 1) as f64 }
    }

    /// The standard error of the mean, √(variance/n), in their unit; NaN for fewer than two.
    pub fn standard_error(&self) -> f64 {
        (self.variance() / self.count as f64).sqrt()
    }
}

impl Extend<f64> for Moments {
    fn extend<T: IntoIterator<Item = f64>>(&mut self, values: T) {
        values.into_iter().for_each(|value| self.add(value));
    }
}

impl FromIterator<f64> for Moments {
    fn from_iter<T: IntoIterator<Item = f64>>(values: T) -> Self {
        let mut moments = Self::default();
        moments.extend(values);
        moments
    }
}

#[cfg(test)]
mod tests {
    use super::Moments;
    use proptest::prelude::*;

    #[test]
    fn two_passes_agree_where_the_mean_dwarfs_the_scatter() {
        // The sum of squares would lose every digit: 10¹⁸ against 1.
        let moments: Moments = [4.0, 7.0, 13.0, 16.0].map(|x| x + 1e9).into_iter().collect();
        assert_eq!((moments.count(), moments.mean(), moments.variance()), (4, 1e9 + 10.0, 30.0));
        assert_eq!(moments.standard_error(), 7.5_f64.sqrt());
    }

    #[test]
    fn too_few_numbers_have_no_moments() {
        let mut moments = Moments::default();
        assert!(moments.mean().is_nan() && moments.variance().is_nan() && moments.standard_error().is_nan());
        moments.add(3.0);
        assert!(moments.mean() == 3.0 && moments.variance().is_nan());
    }

    #[test]
    fn equal_numbers_have_exactly_no_variance() {
        let moments: Moments = std::iter::repeat_n(0.1, 1000).collect();
        assert_eq!((moments.mean(), moments.variance()), (0.1, 0.0));
    }

    proptest! {
        #[test]
        fn merging_parts_is_one_pass(
            numbers in prop::collection::vec(-1e3..1e3_f64, 2..200), cut in 0.0..=1.0_f64, offset in -1e6..1e6_f64,
        ) {
            let numbers: Vec<f64> = numbers.into_iter().map(|x| x + offset).collect();
            let cut = (cut * numbers.len() as f64) as usize;
            let whole: Moments = numbers.iter().copied().collect();
            let mut merged: Moments = numbers[..cut].iter().copied().collect();
            merged.merge(&numbers[cut..].iter().copied().collect());
            let mean = numbers.iter().sum::<f64>() / numbers.len() as f64;
            let variance = numbers.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (numbers.len() - 1) as f64;
            for moments in [whole, merged] {
                prop_assert_eq!(moments.count() as usize, numbers.len());
                prop_assert!((moments.mean() - mean).abs() <= 1e-14 * (1e3 + offset.abs()));
                // Rounding of x moves x − mean by ε |offset|.
                prop_assert!((moments.variance() - variance).abs() <= 1e-12 * variance + 1e-9 * variance.sqrt());
            }
        }
    }
}
