//! What was wrong with a command line, said as everything else that is wrong.

use crate::stop::Stop;
use chapters::parameter::{Fault, excerpt};
use clap::error::{ContextKind, ContextValue, ErrorKind};
use std::error::Error;

/// clap's refusal in the manner of all others: one line, the place first.
pub fn refusal(error: &clap::Error) -> Stop {
    let all = |kind| match error.get(kind) {
        Some(ContextValue::String(text)) => vec![text.clone()],
        Some(ContextValue::Strings(texts)) => texts.clone(),
        _ => Vec::new(),
    };
    let first = |kind| all(kind).into_iter().next().unwrap_or_default();
    let (place, value) = (first(ContextKind::InvalidArg), first(ContextKind::InvalidValue));
    match error.kind() {
        // clap would advise to pass the option as a value, which none of ours can be.
        ErrorKind::UnknownArgument if place.starts_with('-') => {
            let meant = first(ContextKind::SuggestedArg);
            let meant = if meant.is_empty() { meant } else { format!(" (did you mean `{meant}`?)") };
            Stop::at(excerpt(&place), format!("unknown option{meant}; `--help` lists them"))
        }
        ErrorKind::UnknownArgument => Stop::at(excerpt(&place), "one word too many; `--help` tells what is taken"),
        ErrorKind::InvalidSubcommand => {
            let word = first(ContextKind::InvalidSubcommand);
            Stop::at(excerpt(&word), "unknown word; `--help` tells what may stand here")
        }
        ErrorKind::TooManyValues => Stop::at(excerpt(&value), "one word too many; `--help` tells what is taken"),
        ErrorKind::InvalidValue if value.is_empty() => Stop::at(argument(&place), "needs a value"),
        ErrorKind::InvalidValue => {
            let unknown = format!("`{}` is none of its words", excerpt(&value));
            Fault::unknown(argument(&place), value, unknown, all(ContextKind::ValidValue)).into()
        }
        ErrorKind::ValueValidation => {
            let why = error.source().map_or("not valid".to_owned(), ToString::to_string);
            let found = format!("`{}`", excerpt(&value));
            let found = if why.contains(&found) { String::new() } else { format!(", found {found}") };
            Stop::at(argument(&place), format!("{why}{found}"))
        }
        ErrorKind::ArgumentConflict if !place.is_empty() => {
            let other = argument(&first(ContextKind::PriorArg));
            match other == argument(&place) {
                true => Stop::at(other, "given twice; valid: once"),
                false => Stop::at(argument(&place), format!("cannot stand beside {other}")),
            }
        }
        ErrorKind::MissingRequiredArgument => Stop::at(argument(&place), "missing; `--help` tells what it may be"),
        _ => {
            let text = error.to_string();
            let line = text.lines().next().unwrap_or_default();
            Stop::Refused(line.strip_prefix("error: ").unwrap_or(line).to_owned())
        }
    }
}

/// The name of an argument as one types it, of `--format <FORMAT>`, `<SHELL>` or `[NAME=VALUE]...`.
fn argument(face: &str) -> String {
    let name = face.split(' ').next().unwrap_or_default();
    match name.starts_with('-') {
        true => name.to_owned(),
        false => name.trim_matches(['<', '>', '[', ']', '.']).to_lowercase(),
    }
}
