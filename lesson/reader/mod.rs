//! The reader: the lecture on a full screen, one step at a time.
//!
//! | what | where |
//! |---|---|
//! | what happens | [`event`] |
//! | the reader without its terminal: events in, lines and work out | [`state`] |
//! | a step as it is known so far, set as a page | [`leaf`] |
//! | going to a step, setting parameters, finding words | [`contents`], [`panel`], [`find`] |
//! | what takes its time, on threads of its own | [`work`] |
//! | the terminal | [`screen`] |
//! | pictures by its pixels | [`graphics`] |
//! | what is remembered | [`bookmark`] |

pub mod bookmark;
mod contents;
mod event;
mod find;
mod graphics;
mod leaf;
mod panel;
mod screen;
mod state;
mod work;

use crate::cli::Lesson;
use crate::interrupt::Interrupt;
use crate::out;
use crate::select::{Chosen, Selection};
use crate::stop::Stop;
use bookmark::Book;
use chapters::parameter::Setting;
use event::Event;
use graphics::Ground;
use leaf::Leaf;
use screen::{Colours, Screen};
use state::{Effect, Reader, Start};
use std::io::{IsTerminal, stdin};
use std::process::ExitCode;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;
use views::tell::tally;
use work::Crew;

/// How often it is looked whether somebody wants the program to end.
const TICK: Duration = Duration::from_millis(100);

/// Opens the reader at the selection, and ends with the tally of what was judged meanwhile.
pub fn serve(selection: Selection, lesson: &Lesson) -> Result<ExitCode, Stop> {
    let interrupt = Interrupt::noted();
    let (book, memory, note) = Book::open();
    let whole = selection.steps.len() > 1;
    let (leaves, first) = leaves(selection);
    let last = leaves.iter().position(|leaf| leaf.chapter.id == memory.last);
    // Of the whole lecture the chapter is taken up that was read last.
    let at = if lesson.is_all() { last.unwrap_or(first) } else { first };
    let mut size = size();
    let (colours, asked) = (Colours::of_terminal(), graphics::asked()?);
    let mut screen = Screen::open(colours).map_err(|error| Stop::at("terminal", error))?;
    let ground = Ground::of_terminal(asked, colours != Colours::None);
    screen.draw_by(ground.protocol());
    let start = Start { at, resume: whole, size, ground, short: lesson.short, details: lesson.details, memory, note };
    let mut reader = Reader::new(leaves, start);
    let (events, arrivals) = channel();
    let crew = Crew::hired(&events);
    screen::listen(events.clone());
    let mut code = None;
    let mut failed = None;
    'open: loop {
        for effect in reader.effects() {
            match effect {
                Effect::Do(job) => crew.give(job),
                Effect::TurnTo(leaf) => crew.turn_to(leaf),
                // Whether it can be written is said once, at the end: the terminal is the reader's now.
                Effect::Keep => drop(book.keep(&reader.memory)),
                Effect::Quit => break 'open,
            }
        }
        if let Err(error) = screen.show(&reader.screen()) {
            failed = Some(Stop::writing(error));
            break 'open;
        }
        let event = loop {
            code = interrupt.code();
            if code.is_some() {
                break 'open;
            }
            match arrivals.recv_timeout(TICK) {
                Ok(event) => break event,
                // Nobody says that a terminal is gone, and some never say that they have another size.
                Err(RecvTimeoutError::Timeout) if !stdin().is_terminal() => break Event::Gone,
                Err(RecvTimeoutError::Timeout) => {
                    let (columns, rows) = self::size();
                    if (columns, rows) != size {
                        break Event::Resize(columns, rows);
                    }
                }
                Err(RecvTimeoutError::Disconnected) => break Event::Gone,
            }
        };
        if let Event::Resize(columns, rows) = event {
            size = (columns, rows);
            screen.forget();
            reader.draw_on(ground.resized());
        }
        reader.take(event);
        // What has come meanwhile is shown together.
        while let Ok(event) = arrivals.try_recv() {
            reader.take(event);
        }
    }
    drop(screen);
    if let Err(stop) = book.keep(&reader.memory) {
        out::say(&format!("note: your place is not remembered: {stop}"));
    }
    if let Some(stop) = failed {
        return Err(stop);
    }
    let (all, broken) = reader.verdicts();
    out::print(format!("{}\n", tally(all - broken, broken)).as_bytes())?;
    Ok(code.map_or(ExitCode::from(u8::from(broken > 0)), ExitCode::from))
}

/// Columns and rows of the terminal; where it does not know them, what most have.
fn size() -> (usize, usize) {
    let known = console::Term::stdout().size_checked();
    known.map_or((80, 24), |(rows, columns)| (columns.into(), rows.into()))
}

/// Every step of the lecture, with the settings of those selected, and the place of the first of these.
fn leaves(selection: Selection) -> (Vec<Leaf>, usize) {
    let mut chosen: Vec<Chosen> = selection.steps;
    let first = chosen.first().map(Chosen::address);
    let leaves = chapters::steps().map(|(chapter, step)| {
        let is_it = |own: &Chosen| own.chapter.id == chapter.id && own.step.id == step.id;
        let setting = chosen.iter().position(is_it).map(|at| chosen.swap_remove(at).setting);
        Leaf::new(chapter, step, setting.unwrap_or_else(|| Setting::defaults(step.parameters())))
    });
    let leaves: Vec<Leaf> = leaves.collect();
    let at = leaves.iter().position(|leaf| Some(leaf.address()) == first).unwrap_or(0);
    (leaves, at)
}
