//! `lesson exercise`: laid out, judged, helped with; and whatever a learner's file may do, one clear message and nothing left.

#[allow(dead_code, reason = "each test file uses its part")]
mod common;

use common::{Run, command, folder};
use serde_json::Value;
use std::fs;
#[cfg(target_os = "linux")]
use std::path::Path;
use std::path::PathBuf;

/// Text without its line breaks.
fn flat(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// A learner with a folder of their own, where everything is kept.
struct Learner(PathBuf);

impl Learner {
    fn new(name: &str) -> Self {
        Self(folder(name))
    }

    fn command(&self, arguments: &str) -> std::process::Command {
        let arguments: Vec<&str> = arguments.split_whitespace().collect();
        let mut command = command(&[&["exercise"], &arguments[..]].concat());
        command.current_dir(&self.0).env("XDG_STATE_HOME", self.0.join("state")).env("TMPDIR", &self.0);
        command
    }

    fn runs(&self, arguments: &str) -> Run {
        listened(self.command(arguments))
    }

    fn writes(&self, body: &str) -> &Self {
        let text = format!("pub fn refracted_sine(theta_i: f64, n_i: f64, n_t: f64) -> f64 {{\n{body}\n}}\n");
        fs::write(self.0.join("snell.rs"), text).unwrap();
        self
    }

    /// What is in the folder, but for what the program remembers.
    fn holds(&self) -> Vec<String> {
        let names = fs::read_dir(&self.0).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
        let mut names: Vec<String> = names.filter(|name| name != "state").collect();
        names.sort();
        names
    }
}

fn listened(mut command: std::process::Command) -> Run {
    let output = command.stdin(std::process::Stdio::null()).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    Run { code: output.status.code().unwrap(), out: text(output.stdout), err: text(output.stderr) }
}

const RIGHT: &str = "    n_i * theta_i.sin() / n_t";

#[test]
fn from_the_start_to_the_solution() {
    let learner = Learner::new("exercise-way");
    let run = learner.runs("start snell");
    assert_eq!(run.code, 0, "{run:?}");
    let file = learner.0.join("lesson-exercises/snell/snell.rs");
    assert!(run.out.contains("snell.rs") && run.out.contains("task.md") && file.is_file(), "{run:?}");
    let run = learner.runs("check snell");
    assert!(run.code == 1 && flat(&run.out).contains("the hole is still there"), "{run:?}");
    // What is there is not overwritten.
    let again = learner.runs("start snell");
    assert!(again.code == 2 && again.err.contains("is there already") && again.err.lines().count() == 1, "{again:?}");
    assert_eq!(learner.runs("start snell --into elsewhere").code, 0);
    // One hint after the other, and the last one again.
    let hints: Vec<String> = (0..4).map(|_| learner.runs("hint snell").out).collect();
    assert!(hints[0].starts_with("hint 1 of 3\n") && hints[1].starts_with("hint 2 of 3\n"), "{hints:?}");
    assert!(hints[2].starts_with("hint 3 of 3, the last\n") && hints[2] == hints[3], "{hints:?}");
    let slip = fs::read_to_string(&file).unwrap().replace("todo!()", "n_t * theta_i.sin() / n_i");
    fs::write(&file, slip).unwrap();
    let run = learner.runs("check snell");
    assert_eq!((run.code, run.err.as_str()), (1, ""), "{run:?}");
    for part in
        ["Snell's law with the indices interchanged", "fresnel/snell/fermat", "yours", "right", "0 passed, 1 failed"]
    {
        assert!(flat(&run.out).contains(part), "{part}: {}", run.out);
    }
    assert!(run.out.lines().all(|line| line.chars().count() <= 80), "{}", run.out);
    let right = fs::read_to_string(&file).unwrap().replace("n_t * theta_i.sin() / n_i", "n_i * theta_i.sin() / n_t");
    fs::write(&file, right).unwrap();
    let run = learner.runs(&format!("check snell {}", file.display()));
    assert!(
        run.code == 0 && run.out.starts_with("snell: solved\n") && run.out.ends_with("\n1 passed, 0 failed\n"),
        "{run:?}"
    );
    // It is remembered: in the list, in the progress, and the hint is the solution now.
    let list: Value = serde_json::from_str(&learner.runs("list --json").out).unwrap();
    let all = list["exercises"].as_array().unwrap();
    let solved: Vec<&str> =
        all.iter().filter(|one| one["solved"] == true).filter_map(|one| one["name"].as_str()).collect();
    assert!(all.len() >= 16 && solved == ["snell"], "{list}");
    assert!(learner.runs("list").out.contains("✓ snell"));
    assert!(learner.runs("hint snell").out.contains("n_i * theta_i.sin() / n_t"));
    let mut progress = command(&["progress"]);
    progress.env("XDG_STATE_HOME", learner.0.join("state"));
    let progress = listened(progress).out;
    assert!(
        progress.lines().any(|line| line.starts_with("fresnel") && line.contains("1 of 4 exercises")),
        "{progress}"
    );
    assert_eq!(learner.holds(), ["elsewhere", "lesson-exercises"]);
}

#[test]
fn scripts_are_told_all_of_it() {
    let learner = Learner::new("exercise-json");
    let run = learner
        .writes("    eprintln!(\"x\"); println!(\"at {theta_i}\"); n_i * theta_i / n_t")
        .runs("check snell --json");
    let found: Value = serde_json::from_str(&run.out).unwrap();
    assert_eq!((run.code, &found["solved"], &found["failed"]), (1, &false.into(), &1.into()), "{found}");
    assert!(found["slip"].as_str().is_some_and(|slip| slip.starts_with("angles for sines")), "{found}");
    let asked: Vec<f64> = found["worst"]["asked"].as_array().unwrap().iter().filter_map(Value::as_f64).collect();
    let right = found["worst"]["right"][0].as_f64().unwrap();
    assert!((asked[1] * asked[0].sin() / asked[2] / right - 1.0).abs() < 1e-15, "{found}");
    assert_eq!(found["checks"][0]["limit"].as_f64(), Some(1e-7));
    assert!(found["printed"].as_str().is_some_and(|text| text.starts_with("at 0.")), "{found}");
}

#[test]
fn what_does_not_run_is_told_in_one_message() {
    let learner = Learner::new("exercise-bad");
    let refused = |run: Run, parts: &[&str]| {
        assert_eq!((run.code, run.out.as_str()), (2, ""), "{run:?}");
        assert!(run.err.starts_with("error: ") && run.err.matches("error: ").count() == 1, "{run:?}");
        assert!(parts.iter().all(|part| run.err.contains(part)), "{parts:?}: {run:?}");
    };
    refused(learner.runs("check snel"), &["snel: no such exercise", "did you mean `snell`"]);
    refused(learner.runs("start nothing-like-it"), &["no such exercise"]);
    refused(learner.runs("check snell"), &["no file to check", "lesson exercise start snell"]);
    refused(learner.runs("check snell nowhere.rs"), &["nowhere.rs", "cannot be read"]);
    refused(learner.runs("check snell --time 0s"), &["--time", "valid"]);
    fs::write(learner.0.join("binary.rs"), [0xff, 0xfe]).unwrap();
    refused(learner.runs("check snell binary.rs"), &["binary.rs", "UTF-8"]);
    fs::write(learner.0.join("taken"), "a file").unwrap();
    refused(learner.runs("start snell --into taken"), &["taken"]);
    learner.writes("    n_i * theta_i.sine() / n_t");
    let run = learner.runs("check snell");
    assert!(
        run.code == 2 && run.err.contains("snell.rs: does not compile") && run.err.contains("snell.rs:2:"),
        "{run:?}"
    );
    fs::write(learner.0.join("snell.rs"), "pub fn refracted_sine(x: f64) -> f64 { x }").unwrap();
    let run = learner.runs("check snell");
    assert!(run.code == 2 && run.err.contains("must be: pub fn refracted_sine(theta_i: f64, n_i: f64"), "{run:?}");
    let mut without = learner.writes(RIGHT).command("check snell");
    without.env("RUSTC", "no-such-compiler");
    refused(listened(without), &["no-such-compiler", "no Rust compiler", "rustup.rs"]);
    assert_eq!(learner.holds(), ["binary.rs", "snell.rs", "taken"]);
}

#[test]
fn what_runs_amiss_is_ended_and_told() {
    let learner = Learner::new("exercise-amiss");
    let cases = [
        ("    loop {}", "no answer within 0.5 s"),
        ("    let all = [n_i, n_t]; all[theta_i.to_bits() as usize % 7 + 2]", "panics: index out of bounds"),
        ("    print!(\"x\"); std::process::exit(0)", "ends the program instead of giving a result"),
        (
            "    fn deep(x: f64) -> f64 { let a = [x; 64]; deep(std::hint::black_box(a)[1]) + x } deep(n_i + theta_i + n_t)",
            "its stack overflows",
        ),
        #[cfg(target_os = "linux")]
        (
            "    let all = vec![1.0_f64; 1 << 32]; all[n_i as usize] * theta_i * n_t",
            "more memory than it may have, 1024 MiB",
        ),
        ("    loop { println!(\"{}\", \"x\".repeat(1000)) }", "prints more than"),
        ("    let _ = (theta_i, n_i, n_t); f64::NAN", "are no numbers"),
    ];
    for (body, part) in cases {
        let run = learner.writes(body).runs("check snell --time 0.5s");
        assert_eq!((run.code, run.err.as_str()), (1, ""), "{body}: {run:?}");
        assert!(run.out.starts_with("snell: not solved\n") && flat(&run.out).contains(part), "{body}: {}", run.out);
        assert!(run.out.ends_with("\n0 passed, 1 failed\n"), "{}", run.out);
    }
    assert_eq!(learner.holds(), ["snell.rs"]);
}

/// What runs out of this folder.
#[cfg(target_os = "linux")]
fn running(folder: &Path) -> usize {
    let of = |entry: &fs::DirEntry| fs::read_link(entry.path().join("exe")).is_ok_and(|exe| exe.starts_with(folder));
    fs::read_dir("/proc").unwrap().flatten().filter(of).count()
}

#[cfg(target_os = "linux")]
#[test]
fn who_is_interrupted_leaves_nobody_behind() {
    use rustix::process::{Pid, Signal, kill_process};
    let learner = Learner::new("exercise-interrupt");
    learner.writes("    loop {}");
    let child = learner.command("check snell --time 100s").spawn().unwrap();
    while running(&learner.0) == 0 {
        std::thread::sleep(std::time::Duration::from_millis(10));
    }
    kill_process(Pid::from_child(&child), Signal::INT).unwrap();
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130), "{output:?}");
    assert!(output.stdout.is_empty() && String::from_utf8_lossy(&output.stderr).contains("interrupted"), "{output:?}");
    assert_eq!((running(&learner.0), learner.holds()), (0, vec!["snell.rs".to_owned()]));
}
