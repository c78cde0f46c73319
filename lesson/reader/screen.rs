//! The terminal: how lines are painted, and that it is as it was when the reader is left, however that happens.

use super::event::{Event, Key};
use super::graphics::Protocol;
use super::state::Line;
use crossterm::event::{
    self as terminal, DisableMouseCapture, EnableMouseCapture, KeyCode, KeyEventKind, KeyModifiers,
};
use crossterm::style::Print;
use crossterm::terminal::{
    BeginSynchronizedUpdate, Clear, ClearType, DisableLineWrap, EnableLineWrap, EndSynchronizedUpdate,
    EnterAlternateScreen, LeaveAlternateScreen, disable_raw_mode, enable_raw_mode,
};
use crossterm::{cursor, execute, queue};
use std::io::{self, BufWriter, Stdout, Write, stdout};
use std::panic;
use std::sync::mpsc::Sender;
use std::thread;
use views::block::{Cell, Tone};
use views::page::{Row, ansi};

/// How many colours the terminal shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Colours {
    /// None, or none are wanted.
    None,
    /// The 256 of xterm.
    Indexed,
    /// All.
    True,
}

impl Colours {
    /// What the environment says.
    pub fn of_terminal() -> Self {
        let is = |name: &str, words: &[&str]| {
            std::env::var(name).is_ok_and(|value| words.iter().any(|word| value.to_lowercase().contains(word)))
        };
        if !crate::out::is_coloured() {
            Self::None
        } else if is("COLORTERM", &["truecolor", "24bit"])
            || is("TERM", &["direct", "kitty", "alacritty", "ghostty"])
            || is("TERM_PROGRAM", &["iterm", "wezterm", "vscode", "ghostty"])
            || std::env::var_os("WT_SESSION").is_some()
        {
            Self::True
        } else {
            Self::Indexed
        }
    }
}

/// The terminal as the reader uses it; dropped, it is as it was.
pub struct Screen {
    out: BufWriter<Stdout>,
    colours: Colours,
    /// How it is told of pictures, if it draws them.
    protocol: Option<Protocol>,
    /// What stands on it, line by line.
    shown: Vec<String>,
}

impl Screen {
    /// Takes the terminal over.
    pub fn open(colours: Colours) -> io::Result<Self> {
        restore_on_panic();
        enable_raw_mode()?;
        let screen = Self { out: BufWriter::new(stdout()), colours, protocol: None, shown: Vec::new() };
        execute!(stdout(), EnterAlternateScreen, EnableMouseCapture, DisableLineWrap, cursor::Hide)?;
        Ok(screen)
    }

    /// From now on pictures are drawn so.
    pub fn draw_by(&mut self, protocol: Option<Protocol>) {
        self.protocol = protocol;
    }

    /// Shows lines; those that are there already are not written again.
    pub fn show(&mut self, lines: &[Line]) -> io::Result<()> {
        let painted: Vec<String> = lines.iter().map(|line| paint(line, self.colours)).collect();
        queue!(self.out, BeginSynchronizedUpdate)?;
        if painted.len() != self.shown.len() {
            self.shown.clear();
            queue!(self.out, Print(self.protocol.map_or("", Protocol::all_erased)), Clear(ClearType::All))?;
        }
        // Cleared first: the cursor of a line that is full stays on its last letter, which clearing would take.
        for (at, line) in painted.iter().enumerate().filter(|(at, line)| self.shown.get(*at) != Some(line)) {
            if let Some(protocol) = self.protocol {
                queue!(self.out, Print(protocol.erased(at)))?;
            }
            queue!(self.out, cursor::MoveTo(0, at as u16), Clear(ClearType::CurrentLine), Print(line))?;
        }
        queue!(self.out, EndSynchronizedUpdate)?;
        self.shown = painted;
        self.out.flush()
    }

    /// What stands on the screen may have been disturbed: all of it is written again.
    pub fn forget(&mut self) {
        self.shown.clear();
    }
}

impl Drop for Screen {
    fn drop(&mut self) {
        // A panic has given it back already.
        if !thread::panicking() {
            let _ = queue!(self.out, Print(self.protocol.map_or("", Protocol::all_erased)));
            let _ = self.out.flush();
            restore();
        }
    }
}

/// Gives the terminal back. More cannot be done where that fails.
fn restore() {
    let _ = execute!(stdout(), DisableMouseCapture, EnableLineWrap, cursor::Show, LeaveAlternateScreen);
    let _ = disable_raw_mode();
}

