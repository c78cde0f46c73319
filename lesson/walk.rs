//! A run of the lecture: step by step with single keys on a terminal, otherwise everything at once.

use crate::cli::Lesson;
use crate::figures;
use crate::out::{self, Folder};
use crate::page::{Page, Tone};
use crate::progress::Progress;
use crate::report::Report;
use crate::run::{self, Parts};
use crate::select::{Chosen, Selection, select};
use crate::stop::Stop;
use crate::text;
use chapters::Step;
use console::{Key, Term};
use std::io::{IsTerminal, stdin, stdout};
use std::process::ExitCode;

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
    let mut selection = select(&lesson.words)?;
    for note in selection.set(&lesson.changes)? {
        out::say(&format!("lesson: {note}"));
    }
    let (view, parts, plot) = plan(lesson, &selection);
    if view == View::Lecture
        && !lesson.json
        && selection.steps.len() > 1
        && stdin().is_terminal()
        && stdout().is_terminal()
    {
        return interactive(selection, lesson);
    }
    let folder = plot.then(|| Folder::open(&lesson.out)).transpose()?;
    let progress = Progress::new();
    let mut report = run::run(&selection, parts, &progress);
    if let Some(folder) = &folder {
        figures::write(&selection, &mut report, folder, lesson.format, &progress)?;
    }
    let tally = text::tally(report.passed, report.failed);
    if lesson.json {
        let mut document = serde_json::to_string_pretty(&report).expect("plain data");
        document.push('\n');
        out::print(document.as_bytes())?;
        out::say(&tally);
    } else {
        out::print(at_once(&selection, &report, view, parts, &tally).as_bytes())?;
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

fn of_item(step: &Step, item: &str) -> (View, Parts, bool) {
    let stress = step.stress.iter().any(|stress| stress.id == item);
    let races = step.races.iter().any(|race| race.id == item);
    let figure = step.figures.iter().any(|figure| figure.id == item);
    (View::Findings, Parts { checks: !(stress || races || figure), stress, races }, figure)
}

fn exit_code(failed: usize) -> ExitCode {
    ExitCode::from(u8::from(failed > 0))
}

fn at_once(selection: &Selection, report: &Report, view: View, parts: Parts, tally: &str) -> String {
    let mut page = Page::for_stdout();
    let steps = report.chapters.iter().flat_map(|chapter| &chapter.steps);
    let mut previous = "";
    for (chosen, step) in selection.steps.iter().zip(steps) {
        match view {
            View::Lecture => {
                if selection.steps.len() > 1 && chosen.chapter.id != previous {
                    text::chapter(&mut page, chosen.chapter);
                    previous = chosen.chapter.id;
                }
                text::lecture(&mut page, chosen.chapter, chosen.step, step);
            }
            View::Findings => text::findings(&mut page, step, parts),
        }
    }
    if parts.races {
        text::machine(&mut page, &report.machine);
    }
    page.verbatim(tally);
    page.into_text()
}

/// Where a key leads.
enum Turn {
    Next,
    Back,
    Plot,
    Quit,
}

/// One step after the other. Keys are read one at a time, and the terminal is itself again between any two.
fn interactive(selection: Selection, lesson: &Lesson) -> Result<ExitCode, Stop> {
    let term = Term::stdout();
    let mut steps: Vec<Selection> =
        selection.steps.into_iter().map(|chosen| Selection { steps: vec![chosen] }).collect();
    let mut seen: Vec<Option<(usize, usize)>> = vec![None; steps.len()];
    let mut at = 0;
    while at < steps.len() {
        let report = run::run(&steps[at], Parts { checks: true, ..Parts::default() }, &Progress::new());
        seen[at] = Some((report.passed, report.failed));
        let first = at == 0 || steps[at].steps[0].chapter.id != steps[at - 1].steps[0].chapter.id;
        show(&steps[at].steps[0], &report, first)?;
        at = loop {
            match ask(&term, at + 1, steps.len())? {
                Turn::Next => break at + 1,
                Turn::Back => break at.saturating_sub(1),
                Turn::Quit => break steps.len(),
                Turn::Plot => plot(&mut steps[at], lesson)?,
            }
        };
    }
    let (passed, failed) = seen.iter().flatten().fold((0, 0), |sum, step| (sum.0 + step.0, sum.1 + step.1));
    out::print(format!("{}\n", text::tally(passed, failed)).as_bytes())?;
    Ok(exit_code(failed))
}

fn show(chosen: &Chosen, report: &Report, first: bool) -> Result<(), Stop> {
    let mut page = Page::for_stdout();
    if first {
        text::chapter(&mut page, chosen.chapter);
    }
    text::lecture(&mut page, chosen.chapter, chosen.step, &report.chapters[0].steps[0]);
    out::print(page.into_text().as_bytes())
}

fn ask(term: &Term, at: usize, of: usize) -> Result<Turn, Stop> {
    let mut page = Page::for_stdout();
    let keys = format!("step {at} of {of}: Enter next, b back, p plot, q quit");
    page.line(0, Tone::Dim, &keys);
    out::print(page.into_text().trim_end().as_bytes())?;
    let turn = loop {
        match term.read_key().map_err(|error| Stop::at("terminal", error))? {
            Key::Enter | Key::Char(' ' | 'n') | Key::ArrowRight | Key::PageDown => break Turn::Next,
            Key::Char('b') | Key::ArrowLeft | Key::PageUp | Key::Backspace => break Turn::Back,
            Key::Char('p') => break Turn::Plot,
            Key::Char('q') | Key::Escape | Key::CtrlC => break Turn::Quit,
            _ => {}
        }
    };
    term.clear_line().map_err(Stop::writing)?;
    Ok(turn)
}

/// Draws the figures of a step and says where they are; a folder that cannot be used does not end the walk.
fn plot(step: &mut Selection, lesson: &Lesson) -> Result<(), Stop> {
    let progress = Progress::new();
    let mut report = run::run(step, Parts { races: true, ..Parts::default() }, &progress);
    let drawn = Folder::open(&lesson.out)
        .and_then(|folder| figures::write(step, &mut report, &folder, lesson.format, &progress));
    let mut page = Page::for_stdout();
    match drawn {
        Ok(()) => {
            let figures = &report.chapters[0].steps[0].figures;
            figures.iter().for_each(|figure| page.verbatim(&figure.path.display().to_string()));
            if figures.is_empty() {
                page.line(0, Tone::Dim, "this step has no figures");
            }
        }
        Err(Stop::Refused(message)) => page.line(0, Tone::Bad, &message),
        Err(Stop::ClosedPipe) => return Err(Stop::ClosedPipe),
    }
    out::print(page.into_text().as_bytes())
}
