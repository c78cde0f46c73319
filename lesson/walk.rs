//! A run of the lecture: step by step with single keys on a terminal, otherwise everything at once.

use crate::cli::Lesson;
use crate::figures;
use crate::out::{self, Folder};
use crate::progress::Progress;
use crate::run;
use crate::select::{Chosen, Selection, select};
use crate::stop::Stop;
use chapters::Step;
use chapters::vocabulary::Part;
use console::{Key, Term};
use std::io::{ErrorKind, IsTerminal, stdin, stdout};
use std::path::Path;
use std::process::ExitCode;
use views::block::{Block, Details, Span, Tone};
use views::page::Page;
use views::report::entry::{ask, unjudged};
use views::report::{Parts, QuestionReport, Report};
use views::tell::{Teller, tally};
use views::{json, terminal};

/// What a run shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum View {
    /// Prose, equations, derivations, numbers and verdicts.
    Lecture,
    /// What the flags asked for.
    Findings,
}

/// Runs what was asked for, shows it, and ends with the tally.
pub fn serve(lesson: &Lesson) -> Result<ExitCode, Stop> {
    let mut selection = select(&lesson.words, &lesson.commands)?;
    for note in selection.set(&lesson.changes)? {
        out::say(&format!("note: {note}"));
    }
    let (view, parts, plot) = plan(lesson, &selection);
    if view == View::Lecture && !lesson.json && !lesson.plain && stdin().is_terminal() && stdout().is_terminal() {
        return interactive(selection, lesson);
    }
    let folder = plot.then(|| Folder::open(&lesson.out)).transpose()?;
    // What can be looked at comes first: checks and races may take their time.
    let wrote = |path: &Path| out::say(&format!("wrote {}", path.display()));
    let own = folder.as_ref().map(|folder| figures::own(&selection, folder, lesson.format, &wrote)).transpose()?;
    let mut report = run::run(&selection, parts, &Progress::new());
    if let Some((folder, own)) = folder.as_ref().zip(own) {
        figures::found(&mut report, own, folder, lesson.format, &wrote)?;
    }
    if report.is_empty() {
        out::say(&format!("note: {}", selection.lacks(parts, plot)));
    }
    let tally = tally(report.passed, report.failed);
    if lesson.json {
        out::print(json::report(&report).as_bytes())?;
        out::say(&tally);
    } else {
        let teller = Teller::english(lesson.details);
        let mut blocks = at_once(&selection, &report, view, parts, &teller);
        blocks.push(Block::Line(tally));
        out::show(&blocks)?;
    }
    Ok(exit_code(report.failed))
}

/// What is shown, run and drawn: the flags', or what suits the item asked for, or the lecture.
fn plan(lesson: &Lesson, selection: &Selection) -> (View, Parts, bool) {
    if lesson.parts != Parts::default() {
        return (View::Findings, lesson.parts, lesson.plot);
    }
    if lesson.plot {
        return (View::Findings, Parts { checks: true, races: true, stress: false }, true);
    }
    match &selection.steps[..] {
        [Chosen { step, item: Some(item), .. }] => of_item(step, item),
        _ => (View::Lecture, Parts { checks: true, ..Parts::default() }, false),
    }
}

/// What suits one item: the part that it belongs to.
fn of_item(step: &Step, item: &str) -> (View, Parts, bool) {
    let part = step.item(item).and_then(|item| item.part());
    (View::Findings, part.map_or(Parts::default(), Parts::only), part == Some(Part::Figures))
}

fn exit_code(failed: usize) -> ExitCode {
    ExitCode::from(u8::from(failed > 0))
}

fn at_once(selection: &Selection, report: &Report, view: View, parts: Parts, teller: &Teller) -> Vec<Block> {
    let mut blocks = Vec::new();
    let steps = report.chapters.iter().flat_map(|chapter| &chapter.steps);
    // Of a whole chapter the evidence is an overview, unless its lines are asked for.
    let folded = selection.steps.len() > 1 && teller.details == Details::default();
    let mut previous = "";
    for (chosen, step) in selection.steps.iter().zip(steps) {
        match view {
            View::Lecture => {
                if selection.steps.len() > 1 && chosen.chapter.id != previous {
                    blocks.extend(teller.chapter(chosen.chapter));
                    previous = chosen.chapter.id;
                }
                blocks.extend(teller.lecture(chosen.chapter, chosen.step, step, folded));
            }
            View::Findings => blocks.extend(teller.findings(step, parts, chosen.item.is_some())),
        }
    }
    if parts.races {
        blocks.extend(teller.machine(&report.machine));
    }
    if view == View::Lecture && folded {
        blocks.extend(teller.unfolding());
    }
    blocks.extend(teller.figures(report));
    blocks
}

/// Where a key leads.
enum Turn {
    Next,
    Back,
    Plot,
    Help,
    Quit,
}

