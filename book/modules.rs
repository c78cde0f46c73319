//! The figures' modules: one a chapter, so that a page loads what it needs and no more.

use crate::Fault;
use crate::press::{ROOT, cargo};
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The machine that browsers are.
const TARGET: &str = "wasm32-unknown-unknown";

/// The modules there are: those of the folder that was named, or else built here. None where this toolchain builds none; that
/// is said, and figures stand still.
///
/// # Errors
/// Says what cannot be read or built.
pub fn found(named: Option<&Path>) -> Result<Vec<PathBuf>, Fault> {
    if let Some(folder) = named {
        let entries = fs::read_dir(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
        let files = entries.flatten().map(|entry| entry.path());
        let modules: Vec<_> = files.filter(|path| path.extension().is_some_and(|kind| kind == "wasm")).collect();
        let known = chapters()?;
        let is_known =
            |path: &PathBuf| known.iter().any(|chapter| path.file_stem().is_some_and(|stem| *stem == **chapter));
        return match modules.iter().find(|path| !is_known(path)) {
            Some(other) => {
                let valid = known.join(".wasm, ");
                Err(format!("{}: no chapter has such a module; valid: {valid}.wasm", other.display()))
            }
            None if modules.is_empty() => Err(format!("{}: no module (….wasm) is there", folder.display())),
            None => Ok(modules),
        };
    }
    if !can_build() {
        eprintln!("note: figures will stand still; `rustup target add {TARGET}` lets them answer");
        return Ok(Vec::new());
    }
    chapters()?.iter().map(|chapter| built(chapter)).collect()
}

/// Whether the standard library for browsers is installed.
fn can_build() -> bool {
    let asked = Command::new("rustc").args(["--print", "target-libdir", "--target", TARGET]).output();
    asked.is_ok_and(|told| Path::new(String::from_utf8_lossy(&told.stdout).trim()).is_dir())
}

/// The chapters that have a module: the features of the package that makes them.
fn chapters() -> Result<Vec<String>, Fault> {
    let told =
        Command::new(cargo()).args(["metadata", "--no-deps", "--format-version", "1"]).current_dir(ROOT).output();
    let told: Value = told.ok().and_then(|told| serde_json::from_slice(&told.stdout).ok()).unwrap_or_default();
    let web = told["packages"].as_array().into_iter().flatten().find(|package| package["name"] == "web");
    let features = web.and_then(|web| web["features"].as_object()).ok_or("cargo does not tell of the package `web`")?;
    Ok(features.keys().cloned().collect())
}

/// A chapter's module, built into a folder of its own: all have one name.
fn built(chapter: &str) -> Result<PathBuf, Fault> {
    let mut build = Command::new(cargo());
    build.args(["build", "--package", "web", "--profile", "wasm", "--target", TARGET, "--features", chapter]);
    build.args(["--message-format", "json-render-diagnostics"]).current_dir(ROOT).stderr(Stdio::inherit());
    let told = build.output().map_err(|error| format!("cargo: {error}"))?;
    let messages = String::from_utf8_lossy(&told.stdout);
    let module = messages.lines().rev().find_map(|line| {
        let message: Value = serde_json::from_str(line).ok()?;
        let files = message["filenames"].as_array()?.iter().filter_map(Value::as_str);
        files.map(PathBuf::from).find(|file| file.extension().is_some_and(|kind| kind == "wasm"))
    });
    let module = module.filter(|_| told.status.success());
    let module = module.ok_or_else(|| format!("the module of {chapter} cannot be built (above)"))?;
    let own = module.with_file_name(format!("{chapter}.wasm"));
    fs::copy(&module, &own).map_err(|error| format!("{}: {error}", own.display()))?;
    Ok(own)
}
