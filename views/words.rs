//! The views' own words, looked up like those of the chapters.

use chapters::text::{Catalogue, English, Phrase};

/// The address under which a catalogue has the views' own words.
pub const ADDRESS: &str = "views";

/// Where the words come from.
#[derive(Clone, Copy)]
pub struct Words<'a>(pub &'a dyn Catalogue);

impl Words<'static> {
    /// English ones.
    pub const ENGLISH: Self = Self(&English);
}

impl Words<'_> {
    /// A template, `measured {value}`, with its parts.
    pub fn say(self, english: &str, parts: &[(&str, Phrase)]) -> Phrase {
        Phrase::fill(&self.0.text(ADDRESS, "", english), parts)
    }

    /// A template of which all parts are numbers or names.
    pub fn tell(self, english: &str, parts: &[(&str, &str)]) -> String {
        let parts: Vec<_> = parts.iter().map(|(name, part)| (*name, Phrase::verbatim(*part))).collect();
        self.say(english, &parts).to_string()
    }
}
