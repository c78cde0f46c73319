//! The figures of a run, drawn in parallel and written where the reader asked for them.

use crate::out::{self, Folder};
use crate::progress::Progress;
use crate::select::{Chosen, Selection};
use crate::stop::{Stop, plain};
use chapters::figure::Plot;
use chapters::vocabulary::Item;
use rayon::prelude::*;
use std::collections::HashMap;
use std::path::Path;
use views::plot;
use views::race_plot;
use views::report::{CheckReport, FigureReport, RaceReport, Report, StepReport};

/// What a figure is written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Pixels.
    Png,
    /// Vectors.
    Svg,
}

impl Format {
    /// That of a file by its name, if it is one of them.
    pub fn of(path: &Path) -> Option<Self> {
        let extension = plain(&path.extension()?.to_string_lossy());
        [Self::Png, Self::Svg].into_iter().find(|format| format.extension() == extension)
    }

    fn extension(self) -> &'static str {
        match self {
            Self::Png => "png",
            Self::Svg => "svg",
        }
    }

    /// The name of the file of what stands at an address.
    pub fn file(self, address: &str) -> String {
        format!("{}.{}", address.replace('/', "-"), self.extension())
    }

    /// A figure as the bytes of a file.
    pub fn draw(self, plot: &Plot) -> Vec<u8> {
        match self {
            Self::Png => plot::png(plot),
            Self::Svg => plot::svg(plot).into_bytes(),
        }
    }
}

/// A figure still to be drawn.
struct Subject<'a> {
    address: String,
    says: &'static str,
    rows: &'static [&'static str],
    plot: Box<dyn Fn() -> Plot + Send + Sync + 'a>,
}

/// Draws the figures of the selected steps: a list for each, in the folder as soon as the step's are drawn. `wrote` is
/// told where each is.
pub fn own(
    selection: &Selection,
    folder: &Folder,
    format: Format,
    wrote: &dyn Fn(&Path),
) -> Result<Vec<Vec<FigureReport>>, Stop> {
    let progress = Progress::new();
    let all: Vec<_> = selection.steps.iter().map(of_step).collect();
    for subject in all.iter().flatten() {
        folder.expect(&format.file(&subject.address))?;
    }
    progress.expect(all.iter().map(Vec::len).sum::<usize>() as u64);
    let written = all.iter().map(|subjects| {
        let written = write(subjects, folder, format, &progress)?;
        progress.hidden(|| written.iter().for_each(|figure| wrote(&figure.path)));
        Ok(written)
    });
    let written = written.collect();
    progress.end();
    written
}

/// Notes the steps' `own` figures in `report`, and draws what was found: its races, and what broken checks left.
pub fn found(
    report: &mut Report,
    own: Vec<Vec<FigureReport>>,
    folder: &Folder,
    format: Format,
    wrote: &dyn Fn(&Path),
) -> Result<(), Stop> {
    let progress = Progress::new();
    let steps = report.chapters.iter_mut().flat_map(|chapter| &mut chapter.steps);
    for (step, own) in steps.zip(own) {
        step.figures = own;
        let subjects = of_findings(&step.races, &step.checks);
        progress.expect(subjects.len() as u64);
        let written = write(&subjects, folder, format, &progress)?;
        progress.hidden(|| written.iter().for_each(|figure| wrote(&figure.path)));
        step.figures.extend(written);
    }
    progress.end();
    Ok(())
}

/// The figures of a step, and of what was found of it, as SVG, by their addresses.
pub fn inline(chosen: &Chosen, found: &StepReport) -> HashMap<String, String> {
    let subjects = of_step(chosen).into_iter().chain(of_findings(&found.races, &found.checks));
    let subjects: Vec<Subject> = subjects.collect();
    subjects.par_iter().map(|subject| (subject.address.clone(), plot::svg(&(subject.plot)()))).collect()
}

/// Draws `subjects`. Either all of them are in the folder afterwards or none.
fn write(
    subjects: &[Subject],
    folder: &Folder,
    format: Format,
    progress: &Progress,
) -> Result<Vec<FigureReport>, Stop> {
    let drawn: Result<Vec<_>, Stop> = subjects
        .par_iter()
        .map(|subject| progress.during(subject.address.clone(), |address| draw(subject, address, folder, format)))
        .collect();
    let (figures, drafts): (Vec<_>, Vec<_>) = drawn?.into_iter().unzip();
    out::publish(&drafts)?;
    Ok(figures)
}

fn of_step(chosen: &Chosen) -> Vec<Subject<'_>> {
    let figures = chosen.step.items().filter(|item| chosen.wants(item.id())).filter_map(|item| {
        let Item::Figure(figure) = item else { return None };
        Some(Subject {
            address: format!("{}/{}", chosen.address(), figure.id),
            says: figure.says,
            rows: chosen.step.rows_of(&item),
            plot: Box::new(|| (figure.plot)(&chosen.setting)),
        })
    });
    figures.collect()
}

fn of_findings<'a>(races: &'a [RaceReport], checks: &'a [CheckReport]) -> Vec<Subject<'a>> {
    let races = races.iter().map(|race| Subject {
        address: race.address.clone(),
        says: race.claim,
        rows: race.rows,
        plot: Box::new(|| race_plot::plot(race)),
    });
    // What a broken check leaves to look at.
    let broken = checks.iter().filter_map(|check| {
        let picture = check.picture.as_ref()?;
        Some(Subject {
            address: check.address.clone(),
            says: check.claim,
            rows: check.rows,
            plot: Box::new(|| picture.clone()),
        })
    });
    races.chain(broken).collect()
}

fn draw(
    subject: &Subject,
    address: String,
    folder: &Folder,
    format: Format,
) -> Result<(FigureReport, out::Draft), Stop> {
    let draft = folder.draft(&format.file(&address), &format.draw(&(subject.plot)()))?;
    let path = draft.path().to_owned();
    Ok((FigureReport { address, says: subject.says, rows: subject.rows, path }, draft))
}
