//! The figures of a run, drawn in parallel and written where the reader asked for them.

use crate::out::Folder;
use crate::plot;
use crate::progress::Progress;
use crate::race_plot;
use crate::report::{FigureReport, RaceReport, Report};
use crate::select::{Chosen, Selection};
use crate::stop::Stop;
use chapters::figure::Plot;
use rayon::prelude::*;

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
struct Draft<'a> {
    address: String,
    says: &'static str,
    rows: &'static [&'static str],
    plot: Box<dyn Fn() -> Plot + Send + Sync + 'a>,
}

/// Draws the figures of the selected steps and the races in `report`, and notes their paths there.
pub fn write(
    selection: &Selection,
    report: &mut Report,
    folder: &Folder,
    format: Format,
    progress: &Progress,
) -> Result<(), Stop> {
    let steps: Vec<_> = report.chapters.iter_mut().flat_map(|chapter| &mut chapter.steps).collect();
    for (chosen, step) in selection.steps.iter().zip(steps) {
        let drafts = drafts(chosen, &step.races);
        progress.expect(drafts.len() as u64);
        let written: Result<Vec<_>, Stop> = drafts
            .par_iter()
            .map(|draft| progress.during(draft.address.clone(), |address| draw(draft, address, folder, format)))
            .collect();
        step.figures = written?;
    }
    progress.end();
    Ok(())
}

fn drafts<'a>(chosen: &'a Chosen, races: &'a [RaceReport]) -> Vec<Draft<'a>> {
    let figures = chosen.step.figures.iter().filter(|figure| chosen.wants(figure.id)).map(|figure| Draft {
        address: format!("{}/{}", chosen.address(), figure.id),
        says: figure.says,
        rows: figure.rows,
        plot: Box::new(|| (figure.plot)(&chosen.setting)),
    });
    let races = races.iter().map(|race| Draft {
        address: race.address.clone(),
        says: race.claim,
        rows: race.rows,
        plot: Box::new(|| race_plot::plot(race)),
    });
    figures.chain(races).collect()
}

fn draw(draft: &Draft, address: String, folder: &Folder, format: Format) -> Result<FigureReport, Stop> {
    let name = format!("{}.{}", address.replace('/', "-"), format.extension());
    let path = folder.write(&name, &format.draw(&(draft.plot)()))?;
    Ok(FigureReport { address, says: draft.says, rows: draft.rows, path })
}
