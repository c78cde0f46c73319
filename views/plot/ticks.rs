//! Axes as numbers: the extent shown and the ticks on it.

use chapters::figure::{Axis, Scale};

/// Ranges narrower than this against their larger end are a single value to an `f64` and to a reader [1].
const NARROWEST: f64 = 1e-12;
/// Ranges narrower than this are a single value: their ticks would be denormal numbers.
const SMALLEST: f64 = 1e-300;
/// Decades from one label to the next: few enough for four labels on sixteen decades where there is room for four.
const STRIDES: [i32; 16] = [1, 2, 3, 4, 5, 6, 8, 10, 15, 20, 25, 30, 40, 50, 100, 200];
/// Over more decades than this, only labelled powers of ten have a tick.
const DENSE: i32 = 50;
/// Fractions of an axis this close to an end are on it.
const BESIDE: f64 = 1e-9;
/// No axis has room for more labelled ticks.
const MOST: f64 = 60.0;

/// The part of the number line that an axis shows, from `first` to `last` (which may be the smaller).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    scale: Scale,
    first: f64,
    last: f64,
}

/// A tick at a fraction of the axis, with its label if it has one.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// Place from 0 (first) to 1 (last).
    pub at: f64,
    /// In the label markup; none for a minor tick.
    pub label: Option<String>,
}

impl Extent {
    /// What `axis` shows: its own range where that can be shown, else that of `values` with a margin of
    /// `margin` of its length at both ends.
    pub fn new(axis: &Axis, values: impl Iterator<Item = f64>, margin: f64) -> Self {
        let scale = axis.scale;
        let shown = |value: &f64| value.is_finite() && (scale == Scale::Linear || *value > 0.0);
        if let Some((first, last)) = axis.range.filter(|(first, last)| shown(first) && shown(last)) {
            let (first, last) = if is_single(first, last) { widen(scale, first) } else { (first, last) };
            return Self { scale, first, last };
        }
        let ends = values.filter(shown).fold(None, |ends: Option<(f64, f64)>, value| {
            Some(ends.map_or((value, value), |(low, high)| (low.min(value), high.max(value))))
        });
        let (first, last) = match (ends, scale) {
            (None, Scale::Linear) => (0.0, 1.0),
            (None, Scale::Log) => (1.0, 10.0),
            (Some((low, high)), _) if is_single(low, high) => widen(scale, low),
            (Some((low, high)), Scale::Linear) => {
                let pad = margin * high - margin * low;
                // Quantities that are never negative start at zero rather than below it.
                let first = if low >= 0.0 { (low - pad).max(0.0) } else { (low - pad).max(f64::MIN) };
                (first, if high <= 0.0 { (high + pad).min(0.0) } else { (high + pad).min(f64::MAX) })
            }
            (Some((low, high)), Scale::Log) => {
                let factor = (high.log10() - low.log10()) * margin;
                (10f64.powf((low.log10() - factor).max(-323.0)), 10f64.powf((high.log10() + factor).min(308.0)))
            }
        };
        Self { scale, first, last }
    }

    /// Where a value lies, from 0 (first) to 1 (last), beyond if outside; NaN if it cannot be shown. What rounding put
    /// beside an end is on it, and what is far out of sight stays within reach of arithmetic.
    pub fn fraction(&self, value: f64) -> f64 {
        let (first, last, value) = match self.scale {
            Scale::Log if value > 0.0 => (self.first.log10(), self.last.log10(), value.log10()),
            Scale::Log => return f64::NAN,
            Scale::Linear => (self.first, self.last, value),
        };
        if !value.is_finite() {
            return f64::NAN;
        }
        // Divided first, so that neither the ends of the f64 range overflow nor small values vanish.
        let unit = first.abs().max(last.abs());
        let at = (value / unit - first / unit) / (last / unit - first / unit);
        if (at - at.round()).abs() < BESIDE { at.round() } else { at.clamp(-1e100, 1e100) }
    }

