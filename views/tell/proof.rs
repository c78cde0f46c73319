//! What `lesson prove` answers.

use super::Teller;
use crate::block::{Block, Span, Tone};
use crate::report::proof::ProofReport;
use chapters::text::Phrase;

impl Teller<'_> {
    /// The argument, and the verdict under it.
    pub fn proof(&self, answer: &ProofReport) -> Vec<Block> {
        let mut argument = vec![self.lines("prove", &answer.lines)];
        argument.extend(answer.hypotheses.iter().map(|line| {
            let with = self.say("with {what}", &[("what", Phrase::verbatim(&line.unicode))]);
            Block::text(6, Tone::Dim, with)
        }));
        let mut blocks = vec![Block::section(vec![Block::Group(argument)])];
        blocks.extend(self.verdict(answer));
        blocks
    }

    fn verdict(&self, answer: &ProofReport) -> Vec<Block> {
        let word = |tone, word: &str| Span::new(tone, self.say(word, &[]));
        let plain = |template: &str, text: String| {
            let text = self.say(template, &[("text", Phrase::verbatim(text))]);
            Span::new(Tone::Plain, Phrase::verbatim(" ").then(text))
        };
        match (answer.verdict, &answer.witness) {
            ("proved", _) => {
                let mut spans = vec![word(Tone::Good, "Proved")];
                let (positive, real) = (&answer.assumed.positive, &answer.assumed.real);
                let also_real = if positive.is_empty() { "for real {text}" } else { "and real {text}" };
                let kinds = [("for positive {text}", positive), (also_real, real)];
                let kinds = kinds.into_iter().filter(|(_, names)| !names.is_empty());
                spans.extend(kinds.map(|(kind, names)| plain(kind, names.join(", "))));
                if !answer.conditions.is_empty() {
                    spans.push(plain("where {text}", answer.conditions.join(", ")));
                }
                vec![Block::paragraph(2, 4, spans)]
            }
            ("refuted", None) => vec![Block::paragraph(2, 4, vec![word(Tone::Bad, "Refuted")])],
            ("refuted", Some(witness)) => {
                let at: Vec<_> = witness.at.iter().map(|(symbol, value)| format!("{symbol} = {value}")).collect();
                let mut spans = vec![word(Tone::Bad, "Refuted")];
                if !at.is_empty() {
                    spans.push(plain("at {text}", at.join(", ")));
                }
                let mut blocks = vec![Block::paragraph(2, 4, spans)];
                if let Some(sides) = &witness.values {
                    let side = |name: &str, value: &String| {
                        let name = format!("{:<7}", self.say(name, &[]).to_string());
                        Block::paragraph(4, 12, vec![Span::verbatim(Tone::Dim, name), Span::plain(value)])
                    };
                    blocks.extend([side("left", &sides.left), side("right", &sides.right)]);
                }
                blocks
            }
            _ => {
                let why = Phrase::verbatim(answer.why.as_deref().unwrap_or_default());
                let why = Span::new(Tone::Plain, Phrase::verbatim(": ").then(why));
                vec![Block::paragraph(2, 4, vec![word(Tone::Bad, "Unknown"), why])]
            }
        }
    }
}
