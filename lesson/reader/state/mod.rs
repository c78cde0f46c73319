//! The reader without its terminal: events in; what is shown, and what is to be done, out.
//!
//! | what | where |
//! |---|---|
//! | what keys do | here |
//! | the page that is open, set for the screen | [`sheet`] |
//! | how one moves through pages and steps, and back | [`moving`] |
//! | words that are searched for | [`seeking`] |
//! | what stands on the screen | [`shown`] |

mod moving;
mod seeking;
mod sheet;
mod shown;
#[cfg(test)]
mod tests;

pub use shown::Line;

use super::bookmark::{Memory, Place};
use super::contents::{Choice, Contents};
use super::event::{Event, Key};
use super::graphics::Ground;
use super::leaf::{Leaf, Look, Name, key};
use super::panel::{Panel, Turn};
use super::work::Job;
use chapters::vocabulary::Question;
use seeking::Search;
use sheet::Sheet;
use views::block::Details;
use views::page::Row;
use views::tell::Evidence;

/// The smallest terminal that a page fits on.
pub const LEAST: (usize, usize) = (40, 20);
/// Columns of a page at most: longer lines are hard to follow.
const WIDEST: usize = 96;
/// Rows that a notch of the wheel scrolls.
const NOTCH: isize = 3;

/// What is to be done outside.
#[derive(Debug)]
pub enum Effect {
    /// Work that takes its time.
    Do(Job),
    /// Pictures of other steps than this one are not needed now.
    TurnTo(usize),
    /// What is remembered has changed.
    Keep,
    /// The reader is left.
    Quit,
}

/// What keys mean.
enum Mode {
    Read,
    /// The keys, from this row on.
    Help(usize),
    GoTo(Contents),
    Search(String),
    Answer(String),
    Set(Panel),
}

/// The reader.
pub struct Reader {
    leaves: Vec<Leaf>,
    at: usize,
    /// The first row on the screen.
    top: usize,
    size: (usize, usize),
    ground: Ground,
    short: bool,
    details: Details,
    mode: Mode,
    sheet: Sheet,
    search: Option<Search>,
    /// Places that were left, the last one last.
    trail: Vec<(usize, usize)>,
    note: Option<String>,
    effects: Vec<Effect>,
    /// What is remembered.
    pub memory: Memory,
}

/// How a reader begins.
pub struct Start {
    /// The step that opens first.
    pub at: usize,
    /// Whether it opens where its chapter was left.
    pub resume: bool,
    /// Columns and rows of the terminal.
    pub size: (usize, usize),
    /// What pictures are made of.
    pub ground: Ground,
    /// The short way.
    pub short: bool,
    /// What is shown of derivations.
    pub details: Details,
    /// What is remembered.
    pub memory: Memory,
    /// What to say first.
    pub note: Option<String>,
}

impl Reader {
    pub fn new(mut leaves: Vec<Leaf>, start: Start) -> Self {
        for leaf in &mut leaves {
            let address = leaf.address();
            for (question, answer) in leaf.step.questions.iter().zip(&mut leaf.answers) {
                let kept = start.memory.answers.get(&format!("{address}/{}", question.id));
                *answer = kept.and_then(|answer| answer.given(question.options().len()));
            }
        }
        let Start { at, size, ground, short, details, memory, note, .. } = start;
        let sheet = Sheet { parts: Vec::new(), starts: Vec::new(), rows: Vec::new() };
        let mut reader = Self {
            leaves,
            at,
            top: 0,
            size,
            ground,
            short,
            details,
            mode: Mode::Read,
            sheet,
            search: None,
            trail: Vec::new(),
            note,
            effects: Vec::new(),
            memory,
        };
        let chapter = reader.leaves[at].chapter.id;
        let place = reader.memory.places.get(chapter).cloned().filter(|_| start.resume);
        let kept = place.and_then(|place| {
            let is_it = |leaf: &Leaf| leaf.chapter.id == chapter && leaf.step.id == place.step;
            Some((reader.leaves.iter().position(is_it)?, place.row))
        });
        match kept {
            Some((leaf, row)) => {
                // Whoever was further down had gone past the question.
                reader.leaves[leaf].skipped = row > 0;
                reader.open(leaf, row);
                let is_start = reader.at == at && reader.top == 0;
                if reader.note.is_none() && !is_start {
                    reader.note = Some("where you were; Home and b lead back, g goes elsewhere".into());
                }
            }
            None => reader.open(at, 0),
        }
        reader
    }

    /// From now on pictures are made of that.
    pub fn draw_on(&mut self, ground: Ground) {
        self.ground = ground;
    }

