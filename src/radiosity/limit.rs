//! Limits from a few terms of a sequence.

/// The limit of a sequence whose error falls by one factor a term, from three terms in order (A. C. Aitken, *Proc. R. Soc.
/// Edinb.* 46 (1926) 289); the last term where they do not differ.
pub fn aitken([first, second, third]: [f64; 3]) -> f64 {
    let (before, after) = (second - first, third - second);
    let bend = after - before;
    if bend == 0.0 { third } else { third - after * after / bend }
}

/// The limit of a sequence whose error falls as h^`order`, from its values at h and h/2 (L. F. Richardson, *Phil. Trans. A* 226
/// (1927) 299).
pub fn richardson([coarse, fine]: [f64; 2], order: f64) -> f64 {
    fine + (fine - coarse) / (order.exp2() - 1.0)
}

/// The limit of a sequence whose error is a sum of such `powers` of h, from as many values and one more, each with its h; the
/// powers need not be whole. The last value where the equations have no one solution.
pub fn without(values: &[(f64, f64)], powers: &[f64]) -> f64 {
    let size = powers.len() + 1;
    let last = values.last().map_or(f64::NAN, |(_, value)| *value);
    if values.len() != size {
        return f64::NAN;
    }
    // In units of the largest h; a column of ones for the limit, one a power, and the values.
    let unit = values.iter().fold(0.0_f64, |most, (h, _)| most.max(*h));
    let row = |(h, value): &(f64, f64)| -> Vec<f64> {
        let terms = powers.iter().map(|power| (h / unit).powf(*power));
        std::iter::once(1.0).chain(terms).chain([*value]).collect()
    };
    let mut rows: Vec<Vec<f64>> = values.iter().map(row).collect();
    // From the last column to the first, which is the limit's.
    for k in (0..size).rev() {
        let most = (0..=k).max_by(|a, b| rows[*a][k].abs().total_cmp(&rows[*b][k].abs())).unwrap_or(k);
        rows.swap(k, most);
        let (upper, pivot) = rows.split_at_mut(k);
        if pivot[0][k] == 0.0 {
            return last;
        }
        for row in upper {
            let share = row[k] / pivot[0][k];
            row.iter_mut().zip(&pivot[0]).for_each(|(x, y)| *x -= share * y);
        }
    }
    rows[0][size] / rows[0][0]
}

/// The order [1] that values at h, h/2 and h/4 show; not a number if they do not fall one way.
pub fn observed_order([coarse, middle, fine]: [f64; 3]) -> f64 {
    ((coarse - middle) / (middle - fine)).log2()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_single_power_is_taken_off_exactly() {
        // 3 + 2·0.9^k, and 3 + 5 h².
        let terms = [0, 1, 2].map(|k| 3.0 + 2.0 * 0.9_f64.powi(k));
        assert!((aitken(terms) - 3.0).abs() < 1e-13);
        let values = [1.0, 0.5, 0.25].map(|h: f64| 3.0 + 5.0 * h * h);
        assert!((richardson([values[0], values[1]], 2.0) - 3.0).abs() < 1e-14);
        assert!((observed_order(values) - 2.0).abs() < 1e-14);
        assert_eq!(aitken([2.0; 3]), 2.0);
    }

    #[test]
    fn several_powers_are_taken_off_exactly() {
        let of = |h: f64| (h, 3.0 + 5.0 * h * h - 2.0 * h.powf(2.5) + 0.7 * h.powi(4));
        let values = [0.25, 0.2, 0.125, 0.1].map(of);
        assert!((without(&values, &[2.0, 2.5, 4.0]) - 3.0).abs() < 1e-12);
        assert!((without(&values[..2], &[2.0]) - 3.0).abs() > 1e-3);
        assert!(without(&values, &[2.0]).is_nan());
        assert_eq!(without(&[(0.5, 1.0), (0.5, 2.0)], &[2.0]), 2.0);
    }
}
