//! When a picture is good enough, and how much to do next.

use light::transport::estimate::Estimate;
use std::ops::Range;
use std::time::Duration;

/// When a picture is good enough: as soon as anything that is asked for is reached.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Goal {
    /// Samples a pixel.
    pub spp: Option<u32>,
    /// Time to render, without making ready.
    pub time: Option<Duration>,
    /// Relative error [1].
    pub error: Option<f64>,
}

/// Samples a pixel if nothing is asked for.
const USUAL: u32 = 64;

/// The most samples a pixel.
pub const MOST: u32 = 1 << 24;

/// Steps of the bar.
const WHOLE: u64 = 1000;

impl Goal {
    /// Pairs of samples that there can be at most.
    fn most(&self) -> u32 {
        let is_open = self.time.is_some() || self.error.is_some();
        self.spp.unwrap_or(if is_open { MOST } else { USUAL }).div_ceil(2)
    }

    /// The next branch of pairs to be rendered after the first `done`, which took `elapsed`; None if the goal is met.
    pub fn next(&self, done: u32, elapsed: Duration, found: &Estimate) -> Option<Range<u32>> {
        let most = self.most();
        let is_met = done >= most
            || self.time.is_some_and(|time| done > 0 && elapsed >= time)
            || self.error.is_some_and(|error| done > 0 && found.relative_error() <= error);
        if is_met {
            return None;
        }
        // Twice as much in every round, each a branch of the tree: the largest that begins there.
        let aligned = if done == 0 { 1 } else { 1 << done.trailing_zeros() };
        let left = 1 << (most - done).ilog2();
        let in_time = self.time.map_or(u32::MAX, |time| {
            let of_one = elapsed.as_secs_f64() / f64::from(done.max(1));
            let rest = time.saturating_sub(elapsed).as_secs_f64();
            let pairs = if of_one > 0.0 { (rest / of_one).max(1.0) } else { 1.0 };
            1 << (pairs as u32).max(1).ilog2()
        });
        Some(done..done + aligned.min(left).min(in_time))
    }

    /// The bar's end.
    pub fn whole(&self) -> u64 {
        WHOLE
    }

    /// How far it is, of [`Goal::whole`]: as far as what is nearest to its end.
    pub fn share(&self, done: u32, elapsed: Duration, found: &Estimate) -> u64 {
        let by_pairs = f64::from(done) / f64::from(self.most());
        let by_time = self.time.map_or(0.0, |time| elapsed.as_secs_f64() / time.as_secs_f64());
        // The square of the error falls as time grows.
        let by_error = self.error.map_or(0.0, |error| error * error / found.relative_mse.max(f64::MIN_POSITIVE));
        (by_pairs.max(by_time).max(by_error).min(1.0) * WHOLE as f64) as u64
    }

    /// The error that was asked for, if it was not reached.
    pub fn missed(&self, found: &Estimate) -> Option<f64> {
        self.error.filter(|error| found.relative_error() > *error)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What rounds a goal takes if a pair takes so long and errors are those of one pair over the root of their number.
    fn rounds(goal: Goal, of_one: f64, error: f64) -> Vec<Range<u32>> {
        let mut rounds = Vec::new();
        let mut done = 0;
        loop {
            let found = Estimate { relative_mse: error * error / f64::from(done.max(1)), ..Estimate::default() };
            let elapsed = Duration::from_secs_f64(of_one * f64::from(done));
            let Some(next) = goal.next(done, elapsed, &found) else { return rounds };
            assert_eq!(next.start, done);
            let span = next.end - next.start;
            assert!(span.is_power_of_two() && next.start.is_multiple_of(span), "{next:?} is no branch");
            done = next.end;
            rounds.push(next);
        }
    }

    #[test]
    fn samples_asked_for_are_taken_in_growing_rounds() {
        let of = |spp| rounds(Goal { spp: Some(spp), ..Goal::default() }, 0.0, 1.0);
        assert_eq!(of(16), vec![0..1, 1..2, 2..4, 4..8]);
        assert_eq!(of(1), vec![0..1; 1]);
        assert_eq!(of(26).last(), Some(&(12..13)));
        assert_eq!(rounds(Goal::default(), 0.0, 1.0).last().map(|last| last.end), Some(USUAL / 2));
    }

    #[test]
    fn time_is_kept_but_for_the_first_pair() {
        let of = |seconds| {
            let goal = Goal { time: Some(Duration::from_secs_f64(seconds)), ..Goal::default() };
            rounds(goal, 0.01, 1.0).last().map(|last| last.end)
        };
        assert_eq!(of(0.001), Some(1));
        // A hundred pairs in a second, and at most the one that was under way.
        assert!(of(1.0).is_some_and(|pairs| (100..=101).contains(&pairs)), "{:?}", of(1.0));
    }

    #[test]
    fn an_error_is_reached_and_not_far_beyond() {
        let goal = Goal { error: Some(0.02), ..Goal::default() };
        // (1/0.02)² pairs, found out at the next power of two.
        assert_eq!(rounds(goal, 0.0, 1.0).last().map(|last| last.end), Some(4096));
        let short = Goal { spp: Some(64), ..goal };
        assert_eq!(rounds(short, 0.0, 1.0).last().map(|last| last.end), Some(32));
        assert_eq!(short.missed(&Estimate { relative_mse: 1.0 / 32.0, ..Estimate::default() }), Some(0.02));
    }
}
