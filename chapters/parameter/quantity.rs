//! Numbers with a unit: what is taken, how it is read and how it is written.

use super::argument::{Argument, shortest};
use super::excerpt;
use std::f64::consts::PI;

/// The finite numbers within `min ..= max`, in `unit` (SI: `rad`, `m`, `Hz`, `1`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Smallest value.
    pub min: f64,
    /// Largest value.
    pub max: f64,
    /// SI unit.
    pub unit: &'static str,
}

/// How a slider should run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Equal steps.
    Linear,
    /// Equal ratios.
    Logarithmic,
}

/// The smallest number above zero: the end of a range that leaves out zero itself.
const SMALLEST: f64 = f64::from_bits(1);

/// Ends at least this many times apart are better passed in ratios than in steps.
const WIDE: f64 = 1e3;

impl Range {
    /// `min ..= max` in `unit`.
    pub const fn new(min: f64, max: f64, unit: &'static str) -> Self {
        Self { min, max, unit }
    }

    /// More than zero, up to `max`.
    pub const fn positive(max: f64, unit: &'static str) -> Self {
        Self { min: SMALLEST, max, unit }
    }

    /// Any finite number.
    pub const fn any(unit: &'static str) -> Self {
        Self { min: f64::MIN, max: f64::MAX, unit }
    }

    /// Whether it is a bound at all.
    pub fn is_bounded(&self) -> bool {
        self.min != f64::MIN || self.max != f64::MAX
    }

    /// Whether `value` is in it.
    pub fn holds(&self, value: f64) -> bool {
        value.is_finite() && (self.min..=self.max).contains(&value)
    }

    /// How a slider over it should run.
    pub fn scale(&self) -> Scale {
        let is_wide = self.min > 0.0 && self.max / self.min >= WIDE;
        if is_wide { Scale::Logarithmic } else { Scale::Linear }
    }

    /// In words, in the unit that `text` carries, otherwise as a number that stands for `bare`.
    pub(super) fn words(&self, text: &str, bare: &str) -> String {
        if !self.is_bounded() {
            return "valid: any finite number".into();
        }
        let (suffix, factor) = suffix(text, self.unit).unwrap_or(("", size(bare, self.unit)));
        let end = |end: f64| format!("{}{suffix}", number(end / factor));
        let unit = match (suffix, bare, self.unit) {
            ("", "", "1") => String::new(),
            ("", "", unit) | ("", unit, _) => format!(" {unit}"),
            _ => String::new(),
        };
        match self.min {
            SMALLEST => format!("valid: above 0, up to {}{unit}", end(self.max)),
            min => format!("valid: {} to {}{unit}", end(min), end(self.max)),
        }
    }

    /// Reads a number of it; one without a suffix counts in the unit `bare`, or in SI if that is empty. `like` is a text
    /// in whose unit the range is told where the argument has none.
    pub(super) fn read(&self, argument: &Argument, bare: &'static str, like: &str) -> Result<f64, String> {
        let given = argument.excerpt();
        let valid = || self.words(if suffix(&given, self.unit).is_some() { &given } else { like }, bare);
        let value = match argument {
            Argument::Number(value) => value * size(bare, self.unit),
            Argument::Text(text) => parse_in(text, self.unit, bare).map_err(|why| format!("{why}; {}", valid()))?,
            _ => return Err(format!("must be a number; {}", valid())),
        };
        if self.holds(value) {
            return Ok(value);
        }
        let meant = if bare.is_empty() { self.meant(&given, like) } else { String::new() };
        Err(format!("{given} is out of range; {}{meant}", valid()))
    }

    /// A number out of range without a unit may lack the one in which people count.
    fn meant(&self, given: &str, like: &str) -> String {
        if suffix(given, self.unit).is_some() {
            return String::new();
        }
        let usual = suffix(like, self.unit).map_or(usual(self.unit), |(suffix, _)| suffix);
        let meant = format!("{}{usual}", given.trim());
        let is_meant = !usual.is_empty() && parse_quantity(&meant, self.unit).is_ok_and(|value| self.holds(value));
        if is_meant { format!(" (did you mean `{meant}`?)") } else { String::new() }
    }
}

/// `x` as one would type it, without the last digits that unit conversion leaves behind.
pub fn number(x: f64) -> String {
    let x: f64 = format!("{x:.9e}").parse().expect("a number just printed");
    if x == 0.0 || (1e-4..1e6).contains(&x.abs()) { x.to_string() } else { format!("{x:e}") }
}

