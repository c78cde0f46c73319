//! Bad input: one clear message that names the place and what would be valid, exit 2, nothing half-written.

#[allow(dead_code, reason = "each test file uses its part")]
mod common;

use common::{command, folder, lesson};

/// Refused in one line that contains every one of `words`.
fn refused(arguments: &str, words: &[&str]) {
    let run = lesson(arguments);
    assert_eq!((run.code, run.out.as_str()), (2, ""), "{arguments}: {run:?}");
    assert_eq!(run.err.lines().count(), 1, "{arguments}: {run:?}");
    assert!(run.err.starts_with("error: "), "{arguments}: {run:?}");
    for word in words {
        assert!(run.err.contains(word), "{arguments} should say `{word}`: {}", run.err);
    }
}

#[test]
fn unknown_chapters_steps_and_items() {
    refused("fresnell", &["fresnell", "did you mean `fresnel`", "path-tracing"]);
    refused("covrage", &["did you mean `coverage`"]);
    refused("compleshuns", &["did you mean `completions`", "prove", "help", "all"]);
    refused("fresnel brewsterr", &["fresnel/brewsterr", "did you mean `brewster`", "natural"]);
    refused("fresnel brewster/nothing_of_the_kind", &["no such item"]);
    refused("fresnel brewster nothing_of_the_kind", &["no such item"]);
    refused("a b c", &["a", "no such chapter"]);
    refused("all brewster", &["brewster"]);
    refused("--check", &["all"]);
    refused("--plot coverage", &["coverage", "a command"]);
    refused("contents fresnle", &["did you mean `fresnel`"]);
    refused("help fresnle", &["did you mean `fresnel`"]);
}

#[test]
fn a_name_of_elsewhere_is_told_where_it_stands() {
    refused("fresnel poynting_theorem", &["no such step", "did you mean `poynting/theorem`"]);
    refused("fresnel no_flow", &["did you mean `fresnel/total_reflection/no_flow`"]);
    refused("brewster", &["no such chapter", "did you mean `fresnel/brewster`"]);
    refused("fresnel brewster r_plus_t", &["no such item", "did you mean `fresnel/energy/r_plus_t`"]);
    refused("fresnel/brewster/square/first", &["only a race", "contestants"]);
}

#[test]
fn an_empty_word_is_none() {
    for words in [&[""][..], &["fresnel", ""], &["fresnel", " "], &["fresnel", "brewster", ""]] {
        let output = command(words).output().unwrap();
        assert_eq!((output.status.code(), &output.stdout[..]), (Some(2), &b""[..]), "{words:?}");
        assert!(String::from_utf8_lossy(&output.stderr).contains("an empty word"), "{words:?}");
    }
}

#[test]
fn unknown_parameters() {
    refused("fresnel brewster --set thetta=1", &["thetta", "did you mean `theta`", "n_t"]);
    refused("fresnel --set thetta=1 --plot", &["thetta", "did you mean `theta`"]);
    // What the functions call n1, the steps call n_i.
    refused("fresnel --set n1=1.5", &["n1", "did you mean `n_i`"]);
    refused("fresnel brewster --set k2=1", &["k2", "no such parameter"]);
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
    let long = format!("--{}", "x".repeat(5000));
    refused(&format!("fresnel {long}"), &["unknown option"]);
    assert!(lesson(&format!("fresnel {long}")).err.len() < 120);
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
    refused("fresnel brewster --set freq=545", &["did you mean `545THz`"]);
    refused("fresnel brewster --set freq=545nm", &["no unit here", "PHz, THz, GHz"]);
    refused("fresnel brewster --set theta=45m", &["no unit here", "deg, °, rad"]);
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
fn malformed_flags_are_refused_like_everything_else() {
    refused("fresnel --set theta", &["--set: expected NAME=VALUE, found `theta`"]);
    refused("fresnel --set", &["--set: needs a value"]);
    refused("fresnel --format bmp", &["--format", "`bmp`", "png, svg"]);
    refused("completions tcsh9", &["shell", "`tcsh9`", "bash"]);
    refused("completions", &["shell: missing"]);
    refused("eval", &["function: missing"]);
    refused("eval fresnel --json-lines --json", &["--json-lines", "--json"]);
    refused("coverage everything", &["everything: one word too many"]);
    refused("fresnel a b c d", &["d: one word too many"]);
    refused("prove x", &["to: missing"]);
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
    for arguments in [
        "",
        "fresnel brewster",
        "--help",
        "--version",
        "help",
        "eval --help",
        "fresnel brewster --help",
        "contents",
        "completions bash",
        "eval --list",
        "coverage",
    ] {
        let words: Vec<_> = arguments.split_whitespace().collect();
        let output = command(&words).stdout(full.try_clone().unwrap()).output().unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments}");
        assert!(String::from_utf8_lossy(&output.stderr).starts_with("error: standard output"), "{arguments}");
    }
}
