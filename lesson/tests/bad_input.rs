//! Bad input: one clear message that names the place and what would be valid, exit 2, nothing half-written.

#[allow(dead_code, reason = "each test file uses its part")]
mod common;

use common::{command, folder, lesson};

/// Refused in one line that contains every one of `words`.
fn refused(arguments: &str, words: &[&str]) {
    let run = lesson(arguments);
    assert_eq!((run.code, run.out.as_str()), (2, ""), "{arguments}: {run:?}");
    assert_eq!(run.err.lines().count(), 1, "{arguments}: {run:?}");
    assert!(run.err.starts_with("lesson: "), "{arguments}: {run:?}");
    for word in words {
        assert!(run.err.contains(word), "{arguments} should say `{word}`: {}", run.err);
    }
}

#[test]
fn unknown_chapters_steps_and_items() {
    refused("fresnell", &["fresnell", "did you mean `fresnel`", "path-tracing"]);
    refused("covrage", &["did you mean `coverage`"]);
    refused("compleshuns", &["did you mean `completions`", "prove", "help", "all"]);
    refused("brdf", &["not written yet", "fresnel"]);
    refused("fresnel brewsterr", &["fresnel/brewsterr", "did you mean `brewster`", "natural"]);
    refused("fresnel brewster/nothing_of_the_kind", &["no such item"]);
    refused("fresnel brewster nothing_of_the_kind", &["no such item"]);
    refused("a b c", &["a", "no such chapter"]);
    refused("all brewster", &["brewster"]);
    refused("--check", &["all"]);
}

#[test]
fn unknown_parameters() {
    refused("fresnel brewster --set thetta=1", &["thetta", "did you mean `theta`", "n_t"]);
    refused("fresnel --set thetta=1 --plot", &["thetta", "did you mean `theta`"]);
    refused("plane-wave --set medium=copper --set medium=gold", &["medium", "given twice"]);
    refused("plane-wave --set medium=copper --set medium=copper", &["medium", "given twice"]);
}

#[test]
fn one_quantity_is_set_once() {
    refused("fresnel brewster --set wavelength=550nm --set freq=545THz", &["freq", "wavelength", "give one of them"]);
    refused("fresnel brewster --set freq=1GHz", &["freq", "valid: 299.792458GHz"]);
    refused("maxwell grid --set courant=1.2", &["courant", "--unstable"]);
}

#[test]
fn unknown_options() {
    refused("maxwell media --unstable", &["unstable", "no such parameter here"]);
    refused("eval fresnel --unstable", &["--unstable", "unknown option"]);
    refused("fresnel --chek", &["--chek", "unknown option", "did you mean `--check`"]);
}

#[test]
fn values_outside_their_domain() {
    refused("fresnel brewster --set n_t=-1.5", &["n_t", "valid"]);
    refused("fresnel brewster --set n_t=nan", &["n_t", "valid"]);
    refused("fresnel brewster --set n_t=1e400", &["n_t", "valid"]);
    refused("fresnel brewster --set n_t=unobtainium", &["n_t", "unobtainium", "gold"]);
    refused("fresnel brewster --set n_i=gold", &["n_i", "absorbs"]);
    refused("fresnel --set n_i=gold", &["n_i", "absorbs"]);
    refused("fresnel brewster --set theta=95deg", &["theta", "95deg", "0deg to 90deg"]);
    refused("fresnel brewster --set theta=nan", &["theta", "valid"]);
    refused("fresnel natural --set n_t=gold --set wavelength=900um", &["gold"]);
    refused("fresnel --set n_t=gold --set wavelength=900um", &["gold"]);
    refused("fresnel --set wavelength=-1nm", &["wavelength", "valid"]);
    refused("fresnel brewster --set wavelength=550", &["did you mean `550nm`", "1nm to 1e6nm"]);
    refused("fresnel brewster --set n_t=glod", &["glod", "did you mean `gold`"]);
    refused("fresnel metals --set wavelength=5um", &["n_t", "gold"]);
}

#[test]
fn unphysical_media_and_frequencies() {
    refused("plane-wave conductor --set medium=cooper", &["medium", "did you mean `copper`", "sea-water"]);
    refused("plane-wave conductor --set medium=0/1/1", &["medium", "valid", "ε_r/μ_r/σ"]);
    refused("plane-wave conductor --set medium=1/-1/1", &["medium", "valid"]);
    refused("plane-wave conductor --set medium=1/1/-1", &["medium", "σ from 0"]);
    refused("plane-wave conductor --set medium=1/1/nan", &["medium", "valid"]);
    refused("plane-wave conductor --set freq=0GHz", &["freq", "valid: 1e-12GHz to 1e7GHz"]);
    refused("plane-wave conductor --set freq=nan", &["freq", "valid"]);
    refused("plane-wave conductor --set medium=copper --set freq=10THz", &["copper at 1e13 Hz", "hold"]);
    refused("plane-wave --set medium=copper --set freq=10THz", &["copper at 1e13 Hz", "hold"]);
}

#[test]
fn folders_and_formats_are_for_figures() {
    refused("fresnel brewster --out figures", &["--out", "needs --plot"]);
    refused("fresnel brewster --check --format svg", &["--format", "needs --plot"]);
}

#[test]
fn malformed_flags_are_clap_s_to_refuse() {
    for arguments in ["fresnel --set theta", "fresnel --format bmp", "fresnel --no-such-flag", "completions tcsh9"] {
        let run = lesson(arguments);
        assert_eq!((run.code, run.out.as_str()), (2, ""), "{arguments}");
        assert!(run.err.starts_with("lesson: ") && !run.err.contains("error:"), "{arguments}: {run:?}");
    }
}

#[test]
fn folders_that_cannot_be_written_to() {
    let place = folder("unwritable");
    let file = place.join("file");
    std::fs::write(&file, "mine").unwrap();
    refused(&format!("fresnel brewster --plot --out {}", file.display()), &["file", "folder"]);
    refused(&format!("fresnel brewster --plot --out {}/below", file.display()), &["below"]);
    refused("fresnel brewster --plot --out /proc/nowhere", &["/proc/nowhere"]);
    assert_eq!(std::fs::read_to_string(&file).unwrap(), "mine");
    assert_eq!(std::fs::read_dir(&place).unwrap().count(), 1);
}

#[test]
fn a_figure_that_cannot_be_put_in_place_takes_its_set_with_it() {
    let place = folder("taken");
    let command = format!("fresnel total_reflection --plot --out {}", place.display());
    let made = lesson(&command);
    let paths: Vec<_> = made.out.lines().filter(|line| line.ends_with(".png")).collect();
    assert!(paths.len() > 1, "{made:?}");
    paths.iter().for_each(|path| std::fs::remove_file(path).unwrap());
    let last = paths.last().unwrap();
    std::fs::create_dir(last).unwrap();
    refused(&command, &["cannot be written"]);
    let left: Vec<_> = std::fs::read_dir(&place).unwrap().map(|file| file.unwrap().path()).collect();
    assert_eq!(left, [std::path::Path::new(last)]);
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disc_is_reported() {
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let output = command(&["fresnel", "brewster"]).stdout(full).output().unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).starts_with("lesson: standard output"));
}
