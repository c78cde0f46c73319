//! What a run found, as plain data: everything that is shown of it is a view.

pub mod derivation;
pub mod entry;
mod parts;
pub mod proof;

pub use self::parts::Parts;
pub use crate::number::{Number, limit, seventeen_digits, short, significant};

use chapters::figure::Plot;
use chapters::parameter::Argument;
use equation::face::Block;
use serde::Serialize;
use std::borrow::Cow;
use std::path::PathBuf;

/// Name of the JSON document's layout.
pub const SCHEMA: &str = "lesson-report/1";

/// Everything that one run found.
#[derive(Debug, Serialize)]
pub struct Report {
    /// [`SCHEMA`].
    pub schema: &'static str,
    /// The program's.
    pub version: &'static str,
    /// Where it ran.
    pub machine: Machine,
    /// In teaching order.
    pub chapters: Vec<ChapterReport>,
    /// How many verdicts are good.
    pub passed: usize,
    /// How many are not.
    pub failed: usize,
}

/// Where the seconds were measured.
#[derive(Clone, Debug, Serialize)]
pub struct Machine {
    /// The processor's name.
    pub cpu: String,
    /// Threads that run at a time.
    pub cores: usize,
    /// Operating system.
    pub os: &'static str,
    /// Instruction set.
    pub arch: &'static str,
    /// `release` or `debug`.
    pub profile: &'static str,
}

/// A chapter, as far as it was run.
#[derive(Debug, Serialize)]
pub struct ChapterReport {
    /// First part of every address in it.
    pub id: &'static str,
    /// Heading.
    pub title: &'static str,
    /// In teaching order.
    pub steps: Vec<StepReport>,
}

/// A step, as far as it was run.
#[derive(Debug, Serialize)]
pub struct StepReport {
    /// Where it stands in the lecture.
    pub address: String,
    /// Heading.
    pub title: &'static str,
    /// What it says in words.
    pub says: &'static str,
    /// Rows of the lecture that it is about.
    pub rows: &'static [&'static str],
    /// The parameters in force.
    pub setting: Vec<ParameterReport>,
    /// The step's quantities at them.
    pub readout: Vec<QuantityReport>,
    /// The equations.
    pub statements: Vec<StatementReport>,
    /// What is asked before the evidence is shown.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub questions: Vec<QuestionReport>,
    /// How they follow.
    pub derivations: Vec<DerivationReport>,
    /// What could refute them.
    pub checks: Vec<CheckReport>,
    /// What could break them.
    pub stress: Vec<StressReport>,
    /// What they cost.
    pub races: Vec<RaceReport>,
    /// The figures drawn.
    pub figures: Vec<FigureReport>,
}

/// A parameter in force: a number in `unit`, or the index n + ik of a medium at the step's wavelength.
#[derive(Debug, Serialize)]
pub struct ParameterReport {
    /// The word before `=`.
    pub name: &'static str,
    /// Symbol, in the markup of labels.
    pub symbol: &'static str,
    /// What it says in words.
    pub says: &'static str,
    /// Its value as one types it.
    pub text: String,
    /// The number, in `unit`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub value: Option<Number>,
    /// Real part of the index.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub n: Option<Number>,
    /// Imaginary part of the index.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub k: Option<Number>,
    /// Unit of the numbers.
    pub unit: &'static str,
    /// As on the command line.
    pub default: Option<&'static str>,
    /// The description of its kind: ends, words or names, and what is valid in a sentence.
    pub domain: Argument,
}

/// A named number.
#[derive(Debug, Serialize)]
pub struct QuantityReport {
    /// Stable name.
    pub key: &'static str,
    /// Symbol, in the markup of labels.
    #[serde(skip)]
    pub symbol: &'static str,
    /// What it says in words.
    pub says: &'static str,
    /// What was found, in `unit`.
    pub value: Number,
    /// Unit of the numbers.
    pub unit: &'static str,
}

/// An equation of a step, its units judged.
#[derive(Debug, Serialize)]
pub struct StatementReport {
    /// Where it stands in the lecture.
    pub address: String,
    /// What it says in words.
    pub says: &'static str,
    /// Rows of the lecture that it is about.
    pub rows: &'static [&'static str],
    /// Its face for LaTeX.
    pub latex: String,
    /// Its face in one line.
    pub unicode: String,
    /// Its face in several lines.
    #[serde(skip)]
    pub layout: Block,
    /// Its face as an element of MathML.
    #[serde(skip)]
    pub mathml: String,
    /// The SI dimension of both sides, or how they differ.
    pub dimension: String,
    /// Whether it is shown as a mistake, of which the sides must differ.
    pub is_struck_out: bool,
    /// What became of it.
    pub verdict: Verdict,
}

