//! What a run found, as plain data: terminal and JSON are views of it.

use chapters::figure::Plot;
use chapters::parameter::Argument;
use chapters::vocabulary::Part;
use equation::face::Block;
use serde::{Serialize, Serializer};
use std::borrow::Cow;
use std::path::PathBuf;
use yardstick::precise::Real;

/// Name of the JSON document's layout.
pub const SCHEMA: &str = "lesson-report/1";

/// What a run does with the steps it is about; figures are drawn beside.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Parts {
    /// Units, derivations and checks.
    pub checks: bool,
    /// Extreme cases.
    pub stress: bool,
    /// Error against run time.
    pub races: bool,
}

impl Parts {
    /// Whether `part` is run.
    pub fn has(self, part: Part) -> bool {
        match part {
            Part::Checks => self.checks,
            Part::Stress => self.stress,
            Part::Races => self.races,
            Part::Figures => false,
        }
    }

    /// One part alone; none if it is the figures.
    pub fn only(part: Part) -> Self {
        Self { checks: part == Part::Checks, stress: part == Part::Stress, races: part == Part::Races }
    }
}

/// Everything that one run found.
#[derive(Debug, Serialize)]
pub struct Report {
    pub schema: &'static str,
    pub version: &'static str,
    pub machine: Machine,
    pub chapters: Vec<ChapterReport>,
    pub passed: usize,
    pub failed: usize,
}

/// Where the seconds were measured.
#[derive(Clone, Debug, Serialize)]
pub struct Machine {
    pub cpu: String,
    pub cores: usize,
    pub os: &'static str,
    pub arch: &'static str,
    /// `release` or `debug`.
    pub profile: &'static str,
}

#[derive(Debug, Serialize)]
pub struct ChapterReport {
    pub id: &'static str,
    pub title: &'static str,
    pub steps: Vec<StepReport>,
}

#[derive(Debug, Serialize)]
pub struct StepReport {
    pub address: String,
    pub title: &'static str,
    pub says: &'static str,
    pub rows: &'static [&'static str],
    pub setting: Vec<ParameterReport>,
    pub readout: Vec<QuantityReport>,
    pub statements: Vec<StatementReport>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub questions: Vec<QuestionReport>,
    pub derivations: Vec<DerivationReport>,
    pub checks: Vec<CheckReport>,
    pub stress: Vec<StressReport>,
    pub races: Vec<RaceReport>,
    pub figures: Vec<FigureReport>,
}

/// A parameter in force: a number in `unit`, or the index n + ik of a medium at the step's wavelength.
#[derive(Debug, Serialize)]
pub struct ParameterReport {
    pub name: &'static str,
    pub symbol: &'static str,
    pub says: &'static str,
    pub text: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub value: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub n: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub k: Option<Number>,
    pub unit: &'static str,
    /// As on the command line.
    pub default: Option<&'static str>,
    /// The description of its kind: ends, words or names, and what is valid in a sentence.
    pub domain: Argument,
}

#[derive(Debug, Serialize)]
pub struct QuantityReport {
    pub key: &'static str,
    #[serde(skip)]
    pub symbol: &'static str,
    pub says: &'static str,
    pub value: Number,
    pub unit: &'static str,
}

#[derive(Debug, Serialize)]
pub struct StatementReport {
    pub address: String,
    pub says: &'static str,
    pub rows: &'static [&'static str],
    pub latex: String,
    pub unicode: String,
    #[serde(skip)]
    pub layout: Block,
    /// The SI dimension of both sides, or how they differ.
    pub dimension: String,
    pub verdict: Verdict,
}

/// A question, and what is said to each answer.
#[derive(Debug, Serialize)]
pub struct QuestionReport {
    pub address: String,
    pub asks: &'static str,
    /// What can be chosen; empty if a number is asked for.
    pub options: Vec<OptionReport>,
    /// The right number, in `unit` (SI).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub number: Option<Number>,
    pub unit: &'static str,
    /// What the right answer shows.
    pub because: &'static str,
}

/// An answer that can be chosen.
#[derive(Debug, Serialize)]
pub struct OptionReport {
    pub says: &'static str,
    pub right: bool,
    /// What is said to whoever chooses it.
    pub reply: &'static str,
}

#[derive(Debug, Serialize)]
pub struct DerivationReport {
    pub address: String,
    pub says: &'static str,
    pub rows: &'static [&'static str],
    pub hypotheses: Vec<LineReport>,
    pub lines: Vec<LineReport>,
    /// What must not be zero.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub conditions: Vec<String>,
    /// How the units of a line disagree.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mismatch: Option<String>,
    pub verdict: Verdict,
}

/// A hypothesis or a line of a derivation, and what became of the hop that leads to it.
#[derive(Debug, Serialize)]
pub struct LineReport {
    pub latex: String,
    pub unicode: String,
    #[serde(skip)]
    pub layout: Block,
    /// Its SI dimension (of both sides, if it has two), or how they differ.
    pub dimension: String,
    /// The rules that justify it.
    pub by: Vec<Cow<'static, str>>,
    #[serde(skip_serializing_if = "str::is_empty")]
    pub says: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hop: Option<HopReport>,
    /// The single steps that it sums up.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub unfolded: Vec<LineReport>,
}

