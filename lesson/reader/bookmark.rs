//! What is remembered from one reading to the next: places, steps seen, answers given.

use crate::exercise;
use crate::out::{self, Folder};
use crate::stop::Stop;
use chapters::vocabulary::Given;
use chapters::{CURRICULUM, Chapter};
use etcetera::{BaseStrategy, choose_base_strategy};
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// The file's name in the folder of this program.
const FILE: &str = "reader.json";
/// What says that a file is one of these, and how it is laid out.
const SCHEMA: &str = "lesson/reader/1";

/// What is remembered.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Memory {
    schema: String,
    /// Where the reader was, by chapter.
    pub places: BTreeMap<String, Place>,
    /// The chapter that was read last.
    pub last: String,
    /// The addresses of steps that were seen.
    pub visited: BTreeSet<String>,
    /// What was answered, by the addresses of questions.
    pub answers: BTreeMap<String, Answer>,
    /// What was done of exercises, by their names.
    pub exercises: BTreeMap<String, Work>,
    /// The chapters that this reader has opened: of the others somebody else may know better.
    #[serde(skip)]
    pub touched: BTreeSet<String>,
}

/// What was done of an exercise.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Work {
    /// How many hints were seen.
    pub hints: usize,
    /// Whether it was solved.
    pub solved: bool,
}

/// A place in a chapter.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Place {
    /// The step's name.
    pub step: String,
    /// The first row on the screen.
    pub row: usize,
}

/// An answer as it is written down.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Answer {
    /// Of several, counted from 1.
    Option(usize),
    /// A number, in SI.
    Number(f64),
}

impl From<Given> for Answer {
    fn from(given: Given) -> Self {
        match given {
            Given::Option(at) => Self::Option(at + 1),
            Given::Number(number) => Self::Number(number),
        }
    }
}

impl Answer {
    /// The answer as it was given, if it can be one of so many options.
    pub fn given(self, options: usize) -> Option<Given> {
        match self {
            Self::Option(at) => at.checked_sub(1).filter(|at| *at < options).map(Given::Option),
            Self::Number(number) => (options == 0 && number.is_finite()).then_some(Given::Number(number)),
        }
    }
}

/// Where it is remembered.
#[derive(Debug)]
pub struct Book {
    /// None where nothing can be or may be written.
    path: Option<PathBuf>,
}

impl Book {
    /// What was remembered by the platform's rules, and what was wrong with it. A file of somebody else's is left alone.
    pub fn open() -> (Self, Memory, Option<String>) {
        match choose_base_strategy() {
            // Where there is no folder for states the data are the next best.
            Ok(rules) => Self::at(rules.state_dir().unwrap_or_else(|| rules.data_dir()).join("lesson").join(FILE)),
            Err(_) => (Self { path: None }, Memory::default(), None),
        }
    }

    fn at(path: PathBuf) -> (Self, Memory, Option<String>) {
        let ignored = |why: String| Some(format!("what was remembered {why} and is ignored: {}", path.display()));
        let (memory, note, is_ours) = match fs::read_to_string(&path) {
            Ok(text) => match read(&text) {
                Ok(memory) => (memory, None, true),
                Err(Flaw::Damaged) => (Memory::default(), ignored("is damaged".into()), true),
                Err(Flaw::Foreign) => (Memory::default(), ignored("is of another version".into()), false),
            },
            Err(error) if error.kind() == ErrorKind::NotFound => (Memory::default(), None, true),
            Err(error) if error.kind() == ErrorKind::InvalidData => {
                (Memory::default(), ignored("is damaged".into()), true)
            }
            Err(error) => (Memory::default(), ignored(format!("cannot be read ({error})")), false),
        };
        (Self { path: is_ours.then_some(path) }, memory, note)
    }