    /// The same with infinities and, on a logarithmic axis, zero at the ends; NaN for what has no place even so.
    pub fn position(&self, value: f64) -> f64 {
        let rising = self.first < self.last;
        match (value, self.scale) {
            (f64::INFINITY, _) => f64::from(u8::from(rising)),
            (f64::NEG_INFINITY, Scale::Linear) | (0.0, Scale::Log) => f64::from(u8::from(!rising)),
            _ => self.fraction(value),
        }
    }

    /// Ticks in rising order of `at`: about `count` labelled ones, or one every `step` on a linear axis.
    pub fn ticks(&self, count: usize, step: Option<f64>) -> Vec<Tick> {
        let count = count.max(2);
        let mut ticks = match self.scale {
            Scale::Linear => self.even_ticks(count, step),
            Scale::Log => self.log_ticks(count),
        };
        ticks.retain(|tick| (0.0..=1.0).contains(&tick.at));
        ticks.sort_by(|a, b| a.at.total_cmp(&b.at));
        ticks
    }

    fn low(&self) -> f64 {
        self.first.min(self.last)
    }

    fn high(&self) -> f64 {
        self.first.max(self.last)
    }

    /// Labelled ticks at even steps of the value.
    fn even_ticks(&self, count: usize, step: Option<f64>) -> Vec<Tick> {
        let given = step.and_then(Decimal::exactly).filter(|step| self.multiples(*step).is_some());
        let step = given.unwrap_or_else(|| self.nice_step(count));
        let Some(multiples) = self.multiples(step) else { return Vec::new() };
        let numbers: Vec<Decimal> = multiples.map(|k| Decimal { digits: k * step.digits, power: step.power }).collect();
        let top = numbers.iter().filter_map(|number| number.magnitude()).max().unwrap_or(0);
        numbers.iter().map(|n| Tick { at: self.fraction(n.value()), label: Some(n.label(top)) }).collect()
    }

    /// A round step for about `count` ticks: 1, 2 or 5 times a power of ten, or 2.5 times one where 5 leaves too few.
    fn nice_step(&self, count: usize) -> Decimal {
        let nice = Decimal::nice(self.high() / count as f64 - self.low() / count as f64);
        let few = self.multiples(nice).is_some_and(|multiples| multiples.count() < 3);
        if few && nice.digits == 5 { Decimal { digits: 25, power: nice.power - 1 } } else { nice }
    }

    /// The multiples of a step within the extent, unless they are too many to show.
    fn multiples(&self, step: Decimal) -> Option<std::ops::RangeInclusive<i128>> {
        let step = step.value();
        let (first, last) = ((self.low() / step - 1e-9).ceil(), (self.high() / step + 1e-9).floor());
        // Beyond the whole numbers that an f64 counts, neighbouring multiples are the same number.
        let countable = first.abs().max(last.abs()) < 1.0 / f64::EPSILON && last - first < MOST;
        (step > 0.0 && countable).then_some(first as i128..=last as i128)
    }

    fn log_ticks(&self, count: usize) -> Vec<Tick> {
        let (low, high) = (self.low().log10(), self.high().log10());
        let (first, last) = ((low - 1e-9).ceil() as i32, (high + 1e-9).floor() as i32);
        let decades = (last - first + 1).max(0) as usize;
        if decades >= 2 && high - low >= 1.5 {
            return self.decade_ticks(first, last, count);
        }
        let steps = [1, 2, 5];
        let ticks = self.within_decades(&steps, first - 1, last + 1);
        if ticks.iter().filter(|tick| (0.0..=1.0).contains(&tick.at)).count() >= 3 {
            return ticks;
        }
        self.even_ticks(count, None)
    }

