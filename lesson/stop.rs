//! Why a run ends before its work is done.

use chapters::parameter::Fault;
use std::fmt::{self, Display};
use std::io;

/// Why a run ends early.
#[derive(Debug)]
pub enum Stop {
    /// It cannot run: one message for the reader, exit code 2.
    Refused(String),
    /// Whoever read our output has had enough: exit code 0, in silence.
    ClosedPipe,
}

impl Stop {
    /// A refusal at `place`.
    pub fn at(place: impl Display, message: impl Display) -> Self {
        Self::Refused(format!("{place}: {message}"))
    }

    /// The same, said of a part of `place`.
    pub fn within(self, place: impl Display) -> Self {
        match self {
            Self::Refused(message) => Self::at(place, message),
            Self::ClosedPipe => self,
        }
    }

    /// What a failed write to standard output means.
    pub fn writing(error: io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::BrokenPipe => Self::ClosedPipe,
            _ => Self::at("standard output", error),
        }
    }
}

impl fmt::Display for Stop {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Refused(message) => message,
            Self::ClosedPipe => "nobody reads any more",
        })
    }
}

impl From<Fault> for Stop {
    fn from(fault: Fault) -> Self {
        let hint = fault.unknown.as_ref().map(|unknown| did_you_mean(&unknown.word, &unknown.names));
        let Fault { place, message, .. } = &fault;
        Self::Refused(format!("{place}: {message}{}{}", hint.unwrap_or_default(), fault.choice()))
    }
}

/// ` (did you mean …?)` if one of `names` resembles `word`, otherwise nothing.
fn did_you_mean(word: &str, names: &[String]) -> String {
    let word = plain(word);
    let likeness = |name: &str| strsim::jaro_winkler(&word, &plain(name));
    let nearest = names.iter().map(|name| (likeness(name), name)).max_by(|a, b| a.0.total_cmp(&b.0));
    match nearest {
        Some((likeness, name)) if likeness > 0.75 => format!(" (did you mean `{name}`?)"),
        _ => String::new(),
    }
}

/// A name as it is compared: case does not matter, `_` and `-` are one.
pub fn plain(name: &str) -> String {
    name.to_lowercase().replace('_', "-")
}
