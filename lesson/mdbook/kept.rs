//! What was put into books before: a book that is built again, as while one writes it, waits for nothing that is known.
//!
//! A folder by the platform's rules has a folder for this very program, by its own bytes; what another one has put there is
//! taken away. It is a help and no more: where nothing can be kept, everything is computed.

use crate::out::{self, Folder};
use etcetera::{BaseStrategy, choose_base_strategy};
use sha2::{Digest, Sha256};
use std::fs;
use std::path::{Path, PathBuf};

/// Parts of the lecture as HTML.
pub struct Kept {
    folder: PathBuf,
}

impl Kept {
    /// Those of this program.
    pub fn open() -> Option<Self> {
        let all = choose_base_strategy().ok()?.cache_dir().join("lesson").join("mdbook");
        let program = fs::read(std::env::current_exe().ok()?).ok()?;
        Some(Self::of(&all, &program))
    }

    /// Those that a program of these bytes has put into the folder of all.
    fn of(all: &Path, program: &[u8]) -> Self {
        let own = name(program);
        for other in fs::read_dir(all).into_iter().flatten().flatten() {
            if other.file_name().to_str().is_some_and(|name| name != own && is_name(name)) {
                // Whoever is reading there computes it again.
                let _ = fs::remove_dir_all(other.path());
            }
        }
        Self { folder: all.join(own) }
    }

    /// What was told of a `key`.
    pub fn get(&self, key: &str) -> Option<String> {
        fs::read_to_string(self.folder.join(file(key))).ok()
    }

    /// Keeps what was told of a `key`, if it can be kept.
    pub fn put(&self, key: &str, html: &str) {
        let kept = Folder::open(&self.folder).and_then(|folder| {
            let draft = folder.draft(&file(key), html.as_bytes())?;
            out::publish(&[draft])
        });
        // Nobody misses it.
        drop(kept);
    }
}

fn file(key: &str) -> String {
    format!("{}.html", name(key.as_bytes()))
}

/// How many hexadecimal digits a name has.
const DIGITS: usize = 32;

fn name(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().take(DIGITS / 2).map(|byte| format!("{byte:02x}")).collect()
}

fn is_name(name: &str) -> bool {
    name.len() == DIGITS && name.bytes().all(|byte| byte.is_ascii_hexdigit())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_told_is_known_until_the_program_is_another() {
        let all = std::env::temp_dir().join(format!("lesson-kept-{}", std::process::id()));
        let kept = Kept::of(&all, b"one");
        assert_eq!(kept.get("a"), None);
        kept.put("a", "<p>told</p>");
        assert_eq!((kept.get("a").as_deref(), kept.get("b")), (Some("<p>told</p>"), None));
        fs::create_dir_all(all.join("somebody's")).unwrap();
        assert_eq!(Kept::of(&all, b"two").get("a"), None);
        assert_eq!(Kept::of(&all, b"one").get("a"), None, "the second has taken it away");
        assert!(all.join("somebody's").is_dir(), "what is not ours stays");
        fs::remove_dir_all(all).unwrap();
    }
}
