//! `lesson exercise`: formulas that the reader writes, judged by the chapters' own checks.
//!
//! | what | where |
//! |---|---|
//! | the words in which an exercise is written | [`vocabulary`] |
//! | the exercises, a file a chapter | [`shelf`] |
//! | the learner's file as a program, and its run | [`compile`], [`process`] |
//! | the learner's function as a formula that a check can try | [`formula`] |
//! | what became of it, and how that is told | [`verdict`], [`told`] |

mod compile;
mod formula;
mod process;
pub mod shelf;
#[cfg(test)]
mod tests;
mod told;
mod verdict;
pub mod vocabulary;

use crate::interrupt::Interrupt;
use crate::out::{self, Folder};
use crate::reader::bookmark::{Book, Memory, Work};
use crate::stop::{Stop, plain};
use chapters::parameter::{Fault as Named, excerpt};
use compile::Source;
use process::{Fault, Process};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;
use std::time::Duration;
use vocabulary::Exercise;

/// What is asked.
#[derive(Debug)]
pub enum Ask {
    /// Which exercises there are.
    List { json: bool },
    /// An exercise's files, put into a folder.
    Start { name: String, into: PathBuf },
    /// A learner's file, judged.
    Check { name: String, file: Option<PathBuf>, limit: Duration, json: bool },
    /// The next hint.
    Hint { name: String },
}

/// Answers on standard output.
pub fn serve(ask: &Ask) -> Result<ExitCode, Stop> {
    match ask {
        Ask::List { json } => {
            let (_, memory) = remembered();
            let text = if *json { told::list_json(&memory) } else { told::list(&memory) };
            out::print(text.as_bytes())?;
        }
        Ask::Start { name, into } => start(find(name)?, into)?,
        Ask::Check { name, file, limit, json } => return check(find(name)?, file.as_deref(), *limit, *json),
        Ask::Hint { name } => hint(find(name)?)?,
    }
    Ok(ExitCode::SUCCESS)
}

/// How many exercises of a chapter there are and how many of them are solved.
pub fn solved(memory: &Memory, chapter: &str) -> [usize; 2] {
    let of = shelf::all().filter(|exercise| exercise.chapter() == chapter);
    let is_solved = |exercise: &&Exercise| memory.exercises.get(exercise.name).is_some_and(|work| work.solved);
    [of.clone().filter(is_solved).count(), of.count()]
}

fn find(name: &str) -> Result<&'static Exercise, Stop> {
    let wanted = plain(name);
    shelf::all().find(|exercise| exercise.name == wanted).ok_or_else(|| {
        let names = shelf::all().map(|exercise| exercise.name);
        Named::unknown(excerpt(name), name, "no such exercise", names).into()
    })
}

/// What the reader has done so far; what is wrong with it is said.
fn remembered() -> (Book, Memory) {
    let (book, memory, note) = Book::open();
    if let Some(note) = note {
        out::say(&format!("note: {note}"));
    }
    (book, memory)
}

/// Changes what is remembered of an exercise. What cannot be written down is said, and no reason to end.
fn remember((book, mut memory): (Book, Memory), exercise: &Exercise, change: impl FnOnce(&mut Work)) {
    change(memory.exercises.entry(exercise.name.to_owned()).or_default());
    if let Err(stop) = book.keep(&memory) {
        out::say(&format!("note: this is not remembered: {stop}"));
    }
}

/// The learner's file in the folder of an exercise.
fn own_file(exercise: &Exercise) -> String {
    format!("{}.rs", exercise.name.replace('-', "_"))
}

/// Puts an exercise's task and start into a new folder `into/NAME`: all of it or nothing.
fn start(exercise: &Exercise, into: &Path) -> Result<(), Stop> {
    let place = into.join(exercise.name);
    if place.symlink_metadata().is_ok() {
        let why = "is there already, and stays as it is; valid: --into another folder, or go on with what is there";
        return Err(Stop::at(place.display(), why));
    }
    let file = own_file(exercise);
    let folder = Folder::open(into)?;
    let files = [("task.md", exercise.files.task.as_bytes()), (file.as_str(), exercise.files.start.as_bytes())];
    out::publish(&[folder.draft_folder(exercise.name, &files)?])?;
    let lines = [format!("{}\n", place.join("task.md").display()), format!("{}\n", place.join(&file).display())];
    out::print(lines.concat().as_bytes())?;
    out::say(&format!("fill the hole, then: lesson exercise check {} {}", exercise.name, place.join(file).display()));
    Ok(())
}

/// Where a learner's file is looked for if none is named.
fn places(exercise: &Exercise) -> [PathBuf; 3] {
    let (file, name) = (own_file(exercise), exercise.name);
    [Path::new(crate::cli::EXERCISES).join(name).join(&file), Path::new(name).join(&file), PathBuf::from(&file)]
}

fn check(exercise: &'static Exercise, file: Option<&Path>, limit: Duration, json: bool) -> Result<ExitCode, Stop> {
    let path = match file {
        Some(path) if path.is_dir() => path.join(own_file(exercise)),
        Some(path) => path.to_owned(),
        None => places(exercise).into_iter().find(|path| path.is_file()).ok_or_else(|| {
            let [first, second, third] = places(exercise).map(|path| path.display().to_string());
            let why = format!("no file to check: neither {first} nor {second} nor {third} is there");
            Stop::at(exercise.name, format!("{why}; `lesson exercise start {}` makes the first", exercise.name))
        })?,
    };
    let text = compile::read(&path)?;
    let interrupt = Arc::new(Interrupt::watched());
    let source = Source { exercise, text: &text, called: path.display().to_string() };
    let program = Arc::new(compile::program(&[source], &interrupt)?);
    let results = exercise.gives.kind.numbers();
    let process = Process::start(program, exercise.name, results, limit, interrupt);
    let process = process.map_err(|why| Stop::at(path.display(), format!("cannot be run: {why}")))?;
    let heard = process.heard();
    let verdict = verdict::verdict(exercise, Box::new(process), &heard);
    match &verdict.fault {
        Some((Fault::Interrupted(code), _)) => {
            out::say("interrupted: nothing is judged");
            return Err(Stop::Interrupted(*code));
        }
        Some((Fault::Lost(why), _)) => return Err(Stop::at(path.display(), format!("cannot be run: {why}"))),
        _ => {}
    }
    let text = match json {
        true => told::verdict_json(exercise, &verdict),
        false => told::set(&told::verdict(exercise, &verdict), out::page()),
    };
    out::print(text.as_bytes())?;
    if !verdict.is_solved(exercise) {
        return Ok(ExitCode::from(1));
    }
    remember(remembered(), exercise, |work| work.solved = true);
    if !json {
        out::say(&format!("`lesson exercise hint {}` now shows the program's own way", exercise.name));
    }
    Ok(ExitCode::SUCCESS)
}

/// Prints the next hint, the last one again after that, and the solution of what is solved.
fn hint(exercise: &Exercise) -> Result<(), Stop> {
    let (book, memory) = remembered();
    let work = memory.exercises.get(exercise.name).copied().unwrap_or_default();
    if work.solved {
        out::say(&format!("{} is solved; this is one way:", exercise.name));
        return out::print(exercise.files.solution.as_bytes());
    }
    let hints = exercise.files.hints();
    let at = (work.hints + 1).min(hints.len());
    let last = if at == hints.len() { ", the last" } else { "" };
    out::print(format!("hint {at} of {}{last}\n\n{}\n", hints.len(), hints[at - 1]).as_bytes())?;
    remember((book, memory), exercise, |work| work.hints = work.hints.max(at));
    Ok(())
}
