//! Questions, and what is said to each answer.

use super::Span;
use crate::number::{short, value};
use crate::words::Words;
use chapters::text::Phrase;

/// A question that the program can judge the answer of.
#[derive(Clone, Debug, PartialEq)]
pub struct Question {
    /// Where it stands in the lecture.
    pub address: String,
    /// What is asked.
    pub prompt: Vec<Span>,
    /// What may be answered.
    pub answers: Answers,
    /// Whether the answer is shown at once.
    pub open: bool,
}

/// What may be answered.
#[derive(Clone, Debug, PartialEq)]
pub enum Answers {
    /// One of several.
    Choices(Vec<Choice>),
    /// A number.
    Number {
        /// The right one, as the program computed it.
        value: f64,
        /// Its unit.
        unit: String,
        /// How far an answer may be off, relative to it [1].
        tolerance: f64,
        /// What is said to it.
        response: Phrase,
    },
}

/// One of several answers.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// The answer.
    pub says: Phrase,
    /// Whether it is the right one.
    pub right: bool,
    /// What is said to whoever chose it.
    pub response: Phrase,
}

impl Answers {
    /// The right answer in words.
    pub fn told(&self, words: Words) -> Phrase {
        match self {
            Self::Choices(choices) => {
                choices.iter().find(|choice| choice.right).map_or_else(Phrase::default, |choice| choice.says.clone())
            }
            Self::Number { value: number, unit, tolerance, .. } => {
                let parts = [("value", value(*number, unit)), ("tolerance", short(100.0 * tolerance))];
                let parts = parts.map(|(name, part)| (name, Phrase::parse(&part)));
                words.say("{value} within {tolerance} %", &parts)
            }
        }
    }
}