    /// Ticks at powers of ten, labelled every so many that there are at most `count` labels.
    fn decade_ticks(&self, first: i32, last: i32, count: usize) -> Vec<Tick> {
        let labels = |stride: i32| (last.div_euclid(stride) - (first - 1).div_euclid(stride)) as usize;
        let stride = STRIDES.into_iter().find(|stride| labels(*stride) <= count).unwrap_or(500);
        let dense = if last - first <= DENSE { 1 } else { stride };
        let ticks = (first..=last).filter(|power| power.rem_euclid(dense) == 0).map(|power| {
            let label = (power.rem_euclid(stride) == 0).then(|| self.log_label(Decimal { digits: 1, power }));
            Tick { at: self.fraction(ten(power)), label }
        });
        let between = if stride == 1 { (2..=9).collect() } else { Vec::new() };
        let minor = self.within_decades(&between, first - 1, last).into_iter().map(|tick| Tick { label: None, ..tick });
        ticks.chain(minor).collect()
    }

    /// The first tick at 2 or 5 times a power of ten that a logarithmic axis has before its first power of ten: where an
    /// axis starts within a decade, it says where.
    pub fn start_tick(&self) -> Option<Tick> {
        if self.scale == Scale::Linear || self.first > self.last {
            return None;
        }
        let power = (self.first.log10() - 1e-9).ceil() as i32 - 1;
        let ticks = self.within_decades(&[2, 5], power, power);
        ticks.into_iter().find(|tick| (0.0..=1.0).contains(&tick.at))
    }

    /// As written on a logarithmic axis: in full if all between thousandths and ten thousands is, otherwise with powers of
    /// ten but for ones and tens.
    fn log_label(&self, number: Decimal) -> String {
        let size = number.magnitude().unwrap_or(0);
        let is_plain = self.low() >= 1e-3 * (1.0 - BESIDE) && self.high() < 1e5;
        if is_plain || (0..=1).contains(&size) { number.plain() } else { number.scientific(size) }
    }

    /// Labelled ticks at `digits`·10ⁿ for n from `first` to `last`.
    fn within_decades(&self, digits: &[i128], first: i32, last: i32) -> Vec<Tick> {
        let numbers = (first..=last).flat_map(|power| digits.iter().map(move |&digits| Decimal { digits, power }));
        numbers
            .map(|n| Tick { at: self.fraction(n.value()), label: Some(self.log_label(n)) })
            .filter(|tick| tick.at.is_finite())
            .collect()
    }
}

/// Whether two ends are too close to be told apart on an axis.
fn is_single(a: f64, b: f64) -> bool {
    let unit = a.abs().max(b.abs());
    let width = (a / unit - b / unit).abs();
    // Two zeros give NaN here, and are a single value too.
    !(width > NARROWEST && width * unit > SMALLEST)
}

/// A range around a single value.
fn widen(scale: Scale, value: f64) -> (f64, f64) {
    match scale {
        Scale::Log => ((value / 3.0).max(1e-323), (value * 3.0).min(f64::MAX)),
        Scale::Linear if value.abs() < 1e-290 => (-1.0, 1.0),
        Scale::Linear => ((value - 0.1 * value.abs()).max(f64::MIN), (value + 0.1 * value.abs()).min(f64::MAX)),
    }
}

/// `digits`·10^`power`: the numbers on an axis are decimals, and are kept as such so that labels show no rounding.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Decimal {
    digits: i128,
    power: i32,
}

impl Decimal {
    /// The 1, 2 or 5 times a power of ten that is at least `step`.
    fn nice(step: f64) -> Self {
        let power = step.log10().floor() as i32;
        let candidates =
            [(1, power), (2, power), (5, power), (1, power + 1)].map(|(digits, power)| Self { digits, power });
        candidates.into_iter().find(|nice| nice.value() >= step * (1.0 - 1e-9)).unwrap_or(candidates[3])
    }

    /// The shortest decimal that names a positive number.
    fn exactly(step: f64) -> Option<Self> {
        let written = (step.is_finite() && step > 0.0).then(|| format!("{step:e}"))?;
        let (digits, power) = written.split_once('e')?;
        let decimals = digits.split_once('.').map_or(0, |(_, decimals)| decimals.len() as i32);
        Some(Self { digits: digits.replace('.', "").parse().ok()?, power: power.parse::<i32>().ok()? - decimals })
    }

