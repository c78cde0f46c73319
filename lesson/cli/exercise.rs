//! Exercises: which there are, laid out, judged, helped with.

use super::Request;
use super::help::HelpArg;
use super::values::duration;
use crate::exercise::Ask;
use clap::{Subcommand, ValueHint};
use std::path::PathBuf;
use std::time::Duration;

/// Where exercises are laid out if nothing else is said.
pub const EXERCISES: &str = "lesson-exercises";

pub const EXERCISE_EXAMPLES: &str = "\
Examples:
  lesson exercise list
  lesson exercise start snell        task and file in lesson-exercises/snell
  lesson exercise check snell        the chapter's own checks, on your formula
  lesson exercise hint snell         the next hint; once solved, the solution

Your file is compiled with `rustc` (or what RUSTC names) and run with up to
1 GiB of memory, --time an answer and 60 s in all. Nothing is fetched.

Exit status: 0 if it is solved, 1 if not (wrong, or it panics, loops, ends),
2 if it could not run: no such exercise or file, it does not compile, no rustc.";

#[derive(Debug, Subcommand)]
pub enum ExerciseCommand {
    /// Which exercises there are, and which you have solved.
    List {
        /// As one JSON document.
        #[arg(long)]
        json: bool,
        #[command(flatten)]
        help: HelpArg,
    },
    /// Put an exercise's task and file into a new folder.
    Start {
        /// The exercise.
        name: String,
        /// The folder in which a folder for it is made.
        #[arg(long, value_name = "DIR", default_value = EXERCISES, value_hint = ValueHint::DirPath)]
        into: PathBuf,
        #[command(flatten)]
        help: HelpArg,
    },
    /// Judge your formula by the chapter's own checks.
    Check {
        /// The exercise.
        name: String,
        /// Your file, or its folder; by default where `start` has put it.
        #[arg(value_hint = ValueHint::AnyPath)]
        file: Option<PathBuf>,
        /// How long one answer may take.
        #[arg(long, value_parser = duration, default_value = "5s")]
        time: Duration,
        /// As one JSON document.
        #[arg(long)]
        json: bool,
        #[command(flatten)]
        help: HelpArg,
    },
    /// The next hint; once it is solved, the solution.
    Hint {
        /// The exercise.
        name: String,
        #[command(flatten)]
        help: HelpArg,
    },
}

impl ExerciseCommand {
    pub fn into_request(self) -> Request {
        Request::Exercise(match self {
            Self::List { json, .. } => Ask::List { json },
            Self::Start { name, into, .. } => Ask::Start { name, into },
            Self::Check { name, file, time, json, .. } => Ask::Check { name, file, limit: time, json },
            Self::Hint { name, .. } => Ask::Hint { name },
        })
    }
}