    /// Writes it down, together with what another reader has written meanwhile: either all of it is there or what was.
    pub fn keep(&self, memory: &Memory) -> Result<(), Stop> {
        let Some(path) = &self.path else { return Ok(()) };
        let before = fs::read_to_string(path).ok().and_then(|text| read(&text).ok()).unwrap_or_default();
        let mut whole = memory.clone();
        whole.schema = SCHEMA.into();
        whole.visited.extend(before.visited);
        for (address, answer) in before.answers {
            whole.answers.entry(address).or_insert(answer);
        }
        for (name, work) in before.exercises {
            let whole = whole.exercises.entry(name).or_default();
            *whole = Work { hints: whole.hints.max(work.hints), solved: whole.solved || work.solved };
        }
        for (chapter, place) in before.places {
            // Where this reader has not been, another may have gone on.
            if !memory.touched.contains(&chapter) {
                whole.places.insert(chapter, place);
            }
        }
        let text = serde_json::to_string_pretty(&whole).map_err(|error| Stop::at(path.display(), error))? + "\n";
        let folder = Folder::open(path.parent().unwrap_or(Path::new(".")))?;
        out::publish(&[folder.draft(FILE, text.as_bytes())?])
    }
}

/// Why a file cannot be used.
enum Flaw {
    Damaged,
    Foreign,
}

fn read(text: &str) -> Result<Memory, Flaw> {
    let value: serde_json::Value = serde_json::from_str(text).map_err(|_| Flaw::Damaged)?;
    if value["schema"] != SCHEMA {
        return Err(Flaw::Foreign);
    }
    serde_json::from_value(value).map_err(|_| Flaw::Damaged)
}

/// Prints how much of each chapter was seen, and how many of its exercises are solved.
pub fn progress() -> Result<(), Stop> {
    let (_, memory, note) = Book::open();
    if let Some(note) = note {
        out::say(&format!("note: {note}"));
    }
    out::print(told(&memory).as_bytes())
}

fn told(memory: &Memory) -> String {
    let widest = CURRICULUM.iter().map(|chapter| chapter.id.len()).max().unwrap_or(0);
    let line = |chapter: &Chapter| {
        let (seen, all) = (seen(memory, chapter), chapter.steps.len());
        let at = memory.places.get(chapter.id).filter(|_| seen > 0).map(|place| format!("   at {}", place.step));
        let [solved, set] = exercise::solved(memory, chapter.id);
        let exercises = format!("{solved} of {set} exercises");
        format!("{:<widest$}  {seen:>2} of {all:>2} steps   {exercises}{}\n", chapter.id, at.unwrap_or_default())
    };
    let total: usize = CURRICULUM.iter().map(|chapter| seen(memory, chapter)).sum();
    let all: usize = CURRICULUM.iter().map(|chapter| chapter.steps.len()).sum();
    let lines: String = CURRICULUM.iter().map(|chapter| line(chapter)).collect();
    let sums = CURRICULUM.iter().map(|chapter| exercise::solved(memory, chapter.id));
    let [solved, set] = sums.fold([0, 0], |sum, one| [sum[0] + one[0], sum[1] + one[1]]);
    format!("{lines}{:<widest$}  {total:>2} of {all:>2} steps   {solved} of {set} exercises\n", "all")
}

