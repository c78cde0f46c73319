//! When a picture is good enough, and how much to do next.

use light::transport::estimate::Estimate;
use std::ops::Range;
use std::time::Duration;

/// When a picture is good enough: as soon as anything that is asked for is reached.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Goal {
    /// Samples a pixel.
    pub spp: Option<u32>,
    /// Numbers of samples, both even, from the first up to but without the second, instead of as many as `spp`.
    pub samples: Option<[u32; 2]>,
    /// How long a round of work may last, if a pair of samples does not last longer.
    pub round: Option<Duration>,
    /// Time to render, without making ready.
    pub time: Option<Duration>,
    /// Relative error [1].
    pub error: Option<f64>,
}

/// What is done.
#[derive(Clone, Copy, Debug)]
pub struct Done<'f> {
    /// Pairs of samples that there are, in order.
    pub ranges: &'f [Range<u32>],
    /// How many of them are of this run.
    pub now: u32,
    /// Time that these took.
    pub elapsed: Duration,
}

/// Samples a pixel if nothing is asked for.
const USUAL: u32 = 64;

/// The most samples a pixel.
pub const MOST: u32 = 1 << 24;

/// More samples in a second than any machine makes.
const FASTEST: f64 = 1e8;

/// How long nobody renders at once who has not said how long.
const DAY: Duration = Duration::from_secs(86_400);

/// Steps of the bar.
const WHOLE: u64 = 1000;

impl Goal {
    /// Pairs that are wanted among those there can be, and how many of them at most.
    fn wanted(&self) -> (Range<u32>, u32) {
        let is_open = self.time.is_some() || self.error.is_some();
        match self.samples {
            Some([from, to]) => (from / 2..to / 2, to / 2 - from / 2),
            None => (0..MOST / 2, self.spp.unwrap_or(if is_open { MOST } else { USUAL }).div_ceil(2)),
        }
    }

    /// Samples a pixel that are wanted, if neither time nor an error ends the work.
    pub fn samples_wanted(&self) -> Option<u32> {
        let is_open = self.spp.is_none() && self.samples.is_none() && (self.time.is_some() || self.error.is_some());
        (!is_open).then(|| 2 * self.wanted().1)
    }

    /// The most branches that the samples of a picture of so many pixels may be in at once: as many as the number of pairs
    /// has binary digits.
    pub fn most_branches(&self, pixels: usize) -> usize {
        let in_time = self.time.unwrap_or(DAY).as_secs_f64() * FASTEST / (2 * pixels) as f64;
        let pairs = self.wanted().1.min((in_time as u32).max(1));
        (u32::BITS - pairs.leading_zeros()) as usize
    }

    /// Pairs that are still missing.
    fn missing(&self, done: &Done) -> u32 {
        let (wanted, most) = self.wanted();
        let of_wanted = |range: &Range<u32>| range.end.min(wanted.end).saturating_sub(range.start.max(wanted.start));
        most.saturating_sub(done.ranges.iter().map(of_wanted).sum())
    }

    /// The next branch of pairs to be rendered; None if the goal is met.
    pub fn next(&self, done: &Done, found: &Estimate) -> Option<Range<u32>> {
        let missing = self.missing(done);
        let is_begun = !done.ranges.is_empty();
        let is_met = missing == 0
            || self.time.is_some_and(|time| is_begun && done.elapsed >= time)
            || self.error.is_some_and(|error| is_begun && found.relative_error() <= error);
        if is_met {
            return None;
        }
        // The first pairs that there are not, up to those that there are.
        let (wanted, _) = self.wanted();
        let mut start = wanted.start;
        for range in done.ranges {
            if range.contains(&start) {
                start = range.end;
            }
        }
        let end = done.ranges.iter().map(|range| range.start).find(|other| *other > start).unwrap_or(u32::MAX);
        let left = missing.min(end.min(wanted.end).saturating_sub(start)).max(1);
        // At most twice as much in every round, each a branch of the tree: the largest that begins there.
        let aligned = if start == 0 { 1 } else { 1 << start.trailing_zeros() };
        let of_one = done.elapsed.as_secs_f64() / f64::from(done.now.max(1));
        let within = |time: Duration| if of_one > 0.0 { (time.as_secs_f64() / of_one).max(1.0) as u32 } else { 1 };
        let in_time = self.time.map_or(u32::MAX, |time| within(time.saturating_sub(done.elapsed)));
        let in_round = self.round.map_or(u32::MAX, within);
        let most = left.min(done.now.max(1)).min(in_time).min(in_round);
        Some(start..start + aligned.min(1 << most.ilog2()))
    }

    /// The bar's end.
    pub fn whole(&self) -> u64 {
        WHOLE
    }