/// A panic of the reader itself gives the terminal back before it is told; one of those that work for it is theirs to
/// report.
fn restore_on_panic() {
    let (own, told) = (thread::current().id(), panic::take_hook());
    panic::set_hook(Box::new(move |panicked| {
        if thread::current().id() == own {
            restore();
            told(panicked);
        }
    }));
}

/// Sends what happens at the terminal, until nobody listens or nothing more can come.
pub fn listen(events: Sender<Event>) {
    thread::spawn(move || {
        loop {
            let event = match terminal::read() {
                Ok(event) => translated(&event),
                Err(error) if error.kind() == io::ErrorKind::Interrupted => None,
                Err(_) => Some(Event::Gone),
            };
            let is_gone = matches!(event, Some(Event::Gone));
            if event.is_some_and(|event| events.send(event).is_err()) || is_gone {
                return;
            }
        }
    });
}

fn translated(event: &terminal::Event) -> Option<Event> {
    match event {
        terminal::Event::Key(key) if key.kind != KeyEventKind::Release => {
            pressed(key.code, key.modifiers).map(Event::Key)
        }
        terminal::Event::Mouse(mouse) => match mouse.kind {
            terminal::MouseEventKind::ScrollDown => Some(Event::Wheel(1)),
            terminal::MouseEventKind::ScrollUp => Some(Event::Wheel(-1)),
            _ => None,
        },
        terminal::Event::Resize(columns, rows) => Some(Event::Resize((*columns).into(), (*rows).into())),
        _ => None,
    }
}

fn pressed(code: KeyCode, held: KeyModifiers) -> Option<Key> {
    let shift = held.contains(KeyModifiers::SHIFT);
    Some(match code {
        KeyCode::Char('c' | 'd') if held.contains(KeyModifiers::CONTROL) => Key::Interrupt,
        KeyCode::Char('h') if held.contains(KeyModifiers::CONTROL) => Key::Backspace,
        KeyCode::Char(_) if held.intersects(KeyModifiers::CONTROL | KeyModifiers::ALT) => return None,
        KeyCode::Char(letter) => Key::Char(letter),
        KeyCode::Enter => Key::Enter,
        KeyCode::Esc => Key::Escape,
        KeyCode::Backspace | KeyCode::Delete => Key::Backspace,
        KeyCode::Tab => Key::Tab,
        KeyCode::Up => Key::Up,
        KeyCode::Down => Key::Down,
        KeyCode::Left => Key::Left { shift },
        KeyCode::Right => Key::Right { shift },
        KeyCode::PageUp => Key::PageUp,
        KeyCode::PageDown => Key::PageDown,
        KeyCode::Home => Key::Home,
        KeyCode::End => Key::End,
        _ => return None,
    })
}

/// A line with the signs that colour it.
fn paint(line: &Line, colours: Colours) -> String {
    let mut painted = " ".repeat(line.margin);
    match &line.row {
        Row::Text(pieces) if line.is_bar => {
            let text: String = pieces.iter().map(|(_, text)| text.as_str()).collect();
            painted.push_str(&format!("\x1b[7m{text}\x1b[0m"));
        }
        Row::Text(pieces) => {
            let mut at = 0;
            for (tone, text) in pieces {
                for letters in stretches(text, at, line) {
                    let sign = sign(*tone, letters.1, colours);
                    match sign.as_str() {
                        "" => painted.push_str(&letters.0),
                        sign => painted.push_str(&format!("\x1b[{sign}m{}\x1b[0m", letters.0)),
                    }
                }
                at += text.chars().count();
            }
        }
        Row::Picture(cells) => paint_cells(&mut painted, cells, colours),
        Row::Strip(told) => painted.push_str(told),
    }
    painted
}

/// The text in stretches of letters that were all searched for, or none of them; `at` is its first letter's place.
fn stretches(text: &str, at: usize, line: &Line) -> Vec<(String, bool)> {
    let mut stretches: Vec<(String, bool)> = Vec::new();
    for (place, letter) in text.chars().enumerate().map(|(place, letter)| (at + place, letter)) {
        let is_marked = line.marks.iter().any(|range| range.contains(&place));
        match stretches.last_mut() {
            Some((letters, marked)) if *marked == is_marked => letters.push(letter),
            _ => stretches.push((letter.to_string(), is_marked)),
        }
    }
    stretches
}

