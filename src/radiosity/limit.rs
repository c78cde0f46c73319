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
}