impl Turn {
    fn of(key: &Key) -> Self {
        match key {
            Key::Enter | Key::Char(' ' | 'n') | Key::ArrowRight | Key::ArrowDown | Key::PageDown => Self::Next,
            Key::Char('b') | Key::ArrowLeft | Key::ArrowUp | Key::PageUp | Key::Backspace => Self::Back,
            Key::Char('p') => Self::Plot,
            Key::Char('q' | END_OF_TRANSMISSION) | Key::Escape | Key::CtrlC => Self::Quit,
            _ => Self::Help,
        }
    }
}

/// What was read where an answer was asked for.
enum Reading {
    /// What was typed.
    Answer(String),
    /// Nothing: the reader goes on without.
    Nothing,
    /// The reader has had enough.
    Leave,
}

/// What Ctrl-D sends.
const END_OF_TRANSMISSION: char = '\x04';
const KEYS: &str = "Keys: Enter, space or n for what comes next, b for what was before, p for this step's figures, \
                    q, Ctrl-C or Ctrl-D to leave, ? or h for this.";

/// One screen after the other. Keys are read one at a time, and the terminal is itself again between any two.
fn interactive(selection: Selection, lesson: &Lesson) -> Result<ExitCode, Stop> {
    let mut walk = Walk::new(selection, lesson.details);
    let (mut at, mut screen) = (0, 0);
    while at < walk.steps.len() {
        if !walk.question(at)? {
            break;
        }
        let screens = walk.screens(at);
        screen = screen.min(screens.len() - 1);
        out::print(screens[screen].as_bytes())?;
        let turn = loop {
            match walk.ask(at)? {
                Turn::Plot => plot(&walk.steps[at], lesson)?,
                Turn::Help => print(|page| page.line(0, Tone::Dim, KEYS))?,
                turn => break turn,
            }
        };
        (at, screen) = match turn {
            Turn::Quit => break,
            Turn::Next if screen + 1 < screens.len() => (at, screen + 1),
            Turn::Next => (at + 1, 0),
            _ if screen > 0 => (at, screen - 1),
            // The screen before a step's first is the last one of the step before.
            _ if at > 0 => (at - 1, usize::MAX),
            _ => (at, screen),
        };
    }
    let (passed, failed) =
        walk.seen.iter().flatten().fold((0, 0), |(p, f), found| (p + found.passed, f + found.failed));
    out::print(format!("{}\n", tally(passed, failed)).as_bytes())?;
    Ok(exit_code(failed))
}

/// The steps of a walk and what was found in those seen so far.
struct Walk {
    details: Details,
    term: Term,
    steps: Vec<Selection>,
    seen: Vec<Option<Report>>,
    /// Whether the questions of each step have been asked.
    asked: Vec<bool>,
}

impl Walk {
    fn new(selection: Selection, details: Details) -> Self {
        let alone = |chosen| Selection { steps: vec![chosen] };
        let steps: Vec<_> = selection.steps.into_iter().map(alone).collect();
        Self {
            term: Term::stdout(),
            details,
            seen: steps.iter().map(|_| None).collect(),
            asked: vec![false; steps.len()],
            steps,
        }
    }

    /// Asks what the step `at` asks, once, before its evidence is shown; whether the reader goes on.
    fn question(&mut self, at: usize) -> Result<bool, Stop> {
        let chosen = &self.steps[at].steps[0];
        let questions = chosen.step.questions;
        if std::mem::replace(&mut self.asked[at], true) || questions.is_empty() {
            return Ok(true);
        }
        let teller = Teller::english(self.details);
        out::show(&teller.opening(&unjudged(chosen.step, chosen.address(), &chosen.setting)))?;
        for question in questions {
            let address = format!("{}/{}", chosen.address(), question.id);
            let asked = ask(question, &chosen.setting, address.clone());
            out::show(&[teller.question(&QuestionReport { address: String::new(), ..asked }, false)])?;
            loop {
                let given = match self.answer(question.options().len())? {
                    Reading::Leave => return Ok(false),
                    Reading::Nothing => break,
                    Reading::Answer(text) => question.read(&text),
                };
                let (tone, verdict, says) = match given {
                    Err(fault) => {
                        print(|page| page.line(2, Tone::Bad, &fault.message))?;
                        continue;
                    }
                    Ok(given) => match question.reply(&chosen.setting, given) {
                        reply if reply.right => (Tone::Good, "Right. ", reply.says),
                        reply => (Tone::Bad, "No. ", reply.says),
                    },
                };
                let says = teller.phrase(&address, "reply", says);
                let spans = vec![Span::verbatim(tone, verdict), Span::new(Tone::Plain, says)];
                out::show(&[Block::paragraph(2, 4, spans)])?;
                // The evidence would carry the reply off the screen before it is read.
                if !self.goes_on()? {
                    return Ok(false);
                }
                break;
            }
        }
        print(Page::gap)?;
        Ok(true)
    }