/// How a hop was verified.
#[derive(Debug, Serialize)]
pub struct HopReport {
    pub verdict: Verdict,
    /// `proved`, `agrees to 70 digits at 16 points`, `refuted at …`, or why nothing can be said.
    pub found: String,
    /// Decimal digits of agreement at the worst point.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub digits: Option<Number>,
}

#[derive(Debug, Serialize)]
pub struct CheckReport {
    pub address: String,
    pub claim: &'static str,
    pub rows: &'static [&'static str],
    pub route: &'static str,
    pub value: Number,
    /// The bound in words (`at most 8 ε`) and where it comes from.
    pub bound: String,
    pub why: &'static str,
    pub limit: Number,
    pub unit: &'static str,
    pub verdict: Verdict,
    pub at: String,
    pub cases: usize,
    pub seconds: f64,
    /// What to look at because the bound broke.
    #[serde(skip)]
    pub picture: Option<Plot>,
}

#[derive(Debug, Serialize)]
pub struct StressReport {
    pub address: String,
    pub claim: &'static str,
    pub rows: &'static [&'static str],
    pub textbook: &'static str,
    pub reference: &'static str,
    pub cases: Vec<CaseReport>,
    pub verdict: Verdict,
    pub seconds: f64,
}

/// One extreme input: what the reference, the textbook form and the program make of it, and the decimal digits kept.
#[derive(Debug, Serialize)]
pub struct CaseReport {
    pub input: String,
    pub quantity: &'static str,
    /// 17 significant digits, as text because it may lie outside the range of `f64`.
    pub reference: String,
    pub textbook: Number,
    pub ours: Number,
    pub textbook_digits: f64,
    pub our_digits: f64,
    /// Digits that the condition number lets any method keep, within the project's promise.
    pub allowed_digits: f64,
    pub condition: Number,
    /// How many inputs this one is the worst of.
    pub worst_of: usize,
    /// Whether the reference is exactly zero.
    #[serde(skip)]
    pub vanishes: bool,
    pub verdict: Verdict,
}

#[derive(Debug, Serialize)]
pub struct RaceReport {
    pub address: String,
    pub claim: &'static str,
    pub rows: &'static [&'static str],
    pub work: &'static str,
    pub error: &'static str,
    pub reference: &'static str,
    pub lanes: Vec<LaneReport>,
}

#[derive(Debug, Serialize)]
pub struct LaneReport {
    pub address: String,
    pub label: &'static str,
    pub repeats: u32,
    pub points: Vec<PointReport>,
    /// p of error ∝ work^(−p), fitted.
    pub order: Option<f64>,
    /// What is asserted of the errors, in words.
    pub expects: String,
    pub verdict: Verdict,
    #[serde(skip)]
    pub asserted: chapters::vocabulary::Expects,
}

#[derive(Debug, Serialize)]
pub struct PointReport {
    pub work: u64,
    pub error: Number,
    /// The fastest run.
    pub seconds: f64,
    pub ns_per_work: f64,
}

#[derive(Debug, Serialize)]
pub struct FigureReport {
    pub address: String,
    pub says: &'static str,
    pub rows: &'static [&'static str],
    pub path: PathBuf,
}

/// What became of something that could have failed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    Passed,
    Failed,
}

impl From<bool> for Verdict {
    fn from(holds: bool) -> Self {
        if holds { Self::Passed } else { Self::Failed }
    }
}

impl Report {
    /// Whether nothing was judged and nothing drawn.
    pub fn is_empty(&self) -> bool {
        let mut steps = self.chapters.iter().flat_map(|chapter| &chapter.steps);
        self.passed + self.failed == 0 && steps.all(|step| step.figures.is_empty())
    }
}

impl StepReport {
    /// The verdict of everything judged in this step.
    pub fn verdicts(&self) -> impl Iterator<Item = Verdict> + '_ {
        let statements = self.statements.iter().map(|item| item.verdict);
        let derivations = self.derivations.iter().map(|item| item.verdict);
        let checks = self.checks.iter().map(|item| item.verdict);
        let stress = self.stress.iter().map(|item| item.verdict);
        let lanes = self.races.iter().flat_map(|race| &race.lanes).map(|lane| lane.verdict);
        statements.chain(derivations).chain(checks).chain(stress).chain(lanes)
    }
}

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

/// A bound's limit in words: whole multiples of the rounding unit as such, `64 ε`.
pub fn limit(x: f64) -> String {
    let units = x / f64::EPSILON;
    if (1.0..=1e6).contains(&units) && units.fract() == 0.0 { format!("{units} ε") } else { short(x) }
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
        assert_eq!([64.0 * f64::EPSILON, 1e-14, 0.5, 0.0].map(limit), ["64 ε", "1e-14", "0.5", "0"]);
    }

    #[test]
    fn short_numbers_keep_six_digits() {
        let texts: Vec<_> = [-0.0, 1.0, 56.309_932_474, 0.04, 1e-12, 123_456.789, -2.5e7, f64::NAN].map(short).into();
        assert_eq!(texts, ["0", "1", "56.3099", "0.04", "1e-12", "123457", "-2.5e7", "nan"]);
        let texts: Vec<_> = [0.001_327_209_4, 1e-29, 9.999_999_9, 0.999_999_96, 999_999.9].map(short).into();
        assert_eq!(texts, ["0.00132721", "1e-29", "10", "1", "1000000"]);
        assert_eq!([1.0 / 6.0, 0.04, 11.0, -2.0].map(|x| significant(x, 3)), ["0.167", "0.04", "11", "-2"]);
    }
}