/// The parameters of "select graphic rendition" for a tone; without colours, those that are none.
fn sign(tone: Tone, is_marked: bool, colours: Colours) -> String {
    let is_colour = |part: &&str| part.len() == 2 && part.starts_with('3');
    let parts = ansi(tone).split(';').filter(|part| !part.is_empty());
    let parts = parts.filter(|part| colours != Colours::None || !is_colour(part));
    parts.chain(is_marked.then_some("7")).collect::<Vec<_>>().join(";")
}

fn paint_cells(painted: &mut String, cells: &[Cell], colours: Colours) {
    for run in cells.chunk_by(|a, b| (a.ink, a.paper) == (b.ink, b.paper)) {
        let text: String = run.iter().map(|cell| cell.symbol).collect();
        let parts: Vec<String> = [(38, run[0].ink), (48, run[0].paper)]
            .into_iter()
            .filter_map(|(ground, colour)| Some(coloured(ground, colour?, colours)))
            .collect();
        match parts.is_empty() {
            true => painted.push_str(&text),
            false => painted.push_str(&format!("\x1b[{}m{text}\x1b[0m", parts.join(";"))),
        }
    }
}

fn coloured(ground: u8, colour: [u8; 3], colours: Colours) -> String {
    let [red, green, blue] = colour;
    match colours {
        Colours::True | Colours::None => format!("{ground};2;{red};{green};{blue}"),
        Colours::Indexed => format!("{ground};5;{}", indexed(colour)),
    }
}

/// Levels of a side of xterm's cube of colours.
const LEVELS: [u8; 6] = [0, 95, 135, 175, 215, 255];

/// The nearest of xterm's 256 colours: of its cube of six levels a side or its greys.
fn indexed(colour: [u8; 3]) -> u8 {
    nearest_of_all(colour).0
}

/// The same as a colour.
pub(super) fn nearest(colour: [u8; 3]) -> [u8; 3] {
    nearest_of_all(colour).1
}

fn nearest_of_all(colour: [u8; 3]) -> (u8, [u8; 3]) {
    let step = |part: u8| (0..6).min_by_key(|level| LEVELS[*level].abs_diff(part)).unwrap_or(0);
    let [red, green, blue] = colour.map(step);
    let in_cube = [red, green, blue].map(|at| LEVELS[at]);
    let mean = colour.iter().map(|part| u32::from(*part)).sum::<u32>() / 3;
    let grey = ((mean.max(8) - 8 + 5) / 10).min(23) as u8;
    let level = 8 + 10 * grey;
    let off = |other: [u8; 3]| colour.iter().zip(other).map(|(a, b)| u32::from(a.abs_diff(b)).pow(2)).sum::<u32>();
    match off([level; 3]) < off(in_cube) {
        true => (232 + grey, [level; 3]),
        false => ((16 + 36 * red + 6 * green + blue) as u8, in_cube),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_become_the_nearest_of_those_there_are() {
        for (colour, index) in
            [([0, 0, 0], 16), ([255; 3], 231), ([255, 0, 0], 196), ([118; 3], 243), ([94, 136, 255], 69)]
        {
            assert_eq!(indexed(colour), index, "{colour:?}");
        }
    }

    #[test]
    fn what_was_searched_for_is_marked_and_without_colours_nothing_is_coloured() {
        let row = Row::Text(vec![(Tone::Bad, "ab".to_owned()), (Tone::Plain, "cd".to_owned())]);
        let line = Line { row, margin: 1, marks: std::iter::once(1..3).collect(), is_bar: false };
        let text = paint(&line, Colours::True);
        assert_eq!(text, " \x1b[1;31ma\x1b[0m\x1b[1;31;7mb\x1b[0m\x1b[7mc\x1b[0md");
        assert_eq!(paint(&line, Colours::None), " \x1b[1ma\x1b[0m\x1b[1;7mb\x1b[0m\x1b[7mc\x1b[0md");
    }

    #[test]
    fn cells_of_one_colour_are_painted_together() {
        let cell = |symbol, ink| Cell { symbol, ink, paper: None };
        let row = Row::Picture(vec![cell('a', Some([1, 2, 3])), cell('b', Some([1, 2, 3])), cell('c', None)]);
        let line = Line { row, margin: 0, marks: Vec::new(), is_bar: false };
        assert_eq!(paint(&line, Colours::True), "\x1b[38;2;1;2;3mab\x1b[0mc");
    }
}
