//! From chapters and reports to blocks: what is told, and in which order.

mod contents;
mod coverage;
mod derivation;
mod findings;
mod functions;
mod help;
mod leaf;
mod lecture;
mod proof;
mod prose;
mod question;

use crate::block::{Block, Details, Face, Heading, Rank, Section, Span, Tone};
use crate::report::{Machine, StatementReport, StepReport, Verdict};
use crate::words::Words;
use chapters::text::{Catalogue, Phrase};

pub use leaf::Evidence;
pub use prose::section as prose_of;

/// Tells the lecture in the words of a catalogue.
#[derive(Clone, Copy)]
pub struct Teller<'a> {
    words: Words<'a>,
    /// What is shown besides the equations themselves.
    pub details: Details,
}

impl Teller<'static> {
    /// Tells it in English.
    pub fn english(details: Details) -> Self {
        Self { words: Words::ENGLISH, details }
    }
}

impl<'a> Teller<'a> {
    /// Tells it in the words of `catalogue`.
    pub fn new(catalogue: &'a dyn Catalogue, details: Details) -> Self {
        Self { words: Words(catalogue), details }
    }

    /// The words that a view of its blocks takes.
    pub fn words(&self) -> Words<'a> {
        self.words
    }

    /// The field of what stands at an address.
    pub fn phrase(&self, address: &str, field: &str, english: &str) -> Phrase {
        self.words.0.phrase(address, field, english)
    }

    /// The lecture's own words around what the chapters say: a template with its parts.
    fn say(&self, english: &str, parts: &[(&str, Phrase)]) -> Phrase {
        self.words.say(english, parts)
    }

    /// What the signs in a report mean.
    pub fn legend(&self) -> Vec<Block> {
        let lines = [
            "ulp = 2⁻⁵² is the rounding unit of the machine's numbers. cond in ulp · (1 + cond) is the condition number: \
             how strongly the exact answer reacts to its inputs.",
            "✓ holds, ✗ is broken. […] is a unit, [1] a pure number. E36 or C10 is a row of the lecture (`lesson coverage`).",
        ];
        let line = |line: &&str| Block::paragraph(0, 2, vec![Span::new(Tone::Dim, self.say(line, &[]))]);
        vec![Block::section(vec![Block::Group(lines.iter().map(line).collect())])]
    }

    /// The machine that the seconds belong to.
    pub fn machine(&self, machine: &Machine) -> Vec<Block> {
        let Machine { cpu, cores, os, arch, profile } = machine;
        let parts = [
            ("cpu", Phrase::verbatim(cpu)),
            ("cores", Phrase::verbatim(cores.to_string())),
            ("system", Phrase::verbatim(format!("{os} {arch}"))),
            ("profile", Phrase::verbatim(*profile)),
        ];
        let text = self.say("{cpu} ({cores} cores), {system}, {profile} build", &parts);
        vec![Block::text(0, Tone::Dim, text)]
    }

    fn heading(&self, found: &StepReport) -> Block {
        Block::Heading(Heading {
            rank: Rank::Step,
            text: vec![Span::new(Tone::Heading, self.phrase(&found.address, "title", found.title))],
            address: Some(found.address.clone()),
            rows: owned(found.rows),
        })
    }
}

/// The last line of every run, the same in every language.
pub fn tally(passed: usize, failed: usize) -> String {
    format!("{passed} passed, {failed} failed")
}

fn owned(rows: &[&str]) -> Vec<String> {
    rows.iter().map(|row| (*row).to_owned()).collect()
}

/// The tone of what was judged.
fn tone(verdict: Verdict) -> Tone {
    if verdict == Verdict::Passed { Tone::Good } else { Tone::Bad }
}

/// A section that stands for an address.
fn section_at(address: &str, blocks: Vec<Block>) -> Block {
    Block::Section(Section { address: Some(address.to_owned()), blocks })
}

fn face_of(statement: &StatementReport) -> Face {
    Face {
        unicode: statement.unicode.clone(),
        layout: statement.layout.clone(),
        mathml: statement.mathml.clone(),
        latex: statement.latex.clone(),
    }
}