/// How many steps of a chapter were seen. What is no longer in it does not count.
fn seen(memory: &Memory, chapter: &Chapter) -> usize {
    chapter.steps.iter().filter(|step| memory.visited.contains(&format!("{}/{}", chapter.id, step.id))).count()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn folder(name: &str) -> PathBuf {
        let path = std::env::temp_dir().join(format!("lesson-bookmark-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&path);
        path
    }

    fn memory(visited: &[&str]) -> Memory {
        let place = Place { step: "brewster".into(), row: 7 };
        Memory {
            places: [("fresnel".to_owned(), place)].into(),
            last: "fresnel".into(),
            visited: visited.iter().map(|address| (*address).to_owned()).collect(),
            answers: [("fresnel/brewster/p_alone".to_owned(), Answer::Option(4))].into(),
            ..Memory::default()
        }
    }

    #[test]
    fn what_is_written_is_read_again_and_two_readers_lose_nothing() {
        let file = folder("kept").join(FILE);
        let (book, nothing, note) = Book::at(file.clone());
        assert_eq!((nothing, note), (Memory::default(), None));
        book.keep(&memory(&["fresnel/snell"])).unwrap();
        book.keep(&memory(&["fresnel/brewster"])).unwrap();
        let (_, read, note) = Book::at(file.clone());
        assert_eq!(note, None);
        assert_eq!(read.visited.iter().collect::<Vec<_>>(), ["fresnel/brewster", "fresnel/snell"]);
        assert_eq!((read.places["fresnel"].row, read.last.as_str()), (7, "fresnel"));
        assert_eq!(read.answers["fresnel/brewster/p_alone"].given(5), Some(Given::Option(3)));
        assert_eq!(read.answers["fresnel/brewster/p_alone"].given(3), None);
        // Nothing but the file is left behind.
        assert_eq!(fs::read_dir(file.parent().unwrap()).unwrap().count(), 1);
        fs::remove_dir_all(file.parent().unwrap()).unwrap();
    }

    #[test]
    fn what_was_done_of_exercises_is_never_undone() {
        let file = folder("exercises").join(FILE);
        let (book, ..) = Book::at(file.clone());
        let work = |hints, solved| Memory {
            exercises: [("snell".into(), Work { hints, solved })].into(),
            ..Memory::default()
        };
        for (hints, solved) in [(2, false), (1, true), (0, false)] {
            book.keep(&work(hints, solved)).unwrap();
        }
        // A reader that was open all the while knows nothing of them.
        book.keep(&memory(&["fresnel/snell"])).unwrap();
        let (_, read, note) = Book::at(file.clone());
        assert_eq!((read.exercises["snell"], note), (Work { hints: 2, solved: true }, None));
        fs::remove_dir_all(file.parent().unwrap()).unwrap();
    }

    #[test]
    fn damaged_files_are_replaced_and_foreign_ones_left_alone() {
        let path = folder("damaged");
        fs::create_dir_all(&path).unwrap();
        let file = path.join(FILE);
        let whole = |visited: &str| format!("{{\"schema\":\"{SCHEMA}\",\"visited\":{visited}}}");
        for (bytes, is_foreign) in [
            (b"".to_vec(), false),
            (b"{\"schema\":\"lesson".to_vec(), false),
            (vec![0xff, 0xfe, 0x00], false),
            (whole("7").into_bytes(), false),
            (b"{\"schema\":\"lesson/reader/2\"}".to_vec(), true),
            (b"[1, 2]".to_vec(), true),
        ] {
            fs::write(&file, &bytes).unwrap();
            let (book, memory, note) = Book::at(file.clone());
            assert_eq!(memory, Memory::default());
            assert!(note.is_some_and(|note| !note.contains('\n')), "{bytes:?}");
            book.keep(&self::memory(&["fresnel/snell"])).unwrap();
            assert_eq!(fs::read(&file).unwrap() == bytes, is_foreign, "{bytes:?}");
        }
        fs::remove_dir_all(&path).unwrap();
    }

    #[test]
    fn progress_counts_steps_that_there_are() {
        let told = told(&memory(&["fresnel/snell", "fresnel/brewster", "fresnel/gone", "maxwell/grid"]));
        let line = |chapter: &str| told.lines().find(|line| line.starts_with(chapter)).unwrap().to_owned();
        assert!(
            line("fresnel").contains(" 2 of 17 steps   0 of ") && line("fresnel").ends_with(" exercises   at brewster"),
            "{told}"
        );
        assert!(line("maxwell").contains(" 1 of ") && line("all").contains(" 3 of "), "{told}");
    }
}
