//! The learner's program while it runs: asked line by line, and ended when it takes too long, too much, or nobody waits
//! any more.

use super::compile::{Program, Reined};
use super::formula::Answers;
use crate::interrupt::Interrupt;
use std::io::{BufRead, BufReader, Read, Write};
use std::process::{ChildStdin, Command, ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, sync_channel};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

/// Memory that the learner's program may have [KiB].
const MEMORY: u64 = 1 << 20;
/// How long all answers together may take.
const IN_ALL: Duration = Duration::from_secs(60);
/// What it may print beside its answers [byte].
const PRINTED: usize = 1 << 20;
/// How much of that is kept [byte].
const KEPT: usize = 4096;
/// The longest line that is read at once [byte].
const LINE: u64 = 1 << 16;
/// How often it is looked whether somebody wants to end.
const MOMENT: Duration = Duration::from_millis(20);

/// Why there is no answer.
#[derive(Clone, Debug, PartialEq)]
pub enum Fault {
    /// The hole is still there.
    Hole,
    /// It panicked, with this message.
    Panic(String),
    /// It calls itself without end.
    Stack,
    /// It asked for more memory than there is for it.
    Memory,
    /// An answer took longer than this.
    Late(Duration),
    /// All answers together took longer than this.
    LateInAll(Duration),
    /// It printed more than so many bytes.
    Loud(usize),
    /// It ended, in this way.
    Ended(String),
    /// It could not be run or spoken to.
    Lost(String),
    /// Somebody ended the run: their exit code.
    Interrupted(u8),
}

impl Fault {
    /// A word for scripts.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Hole => "hole",
            Self::Panic(_) => "panic",
            Self::Stack => "stack",
            Self::Memory => "memory",
            Self::Late(_) | Self::LateInAll(_) => "time",
            Self::Loud(_) => "output",
            Self::Ended(_) => "end",
            Self::Lost(_) => "lost",
            Self::Interrupted(_) => "interrupted",
        }
    }

    /// What happened.
    pub fn says(&self) -> String {
        match self {
            Self::Hole => "the hole is still there: `todo!()` waits for the formula".into(),
            Self::Panic(message) => format!("panics: {message}"),
            Self::Stack => "its stack overflows: it calls itself without end".into(),
            Self::Memory => format!("asks for more memory than it may have, {} MiB", MEMORY >> 10),
            Self::Late(limit) => format!(
                "no answer within {} s (--time sets another limit); it was ended: a loop without end?",
                limit.as_secs_f64()
            ),
            Self::LateInAll(limit) => {
                format!("all answers together took more than {} s; it was ended", limit.as_secs())
            }
            Self::Loud(limit) => format!("prints more than {limit} bytes; it was ended"),
            Self::Ended(how) => format!("ends the program instead of giving a result ({how})"),
            Self::Lost(why) => format!("cannot be run: {why}"),
            Self::Interrupted(_) => "interrupted".into(),
        }
    }
}

/// What became of a learner's program.
#[derive(Debug, Default)]
pub struct Heard {
    /// Why it stopped answering, and what it had been asked then.
    pub fault: Option<(Fault, Vec<f64>)>,
    /// What it printed beside its answers.
    pub printed: Vec<u8>,
}

/// A learner's program that runs.
pub struct Process {
    child: Option<Reined>,
    stdin: Option<ChildStdin>,
    lines: Receiver<Vec<u8>>,
    stderr: Arc<Mutex<Tail>>,
    marker: Vec<u8>,
    results: usize,
    begun: Instant,
    limit: Duration,
    interrupt: Arc<Interrupt>,
    loudness: usize,
    heard: Arc<Mutex<Heard>>,
    _program: Arc<Program>,
}

/// The end of what was said on standard error.
#[derive(Default)]
struct Tail {
    bytes: Vec<u8>,
    is_whole: bool,
}

