//! From pages to a book: the program is built, fills the pages, and mdBook sets them.

use crate::{Fault, modules};
use flate2::Compression;
use flate2::write::GzEncoder;
use mdbook_driver::MDBook;
use mdbook_driver::config::Config;
use serde_json::Value;
use std::ffi::OsString;
use std::fs::{self, File};
use std::io::Write;
use std::path::{self, Path, PathBuf};
use std::process::{Command, Stdio};
use tempfile::TempDir;

/// The folder of the book's sources.
pub const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// Where the book goes if nothing else is said.
pub const OUT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/out");

/// What marks a folder as a book of ours, which may be replaced.
const MARK: &str = ".lesson-book";

/// Builds the book into the folder `out`, which is replaced when all of it is there; `modules` is the folder that has those of
/// the figures, if they are not to be built.
///
/// # Errors
/// Says what failed; the folder is then as it was.
pub fn build(out: &Path, modules: Option<&Path>) -> Result<(), Fault> {
    let refused = |error| format!("{}: cannot be written to: {error}", out.display());
    let out = &path::absolute(out).map_err(refused)?;
    if out.exists() && !is_ours(out) {
        return Err(format!("{}: there is something else than a book of ours; valid: another folder", out.display()));
    }
    let parent = out.parent().ok_or_else(|| format!("{}: no folder for a book", out.display()))?;
    fs::create_dir_all(parent).map_err(refused)?;
    let modules = modules::found(modules)?;
    let lesson = program()?;
    // Beside the one to come, so that a rename puts it there; what is not whole goes with it.
    let drafts = TempDir::with_prefix_in(".book-", parent).map_err(refused)?;
    let draft = drafts.path().join("new");
    set(&lesson, &modules, &draft)?;
    put(&modules, &draft)?;
    fs::write(draft.join(MARK), "").map_err(refused)?;
    let old = drafts.path().join("old");
    if out.exists() {
        fs::rename(out, &old).map_err(refused)?;
    }
    fs::rename(&draft, out).map_err(|error| {
        // Better the old one than none.
        let _ = fs::rename(&old, out);
        refused(error)
    })
}

/// Whether a folder holds a book that was put there by us, or nothing.
fn is_ours(folder: &Path) -> bool {
    let is_empty = fs::read_dir(folder).is_ok_and(|mut entries| entries.next().is_none());
    is_empty || folder.join(MARK).is_file()
}

/// Puts the figures' modules into the book, packed: a third of their size, whatever shows the book.
fn put(modules: &[PathBuf], book: &Path) -> Result<(), Fault> {
    let folder = book.join("modules");
    let refused = |error| format!("{}: {error}", folder.display());
    fs::create_dir_all(&folder).map_err(refused)?;
    modules.iter().try_for_each(|module| {
        let packed = folder.join(module.file_name().unwrap_or_default()).with_extension("wasm.gz");
        let mut packer = GzEncoder::new(File::create(packed).map_err(refused)?, Compression::best());
        packer
            .write_all(&fs::read(module).map_err(refused)?)
            .and_then(|()| packer.finish())
            .map(|_| ())
            .map_err(refused)
    })
}

/// Sets the book into a folder, its pages filled by the program at `lesson`, the figures of chapters with modules ready to answer.
fn set(lesson: &Path, modules: &[PathBuf], folder: &Path) -> Result<(), Fault> {
    let told = |error: mdbook_driver::errors::Error| format!("{error:#}");
    let mut config = Config::from_disk(Path::new(ROOT).join("book.toml")).map_err(told)?;
    config.build.build_dir = folder.to_owned();
    let command = lesson.to_str().ok_or_else(|| format!("{}: not a name that mdBook can run", lesson.display()))?;
    // mdBook splits it as a shell does.
    let command = format!("'{command}' mdbook");
    config.set("preprocessor.lesson.command", command).map_err(told)?;
    let live: Vec<_> = modules.iter().filter_map(|module| module.file_stem()?.to_str()).collect();
    config.set("preprocessor.lesson.live", live).map_err(told)?;
    MDBook::load_with_config(ROOT, config).and_then(|book| book.build()).map_err(told)
}

/// The cargo that runs us, or the one there is.
pub fn cargo() -> OsString {
    std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into())
}

/// The program, built if it is not up to date.
fn program() -> Result<PathBuf, Fault> {
    let built = Command::new(cargo())
        .args(["build", "--release", "--package", "lesson", "--message-format", "json-render-diagnostics"])
        .current_dir(ROOT)
        .stderr(Stdio::inherit())
        .output()
        .map_err(|error| format!("cargo: {error}"))?;
    if !built.status.success() {
        return Err("the program `lesson` cannot be built (above)".to_owned());
    }
    let messages = String::from_utf8_lossy(&built.stdout);
    let executable = messages.lines().rev().find_map(|line| {
        let message: Value = serde_json::from_str(line).ok()?;
        message["executable"].as_str().map(PathBuf::from)
    });
    executable.ok_or_else(|| "cargo does not say where the program `lesson` is".to_owned())
}