    /// What is to be done outside since it was last asked.
    pub fn effects(&mut self) -> Vec<Effect> {
        std::mem::take(&mut self.effects)
    }

    /// Verdicts so far: of how many things, and how many are broken.
    pub fn verdicts(&self) -> (usize, usize) {
        let verdicts = self.leaves.iter().map(Leaf::verdicts);
        verdicts.fold((0, 0), |(all, broken), (more, failed)| (all + more, broken + failed))
    }

    /// Takes an event in.
    pub fn take(&mut self, event: Event) {
        match event {
            Event::Key(Key::Interrupt) | Event::Gone => self.effects.push(Effect::Quit),
            Event::Key(_) | Event::Wheel(_) if self.is_too_small() => {
                if let Event::Key(Key::Char('q') | Key::Escape) = event {
                    self.effects.push(Effect::Quit);
                }
            }
            Event::Key(key) => self.press(key),
            Event::Wheel(notches) => self.scroll(notches * NOTCH),
            Event::Resize(columns, rows) => self.resize((columns, rows)),
            Event::Done(done) => {
                let is_here = done.leaf == self.at;
                self.leaves[done.leaf].take(done.result);
                if is_here {
                    self.set();
                }
            }
        }
        self.remember();
    }

    fn press(&mut self, key: Key) {
        self.note = None;
        match std::mem::replace(&mut self.mode, Mode::Read) {
            Mode::Read => self.read(key),
            Mode::Help(top) => {
                let last = shown::help(self.look().width).len().saturating_sub(self.height());
                match key {
                    Key::Down | Key::PageDown | Key::Char(' ') | Key::Enter if top < last => {
                        let rows = if key == Key::Down { 1 } else { self.height() - 1 };
                        self.mode = Mode::Help((top + rows).min(last));
                    }
                    Key::Up | Key::PageUp if top > 0 => {
                        let rows = if key == Key::Up { 1 } else { self.height() - 1 };
                        self.mode = Mode::Help(top.saturating_sub(rows));
                    }
                    _ => {}
                }
            }
            Mode::GoTo(mut contents) => match contents.press(key, &self.leaves) {
                Choice::Open => self.mode = Mode::GoTo(contents),
                Choice::Go(leaf) => self.go(leaf, 0),
                Choice::Close => {}
            },
            Mode::Search(mut words) => match key {
                Key::Escape => {}
                Key::Enter => self.find(&words),
                Key::Backspace if words.is_empty() => {}
                _ => {
                    edit(&mut words, key);
                    self.mode = Mode::Search(words);
                }
            },
            Mode::Answer(mut text) => match key {
                Key::Escape => {}
                Key::Enter => self.answer(&text),
                Key::Backspace if text.is_empty() => {}
                _ => {
                    edit(&mut text, key);
                    self.mode = Mode::Answer(text);
                }
            },
            Mode::Set(panel) if key == Key::Tab => {
                self.mode = Mode::Set(panel);
                self.turn_over();
            }
            Mode::Set(mut panel) => match panel.press(key, &self.leaves[self.at].setting) {
                // Figures have the whole screen again.
                Turn::Close => self.set(),
                Turn::Stay => self.mode = Mode::Set(panel),
                Turn::Set(setting) => {
                    self.mode = Mode::Set(panel);
                    let tasks = self.leaves[self.at].set(setting);
                    let leaf = self.at;
                    self.effects.extend(tasks.into_iter().map(|task| Effect::Do(Job { leaf, task })));
                    self.set();
                }
            },
        }
    }