impl Process {
    /// Starts `program` to answer for the exercise of that `name` with so many `results` each time, each within `limit`.
    pub fn start(
        program: Arc<Program>,
        name: &str,
        results: usize,
        limit: Duration,
        interrupt: Arc<Interrupt>,
    ) -> Result<Self, String> {
        let marker = marker();
        let mut command = command(&program);
        command.arg(name).arg(&marker).env("RUST_BACKTRACE", "0");
        let spawned = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn();
        let mut child = Reined(spawned.map_err(|error| error.to_string())?);
        let (stdin, stdout, stderr) = (child.0.stdin.take(), child.0.stdout.take(), child.0.stderr.take());
        let (sender, lines) = sync_channel(64);
        // Threads of their own, which nobody waits for: somebody whom the learner's program has started may hold the pipes.
        thread::spawn(move || {
            let mut stdout = BufReader::new(stdout.expect("piped"));
            loop {
                let mut line = Vec::new();
                let read = stdout.by_ref().take(LINE).read_until(b'\n', &mut line);
                if !read.is_ok_and(|read| read > 0) || sender.send(line).is_err() {
                    return;
                }
            }
        });
        let tail = Arc::<Mutex<Tail>>::default();
        let of_thread = Arc::clone(&tail);
        thread::spawn(move || listen(stderr.expect("piped"), &of_thread));
        Ok(Self {
            child: Some(child),
            stdin,
            lines,
            stderr: tail,
            marker: marker.into_bytes(),
            results,
            begun: Instant::now(),
            limit,
            interrupt,
            loudness: 0,
            heard: Arc::default(),
            _program: program,
        })
    }

    /// What is heard of it, now and later.
    pub fn heard(&self) -> Arc<Mutex<Heard>> {
        Arc::clone(&self.heard)
    }

    fn ask(&mut self, numbers: &[f64]) -> Result<Vec<f64>, Fault> {
        let words: Vec<String> = numbers.iter().map(|x| format!("{:x}", x.to_bits())).collect();
        let line = words.join(" ") + "\n";
        let stdin = self.stdin.as_mut().ok_or_else(|| Fault::Lost("it has ended".into()))?;
        if stdin.write_all(line.as_bytes()).and_then(|()| stdin.flush()).is_err() {
            return Err(self.how_it_ended());
        }
        let asked = Instant::now();
        loop {
            match self.lines.recv_timeout(MOMENT) {
                Ok(line) => {
                    let at = line.windows(self.marker.len()).position(|window| window == self.marker);
                    let printed = &line[..at.unwrap_or(line.len())];
                    self.loudness += printed.len();
                    let mut heard = self.heard.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
                    let room = KEPT.saturating_sub(heard.printed.len());
                    heard.printed.extend(&printed[..printed.len().min(room)]);
                    drop(heard);
                    if let Some(at) = at {
                        let answer = parse(&line[at + self.marker.len()..]).filter(|all| all.len() == self.results);
                        return answer.ok_or_else(|| Fault::Lost("its answer cannot be read".into()));
                    }
                    if self.loudness > PRINTED {
                        return Err(Fault::Loud(PRINTED));
                    }
                }
                Err(RecvTimeoutError::Timeout) => {}
                Err(RecvTimeoutError::Disconnected) => return Err(self.how_it_ended()),
            }
            if let Some(code) = self.interrupt.code() {
                return Err(Fault::Interrupted(code));
            }
            if asked.elapsed() > self.limit {
                return Err(Fault::Late(self.limit));
            }
            if self.begun.elapsed() > IN_ALL {
                return Err(Fault::LateInAll(IN_ALL));
            }
        }
    }

    /// How a program ended that answers no more.
    fn how_it_ended(&mut self) -> Fault {
        self.stdin = None;
        let Some(child) = self.child.as_mut() else { return Fault::Lost("it has ended".into()) };
        let (mut status, patience) = (None, Instant::now());
        // Both its end and its last words may be a moment behind.
        while patience.elapsed() < Duration::from_secs(1) {
            status = child.0.try_wait().ok().flatten();
            let is_whole = self.stderr.lock().is_ok_and(|tail| tail.is_whole);
            if status.is_some() && is_whole {
                break;
            }
            thread::sleep(Duration::from_millis(2));
        }
        if let Some(code) = self.interrupt.code() {
            return Fault::Interrupted(code);
        }
        let said = self.stderr.lock().map(|tail| String::from_utf8_lossy(&tail.bytes).into_owned()).unwrap_or_default();
        judged(status, &said)
    }
}

impl Answers for Process {
    fn answer(&mut self, numbers: &[f64]) -> Option<Vec<f64>> {
        match self.ask(numbers) {
            Ok(results) => Some(results),
            Err(fault) => {
                // It is ended here and now.
                self.child = None;
                let mut heard = self.heard.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
                heard.fault = Some((fault, numbers.to_vec()));
                None
            }
        }
    }
}

