//! Where results go: standard output, and files that are either whole or not there.

use crate::stop::Stop;
use console::Term;
use std::fmt::Display;
use std::fs::{self, File, TryLockError};
use std::io::{self, ErrorKind, IsTerminal, Write, stderr, stdout};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};
use views::block::Block;
use views::page::Page;
use views::terminal;
use views::words::Words;

/// A page for standard output: as wide as the terminal within reason, in colour where that is wanted.
pub fn page() -> Page {
    let columns = Term::stdout().size_checked().map_or(80, |(_, columns)| usize::from(columns));
    Page::new(if stdout().is_terminal() { columns } else { 80 }, is_coloured())
}

/// Whether standard output shows colours and nobody has declined them.
pub fn is_coloured() -> bool {
    let declined = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty())
        || std::env::var_os("TERM").is_some_and(|value| value == "dumb");
    stdout().is_terminal() && !declined
}

/// Shows `blocks` on standard output.
pub fn show(blocks: &[Block]) -> Result<(), Stop> {
    let mut page = page();
    terminal::set(&mut page, Words::ENGLISH, blocks);
    print(page.into_text().as_bytes())
}

/// Writes `text` to standard output.
pub fn print(text: &[u8]) -> Result<(), Stop> {
    let mut out = stdout().lock();
    out.write_all(text).and_then(|()| out.flush()).map_err(Stop::writing)
}

/// Says something on standard error; nobody may be listening.
pub fn say(text: &str) {
    let _ = writeln!(stderr(), "{text}");
}

/// A folder that can be written to, and a hidden one inside it for what is not yet whole. That one is ours as long as
/// its lock is held, which ends with the process however it ends: the next run takes away what a killed one left.
#[derive(Debug)]
pub struct Folder {
    path: PathBuf,
    /// The same as it was typed: nothing where a file was named alone.
    typed: PathBuf,
    drafts: PathBuf,
    /// Held, never read.
    _lock: File,
}

impl Folder {
    /// Makes the folder and tries it out, so that a run does not find out at its end.
    pub fn open(path: &Path) -> Result<Self, Stop> {
        let refuse = |error| Stop::at(path.display(), format!("cannot be used as a folder to write to: {error}"));
        fs::create_dir_all(path).map_err(refuse)?;
        sweep(path);
        let (drafts, lock) = claim(path).map_err(refuse)?;
        Ok(Self { path: path.to_owned(), typed: path.to_owned(), drafts, _lock: lock })
    }

    /// The folder that a file is to be in, which must be there, tried out, and the file's name there.
    pub fn of(path: &Path) -> Result<(Self, String), Stop> {
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let parent = parent(path);
        if matches!(fs::metadata(parent), Err(error) if error.kind() == ErrorKind::NotFound) {
            return Err(cannot_write(path, format!("there is no folder {}", parent.display())));
        }
        let mut folder = Self::open(parent)?;
        folder.typed = path.parent().unwrap_or(Path::new("")).to_owned();
        folder.expect(&name)?;
        Ok((folder, name))
    }

    /// Refuses a `name` that a folder has already.
    pub fn expect(&self, name: &str) -> Result<(), Stop> {
        let place = self.typed.join(name);
        if place.is_dir() { Err(cannot_write(&place, "there is a folder of that name")) } else { Ok(()) }
    }

    /// Keeps the file `name` for this run alone, as long as the folder is held; refused if another run has it.
    pub fn reserve(&self, name: &str) -> Result<(), Stop> {
        let mark = format!("{name}{RESERVED}");
        let place = self.typed.join(name);
        File::create(self.drafts.join(&mark)).map_err(|error| cannot_write(&place, error))?;
        let others = fs::read_dir(&self.path).into_iter().flatten().flatten();
        let others = others.filter(|entry| entry.file_name().to_str().is_some_and(is_drafts_name));
        let is_taken = others.map(|entry| entry.path()).filter(|drafts| *drafts != self.drafts).any(|drafts| {
            let lock = File::open(drafts.join(LOCK));
            drafts.join(&mark).exists()
                && lock.is_ok_and(|lock| matches!(lock.try_lock(), Err(TryLockError::WouldBlock)))
        });
        if is_taken { Err(cannot_write(&place, "another run is writing it; valid: another file")) } else { Ok(()) }
    }