    fn read(&mut self, key: Key) {
        let asks = self.leaves[self.at].asks().map(|(_, question)| question);
        match key {
            Key::Char('q') => self.effects.push(Effect::Quit),
            Key::Char(' ') | Key::Enter => self.on(),
            Key::Char('b') | Key::Backspace => self.back(),
            Key::Char('n') => self.step(self.at + 1),
            Key::Char('N') => self.step(self.at.wrapping_sub(1)),
            Key::Down | Key::Char('j') => self.scroll(1),
            Key::Up | Key::Char('k') => self.scroll(-1),
            Key::PageDown => self.scroll(self.height() as isize - 1),
            Key::PageUp => self.scroll(1 - self.height() as isize),
            Key::Home => self.top = 0,
            Key::End => self.top = self.last_top(),
            Key::Char('g') => self.mode = Mode::GoTo(Contents::at(&self.leaves, self.at)),
            Key::Char('/') => self.mode = Mode::Search(String::new()),
            Key::Char('.') => self.next_hit(1),
            Key::Char(',') => self.next_hit(-1),
            Key::Char('?' | 'h') => self.mode = Mode::Help(0),
            Key::Escape => self.search = None,
            Key::Char('u') => {
                self.details.units = !self.details.units;
                let now = if self.details.units { "with" } else { "without" };
                self.note = Some(format!("derivations (d) {now} the unit of every line"));
                self.set();
            }
            Key::Char('f') => self.next_figure(),
            Key::Char('s') if self.leaves[self.at].setting.entries().next().is_none() => {
                self.note = Some("this step has nothing to set".into());
            }
            Key::Char('s') => {
                self.skip();
                self.mode = Mode::Set(Panel::default());
                self.set();
                self.show(|name| name == Name::Numbers);
            }
            Key::Char('a') if self.leaves[self.at].has_passed() => {
                self.leaves[self.at].skipped = false;
                self.set();
                self.top = 0;
                self.reveal_question();
            }
            Key::Char(digit) if asks.is_some_and(|question| is_answer(question, digit)) => {
                let is_choice = asks.is_some_and(|question| !question.options().is_empty());
                if is_choice {
                    self.answer(digit.encode_utf8(&mut [0; 4]));
                } else {
                    self.mode = Mode::Answer(digit.to_string());
                }
            }
            Key::Char('a' | '0'..='9') => self.note = Some("nothing is asked here".into()),
            Key::Char(letter) => match Evidence::ALL.into_iter().find(|kind| key_is(*kind, letter)) {
                Some(kind) => self.unfold(kind),
                None => self.note = Some("? shows the keys".into()),
            },
            Key::Left { .. } | Key::Right { .. } | Key::Tab | Key::Interrupt => {}
        }
    }

    /// Columns of a page.
    fn width(&self) -> usize {
        let (columns, _) = self.size;
        let width = if columns < 60 { columns } else { (columns - 4).min(WIDEST) };
        width.max(LEAST.0)
    }

    fn look(&self) -> Look {
        Look {
            width: self.width(),
            height: self.height(),
            ground: self.ground,
            short: self.short,
            details: self.details,
        }
    }

    /// Rows for the page: all but the bar and the panel.
    fn height(&self) -> usize {
        let rows = self.size.1.saturating_sub(1).max(1);
        match &self.mode {
            Mode::Set(panel) => rows.saturating_sub(self.panel(panel).len() + 1).max(1),
            _ => rows,
        }
    }

    /// The parameters, as they stand under the page.
    fn panel(&self, panel: &Panel) -> Vec<Row> {
        panel.rows(&self.leaves[self.at].setting, self.width(), (self.size.1 / 2).saturating_sub(2))
    }

    fn is_too_small(&self) -> bool {
        self.size.0 < LEAST.0 || self.size.1 < LEAST.1
    }

    fn resize(&mut self, size: (usize, usize)) {
        if size != self.size {
            self.size = size;
            if !self.is_too_small() {
                self.set();
            }
        }
    }

    fn answer(&mut self, text: &str) {
        let leaf = &mut self.leaves[self.at];
        let Some((at, question)) = leaf.asks() else { return };
        match question.read(text) {
            Ok(given) => {
                leaf.answers[at] = Some(given);
                let address = format!("{}/{}", leaf.address(), question.id);
                self.memory.answers.insert(address, given.into());
                self.effects.push(Effect::Keep);
                self.set();
                self.reveal(|name| name == Name::Question(at));
            }
            Err(fault) => self.note = Some(fault.message),
        }
    }

    fn unfold(&mut self, kind: Evidence) {
        self.skip();
        let leaf = self.at;
        match self.leaves[leaf].toggle(kind) {
            Err(none) => self.note = Some(none),
            Ok(task) => {
                self.effects.extend(task.map(|task| Effect::Do(Job { leaf, task })));
                self.set();
                if self.leaves[leaf].is_open(kind) {
                    self.show(|name| name == Name::Evidence(kind));
                }
            }
        }
    }

    fn remember(&mut self) {
        let leaf = &self.leaves[self.at];
        let place = Place { step: leaf.step.id.to_owned(), row: self.top };
        self.memory.last = leaf.chapter.id.to_owned();
        self.memory.touched.insert(leaf.chapter.id.to_owned());
        self.memory.places.insert(leaf.chapter.id.to_owned(), place);
    }
}

fn key_is(kind: Evidence, letter: char) -> bool {
    key(kind) == letter
}

/// Whether a key begins an answer.
fn is_answer(question: &Question, letter: char) -> bool {
    match question.options().len() {
        0 => letter.is_ascii_digit() || matches!(letter, '-' | '+'),
        _ => letter.is_ascii_digit(),
    }
}

fn edit(text: &mut String, key: Key) {
    match key {
        Key::Char(letter) => text.push(letter),
        Key::Backspace => drop(text.pop()),
        _ => {}
    }
}
