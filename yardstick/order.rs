//! The observed order of a method: the slope of its error against its work on log–log axes.

/// Least-squares slope of ln(error) against ln(work) [1]; a method of order p has slope −p.
/// Points that are not positive and finite are left out; `None` with fewer than two left.
pub fn slope(points: &[(f64, f64)]) -> Option<f64> {
    let logs: Vec<(f64, f64)> = points
        .iter()
        .filter(|(work, error)| *work > 0.0 && *error > 0.0 && work.is_finite() && error.is_finite())
        .map(|(work, error)| (work.ln(), error.ln()))
        .collect();
    if logs.len() < 2 {
        return None;
    }
    let count = logs.len() as f64;
    let (mean_x, mean_y) =
        (logs.iter().map(|p| p.0).sum::<f64>() / count, logs.iter().map(|p| p.1).sum::<f64>() / count);
    let (mut covariance, mut variance) = (0.0, 0.0);
    for (x, y) in &logs {
        covariance += (x - mean_x) * (y - mean_y);
        variance += (x - mean_x) * (x - mean_x);
    }
    (variance > 0.0).then(|| covariance / variance)
}

#[cfg(test)]
mod tests {
    use super::slope;

    #[test]
    fn finds_the_power_of_a_power_law() {
        let points: Vec<_> = (1..8).map(|k| (f64::from(1 << k), 3.0 * f64::from(1 << k).powf(-1.5))).collect();
        assert!((slope(&points).unwrap() + 1.5).abs() < 1e-12);
    }

    #[test]
    fn needs_two_usable_points() {
        assert_eq!(slope(&[(1.0, 1.0), (2.0, 0.0), (3.0, f64::NAN)]), None);
        assert_eq!(slope(&[(2.0, 1.0), (2.0, 3.0)]), None);
    }
}
