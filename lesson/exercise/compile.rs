//! The learner's file as a program that answers: each line of numbers on its standard input with a line of numbers.
//!
//! Numbers are bit patterns, so that nothing is lost; an answer stands behind a word that nobody else knows, so that the
//! function may print what it likes.

use super::vocabulary::{Exercise, Kind};
use crate::interrupt::Interrupt;
use crate::out::Folder;
use crate::stop::Stop;
use std::ffi::OsString;
use std::fs;
use std::io::{ErrorKind, Read};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

/// How long the compiler may take.
const PATIENCE: Duration = Duration::from_secs(120);
/// How often it is asked whether it is done.
const MOMENT: Duration = Duration::from_millis(4);
/// How many lines of the compiler's are shown.
const SHOWN: usize = 60;
/// The largest file that is taken [byte].
const LARGEST: u64 = 1 << 20;
/// What the program is made from, beside the learner's files.
const ASKED: &str = "asked.rs";

/// A program made from learners' files, as long as it is held.
pub struct Program {
    /// The executable.
    pub path: PathBuf,
    /// Held for what it takes with it.
    _folder: Folder,
}

/// An exercise and a file for it: its text, and what it is called when something is said of it.
pub struct Source<'s> {
    pub exercise: &'s Exercise,
    pub text: &'s str,
    pub called: String,
}

/// The text of a learner's file.
pub fn read(path: &Path) -> Result<String, Stop> {
    let refuse = |why: &dyn std::fmt::Display| Stop::at(path.display(), format!("cannot be read: {why}"));
    let about = fs::metadata(path).map_err(|error| refuse(&error))?;
    if !about.is_file() {
        return Err(refuse(&"it is no file"));
    }
    if about.len() > LARGEST {
        return Err(refuse(&format!("it has {} bytes; valid: up to {LARGEST}", about.len())));
    }
    let bytes = fs::read(path).map_err(|error| refuse(&error))?;
    String::from_utf8(bytes).map_err(|_| refuse(&"it is no text in UTF-8"))
}

/// Compiles `sources` into one program that answers for each of them by its exercise's name.
pub fn program(sources: &[Source], interrupt: &Interrupt) -> Result<Program, Stop> {
    let temporary = std::path::absolute(std::env::temp_dir()).map_err(|error| Stop::at("temporary folder", error))?;
    let folder = Folder::open(&temporary)?;
    let place = folder.scratch().to_owned();
    let put = |name: &str, text: &str| {
        fs::write(place.join(name), text).map_err(|error| Stop::at(place.join(name).display(), error))
    };
    for source in sources {
        put(&file(source.exercise), source.text)?;
    }
    put(ASKED, &wrapper(sources.iter().map(|source| source.exercise)))?;
    let path = place.join(format!("answers{}", std::env::consts::EXE_SUFFIX));
    // In a folder without a toolchain file, which might ask for a toolchain that would have to be fetched.
    let mut command = Command::new(compiler());
    command.args(["--edition", "2024", "-O", "-C", "overflow-checks=on", "-A", "warnings", "--crate-name", "answers"]);
    command.args(["--color", "never", "-o"]).arg(&path).arg(ASKED).current_dir(&place);
    let (succeeded, said) = compile(command, interrupt)?;
    if succeeded {
        return Ok(Program { path, _folder: folder });
    }
    let called: Vec<&str> = sources.iter().map(|source| source.called.as_str()).collect();
    let mut said = said;
    for source in sources {
        said = said.replace(&file(source.exercise), &source.called);
    }
    let lines: Vec<&str> = said.lines().collect();
    let mut shown = lines[..lines.len().min(SHOWN)].join("\n");
    if lines.len() > SHOWN {
        shown += &format!("\n… and {} lines more", lines.len() - SHOWN);
    }
    // What is wrong where the function is called is wrong with its face.
    if said.contains(ASKED) {
        let faces: Vec<String> = sources.iter().map(|source| source.exercise.signature()).collect();
        shown += &format!("\nthe function must be: {}", faces.join(", "));
    }
    Err(Stop::at(called.join(", "), format!("does not compile\n{shown}")))
}

/// The compiler: the one that cargo's users choose by the same word, or the one on the path.
fn compiler() -> OsString {
    std::env::var_os("RUSTC").filter(|name| !name.is_empty()).unwrap_or_else(|| "rustc".into())
}