    /// The nearest `f64`.
    fn value(self) -> f64 {
        format!("{}e{}", self.digits, self.power).parse().unwrap_or(f64::NAN)
    }

    /// Power of ten of the first digit; none for zero.
    fn magnitude(self) -> Option<i32> {
        let digits = self.digits.unsigned_abs().checked_ilog10()?;
        Some(digits as i32 + self.power)
    }

    /// As written beside ticks of which the largest is of magnitude `top`.
    fn label(self, top: i32) -> String {
        if self.digits == 0 {
            return "0".into();
        }
        if (-4..=4).contains(&top) {
            return self.plain();
        }
        self.scientific(top)
    }

    /// With a power of ten.
    fn scientific(self, top: i32) -> String {
        let mantissa = Self { power: self.power - top, ..self };
        match mantissa.plain().as_str() {
            "1" => power_of_ten(top),
            "−1" => format!("−{}", power_of_ten(top)),
            mantissa => format!("{mantissa}·{}", power_of_ten(top)),
        }
    }

    /// Without a power of ten.
    fn plain(self) -> String {
        let sign = if self.digits < 0 { "−" } else { "" };
        let digits = self.digits.unsigned_abs().to_string();
        if self.power >= 0 {
            return format!("{sign}{digits}{}", "0".repeat(self.power as usize));
        }
        let decimals = self.power.unsigned_abs() as usize;
        let digits = format!("{digits:0>width$}", width = decimals + 1);
        let (whole, part) = digits.split_at(digits.len() - decimals);
        format!("{sign}{whole}.{part}")
    }
}

/// 10ⁿ in the label markup.
fn power_of_ten(power: i32) -> String {
    format!("10^{{{}{}}}", if power < 0 { "−" } else { "" }, power.unsigned_abs())
}

