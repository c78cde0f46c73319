//! A race as a figure: error against time on logarithmic axes.

use crate::number::{hundredths, significant};
use crate::report::{LaneReport, RaceReport};
use chapters::figure::{Axis, Chart, Dash, Hue, Mark, Plot, Shape};
use chapters::vocabulary::Expects;

/// Half a rounding unit: errors below it are all the same to `f64`.
const FLOOR: f64 = f64::EPSILON / 2.0;
/// Decades that the axis of the errors shows at least, lest rounding look like a result.
const DECADES: f64 = 3.0;
/// Power of ten under which that axis does not reach only to be wide enough: no relative error of an `f64` lies there.
const LOWEST: f64 = -17.0;
/// Share of the errors' span that is left free on both sides.
const MARGIN: f64 = 0.05;

/// Error against the time of a run [µs or ms]; where no lane is expected to gain by work, bars of the time for one unit of it [ns].
pub fn plot(race: &RaceReport) -> Plot {
    let gains = |lane: &LaneReport| matches!(lane.asserted, Expects::Order { .. } | Expects::Converges { .. });
    if !race.lanes.iter().any(gains) {
        return Plot::of(sentence(race.claim), bars(race));
    }
    let (name, units) = unit(race);
    let mut chart = Chart::new("", Axis::log("time of a run", name), errors(race));
    for (lane, at) in race.lanes.iter().zip(0..) {
        let points = curve(lane, units);
        if let Expects::Order { order, .. } = lane.asserted {
            chart.marks.extend(guide(lane, &points, order).filter(|_| works_for_time(lane)));
        }
        chart = chart.with(Mark::Points {
            label: legend(lane),
            hue: Hue::Nth(at),
            shape: shape(at),
            joined: converges(lane),
            points: points.iter().copied().filter(|point| point[1].is_finite() && point[1] != 0.0).collect(),
        });
        let times = |is_beyond: fn(f64) -> bool| -> Vec<f64> {
            points.iter().filter(|point| is_beyond(point[1])).map(|point| point[0]).collect()
        };
        let (hue, shape) = (Hue::Nth(at), shape(at));
        let broken = Mark::Broken { hue, shape, at: times(|error| !error.is_finite()) };
        let vanished = Mark::Vanished { hue, shape, at: times(|error| error == 0.0) };
        let is_used =
            |mark: &Mark| !matches!(mark, Mark::Broken { at, .. } | Mark::Vanished { at, .. } if at.is_empty());
        chart.marks.extend([broken, vanished].into_iter().filter(is_used));
    }
    Plot::of(sentence(race.claim), chart)
}

/// Times further apart than this are shown on a logarithmic axis, lest the short ones vanish.
const FAR: f64 = 25.0;
/// What bars take of the height that a lane has.
const FILLED: f64 = 0.76;

/// What a unit of work costs: a bar for each amount of work, the lanes from the top; the key says how wrong they are.
fn bars(race: &RaceReport) -> Chart {
    let times = || race.lanes.iter().flat_map(|lane| &lane.points).map(|point| point.ns_per_work);
    let (shortest, longest) = (times().fold(f64::INFINITY, f64::min), times().fold(0.0, f64::max));
    let label = format!("time of one of the {}", unit_of_work(race.work));
    let axis = match longest / shortest < FAR {
        true => Axis::linear(label, "ns").range(0.0, 1.05 * longest),
        false => Axis::log(label, "ns").range(0.5 * shortest, 1.4 * longest),
    };
    let lanes = race.lanes.len();
    let mut chart = Chart::new("", axis, Axis::bare(0.0, lanes as f64));
    for (at, lane) in race.lanes.iter().enumerate() {
        let height = FILLED / lane.points.len().max(1) as f64;
        let top = (lanes - at) as f64 - (1.0 - FILLED) / 2.0;
        for (k, point) in lane.points.iter().enumerate() {
            let name = if k == 0 { told(lane) } else { String::new() };
            let low = top - height * (k + 1) as f64;
            chart = chart.bar(Hue::Nth(at as u8), name, point.ns_per_work, [low, low + 0.86 * height]);
        }
    }
    chart
}

