//! The reader in a terminal that is none: what stands on the screen, whatever bytes put it there.
#![cfg(unix)]

#[allow(dead_code, reason = "each test file uses its part")]
mod common;

use common::{command, folder};
use rustix::process::{Pid, Signal, kill_process};
use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use rustix::termios::{Winsize, tcsetwinsize};
use std::fs::File;
use std::io::{Read, Write};
use std::num::NonZeroU16;
use std::path::Path;
use std::process::{Child, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

/// How long anything may take before the test gives up: nothing is judged by it.
const PATIENCE: Duration = Duration::from_secs(120);

/// What every frame ends with.
const FRAME_END: &[u8] = b"\x1b[?2026l";

/// The program in a terminal.
struct Terminal {
    child: Child,
    master: File,
    bytes: Receiver<Vec<u8>>,
    parser: vt100::Parser,
    /// The last bytes that came: a frame is whole where it says so.
    tail: Vec<u8>,
    /// All that came.
    sent: Vec<u8>,
}

impl Terminal {
    fn open(arguments: &str, (columns, rows): (u16, u16), state: &Path) -> Self {
        Self::with(arguments, (columns, rows), state, &[])
    }

    fn with(arguments: &str, (columns, rows): (u16, u16), state: &Path, environment: &[(&str, &str)]) -> Self {
        let master = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY).unwrap();
        grantpt(&master).unwrap();
        unlockpt(&master).unwrap();
        tcsetwinsize(&master, size(columns, rows)).unwrap();
        let name = ptsname(&master, Vec::new()).unwrap().into_string().unwrap();
        let end = || Stdio::from(File::options().read(true).write(true).open(&name).unwrap());
        let arguments: Vec<_> = arguments.split_whitespace().collect();
        let mut command = command(&arguments);
        command.stdin(end()).stdout(end()).stderr(end());
        command.env("XDG_STATE_HOME", state).env("TERM", "xterm-256color").env_remove("NO_COLOR");
        // Whatever terminal the tests are run in.
        command.env("LESSON_GRAPHICS", "none");
        command.envs(environment.iter().copied());
        let child = command.spawn().unwrap();
        // The ends that the command holds would keep the terminal open for ever.
        drop(command);
        let master = File::from(master);
        let mut reader = master.try_clone().unwrap();
        let (sender, bytes) = channel();
        std::thread::spawn(move || {
            let mut buffer = [0; 1 << 16];
            while let Ok(count @ 1..) = reader.read(&mut buffer) {
                if sender.send(buffer[..count].to_vec()).is_err() {
                    break;
                }
            }
        });
        let lines = |count| NonZeroU16::new(count).unwrap();
        Self {
            child,
            master,
            bytes,
            parser: vt100::Parser::new(lines(rows), lines(columns), 0),
            tail: Vec::new(),
            sent: Vec::new(),
        }
    }

    fn screen(&self) -> String {
        self.parser.screen().contents()
    }

    /// The bar at the bottom.
    fn bar(&self) -> String {
        self.screen().lines().last().unwrap_or_default().to_owned()
    }

    fn press(&mut self, keys: &str) {
        self.master.write_all(keys.as_bytes()).unwrap();
    }

    /// Waits until the screen is as it should be.
    fn until(&mut self, what: &str, is_so: impl Fn(&Self) -> bool) {
        let begun = Instant::now();
        while self.tail != FRAME_END || !is_so(self) {
            match self.bytes.recv_timeout(Duration::from_secs(1)) {
                Ok(bytes) => {
                    self.parser.process(&bytes);
                    self.sent.extend(&bytes);
                    self.tail.extend(bytes);
                    self.tail.drain(..self.tail.len().saturating_sub(FRAME_END.len()));
                }
                Err(_) if begun.elapsed() < PATIENCE && self.child.try_wait().unwrap().is_none() => {}
                Err(_) => panic!("{what} did not come:\n{}", self.screen()),
            }
        }
    }

    /// How often something was sent.
    fn count(&self, what: &str) -> usize {
        self.sent.windows(what.len()).filter(|part| *part == what.as_bytes()).count()
    }

    fn shows(&mut self, text: &str) {
        self.until(text, |terminal| terminal.screen().contains(text));
    }

    fn resize(&mut self, columns: u16, rows: u16) {
        let lines = |count| NonZeroU16::new(count).unwrap();
        self.parser.screen_mut().set_size(lines(rows), lines(columns));
        tcsetwinsize(&self.master, size(columns, rows)).unwrap();
        // The test's own terminal is nobody's controlling one, which would tell its processes.
        self.signal(Signal::WINCH);
    }

    fn signal(&self, signal: Signal) {
        kill_process(Pid::from_child(&self.child), signal).unwrap();
    }

    /// Waits for the end: the exit code, and whether the terminal is as it was.
    fn end(mut self) -> (i32, String) {
        let begun = Instant::now();
        let code = loop {
            while let Ok(bytes) = self.bytes.recv_timeout(Duration::from_millis(20)) {
                self.parser.process(&bytes);
            }
            match self.child.try_wait().unwrap() {
                Some(status) => break status.code().unwrap_or(-1),
                None => assert!(begun.elapsed() < PATIENCE, "does not end:\n{}", self.screen()),
            }
        };
        // To the end of what there is: with the program its end of the terminal is closed.
        while let Ok(bytes) = self.bytes.recv_timeout(PATIENCE) {
            self.parser.process(&bytes);
        }
        let screen = self.parser.screen();
        assert!(!screen.alternate_screen() && !screen.hide_cursor(), "the terminal is not as it was");
        assert_eq!(screen.mouse_protocol_mode(), vt100::MouseProtocolMode::None);
        (code, screen.contents())
    }
}

