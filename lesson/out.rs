//! Where results go: standard output, and files that are either whole or not there.

use crate::stop::Stop;
use console::Term;
use std::fmt::Display;
use std::fs;
use std::io::{IsTerminal, Write, stderr, stdout};
use std::path::{Path, PathBuf};
use views::block::Block;
use views::page::Page;
use views::terminal;
use views::words::Words;

/// A page for standard output: as wide as the terminal within reason, in colour where that is wanted.
pub fn page() -> Page {
    let terminal = stdout().is_terminal();
    let columns = Term::stdout().size_checked().map_or(80, |(_, columns)| usize::from(columns));
    let declined = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty())
        || std::env::var_os("TERM").is_some_and(|value| value == "dumb");
    Page::new(if terminal { columns } else { 80 }, terminal && !declined)
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

/// A folder that can be written to.
#[derive(Debug)]
pub struct Folder {
    path: PathBuf,
}

impl Folder {
    /// Makes the folder and tries it out, so that a run does not find out at its end.
    pub fn open(path: &Path) -> Result<Self, Stop> {
        let refuse = |error| Stop::at(path.display(), format!("cannot be used as a folder to write to: {error}"));
        fs::create_dir_all(path).map_err(refuse)?;
        let probe = path.join(format!(".lesson-{}.tmp", std::process::id()));
        fs::write(&probe, []).and_then(|()| fs::remove_file(&probe)).map_err(refuse)?;
        Ok(Self { path: path.to_owned() })
    }

    /// Writes a file under a temporary name; [`publish`] puts it in its place.
    pub fn draft(&self, name: &str, bytes: &[u8]) -> Result<Draft, Stop> {
        let draft = Draft {
            path: self.path.join(name),
            temporary: self.path.join(format!(".{name}-{}.tmp", std::process::id())),
        };
        match draft.path.is_dir() {
            true => Err(draft.refused("there is a folder of that name")),
            false => match fs::write(&draft.temporary, bytes) {
                Ok(()) => Ok(draft),
                Err(error) => Err(draft.refused(error)),
            },
        }
    }
}

/// A file that is written but not yet in its place. Dropped, it is gone.
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

    fn refused(&self, why: impl Display) -> Stop {
        Stop::at(self.path.display(), format!("cannot be written: {why}"))
    }
}

impl Drop for Draft {
    fn drop(&mut self) {
        let _ = fs::remove_file(&self.temporary);
    }
}

/// Moves all of `drafts` into place, or none: those already moved are taken away again.
pub fn publish(drafts: &[Draft]) -> Result<(), Stop> {
    for (at, draft) in drafts.iter().enumerate() {
        fs::rename(&draft.temporary, &draft.path).map_err(|error| {
            for moved in &drafts[..at] {
                let _ = fs::remove_file(&moved.path);
            }
            draft.refused(error)
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
        drop(drafts);
        fs::remove_dir(path.join("second.png")).unwrap();
        let drafts = [folder.draft("free.png", b"x").unwrap()];
        publish(&drafts).unwrap();
        assert_eq!(drafts[0].path(), path.join("free.png"));
        drop(drafts);
        let mut names: Vec<_> = fs::read_dir(&path).unwrap().map(|entry| entry.unwrap().file_name()).collect();
        names.sort();
        assert_eq!(names, ["free.png", "taken.png"]);
        fs::remove_dir_all(&path).unwrap();
    }

    #[test]
    fn a_file_in_the_way_is_refused() {
        assert!(matches!(Folder::open(Path::new("/dev/null/figures")), Err(Stop::Refused(_))));
    }
}
