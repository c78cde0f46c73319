//! Values of options.

use crate::render::MOST as MOST_SAMPLES;
use chapters::parameter::parse_quantity;
use std::time::Duration;

/// Reads `NAME=VALUE`.
pub fn assignment(text: &str) -> Result<(String, String), String> {
    let (name, value) = text.split_once('=').ok_or("expected NAME=VALUE")?;
    if name.is_empty() || value.is_empty() {
        return Err("expected NAME=VALUE with both sides filled".to_owned());
    }
    Ok((name.to_owned(), value.to_owned()))
}

/// A whole number from the first to the last.
pub fn whole(text: &str, first: u32, last: u32) -> Result<u32, String> {
    let number = text.parse().ok().filter(|number| (first..=last).contains(number));
    number.ok_or_else(|| format!("must be a whole number from {first} to {last}"))
}

pub fn seed(text: &str) -> Result<u64, String> {
    text.parse().map_err(|_| format!("must be a whole number from 0 to {}", u64::MAX))
}

/// A time of at most a month.
pub fn duration(text: &str) -> Result<Duration, String> {
    const MONTH: f64 = 30.0 * 86_400.0;
    let seconds = parse_quantity(text, "s")?;
    match seconds > 0.0 && seconds <= MONTH {
        true => Ok(Duration::from_secs_f64(seconds)),
        false => Err(format!("out of range; valid: above 0, up to {MONTH} s")),
    }
}

/// A range of samples; they come in pairs, one of each half of the picture.
pub fn sample_numbers(text: &str) -> Result<[u32; 2], String> {
    let valid = format!("valid: A..B, both even, A below B, up to {MOST_SAMPLES}, such as 64..128");
    let (from, to) = text.split_once("..").ok_or_else(|| format!("is no range; {valid}"))?;
    let number = |text: &str| text.parse::<u32>().ok().filter(|number| *number <= MOST_SAMPLES);
    let (Some(from), Some(to)) = (number(from), number(to)) else { return Err(format!("is no range; {valid}")) };
    if from % 2 == 1 || to % 2 == 1 {
        return Err(format!("cuts a pair of samples, which are rendered together; {valid}"));
    }
    if from < to { Ok([from, to]) } else { Err(format!("has no sample; {valid}")) }
}

pub fn share(text: &str) -> Result<f64, String> {
    let share = parse_quantity(text, "1")?;
    if share > 0.0 && share < 1.0 { Ok(share) } else { Err("out of range; valid: above 0, below 1".to_owned()) }
}

pub fn stops(text: &str) -> Result<f64, String> {
    let stops = parse_quantity(text, "1")?;
    if stops.abs() <= 30.0 { Ok(stops) } else { Err("out of range; valid: -30 to 30".to_owned()) }
}
