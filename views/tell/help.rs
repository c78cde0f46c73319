//! What a part of the curriculum has and takes, for somebody who asks before running it.

use super::{Teller, section_at};
use crate::block::{Block, Span, Term, Terms, Tone};
use chapters::parameter::Parameter;
use chapters::text::Phrase;
use chapters::vocabulary::Item;
use chapters::{Chapter, Step};

/// Columns of the names in a list.
const NAMES: usize = 14;

impl Teller<'_> {
    /// A step: what it has by kind, its parameters, and what the signs mean.
    pub fn step_help(&self, chapter: &Chapter, step: &Step) -> Vec<Block> {
        let address = format!("{}/{}", chapter.id, step.id);
        let title = self.phrase(&address, "title", step.title);
        let usage = format!("lesson {} {}", chapter.id, step.id);
        let says = self.phrase(&address, "says", step.says);
        let mut blocks = vec![self.usage(&usage, title, says)];
        blocks.push(self.list("It has:", Some(NAMES), self.inventory(step)));
        blocks.extend(self.parameters(&address, &[step]));
        blocks.extend(self.legend());
        vec![section_at(&address, blocks)]
    }

    /// Chapters: their steps and the parameters of all, and what the signs mean.
    pub fn chapters_help(&self, chapters: &[&Chapter]) -> Vec<Block> {
        let mut blocks = Vec::new();
        for chapter in chapters {
            let title = self.phrase(chapter.id, "title", chapter.title);
            let says = self.phrase(chapter.id, "says", chapter.says);
            blocks.push(self.usage(&format!("lesson {} [STEP]", chapter.id), title, says));
            blocks.extend(self.contents(chapter));
        }
        let steps: Vec<&Step> = chapters.iter().flat_map(|chapter| chapter.steps).collect();
        blocks.extend(self.parameters("", &steps));
        blocks.extend(self.legend());
        blocks
    }

    fn usage(&self, command: &str, title: Phrase, says: Phrase) -> Block {
        let usage = vec![Span::verbatim(Tone::Code, command), Span::plain("  "), Span::new(Tone::Strong, title)];
        Block::section(vec![Block::Group(vec![Block::paragraph(0, 4, usage), Block::text(2, Tone::Plain, says)])])
    }

    fn list(&self, title: &str, width: Option<usize>, items: Vec<Term>) -> Block {
        let title = Block::text(0, Tone::Strong, self.say(title, &[]));
        Block::section(vec![Block::Group(vec![title, Block::Terms(Terms { width, items })])])
    }

    /// The ids of a step's items, kind by kind.
    fn inventory(&self, step: &Step) -> Vec<Term> {
        let mut kinds: Vec<((&str, &str), Vec<&str>)> = Vec::new();
        for item in step.items() {
            match kinds.iter_mut().find(|(kind, _)| *kind == short_kind(&item)) {
                Some((_, ids)) => ids.push(item.id()),
                None => kinds.push((short_kind(&item), vec![item.id()])),
            }
        }
        let term = |((one, many), ids): ((&str, &str), Vec<&str>)| {
            let count = Phrase::verbatim(ids.len().to_string());
            let name = self.say(if ids.len() == 1 { one } else { many }, &[("count", count)]);
            Term {
                name: Span::new(Tone::Plain, name),
                says: vec![Span::verbatim(Tone::Code, ids.join(", "))],
                note: None,
            }
        };
        kinds.into_iter().map(term).collect()
    }

    /// What can be set in `steps`, each name once, and the media that have names.
    fn parameters(&self, address: &str, steps: &[&Step]) -> Vec<Block> {
        let parameters = distinct(steps);
        if parameters.is_empty() {
            return Vec::new();
        }
        let terms = parameters.iter().flat_map(|parameter| self.input(address, "", parameter)).collect();
        let mut blocks = vec![self.list("To set, with --set NAME=VALUE:", Some(NAMES), terms)];
        let named: Vec<Term> = named(&parameters)
            .into_iter()
            .map(|(parameters, media)| Term {
                name: Span::verbatim(Tone::Code, parameters.join(", ")),
                says: vec![Span::verbatim(Tone::Plain, media.join(", "))],
                note: None,
            })
            .collect();
        if !named.is_empty() {
            blocks.push(self.list("Media by name:", None, named));
        }
        blocks
    }

    /// The names of a step's parameters and of the media they take, for the end of its page.
    pub(super) fn settable(&self, step: &Step, address: &str, media_too: bool) -> Vec<Block> {
        let parameters = distinct(&[step]);
        if parameters.is_empty() {
            return Vec::new();
        }
        let code = |text: String| Span::verbatim(Tone::Code, text);
        let plain = |text: &str| Span::new(Tone::Plain, self.say(text, &[]));
        let names: Vec<_> = parameters.iter().map(|parameter| parameter.name).collect();
        let command = code(format!("lesson {} --help", address.replace('/', " ")));
        let set = vec![plain("To set:"), Span::plain(" "), code(names.join(", ")), Span::plain("; "), command];
        let set = [set, vec![Span::plain(" "), plain("tells what each may be")]].concat();
        let media = named(&parameters).into_iter().filter(|_| media_too).map(|(parameters, media)| {
            let names = [code(parameters.join(", ")), Span::plain(" "), plain("by name:"), Span::plain(" ")];
            Block::paragraph(4, 6, [&names[..], &[code(media.join(", "))]].concat())
        });
        vec![Block::Group(std::iter::once(Block::paragraph(2, 4, set)).chain(media).collect())]
    }
}

/// What a count of an item's kind is called in a column: one, several.
fn short_kind(item: &Item) -> (&'static str, &'static str) {
    match item {
        Item::Statement(_) => ("1 equation", "{count} equations"),
        Item::Question(_) => ("1 question", "{count} questions"),
        Item::Derivation(_) => ("1 derivation", "{count} derivations"),
        Item::Check(_) => ("1 check", "{count} checks"),
        Item::Stress(_) => ("1 stress test", "{count} stress tests"),
        Item::Race(_) => ("1 race", "{count} races"),
        Item::Figure(_) => ("1 figure", "{count} figures"),
    }
}

/// The parameters of `steps`, the first of each name.
fn distinct(steps: &[&Step]) -> Vec<&'static Parameter> {
    let mut parameters: Vec<&'static Parameter> = Vec::new();
    for parameter in steps.iter().flat_map(|step| step.parameters()) {
        if parameters.iter().all(|known| known.name != parameter.name) {
            parameters.push(parameter);
        }
    }
    parameters
}

/// The media that have names, with the parameters that take them.
fn named(parameters: &[&Parameter]) -> Vec<(Vec<&'static str>, Vec<&'static str>)> {
    let mut named: Vec<(Vec<&str>, Vec<&str>)> = Vec::new();
    for parameter in parameters {
        let media = parameter.kind.names();
        match named.iter_mut().find(|(_, known)| *known == media) {
            Some((takers, _)) => takers.push(parameter.name),
            None if media.is_empty() => {}
            None => named.push((vec![parameter.name], media)),
        }
    }
    named
}
