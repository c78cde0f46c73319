//! The next value up or down: what an arrow key does with a parameter.

use super::quantity::{Range, number, parse_quantity, suffix_of};
use super::{Argument, INDEX_MAX, INDEX_MIN, Kind, Parameter, Scale};

/// A step from one value to a neighbour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Nudge {
    /// Upwards, or to the next word.
    pub up: bool,
    /// Ten times as far.
    pub coarse: bool,
}

/// Into how many fine steps a range, or the value where a range has no size of its own, is divided about.
const STEPS: f64 = 100.0;
/// The fine step at zero, where the value has no size either.
const AT_ZERO: f64 = 0.01;

impl Parameter {
    /// The text of the neighbour of `text`, within the domain; `None` where there is none.
    pub fn nudged(&self, text: &str, nudge: Nudge) -> Option<String> {
        match self.kind {
            Kind::Number(range) => nudged(range, text, nudge),
            Kind::Count { min, max } => {
                let count = text.trim().parse::<f64>().ok()?;
                let next = (count + way(nudge)).clamp(min as f64, max as f64);
                (next != count).then(|| number(next))
            }
            Kind::Choice(words) => neighbour(words, text, nudge),
            Kind::Medium | Kind::MediumInParts | Kind::ClearMedium => match text.trim().parse::<f64>() {
                Ok(_) => nudged(Range::new(INDEX_MIN, INDEX_MAX, "1"), text, nudge),
                Err(_) => neighbour(&self.kind.names(), text, nudge),
            },
            Kind::Conductor => neighbour(&self.kind.names(), text, nudge),
            Kind::Vector(_) | Kind::List { .. } | Kind::Record(_) => None,
        }
    }
}

/// How far and which way, in fine steps.
fn way(nudge: Nudge) -> f64 {
    let far = if nudge.coarse { 10.0 } else { 1.0 };
    if nudge.up { far } else { -far }
}

/// The word before or after `text`; the first of those that it is none of.
fn neighbour(words: &[&str], text: &str, nudge: Nudge) -> Option<String> {
    let next = match words.iter().position(|word| word.eq_ignore_ascii_case(text.trim())) {
        None => words.first(),
        Some(at) if nudge.up => words.get(at + 1),
        Some(at) => at.checked_sub(1).and_then(|at| words.get(at)),
    };
    next.map(|word| (*word).to_owned())
}

/// The neighbour of a number, in the unit that it is written in.
fn nudged(range: Range, text: &str, nudge: Nudge) -> Option<String> {
    let (unit, factor) = suffix_of(text, range.unit);
    let value = parse_quantity(text, range.unit).ok()? / factor;
    let (least, most) = (range.min / factor, range.max / factor);
    // Of a range that is wide or has no ends the value says what is a small step.
    let sized = range.is_bounded() && range.scale() == Scale::Linear && most - least <= 1e3 * value.abs().max(1.0);
    let size = if sized { most - least } else { value.abs() };
    let step = if size == 0.0 { AT_ZERO } else { round(size / STEPS) };
    let target = value + step * way(nudge);
    // On the grid of steps, so that there and back is where it was; towards the end it only approaches it.
    let next = (target / step).round() * step;
    let inside = [next.clamp(least, most)].into_iter().find(|next| next.is_finite() && *next != value)?;
    let shown = |value: f64| format!("{}{unit}", number(value));
    // An end that is written in another unit may round to beyond itself.
    [shown(inside), shown(inside * (1.0 - 1e-9)), shown(inside * (1.0 + 1e-9))].into_iter().find(|text| {
        Kind::Number(range).read(&Argument::Text(text.clone())).is_ok()
            && parse_quantity(text, range.unit) != Ok(value * factor)
    })
}

/// The largest of 1, 2, 5, 10, 20 … that is not above `x` by much.
fn round(x: f64) -> f64 {
    let decade = 10f64.powf(x.log10().floor());
    let digit = [5.0, 2.0, 1.0].into_iter().find(|digit| digit * decade <= 1.12 * x).unwrap_or(1.0);
    if 10.0 * decade <= 1.12 * x { 10.0 * decade } else { digit * decade }
}

#[cfg(test)]
mod tests {
    use super::super::{THETA, WAVELENGTH};
    use super::*;

    const FINE: Nudge = Nudge { up: true, coarse: false };
    const BACK: Nudge = Nudge { up: false, coarse: false };
    const FAR: Nudge = Nudge { up: true, coarse: true };

    fn nudged(parameter: Parameter, text: &str, nudge: Nudge) -> Option<String> {
        parameter.nudged(text, nudge)
    }

    #[test]
    fn numbers_step_in_the_unit_they_are_written_in_and_stop_at_the_ends() {
        let degrees = |text, nudge| nudged(THETA, text, nudge);
        assert_eq!(degrees("45deg", FINE).as_deref(), Some("46deg"));
        assert_eq!(degrees("45deg", BACK).as_deref(), Some("44deg"));
        assert_eq!(degrees("45deg", FAR).as_deref(), Some("55deg"));
        assert_eq!(degrees("85deg", FAR).as_deref(), Some("90deg"));
        assert_eq!((degrees("90deg", FINE), degrees("0deg", BACK)), (None, None));
        assert_eq!(nudged(WAVELENGTH, "550nm", FINE).as_deref(), Some("555nm"));
        assert_eq!(nudged(WAVELENGTH, "550nm", FAR).as_deref(), Some("600nm"));
    }

    #[test]
    fn words_step_through_their_list() {
        let pol = Parameter::new("pol", "", "", Kind::Choice(&["s", "p"]));
        assert_eq!(nudged(pol, "s", FINE).as_deref(), Some("p"));
        assert_eq!((nudged(pol, "p", FINE), nudged(pol, "s", BACK)), (None, None));
        let index = Parameter::new("n_t", "", "", Kind::Medium);
        assert_eq!(nudged(index, "1.5", FINE).as_deref(), Some("1.51"));
        let names = Kind::Medium.names();
        assert_eq!(nudged(index, names[0], FINE).as_deref(), Some(names[1]));
    }

    #[test]
    fn every_number_of_the_lecture_goes_there_and_back_within_its_domain() {
        for (_, step) in crate::steps() {
            for parameter in step.parameters() {
                let Some(default) = parameter.default else { continue };
                for nudge in [FINE, BACK, FAR] {
                    let Some(next) = parameter.nudged(default, nudge) else { continue };
                    assert!(parameter.parse(&next).is_ok(), "{}: {default} to {next}", parameter.name);
                    assert!(next.len() < 24, "{}: {next}", parameter.name);
                    assert_ne!(next, default);
                }
            }
        }
    }
}
