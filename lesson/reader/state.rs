//! The reader without its terminal: events in; what is shown, and what is to be done, out.

use super::bookmark::{Memory, Place};
use super::contents::{Choice, Contents};
use super::event::{Event, Key};
use super::find::{Hit, hits};
use super::leaf::{Leaf, Look, Name, Part, key};
use super::panel::{Panel, Turn};
use super::work::Job;
use chapters::text::Phrase;
use chapters::vocabulary::Question;
use std::ops::Range;
use views::block::{Details, Tone};
use views::page::{Page, Row};
use views::tell::Evidence;

/// The smallest terminal that a page fits on.
pub const LEAST: (usize, usize) = (40, 20);
/// Columns of a page at most: longer lines are hard to follow.
const WIDEST: usize = 96;
/// Rows that a notch of the wheel scrolls.
const NOTCH: isize = 3;
/// How many places are remembered to go back to.
const TRAIL: usize = 1000;

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

/// A line of the screen.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// What stands in it.
    pub row: Row,
    /// Columns left free before it.
    pub margin: usize,
    /// Letters that were searched for.
    pub marks: Vec<Range<usize>>,
    /// Whether it is a bar across the screen.
    pub is_bar: bool,
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

/// What is searched for.
struct Search {
    words: String,
    /// By step, and by which of its hits.
    found: Vec<(usize, usize)>,
    at: usize,
}

/// The page that is open, set for the screen.
struct Sheet {
    parts: Vec<Part>,
    /// The first row of each part.
    starts: Vec<usize>,
    rows: Vec<Row>,
}