/// A word that the learner's program cannot know.
fn marker() -> String {
    use std::hash::{BuildHasher, RandomState};
    format!("answer-{:016x}:", RandomState::new().hash_one(std::process::id()))
}

/// The program, with limits of memory and of the processor's time that hold even if we are killed.
#[cfg(unix)]
fn command(program: &Program) -> Command {
    let mut command = Command::new("/bin/sh");
    let limits = format!(
        "ulimit -v {MEMORY} 2>/dev/null; ulimit -c 0 2>/dev/null; ulimit -t {} 2>/dev/null; exec \"$0\" \"$@\"",
        IN_ALL.as_secs() + 10
    );
    command.arg("-c").arg(limits).arg(&program.path);
    command
}

#[cfg(not(unix))]
fn command(program: &Program) -> Command {
    Command::new(&program.path)
}

/// Keeps the end of what is said.
fn listen(mut stderr: impl Read, tail: &Mutex<Tail>) {
    let mut buffer = [0; 4096];
    while let Ok(read @ 1..) = stderr.read(&mut buffer) {
        let Ok(mut tail) = tail.lock() else { return };
        tail.bytes.extend(&buffer[..read]);
        let surplus = tail.bytes.len().saturating_sub(KEPT);
        tail.bytes.drain(..surplus);
    }
    if let Ok(mut tail) = tail.lock() {
        tail.is_whole = true;
    }
}

/// The numbers of an answer.
fn parse(words: &[u8]) -> Option<Vec<f64>> {
    let words = std::str::from_utf8(words).ok()?;
    words.split_whitespace().map(|word| u64::from_str_radix(word, 16).ok().map(f64::from_bits)).collect()
}

/// What an end with these last words was.
fn judged(status: Option<ExitStatus>, said: &str) -> Fault {
    if said.contains("has overflowed its stack") {
        return Fault::Stack;
    }
    if said.contains("memory allocation of") || said.contains("capacity overflow") {
        return Fault::Memory;
    }
    if let Some((_, panic)) = said.rsplit_once("panicked at ") {
        let mut lines = panic.lines();
        lines.next();
        let message: Vec<&str> = lines.take_while(|line| !line.starts_with("note: ")).collect();
        let message = message.join(" ");
        return match message.starts_with("not yet implemented") {
            true => Fault::Hole,
            false => Fault::Panic(message.trim().to_owned()),
        };
    }
    // What a shell says of what it cannot run: a folder, say, in which nothing may be run.
    if status.is_some_and(|status| matches!(status.code(), Some(126 | 127))) {
        return Fault::Lost(said.trim().to_owned());
    }
    Fault::Ended(status.map_or("it went silent".into(), |status| status.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn last_words_are_understood() {
        let told = |said: &str| judged(None, said);
        let panic =
            "\nthread 'main' (7) panicked at yours.rs:3:5:\nindex 3 is too large\nnote: run with `RUST_BACKTRACE=1`";
        assert_eq!(told(panic), Fault::Panic("index 3 is too large".into()));
        assert_eq!(told("thread 'main' panicked at a.rs:1:1:\nnot yet implemented: the formula"), Fault::Hole);
        assert_eq!(told("thread 'main' has overflowed its stack\nfatal runtime error"), Fault::Stack);
        assert_eq!(told("memory allocation of 8 bytes failed"), Fault::Memory);
        assert_eq!(told("whatever"), Fault::Ended("it went silent".into()));
    }

    #[test]
    fn answers_are_bit_patterns() {
        let all = [0.0, -0.0, 1.5e-308, f64::INFINITY];
        let words: Vec<String> = all.iter().map(|x: &f64| format!("{:x}", x.to_bits())).collect();
        let read = parse(words.join(" ").as_bytes()).unwrap();
        assert_eq!(read.iter().map(|x| x.to_bits()).collect::<Vec<_>>(), all.map(f64::to_bits));
        assert!(parse(b"3ff0000000000000\n").is_some_and(|one| one == [1.0]));
        assert_eq!((parse(b"xyz"), parse(&[0xff])), (None, None));
        assert_ne!(marker(), marker());
    }
}
