//! A run of the lecture: in the reader on a terminal, otherwise everything at once.

use crate::cli::Lesson;
use crate::figures;
use crate::out::{self, Folder};
use crate::progress::Progress;
use crate::reader;
use crate::run;
use crate::select::{Chosen, Selection, select};
use crate::stop::Stop;
use chapters::Step;
use chapters::vocabulary::Part;
use std::io::{IsTerminal, stdin, stdout};
use std::path::Path;
use std::process::ExitCode;
use views::block::{Block, Details};
use views::json;
use views::report::{Parts, Report, Verdict};
use views::tell::{Teller, tally};

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
    if view == View::Lecture && !lesson.json && !lesson.plain && is_readable() {
        return reader::serve(selection, lesson);
    }
    if lesson.short {
        return briefly(&selection);
    }
    let folder = plot.then(|| Folder::open(&lesson.out)).transpose()?;
    // What can be looked at comes first: checks and races may take their time.
    let wrote = |path: &Path| out::say(&format!("wrote {}", path.display()));
    let own = folder.as_ref().map(|folder| figures::own(&selection, folder, lesson.format, &wrote)).transpose()?;
    let mut report = run::run(&selection, parts, &Progress::new());
    if let Some((folder, own)) = folder.as_ref().zip(own) {
        figures::found(&mut report, own, folder, lesson.format, &wrote)?;
    }
    if let Some(lack) = selection.lacks(parts, plot) {
        out::say(&format!("note: {lack}"));
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

/// Whether there is somebody with a screen and keys.
fn is_readable() -> bool {
    let is_dumb = std::env::var_os("TERM").is_none_or(|term| term.is_empty() || term == "dumb");
    stdin().is_terminal() && stdout().is_terminal() && (cfg!(windows) || !is_dumb)
}

/// The short way, at once: of every step what it claims, how it begins, what it is about and what there is to see.
fn briefly(selection: &Selection) -> Result<ExitCode, Stop> {
    let teller = Teller::english(Details::default());
    let (mut blocks, mut previous, mut verdicts) = (Vec::new(), "", (0, 0));
    for Chosen { chapter, step, setting, .. } in &selection.steps {
        if selection.steps.len() > 1 && chapter.id != previous {
            blocks.push(teller.title(chapter));
            previous = chapter.id;
        }
        let found = run::stated(chapter, step, setting);
        let failed = found.verdicts().filter(|verdict| *verdict == Verdict::Failed).count();
        verdicts = (verdicts.0 + found.verdicts().count() - failed, verdicts.1 + failed);
        blocks.extend(teller.brief(chapter, step, &found));
    }
    blocks.extend(teller.briefly());
    blocks.push(Block::Line(tally(verdicts.0, verdicts.1)));
    out::show(&blocks)?;
    Ok(exit_code(verdicts.1))
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