/// A question, and what is said to each answer.
#[derive(Debug, Serialize)]
pub struct QuestionReport {
    /// Where it stands in the lecture.
    pub address: String,
    /// What is asked.
    pub asks: &'static str,
    /// What can be chosen; empty if a number is asked for.
    pub options: Vec<OptionReport>,
    /// The right number, in `unit` (SI).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub number: Option<Number>,
    /// Unit of the number.
    pub unit: &'static str,
    /// How far off a number may be, as a share of the right one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tolerance: Option<f64>,
    /// What the right answer shows.
    pub because: &'static str,
    /// Whether the right answer is one that can be given, and is taken.
    pub verdict: Verdict,
}

/// An answer that can be chosen.
#[derive(Debug, Serialize)]
pub struct OptionReport {
    /// The answer.
    pub says: &'static str,
    /// Whether it is right at the setting.
    pub right: bool,
    /// What is said to whoever chooses it.
    pub reply: &'static str,
}

/// A chain of lines, each hop judged.
#[derive(Debug, Serialize)]
pub struct DerivationReport {
    /// Where it stands in the lecture.
    pub address: String,
    /// What it says in words.
    pub says: &'static str,
    /// Rows of the lecture that it is about.
    pub rows: &'static [&'static str],
    /// What is assumed, as substitutions.
    pub hypotheses: Vec<LineReport>,
    /// The argument.
    pub lines: Vec<LineReport>,
    /// What must not be zero.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub conditions: Vec<String>,
    /// How the units of a line disagree.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mismatch: Option<String>,
    /// What became of it.
    pub verdict: Verdict,
}

/// A hypothesis or a line of a derivation, and what became of the hop that leads to it.
#[derive(Debug, Serialize)]
pub struct LineReport {
    /// Its face for LaTeX.
    pub latex: String,
    /// Its face in one line.
    pub unicode: String,
    /// Its face in several lines.
    #[serde(skip)]
    pub layout: Block,
    /// Its face as an element of MathML.
    #[serde(skip)]
    pub mathml: String,
    /// Its SI dimension (of both sides, if it has two), or how they differ.
    pub dimension: String,
    /// The rules that justify it.
    pub by: Vec<Cow<'static, str>>,
    /// What it says in words.
    #[serde(skip_serializing_if = "str::is_empty")]
    pub says: &'static str,
    /// How the hop to it was judged; none for a start.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hop: Option<HopReport>,
    /// The single steps that it sums up.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub unfolded: Vec<LineReport>,
}

/// How a hop was verified.
#[derive(Debug, Serialize)]
pub struct HopReport {
    /// What became of it.
    pub verdict: Verdict,
    /// `proved`, `agrees to 70 digits at 16 points`, `refuted at …`, or why nothing can be said.
    pub found: String,
    /// Decimal digits of agreement at the worst point.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub digits: Option<Number>,
}

/// A measurement against its bound.
#[derive(Debug, Serialize)]
pub struct CheckReport {
    /// Where it stands in the lecture.
    pub address: String,
    /// The claim.
    pub claim: &'static str,
    /// Rows of the lecture that it is about.
    pub rows: &'static [&'static str],
    /// The other route.
    pub route: &'static str,
    /// What was found, in `unit`.
    pub value: Number,
    /// The bound in words (`at most 8 ulp`) and where it comes from.
    pub bound: String,
    /// Where the bound comes from.
    pub why: &'static str,
    /// The bound's number.
    pub limit: Number,
    /// Unit of the numbers.
    pub unit: &'static str,
    /// What became of it.
    pub verdict: Verdict,
    /// The input of the worst case.
    pub at: String,
    /// How many cases were looked at.
    pub cases: usize,
    /// How long it took.
    pub seconds: f64,
    /// What to look at because the bound broke.
    #[serde(skip)]
    pub picture: Option<Plot>,
}