/// 10ⁿ.
fn ten(power: i32) -> f64 {
    Decimal { digits: 1, power }.value()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::iter::empty;

    fn labels(axis: Axis, count: usize) -> Vec<String> {
        let ticks = Extent::new(&axis, empty(), 0.0).ticks(count, axis.tick);
        ticks.into_iter().filter_map(|tick| tick.label).collect()
    }

    #[test]
    fn linear_ticks_are_round_numbers() {
        assert_eq!(labels(Axis::linear("", "").range(0.0, 1.0), 6), ["0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(labels(Axis::linear("", "").range(0.0, 90.0).tick(30.0), 6), ["0", "30", "60", "90"]);
        assert_eq!(labels(Axis::linear("", "").range(-1.0, 1.0).tick(0.5), 9), ["−1.0", "−0.5", "0", "0.5", "1.0"]);
        assert_eq!(labels(Axis::linear("", "").range(0.0, 3e-7), 4), ["0", "10^{−7}", "2·10^{−7}", "3·10^{−7}"]);
        assert_eq!(labels(Axis::linear("", "").range(0.0, 0.3).tick(0.1), 4), ["0", "0.1", "0.2", "0.3"]);
    }

    #[test]
    fn log_ticks_are_powers_of_ten() {
        assert_eq!(labels(Axis::log("", "").range(1e-6, 1e-3), 6), ["10^{−6}", "10^{−5}", "10^{−4}", "10^{−3}"]);
        assert_eq!(labels(Axis::log("", "").range(0.1, 100.0), 6), ["0.1", "1", "10", "100"]);
        assert_eq!(labels(Axis::log("", "").range(1.0, 10.0), 6), ["1", "2", "5", "10"]);
        assert_eq!(labels(Axis::log("", "").range(1.1, 1.4), 4), ["1.1", "1.2", "1.3", "1.4"]);
        // All of an axis is written in one way.
        assert_eq!(labels(Axis::log("", "").range(1e-3, 1.0), 6), ["0.001", "0.01", "0.1", "1"]);
        assert_eq!(labels(Axis::log("", "").range(0.01, 2e4), 8), ["0.01", "0.1", "1", "10", "100", "1000", "10000"]);
        let mixed = ["10^{−4}", "10^{−3}", "10^{−2}", "10^{−1}", "1", "10", "10^{2}"];
        assert_eq!(labels(Axis::log("", "").range(1e-4, 100.0), 8), mixed);
        assert_eq!(
            Extent::new(&Axis::log("", "").range(4e-3, 1.0), empty(), 0.0).start_tick().unwrap().label.unwrap(),
            "0.005"
        );
        let wide = labels(Axis::log("", "").range(1e-300, 1e300), 8);
        assert!(wide.len() >= 3 && wide.len() <= 8 && wide.contains(&"1".to_owned()), "{wide:?}");
    }

    #[test]
    fn an_extent_that_cannot_be_shown_is_replaced() {
        let of = |axis: Axis, values: &[f64]| Extent::new(&axis, values.iter().copied(), 0.05);
        assert_eq!(of(Axis::linear("", ""), &[]).fraction(0.5), 0.5);
        assert_eq!(of(Axis::linear("", ""), &[f64::NAN, f64::INFINITY]).fraction(0.5), 0.5);
        assert!((of(Axis::linear("", ""), &[7.0]).fraction(7.0) - 0.5).abs() < 1e-12);
        assert_eq!(of(Axis::linear("", "").range(f64::NAN, 1.0), &[]).fraction(0.5), 0.5);
        assert!((of(Axis::log("", ""), &[-1.0, 0.0, 5.0]).fraction(5.0) - 0.5).abs() < 1e-12);
        assert!(of(Axis::log("", ""), &[1.0, 10.0]).fraction(0.0).is_nan());
        assert!((of(Axis::linear("", "").range(f64::MIN, f64::MAX), &[]).fraction(0.0) - 0.5).abs() < 1e-12);
        assert!((of(Axis::linear("", "").range(90.0, 0.0), &[]).fraction(90.0)).abs() < 1e-12);
    }

    fn any_axis() -> impl Strategy<Value = Axis> {
        let end = prop_oneof![any::<f64>(), -1e3..1e3, Just(0.0), Just(f64::MAX), Just(5e-324), Just(1.0)];
        (any::<bool>(), proptest::option::of((end.clone(), end.clone())), proptest::option::of(end)).prop_map(
            |(log, range, tick)| {
                let scale = if log { Scale::Log } else { Scale::Linear };
                Axis { scale, range, tick, ..Axis::linear("", "") }
            },
        )
    }

    proptest! {
        #[test]
        fn ticks_rise_within_the_axis_and_differ(axis in any_axis(), values in proptest::collection::vec(any::<f64>(), 0..4), count in 0usize..12) {
            let extent = Extent::new(&axis, values.into_iter(), 0.05);
            let ticks = extent.ticks(count, axis.tick);
            prop_assert!(ticks.len() <= 700);
            prop_assert!(ticks.iter().all(|tick| tick.at > -1e-6 && tick.at < 1.0 + 1e-6));
            prop_assert!(ticks.windows(2).all(|pair| pair[0].at < pair[1].at), "{extent:?} {ticks:?}");
            let labels: Vec<_> = ticks.iter().filter_map(|tick| tick.label.as_ref()).collect();
            prop_assert!(labels.windows(2).all(|pair| pair[0] != pair[1]));
            prop_assert!(labels.len() <= MOST as usize);
        }

        #[test]
        fn an_ordinary_axis_has_some_labels(log in any::<bool>(), low in -5.0..5.0f64, width in 0.01..30.0f64, count in 4usize..12) {
            let axis = if log { Axis::log("", "").range(10f64.powf(low), 10f64.powf(low + width)) }
                       else { Axis::linear("", "").range(low, low + width) };
            let found = labels(axis, count).len();
            prop_assert!((2..=count + 2).contains(&found), "{found}");
        }
    }
}
