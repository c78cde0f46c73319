//! What `lesson eval` offers.

use super::{Teller, section_at};
use crate::block::{Block, Heading, Rank, Span, Term, Terms, Tone};
use chapters::function::{Function, Input};
use chapters::setting::{self, range};
use chapters::text::Phrase;

impl Teller<'_> {
    /// Functions with their inputs and outputs.
    pub fn functions<'f>(&self, functions: impl Iterator<Item = &'f Function>) -> Vec<Block> {
        functions.map(|function| self.function(function)).collect()
    }

    fn function(&self, function: &Function) -> Block {
        let address = format!("eval/{}", function.name);
        let field = |name: &str, unit: &str, says: &str, limits: String| {
            let unit = if unit.is_empty() { String::new() } else { format!("[{unit}]") };
            let says = self.phrase(&format!("{address}/{name}"), "says", says);
            let unit = Phrase::verbatim(unit).then(Phrase::parse(&limits));
            Term {
                name: Span::verbatim(Tone::Code, name),
                says: vec![Span::new(Tone::Plain, says), Span::plain(" "), Span::new(Tone::Dim, unit)],
                note: None,
            }
        };
        let inputs = function.inputs.iter().map(|input| field(input.name, input.unit, input.says, limits(input)));
        let outputs = function.outputs.iter().map(|output| field(output.name, output.unit, output.says, String::new()));
        let says = self.phrase(&address, "says", function.says);
        let heading = Heading {
            rank: Rank::Entry,
            text: vec![Span::verbatim(Tone::Heading, function.name), Span::plain("  "), Span::new(Tone::Plain, says)],
            address: None,
            rows: Vec::new(),
        };
        let terms = |items| Block::Terms(Terms { width: Some(14), items });
        let blocks = vec![
            Block::Heading(heading),
            Block::text(2, Tone::Strong, self.say("takes", &[])),
            terms(inputs.collect()),
            Block::text(2, Tone::Strong, self.say("gives", &[])),
            terms(outputs.collect()),
        ];
        section_at(&address, vec![Block::Group(blocks)])
    }
}

fn limits(input: &Input) -> String {
    let domain = input.domain.map_or(String::new(), |(min, max)| format!(", {}", range(min, max, input.unit, "")));
    let default = input.default.map_or(String::new(), |value| format!(", {} if left out", setting::number(value)));
    domain + &default
}