impl Drop for Terminal {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn size(columns: u16, rows: u16) -> Winsize {
    Winsize { ws_row: rows, ws_col: columns, ws_xpixel: 0, ws_ypixel: 0 }
}

#[test]
fn a_chapter_is_walked_at_three_sizes() {
    let chapter = chapters::CURRICULUM.iter().find(|chapter| chapter.id == "poynting").unwrap();
    let last = chapter.steps.len();
    for (columns, rows) in [(40, 20), (80, 24), (120, 40)] {
        let state = folder(&format!("reader-{columns}"));
        let mut terminal = Terminal::open("poynting", (columns, rows), &state);
        terminal.until("the first step", |terminal| terminal.bar().contains(&format!("1/{last}")));
        let is_end = |terminal: &Terminal| {
            let bar = terminal.bar();
            bar.contains(&format!("{last}/{last}")) && bar.contains(" end ")
        };
        let mut seen = vec![terminal.screen()];
        for _ in 0..120 {
            if is_end(&terminal) {
                break;
            }
            // What is drawn meanwhile changes the screen too.
            terminal.until("the figures", |terminal| !terminal.bar().contains('⋯'));
            let before = terminal.bar();
            terminal.press(" ");
            terminal.until("another screen", |terminal| terminal.bar().replace('⋯', " ") != before.replace('⋯', " "));
            seen.push(terminal.screen());
        }
        assert!(is_end(&terminal), "{}", terminal.screen());
        // Every step was there, and nothing of a claim was lost on the way.
        let seen = seen.concat().split_whitespace().collect::<Vec<_>>().join(" ");
        for step in chapter.steps {
            let title = step.title.split_whitespace().collect::<Vec<_>>().join(" ");
            assert!(seen.contains(&title), "{title}: {seen}");
        }
        terminal.press("q");
        let (code, after) = terminal.end();
        assert_eq!(code, 0);
        assert!(after.contains(" passed, 0 failed"), "{after}");
    }
}

#[test]
fn a_reader_goes_sets_races_leaves_and_comes_back() {
    let state = folder("reader-session");
    let mut terminal = Terminal::open("fresnel snell", (80, 24), &state);
    terminal.shows("fresnel/snell");
    terminal.press("gbrewster");
    terminal.shows("Go to: brewster");
    terminal.press("\r");
    terminal.until("the step", |terminal| terminal.bar().contains("fresnel/brewster"));
    // A parameter is set, and what is out of its domain is not.
    terminal.press("s");
    terminal.shows("› ");
    terminal.press("\x1b[B2.4\r");
    terminal.shows("n_t=2.4");
    terminal.press("-7\r");
    terminal.shows("valid");
    assert!(terminal.screen().contains("n_t=2.4"), "{}", terminal.screen());
    terminal.press("\x1b");
    terminal.until("the panel to close", |terminal| terminal.bar().contains("? keys"));
    terminal.resize(100, 30);
    terminal.until("the new size", |terminal| {
        terminal.screen().lines().count() == 30 && terminal.bar().contains("space on")
    });
    // The race runs behind the page, and is drawn when it is done.
    terminal.press("gnatural\r");
    terminal.until("the step", |terminal| terminal.bar().contains("fresnel/natural"));
    // On without an answer.
    terminal.press(" ");
    terminal.until("the rest", |terminal| !terminal.bar().contains("answers"));
    terminal.press("r");
    terminal.shows("ns per work");
    terminal.press("/");
    terminal.press("walsh\r");
    terminal.until("what was searched for", |terminal| terminal.bar().contains(" of "));
    terminal.press("\x1b");
    terminal.until("the search to end", |terminal| terminal.bar().contains("g go to"));
    terminal.press("q");
    assert_eq!(terminal.end().0, 0);
    let mut again = Terminal::open("fresnel", (80, 24), &state);
    again.until("the place", |terminal| terminal.bar().contains("fresnel/natural"));
    again.press("q");
    assert_eq!(again.end().0, 0);
    let progress = command(&["progress"]).env("XDG_STATE_HOME", &state).output().unwrap();
    let progress = String::from_utf8(progress.stdout).unwrap();
    let line = progress.lines().find(|line| line.starts_with("fresnel")).unwrap();
    assert!(line.contains(" 3 of 17 steps   0 of ") && line.ends_with(" exercises   at natural"), "{progress}");
}

#[test]
fn a_question_is_answered_and_remembered() {
    let state = folder("reader-question");
    let mut terminal = Terminal::open("fresnel brewster", (80, 24), &state);
    terminal.shows("or space to go on without");
    terminal.press("1");
    terminal.shows("Your answer: 1)");
    terminal.press("q");
    terminal.end();
    let mut again = Terminal::open("fresnel brewster", (80, 24), &state);
    again.shows("Your answer: 1)");
    again.press("\x03");
    assert_eq!(again.end().0, 0);
}

#[test]
fn signals_and_damaged_memories_leave_everything_as_it_was() {
    let state = folder("reader-signal");
    std::fs::create_dir_all(state.join("lesson")).unwrap();
    std::fs::write(state.join("lesson/reader.json"), "{ damaged").unwrap();
    let mut terminal = Terminal::open("poynting", (80, 24), &state);
    terminal.shows("what was remembered is damaged");
    terminal.signal(Signal::TERM);
    let (code, after) = terminal.end();
    assert_eq!(code, 128 + 15);
    assert!(after.contains("passed, 0 failed"), "{after}");
}

#[test]
fn small_terminals_are_told_and_dumb_ones_get_everything_at_once() {
    let state = folder("reader-small");
    let mut terminal = Terminal::open("poynting", (30, 10), &state);
    terminal.shows("too small");
    terminal.resize(80, 24);
    terminal.until("the page", |terminal| terminal.bar().contains("poynting"));
    terminal.press("q");
    assert_eq!(terminal.end().0, 0);
    let terminal = Terminal::with("poynting flow", (80, 24), &state, &[("TERM", "dumb")]);
    let (code, text) = terminal.end();
    assert_eq!(code, 0);
    assert!(text.contains(" passed, 0 failed") && !text.contains("space on"), "{text}");
}

#[test]
fn terminals_that_draw_are_told_of_pictures_row_by_row() {
    for (protocol, begins) in
        [("kitty", "\x1b_Ga=T,f=100,c="), ("iterm2", "\x1b]1337;File=size="), ("sixel", "\x1bP0;1;0q\"1;1;")]
    {
        let state = folder(&format!("reader-{protocol}"));
        let mut terminal = Terminal::with("fresnel r_s", (80, 40), &state, &[("LESSON_GRAPHICS", protocol)]);
        terminal.until("the page", |terminal| terminal.bar().contains("fresnel/r_s"));
        terminal.press(" ");
        terminal.until("the rest", |terminal| !terminal.bar().contains("answers"));
        terminal.press("f");
        terminal.until("the figure", |terminal| terminal.count(begins) > 10);
        // No half blocks, and of what is sent nothing reads as text.
        let screen = terminal.screen();
        assert!(!screen.contains('▀') && !screen.contains("iVBOR") && !screen.contains("1337"), "{protocol}: {screen}");
        // Gone with the step: in kitty's protocol they would stay.
        let before = terminal.count("\x1b_Ga=d,d=");
        terminal.press("n");
        terminal.until("the next step", |terminal| !terminal.bar().contains("fresnel/r_s"));
        assert_eq!(protocol == "kitty", terminal.count("\x1b_Ga=d,d=") > before, "{protocol}");
        terminal.press("q");
        assert_eq!(terminal.end().0, 0, "{protocol}");
    }
    // One that cannot be known is refused before the terminal is touched.
    let state = folder("reader-graphics");
    let (code, text) = Terminal::with("fresnel r_s", (80, 24), &state, &[("LESSON_GRAPHICS", "regis")]).end();
    assert_eq!(code, 2);
    assert!(text.contains("LESSON_GRAPHICS") && text.contains("kitty, iterm2, sixel or none"), "{text}");
}

#[test]
fn without_colours_nothing_is_coloured() {
    let state = folder("reader-plain");
    let mut terminal = Terminal::with("fresnel r_s", (80, 24), &state, &[("NO_COLOR", "1")]);
    terminal.until("the page", |terminal| terminal.bar().contains("fresnel/r_s"));
    terminal.press(" ");
    terminal.until("the rest", |terminal| !terminal.bar().contains("answers"));
    let before = terminal.screen();
    terminal.press("f");
    terminal.until("the figure", |terminal| terminal.screen() != before && !terminal.screen().contains("drawing"));
    let screen = terminal.parser.screen();
    let cells = (0..24).flat_map(|row| (0..80).map(move |column| (row, column)));
    for cell in cells.filter_map(|(row, column)| screen.cell(row, column)) {
        assert_eq!((cell.fgcolor(), cell.bgcolor()), (vt100::Color::Default, vt100::Color::Default));
    }
    terminal.press("q");
    terminal.end();
}
