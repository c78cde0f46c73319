//! The words in which a chapter is written: all data, nothing about how it is shown. One file for each kind of item.
//!
//! A claim is found by its address, `chapter/step/item` (`fresnel/energy/r_plus_t`): the same string is
//! command-line argument, JSON key, test name, book anchor and random stream.
//!
//! An item is written as a sentence of small words:
//!
//! ```ignore
//! const ENDS: Check<fn(f64, f64) -> f64> = check("both_ends", "exact at both ends")
//!     .against("the exact R_n")
//!     .within(16.0, "ulp", "a few roundings")
//!     .of(worst_gap, schlick)
//!     .slip("1 − R₀ forgotten", |cos, n| r_0(n) + (1.0 - cos).powi(5));
//! ```
//!
//! It is evidence for the lecture rows of its step, unless it names `rows` of its own.

mod bench;
mod check;
mod derivation;
mod figure;
mod item;
mod question;
mod race;
mod statement;
mod stress;

pub use bench::{Bench, Quantity, SEED};
pub use check::{Bound, Check, Claim, Claimed, Head, Measured, Measurement, check, excess, largest};
pub use derivation::{Derivation, Unspoiled, derivation};
pub use figure::{Exhibit, Figure, Gallery, exhibit, figure, gallery};
pub use item::{Item, Part};
pub use question::{Answer, Choice, Given, Misled, Question, Reply, SIGNS, TRENDS, choice, question};
pub use race::{Entrant, Expects, Heat, Judge, Lane, Race, Run, fitted_order, lane, race};
pub use statement::{Statement, statement};
pub use stress::{ALLOWED_ULPS, Extreme, OwnCases, Stress, digits, stress};

use crate::parameter::Function;
use crate::parameter::{Parameter, Setting};

/// One chapter of the lecture.
#[derive(Debug)]
pub struct Chapter {
    /// First part of every address in it; also the command-line word.
    pub id: &'static str,
    /// Heading.
    pub title: &'static str,
    /// One sentence: what the learner can do afterwards.
    pub says: &'static str,
    /// Ids of the chapters it needs.
    pub builds_on: &'static [&'static str],
    /// The course text, Markdown; `<!-- step: id -->` stands where that step's views go.
    pub prose: &'static str,
    /// In teaching order.
    pub steps: &'static [Step],
    /// What the steps show, for whoever only draws.
    pub figures: Gallery,
    /// What `lesson eval` offers from this chapter.
    pub functions: &'static [Function],
}

/// One step of a chapter: everything that any view of it needs.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    /// Second part of the address; a module name (`total_reflection`).
    pub id: &'static str,
    /// Heading.
    pub title: &'static str,
    /// The claim in one sentence.
    pub says: &'static str,
    /// The lecture rows that this step teaches (`E36`, `C10`), and for which its items are evidence.
    pub rows: &'static [&'static str],
    /// What can be set, and what it looks like.
    pub exhibit: Exhibit,
    /// The equations shown, as objects.
    pub statements: &'static [Statement],
    /// The one of these that the step is about, by its id; none is the first.
    pub key: Option<&'static str>,
    /// What is asked before the evidence is shown.
    pub questions: &'static [Question],
    /// How the statements follow from earlier ones.
    pub derivations: &'static [Derivation],
    /// The step's quantities at the setting, computed by the program's own functions.
    pub readout: Option<fn(&Setting) -> Vec<Quantity>>,
    /// What could refute it.
    pub checks: &'static [&'static dyn Claim],
    /// What could break it.
    pub stress: &'static [Stress],
    /// What it costs.
    pub races: &'static [Race],
}

/// The step of an exhibit: its title, and its claim in one sentence.
pub const fn step(exhibit: Exhibit, title: &'static str, says: &'static str) -> Step {
    Step {
        id: exhibit.step,
        title,
        says,
        rows: &[],
        exhibit,
        statements: &[],
        key: None,
        questions: &[],
        derivations: &[],
        readout: None,
        checks: &[],
        stress: &[],
        races: &[],
    }
}

impl Step {
    /// The lecture rows that it teaches.
    pub const fn rows(self, rows: &'static [&'static str]) -> Self {
        Self { rows, ..self }
    }

    /// The equations shown.
    pub const fn statements(self, statements: &'static [Statement]) -> Self {
        Self { statements, ..self }
    }

    /// The one of the equations that the step is about, where others come first.
    pub const fn about(self, key: &'static str) -> Self {
        Self { key: Some(key), ..self }
    }

    /// What is asked before the evidence is shown.
    pub const fn questions(self, questions: &'static [Question]) -> Self {
        Self { questions, ..self }
    }

    /// How the statements follow.
    pub const fn derivations(self, derivations: &'static [Derivation]) -> Self {
        Self { derivations, ..self }
    }

    /// Its quantities at the setting.
    pub const fn readout(self, readout: fn(&Setting) -> Vec<Quantity>) -> Self {
        Self { readout: Some(readout), ..self }
    }

    /// What could refute it.
    pub const fn checks(self, checks: &'static [&'static dyn Claim]) -> Self {
        Self { checks, ..self }
    }

    /// What could break it.
    pub const fn stress(self, stress: &'static [Stress]) -> Self {
        Self { stress, ..self }
    }

    /// What it costs.
    pub const fn races(self, races: &'static [Race]) -> Self {
        Self { races, ..self }
    }

    /// What `--set` may change here.
    pub fn parameters(&self) -> &'static [Parameter] {
        self.exhibit.parameters
    }
}
