//! What is wrong with an input, and where.

use std::fmt;

/// Why an input cannot be used: where, and what would be valid.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// The parameter, field or address: `layers[1].n`.
    pub place: String,
    /// What is wrong with it and the valid range.
    pub message: String,
    /// Set if a name is not known.
    pub unknown: Option<Unknown>,
}

/// A name that is not known where it stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unknown {
    /// The name as it was given.
    pub word: String,
    /// The names known there.
    pub names: Vec<String>,
}

impl Fault {
    /// A fault at `place`.
    pub fn new(place: impl Into<String>, message: impl Into<String>) -> Self {
        Self { place: place.into(), message: message.into(), unknown: None }
    }

    /// A fault at `place`: `word` is none of the `names` known there.
    pub fn unknown<N: Into<String>>(
        place: impl Into<String>,
        word: impl Into<String>,
        message: impl Into<String>,
        names: impl IntoIterator<Item = N>,
    ) -> Self {
        let names = names.into_iter().map(Into::into).collect();
        Self { unknown: Some(Unknown { word: excerpt(&word.into()), names }), ..Self::new(place, message) }
    }

    /// The same, said of a part of `place`: what reads a part need not know where it stands.
    pub fn within(mut self, place: &str) -> Self {
        let is_dotted = !(place.is_empty() || self.place.is_empty() || self.place.starts_with('['));
        self.place = format!("{place}{}{}", if is_dotted { "." } else { "" }, self.place);
        self
    }

    /// Whether it is said of the parameter `name`, or of a part of it.
    pub fn is_of(&self, name: &str) -> bool {
        self.place.strip_prefix(name).is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
    }

    /// The end of the message: which names there are, if one was not known.
    pub fn choice(&self) -> String {
        match &self.unknown {
            None => String::new(),
            Some(unknown) if unknown.names.is_empty() => ". There are none".into(),
            Some(unknown) => format!(". Known: {}", unknown.names.join(", ")),
        }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}{}", self.place, self.message, self.choice())
    }
}

impl std::error::Error for Fault {}

/// At most 40 characters of `text`, so that no message repeats a megabyte.
pub fn excerpt(text: &str) -> String {
    let mut short: String = text.chars().take(40).collect();
    if short.len() < text.len() {
        short.push('…');
    }
    short
}