/// Reads a finite number with an optional unit suffix, converted to `unit`.
///
/// # Errors
/// What is wrong with it.
pub fn parse_quantity(text: &str, unit: &str) -> Result<f64, String> {
    parse_in(text, unit, "")
}

fn parse_in(text: &str, unit: &str, bare: &str) -> Result<f64, String> {
    let text = text.trim();
    let (suffix, factor) = suffix(text, unit).unwrap_or(("", size(bare, unit)));
    let digits = &text[..text.len() - suffix.len()];
    let value: f64 = digits.trim_end().parse().map_err(|_| not_a_quantity(text, unit))?;
    let value = if factor == DEGREE { value.to_radians() } else { value * factor };
    if !value.is_finite() {
        return Err(format!("`{}` is not a finite number", excerpt(text)));
    }
    Ok(value)
}

/// Why `text` is no quantity in `unit`; if it is a number with a unit of another kind, which units there are.
fn not_a_quantity(text: &str, unit: &str) -> String {
    let shown = excerpt(text);
    let begins = text.char_indices().map(|(at, _)| at).rev().find(|at| text[..*at].trim_end().parse::<f64>().is_ok());
    let Some(begins) = begins else { return format!("`{shown}` is not a number") };
    let (known, given) = (suffixes(unit), excerpt(text[begins..].trim_start()));
    match known {
        [] => format!("`{shown}`: `{given}` is no unit here; this is a number without one"),
        _ => {
            let known: Vec<_> = known.iter().map(|(suffix, _)| *suffix).collect();
            format!("`{shown}`: `{given}` is no unit here; units: {}", known.join(", "))
        }
    }
}

/// `value` in SI as a text that reads back to it, in the suffix that leaves its number between 1 and 1000 if the trip
/// through that unit keeps the last bit, otherwise in SI.
pub fn write_quantity(value: f64, unit: &str) -> String {
    let preferred = suffixes(unit).iter().filter(|(_, factor)| (1.0..1000.0).contains(&(value / factor).abs()));
    let si = suffixes(unit).iter().find(|(_, factor)| *factor == 1.0).map_or("", |(suffix, _)| suffix);
    let texts = preferred.map(|(suffix, factor)| format!("{}{suffix}", shortest(rounded(value / factor))));
    let kept = texts.into_iter().find(|text| parse_quantity(text, unit) == Ok(value));
    kept.unwrap_or_else(|| format!("{}{si}", shortest(value)))
}

/// To fifteen digits, which is what survives a multiplication.
fn rounded(x: f64) -> f64 {
    format!("{x:.14e}").parse().unwrap_or(x)
}

/// The suffix that a quantity in `unit` carries, with its size in it.
fn suffix(text: &str, unit: &str) -> Option<(&'static str, f64)> {
    let text = text.trim();
    let number =
        |suffix: &str| text.strip_suffix(suffix).is_some_and(|digits| digits.trim_end().parse::<f64>().is_ok());
    suffixes(unit).iter().copied().find(|(suffix, _)| number(suffix))
}

/// The suffix that a quantity in `unit` carries and its size in it; nothing and 1 of a bare one.
pub(super) fn suffix_of(text: &str, unit: &str) -> (&'static str, f64) {
    suffix(text, unit).unwrap_or(("", 1.0))
}

/// The size of the suffix `bare` in `unit`; 1 of none.
fn size(bare: &str, unit: &str) -> f64 {
    suffixes(unit).iter().find(|(suffix, _)| *suffix == bare).map_or(1.0, |(_, factor)| *factor)
}

const DEGREE: f64 = PI / 180.0;

/// The unit in which people count what is kept in `unit`, if that is another one.
fn usual(unit: &str) -> &'static str {
    match unit {
        "rad" => "deg",
        "m" => "nm",
        "Hz" => "THz",
        _ => "",
    }
}

