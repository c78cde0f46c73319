//! What a step asks before it shows its evidence.

use super::Teller;
use crate::block::{Answers, Block, Choice, Question, Span, Tone};
use crate::report::QuestionReport;

impl Teller<'_> {
    /// A question; `open` if its answer is shown at once.
    pub fn question(&self, question: &QuestionReport, open: bool) -> Block {
        let field = |field: &str, english: &str| self.phrase(&question.address, field, english);
        let answers = match question.number {
            Some(number) => Answers::Number {
                value: number.0,
                unit: question.unit.to_owned(),
                tolerance: question.tolerance.unwrap_or(0.0),
                response: field("because", question.because),
            },
            None => {
                let choice = |(at, option): (usize, &crate::report::OptionReport)| Choice {
                    says: field(&format!("option {at}"), option.says),
                    right: option.right,
                    response: field(&format!("reply {at}"), option.reply),
                };
                Answers::Choices(question.options.iter().enumerate().map(choice).collect())
            }
        };
        let prompt = vec![Span::new(Tone::Strong, field("asks", question.asks))];
        Block::Question(Question { address: question.address.clone(), prompt, answers, open })
    }
}