/// What is counted, without the bracket that explains it.
fn unit_of_work(work: &str) -> &str {
    work.split(" (").next().unwrap_or(work)
}

/// A lane and its largest error.
fn told(lane: &LaneReport) -> String {
    let worst = lane.points.iter().map(|point| point.error.0.abs()).max_by(f64::total_cmp).unwrap_or(f64::NAN);
    match worst.is_finite() {
        true => format!("{}: error {}", lane.label, significant(worst, 2)),
        false => format!("{}: no number", lane.label),
    }
}

/// A claim as a heading: with a capital.
fn sentence(claim: &str) -> String {
    let mut letters = claim.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}

/// The unit of the time of a run, and how many are a second: whole numbers of few digits for most.
fn unit(race: &RaceReport) -> (&'static str, f64) {
    let longest = race.lanes.iter().flat_map(|lane| &lane.points).map(|point| point.seconds).fold(0.0, f64::max);
    if longest < 0.01 { ("µs", 1e6) } else { ("ms", 1e3) }
}

/// Errors over the time of a run, in units of which so many are a second.
fn curve(lane: &LaneReport, units: f64) -> Vec<[f64; 2]> {
    lane.points.iter().map(|point| [point.seconds * units, point.error.0]).collect()
}

/// The axis of the errors, wide enough that roundings of the same size stand at the same height.
fn errors(race: &RaceReport) -> Axis {
    let axis = Axis::log(race.error, "");
    let drawn = race.lanes.iter().flat_map(|lane| curve(lane, 1.0)).map(|[_, error]| error.log10());
    let ends = drawn.filter(|power| power.is_finite()).fold(None, |ends: Option<(f64, f64)>, power| {
        Some(ends.map_or((power, power), |(low, high)| (low.min(power), high.max(power))))
    });
    let is_zero = || race.lanes.iter().flat_map(|lane| &lane.points).any(|point| point.error.0 == 0.0);
    let Some((low, high)) = ends.or_else(|| is_zero().then(|| (FLOOR.log10(), FLOOR.log10()))) else { return axis };
    let span = high - low;
    let (pad, least) = (MARGIN * span, (DECADES - span) / 2.0);
    let first = (low - pad.max(least)).max(LOWEST.min(low - pad));
    axis.range(10f64.powf(first), 10f64.powf((high + pad).max(first + DECADES)))
}

fn legend(lane: &LaneReport) -> String {
    match (lane.asserted, lane.order) {
        (Expects::Order { .. }, Some(order)) => format!("{} (order {})", lane.label, hundredths(order)),
        (Expects::Breaks { .. }, _) => format!("{} (breaks)", lane.label),
        _ => lane.label.to_owned(),
    }
}

/// The asserted order as a dotted line through the lane's last point. An order is one in the work: each amount of work
/// stands at the time that it took, whether that grows with it, with its square or from a start-up cost. None beside a
/// lane that bends away from it, as those do that are faster than any power.
fn guide(lane: &LaneReport, points: &[[f64; 2]], order: f64) -> Option<Mark> {
    let drawn: Vec<_> =
        lane.points.iter().zip(points).filter(|(_, [x, y])| *x > 0.0 && *y > 0.0 && y.is_finite()).collect();
    let (last, [_, error]) = drawn.last()?;
    let due = |work: u64| error * (last.work as f64 / work as f64).powf(order);
    let follows = drawn.iter().all(|(point, [_, error])| (0.1..=10.0).contains(&(due(point.work) / error)));
    if drawn.len() < 2 || order <= 0.0 || !follows {
        return None;
    }
    let points = drawn.iter().map(|(point, [time, _])| [*time, due(point.work)]).collect();
    Some(Mark::Line { label: String::new(), hue: Hue::Reference, dash: Dash::Dotted, points })
}

/// Whether more work took more time, so that an order in the work is one in the time: not of a table's entries.
fn works_for_time(lane: &LaneReport) -> bool {
    let ends = lane.points.first().zip(lane.points.last());
    ends.is_some_and(|(first, last)| last.seconds / first.seconds > (last.work as f64 / first.work as f64).sqrt())
}