/// Runs the compiler to its end: whether it succeeded, and what it said.
fn compile(mut command: Command, interrupt: &Interrupt) -> Result<(bool, String), Stop> {
    let named = || compiler().to_string_lossy().into_owned();
    let child = command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped()).spawn();
    let mut compiler = Reined(child.map_err(|error| match error.kind() {
        ErrorKind::NotFound => {
            Stop::at(named(), "no Rust compiler of that name; https://rustup.rs tells how to get one, or set RUSTC")
        }
        _ => Stop::at(named(), format!("cannot be run: {error}")),
    })?);
    let stderr = compiler.0.stderr.take().expect("piped");
    let begun = Instant::now();
    let reader = thread::spawn(move || {
        let mut said = Vec::new();
        let mut stderr = stderr.take(LARGEST);
        let _ = stderr.read_to_end(&mut said);
        // What is beyond is heard, or the compiler would wait for ever to say it.
        let _ = std::io::copy(&mut stderr.into_inner(), &mut std::io::sink());
        String::from_utf8_lossy(&said).into_owned()
    });
    let status = loop {
        match compiler.0.try_wait().map_err(|error| Stop::at(named(), error))? {
            Some(status) => break status,
            None if begun.elapsed() > PATIENCE => {
                return Err(Stop::at(named(), format!("not done after {} s, and ended", PATIENCE.as_secs())));
            }
            None => {}
        }
        if let Some(code) = interrupt.code() {
            return Err(Stop::Interrupted(code));
        }
        thread::sleep(MOMENT);
    };
    if let Some(code) = interrupt.code() {
        return Err(Stop::Interrupted(code));
    }
    Ok((status.success(), reader.join().unwrap_or_default()))
}

/// A process that ends with whoever holds it.
pub struct Reined(pub Child);

impl Drop for Reined {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// What an exercise's file is called beside the wrapper.
fn file(exercise: &Exercise) -> String {
    format!("{}.rs", module(exercise))
}

fn module(exercise: &Exercise) -> String {
    exercise.name.replace('-', "_")
}

/// The program round the learners' functions.
fn wrapper<'e>(exercises: impl Iterator<Item = &'e Exercise>) -> String {
    let (mut modules, mut arms) = (String::new(), String::new());
    for exercise in exercises {
        let (module, function) = (module(exercise), exercise.function);
        let kinds: Vec<&str> = exercise.takes.iter().map(|one| one.kind.rust()).collect();
        let (mut at, mut arguments) = (0, Vec::new());
        for taken in exercise.takes {
            arguments.push(match taken.kind {
                Kind::Real => format!("x[{at}]"),
                Kind::Whole => format!("x[{at}] as u32"),
                Kind::Triple => format!("[x[{at}], x[{}], x[{}]]", at + 1, at + 2),
            });
            at += taken.kind.numbers();
        }
        let (kinds, arguments, gives) = (kinds.join(", "), arguments.join(", "), exercise.gives.kind.rust());
        let given = if exercise.gives.kind == Kind::Triple { "y.to_vec()" } else { "vec![y]" };
        modules += &format!("mod {module};\n");
        arms += &format!(
            "        \"{name}\" => |x| {{\n            let f: fn({kinds}) -> {gives} = {module}::{function};\n            \
             let y = f({arguments});\n            {given}\n        }},\n",
            name = exercise.name
        );
    }
    format!(
        "{modules}\nfn main() {{\n    use std::io::{{BufRead, Write}};\n    \
         let words: Vec<String> = std::env::args().collect();\n    \
         let answer: fn(&[f64]) -> Vec<f64> = match words[1].as_str() {{\n{arms}        \
         _ => std::process::exit(3),\n    }};\n    \
         for line in std::io::stdin().lock().lines() {{\n        let Ok(line) = line else {{ return }};\n        \
         let number = |word: &str| f64::from_bits(u64::from_str_radix(word, 16).expect(\"bits\"));\n        \
         let x: Vec<f64> = line.split_whitespace().map(number).collect();\n        \
         let y: Vec<String> = answer(&x).iter().map(|y| format!(\"{{:x}}\", y.to_bits())).collect();\n        \
         let mut out = std::io::stdout().lock();\n        \
         if writeln!(out, \"{{}} {{}}\", words[2], y.join(\" \")).and_then(|()| out.flush()).is_err() {{ return }}\n    \
         }}\n}}\n"
    )
}