/// A family of extreme inputs.
#[derive(Debug, Serialize)]
pub struct StressReport {
    /// Where it stands in the lecture.
    pub address: String,
    /// The claim.
    pub claim: &'static str,
    /// Rows of the lecture that it is about.
    pub rows: &'static [&'static str],
    /// What the textbook column computes.
    pub textbook: &'static str,
    /// Where the reference comes from.
    pub reference: &'static str,
    /// The extreme inputs.
    pub cases: Vec<CaseReport>,
    /// What became of it.
    pub verdict: Verdict,
    /// How long it took.
    pub seconds: f64,
}

/// One extreme input: what the reference, the textbook form and the program make of it, and the decimal digits kept.
#[derive(Debug, Serialize)]
pub struct CaseReport {
    /// The input.
    pub input: String,
    /// What is computed.
    pub quantity: &'static str,
    /// 17 significant digits, as text because it may lie outside the range of `f64`.
    pub reference: String,
    /// What the textbook form gives.
    pub textbook: Number,
    /// What the program gives.
    pub ours: Number,
    /// Decimal digits that the textbook form keeps.
    pub textbook_digits: f64,
    /// Decimal digits that the program keeps.
    pub our_digits: f64,
    /// Digits that the condition number lets any method keep, within the project's promise.
    pub allowed_digits: f64,
    /// Condition number [1].
    pub condition: Number,
    /// How many inputs this one is the worst of.
    pub worst_of: usize,
    /// Whether the reference is exactly zero.
    #[serde(skip)]
    pub vanishes: bool,
    /// What became of it.
    pub verdict: Verdict,
}

/// Methods at growing work.
#[derive(Debug, Serialize)]
pub struct RaceReport {
    /// Where it stands in the lecture.
    pub address: String,
    /// The claim.
    pub claim: &'static str,
    /// Rows of the lecture that it is about.
    pub rows: &'static [&'static str],
    /// What a unit of work is.
    pub work: &'static str,
    /// Name of the error.
    pub error: &'static str,
    /// Where the reference comes from.
    pub reference: &'static str,
    /// The contestants.
    pub lanes: Vec<LaneReport>,
}

/// One contestant of a race.
#[derive(Debug, Serialize)]
pub struct LaneReport {
    /// Where it stands in the lecture.
    pub address: String,
    /// Name in table and legend.
    pub label: &'static str,
    /// How many runs make one error.
    pub repeats: u32,
    /// Error and time at growing work.
    pub points: Vec<PointReport>,
    /// p of error ∝ work^(−p), fitted.
    pub order: Option<f64>,
    /// What is asserted of the errors, in words.
    pub expects: String,
    /// What became of it.
    pub verdict: Verdict,
    /// The same as data.
    #[serde(skip)]
    pub asserted: chapters::vocabulary::Expects,
}

/// A contestant at one amount of work.
#[derive(Debug, Serialize)]
pub struct PointReport {
    /// Units of work.
    pub work: u64,
    /// The error (RMS if there are several runs).
    pub error: Number,
    /// The fastest run.
    pub seconds: f64,
    /// Time of a unit of work [ns].
    pub ns_per_work: f64,
}

/// A figure that was written.
#[derive(Debug, Serialize)]
pub struct FigureReport {
    /// Where it stands in the lecture.
    pub address: String,
    /// What it says in words.
    pub says: &'static str,
    /// Rows of the lecture that it is about.
    pub rows: &'static [&'static str],
    /// Where it was written.
    pub path: PathBuf,
}

/// What became of something that could have failed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// It holds.
    Passed,
    /// It does not.
    Failed,
}

impl From<bool> for Verdict {
    fn from(holds: bool) -> Self {
        if holds { Self::Passed } else { Self::Failed }
    }
}

impl StepReport {
    /// The verdict of everything judged in this step.
    pub fn verdicts(&self) -> impl Iterator<Item = Verdict> + '_ {
        let statements = self.statements.iter().map(|item| item.verdict);
        let questions = self.questions.iter().map(|item| item.verdict);
        let derivations = self.derivations.iter().map(|item| item.verdict);
        let checks = self.checks.iter().map(|item| item.verdict);
        let stress = self.stress.iter().map(|item| item.verdict);
        let lanes = self.races.iter().flat_map(|race| &race.lanes).map(|lane| lane.verdict);
        statements.chain(questions).chain(derivations).chain(checks).chain(stress).chain(lanes)
    }
}
