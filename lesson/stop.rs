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
    /// Somebody ended it before there was anything, which has been said: their exit code.
    Interrupted(u8),
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
            Self::ClosedPipe | Self::Interrupted(_) => self,
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
            Self::Refused(message) => return f.write_str(&harmless(message)),
            Self::ClosedPipe => "nobody reads any more",
            Self::Interrupted(_) => "somebody ended it",
        })
    }
}

impl From<Fault> for Stop {
    fn from(fault: Fault) -> Self {
        Self::unknown(fault, std::iter::empty())
    }
}

impl Stop {
    /// A fault, with the name that may have been meant: one of those known at its place, or, if that is more like it,
    /// the last part of an address `elsewhere`.
    pub fn unknown(fault: Fault, elsewhere: impl IntoIterator<Item = String>) -> Self {
        let meant = fault.unknown.as_ref().and_then(|unknown| {
            let here = nearest(&unknown.word, unknown.names.iter().map(String::as_str));
            let elsewhere: Vec<String> = elsewhere.into_iter().collect();
            let there = nearest(&unknown.word, elsewhere.iter().map(String::as_str));
            let best = match (here, there) {
                (Some(here), Some(there)) if there.0 > here.0 => Some(there),
                (here, there) => here.or(there),
            };
            best.map(|(_, name)| name.to_owned())
        });
        Self::meaning(&fault, meant.as_deref())
    }

    /// A fault, with what was `meant` if that is known.
    pub fn meaning(fault: &Fault, meant: Option<&str>) -> Self {
        let meant = meant.map_or(String::new(), |meant| format!(" (did you mean `{meant}`?)"));
        let Fault { place, message, .. } = fault;
        Self::Refused(format!("{place}: {message}{meant}{}", fault.choice()))
    }
}

/// A message with a sign instead of every control character but the end of a line: what it quotes can be anybody's, and such
/// would be the terminal's to obey.
pub fn harmless(message: &str) -> String {
    message.chars().map(|c| if c.is_control() && c != '\n' { char::REPLACEMENT_CHARACTER } else { c }).collect()
}

/// How alike two names must be for one to be meant by the other.
const ALIKE: f64 = 0.75;

/// The first of `names` most like `word`, if any is like it, and how much it is. Of an address the end counts, from any
/// of its parts on.
fn nearest<'n>(word: &str, names: impl Iterator<Item = &'n str>) -> Option<(f64, &'n str)> {
    let word = plain(word).replace('/', "-");
    let likeness = |name: &str| {
        let starts = std::iter::once(0).chain(name.match_indices('/').map(|(at, _)| at + 1));
        let ends = starts.map(|start| strsim::jaro_winkler(&word, &plain(&name[start..]).replace('/', "-")));
        ends.fold(0.0, f64::max)
    };
    let alike = names.map(|name| (likeness(name), name)).filter(|(likeness, _)| *likeness > ALIKE);
    alike.reduce(|best, next| if next.0 > best.0 { next } else { best })
}

/// A name as it is compared: case does not matter, `_` and `-` are one.
pub fn plain(name: &str) -> String {
    name.to_lowercase().replace('_', "-")
}
