//! Text and what it means.

use chapters::text::{Phrase, Piece};

/// What a piece of text means; the only thing that decides its colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tone {
    /// Text.
    Plain,
    /// What stands over a part.
    Heading,
    /// Said with emphasis.
    Emphasis,
    /// Said with force.
    Strong,
    /// What one types.
    Code,
    /// A word of the command line.
    Name,
    /// Where something stands in the lecture.
    Address,
    /// Mathematics.
    Equation,
    /// Units, asides.
    Dim,
    /// What holds.
    Good,
    /// What does not.
    Bad,
}

/// A stretch of text in one tone; what is marked inside a phrase has its own.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Span {
    /// What it means.
    pub tone: Tone,
    /// What it says.
    pub text: Phrase,
    /// The same as an element of MathML, if it is an equation.
    pub mathml: Option<String>,
}

impl Span {
    /// A phrase in a tone.
    pub fn new(tone: Tone, text: Phrase) -> Self {
        Self { tone, text, mathml: None }
    }

    /// Text in a tone, letter by letter.
    pub fn verbatim(tone: Tone, text: impl Into<String>) -> Self {
        Self::new(tone, Phrase::verbatim(text))
    }

    /// Plain text, letter by letter.
    pub fn plain(text: impl Into<String>) -> Self {
        Self::verbatim(Tone::Plain, text)
    }

    /// An equation.
    pub fn equation(unicode: &str, mathml: &str) -> Self {
        Self { mathml: Some(mathml.to_owned()), ..Self::verbatim(Tone::Equation, unicode) }
    }

    /// The span in Unicode, in pieces of one tone.
    pub fn faces(&self) -> Vec<(Tone, String)> {
        let mut faces = Vec::new();
        collect(self.tone, &self.text, &mut faces);
        if faces.is_empty() {
            faces.push((self.tone, String::new()));
        }
        faces
    }
}

fn collect(tone: Tone, phrase: &Phrase, faces: &mut Vec<(Tone, String)>) {
    for piece in &phrase.0 {
        match piece {
            Piece::Emphasis(of) => collect(Tone::Emphasis, of, faces),
            Piece::Strong(of) => collect(Tone::Strong, of, faces),
            Piece::Code(of) => faces.push((Tone::Code, of.to_string())),
            _ => match faces.last_mut() {
                Some((last, text)) if *last == tone => text.push_str(&piece.to_string()),
                _ => faces.push((tone, piece.to_string())),
            },
        }
    }
}