    /// Refuses a `name` that a file of other `bytes` has already: somebody may have written it by hand.
    pub fn unlike(&self, name: &str, bytes: &[u8]) -> Result<(), Stop> {
        let place = self.typed.join(name);
        match fs::metadata(&place).is_ok_and(|about| about.is_file()) && fs::read(&place).is_ok_and(|own| own != bytes)
        {
            true => Err(cannot_write(&place, "it is there already, with other content; valid: another file or folder")),
            false => Ok(()),
        }
    }

    /// Writes a file among the drafts; [`publish`] puts it in its place.
    pub fn draft(&self, name: &str, bytes: &[u8]) -> Result<Draft, Stop> {
        self.draft_by(name, |file| file.write_all(bytes))
    }

    /// Where this run may put what only it needs: taken away with the rest.
    pub fn scratch(&self) -> &Path {
        &self.drafts
    }

    /// A folder `name` of these files among the drafts; [`publish`] puts it in its place, whole.
    pub fn draft_folder(&self, name: &str, files: &[(&str, &[u8])]) -> Result<Draft, Stop> {
        let draft = Draft { path: self.typed.join(name), temporary: self.drafts.join(name) };
        let put = |(file, bytes): &(&str, &[u8])| fs::write(draft.temporary.join(file), bytes);
        let written = fs::create_dir_all(&draft.temporary).and_then(|()| files.iter().try_for_each(put));
        written.map_err(|error| cannot_write(&draft.path, error))?;
        Ok(draft)
    }

    /// The same of a file that is too large to be held a second time.
    pub fn draft_by(&self, name: &str, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<Draft, Stop> {
        self.expect(name)?;
        let draft = Draft { path: self.typed.join(name), temporary: self.drafts.join(name) };
        // Whoever took the folder away meanwhile shall not cost the work.
        let written = fs::create_dir_all(&self.drafts)
            .and_then(|()| File::create(&draft.temporary))
            .and_then(|mut file| write(&mut file));
        written.map_err(|error| cannot_write(&draft.path, error))?;
        Ok(draft)
    }
}

/// With what was not published.
impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.drafts);
    }
}

