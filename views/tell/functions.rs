//! What `lesson eval` offers.

use super::{Teller, section_at};
use crate::block::{Block, Heading, Rank, Span, Term, Terms, Tone};
use chapters::parameter::{Form, Function, Kind, Parameter};
use chapters::text::Phrase;

impl Teller<'_> {
    /// Functions with their inputs and outputs.
    pub fn functions<'f>(&self, functions: impl Iterator<Item = &'f Function>) -> Vec<Block> {
        functions.map(|function| self.function(function)).collect()
    }

    fn function(&self, function: &Function) -> Block {
        let address = format!("eval/{}", function.name);
        let inputs = function.inputs.iter().flat_map(|input| self.input(&address, "", input)).collect();
        let outputs =
            function.outputs.iter().map(|output| self.field(&address, output.name, "", output.unit, output.says, ""));
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
            terms(inputs),
            Block::text(2, Tone::Strong, self.say("gives", &[])),
            terms(outputs.collect()),
        ];
        section_at(&address, vec![Block::Group(blocks)])
    }

    /// An input, and the fields of the records that it is made of, each by its path.
    pub(super) fn input(&self, address: &str, within: &str, input: &Parameter) -> Vec<Term> {
        let (note, fields) = match input.kind {
            Kind::Record(fields) => (", fields:".to_owned(), fields),
            Kind::List { of: Kind::Record(fields), most } => {
                (format!(", a list of up to {most} with the fields:"), *fields)
            }
            _ => (format!(", {}", input.domain()), &[][..]),
        };
        let default = input.default.map_or(String::new(), |default| format!(", {default} if left out"));
        let also = input.aliases.iter().map(|alias| match alias.form {
            Form::Same => alias.name.to_owned(),
            Form::In(unit) | Form::Over(_, unit) => format!("{} [{unit}]", alias.name),
        });
        let also: Vec<_> = also.collect();
        let also = if also.is_empty() { String::new() } else { format!("; or {}", also.join(", ")) };
        let path = format!("{within}{}", input.name);
        let with =
            input.only_with.map_or(String::new(), |(choice, words)| format!(", with {choice}={}", words.join(" or ")));
        let note = format!("{note}{default}{also}{with}");
        let own = self.field(address, &path, input.symbol, input.kind.unit(), input.says, &note);
        let inner = fields.iter().flat_map(|field| self.input(address, &format!("{path}."), field));
        std::iter::once(own).chain(inner).collect()
    }

    fn field(&self, address: &str, name: &str, symbol: &str, unit: &str, says: &str, note: &str) -> Term {
        let unit = if unit.is_empty() { String::new() } else { format!(" [{unit}]") };
        let says = self.phrase(&format!("{address}/{name}"), "says", says);
        let symbol = match symbol {
            "" => Vec::new(),
            symbol => vec![Span::new(Tone::Equation, Phrase::parse(symbol)), Span::plain(", ")],
        };
        // Names and numbers as one types them.
        let note = Phrase::verbatim(unit).then(Phrase::verbatim(note));
        Term {
            name: Span::verbatim(Tone::Code, name),
            says: [symbol, vec![Span::new(Tone::Plain, says), Span::new(Tone::Dim, note)]].concat(),
            note: None,
        }
    }
}
