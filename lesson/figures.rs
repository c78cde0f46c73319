//! The figures of a run, drawn in parallel and written where the reader asked for them.

use crate::out::{self, Folder};
use crate::progress::Progress;
use crate::select::{Chosen, Selection};
use crate::stop::Stop;
use chapters::figure::Plot;
use chapters::vocabulary::Item;
use rayon::prelude::*;
use views::plot;
use views::race_plot;
use views::report::{CheckReport, FigureReport, RaceReport, Report};

/// What a figure is written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Pixels.
    Png,
    /// Vectors.
    Svg,
}

impl Format {
    fn extension(self) -> &'static str {
        match self {
            Self::Png => "png",
            Self::Svg => "svg",
        }
    }

    fn draw(self, plot: &Plot) -> Vec<u8> {
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

/// Draws the figures of the selected steps and the races in `report`, and notes their paths there. Either all of them
/// are in the folder afterwards or none.
pub fn write(
    selection: &Selection,
    report: &mut Report,
    folder: &Folder,
    format: Format,
    progress: &Progress,
) -> Result<(), Stop> {
    let mut files = Vec::new();
    let steps: Vec<_> = report.chapters.iter_mut().flat_map(|chapter| &mut chapter.steps).collect();
    for (chosen, step) in selection.steps.iter().zip(steps) {
        let subjects = subjects(chosen, &step.races, &step.checks);
        progress.expect(subjects.len() as u64);
        let drawn: Result<Vec<_>, Stop> = subjects
            .par_iter()
            .map(|subject| progress.during(subject.address.clone(), |address| draw(subject, address, folder, format)))
            .collect();
        let (figures, drafts): (Vec<_>, Vec<_>) = drawn?.into_iter().unzip();
        step.figures = figures;
        files.extend(drafts);
    }
    out::publish(&files)?;
    progress.end();
    Ok(())
}

fn subjects<'a>(chosen: &'a Chosen, races: &'a [RaceReport], checks: &'a [CheckReport]) -> Vec<Subject<'a>> {
    let figures = chosen.step.items().filter(|item| chosen.wants(item.id())).filter_map(|item| {
        let Item::Figure(figure) = item else { return None };
        Some(Subject {
            address: format!("{}/{}", chosen.address(), figure.id),
            says: figure.says,
            rows: chosen.step.rows_of(&item),
            plot: Box::new(|| (figure.plot)(&chosen.setting)),
        })
    });
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
    figures.chain(races).chain(broken).collect()
}

fn draw(
    subject: &Subject,
    address: String,
    folder: &Folder,
    format: Format,
) -> Result<(FigureReport, out::Draft), Stop> {
    let name = format!("{}.{}", address.replace('/', "-"), format.extension());
    let draft = folder.draft(&name, &format.draw(&(subject.plot)()))?;
    let path = draft.path().to_owned();
    Ok((FigureReport { address, says: subject.says, rows: subject.rows, path }, draft))
}
