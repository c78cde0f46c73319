//! Counts beside what was expected of them, as a figure: what a χ² test leaves to look at.

use crate::figure::{Axis, Chart, Hue};
use yardstick::statistics::Bin;

/// How many fell into each bin and how many should have; `edges` are one more than the bins drawn, in the unit of `x`.
pub fn histogram(x: Axis, edges: &[f64], bins: &[Bin]) -> Chart {
    let steps = |height: fn(&Bin) -> f64| -> Vec<[f64; 2]> {
        let columns = edges.windows(2).zip(bins);
        columns.flat_map(|(edge, bin)| [[edge[0], height(bin)], [edge[1], height(bin)]]).collect()
    };
    Chart::new("", x, Axis::linear("draws in a bin", ""))
        .line(Hue::Ours, "drawn", steps(|bin| bin.observed as f64))
        .dashed(Hue::Reference, "expected", steps(|bin| bin.expected))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::Mark;

    #[test]
    fn every_bin_is_a_step_of_its_width() {
        let bin = |observed, expected| Bin { observed, expected, pool: Some(0) };
        let chart = histogram(Axis::linear("x", ""), &[0.0, 1.0, 3.0], &[bin(4, 5.0), bin(2, 1.0)]);
        let Mark::Line { points, .. } = &chart.marks[0] else { panic!("{chart:?}") };
        assert_eq!(points, &[[0.0, 4.0], [1.0, 4.0], [1.0, 2.0], [3.0, 2.0]]);
    }
}