/// Suffixes that are understood for a unit, with their size in it.
pub(super) fn suffixes(unit: &str) -> &'static [(&'static str, f64)] {
    match unit {
        "rad" => &[("deg", DEGREE), ("°", DEGREE), ("rad", 1.0)],
        "m" => &[("nm", 1e-9), ("um", 1e-6), ("µm", 1e-6), ("μm", 1e-6), ("mm", 1e-3), ("km", 1e3), ("m", 1.0)],
        "Hz" => &[("PHz", 1e15), ("THz", 1e12), ("GHz", 1e9), ("MHz", 1e6), ("kHz", 1e3), ("mHz", 1e-3), ("Hz", 1.0)],
        "Ω" => &[("kΩ", 1e3), ("mΩ", 1e-3), ("Ω", 1.0), ("kohm", 1e3), ("ohm", 1.0)],
        "s" => &[
            ("fs", 1e-15),
            ("ps", 1e-12),
            ("ns", 1e-9),
            ("us", 1e-6),
            ("ms", 1e-3),
            ("s", 1.0),
            ("min", 60.0),
            ("h", 3600.0),
        ],
        _ => &[],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_2;

    #[test]
    fn quantities_take_suffixes_and_refuse_the_rest() {
        assert_eq!(parse_quantity("90deg", "rad"), Ok(FRAC_PI_2));
        assert_eq!(parse_quantity("0.5", "rad"), Ok(0.5));
        assert!((parse_quantity("550nm", "m").unwrap() - 550e-9).abs() < 1e-22);
        assert_eq!(parse_quantity("1GHz", "Hz"), Ok(1e9));
        assert_eq!(parse_quantity("50 Hz", "Hz"), Ok(50.0));
        assert_eq!(parse_quantity("2mHz", "Hz"), Ok(2e-3));
        for bad in ["", "deg", "1e400", "nan", "inf", "5 furlongs", "550nm nm"] {
            assert!(parse_quantity(bad, "m").is_err(), "{bad}");
        }
    }

    #[test]
    fn a_wrong_unit_is_told_the_right_ones() {
        let says = |text, unit| parse_quantity(text, unit).unwrap_err();
        assert_eq!(says("545nm", "Hz"), "`545nm`: `nm` is no unit here; units: PHz, THz, GHz, MHz, kHz, mHz, Hz");
        assert_eq!(says("1e3 furlongs", "rad"), "`1e3 furlongs`: `furlongs` is no unit here; units: deg, °, rad");
        assert_eq!(says("1.5nm", "1"), "`1.5nm`: `nm` is no unit here; this is a number without one");
        assert_eq!(says("much", "m"), "`much` is not a number");
        let light = Range::new(3e11, 3e17, "Hz");
        assert!(light.read(&"545".into(), "", "").unwrap_err().ends_with("(did you mean `545THz`?)"));
    }

    #[test]
    fn ranges_are_told_in_the_unit_given() {
        let angles = Range::new(0.0, FRAC_PI_2, "rad");
        let says = |range: Range, given: Argument, bare, like| range.read(&given, bare, like).unwrap_err();
        assert_eq!(says(angles, "95deg".into(), "", ""), "95deg is out of range; valid: 0deg to 90deg");
        let hint = "56.3 is out of range; valid: 0 to 1.570796327 rad (did you mean `56.3deg`?)";
        assert_eq!(says(angles, "56.3".into(), "", ""), hint);
        assert_eq!(says(angles, 56.3.into(), "", ""), hint);
        let lengths = Range::new(1e-9, 1e-3, "m");
        let valid = "valid: 1nm to 1e6nm (did you mean `550nm`?)";
        assert_eq!(says(lengths, "550".into(), "", "550nm"), format!("550 is out of range; {valid}"));
        assert_eq!(says(lengths, "5mm".into(), "", "550nm"), "5mm is out of range; valid: 1e-6mm to 1mm");
        assert_eq!(says(lengths, 0.0.into(), "nm", ""), "0 is out of range; valid: 1 to 1e6 nm");
        assert_eq!(lengths.read(&550.0.into(), "nm", ""), lengths.read(&"550nm".into(), "", ""));
        assert_eq!(says(Range::new(1e-9, 1e9, "1"), 0.0.into(), "", ""), "0 is out of range; valid: 1e-9 to 1e9");
        assert_eq!(
            says(Range::positive(1e30, "1"), 0.0.into(), "", ""),
            "0 is out of range; valid: above 0, up to 1e30"
        );
        assert_eq!(says(Range::any("1"), f64::NAN.into(), "", ""), "NaN is out of range; valid: any finite number");
    }

    #[test]
    fn quantities_are_written_in_a_unit_that_keeps_them() {
        for (text, unit) in [("550nm", "m"), ("45deg", "rad"), ("1GHz", "Hz"), ("188.365156706Ω", "Ω"), ("2.3", "1")]
        {
            assert_eq!(write_quantity(parse_quantity(text, unit).unwrap(), unit), text);
        }
        assert_eq!(write_quantity(1e-40, "m"), "1e-40m");
    }

    #[test]
    fn wide_ranges_run_in_ratios() {
        assert_eq!(Range::new(1e-9, 1e-3, "m").scale(), Scale::Logarithmic);
        assert_eq!(Range::new(0.0, FRAC_PI_2, "rad").scale(), Scale::Linear);
        assert_eq!(Range::new(1.0, 5.0, "1").scale(), Scale::Linear);
    }
}
