//! Labels and phrases: the markup of every string that a chapter shows, read once and for all.
//!
//! A chapter's strings are Unicode with a little markup:
//!
//! | written | is | because |
//! |---|---|---|
//! | `R_s`, `θ_B`, `n_1` | a symbol with an index | one letter, number or closing bracket, `_`, one letter or digit |
//! | `S_{max}`, `10^{−6}` | the same with a longer index or power | in braces, which may hold markup themselves |
//! | `x^2`, `N^−½`, `e^(iδ)` | a power | after any word; brackets hold one as braces do |
//! | `MgF_2`, `Al_2O_3` | a chemical formula | a digit after an element |
//! | `2.5e-7`, `1e12` | 2.5·10⁻⁷, 10¹² | a number of at most nine characters; longer ones are there to be copied |
//! | `-1.5`, `x = -2` | −1.5, x = −2 | a hyphen before a digit, unless it joins words: `s-polarised`, `n-1` |
//!
//! Everything else stands as written: names (`r_plus_t`, `theta_1`), assignments (`n_t=gold`), marks without their
//! partner. An index ends where letters of its alphabet do: `ω_cτ` is ω_c times τ, `d_nm` is a name.
//!
//! What is there to be typed (commands, addresses) is no phrase: [`Phrase::verbatim`] takes it as it is.

mod catalogue;
mod face;
mod parse;

pub use catalogue::{Catalogue, English};
pub use face::{Run, Shift, small};

/// A text that has been read: what a label, a claim or a paragraph says, and what is marked in it.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Phrase(pub Vec<Piece>);

/// A part of a phrase.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Piece {
    /// Letters as they stand.
    Plain(String),
    /// A letter, a number or a bracket with what hangs below and above it.
    Symbol {
        /// What carries them.
        base: String,
        /// In the order in which they were written; never empty.
        scripts: Vec<Script>,
    },
    /// A number with a power of ten: 2.5·10⁻⁷.
    Number {
        /// The digits before the power; empty if they are just 1.
        factor: String,
        /// The power, with a minus sign if it has one.
        power: String,
    },
    /// Said with emphasis.
    Emphasis(Phrase),
    /// Said with force.
    Strong(Phrase),
    /// A symbol or a command inside the course text.
    Code(Phrase),
}

/// An index or a power.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Script {
    /// Below or above.
    pub shift: Shift,
    /// What it holds.
    pub of: Phrase,
    /// How it was held together.
    pub held: Held,
}

/// What holds an index or a power together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Held {
    /// Nothing: it is a single letter.
    Alone,
    /// Braces.
    Braces,
    /// Brackets, which a line that cannot raise shows.
    Brackets,
}

impl Phrase {
    /// The phrase that `text` is in the markup of chapters.
    pub fn parse(text: &str) -> Self {
        parse::phrase(text)
    }

    /// `text` letter by letter, because it is there to be typed or was typeset already.
    pub fn verbatim(text: impl Into<String>) -> Self {
        let text = text.into();
        Self(if text.is_empty() { Vec::new() } else { vec![Piece::Plain(text)] })
    }

    /// `template` with each `{name}` replaced by the phrase of that name; a name without one stands as written.
    pub fn fill(template: &str, parts: &[(&str, Phrase)]) -> Self {
        let (mut whole, mut rest) = (Self::default(), template);
        while let Some((before, from)) = rest.split_once('{') {
            let found = from.split_once('}').and_then(|(name, after)| {
                Some((parts.iter().find(|(known, _)| *known == name).map(|(_, part)| part.clone())?, after))
            });
            let (part, after) = found.unwrap_or((Self::verbatim("{"), from));
            whole = whole.then(Self::verbatim(before)).then(part);
            rest = after;
        }
        whole.then(Self::verbatim(rest))
    }

    /// This phrase, and `next` right behind it.
    pub fn then(mut self, next: Self) -> Self {
        self.0.extend(next.0);
        self
    }

    /// Whether it says nothing.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn templates_take_their_parts_and_keep_strange_braces() {
        let parts = [("value", Phrase::parse("2e-7")), ("unit", Phrase::verbatim("R_s"))];
        assert_eq!(
            Phrase::fill("measured {value} {unit}; {other} {", &parts).to_string(),
            "measured 2·10⁻⁷ R_s; {other} {"
        );
        assert!(Phrase::fill("", &parts).is_empty());
    }
}