/// The folder that a file is in by its path.
pub fn parent(path: &Path) -> &Path {
    path.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// The file in a folder of drafts that its owner holds locked.
const LOCK: &str = "lock";

/// What follows a file's name among the drafts of the run that alone may write it.
const RESERVED: &str = ".reserved";

/// A name for a folder of drafts that this process has not used: whoever still looks at an old one takes away no new one.
fn drafts_name() -> String {
    static USED: AtomicU32 = AtomicU32::new(0);
    format!(".lesson-{}-{}.tmp", std::process::id(), USED.fetch_add(1, Ordering::Relaxed))
}

/// Whether a name is one of [`drafts_name`].
fn is_drafts_name(name: &str) -> bool {
    let numbers = name.strip_prefix(".lesson-").and_then(|rest| rest.strip_suffix(".tmp"));
    numbers.and_then(|numbers| numbers.split_once('-')).is_some_and(|(process, count)| {
        [process, count].iter().all(|number| !number.is_empty() && number.bytes().all(|digit| digit.is_ascii_digit()))
    })
}

/// How often somebody may come between, before that is no chance.
const ATTEMPTS: u32 = 100;

/// Makes a folder of drafts in `path` and locks it.
fn claim(path: &Path) -> io::Result<(PathBuf, File)> {
    let mut refusal = None;
    for _ in 0..ATTEMPTS {
        let drafts = path.join(drafts_name());
        let locked = fs::create_dir(&drafts).and_then(|()| File::create(drafts.join(LOCK)));
        match locked {
            Ok(lock) => {
                // A file system without locks lets nobody sweep either.
                let _ = lock.lock();
                // Who swept before the lock was held has taken the folder away.
                if drafts.join(LOCK).exists() {
                    return Ok((drafts, lock));
                }
            }
            // Another process of that number, or who swept, came between.
            Err(error) if matches!(error.kind(), ErrorKind::AlreadyExists | ErrorKind::NotFound) => {
                refusal = Some(error);
            }
            Err(error) => return Err(error),
        }
    }
    Err(refusal.unwrap_or_else(|| ErrorKind::AlreadyExists.into()))
}

/// Takes away folders of drafts in `path` whose owners are no more. What cannot be taken away stays.
fn sweep(path: &Path) {
    for entry in fs::read_dir(path).into_iter().flatten().flatten() {
        // A link of that name is not ours.
        let is_ours =
            entry.file_type().is_ok_and(|kind| kind.is_dir()) && entry.file_name().to_str().is_some_and(is_drafts_name);
        if !is_ours {
            continue;
        }
        let drafts = entry.path();
        // Killed between making the folder and its lock, the owner left none.
        let lock = File::options().write(true).create(true).truncate(false).open(drafts.join(LOCK));
        // Out of the way in one step first: an owner that comes between making the folder and its lock finds no folder,
        // where one taken away piece by piece would have let it put a new lock between the pieces.
        let aside = path.join(drafts_name());
        if let Ok(lock) = lock
            && lock.try_lock().is_ok()
            && fs::rename(&drafts, &aside).is_ok()
        {
            let _ = fs::remove_dir_all(&aside);
        }
    }
}

fn cannot_write(path: &Path, why: impl Display) -> Stop {
    Stop::at(path.display(), format!("cannot be written: {why}"))
}

/// A file that is written but not yet in its place.
#[derive(Debug)]
pub struct Draft {
    path: PathBuf,
    temporary: PathBuf,
}

impl Draft {
    /// Where it will be.
    pub fn path(&self) -> &Path {
        &self.path
    }
}

/// Moves each of `drafts` into place that can be: the paths of those, and why others are not there. For what each stands
/// for itself and took long to make.
pub fn publish_each(drafts: &[Draft]) -> (Vec<&Path>, Vec<Stop>) {
    let (mut paths, mut failures) = (Vec::new(), Vec::new());
    for draft in drafts {
        match fs::rename(&draft.temporary, &draft.path) {
            Ok(()) => paths.push(draft.path()),
            Err(error) => failures.push(cannot_write(&draft.path, error)),
        }
    }
    (paths, failures)
}

/// Moves all of `drafts` into place, or none: those already moved are taken away again. For what belongs together.
pub fn publish(drafts: &[Draft]) -> Result<(), Stop> {
    for (at, draft) in drafts.iter().enumerate() {
        fs::rename(&draft.temporary, &draft.path).map_err(|error| {
            for moved in &drafts[..at] {
                let _ = fs::remove_file(&moved.path);
            }
            cannot_write(&draft.path, error)
        })?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_that_cannot_be_put_in_place_leaves_nothing_behind() {
        let path = std::env::temp_dir().join(format!("lesson-out-test-{}", std::process::id()));
        let folder = Folder::open(&path).unwrap();
        fs::create_dir(path.join("taken.png")).unwrap();
        assert!(matches!(folder.draft("taken.png", b"x"), Err(Stop::Refused(_))));
        // A place that is taken between draft and publication spoils the whole set.
        let drafts = ["first.png", "second.png"].map(|name| folder.draft(name, b"x").unwrap());
        fs::create_dir(path.join("second.png")).unwrap();
        assert!(matches!(publish(&drafts), Err(Stop::Refused(_))));
        fs::remove_dir(path.join("second.png")).unwrap();
        let drafts = [folder.draft("free.png", b"x").unwrap()];
        publish(&drafts).unwrap();
        assert_eq!(drafts[0].path(), path.join("free.png"));
        drop(folder);
        assert_eq!(names(&path), ["free.png", "taken.png"]);
        fs::remove_dir_all(&path).unwrap();
    }

    #[test]
    fn a_file_is_called_what_was_typed() {
        for typed in ["out-test-typed.png", "./out-test-typed.png"] {
            let (folder, name) = Folder::of(Path::new(typed)).unwrap();
            assert_eq!(folder.draft(&name, b"x").unwrap().path().to_str(), Some(typed));
        }
    }

    fn names(path: &Path) -> Vec<String> {
        let names = fs::read_dir(path).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
        let mut names: Vec<_> = names.collect();
        names.sort();
        names
    }

    #[test]
    fn what_a_killed_run_left_is_taken_away_and_nothing_else() {
        let path = std::env::temp_dir().join(format!("lesson-sweep-test-{}", std::process::id()));
        let _ = fs::remove_dir_all(&path);
        // Killed with a draft, and killed before there was a lock.
        for (left, file) in [(".lesson-1-0.tmp", Some("figure.png")), (".lesson-2-3.tmp", None)] {
            fs::create_dir_all(path.join(left)).unwrap();
            file.into_iter()
                .chain(file.map(|_| LOCK))
                .for_each(|file| fs::write(path.join(left).join(file), []).unwrap());
        }
        let others = [".lesson-x-0.tmp", ".lesson-7.tmp", ".lesson--1.tmp", "lesson-1-0.tmp", ".lesson-1-0.tmpx"];
        others.iter().for_each(|other| fs::create_dir(path.join(other)).unwrap());
        fs::write(path.join(".lesson-3-0.tmp"), "a file of somebody's").unwrap();
        let living = Folder::open(&path).unwrap();
        let draft = living.draft("kept.png", b"x").unwrap();
        // A second run meanwhile leaves the first one's drafts alone.
        drop(Folder::open(&path).unwrap());
        publish(&[draft]).unwrap();
        drop(living);
        let mut kept = [&others[..], &[".lesson-3-0.tmp", "kept.png"]].concat();
        kept.sort_unstable();
        assert_eq!(names(&path), kept);
        fs::remove_dir_all(&path).unwrap();
    }

    #[test]
    fn runs_that_begin_together_all_get_a_place() {
        let path = std::env::temp_dir().join(format!("lesson-race-test-{}", std::process::id()));
        std::thread::scope(|scope| {
            for worker in 0..8 {
                let path = &path;
                scope.spawn(move || {
                    for turn in 0..50 {
                        let folder = Folder::open(path).unwrap();
                        publish(&[folder.draft(&format!("{worker}-{turn}"), b"x").unwrap()]).unwrap();
                    }
                });
            }
        });
        assert_eq!(names(&path).len(), 8 * 50);
        fs::remove_dir_all(&path).unwrap();
    }

    #[test]
    fn what_can_be_put_in_place_is_though_something_else_cannot() {
        let path = std::env::temp_dir().join(format!("lesson-each-test-{}", std::process::id()));
        let [one, two] = ["one", "two"].map(|name| Folder::open(&path.join(name)).unwrap());
        // The folder that was taken away is made again.
        fs::remove_dir_all(path.join("two")).unwrap();
        let drafts = [one.draft("taken.png", b"x"), one.draft("a.png", b"x"), two.draft("b.png", b"x")];
        let drafts = drafts.map(Result::unwrap);
        fs::create_dir(path.join("one/taken.png")).unwrap();
        let (paths, failures) = publish_each(&drafts);
        assert_eq!(paths, [path.join("one/a.png"), path.join("two/b.png")]);
        assert!(failures.len() == 1 && failures[0].to_string().contains("taken.png: cannot be written"));
        drop((one, two));
        fs::remove_dir_all(&path).unwrap();
    }

    #[test]
    fn a_file_is_one_runs_alone_as_long_as_that_lasts() {
        let path = std::env::temp_dir().join(format!("lesson-reserve-test-{}", std::process::id()));
        let [first, second] = [0, 1].map(|_| Folder::open(&path).unwrap());
        first.reserve("a.film").unwrap();
        assert!(second.reserve("a.film").unwrap_err().to_string().contains("another run is writing it"));
        second.reserve("b.film").unwrap();
        drop((first, second));
        Folder::open(&path).unwrap().reserve("a.film").unwrap();
        fs::remove_dir_all(&path).unwrap();
    }

    #[test]
    fn a_file_in_the_way_is_refused() {
        assert!(matches!(Folder::open(Path::new("/dev/null/figures")), Err(Stop::Refused(_))));
    }
}
