//! Where results go: standard output, and files that are either whole or not there.

use crate::stop::Stop;
use std::fs;
use std::io::{Write, stderr, stdout};
use std::path::{Path, PathBuf};

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

    /// Writes a file under a temporary name and moves it into place; returns its path.
    pub fn write(&self, name: &str, bytes: &[u8]) -> Result<PathBuf, Stop> {
        let path = self.path.join(name);
        let draft = self.path.join(format!(".{name}-{}.tmp", std::process::id()));
        fs::write(&draft, bytes).and_then(|()| fs::rename(&draft, &path)).map_err(|error| {
            let _ = fs::remove_file(&draft);
            Stop::at(path.display(), format!("cannot be written: {error}"))
        })?;
        Ok(path)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_that_cannot_be_put_in_place_leaves_nothing_behind() {
        let path = std::env::temp_dir().join(format!("lesson-out-test-{}", std::process::id()));
        let folder = Folder::open(&path).unwrap();
        fs::create_dir(path.join("taken.png")).unwrap();
        assert!(matches!(folder.write("taken.png", b"x"), Err(Stop::Refused(_))));
        assert_eq!(folder.write("free.png", b"x").unwrap(), path.join("free.png"));
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