    /// How far it is, of [`Goal::whole`]: as far as what is nearest to its end.
    pub fn share(&self, done: &Done, found: &Estimate) -> u64 {
        let by_pairs = 1.0 - f64::from(self.missing(done)) / f64::from(self.wanted().1);
        let by_time = self.time.map_or(0.0, |time| done.elapsed.as_secs_f64() / time.as_secs_f64());
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
    use light::transport::film::{Film, branches};

    /// What rounds a goal takes if a pair takes so long and errors are those of one pair over the root of their number.
    fn rounds(goal: Goal, of_one: f64, error: f64) -> Vec<Range<u32>> {
        let rounds = rounds_after(&[], goal, of_one, error);
        assert!(rounds.windows(2).all(|two| two[0].end == two[1].start));
        rounds
    }

    /// The same of a film that has some pairs.
    fn rounds_after(before: &[Range<u32>], goal: Goal, of_one: f64, error: f64) -> Vec<Range<u32>> {
        let (mut film, mut now, mut rounds) = (Film::new(1, 1), 0, Vec::new());
        let add = |film: &mut Film, range| film.add(range, vec![[[0.0; 3]; 2]]).expect("new pairs");
        before.iter().flat_map(|range| branches(range.clone())).for_each(|branch| add(&mut film, branch));
        loop {
            let relative_mse = error * error / f64::from(film.pairs().max(1));
            let found = Estimate { relative_mse, ..Estimate::default() };
            let elapsed = Duration::from_secs_f64(of_one * f64::from(now));
            let Some(next) = goal.next(&Done { ranges: &film.ranges(), now, elapsed }, &found) else { return rounds };
            now += next.end - next.start;
            add(&mut film, next.clone());
            rounds.push(next);
        }
    }

    #[test]
    fn what_is_missing_is_rendered_and_nothing_else() {
        let to = |spp| Goal { spp: Some(spp), ..Goal::default() };
        let of = |from, to| Goal { samples: Some([from, to]), ..Goal::default() };
        let covered = |rounds: Vec<Range<u32>>| rounds.into_iter().flatten().collect::<Vec<u32>>();
        let after = |before: &[Range<u32>], goal| covered(rounds_after(before, goal, 0.0, 1.0));
        // Going on from 10 pairs, and nothing to do.
        assert_eq!(after(&[0..10; 1], to(64)), (10..32).collect::<Vec<_>>());
        assert_eq!(after(&[0..32; 1], to(64)), [0_u32; 0]);
        assert_eq!(after(&[0..40; 1], to(64)), [0_u32; 0]);
        // Holes first; as many as are asked for, wherever they are.
        assert_eq!(after(&[4..8, 16..24], to(64)), (0..4).chain(8..16).chain(24..32).collect::<Vec<_>>());
        assert_eq!(after(&[4..8, 16..24], to(28)), [0, 1]);
        // Numbers that are asked for, whatever else there is.
        assert_eq!(after(&[], of(14, 40)), (7..20).collect::<Vec<_>>());
        assert_eq!(after(&[0..4, 8..10, 30..40], of(14, 40)), (7..8).chain(10..20).collect::<Vec<_>>());
        assert_eq!(after(&[7..20; 1], of(14, 40)), [0_u32; 0]);
        assert_eq!(after(&[0..64; 1], of(14, 40)), [0_u32; 0]);
    }

    #[test]
    fn a_round_is_no_longer_than_it_may_be() {
        let goal = Goal { spp: Some(1024), round: Some(Duration::from_secs(2)), ..Goal::default() };
        for (before, of_one) in [(0, 0.3), (0, 5.0), (64, 0.3), (37, 0.01), (256, 1.0)] {
            let rounds = rounds_after(&[0..before; 1][usize::from(before == 0)..], goal, of_one, 1.0);
            let most = (2.0 / of_one).max(1.0) as u32;
            assert!(rounds.iter().all(|round| round.end - round.start <= most), "{before} {of_one}");
            // The first one is one pair: nothing is known of its time.
            assert_eq!(rounds[0], before..before + 1);
            assert_eq!(rounds.last().map(|last| last.end), Some(512));
        }
    }

    #[test]
    fn a_film_has_no_more_branches_than_are_counted_on() {
        for (spp, of_one) in [(2, 1.0), (64, 0.3), (62, 5.0), (1000, 0.01)] {
            let goal = Goal { spp: Some(spp), round: Some(Duration::from_secs(2)), ..Goal::default() };
            let mut film = Film::new(1, 1);
            let of_round = |range: Range<u32>| {
                film.add(range, vec![[[0.0; 3]; 2]]).expect("new pairs");
                film.branches().len()
            };
            let most = rounds(goal, of_one, 1.0).into_iter().map(of_round).max();
            assert!(most.is_some_and(|most| most <= goal.most_branches(1 << 20)), "{spp}: {most:?}");
        }
        let of = |goal: Goal| goal.most_branches(1 << 24);
        assert_eq!(of(Goal { spp: Some(64), ..Goal::default() }), 6);
        // A minute: 178 pairs. Without any end: a day.
        assert_eq!(of(Goal { time: Some(Duration::from_secs(60)), ..Goal::default() }), 8);
        assert_eq!(of(Goal { error: Some(0.1), ..Goal::default() }), 18);
        assert_eq!(Goal { error: Some(0.1), ..Goal::default() }.samples_wanted(), None);
        assert_eq!(Goal { error: Some(0.1), spp: Some(7), ..Goal::default() }.samples_wanted(), Some(8));
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