/// Whether the lane's errors fall with its work, so that a line tells something.
fn converges(lane: &LaneReport) -> bool {
    let errors = || lane.points.iter().map(|point| point.error.0.max(FLOOR));
    let (largest, smallest) = (errors().fold(0.0, f64::max), errors().fold(f64::INFINITY, f64::min));
    largest > 10.0 * smallest
}

fn shape(at: u8) -> Shape {
    const SHAPES: [Shape; 5] = [Shape::Disc, Shape::Square, Shape::Triangle, Shape::Diamond, Shape::Ring];
    SHAPES[usize::from(at) % SHAPES.len()]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::{Number, PointReport, Verdict};
    use chapters::figure::Panel;

    fn race(errors: &[f64], asserted: Expects) -> RaceReport {
        let point = |(k, error): (usize, &f64)| PointReport {
            work: 1 << k,
            error: Number(*error),
            seconds: 1e-6 * (1 << k) as f64,
            ns_per_work: 1e3,
        };
        let lane = LaneReport {
            address: "c/s/r/l".into(),
            label: "lane",
            repeats: 1,
            points: errors.iter().enumerate().map(point).collect(),
            order: Some(2.0),
            expects: String::new(),
            verdict: Verdict::Passed,
            asserted,
        };
        RaceReport {
            address: "c/s/r".into(),
            claim: "claim",
            rows: &[],
            work: "",
            error: "|ΔR|",
            reference: "",
            lanes: vec![lane],
        }
    }

    fn marks(race: &RaceReport) -> Vec<Mark> {
        match plot(race).panels.remove(0) {
            Panel::Chart(chart) => chart.marks,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn an_asserted_order_is_drawn_beside_its_lane() {
        let marks = marks(&race(&[1.0, 0.25, 0.0625], Expects::Order { order: 2.0, tolerance: 0.1 }));
        let Mark::Line { points, .. } = &marks[0] else { panic!("{marks:?}") };
        let due = [[1.0, 1.0], [2.0, 0.25], [4.0, 0.0625]];
        assert!(
            points.iter().flatten().zip(due.iter().flatten()).all(|(a, b)| (a / b - 1.0).abs() < 1e-12),
            "{points:?}"
        );
    }

    #[test]
    fn long_runs_are_told_in_milliseconds() {
        let mut race = race(&[1.0, 0.25, 0.0625], Expects::Order { order: 2.0, tolerance: 0.1 });
        race.lanes[0].points[2].seconds = 0.02;
        let Panel::Chart(chart) = plot(&race).panels.remove(0) else { panic!("no chart") };
        let Some(Mark::Points { points, .. }) = chart.marks.last() else { panic!("{:?}", chart.marks) };
        assert!(chart.x.unit == "ms" && (points[2][0] - 20.0).abs() < 1e-9, "{points:?}");
    }

    #[test]
    fn an_order_of_nothing_has_no_sign() {
        let mut race = race(&[1.0, 1.0, 1.0], Expects::Order { order: 0.0, tolerance: 0.1 });
        race.lanes[0].order = Some(-1e-5);
        assert_eq!(legend(&race.lanes[0]), "lane (order 0.00)");
    }

    #[test]
    fn a_lane_that_bends_has_no_order_drawn_beside_it() {
        let marks = marks(&race(&[1.0, 0.1, 1e-4, 1e-10], Expects::Order { order: 11.0, tolerance: 1.0 }));
        assert!(matches!(&marks[..], [Mark::Points { .. }]));
    }

    #[test]
    fn an_order_in_what_costs_no_time_is_not_drawn() {
        let mut race = race(&[1.0, 0.25, 0.0625], Expects::Order { order: 2.0, tolerance: 0.1 });
        for (point, seconds) in race.lanes[0].points.iter_mut().zip([1e-6, 1e-6, 1.8e-6]) {
            point.seconds = seconds;
        }
        assert!(matches!(&marks(&race)[..], [Mark::Points { .. }]));
    }

    #[test]
    fn what_no_axis_holds_stands_in_bands_of_its_own() {
        let race = race(&[0.0, 1e-3, f64::NAN, f64::INFINITY], Expects::Order { order: 2.0, tolerance: 0.1 });
        let marks = marks(&race);
        let [
            Mark::Points { points, hue, shape, label, .. },
            Mark::Broken { hue: broken_hue, shape: broken_shape, at: broken },
            Mark::Vanished { hue: vanished_hue, shape: vanished_shape, at: vanished },
        ] = &marks[..]
        else {
            panic!("{marks:?}")
        };
        assert_eq!(points.iter().map(|point| point[1]).collect::<Vec<_>>(), [1e-3]);
        assert_eq!((broken.len(), vanished.len(), label.as_str()), (2, 1, "lane (order 2.00)"));
        assert_eq!([(hue, shape); 2], [(broken_hue, broken_shape), (vanished_hue, vanished_shape)]);
    }

    fn error_axis(errors: &[f64]) -> Axis {
        let race = race(errors, Expects::Order { order: 2.0, tolerance: 0.1 });
        match plot(&race).panels.remove(0) {
            Panel::Chart(chart) => chart.y,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn where_work_gains_errors_stand_over_their_times() {
        for expects in [Expects::Order { order: 2.0, tolerance: 0.1 }, Expects::Converges { last: 1e-3, why: "" }] {
            let Panel::Chart(chart) = plot(&race(&[1e-1, 1e-3], expects)).panels.remove(0) else { panic!("no chart") };
            assert!(chart.marks.iter().all(|mark| !matches!(mark, Mark::Bar { .. })), "{:?}", chart.marks);
        }
    }

    #[test]
    fn where_work_gains_nothing_a_unit_of_it_is_a_bar() {
        let mut race = race(&[3e-16, 2e-15], Expects::Within { limit: 1.0, why: "" });
        (race.work, race.lanes[0].points[1].ns_per_work) = ("evaluations (of R)", 3e3);
        let Panel::Chart(chart) = plot(&race).panels.remove(0) else { panic!("no chart") };
        let [Mark::Bar { label, end: first, .. }, Mark::Bar { label: none, end: second, .. }] = &chart.marks[..] else {
            panic!("{:?}", chart.marks)
        };
        assert_eq!([first[0][0], second[0][0]], [1e3, 3e3]);
        // One under the other, apart, within the axis.
        assert!(second[0][1] > 0.0 && second[1][1] < first[0][1] && first[1][1] < 1.0);
        assert_eq!((label.as_str(), none.as_str()), ("lane: error 2e-15", ""));
        assert_eq!((chart.x.label.as_str(), chart.x.range), ("time of one of the evaluations", Some((0.0, 3150.0))));
        // Lengths further apart than eyes compare: logarithms.
        race.lanes[0].points[1].ns_per_work = 1e6;
        race.lanes[0].points[0].error = Number(f64::NAN);
        let Panel::Chart(chart) = plot(&race).panels.remove(0) else { panic!("no chart") };
        assert_eq!(chart.x.range, Some((500.0, 1.4e6)));
        assert!(matches!(&chart.marks[0], Mark::Bar { label, .. } if label == "lane: no number"));
    }

    #[test]
    fn rounding_does_not_fill_the_axis() {
        for errors in [&[1e-15, 2.5e-15][..], &[0.0], &[3e-16, f64::NAN], &[1e-14, 1e-12], &[1e-19, 2e-19]] {
            let (first, last) = error_axis(errors).range.unwrap();
            assert!(last / first > 999.0, "{errors:?}: from {first} to {last}");
            assert!(errors.iter().filter(|error| **error > 0.0).all(|error| first < *error && *error < last));
            assert!(first > 9.9e-18 || errors[0] < 1e-18, "{errors:?}: from {first}");
        }
        let (first, last) = error_axis(&[1e-12, 1.0]).range.unwrap();
        assert!(first > 1e-13 && last < 10.0, "from {first} to {last}");
        assert_eq!(error_axis(&[f64::NAN]).range, None);
        assert_eq!(error_axis(&[1.0]).label, "|ΔR|");
    }
}