/// The reader.
pub struct Reader {
    leaves: Vec<Leaf>,
    at: usize,
    /// The first row on the screen.
    top: usize,
    size: (usize, usize),
    is_coloured: bool,
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
    /// Whether there are colours.
    pub is_coloured: bool,
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
        let Start { at, size, is_coloured, short, details, memory, note, .. } = start;
        let sheet = Sheet { parts: Vec::new(), starts: Vec::new(), rows: Vec::new() };
        let mut reader = Self {
            leaves,
            at,
            top: 0,
            size,
            is_coloured,
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
                let last = help(self.look().width).len().saturating_sub(self.height());
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
            Key::Char('a') if self.leaves[self.at].skipped => {
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
            is_coloured: self.is_coloured,
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

    /// From the numbers to the first figure and back, while parameters are turned.
    fn turn_over(&mut self) {
        let start = |name: Name| {
            let at = self.sheet.parts.iter().position(|part| part.name == name)?;
            Some(self.sheet.starts[at])
        };
        let (numbers, figure) = (start(Name::Numbers), start(Name::Figure(0)));
        let other = if Some(self.top) == figure { numbers } else { figure };
        self.top = other.unwrap_or(self.top);
    }

    fn is_too_small(&self) -> bool {
        self.size.0 < LEAST.0 || self.size.1 < LEAST.1
    }

    /// Sets the page that is open anew; what stands at the top of the screen stays there.
    fn set(&mut self) {
        let anchor = self.anchor();
        let look = self.look();
        let jobs = self.leaves[self.at].wanted(self.at, &look);
        self.effects.extend(jobs.into_iter().map(Effect::Do));
        let parts = self.leaves[self.at].parts(&look);
        let mut sheet = Sheet { parts, starts: Vec::new(), rows: Vec::new() };
        for part in &sheet.parts {
            sheet.starts.push(sheet.rows.len());
            sheet.rows.extend(part.rows.iter().cloned());
        }
        // No empty rows at the end.
        while sheet.rows.last().is_some_and(Row::is_empty) {
            sheet.rows.pop();
        }
        self.sheet = sheet;
        if let Some((name, share, before)) = anchor
            && let Some(at) = self.sheet.parts.iter().position(|part| part.name == name)
        {
            let rows = self.sheet.parts[at].rows.len();
            // A part of the same size is the same: nothing moves. Of another, as far in.
            let inside = if before == rows { share.0 } else { share.0 * rows / share.1.max(1) };
            self.top = self.sheet.starts[at] + inside;
        }
        // What was at the top may have been folded away.
        if self.top >= self.sheet.rows.len() {
            self.top = self.last_top();
        }
    }

    /// The part at the top of the screen and how far into it that is.
    fn anchor(&self) -> Option<(Name, (usize, usize), usize)> {
        let at = self.sheet.starts.iter().rposition(|start| *start <= self.top)?;
        let (start, rows) = (self.sheet.starts[at], self.sheet.parts[at].rows.len());
        Some((self.sheet.parts[at].name, (self.top - start, rows), rows))
    }

    fn resize(&mut self, size: (usize, usize)) {
        if size != self.size {
            self.size = size;
            if !self.is_too_small() {
                self.set();
            }
        }
    }

    /// Opens a step at a row.
    fn open(&mut self, leaf: usize, row: usize) {
        if leaf != self.at {
            self.leaves[self.at].forget();
            self.effects.push(Effect::TurnTo(leaf));
        }
        self.at = leaf;
        self.sheet = Sheet { parts: Vec::new(), starts: Vec::new(), rows: Vec::new() };
        self.top = row;
        self.set();
        let address = self.leaves[leaf].address();
        self.memory.visited.insert(address);
        self.effects.push(Effect::Keep);
    }

    /// The same, so that `b` leads back.
    fn go(&mut self, leaf: usize, row: usize) {
        self.leave_trace();
        self.open(leaf, row);
    }

    fn leave_trace(&mut self) {
        if self.trail.last() != Some(&(self.at, self.top)) {
            self.trail.push((self.at, self.top));
        }
        if self.trail.len() > TRAIL {
            self.trail.remove(0);
        }
    }

    fn step(&mut self, leaf: usize) {
        match self.leaves.get(leaf) {
            Some(_) => self.go(leaf, 0),
            None if leaf == self.leaves.len() => self.note = Some("this is the last step of all; q leaves".into()),
            None => self.note = Some("this is the first step of all".into()),
        }
    }

    /// The last row that may stand at the top of the screen when one scrolls.
    fn last_top(&self) -> usize {
        self.sheet.rows.len().saturating_sub(self.height())
    }

    fn scroll(&mut self, rows: isize) {
        match &mut self.mode {
            Mode::Read | Mode::Set(_) => {
                let last = self.last_top().max(if rows < 0 { self.top } else { 0 });
                self.top = self.top.saturating_add_signed(rows).min(last.max(self.top));
            }
            Mode::GoTo(contents) => {
                let key = if rows < 0 { Key::Up } else { Key::Down };
                for _ in 0..rows.abs() {
                    contents.press(key, &self.leaves);
                }
            }
            _ => {}
        }
    }

    /// Whether everything down to the end is on the screen.
    fn is_at_end(&self) -> bool {
        self.top + self.height() >= self.sheet.rows.len()
    }

    /// A screen further; past a question; or to the next step.
    fn on(&mut self) {
        if self.is_at_end() {
            if self.leaves[self.at].asks().is_some() {
                self.leave_trace();
                let end = self.sheet.rows.len();
                self.skip();
                // What follows begins where the question stood, which has moved behind the text.
                let rest = self.sheet.parts.iter().position(|part| part.name == Name::Text);
                self.top = rest.map_or(end, |at| self.sheet.starts[at]).min(self.last_top().max(self.top));
                return;
            }
            return self.step(self.at + 1);
        }
        self.leave_trace();
        let mut next = self.top + self.height();
        // What would be torn begins the next screen, unless it began this one.
        let torn =
            self.sheet.starts.iter().zip(&self.sheet.parts).find(|(start, part)| {
                part.is_whole && **start > self.top && **start < next && **start + seen(part) > next
            });
        if let Some((start, _)) = torn {
            next = *start;
        } else if let Some(gap) = (next.saturating_sub(2)..next).rev().find(|row| self.sheet.rows[*row].is_empty()) {
            // A paragraph of which only the first lines were seen is read from its start.
            next = gap + 1;
        }
        while self.sheet.rows.get(next).is_some_and(Row::is_empty) {
            next += 1;
        }
        // A few rows more do not make another screen.
        if next + self.height() / 3 > self.sheet.rows.len() {
            next = self.last_top().max(self.top + 1);
        }
        self.top = next.min(self.sheet.rows.len() - 1);
    }

    /// To where one was; where that is not known, a screen back or to the step before.
    fn back(&mut self) {
        if let Some((leaf, top)) = self.trail.pop() {
            if leaf == self.at {
                self.top = top.min(self.sheet.rows.len().saturating_sub(1))
            } else {
                self.open(leaf, top)
            }
        } else if self.top > 0 {
            self.top = self.top.saturating_sub(self.height() - 1);
        } else if self.at > 0 {
            self.open(self.at - 1, 0);
            self.top = self.last_top();
        } else {
            self.note = Some("this is where it all begins".into());
        }
    }

    fn skip(&mut self) {
        if self.leaves[self.at].asks().is_some() {
            self.leaves[self.at].skipped = true;
            self.set();
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

    fn reveal_question(&mut self) {
        let asks = self.leaves[self.at].asks().map(|(at, _)| at);
        self.reveal(|name| asks.is_some_and(|at| name == Name::Question(at)));
    }

    /// Scrolls as little as shows a part, its beginning first.
    fn reveal(&mut self, is_it: impl Fn(Name) -> bool) {
        let Some(at) = self.sheet.parts.iter().position(|part| is_it(part.name)) else { return };
        let (start, rows) = (self.sheet.starts[at], seen(&self.sheet.parts[at]));
        if start + rows > self.top + self.height() {
            self.top = (start + rows).saturating_sub(self.height());
        }
        self.top = self.top.min(start);
    }

    /// Brings a part to the top.
    fn show(&mut self, is_it: impl Fn(Name) -> bool) {
        if let Some(at) = self.sheet.parts.iter().position(|part| is_it(part.name)) {
            self.leave_trace();
            self.top = self.sheet.starts[at];
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

    fn next_figure(&mut self) {
        self.skip();
        if self.leaves[self.at].unfold_figures() {
            self.set();
        }
        let figures =
            || self.sheet.parts.iter().zip(&self.sheet.starts).filter(|(part, _)| matches!(part.name, Name::Figure(_)));
        let next = figures().find(|(_, start)| **start > self.top).or_else(|| figures().next());
        match next.map(|(_, start)| *start) {
            Some(start) => {
                self.leave_trace();
                self.top = start;
            }
            None => self.note = Some("this step has no figures".into()),
        }
    }

    fn find(&mut self, words: &str) {
        self.search = None;
        if words.trim().is_empty() {
            return;
        }
        // A symbol is searched for as it is set: r_s is shown as rₛ.
        let set = Phrase::parse(words).to_string();
        for words in [words, &set] {
            let (look, chapter) = (self.look(), self.leaves[self.at].chapter.id);
            let mut found = Vec::new();
            for (leaf, own) in self.leaves.iter_mut().enumerate().filter(|(_, leaf)| leaf.chapter.id == chapter) {
                let skipped = std::mem::replace(&mut own.skipped, true);
                let parts = own.parts(&look);
                own.skipped = skipped;
                let count = hits(parts.iter().flat_map(|part| &part.rows), words).len();
                found.extend((0..count).map(|hit| (leaf, hit)));
            }
            if let Some(first) =
                found.iter().position(|(leaf, _)| *leaf >= self.at).or((!found.is_empty()).then_some(0))
            {
                // From where one is; the first hit of this step that is not above the screen.
                if found[first].0 == self.at {
                    self.skip();
                }
                self.search = Some(Search { words: words.to_owned(), found, at: first });
                let here = self.own_hits();
                let below = here.iter().position(|hit| hit.first().is_some_and(|(row, _)| *row >= self.top));
                if let Some(search) = &mut self.search
                    && search.found[first].0 == self.at
                {
                    search.at = first + below.unwrap_or(here.len());
                    if search.at >= search.found.len() {
                        search.at = 0;
                    }
                }
                return self.show_hit();
            }
        }
        self.note = Some(format!("“{}” does not stand in this chapter", words.trim()));
    }

    fn next_hit(&mut self, way: isize) {
        match &mut self.search {
            Some(search) => {
                search.at = (search.at as isize + way).rem_euclid(search.found.len() as isize) as usize;
                self.show_hit();
            }
            None => self.note = Some("/ searches the chapter".into()),
        }
    }

    fn show_hit(&mut self) {
        let Some((leaf, hit)) = self.search.as_ref().map(|search| search.found[search.at]) else { return };
        self.leave_trace();
        if leaf != self.at {
            self.open(leaf, 0);
        }
        self.skip();
        let row = self.own_hits().get(hit).and_then(|hit| hit.first()).map(|(row, _)| *row);
        if let Some(row) = row.filter(|row| *row < self.top || *row + 2 > self.top + self.height()) {
            self.top = row.saturating_sub(self.height() / 3);
        }
    }

    /// The places on this page where the words stand that are searched for.
    fn own_hits(&self) -> Vec<Hit> {
        self.search.as_ref().map_or(Vec::new(), |search| hits(self.sheet.rows.iter(), &search.words))
    }

    fn remember(&mut self) {
        let leaf = &self.leaves[self.at];
        let place = Place { step: leaf.step.id.to_owned(), row: self.top };
        self.memory.last = leaf.chapter.id.to_owned();
        self.memory.touched.insert(leaf.chapter.id.to_owned());
        self.memory.places.insert(leaf.chapter.id.to_owned(), place);
    }

    /// The screen, line by line.
    pub fn screen(&self) -> Vec<Line> {
        let (columns, rows) = self.size;
        if self.is_too_small() {
            return self.too_small();
        }
        let Look { width, height, .. } = self.look();
        let margin = (columns - width.min(columns)) / 2;
        let plain = |row: Row| Line { row, margin, marks: Vec::new(), is_bar: false };
        let mut lines: Vec<Line> = match &self.mode {
            Mode::Help(top) => help(width).into_iter().skip(*top).map(plain).collect(),
            Mode::GoTo(contents) => {
                let is_seen = |leaf: &Leaf| self.memory.visited.contains(&leaf.address());
                contents.rows(&self.leaves, is_seen, width, height).into_iter().map(plain).collect()
            }
            Mode::Set(panel) => {
                let mut lines = self.page(height, margin);
                let panel = self.panel(panel);
                lines.push(plain(Row::Text(vec![(Tone::Dim, "─".repeat(width))])));
                lines.extend(panel.into_iter().map(plain));
                lines
            }
            Mode::Read | Mode::Search(_) | Mode::Answer(_) => self.page(height, margin),
        };
        lines.truncate(rows - 1);
        lines.resize(rows - 1, plain(Row::Text(Vec::new())));
        lines.push(self.bar());
        lines
    }

    fn page(&self, height: usize, margin: usize) -> Vec<Line> {
        let hits = self.own_hits();
        let line = |(at, row): (usize, &Row)| {
            let marks = hits.iter().flatten().filter(|(row, _)| *row == at).map(|(_, range)| range.clone()).collect();
            Line { row: row.clone(), margin, marks, is_bar: false }
        };
        let mut lines: Vec<Line> = self.sheet.rows.iter().enumerate().skip(self.top).take(height).map(line).collect();
        lines.resize(height, Line { row: Row::Text(Vec::new()), margin, marks: Vec::new(), is_bar: false });
        lines
    }

    fn too_small(&self) -> Vec<Line> {
        let (columns, rows) = self.size;
        let (least_columns, least_rows) = LEAST;
        let text =
            format!("{columns} × {rows} is too small; {least_columns} × {least_rows} or more, please. q leaves.");
        let letters: Vec<char> = text.chars().collect();
        let line = |text: &[char]| Line {
            row: Row::Text(vec![(Tone::Plain, text.iter().collect())]),
            margin: 0,
            marks: Vec::new(),
            is_bar: false,
        };
        let mut lines: Vec<Line> = letters.chunks(columns.max(1)).take(rows).map(line).collect();
        lines.resize(rows, line(&[]));
        lines
    }

    /// The bar at the bottom: where one is, and what can be done.
    fn bar(&self) -> Line {
        let (columns, _) = self.size;
        let leaf = &self.leaves[self.at];
        let (number, of) = self.numbered();
        let place = if columns < 60 {
            format!(" {number}/{of} {} ", leaf.step.id)
        } else {
            format!(" {} {number}/{of} ", leaf.address())
        };
        let share = match self.sheet.rows.len().saturating_sub(self.height()) {
            0 => String::new(),
            _ if self.is_at_end() => " end ".into(),
            _ => format!(" {} % ", 100 * (self.top + self.height()) / self.sheet.rows.len()),
        };
        let keys: String = match (&self.mode, &self.note, &self.search) {
            (Mode::Search(words), ..) => format!("/{words}▏"),
            (Mode::Answer(text), ..) => format!("answer: {text}▏  Enter gives it, Esc not"),
            (Mode::GoTo(_), ..) => "type to filter  ↑↓ Enter goes  Esc closes".into(),
            (Mode::Help(top), ..) if top + self.height() < help(self.look().width).len() => "space: more".into(),
            (Mode::Help(_), ..) => "any key goes back".into(),
            (Mode::Set(_), ..) => "↑↓ ←→ (shift: far) or type  Tab figure  Esc".into(),
            (_, Some(note), _) => note.clone(),
            (_, _, Some(search)) => {
                format!("{} of {} “{}”  . next  , before  Esc ends", search.at + 1, search.found.len(), search.words)
            }
            _ if leaf.asks().is_some() => match leaf.asks().map_or(0, |(_, question)| question.options().len()) {
                0 => "type a number  space goes on  ? keys".into(),
                options => format!("1 to {options} answers  space goes on  ? keys"),
            },
            _ if columns < 60 => "space on  ? keys".into(),
            _ if columns < 100 => "space on  b back  g go to  ? keys  q quit".into(),
            _ => "space on  b back  n next step  g go to  / search  s settings  f figures  ? keys  q quit".into(),
        };
        let busy = if leaf.is_busy() { "⋯ " } else { "" };
        let left = format!("{place}{share}{busy}");
        let room = columns.saturating_sub(left.chars().count() + 1);
        let mut keys: Vec<char> = keys.chars().collect();
        if keys.len() > room {
            keys.truncate(room.saturating_sub(1));
            keys.push('…');
        }
        let gap = columns.saturating_sub(left.chars().count() + keys.len() + 1);
        let text = format!("{left}{}{} ", " ".repeat(gap), keys.into_iter().collect::<String>());
        Line { row: Row::Text(vec![(Tone::Plain, text)]), margin: 0, marks: Vec::new(), is_bar: true }
    }

    /// Which step of its chapter is open, from 1, and how many that has.
    fn numbered(&self) -> (usize, usize) {
        let chapter = self.leaves[self.at].chapter;
        let first = self.leaves.iter().position(|leaf| leaf.chapter.id == chapter.id).unwrap_or(0);
        (self.at - first + 1, chapter.steps.len())
    }
}

/// Rows of a part up to its last one that is not empty.
fn seen(part: &Part) -> usize {
    part.rows.iter().rposition(|row| !row.is_empty()).map_or(0, |last| last + 1)
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

/// The keys, as they are told.
pub const KEYS: [(&str, &str); 19] = [
    ("space, Enter", "on: the next screen, then the next step"),
    ("b", "back to where you were"),
    ("n  N", "the next step, the step before"),
    ("↑ ↓  PgUp PgDn", "scroll; so does the mouse's wheel"),
    ("Home End", "the step's beginning, its end"),
    ("g", "go to a chapter or a step: type a part of its name"),
    ("/", "search the chapter's text"),
    (".  ,", "the next place found, the one before"),
    ("f", "the next figure of the step; first, all of them"),
    ("s", "settings: turn a parameter and see what changes"),
    ("1 2 3 …", "answer a question; space goes on without"),
    ("a", "answer a question that you have passed"),
    ("d", "derivations, line by line"),
    ("u", "with the unit of every line, or without"),
    ("e", "checks: what could refute the step"),
    ("x", "extreme cases: what could break it"),
    ("r", "races: error against run time"),
    ("?", "this"),
    ("q, Ctrl-C", "leave; your place is remembered"),
];

fn help(width: usize) -> Vec<Row> {
    let mut page = Page::new(width, true);
    for (keys, says) in KEYS {
        page.row(0, &[15, 0], &[(Tone::Name, keys), (Tone::Plain, says)]);
    }
    page.into_rows()
}

#[cfg(test)]
mod tests {
    use super::super::work::{Finished, Order, Outcome, Source, Task};
    use super::*;
    use chapters::parameter::Setting;
    use std::sync::Arc;
    use views::plot;
    use views::report::entry::readout;

    fn reader(at: &str, size: (usize, usize)) -> Reader {
        let leaves: Vec<Leaf> = chapters::steps()
            .map(|(chapter, step)| Leaf::new(chapter, step, Setting::defaults(step.parameters())))
            .collect();
        let at = leaves.iter().position(|leaf| leaf.address() == at).unwrap();
        let start = Start {
            at,
            resume: false,
            size,
            is_coloured: true,
            short: false,
            details: Details::default(),
            memory: Memory::default(),
            note: None,
        };
        Reader::new(leaves, start)
    }

    fn press(reader: &mut Reader, keys: &str) {
        for key in keys.chars() {
            let key = match key {
                '\n' => Key::Enter,
                '\x1b' => Key::Escape,
                key => Key::Char(key),
            };
            reader.take(Event::Key(key));
        }
    }

    fn bar(reader: &Reader) -> String {
        reader.screen().last().unwrap().row.text()
    }

    fn text(reader: &Reader) -> String {
        reader.screen().iter().map(|line| line.row.text() + "\n").collect()
    }

    /// Draws and reads what is wanted, as the crew would.
    fn draw(reader: &mut Reader) {
        for effect in reader.effects() {
            let Effect::Do(Job { leaf, task }) = effect else { continue };
            let result = match task {
                Task::Draw { which, source, order, is_coloured } => {
                    let plot = match source {
                        Source::Figure(figure, setting) => Arc::new((figure.plot)(&setting)),
                        Source::Plot(plot) => plot,
                    };
                    let cells = plot::cells(&plot, order.columns, order.rows, is_coloured);
                    Outcome::Drawn { which, order, drawn: Some((plot, cells)) }
                }
                Task::Read { step, setting, edition } => {
                    Outcome::Read { edition, readout: Some(readout(step, &setting)) }
                }
                _ => continue,
            };
            reader.take(Event::Done(Finished { leaf, result }));
        }
    }

    #[test]
    fn a_chapter_takes_few_presses() {
        let mut reader = reader("fresnel/snell", (80, 24));
        let mut presses = 0;
        loop {
            draw(&mut reader);
            if bar(&reader).contains("17/17") && reader.is_at_end() {
                break;
            }
            press(&mut reader, " ");
            presses += 1;
            assert!(presses <= 60, "still at {}", bar(&reader));
        }
        assert!(presses > 17, "a screen for every step, and more than that");
    }

    #[test]
    fn back_leads_where_one_was_whatever_led_away() {
        let mut reader = reader("fresnel/snell", (80, 24));
        let mut places = vec![(reader.at, reader.top)];
        for keys in ["n", " ", " ", "gschlick\n", "N", "/grazing\n", "f"] {
            press(&mut reader, keys);
            places.push((reader.at, reader.top));
        }
        places.dedup();
        while let Some(place) = places.pop() {
            assert_eq!((reader.at, reader.top), place, "{places:?}");
            if !places.is_empty() {
                press(&mut reader, "b");
            }
        }
        assert_eq!((reader.leaves[reader.at].address().as_str(), reader.top), ("fresnel/snell", 0));
    }

    #[test]
    fn every_screen_fits_its_terminal_and_keeps_its_place_when_that_changes() {
        let mut reader = reader("fresnel/snell", (80, 24));
        press(&mut reader, "n  ");
        let first = reader.sheet.rows[reader.top..].iter().find(|row| !row.is_empty()).unwrap().text();
        let word = first.split_whitespace().next().unwrap().to_owned();
        for size in [(40, 20), (200, 50), (61, 23), (100, 30), (80, 24)] {
            reader.take(Event::Resize(size.0, size.1));
            let screen = reader.screen();
            assert_eq!(screen.len(), size.1);
            for line in &screen {
                let wide: usize = line.margin + unicode_width::UnicodeWidthStr::width(line.row.text().as_str());
                assert!(wide <= size.0, "{size:?}: {:?}", line.row.text());
            }
        }
        assert!(text(&reader).contains(&word), "{word}: {}", text(&reader));
        reader.take(Event::Resize(30, 10));
        assert!(text(&reader).contains("30 × 10"), "{}", text(&reader));
    }

    #[test]
    fn a_question_keeps_the_rest_back_until_it_is_answered_or_passed() {
        let mut one = reader("fresnel/brewster", (80, 24));
        let rows = one.sheet.rows.len();
        assert!(bar(&one).contains("answers"), "{}", bar(&one));
        press(&mut one, "9");
        assert!(bar(&one).contains("is no answer; valid: 1 to 5"), "{}", bar(&one));
        press(&mut one, "1");
        assert!(one.sheet.rows.len() > rows + 10 && text(&one).contains("Your answer: 1)"), "{}", text(&one));
        assert_eq!(one.memory.answers.len(), 1);
        let mut other = reader("fresnel/brewster", (80, 24));
        press(&mut other, " ");
        assert!(other.sheet.rows.len() > rows + 10 && other.memory.answers.is_empty());
        press(&mut other, "a");
        assert!(bar(&other).contains("answers"), "{}", bar(&other));
    }

    #[test]
    fn a_setting_answers_at_once_and_asks_for_what_takes_longer() {
        let mut reader = reader("fresnel/brewster", (80, 24));
        press(&mut reader, " e");
        draw(&mut reader);
        press(&mut reader, "s");
        draw(&mut reader);
        let before = text(&reader);
        reader.take(Event::Key(Key::Right { shift: false }));
        assert_ne!(text(&reader), before);
        let tasks: Vec<_> = reader
            .effects()
            .into_iter()
            .filter_map(|effect| if let Effect::Do(job) = effect { Some(job.task) } else { None })
            .collect();
        assert!(
            tasks.iter().any(|task| matches!(task, Task::Judge { kind: Evidence::Checks, edition: 1, .. })),
            "{tasks:?}"
        );
        assert!(
            tasks.iter().any(|task| matches!(task, Task::Draw { order: Order { edition: 1, .. }, .. })),
            "{tasks:?}"
        );
        // What comes late from the old setting is not taken for the new one's.
        let late = Outcome::Judged { kind: Evidence::Checks, edition: 0, found: Some(Vec::new()) };
        let at = reader.at;
        reader.take(Event::Done(Finished { leaf: at, result: late }));
        assert!(reader.leaves[at].is_busy());
    }

    #[test]
    fn words_are_found_in_the_whole_chapter() {
        let mut reader = reader("fresnel/snell", (80, 24));
        press(&mut reader, "/brewster\n");
        assert!(bar(&reader).contains("“brewster”"), "{}", bar(&reader));
        let marked = |reader: &Reader| reader.screen().iter().any(|line| !line.marks.is_empty());
        let first = (reader.at, reader.top);
        for _ in 0..5 {
            assert!(marked(&reader), "{}", text(&reader));
            press(&mut reader, ".");
        }
        press(&mut reader, ",,,,,");
        assert_eq!(reader.at, first.0);
        press(&mut reader, "\x1b/xyzzy\n");
        assert!(bar(&reader).contains("does not stand"), "{}", bar(&reader));
    }

    #[test]
    fn every_key_is_told_and_every_told_key_does_something() {
        let mut reader = reader("fresnel/natural", (80, 24));
        press(&mut reader, "?");
        for (keys, _) in KEYS {
            assert!(text(&reader).contains(keys), "{keys}");
        }
        press(&mut reader, " ");
        for (keys, _) in KEYS {
            for key in keys.split([' ', ',']).filter(|key| key.chars().count() == 1 && !"…↑↓".contains(key)) {
                press(&mut reader, key);
                assert!(!bar(&reader).contains("? shows the keys"), "{key}");
                press(&mut reader, "\x1b\x1b");
            }
        }
    }
}
