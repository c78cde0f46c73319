//! A choice among things of different weight.

/// Things by their shares of a whole.
#[derive(Clone, Debug, PartialEq)]
pub struct Shares {
    /// Of each thing the share of it and of all before.
    ends: Vec<f64>,
    /// The weight of all.
    whole: f64,
}

impl Shares {
    /// Of weights ≥ 0; None if all are 0, or there are none, or their sum is not finite.
    pub fn new(weights: impl IntoIterator<Item = f64>) -> Option<Self> {
        let mut whole = 0.0;
        let mut ends: Vec<f64> = weights
            .into_iter()
            .map(|weight| {
                whole += weight;
                whole
            })
            .collect();
        if !(whole > 0.0 && whole < f64::INFINITY) {
            return None;
        }
        ends.iter_mut().for_each(|end| *end /= whole);
        Some(Self { ends, whole })
    }

    /// The weight of all.
    pub fn whole(&self) -> f64 {
        self.whole
    }

    /// The share [1] of a thing.
    pub fn share(&self, thing: usize) -> f64 {
        self.ends[thing] - if thing == 0 { 0.0 } else { self.ends[thing - 1] }
    }

    /// A thing by its share, from a number 0 ≤ u < 1, and another number of the same kind that is left of it.
    pub fn pick(&self, u: f64) -> (usize, f64) {
        // Never one of no share: its end is not above the one before.
        let thing = self.ends.partition_point(|end| *end <= u).min(self.ends.len() - 1);
        let start = if thing == 0 { 0.0 } else { self.ends[thing - 1] };
        let rest = (u - start) / (self.ends[thing] - start);
        (thing, rest.clamp(0.0, 1.0_f64.next_down()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn things_are_picked_by_their_shares_and_what_is_left_is_even() {
        let shares = Shares::new([1.0, 0.0, 3.0]).expect("some weight");
        let n = 4000;
        let mut counts = [0; 3];
        let mut rest = 0.0;
        for k in 0..n {
            let (thing, left) = shares.pick((f64::from(k) + 0.5) / f64::from(n));
            counts[thing] += 1;
            rest += left / f64::from(n);
        }
        assert_eq!(counts, [1000, 0, 3000]);
        // Midpoints of even steps in either part.
        assert!((rest - 0.5).abs() < 1e-12, "{rest}");
        assert_eq!([0, 1, 2].map(|thing| shares.share(thing)), [0.25, 0.0, 0.75]);
        assert_eq!(shares.whole(), 4.0);
    }

    #[test]
    fn nothing_can_be_picked_from_nothing() {
        for weights in [vec![], vec![0.0, 0.0], vec![f64::INFINITY], vec![f64::NAN]] {
            assert_eq!(Shares::new(weights), None);
        }
    }
}