    /// Waits for a key; whether it leads on.
    fn goes_on(&self) -> Result<bool, Stop> {
        out::print(b"Enter on, q quit")?;
        let key = self.term.read_key_raw();
        self.term.clear_line().map_err(Stop::writing)?;
        match key {
            Ok(key) => Ok(!matches!(Turn::of(&key), Turn::Quit)),
            Err(error) if matches!(error.kind(), ErrorKind::UnexpectedEof | ErrorKind::Interrupted) => Ok(false),
            Err(error) => Err(Stop::at("terminal", error)),
        }
    }

    /// Reads an answer: one key if there are `options`, otherwise a line.
    fn answer(&self, options: usize) -> Result<Reading, Stop> {
        let last = char::from(b'a' + options.clamp(1, 26) as u8 - 1);
        let prompt = if options == 0 { "Your answer".to_owned() } else { format!("Your answer, a to {last}") };
        out::print(format!("{prompt} (Enter goes on, q leaves): ").as_bytes())?;
        let mut text = String::new();
        let reading = loop {
            match self.term.read_key_raw() {
                Ok(Key::Enter) if text.is_empty() => break Reading::Nothing,
                Ok(Key::Enter) => break Reading::Answer(text),
                Ok(Key::CtrlC | Key::Escape | Key::Char(END_OF_TRANSMISSION)) => break Reading::Leave,
                Ok(Key::Char('q')) if text.is_empty() => break Reading::Leave,
                Ok(Key::Char(letter)) => {
                    text.push(letter);
                    out::print(letter.encode_utf8(&mut [0; 4]).as_bytes())?;
                    if options > 0 {
                        break Reading::Answer(text);
                    }
                }
                Ok(Key::Backspace) if text.pop().is_some() => out::print(b"\x08 \x08")?,
                Ok(_) => {}
                Err(error) if matches!(error.kind(), ErrorKind::UnexpectedEof | ErrorKind::Interrupted) => {
                    break Reading::Leave;
                }
                Err(error) => return Err(Stop::at("terminal", error)),
            }
        };
        out::print(b"\n")?;
        Ok(reading)
    }

    /// The step `at` as screens of the terminal as it is now, one line left for the prompt.
    fn screens(&mut self, at: usize) -> Vec<String> {
        let parts = Parts { checks: true, ..Parts::default() };
        let report = self.seen[at].get_or_insert_with(|| run::run(&self.steps[at], parts, &Progress::new()));
        let chosen = &self.steps[at].steps[0];
        let teller = Teller::english(self.details);
        let mut blocks = Vec::new();
        if self.steps.len() > 1 && (at == 0 || self.steps[at - 1].steps[0].chapter.id != chosen.chapter.id) {
            blocks.extend(teller.chapter(chosen.chapter));
        }
        blocks.extend(teller.lecture(chosen.chapter, chosen.step, &report.chapters[0].steps[0], false));
        let mut page = out::page();
        terminal::set(&mut page, teller.words(), &blocks);
        page.into_screens(usize::from(self.term.size().0).saturating_sub(1))
    }

    /// Asks for a key; the prompt is gone again when there is an answer.
    fn ask(&self, at: usize) -> Result<Turn, Stop> {
        let prompt = format!("{}/{} Enter on, b back, p plot, q quit", at + 1, self.steps.len());
        let columns = usize::from(self.term.size().1);
        out::print(prompt.chars().take(columns.saturating_sub(1)).collect::<String>().as_bytes())?;
        let turn = match self.term.read_key_raw() {
            Ok(key) => Ok(Turn::of(&key)),
            Err(error) if matches!(error.kind(), ErrorKind::UnexpectedEof | ErrorKind::Interrupted) => Ok(Turn::Quit),
            Err(error) => Err(Stop::at("terminal", error)),
        };
        self.term.clear_line().map_err(Stop::writing)?;
        turn
    }
}

/// Sets a page and prints it.
fn print(set: impl FnOnce(&mut Page)) -> Result<(), Stop> {
    let mut page = out::page();
    set(&mut page);
    out::print(page.into_text().as_bytes())
}

/// Draws the figures of a step and says where they are; a folder that cannot be used does not end the walk.
fn plot(step: &Selection, lesson: &Lesson) -> Result<(), Stop> {
    let wrote = |path: &Path| {
        // Whoever reads no more is found out at the next screen.
        let _ = print(|page| page.verbatim(&path.display().to_string()));
    };
    let drawn = Folder::open(&lesson.out).and_then(|folder| {
        let own = figures::own(step, &folder, lesson.format, &wrote)?;
        // Checks too: one that breaks may leave something to look at.
        let mut report = run::run(step, Parts { checks: true, races: true, stress: false }, &Progress::new());
        figures::found(&mut report, own, &folder, lesson.format, &wrote)?;
        Ok(report)
    });
    match drawn {
        Err(Stop::Refused(message)) => print(|page| page.line(0, Tone::Bad, &message)),
        Err(closed) => Err(closed),
        Ok(report) if report.chapters[0].steps[0].figures.is_empty() => {
            print(|page| page.line(0, Tone::Dim, "this step has no figures"))
        }
        Ok(_) => Ok(()),
    }
}
