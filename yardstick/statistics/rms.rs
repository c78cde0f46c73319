//! The size of errors that scatter around zero.

/// The root of the mean square [1]; NaN if any error is, or if there is none.
pub fn rms(errors: &[f64]) -> f64 {
    let largest = errors.iter().map(|error| error.abs()).max_by(f64::total_cmp).unwrap_or(f64::NAN);
    if largest == 0.0 || !largest.is_finite() {
        return largest;
    }
    // Scaled, so that errors near the end of the range do not underflow when squared.
    let sum: f64 = errors.iter().map(|error| (error / largest).powi(2)).sum();
    largest * (sum / errors.len() as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::rms;

    #[test]
    fn rms_neither_underflows_nor_hides_nan() {
        assert_eq!(rms(&[3e-200, -3e-200]), 3e-200);
        assert!((rms(&[1.0, 7.0]) - 5.0).abs() < 1e-15);
        assert_eq!(rms(&[0.0]), 0.0);
        assert!(rms(&[]).is_nan() && rms(&[1.0, f64::NAN]).is_nan());
    }
}
