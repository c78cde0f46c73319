//! Numbers as people and JSON read them.

use serde::{Serialize, Serializer};
use yardstick::precise::Real;

/// An `f64` whose JSON face is a number, or the string "inf", "-inf" or "nan".
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Number(pub f64);

impl Number {
    /// The name of a value that JSON has no number for.
    pub fn non_finite(self) -> Option<&'static str> {
        match self.0 {
            x if x.is_nan() => Some("nan"),
            f64::INFINITY => Some("inf"),
            f64::NEG_INFINITY => Some("-inf"),
            _ => None,
        }
    }
}

impl Serialize for Number {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.non_finite() {
            Some(name) => serializer.serialize_str(name),
            None => serializer.serialize_f64(self.0),
        }
    }
}

/// `value` with 17 significant digits, such as `-1.2345678901234567e-4567`.
pub fn seventeen_digits(value: &Real) -> String {
    let decimal = value.clone().with_base_and_precision::<10>(17).value();
    let (significand, exponent) = decimal.repr().clone().into_parts();
    let (sign, digits) = match significand.to_string() {
        text if text.starts_with('-') => ("-", text[1..].to_owned()),
        text => ("", text),
    };
    if digits == "0" {
        return format!("{:.16e}", 0.0);
    }
    let magnitude = exponent + digits.len() as isize - 1;
    let mut tail = digits[1..].to_owned();
    tail.extend(std::iter::repeat_n('0', 16_usize.saturating_sub(tail.len())));
    format!("{sign}{}.{tail}e{magnitude}", &digits[..1])
}

/// A bound's limit in words: whole multiples of the rounding unit as such, `64 ulp`.
pub fn limit(x: f64) -> String {
    let units = x / f64::EPSILON;
    if (1.0..=1e6).contains(&units) && units.fract() == 0.0 { format!("{units} ulp") } else { short(x) }
}

/// To a hundredth; zero has no sign.
pub fn hundredths(x: f64) -> String {
    format!("{:.2}", (100.0 * x).round() / 100.0 + 0.0)
}

/// Up to six significant digits.
pub fn short(x: f64) -> String {
    significant(x, 6)
}

/// Up to `digits` significant digits, the very small and the large in powers of ten.
pub fn significant(x: f64, digits: usize) -> String {
    if let Some(name) = Number(x).non_finite() {
        return name.to_owned();
    }
    // Adding zero takes the sign off a negative one.
    let x = x + 0.0;
    let magnitude = x.abs();
    let scientific = format!("{x:.*e}", digits.saturating_sub(1));
    if magnitude != 0.0 && !(1e-4..1e6).contains(&magnitude) {
        return trimmed(&scientific);
    }
    // The exponent after rounding, which may have carried into another digit.
    let exponent = scientific.split_once('e').and_then(|(_, exponent)| exponent.parse::<i64>().ok()).unwrap_or(0);
    trimmed(&format!("{x:.*}", usize::try_from(digits as i64 - 1 - exponent).unwrap_or(0)))
}

/// Without the zeros at the end of its fraction.
fn trimmed(text: &str) -> String {
    let (mantissa, exponent) = text.split_at(text.find('e').unwrap_or(text.len()));
    let mantissa = if mantissa.contains('.') { mantissa.trim_end_matches('0').trim_end_matches('.') } else { mantissa };
    format!("{mantissa}{exponent}")
}

/// 17 significant digits, or the name of what is not finite.
pub fn full(x: Number) -> String {
    x.non_finite().map_or_else(|| format!("{:.16e}", x.0), str::to_owned)
}

/// What lengths are told in [m].
const LENGTHS: [(f64, &str); 5] = [(1e-9, "nm"), (1e-6, "µm"), (1e-3, "mm"), (1.0, "m"), (1e3, "km")];

/// A length [m] in the unit that leaves one to three digits before the point, as far as there is one.
fn length(metres: f64) -> String {
    let reached = LENGTHS.iter().rev().find(|(size, _)| metres.abs() >= *size);
    let (size, unit) = if metres == 0.0 { (1.0, "m") } else { *reached.unwrap_or(&LENGTHS[0]) };
    format!("{} {unit}", short(metres / size))
}

/// A value with its unit as people read it: angles in degrees, lengths in the prefix of their size.
pub fn value(value: f64, unit: &str) -> String {
    let sign = if value < 0.0 { "−" } else { "" };
    match unit {
        _ if value.is_nan() => "none".to_owned(),
        _ if value.is_infinite() => format!("{sign}∞"),
        "rad" => format!("{}°", short(value.to_degrees())),
        "m" => length(value),
        "1" | "" => short(value),
        _ => format!("{} {unit}", short(value)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use yardstick::precise;

    #[test]
    fn numbers_that_json_lacks_become_strings() {
        let text = serde_json::to_string(&[Number(0.1), Number(f64::NAN), Number(f64::INFINITY), Number(-1e-320)]);
        assert_eq!(text.unwrap(), r#"[0.1,"nan","inf",-1e-320]"#);
    }

    #[test]
    fn references_print_like_floats_and_beyond_their_range() {
        for x in [0.1, -2.0 / 3.0, 1e300, 5e-324, 1.0, 12345.678] {
            assert_eq!(seventeen_digits(&precise::real(x)), format!("{x:.16e}"));
        }
        assert_eq!(seventeen_digits(&precise::real(0.0)), "0.0000000000000000e0");
        let tiny = precise::real(1e-300);
        let tinier = &(&tiny * &tiny) * &tiny;
        assert!(seventeen_digits(&tinier).ends_with("e-900"), "{}", seventeen_digits(&tinier));
    }

    #[test]
    fn limits_count_rounding_units_where_they_are_whole() {
        assert_eq!([64.0 * f64::EPSILON, 1e-14, 0.5, 0.0].map(limit), ["64 ulp", "1e-14", "0.5", "0"]);
    }

    #[test]
    fn short_numbers_keep_six_digits() {
        let texts: Vec<_> = [-0.0, 1.0, 56.309_932_474, 0.04, 1e-12, 123_456.789, -2.5e7, f64::NAN].map(short).into();
        assert_eq!(texts, ["0", "1", "56.3099", "0.04", "1e-12", "123457", "-2.5e7", "nan"]);
        let texts: Vec<_> = [0.001_327_209_4, 1e-29, 9.999_999_9, 0.999_999_96, 999_999.9].map(short).into();
        assert_eq!(texts, ["0.00132721", "1e-29", "10", "1", "1000000"]);
        assert_eq!([1.0 / 6.0, 0.04, 11.0, -2.0].map(|x| significant(x, 3)), ["0.167", "0.04", "11", "-2"]);
    }

    #[test]
    fn values_carry_the_unit_of_their_size() {
        let lengths = [550.078e3, 550e-9, 2.06e-6, 0.0, -1.5e-3, 1e-12, 5.0, 1e-29];
        let told = ["550.078 km", "550 nm", "2.06 µm", "0 m", "-1.5 mm", "0.001 nm", "5 m", "1e-20 nm"];
        assert_eq!(lengths.map(|x| value(x, "m")), told);
        assert_eq!(value(0.001_327_209_4, "W/m²"), "0.00132721 W/m²");
        assert_eq!(value(std::f64::consts::FRAC_PI_2, "rad"), "90°");
    }
}
