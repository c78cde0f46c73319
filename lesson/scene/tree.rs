//! What TOML and JSON have in common: values, and where they stand.

use light::scene::{Part, Place};
use std::ops::Range;

/// A value and where it stands in its text [byte].
#[derive(Clone, Debug, PartialEq)]
pub struct Node {
    pub span: Range<usize>,
    pub value: Value,
}

/// What a scene file can say.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    Null,
    Flag(bool),
    /// Of any size; what is too large for a double is infinite.
    Number(f64),
    Text(String),
    List(Vec<Node>),
    /// In the order of the file; keys differ.
    Table(Vec<Entry>),
    /// A date or a time, which scenes have no use for.
    Date,
}

/// A key, where it stands, and its value.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    pub key: String,
    pub span: Range<usize>,
    pub node: Node,
}

/// Why a text is no tree, and where that shows.
#[derive(Clone, Debug, PartialEq)]
pub struct Malformed {
    pub why: String,
    pub span: Range<usize>,
}

impl Node {
    /// What is found, in a word or two.
    pub fn kind(&self) -> String {
        match &self.value {
            Value::Null => "null".into(),
            Value::Flag(flag) => format!("{flag}"),
            Value::Number(number) => format!("the number {number}"),
            Value::Text(text) => format!("the text `{}`", chapters::parameter::excerpt(text)),
            Value::List(list) => format!("a list of {}", list.len()),
            Value::Table(_) => "a table".into(),
            Value::Date => "a date".into(),
        }
    }

    /// Where `place` stands in the text, or the innermost thing around it that the text has.
    pub fn find(&self, place: &Place) -> Range<usize> {
        let mut node = self;
        for part in place.parts() {
            let inner = match (&node.value, part) {
                (Value::Table(entries), Part::Key(key)) => entry(entries, key).map(|entry| &entry.node),
                (Value::List(list), Part::At(at)) => list.get(*at),
                _ => None,
            };
            let Some(inner) = inner else { break };
            node = inner;
        }
        node.span.clone()
    }
}

/// What a scene calls by one name, and its file may by another.
const ALIASES: [(&str, &str); 2] = [("mesh", "file"), ("alpha", "alpha_x")];

fn entry<'e>(entries: &'e [Entry], key: &str) -> Option<&'e Entry> {
    let named = |key: &str| entries.iter().find(|entry| entry.key == key);
    named(key).or_else(|| ALIASES.iter().find(|(of, _)| *of == key).and_then(|(_, alias)| named(alias)))
}
